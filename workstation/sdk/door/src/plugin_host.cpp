#include "plugin_host.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "ew/sdk/case_parts.h"
#include "ew/sdk/overlays.h"
#include "ew/sdk/scan.h"
#include "ew/sdk/window.h"
#include "ew/sdk/workspaces.h"

namespace ew::door {
namespace {

using Calls = std::shared_ptr<PluginCalls>;

/// A document of the plugin as the window sees it: what cannot be asked is empty, the title stays the last one. The plugin keeps the
/// document; once it is gone there is nothing to ask.
class DocumentGuard final : public sdk::PanelDocument {
  template <class Ask>
  auto ask(Ask&& question) const {
    return calls_.call(PluginMoment::document, panel_, [&] {
      const auto inner = inner_.lock();
      return inner ? question(*inner) : decltype(question(*inner))();
    });
  }
  template <class Act>
  void act(PluginMoment moment, Act&& action) {
    static_cast<void>(calls_.call(moment, panel_, [&] {
      if (const auto inner = inner_.lock()) action(*inner);
    }));
  }

 public:
  /// Kept by `calls`, so it holds no share of them.
  DocumentGuard(PluginCalls& calls, std::weak_ptr<sdk::PanelDocument> inner, std::string panel)
      : calls_(calls), inner_(std::move(inner)), panel_(std::move(panel)), title_(panel_) {}

  [[nodiscard]] std::string title() const override {
    if (auto title = ask([](const sdk::PanelDocument& d) { return d.title(); }); title && !inner_.expired()) title_ = std::move(*title);
    return title_;
  }
  [[nodiscard]] std::string remark() const override {
    return ask([](const sdk::PanelDocument& d) { return d.remark(); }).value_or(std::string());
  }
  [[nodiscard]] std::string note() const override {
    return ask([](const sdk::PanelDocument& d) { return d.note(); }).value_or(std::string());
  }
  [[nodiscard]] std::string undoText() const override {
    return ask([](const sdk::PanelDocument& d) { return d.undoText(); }).value_or(std::string());
  }
  [[nodiscard]] std::string redoText() const override {
    return ask([](const sdk::PanelDocument& d) { return d.redoText(); }).value_or(std::string());
  }
  void undo() override {
    act(PluginMoment::undo, [](sdk::PanelDocument& d) { d.undo(); });
  }
  void redo() override {
    act(PluginMoment::redo, [](sdk::PanelDocument& d) { d.redo(); });
  }
  void save(bool elsewhere) override {
    act(PluginMoment::save, [elsewhere](sdk::PanelDocument& d) { d.save(elsewhere); });
  }
  [[nodiscard]] std::string unsaved() const override {
    return calls_
        .call(PluginMoment::closing, panel_,
              [this] {
                const auto inner = inner_.lock();
                return inner ? inner->unsaved() : std::string();
              })
        .value_or(std::string());
  }
  [[nodiscard]] std::shared_ptr<void> onChanged(std::function<void()> callback) override {
    auto ticket = ask([&](sdk::PanelDocument& d) { return d.onChanged(std::move(callback)); });
    return calls_.keepTicket(ticket ? std::move(*ticket) : nullptr);
  }

 private:
  PluginCalls& calls_;
  std::weak_ptr<sdk::PanelDocument> inner_;
  std::string panel_;
  mutable std::string title_;
};

class PluginCases final : public sdk::Cases {
 public:
  PluginCases(Calls calls, sdk::Cases& inner, bool isForPractice)
      : calls_(std::move(calls)), inner_(inner), isForPractice_(isForPractice) {}
  [[nodiscard]] std::optional<Case> current() const override { return inner_.current(); }
  [[nodiscard]] std::optional<Case> forPractice() const override { return isForPractice_ ? inner_.forPractice() : inner_.current(); }
  [[nodiscard]] std::filesystem::path currentFolder() const override { return inner_.currentFolder(); }
  [[nodiscard]] bool isLocked() const override { return inner_.isLocked(); }
  [[nodiscard]] Result<Case> read(const std::filesystem::path& folderOrManifest) const override { return inner_.read(folderOrManifest); }
  [[nodiscard]] std::vector<Error> check(const Case& edited) const override { return inner_.check(edited); }
  Result<void> edit(const Case& edited, const std::string& what, const std::string& mergeKey) override {
    return inner_.edit(edited, what, mergeKey);
  }
  Result<void> save(const std::filesystem::path& folder) override { return inner_.save(folder); }
  Result<void> saveCopy() override { return inner_.saveCopy(); }
  Result<void> makeOwn() override { return inner_.makeOwn(); }
  [[nodiscard]] bool hasUnsavedChanges() const override { return inner_.hasUnsavedChanges(); }
  Result<void> open(const std::filesystem::path& folder) override { return inner_.open(folder); }
  [[nodiscard]] std::optional<Scan> scan() const override { return inner_.scan(); }
  [[nodiscard]] Choices choices() const override { return inner_.choices(); }
  Ticket onChanged(std::function<void()> callback) override {
    return calls_->keepTicket(inner_.onChanged(
        [calls = calls_, callback = std::move(callback)] { static_cast<void>(calls->call(PluginMoment::caseChanged, {}, callback)); }));
  }

