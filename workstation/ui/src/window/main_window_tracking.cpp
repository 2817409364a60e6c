// The tracker page and its wizards, and what the window says of the tracker in use.
#include <algorithm>

#include "scan/tracking_look.h"
#include "widgets/words.h"
#include "window/main_window_parts.h"

namespace ew::ui {
namespace {

const auto kFit = QStringLiteral("tracker fit");

}  // namespace

void MainWindow::connectTrackers() {
  Parts& p = *parts_;
  p.trackers.setWindow({[this] { return parts_->document.current() ? parts_->document.current()->mannequin : std::string(); },
                        [this] {
                          const auto mannequin = parts_->view3d->scene().mannequin();
                          return mannequin ? bridge::skinVerticesOf(*mannequin).points_mm : std::vector<glm::vec3>{};
                        }});
  connect(&p.trackers, &Trackers::problem, this, [this](const Error& error) { parts_->messages->showError(error); });
  connect(&p.trackers, &Trackers::fitLost, this, [this](const QString& sentence) { parts_->messages->showError(sentence, kFit); });
  connect(&p.trackers, &Trackers::fitFound, this, [this] { parts_->messages->forget(kFit); });
  connect(&p.trackers, &Trackers::stateChanged, this, &MainWindow::showTrackerState);
  connect(&p.trackers, &Trackers::listChanged, this, [this] {
    parts_->scanView->setSoundsLoss(parts_->trackers.soundsLost());
    showTrackerState();
  });
  connect(p.view3d, &View3D::mannequinChanged, &p.trackers, &Trackers::mannequinChanged);
  connect(p.status, &StatusLine::trackerAsked, this, &MainWindow::showTracker);
  p.trackers.load();
  showTrackerState();
}

/// In the status line; nothing while the mouse is all there is.
void MainWindow::showTrackerState() {
  Parts& p = *parts_;
  const TrackerSettings* used = p.trackers.find(p.trackers.used());
  if (used == nullptr) return p.status->setTracker({}, {}, {}, {});
  const TrackingLook look = lookOf(p.trackers.report().state);
  const bool isController = std::holds_alternative<HandControllerSettings>(used->source);
  p.status->setTracker(isController ? QStringLiteral("tracker-gamepad") : look.icon, isController ? tr("controller") : look.word,
                       look.colour, isController ? words(p.trackers.deviceStatus().sentence) : words(p.trackers.report().sentence));
}

void MainWindow::showTracker() {
  Parts& p = *parts_;
  if (p.trackerPage.isNull()) {
    auto* page = new TrackerPage(p.trackers, this);
    p.trackerPage = page;
    connect(page, &TrackerPage::setUpAsked, this,
            [this](const QString& tracker) { leadToTracker(tracker.toStdString(), TrackerCourse::camera); });
    connect(page, &TrackerPage::alignAsked, this, [this](const QString& tracker) {
      const bool needsFace = parts_->trackers.needsFace(tracker.toStdString());
      leadToTracker(tracker.toStdString(), needsFace ? TrackerCourse::faceAndAlign : TrackerCourse::align);
    });
    // Over the 3D view: the scan stays in sight.
    page->move(mapToGlobal(QPoint(8, p.topBar->height() + 8)));
  }
  p.trackerPage->show();
  p.trackerPage->raise();
  p.trackerPage->activateWindow();
}

void MainWindow::leadToTracker(const std::string& tracker, TrackerCourse course) {
  Parts& p = *parts_;
  if (!p.trackerWizard.isNull()) p.trackerWizard->close();
  auto* wizard = new TrackerWizard(p.trackers, tracker, course, this);
  p.trackerWizard = wizard;
  wizard->show();
  wizard->raise();
  wizard->activateWindow();
}

}  // namespace ew::ui
