// What Table 1 leaves out: interpolators, wiring, additions, vertex and frame work, what a fragment costs in all, time, and how far the
// delivered light vector is from the true one.

#include <cmath>

#include "datapath/vertex_program.h"
#include "system/accounting.h"
#include "testbench/experiments/table1_accuracy.h"
#include "testbench/experiments/table1_sections.h"

namespace bump {

namespace {

Table1Value derived(const std::string& quantity, const std::string& unit, double number) {
  Table1Value value;
  value.quantity = quantity;
  value.unit = unit;
  value.derived = number;
  return value;
}

double operations(const Inventory& i) {
  return i.multipliers + i.adders + i.dividers + i.square_roots + i.tables + i.maps + i.shifters;
}

/// The rows of one architecture.
class Beyond {
 public:
  Beyond(const Table1Source& source, std::vector<Table1Row>& rows) : source_(source), built_(*source.built), rows_(rows) {}

  void add() {
    pixel_units();
    vertex();
    frame();
    accuracy();
  }

 private:
  Table1Row& row(const std::string& step, const std::string& why) {
    Table1Row added;
    added.section = Table1Section::beyond;
    added.scheme = source_.about.id;
    added.step = step;
    added.reconstruction = source_.reconstructs(step);
    added.agreement = "not listed";
    added.why = why;
    rows_.push_back(added);
    return rows_.back();
  }

  /// Additions included. `schedule` null: not a pipeline, or its latency is configured.
  void pixel_unit(const std::string& name, const Netlist& netlist, const Schedule* schedule, const std::string& why) {
    const Inventory all = count(netlist);
    fragment_ += all;
    Table1Row& unit = row(name, why);
    unit.values = operator_values(&all);
    for (const auto& [quantity, number] : {std::pair<const char*, int>{"shifters", all.shifters},
                                           {"clamps", all.clamps},
                                           {"selects", all.selects},
                                           {"sign_logic", all.sign_logic},
                                           {"shifts", all.shifts},
                                           {"index_encoders", all.index_encoders},
                                           {"second_ports", all.second_ports}})
      unit.values.push_back(derived(quantity, "operators", number));
    unit.values.push_back(derived("table_bits", "bits", static_cast<double>(all.table_bits)));
    unit.values.push_back(derived("distinct_table_bits", "bits", static_cast<double>(all.distinct_table_bits)));
    if (schedule == nullptr) return;
    unit.values.push_back(derived("latency", "cycles", schedule->latency));
    unit.values.push_back(derived("initiation_interval", "cycles", schedule->initiation_interval));
  }

  void pixel_units() {
    const Design& design = built_.design;
    pixel_unit("interpolators", built_.interpolators, nullptr, "perspective weights, u, v and every component; floating point");
    rows_.back().values.push_back(derived("interpolated_components", "components", built_.interpolator_components));
    if (design.conversion)
      pixel_unit("conversion", *design.conversion, &built_.schedules.conversion, "forms per pixel what the paper takes as given");
    pixel_unit("environment", design.environment, &built_.schedules.environment, "with additions");
    if (design.light_maps)
      pixel_unit("light_map_address", design.light_maps->address, &built_.schedules.light_map_address, "address of the dependent fetch");
    pixel_unit("illumination", design.illumination, &built_.schedules.illumination, "with additions");
    pixel_unit("colour", built_.colour, &built_.schedules.colour, "ambient light and the texel's colour, the same for every scheme");
    if (design.light_maps) fragment_.maps += static_cast<int>(design.light_maps->maps.size());
    fragment_.tables += fragment_.second_ports;  // a table is read through each of its ports
    Table1Row& fragment = row(
        "fragment", "executed for each fragment and one light: all of the units above, every operator once and tables through each port");
    fragment.values = operator_values(&fragment_);
    fragment.values.push_back(derived("shifters", "operators", fragment_.shifters));
    fragment.values.push_back(derived("operations", "operations", operations(fragment_)));
  }

  void vertex() {
    const Netlist& program = built_.design.vertex;
    const Inventory all = count(program), per_light = count_nodes(program, depends_on(program, {"L."})),
                    transform = count(built_.transform);
    const auto add = [&](const std::string& step, const Inventory& counts, const std::string& why) {
      Table1Row& added = row(step, why);
      added.values = operator_values(&counts);
      added.values.push_back(derived("operations", "operations", operations(counts)));
    };
    add("vertex", all, "the scheme's program, for each vertex and one light; floating point");
    add("vertex_per_light", per_light, "its part that every further light repeats");
    add("vertex_transform", transform, "position to clip coordinates, and the vector to the eye if the program reads it");
  }

  void frame() {
    if (!built_.design.light_maps) return;
    const LightMaps& maps = *built_.design.light_maps;
    const Inventory each = frame_cost(maps, {Light{}}, 0).published;  // one light of intensity 1
    const double entries = std::ldexp(1.0, maps.address_bits);
    Table1Row& added = row("frame", "filling the light maps, for each object and light");
    for (const Table1Value& value : operator_values(&each))
      added.values.push_back(derived(value.quantity, "operations", *value.derived * entries));
    added.values.push_back(derived("entries", "entries", entries));
    added.values.push_back(derived("operations", "operations", operations(each) * entries));
  }

  void accuracy() {
    const auto error = light_direction_error(built_.design);
    if (!error) return;
    Table1Row& added = row("accuracy", "angle between delivered and true L', random N and lit L, double precision");
    const auto tenths = [](double value) { return std::round(10 * value) / 10; };
    added.values = {derived("mean_error", "degrees", tenths(error->mean_degrees)),
                    derived("rms_error", "degrees", tenths(error->rms_degrees)),
                    derived("largest_error", "degrees", tenths(error->max_degrees))};
  }

  const Table1Source& source_;
  const BuiltScheme& built_;
  std::vector<Table1Row>& rows_;
  Inventory fragment_;
};

}  // namespace

void add_beyond(const Table1Context& context, std::vector<Table1Row>& rows) {
  for (const Table1Source& source : context.sources)
    if (source.built) Beyond(source, rows).add();
}

}  // namespace bump
