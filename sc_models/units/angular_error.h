#pragma once
// Measures how far the directions that the environment unit delivers are from the true ones, per fragment and light: L is the light vector
// at the fragment, H the sum of the unit vectors to light and eye, both in the frame in which the design delivers them; the polar frame is
// that about the z axis of the axes in which vectors are shaded (object_space.h). Only vectors that light the surface are counted: those
// on the outer side of the interpolated normal. Others add nothing to the picture, and the error tables of the literature leave them out. A
// measuring instrument, not hardware; it takes no time. Source of the frames: schemes/scheme.h, DeliveredDirection; polar: Lee 2007, Eqs
// 19-21.

#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "units/background_queue.h"
#include "units/counters.h"
#include "units/pipeline_context.h"

namespace bump {

/// The right-handed frame as columns x, y, z, in the coordinates of n, t, b (any length; t is made orthogonal to n, b only gives the
/// handedness).
glm::dmat3 delivery_frame(DeliveredDirection::Frame frame, const glm::dvec3& n, const glm::dvec3& t, const glm::dvec3& b);
/// The direction that two planes (phi, theta in turns) mean, Lee 2007 Eqs 19-21.
glm::dvec3 polar_direction(double phi, double theta);
/// Angle between two vectors of any length, degrees; 90 if one of them is zero.
double angle_between(const glm::dvec3& a, const glm::dvec3& b);

class AngularMeter {
 public:
  explicit AngularMeter(std::shared_ptr<const PipelineContext> context);
  /// Nothing happens unless the context probes directions. With ContextOptions::measure_aside the block is measured later, by a thread.
  void process(const FragmentBlock& block);

  /// One entry per delivered direction of the design, all lights together; empty without probes. Angles are NaN where no vector lights
  /// the surface.
  std::vector<AngularError> hardware() const { return report(&Sums::hardware); }
  std::vector<AngularError> exact() const { return report(&Sums::exact); }

 private:
  struct Sum {
    std::int64_t count = 0;
    double sum = 0, squares = 0, highest = 0;
    void add(double degrees);
  };
  struct Sums {
    Sum hardware, exact;
  };
  /// What measuring reads of a block: the probes, then for every light and direction the planes of the hardware and of the double
  /// evaluation.
  struct Sample {
    int object = 0;
    std::size_t lanes = 0;
    std::vector<Lanes> planes;
  };

  void measure(const Sample& sample);
  void measure_lane(const Sample& sample, const ObjectSpace& space, int light, std::size_t lane);
  std::vector<AngularError> report(Sum Sums::*which) const;

  std::shared_ptr<const PipelineContext> context_;
  std::vector<int> planes_;  ///< of hardware and double evaluation, in the order of a sample; the probes of the hardware only
  std::vector<Sums> sums_;   ///< one per delivered direction
  std::unique_ptr<BackgroundQueue<Sample>> queue_;  ///< none without probes
};

}  // namespace bump
