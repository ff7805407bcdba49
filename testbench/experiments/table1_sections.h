#pragma once
// The sections of Table 1, each a function that appends its rows. What they share: every registered scheme built once under the
// configuration, and the order of the columns. Internal to table1.cpp; no hardware, no time.

#include <array>
#include <string>
#include <vector>

#include "testbench/experiments/table1.h"
#include "testbench/experiments/table1_netlists.h"

namespace bump {

/// One architecture: what is known of it, and its netlists if it is registered.
struct Table1Source {
  Table1Scheme about;
  const Scheme* scheme = nullptr;
  std::optional<BuiltScheme> built;
  std::optional<BuiltScheme> at_defaults;  ///< only where the configuration differs from the scheme's defaults

  bool reconstructs(const std::string& step) const;
  bool blends_colours() const;  ///< the printed illumination includes the colour unit
};

inline const std::array<std::string, 2> table1_steps = {"environment", "illumination"};

struct Table1Context {
  const Configuration& configuration;
  std::vector<Table1Source> sources;

  const Table1Source* find(std::string_view scheme) const;
};

/// The six columns of Table 1. `published`: null entries are not known; empty: none is.
std::vector<Table1Value> operator_values(const Inventory* derived, const std::vector<std::optional<double>>& published = {});
/// As a cell prints them; an operator that it does not name is 0.
std::vector<std::optional<double>> printed(const published::OperatorCounts& counts);

/// "set to a=1 (default 2)" for a scheme away from its defaults, else empty.
std::string configured_text(const Table1Scheme& scheme);

void add_operators(const Table1Context& context, std::vector<Table1Row>& rows);
void add_text_counts(const Table1Context& context, std::vector<Table1Row>& rows);
void add_storage(const Table1Context& context, std::vector<Table1Row>& rows);
void add_reductions(const Table1Context& context, std::vector<Table1Row>& rows);
void add_beyond(const Table1Context& context, std::vector<Table1Row>& rows);

}  // namespace bump
