// Plugins in the window: their words, workspaces and entries of menus, and what they throw.
#include <spdlog/spdlog.h>
#include <QLocale>
#include <QPointer>
#include <algorithm>
#include <cctype>
#include <utility>

#include "widgets/words.h"
#include "window/main_window_parts.h"

namespace ew::ui {
namespace {

constexpr int kFirstOwnKey = 3;  // Ctrl+1 and Ctrl+2 are Explore and Author
constexpr int kLastOwnKey = 9;

bool isWorkspaceId(const std::string& id) {
  return !id.empty() && std::all_of(id.begin(), id.end(), [](unsigned char c) { return std::isalnum(c) != 0 || c == '-' || c == '_'; });
}

/// Letters and function keys move the probe and set the console; a tool's key needs Ctrl or Alt.
bool isKeyOfTools(const QKeySequence& keys) {
  return keys.count() > 0 && (keys[0] & (static_cast<int>(Qt::CTRL) | static_cast<int>(Qt::ALT))) != 0;
}

}  // namespace

void MainWindow::loadWordsOf(const door::PluginStatus& plugin) {
  auto own = std::make_unique<QTranslator>();
  if (!own->load(QLocale(), words(plugin.manifest->name), QStringLiteral("_"), wordsOf(plugin.folder))) return;
  QCoreApplication::installTranslator(own.get());
  parts_->pluginWords.push_back(std::move(own));
}

bool MainWindow::addWorkspace(const sdk::Workspace& workspace) {
  Parts& p = *parts_;
  const std::string& id = workspace.id;
  const bool isTaken = id == kExplore || id == kAuthor ||
                       std::any_of(p.ownWorkspaces.begin(), p.ownWorkspaces.end(), [&](const auto& each) { return each.what.id == id; });
  if (isTaken || !isWorkspaceId(id)) return false;
  auto* action = new QAction(words(workspace.title), this);
  action->setCheckable(true);
  p.workspaceActions->addAction(action);
  const int key = kFirstOwnKey + static_cast<int>(p.ownWorkspaces.size());
  QString tip = words(workspace.tip);
  if (key <= kLastOwnKey) {
    KeyCommand command;
    command.id = "workspace." + id;
    command.source = QByteArray::fromStdString(workspace.title);
    command.usual = {QKeySequence(QStringLiteral("Ctrl+%1").arg(key))};
    p.keyedActions.push_back({action, command.id});
    tip = tipWithKeys(tip + QStringLiteral(" (%1)"), command.id);
    p.keys.add(std::move(command));
  }
  connect(action, &QAction::triggered, this, [this, id] { showWorkspace(id); });
  p.viewMenu->insertAction(p.beforeLooks, action);
  p.topBar->addWorkspace(words(id), words(workspace.title), tip, QByteArray::fromStdString(workspace.icon));
  p.ownWorkspaces.push_back({workspace, action});
  return true;
}

sdk::Ticket MainWindow::addTool(const sdk::MenuEntry& entry, std::function<void()> run) {
  Parts& p = *parts_;
  const QKeySequence keys = QKeySequence::fromString(words(entry.keys), QKeySequence::PortableText);
  bool isFree = entry.keys.empty() || isKeyOfTools(keys);
  for (const QAction* other : findChildren<QAction*>()) isFree = isFree && (entry.keys.empty() || !other->shortcuts().contains(keys));
  if (!isFree) spdlog::warn("The keys {} of '{}' belong to the window or the scan; the entry has none.", entry.keys, entry.title);
  auto* action = new QAction(words(entry.title), this);
  KeyCommand command;
  command.id = "tool." + entry.title;
  command.group = KeyGroup::tools;
  command.source = QByteArray::fromStdString(entry.title);
  if (isFree && !entry.keys.empty()) command.usual = {keys};
  while (p.keys.find(command.id) != nullptr) command.id += '+';  // two of one title
  p.keyedActions.push_back({action, command.id});
  p.keys.add(command);
  action->setEnabled(entry.workspace.empty() || entry.workspace == p.workspace);
  action->setVisible(!p.access.isLocked() || entry.workspace == kExplore);
  connect(action, &QAction::triggered, this, [run = std::move(run)] { run(); });
  if (entry.place == sdk::MenuPlace::tools)
    p.toolsMenu->addAction(action);
  else
    p.fileMenu->insertAction(p.beforeOpening, action);
  if (entry.place == sdk::MenuPlace::start) p.startPage->addBeginning(action);
  p.toolsMenu->menuAction()->setVisible(!p.toolsMenu->isEmpty());
  p.tools.push_back({action, entry.workspace});
  return {action, [window = QPointer<MainWindow>(this), action = QPointer<QAction>(action), id = command.id](void*) {
            if (!window || !action) return;
            Parts& of = *window->parts_;
            std::erase_if(of.tools, [&](const auto& each) { return each.action == action; });
            std::erase_if(of.keyedActions, [&](const auto& each) { return each.action == action; });
            of.keys.remove(id);
            delete action;
            of.toolsMenu->menuAction()->setVisible(!of.toolsMenu->isEmpty());
          }};
}

void MainWindow::openPlugins() {
  Parts& p = *parts_;
  if (p.plugins) return;
  p.plugins.emplace();
  for (const door::PluginStatus& plugin : p.plugins->states())
    if (plugin.manifest) loadWordsOf(plugin);
  p.host->setWorkspaceSwitch({[this](const sdk::Workspace& workspace) { return addWorkspace(workspace); },
                              [this](const std::string& id) { showWorkspace(id); }, [this] { return parts_->workspace; }});
  p.host->setMenu([this](const sdk::MenuEntry& entry, std::function<void()> run) { return addTool(entry, std::move(run)); });
  p.plugins->openAll(*p.host, [this](const door::PluginFault& fault) { parts_->messages->showError(words(door::messageOf(fault))); });
  for (const door::PluginStatus& plugin : p.plugins->states()) {
    if (plugin.state != door::PluginState::loaded && plugin.state != door::PluginState::replaced)
      p.messages->showError(words(plugin.message));
  }
  showPanels();
  showAccess();
}

void MainWindow::showThrown(const QObject* receiver, const Thrown& thrown) {
  Parts& p = *parts_;
  if (p.plugins && p.plugins->tellOfPanel(WorkstationHost::panelOf(receiver), thrown)) return;
  p.messages->showError(
      thrown.noMemory ? tr("There is not enough memory for this; close other programs and try again.")
                      : tr("The program met a problem that it did not foresee (%1). Your work is still there: save it, and please report "
                           "this with what you did.")
                            .arg(words(thrown.reason)));
}

}  // namespace ew::ui