 private:
  Calls calls_;
  sdk::Cases& inner_;
  bool isForPractice_;
};

/// What a job of the plugin asks while it works: a plugin that is withdrawn has to stop.
class UntilWithdrawn final : public Progress {
 public:
  UntilWithdrawn(Progress& inner, const PluginCalls& calls) : inner_(inner), calls_(calls) {}
  void report(const Message& what, double fraction) override { inner_.report(what, fraction); }
  [[nodiscard]] bool cancelRequested() const override { return inner_.cancelRequested() || calls_.isWithdrawn(); }

 private:
  Progress& inner_;
  const PluginCalls& calls_;
};

class PluginJobs final : public sdk::Jobs {
 public:
  PluginJobs(Calls calls, sdk::Jobs& inner) : calls_(std::move(calls)), inner_(inner) {}

  void start(const std::string& title, std::function<Result<void>(Progress&)> work,
             std::function<void(const Result<void>&)> done) override {
    startBy(&sdk::Jobs::start, title, std::move(work), std::move(done));
  }
  void startSaving(const std::string& title, std::function<Result<void>(Progress&)> work,
                   std::function<void(const Result<void>&)> done) override {
    startBy(&sdk::Jobs::startSaving, title, std::move(work), std::move(done));
  }

 private:
  using Work = std::function<Result<void>(Progress&)>;
  using Done = std::function<void(const Result<void>&)>;

  void startBy(void (sdk::Jobs::*how)(const std::string&, Work, Done), const std::string& title, Work work, Done done) {
    calls_->whenMade([calls = calls_, &inner = inner_, how, title, work = std::move(work), done = std::move(done)] {
      const auto fault = std::make_shared<std::optional<PluginFault>>();  // told when the work is over, on the window's thread
      (inner.*how)(
          title, [calls, title, work, fault](Progress& progress) { return workOn(*calls, title, work, progress, *fault); },
          [calls, title, done, fault](const Result<void>& outcome) {
            // Too little memory is an outcome that a plugin foresees; anything else is its mistake and told whatever it makes of it.
            if (*fault && !((*fault)->thrown.noMemory && done)) calls->tell(**fault);
            if (done) static_cast<void>(calls->call(PluginMoment::jobDone, title, [&] { done(outcome); }));
          });
    });
  }
  static Result<void> workOn(PluginCalls& calls, const std::string& title, const std::function<Result<void>(Progress&)>& work,
                             Progress& progress, std::optional<PluginFault>& fault) {
    const PluginCalls::Working working(calls);
    if (!working.mayBegin()) return failure(ErrorCode::cancelled, say<"The plugin of this work is not running any more.">());
    UntilWithdrawn watched(progress, calls);
    return guarded([&] { return work(watched); },
                   [&](const Thrown& thrown) { return errorOf(fault.emplace(calls.faultOf(PluginMoment::job, title, thrown))); });
  }

  Calls calls_;
  sdk::Jobs& inner_;
};

class PluginPanels final : public sdk::Panels {
 public:
  PluginPanels(Calls calls, sdk::Panels& inner) : calls_(std::move(calls)), inner_(inner) {}

