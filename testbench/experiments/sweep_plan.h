#pragma once
// A sweep ready to run: its scenes read, its points named by what they depend on, and gathered in groups whose points differ in time alone,
// so that one simulation of each group tells the values, and the records, of all. No model of hardware.

#include <deque>
#include <string>
#include <vector>

#include "testbench/experiments/sweep_spec.h"
#include "units/scene.h"

namespace bump {

/// The version of what is stored of a point: it is part of the points' names, so that what an older program left is not mistaken.
constexpr int sweep_schema_version = 1;

struct PlannedPoint {
  SpecPoint spec;
  /// Hash of all that the result depends on: version of the program and of its figures, scene files, frame, scheme, resolved configuration.
  std::string id;
  std::size_t group = 0;
};

struct PointGroup {
  const Scene* scene = nullptr;
  const Scheme* scheme = nullptr;
  std::vector<std::size_t> members;  ///< points, in order
  bool varies_caches = false;        ///< members differ in what caches find
};

/// i of n: 1 to n of n.
struct Shard {
  int index = 1, of = 1;
};

class SweepPlan {
 public:
  /// Reads the scenes. Points that are the same as an earlier one are dropped. Throws Error(input). `version` is the program's.
  SweepPlan(SweepSpec spec, const std::string& version);
  SweepPlan(const SweepPlan&) = delete;  // groups refer to its scenes
  SweepPlan& operator=(const SweepPlan&) = delete;

  const SweepSpec& spec() const { return spec_; }
  const std::vector<PlannedPoint>& points() const { return points_; }
  const std::vector<PointGroup>& groups() const { return groups_; }
  const PointGroup& group_of(std::size_t point) const { return groups_[points_[point].group]; }
  std::size_t repeated() const { return repeated_; }  ///< points that were dropped
  /// As the specification names the scenes.
  const std::vector<Scene>& scenes() const { return scenes_; }
  /// Name of the whole: of all points in their order, whatever the shard.
  const std::string& id() const { return id_; }

  /// Sets what the point sets, in a configuration that may hold those of another point.
  void apply(std::size_t point, Configuration& configuration) const;
  Configuration configuration_of(std::size_t point) const;
  /// The simulation from which the group's points are dated: the first member's configuration, but with the defaults of all that is only
  /// timing, with which no machine deadlocks, and of the caches where the members differ in them.
  Configuration recorded_configuration(const PointGroup& group) const;
  /// For messages: "point 17 (lee2007 on world_sphere, fifos.depth = 2)".
  std::string describe(std::size_t point) const;

  /// Whole groups in turn, or points in turn where there are fewer groups than shards.
  bool is_in(const Shard& shard, std::size_t point) const;

 private:
  const Scene& sized_scene(const SpecPoint& point);
  std::string id_of(const SpecPoint& point, const Scene& scene, const Configuration& configuration) const;

  SweepSpec spec_;
  std::string prefix_;         ///< what all points depend on
  std::vector<Scene> scenes_;  ///< by index of the specification
  std::deque<Scene> sized_;    ///< with frames of other sizes
  std::vector<PlannedPoint> points_;
  std::vector<PointGroup> groups_;
  std::size_t repeated_ = 0;
  std::string id_;
};

/// Whether the points of a group may differ in the parameter: it is only timing, or decides only what caches find.
bool is_dated_again(const Parameter& parameter);
/// Only what caches find.
bool is_cache_parameter(const Parameter& parameter);

}  // namespace bump
