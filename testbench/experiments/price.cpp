#include "testbench/experiments/price.h"

#include <algorithm>
#include <map>

#include "datapath/vertex_program.h"
#include "testbench/experiments/table1_netlists.h"
#include "units/light_map_fill.h"

namespace bump {

namespace {

using Role = UnitPrice::Role;

/// Far from every default, so that what follows the material differs.
Material other_material() {
  Material material;
  material.ambient = 0.29;
  material.diffuse = 0.37;
  material.specular = 0.41;
  material.shininess = 7;
  return material;
}

int distinct_materials(const Scene& scene) {
  std::vector<Material> seen;
  for (const SceneObject& object : scene.objects)
    if (std::find(seen.begin(), seen.end(), object.material) == seen.end()) seen.push_back(object.material);
  return std::max<int>(1, static_cast<int>(seen.size()));
}

bool begins_with(const std::string& text, const std::string& prefix) {
  return text.compare(0, prefix.size(), prefix) == 0;
}

/// A datapath of the pixel pipeline.
struct PixelUnit {
  std::string name;
  const Netlist* netlist;
  const Schedule* schedule;
  std::vector<bool> settable;
};

/// What the unit at `index` holds for those behind it: words that they read and that it does not produce. The colour unit pays for what
/// waits for it; texels of the bump map do not exist before the texture unit, nor words of light maps before they are fetched.
std::vector<CarriedWord> carried_by(const std::vector<PixelUnit>& units, std::size_t index) {
  std::vector<CarriedWord> words;
  std::vector<std::string> produced;
  for (std::size_t later = index + 1; later < units.size(); ++later) {
    if (units[later].name == "colour") continue;
    for (const Netlist::Port& port : units[later - 1].netlist->outputs()) produced.push_back(port.name);
    for (const Netlist::Port& port : units[later].netlist->inputs()) {
      if (std::find(produced.begin(), produced.end(), port.name) != produced.end()) continue;
      if (begins_with(port.name, "light.") || begins_with(port.name, "light_map.")) continue;
      if (units[index].name == "conversion" && begins_with(port.name, "map.")) continue;
      const int width = units[later].netlist->nodes()[static_cast<std::size_t>(port.node)].format.width;
      const auto known = std::find_if(words.begin(), words.end(), [&](const CarriedWord& word) { return word.name == port.name; });
      if (known == words.end())
        words.push_back({port.name, width});
      else
        known->width = std::max(known->width, width);
    }
  }
  return words;
}

class Pricing {
 public:
  Pricing(const Scheme& scheme, const Configuration& configuration, const PriceBook& book, const PriceOptions& options)
      : scheme_(scheme),
        configuration_(configuration),
        book_(book),
        options_(options),
        built_(options.scene != nullptr ? build_scheme(scheme, configuration, *options.scene) : build_scheme(scheme, configuration)) {}

  SchemePrice price() {
    price_.page = &scheme_.page();
    const std::vector<PixelUnit> units = pixel_units();
    for (std::size_t i = 0; i < units.size(); ++i) add_pixel_unit(units, i);
    add_interpolators();
    add_vertex_work();
    if (built_.design.light_maps) add_frame_work();
    if (options_.work != nullptr) {
      price_.work = *options_.work;
      if (book_.energy != nullptr && options_.work->fragments > 0) add_traffic();
    }
    return std::move(price_);
  }

 private:
  std::vector<PixelUnit> pixel_units() const {
    const Design& design = built_.design;
    const Design other = scheme_.design(configuration_, other_material());
    std::vector<PixelUnit> units;
    const auto add = [&](const std::string& name, const Netlist& netlist, const Schedule& schedule, const Netlist& with_other_material) {
      units.push_back({name, &netlist, &schedule, differing_constants(netlist, with_other_material)});
    };
    if (design.conversion) add("conversion", *design.conversion, built_.schedules.conversion, *other.conversion);
    add("environment", design.environment, built_.schedules.environment, other.environment);
    if (design.light_maps)
      add("light_map_address", design.light_maps->address, built_.schedules.light_map_address, other.light_maps->address);
    add("illumination", design.illumination, built_.schedules.illumination, other.illumination);
    // Every constant of the colour unit, ambient light and gains, is set by material or light.
    units.push_back({"colour", &built_.colour, &built_.schedules.colour, std::vector<bool>(built_.colour.nodes().size(), true)});
    return units;
  }