  void addStaged(sdk::StagePanel panel) override {
    ids_.push_back(panel.id);
    panel.make = guardedMake(panel.title, std::move(panel.make));
    panel.makeStage = guardedMake(panel.title, std::move(panel.makeStage));
    if (!panel.document.expired()) {
      const auto document = std::make_shared<DocumentGuard>(*calls_, panel.document, panel.title);
      calls_->keepDocument(document);
      panel.document = document;
    }
    calls_->whenMade([this, panel = std::move(panel)] { inner_.addStaged(panel); });
  }
  void setShown(const std::string& id, bool shown) override {
    if (has(id)) calls_->whenMade([this, id, shown] { inner_.setShown(id, shown); });
  }
  void bringToFront(const std::string& id) override {
    calls_->whenMade([this, id] { inner_.bringToFront(id); });
  }
  [[nodiscard]] bool has(const std::string& id) const { return std::find(ids_.begin(), ids_.end(), id) != ids_.end(); }

 private:
  /// Nothing stays nothing: a panel without a stage has none.
  [[nodiscard]] sdk::StagePanel::Make guardedMake(const std::string& title, sdk::StagePanel::Make make) const {
    if (!make) return {};
    return [calls = calls_, title, make = std::move(make)](QWidget* parent) -> QWidget* {
      return calls->call(PluginMoment::panel, title, [&] { return make(parent); }).value_or(nullptr);
    };
  }

  Calls calls_;
  sdk::Panels& inner_;
  std::vector<std::string> ids_;
};

class PluginCommands final : public sdk::Commands {
 public:
  PluginCommands(Calls calls, sdk::Commands& inner) : calls_(std::move(calls)), inner_(inner) {}

  void add(const std::string& name, const std::string& usage, Run run) override {
    calls_->whenMade([this, name, usage, run = std::move(run)] {
      inner_.add(name, usage, [calls = calls_, name, run](const std::vector<std::string>& args, Progress& progress) {
        auto outcome = calls->callForError(PluginMoment::command, name, [&] { return run(args, progress); });
        if (outcome && outcome->putInPlace)
          outcome->putInPlace = [calls, name, put = std::move(outcome->putInPlace)] {
            return calls->callForError(PluginMoment::command, name, put);
          };
        return outcome;
      });
    });
  }

 private:
  Calls calls_;
  sdk::Commands& inner_;
};

/// Where the plugin says the probe is. When it cannot say, the probe stays where it was.
class PoseGuard final : public PoseSource {
 public:
  PoseGuard(Calls calls, std::shared_ptr<const PoseSource> inner) : calls_(std::move(calls)), inner_(std::move(inner)) {}
  [[nodiscard]] Pose poseAt(double time_s) const override {
    if (isLost_) return last_;
    auto pose = calls_->call(PluginMoment::drive, {}, [&] { return inner_->poseAt(time_s); });
    if (pose)
      last_ = *pose;
    else
      isLost_ = true;
    return last_;
  }
  [[nodiscard]] bool movesAfter(double time_s) const override {
    if (isLost_) return false;
    const auto moves = calls_->call(PluginMoment::drive, {}, [&] { return inner_->movesAfter(time_s); });
    isLost_ = !moves;
    return moves.value_or(false);
  }

