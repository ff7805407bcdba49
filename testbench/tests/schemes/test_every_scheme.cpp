// What must hold for every registered scheme, whatever it computes: names connect, structure does not follow the material, datapaths are
// hardware.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <set>
#include <sstream>

#include "datapath/duplicates.h"
#include "datapath/inventory.h"
#include "datapath/schedule.h"
#include "testbench/tests/schemes/scheme_bench.h"

using namespace bump;
using namespace bump::bench;

namespace {

Parameters parameters_of(const Scheme& scheme) {
  Parameters parameters;
  scheme.declare(parameters);
  return parameters;
}

ParameterValue random_value(const Parameter& parameter, Random& random) {
  switch (parameter.fallback.index()) {
    case 0:
      return random.word() % 2 != 0;
    case 1: {
      const auto low = static_cast<std::int64_t>(parameter.low), high = static_cast<std::int64_t>(parameter.high);
      return low + static_cast<std::int64_t>(random.word() % static_cast<std::uint64_t>(high - low + 1));
    }
    case 2:
      return random.uniform(parameter.low, parameter.high);
    default:
      return parameter.choices[random.word() % parameter.choices.size()];
  }
}

/// Calls `check` with the default design of every scheme and with designs of random settings; settings that contradict one another are the
/// scheme's to refuse, as bad input.
template <class Check>
void for_designs(const Check& check, int random_settings = 12) {
  for (const Scheme* scheme : all_schemes()) {
    Random random(17);
    for (int i = 0; i <= random_settings; ++i) {
      Configuration configuration(parameters_of(*scheme));
      std::string text = scheme->page().id;
      if (i > 0)
        for (const auto& [key, parameter] : configuration.parameters().all()) {
          const ParameterValue value = random_value(parameter, random);
          configuration.set(key, value, Location("random"));
          text += " " + key + "=" + to_string(value);
        }
      CAPTURE(text);
      std::unique_ptr<Design> design;
      try {
        design = std::make_unique<Design>(scheme->design(configuration, Material{}));
      } catch (const Error& error) {
        INFO(error.what());
        CHECK(i > 0);
        CHECK(error.kind() == ErrorKind::input);
      }
      if (design) check(*scheme, configuration, *design);
    }
  }
}

std::vector<const Netlist*> pixel_units(const Design& design) {
  std::vector<const Netlist*> units;
  if (design.conversion) units.push_back(&*design.conversion);
  units.push_back(&design.environment);
  if (design.light_maps) units.push_back(&design.light_maps->address);
  units.push_back(&design.illumination);
  return units;
}

std::set<std::string> names_of(const std::vector<Netlist::Port>& ports) {
  std::set<std::string> names;
  for (const Netlist::Port& port : ports) names.insert(port.name);
  return names;
}

/// Everything about a netlist but the values of constants and the contents of tables.
std::string structure_of(const Netlist& netlist) {
  std::ostringstream text;
  for (const Node& node : netlist.nodes()) {
    text << name_of(node.op) << ' ' << node.name << ' ' << to_string(node.format) << ' ' << node.amount << ' ' << node.table << ' '
         << node.low << ' ' << node.high << ' ' << node.addition;
    for (const int operand : node.operands) text << ' ' << operand;
    text << '\n';
  }
  for (const TablePtr& table : netlist.tables())
    text << table->name << ' ' << table->address_bits << ' ' << table->bits() << ' ' << to_string(table->index) << '\n';
  for (const Netlist::Port& port : netlist.outputs()) text << port.name << ' ' << port.node << '\n';
  return text.str();
}

}  // namespace

TEST_CASE("every scheme says what it is") {
  REQUIRE(!all_schemes().empty());
  for (const Scheme* scheme : all_schemes()) {
    const SchemePage& page = scheme->page();
    CAPTURE(page.id);
    CHECK(!page.id.empty());
    CHECK(!page.title.empty());
    CHECK(!page.source.empty());
    CHECK(!page.provenance.empty());
    CHECK(!page.summary.empty());
    CHECK(&find_scheme(page.id) == scheme);
  }
}

