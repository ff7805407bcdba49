// `bumpsim price` as a user meets it.

#include <fmt/core.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <regex>

#include "program_runner.h"

using namespace bump;
using Json = nlohmann::json;
namespace fs = std::filesystem;

TEST_CASE("a scheme has its price in every format") {
  const TemporaryFolder folder;
  const Outcome text = bumpsim("price lee2007", folder.path());
  CHECK(text.code == 0);
  CHECK(text.out.find("by osu018_model") != std::string::npos);
  CHECK(text.out.find("by horowitz45") != std::string::npos);
  const Outcome json = bumpsim("price lee2007 --json", folder.path());
  REQUIRE(json.code == 0);
  CHECK(Json::parse(json.out)["schemes"][0]["area"]["table"] == "osu018_model");
  CHECK(bumpsim("price lee2007 --format csv", folder.path()).out.find("scheme,unit,role,quantity") == 0);
  const Outcome file = bumpsim("price lee2007,cart_none --format md --out price.md", folder.path());
  CHECK(file.code == 2);  // no such scheme
  CHECK_FALSE(fs::exists(folder.path() / "price.md"));
  CHECK(bumpsim("price lee2007,peercy1997 --format md --out price.md", folder.path()).code == 0);
  CHECK(read_file(folder.path() / "price.md").find("# Price\n") == 0);
}

TEST_CASE("on a scene the price has memory traffic, whatever the number of jobs") {
  const TemporaryFolder folder;
  folder.write("scene.toml", small_scene());
  const std::string command = "price lee2007,kugler1998,phong1975 --scene scene.toml --json --jobs ";
  const Outcome one = bumpsim(command + "1", folder.path()), two = bumpsim(command + "2", folder.path());
  INFO(one.err);
  REQUIRE(one.code == 0);
  CHECK(one.out == two.out);
  const Json document = Json::parse(one.out);
  for (const Json& scheme : document["schemes"]) {
    INFO(scheme["scheme"]);
    CHECK(scheme["fragments"] > 0);
    CHECK(scheme["memory_traffic_of_fragment"]["total"] > 0);
    for (const Json& unit : scheme["units"])
      if (unit["unit"] == "vertex") CHECK(unit["energy_of_fragment"] > 0);
  }
  const Json run = Json::parse(bumpsim("run scene.toml --no-quality --json --out r", folder.path()).out);
  CHECK(document["schemes"][0]["fragments"] == run["fragments"]);
  for (const Json& item : document["schemes"][0]["memory_traffic_of_fragment"]["items"])
    if (item["component"] == "memory_byte")
      CHECK(item["count"].get<double>() * run["fragments"].get<double>() == Approx(run["texture"]["bytes"].get<double>()));
}

TEST_CASE("a break-even names the winner on either side") {
  const TemporaryFolder folder;
  const Outcome outcome = bumpsim("price --break-even peercy1997,lee2007 --json", folder.path());
  REQUIRE(outcome.code == 0);
  const Json document = Json::parse(outcome.out);
  REQUIRE(document["schemes"].size() == 2);
  REQUIRE(document["break_even"].size() == 4);
  for (const Json& point : document["break_even"]) {
    if (point["at"].is_null()) continue;
    const double at = point["at"];
    const auto cost = [&](int i) { return point["lines"][i]["rest"].get<double>() + at * point["lines"][i]["tables"].get<double>(); };
    CHECK(cost(0) == Approx(cost(1)));
    CHECK(point["cheaper_below"] != point["cheaper_above"]);
  }
}

