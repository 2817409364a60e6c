#include "window/frame/workspaces.h"

#include <QMenu>
#include <algorithm>
#include <cctype>
#include <utility>

#include "ew/sdk/host.h"
#include "ew/widgets/words.h"
#include "keys/key_tips.h"
#include "window/frame/columns.h"
#include "window/frame/commands.h"
#include "window/frame/undo.h"
#include "window/frame/window_parts.h"

namespace ew::ui {
namespace {

constexpr int kFirstOwnKey = 3;  // Ctrl+1 and Ctrl+2 are Explore and Author
constexpr int kLastOwnKey = 9;

bool isWorkspaceId(const std::string& id) {
  return !id.empty() && std::all_of(id.begin(), id.end(), [](unsigned char c) { return std::isalnum(c) != 0 || c == '-' || c == '_'; });
}

}  // namespace

void Workspaces::addMenu(QMenu& view) {
  menu_ = &view;
  group_ = new QActionGroup(&parts_.window);
  explore_ = parts_.commands->add(view, "workspace.explore", [this] { show(kExplore); });
  author_ = parts_.commands->add(view, "workspace.author", [this] { show(kAuthor); });
  for (QAction* action : {explore_, author_}) {
    action->setCheckable(true);
    group_->addAction(action);
  }
  explore_->setChecked(true);
  behind_ = view.addSeparator();
}

bool Workspaces::add(const sdk::Workspace& workspace) {
  WindowParts& p = parts_;
  const std::string& id = workspace.id;
  const bool isTaken =
      id == kExplore || id == kAuthor || std::any_of(own_.begin(), own_.end(), [&](const Own& each) { return each.what.id == id; });
  if (isTaken || !isWorkspaceId(id)) return false;
  auto* action = new QAction(words(workspace.title), &p.window);
  action->setCheckable(true);
  group_->addAction(action);
  const int key = kFirstOwnKey + static_cast<int>(own_.size());
  QString tip = words(workspace.tip);
  if (key <= kLastOwnKey) {
    KeyCommand command;
    command.id = "workspace." + id;
    command.source = QByteArray::fromStdString(workspace.title);
    command.usual = {QKeySequence(QStringLiteral("Ctrl+%1").arg(key))};
    p.commands->join(action, command.id);
    tip = tipWithKeys(tip + QStringLiteral(" (%1)"), command.id);
    p.keys.add(std::move(command));
  }
  connect(action, &QAction::triggered, this, [this, id] { show(id); });
  menu_->insertAction(behind_, action);
  p.topBar->addWorkspace(words(id), words(workspace.title), tip, QByteArray::fromStdString(workspace.icon));
  own_.push_back({workspace, action});
  return true;
}

void Workspaces::connectParts() {
  WindowParts& p = parts_;
  connect(p.topBar, &TopBar::workspaceChosen, this, [this](const QString& id) { show(id.toStdString()); });
  connect(p.startPage, &StartPage::backRequested, this, &Workspaces::backToWork);
  connect(p.pages, &QStackedWidget::currentChanged, this, [this] {
    Q_EMIT pageChanged();
    parts_.status->setIdle(isAtStart());
    showStage();
    parts_.columns->placeMessages();
    parts_.refresh();
  });
  connect(p.panels, &WorkspacePanels::changed, this, &Workspaces::showStage);
  connect(p.panels, &WorkspacePanels::tabsChanged, this, [this] {
    showPanels();
    showStage();
  });
}

void Workspaces::refresh() {
  const bool locked = parts_.access.isLocked();
  const auto showRoom = [&](const std::string& id, QAction* action) {
    action->setVisible(!locked);
    action->setEnabled(!locked);
    parts_.topBar->setShown(words(id), !locked);
  };
  showRoom(kAuthor, author_);
  for (const Own& own : own_) showRoom(own.what.id, own.action);
}

void Workspaces::showStartPage() {
  if (isAtStart()) return pageChanged();
  parts_.pages->setCurrentWidget(parts_.startPage);
}

void Workspaces::backToWork() {
  parts_.pages->setCurrentWidget(parts_.workspacePage);
  parts_.scanView->setFocus();
}

void Workspaces::show(const std::string& id) {
  WindowParts& p = parts_;
  const auto found = std::find_if(own_.begin(), own_.end(), [&](const Own& each) { return each.what.id == id; });
  if (id != kExplore && id != kAuthor && found == own_.end()) return;
  if (id != kExplore && !p.may(Permission::editCases)) return;
  current_ = id;
  p.topBar->setWorkspace(words(id));
  (found != own_.end() ? found->action : isAuthor() ? author_ : explore_)->setChecked(true);
  Q_EMIT shown();
  if (id != kExplore) p.columns->setScanOnly(false);
  p.preparation.hold(isAuthor());  // nothing that nobody asked for beside an author's own work
  showPanels();
  p.status->setForAuthors(isAuthor());
  p.startPage->setForAuthors(isAuthor());
  showStage();
  // Scanning needs something to scan; authoring may begin with nothing.
  const bool needsSubject = !isAuthor() && keepsScan() && !(p.document.current() && p.opener->showsCase());
  p.pages->setCurrentWidget(needsSubject && !p.session.subject() ? static_cast<QWidget*>(p.startPage) : p.workspacePage);
  p.columns->placeMessages();
  p.refresh();
}

void Workspaces::showPanels() {
  parts_.panels->show(current_);
  parts_.columns->show();
}

void Workspaces::showStage() {
  WindowParts& p = parts_;
  const bool staged = hasPanels() && isAtWork() && p.host->hasStageInFront();
  QWidget* stage = staged ? p.host->stageInFront(p.stages) : nullptr;
  if (stage != nullptr) {
    if (p.stages->indexOf(stage) < 0) p.stages->addWidget(stage);
    p.stages->setCurrentWidget(stage);
  }
  const bool was = std::exchange(isStaged_, stage != nullptr);
  if (const QMenu* scan = p.commands->scanMenu())
    scan->menuAction()->setEnabled(!isStaged_);  // its keys are those of a scan that is not seen
  if (was != isStaged_) {
    p.stages->setVisible(isStaged_);
    p.status->setStaged(isStaged_);
  }
  p.columns->show();
  p.undo->refresh();
  p.refresh();
}

const sdk::Workspace* Workspaces::own() const {
  const auto found = std::find_if(own_.begin(), own_.end(), [this](const Own& each) { return each.what.id == current_; });
  return found != own_.end() ? &found->what : nullptr;
}

bool Workspaces::hasPanels() const { return isAuthor() || parts_.panels->has(current_); }

bool Workspaces::isAtStart() const { return parts_.pages->currentWidget() == parts_.startPage; }

bool Workspaces::isAtWork() const { return parts_.pages->currentWidget() == parts_.workspacePage; }

std::shared_ptr<sdk::PanelDocument> Workspaces::panelDocument() const {
  return isStaged_ && parts_.host != nullptr ? parts_.host->documentInFront() : nullptr;
}

QString Workspaces::authorText() const { return author_->text().remove(QLatin1Char('&')); }

}  // namespace ew::ui
