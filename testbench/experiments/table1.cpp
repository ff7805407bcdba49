#include "testbench/experiments/table1.h"

#include <algorithm>
#include <cmath>

#include "datapath/invariant.h"
#include "testbench/experiments/table1_formats.h"
#include "testbench/experiments/table1_sections.h"

namespace bump {

namespace {

/// "key=value (default ...)" of the parameters away from their defaults whose keys begin with `prefix`.
std::vector<std::string> away_from_default(const Configuration& configuration, const std::string& prefix) {
  std::vector<std::string> changed;
  for (const auto& [key, entry] : configuration.entries()) {
    const Parameter& parameter = *configuration.parameters().find(key);
    if (key.compare(0, prefix.size(), prefix) != 0 || entry.value == parameter.fallback) continue;
    changed.push_back(key + "=" + to_string(entry.value) + " (default " + to_string(parameter.fallback) + ")");
  }
  return changed;
}

/// The columns of Table 1 in its order, then what else is registered.
std::vector<Table1Source> sources(const Configuration& configuration) {
  std::vector<Table1Source> result;
  const auto known = [&](std::string_view id) {
    return std::any_of(result.begin(), result.end(), [&](const Table1Source& source) { return source.about.id == id; });
  };
  for (const published::Table1Cell& cell : published::table1) {
    if (known(cell.scheme)) continue;
    result.emplace_back();
    result.back().about.id = cell.scheme;
    result.back().about.column = cell.column;
  }
  for (const Scheme* scheme : all_schemes()) {
    if (known(scheme->page().id)) continue;
    result.emplace_back();
    result.back().about.id = scheme->page().id;
  }
  for (const Scheme* scheme : all_schemes()) {
    const SchemePage& page = scheme->page();
    Table1Source& source = *std::find_if(result.begin(), result.end(), [&](const Table1Source& s) { return s.about.id == page.id; });
    source.scheme = scheme;
    source.about.title = page.title;
    source.about.source = page.source;
    source.about.provenance = page.provenance;
    source.about.reconstructed = page.reconstructed;
    source.about.modelled = true;
    source.about.configured = away_from_default(configuration, page.id + ".");
    source.built = build_scheme(*scheme, configuration);
    if (!source.about.configured.empty()) source.at_defaults = build_scheme(*scheme, Configuration(configuration.parameters()));
  }
  return result;
}

}  // namespace

std::optional<double> Table1Value::difference() const {
  return derived && published ? std::optional<double>(*derived - *published) : std::nullopt;
}

bool Table1Value::differs() const {
  return derived && published && *derived != *published;
}

const Table1Value* Table1Row::find(const std::string& quantity) const {
  const auto value = std::find_if(values.begin(), values.end(), [&](const Table1Value& v) { return v.quantity == quantity; });
  return value == values.end() ? nullptr : &*value;
}

const Table1Scheme& Table1::scheme(const std::string& id) const {
  const auto found = std::find_if(schemes.begin(), schemes.end(), [&](const Table1Scheme& s) { return s.id == id; });
  BUMP_ASSERT(found != schemes.end());
  return *found;
}

const char* name_of(Table1Section section) {
  switch (section) {
    case Table1Section::operators:
      return "operators";
    case Table1Section::text:
      return "text";
    case Table1Section::storage:
      return "storage";
    case Table1Section::text_sizes:
      return "text_sizes";
    case Table1Section::reduction:
      return "reduction";
    case Table1Section::claim:
      return "claim";
    case Table1Section::beyond:
      return "beyond";
  }
  return "";
}

bool Table1Source::reconstructs(const std::string& step) const {
  return std::find(about.reconstructed.begin(), about.reconstructed.end(), step) != about.reconstructed.end();
}

bool Table1Source::blends_colours() const {
  const published::Table1Cell* cell = published::table1_cell(about.id, "illumination");
  return cell != nullptr && cell->includes_colour_blending;
}

const Table1Source* Table1Context::find(std::string_view scheme) const {
  for (const Table1Source& source : sources)
    if (source.about.id == scheme) return &source;
  return nullptr;
}

std::string configured_text(const Table1Scheme& scheme) {
  std::string text;
  for (const std::string& setting : scheme.configured) text += (text.empty() ? "set to " : ", ") + setting;
  return text;
}

Table1 make_table1(const Configuration& configuration) {
  const Table1Context context{configuration, sources(configuration)};
  Table1 table;
  for (const Table1Source& source : context.sources) table.schemes.push_back(source.about);
  table.settings = away_from_default(configuration, "");
  add_operators(context, table.rows);
  add_text_counts(context, table.rows);
  add_storage(context, table.rows);
  add_reductions(context, table.rows);
  add_beyond(context, table.rows);
  return table;
}

std::string format_table1(const Table1& table, const std::string& format) {
  if (format == "csv") return table1_csv(table);
  if (format == "json") return table1_json(table);
  BUMP_ASSERT(format == "text" || format == "md");
  return table1_document(table, format == "md");
}

}  // namespace bump
