#include "units/angular_error.h"

#include <algorithm>
#include <cmath>

#include "datapath/invariant.h"

namespace bump {

namespace {

constexpr double pi = 3.14159265358979323846;

/// Planes of a sample: the probe vectors P, N, T, B come first, three planes each.
constexpr std::size_t position_probe = 0, normal_probe = 3, tangent_probe = 6, binormal_probe = 9, probe_planes = 12;

/// Blocks that may wait to be measured: enough for a thread to be away for some milliseconds.
constexpr std::size_t waiting_blocks = 32;

glm::dvec3 vector_at(const Lanes* planes, std::size_t lane) {
  return {planes[0][lane], planes[1][lane], planes[2][lane]};
}

/// The direction that 2 or 3 planes hold.
glm::dvec3 delivered(const Lanes* planes, std::size_t count, std::size_t lane) {
  return count == 2 ? polar_direction(planes[0][lane], planes[1][lane]) : vector_at(planes, lane);
}

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
  const std::vector<DeliveredDirection>& directions = context_->designs.front().directions;
  if (directions.empty()) return;
  sums_.resize(directions.size());
  planes_.resize(probe_planes);
  for (const Attribute& attribute : context_->attributes)
    if (attribute.probe >= 0) planes_[static_cast<std::size_t>(attribute.probe)] = attribute.plane;
  for (int light = 0; light < context_->lights; ++light) {
    for (const DeliveredDirection& direction : directions) {
      BUMP_ASSERT(direction.planes.size() == 2 || direction.planes.size() == 3);
      for (const std::string& name : direction.planes) planes_.push_back(context_->plane(name, light));
    }
  }
  queue_ = std::make_unique<BackgroundQueue<Sample>>(waiting_blocks, context_->options.measure_aside,
                                                     [this](const Sample& sample) { measure(sample); });
}

void AngularMeter::process(const FragmentBlock& block) {
  if (!queue_) return;
  Sample& sample = queue_->next();
  sample.object = block.object;
  sample.lanes = static_cast<std::size_t>(block.lanes);
  sample.planes.resize(probe_planes + 2 * (planes_.size() - probe_planes));
  Lanes* out = sample.planes.data();
  const auto copy = [&](const Lanes& plane) { std::copy_n(plane.begin(), sample.lanes, (out++)->begin()); };
  for (std::size_t i = 0; i < planes_.size(); ++i) copy(block.hardware[static_cast<std::size_t>(planes_[i])]);
  for (std::size_t i = probe_planes; i < planes_.size(); ++i) copy(context_->exact_plane(block, planes_[i]));
  queue_->push();
}

void AngularMeter::measure(const Sample& sample) {
  const ObjectSpace& space = context_->spaces[static_cast<std::size_t>(sample.object)];
  for (int light = 0; light < context_->lights; ++light)
    for (std::size_t lane = 0; lane < sample.lanes; ++lane) measure_lane(sample, space, light, lane);
}

void AngularMeter::measure_lane(const Sample& sample, const ObjectSpace& space, int light, std::size_t lane) {
  const std::vector<DeliveredDirection>& directions = context_->designs.front().directions;
  const Lanes* planes = sample.planes.data();
  const std::size_t of_all_lights = planes_.size() - probe_planes;
  const Lanes* hardware =
      planes + probe_planes + of_all_lights / static_cast<std::size_t>(context_->lights) * static_cast<std::size_t>(light);
  const glm::dvec3 position = vector_at(planes + position_probe, lane);
  const glm::dvec3 normal = space.direction(vector_at(planes + normal_probe, lane));
  const glm::dvec3 to_light = glm::normalize(space.light_vector(light, position));
  glm::dmat3 frame{1};
  for (std::size_t i = 0; i < directions.size(); hardware += directions[i++].planes.size()) {
    const DeliveredDirection& direction = directions[i];
    const bool is_turned = direction.frame != DeliveredDirection::Frame::shading;
    // The directions of a design come in one frame.
    if (is_turned && (i == 0 || direction.frame != directions[i - 1].frame))
      frame = delivery_frame(direction.frame, normal, space.direction(vector_at(planes + tangent_probe, lane)),
                             space.direction(vector_at(planes + binormal_probe, lane)));
    glm::dvec3 truth = to_light;
    if (direction.of == DeliveredDirection::Of::half) truth = truth + glm::normalize(space.eye_vector(position));
    if (is_turned) truth = glm::transpose(frame) * truth;
    if (!((is_turned ? truth.z : glm::dot(truth, normal)) > 0)) continue;
    const std::size_t count = direction.planes.size();
    sums_[i].hardware.add(angle_between(truth, delivered(hardware, count, lane)));
    sums_[i].exact.add(angle_between(truth, delivered(hardware + of_all_lights, count, lane)));
  }
}

std::vector<AngularError> AngularMeter::report(Sum Sums::*which) const {
  if (queue_) queue_->drain();
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
