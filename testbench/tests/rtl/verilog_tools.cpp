#include "verilog_tools.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace bump_test {

namespace fs = std::filesystem;

namespace {

fs::path temporary_folder() {
  std::string pattern = (fs::temp_directory_path() / "bumpsim-verilog-XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
  return pattern;
}

void write(const fs::path& path, const std::string& text) {
  fs::create_directories(path.parent_path());
  std::ofstream file(path, std::ios::binary);
  file << text;
  if (!file.flush()) throw std::runtime_error("cannot write " + path.string());
}

std::string read(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// Runs commands in a folder; what they said, and "failed" in front if one did.
std::string run(const std::string& commands, const fs::path& folder) {
  const int status = std::system(("cd '" + folder.string() + "' && (" + commands + ") > said 2>&1 </dev/null").c_str());
  return (status == 0 ? "" : "failed: ") + read(folder / "said");
}

std::uint64_t bits_of(std::int64_t word, const bump::Format& format) {
  return static_cast<std::uint64_t>(word) & ((std::uint64_t{1} << format.width) - 1);
}

int width_of(const std::vector<Port>& ports) {
  int width = 0;
  for (const Port& port : ports) width += port.format.width;
  return width;
}

/// The words of a cycle side by side, the first highest.
std::string line_of(const std::vector<Port>& ports, const PortWords& words) {
  std::string bits(static_cast<std::size_t>((4 - width_of(ports) % 4) % 4), '0');
  for (std::size_t i = 0; i < ports.size(); ++i)
    for (int bit = ports[i].format.width - 1; bit >= 0; --bit) bits += ((bits_of(words[i], ports[i].format) >> bit) & 1) != 0 ? '1' : '0';
  std::string text;
  for (std::size_t i = 0; i < bits.size(); i += 4)
    text += "0123456789abcdef"[(bits[i] - '0') * 8 + (bits[i + 1] - '0') * 4 + (bits[i + 2] - '0') * 2 + (bits[i + 3] - '0')];
  return text;
}

std::string concatenated(const std::vector<Port>& ports) {
  std::string text;
  for (const Port& port : ports) text += (text.empty() ? "" : ", ") + port.name;
  return "{" + text + "}";
}

/// A module that feeds a device and writes what comes out of it.
std::string bench_of(const Device& device, std::size_t number) {
  const std::size_t count = device.vectors.size();
  std::string connections = device.stages > 0 ? ".clk(clk)" : "";
  std::string text = fmt::format("module bench_{};\n  reg clk;\n", number);
  for (const Port& port : device.inputs) text += fmt::format("  wire [{}:0] {};\n", port.format.width - 1, port.name);
  for (const Port& port : device.outputs) text += fmt::format("  wire [{}:0] {};\n", port.format.width - 1, port.name);
  for (const auto* ports : {&device.inputs, &device.outputs})
    for (const Port& port : *ports) connections += fmt::format("{}.{}({})", connections.empty() ? "" : ", ", port.name, port.name);
  text += fmt::format("  reg [{}:0] in;\n  reg [{}:0] vectors [0:{}];\n  assign {} = in;\n  {} device ({});\n", width_of(device.inputs) - 1,
                      width_of(device.inputs) - 1, count - 1, concatenated(device.inputs), device.name, connections);
  text += fmt::format(
      "  integer file, t;\n  initial begin\n    clk = 0;\n    $readmemh(\"in_{0}.hex\", vectors);\n    file = $fopen(\"out_{0}.hex\", "
      "\"w\");\n"
      "    for (t = 0; t < {1}; t = t + 1) begin\n      if (t < {2}) in = vectors[t];\n      #1;\n"
      "      if (t >= {3}) $fdisplay(file, \"%h\", {4});\n      clk = 1;\n      #1 clk = 0;\n    end\n    $fclose(file);\n  "
      "end\nendmodule\n",
      number, count + static_cast<std::size_t>(device.stages), count, device.stages, concatenated(device.outputs));
  return text;
}

std::string compare(const Device& device, const std::string& out) {
  std::istringstream lines(out);
  std::string line, text;
  std::size_t count = 0;
  for (; std::getline(lines, line); ++count) {
    if (count >= device.expected.size()) break;
    const std::string expected = line_of(device.outputs, device.expected[count]);
    if (line != expected && text.size() < 1000)
      text += fmt::format("{}: of {} came {}, not {}\n", device.name, fmt::join(device.vectors[count], " "), line, expected);
  }
  if (count != device.vectors.size()) text += fmt::format("{}: {} results, not {}\n", device.name, count, device.vectors.size());
  return text;
}

std::int64_t lowest(const bump::Format& format) {
  return format.is_signed ? -(std::int64_t{1} << (format.width - 1)) : 0;
}

std::int64_t random_word(const bump::Format& format, std::mt19937_64& random) {
  switch (integer(random, 0, 3)) {
    case 0: {
      const std::int64_t corners[] = {0, 1, -1, lowest(format), lowest(format) + 1, ~lowest(format), ~lowest(format) - 1};
      return bump::wrap(corners[integer(random, 0, 6)], format);
    }
    case 1:
      return bump::wrap(static_cast<std::int64_t>(std::uint64_t{1} << integer(random, 0, format.width - 1)), format);
    case 2:  // of any size, so that quotients and leading ones are
      return bump::wrap(static_cast<std::int64_t>(random()) >> integer(random, 64 - format.width, 63), format);
    default:
      return bump::wrap(static_cast<std::int64_t>(random()), format);
  }
}

}  // namespace

bool is_there(const std::string& tool) {
  if (std::system(("command -v " + tool + " >/dev/null 2>&1").c_str()) == 0) return true;
  WARN("skipped: " << tool << " is not installed");
  return false;
}

std::string lint(const std::vector<bump::VerilogModule>& modules) {
  const fs::path folder = temporary_folder();
  std::string files;
  for (const bump::VerilogModule& module : modules) {
    write(folder / (module.name + ".v"), module.text);
    files += " " + module.name + ".v";
  }
  const std::string said = run("verilator --lint-only -Wall -Wno-MULTITOP" + files, folder);
  fs::remove_all(folder);
  return said;
}

IcarusBench::IcarusBench() : folder_(temporary_folder()) {}

IcarusBench::~IcarusBench() {
  std::error_code error;
  fs::remove_all(folder_, error);
}

void IcarusBench::add(const bump::VerilogModule& module) {
  const auto same = std::find_if(modules_.begin(), modules_.end(), [&](const bump::VerilogModule& m) { return m.name == module.name; });
  if (same == modules_.end())
    modules_.push_back(module);
  else
    REQUIRE(same->text == module.text);  // a name means one module
}

void IcarusBench::add_file(const std::string& path, const std::string& text) {
  write(folder_ / path, text);
}

std::string IcarusBench::mismatches() {
  std::string source;
  for (const bump::VerilogModule& module : modules_) source += module.text + "\n";
  for (std::size_t i = 0; i < devices_.size(); ++i) {
    source += bench_of(devices_[i], i);
    std::string vectors;
    for (const PortWords& words : devices_[i].vectors) vectors += line_of(devices_[i].inputs, words) + "\n";
    write(folder_ / fmt::format("in_{}.hex", i), vectors);
  }
  write(folder_ / "bench.v", source);
  std::string text = run("iverilog -g2001 -Wall -Wno-timescale -o bench bench.v && vvp -n bench", folder_);
  for (std::size_t i = 0; i < devices_.size() && text.size() < 4000; ++i)
    text += compare(devices_[i], read(folder_ / fmt::format("out_{}.hex", i)));
  return text;
}

std::vector<PortWords> words_for(const std::vector<Port>& ports, std::size_t most, std::mt19937_64& random) {
  std::vector<PortWords> all;
  const int bits = width_of(ports);
  const bool every = bits < 30 && (std::size_t{1} << bits) <= most;
  const std::size_t count = every ? std::size_t{1} << bits : most;
  for (std::size_t i = 0; i < count; ++i) {
    PortWords words;
    auto code = static_cast<std::int64_t>(i);
    for (const Port& port : ports) {
      words.push_back(every ? bump::wrap(code, port.format) : random_word(port.format, random));
      code >>= port.format.width;
    }
    all.push_back(std::move(words));
  }
  return all;
}

int integer(std::mt19937_64& random, int low, int high) {
  return low + static_cast<int>(random() % static_cast<std::uint64_t>(high - low + 1));
}

}  // namespace bump_test
