#pragma once

#include <QAction>
#include <QMenu>
#include <QObject>
#include <functional>
#include <string>
#include <vector>

namespace ew::ui {

struct WindowParts;

/// Entries of menus, and which commands of key_table.h they are: text and keys come from there, as the user chose them.
class Commands final : public QObject {
  Q_OBJECT

 public:
  explicit Commands(WindowParts& parts) : parts_(parts) {}

  /// An entry without keys.
  QAction* addPlain(QMenu& menu, const QString& text, std::function<void()> run);
  /// An entry that is a command: it has that one's text and keys.
  QAction* add(QMenu& menu, const std::string& command, std::function<void()> run);
  /// An entry that moves a control of the console. It is here and not at the control: the console may be hidden beside an author's panels.
  /// @param steps of ConsolePanel::step
  QAction* addConsole(QMenu& menu, const std::string& command, const QString& control, int steps);
  /// An entry that was made elsewhere is a command, or one more.
  void join(QAction* action, const std::string& command) { keyed_.push_back({action, command}); }
  void forget(const QAction* action);
  /// The menu of the scan: none of its entries does anything while a panel's stage lies over the scan.
  void setScanMenu(QMenu& menu) { scanMenu_ = &menu; }
  [[nodiscard]] QMenu* scanMenu() const { return scanMenu_; }

  /// Gives every entry its keys, as the present state has them.
  void showKeys();
  /// Does what a key of the command does. @return false: there is no such command now
  bool run(const std::string& command);

 private:
  struct Keyed {
    QAction* action;
    std::string command;
  };
  WindowParts& parts_;
  std::vector<Keyed> keyed_;  ///< an action may be several commands
  QMenu* scanMenu_ = nullptr;
};

}  // namespace ew::ui
