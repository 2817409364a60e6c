#include "plugins/workstation_host.h"

#include <QApplication>
#include <QLabel>
#include <QScrollArea>
#include <QShowEvent>
#include <QTabWidget>
#include <QTimer>
#include <QVBoxLayout>
#include <utility>

#include <spdlog/spdlog.h>

#include "body/host_overlays.h"
#include "ew/door/host_parts.h"
#include "ew/library/access.h"
#include "ew/library/case.h"
#include "ew/sdk/case_parts.h"
#include "ew/widgets/save_file.h"
#include "ew/widgets/words.h"
#include "jobs/message_bar.h"
#include "plugins/host_scan.h"
#include "plugins/workspace_panels.h"

namespace ew::ui {
namespace {

/// What a plugin asks, as the one question asks it.
SaveFile saveFileOf(const sdk::SaveFile& asked) {
  SaveFile same{words(asked.title), wordsOf(asked.proposal), words(asked.filter), {}};
  for (const std::string& ending : asked.endings) same.endings << words(ending);
  if (asked.written)
    same.written = [written = asked.written](const QString& file) {
      QStringList names;
      for (const auto& each : written(pathOf(file))) names << wordsOf(each);
      return names;
    };
  if (asked.whyKept) same.whyKept = [why = asked.whyKept](const QString& file) { return words(why(pathOf(file))); };
  same.madeFrom = asked.madeFrom;
  same.isDated = asked.isDated;
  return same;
}

constexpr const char* kPanelId = "panelId";  ///< property of a panel's column and stage

/// A tab that makes its content when it is first seen. What the plugin throws is stopped and told by the door; here it is an empty result.
class LazyPanel final : public QScrollArea {
 public:
  explicit LazyPanel(sdk::StagePanel panel) : panel_(std::move(panel)) {
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setProperty(kPanelId, words(panel_.id));
  }

  [[nodiscard]] const sdk::StagePanel& panel() const { return panel_; }
  [[nodiscard]] bool hasStage() const { return stage_ || panel_.makeStage; }
  /// Made when first asked for, after the column.
  [[nodiscard]] QWidget* stage(QWidget* parent) {
    makeColumn();
    if (!stage_ && panel_.makeStage) {
      stage_ = make(std::exchange(panel_.makeStage, nullptr), parent);
      if (stage_) stage_->setProperty(kPanelId, words(panel_.id));
    }
    return stage_;
  }

 protected:
  void showEvent(QShowEvent* event) override {
    QScrollArea::showEvent(event);
    makeColumn();
  }

 private:
  void makeColumn() {
    if (!panel_.make) return;
    QWidget* content = make(std::exchange(panel_.make, nullptr), this);
    if (content == nullptr) {
      auto* sentence = new QLabel(WorkstationHost::tr("This panel could not be opened; Help, Plugins says more."));
      sentence->setObjectName(QStringLiteral("panelProblem"));
      sentence->setWordWrap(true);
      sentence->setMargin(16);
      sentence->setAlignment(Qt::AlignTop | Qt::AlignLeft);
      content = sentence;
    }
    setWidget(content);
    viewport()->setAutoFillBackground(false);
    content->setAutoFillBackground(false);
  }
  /// @return null when the plugin made none; then nothing is left of what it had begun
  [[nodiscard]] static QWidget* make(const sdk::StagePanel::Make& how, QWidget* parent) {
    const QObjectList before = parent->children();
    QWidget* made = how(parent);
    if (made != nullptr) return made;
    for (QObject* child : QObjectList(parent->children()))
      if (!before.contains(child)) delete child;
    return nullptr;
  }

  sdk::StagePanel panel_;
  QPointer<QWidget> stage_;
};

/// Callbacks that live as long as somebody holds their ticket.
template <class... What>
class CallRegistry {
 public:
  using Call = std::function<void(What...)>;
  [[nodiscard]] sdk::Ticket add(Call call) {
    auto kept = std::make_shared<Call>(std::move(call));
    calls_.push_back(kept);
    return kept;
  }
  /// @return whether anybody listens
  bool tell(const What&... what) {
    std::erase_if(calls_, [](const auto& one) { return one.expired(); });
    const auto now = calls_;  // a callback may register another
    for (const auto& weak : now) {
      if (const auto call = weak.lock()) (*call)(what...);
    }
    return !now.empty();
  }

