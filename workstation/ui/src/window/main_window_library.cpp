#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ew/library/bundle.h"
#include "ew/library/case_words.h"
#include "ew/library/lesson.h"
#include "ew/library/published.h"
#include "ew/library/withdrawn.h"
#include "ew/sdk/person.h"
#include "widgets/words.h"
#include "window/main_window_parts.h"

// The start page: what the library's index finds, with what is read for the cards in sight.

namespace ew::ui {
namespace {

constexpr int kDetailsAfter_ms = 40;  // of rest: whoever scrolls through a thousand cards does not wait for their pictures
const auto kWithdrawing = QStringLiteral("withdraw");

/// Whether a file goes with a case that is taken out of the library: it lies in its folder, or with another revision of a published one.
bool goesWith(const std::filesystem::path& caseFolder, const std::filesystem::path& file) {
  std::error_code failed;
  std::filesystem::path goes = std::filesystem::weakly_canonical(caseFolder, failed);
  if (goes.parent_path().parent_path() == std::filesystem::weakly_canonical(publishedFolder(libraryFolder()), failed))
    goes = goes.parent_path();
  const auto inside = std::filesystem::weakly_canonical(file, failed).lexically_relative(goes);
  return !inside.empty() && *inside.begin() != "..";
}

}  // namespace

void MainWindow::connectLibrary() {
  Parts& p = *parts_;
  p.detailsSoon.setSingleShot(true);
  p.detailsSoon.setInterval(kDetailsAfter_ms);
  connect(&p.detailsSoon, &QTimer::timeout, this, &MainWindow::readDetails);
  connect(p.startPage, &StartPage::sightChanged, &p.detailsSoon, QOverload<>::of(&QTimer::start));
  connect(p.startPage, &StartPage::listed, this, [this] {
    parts_->detailsSoon.start();
    showRecent();
  });
  connect(p.startPage, &StartPage::problem, this, [this](const Error& error) { parts_->messages->showError(error); });
  connect(&p.library, &LibraryBrowser::opened, this, [this] { parts_->startPage->setIndex(parts_->library.index()); });
  connect(&p.library, &LibraryBrowser::changed, this, [this] { parts_->startPage->showFound(); });
  connect(&p.library, &LibraryBrowser::refreshed, this, [this] {
    parts_->startPage->setReading(false);
    // A refresh that began before the import does not know the case yet; another one follows.
    if (!parts_->imported.isEmpty() && parts_->startPage->choose(parts_->imported)) parts_->imported.clear();
  });
  connect(&p.library, &LibraryBrowser::noted, this, [this](const QString& note) { parts_->messages->showNote(note); });
  connect(&p.library, &LibraryBrowser::failed, this, [this](const Error& error) { parts_->messages->showError(error); });
  connect(&p.learning, &Learning::changed, this, [this] { parts_->startPage->showLearning(parts_->learning.shared()); });
  connect(&p.learning, &Learning::failed, this, [this](const Error& error) { parts_->messages->showError(error); });
  connect(p.startPage, &StartPage::lessonChosen, this, &MainWindow::openLesson);
  connect(p.startPage, &StartPage::withdrawRequested, this, &MainWindow::withdraw);
  connect(&p.details, &CaseDetails::pictureRead, p.startPage, &StartPage::setThumbnail);
  connect(&p.details, &CaseDetails::caseRead, this, &MainWindow::showPreparation);
}

void MainWindow::withdraw(const QString& folder, const QString& title) {
  if (parts_->access.isLocked()) return;
  const auto isUsedHere = [this, folder] {
    const std::vector<std::filesystem::path> used = parts_->opener->sources();
    return parts_->opener->isOpening(folder) ||
           std::any_of(used.begin(), used.end(), [&](const auto& file) { return goesWith(pathOf(folder), file); });
  };
  const auto refuse = [this, title] {
    parts_->messages->showError(
        tr("'%1' is in use in this window. Close it first, by opening another case; then it can be taken out of the library.").arg(title),
        kWithdrawing);
  };
  if (isUsedHere()) return refuse();
  QMessageBox question(this);
  question.setObjectName(QStringLiteral("withdrawQuestion"));
  question.setWindowTitle(tr("Take out of the library"));
  question.setText(tr("Take '%1' out of the library?").arg(title));
  question.setInformativeText(tr(
      "Nobody finds it any more. Nothing is deleted: its folder is moved to 'withdrawn' in the library, and moved back to its place it is "
      "there again. Attempts stay."));
  QPushButton* take = question.addButton(tr("Take it out"), QMessageBox::AcceptRole);
  take->setObjectName(QStringLiteral("withdrawNow"));
  question.setDefaultButton(question.addButton(QMessageBox::Cancel));
  question.exec();
  if (question.clickedButton() != take) return;
  if (isUsedHere()) return refuse();  // it was opened meanwhile
  const auto taken = withdrawCase(pathOf(folder), libraryFolder(), sdk::personWhoLearns());
  if (!taken) return parts_->messages->showError(taken.error());
  parts_->messages->showNote(tr("'%1' was taken out of the library. It lies in %2; moved back to %3, it is there again.")
                                 .arg(title, wordsOf(taken->folder), wordsOf(taken->from)));
  parts_->library.refresh();
}

void MainWindow::chooseBundle() {
  const QString file = QFileDialog::getOpenFileName(this, tr("Import a case bundle"), QString(), tr("Case bundles (*.ewcase)"));
  if (!file.isEmpty()) importCase(file);
}

void MainWindow::importCase(const QString& bundle) {
  if (!parts_->session.subject()) showStartPage();
  auto taken = std::make_shared<PublishedCase>();
  const QString name = QFileInfo(bundle).fileName();
  parts_->jobs.start(
      tr("Importing %1").arg(name),
      [taken, bundle](Progress& progress) -> Result<void> {
        auto imported = importBundle(pathOf(bundle), libraryFolder(), {}, progress);
        if (!imported) return passOn(imported.error());
        *taken = std::move(*imported);
        return {};
      },
      [this, taken, name](const Result<void>& outcome) {
        const QString topic = QStringLiteral("import ") + name;
        if (!outcome) {
          if (outcome.error().code != ErrorCode::cancelled) parts_->messages->showError(outcome.error(), topic);
          return;
        }
        const auto opened = loadCase(taken->folder);
        const QString title = opened ? words(parts_->isAuthor() ? opened->title : titleForTrainees(*opened)) : words(taken->id);
        parts_->messages->showNote(taken->wasThere ? tr("'%1' is in the library already, as revision %2.").arg(title).arg(taken->revision)
                                                   : tr("'%1' was taken into the library as revision %2.").arg(title).arg(taken->revision),
                                   topic);
        parts_->imported = wordsOf(taken->folder);
        showStartPage();
      });
}

void MainWindow::openLesson(const QString& folder, const QString& lessonId) {
  Parts& p = *parts_;
  setWorkspace(Workspace::explore);
  p.host->askFor(pathOf(folder), std::string(kLessonsPart), lessonId.toStdString());
  showColumn(Column::panels);  // where it is worked on; behind a tab it would not even begin
  const auto& present = p.document.current();
  if (present && p.opener->showsCase() && present->folder == pathOf(folder)) return backToWork();
  open(folder);
}

void MainWindow::prepareCases() {
  if (const auto folder = shippedCasesFolder()) parts_->preparation.start(listCases(*folder).cases);
}

void MainWindow::readDetails() {
  if (parts_->pages->currentWidget() != parts_->startPage) return;
  parts_->details.want(parts_->startPage->foldersInSight());
  showPreparation();
}

void MainWindow::showPreparation() {
  if (parts_->pages->currentWidget() != parts_->startPage) return;
  for (const QString& folder : parts_->startPage->foldersInSight()) {
    const Case* shown = parts_->details.of(folder);
    if (shown == nullptr) continue;
    const auto seen = parts_->preparation.seen(*shown);
    const QString takes = aboutMinutes(seen.estimate_s);
    switch (seen.state) {
      case CasePreparation::State::ready:
        parts_->startPage->setState(folder, {}, 0.0);
        break;
      case CasePreparation::State::running:
        parts_->startPage->setState(folder, seen.step.isEmpty() ? tr("Preparing") : seen.step, seen.fraction);
        break;
      case CasePreparation::State::waiting:
        parts_->startPage->setState(folder, tr("Will be prepared, %1").arg(takes), 0.0);
        break;
      case CasePreparation::State::stopped:
        // What has no sweeps is shown at once, as a draft.
        parts_->startPage->setState(folder,
                                    shown->volume.sweeps.empty() ? tr("Coarse at first, whole in %1").arg(takes)
                                                                 : tr("Not prepared yet, %1; open it to begin").arg(takes),
                                    0.0);
        break;
    }
  }
}

void MainWindow::fillStartPage() {
  const auto shipped = shippedCasesFolder();
  parts_->startPage->setProblem(shipped ? QString() : words(shipped.error().message));
  parts_->startPage->setReading(true);
  parts_->details.forget();
  parts_->preparation.forget();
  parts_->library.refresh();
  parts_->learning.refresh();
  if (parts_->library.index() == nullptr) parts_->startPage->setReading(false);
  showRecent();
  parts_->startPage->setOpenCase(parts_->session.subject() ? words(parts_->session.subject()->title) : QString());
  readDetails();
  showTitle();
}

}  // namespace ew::ui
