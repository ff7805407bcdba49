#include "testbench/experiments/result_table.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <system_error>

#include "channels/parameters.h"
#include "datapath/error.h"
#include "testbench/experiments/sweep_journal.h"
#include "testbench/experiments/sweep_tables.h"

namespace bump {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Adds rows of named cells, columns as they appear.
class Collector {
 public:
  explicit Collector(const std::string& file) { table_.file = file; }

  void add(const Json& row) {
    table_.rows.emplace_back(table_.columns.size());
    add_members(row, "");
  }
  ResultTable take() {
    for (auto& row : table_.rows) row.resize(table_.columns.size());
    if (table_.rows.empty()) throw Error({"a table without rows", {table_.file}, "", "a sweep or fit that has results"});
    return std::move(table_);
  }

 private:
  void add_members(const Json& object, const std::string& prefix) {
    for (const auto& [name, value] : object.items()) {
      if (value.is_object())
        add_members(value, prefix + name + ".");
      else if (!value.is_array())
        cell(prefix + name) = text_of(value);
    }
  }
  std::string& cell(const std::string& column) {
    const auto [place, is_new] = index_.try_emplace(column, table_.columns.size());
    if (is_new) table_.columns.push_back(column);
    std::vector<std::string>& row = table_.rows.back();
    if (row.size() < table_.columns.size()) row.resize(table_.columns.size());
    return row[place->second];
  }
  static std::string text_of(const Json& value) {
    if (value.is_null()) return "";
    if (value.is_string()) return value.get<std::string>();
    if (value.is_number_float()) return to_string(ParameterValue(value.get<double>()));
    return value.dump();
  }

  ResultTable table_;
  std::map<std::string, std::size_t> index_;
};

Json parse_json(const std::string& text, const std::string& file, int line) {
  try {
    return Json::parse(text);
  } catch (const nlohmann::json::exception& error) {
    throw Error({"not JSON", Location(file, line), error.what(), "a table that bumpsim wrote"});
  }
}

/// RFC 4180.
class CsvReader {
 public:
  CsvReader(const std::string& text, const std::string& file) : text_(text), file_(file) {
    if (text_.compare(0, 3, "\xEF\xBB\xBF") == 0) at_ = 3;
  }

  /// False at the end. Blank lines are passed over.
  bool record(std::vector<std::string>& fields) {
    while (at_ < text_.size() && (text_[at_] == '\n' || text_[at_] == '\r')) end_of_line();
    fields.clear();
    if (at_ >= text_.size()) return false;
    begun_ = line_;
    for (;;) {
      fields.push_back(field());
      if (at_ < text_.size() && text_[at_] == ',') {
        ++at_;
        continue;
      }
      end_of_line();
      return true;
    }
  }
  int line() const { return begun_; }  ///< of the last record

 private:
  std::string field() {
    if (at_ >= text_.size() || text_[at_] != '"') {
      const std::size_t end = std::min(text_.find_first_of(",\r\n", at_), text_.size());
      const std::string plain = text_.substr(at_, end - at_);
      at_ = end;
      return plain;
    }
    std::string quoted;
    for (++at_; at_ < text_.size(); ++at_) {
      if (text_[at_] == '\n') ++line_;
      if (text_[at_] != '"') {
        quoted += text_[at_];
      } else if (at_ + 1 < text_.size() && text_[at_ + 1] == '"') {
        quoted += text_[at_++];
      } else {
        ++at_;
        if (at_ < text_.size() && text_[at_] != ',' && text_[at_] != '\r' && text_[at_] != '\n')
          throw Error({"text behind a quoted field", Location(file_, line_), "", "a quote inside a field is written twice"});
        return quoted;
      }
    }
    throw Error({"a quoted field without end", Location(file_, begun_), "", "a closing quote"});
  }
  void end_of_line() {
    if (at_ < text_.size() && text_[at_] == '\r') ++at_;
    if (at_ < text_.size() && text_[at_] == '\n') {
      ++at_;
      ++line_;
    }
  }

