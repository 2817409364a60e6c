#include "window/frame/commands.h"

#include <map>
#include <utility>

#include "window/frame/window_parts.h"
#include "window/frame/workspaces.h"

namespace ew::ui {
namespace {

bool isBelow(const QWidget* widget, const QWidget* above) {
  while (widget != nullptr && widget != above) widget = widget->parentWidget();
  return widget != nullptr;
}

}  // namespace

QAction* Commands::addPlain(QMenu& menu, const QString& text, std::function<void()> run) {
  QAction* action = menu.addAction(text);
  connect(action, &QAction::triggered, this, [this, &menu, run = std::move(run)] {
    // A key of the scan does nothing while a panel's stage lies over it, whichever submenu it stands in.
    if (!parts_.workspaces->isStaged() || !isBelow(&menu, scanMenu_)) run();
  });
  return action;
}

QAction* Commands::add(QMenu& menu, const std::string& command, std::function<void()> run) {
  const KeyCommand* entry = parts_.keys.find(command);
  QAction* action = addPlain(menu, entry != nullptr ? entry->text() : QString(), std::move(run));
  join(action, command);
  return action;
}

QAction* Commands::addConsole(QMenu& menu, const std::string& command, const QString& control, int steps) {
  return add(menu, command, [this, control, steps] { parts_.console->step(control, steps); });
}

void Commands::forget(const QAction* action) {
  std::erase_if(keyed_, [action](const Keyed& each) { return each.action == action; });
}

void Commands::showKeys() {
  const WindowParts& p = parts_;
  const unsigned state = p.session.isFrozen() || p.session.isPlaying() ? kWhileStill : kWhileRunning;
  std::map<QAction*, QList<QKeySequence>> keys;
  for (const auto& [action, command] : keyed_) {
    const KeyCommand* entry = p.keys.find(command);
    QList<QKeySequence>& its = keys[action];
    // What is off takes no key from others, and its menu says which it has.
    if (entry != nullptr && ((entry->when & state) != 0 || !action->isEnabled())) its << p.keys.keysOf(command);
  }
  for (const auto& [action, its] : keys)
    if (action->shortcuts() != its) action->setShortcuts(its);
}

bool Commands::run(const std::string& command) {
  WindowParts& p = parts_;
  for (const auto& [action, id] : keyed_) {
    if (id != command) continue;
    if (action->isEnabled()) action->trigger();
    return true;
  }
  const bool isScanning = p.session.subject() && !p.workspaces->isStaged() && p.workspaces->isAtWork();
  return isScanning && (p.cineBar->run(command) || p.hand.run(command));
}

}  // namespace ew::ui
