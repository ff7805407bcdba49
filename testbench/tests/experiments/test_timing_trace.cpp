// The file of a timing trace: what goes in comes out, and nothing else is taken for one.

#include <catch2/catch.hpp>

#include "retime_bench.h"

using namespace bump;
using namespace bump::test;

namespace {

/// The message of the refusal; empty if it is accepted.
std::string refusal(const std::string& bytes) {
  try {
    decode_trace(bytes, "some.trace");
    return "";
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::input);
    return error.what();
  }
}

}  // namespace

TEST_CASE("a trace that is written and read is the same") {
  const TimingTrace trace = record("kugler1998", {{{"kugler1998.light_map_bits", "11"}, {"numeric", "double"}}});
  const std::string bytes = encode_trace(trace);
  const TimingTrace read = decode_trace(bytes, "some.trace");
  CHECK((encode_trace(read) == bytes));
  CHECK(read.scheme == "kugler1998");
  CHECK(read.cycles == trace.cycles);
  CHECK(read.fragments() > 100);
  CHECK(read.streams[traced::light_map].tokens == read.fragments());
  CHECK(read.lights == trace.lights);
  CHECK((read.materials == trace.materials));
  CHECK(read.configuration == trace.configuration);
  CHECK(Retimer(read, all_parameters(), "some.trace").recorded().choice("numeric") == "double");
}

TEST_CASE("a trace that is cut off anywhere, or of which any byte is another, is refused") {
  const std::string bytes = encode_trace(record("phong1975"));
  REQUIRE(refusal(bytes).empty());
  for (std::size_t size = 0; size < bytes.size(); size += size < 64 ? 1 : 37) {
    INFO(size);
    CHECK_THAT(refusal(bytes.substr(0, size)), Catch::Contains("cut off") || Catch::Contains("damaged"));
  }
  for (std::size_t i = 0; i < bytes.size(); i += i < 64 ? 1 : 53) {
    INFO(i);
    std::string other = bytes;
    other[i] = static_cast<char>(other[i] ^ 0x10);
    CHECK_FALSE(refusal(other).empty());
  }
  CHECK_THAT(refusal(bytes + "x"), Catch::Contains("behind its end"));
}

TEST_CASE("other files and other versions are refused as such") {
  CHECK_THAT(refusal("# a scene\n[frame]\nwidth = 512\n"), Catch::Contains("no timing trace"));
  std::string later = encode_trace(record("phong1975"));
  later[8] = 3;
  CHECK_THAT(refusal(later), Catch::Contains("version 3") && Catch::Contains("version 2") && Catch::Contains("--record"));
}

TEST_CASE("streams that contradict one another are refused, even under a right checksum") {
  TimingTrace trace = record("phong1975");
  SECTION("a fragment too many") {
    ++trace.streams[traced::texture].runs.back().count;
  }
  SECTION("a triangle too few") {
    trace.streams[traced::setup].runs.pop_back();
  }
  SECTION("a triangle without an end") {
    trace.streams[traced::raster].runs.pop_back();
  }
  SECTION("no time at all") {
    trace.streams[traced::vertex].kinds.front().interval = 0;
  }
  SECTION("a miss without memory") {
    trace.streams[traced::vertex].kinds.front().misses = 1;
  }
  SECTION("a fragment of no triangle") {
    trace.streams[traced::raster].kinds.back().take = 0;
  }
  CHECK_THAT(refusal(encode_trace(trace)), Catch::Contains("damaged"));
}