TEST_CASE("wrong questions about prices are explained") {
  const TemporaryFolder folder;
  folder.write("poor.toml",
               "title = \"t\"\ntechnology = \"t\"\nsource = \"s\"\n[area]\nunit = \"NAND2\"\naccuracy = \"a\"\n"
               "[area.adder]\nform = \"linear\"\nper_width = 8\nsource = \"s\"\naccuracy = \"a\"\n");
  folder.write("broken.toml", "title = \"t\"\n[area\n");
  folder.write(
      "keys.toml",
      "title = \"t\"\ntechnology = \"t\"\nsource = \"s\"\n[area]\nunit = \"NAND2\"\naccuracy = \"a\"\n[area.adder]\nforme = \"linear\"\n");
  folder.write("unit.toml", "title = \"t\"\ntechnology = \"t\"\nsource = \"s\"\n[area]\nunit = \"um2\"\naccuracy = \"a\"\n");
  const std::pair<const char*, const char*> cases[] = {
      {"price lee2008", "lee2007"},
      {"price lee2007 --prices osu018", "osu018_model"},
      {"price lee2007 --prices nothing.toml", "nothing.toml"},
      {"price lee2007 --prices poor.toml", "price table 'poor' has no area."},
      {"price lee2007 --prices poor.toml", "needed by lee2007, environment unit"},
      {"price lee2007 --prices broken.toml", "broken.toml:2"},
      {"price lee2007 --prices unit.toml", "unit.toml:5"},
      {"price --break-even lee2007", "it compares two"},
      {"price --break-even lee2007,lee2007", "--break-even names lee2007 twice"},
      {"price --break-even lee2007,lee2007", "try: --break-even lee2007,peercy1997"},
      {"price lee2007 --prices keys.toml", "has the keys form, source, technology, accuracy, rule, value, base, per_width, coefficient"},
      {"price --break-even lee2007,peercy1997 --prices poor.toml", "poor"},
      {"price lee2007 --scene nowhere", "nowhere"},
      {"price lee2007 --real-bits 99", "real-bits"},
      {"price lee2007 --format xml", "xml"},
      {"price lee2007 --set lee2007.word_bits=99", "word_bits"},
      {"price lee2007 --out /proc/price", "/proc"},
  };
  for (const auto& [arguments, says] : cases) {
    const Outcome outcome = bumpsim(arguments, folder.path());
    INFO(arguments << "\n" << outcome.err);
    CHECK(outcome.code == 2);
    CHECK(outcome.out.empty());
    CHECK(outcome.err.find("bumpsim: ") == 0);
    CHECK(outcome.err.find(says) != std::string::npos);
  }
}

TEST_CASE("of several schemes the one without a price is a row, and the exit code tells") {
  const TemporaryFolder folder;
  std::string table = read_file(fs::path(BUMP_SOURCE_DIR) / "testbench/prices/osu018_model.toml");
  const std::size_t at = table.find("[area.divider]"), end = table.find("[area.square_root]");
  table.erase(at, end - at);
  folder.write("no_divider.toml", table);
  const Outcome outcome = bumpsim("price lee2007,peercy1997 --prices no_divider.toml --format csv", folder.path());
  CHECK(outcome.code == 2);
  CHECK(outcome.err.find("bumpsim: peercy1997: ") == 0);
  CHECK(outcome.err.find("price table 'no_divider' has no area.divider") != std::string::npos);
  CHECK(outcome.out.find("lee2007,bump_mapping,total,area") != std::string::npos);
  CHECK(outcome.out.find("error: price table 'no_divider' has no area.divider") != std::string::npos);
}

TEST_CASE("the prices that the README shows are those that the program prints") {
  const TemporaryFolder folder;
  const std::string page = read_file(fs::path(BUMP_SOURCE_DIR) / "README.md");
  // | `scheme`, `setting` | area | of which tables, registers | energy | of which tables, registers |
  const std::regex row(R"(\n\| `(\w+)`(?:, `([\w=]+)`)? \| ([\d.]+) k \| [\d.]+ k, [\d.]+ k \| ([\d.]+) \| [\d.]+, [\d.]+ \|(?=\n))");
  int rows = 0;
  for (std::sregex_iterator found(page.begin(), page.end(), row), end; found != end; ++found, ++rows) {
    const std::string scheme = (*found)[1], setting = (*found)[2];
    const Outcome outcome =
        bumpsim("price " + scheme + (setting.empty() ? "" : " --set " + scheme + "." + setting) + " --json", folder.path());
    INFO(scheme << " " << setting << "\n" << outcome.err);
    REQUIRE(outcome.code == 0);
    const Json priced = Json::parse(outcome.out)["schemes"][0];
    CHECK(fmt::format("{:.1f}", priced["area"]["bump_mapping"].get<double>() / 1000) == (*found)[3]);
    CHECK(fmt::format("{:.1f}", priced["energy_of_fragment"]["bump_mapping"].get<double>()) == (*found)[4]);
  }
  CHECK(rows == 5);
}
