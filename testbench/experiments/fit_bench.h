#pragma once
// Designs of one scheme measured on all scenes of a fit, each in a child process, and never one twice: without dates while searching, as
// any run when the answer is confirmed. What they cost comes from netlists and prices. No model of hardware.

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "testbench/experiments/child_processes.h"
#include "testbench/experiments/fit.h"
#include "testbench/reference/reference_renderer.h"

namespace bump {

/// What the fits of all schemes share.
struct FitScenes {
  const std::vector<const Scene*>& scenes;
  const std::vector<References>& references;
  const FitOptions& options;
};

class FitBench {
 public:
  /// `progress`: designs measured, as a share of the options' limit.
  FitBench(const FitScenes& scenes, const Scheme& scheme, std::function<void(double)> progress);

  /// `width_sum`: of the widths chosen. Nothing for settings that contradict one another.
  std::optional<FitCost> cost(const Configuration& configuration, std::int64_t width_sum);
  DesignSize size(const Configuration& configuration, std::int64_t width_sum) const;

  /// dB on the worst of the scenes for each, in the quality that is asked for; minus infinity for a design that fails. A design that is
  /// below `floor` on the scene that has been the worst most often is not measured on the others: what it has there is the answer.
  std::vector<double> worst(const std::vector<Configuration>& designs, double floor);
  /// Of each scene, as any run, self-check included. Throws what a run of it throws.
  std::vector<FitQuality> in_full(const Configuration& design) const;

  int measured() const { return static_cast<int>(known_.size()); }
  int failed() const { return static_cast<int>(failed_.size()); }
  const std::optional<Error>& first_error() const { return first_error_; }

 private:
  std::string settings_of(const Configuration& configuration) const;
  struct Task {
    const Configuration* design;
    std::size_t scene;
  };
  using OnScenes = std::vector<std::optional<double>>;  ///< dB, as far as measured
  static double worst_of(const OnScenes& qualities);
  void measure(const std::vector<Task>& tasks);
  std::string name_of(const Task& task) const;
  ChildOptions child_options() const;
  std::size_t hardest_scene() const;
  void count_hardest(const OnScenes& qualities);

  const FitScenes& scenes_;
  const Scheme& scheme_;
  std::function<void(double)> progress_;
  std::map<std::string, OnScenes> known_;  ///< by settings
  std::vector<int> was_worst_;             ///< of each scene, how often
  std::set<std::string> failed_;           ///< their settings
  std::optional<Error> first_error_;
};

}  // namespace bump
