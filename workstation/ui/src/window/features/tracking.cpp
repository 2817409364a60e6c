#include "window/features/tracking.h"

#include <QMenu>
#include <variant>

#include "ew/bridge/mannequin.h"
#include "ew/trackers/hand_controller.h"
#include "ew/widgets/words.h"
#include "scan/tracking_look.h"
#include "trackers/tracker_page.h"
#include "trackers/wizard/tracker_wizard.h"
#include "window/frame/commands.h"
#include "window/frame/window_parts.h"

namespace ew::ui {
namespace {

const auto kFit = QStringLiteral("tracker fit");

}  // namespace

Tracking::~Tracking() {
  delete wizard_;
  delete page_;
}

void Tracking::addAction(QMenu& scan) {
  parts_.commands->add(scan, "tracker", [this] { showPage(); });
}

void Tracking::connectParts() {
  WindowParts& p = parts_;
  p.trackers.mannequin().setWindow({[&p] { return p.document.current() ? p.document.current()->mannequin : std::string(); },
                                    [&p] {
                                      const auto mannequin = p.view3d->scene().mannequin();
                                      return mannequin ? bridge::skinVerticesOf(*mannequin).points_mm : std::vector<glm::vec3>{};
                                    }});
  connect(&p.trackers, &Trackers::problem, this, [this](const Error& error) { parts_.messages->showError(error); });
  connect(&p.trackers, &Trackers::fitLost, this, [this](const QString& sentence) { parts_.messages->showError(sentence, kFit); });
  connect(&p.trackers, &Trackers::fitFound, this, [this] { parts_.messages->forget(kFit); });
  connect(&p.trackers, &Trackers::stateChanged, this, &Tracking::showState);
  connect(&p.trackers, &Trackers::listChanged, this, [this] {
    parts_.scanView->setSoundsLoss(parts_.trackers.soundsLost());
    showState();
  });
  connect(p.view3d, &View3D::mannequinChanged, &p.trackers, &Trackers::mannequinChanged);
  connect(p.status, &StatusLine::trackerAsked, this, &Tracking::showPage);
  p.trackers.load();
  showState();
}

/// In the status line; nothing while the mouse is all there is.
void Tracking::showState() {
  WindowParts& p = parts_;
  const TrackerSettings* used = p.trackers.find(p.trackers.used());
  if (used == nullptr) return p.status->setTracker({}, {}, {}, {});
  const TrackingLook look = lookOf(p.trackers.report().state);
  const bool isController = std::holds_alternative<HandControllerSettings>(used->source);
  p.status->setTracker(isController ? QStringLiteral("tracker-gamepad") : look.icon, isController ? tr("controller") : look.word,
                       look.colour, isController ? words(p.trackers.deviceStatus().sentence) : words(p.trackers.report().sentence));
}

void Tracking::showPage() {
  WindowParts& p = parts_;
  if (page_.isNull()) {
    auto* page = new TrackerPage(p.trackers, &p.window);
    page_ = page;
    connect(page, &TrackerPage::setUpAsked, this, [this](const QString& tracker) { leadTo(tracker.toStdString(), TrackerCourse::camera); });
    connect(page, &TrackerPage::alignAsked, this, [this](const QString& tracker) {
      const bool needsFace = parts_.trackers.needsFace(tracker.toStdString());
      leadTo(tracker.toStdString(), needsFace ? TrackerCourse::faceAndAlign : TrackerCourse::align);
    });
    // Over the 3D view: the scan stays in sight.
    page->move(p.window.mapToGlobal(QPoint(8, p.topBar->height() + 8)));
  }
  page_->show();
  page_->raise();
  page_->activateWindow();
}

void Tracking::leadTo(const std::string& tracker, TrackerCourse course) {
  WindowParts& p = parts_;
  if (!wizard_.isNull()) wizard_->close();
  auto* wizard = new TrackerWizard(p.trackers, tracker, course, &p.window);
  wizard_ = wizard;
  wizard->show();
  wizard->raise();
  wizard->activateWindow();
}

}  // namespace ew::ui
