#include "ew/door/headless_host.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "ew/door/host_parts.h"
#include "ew/library/case.h"

namespace ew::door {
namespace {

class NoOpenCase final : public sdk::Cases {
 public:
  std::optional<nlohmann::json> current() const override { return std::nullopt; }
  std::filesystem::path currentFolder() const override { return {}; }
  std::vector<Error> check(const nlohmann::json& manifest) const override { return checkManifest(manifest, {}); }
  Result<void> edit(const nlohmann::json&, const std::string&, const std::string&) override { return noCase(); }
  Result<void> save(const std::filesystem::path&) override { return noCase(); }
  bool hasUnsavedChanges() const override { return false; }
  Ticket onChanged(std::function<void()>) override { return nullptr; }

 private:
  static Result<void> noCase() { return failure(ErrorCode::notFound, "No case is open; open one in the workstation first."); }
};

class JobsAtOnce final : public sdk::Jobs {
 public:
  explicit JobsAtOnce(Progress& progress) : progress_(progress) {}
  void start(const std::string&, std::function<Result<void>(Progress&)> work, std::function<void(const Result<void>&)> done) override {
    const Result<void> outcome = work(progress_);
    if (done) done(outcome);
  }

 private:
  Progress& progress_;
};

class NoPanels final : public sdk::Panels {
 public:
  void add(const std::string&, const std::string&, std::function<QWidget*(QWidget*)>) override {}
};

class CommandList final : public sdk::Commands {
 public:
  void add(const std::string& name, const std::string& usage, Run run) override {
    if (std::any_of(commands.begin(), commands.end(), [&](const Command& c) { return c.name == name; })) {
      spdlog::warn("A plugin offers the command '{}', which another plugin already gave; the first one is kept.", name);
      return;
    }
    commands.push_back({name, usage, std::move(run)});
  }
  std::vector<Command> commands;
};

}  // namespace

struct HeadlessHost::Parts {
  explicit Parts(Progress& progress) : jobs(progress) {}
  FileVolumes volumes;
  TextFiles files;
  NoOpenCase cases;
  JobsAtOnce jobs;
  NoPanels panels;
  CommandList commands;
  ProgramLog log;
};

HeadlessHost::HeadlessHost(Progress& progress) : parts_(std::make_unique<Parts>(progress)) {}
HeadlessHost::~HeadlessHost() = default;
sdk::Volumes& HeadlessHost::volumes() { return parts_->volumes; }
sdk::Files& HeadlessHost::files() { return parts_->files; }
sdk::Cases& HeadlessHost::cases() { return parts_->cases; }
sdk::Jobs& HeadlessHost::jobs() { return parts_->jobs; }
sdk::Panels& HeadlessHost::panels() { return parts_->panels; }
sdk::Commands& HeadlessHost::commands() { return parts_->commands; }
sdk::Log& HeadlessHost::log() { return parts_->log; }
const std::vector<Command>& HeadlessHost::registered() const { return parts_->commands.commands; }
const Command* HeadlessHost::find(const std::string& name) const {
  const auto at = std::find_if(registered().begin(), registered().end(), [&](const Command& c) { return c.name == name; });
  return at == registered().end() ? nullptr : &*at;
}

}  // namespace ew::door
