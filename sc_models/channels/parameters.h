#pragma once
// Every knob of the simulator is a declared parameter: its key is its module's path ("texture_fetch.cache.ways"), its configuration key
// and its documented name at once. Units and schemes declare theirs; a Configuration holds the resolved values and where each came from.
// A parameter that nobody declared cannot be read or set.

#include <cstdint>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "datapath/error.h"

namespace bump {

using ParameterValue = std::variant<bool, std::int64_t, double, std::string>;

struct Parameter {
  std::string key;                   ///< "module.name", lower case, dots between levels
  ParameterValue fallback;           ///< default value; its alternative is the parameter's type
  double low = 0, high = 0;          ///< allowed range of numbers, inclusive
  std::vector<std::string> choices;  ///< allowed words; empty for other types
  std::string unit;                  ///< "tokens", "cycles", "bits", "" ...
  std::string meaning;               ///< one line
  /// Read by nothing but the timing plane: it moves dates, and never values, routes, hits or the intervals that units record. What was
  /// recorded once can be dated again with another value (sc_models/retiming).
  bool timing_only = false;
  /// Not empty for what decides more than the cost and precision of the same picture: which map the artist delivers, which reading of a paper
  /// counts as the scheme. A search for the cheapest design leaves the parameter as it is, and gives this as the reason.
  std::string decides{};
};

/// The declared parameters, in key order.
class Parameters {
 public:
  // Each declares one and returns it, so that it can be marked.
  Parameter& integer(const std::string& key, std::int64_t fallback, std::int64_t low, std::int64_t high, const std::string& unit,
                     const std::string& meaning);
  Parameter& number(const std::string& key, double fallback, double low, double high, const std::string& unit, const std::string& meaning);
  Parameter& boolean(const std::string& key, bool fallback, const std::string& meaning);
  Parameter& choice(const std::string& key, const std::string& fallback, const std::vector<std::string>& choices,
                    const std::string& meaning);

  const Parameter* find(const std::string& key) const;
  const std::map<std::string, Parameter>& all() const { return parameters_; }
  /// The declared key with the smallest edit distance, "" if nothing is near.
  std::string nearest(const std::string& key) const;

 private:
  Parameter& declare(Parameter parameter);
  std::map<std::string, Parameter> parameters_;
};

/// "4, allowed 1 to 65536 tokens" and the like, for messages and `describe`.
std::string allowed(const Parameter& parameter);
std::string to_string(const ParameterValue& value);

/// Resolved values. Starts from the declared defaults; later settings win.
class Configuration {
 public:
  explicit Configuration(Parameters parameters);

  /// Sets a value given as text ("16", "true", "tiled"), as from `--set key=value`. Throws Error(input) naming the nearest key or the
  /// allowed range.
  void set_text(const std::string& key, const std::string& text, const Location& origin);
  /// Sets a typed value (an integer is accepted where a number is expected).
  void set(const std::string& key, const ParameterValue& value, const Location& origin);

  std::int64_t integer(const std::string& key) const;
  double number(const std::string& key) const;
  bool boolean(const std::string& key) const;
  const std::string& choice(const std::string& key) const;

  struct Entry {
    ParameterValue value;
    Location origin;  ///< file "default" for defaults, "--set" for the command line
  };
  const std::map<std::string, Entry>& entries() const { return entries_; }
  const Parameters& parameters() const { return parameters_; }

 private:
  const Entry& entry(const std::string& key) const;
  Parameters parameters_;
  std::map<std::string, Entry> entries_;
};

/// The candidate nearest to `word` by edit distance (at most 3, less for short words), "" if none is near.
std::string nearest_word(const std::string& word, const std::vector<std::string>& candidates);

}  // namespace bump