 private:
  Calls calls_;
  std::shared_ptr<const PoseSource> inner_;
  mutable Pose last_{.probeToWorld = {}, .status = PoseStatus::missing};
  mutable bool isLost_ = false;
};

class PluginScan final : public sdk::Scan {
 public:
  PluginScan(Calls calls, sdk::Scan& inner) : calls_(std::move(calls)), inner_(inner) {}
  [[nodiscard]] std::optional<ScanState> state() const override { return inner_.state(); }
  [[nodiscard]] DisplayImage image() const override { return inner_.image(); }
  [[nodiscard]] DisplayGeometry geometry() const override { return inner_.geometry(); }
  [[nodiscard]] Knobs knobs() const override { return inner_.knobs(); }
  [[nodiscard]] double now_s() const override { return inner_.now_s(); }
  [[nodiscard]] sdk::Ticket onEvent(EventCallback callback) override {
    return calls_->keepTicket(inner_.onEvent([calls = calls_, callback = std::move(callback)](const ScanEvent& event) {
      static_cast<void>(calls->call(PluginMoment::scan, {}, [&] { callback(event); }));
    }));
  }
  [[nodiscard]] sdk::Ticket drive(std::shared_ptr<const PoseSource> source, std::function<void()> takenBack) override {
    if (source == nullptr) return nullptr;
    auto told = [calls = calls_, takenBack = std::move(takenBack)] {
      if (takenBack) static_cast<void>(calls->call(PluginMoment::drive, {}, takenBack));
    };
    return calls_->keepTicket(inner_.drive(std::make_shared<PoseGuard>(calls_, std::move(source)), std::move(told)));
  }
  Result<void> placeProbe(const Transform<frame::World, frame::Probe>& probeToWorld) override { return inner_.placeProbe(probeToWorld); }
  Result<void> apply(const Knobs& knobs) override { return inner_.apply(knobs); }
  Result<void> chooseProbe(const std::string& id) override { return inner_.chooseProbe(id); }
  Result<void> setFrozen(bool frozen) override { return inner_.setFrozen(frozen); }
  [[nodiscard]] std::optional<sdk::Scanned> scanned() const override { return inner_.scanned(); }
  [[nodiscard]] std::vector<sdk::ScanMeasurement> measurements() const override { return inner_.measurements(); }
  [[nodiscard]] sdk::Ticket onMeasured(std::function<void()> callback) override {
    return calls_->keepTicket(inner_.onMeasured(
        [calls = calls_, callback = std::move(callback)] { static_cast<void>(calls->call(PluginMoment::scan, {}, callback)); }));
  }
  [[nodiscard]] sdk::Ticket askForPoint(const std::string& hint, std::function<void(const Point<frame::Probe>&)> pointed,
                                        std::function<void()> stopped) override {
    return calls_->keepTicket(inner_.askForPoint(
        hint,
        [calls = calls_, pointed = std::move(pointed)](const Point<frame::Probe>& at) {
          static_cast<void>(calls->call(PluginMoment::scan, {}, [&] { pointed(at); }));
        },
        [calls = calls_, stopped = std::move(stopped)] {
          if (stopped) static_cast<void>(calls->call(PluginMoment::scan, {}, stopped));
        }));
  }
  [[nodiscard]] sdk::Ticket askForStroke(sdk::StrokeRequest request) override {
    for (auto* each : {&request.begun, &request.moved, &request.ended})
      *each = [calls = calls_, told = std::move(*each)](const Point<frame::Probe>& at) {
        if (told) static_cast<void>(calls->call(PluginMoment::scan, {}, [&] { told(at); }));
      };
    request.stopped = [calls = calls_, stopped = std::move(request.stopped)] {
      if (stopped) static_cast<void>(calls->call(PluginMoment::scan, {}, stopped));
    };
    return calls_->keepTicket(inner_.askForStroke(std::move(request)));
  }
  [[nodiscard]] Result<void> showLabels(std::optional<Volume> labels) override { return inner_.showLabels(std::move(labels)); }
  [[nodiscard]] sdk::Ticket keepSettings() override { return calls_->keepTicket(inner_.keepSettings()); }

 private:
  Calls calls_;
  sdk::Scan& inner_;
};

class PluginWorkspaces final : public sdk::Workspaces {
 public:
  PluginWorkspaces(Calls calls, sdk::Workspaces& inner) : calls_(std::move(calls)), inner_(inner) {}
  void add(const sdk::Workspace& workspace) override {
    calls_->whenMade([this, workspace] { inner_.add(workspace); });
  }
  void show(const std::string& id) override {
    calls_->whenMade([this, id] { inner_.show(id); });
  }
  [[nodiscard]] std::string shown() const override { return inner_.shown(); }

 private:
  Calls calls_;
  sdk::Workspaces& inner_;
};

/// A drawing that goes when the plugin is withdrawn, although the plugin still holds it.
template <class Drawing>
class OverlayProxy final : public sdk::Overlay<Drawing> {
 public:
  OverlayProxy(PluginCalls& calls, const std::shared_ptr<sdk::Overlay<Drawing>>& inner) : inner_(inner), ticket_(calls.keepTicket(inner)) {}
  void show(Drawing drawing) override {
    if (const auto inner = inner_.lock()) inner->show(std::move(drawing));
  }

