// The netlist evaluators side by side with hand-written loops: bit-accurate fixed point and double precision of every unit of a scheme, and
// Lee 2007's datapath written by hand in double (lee_floor.h). Full blocks of fragments that change little from one to the next, as over a
// triangle, but for the map's. Prints nanoseconds a fragment and ratios, and JSON with --json. Usage: bench_datapath [--turns N] [--schemes
// a,b] [--json]

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>

#include "schemes/scheme.h"
#include "testbench/bench/help_option.h"
#include "testbench/bench/lee_floor.h"
#include "testbench/bench/stopwatch.h"
#include "units/colour_unit.h"

using namespace bump;

namespace {

using Plane = std::vector<double>;
using Planes = std::map<std::string, Plane>;

/// The same sequence on every machine.
class Random {
 public:
  double uniform(double low, double high) {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * static_cast<double>(state_ >> 11) * 0x1p-53;
  }

 private:
  std::uint64_t state_ = 2007;
};

Configuration defaults_of(const Scheme& scheme) {
  Parameters parameters;
  scheme.declare(parameters);
  return Configuration(parameters);
}

constexpr int blocks = 8, fragments_of_a_turn = blocks * block_lanes;

/// Blocks of a smooth ramp each, somewhere in the port's range; a map's texels are noise on it.
Plane port_values(const std::string& name, const Format& format, Random& random) {
  const double low = std::max(-1.0, format.lowest()), high = std::min(1.0, format.highest());
  const double noise = name.compare(0, 4, "map.") == 0 ? 0.1 : 0;
  Plane plane;
  for (int block = 0; block < blocks; ++block) {
    const double start = random.uniform(low, high), end = random.uniform(0.9, 1) * start + 0.1 * random.uniform(low, high);
    for (int i = 0; i < block_lanes; ++i) {
      const double value = start + (end - start) * i / block_lanes + noise * random.uniform(low, high);
      plane.push_back(std::min(high, std::max(low, value)));
    }
  }
  return plane;
}

/// A netlist with planes for its ports, ready to run in one arithmetic.
struct Unit {
  std::unique_ptr<Evaluator> evaluator;
  std::vector<double*> inputs, outputs;

  Unit(const Netlist& n, Arithmetic arithmetic, Planes& planes, Random& random) : evaluator(make_evaluator(n, arithmetic)) {
    for (const Netlist::Port& port : n.inputs()) {
      Plane& plane = planes[port.name];
      if (plane.empty()) plane = port_values(port.name, n.nodes()[static_cast<std::size_t>(port.node)].format, random);
      inputs.push_back(plane.data());
    }
    for (const Netlist::Port& port : n.outputs()) {
      Plane& plane = planes[port.name];
      plane.resize(fragments_of_a_turn);
      outputs.push_back(plane.data());
    }
    run();
  }

  void run() {
    std::vector<const double*> in(inputs.size());
    std::vector<double*> out(outputs.size());
    for (int first = 0; first < fragments_of_a_turn; first += block_lanes) {
      for (std::size_t i = 0; i < in.size(); ++i) in[i] = inputs[i] + first;
      for (std::size_t i = 0; i < out.size(); ++i) out[i] = outputs[i] + first;
      evaluator->evaluate(in.data(), block_lanes, out.data());
    }
  }
};

struct Entry {
  std::string scheme, unit, arithmetic;
  bench::Timing timing;
};

double nanoseconds(double seconds) {
  return seconds * 1e9 / fragments_of_a_turn;
}

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> parts(1);
  for (const char letter : text) {
    if (letter == ',')
      parts.emplace_back();
    else
      parts.back() += letter;
  }
  return parts;
}

/// Units of a scheme in both arithmetics; planes of earlier units are the inputs of later ones.
void add_units(const std::string& scheme, const Design& design, const Netlist& colour, std::vector<std::unique_ptr<Unit>>& units,
               std::map<std::string, Planes>& planes, std::vector<Entry>& entries) {
  for (const Arithmetic arithmetic : {Arithmetic::fixed, Arithmetic::real}) {
    const char* name = arithmetic == Arithmetic::fixed ? "fixed" : "double";
    Planes& of_scheme = planes[scheme + name];
    Random random;
    const auto add = [&](const char* unit, const Netlist& netlist) {
      units.push_back(std::make_unique<Unit>(netlist, arithmetic, of_scheme, random));
      entries.push_back({scheme, unit, name, {}});
    };
    add("environment", design.environment);
    if (design.light_maps && arithmetic == Arithmetic::fixed) add("light map address", design.light_maps->address);
    add("illumination", design.illumination);
    add("colour", colour);
  }
}

double largest_difference(const Plane& a, const Plane& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::fabs(a[i] - b[i]));
  return largest;
}

}  // namespace

