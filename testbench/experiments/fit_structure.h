#pragma once
// Which choices of a scheme's structure a fit may take: its words, flags and small whole numbers that are no widths (the texel's filter,
// where angles are formed, ROM ports, the place of a binary point). Left as they are: what the user has set, and what decides more than
// the cost of the same picture (Parameter::decides), with its reason. No model of hardware.

#include <string>
#include <vector>

#include "channels/parameters.h"
#include "schemes/scheme.h"

namespace bump {

/// Of each choice the index of its value.
using Structure = std::vector<std::size_t>;

struct FitChoice {
  std::string key;
  std::vector<ParameterValue> values;
  std::size_t given = 0;  ///< index of the configuration's value
};

struct FitStructure {
  struct Kept {
    std::string key, reason;
  };
  std::vector<FitChoice> choices;  ///< in order of key
  std::vector<std::string> set;    ///< set by the user
  std::vector<Kept> kept;          ///< by what they decide

  Structure given() const;
};

FitStructure fit_structure(const Scheme& scheme, const Configuration& configuration);

/// The configuration with these values of the choices. What equals the configuration's own value stays untouched.
Configuration with_structure(const Configuration& configuration, const std::vector<FitChoice>& choices, const Structure& structure);

}  // namespace bump
