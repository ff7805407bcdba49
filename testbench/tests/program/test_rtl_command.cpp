// `bumpsim rtl` as a user meets it, and the checks of what it writes. Tools that a machine does not have are left out.

#include <catch2/catch.hpp>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "program_runner.h"

using namespace bump;
using Catch::Contains;
using Json = nlohmann::json;
namespace fs = std::filesystem;

namespace {

bool is_there(const std::string& tool) {
  if (std::system(("command -v " + tool + " >/dev/null 2>&1").c_str()) == 0) return true;
  WARN("skipped: " << tool << " is not installed");
  return false;
}

/// Path to text of everything in a folder.
std::map<std::string, std::string> files_of(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files[entry.path().lexically_relative(folder).string()] = read_file(entry.path());
  return files;
}

Outcome make(const std::string& arguments, const fs::path& folder) {
  const TemporaryFolder logs;
  const std::string out = (logs.path() / "out").string();
  const int status = std::system(("make -s -C '" + folder.string() + "' " + arguments + " >'" + out + "' 2>&1 </dev/null").c_str());
  return {WEXITSTATUS(status), read_file(out), ""};
}

}  // namespace

TEST_CASE("a scheme becomes a folder of Verilog that says what is in it, with the same bytes every time") {
  const TemporaryFolder folder;
  const Outcome first = bumpsim("rtl lee2007 --out a --vectors 50", folder.path());
  INFO(first.err);
  REQUIRE(first.code == 0);
  CHECK_THAT(first.out, Contains("lee2007_environment: latency ") && Contains("6 multipliers, 16 adders") && Contains("make -C a check"));
  const Outcome second = bumpsim("rtl lee2007 --out deep/b --vectors 50 --json", folder.path());
  REQUIRE(second.code == 0);
  const auto files = files_of(folder.path() / "a");
  CHECK(files == files_of(folder.path() / "deep/b"));

  const Json manifest = Json::parse(files.at("rtl.json"));
  Json printed = Json::parse(second.out);
  CHECK(printed["folder"] == "deep/b");
  printed.erase("folder");
  CHECK(printed == manifest);
  CHECK(manifest["schema"] == "bumpsim-rtl");
  CHECK(manifest["configuration"].empty());
  CHECK(manifest["files"].size() + 1 == files.size());
  for (const Json& file : manifest["files"]) CHECK(files.count(file) == 1);
  REQUIRE(manifest["units"].size() == 2);
  for (const Json& unit : manifest["units"]) {
    for (const Json& module : unit["modules"]) {
      const std::string name = module;
      CHECK_THAT(files.at("rtl/" + name + ".v"), Contains("module " + name));
    }
    for (const Json& rom : unit["roms"]) CHECK(files.count(rom) == 1);
    int bits = 0;
    for (const char* side : {"inputs", "outputs"})
      for (const Json& port : unit[side]) bits += port["width"].get<int>();
    const std::string name = unit["unit"], vectors = files.at("test/" + name + ".hex");
    CHECK(vectors.size() == 50 * (static_cast<std::size_t>(bits + 3) / 4 + 1));
    CHECK(unit["capacity"] == unit["latency"].get<int>() + 1);
  }
}

TEST_CASE("units, sharing, capacity and vectors are as asked for") {
  const TemporaryFolder folder;
  const std::string settings = " --set environment.multipliers=2 --set environment.capacity=5";
  REQUIRE(bumpsim("rtl lee2007 --unit environment --vectors 30 --seed 9 --out shared" + settings, folder.path()).code == 0);
  REQUIRE(bumpsim("rtl lee2007 --unit environment --vectors 30 --seed 8 --out other" + settings, folder.path()).code == 0);
  const auto shared = files_of(folder.path() / "shared"), other = files_of(folder.path() / "other");
  const Json manifest = Json::parse(shared.at("rtl.json"));
  REQUIRE(manifest["units"].size() == 1);
  CHECK(manifest["configuration"] == Json{{"environment.multipliers", 2}, {"environment.capacity", 5}});
  CHECK(manifest["units"][0]["built"]["products"] == 6);
  CHECK(manifest["units"][0]["built"]["multipliers"] == 2);
  CHECK(manifest["units"][0]["initiation_interval"] == 3);
  CHECK(manifest["units"][0]["capacity"] == 5);
  CHECK(manifest["units"][0]["register_bits"]["entry"] == 60);
  CHECK_THAT(shared.at("rtl/lee2007_environment.v"), Contains("CAPACITY = 5"));
  CHECK_THAT(shared.at("README.md"),
             Contains("bumpsim rtl lee2007 --unit environment --set environment.capacity=5 --set environment.multipliers=2`"));
  CHECK(shared.at("test/environment.hex") != other.at("test/environment.hex"));
  CHECK(shared.at("rtl/lee2007_environment.v") == other.at("rtl/lee2007_environment.v"));
}

