// A price report for readers: aligned text or Markdown of the same document.

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "testbench/experiments/compare.h"
#include "testbench/experiments/document.h"
#include "testbench/experiments/price_report.h"

namespace bump {

namespace {

using Role = UnitPrice::Role;
using Row = std::vector<std::string>;

constexpr std::array<CostGroup, 6> datapath_groups = {CostGroup::multipliers, CostGroup::adders,    CostGroup::dividers,
                                                      CostGroup::tables,      CostGroup::registers, CostGroup::logic};
const Row group_headings = {"multipliers", "adders", "div, sqrt", "tables", "registers", "logic"};

std::string amount(const std::optional<double>& value, Quantity quantity) {
  if (!value) return "-";
  return quantity == Quantity::area ? fmt::format("{:.0f}", *value) : fmt::format("{:.2f}", *value);
}
std::string amount_or_none(double value, Quantity quantity) {
  return value == 0 ? "-" : amount(value, quantity);
}

/// A place of a cost on a scale from which readers take two or three digits.
std::string rounded(double value) {
  return fmt::format("{:.3g}", value);
}

class PriceDocument {
 public:
  PriceDocument(const PriceReport& report, bool markdown, bool items) : report_(report), document_(markdown), items_(items) {}

  std::string text() {
    head();
    for (const Quantity quantity : {Quantity::area, Quantity::energy})
      if (report_.book.of(quantity) != nullptr) overview(quantity);
    for (const SchemePrice& price : report_.schemes) {
      if (price.error || (report_.schemes.size() > 1 && !items_)) continue;
      for (const Quantity quantity : {Quantity::area, Quantity::energy})
        if (report_.book.of(quantity) != nullptr) units(price, quantity);
    }
    if (!report_.break_even.empty()) break_evens();
    for (const Quantity quantity : {Quantity::area, Quantity::energy})
      if (report_.book.of(quantity) != nullptr) prices(quantity);
    return document_.text();
  }

 private:
  const PriceTable& table(Quantity quantity) const { return *report_.book.of(quantity); }
  static std::string subject(Quantity quantity) {
    return quantity == Quantity::area ? "Area, NAND2 equivalents" : "Energy of a fragment, pJ";
  }

  void head() {
    document_.heading(1, "Price");
    std::string words = report_.scene.empty() ? "For one light, every pixel netlist once for a fragment; memory traffic needs a scene."
                                              : "On " + report_.scene + ": what was executed and moved there, for each fragment.";
    if (report_.real_bits > 0) words += fmt::format(" Interpolators and vertex work as fixed point of {} bits.", report_.real_bits);
    document_.paragraph(words);
    for (const Quantity quantity : {Quantity::area, Quantity::energy}) {
      if (report_.book.of(quantity) == nullptr) {
        document_.paragraph(fmt::format("No table prices {}: there is none below.", quantity == Quantity::area ? "areas" : "energies"));
        continue;
      }
      const PriceTable& by = table(quantity);
      document_.paragraph(fmt::format("{} by {}: {}; {}. Accuracy of a total: {}.", quantity == Quantity::area ? "Areas" : "Energies",
                                      by.name(), by.title(), by.technology(), by.accuracy(quantity)));
    }
    if (report_.settings.empty()) {
      document_.paragraph("All parameters have their defaults.");
    } else {
      std::string configured = "Configured:";
      for (const std::string& setting : report_.settings) configured += " " + setting + ";";
      configured.back() = '.';
      document_.paragraph(configured);
    }
  }

