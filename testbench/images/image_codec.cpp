#include "testbench/images/image_codec.h"

#include <dlfcn.h>

#include <filesystem>
#include <system_error>

namespace bump {

namespace {

constexpr const char* module_name = "bumpsim_images.so";

/// Beside the program, else where it was built.
std::string module_path() {
  std::error_code ignored;
  const std::filesystem::path beside = std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path() / module_name;
  return std::filesystem::exists(beside, ignored) ? beside.string() : std::string(BUMP_BUILD_DIR "/") + module_name;
}

const ImageCodec& load() {
  const std::string path = module_path();
  const auto fail = [&](const char* why) {
    throw Error(ErrorKind::internal,
                {"cannot load the picture module '" + path + "'", {}, why == nullptr ? "" : why, "build the program again"});
  };
  void* const module = dlopen(path.c_str(), RTLD_LAZY | RTLD_LOCAL);  // stays loaded
  if (module == nullptr) fail(dlerror());
  const auto codec = reinterpret_cast<const ImageCodec* (*)()>(dlsym(module, "bump_image_codec"));
  if (codec == nullptr) fail(dlerror());
  return *codec();
}

}  // namespace

const ImageCodec& image_codec() {
  static const ImageCodec& codec = load();
  return codec;
}

}  // namespace bump
