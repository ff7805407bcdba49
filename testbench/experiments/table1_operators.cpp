// Table 1's own cells, and the numbers of operators that its text gives.

#include <algorithm>

#include "datapath/error.h"
#include "datapath/invariant.h"
#include "testbench/experiments/table1_sections.h"

namespace bump {

namespace {

std::string agreement_of(const published::Table1Cell* cell, const std::vector<Table1Value>& values, bool modelled) {
  if (!modelled) return "not modelled";
  if (cell == nullptr) return "not listed";
  if (!cell->available) return "not available";
  if (std::any_of(values.begin(), values.end(), [](const Table1Value& value) { return value.differs(); })) return "differs";
  switch (cell->agreement) {
    case published::Agreement::exact:
      return "exact";
    case published::Agreement::convention:
      return "by convention";
    case published::Agreement::construction:
      return "by construction";
  }
  return "";
}

/// A value says why if it differs, or agrees on something that could be counted otherwise; zeros that nobody lists do not.
void give_reasons(Table1Row& row, bool where_equal) {
  for (Table1Value& value : row.values) {
    if (!value.published) continue;
    const bool listed = *value.published != 0 || value.derived.value_or(0) != 0;
    if (value.differs() || !value.derived || (where_equal && listed)) value.why = row.why;
  }
}

std::vector<std::optional<double>> printed_if(const published::Table1Cell* cell) {
  if (cell == nullptr || !cell->available) return {};
  return printed(cell->counts);
}

bool any_operator(const Inventory& i) {
  return i.multipliers + i.adders + i.dividers + i.square_roots + i.tables + i.maps > 0;
}

Table1Row row_of(const Table1Source& source, const std::string& step, Table1Kind kind) {
  Table1Row row;
  row.section = Table1Section::operators;
  row.kind = kind;
  row.scheme = source.about.id;
  row.step = step;
  row.reconstruction = source.reconstructs(step);
  return row;
}

bool same_operators(const Inventory& a, const Inventory& b) {
  return a.multipliers == b.multipliers && a.adders == b.adders && a.dividers == b.dividers && a.square_roots == b.square_roots &&
         a.tables == b.tables && a.maps == b.maps;
}

/// Why the configured design counts as it does: what is known of the cell, or, where settings change the count, those and the reading that
/// they select.
std::string reason(const Table1Context& context, const Table1Source& source, const std::string& step, const published::Table1Cell* cell) {
  if (!source.built) return "not modelled";
  const auto counted = [&](const BuiltScheme& built) { return step_count(built, step, Portion::published, source.blends_colours()); };
  if (!source.at_defaults || same_operators(counted(*source.built), counted(*source.at_defaults)))
    return cell == nullptr ? "" : std::string(cell->remark);
  std::string why = configured_text(source.about);
  if (cell == nullptr) return why;
  for (const published::Reading& reading : cell->readings)
    if (!reading.settings.empty() && has_settings(context.configuration, reading.settings)) why += "; " + std::string(reading.why);
  return why;
}

void add_step(const Table1Context& context, const Table1Source& source, const std::string& step, std::vector<Table1Row>& rows) {
  const published::Table1Cell* cell = published::table1_cell(source.about.id, step);
  Table1Row row = row_of(source, step, Table1Kind::step);
  Inventory derived;
  if (source.built) derived = step_count(*source.built, step, Portion::published, source.blends_colours());
  row.values = operator_values(source.built ? &derived : nullptr, printed_if(cell));
  row.source = cell != nullptr ? std::string(cell->source) : "";
  row.agreement = agreement_of(cell, row.values, source.built.has_value());
  row.why = reason(context, source, step, cell);
  give_reasons(row, row.agreement != "exact");
  rows.push_back(row);
}

void add_readings(const Table1Context& context, const Table1Source& source, const std::string& step, std::vector<Table1Row>& rows) {
  const published::Table1Cell* cell = published::table1_cell(source.about.id, step);
  if (cell == nullptr || !source.built) return;
  for (const published::Reading& reading : cell->readings) {
    if (reading.settings.empty() || has_settings(context.configuration, reading.settings)) continue;
    Table1Row row = row_of(source, step, Table1Kind::reading);
    row.settings = reading.settings;
    row.source = cell->source;
    row.why = reading.why;
    try {
      const BuiltScheme other = build_scheme(*source.scheme, with_settings(context.configuration, reading.settings));
      const Inventory derived = step_count(other, step, Portion::published, source.blends_colours());
      row.values = operator_values(&derived, printed_if(cell));
      row.agreement = agreement_of(cell, row.values, true);
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::input) throw;
      row.values = operator_values(nullptr, printed_if(cell));
      row.agreement = "not possible";
      row.why += "; not with this configuration: " + error.text().what;
    }
    give_reasons(row, false);
    rows.push_back(row);
  }
}

void add_addition(const Table1Source& source, const std::string& step, const Inventory& addition, const std::string& why,
                  std::vector<Table1Row>& rows) {
  if (!any_operator(addition)) return;
  Table1Row row = row_of(source, step, Table1Kind::addition);
  row.values = operator_values(&addition);
  row.agreement = "not listed";
  row.why = why;
  rows.push_back(row);
}

void add_total(const Table1Source& source, std::vector<Table1Row>& rows) {
  Table1Row row = row_of(source, "total", Table1Kind::total);
  row.reconstruction = !source.about.reconstructed.empty();
  Inventory derived;
  bool listed = true, available = true;
  published::OperatorCounts sum;
  for (const std::string& step : table1_steps) {
    if (source.built) derived += step_count(*source.built, step, Portion::published, source.blends_colours());
    const published::Table1Cell* cell = published::table1_cell(source.about.id, step);
    listed = listed && cell != nullptr;
    available = available && cell != nullptr && cell->available;
    if (cell == nullptr) continue;
    const published::OperatorCounts& c = cell->counts;
    sum = {sum.multipliers + c.multipliers,   sum.adders + c.adders, sum.dividers + c.dividers,
           sum.square_roots + c.square_roots, sum.tables + c.tables, sum.maps + c.maps};
  }
  row.values = operator_values(source.built ? &derived : nullptr, available ? printed(sum) : std::vector<std::optional<double>>{});
  const bool differ = std::any_of(row.values.begin(), row.values.end(), [](const Table1Value& value) { return value.differs(); });
  row.agreement = !source.built ? "not modelled"
                  : !listed     ? "not listed"
                  : !available  ? "not available"
                  : differ      ? "differs"
                                : "as its steps";
  row.why = !source.built ? "not modelled" : differ ? "sum of the steps, where the reasons stand" : "";
  if (source.built && source.blends_colours())
    row.why += std::string(row.why.empty() ? "" : "; ") + "includes colour blending, which no other total does";
  give_reasons(row, false);
  rows.push_back(row);
}

}  // namespace

