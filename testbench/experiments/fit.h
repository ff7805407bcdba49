#pragma once
// Equal quality: for each scheme the cheapest structure (fit_variants.h) and widths (fit_search.h) whose pictures reach a PSNR on the worst
// of several scenes. Designs are simulated in child processes, without dates while searching; the answer is then run once more as any run
// is, self-check included. Quality is by default that of the hardware's picture against the reference, which holds a scheme to the truth:
// what its formula neglects counts as what its words round. Against its own double evaluation only the words count. No model of hardware.

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "channels/parameters.h"
#include "datapath/error.h"
#include "schemes/scheme.h"
#include "testbench/experiments/fit_cost.h"
#include "testbench/experiments/fit_variants.h"
#include "testbench/experiments/price_table.h"
#include "units/scene.h"

namespace bump {

enum class FitAgainst { reference, own_double };

struct FitOptions {
  double psnr_db = 0;
  FitAgainst against = FitAgainst::reference;
  FitCostKind cost = FitCostKind::table_bits;
  PriceBook book;                ///< what to price by; its tables must outlive the result
  bool search_structure = true;  ///< false: widths alone
  int limit = 600;               ///< designs measured at most, for each scheme
  int jobs = 0;                  ///< 0: one per core; the result does not depend on it
  /// Schemes finished, and designs measured of the next one as a share of the limit.
  std::function<void(double)> progress;
  const std::atomic<bool>* cancelled = nullptr;
};

/// A scene's picture by the design found, dB; infinite for identical pictures.
struct FitQuality {
  double to_reference = 0, to_double = 0;
  double double_to_reference = 0;  ///< of the scheme's formula, whatever the widths
};

struct FitRow {
  const SchemePage* page = nullptr;
  std::optional<Error> error;      ///< why there is no design
  std::vector<FitChoice> choices;  ///< of structure, that were searched
  Structure structure;             ///< their values
  VariantCounts variants;
  std::vector<FitStructure::Kept> kept;  ///< choices left as they are by what they decide
  std::vector<std::string> left;         ///< choices left as they are, as the structure was not searched
  std::vector<std::string> keys;         ///< widths that were chosen
  std::vector<WidthRange> ranges;        ///< what their parameters allow
  Widths widths;                         ///< theirs
  std::vector<std::string> set, idle;    ///< what the user set; widths that have no effect
  /// Widths that ended at their least allowed value: where a bit more costs more, so that narrower ones might cost less; and the others.
  std::vector<std::string> costly_limits, idle_limits;
  bool reached = false;  ///< false: no design that was measured does; this is the best of them
  bool complete = true;  ///< false: the limit ended the search
  int measured = 0;      ///< designs
  int failed = 0;        ///< of them, by an error
  DesignSize size;
  std::vector<FitQuality> qualities;  ///< one a scene

  double worst(double FitQuality::*which) const;
  /// Choices that differ from the configuration's, as key and value.
  std::vector<std::pair<std::string, std::string>> taken() const;
  /// What it costs may be too much, as the search ended at what the scheme's parameters allow.
  bool is_upper_bound() const { return reached && !costly_limits.empty(); }
};

struct Fit {
  std::vector<const Scene*> scenes;
  const Configuration* configuration = nullptr;
  FitOptions options;
  std::vector<FitRow> rows;

  /// Of the row, as asked for.
  double worst(const FitRow& row) const;
};

/// Scenes and configuration must outlive the result. Call before this process elaborates SystemC. Throws Error(input) for settings under
/// which widths mean nothing, for two scenes of one name, and for a cost that no price table has; Error(cancelled).
Fit fit(const std::vector<const Scene*>& scenes, const std::vector<const Scheme*>& schemes, const Configuration& configuration,
        const FitOptions& options);

/// "own_double" is `double` on the command line.
const char* name_of(FitAgainst against);

/// The first row with the worst failure; null if there is none. Not to reach the target is no failure.
const FitRow* worst_failure(const Fit& fit);

}  // namespace bump
