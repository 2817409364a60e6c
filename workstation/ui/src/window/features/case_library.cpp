#include "window/features/case_library.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <system_error>
#include <utility>
#include <vector>

#include "ew/library/bundle.h"
#include "ew/library/case.h"
#include "ew/library/folders.h"
#include "ew/library/published.h"
#include "ew/library/withdrawn.h"
#include "ew/sdk/person.h"
#include "ew/widgets/words.h"
#include "window/features/opening.h"
#include "window/features/preparing.h"
#include "window/frame/commands.h"
#include "window/frame/window_parts.h"
#include "window/frame/workspaces.h"

namespace ew::ui {
namespace {

constexpr int kDetailsAfter_ms = 40;  // of rest: whoever scrolls through a thousand cards does not wait for their images
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

CaseLibrary::CaseLibrary(WindowParts& parts) : Feature(parts) {
  detailsSoon_.setSingleShot(true);
  detailsSoon_.setInterval(kDetailsAfter_ms);
}

void CaseLibrary::addImportAction(QMenu& file) {
  parts_.commands->add(file, "import.case", [this] { chooseBundle(); });
}

void CaseLibrary::addStartActions(QMenu& file) {
  parts_.commands->add(file, "start", [this] { parts_.workspaces->showStartPage(); });
  parts_.commands->add(file, "search", [this] {
    if (!parts_.workspaces->isAtStart()) parts_.workspaces->showStartPage();
    parts_.startPage->focusSearch();
  });
}

void CaseLibrary::connectParts() {
  WindowParts& p = parts_;
  connect(p.workspaces, &Workspaces::pageChanged, this, [this] {
    if (parts_.workspaces->isAtStart()) fill();
  });
  connect(&detailsSoon_, &QTimer::timeout, this, &CaseLibrary::readDetails);
  connect(p.startPage, &StartPage::sightChanged, &detailsSoon_, QOverload<>::of(&QTimer::start));
  connect(p.startPage, &StartPage::listed, this, [this] {
    detailsSoon_.start();
    parts_.opening->showRecent();
  });
  connect(p.startPage, &StartPage::problem, this, [this](const Error& error) { parts_.messages->showError(error); });
  connect(&p.library, &LibraryBrowser::opened, this, [this] { parts_.startPage->setIndex(parts_.library.index()); });
  connect(&p.library, &LibraryBrowser::changed, this, [this] { parts_.startPage->showFound(); });
  connect(&p.library, &LibraryBrowser::refreshed, this, [this] {
    parts_.startPage->setReading(false);
    // A refresh that began before the import does not know the case yet; another one follows.
    if (!imported_.isEmpty() && parts_.startPage->choose(imported_)) imported_.clear();
  });
  connect(&p.library, &LibraryBrowser::noted, this, [this](const QString& note) { parts_.messages->showNote(note); });
  connect(&p.library, &LibraryBrowser::failed, this, [this](const Error& error) { parts_.messages->showError(error); });
  connect(&p.learning, &Learning::changed, this, [this] { parts_.startPage->showLearning(parts_.learning.shared()); });
  connect(&p.learning, &Learning::failed, this, [this](const Error& error) { parts_.messages->showError(error); });
  connect(p.startPage, &StartPage::withdrawRequested, this, &CaseLibrary::withdraw);
  connect(&p.details, &CaseDetails::imageRead, p.startPage, &StartPage::setThumbnail);
  connect(&p.details, &CaseDetails::caseRead, p.preparing, &Preparing::show);
}

void CaseLibrary::withdraw(const QString& folder, const QString& title) {
  if (parts_.access.isLocked()) return;
  const auto isUsedHere = [this, folder] {
    const std::vector<std::filesystem::path> used = parts_.opener->sources();
    return parts_.opener->isOpening(folder) ||
           std::any_of(used.begin(), used.end(), [&](const auto& file) { return goesWith(pathOf(folder), file); });
  };
  const auto refuse = [this, title] {
    parts_.messages->showError(
        tr("'%1' is in use in this window. Close it first, by opening another case; then it can be taken out of the library.").arg(title),
        kWithdrawing);
  };
  if (isUsedHere()) return refuse();
  QMessageBox question(&parts_.window);
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
  WithdrawnCase taken;
  // Awaited: nobody opens it meanwhile.
  const auto done = parts_.jobs.await(tr("Taking '%1' out of the library").arg(title), [&](Progress&) -> Result<void> {
    auto moved = withdrawCase(pathOf(folder), libraryFolder(), sdk::personWhoLearns());
    if (!moved) return passOn(moved.error());
    taken = std::move(*moved);
    return {};
  });
  if (!done) return parts_.messages->showError(done.error());
  parts_.messages->showNote(tr("'%1' was taken out of the library. It lies in %2; moved back to %3, it is there again.")
                                .arg(title, wordsOf(taken.folder), wordsOf(taken.from)));
  parts_.library.refresh();
}

void CaseLibrary::chooseBundle() {
  const QString file = QFileDialog::getOpenFileName(&parts_.window, tr("Import a case bundle"), QString(), tr("Case bundles (*.ewcase)"));
  if (!file.isEmpty()) importCase(file);
}

void CaseLibrary::importCase(const QString& bundle) {
  if (!parts_.session.subject()) parts_.workspaces->showStartPage();
  struct Taken {
    CaseRevision revision;
    std::string title, titleForTrainees;
  };
  auto taken = std::make_shared<Taken>();
  const QString name = QFileInfo(bundle).fileName();
  parts_.jobs.start(
      tr("Importing %1").arg(name),
      [taken, bundle](Progress& progress) -> Result<void> {
        auto imported = importBundle(pathOf(bundle), libraryFolder(), {}, progress);
        if (!imported) return passOn(imported.error());
        const auto opened = loadCase(imported->folder);
        *taken = {*imported, opened ? opened->title : imported->id, opened ? titleForTrainees(*opened) : imported->id};
        return {};
      },
      [this, taken, name](const Result<void>& outcome) {
        const QString topic = QStringLiteral("import ") + name;
        if (!outcome) {
          if (outcome.error().code != ErrorCode::cancelled) parts_.messages->showError(outcome.error(), topic);
          return;
        }
        const QString title = words(parts_.workspaces->isAuthor() ? taken->title : taken->titleForTrainees);
        const CaseRevision& revision = taken->revision;
        parts_.messages->showNote(revision.wasThere
                                      ? tr("'%1' is in the library already, as revision %2.").arg(title).arg(revision.revision)
                                      : tr("'%1' was taken into the library as revision %2.").arg(title).arg(revision.revision),
                                  topic);
        imported_ = wordsOf(revision.folder);
        parts_.workspaces->showStartPage();
      });
}

void CaseLibrary::readDetails() {
  if (!parts_.workspaces->isAtStart()) return;
  parts_.details.want(parts_.startPage->foldersInSight());
  parts_.preparing->show();
}

void CaseLibrary::fill() {
  const auto shipped = shippedCasesFolder();
  parts_.startPage->setProblem(shipped ? QString() : words(shipped.error().message));
  parts_.startPage->setReading(true);
  parts_.details.forget();
  parts_.preparation.forget();
  parts_.library.refresh();
  parts_.learning.refresh();
  if (parts_.library.index() == nullptr) parts_.startPage->setReading(false);
  parts_.opening->readRecent();
  parts_.opening->showRecent();
  parts_.startPage->setOpenCase(parts_.session.subject() ? words(parts_.session.subject()->title) : QString());
  readDetails();
  parts_.refresh();
}

}  // namespace ew::ui
