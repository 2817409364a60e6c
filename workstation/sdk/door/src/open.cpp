#include <dlfcn.h>

#include <exception>
#include <set>
#include <string>

#include "elf_check.h"
#include "ew/door/door.h"

namespace ew::door {
namespace {

/// "interface 2, GCC 12" for a number made as in ew/sdk/abi.h: people can act on that, not on 134161.
std::string readable(std::uint32_t abi) {
  return std::to_string(abi) + " (interface " + std::to_string(abi >> 16) + ", compiler " + std::to_string((abi >> 8) & 0xffu) + ")";
}

std::optional<OpenPlugin> refuse(PluginStatus& status, PluginState state, std::string sentence) {
  status.state = state;
  status.sentence = std::move(sentence);
  return std::nullopt;
}

std::string otherAbiSentence(const PluginManifest& manifest, std::uint32_t found) {
  return "The plugin '" + manifest.title + "' " + manifest.version + " was built for ABI " + readable(found) +
         ", and this program has ABI " + readable(sdk::kAbi) +
         "; install the version of the plugin that belongs to this EchoWeave, or build it again.";
}

std::string linkerMessage() {
  const char* message = ::dlerror();
  return message == nullptr ? "no reason given" : message;
}

template <class Function>
Function symbol(void* library, const char* name) {
  return reinterpret_cast<Function>(::dlsym(library, name));
}

}  // namespace

OpenPlugin::~OpenPlugin() {
  if (plugin_ == nullptr) return;
  try {
    destroy_(plugin_);
  } catch (...) {
    // A plugin that throws while it is destroyed has nobody left to tell; the program must still end in order.
  }
}

std::optional<OpenPlugin> openPlugin(PluginStatus& status, sdk::Host& host) {
  if (status.state != PluginState::found || !status.manifest) {
    if (status.sentence.empty()) {
      status.state = PluginState::badManifest;
      status.sentence = "The plugin in '" + status.folder.string() + "' has no manifest that could be read; install it again.";
    }
    return std::nullopt;
  }
  const PluginManifest& manifest = *status.manifest;
  if (manifest.abi != sdk::kAbi) return refuse(status, PluginState::otherAbi, otherAbiSentence(manifest, manifest.abi));

  if (const std::string why = whyNotALibrary(manifest.library); !why.empty())
    return refuse(status, PluginState::notLoadable,
                  "The library of the plugin '" + manifest.title + "' cannot be loaded: " + why + "; install the plugin again.");

  // RTLD_NODELETE: what a plugin registers with VTK or Qt outlives any handle, and unloading its code crashes the program at its end.
  void* library = ::dlopen(manifest.library.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
  if (library == nullptr)
    return refuse(
        status, PluginState::notLoadable,
        "The library of the plugin '" + manifest.title + "' cannot be loaded (" + linkerMessage() + "); install the plugin again.");

  const auto abi = symbol<std::uint32_t (*)()>(library, "ewPluginAbi");
  const auto create = symbol<sdk::Plugin* (*)(sdk::Host&)>(library, "ewPluginCreate");
  const auto destroy = symbol<void (*)(sdk::Plugin*)>(library, "ewPluginDestroy");
  for (const auto& [present, name] : {std::pair{abi != nullptr, "ewPluginAbi"}, std::pair{create != nullptr, "ewPluginCreate"},
                                      std::pair{destroy != nullptr, "ewPluginDestroy"}})
    if (!present)
      return refuse(status, PluginState::notLoadable,
                    "The library of the plugin '" + manifest.title + "' has no function " + name +
                        ", so it is not an EchoWeave plugin; install the plugin again or remove its folder.");
  try {
    const std::uint32_t found = abi();
    if (found != sdk::kAbi) return refuse(status, PluginState::otherAbi, otherAbiSentence(manifest, found));
    sdk::Plugin* plugin = create(host);
    if (plugin == nullptr)
      return refuse(status, PluginState::failed,
                    "The plugin '" + manifest.title + "' could not start and gave no reason; the log may say more.");
    status.state = PluginState::loaded;
    status.sentence.clear();
    return OpenPlugin(plugin, destroy);
  } catch (const std::exception& problem) {
    return refuse(status, PluginState::failed,
                  "The plugin '" + manifest.title + "' could not start (" + problem.what() + "); the rest of the program is not affected.");
  } catch (...) {
    return refuse(status, PluginState::failed,
                  "The plugin '" + manifest.title + "' could not start; the rest of the program is not affected.");
  }
}

PluginList::PluginList(const std::vector<std::filesystem::path>& folders) : states_(discoverPlugins(folders)) {}

PluginList::~PluginList() {
  while (!open_.empty()) open_.pop_back();  // last opened, first destroyed
}

void PluginList::openAll(sdk::Host& host) {
  std::set<std::string> running;
  for (auto& status : states_) {
    if (status.state == PluginState::found && running.contains(status.manifest->name)) {
      status.state = PluginState::replaced;
      status.sentence =
          "Another plugin named '" + status.manifest->name + "' was found before this one and is used instead; remove one of them.";
    } else if (status.state == PluginState::found) {
      if (auto opened = openPlugin(status, host)) open_.push_back(std::move(*opened));
    }
    if (status.state == PluginState::loaded) running.insert(status.manifest->name);
  }
}

}  // namespace ew::door
