#include "window/features/body_and_probe.h"

#include <QKeyEvent>
#include <QMenu>
#include <algorithm>

#include "body/host_overlays.h"
#include "ew/bridge/mannequin.h"
#include "ew/scanning/recorded.h"
#include "ew/widgets/theme.h"
#include "window/frame/commands.h"
#include "window/frame/window_parts.h"
#include "window/frame/workspaces.h"

namespace ew::ui {
namespace {

constexpr int kHandRests_ms = 150;

}  // namespace

BodyAndProbe::BodyAndProbe(WindowParts& parts) : Feature(parts) {
  coverageSoon_.setSingleShot(true);
  coverageSoon_.setInterval(kHandRests_ms);
}

/// The keys are watched until the window is gone, and they ask features.
BodyAndProbe::~BodyAndProbe() {
  parts_.focusKeys.isBesideScan = [](const QWidget&) { return false; };
  parts_.focusKeys.doInScan = [](QKeyEvent&) { return false; };
  parts_.focusKeys.backToScan = [] {};
  if (parts_.view3d != nullptr) parts_.view3d->setBeforeDrawing({});
}

void BodyAndProbe::addLooks(QMenu& view) {
  const auto look = [&](const char* command, bridge::CameraPreset preset) {
    parts_.commands->add(view, command, [this, preset] { parts_.view3d->showFrom(preset); });
  };
  look("look.front", bridge::CameraPreset::front);
  look("look.back", bridge::CameraPreset::back);
  look("look.right", bridge::CameraPreset::right);
  look("look.left", bridge::CameraPreset::left);
  look("look.head", bridge::CameraPreset::top);
  parts_.commands->add(view, "look.volume", [this] { parts_.view3d->fitToVolume(); });
}

void BodyAndProbe::connectParts() {
  WindowParts& p = parts_;
  connect(&p.host->hostOverlays(), &HostOverlays::bodyChanged, this, &BodyAndProbe::paintOver);
  connect(p.bodyTools, &BodyTools::overChanged, this, &BodyAndProbe::paintOver);
  connectKeys();
  p.view3d->setBeforeDrawing([this] { bringFan(); });
  connect(&p.session, &Session::imageChanged, this, &BodyAndProbe::showImage);
  connect(&p.session, &Session::subjectChanged, this, [this] {
    if (const auto& subject = parts_.session.subject()) {
      parts_.view3d->setVolumeBox(subject->placedGrid);
    } else {
      parts_.view3d->clearVolumeBox();
      parts_.view3d->setProbeVisible(false);
    }
    showCoverageSoon();
  });
  connect(&coverageSoon_, &QTimer::timeout, this, &BodyAndProbe::showCoverage);
  connect(p.view3d, &View3D::mannequinChanged, this, &BodyAndProbe::showCoverage);
  connect(&p.hand, &HandInput::refused, this, &BodyAndProbe::sayWhyItRests);
  connect(&p.session.probeControl(), &ProbeControl::trackingChanged, this, &BodyAndProbe::showImage);
}

/// Whoever clicks beside the scan goes on scanning: keys of the probe are not lost to a panel, a slider or a tab.
void BodyAndProbe::connectKeys() {
  parts_.focusKeys.isBesideScan = [this](const QWidget& widget) {
    const WindowParts& p = parts_;
    const QWidget* places[] = {p.panels, p.console, p.caseInfo, p.topBar, p.messages};
    return !p.workspaces->isStaged() && p.workspaces->current() == kExplore && p.workspaces->isAtWork() &&
           std::any_of(std::begin(places), std::end(places),
                       [&](const QWidget* place) { return place == &widget || place->isAncestorOf(&widget); });
  };
  parts_.focusKeys.doInScan = [this](QKeyEvent& key) { return doKey(key); };
  parts_.focusKeys.backToScan = [this] { parts_.scanView->setFocus(Qt::MouseFocusReason); };
}

void BodyAndProbe::restyle() { parts_.view3d->setDarkTheme(currentTheme().dark); }

bool BodyAndProbe::doKey(QKeyEvent& event) {
  WindowParts& p = parts_;
  if (p.workspaces->isStaged() || !p.workspaces->isAtWork()) return false;
  return p.cineBar->handleKey(event) || (p.session.subject() && p.hand.handleKey(event));
}

void BodyAndProbe::showImage() {
  WindowParts& p = parts_;
  if (!p.session.subject() || p.session.image().isEmpty()) return;
  const Knobs& knobs = p.session.wide() != nullptr ? p.session.shownState().knobs : p.session.imageKnobs();
  p.view3d->setProbe(p.session.imageProbe(), p.session.fanGeometry().depth_mm, knobs);
  p.view3d->setPose(p.session.imagePose());
  p.view3d->setProbeVisible(true);
}

void BodyAndProbe::bringFan() {
  const Session& session = parts_.session;
  if (!session.subject() || session.fanImage().isEmpty()) return;
  parts_.view3d->bringFanImage(session.fanImage(), session.fanGeometry());
}

void BodyAndProbe::paintOver() {
  const HostOverlays& overlays = parts_.host->hostOverlays();
  if (!overlays.isBodyDrawnOver() && !parts_.bodyTools->isDrawnOver()) return parts_.view3d->setOver({});
  parts_.view3d->setOver([&p = parts_, &overlays](QPainter& painter) {
    overlays.paintOverBody(painter, [sight = p.view3d->sight()](const Point<frame::World>& at) {
      const glm::dvec2 pixel = sight.pixelOf(at.at);
      return QPointF(pixel.x, pixel.y);
    });
    p.bodyTools->paintOver(painter);
  });
}

/// What is placed elsewhere by a hand is tinted when the hand rests: every corner of the skin is looked at for it.
void BodyAndProbe::showCoverageSoon() {
  const auto& subject = parts_.session.subject();
  const auto voxels = subject ? subject->voxels.volume() : nullptr;
  if (voxels && voxels == coverageOf_.lock()) return coverageSoon_.start();
  coverageOf_ = voxels;
  showCoverage();
}

void BodyAndProbe::showCoverage() {
  coverageSoon_.stop();
  if (!parts_.view3d->scene().mannequin()) return;
  if (!parts_.session.subject()) return parts_.view3d->setCoverage({});
  // Where the body is drawn: a hundred thousand corners, of which nobody here asks.
  parts_.view3d->changeLooks([recorded = parts_.session.recorded()](bridge::Scene3D& scene) {
    if (!scene.mannequin()) return;  // there was no memory for it there
    const bridge::SkinVertices skin = bridge::skinVerticesOf(*scene.mannequin());
    scene.setCoverage(coverageOfSkin(recorded, skin.points_mm, skin.outward));
  });
}

void BodyAndProbe::sayWhyItRests() {
  const Session& session = parts_.session;
  parts_.scanView->say(
      session.isPlaying()                    ? tr("A recording is shown. Close it (Escape) to move the probe yourself.")
      : session.probeControl().isFollowing() ? tr("The probe is moved for you. Escape takes it back.")
      : session.probeControl().mover() == ProbeControl::Mover::tracker && !session.isFrozen()
          ? tr("The tracker has the probe. Choose the mouse on the page Tracker to move it here.")
          : tr("The image is frozen, and the probe with it. Let it run (%1): then both move again.").arg(parts_.keys.words("freeze")));
}

}  // namespace ew::ui