TEST_CASE("an unknown scheme is refused with the nearest name") {
  const std::string id = all_schemes().front()->page().id;
  try {
    find_scheme(id + "x");
    FAIL("found a scheme that does not exist");
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::input);
    CHECK(std::string(error.what()).find(id) != std::string::npos);
  }
}

TEST_CASE("every scheme has a page that names each of its parameters") {
  for (const Scheme* scheme : all_schemes()) {
    const std::string id = scheme->page().id;
    std::ifstream file(std::string(BUMP_SOURCE_DIR) + "/sc_models/schemes/" + id + "/README.md");
    CAPTURE(id);
    REQUIRE(file.good());
    std::stringstream page;
    page << file.rdbuf();
    const Parameters parameters = parameters_of(*scheme);
    for (const auto& [key, parameter] : parameters.all()) {
      CAPTURE(key);
      CHECK(key.compare(0, id.size() + 1, id + ".") == 0);
      CHECK(!parameter.meaning.empty());
      CHECK(page.str().find(key.substr(id.size() + 1)) != std::string::npos);
    }
  }
}

TEST_CASE("vertex programs read the vertex and deliver the interpolants, one for one") {
  std::set<std::string> vertex;
  for (const char* name : {"N", "T", "B", "L", "V"})
    for (const char* component : {".x", ".y", ".z"}) vertex.insert(std::string(name) + component);
  for_designs([&](const Scheme&, const Configuration&, const Design& design) {
    for (const Netlist::Port& port : design.vertex.inputs()) CHECK(vertex.count(port.name) == 1);
    std::set<std::string> interpolants;
    for (const Interpolant& interpolant : design.interpolants) CHECK(interpolants.insert(interpolant.name).second);
    CHECK(names_of(design.vertex.outputs()) == interpolants);
  });
}

TEST_CASE("every input of a unit is an interpolant, a map channel or the output of a unit before it, in the same format") {
  for_designs([](const Scheme&, const Configuration&, const Design& design) {
    std::set<std::string> known;
    for (const Interpolant& interpolant : design.interpolants) known.insert(interpolant.name);
    for (const BumpEncoding::Channel& channel : design.map.channels) CHECK(known.insert("map." + channel.name).second);
    std::map<std::string, Format> delivered;
    if (design.light_maps) {
      known.insert("light_map.base");
      for (const LightMaps::Map& map : design.light_maps->maps) {
        CHECK(known.insert("light." + map.name).second);
        delivered["light." + map.name] = map.word;
      }
    }
    for (const Netlist* unit : pixel_units(design)) {
      for (const Netlist::Port& port : unit->inputs()) {
        CAPTURE(unit->name(), port.name);
        CHECK(known.count(port.name) == 1);
        if (design.conversion && unit == &*design.conversion) CHECK(port.name.rfind("map.", 0) != 0);  // it runs before the texture unit
        const auto source = delivered.find(port.name);
        if (source != delivered.end())
          CHECK(to_string(source->second) == to_string(unit->nodes()[static_cast<std::size_t>(port.node)].format));
      }
      for (const Netlist::Port& port : unit->outputs()) {
        known.insert(port.name);
        delivered[port.name] = unit->nodes()[static_cast<std::size_t>(port.node)].format;
      }
    }
    CHECK(names_of(design.illumination.outputs()) == std::set<std::string>{"intensity"});
    for (const DeliveredDirection& direction : design.directions) {
      CHECK((direction.planes.size() == 2 || direction.planes.size() == 3));
      for (const std::string& plane : direction.planes) CHECK(known.count(plane) == 1);
    }
  });
}

