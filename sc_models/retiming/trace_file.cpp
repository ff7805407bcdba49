#include "retiming/trace_file.h"

#include <cstring>
#include <limits>

#include "datapath/sha256.h"
#include "retiming/byte_numbers.h"

namespace bump {

namespace {

const std::string magic = trace_magic;
constexpr std::size_t digest_size = 64;
constexpr const char* again = "bumpsim run SCENE --record FILE makes a new one";

class Writer {
 public:
  void number(std::uint64_t value) { put_number(bytes_, value); }
  void fixed(std::uint64_t value) {
    for (int i = 0; i < 8; ++i) bytes_ += static_cast<char>((value >> (8 * i)) & 0xff);
  }
  void real(double value) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    fixed(bits);
  }
  void text(const std::string& value) {
    number(value.size());
    bytes_ += value;
  }
  void raw(const std::string& value) { bytes_ += value; }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

/// Never reads behind the end; throws what damaged() throws instead.
class Reader {
 public:
  Reader(const std::string& bytes, std::size_t begin, std::size_t end, const std::string& name)
      : bytes_(bytes), at_(begin), end_(end), name_(name) {}

  [[noreturn]] void damaged(const std::string& what) const { throw Error({"the timing trace is damaged: " + what, {name_}, "", again}); }
  std::uint64_t number() {
    std::uint64_t value = 0;
    for (int shift = 0; shift < 64; shift += 7) {
      if (at_ == end_) damaged("it ends too soon");
      const auto byte = static_cast<unsigned char>(bytes_[at_++]);
      value |= std::uint64_t{byte & 0x7fU} << shift;
      if ((byte & 0x80U) == 0) return value;
    }
    damaged("a number is too long");
  }
  /// At most `most`.
  std::uint64_t number(std::uint64_t most, const char* what) {
    const std::uint64_t value = number();
    if (value > most) damaged(std::string(what) + " of " + std::to_string(value));
    return value;
  }
  /// A count of things that take a byte or more each.
  std::size_t count() { return static_cast<std::size_t>(number(end_ - at_, "a count")); }
  std::uint64_t fixed() {
    if (end_ - at_ < 8) damaged("it ends too soon");
    std::uint64_t value = 0;
    for (int i = 0; i < 8; ++i) value |= std::uint64_t{static_cast<unsigned char>(bytes_[at_++])} << (8 * i);
    return value;
  }
  double real() {
    const std::uint64_t bits = fixed();
    double value = 0;
    std::memcpy(&value, &bits, sizeof value);
    return value;
  }
  std::string text() {
    const std::size_t size = count();
    at_ += size;
    return bytes_.substr(at_ - size, size);
  }
  std::size_t position() const { return at_; }
  bool at_end() const { return at_ == end_; }

