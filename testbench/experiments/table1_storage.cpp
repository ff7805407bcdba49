// Bytes of tables and maps, and the sizes that the text gives.

#include <cmath>

#include "datapath/error.h"
#include "testbench/experiments/table1_sections.h"

namespace bump {

namespace {

void add_bytes(Table1Row& row, const std::string& quantity, const std::optional<double>& bytes) {
  if (!bytes) return;
  Table1Value value;
  value.quantity = quantity;
  value.unit = "bytes";
  value.derived = bytes;
  row.values.push_back(value);
}

void add_stored(const Table1Source& source, const std::string& step, std::vector<Table1Row>& rows) {
  using published::Storage;
  published::Part part;
  part.unit = step;
  Table1Row row;
  row.section = Table1Section::storage;
  row.scheme = source.about.id;
  row.step = step;
  row.reconstruction = source.reconstructs(step);
  const BuiltScheme& built = *source.built;
  add_bytes(row, "table_bytes", part_bytes(built, part, Storage::tables));
  add_bytes(row, "distinct_table_and_map_bytes", part_bytes(built, part, Storage::distinct));
  add_bytes(row, "map_bytes", part_bytes(built, part, Storage::maps));
  const double addition = static_cast<double>(step_count(built, step, Portion::addition, false).table_bits) / 8;
  if (addition > 0) add_bytes(row, "additional_table_bytes", addition);
  if (step == "illumination" && light_map_bytes(built.design) > 0) add_bytes(row, "light_map_bytes", light_map_bytes(built.design));
  if (!row.values.empty()) rows.push_back(row);
}

}  // namespace

void add_storage(const Table1Context& context, std::vector<Table1Row>& rows) {
  for (const Table1Source& source : context.sources)
    if (source.built)
      for (const std::string& step : table1_steps) add_stored(source, step, rows);

  for (const published::TextSize& claim : published::text_sizes) {
    const Table1Source* source = context.find(claim.part.scheme);
    Table1Row row;
    row.section = Table1Section::text_sizes;
    row.scheme = claim.part.scheme;
    row.step = claim.about;
    row.settings = claim.part.settings;
    row.source = std::string(claim.source) + ": \"" + std::string(claim.quoted) + "\"";
    row.why = claim.remark;
    Table1Value value;
    value.quantity = "bytes";
    value.unit = "bytes";
    value.published = claim.bytes;
    row.agreement = "not modelled";
    if (source != nullptr && source->built) {
      row.reconstruction =
          !source->about.reconstructed.empty() && (claim.part.unit.empty() || source->reconstructs(std::string(claim.part.unit)));
      row.why = configured_text(source->about) + (source->about.configured.empty() || row.why.empty() ? "" : "; ") + row.why;
      const BuiltScheme built = build_scheme(*source->scheme, with_settings(context.configuration, claim.part.settings));
      value.derived = part_bytes(built, claim.part, claim.storage);
      if (!value.derived) value.derived = 0;
      row.agreement = value.differs() ? "differs" : "exact";
    } else {
      row.why = "not modelled";
    }
    value.why = row.agreement == "exact" && claim.remark.empty() ? "" : row.why;
    row.values.push_back(value);
    rows.push_back(row);
  }
}

}  // namespace bump