 private:
  std::vector<std::weak_ptr<Call>> calls_;
};

class HostVolumes final : public door::FileVolumes {
 public:
  explicit HostVolumes(WorkstationHost& host) : host_(host) {}
  void show(Volume volume, const std::string& title) override { showMade(std::move(volume), title, {}); }
  void showMade(Volume volume, const std::string& title, const std::vector<std::filesystem::path>& madeFrom) override {
    Q_EMIT host_.volumeShown(std::make_shared<const Volume>(std::move(volume)), words(title), madeFrom);
  }
  [[nodiscard]] std::optional<sdk::DisplayVolume> shown() const override { return shownNow ? shownNow() : std::nullopt; }
  void wasKept(const std::shared_ptr<const Volume>& volume) override { Q_EMIT host_.volumeKept(volume); }

  std::function<std::optional<sdk::DisplayVolume>()> shownNow;

 private:
  WorkstationHost& host_;
};

class HostCases final : public sdk::Cases {
 public:
  HostCases(CaseDocument& document, const door::PartSchemas& parts) : document_(document), parts_(parts) {}

  [[nodiscard]] std::optional<Case> current() const override {
    if (!document_.current() || !isLocked()) return document_.current();
    return shownCase(*document_.current(), *access);
  }
  [[nodiscard]] std::optional<Case> forPractice() const override { return document_.current(); }
  [[nodiscard]] std::filesystem::path currentFolder() const override {
    return document_.current() ? document_.current()->folder : std::filesystem::path();
  }
  [[nodiscard]] Result<Case> read(const std::filesystem::path& folderOrManifest) const override {
    if (access != nullptr)
      if (auto allowed = access->require(Permission::seeAnswers); !allowed) return passOn(allowed.error());
    return loadCase(folderOrManifest);
  }
  [[nodiscard]] std::vector<Error> check(const Case& edited) const override { return parts_.problemsIn(edited, currentFolder()); }
  [[nodiscard]] bool isLocked() const override { return access != nullptr && access->isLocked(); }
  Result<void> edit(const Case& edited, const std::string& what, const std::string& mergeKey) override {
    if (access != nullptr)
      if (auto allowed = access->require(Permission::editCases); !allowed) return allowed;
    return document_.edit(edited, what, mergeKey);
  }
  Result<void> save(const std::filesystem::path& folder) override { return saving.save ? saving.save(folder) : document_.save(folder); }
  Result<void> saveCopy() override { return saving.saveCopy ? saving.saveCopy() : sdk::Cases::saveCopy(); }
  Result<void> makeOwn() override {
    if (!document_.current()) return failure(ErrorCode::badUsage, say<"No case is open; open one first.">());
    return saving.makeOwn ? saving.makeOwn() : Result<void>();
  }
  [[nodiscard]] bool hasUnsavedChanges() const override { return document_.hasUnsavedChanges(); }
  Result<void> open(const std::filesystem::path& folder) override { return openCase ? openCase(folder) : sdk::Cases::open(folder); }
  [[nodiscard]] std::optional<Scan> scan() const override { return askScan ? askScan() : std::nullopt; }
  [[nodiscard]] Choices choices() const override { return askChoices ? askChoices() : Choices{}; }
  Ticket onChanged(std::function<void()> callback) override { return callbacks_.add(std::move(callback)); }
  void tellChanged() { callbacks_.tell(); }

  const AccessPolicy* access = nullptr;
  std::function<std::optional<Scan>()> askScan;
  std::function<Choices()> askChoices;
  std::function<Result<void>(const std::filesystem::path&)> openCase;

  WorkstationHost::CaseSaving saving;

 private:
  CaseDocument& document_;
  const door::PartSchemas& parts_;
  CallRegistry<> callbacks_;
};

class HostCaseParts final : public sdk::CaseParts {
 public:
  HostCaseParts(CaseDocument& document, door::PartSchemas& schemas) : document_(document), schemas_(schemas) {}

