#include "calipers.h"

#include <QSettings>
#include <algorithm>

#include "ew/measurement/on_picture.h"
#include "session.h"
#include "words.h"

namespace ew::ui {
namespace {

using measurement::CaliperDrawing;
using measurement::CaliperKind;
using measurement::Measured;
using measurement::Measurement;

const auto kFollowsSetting = QStringLiteral("calipersFollowEdges");
constexpr std::size_t kMostClicks = 32;  // of an outline: more were drawn, along the edge already

}  // namespace

Calipers::Calipers(Session& session, QObject* parent)
    : QObject(parent), session_(session), followsEdges_(QSettings().value(kFollowsSetting, false).toBool()) {
  connect(&session_, &Session::pictureChanged, this, &Calipers::look);
  connect(&session_, &Session::subjectReplaced, this, &Calipers::forget);
  connect(&session_, &Session::frozenChanged, this, [this](bool frozen) {
    if (!frozen && !session_.isPlaying()) forget();
  });
}

Calipers::Still Calipers::still() const {
  const ScanState& shown = session_.shownState();
  return {session_.isPlaying(), shown.time_s, shown.number};
}

void Calipers::take(CaliperKind kind) {
  if (!session_.subject() || session_.picture().isEmpty()) return;
  if (drawing_.tool() == kind) {
    return change([](CaliperDrawing& drawing) {
      while (drawing.tool()) drawing.cancel();
    });
  }
  if (session_.pictureKnobs().mode == DisplayMode::mMode) {
    Q_EMIT said(tr("Calipers measure in the image, not in the strip of the M-mode. Switch to B or B + M (M)."));
    return;
  }
  if (session_.isPlaying())
    Q_EMIT pauseAsked();
  else
    session_.setFrozen(true);
  of_ = still();
  look();
  change([kind](CaliperDrawing& drawing) { drawing.take(kind); });
}

void Calipers::change(const std::function<void(CaliperDrawing&)>& edit) {
  const int next = drawing_.shown().nextNumber;
  edit(drawing_);
  if (followsEdges_ && drawing_.shown().nextNumber == next + 1) followEdge(next);
  measureAll();
  Q_EMIT changed();
}

void Calipers::setFollowsEdges(bool follows) {
  if (follows == followsEdges_) return;
  followsEdges_ = follows;
  QSettings().setValue(kFollowsSetting, follows);
  Q_EMIT changed();
}

void Calipers::followEdge(int number) {
  const Measurement* made = drawing_.shown().find(number);
  if (made == nullptr || made->caliper.kind != CaliperKind::trace || made->caliper.parts[0].points.size() > kMostClicks) return;
  auto outline = measurement::traceOnPicture(session_.picture().grey, session_.geometry(), made->caliper.parts[0].points);
  if (outline)
    drawing_.refine(number, std::move(*outline));
  else
    Q_EMIT said(words(outline.error().message));
}

void Calipers::look() {
  if (!of_) return;
  if (!(*of_ == still())) return forget();
  if (uncertaintyAt_ && geometry_ == session_.geometry()) return;
  // The same picture in a window of another size: other pixels.
  geometry_ = session_.geometry();
  uncertaintyAt_ = measurement::uncertaintyOn(session_.pictureProbe(), session_.pictureKnobs(), session_.pictureScene(), geometry_);
  lines_.clear();
  measureAll();
  Q_EMIT changed();
}

void Calipers::forget() {
  of_.reset();
  uncertaintyAt_ = {};
  drawing_ = CaliperDrawing();
  measureAll();
  Q_EMIT changed();
}

Measured Calipers::measured(const measurement::Caliper& caliper) const {
  auto found = measure(caliper, uncertaintyAt_);
  return found ? std::move(*found) : Measured{};
}

void Calipers::measureAll() {
  std::vector<Line> now;
  for (const Measurement& measurement : drawing_.shown().all) {
    const auto known = std::find_if(lines_.begin(), lines_.end(), [&](const Line& line) { return line.measurement == measurement; });
    now.push_back(known != lines_.end() ? *known : Line{measurement, measured(measurement.caliper)});
  }
  lines_ = std::move(now);
  unfinished_.reset();
  if (const auto caliper = drawing_.unfinished()) {
    Measurement next;
    next.number = drawing_.shown().nextNumber;
    next.caliper = *caliper;
    unfinished_ = Line{next, measured(*caliper)};
  }
}

}  // namespace ew::ui
