#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "ew/door/headless_host.h"
#include "ew/door/host_parts.h"
#include "ew/sdk/overlays.h"
#include "ew/sdk/scan.h"
#include "ew/sdk/window.h"
#include "ew/sdk/workspaces.h"
#include "sdk/panel_host.h"

// A host for the hard cases of plugins: it keeps what it is given, and calls back when a test says so.
namespace ew::door::door_test {

using nlohmann::json;

/// Callbacks with tickets.
template <class Call>
class Kept {
 public:
  [[nodiscard]] sdk::Ticket keep(Call call) {
    auto kept = std::make_shared<Call>(std::move(call));
    calls_.push_back(kept);
    return kept;
  }
  /// Those whose ticket is still held.
  [[nodiscard]] std::vector<std::shared_ptr<Call>> all() const {
    std::vector<std::shared_ptr<Call>> held;
    for (const auto& weak : calls_)
      if (auto call = weak.lock()) held.push_back(std::move(call));
    return held;
  }

 private:
  std::vector<std::weak_ptr<Call>> calls_;
};

/// A scan whose images are made when the test says so.
class KeepingScan final : public sdk::Scan {
 public:
  struct Driver {
    std::shared_ptr<const PoseSource> source;
    std::function<void()> takenBack;
  };
  [[nodiscard]] std::optional<ScanState> state() const override { return ScanState{}; }
  [[nodiscard]] DisplayImage image() const override { return {}; }
  [[nodiscard]] DisplayGeometry geometry() const override { return {}; }
  [[nodiscard]] Knobs knobs() const override { return {}; }
  [[nodiscard]] double now_s() const override { return 0.0; }
  [[nodiscard]] sdk::Ticket onEvent(EventCallback callback) override { return events.keep(std::move(callback)); }
  [[nodiscard]] sdk::Ticket drive(std::shared_ptr<const PoseSource> source, std::function<void()> takenBack) override {
    return drivers.keep({std::move(source), std::move(takenBack)});
  }
  Result<void> apply(const Knobs&) override { return {}; }
  Result<void> chooseProbe(const std::string&) override { return {}; }
  Result<void> setFrozen(bool) override { return {}; }
  [[nodiscard]] sdk::Ticket keepSettings() override { return nullptr; }
  void makeFrame() {
    for (const auto& callback : events.all()) (*callback)({0.0, FrameMade{}});
  }

  Kept<EventCallback> events;
  Kept<Driver> drivers;
};

class KeepingWorkspaces final : public sdk::Workspaces {
 public:
  void add(const sdk::Workspace& workspace) override { added.push_back(workspace); }
  void show(const std::string&) override {}
  [[nodiscard]] std::string shown() const override { return "author"; }
  std::vector<sdk::Workspace> added;
};

class KeepingOverlays final : public sdk::Overlays {
 public:
  template <class Drawing>
  struct Shown final : sdk::Overlay<Drawing> {
    void show(Drawing drawing) override { latest = std::move(drawing); }
    Drawing latest;
  };
  [[nodiscard]] std::shared_ptr<sdk::ScanOverlay> overScan() override {
    auto shown = std::make_shared<Shown<sdk::ScanDrawing>>();
    scan.push_back(shown);
    return shown;
  }
  [[nodiscard]] std::shared_ptr<sdk::BodyOverlay> overBody() override {
    auto shown = std::make_shared<Shown<sdk::BodyDrawing>>();
    body.push_back(shown);
    return shown;
  }
  std::vector<std::weak_ptr<Shown<sdk::ScanDrawing>>> scan;
  std::vector<std::weak_ptr<Shown<sdk::BodyDrawing>>> body;
};

class KeepingCaseParts final : public sdk::CaseParts {
 public:
  [[nodiscard]] Result<sdk::Ticket> add(const std::string& name, const std::string& schema) override { return schemas->add(name, schema); }
  [[nodiscard]] std::optional<nlohmann::json> read(const std::string&) const override { return std::nullopt; }
  Result<void> edit(const std::string&, const std::optional<nlohmann::json>&, const std::string&, const std::string&) override {
    return {};
  }
  [[nodiscard]] std::filesystem::path folderOf(const std::string&) const override { return {}; }
  [[nodiscard]] sdk::Ticket onOpened(OpenCallback callback) override { return opened.keep(std::move(callback)); }

  std::shared_ptr<PartSchemas> schemas = std::make_shared<PartSchemas>();
  Kept<OpenCallback> opened;
};

class KeepingWindow final : public sdk::Window {
 public:
  void info(const std::string&, const std::string&) override {}
  void warn(const std::string&, const std::string&) override {}
  void error(const std::string&, const std::string&) override {}
  [[nodiscard]] sdk::Ticket addEntry(const sdk::MenuEntry&, std::function<void()> run) override { return entries.keep(std::move(run)); }
  [[nodiscard]] sdk::Ticket onClosing(std::function<std::string()> unsaved) override { return closing.keep(std::move(unsaved)); }

  Kept<std::function<void()>> entries;
  Kept<std::function<std::string()>> closing;
};

/// A host that keeps what it is given, as a window does, and whose jobs run when they are asked to.
class KeepingHost final : public sdk::Host, public sdk::Panels, public sdk::Jobs, public sdk::Log {
 public:
  struct Job {
    std::string title;
    std::function<Result<void>(Progress&)> work;
    std::function<void(const Result<void>&)> done;
  };

  sdk::Volumes& volumes() override { return inner_.volumes(); }
  sdk::Files& files() override { return inner_.files(); }
  sdk::Cases& cases() override { return theCase; }
  sdk::Jobs& jobs() override { return *this; }
  sdk::Panels& panels() override { return *this; }
  sdk::Commands& commands() override { return inner_.commands(); }
  sdk::Scan& scan() override { return theScan; }
  sdk::Workspaces& workspaces() override { return theWorkspaces; }
  sdk::Overlays& overlays() override { return theOverlays; }
  sdk::CaseParts& caseParts() override { return theParts; }
  sdk::Window& window() override { return theWindow; }
  sdk::Log& log() override { return *this; }

  void addStaged(sdk::StagePanel panel) override {
    if (const auto document = panel.document.lock()) tickets_.push_back(document->onChanged([] {}));
    panelsKept.push_back(std::move(panel));
  }
  void start(const std::string& title, std::function<Result<void>(Progress&)> work,
             std::function<void(const Result<void>&)> done) override {
    jobsKept.push_back({title, std::move(work), std::move(done)});
  }
  void startSaving(const std::string& title, std::function<Result<void>(Progress&)> work,
                   std::function<void(const Result<void>&)> done) override {
    start(title, std::move(work), std::move(done));
    ++savingJobs;
  }
  void info(const std::string&) override {}
  void warn(const std::string&) override {}
  void error(const std::string& text) override { errors.push_back(text); }

  [[nodiscard]] const std::vector<Command>& commandsKept() const { return inner_.registered(); }
  /// The sentences told since the last call.
  [[nodiscard]] std::vector<std::string> told() { return std::exchange(errors, {}); }

  test::OneCase theCase;
  KeepingScan theScan;
  KeepingWorkspaces theWorkspaces;
  KeepingOverlays theOverlays;
  KeepingCaseParts theParts;
  KeepingWindow theWindow;
  std::vector<sdk::StagePanel> panelsKept;
  std::vector<Job> jobsKept;
  int savingJobs = 0;
  std::vector<std::string> errors;

 private:
  HeadlessHost inner_;
  std::vector<std::shared_ptr<void>> tickets_;
};

}  // namespace ew::door::door_test