  const std::string& text_;
  const std::string& file_;
  std::size_t at_ = 0;
  int line_ = 1, begun_ = 1;
};

std::string file_of(const std::string& path) {
  std::error_code error;
  if (!fs::is_directory(path, error)) return path;
  for (const char* name : {sweep_csv_name, sweep_lines_name})
    if (const fs::path file = fs::path(path) / name; fs::is_regular_file(file, error)) return file.string();
  const bool begun = has_sweep_journal(path);
  throw Error({"the folder holds no table",
               {path},
               begun ? "its sweep has not finished" : std::string("there is no ") + sweep_csv_name,
               begun ? "bumpsim sweep again with the same --out: it goes on where it stopped" : "the folder of a sweep, or a file"});
}

std::string text_of_file(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw Error({"cannot read the table", {file}, std::generic_category().message(errno), "the folder of a sweep, or a file"});
  std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  if (in.bad()) throw Error({"cannot read the table", {file}, "reading failed", ""});
  return text;
}

}  // namespace

std::optional<std::size_t> ResultTable::find(const std::string& column) const {
  const auto found = std::find(columns.begin(), columns.end(), column);
  if (found == columns.end()) return std::nullopt;
  return static_cast<std::size_t>(found - columns.begin());
}

std::optional<double> ResultTable::number(std::size_t row, std::size_t column) const {
  const std::string& text = rows[row][column];
  if (text == "inf") return std::numeric_limits<double>::infinity();
  if (text == "-inf") return -std::numeric_limits<double>::infinity();
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, std::chars_format::general);
  if (error != std::errc() || end != text.data() + text.size() || value != value) return std::nullopt;
  return value;
}

bool ResultTable::is_numeric(std::size_t column) const {
  for (std::size_t row = 0; row < rows.size(); ++row)
    if (number(row, column)) return true;
  return false;
}

ResultTable table_from_csv(const std::string& text, const std::string& file) {
  ResultTable table;
  table.file = file;
  CsvReader reader(text, file);
  if (!reader.record(table.columns)) throw Error({"an empty file", {file}, "", "a table with a header"});
  for (std::size_t i = 0; i < table.columns.size(); ++i)
    if (std::find(table.columns.begin(), table.columns.begin() + static_cast<std::ptrdiff_t>(i), table.columns[i]) !=
        table.columns.begin() + static_cast<std::ptrdiff_t>(i))
      throw Error({"two columns are called '" + table.columns[i] + "'", Location(file, 1), "", "names that differ"});
  std::vector<std::string> fields;
  while (reader.record(fields)) {
    if (fields.size() != table.columns.size())
      throw Error({fmt::format("a row of {} fields under a header of {}", fields.size(), table.columns.size()),
                   Location(file, reader.line()), "", "CSV with commas, the first line the names of the columns"});
    table.rows.push_back(fields);
  }
  if (table.rows.empty()) throw Error({"a table without rows", {file}, "", "a sweep or fit that has results"});
  return table;
}

ResultTable table_from_json_lines(const std::string& text, const std::string& file) {
  Collector collector(file);
  int line = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string row = text.substr(begin, end - begin);
    begin = end + 1;
    ++line;
    if (row.find_first_not_of(" \t\r") == std::string::npos) continue;
    const Json json = parse_json(row, file, line);
    if (!json.is_object()) throw Error({"a line that is no JSON object", Location(file, line), "", "one object a row"});
    collector.add(json);
  }
  return collector.take();
}

ResultTable table_from_json(const std::string& text, const std::string& file) {
  const Json json = parse_json(text, file, 0);
  const Json& rows = json.is_object() && json.contains("rows") ? json.at("rows") : json;
  if (!rows.is_array())
    throw Error({"a JSON document without rows", {file}, "rows are looked for in a list, or in \"rows\"", "JSON of bumpsim fit, or CSV"});
  Collector collector(file);
  for (const Json& row : rows) {
    if (!row.is_object()) throw Error({"a row that is no JSON object", {file}, "", "JSON of bumpsim fit, or CSV"});
    collector.add(row);
  }
  return collector.take();
}

ResultTable read_result_table(const std::string& path) {
  const std::string file = file_of(path), text = text_of_file(file), suffix = fs::path(file).extension().string();
  if (suffix == ".jsonl" || suffix == ".ndjson") return table_from_json_lines(text, file);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (suffix == ".json" || (suffix != ".csv" && first != std::string::npos && (text[first] == '{' || text[first] == '[')))
    return table_from_json(text, file);
  return table_from_csv(text, file);
}

}  // namespace bump
