#include "scan/session.h"

#include <algorithm>
#include <utility>

#include "ew/core/contract.h"
#include "ew/widgets/handler_watch.h"

namespace ew::ui {

Session::Session(QObject* parent) : QObject(parent) {
  connect(&frames_, &FrameTimer::asked, this, &Session::makeImageNow);
  connect(&frames_, &FrameTimer::elapsed, this, [this] {
    if (!frames_.isWatched() || !changesByItself()) return;
    isOwnFrame_ = !frames_.isAsked() && probeControl_.mover() != ProbeControl::Mover::tracker;
    frames_.askNow();
    isOwnFrame_ = false;
  });
  connect(&cineLoop_, &CineLoop::formed, this, &Session::imageChanged);
  connect(&probeControl_, &ProbeControl::lastImageMade, this, &Session::imageChanged);
}

void Session::endSubject(Patient patient) {
  showWide({});
  play({});
  setFrozen(false);
  cineLoop_.forget();
  Q_EMIT subjectReplaced();
  if (patient == Patient::another) Q_EMIT patientReplaced();
}

void Session::show(ScanSubject shown, Patient patient) {
  endSubject(patient);
  scan_.scanner.show(std::move(shown));
  scan_.cine.forget();
  recorded_ = Recorded(*subject());
  frames_.forgetTimes();
  frames_.forgetLowering();
  frames_.forgetLatency();
  caseLabels_ = subject()->labels;
  console_.forgetWishes();
  breath_.beginAnew();
  scan_.isOfThisScan = false;
  console_.takeSubject();
  frames_.ask();
  Q_EMIT subjectChanged();
}

bool Session::canRefine() const {
  return subject() && subject()->isDraft && scan_.isLive() && !scan_.wide && subject()->labels == caseLabels_;
}

void Session::refine(ScanSubject better) {
  EW_EXPECTS(canRefine());
  scan_.scanner.refine(std::move(better));
  caseLabels_ = subject()->labels;
  recorded_ = Recorded(*subject());
  frames_.ask();
  Q_EMIT subjectChanged();
}

void Session::clear(Patient patient) {
  endSubject(patient);
  scan_.scanner.clear();
  scan_.cine.forget();
  recorded_ = {};
  scan_.image = {};
  scan_.isOfThisScan = false;
  scan_.forming.reset();
  Q_EMIT subjectChanged();
  Q_EMIT imageChanged();
}

void Session::exchangeImage(Session& other) {
  EW_EXPECTS(&other != this && !scan_.played && !other.scan_.played && !scan_.wide && !other.scan_.wide);
  EW_EXPECTS((scan_.frozen || scan_.image.isEmpty()) && (other.scan_.frozen || other.scan_.image.isEmpty()));
  const bool wasFrozen = isFrozen(), otherWasFrozen = other.isFrozen();
  const bool isForming = cineLoop_.isForming(), otherIsForming = other.cineLoop_.isForming();
  for (Session* each : {this, &other}) {
    each->cineLoop_.stop();
    each->frames_.stop();
    each->console_.forgetWishes();
    each->frames_.forgetLowering();
    each->frames_.forgetTimes();
    each->frames_.forgetMove();
  }
  std::swap(scan_, other.scan_);
  probeControl_.endLoss();
  // No two images of the window have the same number.
  scan_.live.number = other.scan_.live.number = std::max(scan_.live.number, other.scan_.live.number);
  // The subject may have been edited while the image stood aside.
  if (other.subject() && subject()) {
    Scanner& scanner = scan_.scanner;
    const ScanSubject& edited = *other.subject();
    if (subject()->isDraft && !edited.isDraft) scanner.refine(edited);
    scanner.setTitle(edited.title);
    scanner.setScene(edited.scene);
    if (edited.tissue && !subject()->tissue) scanner.know(edited.tissue);
    if (edited.labels != subject()->labels) scanner.setLabels(edited.labels);
    caseLabels_ = other.caseLabels_;
  }
  notifyImageChanged(wasFrozen);
  other.notifyImageChanged(otherWasFrozen);
  if (otherIsForming) cineLoop_.form();
  if (isForming) other.cineLoop_.form();
}

void Session::notifyImageChanged(bool wasFrozen) {
  frames_.ask();
  if (isFrozen() != wasFrozen) Q_EMIT frozenChanged(isFrozen());
  Q_EMIT cineLoop_.replaced();
  Q_EMIT console_.probeChanged();
  Q_EMIT console_.knobsChanged();
  Q_EMIT console_.sceneChanged();
  Q_EMIT probeControl_.holdChanged();
  Q_EMIT imageChanged();
}

void Session::beginLike(const Session& other) {
  EW_EXPECTS(other.subject().has_value());
  console_.setProbes(other.console_.allProbes());
  show(*other.subject());
  scan_.live = other.scan_.live;
}

void Session::place(const Transform<frame::World, frame::World>& ownToWorld) {
  if (!subject()) return;
  const Grid before = subject()->placedGrid;
  scan_.scanner.place(ownToWorld);
  if (subject()->placedGrid == before) return;
  cineLoop_.forget();  // what was seen cannot be formed again from voxels that lie elsewhere
  recorded_ = Recorded(*subject());
  frames_.ask();
  Q_EMIT subjectChanged();
}

void Session::setTitle(const std::string& title) {
  if (!subject() || subject()->title == title) return;
  scan_.scanner.setTitle(title);
  Q_EMIT subjectChanged();
}

void Session::setLabels(std::shared_ptr<const Volume> labels) {
  if (!subject()) return;
  caseLabels_ = labels;
  takeLabels(std::move(labels));
}

void Session::previewLabels(std::optional<Volume> labels) {
  if (!subject()) return;
  if (!labels) return takeLabels(caseLabels_);
  const auto ownToWorld = subject()->placedGrid.voxelToWorld() * inverse(subject()->voxels.grid().voxelToWorld());
  labels->grid = placed(labels->grid, inverse(ownToWorld));
  takeLabels(std::make_shared<const Volume>(std::move(*labels)));
}

void Session::takeLabels(std::shared_ptr<const Volume> labels) {
  if (subject()->labels == labels) return;
  scan_.scanner.setLabels(std::move(labels));
  if (scan_.frozen) {  // the image that is painted in is formed again, with the shadows of what is painted
    cineLoop_.stop();
    scan_.forming.reset();
    scan_.isProcessedAnew = true;
  } else {
    cineLoop_.forget();  // its images cannot be formed again with tissues that lie elsewhere
  }
  frames_.ask();
  Q_EMIT subjectChanged();
}

void Session::know(std::shared_ptr<const TissueMaps> ofVoxels) {
  if (!subject()) return;
  scan_.scanner.know(std::move(ofVoxels));
  console_.beginWantedEchoes();
}

void Session::setCaseScene(const Scene& asked) {
  if (!subject()) return;
  const Scene scene = subject()->known(asked);
  if (subject()->scene == scene) return;
  scan_.scanner.setScene(scene);
  console_.takeCaseScene();
}

bool Session::changesByItself() const {
  if (!subject() || !scan_.isLive() || scan_.image.isEmpty()) return false;
  // A body that moves may be held still; blood flows on.
  if (subject()->flowsIn(scan_.live.knobs)) return true;
  if (subject()->movesIn(scan_.live.scene) && breath_.movesAfter(scan_.shown.time_s)) return true;
  return scan_.live.scene.noise || scan_.live.knobs.mode != DisplayMode::bMode || scan_.unsettledFrames > 0 || frames_.isLowered() ||
         probeControl_.movesAfter(scan_.shown.time_s);
}

std::optional<double> Session::contact() const {
  const std::shared_ptr<const Skin>& skin = probeControl_.skin();
  if (!skin || console_.allProbes().empty()) return std::nullopt;
  const Pose here = probeControl_.pose();
  const Probe& probe = console_.probe();
  const std::vector<float> gaps_mm = gapsToSkin_mm(probe, here, *skin);
  return subject() ? contactShare(gaps_mm, dataInFrontOf(recorded_, probe, here)) : contactShare(gaps_mm);
}

RecordingGap Session::unrecorded() const {
  constexpr int kEvery_px = 4;
  if (!subject() || scan_.image.isEmpty()) return {};
  return unrecordedPart(recorded_, fanGeometry(), seen().spans(), scan_.shown.pose, fanGeometry().depth_mm, kEvery_px);
}

bool Session::seesVolume() const { return !scan_.image.isEmpty() && seen().seesVolume(imagePose()); }

void Session::forgetImages() {
  scan_.scanner.forget();
  scan_.cine.forget();
  scan_.unsettledFrames = 0;
  frames_.ask();
}

void Session::setImageSize(int width, int height) {
  if (width == scan_.width_px && height == scan_.height_px) return;
  scan_.width_px = width;
  scan_.height_px = height;
  frames_.ask();
}

ScanState Session::nextState() {
  if (scan_.played) return *scan_.played;
  if (scan_.frozen) return *scan_.frozen;
  ScanState next = scan_.live;
  next.time_s = frames_.now_s();
  next.number = scan_.live.number + 1;
  if (subject() && subject()->movesIn(next.scene)) next.body = breath_.at(next.time_s);
  next.pose = probeControl_.poseAt(next.time_s);
  next.scene = probeControl_.scene();
  if (!isFreezing_) next.knobs = frames_.affordableKnobs(next);
  const std::shared_ptr<const Skin>& skin = probeControl_.skin();
  if (next.scene.contact && skin && next.pose.status == PoseStatus::ok) next.gaps_mm = gapsToSkin_mm(next.probe, next.pose, *skin);
  return next;
}

void Session::makeImageNow() {
  if (!frames_.takeAsked()) return;
  if (!subject() || !scan_.hasSize()) return;
  // A frozen image is still drawn anew for a window of another size or when it is shown otherwise, from the frozen pose and knobs.
  const bool isAsItWas = !std::exchange(scan_.isProcessedAnew, false) && scan_.isOfSize();
  if (scan_.frozen && isAsItWas) return;
  if (scan_.frozen && scan_.cineFrame) return cineLoop_.form();
  frames_.stop();
  frames_.begin();
  ScanState next = nextState();
  const bool isLive = scan_.isLive();
  const bool isTracked = isLive && probeControl_.mover() == ProbeControl::Mover::tracker;
  if (isTracked && next.pose.status != PoseStatus::ok) {
    if (probeControl_.miss(std::move(next))) keepComing();
    return;
  }
  if (isTracked) probeControl_.keepTracked(next.pose);
  const bool wasLost = isLive && probeControl_.endLoss();
  scan_.shown = std::move(next);
  // Anything but a frame that came by itself may have changed what persistence has to forget.
  if (isLive) {
    scan_.unsettledFrames = isOwnFrame_ ? std::max<std::size_t>(1, scan_.unsettledFrames) - 1 : framesToSettle(scan_.live.knobs);
  }
  {
    const HandlerWatch::Part part("the image of the scan");
    scan_.image = scan_.scanner.make(scan_.shown, scan_.width_px, scan_.height_px);
  }
  scan_.forming.reset();
  scan_.isOfThisScan = !scan_.played && (scan_.isOfThisScan || isLive);
  if (isLive) {
    scan_.live.number = scan_.shown.number;
    scan_.cine.add(scan_.shown, imageSize_px(), [this] { return scan_.scanner.memory(); });
  }
  const double end_s = frames_.finish(isLive);
  if (isTracked) probeControl_.measureLatency();
  frames_.keepTimes(scan_.scanner.lastTimes());
  if (wasLost) probeControl_.tellFound(end_s);
  {
    const HandlerWatch::Part part("telling everybody of an image");
    Q_EMIT imageChanged();
  }
  keepComing();
}

void Session::keepComing() {
  if (!frames_.isWatched() || !changesByItself()) return;
  if (probeControl_.mover() == ProbeControl::Mover::tracker) return frames_.comeAsTracked();
  frames_.comeAsAMachine(scan_.shown.time_s);
}

}  // namespace ew::ui
