#include <dlfcn.h>

#include <array>
#include <cstdio>
#include <set>
#include <string>
#include <utility>

#include "elf_check.h"
#include "ew/door/door.h"
#include "plugin_host.h"

namespace ew::door {
namespace {

/// "2893710604 (interface ac7b0f, compiler 12)" for a number made as in abi_number.h: people can act on the compiler, and see that the
/// interface is another one.
Message readable(std::uint32_t abi) {
  std::array<char, 8> interface {};
  std::snprintf(interface.data(), interface.size(), "%06x", abi >> 8);
  return say<"%1 (interface %2, compiler %3)">(abi, std::string(interface.data()), abi & 0xffu);
}

void refuse(PluginStatus& status, PluginState state, Message message) {
  status.state = state;
  status.message = std::move(message);
}

Message builtForAnother(const PluginManifest& manifest, std::uint32_t found) {
  return say<
      "The plugin '%1' %2 was built for ABI %3, and this program has ABI %4; install the version of the plugin that belongs to this "
      "EchoWeave, or build it again.">(manifest.title, manifest.version, readable(found), readable(sdk::kAbi));
}

Message linkerMessage() {
  const char* message = ::dlerror();
  return message == nullptr ? say<"no reason given">() : verbatim(message);
}

template <class Function>
Function symbol(void* library, const char* name) {
  return reinterpret_cast<Function>(::dlsym(library, name));
}

/// What a plugin's library exports; only what was found is set.
struct Library {
  std::uint32_t (*abi)() = nullptr;
  sdk::Plugin* (*create)(sdk::Host&) = nullptr;
  void (*destroy)(sdk::Plugin*) = nullptr;
};

/// Loads the library of a manifest whose ABI fits. @error a sentence for the Plugins page
Result<Library> loaded(const PluginManifest& manifest) {
  if (const Message why = whyNotALibrary(manifest.library); !why.empty())
    return failure(ErrorCode::notReadable,
                   say<"The library of the plugin '%1' cannot be loaded: %2; install the plugin again.">(manifest.title, why));
  // RTLD_NODELETE: what a plugin registers with VTK or Qt outlives any handle, and unloading its code crashes the program at its end.
  void* library = ::dlopen(manifest.library.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
  if (library == nullptr)
    return failure(ErrorCode::notReadable,
                   say<"The library of the plugin '%1' cannot be loaded (%2); install the plugin again.">(manifest.title, linkerMessage()));
  Library found;
  found.abi = symbol<std::uint32_t (*)()>(library, "ewPluginAbi");
  found.create = symbol<sdk::Plugin* (*)(sdk::Host&)>(library, "ewPluginCreate");
  found.destroy = symbol<void (*)(sdk::Plugin*)>(library, "ewPluginDestroy");
  for (const auto& [present, name] : {std::pair{found.abi != nullptr, "ewPluginAbi"}, std::pair{found.create != nullptr, "ewPluginCreate"},
                                      std::pair{found.destroy != nullptr, "ewPluginDestroy"}})
    if (!present)
      return failure(ErrorCode::notReadable,
                     say<"The library of the plugin '%1' has no function %2, so it is not an EchoWeave plugin; install "
                         "the plugin again or remove its folder.">(manifest.title, std::string(name)));
  return found;
}

}  // namespace

/// A plugin that was asked to start, with its view of the host. Its library is never unloaded.
struct PluginList::Open {
  Open(sdk::Host& inner, const PluginManifest& manifest, PluginCalls::Tell tell) : host(inner, manifest, std::move(tell)) {}
  ~Open() {
    host.calls().withdraw();
    if (plugin == nullptr) return;
    const auto faultOf = [&](const Thrown& thrown) { return host.calls().faultOf(PluginMoment::end, {}, thrown); };
    static_cast<void>(guarded([&] { destroy(plugin); },
                              [&](const Thrown& thrown) {
                                host.calls().tell(faultOf(thrown));
                                return errorOf(faultOf(thrown));
                              }));
  }
  Open(const Open&) = delete;
  Open& operator=(const Open&) = delete;

  /// Creates the plugin and puts what it registered into place, or takes all of it back. Says in `status` which.
  void start(const Library& library, PluginStatus& status) {
    const auto failed = [&](const Thrown& thrown) { return errorOf(host.calls().faultOf(PluginMoment::start, {}, thrown)); };
    const auto abi = guarded([&] { return library.abi(); }, failed);
    if (!abi) return refuse(status, PluginState::failed, abi.error().message);
    if (*abi != sdk::kAbi) return refuse(status, PluginState::otherAbi, builtForAnother(*status.manifest, *abi));
    const auto made = guarded([&] { return library.create(host); }, failed);
    if (!made || *made == nullptr) {
      host.calls().withdraw();
      return refuse(
          status, PluginState::failed,
          made ? say<"The plugin '%1' could not start and gave no reason; the log may say more.">(status.title()) : made.error().message);
    }
    plugin = *made;
    destroy = library.destroy;
    status.state = PluginState::loaded;
    status.message = {};
    host.calls().made();
  }

  PluginHost host;
  sdk::Plugin* plugin = nullptr;
  void (*destroy)(sdk::Plugin*) = nullptr;
};

PluginList::PluginList(const std::vector<std::filesystem::path>& folders) : states_(discoverPlugins(folders)) {}
PluginList::PluginList(PluginList&&) noexcept = default;

PluginList::~PluginList() {
  while (!open_.empty()) open_.pop_back();  // last opened, first destroyed
}

void PluginList::openAll(sdk::Host& host, const Tell& tell) {
  std::set<std::string> running;
  for (auto& status : states_) {
    if (status.state == PluginState::found && running.contains(status.manifest->name)) {
      refuse(status, PluginState::replaced,
             say<"Another plugin named '%1' was found before this one and is used instead; remove one of them.">(status.manifest->name));
    } else if (status.state == PluginState::found && status.manifest->abi != sdk::kAbi) {
      refuse(status, PluginState::otherAbi, builtForAnother(*status.manifest, status.manifest->abi));
    } else if (status.state == PluginState::found) {
      if (const auto library = loaded(*status.manifest)) {
        // The address stays: the list of states neither grows nor shrinks, and moving it moves none of them.
        open_.push_back(std::make_unique<Open>(host, *status.manifest, [&host, &status, tell](const PluginFault& fault) {
          status.message = messageOf(fault);
          host.log().error(status.sentence());
          if (tell) tell(fault);
        }));
        open_.back()->start(*library, status);
      } else {
        refuse(status, PluginState::notLoadable, library.error().message);
      }
    }
    if (status.state == PluginState::loaded) running.insert(status.manifest->name);
  }
}

bool PluginList::tellOfPanel(const std::string& panelId, const Thrown& thrown) {
  for (const auto& open : open_) {
    if (panelId.empty() || !open->host.hasPanel(panelId)) continue;
    open->host.calls().tell(open->host.calls().faultOf(PluginMoment::event, {}, thrown));
    return true;
  }
  return false;
}

}  // namespace ew::door
