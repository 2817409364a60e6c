#include "session.h"

#include <QTimer>
#include <algorithm>
#include <cmath>

namespace ew::ui {
namespace {

constexpr std::size_t kRememberedFrames = 25;
constexpr double kGel_mm = 3.0;
constexpr int kContactSamples = 17;

}  // namespace

double usualPress_mm(const Probe& probe) {
  constexpr double kLeast_mm = 1.0;
  constexpr double kShare = 0.8;
  return std::min(kLeast_mm + kShare * faceSagitta_mm(probe), kMaxPress_mm);
}

Session::Session(QObject* parent) : QObject(parent) {
  // A hold needs a surface to stand on, also before there is a skin: the middle of the trunk's front.
  hold_.contact = {{0.0, -105.0, 0.0}, {0.0, -1.0, 0.0}};
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

void Session::setPlacedGrid(const Grid& grid) {
  if (!subject_ || subject_->placedGrid == grid) return;
  EW_EXPECTS(grid.dims == subject_->volume->grid.dims);
  subject_->placedGrid = grid;
  due();
  Q_EMIT subjectChanged();
}

void Session::setTitle(const QString& title) {
  if (!subject_ || subject_->title == title) return;
  subject_->title = title;
  Q_EMIT subjectChanged();
}

void Session::setSkin(std::shared_ptr<const Skin> skin) {
  skin_ = std::move(skin);
  Q_EMIT holdChanged();
}

void Session::setKnobs(const Knobs& knobs) {
  if (knobs == knobs_) return;
  knobs_ = knobs;
  due();
  Q_EMIT knobsChanged();
}

double Session::depth_mm() const {
  const double wanted = knobs_.depth_mm > 0.0 ? knobs_.depth_mm : probe_.defaultDepth_mm;
  return std::clamp(wanted, probe_.minDepth_mm, probe_.maxDepth_mm);
}

double Session::focus_mm() const { return knobs_.focus_mm > 0.0 ? std::min(knobs_.focus_mm, depth_mm()) : depth_mm() / 2.0; }

void Session::setHold(const Hold& hold) {
  hold_ = hold;
  due();
  Q_EMIT holdChanged();
}

std::optional<double> Session::contact() const {
  if (!skin_) return std::nullopt;
  const Pose held = pose();
  int touching = 0;
  for (const glm::dvec3& p_probe : facePoints_mm(probe_, kContactSamples)) {
    const glm::dvec3 p_world = glm::dvec3(held.probeToWorld.matrix * glm::dvec4(p_probe, 1.0));
    const Skin::Contact nearest = skin_->nearest(p_world);
    if (glm::dot(p_world - nearest.point_mm, nearest.outward) <= kGel_mm) ++touching;
  }
  return static_cast<double>(touching) / kContactSamples;
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
    makePictureNow();  // what is frozen is what the console and the hand say at this moment
    frozenHold_ = hold_;
    frozenKnobs_ = knobs_;
    frozenProbe_ = probe_;
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
  maker_.configure(pictureProbe(), pictureKnobs(), subject_->scene, subject_->placedGrid, width_, height_);
  const VolumeView<const std::uint8_t> voxels{subject_->volume->echo.data(), subject_->placedGrid};
  picture_ = maker_.make(voxels, picturePose());
  recent_.push_back(maker_.lastTimes());
  if (recent_.size() > kRememberedFrames) recent_.erase(recent_.begin());
  Q_EMIT pictureChanged();
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
