#include "testbench/cosimulation/unit_library.h"

#include <dlfcn.h>

#include <filesystem>

#include "datapath/error.h"

namespace bump {

namespace {

std::filesystem::path library_of(const std::string& folder, const std::string& unit) {
  return std::filesystem::absolute(folder) / (unit + ".so");
}

}  // namespace

std::vector<std::string> units_in(const std::string& folder) {
  std::vector<std::string> units;
  for (const char* unit : {"environment", "illumination"})
    if (std::filesystem::exists(library_of(folder, unit))) units.push_back(unit);
  if (units.empty())
    throw Error({"there is no translated unit",
                 {folder},
                 "neither environment.so nor illumination.so is there",
                 "scripts/cosimulate.sh builds them"});
  return units;
}

std::unique_ptr<RtlPins> load_unit(const std::string& folder, const std::string& unit) {
  const std::string path = library_of(folder, unit).string();
  const auto fail = [&] {
    const char* reason = ::dlerror();
    throw Error(
        {"cannot load the translated " + unit + " unit", {path}, reason != nullptr ? reason : "", "build it with scripts/cosimulate.sh"});
  };
  void* library = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) fail();
  const auto make = reinterpret_cast<MakeRtlPins>(::dlsym(library, "bump_make_rtl_pins"));
  if (make == nullptr) fail();
  std::unique_ptr<RtlPins> pins;
  make(pins);
  return pins;
}

}  // namespace bump