TEST_CASE("light maps have a direction for every entry, an address for every object, and words for what fills them") {
  std::set<std::string> frame;
  for (const char* name : {"N", "L", "H"})
    for (const char* component : {".x", ".y", ".z"}) frame.insert(std::string(name) + component);
  for_designs([&](const Scheme&, const Configuration&, const Design& design) {
    if (!design.light_maps) return;
    const LightMaps& maps = *design.light_maps;
    std::set<std::string> names;
    for (const LightMaps::Map& map : maps.maps) CHECK(names.insert(map.name).second);
    CHECK(names_of(maps.fill.outputs()) == names);
    for (const Netlist::Port& port : maps.fill.inputs()) CHECK(frame.count(port.name) == 1);
    const std::set<std::string> outputs = names_of(maps.address.outputs());
    CHECK(outputs.count("light_map.entry") == 1);
    for (const std::string& coordinate : maps.coordinates) CHECK(outputs.count(coordinate) == 1);
    std::vector<double> coordinates(maps.coordinates.size());
    Random random(37);
    for (int i = 0; i < 500; ++i) {
      const auto entry = static_cast<std::int64_t>(random.word() % (std::uint64_t{1} << maps.address_bits));
      maps.centre(entry, coordinates.data());
      CHECK(glm::length(maps.direction(coordinates.data())) == Approx(1));
    }
  });
}

TEST_CASE("what becomes hardware has no floating-point edge and can be scheduled") {
  for_designs([](const Scheme&, const Configuration&, const Design& design) {
    for (const Netlist* unit : pixel_units(design)) {
      CAPTURE(unit->name());
      for (const Node& node : unit->nodes()) CHECK(!node.format.is_real);
      const Schedule pipelined = schedule(*unit, OperatorLatencies{});
      CHECK(pipelined.latency > 0);
      CHECK(pipelined.initiation_interval == 1);
      const int multipliers = count(*unit).multipliers;
      if (multipliers > 1) CHECK(schedule(*unit, OperatorLatencies{}, 1).initiation_interval == multipliers);
    }
    for (const Node& node : design.vertex.nodes()) CHECK((node.format.is_real || node.format == flag()));
  });
}

TEST_CASE("no operator is recorded twice") {
  for_designs([](const Scheme&, const Configuration&, const Design& design) {
    for (const Netlist* unit : pixel_units(design)) {
      const auto twice = equal_nodes(*unit);
      if (!twice.empty()) INFO(unit->name() + ": " + unit->nodes()[static_cast<std::size_t>(twice.front().second)].name);
      CHECK(twice.empty());
    }
    CHECK(equal_nodes(design.vertex).empty());
  });
}

TEST_CASE("no operator goes unread") {
  for_designs([](const Scheme&, const Configuration&, const Design& design) {
    for (const Netlist* unit : pixel_units(design)) {
      std::vector<bool> read(unit->nodes().size(), false);
      for (const Netlist::Port& port : unit->outputs()) read[static_cast<std::size_t>(port.node)] = true;
      for (std::size_t i = read.size(); i-- > 0;)
        if (read[i])
          for (const int operand : unit->nodes()[i].operands) read[static_cast<std::size_t>(operand)] = true;
      for (std::size_t i = 0; i < read.size(); ++i) {
        const Op op = unit->nodes()[i].op;
        const bool is_built = op == Op::add || op == Op::sub || op == Op::add_sub || op == Op::mul || op == Op::div || op == Op::sqrt ||
                              op == Op::table || op == Op::clamp || op == Op::shift_by;
        CAPTURE(unit->name(), unit->nodes()[i].name);
        if (is_built) CHECK(read[i]);
      }
    }
  });
}

TEST_CASE("published operators and additions make up the whole") {
  for_designs([](const Scheme&, const Configuration&, const Design& design) {
    for (const Netlist* unit : pixel_units(design)) {
      Inventory sum = count(*unit, Portion::published);
      sum += count(*unit, Portion::addition);
      const Inventory all = count(*unit, Portion::all);
      CHECK(sum.multipliers == all.multipliers);
      CHECK(sum.adders == all.adders);
      CHECK(sum.tables + sum.maps == all.tables + all.maps);
      CHECK(sum.table_bits == all.table_bits);
    }
  });
}

