#include "testbench/experiments/retime_grid.h"

#include <algorithm>

namespace bump {

namespace {

SweepAxis axis_of(const std::string& text, const Parameters& parameters) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0)
    throw Error({"'" + text + "' is no sweep", {}, "a sweep is a key and its values", "--sweep fifos.depth=1,2,4"});
  SweepAxis axis{text.substr(0, equals), {}};
  Configuration scratch(parameters);
  for (std::size_t begin = equals + 1; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    scratch.set_text(axis.key, text.substr(begin, end - begin), {"--sweep", 0, 0});
    const ParameterValue& value = scratch.entries().at(axis.key).value;
    if (std::find(axis.values.begin(), axis.values.end(), value) != axis.values.end())
      throw Error({axis.key + " is to be " + to_string(value) + " twice", {"--sweep", 0, 0}, "", "each value once"});
    axis.values.push_back(value);
    begin = end + 1;
  }
  return axis;
}

}  // namespace

SweepGrid::SweepGrid(const std::vector<std::string>& texts, const Parameters& parameters) {
  for (const std::string& text : texts) {
    SweepAxis axis = axis_of(text, parameters);
    for (const SweepAxis& other : axes_)
      if (other.key == axis.key)
        throw Error({axis.key + " is swept twice", {"--sweep", 0, 0}, "", "all its values after one --sweep, commas between"});
    if (axis.values.size() > most_points / points_)
      throw Error({"the sweep has more than " + std::to_string(most_points) + " points",
                   {"--sweep", 0, 0},
                   "it is the product of all values of all keys",
                   "fewer values, or several sweeps one after another"});
    points_ *= axis.values.size();
    axes_.push_back(std::move(axis));
  }
  std::size_t stride = points_;
  for (const SweepAxis& axis : axes_) stride_.push_back(stride /= axis.values.size());
}

const ParameterValue& SweepGrid::value(std::size_t point, std::size_t axis) const {
  return axes_[axis].values[point / stride_[axis] % axes_[axis].values.size()];
}

void SweepGrid::apply(std::size_t point, Configuration& configuration) const {
  for (std::size_t i = 0; i < axes_.size(); ++i) configuration.set(axes_[i].key, value(point, i), {"--sweep", 0, 0});
}

std::vector<std::string> SweepGrid::values(std::size_t point) const {
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < axes_.size(); ++i) texts.push_back(to_string(value(point, i)));
  return texts;
}

}  // namespace bump
