#include "window/features/plugin_hosting.h"

#include <spdlog/spdlog.h>
#include <QAction>
#include <QCoreApplication>
#include <QKeySequence>
#include <QLocale>
#include <QMenu>
#include <QPointer>
#include <algorithm>
#include <optional>
#include <utility>

#include "ew/core/guarded.h"
#include "ew/widgets/question.h"
#include "ew/widgets/words.h"
#include "window/features/opening.h"
#include "window/frame/commands.h"
#include "window/frame/safe_application.h"
#include "window/frame/window_parts.h"
#include "window/frame/workspaces.h"

namespace ew::ui {
namespace {

/// Letters and function keys move the probe and set the console; a tool's key needs Ctrl or Alt.
bool isKeyOfTools(const QKeySequence& keys) {
  return keys.count() > 0 && (keys[0] & (static_cast<int>(Qt::CTRL) | static_cast<int>(Qt::ALT))) != 0;
}

}  // namespace

PluginHosting::~PluginHosting() {
  // A plugin that goes later than this asks a window that has no menus any more.
  parts_.host->setWorkspaceSwitch({});
  parts_.host->setMenu({});
}

void PluginHosting::setToolsMenu(QMenu& tools) {
  toolsMenu_ = &tools;
  toolsMenu_->menuAction()->setVisible(false);
}

void PluginHosting::connectParts() {
  WindowParts& p = parts_;
  if (const auto* application = qobject_cast<SafeApplication*>(QCoreApplication::instance()))
    connect(application, &SafeApplication::thrown, this, &PluginHosting::showThrown);
  connect(p.workspaces, &Workspaces::shown, this, &PluginHosting::refresh);
  p.host->setScan([&p]() -> std::optional<sdk::Cases::Scan> {
    const Session& session = p.session;
    if (!p.opener->showsCase() || !session.subject()) return std::nullopt;
    const Probe& probe = session.console().probe();
    return sdk::Cases::Scan{probe.id,
                            session.probeControl().pose().probeToWorld,
                            session.console().depth_mm(),
                            isSector(probe.kind) ? probe.halfAngle_rad : 0.0,
                            faceHalfWidth_mm(probe),
                            session.subject()->placedGrid};
  });
}

void PluginHosting::refresh() {
  const bool locked = parts_.access.isLocked();
  for (const Tool& tool : tools_) {
    tool.action->setEnabled(tool.workspace.empty() || tool.workspace == parts_.workspaces->current());
    tool.action->setVisible(!locked || tool.workspace == kExplore);
  }
  toolsMenu_->menuAction()->setVisible(!toolsMenu_->isEmpty());  // tools may also stand in the File menu
}

void PluginHosting::holdUnsavedWork(UnsavedWork& list) {
  list.add({"panels",
            {Loss::closing},
            [this] {
              const auto panels = parts_.host->panelsAdded();
              return std::any_of(panels.begin(), panels.end(), [](const sdk::StagePanel* each) {
                const auto document = each->document.lock();
                return document && !document->unsaved().empty();
              });
            },
            [this](Loss, const std::string&) { return mayLeavePanels(); }});
  list.add({"plugins",
            {Loss::scan, Loss::opening, Loss::closing},
            [this] { return !parts_.host->unsaved().empty(); },
            [this](Loss loss, const std::string& next) { return mayLeave(loss, words(next)); }});
}

void PluginHosting::loadWordsOf(const door::PluginStatus& plugin) {
  auto own = std::make_unique<QTranslator>();
  if (!own->load(QLocale(), words(plugin.manifest->name), QStringLiteral("_"), wordsOf(plugin.folder))) return;
  QCoreApplication::installTranslator(own.get());
  words_.push_back(std::move(own));
}

sdk::Ticket PluginHosting::addTool(const sdk::MenuEntry& entry, std::function<void()> run) {
  WindowParts& p = parts_;
  const QKeySequence keys = QKeySequence::fromString(words(entry.keys), QKeySequence::PortableText);
  bool isFree = entry.keys.empty() || isKeyOfTools(keys);
  for (const QAction* other : p.window.findChildren<QAction*>())
    isFree = isFree && (entry.keys.empty() || !other->shortcuts().contains(keys));
  if (!isFree) spdlog::warn("The keys {} of '{}' belong to the window or the scan; the entry has none.", entry.keys, entry.title);
  auto* action = new QAction(words(entry.title), &p.window);
  KeyCommand command;
  command.id = "tool." + entry.title;
  command.group = KeyGroup::tools;
  command.source = QByteArray::fromStdString(entry.title);
  if (isFree && !entry.keys.empty()) command.usual = {keys};
  while (p.keys.find(command.id) != nullptr) command.id += '+';  // two of one title
  p.commands->join(action, command.id);
  p.keys.add(command);
  action->setEnabled(entry.workspace.empty() || entry.workspace == p.workspaces->current());
  action->setVisible(!p.access.isLocked() || entry.workspace == kExplore);
  connect(action, &QAction::triggered, this, [run = std::move(run)] { run(); });
  if (entry.place == sdk::MenuPlace::tools)
    toolsMenu_->addAction(action);
  else
    file_->insertAction(p.opening->firstAction(), action);
  if (entry.place == sdk::MenuPlace::start) p.startPage->addBeginning(action);
  toolsMenu_->menuAction()->setVisible(!toolsMenu_->isEmpty());
  tools_.push_back({action, entry.workspace});
  return {action, [hosting = QPointer<PluginHosting>(this), action = QPointer<QAction>(action), id = command.id](void*) {
            if (!hosting || !action) return;
            WindowParts& of = hosting->parts_;
            std::erase_if(hosting->tools_, [&](const Tool& each) { return each.action == action; });
            of.commands->forget(action);
            of.keys.remove(id);
            delete action;
            hosting->toolsMenu_->menuAction()->setVisible(!hosting->toolsMenu_->isEmpty());
          }};
}

void PluginHosting::open() {
  WindowParts& p = parts_;
  if (p.plugins) return;
  p.plugins.emplace();
  for (const door::PluginStatus& plugin : p.plugins->states())
    if (plugin.manifest) loadWordsOf(plugin);
  p.host->setWorkspaceSwitch({[&p](const sdk::Workspace& workspace) { return p.workspaces->add(workspace); },
                              [&p](const std::string& id) { p.workspaces->show(id); }, [&p] { return p.workspaces->current(); }});
  p.host->setMenu([this](const sdk::MenuEntry& entry, std::function<void()> run) { return addTool(entry, std::move(run)); });
  p.plugins->openAll(*p.host, [&p](const door::PluginFault& fault) { p.messages->showError(words(door::messageOf(fault))); });
  for (const door::PluginStatus& plugin : p.plugins->states()) {
    if (plugin.state != door::PluginState::loaded && plugin.state != door::PluginState::replaced)
      p.messages->showError(words(plugin.message));
  }
  p.workspaces->showPanels();
  p.refresh();
}

void PluginHosting::showThrown(const QObject* receiver, const Thrown& thrown) {
  WindowParts& p = parts_;
  if (p.plugins && p.plugins->tellOfPanel(WorkstationHost::panelOf(receiver), thrown)) return;
  p.messages->showError(
      thrown.noMemory ? tr("There is not enough memory for this; close other programs and try again.")
                      : tr("The program met a problem that it did not foresee (%1). Your work is still there: save it, and please report "
                           "this with what you did.")
                            .arg(words(thrown.reason)));
}

bool PluginHosting::mayLeavePanels() {
  for (const sdk::StagePanel* panel : parts_.host->panelsAdded()) {
    const auto document = panel->document.lock();
    const QString unsaved = document ? words(document->unsaved()) : QString();
    if (unsaved.isEmpty()) continue;
    const auto answer = askBeforeLeaving(&parts_.window, {"unsavedPluginQuestion", unsaved, words(panel->title)});
    if (answer == QMessageBox::Discard) continue;
    if (answer != QMessageBox::Save) return false;
    document->save(false);
    if (!parts_.isSavedNow() || !document->unsaved().empty()) return false;
  }
  return true;
}

bool PluginHosting::mayLeave(Loss loss, const QString& next) {
  for (const sdk::UnsavedWork& work : parts_.host->unsaved()) {
    if (loss != Loss::closing && !work.goesWithScan) continue;
    const auto answer =
        askBeforeLeaving(&parts_.window, {"unsavedPluginQuestion", words(work.sentence()), {}, static_cast<bool>(work.save)}, next);
    if (answer == QMessageBox::Discard) continue;
    if (answer != QMessageBox::Save || !work.save() || !parts_.isSavedNow() || !work.sentence().empty()) return false;
  }
  return true;
}

}  // namespace ew::ui