  [[nodiscard]] Result<sdk::Ticket> add(const std::string& name, const std::string& schema) override { return schemas_.add(name, schema); }
  [[nodiscard]] std::optional<nlohmann::json> read(const std::string& name) const override {
    if (!document_.current() || (access != nullptr && access->isLocked() && !document_.current()->sealed)) return std::nullopt;
    return door::partOf(document_.current()->otherFields, name);
  }
  Result<void> edit(const std::string& name, const std::optional<nlohmann::json>& section, const std::string& what,
                    const std::string& mergeKey) override {
    if (!document_.current()) return failure(ErrorCode::notFound, say<"No case is open; open one first.">());
    if (access != nullptr)
      if (auto allowed = access->require(Permission::editCases); !allowed) return allowed;
    if (!schemas_.knows(name)) return failure(ErrorCode::badUsage, say<"The section '%1' of a case has no schema; add it first.">(name));
    if (section)
      if (auto problems = schemas_.problems(name, *section); !problems.empty()) return passOn(std::move(problems.front()));
    return document_.edit(door::withPart(*document_.current(), name, section), what, mergeKey);
  }
  [[nodiscard]] std::filesystem::path folderOf(const std::string& name) const override {
    return document_.current() ? document_.current()->folder / "parts" / name : std::filesystem::path();
  }
  [[nodiscard]] sdk::Ticket onOpened(OpenCallback callback) override { return callbacks_.add(std::move(callback)); }
  void tellOpened() {
    callbacks_.tell(document_.current() ? document_.current()->folder : std::filesystem::path());
    if (!document_.current() || !waiting_) return;
    const auto asked = *std::exchange(waiting_, std::nullopt);  // whoever opens another case wants something else
    if (asked.folder == document_.current()->folder) tellAsked(asked.name, asked.item);
  }
  [[nodiscard]] sdk::Ticket onAsked(const std::string& name, AskCallback callback) override {
    sdk::Ticket ticket = asked_[name].add(std::move(callback));
    // A panel is made when it is first seen, so it may be asked before it listens; it is told once it is whole.
    if (unheard_ && unheard_->name == name) QTimer::singleShot(0, &here_, [this] { tellUnheard(); });
    return ticket;
  }
  const AccessPolicy* access = nullptr;

  /// Of the open case at once, of another when it is opened.
  void ask(const std::filesystem::path& folder, const std::string& name, const std::string& item) {
    waiting_.reset();
    unheard_.reset();
    if (document_.current() && document_.current()->folder == folder) return tellAsked(name, item);
    waiting_ = Asked{folder, name, item};
  }

 private:
  struct Asked {
    std::filesystem::path folder;
    std::string name, item;
  };
  void tellAsked(const std::string& name, const std::string& item) {
    const auto calls = asked_.find(name);
    if (calls != asked_.end() && calls->second.tell(item)) return;
    unheard_ = Asked{document_.current()->folder, name, item};
  }
  void tellUnheard() {
    const auto asked = std::exchange(unheard_, std::nullopt);
    if (asked && document_.current() && document_.current()->folder == asked->folder) tellAsked(asked->name, asked->item);
  }

  CaseDocument& document_;
  door::PartSchemas& schemas_;
  QObject here_;  ///< what is told later is told only while this is there
  CallRegistry<std::filesystem::path> callbacks_;
  std::map<std::string, CallRegistry<std::string>> asked_;
  std::optional<Asked> waiting_;  ///< until its case is open
  std::optional<Asked> unheard_;  ///< of the open case, until somebody listens
};

class HostJobs final : public sdk::Jobs {
 public:
  explicit HostJobs(ui::Jobs& jobs) : jobs_(jobs) {}
  void start(const std::string& title, std::function<Result<void>(Progress&)> work,
             std::function<void(const Result<void>&)> done) override {
    jobs_.start(words(title), std::move(work), std::move(done));
  }
  void startSaving(const std::string& title, std::function<Result<void>(Progress&)> work,
                   std::function<void(const Result<void>&)> done) override {
    jobs_.start(words(title), std::move(work), std::move(done), ui::Jobs::Kind::saving);
  }

 private:
  ui::Jobs& jobs_;
};

class HostPanels final : public sdk::Panels {
 public:
  HostPanels(WorkstationHost& host, WorkspacePanels& columns) : host_(host), columns_(columns) {}
  void addStaged(sdk::StagePanel asked) override {
    const QString id = words(asked.id);
    const QString title = words(asked.title);
    QTabWidget& tabs = columns_.of(asked.workspace);
    if (const auto document = asked.document.lock())
      tickets_.push_back(document->onChanged([&host = host_] { Q_EMIT host.panelDocumentChanged(); }));
    auto* panel = new LazyPanel(std::move(asked));
    panel->setObjectName(QStringLiteral("panel_") + id);
    tabs.addTab(panel, title);
  }
  void setShown(const std::string& id, bool shown) override {
    for (const auto& [workspace, tabs] : columns_.all())
      for (int i = 0; i < tabs->count(); ++i)
        if (const auto* panel = dynamic_cast<const LazyPanel*>(tabs->widget(i)); panel != nullptr && panel->panel().id == id)
          return columns_.setTabShown(*tabs, i, shown);
  }
  void bringToFront(const std::string& id) override {
    for (const auto& [workspace, tabs] : columns_.all())
      for (int i = 0; i < tabs->count(); ++i)
        if (const auto* panel = dynamic_cast<const LazyPanel*>(tabs->widget(i)); panel != nullptr && panel->panel().id == id)
          tabs->setCurrentIndex(i);
    columns_.ask();
  }
  [[nodiscard]] LazyPanel* inFront() const {
    const QTabWidget* tabs = columns_.inFront();
    return tabs != nullptr ? dynamic_cast<LazyPanel*>(tabs->currentWidget()) : nullptr;
  }
  [[nodiscard]] std::vector<const sdk::StagePanel*> all() const {
    std::vector<const sdk::StagePanel*> found;
    for (const auto& [workspace, tabs] : columns_.all())
      for (int i = 0; i < tabs->count(); ++i)
        if (const auto* panel = dynamic_cast<const LazyPanel*>(tabs->widget(i))) found.push_back(&panel->panel());
    return found;
  }

