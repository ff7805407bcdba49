#pragma once
// A table of prices, read from a TOML file that anybody can replace: for each component its area in NAND2 equivalents and the energy of
// one operation as a function of the component's sizes, each entry with its source, its technology and how accurate it is. What a table
// does not list has no price, and asking for it is an error: nothing is free by omission. An entry may say that its source leaves the
// component out ("excluded"); then totals say so, too. No hardware of its own, no time. The file format is in testbench/prices/README.md.

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "datapath/error.h"
#include "testbench/experiments/price_component.h"

namespace bump {

enum class Quantity { area, energy };
/// "area", "energy".
const char* name_of(Quantity quantity);
/// "NAND2", "pJ".
const char* unit_of(Quantity quantity);

/// Values of a component's sizes, in the order of sizes_of(); unused ones are 0.
using PriceSizes = std::array<double, 4>;

struct PriceEntry {
  enum class Form {
    constant,  ///< value
    linear,    ///< base + sum of per_<size> * size
    product,   ///< base + coefficient * product of the first two sizes + sum of per_<size> * size
    power,     ///< coefficient * product of (size / reference_<size>) ^ exponent_<size>
    excluded   ///< the source has no figure, for the reason given: counted apart, in no total
  };
  Form form = Form::constant;
  double base = 0, coefficient = 0;
  PriceSizes per{}, reference{1, 1, 1, 1}, exponent{};
  std::string source, technology, accuracy;
  std::string rule;    ///< how it was scaled from what the source states; empty: as stated there
  std::string reason;  ///< excluded: why
  Location where;

  bool is_excluded() const { return form == Form::excluded; }
  /// The price for these sizes, in the table's unit.
  double at(const PriceSizes& sizes) const;
};

/// "9.4 first second", "0.2 (first/8)^0.99 (second/8)^0.99"; what a reader can check.
std::string formula(const PriceEntry& entry, Component component);

class PriceTable {
 public:
  /// Throws Error(input) with file, line and column: syntax, unknown components, keys and units, missing or wrong coefficients, an entry
  /// without source or accuracy. `name` is what totals call the table.
  PriceTable(const std::string& text, const std::string& file, std::string name);

  const std::string& name() const { return name_; }
  const std::string& title() const { return title_; }
  const std::string& technology() const { return technology_; }
  const std::string& source() const { return source_; }
  /// Of a total in this quantity; empty if the table does not price it.
  const std::string& accuracy(Quantity quantity) const { return section(quantity).accuracy; }
  const std::string& file() const { return file_; }
  /// Whether it has entries for this quantity.
  bool prices(Quantity quantity) const { return !section(quantity).entries.empty(); }

  /// The component's entry, or that of its general case; null if neither is there.
  const PriceEntry* find(Quantity quantity, Component component) const;
  /// Which component's entry find() gives; `component` itself if there is none.
  Component entry_component(Quantity quantity, Component component) const;
  /// As find(). Throws Error(input) naming table, component and `who` needs it.
  const PriceEntry& at(Quantity quantity, Component component, const std::string& who) const;

 private:
  struct Section {
    std::string accuracy;
    std::map<Component, PriceEntry> entries;
  };
  const Section& section(Quantity quantity) const { return sections_[static_cast<std::size_t>(quantity)]; }

  std::string file_, name_, title_, technology_, source_;
  std::array<Section, 2> sections_;
};

/// Reads a file; the table is called like it, without folder and suffix.
PriceTable read_price_table(const std::string& path);

/// Where areas and where energies come from: never a mixture of tables in one total. Null: nothing prices that quantity.
struct PriceBook {
  const PriceTable* area = nullptr;
  const PriceTable* energy = nullptr;

  const PriceTable* of(Quantity quantity) const { return quantity == Quantity::area ? area : energy; }
};
/// Each quantity from the first table that prices it. The tables must outlive the book.
PriceBook make_price_book(const std::vector<PriceTable>& tables);

}  // namespace bump
