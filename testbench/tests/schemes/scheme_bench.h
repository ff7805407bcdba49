#pragma once
// A bench for one scheme without a pipeline: random surface points go through the vertex program, the map encoding and the per-pixel
// netlists of a Design, in double precision or in fixed point, every point as its own vertex and its own texel. Nothing is interpolated or
// filtered, so what remains is the scheme's arithmetic.

#include <array>
#include <functional>
#include <glm/glm.hpp>
#include <initializer_list>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "datapath/evaluate.h"
#include "schemes/scheme.h"

namespace bump::bench {

using Plane = std::array<double, block_lanes>;
/// Values of 256 points by name: ports of the netlists, as the pipeline would carry them.
using Planes = std::map<std::string, Plane>;
using Settings = std::initializer_list<std::pair<const char*, const char*>>;

Configuration configured(const Scheme& scheme, Settings settings);
Design designed(const std::string& id, Settings settings = {}, const Material& material = {});

/// Runs the first `lanes` points through a netlist: inputs by name from `planes`, outputs by name into it. The evaluator is returned to
/// look at nodes; it refers to the netlist.
std::unique_ptr<Evaluator> run(const Netlist& netlist, Arithmetic arithmetic, Planes& planes, int lanes = block_lanes);

/// One surface point with unit vectors; the frame is right-handed, V and L on the outer side of N, N' tilted from N by at most `tilt`
/// radians.
struct Point {
  glm::dvec3 normal, tangent, binormal, light, view;
  glm::dvec3 bump;  ///< N' in tangent space
};

/// Deterministic random numbers that are the same everywhere.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed * 2654435769u + 1) {}
  std::uint64_t word();
  double uniform(double low, double high);
  glm::dvec3 direction();
  Point point(double tilt = 0.5);

 private:
  std::uint64_t state_;
};

/// N', L, H shaded by Eq 2 of Lee 2007 in tangent space, without ambient.
double exact_intensity(const Point& point, const Material& material);

/// Shades 256 points: the vertex program always in double precision, texels quantised in fixed point. Returns every plane on the way. Light
/// maps are worked out entry by entry, each point with its own light and eye, infinitely far.
Planes shade(const Design& design, Arithmetic arithmetic, const std::vector<Point>& points);

struct Accuracy {
  double fixed_to_real_db = 0;  ///< intensity, peak 1: fixed point against the scheme's double evaluation
  double real_to_exact_db = 0;  ///< double evaluation against exact_intensity
  double fixed_to_exact_db = 0;
};
Accuracy accuracy(const Design& design, const Material& material, int blocks, const std::function<Point(Random&)>& draw);

std::array<double, 3> components(const glm::dvec3& v);
/// Unit vector of polar angles in turns.
glm::dvec3 from_polar(double phi, double theta);
double degrees_between(const glm::dvec3& a, const glm::dvec3& b);

}  // namespace bump::bench
