#include "panel/stitch_session.h"

#include <QLocale>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "ew/sdk/panel.h"
#include "panel/charts.h"
#include "panel/session_parts.h"

namespace ew::stitching {
namespace {

using sdk::words;

}  // namespace

void StitchSession::afterChoice() {
  landmarkResult_.reset();
  const auto marks = landmarks();
  if (chosenLandmark_ >= static_cast<int>(marks.size())) chosenLandmark_ = static_cast<int>(marks.size()) - 1;
  if (marks.empty()) return;
  if (auto result = registration::registerLandmarks(marks)) landmarkResult_ = std::move(*result);
}

void StitchSession::setPlace(std::size_t index, const Transform<frame::World, frame::View>& shown, const QString& what,
                             const std::string& mergeKey) {
  const Transform<frame::Placed, frame::View> place = rigidInverse(placedToShown(index)) * shown;
  edit(withPlace(project(), index, renamed<frame::World, frame::View>(place), Placement::hand), what, mergeKey);
}

void StitchSession::setPlacement(std::size_t index, Placement placement) {
  if (index >= project().volumes.size()) return;
  const QString name = words(letterOf(index));
  const auto done = [&] {
    switch (placement) {
      case Placement::unknown:
        return tr("clear the pose of %1").arg(name);
      case Placement::tracker:
        return tr("believe the tracker about %1").arg(name);
      case Placement::hand:
        return tr("take the pose of %1 as a start").arg(name);
    }
    return QString();
  };
  edit(withPlace(project(), index, project().volumes[index].toWorld, placement), done());
}

QString StitchSession::nameOfPair() const {
  return pair_ ? tr("%1 to %2").arg(words(letterOf(pair_->fixed)), words(letterOf(pair_->moving))) : QString();
}

void StitchSession::editPair(const std::function<void(ProjectPair&)>& change, const QString& what, const std::string& mergeKey) {
  if (!pair_) return;
  ProjectPair pair = pairOf(project(), pair_->fixed, pair_->moving);
  change(pair);
  edit(withPair(project(), pair), what, mergeKey);
}

std::vector<registration::LandmarkPair> StitchSession::landmarks() const {
  return pair_ ? pairOf(project(), pair_->fixed, pair_->moving).landmarks : std::vector<registration::LandmarkPair>{};
}

void StitchSession::pick(bool moving, const glm::dvec3& p_mm) {
  if (!pair_) return;
  (moving ? pickedMoving_ : pickedFixed_) = p_mm;
  if (!pickedFixed_ || !pickedMoving_) {
    Q_EMIT lookChanged();
    Q_EMIT changed();
    return;
  }
  const registration::LandmarkPair mark{tr("place %1").arg(landmarks().size() + 1).toStdString(), *pickedFixed_, *pickedMoving_};
  pickedFixed_.reset();
  pickedMoving_.reset();
  chosenLandmark_ = static_cast<int>(landmarks().size());
  editPair([&](ProjectPair& pair) { pair.landmarks.push_back(mark); },
           tr("landmark %1 of %2").arg(landmarks().size() + 1).arg(nameOfPair()));
}

void StitchSession::dropPick() {
  pickedFixed_.reset();
  pickedMoving_.reset();
  Q_EMIT lookChanged();
  Q_EMIT changed();
}

void StitchSession::removeLandmark(int landmark) {
  const auto marks = landmarks();
  if (landmark < 0 || landmark >= static_cast<int>(marks.size())) return;
  editPair([&](ProjectPair& pair) { pair.landmarks.erase(pair.landmarks.begin() + landmark); },
           tr("remove landmark %1").arg(words(marks[static_cast<std::size_t>(landmark)].name)));
}

void StitchSession::renameLandmark(int landmark, const QString& name) {
  const auto marks = landmarks();
  if (landmark < 0 || landmark >= static_cast<int>(marks.size())) return;
  if (name.trimmed().isEmpty()) {
    Q_EMIT problem(tr("A landmark needs a name; type one."));
    Q_EMIT changed();
    return;
  }
  editPair([&](ProjectPair& pair) { pair.landmarks[static_cast<std::size_t>(landmark)].name = name.trimmed().toStdString(); },
           tr("call landmark %1 '%2'").arg(landmark + 1).arg(name.trimmed()));
}

void StitchSession::useLandmarks() {
  if (isBusy()) return;
  if (landmarks().size() < 3) {
    Q_EMIT problem(tr("Three places that do not lie on one line are needed; mark %n more in both volumes.", nullptr,
                      3 - static_cast<int>(landmarks().size())));
    return;
  }
  editPair(
      [](ProjectPair& pair) {
        pair.method = PairMethod::landmarks;
        pair.start.reset();
        pair.decision = Decision::undecided;
      },
      tr("bring %1 together by landmarks").arg(nameOfPair()));
  run(Step::graph, tr("Matching %1 by landmarks").arg(nameOfPair()));
}

void StitchSession::setDecision(Decision decision) {
  if (!pair_) return;
  const Decision before = pairOf(project(), pair_->fixed, pair_->moving).decision;
  const Decision next = before == decision ? Decision::undecided : decision;
  const auto what = [&] {
    switch (next) {
      case Decision::undecided:
        return tr("clear decision on %1").arg(nameOfPair());
      case Decision::accepted:
        return tr("accept %1").arg(nameOfPair());
      case Decision::rejected:
        return tr("reject %1").arg(nameOfPair());
    }
    return QString();
  };
  editPair([&](ProjectPair& pair) { pair.decision = next; }, what());
}

void StitchSession::setTransform(const Transform<frame::Moving, frame::Fixed>& fixedToMoving, const QString& what,
                                 const std::string& mergeKey) {
  editPair(
      [&](ProjectPair& pair) {
        pair.start = fixedToMoving;
        pair.method = PairMethod::byHand;
        if (pair.decision == Decision::rejected) pair.decision = Decision::undecided;
      },
      what, mergeKey);
}

void StitchSession::nudge(const glm::dvec3& shift_mm, const glm::dvec3& rotation_deg) {
  if (!pair_) return;
  const glm::dmat3 axes(plane_.right, plane_.down, plane_.normal());
  const bool shifts = shift_mm != glm::dvec3(0.0);
  const auto next = nudged(transform(), axes * shift_mm, axes * rotation_deg, cross_);
  const std::string key = (shifts ? "shift " : "turn ") + std::to_string(pair_->fixed) + ' ' + std::to_string(pair_->moving);
  // The name tells the whole way since the keys began to be pressed.
  auto from = transform();
  if (const StitchProject* before = document_.beforeMerging(key)) {
    const ProjectPair was = pairOf(*before, pair_->fixed, pair_->moving);
    const PairLine line = pairLine(pair_->fixed, pair_->moving);
    from = was.start && was.method == PairMethod::byHand ? *was.start
           : line.outcome != nullptr                     ? line.outcome->rigid.fixedToMoving
                                                         : startTransform();
  }
  const Transform<frame::Fixed, frame::Fixed> motion = rigidInverse(next) * from;
  const QLocale locale;
  QString what;
  if (shifts) {
    what =
        tr("nudge %1 by %2 mm").arg(words(letterOf(pair_->moving)), locale.toString(glm::length(carried(motion, cross_) - cross_), 'g', 3));
  } else {
    const glm::dmat3 turn(motion.matrix);
    const double angle = std::acos(std::clamp(0.5 * (turn[0][0] + turn[1][1] + turn[2][2] - 1.0), -1.0, 1.0)) * 180.0 / M_PI;
    what = tr("rotate %1 by %2°").arg(words(letterOf(pair_->moving)), locale.toString(angle, 'g', 3));
  }
  if (stage_ != Stage::rigid) stage_ = Stage::rigid;
  setTransform(next, what, key);
}

void StitchSession::pinStart() {
  if (running_) return;
  const auto now = transform();
  editPair([&](ProjectPair& pair) { pair.start = now; }, tr("redo %1").arg(nameOfPair()), "redo " + nameOfPair().toStdString());
}

void StitchSession::setEffort(registration::ElasticEffort effort) {
  StitchProject next = project();
  next.settings.effort = effort;
  edit(std::move(next), tr("elastic quality %1").arg(nameOfEffort(effort)));
}

void StitchSession::setPairEffort(std::optional<registration::ElasticEffort> effort) {
  editPair([&](ProjectPair& pair) { pair.effort = effort; },
           effort ? tr("deform %1 %2").arg(nameOfPair(), nameOfEffort(*effort)) : tr("deform %1 as all pairs").arg(nameOfPair()));
}

void StitchSession::warpAgain() { run(Step::elastic, tr("Deforming %1 again").arg(nameOfPair())); }

void StitchSession::redoPair(PairMethod method, std::optional<double> maxRotation_deg) {
  if (!pair_ || isBusy()) return;
  editPair(
      [&](ProjectPair& pair) {
        pair.method = method;
        pair.maxRotation_deg = maxRotation_deg;
        pair.decision = Decision::undecided;
        if (method != PairMethod::byHand && method != PairMethod::refine) pair.start.reset();
      },
      tr("redo %1").arg(nameOfPair()), "redo " + nameOfPair().toStdString());
  run(Step::graph, tr("Matching %1 again").arg(nameOfPair()));
}

}  // namespace ew::stitching