 private:
  std::weak_ptr<sdk::Overlay<Drawing>> inner_;
  sdk::Ticket ticket_;
};

class PluginOverlays final : public sdk::Overlays {
 public:
  PluginOverlays(Calls calls, sdk::Overlays& inner) : calls_(std::move(calls)), inner_(inner) {}
  [[nodiscard]] std::shared_ptr<sdk::ScanOverlay> overScan() override {
    return std::make_shared<OverlayProxy<sdk::ScanDrawing>>(*calls_, inner_.overScan());
  }
  [[nodiscard]] std::shared_ptr<sdk::BodyOverlay> overBody() override {
    return std::make_shared<OverlayProxy<sdk::BodyDrawing>>(*calls_, inner_.overBody());
  }
  [[nodiscard]] sdk::Ticket showInBody(const sdk::BodyAids& aids) override { return calls_->keepTicket(inner_.showInBody(aids)); }
  [[nodiscard]] std::shared_ptr<sdk::HandlesOverlay> showHandles(const sdk::BodyHandles& handles, sdk::HandlesMoved moved) override {
    return std::make_shared<OverlayProxy<sdk::BodyHandles>>(
        *calls_, inner_.showHandles(handles, [calls = calls_, moved = std::move(moved)](const auto& toWorld, bool isOver) {
          static_cast<void>(calls->call(PluginMoment::event, {}, [&] { moved(toWorld, isOver); }));
        }));
  }
  [[nodiscard]] sdk::Ticket askForBodyPoint(const std::string& hint, std::function<void(const Point<frame::World>&)> pointed,
                                            std::function<void()> stopped) override {
    return calls_->keepTicket(inner_.askForBodyPoint(
        hint,
        [calls = calls_, pointed = std::move(pointed)](const Point<frame::World>& at) {
          static_cast<void>(calls->call(PluginMoment::event, {}, [&] { pointed(at); }));
        },
        [calls = calls_, stopped = std::move(stopped)] {
          if (stopped) static_cast<void>(calls->call(PluginMoment::event, {}, stopped));
        }));
  }

 private:
  Calls calls_;
  sdk::Overlays& inner_;
};

class PluginCaseParts final : public sdk::CaseParts {
 public:
  PluginCaseParts(Calls calls, sdk::CaseParts& inner) : calls_(std::move(calls)), inner_(inner) {}
  [[nodiscard]] Result<sdk::Ticket> add(const std::string& name, const std::string& schema) override {
    auto ticket = inner_.add(name, schema);
    if (!ticket) return ticket;
    return calls_->keepTicket(std::move(*ticket));
  }
  [[nodiscard]] std::optional<nlohmann::json> read(const std::string& name) const override { return inner_.read(name); }
  Result<void> edit(const std::string& name, const std::optional<nlohmann::json>& section, const std::string& what,
                    const std::string& mergeKey) override {
    return inner_.edit(name, section, what, mergeKey);
  }
  [[nodiscard]] std::filesystem::path folderOf(const std::string& name) const override { return inner_.folderOf(name); }
  [[nodiscard]] sdk::Ticket onOpened(OpenCallback callback) override {
    return calls_->keepTicket(inner_.onOpened([calls = calls_, callback = std::move(callback)](const std::filesystem::path& folder) {
      static_cast<void>(calls->call(PluginMoment::caseChanged, {}, [&] { callback(folder); }));
    }));
  }
  [[nodiscard]] sdk::Ticket onAsked(const std::string& name, AskCallback callback) override {
    return calls_->keepTicket(inner_.onAsked(name, [calls = calls_, callback = std::move(callback)](const std::string& item) {
      static_cast<void>(calls->call(PluginMoment::caseChanged, {}, [&] { callback(item); }));
    }));
  }