 private:
  WorkstationHost& host_;
  WorkspacePanels& columns_;
  std::vector<std::shared_ptr<void>> tickets_;
};

class HostWorkspaces final : public sdk::Workspaces {
 public:
  void add(const sdk::Workspace& workspace) override {
    if (theSwitch.add && !theSwitch.add(workspace))
      spdlog::warn("A plugin brings the workspace '{}', whose name is taken or is none; it is left out.", workspace.id);
  }
  void show(const std::string& id) override {
    if (theSwitch.show) theSwitch.show(id);
  }
  [[nodiscard]] std::string shown() const override { return theSwitch.shown ? theSwitch.shown() : std::string(); }

  WorkstationHost::WorkspaceSwitch theSwitch;
};

class HostWindow final : public sdk::Window {
 public:
  explicit HostWindow(MessageBar& messages) : messages_(messages) {}
  void info(const std::string& sentence, const std::string& topic) override { messages_.showNote(words(sentence), topicOf(topic)); }
  void warn(const std::string& sentence, const std::string& topic) override {
    spdlog::warn("{}", sentence);
    messages_.showNote(words(sentence), topicOf(topic));
  }
  void error(const std::string& sentence, const std::string& topic) override {
    spdlog::error("{}", sentence);
    messages_.showError(words(sentence), topicOf(topic));
  }
  [[nodiscard]] sdk::Ticket addEntry(const sdk::MenuEntry& entry, std::function<void()> run) override {
    return addToMenu ? addToMenu(entry, std::move(run)) : nullptr;
  }
  [[nodiscard]] sdk::Ticket onClosing(std::function<std::string()> ask) override {
    return closing_.add([this, ask = std::move(ask)] { answers_.push_back(ask()); });
  }
  [[nodiscard]] sdk::Ticket holdUnsaved(sdk::UnsavedWork work) override {
    return holding_.add([this, work = std::move(work)] { held_.push_back(work); });
  }
  [[nodiscard]] std::optional<std::filesystem::path> askSaveFile(const sdk::SaveFile& asked) override {
    QWidget* modal = QApplication::activeModalWidget();
    const QString file = ew::askSaveFile(modal != nullptr ? modal : messages_.window(), saveFileOf(asked));
    return file.isEmpty() ? std::nullopt : std::optional(pathOf(file));
  }
  [[nodiscard]] std::vector<sdk::UnsavedWork> unsaved() {
    held_.clear();
    answers_.clear();
    closing_.tell();
    holding_.tell();
    for (std::string& each : answers_) held_.push_back({[sentence = std::move(each)] { return sentence; }});
    answers_.clear();
    std::erase_if(held_, [](const sdk::UnsavedWork& work) { return work.sentence().empty(); });
    return std::exchange(held_, {});
  }

  std::function<sdk::Ticket(const sdk::MenuEntry&, std::function<void()>)> addToMenu;

