#pragma once
// Several schemes on one scene with one configuration: every one simulated in a process of its own and measured against the same
// references. A scheme that fails is a row with its error; the others are compared all the same. No model of hardware.

#include <atomic>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "channels/parameters.h"
#include "datapath/error.h"
#include "schemes/scheme.h"
#include "testbench/experiments/compare_picture.h"
#include "units/scene.h"

namespace bump {

/// "a,b", blanks around ids allowed, in the order given; "all": every scheme in order of id. One that is named twice is compared once.
/// Throws Error(input) with the nearest id.
std::vector<const Scheme*> schemes_of(const std::string& list);

struct ComparisonRow {
  const SchemePage* page = nullptr;
  std::optional<Error> error;     ///< why there is no result
  nlohmann::ordered_json result;  ///< the document of result_json.h, `host` aside; null if the scheme failed
  SmallFrame frame;               ///< what the hardware drew, shrunk for the picture; empty without a picture
};

struct Comparison {
  const Scene* scene = nullptr;
  const Configuration* configuration = nullptr;
  std::string engine;
  std::vector<ComparisonRow> rows;
  std::vector<std::string> warnings;  ///< each once
  SmallFrame reference;               ///< shrunk as the rows' frames are; empty without a picture
};

struct ComparisonOptions {
  std::string engine = "dated";
  int jobs = 0;          ///< 0: one per core; the comparison does not depend on it
  bool picture = false;  ///< keep the frames
  std::function<void(double)> progress;
  const std::atomic<bool>* cancelled = nullptr;
};

/// Scene and configuration must outlive the result. Call before this process elaborates SystemC. Throws Error(cancelled).
Comparison compare(const Scene& scene, const std::vector<const Scheme*>& schemes, const Configuration& configuration,
                   const ComparisonOptions& options);

/// True if the scheme is, in whole or in part, a reconstruction.
bool is_reconstruction(const SchemePage& page);

/// The id, with " (R)" for a reconstruction.
std::string marked_id(const SchemePage& page);

/// The first row with the worst failure: internal before self-check, deadlock and input. Null if every scheme has its result.
const ComparisonRow* worst_failure(const Comparison& comparison);
/// Every scheme failed: there is nothing to compare.
bool is_void(const Comparison& comparison);

/// The frames of those that did not fail behind the reference's, each with id and PSNR against the reference. For `picture` comparisons
/// only.
FrameBuffer picture_of(const Comparison& comparison);

}  // namespace bump
