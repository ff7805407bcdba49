#include "schemes/scheme.h"

#include <map>

namespace bump {

namespace {

std::map<std::string, std::unique_ptr<Scheme>>& registry() {
  static std::map<std::string, std::unique_ptr<Scheme>> schemes;
  return schemes;
}

}  // namespace

bool register_scheme(std::unique_ptr<Scheme> scheme) {
  const std::string id = scheme->page().id;
  return registry().emplace(id, std::move(scheme)).second;
}

std::vector<const Scheme*> all_schemes() {
  std::vector<const Scheme*> schemes;
  for (const auto& [id, scheme] : registry()) schemes.push_back(scheme.get());
  return schemes;
}

const Scheme& find_scheme(const std::string& id) {
  const auto found = registry().find(id);
  if (found != registry().end()) return *found->second;
  std::vector<std::string> ids;
  std::string list;
  for (const auto& [known, scheme] : registry()) {
    ids.push_back(known);
    list += (list.empty() ? "" : ", ") + known;
  }
  const std::string near = nearest_word(id, ids);
  throw Error({"unknown scheme '" + id + "'", {}, "the schemes are: " + list, near.empty() ? "bumpsim list schemes" : "--scheme " + near});
}

}  // namespace bump
