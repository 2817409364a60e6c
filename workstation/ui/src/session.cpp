#include "session.h"

#include <algorithm>
#include <cmath>

namespace ew::ui {
namespace {

constexpr std::size_t kRememberedFrames = 25;
constexpr double kGel_mm = 3.0;
constexpr int kContactSamples = 17;

constexpr double kFramePeriod_ms = 36.0;  // about 28 frames a second, as a machine shows of a deep abdomen

/// Frames until persistence shows less than half a grey level of what was there before.
int framesToSettle(double persistence) {
  return persistence > 0.0 ? 1 + static_cast<int>(std::ceil(std::log(0.5 / 255.0) / std::log(std::min(persistence, 0.95)))) : 0;
}

}  // namespace

double usualPress_mm(const Probe& probe) {
  constexpr double kLeast_mm = 1.0;
  constexpr double kShare = 0.8;
  return std::min(kLeast_mm + kShare * faceSagitta_mm(probe), kMaxPress_mm);
}

Session::Session(QObject* parent) : QObject(parent) {
  // A hold needs a surface to stand on, also before there is a skin: the middle of the trunk's front.
  hold_.contact = {{0.0, -105.0, 0.0}, {0.0, -1.0, 0.0}};
  clock_.start();
  nextFrame_.setSingleShot(true);
  nextFrame_.setTimerType(Qt::PreciseTimer);
  connect(&nextFrame_, &QTimer::timeout, this, [this] {
    if (!isWatched_ || !changesByItself()) return;
    isOwnFrame_ = !due_;
    due_ = true;
    makePictureNow();
    isOwnFrame_ = false;
  });
}

void Session::setProbes(std::vector<Probe> all) {
  all_ = std::move(all);
  updateUsableProbes();
}

void Session::updateUsableProbes() {
  usable_.clear();
  if (subject_) {
    for (const std::string& id : subject_->probes) {
      const auto found = std::find_if(all_.begin(), all_.end(), [&](const Probe& p) { return p.id == id; });
      if (found != all_.end()) usable_.push_back(*found);
    }
  }
  if (usable_.empty()) usable_ = all_;
  const bool stillThere = std::any_of(usable_.begin(), usable_.end(), [this](const Probe& p) { return p == probe_; });
  if (!stillThere && !usable_.empty()) {
    takeProbe(usable_.front());
    due();
    Q_EMIT holdChanged();
  }
  Q_EMIT probeChanged();
  Q_EMIT knobsChanged();
}

void Session::takeProbe(const Probe& probe) {
  probe_ = probe;
  // Another probe sees to another depth: its own default, rather than a depth it may not reach.
  knobs_.depth_mm = 0.0;
  knobs_.focus_mm = 0.0;
  knobs_.moreFoci_mm = {};
  knobs_.carrier_hz = 0.0;
  knobs_.steering_rad = 0.0;
  knobs_.trapezoid = false;
  face_mm_ = facePoints_mm(probe_, kContactSamples);
  hold_.press_mm = usualPress_mm(probe_);
}

void Session::chooseProbe(const std::string& id) {
  const auto found = std::find_if(usable_.begin(), usable_.end(), [&](const Probe& p) { return p.id == id; });
  if (found == usable_.end() || *found == probe_) return;
  takeProbe(*found);
  due();
  Q_EMIT probeChanged();
  Q_EMIT knobsChanged();
  Q_EMIT holdChanged();
}

void Session::show(Subject subject) {
  setFrozen(false);
  subject_ = std::move(subject);
  recent_.clear();
  maker_.forget();
  adaptive_.reset();
  latency_.clear();
  sceneBeforeReset_.reset();
  takeScene(subject_->scene);
  if (!subject_->probes.empty()) {
    const auto first = std::find_if(all_.begin(), all_.end(), [this](const Probe& p) { return p.id == subject_->probes.front(); });
    if (first != all_.end()) takeProbe(*first);
  }
  updateUsableProbes();
  due();
  Q_EMIT subjectChanged();
}

void Session::clear() {
  setFrozen(false);
  subject_.reset();
  picture_ = {};
  Q_EMIT subjectChanged();
  Q_EMIT pictureChanged();
}

void Session::place(const glm::dmat4& ownToWorld) {
  if (!subject_) return;
  const Grid there = placed(subject_->volume->grid, ownToWorld);
  if (subject_->placedGrid == there) return;
  subject_->placedGrid = there;
  if (subject_->labels) subject_->placedLabels = placed(subject_->labels->grid, ownToWorld);
  due();
  Q_EMIT subjectChanged();
}

void Session::setTitle(const QString& title) {
  if (!subject_ || subject_->title == title) return;
  subject_->title = title;
  Q_EMIT subjectChanged();
}

void Session::takeScene(const Scene& scene) {
  scene_ = scene;
  recent_.clear();
  due();
  Q_EMIT sceneChanged();
}

void Session::setScene(const Scene& scene) {
  if (scene == scene_) return;
  sceneBeforeReset_.reset();
  takeScene(scene);
}

void Session::resetScene() {
  if (!subject_ || hasCaseScene()) return;
  sceneBeforeReset_ = scene_;
  takeScene(subject_->scene);
}

void Session::undoSceneReset() {
  if (!sceneBeforeReset_) return;
  const Scene before = *sceneBeforeReset_;
  sceneBeforeReset_.reset();
  takeScene(before);
}

void Session::setCaseScene(const Scene& scene) {
  if (!subject_ || subject_->scene == scene) return;
  subject_->scene = scene;
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
  if (!subject_ || frozen_ || picture_.width == 0) return false;
  return scene_.noise || knobs_.mode != DisplayMode::bMode || unsettledFrames_ > 0 || isLowered();
}

void Session::setSkin(std::shared_ptr<const Skin> skin) {
  skin_ = std::move(skin);
  if (scene_.contact) due();
  Q_EMIT holdChanged();
}

void Session::setKnobs(const Knobs& knobs) {
  if (knobs == knobs_) return;
  knobs_ = knobs;
  if (!(knobs_.zoom > 1.0)) pan_ = {};  // the next zoom begins in the middle
  due();
  Q_EMIT knobsChanged();
}

void Session::setPan(const Pan& pan) {
  if (pan == pan_) return;
  pan_ = pan;
  due();
  Q_EMIT knobsChanged();
}

double Session::depth_mm() const { return resolvedDepth_mm(probe_, knobs_); }

double Session::focus_mm() const { return knobs_.focus_mm > 0.0 ? std::min(knobs_.focus_mm, depth_mm()) : depth_mm() / 2.0; }

void Session::setHold(const Hold& hold) {
  if (!movedAt_s_ && !frozen_ && !(hold == hold_)) movedAt_s_ = now_s();
  hold_ = hold;
  due();
  Q_EMIT holdChanged();
}

void Session::measureGaps(const Pose& pose) {
  gaps_mm_.resize(face_mm_.size());
  for (std::size_t i = 0; i < face_mm_.size(); ++i) {
    const glm::dvec3 p_world = glm::dvec3(pose.probeToWorld.matrix * glm::dvec4(face_mm_[i], 1.0));
    const Skin::Contact nearest = skin_->nearest(p_world);
    gaps_mm_[i] = static_cast<float>(glm::dot(p_world - nearest.point_mm, nearest.outward));
  }
}

std::optional<double> Session::contact() const {
  if (!skin_ || face_mm_.empty()) return std::nullopt;
  const Pose held = pose();
  std::size_t touching = 0;
  for (const glm::dvec3& p_probe : face_mm_) {
    const glm::dvec3 p_world = glm::dvec3(held.probeToWorld.matrix * glm::dvec4(p_probe, 1.0));
    const Skin::Contact nearest = skin_->nearest(p_world);
    if (glm::dot(p_world - nearest.point_mm, nearest.outward) <= kGel_mm) ++touching;
  }
  return static_cast<double>(touching) / static_cast<double>(face_mm_.size());
}

bool Session::seesVolume() const {
  const Pose at = picturePose();
  if (!subject_ || at.status != PoseStatus::ok || picture_.width == 0) return false;
  const Grid& grid = subject_->placedGrid;
  const glm::dmat4 imageToVoxel = (grid.worldToVoxel() * at.probeToWorld * geometry().imageToProbe()).matrix;
  const Spans& fan = maker_.spans();
  constexpr int kEvery_px = 8;
  for (std::size_t y = 0; y < fan.size(); y += kEvery_px) {
    for (const RowSpan& run : fan[y]) {
      for (int x = run.begin; x < run.end; x += kEvery_px) {
        const glm::dvec3 p_voxel(imageToVoxel * glm::dvec4(x, y, 0.0, 1.0));
        if (glm::all(glm::greaterThanEqual(p_voxel, glm::dvec3(-0.5))) && glm::all(glm::lessThan(p_voxel, glm::dvec3(grid.dims) - 0.5)))
          return true;
      }
    }
  }
  return false;
}

void Session::setFrozen(bool frozen) {
  if (frozen == frozen_) return;
  if (frozen) {
    // What is frozen is what the console and the hand say at this moment, as well as they can say it.
    if (adaptive_.isLowered()) due_ = true;
    adaptive_.reset();
    isFreezing_ = true;
    makePictureNow();
    isFreezing_ = false;
    frozenHold_ = hold_;
    frozenKnobs_ = knobs_;
    frozenPan_ = pan_;
    frozenProbe_ = probe_;
    frozenScene_ = scene_;
  }
  frozen_ = frozen;
  if (!frozen) due();
  Q_EMIT frozenChanged(frozen);
}

Pose Session::picturePose() const { return poseOf(frozen_ ? frozenHold_ : hold_); }
const Knobs& Session::pictureKnobs() const { return frozen_ ? frozenKnobs_ : knobs_; }

void Session::setPictureSize(int width, int height) {
  if (width == width_ && height == height_) return;
  width_ = width;
  height_ = height;
  due();
}

void Session::due() {
  if (due_) return;
  due_ = true;
  QTimer::singleShot(0, this, &Session::makePictureNow);
}

void Session::makePictureNow() {
  if (!due_) return;
  due_ = false;
  if (!subject_ || width_ <= 0 || height_ <= 0) return;
  // A frozen picture is still drawn anew for a window of another size, from the frozen pose and knobs.
  if (frozen_ && picture_.width == width_ && picture_.height == height_) return;
  nextFrame_.stop();
  const Pose pose = picturePose();
  const double begin_s = now_s();
  if (!frozen_) {
    time_s_ = begin_s;
    ++number_;
    const bool mayLower = isAdaptive_ && !isFreezing_;
    usedKnobs_ = mayLower ? adaptive_.step(knobs_, pose, time_s_, lastFrame_ms_) : knobs_;
    // Anything but a frame that came by itself may have changed what persistence has to forget.
    unsettledFrames_ = isOwnFrame_ ? std::max(0, unsettledFrames_ - 1) : framesToSettle(knobs_.persistence);
  } else {
    usedKnobs_ = frozenKnobs_;
  }
  maker_.configure(pictureProbe(), usedKnobs_, pictureScene(), subject_->placedGrid, width_, height_, subject_->labels != nullptr,
                   frozen_ ? frozenPan_ : pan_);
  const bool wantsGaps = pictureScene().contact && skin_ && pose.status == PoseStatus::ok;
  if (wantsGaps && !frozen_) measureGaps(pose);
  FrameInput input;
  if (subject_->bricks) {
    // Zooming out, a weave undersamples as the paper's does; the better qualities read a coarser level.
    const double level_mm = usedKnobs_.quality == Quality::weave ? 0.0 : geometry().pixel_mm;
    input.echo = subject_->bricks->sourceFor(subject_->placedGrid, level_mm);
  } else {
    input.echo = VolumeView<const std::uint8_t>{subject_->volume->echo.data(), subject_->placedGrid};
  }
  if (subject_->labels) input.labels = VolumeView<const std::uint8_t>{subject_->labels->echo.data(), subject_->placedLabels};
  input.pose = pose;
  if (wantsGaps) input.gaps_mm = gaps_mm_;
  input.time_s = time_s_;
  input.number = number_;
  picture_ = maker_.make(input);
  ++framesMade_;
  const double end_s = now_s();
  lastFrame_ms_ = 1000.0 * (end_s - begin_s);
  if (movedAt_s_ && !frozen_) latency_.add(1e6 * (end_s - *movedAt_s_));
  movedAt_s_.reset();
  recent_.push_back(maker_.lastTimes());
  if (recent_.size() > kRememberedFrames) recent_.erase(recent_.begin());
  Q_EMIT pictureChanged();
  keepComing();
}

void Session::keepComing() {
  if (!isWatched_ || !changesByItself()) return;
  // What the picture's viewers spend counts as well: at least as long as frame and drawing took, the window is free for the hand.
  const double spent_ms = 1000.0 * (now_s() - time_s_);
  nextFrame_.start(static_cast<int>(std::lround(std::max(kFramePeriod_ms - spent_ms, std::min(spent_ms, 200.0)))));
}

std::vector<StepTime> Session::stepTimes() const {
  std::vector<StepTime> medians;
  for (const Step& step : maker_.plan().steps) {
    std::vector<double> seen;
    for (const auto& frame : recent_) {
      for (const StepTime& time : frame) {
        if (time.kind == step.kind) seen.push_back(time.measured_us);
      }
    }
    if (seen.empty()) continue;
    const auto middle = seen.begin() + static_cast<std::ptrdiff_t>(seen.size() / 2);
    std::nth_element(seen.begin(), middle, seen.end());
    medians.push_back({step.kind, *middle});
  }
  return medians;
}

}  // namespace ew::ui
