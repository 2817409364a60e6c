// The lock for trainees on an account that they share with instructors: what the window shows while it is closed.
#include <QMenu>

#include "ew/library/learning.h"
#include "ew/sdk/person.h"
#include "widgets/words.h"
#include "window/access_dialog.h"
#include "window/main_window_parts.h"

namespace ew::ui {
namespace {

const QString kAccess = QStringLiteral("access");

/// The attempt in whose folder a file lies, or that a folder is; empty: the path is none of the library's attempts.
std::optional<Attempt> attemptAround(const std::filesystem::path& path) {
  std::error_code failed;
  const auto root = std::filesystem::weakly_canonical(attemptsFolder(libraryFolder()), failed);
  for (auto at = std::filesystem::weakly_canonical(path, failed); !failed && at.has_relative_path(); at = at.parent_path())
    if (at.parent_path() == root) {
      const auto kept = KeptAttempt::open(at);
      return kept ? kept->attempt() : Attempt();  // one that cannot be read is nobody's that is known
    }
  return std::nullopt;
}

}  // namespace

void MainWindow::addAccessMenu(QMenu& file) {
  Parts& p = *parts_;
  p.lockAction = addPlainAction(file, tr("Lock for trainees…"), [this] { lockForTrainees(); });
  p.lockAction->setObjectName(QStringLiteral("lockForTrainees"));
  p.unlockAction = addPlainAction(file, tr("Unlock for instructors…"), [this] { unlockForInstructors(); });
  p.unlockAction->setObjectName(QStringLiteral("unlockForInstructors"));
  p.removeLockAction = addPlainAction(file, tr("Take the lock away"), [this] {
    const auto removed = removeLock(parts_->access, sdk::personWhoLearns());
    if (!removed) return parts_->messages->showError(removed.error(), kAccess);
    showAccess();
    parts_->host->tellAccessChanged();
    parts_->messages->showNote(tr("The lock is gone: everybody at this account sees everything."), kAccess);
  });
  p.removeLockAction->setObjectName(QStringLiteral("removeLock"));
}

bool MainWindow::may(Permission permission) {
  const auto allowed = parts_->access.require(permission);
  if (!allowed) parts_->messages->showError(allowed.error(), kAccess);
  return allowed.has_value();
}

bool MainWindow::mayOpenPath(const QString& path) {
  if (!parts_->access.isLocked()) return true;
  const auto attempt = attemptAround(pathOf(path));
  if (!attempt) return true;
  // What names nobody may be anybody's.
  const auto allowed = attempt->person.empty() ? parts_->access.require(Permission::seeOthersAttempts)
                                               : ew::mayOpen(*attempt, sdk::personWhoLearns(), parts_->access);
  if (!allowed) parts_->messages->showError(allowed.error(), kAccess);
  return allowed.has_value();
}

void MainWindow::lockForTrainees() {
  Parts& p = *parts_;
  if (!mayLeaveCase({})) return;
  if (p.access.hasLock()) {
    p.access.lockAgain();
  } else {
    auto* dialog = new AccessDialog(  // it deletes itself
        AccessDialog::Asks::fresh, tr("Lock for trainees"),
        tr("Until this passphrase is given again the window shows Explore alone: no Author, no answers, nobody else's attempts. The lock "
           "does not stop who reads this account's files with other programs: for examinations export cases with sealed answers."),
        [&p](const Passphrase& passphrase) { return setLock(p.access, passphrase, sdk::personWhoLearns()); }, this);
    if (dialog->exec() != QDialog::Accepted) return;
  }
  // Undo would bring back what an author wrote, and edits would lie there unsaved.
  const bool hadEdits = p.document.hasUnsavedChanges();
  p.document.history().clear();
  p.keptEdits.forget();
  if (hadEdits) reloadCase();
  showAccess();
  p.host->tellAccessChanged();
  p.messages->showNote(tr("Locked for trainees."), kAccess);
}

void MainWindow::unlockForInstructors() {
  Parts& p = *parts_;
  auto* dialog = new AccessDialog(  // it deletes itself
      AccessDialog::Asks::known, tr("Unlock for instructors"), tr("The passphrase that locked this library for trainees."),
      [&p](const Passphrase& passphrase) { return p.access.unlock(passphrase, sdk::personWhoLearns()); }, this);
  if (dialog->exec() != QDialog::Accepted) return;
  showAccess();
  p.host->tellAccessChanged();
  p.messages->showNote(tr("Unlocked until you lock it again or close the window."), kAccess);
}

void MainWindow::showAccess() {
  Parts& p = *parts_;
  const bool locked = p.access.isLocked();
  p.lockAction->setText(p.access.hasLock() ? tr("Lock again") : tr("Lock for trainees…"));
  p.lockAction->setVisible(!locked);
  p.unlockAction->setVisible(locked);
  p.removeLockAction->setVisible(p.access.hasLock() && !locked);
  const auto showRoom = [&](const std::string& id, QAction* action) {
    action->setVisible(!locked);
    action->setEnabled(!locked);
    p.topBar->setShown(words(id), !locked);
  };
  showRoom(kAuthor, p.authorAction);
  for (const auto& own : p.ownWorkspaces) showRoom(own.what.id, own.action);
  for (const auto& tool : p.tools) tool.action->setVisible(!locked || tool.workspace == kExplore);
  p.toolsMenu->menuAction()->setVisible(!p.toolsMenu->isEmpty());  // tools may also stand in the File menu
  for (QAction* action : {p.saveAction, p.saveAsAction}) action->setVisible(!locked);
  if (locked && p.workspace != kExplore) showWorkspace(kExplore);
  showTitle();
}

}  // namespace ew::ui
