#include <unistd.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>

#include "datapath/error.h"
#include "testbench/experiments/result_table.h"
#include "testbench/results/text_table.h"

using namespace bump;

namespace {

std::string message(const std::function<void()>& work) {
  try {
    work();
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::input);
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("what csv_line writes is read back") {
  const std::vector<std::vector<std::string>> rows = {
      {"scheme", "note, long", "x"}, {"lee2007", "say \"no\"", "1.5"}, {"", "two\nlines", "-inf"}, {"a;b", " blank ", "1e3"}};
  std::string text;
  for (const auto& row : rows) text += csv_line(row);
  for (const std::string& variant : {text, "\xEF\xBB\xBF" + text, text + "\n\n"}) {
    const ResultTable table = table_from_csv(variant, "t.csv");
    CHECK(table.columns == rows[0]);
    REQUIRE(table.rows.size() == 3);
    for (std::size_t i = 0; i < 3; ++i) CHECK(table.rows[i] == rows[i + 1]);
    CHECK(*table.number(0, 2) == 1.5);
    CHECK((std::isinf(*table.number(1, 2)) && *table.number(1, 2) < 0));
    CHECK(*table.number(2, 2) == 1000);
    CHECK_FALSE(table.number(0, 0));
    CHECK(table.is_numeric(2));
    CHECK_FALSE(table.is_numeric(1));
    CHECK(*table.find("note, long") == 1);
    CHECK_FALSE(table.find("note"));
  }
  CHECK(table_from_csv("a,b\r\n1,2\r\n", "t").rows == std::vector<std::vector<std::string>>{{"1", "2"}});
}

TEST_CASE("JSON and JSON Lines make the same table") {
  const std::string first = R"({"scheme": "lee2007", "psnr": 25.5, "chosen": {"a": 3}, "list": [1], "none": null})",
                    second = R"({"scheme": "cart", "psnr": "inf", "late": true, "chosen": {"a": 4}})";
  const ResultTable lines = table_from_json_lines(first + "\n\n" + second + "\n", "t.jsonl");
  CHECK(lines.columns == std::vector<std::string>{"scheme", "psnr", "chosen.a", "none", "late"});
  CHECK(lines.rows[0] == std::vector<std::string>{"lee2007", "25.5", "3", "", ""});
  CHECK(lines.rows[1] == std::vector<std::string>{"cart", "inf", "4", "", "true"});
  for (const std::string& text : {"[" + first + "," + second + "]", "{\"schema\": \"x\", \"rows\": [" + first + "," + second + "]}"}) {
    const ResultTable whole = table_from_json(text, "t.json");
    CHECK(whole.columns == lines.columns);
    CHECK(whole.rows == lines.rows);
  }
}

TEST_CASE("what is no table is explained with its place") {
  CHECK(message([] { table_from_csv("a,b\n1,2\n1,2,3\n", "t.csv"); }).find("t.csv:3") != std::string::npos);
  CHECK(message([] { table_from_csv("a,\"b\nc\"\n1,2\n3\n", "t.csv"); }).find("t.csv:4") != std::string::npos);
  CHECK(message([] { table_from_csv("a,b\n1,\"2\n", "t.csv"); }).find("without end") != std::string::npos);
  CHECK(message([] { table_from_csv("a,b\n1,\"2\"3\n", "t.csv"); }).find("t.csv:2") != std::string::npos);
  CHECK(message([] { table_from_csv("a,a\n1,2\n", "t.csv"); }).find("two columns are called 'a'") != std::string::npos);
  CHECK(message([] { table_from_csv("", "t.csv"); }).find("empty") != std::string::npos);
  CHECK(message([] { table_from_csv("a,b\n", "t.csv"); }).find("without rows") != std::string::npos);
  CHECK(message([] { table_from_json_lines("{\"a\": 1}\n{\"a\": \n", "t.jsonl"); }).find("t.jsonl:2") != std::string::npos);
  CHECK(message([] { table_from_json_lines("{\"a\": 1}\n3\n", "t.jsonl"); }).find("t.jsonl:2") != std::string::npos);
  CHECK(message([] { table_from_json("{\"points\": []}", "t.json"); }).find("without rows") != std::string::npos);
  CHECK(message([] { table_from_json("[1]", "t.json"); }).find("no JSON object") != std::string::npos);
  CHECK(message([] { table_from_json("[]", "t.json"); }).find("without rows") != std::string::npos);
  CHECK(message([] { read_result_table("/nowhere/t.csv"); }).find("/nowhere/t.csv") != std::string::npos);
}

TEST_CASE("the folder of a sweep is its points; one that is not finished says so") {
  namespace fs = std::filesystem;
  const fs::path folder = fs::temp_directory_path() / ("bump_result_table_" + std::to_string(::getpid()));
  fs::create_directories(folder);
  CHECK(message([&] { read_result_table(folder.string()); }).find("points.csv") != std::string::npos);
  std::ofstream(folder / "journal.jsonl") << "{\"journal\": \"bumpsim-sweep\", \"version\": 1}\n";
  CHECK(message([&] { read_result_table(folder.string()); }).find("not finished") != std::string::npos);
  std::ofstream(folder / "points.csv") << "scheme,cycles\nlee2007,10\n";
  CHECK(read_result_table(folder.string()).rows.size() == 1);
  std::ofstream(folder / "other") << "[{\"a\": 1}]";  // told by its content
  CHECK(read_result_table((folder / "other").string()).columns == std::vector<std::string>{"a"});
  fs::remove_all(folder);
}
