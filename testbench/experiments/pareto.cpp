#include "testbench/experiments/pareto.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "channels/parameters.h"
#include "datapath/error.h"

namespace bump {

namespace {

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::string lower(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

/// The measure that "psnr" means in the tables of the program.
const std::vector<std::string>& usual_psnr() {
  static const std::vector<std::string> columns = {"psnr_worst_db", "psnr_hardware_to_reference_db"};
  return columns;
}

std::vector<std::string> numeric_columns(const ResultTable& table, const std::string& part) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < table.columns.size(); ++i)
    if (lower(table.columns[i]).find(lower(part)) != std::string::npos && table.is_numeric(i)) names.push_back(table.columns[i]);
  return names;
}

[[noreturn]] void unknown_column(const ResultTable& table, const std::string& name, const std::string& option) {
  const std::vector<std::string> all = numeric_columns(table, "");
  const std::string near = nearest_word(name, table.columns);
  std::string list;
  for (std::size_t i = 0; i < all.size() && i < 30; ++i) list += (list.empty() ? "" : ", ") + all[i];
  if (all.size() > 30) list += fmt::format(" and {} more", all.size() - 30);
  throw Error({"no column '" + name + "'",
               {table.file},
               "the columns of numbers are: " + list,
               near.empty() ? option + " with one of them" : option + " " + near});
}

std::size_t column_of_numbers(const ResultTable& table, const std::string& name, const std::string& option) {
  if (const auto exact = table.find(name)) {
    if (table.is_numeric(*exact)) return *exact;
    throw Error(
        {"column '" + name + "' holds no numbers", {table.file}, "", option + " with one of: " + joined(numeric_columns(table, ""))});
  }
  if (lower(name) == "psnr")
    for (const std::string& usual : usual_psnr())
      if (const auto found = table.find(usual); found && table.is_numeric(*found)) return *found;
  const std::vector<std::string> candidates = numeric_columns(table, name);
  if (candidates.empty()) unknown_column(table, name, option);
  if (candidates.size() > 1)
    throw Error({fmt::format("'{}' may mean {} columns", name, candidates.size()),
                 {table.file},
                 joined(candidates),
                 option + " " + candidates.front()});
  return *table.find(candidates.front());
}

/// The label's column, or another that any cell may stand in.
std::size_t any_column(const ResultTable& table, const std::string& name, const std::string& option) {
  if (const auto found = table.find(name)) return *found;
  const std::string near = nearest_word(name, table.columns);
  throw Error({"no column '" + name + "'",
               {table.file},
               "the columns are: " + joined(table.columns),
               near.empty() ? option + " with one of them" : option + " with " + near});
}

struct Condition {
  std::size_t column;
  std::string value;
};

Condition condition_of(const ResultTable& table, const std::string& text) {
  const std::size_t sign = text.find('=');
  if (sign == std::string::npos || sign == 0)
    throw Error({"'" + text + "' is no condition", {}, "it is a column, '=' and a value", "--where scene=world_sphere"});
  return {any_column(table, text.substr(0, sign), "--where"), text.substr(sign + 1)};
}

/// Numbers are equal however they are written.
bool holds(const ResultTable& table, std::size_t row, const Condition& condition) {
  if (table.rows[row][condition.column] == condition.value) return true;
  ResultTable given;
  given.rows = {{condition.value}};
  const auto wanted = given.number(0, 0), is = table.number(row, condition.column);
  return wanted && is && *wanted == *is;
}

/// "ok" where the table has none.
std::string status_of(const ResultTable& table, std::size_t row) {
  const auto status = table.find("status");
  return status ? table.rows[row][*status] : "ok";
}

/// Columns left of the status that are not the same in all points, without those that are shown anyway and running numbers.
std::vector<std::size_t> identity_columns(const ResultTable& table, const std::vector<ParetoPoint>& points,
                                          const std::set<std::size_t>& shown) {
  std::vector<std::size_t> columns;
  const auto status = table.find("status");
  for (std::size_t i = 0; status && i < *status; ++i) {
    const std::string& name = table.columns[i];
    if (shown.count(i) > 0 || name == "point" || name == "id") continue;
    const bool differs = std::any_of(points.begin(), points.end(), [&](const ParetoPoint& point) {
      return table.rows[point.row][i] != table.rows[points.front().row][i];
    });
    if (differs) columns.push_back(i);
  }
  return columns;
}

[[noreturn]] void nothing_left(const ParetoFront& front) {
  throw Error(
      {"no row is left",
       {front.file},
       fmt::format("of {} rows {} do not meet --where, {} failed, {} did not reach their quality, {} have no number in both columns",
                   front.rows, front.filtered, front.failed, front.not_reached, front.without_value),
       "other columns, or other conditions"});
}

void check_scale(const ParetoFront& front, const ParetoAxis& axis, double ParetoPoint::*value) {
  if (!axis.logarithmic) return;
  for (const ParetoPoint& point : front.points)
    if (point.*value <= 0)
      throw Error({fmt::format("a logarithmic axis cannot show {:g} of column '{}'", point.*value, axis.column),
                   {front.file},
                   fmt::format("row {} has it", point.row + 1),
                   "a linear axis, without --log"});
}

}  // namespace

