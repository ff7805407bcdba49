#include "testbench/scene/material_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "datapath/error.h"

namespace bump {

namespace {

/// Texture options with the most arguments they take; those of one to three numbers may take fewer.
struct Option {
  std::size_t arguments;
  std::vector<std::string> without_effect;  ///< the arguments, if there are some, that change nothing; the last one goes on
};

const std::map<std::string, Option>& options() {
  static const std::map<std::string, Option> known = {
      {"-blendu", {1, {"on"}}}, {"-blendv", {1, {"on"}}}, {"-boost", {1, {}}},   {"-bm", {1, {"1"}}},      {"-cc", {1, {"off"}}},
      {"-clamp", {1, {"off"}}}, {"-colorspace", {1, {}}}, {"-imfchan", {1, {}}}, {"-mm", {2, {"0", "1"}}}, {"-o", {3, {"0"}}},
      {"-s", {3, {"1"}}},       {"-t", {3, {"0"}}},       {"-texres", {1, {}}},  {"-type", {1, {}}}};
  return known;
}

/// A number with nothing behind it; not necessarily finite. What is too small is 0, what is too large infinite.
std::optional<double> number_of(const std::string& word) {
  const char* begin = word.data() + (word.size() > 1 && word[0] == '+' && word[1] != '-' ? 1 : 0);
  const char* end = word.data() + word.size();
  double number = 0;
  const auto [stop, error] = std::from_chars(begin, end, number);
  if (stop != end || error == std::errc::invalid_argument) return std::nullopt;
  if (error == std::errc()) return number;
  const std::size_t exponent = word.find_first_of("eE");
  return exponent != std::string::npos && word[exponent + 1] == '-' ? 0 : HUGE_VAL;
}

class MaterialReader {
 public:
  MaterialReader(const FileName& file, std::vector<std::string>& warnings) : file_(file), warnings_(warnings) {}

  std::string read(const std::string& text) {
    std::size_t begin = text.compare(0, 3, "\xef\xbb\xbf") == 0 ? 3 : 0;
    for (line_ = 1; begin < text.size(); ++line_) {
      const std::size_t end = std::min(text.find_first_of("\r\n", begin), text.size());
      read_line(text.substr(begin, end - begin));
      begin = end + (text.compare(end, 2, "\r\n") == 0 ? 2 : 1);
    }
    if (!without_effect_.empty()) warnings_.push_back("'" + file_.shown + "': statements without effect: " + list_of(without_effect_));
    if (!unknown_.empty()) warnings_.push_back("'" + file_.shown + "': unknown keys ignored: " + list_of(unknown_));
    return used_;
  }

 private:
  struct Word {
    std::size_t begin;
    std::string text;
  };

  static std::string list_of(const std::set<std::string>& words) {
    std::string list;
    for (const auto& word : words) list += (list.empty() ? "" : ", ") + word;
    return list;
  }

  void warn(const std::string& text) { warnings_.push_back(to_string(Location(file_.shown, line_)) + ": " + text); }

  void read_line(const std::string& line) {
    std::vector<Word> words;
    for (std::size_t at = line.find_first_not_of(" \t"); at != std::string::npos;) {
      const std::size_t end = std::min(line.find_first_of(" \t", at), line.size());
      words.push_back({at, line.substr(at, end - at)});
      at = line.find_first_not_of(" \t", end);
    }
    if (words.empty() || words[0].text[0] == '#') return;
    static const std::set<std::string> ignored = {
        "Ka",    "Ks",   "Ke",        "Ns", "Ni", "Tf", "Tr", "d",  "illum", "map_Ka", "map_Ks", "map_Ke", "map_Ns", "map_d",  "disp",
        "decal", "refl", "sharpness", "Km", "Pr", "Pm", "Ps", "Pc", "Pcr",   "aniso",  "anisor", "map_Pr", "map_Pm", "map_Ps", "map_aat"};
    const std::string& key = words[0].text;
    if (key == "newmtl") {
      used_ += line + "\n";
    } else if (key == "Kd") {
      check_colour(words);
      used_ += line + "\n";
    } else if (key == "map_Kd" || key == "map_Bump" || key == "map_bump" || key == "bump" || key == "norm") {
      read_map(line, words);
    } else {
      (ignored.count(key) > 0 ? without_effect_ : unknown_).insert(key);
    }
  }

  void check_colour(const std::vector<Word>& words) {
    const Location where(file_.path, line_);
    bool inside = true;
    for (std::size_t i = 1; i < 4; ++i) {
      if (i >= words.size() || words[i].text[0] == '#') {
        throw Error({"Kd has " + std::to_string(i - 1) + (i == 2 ? " number" : " numbers"), where, "it takes red, green and blue, 0 to 1",
                     "Kd 0.8 0.8 0.8"});
      }
      const std::string& word = words[i].text;
      const auto number = number_of(word);
      if (!number) throw Error({"'" + word + "' is not a number", where, "Kd takes red, green and blue, 0 to 1", "Kd 0.8 0.8 0.8"});
      if (!std::isfinite(*number)) {
        throw Error({"'" + word + "' is not a finite number", where, "Kd takes red, green and blue, 0 to 1", "Kd 0.8 0.8 0.8"});
      }
      inside = inside && *number >= 0 && *number <= 1;
    }
    if (!inside) warn("Kd is clamped to [0, 1]");
  }

  /// Passes the file's name on, and the multiplier of a height map.
  void read_map(const std::string& line, const std::vector<Word>& words) {
    const std::string& key = words[0].text;
    const bool takes_multiplier = key != "map_Kd" && key != "norm";
    std::string multiplier;
    std::size_t at = 1;
    while (at < words.size()) {
      const auto option = options().find(words[at].text);
      if (option == options().end()) break;
      std::vector<std::string> arguments;
      ++at;
      const bool numbers = option->second.arguments == 3;
      while (arguments.size() < option->second.arguments && at < words.size()) {
        if (numbers && (at + 1 == words.size() || !number_of(words[at].text))) break;  // the file's name
        arguments.push_back(words[at++].text);
      }
      if (option->first == "-bm" && takes_multiplier) {
        const auto number = arguments.empty() ? std::nullopt : number_of(arguments[0]);
        if (number && std::abs(*number) <= 1000) {
          multiplier = " -bm " + arguments[0];
        } else {
          multiplier.clear();
          warn(key + " has an unusable -bm, which takes a number from -1000 to 1000; 1 is used");
        }
      } else if (!is_without_effect(option->second, arguments)) {
        std::string given = option->first;
        for (const auto& argument : arguments) given += " " + argument;
        warn("option " + given + " of " + key + " is not supported and ignored");
      }
    }
    if (at < words.size()) {
      used_ += key + multiplier + " " + line.substr(words[at].begin) + "\n";
    } else {
      warn(key + " names no file; it is ignored");
    }
  }

  static bool is_without_effect(const Option& option, const std::vector<std::string>& arguments) {
    if (option.without_effect.empty() || arguments.empty()) return false;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
      const std::string& plain = option.without_effect[std::min(i, option.without_effect.size() - 1)];
      const auto number = number_of(arguments[i]), none = number_of(plain);
      if (none ? !number || *number != *none : arguments[i] != plain) return false;
    }
    return true;
  }

  const FileName& file_;
  std::vector<std::string>& warnings_;
  int line_ = 0;
  std::string used_;
  std::set<std::string> without_effect_, unknown_;
};

}  // namespace

std::string used_material_text(const std::string& text, const FileName& file, std::vector<std::string>& warnings) {
  return MaterialReader(file, warnings).read(text);
}

}  // namespace bump
