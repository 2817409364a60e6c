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

/// The host without a window, for the command line and tests: jobs run at once on the calling thread, panels are ignored, no case is open,
/// volumes and files go through io, the log through spdlog. What a plugin throws does not get here: PluginList stops it before.
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
  sdk::Log& log() override;

  /// Commands registered so far, in order. A name that is already taken is refused with a warning in the log.
  [[nodiscard]] const std::vector<Command>& registered() const;
  [[nodiscard]] const Command* find(const std::string& name) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace ew::door