  void add_pixel_unit(const std::vector<PixelUnit>& units, std::size_t index) {
    const PixelUnit& unit = units[index];
    const bool is_colour = unit.name == "colour";
    ItemOptions items;
    items.settable = unit.settable;
    items.materials = options_.scene != nullptr ? distinct_materials(*options_.scene) : 1;
    std::vector<PriceItem> built = built_items(*unit.netlist, unit.schedule, items),
                           executed = executed_items(*unit.netlist, only_reads(items));
    const std::vector<CarriedWord> carried = is_colour ? std::vector<CarriedWord>{} : carried_by(units, index);
    RegisterBits registers = pipeline_registers(*unit.netlist, *unit.schedule, carried),
                 clocked = clocked_registers(*unit.netlist, *unit.schedule, carried);
    if (is_colour) add_waiting_texels(units, registers, clocked);
    add_registers(registers, built);
    add_registers(clocked, executed);

    UnitPrice price = named(unit.name, is_colour ? Role::colour : Role::bump_mapping);
    price.registers = registers;
    price.latency = unit.schedule->unit_latency();
    price.initiation_interval = unit.schedule->initiation_interval;
    price.executions = executions_of(unit.name, 1);
    const std::string who = scheme_.page().id + ", " + unit.name + " unit";
    if (book_.area != nullptr) price.area = price_items(merged(built), *book_.area, Quantity::area, who);
    if (book_.energy != nullptr) price.energy = price_items(merged(executed), *book_.energy, Quantity::energy, who);
    price_.units.push_back(std::move(price));
  }

  /// A read touches one copy, however many materials there are.
  static ItemOptions only_reads(ItemOptions items) {
    items.materials = 1;
    return items;
  }
  static void add_registers(const RegisterBits& bits, std::vector<PriceItem>& items) {
    if (bits.total() > 0) items.push_back({Component::register_bits, {}, static_cast<double>(bits.total()), false, "pipeline registers"});
  }
  /// The texel's colour passes the units in front of the colour unit.
  void add_waiting_texels(const std::vector<PixelUnit>& units, RegisterBits& registers, RegisterBits& clocked) const {
    for (const Netlist::Port& port : built_.colour.inputs()) {
      if (!begins_with(port.name, "tex.")) continue;
      const int width = built_.colour.nodes()[static_cast<std::size_t>(port.node)].format.width;
      for (const PixelUnit& unit : units) {
        if (unit.name == "conversion" || unit.name == "colour") continue;  // in front of the texture unit; the unit's own
        const int interval = unit.schedule->initiation_interval;
        registers.carried += std::int64_t{width} * ((unit.schedule->unit_latency() + interval - 1) / interval);
        clocked.carried += std::int64_t{width} * unit.schedule->unit_latency();
      }
    }
  }

  static UnitPrice named(const std::string& name, Role role) {
    UnitPrice price;
    price.name = name;
    price.role = role;
    return price;
  }
  std::optional<double> executions_of(const std::string& unit, std::optional<double> without_scene) const {
    if (options_.work == nullptr) return without_scene;
    const auto found = options_.work->executions.find(unit);
    if (found == options_.work->executions.end() || options_.work->fragments == 0) return std::nullopt;
    return static_cast<double>(found->second) / static_cast<double>(options_.work->fragments);
  }

  /// What stands apart may have no price without making the totals wrong.
  void price_apart(UnitPrice& price, const std::vector<PriceItem>& items, Quantity quantity) const {
    const PriceTable* table = book_.of(quantity);
    if (table == nullptr) return;
    try {
      CostSheet sheet = price_items(merged(items), *table, quantity, scheme_.page().id + ", " + price.name);
      (quantity == Quantity::area ? price.area : price.energy) = std::move(sheet);
    } catch (const Error& missing) {
      price.unpriced[static_cast<std::size_t>(quantity)] = missing.text().what;
    }
  }
  ItemOptions real_items() const {
    ItemOptions items;
    items.real_bits = options_.real_bits;
    return items;
  }

  void add_interpolators() {
    UnitPrice price = named("interpolators", Role::apart);
    price.executions = 1;
    const std::vector<PriceItem> items = executed_items(built_.interpolators, real_items());
    price_apart(price, items, Quantity::area);
    price_apart(price, items, Quantity::energy);
    price_.units.push_back(std::move(price));
  }

  void add_vertex_work() {
    const Netlist& program = built_.design.vertex;
    std::vector<PriceItem> items = executed_items(program, real_items());
    const std::vector<bool> per_light = depends_on(program, {"L."});
    const int lights = options_.scene != nullptr ? static_cast<int>(options_.scene->lights.size()) : 1;
    if (lights > 1) {
      std::vector<PriceItem> repeated;
      for (const PriceItem& item : items)
        if (per_light[static_cast<std::size_t>(program.find(item.node))]) repeated.push_back(item);
      for (PriceItem& item : repeated) item.count *= lights - 1;
      items.insert(items.end(), repeated.begin(), repeated.end());
    }
    add_program("vertex", items, "runs on the vertex processor's arithmetic units");
    add_program("vertex_transform", executed_items(built_.transform, real_items()), "runs on the vertex processor's arithmetic units");
  }

  /// For every entry of the maps: each light's part, and the sum.
  void add_frame_work() {
    const LightMaps& maps = *built_.design.light_maps;
    const std::vector<Light> lights = options_.scene != nullptr ? options_.scene->lights : std::vector<Light>(1);
    std::vector<PriceItem> items;
    for (std::size_t l = 0; l < lights.size(); ++l) {
      for (const Netlist& netlist : {maps.fill, light_sum_netlist(maps, scales_lights(lights), l > 0)}) {
        const std::vector<PriceItem> part = executed_items(netlist, real_items());
        items.insert(items.end(), part.begin(), part.end());
      }
    }
    add_program("frame", items, "the host fills the light maps");
  }

