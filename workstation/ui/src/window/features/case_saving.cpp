#include "window/features/case_saving.h"

#include <QAction>
#include <QDateTime>
#include <QLocale>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QScopedValueRollback>
#include <algorithm>
#include <chrono>
#include <memory>
#include <string>
#include <utility>

#include "case/case_folder_dialog.h"
#include "ew/core/fingerprint.h"
#include "ew/core/foreign_json.h"
#include "ew/library/access.h"
#include "ew/library/case.h"
#include "ew/widgets/question.h"
#include "ew/widgets/words.h"
#include "window/features/opening.h"
#include "window/frame/commands.h"
#include "window/frame/window_parts.h"
#include "window/frame/workspaces.h"

namespace ew::ui {
namespace {

constexpr int kKeepAfter_ms = 400;  // a crash takes no more than this; typing writes no file a letter

// Topics of messages: of two about saving the same thing only the later one is true.
const QString kSavingCase = QStringLiteral("save case");
const QString kKeeping = QStringLiteral("keep edits");
const auto kEditing = QStringLiteral("edit case");

/// A case that another program or window has saved meanwhile.
enum class Keep { nothing, elsewhere, theirs, ours };

Keep askWhichToKeep(QWidget* parent, const QString& title) {
  QMessageBox question(parent);
  question.setObjectName(QStringLiteral("changedOnDiskQuestion"));
  question.setIcon(QMessageBox::NoIcon);
  question.setText(CaseSaving::tr("The case '%1' was saved by another window or program since it was opened here.").arg(title));
  question.setInformativeText(
      CaseSaving::tr("Save as keeps both, each in a folder of its own. Reload drops the changes made here. Overwrite drops the others'."));
  auto* elsewhere = question.addButton(CaseSaving::tr("Save as…"), QMessageBox::AcceptRole);
  auto* theirs = question.addButton(CaseSaving::tr("Reload"), QMessageBox::DestructiveRole);
  auto* ours = question.addButton(CaseSaving::tr("Overwrite"), QMessageBox::DestructiveRole);
  elsewhere->setObjectName(QStringLiteral("keepBoth"));
  theirs->setObjectName(QStringLiteral("reload"));
  ours->setObjectName(QStringLiteral("overwrite"));
  question.addButton(QMessageBox::Cancel);
  question.setDefaultButton(elsewhere);
  question.exec();
  if (question.clickedButton() == elsewhere) return Keep::elsewhere;
  if (question.clickedButton() == theirs) return Keep::theirs;
  return question.clickedButton() == ours ? Keep::ours : Keep::nothing;
}

QString whyPublishedIsCopied(const QString& title) {
  return CaseSaving::tr("Published cases are not edited in place, for attempts of trainees refer to them. Save '%1' as a case of your own.")
      .arg(title);
}

QString wordsOfTime(const std::chrono::system_clock::time_point& at) {
  return QLocale().toString(QDateTime::fromSecsSinceEpoch(std::chrono::system_clock::to_time_t(at)), QLocale::ShortFormat);
}

}  // namespace

CaseSaving::CaseSaving(WindowParts& parts) : Feature(parts), keptEdits_(ownDataFolder() / "unsaved-cases") {
  keepSoon_.setSingleShot(true);
  keepSoon_.setInterval(kKeepAfter_ms);
}

void CaseSaving::addActions(QMenu& file) {
  save_ = parts_.commands->add(file, "save", [this] { save(false); });
  saveAs_ = parts_.commands->add(file, "save.as", [this] { save(true); });
}

void CaseSaving::connectParts() {
  WindowParts& p = parts_;
  connect(&p.document, &CaseDocument::changed, this, [this] {
    if (!keepSoon_.isActive()) keepSoon_.start();
  });
  connect(&p.document, &CaseDocument::leaseLost, this, [this](const Error& why) { parts_.messages->showError(why, kEditing); });
  connect(&keepSoon_, &QTimer::timeout, this, &CaseSaving::keepEdits);
  p.host->setCaseSaving({[this](const std::filesystem::path& folder) { return saveFor(folder); }, [this] { return makeOwn(); },
                         [this] { return saveCopy({}); }});
}

void CaseSaving::refresh() {
  const bool ofPanel = parts_.workspaces->panelDocument() != nullptr;
  save_->setText(ofPanel ? tr("&Save project") : tr("&Save case"));
  saveAs_->setText(ofPanel ? tr("Save project &as…") : tr("Save case &as…"));
  const bool canSave = (ofPanel || parts_.document.current().has_value()) && parts_.access.may(Permission::editCases);
  for (QAction* action : {save_, saveAs_}) {
    action->setEnabled(canSave);
    action->setVisible(!parts_.access.isLocked());
  }
}

void CaseSaving::holdUnsavedWork(UnsavedWork& list) {
  list.add({"case",
            {Loss::opening, Loss::closing},
            [this] { return parts_.document.hasUnsavedChanges(); },
            [this](Loss, const std::string& next) { return mayLeave(words(next)); }});
}

bool CaseSaving::mayLeave(const QString& next) {
  if (!parts_.document.hasUnsavedChanges() || (dropsEdits_ && !next.isEmpty())) return true;
  const auto answer = askBeforeLeaving(
      &parts_.window,
      {"unsavedQuestion", tr("The case '%1' has changes that are not saved.").arg(words(parts_.document.current()->title)), {}}, next);
  return answer == QMessageBox::Discard || (answer == QMessageBox::Save && saveCase(false));
}

void CaseSaving::reload() {
  parts_.opener->open(wordsOf(parts_.document.current()->folder));
  dropsEdits_ = true;  // decided; a case that cannot be opened keeps them all the same
}

void CaseSaving::forgetEdits() {
  keepSoon_.stop();
  keptEdits_.forget();
}

void CaseSaving::openingEnded() {
  dropsEdits_ = false;
  restoring_.reset();
}

void CaseSaving::offerKeptEdits(const std::filesystem::path& caseFolder) {
  if (parts_.access.isLocked()) return;  // they are an author's, and wait
  if (asksAboutKept_) return;            // a case that came while somebody thinks about its edits
  offeredFor_.push_back(caseFolder);
  if (!isLooking_) lookForKept();
}

void CaseSaving::lookForKept() {
  isLooking_ = true;
  auto found = std::make_shared<std::vector<EditsLeft>>();
  parts_.jobs.start(
      tr("Looking for unsaved changes"),
      [found, root = keptEdits_.root()](Progress& progress) -> Result<void> {
        for (EditAutosave::Left& left : EditAutosave(root).left()) {
          if (progress.cancelRequested()) break;
          auto edited = caseFromManifest(left.manifest, left.caseFolder);
          found->push_back({std::move(left), std::move(edited)});
        }
        // A window that is being closed asks nothing.
        if (progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"Stopped as asked.">());
        return {};
      },
      [this, found, folders = std::exchange(offeredFor_, {})](const Result<void>& outcome) {
        isLooking_ = false;
        if (!outcome) return;
        askAboutKept(*found, folders);
        if (!isLooking_ && !offeredFor_.empty()) lookForKept();  // who asked meanwhile may know of edits that came meanwhile
      },
      Jobs::Kind::background);
}

void CaseSaving::askAboutKept(const std::vector<EditsLeft>& all, const std::vector<std::filesystem::path>& folders) {
  WindowParts& p = parts_;
  if (p.access.isLocked() || asksAboutKept_) return;
  const QScopedValueRollback<bool> asks(asksAboutKept_, true);
  for (const EditsLeft& each : all) {
    const EditAutosave::Left& left = each.left;
    const bool isLater = std::find(decideLater_.begin(), decideLater_.end(), left.kept) != decideLater_.end();
    const bool isAskedFor =
        std::any_of(folders.begin(), folders.end(), [&](const auto& folder) { return folder.empty() || folder == left.caseFolder; });
    if (isLater || restoring_ || !isAskedFor) continue;
    QMessageBox question(&p.window);
    question.setObjectName(QStringLiteral("keptEditsQuestion"));
    question.setIcon(QMessageBox::NoIcon);
    question.setText(tr("The case '%1' has changes of %2 that were not saved when the program ended.")
                         .arg(words(textAt(left.manifest, "title")), wordsOfTime(left.at)));
    question.setInformativeText(tr("Folder: %1").arg(wordsOf(left.caseFolder)));
    auto* open = question.addButton(tr("Open with these changes"), QMessageBox::AcceptRole);
    auto* discard = question.addButton(tr("Throw them away"), QMessageBox::DestructiveRole);
    auto* later = question.addButton(tr("Decide later"), QMessageBox::RejectRole);
    open->setObjectName(QStringLiteral("openKept"));
    discard->setObjectName(QStringLiteral("discardKept"));
    question.setDefaultButton(open);
    question.setEscapeButton(later);
    question.exec();
    if (question.clickedButton() == discard) {
      EditAutosave::remove(left);
    } else if (question.clickedButton() == open) {
      const auto& current = p.document.current();
      const bool isOpen = current && current->folder == left.caseFolder;
      if (!isOpen) p.opener->open(wordsOf(left.caseFolder));
      restoring_ = each;  // once it is open; what was being opened before has been given up
      if (isOpen) restoreKeptEdits();
    } else {
      decideLater_.push_back(left.kept);
    }
  }
}

void CaseSaving::caseOpened() {
  if (restoring_)
    restoreKeptEdits();
  else if (const auto& current = parts_.document.current())
    offerKeptEdits(current->folder);
}

void CaseSaving::keepEdits() {
  WindowParts& p = parts_;
  if (!p.document.hasUnsavedChanges()) return keptEdits_.forget();
  const auto kept = keptEdits_.keep(*p.document.current(), p.document.asRead().value_or(Fingerprint{}));
  if (kept) return p.messages->forget(kKeeping);
  p.messages->showError(kept.error(), kKeeping);
}

void CaseSaving::restoreKeptEdits() {
  WindowParts& p = parts_;
  const auto left = std::exchange(restoring_, std::nullopt);
  if (!left || !p.document.current() || p.document.current()->folder != left->left.caseFolder) return;
  const auto& [kept, edited] = *left;
  const auto restored =
      edited ? p.document.restore(*edited, tr("Take over the changes of %1").arg(wordsOfTime(kept.at)).toStdString(), kept.asRead)
             : Result<void>(passOn(edited.error()));
  if (!restored) {
    decideLater_.push_back(kept.kept);
    p.messages->showError(restored.error());
    return;
  }
  keepEdits();  // here, before they are gone there
  EditAutosave::remove(kept);
}

void CaseSaving::save(bool elsewhere) {
  if (const auto document = parts_.workspaces->panelDocument())
    document->save(elsewhere);
  else
    saveCase(elsewhere);
}

bool CaseSaving::saveCase(bool elsewhere) {
  const auto saved = elsewhere ? saveCopy({}) : saveInPlace();
  if (saved && !elsewhere) parts_.messages->forget(kSavingCase);
  if (!saved && saved.error().code != ErrorCode::cancelled) parts_.messages->showError(saved.error(), kSavingCase);
  return saved.has_value();
}

Result<void> CaseSaving::saveInPlace() {
  if (auto allowed = parts_.access.require(Permission::editCases); !allowed) return allowed;
  CaseDocument& document = parts_.document;
  if (!document.current()) return failure(ErrorCode::badUsage, say<"No case is open; open one first.">());
  const auto unsaved = failure(ErrorCode::cancelled, say<"The case is not saved.">());
  const QString title = words(document.current()->title);
  CaseOverwrite decided;
  if (document.isPublishedCase()) return saveCopy(whyPublishedIsCopied(title));
  document.refreshLease();
  if (document.lost()) return saveCopy(words(document.lost()->message));
  if (document.isShippedCase()) {
    QMessageBox question(&parts_.window);
    question.setObjectName(QStringLiteral("shippedQuestion"));
    question.setIcon(QMessageBox::NoIcon);
    question.setText(tr("The case '%1' belongs to the program.").arg(title));
    question.setInformativeText(tr("Save a copy of your own: the next version of the program replaces what is changed in its own cases."));
    auto* copy = question.addButton(tr("Save a copy…"), QMessageBox::AcceptRole);
    auto* shipped = question.addButton(tr("Change the program's case"), QMessageBox::DestructiveRole);
    copy->setObjectName(QStringLiteral("saveCopy"));
    shipped->setObjectName(QStringLiteral("changeShipped"));
    question.addButton(QMessageBox::Cancel);
    question.setDefaultButton(copy);
    question.exec();
    if (question.clickedButton() == copy) return saveCopy({});
    if (question.clickedButton() != shipped) return unsaved;
    decided.shipped = true;
  }
  if (document.isChangedOnDisk()) {
    switch (askWhichToKeep(&parts_.window, title)) {
      case Keep::elsewhere:
        return saveCopy({});
      case Keep::theirs:
        reload();
        return unsaved;
      case Keep::nothing:
        return unsaved;
      case Keep::ours:
        decided.changedOnDisk = true;
    }
  }
  return document.save({}, decided);
}

Result<void> CaseSaving::saveCopy(const QString& why) {
  if (auto allowed = parts_.access.require(Permission::editCases); !allowed) return allowed;
  CaseDocument& document = parts_.document;
  if (!document.current()) return failure(ErrorCode::badUsage, say<"No case is open; open one first.">());
  std::filesystem::path present = document.current()->folder;
  if (!present.has_filename()) present = present.parent_path();
  CaseFolderDialog dialog(why, wordsOf(present.filename()), &parts_.window);
  if (dialog.exec() != QDialog::Accepted) return failure(ErrorCode::cancelled, say<"The case is not saved.">());
  const std::filesystem::path folder = dialog.folder();
  if (auto saved = saveElsewhere(folder); !saved) return saved;
  parts_.opening->remember(wordsOf(folder));
  parts_.opening->rememberOpen(wordsOf(folder));
  parts_.messages->showNote(tr("Saved in %1.").arg(wordsOf(folder)), kSavingCase);
  return {};
}

Result<void> CaseSaving::saveElsewhere(const std::filesystem::path& folder) {
  const std::filesystem::path present = parts_.document.current()->folder;
  std::string idThere;
  auto looked = parts_.jobs.await(tr("Looking at the cases beside it"), [&](Progress&) -> Result<void> {
    idThere = idForFolder(folder);
    return {};
  });
  if (!looked) return looked;
  if (!parts_.document.current() || parts_.document.current()->folder != present)
    return failure(ErrorCode::cancelled, say<"The case is not saved.">());
  return parts_.document.save(folder, {}, idThere);
}

Result<void> CaseSaving::saveFor(const std::filesystem::path& folder) {
  if (auto allowed = parts_.access.require(Permission::editCases); !allowed) return allowed;
  if (folder.empty()) return saveInPlace();
  if (!parts_.document.current()) return failure(ErrorCode::badUsage, say<"No case is open; open one first.">());
  if (auto saved = folder == parts_.document.current()->folder ? parts_.document.save(folder) : saveElsewhere(folder); !saved) return saved;
  parts_.opening->remember(wordsOf(folder));
  parts_.opening->rememberOpen(wordsOf(folder));
  return {};
}

Result<void> CaseSaving::makeOwn() {
  if (auto allowed = parts_.access.require(Permission::editCases); !allowed) return allowed;
  CaseDocument& document = parts_.document;
  if (!document.current()) return failure(ErrorCode::badUsage, say<"No case is open; open one first.">());
  const QString title = words(document.current()->title);
  if (document.isPublishedCase()) return saveCopy(whyPublishedIsCopied(title));
  if (document.isShippedCase())
    return saveCopy(tr("The case '%1' belongs to the program. It is copied to a folder of your own first, and changed there.").arg(title));
  if (const auto taken = document.reserve(); !taken) return saveCopy(words(taken.error().message));
  return {};
}

}  // namespace ew::ui
