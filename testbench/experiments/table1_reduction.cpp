// "Up to 78 % fewer multiplications": of what? The proposed design against every other one, by step, from the printed and from the derived
// numbers.

#include <algorithm>
#include <cmath>

#include "testbench/experiments/table1_sections.h"

namespace bump {

namespace {

double tenths(double value) {
  return std::round(10 * value) / 10;
}

/// 1 - ours / theirs in per cent; null if either is not known or theirs is 0.
std::optional<double> reduction(const std::optional<double>& ours, const std::optional<double>& theirs) {
  if (!ours || !theirs || *theirs == 0) return std::nullopt;
  return tenths(100 * (1 - *ours / *theirs));
}

const Table1Row* operators_of(const std::vector<Table1Row>& rows, std::string_view scheme, const std::string& step) {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const Table1Row& row) {
    return row.section == Table1Section::operators && row.scheme == scheme && row.step == step &&
           (row.kind == Table1Kind::step || row.kind == Table1Kind::total);
  });
  return found == rows.end() ? nullptr : &*found;
}

Table1Value change(const std::string& quantity, const Table1Row& ours, const Table1Row& theirs, const std::string& of) {
  const Table1Value &a = *ours.find(of), &b = *theirs.find(of);
  Table1Value value;
  value.quantity = quantity;
  value.unit = "operators";
  if (a.derived && b.derived) value.derived = *a.derived - *b.derived;
  if (a.published && b.published) value.published = *a.published - *b.published;
  return value;
}

Table1Row compare(const Table1Source& other, const Table1Row& ours, const Table1Row& theirs) {
  Table1Row row;
  row.section = Table1Section::reduction;
  row.scheme = other.about.id;
  row.step = theirs.step;
  row.reconstruction = theirs.reconstruction || ours.reconstruction;
  row.agreement = "computed";
  const Table1Value &a = *ours.find("multipliers"), &b = *theirs.find("multipliers");
  Table1Value saved;
  saved.quantity = "multipliers_saved";
  saved.unit = "%";
  saved.derived = reduction(a.derived, b.derived);
  saved.published = reduction(a.published, b.published);
  row.values = {saved, change("adders_more", ours, theirs, "adders"), change("tables_more", ours, theirs, "tables")};
  for (Table1Value& value : row.values)
    if (value.differs() || (value.published && !value.derived)) value.why = "the counts differ or are not modelled; see the operators";
  return row;
}

/// The largest saving of a step, and every architecture that is within rounding of the claim.
void add_claim(const std::string& step, std::vector<Table1Row>& rows) {
  Table1Row row;
  row.section = Table1Section::claim;
  row.scheme = published::proposed;
  row.step = step;
  row.source = published::reduction_claim.source;
  std::optional<double> largest[2];
  std::string whom[2], rounds;
  for (const Table1Row& other : rows) {
    if (other.section != Table1Section::reduction || other.step != step) continue;
    const Table1Value& saved = *other.find("multipliers_saved");
    // Only columns of Table 1 are "previous approaches"; the derived maximum is taken over the same ones.
    if (published::table1_cell(other.scheme, "environment") == nullptr) continue;
    const std::optional<double> both[] = {saved.published, saved.derived};
    for (int i = 0; i < 2; ++i)
      if (both[i] && (!largest[i] || *both[i] > *largest[i])) largest[i] = both[i], whom[i] = other.scheme;
    if (saved.published && std::lround(*saved.published) == published::reduction_claim.percent)
      rounds += (rounds.empty() ? "" : ", ") + other.scheme;
  }
  const char* const names[] = {"largest_saving_from_printed_counts", "largest_saving_from_netlists"};
  for (int i = 0; i < 2; ++i) {
    Table1Value value;
    value.quantity = names[i];
    value.unit = "%";
    value.derived = largest[i];
    value.published = published::reduction_claim.percent;
    value.why = "against " + (whom[i].empty() ? "none" : whom[i]);
    row.values.push_back(value);
  }
  row.why = rounds.empty() ? "no architecture gives the claimed number" : "rounds to the claimed number against " + rounds;
  const bool maximum = largest[0] && std::lround(*largest[0]) == published::reduction_claim.percent;
  row.agreement = maximum ? "maximum agrees" : rounds.empty() ? "differs" : "agrees, but is not the maximum";
  rows.push_back(row);
}

}  // namespace

void add_reductions(const Table1Context& context, std::vector<Table1Row>& rows) {
  const std::array<std::string, 3> bases = {"environment", "illumination", "total"};
  std::vector<Table1Row> added;
  for (const Table1Source& other : context.sources) {
    if (other.about.id == published::proposed) continue;
    for (const std::string& step : bases) {
      const Table1Row *ours = operators_of(rows, published::proposed, step), *theirs = operators_of(rows, other.about.id, step);
      if (ours != nullptr && theirs != nullptr) added.push_back(compare(other, *ours, *theirs));
    }
  }
  for (const std::string& step : bases) add_claim(step, added);
  rows.insert(rows.end(), added.begin(), added.end());
}

}  // namespace bump
