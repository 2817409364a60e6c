#include "workstation_host.h"

#include <QLabel>
#include <QScrollArea>
#include <QShowEvent>
#include <QTabWidget>
#include <QVBoxLayout>
#include <utility>
#include <vector>

#include "ew/door/host_parts.h"
#include "ew/library/case.h"
#include "words.h"

namespace ew::ui {
namespace {

constexpr const char* kPanelId = "panelId";  ///< property of a panel's column and stage

/// A tab that makes its content when it is first seen. What the plugin throws is stopped and told by the door; here it is an empty result.
class LazyPanel final : public QScrollArea {
 public:
  explicit LazyPanel(sdk::StagedPanel panel) : panel_(std::move(panel)) {
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setProperty(kPanelId, words(panel_.id));
  }

  [[nodiscard]] const sdk::StagedPanel& panel() const { return panel_; }
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
    // A panel never scrolls sideways: the column is at least as wide as its content asks for.
    setMinimumWidth(content->minimumSizeHint().width() + 8);
  }
  /// @return null when the plugin made none; then nothing is left of what it had begun
  [[nodiscard]] static QWidget* make(const sdk::StagedPanel::Make& how, QWidget* parent) {
    const QObjectList before = parent->children();
    QWidget* made = how(parent);
    if (made != nullptr) return made;
    for (QObject* child : QObjectList(parent->children()))
      if (!before.contains(child)) delete child;
    return nullptr;
  }

  sdk::StagedPanel panel_;
  QPointer<QWidget> stage_;
};

class HostVolumes final : public door::FileVolumes {
 public:
  explicit HostVolumes(WorkstationHost& host) : host_(host) {}
  void show(Volume volume, const std::string& title) override {
    Q_EMIT host_.volumeShown(std::make_shared<const Volume>(std::move(volume)), words(title));
  }

 private:
  WorkstationHost& host_;
};

class HostCases final : public sdk::Cases {
 public:
  explicit HostCases(CaseDocument& document) : document_(document) {}

  [[nodiscard]] std::optional<nlohmann::json> current() const override {
    if (!document_.current()) return std::nullopt;
    return document_.manifest();
  }
  [[nodiscard]] std::filesystem::path currentFolder() const override {
    return document_.current() ? document_.current()->folder : std::filesystem::path();
  }
  [[nodiscard]] std::vector<Error> check(const nlohmann::json& manifest) const override { return checkManifest(manifest, currentFolder()); }
  Result<void> edit(const nlohmann::json& manifest, const std::string& what, const std::string& mergeKey) override {
    return document_.edit(manifest, what, mergeKey);
  }
  Result<void> save(const std::filesystem::path& folder) override { return saving.save ? saving.save(folder) : document_.save(folder); }
  Result<void> makeOwn() override {
    if (!document_.current()) return failure(ErrorCode::badUsage, "No case is open; open one first.");
    return saving.makeOwn ? saving.makeOwn() : Result<void>();
  }
  [[nodiscard]] bool hasUnsavedChanges() const override { return document_.hasUnsavedChanges(); }
  [[nodiscard]] std::optional<Scan> scan() const override { return askScan ? askScan() : std::nullopt; }
  [[nodiscard]] Choices choices() const override { return askChoices ? askChoices() : Choices{}; }
  Ticket onChanged(std::function<void()> callback) override {
    auto kept = std::make_shared<std::function<void()>>(std::move(callback));
    callbacks_.push_back(kept);
    return kept;
  }

  std::function<std::optional<Scan>()> askScan;
  std::function<Choices()> askChoices;

  void tellChanged() {
    std::erase_if(callbacks_, [](const auto& one) { return one.expired(); });
    const auto now = callbacks_;  // a callback may register another
    for (const auto& weak : now) {
      if (const auto callback = weak.lock()) (*callback)();
    }
  }

  WorkstationHost::CaseSaving saving;

