// A price report for programs: CSV and JSON.

#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "testbench/experiments/compare.h"
#include "testbench/experiments/price_report.h"
#include "testbench/results/error_json.h"
#include "testbench/results/text_table.h"

namespace bump {

namespace {

using Json = nlohmann::ordered_json;

const char* role_name(UnitPrice::Role role) {
  return role == UnitPrice::Role::bump_mapping ? "bump_mapping" : role == UnitPrice::Role::colour ? "colour" : "apart";
}

Json optional(const std::optional<double>& value) {
  return value ? Json(*value) : Json();
}

Json table_json(const PriceReport& report, Quantity quantity) {
  const PriceTable* table = report.book.of(quantity);
  if (table == nullptr) return nullptr;
  Json json = {{"name", table->name()},     {"unit", unit_of(quantity)},
               {"title", table->title()},   {"technology", table->technology()},
               {"source", table->source()}, {"accuracy", table->accuracy(quantity)},
               {"entries", Json::array()}};
  for (const UsedEntry& used : used_entries(report)) {
    if (used.quantity != quantity) continue;
    Json entry = {{"component", name_of(used.component)}, {"formula", formula(*used.entry, used.component)}};
    if (used.entry->is_excluded()) {
      entry["excluded"] = used.entry->reason;
      entry["most"] = used.excluded;
    } else {
      entry["source"] = used.entry->source;
      entry["technology"] = used.entry->technology;
      entry["accuracy"] = used.entry->accuracy;
      if (!used.entry->rule.empty()) entry["rule"] = used.entry->rule;
    }
    if (!used.standing_in.empty()) {
      entry["stands_in_for"] = Json::array();
      for (const Component component : used.standing_in) entry["stands_in_for"].push_back(name_of(component));
    }
    json["entries"].push_back(entry);
  }
  return json;
}

Json groups_json(const CostSheet& sheet) {
  Json json = Json::object();
  for (int g = 0; g < static_cast<int>(CostGroup::count); ++g)
    if (const double amount = sheet.of(static_cast<CostGroup>(g)); amount > 0) json[name_of(static_cast<CostGroup>(g))] = amount;
  return json;
}

Json sheet_json(const CostSheet& sheet) {
  Json json = {{"total", sheet.total()}, {"additions", sheet.additions()}, {"groups", groups_json(sheet)}, {"items", Json::array()}};
  for (const PricedItem& item : sheet.items) {
    Json one = {{"component", name_of(item.item.component)}, {"count", item.item.count}};
    const std::vector<std::string>& sizes = sizes_of(item.item.component);
    for (std::size_t i = 0; i < sizes.size(); ++i) one[sizes[i]] = item.item.size[i];
    if (item.entry->is_excluded())
      one["excluded"] = true;
    else
      one["each"] = item.each;
    if (item.item.addition) one["addition"] = true;
    json["items"].push_back(one);
  }
  return json;
}

Json unit_json(const UnitPrice& unit) {
  Json json = {{"unit", unit.name}, {"role", role_name(unit.role)}};
  if (unit.registers) {
    json["latency"] = unit.latency;
    json["initiation_interval"] = unit.initiation_interval;
    json["register_bits"] = {{"between", unit.registers->between},
                             {"inside", unit.registers->inside},
                             {"carried", unit.registers->carried},
                             {"waiting", unit.registers->waiting}};
  }
  if (unit.area) json["area"] = sheet_json(*unit.area);
  if (unit.energy) json["energy_of_execution"] = sheet_json(*unit.energy);
  json["executions_of_fragment"] = optional(unit.executions);
  json["energy_of_fragment"] = optional(unit.energy_of_fragment());
  for (const Quantity quantity : {Quantity::area, Quantity::energy})
    if (const std::string& why = unit.unpriced[static_cast<std::size_t>(quantity)]; !why.empty())
      json[std::string("no_") + name_of(quantity)] = why;
  return json;
}

/// What the totals, the one with the colour unit included, lack by the table's own word.
Json left_out_json(const SchemePrice& price, Quantity quantity) {
  Json json = Json::object();
  for (const LeftOut& one : price.left_out(quantity, true)) json[name_of(one.component)] = one.amount;
  return json;
}

Json total_json(const PriceReport& report, const SchemePrice& price, Quantity quantity) {
  const PriceTable* table = report.book.of(quantity);
  if (table == nullptr) return nullptr;
  return {{"bump_mapping", optional(price.total(quantity, false))},
          {"with_colour_unit", optional(price.total(quantity, true))},
          {"additions", optional(price.additions(quantity))},
          {"unit", unit_of(quantity)},
          {"table", table->name()},
          {"accuracy", table->accuracy(quantity)},
          {"without", left_out_json(price, quantity)}};
}

Json scheme_json(const PriceReport& report, const SchemePrice& price) {
  Json json = {{"scheme", price.page->id}, {"title", price.page->title}, {"reconstruction", is_reconstruction(*price.page)}};
  json["error"] = price.error ? to_json(price.error->text()) : Json();
  if (price.error) return json;
  json["area"] = total_json(report, price, Quantity::area);
  json["energy_of_fragment"] = total_json(report, price, Quantity::energy);
  json["table_bits"] = optional(price.table_bits());
  json["table_reads_of_fragment"] = optional(price.table_reads());
  json["units"] = Json::array();
  for (const UnitPrice& unit : price.units) json["units"].push_back(unit_json(unit));
  json["memory_traffic_of_fragment"] = price.traffic ? sheet_json(*price.traffic) : Json();
  json["fragments"] = price.work ? Json(price.work->fragments) : Json();
  return json;
}

Json break_even_json(const PriceReport& report) {
  Json json = Json::array();
  for (const BreakEven& point : report.break_even) {
    const auto id = [&](int index) {
      return index < 0 ? Json() : Json(report.schemes[(*report.compared)[static_cast<std::size_t>(index)]].page->id);
    };
    Json one = {{"quantity", name_of(point.quantity)},
                {"unit", point.unit},
                {"at", optional(point.at)},
                {"cheaper_below", id(point.below)},
                {"cheaper_above", id(point.above)}};
    for (int i = 0; i < 2; ++i) {
      const CostLine& line = point.lines[static_cast<std::size_t>(i)];
      one["lines"].push_back({{"scheme", id(i)}, {"rest", line.rest}, {"tables", line.tables}, {"cost_by_table", line.own}});
    }
    json.push_back(one);
  }
  return json;
}

Json excluded_effects_json(const PriceReport& report) {
  Json json = Json::array();
  for (const ExcludedEffect& effect : report.excluded_effects) {
    const auto id = [&](int index) {
      return index < 0 ? Json() : Json(report.schemes[(*report.compared)[static_cast<std::size_t>(index)]].page->id);
    };
    json.push_back({{"quantity", name_of(effect.quantity)},
                    {"component", name_of(effect.component)},
                    {"amounts", effect.amounts},
                    {"cheaper_without_it", id(effect.ahead)},
                    {"turns_above", optional(effect.at)}});
  }
  return json;
}

class Csv {
 public:
  explicit Csv(const PriceReport& report) : report_(report) {}

