#include "panel/session_door.h"

#include "ew/core/frames.h"
#include "ew/registration/verdict.h"
#include "ew/stitching/project.h"
#include "ew/widgets/words.h"
#include "panel/stitch_session.h"

namespace ew::stitching {

SessionDoor::SessionDoor(StitchSession& session, QObject* parent) : QObject(parent), session_(session) {
  setObjectName(QStringLiteral("stitchDoor"));
}

bool SessionDoor::openProjectFile(const QString& file) { return session_.document().openProject(file.toStdString()); }

bool SessionDoor::saveProjectAs(const QString& file) { return session_.document().saveAs(file.toStdString()); }

void SessionDoor::saveResultIn(const QString& folder) { session_.mosaic().saveIn(folder.toStdString()); }

void SessionDoor::setCalibrationFile(int volume, const QString& file) {
  session_.inputs().setCalibration(static_cast<std::size_t>(volume), file.toStdString());
}

void SessionDoor::chooseThePair(int a, int b) { session_.look().choosePair(static_cast<std::size_t>(a), static_cast<std::size_t>(b)); }

QString SessionDoor::projectAsText() const { return words(projectText(session_.document().project(), {})); }

QString SessionDoor::verdictOf(int a, int b) const {
  const StitchResults::PairLine line = session_.results().pairLine(static_cast<std::size_t>(a), static_cast<std::size_t>(b));
  return line.outcome != nullptr ? QString::fromLatin1(registration::nameOf(line.outcome->rigid.verdict)) : QString();
}

QList<double> SessionDoor::transformNow() const {
  QList<double> numbers;
  for (const double number : rowsOf(session_.look().transform())) numbers << number;
  return numbers;
}

QList<double> SessionDoor::matesAt(double x, double y, double z, bool warped) const {
  const StitchLook::Stage stage = warped ? StitchLook::Stage::elastic : StitchLook::Stage::rigid;
  const glm::dvec3 fixed = session_.look().fixedMapping(stage)({x, y, z});
  const glm::dvec3 moving = session_.look().movingMapping(stage)({x, y, z});
  return {fixed.x, fixed.y, fixed.z, moving.x, moving.y, moving.z};
}

bool SessionDoor::isElasticFound() const { return session_.look().hasElastic(); }

QString SessionDoor::effortOfWarp() const {
  const auto& shown = session_.look().pair();
  const PairDeformation* pair = shown ? session_.results().warpedOf(shown->fixed, shown->moving) : nullptr;
  return pair != nullptr ? QString::fromLatin1(nameOf(pair->effort)) : QString();
}

double SessionDoor::largestWarp_mm() const {
  const ChainState* found = session_.results().found();
  return found != nullptr ? found->warpSummary.largest_mm : 0.0;
}

int SessionDoor::nodesOfResult() const {
  const auto result = session_.mosaic().volume();
  return result ? static_cast<int>(result->grid.voxelCount()) : 0;
}

}  // namespace ew::stitching