  /// One row a scheme.
  void overview(Quantity quantity) {
    const bool traffic = quantity == Quantity::energy && !report_.scene.empty();
    document_.heading(2, subject(quantity) + ", by " + table(quantity).name() + without(quantity));
    Row header = {"scheme"};
    header.insert(header.end(), group_headings.begin(), group_headings.end());
    header.insert(header.end(), {"total", "beside published", "with colour"});
    header.push_back(quantity == Quantity::area ? "table bits" : "table reads");
    if (traffic) header.insert(header.end(), {"memory", "with memory"});
    std::vector<Row> rows;
    for (const SchemePrice& price : report_.schemes) {
      Row row = {marked_id(*price.page)};
      if (price.error) {
        row.resize(header.size(), "-");
        row[1] = "no price";
        rows.push_back(row);
        continue;
      }
      for (const CostGroup group : datapath_groups) row.push_back(amount_or_none(price.of(quantity, group).value_or(0), quantity));
      const std::optional<double> total = price.total(quantity, false), all = price.total(quantity, true);
      row.push_back(amount(total, quantity));
      row.push_back(amount_or_none(price.additions(quantity).value_or(0), quantity));
      row.push_back(amount(all, quantity));
      row.push_back(quantity == Quantity::area ? amount(price.table_bits(), quantity)
                    : price.table_reads()      ? rounded(*price.table_reads())
                                               : "-");
      if (traffic) {
        const std::optional<double> memory = price.traffic ? std::optional(price.traffic->total()) : std::nullopt;
        row.push_back(amount(memory, quantity));
        row.push_back(amount(memory && all ? std::optional(*memory + *all) : std::nullopt, quantity));
      }
      rows.push_back(row);
    }
    document_.table(header, rows, 1);
    for (const SchemePrice& price : report_.schemes)
      if (price.error)
        document_.item(fmt::format("{} has no price: {}; {}", price.page->id, price.error->text().what, price.error->text().why));
    document_.item(fmt::format("Totals are by {}{} ({}): bump mapping{}, without and with the colour unit{}.", table(quantity).name(),
                               without(quantity), table(quantity).accuracy(quantity),
                               quantity == Quantity::area ? " with its tables and pipeline registers" : "",
                               traffic ? ", then with caches and memory" : ""));
    if (quantity == Quantity::area)
      document_.item("Beside published: the part of the total that is in no published figure; its registers are not told apart.");
    left_out(quantity);
    if (std::any_of(report_.schemes.begin(), report_.schemes.end(),
                    [](const SchemePrice& price) { return is_reconstruction(*price.page); }))
      document_.item("(R): a reconstruction, in whole or in part.");
  }

  /// What every total of the quantity lacks by its table, for a place beside the table's name.
  std::string without(Quantity quantity) const {
    const std::string names = excluded_names(report_, quantity);
    return names.empty() ? "" : ", without " + names;
  }

  /// What the totals do not have because the table excludes it, and what no table prices.
  void left_out(Quantity quantity) {
    std::string list;
    for (const UsedEntry& used : used_entries(report_))
      if (used.quantity == quantity && used.excluded > 0)
        list += fmt::format("{}{} (up to {:.0f}{})", list.empty() ? "" : ", ", name_of(used.component), used.excluded,
                            used.component == Component::register_bits ? " bits" : "");
    if (!list.empty()) document_.item("In no total, because the table excludes them: " + list + ".");
    document_.item("In no total, whatever the table: " + never_priced(quantity) + ".");
  }

  void units(const SchemePrice& price, Quantity quantity) {
    const bool energy = quantity == Quantity::energy;
    document_.heading(2, fmt::format("{}: {} of each unit, {}, by {}", marked_id(*price.page), name_of(quantity),
                                     energy ? "pJ an execution" : "NAND2", table(quantity).name() + without(quantity)));
    Row header = {"unit"};
    header.insert(header.end(), group_headings.begin(), group_headings.end());
    header.push_back("total");
    if (energy)
      header.insert(header.end(), {"executions", "of a fragment"});
    else
      header.insert(header.end(), {"register bits", "latency"});
    std::vector<Row> rows;
    std::vector<std::string> notes;
    for (const UnitPrice& unit : price.units) {
      const std::optional<CostSheet>& sheet = energy ? unit.energy : unit.area;
      Row row = {unit.name + (unit.role == Role::apart ? ", apart" : "")};
      for (const CostGroup group : datapath_groups) row.push_back(sheet ? amount_or_none(sheet->of(group), quantity) : "-");
      row.push_back(sheet ? amount(sheet->total(), quantity) : "-");
      if (energy) {
        row.push_back(unit.executions ? rounded(*unit.executions) : "-");
        row.push_back(amount(unit.energy_of_fragment(), quantity));
      } else {
        row.push_back(unit.registers ? std::to_string(unit.registers->total()) : "-");
        row.push_back(unit.registers ? std::to_string(unit.latency) : "-");
      }
      rows.push_back(row);
      const std::string& why = unit.unpriced[static_cast<std::size_t>(quantity)];
      if (!why.empty()) notes.push_back(unit.name + " has no " + name_of(quantity) + ": " + why + ".");
    }
    if (energy && price.traffic) {
      for (const PricedItem& item : price.traffic->items) {
        Row row(header.size(), "-");
        row[0] = fmt::format("{}, {}", item.item.component == Component::cache_read ? "cache look-ups" : "memory bytes", item.item.node);
        row[header.size() - 3] = amount(item.each, quantity);
        row[header.size() - 2] = rounded(item.item.count);
        row[header.size() - 1] = amount(item.total(), quantity);
        rows.push_back(row);
      }
    }
    document_.table(header, rows, 1);
    for (const std::string& note : notes) document_.item(note);
    if (items_) components(price, quantity);
  }

