#pragma once

#include <cstdint>

#include "ew/sdk/abi.h"
#include "ew/sdk/host.h"

#define EW_EXPORT __attribute__((visibility("default")))

namespace ew::sdk {

/// What a plugin library hands out. Lives as long as the program: plugins are never unloaded.
class Plugin {
 public:
  virtual ~Plugin();
};

}  // namespace ew::sdk

// A plugin library exports three functions:
//   extern "C" EW_EXPORT std::uint32_t ewPluginAbi() { return ew::sdk::kAbi; }
//   extern "C" EW_EXPORT ew::sdk::Plugin* ewPluginCreate(ew::sdk::Host& host) { return new MyPlugin(host); }
//   extern "C" EW_EXPORT void ewPluginDestroy(ew::sdk::Plugin* plugin) { delete plugin; }
