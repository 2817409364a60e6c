#include "ew/door/headless_host.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>

#include "ew/core/elapsed.h"
#include "ew/core/find_entry.h"
#include "ew/door/host_parts.h"
#include "ew/library/case.h"
#include "ew/sdk/case_parts.h"
#include "ew/sdk/overlays.h"
#include "ew/sdk/scan.h"
#include "ew/sdk/window.h"
#include "ew/sdk/workspaces.h"

namespace ew::door {
namespace {

auto noCaseIsOpen() { return failure(ErrorCode::notFound, say<"No case is open; open one in the workstation first.">()); }

class NoOpenCase final : public sdk::Cases {
 public:
  explicit NoOpenCase(const PartSchemas& parts) : parts_(parts) {}
  std::optional<Case> current() const override { return std::nullopt; }
  std::filesystem::path currentFolder() const override { return {}; }
  Result<Case> read(const std::filesystem::path& folderOrManifest) const override { return loadCase(folderOrManifest); }
  std::vector<Error> check(const Case& edited) const override { return parts_.problemsIn(edited, {}); }
  Result<void> edit(const Case&, const std::string&, const std::string&) override { return noCaseIsOpen(); }
  Result<void> save(const std::filesystem::path&) override { return noCaseIsOpen(); }
  bool hasUnsavedChanges() const override { return false; }
  Ticket onChanged(std::function<void()>) override { return nullptr; }

 private:
  const PartSchemas& parts_;
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
  void addStaged(sdk::StagePanel) override {}
};

class NoScan final : public sdk::Scan {
 public:
  [[nodiscard]] std::optional<ScanState> state() const override { return std::nullopt; }
  [[nodiscard]] DisplayImage image() const override { return {}; }
  [[nodiscard]] DisplayGeometry geometry() const override { return {}; }
  [[nodiscard]] Knobs knobs() const override { return {}; }
  [[nodiscard]] double now_s() const override { return secondsSince(begin_); }
  [[nodiscard]] sdk::Ticket onEvent(EventCallback) override { return nullptr; }
  [[nodiscard]] sdk::Ticket drive(std::shared_ptr<const PoseSource>, std::function<void()>) override { return nullptr; }
  Result<void> apply(const Knobs&) override { return nothing(); }
  Result<void> chooseProbe(const std::string&) override { return nothing(); }
  Result<void> setFrozen(bool) override { return nothing(); }
  [[nodiscard]] sdk::Ticket keepSettings() override { return nullptr; }

 private:
  static Result<void> nothing() { return failure(ErrorCode::badUsage, say<"Nothing is scanned; open a case in the workstation first.">()); }
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

class NoWorkspaces final : public sdk::Workspaces {
 public:
  void add(const sdk::Workspace&) override {}
  void show(const std::string&) override {}
  [[nodiscard]] std::string shown() const override { return {}; }
};

template <class Drawing>
class NoOverlay final : public sdk::Overlay<Drawing> {
 public:
  void show(Drawing) override {}
};

class NoOverlays final : public sdk::Overlays {
 public:
  [[nodiscard]] std::shared_ptr<sdk::ScanOverlay> overScan() override { return std::make_shared<NoOverlay<sdk::ScanDrawing>>(); }
  [[nodiscard]] std::shared_ptr<sdk::BodyOverlay> overBody() override { return std::make_shared<NoOverlay<sdk::BodyDrawing>>(); }
};

class PartsWithoutCase final : public sdk::CaseParts {
 public:
  [[nodiscard]] Result<sdk::Ticket> add(const std::string& name, const std::string& schema) override { return schemas->add(name, schema); }
  [[nodiscard]] std::optional<nlohmann::json> read(const std::string&) const override { return std::nullopt; }
  Result<void> edit(const std::string&, const std::optional<nlohmann::json>&, const std::string&, const std::string&) override {
    return noCaseIsOpen();
  }
  [[nodiscard]] std::filesystem::path folderOf(const std::string&) const override { return {}; }
  [[nodiscard]] sdk::Ticket onOpened(OpenCallback) override { return nullptr; }

  std::shared_ptr<PartSchemas> schemas = std::make_shared<PartSchemas>();
};

class SentencesToTheLog final : public sdk::Window {
 public:
  void info(const std::string& sentence, const std::string&) override { spdlog::info("{}", sentence); }
  void warn(const std::string& sentence, const std::string&) override { spdlog::warn("{}", sentence); }
  void error(const std::string& sentence, const std::string&) override { spdlog::error("{}", sentence); }
  [[nodiscard]] sdk::Ticket addEntry(const sdk::MenuEntry&, std::function<void()>) override { return nullptr; }
  [[nodiscard]] sdk::Ticket onClosing(std::function<std::string()>) override { return nullptr; }
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
  PartsWithoutCase caseParts;
  NoOpenCase cases{*caseParts.schemas};
  JobsAtOnce jobs;
  NoPanels panels;
  CommandList commands;
  NoScan scan;
  NoWorkspaces workspaces;
  NoOverlays overlays;
  SentencesToTheLog window;
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
sdk::Scan& HeadlessHost::scan() { return parts_->scan; }
sdk::Workspaces& HeadlessHost::workspaces() { return parts_->workspaces; }
sdk::Overlays& HeadlessHost::overlays() { return parts_->overlays; }
sdk::CaseParts& HeadlessHost::caseParts() { return parts_->caseParts; }
sdk::Window& HeadlessHost::window() { return parts_->window; }
std::vector<Error> HeadlessHost::partProblems(const nlohmann::json& manifest) const {
  return parts_->caseParts.schemas->problems(manifest);
}
sdk::Log& HeadlessHost::log() { return parts_->log; }
const std::vector<Command>& HeadlessHost::registered() const { return parts_->commands.commands; }
const Command* HeadlessHost::find(const std::string& name) const { return entryWith(registered(), &Command::name, name); }

}  // namespace ew::door