 private:
  static QString topicOf(const std::string& topic) { return topic.empty() ? QString() : QStringLiteral("plugin ") + words(topic); }
  MessageBar& messages_;
  CallRegistry<> closing_, holding_;
  std::vector<std::string> answers_;
  std::vector<sdk::UnsavedWork> held_;
};

/// A window has no command line, so commands are not kept.
class NoCommands final : public sdk::Commands {
 public:
  void add(const std::string&, const std::string&, Run) override {}
};

}  // namespace

struct WorkstationHost::Parts {
  Parts(WorkstationHost& host, CaseDocument& document, ui::Jobs& theJobs, Session& session, WorkspacePanels& columns, MessageBar& messages)
      : volumes(host),
        cases(document, *schemas),
        caseParts(document, *schemas),
        jobs(theJobs),
        panels(host, columns),
        scan(session),
        window(messages) {}
  std::shared_ptr<door::PartSchemas> schemas = std::make_shared<door::PartSchemas>();
  HostVolumes volumes;
  door::TextFiles files;
  HostCases cases;
  HostCaseParts caseParts;
  HostJobs jobs;
  HostPanels panels;
  NoCommands commands;
  HostScan scan;
  HostWorkspaces workspaces;
  HostOverlays overlays;
  HostWindow window;
  door::ProgramLog log;
};

WorkstationHost::WorkstationHost(CaseDocument& document, Jobs& jobs, Session& session, WorkspacePanels& panels, MessageBar& messages,
                                 QObject* parent)
    : QObject(parent), parts_(std::make_unique<Parts>(*this, document, jobs, session, panels, messages)) {
  connect(&document, &CaseDocument::changed, this, [this] { parts_->cases.tellChanged(); });
  connect(&document, &CaseDocument::opened, this, [this] { parts_->caseParts.tellOpened(); });
  connect(&document, &CaseDocument::closed, this, [this] { parts_->caseParts.tellOpened(); });
}

WorkstationHost::~WorkstationHost() = default;

void WorkstationHost::setCaseSaving(CaseSaving saving) { parts_->cases.saving = std::move(saving); }
void WorkstationHost::setScan(std::function<std::optional<sdk::Cases::Scan>()> scan) { parts_->cases.askScan = std::move(scan); }
void WorkstationHost::setAccess(const AccessPolicy& access) { parts_->cases.access = parts_->caseParts.access = &access; }
void WorkstationHost::tellAccessChanged() {
  parts_->cases.tellChanged();
  parts_->caseParts.tellOpened();
}
void WorkstationHost::setOpening(std::function<Result<void>(const std::filesystem::path&)> open) {
  parts_->cases.openCase = std::move(open);
}
void WorkstationHost::askFor(const std::filesystem::path& caseFolder, const std::string& part, const std::string& item) {
  parts_->panels.bringToFront(part);
  parts_->caseParts.ask(caseFolder, part, item);
}
void WorkstationHost::setChoices(std::function<sdk::Cases::Choices()> choices) { parts_->cases.askChoices = std::move(choices); }

void WorkstationHost::setWorkspaceSwitch(WorkspaceSwitch theSwitch) { parts_->workspaces.theSwitch = std::move(theSwitch); }
void WorkstationHost::setMenu(std::function<sdk::Ticket(const sdk::MenuEntry&, std::function<void()>)> addEntry) {
  parts_->window.addToMenu = std::move(addEntry);
}

bool WorkstationHost::hasStageInFront() const {
  const LazyPanel* panel = parts_->panels.inFront();
  return panel != nullptr && panel->hasStage();
}

QWidget* WorkstationHost::stageInFront(QWidget* parent) {
  LazyPanel* panel = parts_->panels.inFront();
  return panel != nullptr ? panel->stage(parent) : nullptr;
}

std::shared_ptr<sdk::PanelDocument> WorkstationHost::documentInFront() const {
  const LazyPanel* panel = parts_->panels.inFront();
  return panel != nullptr ? panel->panel().document.lock() : nullptr;
}

std::vector<sdk::UnsavedWork> WorkstationHost::unsaved() const { return parts_->window.unsaved(); }
HostScan& WorkstationHost::hostScan() { return parts_->scan; }
HostOverlays& WorkstationHost::hostOverlays() { return parts_->overlays; }

std::vector<const sdk::StagePanel*> WorkstationHost::panelsAdded() const { return parts_->panels.all(); }

std::string WorkstationHost::panelOf(const QObject* part) {
  for (; part != nullptr; part = part->parent())
    if (const QVariant id = part->property(kPanelId); id.isValid()) return id.toString().toStdString();
  return {};
}

sdk::Volumes& WorkstationHost::volumes() { return parts_->volumes; }
void WorkstationHost::setShownVolume(std::function<std::optional<sdk::DisplayVolume>()> shown) {
  parts_->volumes.shownNow = std::move(shown);
}
sdk::Files& WorkstationHost::files() { return parts_->files; }
sdk::Cases& WorkstationHost::cases() { return parts_->cases; }
sdk::Jobs& WorkstationHost::jobs() { return parts_->jobs; }
sdk::Panels& WorkstationHost::panels() { return parts_->panels; }
sdk::Commands& WorkstationHost::commands() { return parts_->commands; }
sdk::Scan& WorkstationHost::scan() { return parts_->scan; }
sdk::Workspaces& WorkstationHost::workspaces() { return parts_->workspaces; }
sdk::Overlays& WorkstationHost::overlays() { return parts_->overlays; }
sdk::CaseParts& WorkstationHost::caseParts() { return parts_->caseParts; }
sdk::Window& WorkstationHost::window() { return parts_->window; }
sdk::Log& WorkstationHost::log() { return parts_->log; }

}  // namespace ew::ui
