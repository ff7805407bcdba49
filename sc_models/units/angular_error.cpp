#include "units/angular_error.h"

#include <algorithm>
#include <cmath>

#include "datapath/invariant.h"

namespace bump {

namespace {

constexpr double pi = 3.14159265358979323846;

/// The planes of probe vectors P, N, T, B.
constexpr int position_probe = 0, normal_probe = 1, tangent_probe = 2, binormal_probe = 3;

}  // namespace

glm::dmat3 delivery_frame(DeliveredDirection::Frame frame, const glm::dvec3& n, const glm::dvec3& t, const glm::dvec3& b) {
  if (frame == DeliveredDirection::Frame::shading) return glm::dmat3{1};
  const glm::dvec3 z = glm::normalize(n);
  if (frame == DeliveredDirection::Frame::tangent) {
    const glm::dvec3 x = glm::normalize(t - z * glm::dot(z, t));
    const glm::dvec3 y = glm::cross(z, x);
    return {x, glm::dot(y, b) < 0 ? -y : y, z};
  }
  const double sine = std::sqrt(z.x * z.x + z.y * z.y);
  const double cos_phi = sine > 0 ? z.x / sine : 1, sin_phi = sine > 0 ? z.y / sine : 0;
  return {{z.z * cos_phi, z.z * sin_phi, -sine}, {-sin_phi, cos_phi, 0}, z};
}

glm::dvec3 polar_direction(double phi, double theta) {
  const double p = 2 * pi * phi, t = 2 * pi * theta;
  return {std::sin(t) * std::cos(p), std::sin(t) * std::sin(p), std::cos(t)};
}

double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
  const double sine = glm::length(glm::cross(a, b)), cosine = glm::dot(a, b);
  if (sine == 0 && cosine == 0) return 90;
  return std::atan2(sine, cosine) * 180 / pi;
}

void AngularMeter::Sum::add(double degrees) {
  ++count;
  sum += degrees;
  squares += degrees * degrees;
  highest = std::max(highest, degrees);
}

AngularMeter::AngularMeter(std::shared_ptr<const PipelineContext> context) : context_(std::move(context)) {
  if (!context_->options.probe_directions) return;
  sums_.resize(context_->designs.front().directions.size());
  for (const Attribute& attribute : context_->attributes)
    if (attribute.probe >= 0) probes_[static_cast<std::size_t>(attribute.probe)] = attribute.plane;
}

glm::dvec3 AngularMeter::probe(const FragmentBlock& block, int vector, std::size_t lane) const {
  glm::dvec3 value;
  for (int axis = 0; axis < 3; ++axis)
    value[axis] = block.hardware[static_cast<std::size_t>(probes_[static_cast<std::size_t>(3 * vector + axis)])][lane];
  return value;
}

void AngularMeter::process(const FragmentBlock& block) {
  if (sums_.empty()) return;
  const std::vector<DeliveredDirection>& directions = context_->design_of(block.object).directions;
  for (int light = 0; light < context_->lights; ++light)
    for (std::size_t i = 0; i < sums_.size(); ++i) measure(block, directions[i], light, sums_[i]);
}

void AngularMeter::measure(const FragmentBlock& block, const DeliveredDirection& direction, int light, Sums& sums) const {
  BUMP_ASSERT(direction.planes.size() == 2 || direction.planes.size() == 3);
  const ObjectSpace& space = context_->spaces[static_cast<std::size_t>(block.object)];
  std::vector<const Lanes*> hardware, exact;
  for (const std::string& name : direction.planes) {
    const int plane = context_->plane(name, light);
    hardware.push_back(&block.hardware[static_cast<std::size_t>(plane)]);
    exact.push_back(&context_->exact_plane(block, plane));
  }
  const auto delivered = [](const std::vector<const Lanes*>& planes, std::size_t lane) {
    if (planes.size() == 2) return polar_direction((*planes[0])[lane], (*planes[1])[lane]);
    return glm::dvec3((*planes[0])[lane], (*planes[1])[lane], (*planes[2])[lane]);
  };
  for (std::size_t lane = 0; lane < static_cast<std::size_t>(block.lanes); ++lane) {
    const glm::dvec3 position = probe(block, position_probe, lane);
    glm::dvec3 truth = glm::normalize(space.light_vector(light, position));
    if (direction.of == DeliveredDirection::Of::half) truth = truth + glm::normalize(space.eye_vector(position));
    const auto axis = [&](int vector) { return space.direction(probe(block, vector, lane)); };
    const glm::dmat3 frame = delivery_frame(direction.frame, axis(normal_probe), axis(tangent_probe), axis(binormal_probe));
    truth = glm::transpose(frame) * truth;
    const bool is_turned = direction.frame != DeliveredDirection::Frame::shading;
    if (!((is_turned ? truth.z : glm::dot(truth, axis(normal_probe))) > 0)) continue;
    sums.hardware.add(angle_between(truth, delivered(hardware, lane)));
    sums.exact.add(angle_between(truth, delivered(exact, lane)));
  }
}

std::vector<AngularError> AngularMeter::report(Sum Sums::*which) const {
  std::vector<AngularError> errors;
  for (std::size_t i = 0; i < sums_.size(); ++i) {
    const Sum& sum = sums_[i].*which;
    AngularError error;
    error.vector = context_->designs.front().directions[i].of == DeliveredDirection::Of::light ? "L'" : "H'";
    error.count = sum.count;
    if (sum.count > 0) {
      error.mean_degrees = sum.sum / static_cast<double>(sum.count);
      error.rms_degrees = std::sqrt(sum.squares / static_cast<double>(sum.count));
      error.max_degrees = sum.highest;
    }
    errors.push_back(error);
  }
  return errors;
}

}  // namespace bump