int main(int argc, char* argv[]) {
  if (bench::gave_help(argc, argv, "nanoseconds a fragment of the netlist evaluators, beside a datapath written by hand", "bench_datapath [--turns N] [--schemes a,b] [--json]")) return 0;
  int turns = 15;
  bool json = false;
  std::vector<std::string> schemes = {"lee2007", "peercy1997", "kugler1998"};
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--json") == 0) json = true;
    if (i + 1 == argc) continue;
    if (std::strcmp(argv[i], "--turns") == 0) turns = std::max(7, std::atoi(argv[i + 1]));
    if (std::strcmp(argv[i], "--schemes") == 0) schemes = split(argv[i + 1]);
  }

  Material material;
  Scene scene;
  scene.lights.resize(1);
  scene.objects.resize(1);
  material = scene.objects.front().material;
  Parameters colour_parameters;
  ColourUnitConfig::declare(colour_parameters);
  const ColourUnitConfig colour_config{Configuration(colour_parameters)};

  std::vector<std::unique_ptr<Design>> designs;
  std::vector<std::unique_ptr<Netlist>> colours;
  std::vector<std::unique_ptr<Unit>> units;
  std::map<std::string, Planes> planes;
  std::vector<Entry> entries;
  for (const std::string& id : schemes) {
    const Scheme& scheme = find_scheme(id);
    designs.push_back(std::make_unique<Design>(scheme.design(defaults_of(scheme), material)));
    const LightSum sum = designs.back()->light_maps ? LightSum::in_light_maps : LightSum::in_colour_unit;
    colours.push_back(std::make_unique<Netlist>(colour_netlist(scene, material, colour_config, sum)));
    add_units(id, *designs.back(), *colours.back(), units, planes, entries);
  }
  std::vector<bench::Work> works;
  for (std::size_t i = 0; i < units.size(); ++i) works.push_back({entries[i].unit, [&unit = *units[i]] { unit.run(); }});

  // The floor reads what the double evaluation of Lee 2007 reads.
  const Scheme& lee = find_scheme("lee2007");
  const Design design = lee.design(defaults_of(lee), material);
  Planes of_lee;
  Random random;
  Unit environment(design.environment, Arithmetic::real, of_lee, random);
  Unit illumination(design.illumination, Arithmetic::real, of_lee, random);
  const auto plane = [&](const char* name) { return of_lee.at(name).data(); };
  const bench::LeeFragments fragments{plane("N.phi"), plane("N.theta"), plane("L.phi"),    plane("L.theta"),
                                      plane("H.phi"), plane("H.theta"), plane("map.phi"),  plane("map.theta"),
                                      plane("alpha"), material.diffuse, material.specular, material.shininess};
  Plane by_polynomials(fragments_of_a_turn), by_library(fragments_of_a_turn);
  works.push_back({"polynomials", [&] { bench::shade_by_polynomials(fragments, fragments_of_a_turn, by_polynomials.data()); }});
  works.push_back({"library", [&] { bench::shade_by_library(fragments, fragments_of_a_turn, by_library.data()); }});
  const std::vector<bench::Timing> timings = bench::taking_turns(works, turns);
  for (std::size_t i = 0; i < entries.size(); ++i) entries[i].timing = timings[i];
  const bench::Timing polynomials = timings[entries.size()], library = timings[entries.size() + 1];
  const double polynomial_error = largest_difference(by_polynomials, of_lee.at("intensity"));
  const double library_error = largest_difference(by_library, of_lee.at("intensity"));

  std::map<std::pair<std::string, std::string>, double> sums;
  for (const Entry& entry : entries) sums[{entry.scheme, entry.arithmetic}] += entry.unit == "colour" ? 0 : entry.timing.median;

  if (json) {
    nlohmann::ordered_json document;
    document["floor"] = {{"polynomials_ns", nanoseconds(polynomials.median)},
                         {"polynomials_largest_difference", polynomial_error},
                         {"library_ns", nanoseconds(library.median)},
                         {"library_largest_difference", library_error}};
    for (const Entry& entry : entries)
      document["units"].push_back({{"scheme", entry.scheme},
                                   {"unit", entry.unit},
                                   {"arithmetic", entry.arithmetic},
                                   {"ns", nanoseconds(entry.timing.median)},
                                   {"least_ns", nanoseconds(entry.timing.least)}});
    for (const auto& [key, seconds] : sums)
      document["ratios"].push_back({{"scheme", key.first},
                                    {"arithmetic", key.second},
                                    {"over_polynomials", seconds / polynomials.median},
                                    {"over_library", seconds / library.median}});
    std::printf("%s\n", document.dump(2).c_str());
    return 0;
  }
  std::printf("Lee 2007 by hand, double: polynomials %.1f ns a fragment (within %.1g of the netlist), library %.1f ns (within %.1g)\n",
              nanoseconds(polynomials.median), polynomial_error, nanoseconds(library.median), library_error);
  for (const Entry& entry : entries)
    std::printf("%-12s %-18s %-7s %7.1f ns (least %.1f)\n", entry.scheme.c_str(), entry.unit.c_str(), entry.arithmetic.c_str(),
                nanoseconds(entry.timing.median), nanoseconds(entry.timing.least));
  for (const auto& [key, seconds] : sums)
    std::printf("%-12s %-7s without colour: %.1f ns, %.2f times the polynomials, %.2f times the library\n", key.first.c_str(),
                key.second.c_str(), nanoseconds(seconds), seconds / polynomials.median, seconds / library.median);
  return 0;
}
