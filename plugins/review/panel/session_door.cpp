#include "panel/session_door.h"

#include "panel/body_view.h"
#include "panel/image_view.h"
#include "panel/session/review_reports.h"
#include "panel/track_view.h"

namespace ew::review {

SessionDoor::SessionDoor(ReviewReports& reports, const ImageView& reviewed, const ImageView& compared, const TrackView& tracks,
                         const BodyView& body, QObject* parent)
    : QObject(parent), reports_(reports), reviewed_(reviewed), compared_(compared), tracks_(tracks), body_(body) {
  setObjectName(QStringLiteral("reviewDoor"));
}

const ImageView* SessionDoor::viewOf(const QString& image) const {
  for (const ImageView* each : {&reviewed_, &compared_})
    if (each->objectName() == image) return each;
  return nullptr;
}

bool SessionDoor::isIdle(const QString& image) const {
  const ImageView* view = viewOf(image);
  return view != nullptr && view->isIdle();
}

QStringList SessionDoor::shownSettings(const QString& image) const {
  const ImageView* view = viewOf(image);
  return view != nullptr ? view->shownSettings() : QStringList();
}

QPointF SessionDoor::pixelOfPoint(double lateral_mm, double axial_mm) const { return reviewed_.pixelOf({lateral_mm, axial_mm}); }

double SessionDoor::pixelOfTime(double clock_s) const { return tracks_.xOf(clock_s); }

int SessionDoor::shownRegions() const { return body_.shownRegions(); }

void SessionDoor::writeReportFile(const QString& file, bool isOfClass) { reports_.write(file.toStdString(), isOfClass); }

}  // namespace ew::review