TEST_CASE("tables have the words of a scene's material") {
  const TemporaryFolder folder;
  const std::string object = "[[object]]\nshape = \"sphere\"\nmaterial = { shininess = ", end = " }\n";
  const std::string head =
      "[camera]\neye = [0.0, 0.0, 4.0]\ntarget = [0.0, 0.0, 0.0]\n[frame]\nwidth = 8\nheight = 8\n[[light]]\ntype = "
      "\"directional\"\ndirection = [0.0, 0.0, 1.0]\n";
  folder.write("shiny.toml", head + object + "60.0" + end);
  folder.write("two.toml", head + object + "60.0" + end + object + "20.0" + end);
  REQUIRE(bumpsim("rtl lee2007 --vectors 10 --out plain", folder.path()).code == 0);
  const Outcome shiny = bumpsim("rtl lee2007 --vectors 10 --scene shiny.toml --out shiny", folder.path());
  INFO(shiny.err);
  REQUIRE(shiny.code == 0);
  const auto first = files_of(folder.path() / "plain"), second = files_of(folder.path() / "shiny");
  CHECK(first.at("rom/lee2007_SPEC.hex") != second.at("rom/lee2007_SPEC.hex"));
  CHECK(first.at("rom/lee2007_SC.hex") == second.at("rom/lee2007_SC.hex"));
  CHECK(Json::parse(first.at("rtl.json"))["scene"].is_null());
  CHECK(Json::parse(second.at("rtl.json"))["scene"] == "shiny.toml");
  CHECK_THAT(second.at("README.md"), Contains("`bumpsim rtl lee2007 --scene shiny.toml`"));
  fs::copy(folder.path() / "shiny.toml", folder.path() / "my own.toml");
  REQUIRE(bumpsim("rtl lee2007 --vectors 10 --scene 'my own.toml' --out own", folder.path()).code == 0);
  CHECK_THAT(files_of(folder.path() / "own").at("README.md"), Contains("--scene 'my own.toml'`"));
  const Outcome two = bumpsim("rtl lee2007 --scene two.toml --out two", folder.path());
  CHECK(two.code == 2);
  CHECK_THAT(two.err, Contains("several materials"));
  CHECK(bumpsim("rtl lee2007 --scene three.toml --out three", folder.path()).code == 2);
  CHECK_FALSE(fs::exists(folder.path() / "two"));
}