void mark_front(std::vector<ParetoPoint>& points, bool high_x_is_better, bool high_y_is_better) {
  const double x_sign = high_x_is_better ? -1 : 1, y_sign = high_y_is_better ? -1 : 1;
  std::vector<ParetoPoint*> order;
  for (ParetoPoint& point : points) order.push_back(&point);
  const auto key = [&](const ParetoPoint* point) { return std::pair(x_sign * point->x, y_sign * point->y); };
  std::stable_sort(order.begin(), order.end(), [&](const ParetoPoint* a, const ParetoPoint* b) { return key(a) < key(b); });
  const ParetoPoint* last = nullptr;  // on the front; of all before, the best y
  for (ParetoPoint* point : order) {
    point->on_front = last == nullptr || key(point).second < key(last).second || key(point) == key(last);
    if (point->on_front) last = point;
  }
}

ParetoFront pareto_front(const ResultTable& table, const ParetoOptions& options) {
  ParetoFront front;
  front.file = table.file;
  front.rows = table.rows.size();
  const std::size_t x = column_of_numbers(table, options.x.column, "--x"), y = column_of_numbers(table, options.y.column, "--y");
  front.x = options.x;
  front.y = options.y;
  front.x.column = table.columns[x];
  front.y.column = table.columns[y];
  std::optional<std::size_t> label = options.label.empty() ? table.find("scheme") : any_column(table, options.label, "--label");
  if (label) front.label = table.columns[*label];
  std::vector<Condition> conditions;
  for (const std::string& text : options.where) conditions.push_back(condition_of(table, text));

  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    if (!std::all_of(conditions.begin(), conditions.end(), [&](const Condition& one) { return holds(table, row, one); })) {
      ++front.filtered;
      continue;
    }
    const std::string status = status_of(table, row);
    if (status != "ok" && status != "reached") {
      ++(status == "not_reached" ? front.not_reached : front.failed);
      continue;
    }
    const auto at_x = table.number(row, x), at_y = table.number(row, y);
    if (!at_x || !at_y) {
      ++front.without_value;
      continue;
    }
    ParetoPoint point;
    point.row = row;
    point.x = *at_x;
    point.y = *at_y;
    if (label) point.label = table.rows[row][*label];
    front.points.push_back(std::move(point));
  }
  if (front.points.empty()) nothing_left(front);
  check_scale(front, front.x, &ParetoPoint::x);
  check_scale(front, front.y, &ParetoPoint::y);
  mark_front(front.points, front.x.high_is_better, front.y.high_is_better);

  std::set<std::size_t> shown = {x, y};
  if (label) shown.insert(*label);
  for (const std::size_t column : identity_columns(table, front.points, shown)) {
    front.identity.push_back(table.columns[column]);
    for (ParetoPoint& point : front.points) point.identity.push_back(table.rows[point.row][column]);
  }
  return front;
}

std::vector<const ParetoPoint*> ParetoFront::front() const {
  std::vector<const ParetoPoint*> marked;
  for (const ParetoPoint& point : points)
    if (point.on_front) marked.push_back(&point);
  std::stable_sort(marked.begin(), marked.end(),
                   [](const ParetoPoint* a, const ParetoPoint* b) { return std::pair(a->x, a->y) < std::pair(b->x, b->y); });
  return marked;
}

}  // namespace bump
