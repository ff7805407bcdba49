#pragma once
// The Pareto front of a table in two of its columns: the rows that no other row beats, where one row beats another if it is no worse in
// both and better in one. Rows with the same two values are on the front together. No model of hardware.

#include <string>
#include <vector>

#include "testbench/experiments/result_table.h"

namespace bump {

struct ParetoAxis {
  std::string column;
  bool high_is_better = false;
  bool logarithmic = false;  ///< of the plot
};

struct ParetoOptions {
  ParetoAxis x, y;
  std::string label;               ///< column; empty: "scheme" if there is one
  std::vector<std::string> where;  ///< "column=value", all of them
};

struct ParetoPoint {
  std::size_t row = 0;  ///< of the table, from 0
  double x = 0, y = 0;  ///< may be infinite
  std::string label;
  bool on_front = false;
  std::vector<std::string> identity;  ///< cells of the front's identity columns
};

struct ParetoFront {
  std::string file;
  ParetoAxis x, y;                    ///< columns by their full names
  std::string label;                  ///< column, or empty
  std::vector<std::string> identity;  ///< columns that tell the points apart: those left of "status" that are not the same in all
  std::vector<ParetoPoint> points;    ///< in order of rows
  std::size_t rows = 0;               ///< of the table
  std::size_t filtered = 0;           ///< left out by `where`
  std::size_t failed = 0;             ///< left out for their status
  std::size_t not_reached = 0;        ///< left out: rows of a fit whose design does not have the quality that the others have
  std::size_t without_value = 0;      ///< left out for a cell that is no number

  /// Points on the front, by x, then y, then row.
  std::vector<const ParetoPoint*> front() const;
};

/// Columns may be given by a part of their name that no other column of numbers has. Rows whose "status" is neither ok nor reached
/// are left out. Throws Error(input): unknown or ambiguous columns, no row left, values that a logarithmic axis cannot show.
ParetoFront pareto_front(const ResultTable& table, const ParetoOptions& options);

/// Sets `on_front`.
void mark_front(std::vector<ParetoPoint>& points, bool high_x_is_better, bool high_y_is_better);

}  // namespace bump