TEST_CASE("other people's tools agree with what was written, and say so when they do not") {
  const TemporaryFolder folder;
  REQUIRE(bumpsim("rtl lee2007 --out rtl --vectors 100 --set environment.multipliers=4", folder.path()).code == 0);
  const fs::path rtl = folder.path() / "rtl";
  const auto files = files_of(rtl);
  const auto spoil = [&](const std::string& name, const std::string& from, const std::string& to) {
    std::string text = files.at(name);
    const std::size_t at = text.find(from);
    REQUIRE(at != std::string::npos);
    folder.write("rtl/" + name, text.replace(at, from.size(), to));
  };
  CHECK(make("", rtl).code == 0);
  if (is_there("verilator")) {
    const Outcome lint = make("lint", rtl);
    INFO(lint.out);
    CHECK(lint.code == 0);
    spoil("rtl/lee2007_environment.v", "reg [INDEX_BITS-1:0] head", "reg [INDEX_BITS:0] head");
    CHECK(make("lint", rtl).code != 0);
    folder.write("rtl/rtl/lee2007_environment.v", files.at("rtl/lee2007_environment.v"));
  }
  if (is_there("iverilog")) {
    const Outcome test = make("test CAPACITY=4", rtl);
    INFO(test.out);
    CHECK(test.code == 0);
    CHECK_THAT(test.out, Contains("environment: 100 vectors, 0 mismatches") && Contains("illumination: 100 vectors, 0 mismatches"));
    std::string sines = files.at("rom/lee2007_SC.hex");
    for (char& digit : sines)
      if (digit == '3') digit = '2';
    folder.write("rtl/rom/lee2007_SC.hex", sines);
    Outcome wrong = make("test-environment", rtl);
    CHECK(wrong.code != 0);
    CHECK_THAT(wrong.out, Contains("rom/lee2007_SC.hex"));
    folder.write("rtl/test/roms.sha256", "");  // the bench sees it as well
    wrong = make("test-environment", rtl);
    CHECK(wrong.code != 0);
    CHECK_THAT(wrong.out, Contains("instead of"));
    folder.write("rtl/test/roms.sha256", files.at("test/roms.sha256"));
    folder.write("rtl/rom/lee2007_SC.hex", files.at("rom/lee2007_SC.hex"));
  }
  if (is_there("yosys")) {
    const Outcome counts = make("counts", rtl);
    INFO(counts.out);
    CHECK(counts.code == 0);
    CHECK_THAT(counts.out, Contains("environment: 4 multipliers") && Contains("as counted"));
    spoil("rtl/lee2007_illumination_datapath.v", " * ", " + ");
    const Outcome wrong = make("counts", rtl);
    CHECK(wrong.code != 0);
    CHECK_THAT(wrong.out, Contains("t:$mul"));
  }
}

TEST_CASE("a damaged ROM image, and variables that make no sense, stop the checks") {
  TemporaryFolder folder;
  REQUIRE(bumpsim("rtl lns --unit illumination --vectors 10 --out rtl", folder.path()).code == 0);
  const fs::path rtl = folder.path() / "rtl";
  CHECK(make("ready", rtl).code == 0);
  for (const char* nonsense : {"VECTORS=0", "VECTORS=1", "VECTORS=abc", "CAPACITY=0", "SEED=x"}) {
    CAPTURE(nonsense);
    CHECK(make(std::string("test ") + nonsense, rtl).code != 0);
  }
  std::string rom = read_file(rtl / "rom/lns_DIFF.hex");
  rom[0] = rom[0] == '0' ? '1' : '0';
  folder.write("rtl/rom/lns_DIFF.hex", rom);
  CHECK(make("test", rtl).code != 0);
}

TEST_CASE("a target whose tool is missing says which") {
  const TemporaryFolder folder;
  REQUIRE(bumpsim("rtl yp6 --out rtl --vectors 10", folder.path()).code == 0);
  fs::create_directories(folder.path() / "bin");
  std::string tools;
  for (const char* tool : {"sh", "mkdir", "make"})
    tools += std::string("ln -s $(command -v ") + tool + ") '" + (folder.path() / "bin").string() + "/'; ";
  REQUIRE(std::system(tools.c_str()) == 0);
  for (const auto& [target, tool] :
       {std::pair{"lint", "verilator"}, std::pair{"test", "iverilog"}, std::pair{"verilate", "verilator"}, std::pair{"counts", "yosys"}}) {
    const TemporaryFolder logs;
    const std::string said = (logs.path() / "said").string();
    const int status = std::system(("PATH='" + (folder.path() / "bin").string() + "' make -s -C '" + (folder.path() / "rtl").string() +
                                    "' " + target + " >'" + said + "' 2>&1")
                                       .c_str());
    CHECK(WEXITSTATUS(status) != 0);
    CHECK_THAT(read_file(said), Contains(std::string(tool) + " is not installed"));
  }
}

