#include "plugin_host.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

namespace ew::door {
namespace {

using Calls = std::shared_ptr<PluginCalls>;

/// A document of the plugin as the window sees it: what cannot be asked is empty, the title stays the last one.
class GuardedDocument final : public sdk::PanelDocument {
  template <class Ask>
  auto ask(Ask&& question) const {
    return calls_.call(PluginMoment::document, panel_, std::forward<Ask>(question));
  }

 public:
  /// Kept by `calls`, so it holds no share of them.
  GuardedDocument(PluginCalls& calls, sdk::PanelDocument& inner, std::string panel)
      : calls_(calls), inner_(inner), panel_(std::move(panel)), title_(panel_) {}

  [[nodiscard]] std::string title() const override {
    if (auto title = ask([this] { return inner_.title(); })) title_ = std::move(*title);
    return title_;
  }
  [[nodiscard]] std::string remark() const override {
    return ask([this] { return inner_.remark(); }).value_or(std::string());
  }
  [[nodiscard]] std::string note() const override {
    return ask([this] { return inner_.note(); }).value_or(std::string());
  }
  [[nodiscard]] std::string undoText() const override {
    return ask([this] { return inner_.undoText(); }).value_or(std::string());
  }
  [[nodiscard]] std::string redoText() const override {
    return ask([this] { return inner_.redoText(); }).value_or(std::string());
  }
  void undo() override {
    static_cast<void>(calls_.call(PluginMoment::undo, panel_, [this] { inner_.undo(); }));
  }
  void redo() override {
    static_cast<void>(calls_.call(PluginMoment::redo, panel_, [this] { inner_.redo(); }));
  }
  void save(bool elsewhere) override {
    static_cast<void>(calls_.call(PluginMoment::save, panel_, [this, elsewhere] { inner_.save(elsewhere); }));
  }
  [[nodiscard]] std::shared_ptr<void> onChanged(std::function<void()> callback) override {
    auto ticket = ask([&] { return inner_.onChanged(std::move(callback)); });
    return calls_.keepTicket(ticket ? std::move(*ticket) : nullptr);
  }

 private:
  PluginCalls& calls_;
  sdk::PanelDocument& inner_;
  std::string panel_;
  mutable std::string title_;
};

class PluginCases final : public sdk::Cases {
 public:
  PluginCases(Calls calls, sdk::Cases& inner) : calls_(std::move(calls)), inner_(inner) {}
  [[nodiscard]] std::optional<nlohmann::json> current() const override { return inner_.current(); }
  [[nodiscard]] std::filesystem::path currentFolder() const override { return inner_.currentFolder(); }
  [[nodiscard]] std::vector<Error> check(const nlohmann::json& manifest) const override { return inner_.check(manifest); }
  Result<void> edit(const nlohmann::json& manifest, const std::string& what, const std::string& mergeKey) override {
    return inner_.edit(manifest, what, mergeKey);
  }
  Result<void> save(const std::filesystem::path& folder) override { return inner_.save(folder); }
  Result<void> makeOwn() override { return inner_.makeOwn(); }
  [[nodiscard]] bool hasUnsavedChanges() const override { return inner_.hasUnsavedChanges(); }
  [[nodiscard]] std::optional<Scan> scan() const override { return inner_.scan(); }
  [[nodiscard]] Choices choices() const override { return inner_.choices(); }
  Ticket onChanged(std::function<void()> callback) override {
    return calls_->keepTicket(inner_.onChanged(
        [calls = calls_, callback = std::move(callback)] { static_cast<void>(calls->call(PluginMoment::caseChanged, {}, callback)); }));
  }

 private:
  Calls calls_;
  sdk::Cases& inner_;
};

/// What a job of the plugin asks while it works: a plugin that is withdrawn has to stop.
class UntilWithdrawn final : public Progress {
 public:
  UntilWithdrawn(Progress& inner, const PluginCalls& calls) : inner_(inner), calls_(calls) {}
  void report(std::string_view what, double fraction) override { inner_.report(what, fraction); }
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
    if (!working.mayBegin()) return failure(ErrorCode::cancelled, "The plugin of this work is not running any more.");
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

  void add(const std::string& id, const std::string& title, std::function<QWidget*(QWidget*)> make) override {
    ids_.push_back(id);
    calls_->whenMade([this, id, title, make = guardedMake(title, std::move(make))] { inner_.add(id, title, make); });
  }
  void addStaged(sdk::StagedPanel panel) override {
    ids_.push_back(panel.id);
    panel.make = guardedMake(panel.title, std::move(panel.make));
    panel.makeStage = guardedMake(panel.title, std::move(panel.makeStage));
    if (panel.document != nullptr)
      panel.document = calls_->keepDocument(std::make_unique<GuardedDocument>(*calls_, *panel.document, panel.title));
    calls_->whenMade([this, panel = std::move(panel)] { inner_.addStaged(panel); });
  }
  [[nodiscard]] bool has(const std::string& id) const { return std::find(ids_.begin(), ids_.end(), id) != ids_.end(); }

 private:
  /// Nothing stays nothing: a panel without a stage has none.
  [[nodiscard]] sdk::StagedPanel::Make guardedMake(const std::string& title, sdk::StagedPanel::Make make) const {
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

}  // namespace

struct PluginHost::Parts {
  Parts(const Calls& calls, sdk::Host& inner)
      : cases(calls, inner.cases()), jobs(calls, inner.jobs()), panels(calls, inner.panels()), commands(calls, inner.commands()) {}
  PluginCases cases;
  PluginJobs jobs;
  PluginPanels panels;
  PluginCommands commands;
};

PluginHost::PluginHost(sdk::Host& inner, std::string plugin, PluginCalls::Tell tell)
    : calls_(std::make_shared<PluginCalls>(std::move(plugin), std::move(tell))),
      inner_(inner),
      parts_(std::make_unique<Parts>(calls_, inner)) {}
PluginHost::~PluginHost() = default;

sdk::Volumes& PluginHost::volumes() { return inner_.volumes(); }
sdk::Files& PluginHost::files() { return inner_.files(); }
sdk::Cases& PluginHost::cases() { return parts_->cases; }
sdk::Jobs& PluginHost::jobs() { return parts_->jobs; }
sdk::Panels& PluginHost::panels() { return parts_->panels; }
sdk::Commands& PluginHost::commands() { return parts_->commands; }
sdk::Log& PluginHost::log() { return inner_.log(); }
bool PluginHost::hasPanel(const std::string& id) const { return parts_->panels.has(id); }

}  // namespace ew::door
