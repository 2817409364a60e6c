#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ew/sdk/host.h"

namespace ew::door {

/// A command a plugin has registered.
struct Command {
  std::string name;
  std::string usage;
  sdk::Commands::Run run;
};

/// The host without a window, for the command line and tests: jobs run at once on the calling thread, panels, workspaces, overlays and
/// menus are ignored, nothing is scanned, no case is open, volumes and files go through io, log and sentences through spdlog. What a plugin
/// throws does not get here: PluginList stops it before.
class HeadlessHost final : public sdk::Host {
 public:
  /// @param progress what jobs report to; must outlive the host
  explicit HeadlessHost(Progress& progress = noProgress());
  ~HeadlessHost() override;

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

  /// What is wrong with the sections of a manifest that plugins have made known.
  [[nodiscard]] std::vector<Error> partProblems(const nlohmann::json& manifest) const;

  /// Commands registered so far, in order. A name that is already taken is refused with a warning in the log.
  [[nodiscard]] const std::vector<Command>& registered() const;
  [[nodiscard]] const Command* find(const std::string& name) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace ew::door
