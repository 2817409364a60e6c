#include <cmath>

#include "main_window_parts.h"
#include "words.h"

// The start page: what the library's index finds, with what is read for the cards in sight.

namespace ew::ui {
namespace {

constexpr int kDetailsAfter_ms = 40;  // of rest: whoever scrolls through a thousand cards does not wait for their pictures

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
  connect(&p.library, &LibraryBrowser::refreshed, this, [this] { parts_->startPage->setReading(false); });
  connect(&p.library, &LibraryBrowser::noted, this, [this](const QString& note) { parts_->messages->showNote(note); });
  connect(&p.library, &LibraryBrowser::failed, this, [this](const Error& error) { parts_->messages->showError(error); });
  connect(&p.details, &CaseDetails::pictureRead, p.startPage, &StartPage::setThumbnail);
  connect(&p.details, &CaseDetails::caseRead, this, &MainWindow::showPreparation);
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
    const QString takes = tr("about %1 s").arg(std::ceil(seen.estimate_s));
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
        parts_->startPage->setState(folder, tr("Not prepared yet, %1; open it to begin").arg(takes), 0.0);
        break;
    }
  }
}

void MainWindow::fillStartPage() {
  const auto shipped = shippedCasesFolder();
  parts_->startPage->setProblem(shipped ? QString() : words(shipped.error().message));
  parts_->startPage->setReading(true);
  parts_->details.forget();
  parts_->library.refresh();
  if (parts_->library.index() == nullptr) parts_->startPage->setReading(false);
  showRecent();
  parts_->startPage->setOpenCase(parts_->session.subject() ? words(parts_->session.subject()->title) : QString());
  readDetails();
  showTitle();
}

}  // namespace ew::ui