 private:
  CaseDocument& document_;
  std::vector<std::weak_ptr<std::function<void()>>> callbacks_;
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
  HostPanels(WorkstationHost& host, QTabWidget& tabs) : host_(host), tabs_(tabs) {}
  void add(const std::string& id, const std::string& title, std::function<QWidget*(QWidget*)> make) override {
    addStaged({id, title, std::move(make), {}, nullptr, {}});
  }
  void addStaged(sdk::StagedPanel asked) override {
    const QString id = words(asked.id);
    const QString title = words(asked.title);
    if (asked.document != nullptr) tickets_.push_back(asked.document->onChanged([&host = host_] { Q_EMIT host.panelDocumentChanged(); }));
    auto* panel = new LazyPanel(std::move(asked));
    panel->setObjectName(QStringLiteral("panel_") + id);
    tabs_.addTab(panel, title);
  }
  [[nodiscard]] LazyPanel* inFront() const { return dynamic_cast<LazyPanel*>(tabs_.currentWidget()); }
  [[nodiscard]] std::vector<const sdk::StagedPanel*> all() const {
    std::vector<const sdk::StagedPanel*> found;
    for (int i = 0; i < tabs_.count(); ++i)
      if (const auto* panel = dynamic_cast<const LazyPanel*>(tabs_.widget(i))) found.push_back(&panel->panel());
    return found;
  }

 private:
  WorkstationHost& host_;
  QTabWidget& tabs_;
  std::vector<std::shared_ptr<void>> tickets_;
};

/// A window has no command line, so commands are not kept.
class NoCommands final : public sdk::Commands {
 public:
  void add(const std::string&, const std::string&, Run) override {}
};

}  // namespace

struct WorkstationHost::Parts {
  HostVolumes volumes;
  door::TextFiles files;
  HostCases cases;
  HostJobs jobs;
  HostPanels panels;
  NoCommands commands;
  door::ProgramLog log;
};

WorkstationHost::WorkstationHost(CaseDocument& document, Jobs& jobs, QTabWidget& panels, QObject* parent)
    : QObject(parent), parts_(new Parts{HostVolumes(*this), {}, HostCases(document), HostJobs(jobs), HostPanels(*this, panels), {}, {}}) {
  connect(&document, &CaseDocument::changed, this, [this] { parts_->cases.tellChanged(); });
}

WorkstationHost::~WorkstationHost() = default;

void WorkstationHost::setCaseSaving(CaseSaving saving) { parts_->cases.saving = std::move(saving); }
void WorkstationHost::setScan(std::function<std::optional<sdk::Cases::Scan>()> scan) { parts_->cases.askScan = std::move(scan); }
void WorkstationHost::setChoices(std::function<sdk::Cases::Choices()> choices) { parts_->cases.askChoices = std::move(choices); }

bool WorkstationHost::hasStageInFront() const {
  const LazyPanel* panel = parts_->panels.inFront();
  return panel != nullptr && panel->hasStage();
}

QWidget* WorkstationHost::stageInFront(QWidget* parent) {
  LazyPanel* panel = parts_->panels.inFront();
  return panel != nullptr ? panel->stage(parent) : nullptr;
}

sdk::PanelDocument* WorkstationHost::documentInFront() const {
  const LazyPanel* panel = parts_->panels.inFront();
  return panel != nullptr ? panel->panel().document : nullptr;
}

std::vector<const sdk::StagedPanel*> WorkstationHost::panelsAdded() const { return parts_->panels.all(); }

std::string WorkstationHost::panelOf(const QObject* part) {
  for (; part != nullptr; part = part->parent())
    if (const QVariant id = part->property(kPanelId); id.isValid()) return id.toString().toStdString();
  return {};
}

sdk::Volumes& WorkstationHost::volumes() { return parts_->volumes; }
sdk::Files& WorkstationHost::files() { return parts_->files; }
sdk::Cases& WorkstationHost::cases() { return parts_->cases; }
sdk::Jobs& WorkstationHost::jobs() { return parts_->jobs; }
sdk::Panels& WorkstationHost::panels() { return parts_->panels; }
sdk::Commands& WorkstationHost::commands() { return parts_->commands; }
sdk::Log& WorkstationHost::log() { return parts_->log; }

}  // namespace ew::ui
