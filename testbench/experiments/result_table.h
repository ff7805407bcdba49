#pragma once
// A table that a command of the program wrote, read back: points of a sweep, a fit, a comparison, or any other CSV with a header, JSON
// Lines of objects, or a JSON document with such objects in "rows" (or that is a list of them). Objects inside objects become columns
// "outer.inner"; lists are passed over. No model of hardware.

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace bump {

struct ResultTable {
  std::string file;
  std::vector<std::string> columns;            ///< in order of appearance
  std::vector<std::vector<std::string>> rows;  ///< as many cells as columns; what is not there is empty

  /// Index of a column, nothing if there is none of that name.
  std::optional<std::size_t> find(const std::string& column) const;
  /// The cell as a number, "inf" and "-inf" included; nothing if it is none.
  std::optional<double> number(std::size_t row, std::size_t column) const;
  /// Whether any cell is a number.
  bool is_numeric(std::size_t column) const;
};

/// `path`: a file, or the folder of a finished sweep. Throws Error(input) with the line of what is wrong.
ResultTable read_result_table(const std::string& path);

/// Of a text, for messages `file` is its name.
ResultTable table_from_csv(const std::string& text, const std::string& file);
ResultTable table_from_json_lines(const std::string& text, const std::string& file);
ResultTable table_from_json(const std::string& text, const std::string& file);

}  // namespace bump