  void add_program(const std::string& name, const std::vector<PriceItem>& items, const std::string& why_no_area) {
    UnitPrice price = named(name, Role::apart);
    price.executions = executions_of(name, std::nullopt);
    if (book_.area != nullptr) price.unpriced[static_cast<std::size_t>(Quantity::area)] = why_no_area;
    price_apart(price, items, Quantity::energy);
    price_.units.push_back(std::move(price));
  }

  double cache_bytes(const std::string& unit) const {
    const auto of = [&](const char* key) { return static_cast<double>(configuration_.integer(unit + ".cache." + key)); };
    return of("sets") * of("ways") * of("line_bytes");
  }
  void add_traffic() {
    const ExecutedWork& work = *options_.work;
    const auto of_fragment = [&](std::int64_t count) { return static_cast<double>(count) / static_cast<double>(work.fragments); };
    std::vector<PriceItem> items;
    const auto add = [&](Component component, PriceSizes size, std::int64_t count, const std::string& what) {
      if (count > 0) items.push_back({component, size, of_fragment(count), false, what});
    };
    add(Component::cache_read, {cache_bytes("texture_fetch")}, work.texture_look_ups, "texture cache");
    add(Component::memory_byte, {}, work.texture_bytes, "textures");
    if (built_.design.light_maps) add(Component::cache_read, {cache_bytes("light_map_fetch")}, work.light_map_look_ups, "light-map cache");
    add(Component::memory_byte, {}, work.light_map_bytes + work.light_map_bytes_written, "light maps, read and written");
    price_.traffic = price_items(items, *book_.energy, Quantity::energy, scheme_.page().id + ", memory traffic");
  }

  const Scheme& scheme_;
  const Configuration& configuration_;
  const PriceBook& book_;
  const PriceOptions& options_;
  BuiltScheme built_;
  SchemePrice price_;
};

/// Of the units of a total.
template <class Amount>
std::optional<double> sum_of_units(const SchemePrice& price, Quantity quantity, bool with_colour, const Amount& amount) {
  double sum = 0;
  for (const UnitPrice& unit : price.units) {
    if (unit.role == Role::apart || (unit.role == Role::colour && !with_colour)) continue;
    const std::optional<CostSheet>& sheet = quantity == Quantity::area ? unit.area : unit.energy;
    if (!sheet || (quantity == Quantity::energy && !unit.executions)) return std::nullopt;
    sum += amount(*sheet) * (quantity == Quantity::energy ? *unit.executions : 1);
  }
  return sum;
}

}  // namespace

std::optional<double> UnitPrice::energy_of_fragment() const {
  if (!energy || !executions) return std::nullopt;
  return energy->total() * *executions;
}

std::optional<double> SchemePrice::total(Quantity quantity, bool with_colour) const {
  return sum_of_units(*this, quantity, with_colour, [](const CostSheet& sheet) { return sheet.total(); });
}

std::optional<double> SchemePrice::of(Quantity quantity, CostGroup group) const {
  return sum_of_units(*this, quantity, false, [group](const CostSheet& sheet) { return sheet.of(group); });
}

std::optional<double> SchemePrice::additions(Quantity quantity) const {
  return sum_of_units(*this, quantity, false, [](const CostSheet& sheet) { return sheet.additions(); });
}

std::optional<double> SchemePrice::table_bits() const {
  return sum_of_units(*this, Quantity::area, false, [](const CostSheet& sheet) { return sheet.table_bits(); });
}

std::optional<double> SchemePrice::port_prices() const {
  return sum_of_units(*this, Quantity::area, false, [](const CostSheet& sheet) { return sheet.port_prices(); });
}

std::vector<LeftOut> SchemePrice::left_out(Quantity quantity, bool with_colour) const {
  std::map<Component, double> amounts;
  for (const UnitPrice& unit : units) {
    if (unit.role == Role::apart || (unit.role == Role::colour && !with_colour)) continue;
    const std::optional<CostSheet>& sheet = quantity == Quantity::area ? unit.area : unit.energy;
    if (!sheet) continue;
    const double times = quantity == Quantity::energy ? unit.executions.value_or(0) : 1;
    for (const PricedItem& priced : sheet->items)
      if (priced.entry->is_excluded())
        amounts[priced.item.component] += priced.item.count * times * (has_width(priced.item.component) ? priced.item.size[0] : 1);
  }
  std::vector<LeftOut> list;
  for (const auto& [component, amount] : amounts)
    if (amount > 0) list.push_back({component, amount});
  return list;
}

std::optional<double> SchemePrice::table_reads() const {
  return sum_of_units(*this, Quantity::energy, false, [](const CostSheet& sheet) { return sheet.table_reads(); });
}

SchemePrice price_scheme(const Scheme& scheme, const Configuration& configuration, const PriceBook& book, const PriceOptions& options) {
  return Pricing(scheme, configuration, book, options).price();
}

}  // namespace bump
