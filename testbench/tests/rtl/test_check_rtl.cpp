// scripts/check_rtl.sh in its short form: two schemes, counts by Yosys and a hundred thousand vectors through Verilator's models.
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <string>

#include "verilog_tools.h"

namespace {

namespace fs = std::filesystem;
using bump_test::is_there;

class Workplace {
 public:
  Workplace() {
    std::string pattern = (fs::temp_directory_path() / "bumpsim-check-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
    folder_ = pattern;
  }
  ~Workplace() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  Workplace(const Workplace&) = delete;
  Workplace& operator=(const Workplace&) = delete;
  const fs::path& folder() const { return folder_; }

 private:
  fs::path folder_;
};

struct Said {
  int code = 0;
  std::string text;
  bool has(const std::string& pattern) const { return std::regex_search(text, std::regex(pattern)); }
};

Said check(const Workplace& workplace, const std::string& program, const std::string& arguments) {
  const std::string out = (workplace.folder() / "said").string();
  const std::string command = "'" BUMP_SOURCE_DIR "/scripts/check_rtl.sh' --no-install --program '" + program + "' --work '" +
                              (workplace.folder() / "work").string() + "' " + arguments + " >'" + out + "' 2>&1 </dev/null";
  const int status = std::system(command.c_str());
  std::ifstream file(out);
  std::ostringstream text;
  text << file.rdbuf();
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text.str()};
}

/// bumpsim with something done to what it emits.
std::string saboteur(const Workplace& workplace, const std::string& change) {
  const fs::path path = workplace.folder() / "program";
  std::ofstream(path) << "#!/bin/sh\n'" BUMP_PROGRAM "' \"$@\" || exit $?\n[ \"$1\" = rtl ] || exit 0\n"
                      << "while [ $# -gt 0 ]; do [ \"$1\" = --out ] && folder=$2; shift; done\ncd \"$folder\" && " << change << "\n";
  fs::permissions(path, fs::perms::owner_all);
  return path.string();
}

}  // namespace

TEST_CASE("other people's tools agree with the program on counts, registers and words of two schemes") {
  if (!is_there("python3") || !is_there("yosys") || !is_there("verilator")) return;
  const Workplace workplace;
  const Said said = check(workplace, BUMP_PROGRAM, "--quick");
  INFO(said.text);
  CHECK(said.code == 0);
  CHECK(said.has("\n18 passed, 0 failed\n$"));  // three of Yosys and one of Verilator for each of four units, one for each scheme
  for (const char* scheme : {"lee2007", "lns"})
    for (const char* unit : {"environment", "illumination"}) {
      const std::string of_unit = std::string(" +") + scheme + " +" + unit + " +";
      CHECK(said.has("ok +bit_exact" + of_unit + "100000 vectors, 0 mismatches, latency [1-9]"));
      CHECK(said.has("ok +operators" + of_unit + "[0-9]+ mul, [1-9][0-9]* add"));
    }
}

TEST_CASE("an operator too few, or a register bit too many, fails the check of counts") {
  if (!is_there("python3") || !is_there("yosys")) return;
  const Workplace workplace;
  const std::string program = saboteur(workplace,
                                       "sed -i '0,/ [*] /s// + /' rtl/tl2_illumination_datapath.v && "
                                       "sed -i '0,/reg .[0-9]*:0. /s//reg [40:0] /' rtl/tl2_environment_datapath.v");
  const Said said = check(workplace, program, "--schemes tl2 --checks counts");
  INFO(said.text);
  CHECK(said.code == 1);
  CHECK(said.has("FAILED +operators +tl2 +illumination +1 multipliers instead of 2"));
  CHECK(said.has("FAILED +registers +tl2 +environment +[0-9]+ bits between and inside operators instead of [0-9]+"));
  CHECK(said.has("FAILED +operators_all +tl2 +all +1 mul.* instead of 2 mul"));
  CHECK(said.has("\n[0-9]+ passed, 3 failed\n$"));
}

TEST_CASE("an operator that hides in a table fails the check of counts") {
  if (!is_there("python3") || !is_there("yosys")) return;
  const Workplace workplace;
  const std::string program = saboteur(
      workplace,
      "sed -i 's/^endmodule/  wire [3:0] hidden = i0_0[1:0] * i0_0[3:2]; assign c0_0[0] = ^hidden;\\nendmodule/' rtl/table_tl2_DIFF.v");
  const Said said = check(workplace, program, "--schemes tl2 --checks counts");
  INFO(said.text);
  CHECK(said.code == 1);
  CHECK(said.has("FAILED +operators +tl2 +illumination +.mul in table_tl2_DIFF"));
}

TEST_CASE("a wrong word in a ROM is found by the vectors") {
  if (!is_there("python3") || !is_there("verilator")) return;
  const Workplace workplace;
  const std::string program =
      saboteur(workplace, "{ [ ! -e rom ] || { sed -i 's/^0/1/' rom/tl2_HAV.hex && sha256sum rom/* >test/roms.sha256; }; }");
  const Said said = check(workplace, program, "--schemes tl2 --checks bit_exact --vectors 2000 --quick");
  INFO(said.text);
  CHECK(said.code == 1);
  CHECK(said.has("FAILED +bit_exact +tl2 +illumination.*vector [0-9]+, output"));
  CHECK(said.has("ok +bit_exact +tl2 +environment"));
}

TEST_CASE("what the check does not know is refused before anything runs") {
  if (!is_there("python3")) return;
  const Workplace workplace;
  CHECK(check(workplace, BUMP_PROGRAM, "--schemes lee2008").code == 2);
  CHECK(check(workplace, BUMP_PROGRAM, "--checks areas").code == 2);
  CHECK(check(workplace, BUMP_PROGRAM, "--vectors many").code == 2);
  CHECK(check(workplace, BUMP_PROGRAM, "--vectors 1").code == 2);
  CHECK(check(workplace, BUMP_PROGRAM, "--quick --checks area").code == 2);
  CHECK(check(workplace, "/bin/true", "").code == 2);
  CHECK(check(workplace, "/nowhere/bumpsim", "").code == 2);
}
