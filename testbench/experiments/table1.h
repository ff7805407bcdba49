#pragma once
// Table 1 of Lee et al. 2007: what each architecture is built of, derived from the recorded netlists, beside what the paper prints, with
// the difference and its reason; sizes of tables and maps; the claim of saved multiplications; and what the table leaves out. One list of
// rows that every output format shows. Models no hardware and takes no time; derived numbers come from netlists, printed ones from
// testbench/published and nowhere else.

#include <optional>
#include <string>
#include <vector>

#include "channels/parameters.h"

namespace bump {

/// One number. Missing values are unknown or not applicable, never 0.
struct Table1Value {
  std::string quantity;  ///< e.g. "multipliers"
  std::string unit;      ///< e.g. "operators", "bytes", "%"
  std::optional<double> derived, published;
  std::string why;  ///< where both are known: reason of a difference, or what the agreement rests on; may be empty if they agree

  /// derived - published, if both are known.
  std::optional<double> difference() const;
  bool differs() const;
};

/// What a row tells; the order of the sections in every format.
enum class Table1Section {
  operators,   ///< Table 1's cells: one row a scheme and step, additions, other readings, totals
  text,        ///< numbers of operators that the text gives
  storage,     ///< bytes of tables and maps
  text_sizes,  ///< sizes that the text gives
  reduction,   ///< multipliers of the proposed design against each other one
  claim,       ///< "up to 78 %"
  beyond       ///< what Table 1 leaves out
};
const char* name_of(Table1Section section);

enum class Table1Kind { step, addition, reading, total, other };

struct Table1Row {
  Table1Section section = Table1Section::operators;
  Table1Kind kind = Table1Kind::other;
  std::string scheme;
  std::string step;      ///< "environment", "illumination", "total", "vertex", ... or what the text speaks of
  std::string settings;  ///< "key=value" with blanks between, where the row is not the configured design
  bool reconstruction = false;
  std::string agreement;  ///< "exact", "by convention", "by construction", "differs", "not listed", "not available", "not modelled"
  std::string source;     ///< of the printed numbers
  std::string why;        ///< of the row as a whole
  std::vector<Table1Value> values;

  const Table1Value* find(const std::string& quantity) const;
};

struct Table1Scheme {
  std::string id;
  std::string column;  ///< heading in Table 1, empty if it has none
  std::string title, source, provenance;
  std::vector<std::string> reconstructed;  ///< steps
  bool modelled = false;                   ///< a scheme of this id is registered
  std::vector<std::string> configured;     ///< "key=value (default ...)" of its parameters away from the default
};

struct Table1 {
  std::vector<Table1Scheme> schemes;  ///< the columns of Table 1 in its order, then the others by id
  std::vector<Table1Row> rows;        ///< by section, in a section by scheme
  std::vector<std::string> settings;  ///< "key=value (default ...)" of every parameter away from the default

  const Table1Scheme& scheme(const std::string& id) const;
};

/// Builds every registered scheme under the configuration. Throws Error(input) if its settings contradict one another.
Table1 make_table1(const Configuration& configuration);

/// `format`: "text" (at most 140 columns), "md", "csv" or "json". Ends with a line break.
std::string format_table1(const Table1& table, const std::string& format);

}  // namespace bump
