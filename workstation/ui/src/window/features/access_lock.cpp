#include "window/features/access_lock.h"

#include <QMenu>
#include <filesystem>
#include <optional>
#include <system_error>

#include "ew/library/access.h"
#include "ew/library/attempt.h"
#include "ew/library/folders.h"
#include "ew/library/learning_progress.h"
#include "ew/sdk/person.h"
#include "ew/widgets/words.h"
#include "window/features/case_saving.h"
#include "window/frame/access_dialog.h"
#include "window/frame/commands.h"
#include "window/frame/window_parts.h"
#include "window/frame/workspaces.h"

namespace ew::ui {
namespace {

const QString kAccess = QStringLiteral("access");

/// The attempt in whose folder a file lies, or that a folder is; empty: the path is none of the library's attempts.
std::optional<Attempt> attemptAround(const std::filesystem::path& path) {
  std::error_code failed;
  const auto root = std::filesystem::weakly_canonical(attemptsFolder(libraryFolder()), failed);
  for (auto at = std::filesystem::weakly_canonical(path, failed); !failed && at.has_relative_path(); at = at.parent_path())
    if (at.parent_path() == root) {
      const auto kept = AttemptFolder::open(at);
      return kept ? kept->attempt() : Attempt();  // one that cannot be read is nobody's that is known
    }
  return std::nullopt;
}

}  // namespace

void AccessLock::addActions(QMenu& file) {
  Commands& commands = *parts_.commands;
  lock_ = commands.addPlain(file, tr("Lock for trainees…"), [this] { lock(); });
  lock_->setObjectName(QStringLiteral("lockForTrainees"));
  unlock_ = commands.addPlain(file, tr("Unlock for instructors…"), [this] { unlock(); });
  unlock_->setObjectName(QStringLiteral("unlockForInstructors"));
  remove_ = commands.addPlain(file, tr("Take the lock away"), [this] { remove(); });
  remove_->setObjectName(QStringLiteral("removeLock"));
}

void AccessLock::refresh() {
  const bool locked = parts_.access.isLocked();
  lock_->setText(parts_.access.hasLock() ? tr("Lock again") : tr("Lock for trainees…"));
  lock_->setVisible(!locked);
  unlock_->setVisible(locked);
  remove_->setVisible(parts_.access.hasLock() && !locked);
}

bool AccessLock::mayOpen(const QString& path) {
  if (!parts_.access.isLocked()) return true;
  const auto attempt = attemptAround(pathOf(path));
  if (!attempt) return true;
  // What names nobody may be anybody's.
  const auto allowed = attempt->person.empty() ? parts_.access.require(Permission::seeOthersAttempts)
                                               : ew::mayOpen(*attempt, sdk::personWhoLearns(), parts_.access);
  if (!allowed) parts_.messages->showError(allowed.error(), kAccess);
  return allowed.has_value();
}

void AccessLock::lock() {
  WindowParts& p = parts_;
  if (!p.caseSaving->mayLeave({})) return;
  if (p.access.hasLock()) {
    p.access.lockAgain();
  } else {
    auto* dialog = new AccessDialog(  // it deletes itself
        AccessDialog::Asks::fresh, tr("Lock for trainees"),
        tr("Until this passphrase is given again the window shows Explore alone: no Author, no answers, nobody else's attempts. The lock "
           "does not stop who reads this account's files with other programs: for examinations export cases with sealed answers."),
        [&p](const Passphrase& passphrase) { return setLock(p.access, passphrase, sdk::personWhoLearns()); }, &p.window);
    if (dialog->exec() != QDialog::Accepted) return;
  }
  // Undo would bring back what an author wrote, and edits would lie there unsaved.
  const bool hadEdits = p.document.hasUnsavedChanges();
  p.document.forgetSteps();
  p.caseSaving->forgetEdits();
  if (hadEdits) p.caseSaving->reload();
  changed();
  p.host->tellAccessChanged();
  p.messages->showNote(tr("Locked for trainees."), kAccess);
}

void AccessLock::unlock() {
  WindowParts& p = parts_;
  auto* dialog = new AccessDialog(  // it deletes itself
      AccessDialog::Asks::known, tr("Unlock for instructors"), tr("The passphrase that locked this library for trainees."),
      [&p](const Passphrase& passphrase) { return p.access.unlock(passphrase, sdk::personWhoLearns()); }, &p.window);
  if (dialog->exec() != QDialog::Accepted) return;
  changed();
  p.host->tellAccessChanged();
  p.messages->showNote(tr("Unlocked until you lock it again or close the window."), kAccess);
}

void AccessLock::remove() {
  const auto removed = removeLock(parts_.access, sdk::personWhoLearns());
  if (!removed) return parts_.messages->showError(removed.error(), kAccess);
  changed();
  parts_.host->tellAccessChanged();
  parts_.messages->showNote(tr("The lock is gone: everybody at this account sees everything."), kAccess);
}

void AccessLock::changed() {
  if (parts_.access.isLocked() && parts_.workspaces->current() != kExplore) parts_.workspaces->show(kExplore);
  parts_.refresh();
}

}  // namespace ew::ui
