#include "panel/alignment_edits.h"

#include <QLocale>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ew/widgets/words.h"
#include "logic/slices.h"
#include "logic/stitch_document.h"
#include "panel/charts.h"
#include "panel/notices.h"
#include "panel/project_document.h"
#include "panel/stitch_look.h"
#include "panel/stitch_results.h"
#include "panel/stitch_runs.h"

namespace ew::stitching {
namespace {}  // namespace

AlignmentEdits::AlignmentEdits(Notices& notices, ProjectDocument& document, const StitchResults& results, StitchLook& look,
                               StitchRuns& runs)
    : notices_(notices), document_(document), results_(results), look_(look), runs_(runs) {}

const StitchProject& AlignmentEdits::project() const { return document_.project(); }

void AlignmentEdits::setPlace(std::size_t index, const Transform<frame::World, frame::View>& shown, const QString& what,
                              const std::string& mergeKey) {
  const Transform<frame::Placed, frame::View> place = rigidInverse(results_.placedToShown(index)) * shown;
  document_.edit(withPlace(project(), index, renamed<frame::World, frame::View>(place), Placement::hand), what, mergeKey);
}

void AlignmentEdits::setPlacement(std::size_t index, Placement placement) {
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
  document_.edit(withPlace(project(), index, project().volumes[index].toWorld, placement), done());
}

QString AlignmentEdits::nameOfPair() const {
  const auto& shown = look_.pair();
  return shown ? tr("%1 to %2").arg(words(letterOf(shown->fixed)), words(letterOf(shown->moving))) : QString();
}

void AlignmentEdits::editPair(const std::function<void(ProjectPair&)>& change, const QString& what, const std::string& mergeKey) {
  const auto& shown = look_.pair();
  if (!shown) return;
  ProjectPair pair = pairOf(project(), shown->fixed, shown->moving);
  change(pair);
  document_.edit(withPair(project(), pair), what, mergeKey);
}

void AlignmentEdits::addLandmark(const glm::dvec3& fixed_mm, const glm::dvec3& moving_mm) {
  const auto count = look_.landmarks().size();
  const registration::LandmarkPair mark{tr("place %1").arg(count + 1).toStdString(), fixed_mm, moving_mm};
  editPair([&](ProjectPair& pair) { pair.landmarks.push_back(mark); }, tr("landmark %1 of %2").arg(count + 1).arg(nameOfPair()));
}

void AlignmentEdits::removeLandmark(int landmark) {
  const auto marks = look_.landmarks();
  if (landmark < 0 || landmark >= static_cast<int>(marks.size())) return;
  editPair([&](ProjectPair& pair) { pair.landmarks.erase(pair.landmarks.begin() + landmark); },
           tr("remove landmark %1").arg(words(marks[static_cast<std::size_t>(landmark)].name)));
}

void AlignmentEdits::renameLandmark(int landmark, const QString& name) {
  const auto marks = look_.landmarks();
  if (landmark < 0 || landmark >= static_cast<int>(marks.size())) return;
  if (name.trimmed().isEmpty()) {
    Q_EMIT notices_.problem(tr("A landmark needs a name; type one."));
    Q_EMIT refused();
    return;
  }
  editPair([&](ProjectPair& pair) { pair.landmarks[static_cast<std::size_t>(landmark)].name = name.trimmed().toStdString(); },
           tr("call landmark %1 '%2'").arg(landmark + 1).arg(name.trimmed()));
}

void AlignmentEdits::useLandmarks() {
  if (runs_.isBusy()) return;
  if (look_.landmarks().size() < 3) {
    Q_EMIT notices_.problem(tr("Three places that do not lie on one line are needed; mark %n more in both volumes.", nullptr,
                               3 - static_cast<int>(look_.landmarks().size())));
    return;
  }
  editPair(
      [](ProjectPair& pair) {
        pair.method = PairMethod::landmarks;
        pair.start.reset();
        pair.decision = Decision::undecided;
      },
      tr("bring %1 together by landmarks").arg(nameOfPair()));
  runs_.run(Step::graph, tr("Matching %1 by landmarks").arg(nameOfPair()));
}

void AlignmentEdits::setDecision(Decision decision) {
  if (!look_.pair()) return;
  const Decision before = pairOf(project(), look_.pair()->fixed, look_.pair()->moving).decision;
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

void AlignmentEdits::setTransform(const Transform<frame::Moving, frame::Fixed>& fixedToMoving, const QString& what,
                                  const std::string& mergeKey) {
  editPair(
      [&](ProjectPair& pair) {
        pair.start = fixedToMoving;
        pair.method = PairMethod::byHand;
        if (pair.decision == Decision::rejected) pair.decision = Decision::undecided;
      },
      what, mergeKey);
}

void AlignmentEdits::nudge(const glm::dvec3& shift_mm, const glm::dvec3& rotation_deg) {
  if (!look_.pair()) return;
  const auto [fixed, moving] = *look_.pair();
  const glm::dmat3 axes(look_.plane().right, look_.plane().down, look_.plane().normal());
  const bool shifts = shift_mm != glm::dvec3(0.0);
  const auto next = nudged(look_.transform(), axes * shift_mm, axes * rotation_deg, look_.cross());
  const std::string key = (shifts ? "shift " : "turn ") + std::to_string(fixed) + ' ' + std::to_string(moving);
  // The name tells the whole way since the keys began to be pressed.
  auto from = look_.transform();
  if (const StitchProject* before = document_.beforeMerging(key)) {
    const ProjectPair was = pairOf(*before, fixed, moving);
    const StitchResults::PairLine line = results_.pairLine(fixed, moving);
    from = was.start && was.method == PairMethod::byHand ? *was.start
           : line.outcome != nullptr                     ? line.outcome->rigid.fixedToMoving
                                                         : look_.startTransform();
  }
  const Transform<frame::Fixed, frame::Fixed> motion = rigidInverse(next) * from;
  const QLocale locale;
  QString what;
  if (shifts) {
    what = tr("nudge %1 by %2 mm")
               .arg(words(letterOf(moving)), locale.toString(glm::length(carried(motion, look_.cross()) - look_.cross()), 'g', 3));
  } else {
    const glm::dmat3 turn(motion.matrix);
    const double angle = std::acos(std::clamp(0.5 * (turn[0][0] + turn[1][1] + turn[2][2] - 1.0), -1.0, 1.0)) * 180.0 / M_PI;
    what = tr("rotate %1 by %2°").arg(words(letterOf(moving)), locale.toString(angle, 'g', 3));
  }
  look_.expectRigid();
  setTransform(next, what, key);
}

void AlignmentEdits::pinStart() {
  if (runs_.isRunning()) return;
  const auto now = look_.transform();
  editPair([&](ProjectPair& pair) { pair.start = now; }, tr("redo %1").arg(nameOfPair()), "redo " + nameOfPair().toStdString());
}

void AlignmentEdits::setEffort(registration::ElasticEffort effort) {
  StitchProject next = project();
  next.settings.effort = effort;
  document_.edit(std::move(next), tr("elastic quality %1").arg(nameOfEffort(effort)));
}

void AlignmentEdits::setPairEffort(std::optional<registration::ElasticEffort> effort) {
  editPair([&](ProjectPair& pair) { pair.effort = effort; },
           effort ? tr("deform %1 %2").arg(nameOfPair(), nameOfEffort(*effort)) : tr("deform %1 as all pairs").arg(nameOfPair()));
}

void AlignmentEdits::warpAgain() { runs_.run(Step::elastic, tr("Deforming %1 again").arg(nameOfPair())); }

void AlignmentEdits::redoPair(PairMethod method, std::optional<double> maxRotation_deg) {
  if (!look_.pair() || runs_.isBusy()) return;
  editPair(
      [&](ProjectPair& pair) {
        pair.method = method;
        pair.maxRotation_deg = maxRotation_deg;
        pair.decision = Decision::undecided;
        if (method != PairMethod::byHand && method != PairMethod::refine) pair.start.reset();
      },
      tr("redo %1").arg(nameOfPair()), "redo " + nameOfPair().toStdString());
  runs_.run(Step::graph, tr("Matching %1 again").arg(nameOfPair()));
}

}  // namespace ew::stitching