 private:
  const std::string& bytes_;
  std::size_t at_, end_;
  const std::string& name_;
};

/// Bits of the largest index.
int bits_of(std::size_t kinds) {
  int bits = 0;
  while ((std::size_t{1} << bits) < kinds) ++bits;
  return bits;
}

void write_stream(Writer& out, const TokenStream& stream) {
  out.number(stream.kinds.size());
  for (const TokenRecord& r : stream.kinds)
    for (const std::uint32_t field :
         {r.interval, r.lead, std::uint32_t{r.misses}, std::uint32_t{r.take}, std::uint32_t{r.release}, std::uint32_t{r.give}})
      out.number(field);
  const int bits = bits_of(stream.kinds.size());
  out.number(stream.runs.size());
  for (const TokenStream::Run& run : stream.runs) out.number((std::uint64_t{run.count - 1} << bits) | run.kind);
}

TokenStream read_stream(Reader& in) {
  constexpr std::uint64_t most = std::numeric_limits<std::uint32_t>::max();
  TokenStream stream;
  stream.kinds.resize(in.count());
  for (TokenRecord& r : stream.kinds) {
    r.interval = static_cast<std::uint32_t>(in.number(most, "an interval"));
    r.lead = static_cast<std::uint32_t>(in.number(most, "a lead"));
    r.misses = static_cast<std::uint16_t>(in.number(0xffff, "misses"));
    r.take = static_cast<std::uint8_t>(in.number(0xff, "a mask"));
    r.release = static_cast<std::uint8_t>(in.number(0xff, "a mask"));
    r.give = static_cast<std::uint8_t>(in.number(0xff, "a mask"));
  }
  const int bits = bits_of(stream.kinds.size());
  stream.runs.resize(in.count());
  for (TokenStream::Run& run : stream.runs) {
    const std::uint64_t word = in.number();
    const std::uint64_t kind = word & ((std::uint64_t{1} << bits) - 1), count = (word >> bits) + 1;
    if (kind >= stream.kinds.size() || count > most) in.damaged("a run of " + std::to_string(count) + " tokens");
    run = {static_cast<std::uint32_t>(kind), static_cast<std::uint32_t>(count)};
    stream.tokens += run.count;
    if (stream.tokens > std::int64_t{1} << 40) in.damaged("too many tokens");
  }
  return stream;
}

void write_accesses(Writer& out, const RecordedAccesses& accesses) {
  out.number(accesses.empty() ? 0 : 1);
  if (accesses.empty()) return;
  out.number(accesses.textures.size());
  for (const Texture& texture : accesses.textures) {
    const int modes =
        (texture.wrap_u == WrapMode::clamp ? 1 : 0) | (texture.wrap_v == WrapMode::clamp ? 2 : 0) | (texture.filterable ? 4 : 0);
    for (const int field : {texture.bytes_per_texel, modes}) out.number(static_cast<std::uint64_t>(field));
    out.number(texture.levels.size());
    for (const TextureLevel& level : texture.levels)
      for (const int side : {level.width, level.height}) out.number(static_cast<std::uint64_t>(side));
  }
  for (const AccessStream* stream : {&accesses.texels, &accesses.words}) {
    out.number(static_cast<std::uint64_t>(stream->fragments));
    out.text(stream->bytes);
  }
}

RecordedAccesses read_accesses(Reader& in) {
  constexpr std::uint64_t most = 1 << 30;
  RecordedAccesses accesses;
  if (in.number(1, "a section") == 0) return accesses;
  accesses.textures.resize(in.count());
  for (Texture& texture : accesses.textures) {
    texture.bytes_per_texel = static_cast<int>(in.number(most, "bytes of a texel"));
    const std::uint64_t modes = in.number(7, "wrap modes");
    texture.wrap_u = (modes & 1U) != 0 ? WrapMode::clamp : WrapMode::repeat;
    texture.wrap_v = (modes & 2U) != 0 ? WrapMode::clamp : WrapMode::repeat;
    texture.filterable = (modes & 4U) != 0;
    texture.levels.resize(in.count());
    for (TextureLevel& level : texture.levels)
      for (int* side : {&level.width, &level.height}) *side = static_cast<int>(in.number(most, "a texture's side"));
  }
  for (AccessStream* stream : {&accesses.texels, &accesses.words}) {
    stream->fragments = static_cast<std::int64_t>(in.number(std::uint64_t{1} << 40, "fragments"));
    stream->bytes = in.text();
  }
  return accesses;
}

void write_body(Writer& out, const TimingTrace& trace) {
  out.text(trace.scheme);
  out.text(trace.scene);
  out.number(static_cast<std::uint64_t>(trace.width));
  out.number(static_cast<std::uint64_t>(trace.height));
  out.number(trace.inputs.size());
  for (const Scene::InputFile& input : trace.inputs) {
    out.text(input.path);
    out.text(input.sha256);
  }
  out.number(trace.materials.size());
  for (const Material& m : trace.materials)
    for (const double value : {m.ambient, m.diffuse, m.specular, m.shininess}) out.real(value);
  out.number(trace.lights.size());
  for (const double intensity : trace.lights) out.real(intensity);
  out.number(trace.configuration.size());
  for (const auto& [key, value] : trace.configuration) {
    out.text(key);
    out.text(value);
  }
  out.text(trace.netlists);
  out.number(static_cast<std::uint64_t>(trace.cycles));
  for (const TokenStream& stream : trace.streams) write_stream(out, stream);
  write_accesses(out, trace.accesses);
}

TimingTrace read_body(Reader& in) {
  TimingTrace trace;
  trace.scheme = in.text();
  trace.scene = in.text();
  trace.width = static_cast<int>(in.number(1 << 30, "a width"));
  trace.height = static_cast<int>(in.number(1 << 30, "a height"));
  trace.inputs.resize(in.count());
  for (Scene::InputFile& input : trace.inputs) {
    input.path = in.text();
    input.sha256 = in.text();
  }
  trace.materials.resize(in.count());
  for (Material& m : trace.materials)
    for (double* value : {&m.ambient, &m.diffuse, &m.specular, &m.shininess}) *value = in.real();
  trace.lights.resize(in.count());
  for (double& intensity : trace.lights) intensity = in.real();
  trace.configuration.resize(in.count());
  for (auto& [key, value] : trace.configuration) {
    key = in.text();
    value = in.text();
  }
  trace.netlists = in.text();
  trace.cycles = static_cast<std::int64_t>(in.number(std::uint64_t{1} << 62, "cycles"));
  for (TokenStream& stream : trace.streams) stream = read_stream(in);
  trace.accesses = read_accesses(in);
  if (!in.at_end()) in.damaged("something follows behind its end");
  try {
    check_trace(trace);
  } catch (const Error& error) {
    in.damaged(error.text().what);
  }
  return trace;
}

}  // namespace

std::string encode_trace(const TimingTrace& trace) {
  Writer body, file;
  write_body(body, trace);
  file.raw(magic);
  file.number(trace_version);
  file.fixed(body.bytes().size());
  file.raw(body.bytes());
  const std::string digest = sha256_hex(file.bytes().data(), file.bytes().size());
  file.raw(digest);
  return file.bytes();
}

TimingTrace decode_trace(const std::string& bytes, const std::string& name) {
  if (bytes.compare(0, magic.size(), magic) != 0) {
    const bool beginning = magic.compare(0, bytes.size(), bytes) == 0;
    throw Error({beginning ? "the timing trace is cut off" : "this is no timing trace", {name}, "a trace begins with 'bumptrc'", again});
  }
  Reader header(bytes, magic.size(), bytes.size(), name);
  const std::uint64_t version = header.number();
  if (version != trace_version)
    throw Error({"the timing trace has version " + std::to_string(version),
                 {name},
                 "this program reads version " + std::to_string(trace_version),
                 again});
  const std::uint64_t size = header.fixed();
  const std::size_t begin = header.position(), rest = bytes.size() - begin;
  if (size > rest || rest - size < digest_size)
    throw Error({"the timing trace is cut off", {name}, "it holds " + std::to_string(bytes.size()) + " bytes, fewer than it says", again});
  if (rest - size > digest_size) header.damaged("something follows behind its end");
  const std::size_t end = begin + static_cast<std::size_t>(size);
  if (sha256_hex(bytes.data(), end) != bytes.substr(end)) header.damaged("its checksum is wrong");
  Reader body(bytes, begin, end, name);
  return read_body(body);
}

}  // namespace bump
