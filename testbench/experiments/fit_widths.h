#pragma once
// Which parameters of a scheme a fit may choose: its whole numbers of bits, unless they only move the binary point (the name ends in
// "integer_bits") or the user has set them. Widths that change nothing under the given settings (texels of a filter that is not chosen)
// are told from the others by recording the design at either end of their range. No model of hardware.

#include <string>
#include <vector>

#include "channels/parameters.h"
#include "schemes/scheme.h"
#include "testbench/experiments/fit_search.h"

namespace bump {

struct FitParameters {
  std::vector<std::string> keys;  ///< to choose, in order of key
  std::vector<WidthRange> ranges;
  std::vector<std::string> set;   ///< set by the user: left as they are
  std::vector<std::string> idle;  ///< without effect under these settings
};

/// A whole number of bits or CORDIC stages that does not only move the binary point.
bool is_fit_width(const Parameter& parameter);

/// Throws Error(input) if settings contradict one another whatever the widths.
FitParameters fit_parameters(const Scheme& scheme, const Configuration& configuration);

/// The configuration with these widths for these keys.
Configuration with_widths(const Configuration& configuration, const std::vector<std::string>& keys, const Widths& widths);

/// Everything about a design that widths and choices can change, as text: nodes, formats, tables' sizes, interpolants and texels. Equal
/// texts compute the same, unless a map is baked for its surface, of which the text says only that it is.
std::string design_signature(const Design& design);

}  // namespace bump
