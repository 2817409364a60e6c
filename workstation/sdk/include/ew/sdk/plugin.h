#pragma once

#include <cstdint>

#include "ew/sdk/host.h"

#define EW_EXPORT __attribute__((visibility("default")))

namespace ew::sdk {

/// Changes with the headers of sdk/ and core/. The door compares the full number below before it calls anything else.
inline constexpr std::uint32_t kInterfaceVersion = 1;

/// Interface version, compiler generation and standard library ABI folded into one number: what must agree for C++ values to cross.
inline constexpr std::uint32_t kAbi = (kInterfaceVersion << 16) | (static_cast<std::uint32_t>(__GNUC__) << 8) |
                                      (static_cast<std::uint32_t>(_GLIBCXX_USE_CXX11_ABI) << 4) | 0x1u;

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