 private:
  Calls calls_;
  sdk::CaseParts& inner_;
};

class PluginWindow final : public sdk::Window {
 public:
  PluginWindow(Calls calls, sdk::Window& inner) : calls_(std::move(calls)), inner_(inner) {}
  void info(const std::string& sentence, const std::string& topic) override { inner_.info(sentence, topic); }
  void warn(const std::string& sentence, const std::string& topic) override { inner_.warn(sentence, topic); }
  void error(const std::string& sentence, const std::string& topic) override { inner_.error(sentence, topic); }
  [[nodiscard]] sdk::Ticket addEntry(const sdk::MenuEntry& entry, std::function<void()> run) override {
    return calls_->keepTicket(inner_.addEntry(entry, [calls = calls_, title = withoutMark(entry.title), run = std::move(run)] {
      static_cast<void>(calls->call(PluginMoment::menu, title, run));
    }));
  }
  [[nodiscard]] sdk::Ticket onClosing(std::function<std::string()> unsaved) override {
    return calls_->keepTicket(inner_.onClosing([calls = calls_, unsaved = std::move(unsaved)] {
      return calls->call(PluginMoment::closing, {}, unsaved).value_or(std::string());
    }));
  }
  [[nodiscard]] sdk::Ticket holdUnsaved(sdk::UnsavedWork work) override {
    sdk::UnsavedWork guarded = work;
    guarded.sentence = [calls = calls_, sentence = std::move(work.sentence)] {
      return calls->call(PluginMoment::closing, {}, sentence).value_or(std::string());
    };
    if (work.save)
      guarded.save = [calls = calls_, save = std::move(work.save)] { return calls->call(PluginMoment::save, {}, save).value_or(false); };
    return calls_->keepTicket(inner_.holdUnsaved(std::move(guarded)));
  }
  [[nodiscard]] std::optional<std::filesystem::path> askSaveFile(const sdk::SaveFile& asked) override {
    using Paths = std::vector<std::filesystem::path>;
    sdk::SaveFile guarded = asked;
    if (asked.written)
      guarded.written = [this, &asked](const std::filesystem::path& file) {
        return calls_->call(PluginMoment::save, {}, [&] { return asked.written(file); }).value_or(Paths{file});
      };
    // What cannot say whether it may go stays.
    if (asked.whyKept)
      guarded.whyKept = [this, &asked](const std::filesystem::path& file) {
        return calls_->call(PluginMoment::save, {}, [&] { return asked.whyKept(file); }).value_or(file.filename().string());
      };
    return inner_.askSaveFile(guarded);
  }

 private:
  static std::string withoutMark(std::string title) {
    std::erase(title, '&');
    return title;
  }
  Calls calls_;
  sdk::Window& inner_;
};

bool isForPractice(const PluginManifest& plugin) {
  return std::find(plugin.capabilities.begin(), plugin.capabilities.end(), "practice") != plugin.capabilities.end();
}

}  // namespace

struct PluginHost::Parts {
  Parts(const Calls& calls, sdk::Host& inner, bool isForPractice)
      : cases(calls, inner.cases(), isForPractice),
        jobs(calls, inner.jobs()),
        panels(calls, inner.panels()),
        commands(calls, inner.commands()),
        scan(calls, inner.scan()),
        workspaces(calls, inner.workspaces()),
        overlays(calls, inner.overlays()),
        caseParts(calls, inner.caseParts()),
        window(calls, inner.window()) {}
  PluginCases cases;
  PluginJobs jobs;
  PluginPanels panels;
  PluginCommands commands;
  PluginScan scan;
  PluginWorkspaces workspaces;
  PluginOverlays overlays;
  PluginCaseParts caseParts;
  PluginWindow window;
};

PluginHost::PluginHost(sdk::Host& inner, const PluginManifest& plugin, PluginCalls::Tell tell)
    : calls_(std::make_shared<PluginCalls>(plugin.title, std::move(tell))),
      inner_(inner),
      parts_(std::make_unique<Parts>(calls_, inner, isForPractice(plugin))) {}
PluginHost::~PluginHost() = default;

sdk::Volumes& PluginHost::volumes() { return inner_.volumes(); }
sdk::Files& PluginHost::files() { return inner_.files(); }
sdk::Cases& PluginHost::cases() { return parts_->cases; }
sdk::Jobs& PluginHost::jobs() { return parts_->jobs; }
sdk::Panels& PluginHost::panels() { return parts_->panels; }
sdk::Commands& PluginHost::commands() { return parts_->commands; }
sdk::Scan& PluginHost::scan() { return parts_->scan; }
sdk::Workspaces& PluginHost::workspaces() { return parts_->workspaces; }
sdk::Overlays& PluginHost::overlays() { return parts_->overlays; }
sdk::CaseParts& PluginHost::caseParts() { return parts_->caseParts; }
sdk::Window& PluginHost::window() { return parts_->window; }
sdk::Log& PluginHost::log() { return inner_.log(); }
bool PluginHost::hasPanel(const std::string& id) const { return parts_->panels.has(id); }

}  // namespace ew::door