std::vector<std::optional<double>> printed(const published::OperatorCounts& c) {
  std::vector<std::optional<double>> numbers;
  for (const int count : {c.multipliers, c.adders, c.dividers, c.square_roots, c.tables, c.maps})
    numbers.push_back(count < 0 ? std::nullopt : std::optional<double>(count));
  return numbers;
}

std::vector<Table1Value> operator_values(const Inventory* derived, const std::vector<std::optional<double>>& published) {
  const char* const names[] = {"multipliers", "adders", "dividers", "square_roots", "tables", "maps"};
  std::vector<Table1Value> values;
  for (std::size_t i = 0; i < std::size(names); ++i) {
    Table1Value value;
    value.quantity = names[i];
    value.unit = "operators";
    if (derived != nullptr) {
      const int counts[] = {derived->multipliers,  derived->adders, derived->dividers,
                            derived->square_roots, derived->tables, derived->maps};
      value.derived = counts[i];
    }
    if (!published.empty()) value.published = published[i];
    values.push_back(value);
  }
  return values;
}

void add_operators(const Table1Context& context, std::vector<Table1Row>& rows) {
  for (const Table1Source& source : context.sources) {
    if (source.built && source.built->design.conversion)
      add_addition(source, "conversion", count(*source.built->design.conversion), "forms per pixel what the paper takes as given", rows);
    for (const std::string& step : table1_steps) {
      add_step(context, source, step, rows);
      if (source.built)
        add_addition(source, step, step_count(*source.built, step, Portion::addition, false), "needed beside what is published", rows);
      add_readings(context, source, step, rows);
    }
    add_total(source, rows);
  }
}

void add_text_counts(const Table1Context& context, std::vector<Table1Row>& rows) {
  for (const published::TextCount& claim : published::text_counts) {
    const Table1Source* source = context.find(claim.part.scheme);
    Table1Row row;
    row.section = Table1Section::text;
    row.scheme = claim.part.scheme;
    row.step = claim.about;
    row.settings = claim.part.settings;
    row.source = claim.source;
    row.why = claim.remark;
    std::optional<Inventory> derived;
    if (source != nullptr && source->built) {
      row.reconstruction = source->reconstructs(std::string(claim.part.unit));
      const auto counted = [&](const Configuration& configuration) {
        return part_count(source->scheme->design(with_settings(configuration, claim.part.settings), Material{}), claim.part);
      };
      try {
        derived = counted(context.configuration);
        if (source->at_defaults && !same_operators(*derived, counted(Configuration(context.configuration.parameters()))))
          row.why = configured_text(source->about);
      } catch (const Error& error) {
        if (error.kind() != ErrorKind::input) throw;
        row.why = "not with this configuration: " + error.text().what;
      }
    } else {
      row.why = "not modelled";
    }
    const std::vector<std::optional<double>> numbers = printed(claim.counts);
    const std::vector<Table1Value> all = operator_values(derived ? &*derived : nullptr, numbers);
    std::copy_if(all.begin(), all.end(), std::back_inserter(row.values),
                 [](const Table1Value& value) { return value.published.has_value(); });
    const bool differ = std::any_of(row.values.begin(), row.values.end(), [](const Table1Value& value) { return value.differs(); });
    row.agreement = !derived ? "not modelled" : differ ? "differs" : "exact";
    give_reasons(row, false);
    rows.push_back(row);
  }
}

}  // namespace bump
