#include "files/own_module.h"

#include <dlfcn.h>

namespace ew::detail {
namespace fs = std::filesystem;

OwnModule openOwnModule(const char* name) {
  std::error_code ignored;
  const fs::path installed = fs::read_symlink("/proc/self/exe", ignored).parent_path() / "../lib/echoweave" / name;
  OwnModule module{fs::exists(installed, ignored) ? installed : fs::path(EW_MODULES) / name};
  module.handle = dlopen(module.file.c_str(), RTLD_NOW | RTLD_LOCAL);
  return module;
}

std::string whyNotOpened() {
  const char* const reason = dlerror();
  return reason == nullptr ? std::string() : std::string(reason);
}

}  // namespace ew::detail
