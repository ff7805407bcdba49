#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "schemes/scheme.h"
#include "testbench/program/commands.h"
#include "testbench/program/shipped_scenes.h"

namespace bump {

int list_command(const ListArguments& arguments) {
  const bool schemes = arguments.what != "scenes";
  const bool scenes = arguments.what != "schemes";
  if (arguments.json) {
    nlohmann::ordered_json document;
    if (schemes) {
      document["schemes"] = nlohmann::ordered_json::array();
      for (const Scheme* scheme : all_schemes()) {
        const SchemePage& page = scheme->page();
        document["schemes"].push_back({{"id", page.id}, {"title", page.title}, {"source", page.source}, {"provenance", page.provenance}});
      }
    }
    if (scenes) {
      document["scenes"] = nlohmann::ordered_json::array();
      for (const ShippedScene& scene : shipped_scenes()) document["scenes"].push_back({{"name", scene.name}, {"title", scene.title}});
    }
    fmt::print("{}\n", document.dump(2));
    return 0;
  }
  if (schemes) {
    fmt::print("schemes\n");
    for (const Scheme* scheme : all_schemes()) fmt::print("  {:<18} {} ({})\n", scheme->page().id, scheme->page().title, scheme->page().provenance);
  }
  if (scenes) {
    fmt::print("scenes\n");
    for (const ShippedScene& scene : shipped_scenes()) fmt::print("  {:<18} {}\n", scene.name, scene.title);
  }
  return 0;
}

}  // namespace bump
