#include "testbench/experiments/fit_structure.h"

#include "testbench/experiments/fit_widths.h"

namespace bump {

namespace {

constexpr double most_numbers = 8;  ///< a whole number with more values is a quantity, and no choice

std::vector<ParameterValue> values_of(const Parameter& parameter) {
  std::vector<ParameterValue> values;
  if (std::holds_alternative<bool>(parameter.fallback)) return {false, true};
  for (const std::string& word : parameter.choices) values.emplace_back(word);
  if (std::holds_alternative<std::int64_t>(parameter.fallback) && parameter.high - parameter.low < most_numbers)
    for (auto value = static_cast<std::int64_t>(parameter.low); value <= static_cast<std::int64_t>(parameter.high); ++value)
      values.emplace_back(value);
  return values;
}

}  // namespace

Structure FitStructure::given() const {
  Structure structure;
  for (const FitChoice& choice : choices) structure.push_back(choice.given);
  return structure;
}

FitStructure fit_structure(const Scheme& scheme, const Configuration& configuration) {
  FitStructure structure;
  for (const auto& [key, parameter] : configuration.parameters().all()) {
    if (key.rfind(scheme.page().id + ".", 0) != 0 || is_fit_width(parameter)) continue;
    FitChoice choice{key, values_of(parameter), 0};
    if (choice.values.size() < 2) continue;
    const Configuration::Entry& entry = configuration.entries().at(key);
    if (entry.origin.file != "default") {
      structure.set.push_back(key);
    } else if (!parameter.decides.empty()) {
      structure.kept.push_back({key, parameter.decides});
    } else {
      while (choice.values[choice.given] != entry.value) ++choice.given;
      structure.choices.push_back(std::move(choice));
    }
  }
  return structure;
}

Configuration with_structure(const Configuration& configuration, const std::vector<FitChoice>& choices, const Structure& structure) {
  Configuration result = configuration;
  for (std::size_t i = 0; i < choices.size(); ++i)
    if (structure[i] != choices[i].given) result.set(choices[i].key, choices[i].values[structure[i]], Location("fit"));
  return result;
}

}  // namespace bump