TEST_CASE("a unit that does not become Verilog is refused with those that do") {
  const TemporaryFolder folder;
  for (const char* unit : {"nonsense", "vertex"}) {
    CAPTURE(unit);
    const Outcome refused = bumpsim(std::string("rtl lee2007 --out rtl --unit ") + unit, folder.path());
    CHECK(refused.code == 2);
    CHECK_THAT(refused.err, Contains("try: environment, illumination\n"));
    CHECK_FALSE(fs::exists(folder.path() / "rtl"));
  }
}

TEST_CASE("an earlier folder is replaced only when told to, and a user's files never") {
  const TemporaryFolder folder;
  const auto emit = [&](const std::string& options) { return bumpsim("rtl yp6 --vectors 10 --out rtl " + options, folder.path()); };
  REQUIRE(emit("").code == 0);
  const auto files = files_of(folder.path() / "rtl");
  const Outcome again = emit("");
  CHECK(again.code == 2);
  CHECK_THAT(again.err, Contains("holds earlier Verilog") && Contains("--force"));
  folder.write("rtl/Makefile", "changed");
  fs::create_directories(folder.path() / "rtl/build/x");
  folder.write("rtl/build/x/log", "made");
  CHECK(emit("--force").code == 0);
  CHECK(files_of(folder.path() / "rtl") == files);

  folder.write("rtl/rtl/mine.v", "module mine; endmodule\n");
  const Outcome more = emit("--force");
  CHECK(more.code == 2);
  CHECK_THAT(more.err, Contains("rtl/rtl/mine.v"));
  CHECK(read_file(folder.path() / "rtl/rtl/mine.v") == "module mine; endmodule\n");

  fs::create_directories(folder.path() / "mine");
  folder.write("mine/rtl.json", "{}");
  const Outcome mine = bumpsim("rtl yp6 --out mine --force", folder.path());
  CHECK(mine.code == 2);
  CHECK_THAT(mine.err, Contains("in use"));
  folder.write("file", "");
  CHECK_THAT(bumpsim("rtl yp6 --out file --force", folder.path()).err, Contains("a file of this name is in the way"));
  fs::create_directories(folder.path() / "empty");
  CHECK(bumpsim("rtl yp6 --vectors 10 --out empty", folder.path()).code == 0);
  for (const auto& entry : fs::directory_iterator(folder.path())) CHECK(entry.path().string().find(".partial") == std::string::npos);
}

TEST_CASE("wrong questions about Verilog are explained") {
  const TemporaryFolder folder;
  const std::pair<const char*, const char*> cases[] = {
      {"rtl", "scheme"},
      {"rtl lee2007", "--out"},
      {"rtl lee2007 --out ''", "--out"},
      {"rtl lee2008 --out o", "lee2007"},
      {"rtl lee2007 --unit enviroment --out o", "environment"},
      {"rtl lee2007 --unit vertex --out o", "it is a program"},
      {"rtl lee2007 --unit conversion --out o", "no conversion unit"},
      {"rtl lee2007 --out o --set numeric=double", "numeric=fixed"},
      {"rtl lee2007 --out o --set lee2007.angel_bits=9", "lee2007.angle_bits"},
      {"rtl lee2007 --out o --vectors many", "--vectors"},
      {"rtl lee2007 --out o --vectors 0", "--vectors"},
      {"rtl lee2007 --out o --vectors -5", "--vectors"},
      {"rtl lee2007 --out o --seed x", "--seed"},
      {"rtl lee2007 --out /proc/o", "/proc/o"},
  };
  for (const auto& [arguments, says] : cases) {
    const Outcome outcome = bumpsim(arguments, folder.path());
    INFO(arguments << "\n" << outcome.err);
    CHECK(outcome.code == 2);
    CHECK(outcome.out.empty());
    CHECK(outcome.err.find("bumpsim: ") == 0);
    CHECK_THAT(outcome.err, Contains(says));
    CHECK_FALSE(fs::exists(folder.path() / "o"));
  }
  const Outcome json = bumpsim("rtl lee2008 --out o --json", folder.path());
  CHECK(json.code == 2);
  CHECK(Json::parse(json.out).contains("error"));
}