  std::string text() {
    text_ = csv_line({"scheme", "unit", "role", "quantity", "of", "table", "component", "sizes", "count", "each", "amount", "amount_unit",
                      "addition", "note"});
    for (const SchemePrice& price : report_.schemes) add(price);
    return std::move(text_);
  }

 private:
  void line(const std::string& unit, const std::string& role, Quantity quantity, const std::string& of, const std::string& component,
            const std::string& sizes, const std::optional<double>& count, const std::optional<double>& each,
            const std::optional<double>& amount, bool addition, const std::string& note) {
    const auto cell = [](const std::optional<double>& value) { return value ? fmt::format("{:.10g}", *value) : std::string(); };
    const PriceTable* table = report_.book.of(quantity);
    text_ += csv_line({scheme_, unit, role, name_of(quantity), of, table != nullptr ? table->name() : "", component, sizes, cell(count),
                       cell(each), cell(amount), unit_of(quantity), addition ? "yes" : "", note});
  }
  void sheet(const UnitPrice& unit, const CostSheet& sheet, Quantity quantity, const std::string& of) {
    for (const PricedItem& item : sheet.items) {
      const bool out = item.entry->is_excluded();
      line(unit.name, role_name(unit.role), quantity, of, name_of(item.item.component), sizes_text(item.item), item.item.count,
           out ? std::nullopt : std::optional(item.each), out ? std::nullopt : std::optional(item.total()), item.item.addition,
           out ? "excluded" : "");
    }
    line(unit.name, role_name(unit.role), quantity, of, "total", "", std::nullopt, std::nullopt, sheet.total(), false, "");
  }
  void add(const SchemePrice& price) {
    scheme_ = price.page->id;
    if (price.error) {
      text_ += csv_line({scheme_, "", "", "", "", "", "", "", "", "", "", "", "", "error: " + price.error->text().what});
      return;
    }
    for (const UnitPrice& unit : price.units) {
      if (unit.area) sheet(unit, *unit.area, Quantity::area, "unit");
      if (unit.energy) sheet(unit, *unit.energy, Quantity::energy, "execution");
      if (unit.energy)
        line(unit.name, role_name(unit.role), Quantity::energy, "fragment", "total", "", unit.executions, unit.energy->total(),
             unit.energy_of_fragment(), false, "");
      for (const Quantity quantity : {Quantity::area, Quantity::energy})
        if (const std::string& why = unit.unpriced[static_cast<std::size_t>(quantity)]; !why.empty())
          line(unit.name, role_name(unit.role), quantity, "", "total", "", std::nullopt, std::nullopt, std::nullopt, false, why);
    }
    if (price.traffic) {
      UnitPrice traffic;
      traffic.name = "memory_traffic";
      traffic.role = UnitPrice::Role::apart;
      sheet(traffic, *price.traffic, Quantity::energy, "fragment");
    }
    for (const Quantity quantity : {Quantity::area, Quantity::energy}) {
      if (report_.book.of(quantity) == nullptr) continue;
      const std::string of = quantity == Quantity::area ? "scheme" : "fragment";
      for (const bool with_colour : {false, true}) {
        std::string note = report_.book.of(quantity)->accuracy(quantity);
        for (const LeftOut& one : price.left_out(quantity, with_colour))
          note += fmt::format("; without {} ({:.10g})", name_of(one.component), one.amount);
        line(with_colour ? "bump_mapping_and_colour" : "bump_mapping", "total", quantity, of, "total", "", std::nullopt, std::nullopt,
             price.total(quantity, with_colour), false, note);
      }
    }
  }

  const PriceReport& report_;
  std::string text_, scheme_;
};

}  // namespace

std::string price_csv(const PriceReport& report) {
  return Csv(report).text();
}

std::string price_json(const PriceReport& report) {
  Json json = {{"schema", price_schema},
               {"schema_version", price_schema_version},
               {"scene", report.scene.empty() ? Json() : Json(report.scene)},
               {"settings", report.settings},
               {"real_bits", report.real_bits > 0 ? Json(report.real_bits) : Json()},
               {"tables", {{"area", table_json(report, Quantity::area)}, {"energy", table_json(report, Quantity::energy)}}},
               {"schemes", Json::array()}};
  for (const SchemePrice& price : report.schemes) json["schemes"].push_back(scheme_json(report, price));
  json["break_even"] = break_even_json(report);
  json["excluded_effects"] = excluded_effects_json(report);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace bump
