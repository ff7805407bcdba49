// Schemes with their prices, break-evens, and the report in its formats.

#include <fmt/core.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "price_bench.h"
#include "system/simulation.h"
#include "testbench/experiments/fit_cost.h"
#include "testbench/experiments/price_report.h"
#include "testbench/experiments/table1_netlists.h"

namespace bump {
namespace {

using Json = nlohmann::json;

Configuration configured(const std::vector<std::pair<std::string, std::string>>& settings = {}) {
  Configuration configuration(all_parameters());
  for (const auto& [key, value] : settings) configuration.set_text(key, value, Location("test"));
  return configuration;
}

const std::vector<PriceTable>& shipped_tables() {
  static const std::vector<PriceTable> tables = [] {
    std::vector<PriceTable> read;
    for (const char* name : {"osu018_model", "horowitz45"})
      read.push_back(read_price_table(std::string(BUMP_SOURCE_DIR) + "/testbench/prices/" + name + ".toml"));
    return read;
  }();
  return tables;
}

PriceBook shipped() {
  return make_price_book(shipped_tables());
}

double count_of(const CostSheet& sheet, CostGroup group) {
  double count = 0;
  for (const PricedItem& item : sheet.items)
    if (group_of(item.item.component) == group) count += item.item.count;
  return count;
}

const UnitPrice& unit(const SchemePrice& price, const std::string& name) {
  for (const UnitPrice& candidate : price.units)
    if (candidate.name == name) return candidate;
  throw std::runtime_error("no unit " + name);
}

PriceReport report_of(const std::vector<const Scheme*>& schemes, const PriceBook& book, const Configuration& configuration = configured()) {
  PriceReportOptions options;
  options.schemes = schemes;
  return make_price_report(configuration, book, options);
}

std::size_t occurrences(const std::string& text, const std::string& word) {
  std::size_t count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
  return count;
}

/// The round table without the entry of one component.
PriceTable without(const std::string& path) {
  std::string text = round_areas();
  const std::size_t begin = text.find("[" + path + "]"), end = text.find("[area", begin + 1);
  return PriceTable(text.erase(begin, end == std::string::npos ? std::string::npos : end - begin), "round.toml", "round");
}

}  // namespace

TEST_CASE("every scheme has its price in the shipped tables, operator for operator") {
  const Configuration configuration = configured();
  for (const Scheme* scheme : all_schemes()) {
    INFO(scheme->page().id);
    const SchemePrice price = price_scheme(*scheme, configuration, shipped());
    const BuiltScheme built = build_scheme(*scheme, configuration);
    const auto agrees = [&](const std::string& name, const Netlist& netlist) {
      INFO(name);
      const UnitPrice& priced = unit(price, name);
      const Inventory counted = count(netlist);
      REQUIRE(priced.area.has_value());
      REQUIRE(priced.energy.has_value());
      for (const CostSheet* sheet : {&*priced.area, &*priced.energy}) {
        CHECK(count_of(*sheet, CostGroup::multipliers) == counted.multipliers);
        CHECK(count_of(*sheet, CostGroup::adders) == counted.adders);
        CHECK(count_of(*sheet, CostGroup::dividers) == counted.dividers + counted.square_roots);
        CHECK(count_of(*sheet, CostGroup::tables) >= counted.tables + counted.maps + counted.second_ports);
        CHECK(count_of(*sheet, CostGroup::registers) > 0);
        CHECK(sheet->table_bits() == static_cast<double>(counted.table_bits));
      }
      for (const PricedItem& item : priced.area->items) {
        INFO(name_of(item.item.component));
        CHECK(item.each > 0);
      }
    };
    agrees("environment", built.design.environment);
    agrees("illumination", built.design.illumination);
    agrees("colour", built.colour);
    double area = 0, energy = 0;
    for (const UnitPrice& one : price.units) {
      if (one.role != UnitPrice::Role::bump_mapping) continue;
      area += one.area->total();
      energy += one.energy->total();
    }
    CHECK(price.total(Quantity::area, false).value() == Approx(area));
    CHECK(price.total(Quantity::energy, false).value() == Approx(energy));
    CHECK(price.total(Quantity::area, true).value() == Approx(area + unit(price, "colour").area->total()));
    CHECK(price.additions(Quantity::area).value() < area);
    double groups = 0;
    for (int g = 0; g < static_cast<int>(CostGroup::count); ++g) groups += price.of(Quantity::area, static_cast<CostGroup>(g)).value();
    CHECK(groups == Approx(area));
  }
}

TEST_CASE("bits are stored once, however many ports read them, in price and in fit") {
  int two_ported = 0;
  for (const Scheme* scheme : all_schemes()) {
    const std::string key = scheme->page().id + ".ports";
    if (all_parameters().find(key) == nullptr) continue;
    INFO(key);
    ++two_ported;
    const Configuration one_port = configured(), two_ports = configured({{key, "2"}});
    const SchemePrice one = price_scheme(*scheme, one_port, shipped()), two = price_scheme(*scheme, two_ports, shipped());
    CHECK(two.table_bits().value() < one.table_bits().value());
    CHECK(two.table_reads().value() == one.table_reads().value());
    CHECK(two.port_prices().value() > 0);
    // Made of gates, what is not stored twice is built twice all the same.
    CHECK(two.of(Quantity::area, CostGroup::tables).value() == Approx(one.of(Quantity::area, CostGroup::tables).value()));
    for (const Configuration* configuration : {&one_port, &two_ports}) {
      const DesignSize size = design_size(*scheme, *configuration, shipped());
      const SchemePrice& price = configuration == &one_port ? one : two;
      CHECK(static_cast<double>(size.table_bits) == price.table_bits().value());
      CHECK(size.area.value() == price.total(Quantity::area, false).value());
    }
  }
  CHECK(two_ported > 5);
}

TEST_CASE("a table without a price for second ports has none for a scheme that needs them") {
  const std::vector<PriceTable> tables = {without("area.second_port")};
  const PriceBook book = make_price_book(tables);
  CHECK(price_scheme(find_scheme("yp6"), configured(), book).total(Quantity::area, false).has_value());
  CHECK_THROWS_WITH(price_scheme(find_scheme("yp6"), configured({{"yp6.ports", "2"}}), book), Catch::Contains("has no area.second_port"));
}

TEST_CASE("an excluded component turns the ranking at the price that the break-even names, and at no other") {
  const std::string file = std::string(BUMP_SOURCE_DIR) + "/testbench/prices/horowitz45.toml";
  std::ifstream stream(file);
  const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  /// The shipped energies with a price for a component that they exclude.
  const auto with_price = [&](Component component, double price) {
    const std::string head = std::string("[energy.") + name_of(component) + "]\n";
    const std::size_t begin = text.find(head), end = std::min(text.find("\n[", begin), text.size());
    REQUIRE(begin != std::string::npos);
    std::string changed = text;
    const std::string form = has_width(component) ? "form = \"linear\"\nper_width = " : "form = \"constant\"\nvalue = ";
    return PriceTable(
        changed.replace(begin, end - begin, head + form + fmt::format("{:.17g}", price) + "\nsource = \"a test\"\naccuracy = \"a test\"\n"),
        file, "changed");
  };
  const Configuration configuration = configured();
  int turns = 0;
  for (const char* a : {"lee2007", "n3", "exact_polar", "ya4"}) {
    for (const char* b : {"kim2001", "lns", "yp2", "lee2007_corrected"}) {
      const SchemePrice first = price_scheme(find_scheme(a), configuration, shipped()),
                        second = price_scheme(find_scheme(b), configuration, shipped());
      for (const ExcludedEffect& effect : excluded_effects(first, second)) {
        INFO(a << " " << b << " " << name_of(effect.component));
        REQUIRE(effect.quantity == Quantity::energy);  // the areas exclude nothing
        const auto lead = [&](double price) {
          const std::vector<PriceTable> tables = {with_price(effect.component, price)};
          const PriceBook book = make_price_book(tables);
          return price_scheme(find_scheme(b), configuration, book).total(Quantity::energy, false).value() -
                 price_scheme(find_scheme(a), configuration, book).total(Quantity::energy, false).value();
        };
        const double now = lead(1e-12);
        CHECK((now > 0 ? 0 : 1) == effect.ahead);
        if (effect.at) {
          ++turns;
          CHECK(lead(*effect.at) == Approx(0).margin(1e-6));
          CHECK(lead(2 * *effect.at) * now < 0);
        } else {
          CHECK(lead(1000) * now > 0);
        }
      }
    }
  }
  CHECK(turns > 0);
}

TEST_CASE("a unit of few bits costs less, and so does one that shares its multipliers") {
  const Scheme& scheme = find_scheme("peercy1997");
  const auto area = [&](const std::vector<std::pair<std::string, std::string>>& settings, const char* of) {
    return unit(price_scheme(scheme, configured(settings), shipped()), of).area->total();
  };
  CHECK(area({{"peercy1997.word_bits", "8"}}, "environment") < area({}, "environment"));
  CHECK(area({{"environment.multipliers", "9"}}, "environment") < area({}, "environment"));
  CHECK(area({{"environment.multipliers", "9"}}, "illumination") == area({}, "illumination"));
}

TEST_CASE("registers follow the schedule: slower operators hold more") {
  const Scheme& scheme = find_scheme("lee2007");
  const auto bits = [&](const std::vector<std::pair<std::string, std::string>>& settings) {
    return unit(price_scheme(scheme, configured(settings), shipped()), "environment").registers->total();
  };
  CHECK(bits({{"datapath.latency.multiplier", "3"}}) > bits({}));
  CHECK(bits({{"datapath.latency.adder", "0"}}) < bits({}));
  const std::vector<std::pair<std::string, std::string>> chained = {{"datapath.latency.adder", "0"},
                                                                    {"datapath.latency.multiplier", "0"},
                                                                    {"datapath.latency.table", "0"},
                                                                    {"datapath.latency.clamp", "0"}};
  CHECK(bits(chained) == 0);
}

TEST_CASE("words for later units are held by the units in front of them") {
  // Lee 2007's illumination unit reads the bump map's angles beside the environment unit's results.
  const SchemePrice price = price_scheme(find_scheme("lee2007"), configured(), shipped());
  const UnitPrice& environment = unit(price, "environment");
  const BuiltScheme built = build_scheme(find_scheme("lee2007"), configured());
  std::int64_t carried = 0;
  for (const Netlist::Port& port : built.design.illumination.inputs()) {
    const auto& outputs = built.design.environment.outputs();
    const bool made = std::any_of(outputs.begin(), outputs.end(), [&](const Netlist::Port& output) { return output.name == port.name; });
    if (!made) carried += built.design.illumination.nodes()[static_cast<std::size_t>(port.node)].format.width * environment.latency;
  }
  CHECK(carried > 0);
  CHECK(environment.registers->carried == carried);
  CHECK(unit(price, "colour").registers->carried > 0);  // the texel, through both units
}

TEST_CASE("a scheme that a table lacks an entry for has no price, and the others have theirs") {
  const std::vector<PriceTable> tables = {without("area.divider")};
  const PriceReport report = report_of({&find_scheme("lee2007"), &find_scheme("peercy1997")}, make_price_book(tables));
  CHECK_FALSE(report.schemes[0].error.has_value());
  REQUIRE(report.schemes[1].error.has_value());
  const ErrorText& text = report.schemes[1].error->text();
  CHECK(text.what == "price table 'round' has no area.divider");
  CHECK(text.why.find("peercy1997, environment unit (") != std::string::npos);
  CHECK(worst_failure(report) == &report.schemes[1]);
  const std::string document = format_price_report(report, "md", false);
  CHECK(document.find("peercy1997 has no price: price table 'round' has no area.divider") != std::string::npos);
  CHECK(document.find("No table prices energies") != std::string::npos);
  const Json json = Json::parse(format_price_report(report, "json", false));
  CHECK(json["schemes"][1]["error"]["what"] == text.what);
  CHECK(json["tables"]["energy"].is_null());
  CHECK(json["schemes"][0]["energy_of_fragment"].is_null());
}

TEST_CASE("what stands apart without a price leaves the totals whole") {
  const SchemePrice price = price_scheme(find_scheme("lee2007"), configured(), shipped());
  CHECK_FALSE(unit(price, "interpolators").area.has_value());
  CHECK(unit(price, "interpolators").unpriced[0].find("area.float_adder") != std::string::npos);
  CHECK(price.total(Quantity::area, true).has_value());
  PriceOptions options;
  options.real_bits = 16;
  const SchemePrice fixed = price_scheme(find_scheme("lee2007"), configured(), shipped(), options);
  REQUIRE(unit(fixed, "interpolators").area.has_value());
  CHECK(unit(fixed, "interpolators").energy->total() < unit(price, "interpolators").energy->total());
  CHECK(fixed.total(Quantity::area, true) == price.total(Quantity::area, true));
}

TEST_CASE("energies of a scene follow what was executed and moved") {
  Scene scene;
  scene.lights.resize(2);
  ExecutedWork work;
  work.fragments = 1000;
  work.executions = {{"environment", 2000}, {"illumination", 2000}, {"colour", 1000},        {"interpolators", 1000},
                     {"vertex", 50},        {"conversion", 0},      {"vertex_transform", 50}};
  work.texture_look_ups = 3000;
  work.texture_bytes = 64000;
  PriceOptions options;
  options.scene = &scene;
  options.work = &work;
  const SchemePrice one = price_scheme(find_scheme("lee2007"), configured(), shipped());
  const SchemePrice two = price_scheme(find_scheme("lee2007"), configured(), shipped(), options);
  CHECK(two.total(Quantity::energy, false).value() == Approx(2 * one.total(Quantity::energy, false).value()));
  CHECK(two.total(Quantity::area, false).value() == one.total(Quantity::area, false).value());
  REQUIRE(two.traffic.has_value());
  const Configuration c = configured();
  const double bytes = static_cast<double>(c.integer("texture_fetch.cache.sets") * c.integer("texture_fetch.cache.ways") *
                                           c.integer("texture_fetch.cache.line_bytes"));
  CHECK(two.traffic->total() == Approx(3 * 10 * std::sqrt(bytes / 8192) + 64 * 244));
  // Lights repeat a part of the vertex program.
  CHECK(unit(two, "vertex").energy->total() > unit(one, "vertex").energy->total());
  CHECK(unit(two, "vertex").energy->total() < 2 * unit(one, "vertex").energy->total());
  CHECK_FALSE(unit(one, "vertex").energy_of_fragment().has_value());
  CHECK(unit(two, "vertex").energy_of_fragment().value() == Approx(0.05 * unit(two, "vertex").energy->total()));
}

TEST_CASE("a break-even is where the costs are equal, and its winners are the cheaper ones") {
  const Configuration configuration = configured();
  const std::vector<const Scheme*> schemes = all_schemes();
  std::vector<SchemePrice> prices;
  for (const Scheme* scheme : schemes) prices.push_back(price_scheme(*scheme, configuration, shipped()));
  int crossings = 0;
  for (std::size_t a = 0; a < prices.size(); ++a) {
    for (std::size_t b = 0; b < prices.size(); ++b) {
      const std::vector<BreakEven> points = break_even(prices[a], prices[b]);
      CHECK(points.size() == 4);
      for (const BreakEven& point : points) {
        INFO(schemes[a]->page().id << " " << schemes[b]->page().id << " " << point.unit);
        // At the price table's own cost the lines give the totals.
        for (const std::size_t i : {std::size_t{0}, std::size_t{1}})
          CHECK(point.lines[i].at(point.lines[i].own) == Approx(prices[i == 0 ? a : b].total(point.quantity, false).value()));
        if (a == b) {
          CHECK_FALSE(point.at.has_value());
          CHECK(point.below == -1);
          CHECK(point.above == -1);
          continue;
        }
        if (point.at) {
          ++crossings;
          CHECK(*point.at > 0);
          CHECK(point.lines[0].at(*point.at) == Approx(point.lines[1].at(*point.at)));
          CHECK(point.winner(0.5 * *point.at) == point.below);
          CHECK(point.winner(2 * *point.at) == point.above);
          CHECK(point.below != point.above);
        } else {
          for (const double cost : {1e-6, 0.01, 1.0, 1e6}) CHECK(point.winner(cost) == point.below);
          CHECK(point.below == point.above);
        }
      }
    }
  }
  CHECK(crossings > 0);
}

TEST_CASE("lines that touch or run side by side have no break-even at a positive cost") {
  const auto point = [](CostLine a, CostLine b) {
    BreakEven result;
    result.lines = {a, b};
    find_break_even(result);
    return result;
  };
  const BreakEven touching = point({5, 2, 0}, {5, 3, 0});
  CHECK_FALSE(touching.at.has_value());
  CHECK((touching.below == 0 && touching.above == 0));
  const BreakEven parallel = point({6, 2, 0}, {5, 2, 0});
  CHECK_FALSE(parallel.at.has_value());
  CHECK((parallel.below == 1 && parallel.above == 1));
  const BreakEven equal = point({5, 2, 0}, {5, 2, 0});
  CHECK_FALSE(equal.at.has_value());
  CHECK((equal.below == -1 && equal.above == -1));
  CHECK(point({10, 1, 0}, {4, 4, 0}).at.value() == 2);
}

TEST_CASE("a report names the table and the accuracy of every total") {
  PriceReportOptions options;
  options.schemes = all_schemes();
  options.break_even = {&find_scheme("lee2007"), &find_scheme("peercy1997")};
  const PriceReport report = make_price_report(configured(), shipped(), options);
  const PriceBook book = shipped();
  for (const std::string format : {"text", "md"}) {
    std::string text = format_price_report(report, format, true);
    std::replace(text.begin(), text.end(), '\n', ' ');
    for (std::size_t at = text.find("  "); at != std::string::npos; at = text.find("  ", at)) text.erase(at, 1);
    for (const Quantity quantity : {Quantity::area, Quantity::energy}) {
      const PriceTable& table = *book.of(quantity);
      CHECK(occurrences(text, table.accuracy(quantity)) >= 2);
      CHECK(occurrences(text, "by " + table.name()) >= 2 + all_schemes().size());
    }
    CHECK(text.find("Break-even: lee2007 against peercy1997") != std::string::npos);
    CHECK(text.find("In no total, because the table excludes them: clamp") != std::string::npos);
    // Every place that names the table of energies beside a total names what is missing from it.
    CHECK(occurrences(text, "by horowitz45") == occurrences(text, "by horowitz45, without clamp") + 1);  // but for the head
    CHECK(text.find("In no total, whatever the table: clock trees") != std::string::npos);
    CHECK(text.find("is in no energy (lee2007 has ") != std::string::npos);
  }
  const Json json = Json::parse(format_price_report(report, "json", false));
  CHECK(json["schema"] == price_schema);
  for (const Json& scheme : json["schemes"]) {
    for (const char* quantity : {"area", "energy_of_fragment"}) {
      CHECK(scheme[quantity]["bump_mapping"] > 0);
      CHECK_FALSE(scheme[quantity]["table"].get<std::string>().empty());
      CHECK_FALSE(scheme[quantity]["accuracy"].get<std::string>().empty());
      CHECK(scheme[quantity]["without"].empty() == (std::string(quantity) == "area"));
    }
  }
  CHECK(json["break_even"].size() == 4);
  std::istringstream csv(format_price_report(report, "csv", false));
  std::string line;
  std::size_t totals = 0;
  while (std::getline(csv, line)) {
    totals += occurrences(line, ",bump_mapping,total,");
    if (occurrences(line, ",bump_mapping,total,energy") > 0) CHECK(line.find("; without ") != std::string::npos);
  }
  CHECK(totals == 2 * all_schemes().size());
}

}  // namespace bump
