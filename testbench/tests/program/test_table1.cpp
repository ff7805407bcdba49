#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "testbench/tests/program/program_runner.h"

using namespace bump;

namespace fs = std::filesystem;

namespace {

std::size_t files_in(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

}  // namespace

TEST_CASE("reports/table1.md is what the program writes") {
  const TemporaryFolder folder;
  const Outcome outcome = bumpsim("table1 --format md", folder.path());
  REQUIRE(outcome.code == 0);
  INFO("to bring it up to date: build/bumpsim table1 --format md --out reports/table1.md --force");
  const bool same = outcome.out == read_file(fs::path(BUMP_SOURCE_DIR) / "reports" / "table1.md");
  CHECK(same);
}

TEST_CASE("table1 writes a file whole, and replaces one only when told to") {
  const TemporaryFolder folder;
  const Outcome printed = bumpsim("table1 --format csv", folder.path());
  REQUIRE(printed.code == 0);
  const Outcome written = bumpsim("table1 --format csv --out table.csv", folder.path());
  CHECK(written.code == 0);
  CHECK(written.out.empty());
  CHECK(read_file(folder.path() / "table.csv") == printed.out);
  CHECK(files_in(folder.path()) == 1);

  folder.write("table.csv", "mine\n");
  const Outcome refused = bumpsim("table1 --out table.csv", folder.path());
  CHECK(refused.code == 2);
  CHECK(refused.err.find("--force") != std::string::npos);
  CHECK(read_file(folder.path() / "table.csv") == "mine\n");
  CHECK(bumpsim("table1 --format csv --out table.csv --force", folder.path()).code == 0);
  CHECK(read_file(folder.path() / "table.csv") == printed.out);
  CHECK(files_in(folder.path()) == 1);
}

TEST_CASE("table1 prints one JSON document, by either option") {
  const TemporaryFolder folder;
  const Outcome flag = bumpsim("table1 --json", folder.path()), format = bumpsim("table1 --format json", folder.path());
  CHECK(flag.code == 0);
  CHECK(flag.err.empty());
  CHECK(flag.out == format.out);
  CHECK(nlohmann::json::parse(flag.out).at("schema") == "bumpsim-table1");
}

TEST_CASE("table1 says what is wrong with what it is told") {
  const TemporaryFolder folder;
  const Outcome key = bumpsim("table1 --set lee2007.from=13", folder.path());
  CHECK(key.code == 2);
  CHECK(key.err.find("lee2007.form") != std::string::npos);
  CHECK(key.out.empty());
  CHECK(bumpsim("table1 --set lee2007.form=12", folder.path()).code == 2);
  CHECK(bumpsim("table1 --format html", folder.path()).code == 2);
  CHECK(bumpsim("table1 --out .", folder.path()).code == 2);
  CHECK(bumpsim("table1 --set kim2001.transform=direct --set kim2001.map_filter=vector", folder.path()).code == 2);
  CHECK(files_in(folder.path()) == 0);
}

TEST_CASE("table1 shows what is configured") {
  const TemporaryFolder folder;
  const Outcome outcome = bumpsim("table1 --set lee2007.form=13", folder.path());
  CHECK(outcome.code == 0);
  CHECK(outcome.out.find("Configured: lee2007.form=13 (default 11).") != std::string::npos);
  CHECK(outcome.out.find("13/11*") != std::string::npos);
}