TEST_CASE("the structure of a scheme does not follow the material") {
  const Material other{0.3, 0.2, 0.9, 77};
  for_designs([&](const Scheme& scheme, const Configuration& configuration, const Design& design) {
    const Design changed = scheme.design(configuration, other);
    for (std::size_t i = 0; i < pixel_units(design).size(); ++i)
      CHECK(structure_of(*pixel_units(design)[i]) == structure_of(*pixel_units(changed)[i]));
    CHECK(structure_of(design.vertex) == structure_of(changed.vertex));
    if (design.light_maps) CHECK(structure_of(design.light_maps->fill) == structure_of(changed.light_maps->fill));
    CHECK(design.map.channels.size() == changed.map.channels.size());
  });
}

TEST_CASE("map encodings are finite, also for flat, upright and overhanging texels") {
  for_designs([](const Scheme&, const Configuration&, const Design& design) {
    Random random(23);
    std::vector<glm::dvec3> normals{{0, 0, 1}, {1, 0, 0}, {0, -1, 0}, {-1, 0, 0}, {1e-300, 0, 1}};
    for (int i = 0; i < 200; ++i) normals.push_back(random.direction());
    std::vector<double> channels(design.map.channels.size());
    for (const glm::dvec3& normal : normals) {
      design.map.encode(normal, channels.data());
      for (const double channel : channels) CHECK(std::isfinite(channel));
    }
  });
}

TEST_CASE("no input gives a result that is not a number") {
  for_designs(
      [](const Scheme&, const Configuration&, const Design& design) {
        const std::vector<glm::dvec3> axes{{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 0}};
        const auto reader = make_evaluator(design.environment, Arithmetic::fixed);  // ROM contents live as long as one
        std::vector<Point> points;
        for (const glm::dvec3& normal : axes)
          for (const glm::dvec3& light : axes)
            for (const glm::dvec3& view : axes) {
              const glm::dvec3 tangent = normal.x == 0 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
              points.push_back({normal, tangent, glm::cross(normal, tangent), light, view, {0, 0, 1}});
            }
        while (points.size() > block_lanes) {
          const std::vector<Point> some(points.end() - block_lanes, points.end());
          points.resize(points.size() - 87);  // 343 points in blocks that overlap
          for (const Arithmetic arithmetic : {Arithmetic::real, Arithmetic::fixed})
            for (const auto& [name, plane] : shade(design, arithmetic, some)) {
              CAPTURE(name);
              CHECK(std::all_of(plane.begin(), plane.end(), [](double value) { return std::isfinite(value); }));
            }
        }
      },
      4);
}

TEST_CASE("fixed point keeps every scheme above the floor that it promises") {
  for (const Material& material : {Material{}, Material{0.1, 0.3, 1, 100}})
    for (const Scheme* scheme : all_schemes()) {
      CAPTURE(scheme->page().id);
      const Design design = scheme->design(Configuration(parameters_of(*scheme)), material);
      const Accuracy found = accuracy(design, material, 10, [](Random& r) { return r.point(); });
      CHECK(found.fixed_to_real_db > design.quantisation_floor_db);
      // One flat facet under distant light and eye, at random: the frame of a simple scene.
      Random facets(29);
      for (int i = 0; i < 20; ++i) {
        const Point facet = facets.point();
        const auto on_facet = [&](Random& r) {
          Point p = facet;
          p.bump = r.point().bump;
          return p;
        };
        CHECK(accuracy(design, material, 1, on_facet).fixed_to_real_db > design.quantisation_floor_db);
      }
    }
}

TEST_CASE("the same settings give the same words") {
  for_designs(
      [](const Scheme& scheme, const Configuration& configuration, const Design& design) {
        const Design again = scheme.design(configuration, Material{});
        Random random(31);
        std::vector<Point> points;
        for (int i = 0; i < block_lanes; ++i) points.push_back(random.point());
        CHECK(shade(design, Arithmetic::fixed, points).at("intensity") == shade(again, Arithmetic::fixed, points).at("intensity"));
      },
      3);
}