  void components(const SchemePrice& price, Quantity quantity) {
    std::vector<Row> rows;
    std::string last;
    for (const UnitPrice& unit : price.units) {
      const std::optional<CostSheet>& sheet = quantity == Quantity::area ? unit.area : unit.energy;
      if (!sheet) continue;
      for (const PricedItem& item : sheet->items) {
        const bool out = item.entry->is_excluded();
        rows.push_back({unit.name == last ? "" : unit.name, std::string(item.item.addition ? "+ " : "") + name_of(item.item.component),
                        sizes_text(item.item), fmt::format("{:.0f}", item.item.count), out ? "excluded" : rounded(item.each),
                        out ? "-" : amount(item.total(), quantity)});
        last = unit.name;
      }
    }
    document_.table({"unit", "component", "sizes", "count", "each", "together"}, rows, 3);
    document_.item("+ is beside the published design.");
  }

  void break_evens() {
    const auto id = [&](int index) { return report_.schemes[(*report_.compared)[static_cast<std::size_t>(index)]].page->id; };
    document_.heading(2, "Break-even: " + id(0) + " against " + id(1));
    std::vector<Row> rows;
    std::vector<std::string> sentences;
    for (const BreakEven& point : report_.break_even) {
      const std::string by = table(point.quantity).name() + without(point.quantity);
      for (int i = 0; i < 2; ++i) {
        const CostLine& line = point.lines[static_cast<std::size_t>(i)];
        rows.push_back({i == 0 ? name_of(point.quantity) : "", i == 0 ? point.unit : "", id(i), amount(line.rest, point.quantity),
                        amount(line.tables, line.tables == std::floor(line.tables) ? Quantity::area : Quantity::energy), rounded(line.own),
                        i == 0 ? (point.at ? rounded(*point.at) : "none") : ""});
      }
      sentences.push_back(sentence(point, by, id));
    }
    document_.table({"quantity", "cost in", "scheme", "without tables", "units of tables", "by its table", "equal at"}, rows, 3);
    for (const std::string& words : sentences) document_.item(words);
    for (const ExcludedEffect& effect : report_.excluded_effects) document_.item(sentence(effect, id));
  }

  /// Whether the component could turn the ranking, with an adder's price to judge by.
  template <class Id>
  std::string sentence(const ExcludedEffect& effect, const Id& id) const {
    const char* unit = unit_of(effect.quantity);
    const char* piece = has_width(effect.component) || effect.component == Component::register_bits ? "bit" : "piece";
    const std::string what = fmt::format("{} is in no {} ({} has {:.0f} {}s, {} {:.0f})", name_of(effect.component),
                                         name_of(effect.quantity), id(0), effect.amounts[0], piece, id(1), effect.amounts[1]);
    if (!effect.at) return what + ": at no price does it change the ranking.";
    std::string scale;
    constexpr double usual_width = 12;
    const PriceEntry* adder = table(effect.quantity).find(effect.quantity, Component::adder);
    if (adder != nullptr && !adder->is_excluded())
      scale = fmt::format("; a bit of an adder takes {} {}", rounded(adder->at({usual_width}) / usual_width), unit);
    return what + fmt::format(": above {} {} a {} it would turn the ranking, {} would be cheaper{}.", rounded(*effect.at), unit, piece,
                              id(1 - effect.ahead), scale);
  }

  template <class Id>
  static std::string sentence(const BreakEven& point, const std::string& by, const Id& id) {
    const std::string what = point.quantity == Quantity::area ? "area" : "energy";
    if (point.at)
      return fmt::format("In {} by {}, {} is cheaper below {} {}, {} above.", what, by, id(point.below), rounded(*point.at), point.unit,
                         id(point.above));
    if (point.below < 0) return fmt::format("In {} by {}, both cost the same, whatever tables cost.", what, by);
    return fmt::format("In {} by {}, {} is cheaper at any cost of tables ({}).", what, by, id(point.below), point.unit);
  }

  void prices(Quantity quantity) {
    document_.heading(2, fmt::format("Prices of {}: {}", table(quantity).name(), name_of(quantity)));
    document_.paragraph("Source: " + table(quantity).source());
    for (const UsedEntry& used : used_entries(report_)) {
      if (used.quantity != quantity) continue;
      std::string words = std::string(name_of(used.component)) + ": ";
      if (used.entry->is_excluded()) {
        document_.item(words + "excluded; " + used.entry->reason);
        continue;
      }
      words += formula(*used.entry, used.component) + " " + unit_of(quantity) + "; " + used.entry->accuracy + "; " + used.entry->source;
      if (!used.entry->rule.empty()) words += "; scaling rule: " + used.entry->rule;
      for (const Component component : used.standing_in)
        words += fmt::format("; also for {}, which the table does not list", name_of(component));
      document_.item(words);
    }
  }

  const PriceReport& report_;
  Document document_;
  bool items_;
};

}  // namespace

std::string price_document(const PriceReport& report, bool markdown, bool items) {
  return PriceDocument(report, markdown, items).text();
}

}  // namespace bump
