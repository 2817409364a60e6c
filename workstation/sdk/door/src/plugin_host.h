#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ew/door/door.h"
#include "ew/sdk/host.h"
#include "plugin_calls.h"

namespace ew::door {

/// The host as one plugin sees it. It knows what this plugin registered: while the plugin is being made nothing is put into place,
/// everything that the program calls later goes through PluginCalls, and all of it can be taken back.
class PluginHost final : public sdk::Host {
 public:
  /// @param inner the program's host; must outlive this
  PluginHost(sdk::Host& inner, const PluginManifest& plugin, PluginCalls::Tell tell);
  ~PluginHost() override;

  sdk::Volumes& volumes() override;
  sdk::Files& files() override;
  sdk::Cases& cases() override;
  sdk::Jobs& jobs() override;
  sdk::Panels& panels() override;
  sdk::Commands& commands() override;
  sdk::Scan& scan() override;
  sdk::Workspaces& workspaces() override;
  sdk::Overlays& overlays() override;
  sdk::CaseParts& caseParts() override;
  sdk::Window& window() override;
  sdk::Log& log() override;

  [[nodiscard]] PluginCalls& calls() { return *calls_; }
  /// Whether the panel with this id is of this plugin.
  [[nodiscard]] bool hasPanel(const std::string& id) const;

 private:
  struct Parts;
  std::shared_ptr<PluginCalls> calls_;
  sdk::Host& inner_;
  std::unique_ptr<Parts> parts_;
};

}  // namespace ew::door
