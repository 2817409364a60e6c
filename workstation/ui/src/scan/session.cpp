#include "scan/session.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ew/core/contract.h"
#include "ew/core/order_statistics.h"
#include "ew/scanning/contact.h"
#include "ew/scanning/recorded.h"

namespace ew::ui {
namespace {

constexpr std::size_t kRememberedFrames = 25;
constexpr double kFramePeriod_ms = 36.0;  // about 28 frames a second, as a machine shows of a deep abdomen

}  // namespace

Session::Session(QObject* parent) : QObject(parent) {
  clock_.start();
  nextFrame_.setSingleShot(true);
  nextFrame_.setTimerType(Qt::PreciseTimer);
  connect(&nextFrame_, &QTimer::timeout, this, [this] {
    if (!isWatched_ || !changesByItself()) return;
    isOwnFrame_ = !due_ && mover() != Mover::tracker;
    due_ = true;
    makePictureNow();
    isOwnFrame_ = false;
  });
  connect(&formOn_, &QTimer::timeout, this, &Session::formOn);
  connect(&trackerTimer_, &QTimer::timeout, this, &Session::lookAtTracker);
}

void Session::setProbes(std::vector<Probe> all) {
  all_ = std::move(all);
  updateUsableProbes();
}

void Session::updateUsableProbes() {
  usable_.clear();
  if (subject()) {
    for (const std::string& id : subject()->probes) {
      const auto found = std::find_if(all_.begin(), all_.end(), [&](const Probe& p) { return p.id == id; });
      if (found != all_.end()) usable_.push_back(*found);
    }
  }
  if (usable_.empty()) usable_ = all_;
  const bool stillThere = std::any_of(usable_.begin(), usable_.end(), [this](const Probe& p) { return p == live_.probe; });
  if (!stillThere && !usable_.empty()) {
    takeProbe(usable_.front());
    due();
    Q_EMIT holdChanged();
  }
  Q_EMIT probeChanged();
  Q_EMIT knobsChanged();
}

void Session::takeProbe(const Probe& probe) {
  live_.probe = probe;
  // Another probe sees to another depth: its own default, rather than a depth it may not reach.
  Knobs& knobs = live_.knobs;
  knobs.depth_mm = 0.0;
  knobs.focus_mm = 0.0;
  knobs.moreFoci_mm = {};
  knobs.carrier_hz = 0.0;
  knobs.steering_rad = 0.0;
  knobs.trapezoid = false;
  Hold pressed = hand_.hold();
  pressed.press_mm = usualPress_mm(probe);
  hand_.setHold(pressed);
}

void Session::chooseProbe(const std::string& id) {
  const auto found = std::find_if(usable_.begin(), usable_.end(), [&](const Probe& p) { return p.id == id; });
  if (played_ || found == usable_.end() || *found == live_.probe || refuses()) return;
  cine_.beginAnew();
  takeProbe(*found);
  due();
  Q_EMIT probeChanged();
  Q_EMIT knobsChanged();
  Q_EMIT holdChanged();
}

void Session::show(ScanSubject shown, Patient patient) {
  showWide({});
  play({});
  setFrozen(false);
  forgetCine();
  Q_EMIT subjectReplaced();
  if (patient == Patient::another) Q_EMIT patientReplaced();
  scanner_.show(std::move(shown));
  cine_.forget();
  recorded_ = Recorded(*subject());
  recent_.clear();
  adaptive_.reset();
  latency_.clear();
  caseLabels_ = subject()->labels;
  sceneBeforeReset_.reset();
  wantedEchoes_.reset();
  breathing_ = {};
  Q_EMIT breathingChanged();
  isOfThisScan_ = false;
  takeScene(subject()->scene);
  if (!subject()->probes.empty()) {
    const auto first = std::find_if(all_.begin(), all_.end(), [this](const Probe& p) { return p.id == subject()->probes.front(); });
    if (first != all_.end()) takeProbe(*first);
  }
  updateUsableProbes();
  due();
  Q_EMIT subjectChanged();
}

bool Session::canRefine() const {
  return subject() && subject()->isDraft && !frozen_ && !played_ && !wide_ && subject()->labels == caseLabels_;
}

void Session::refine(ScanSubject better) {
  EW_EXPECTS(canRefine());
  scanner_.refine(std::move(better));
  caseLabels_ = subject()->labels;
  recorded_ = Recorded(*subject());
  due();
  Q_EMIT subjectChanged();
}

void Session::clear(Patient patient) {
  showWide({});
  play({});
  setFrozen(false);
  forgetCine();
  Q_EMIT subjectReplaced();
  if (patient == Patient::another) Q_EMIT patientReplaced();
  scanner_.clear();
  cine_.forget();
  recorded_ = {};
  picture_ = {};
  isOfThisScan_ = false;
  forming_.reset();
  Q_EMIT subjectChanged();
  Q_EMIT pictureChanged();
}

void Session::exchangePicture(Session& other) {
  EW_EXPECTS(&other != this && !played_ && !other.played_ && !wide_ && !other.wide_);
  EW_EXPECTS((frozen_ || picture_.isEmpty()) && (other.frozen_ || other.picture_.isEmpty()));
  const bool wasFrozen = isFrozen(), otherWasFrozen = other.isFrozen();
  const bool isForming = formOn_.isActive(), otherIsForming = other.formOn_.isActive();
  for (Session* each : {this, &other}) {
    each->formOn_.stop();
    each->nextFrame_.stop();
    each->sceneBeforeReset_.reset();
    each->wantedEchoes_.reset();
    each->adaptive_.reset();
    each->recent_.clear();
    each->movedAt_s_.reset();
  }
  std::swap(scanner_, other.scanner_);
  std::swap(live_, other.live_);
  std::swap(frozen_, other.frozen_);
  std::swap(asScanned_, other.asScanned_);
  std::swap(processing_, other.processing_);
  std::swap(consoleWhileFrozen_, other.consoleWhileFrozen_);
  std::swap(isProcessedAnew_, other.isProcessedAnew_);
  std::swap(shown_, other.shown_);
  std::swap(cine_, other.cine_);
  std::swap(cineFrame_, other.cineFrame_);
  std::swap(forming_, other.forming_);
  std::swap(picture_, other.picture_);
  std::swap(isOfThisScan_, other.isOfThisScan_);
  lost_.reset();
  std::swap(unsettledFrames_, other.unsettledFrames_);
  std::swap(width_, other.width_);
  std::swap(height_, other.height_);
  // No two pictures of the window have the same number.
  live_.number = other.live_.number = std::max(live_.number, other.live_.number);
  // The subject may have been edited while the picture stood aside.
  if (other.subject() && subject()) {
    const ScanSubject& edited = *other.subject();
    if (subject()->isDraft && !edited.isDraft) scanner_.refine(edited);
    scanner_.setTitle(edited.title);
    scanner_.setScene(edited.scene);
    if (edited.tissue && !subject()->tissue) scanner_.know(edited.tissue);
    if (edited.labels != subject()->labels) scanner_.setLabels(edited.labels);
    caseLabels_ = other.caseLabels_;
  }
  tellOfPicture(wasFrozen);
  other.tellOfPicture(otherWasFrozen);
  if (otherIsForming) formCine();
  if (isForming) other.formCine();
}

void Session::tellOfPicture(bool wasFrozen) {
  due();
  if (isFrozen() != wasFrozen) Q_EMIT frozenChanged(isFrozen());
  Q_EMIT cineReplaced();
  Q_EMIT probeChanged();
  Q_EMIT knobsChanged();
  Q_EMIT sceneChanged();
  Q_EMIT holdChanged();
  Q_EMIT pictureChanged();
}

void Session::beginLike(const Session& other) {
  EW_EXPECTS(other.subject().has_value());
  setProbes(other.all_);
  show(*other.subject());
  live_ = other.live_;
}

void Session::place(const Transform<frame::World, frame::World>& ownToWorld) {
  if (!subject()) return;
  const Grid before = subject()->placedGrid;
  scanner_.place(ownToWorld);
  if (subject()->placedGrid == before) return;
  forgetCine();  // what was seen cannot be formed again from voxels that lie elsewhere
  recorded_ = Recorded(*subject());
  due();
  Q_EMIT subjectChanged();
}

void Session::setTitle(const std::string& title) {
  if (!subject() || subject()->title == title) return;
  scanner_.setTitle(title);
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
  scanner_.setLabels(std::move(labels));
  if (frozen_) {  // the image that is painted in is formed again, with the shadows of what is painted
    formOn_.stop();
    forming_.reset();
    isProcessedAnew_ = true;
  } else {
    forgetCine();  // its images cannot be formed again with tissues that lie elsewhere
  }
  due();
  Q_EMIT subjectChanged();
}

void Session::takeScene(const Scene& scene) {
  live_.scene = subject() ? subject()->known(scene) : scene;
  if (consoleWhileFrozen_) consoleWhileFrozen_ = processed(live_, processing_);
  recent_.clear();
  due();
  Q_EMIT sceneChanged();
}

void Session::setScene(const Scene& scene) {
  if (played_ || scene == live_.scene || refuses()) return;
  sceneBeforeReset_.reset();
  wantedEchoes_ = scene.liveEchoes;
  takeScene(scene);
  askForEchoes(scene);
}

void Session::askForEchoes(const Scene& scene) {
  if (scene.liveEchoes && subject() && !subject()->tissue && subject()->canFormEchoes()) Q_EMIT echoesWanted();
}

void Session::know(std::shared_ptr<const TissueMaps> ofVoxels) {
  if (!subject()) return;
  scanner_.know(std::move(ofVoxels));
  recent_.clear();
  due();
  Scene scene = live_.scene;
  scene.liveEchoes = std::exchange(wantedEchoes_, std::nullopt);
  if (scene != live_.scene) takeScene(scene);
}

void Session::resetScene() {
  if (!subject() || played_ || hasCaseScene() || refuses()) return;
  sceneBeforeReset_ = live_.scene;
  takeScene(subject()->scene);
}

void Session::undoSceneReset() {
  if (!sceneBeforeReset_ || played_ || refuses()) return;
  const Scene before = *sceneBeforeReset_;
  sceneBeforeReset_.reset();
  takeScene(before);
}

void Session::setCaseScene(const Scene& asked) {
  if (!subject()) return;
  const Scene scene = subject()->known(asked);
  if (subject()->scene == scene) return;
  scanner_.setScene(scene);
  sceneBeforeReset_.reset();
  takeScene(scene);
}

void Session::setAdaptive(bool adaptive) {
  if (adaptive == isAdaptive_) return;
  isAdaptive_ = adaptive;
  adaptive_.reset();
  due();
  Q_EMIT adaptiveChanged(adaptive);
}

void Session::setWatched(bool watched) {
  isWatched_ = watched;
  if (watched) due();
}

bool Session::changesByItself() const {
  if (!subject() || frozen_ || played_ || picture_.isEmpty()) return false;
  return (subject()->movesIn(live_.scene) && breathing_.movesAfter(subject()->motion->rhythms, shown_.time_s)) || live_.scene.noise ||
         live_.knobs.mode != DisplayMode::bMode || unsettledFrames_ > 0 || isLowered() || mover() == Mover::tracker ||
         (source_ && source_->movesAfter(shown_.time_s));
}

void Session::setSkin(std::shared_ptr<const Skin> skin) {
  skin_ = std::move(skin);
  if (live_.scene.contact) due();
  Q_EMIT holdChanged();
}

void Session::setKnobs(const Knobs& knobs) {
  if (played_ || knobs == console().knobs) return;
  if (wide_) return setKnobsOfWide(knobs);
  if (frozen_ && differInProcessingOnly(knobs, console().knobs)) return process(knobs, knobs.zoom > 1.0 ? pan() : Pan{});
  if (refuses()) return;
  live_.knobs = knobs;
  if (!(knobs.zoom > 1.0)) live_.pan = {};  // the next zoom begins in the middle
  due();
  Q_EMIT knobsChanged();
}

Detail Session::detail() const {
  if (wide_) return wide_->shown.detail;
  const ScanState& at = settings();
  return {at.knobs.zoom > 1.0 ? at.knobs.zoom : 1.0, panWithinFan(at.probe, at.knobs, at.pan)};
}

void Session::setDetail(double zoom, const Pan& part) {
  // An older image of the loop may have been scanned with another zoom than the console has.
  if (played_ || (zoom == settings().knobs.zoom && part == settings().pan)) return;
  if (wide_) {
    wide_->shown.detail = {zoom, part};
    showWideSettings();
    Q_EMIT knobsChanged();
    return Q_EMIT wideDetailAsked({zoom, part});
  }
  if (frozen_) {
    processing_.detail = Detail{zoom, part};
    return process(console().knobs, console().pan);
  }
  live_.knobs.zoom = zoom;
  live_.pan = part;
  due();
  Q_EMIT knobsChanged();
}

double Session::depth_mm() const { return resolvedDepth_mm(probe(), knobs()); }

double Session::focus_mm() const { return knobs().focus_mm > 0.0 ? std::min(knobs().focus_mm, depth_mm()) : depth_mm() / 2.0; }

void Session::resetTgc() {
  Knobs reset = knobs();
  if (gainLaw() == GainLaw::decibel)
    reset.tgc_db = Knobs{}.tgc_db;
  else
    reset.dgc = Knobs{}.dgc;
  setKnobs(reset);
}

void Session::setNeutral() {
  Knobs neutral;
  neutral.quality = knobs().quality;
  setKnobs(neutral);
}

void Session::setHold(const Hold& hold) {
  const bool moves = !(hold == hand_.hold());
  hand_.setHold(hold);
  if (moves && isLost() && isHandReady_) takeBackByHand();
  if (!movedAt_s_ && !frozen_ && moves && mover() != Mover::tracker) movedAt_s_ = now_s();
  due();
  Q_EMIT holdChanged();
}

void Session::follow(std::shared_ptr<const PoseSource> source) {
  if (source == source_) return;
  source_ = std::move(source);
  due();
  Q_EMIT holdChanged();
  if (tracked_) Q_EMIT trackingChanged();
}

std::optional<double> Session::contact() const {
  if (!skin_ || all_.empty()) return std::nullopt;
  const Pose here = pose();
  const std::vector<float> gaps_mm = gapsToSkin_mm(probe(), here, *skin_);
  return subject() ? contactShare(gaps_mm, dataInFrontOf(recorded_, probe(), here)) : contactShare(gaps_mm);
}

UnrecordedPart Session::unrecorded() const {
  constexpr int kEvery_px = 4;
  if (!subject() || picture_.isEmpty()) return {};
  return unrecordedPart(recorded_, fanGeometry(), spans(), shown_.pose, fanGeometry().depth_mm, kEvery_px);
}

bool Session::seesVolume() const { return !picture_.isEmpty() && seen().seesVolume(picturePose()); }

Pose Session::pose() const { return played_ ? played_->pose : poses().poseAt(now_s()); }

void Session::play(std::optional<ScanState> state) {
  if ((!state && !played_) || (state && !subject())) return;
  showWide({});
  if (state) setFrozen(false);
  if (state && !played_) cine_.beginAnew();  // what was scanned before a recording is another scan
  if (!state || !played_) forgetPictures();
  const ScanState before = console();
  played_ = std::move(state);
  if (played_) askForEchoes(played_->scene);
  const ScanState& now = console();
  if (now.probe != before.probe) Q_EMIT probeChanged();
  if (now.knobs != before.knobs || !(now.pan == before.pan) || now.probe != before.probe) Q_EMIT knobsChanged();
  if (now.scene != before.scene) {
    recent_.clear();
    Q_EMIT sceneChanged();
  }
  Q_EMIT holdChanged();
  due();
}

void Session::forgetPictures() {
  scanner_.forget();
  cine_.forget();
  unsettledFrames_ = 0;
  due();
}

void Session::askBreathing(BreathingRequest request) {
  if (played_ || !canBreathe() || request == breathing_.asked()) return;
  breathing_.ask(request, subject()->motion->rhythms, now_s());
  due();
  Q_EMIT breathingChanged();
}

const char* Session::whyBreathingIsNotSeen() const {
  if (!canBreathe()) return QT_TR_NOOP("Nothing that is scanned here moves with the breath, so the image stays as it is.");
  if (!subject()->movesIn(live_.scene))
    return QT_TR_NOOP("The patient breathes, but the image does not show it: switch live echoes and motion on (Effects).");
  return nullptr;
}

void Session::setPictureSize(int width, int height) {
  if (width == width_ && height == height_) return;
  width_ = width;
  height_ = height;
  due();
}

void Session::refresh() { due(); }

void Session::due() {
  if (due_) return;
  due_ = true;
  QTimer::singleShot(0, this, &Session::makePictureNow);
}

ScanState Session::nextState() {
  if (played_) return *played_;
  if (frozen_) return *frozen_;
  ScanState next = live_;
  next.time_s = now_s();
  next.number = live_.number + 1;
  if (subject() && subject()->movesIn(next.scene)) next.body = breathing_.at(subject()->motion->rhythms, next.time_s);
  next.pose = poses().poseAt(next.time_s);
  next.scene = sceneOf(mover());
  const bool mayLower = isAdaptive_ && !isFreezing_;
  if (mayLower) next.knobs = adaptive_.step(live_.knobs, next.pose, next.time_s, lastFrame_ms_, !formsEchoes(next.scene));
  if (next.scene.contact && skin_ && next.pose.status == PoseStatus::ok) next.gaps_mm = gapsToSkin_mm(next.probe, next.pose, *skin_);
  return next;
}

void Session::makePictureNow() {
  if (!due_) return;
  due_ = false;
  if (!subject() || width_ <= 0 || height_ <= 0) return;
  // A frozen picture is still drawn anew for a window of another size or when it is shown otherwise, from the frozen pose and knobs.
  const bool isAsItWas = !std::exchange(isProcessedAnew_, false) && picture_.width() == width_ && picture_.height() == height_;
  if (frozen_ && isAsItWas) return;
  if (frozen_ && cineFrame_) return formCine();
  nextFrame_.stop();
  const double begin_s = frameBegan_s_ = now_s();
  ScanState next = nextState();
  if (!frozen_ && !played_ && mover() == Mover::tracker) {
    if (next.pose.status != PoseStatus::ok) return miss(std::move(next));
    lastTracked_ = next.pose;
  }
  const bool wasLost = lost_.has_value() && !frozen_ && !played_;
  if (!frozen_ && !played_) lost_.reset();
  shown_ = std::move(next);
  // Anything but a frame that came by itself may have changed what persistence has to forget.
  if (!frozen_ && !played_) {
    unsettledFrames_ = isOwnFrame_ ? std::max<std::size_t>(1, unsettledFrames_) - 1 : framesToSettle(live_.knobs.persistence);
  }
  picture_ = scanner_.make(shown_, width_, height_);
  forming_.reset();
  isOfThisScan_ = !played_ && (isOfThisScan_ || !frozen_);
  if (!frozen_ && !played_) {
    live_.number = shown_.number;
    cine_.add(shown_, {width_, height_}, [this] { return scanner_.memory(); });
  }
  ++framesMade_;
  const double end_s = now_s();
  lastFrame_ms_ = 1000.0 * (end_s - begin_s);
  if (movedAt_s_ && !frozen_ && !played_) latency_.add(1e6 * (end_s - *movedAt_s_));
  movedAt_s_.reset();
  if (mover() == Mover::tracker && !frozen_ && !played_) measureLatency();
  recent_.push_back(scanner_.lastTimes());
  if (recent_.size() > kRememberedFrames) recent_.erase(recent_.begin());
  if (wasLost) {
    if (tracked_) tracking_ = tracked_->report(end_s);
    Q_EMIT trackingChanged();
  }
  Q_EMIT pictureChanged();
  keepComing();
}

void Session::keepComing() {
  if (!isWatched_ || !changesByItself()) return;
  if (mover() == Mover::tracker) {
    const double now = now_s();
    pace_ = trackedPace(frameBegan_s_, now - frameBegan_s_);
    nextFrame_.start(static_cast<int>(std::lround(1000.0 * std::max(0.0, pace_.latest_s - now))));
    return;
  }
  // What the picture's viewers spend counts as well: at least as long as frame and drawing took, the window is free for the hand.
  const double spent_ms = 1000.0 * (now_s() - shown_.time_s);
  nextFrame_.start(static_cast<int>(std::lround(std::max(kFramePeriod_ms - spent_ms, std::min(spent_ms, 200.0)))));
}

std::vector<StepTime> Session::stepTimes() const {
  std::vector<StepTime> medians;
  for (const Step& step : scanner_.plan().steps) {
    std::vector<double> seen;
    for (const auto& frame : recent_) {
      for (const StepTime& time : frame) {
        if (time.kind == step.kind) seen.push_back(time.measured_us);
      }
    }
    if (seen.empty()) continue;
    medians.push_back({step.kind, upperMedianOf(seen)});
  }
  return medians;
}

}  // namespace ew::ui
