#include "calipers.h"

#include <QPointer>
#include <QSettings>
#include <algorithm>
#include <memory>

#include "ew/measurement/on_picture.h"
#include "jobs.h"
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

/// Whether it gives circumference and area.
bool isOutline(CaliperKind kind) {
  return kind == CaliperKind::ellipse || kind == CaliperKind::fittedEllipse || kind == CaliperKind::trace;
}

std::optional<CaliperKind> toolFor(measurement::ItemMeasure measure) {
  switch (measure) {
    case measurement::ItemMeasure::distance:
      return CaliperKind::distance;
    case measurement::ItemMeasure::circumference:
      return CaliperKind::ellipse;
    case measurement::ItemMeasure::area:
      return CaliperKind::trace;
    case measurement::ItemMeasure::angle:
      return CaliperKind::angle;
    default:
      return std::nullopt;
  }
}

}  // namespace

Calipers::Calipers(Session& session, Jobs& jobs, QObject* parent)
    : QObject(parent), session_(session), jobs_(jobs), followsEdges_(QSettings().value(kFollowsSetting, false).toBool()) {
  connect(&session_, &Session::pictureChanged, this, &Calipers::look);
  connect(&session_, &Session::subjectReplaced, this, &Calipers::forget);
  connect(&session_, &Session::frozenChanged, this, [this](bool frozen) {
    if (!frozen && !session_.isPlaying()) forget();
  });
}

void Calipers::take(CaliperKind kind) {
  const auto& tool = drawing_.tool();
  const bool staysFor = tool && (*tool == kind || (isOutline(*tool) && isOutline(kind)));
  takeInto(kind, staysFor ? drawing_.purpose() : CaliperDrawing::Purpose{});
}

void Calipers::takeFor(const measurement::PackageItem& item, const std::string& side) {
  if (const auto kind = toolFor(item.measure)) takeInto(*kind, {item.label, side});
}

void Calipers::takeInto(CaliperKind kind, const CaliperDrawing::Purpose& asked) {
  if (!session_.subject() || session_.picture().isEmpty()) return;
  if (drawing_.tool() == kind && drawing_.purpose() == asked) {
    return change([](CaliperDrawing& drawing) {
      while (drawing.tool()) drawing.cancel();
    });
  }
  if (session_.pictureKnobs().mode == DisplayMode::mMode) {
    Q_EMIT said(tr("Calipers measure in the image, not in the strip of the M-mode. Switch to B or B + M (M)."));
    return;
  }
  const CaliperDrawing::Purpose purpose = asked;  // it may be the drawing's own, and the drawing may change
  hold();
  if (!session_.isPlaying()) session_.setFrozen(true);
  of_ = still();
  if (pictures_.try_emplace(*of_, nextPicture_).second) ++nextPicture_;
  look();
  change([&](CaliperDrawing& drawing) { drawing.take(kind, purpose); });
}

std::optional<std::uint64_t> Calipers::picture() const { return of_ ? std::optional(pictures_.at(*of_)) : std::nullopt; }

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
  struct Traced {
    GreyImage picture;
    DisplayGeometry geometry;
    measurement::Caliper clicked;
    std::vector<glm::dvec2> outline;
  };
  auto traced = std::make_shared<Traced>(Traced{copyOf(session_.picture().grey), session_.geometry(), made->caliper, {}});
  jobs_.start(
      tr("Following the edge"),
      [traced](Progress&) -> Result<void> {
        auto outline =
            measurement::traceOnPicture(viewOf(std::as_const(traced->picture)), traced->geometry, traced->clicked.parts[0].points);
        if (!outline) return passOn(outline.error());
        traced->outline = std::move(*outline);
        return {};
      },
      [self = QPointer<Calipers>(this), traced, number, picture = still()](const Result<void>& outcome) {
        if (!self) return;
        CaliperDrawing* drawing = self->drawingOf(picture);
        const Measurement* clicked = drawing != nullptr ? drawing->shown().find(number) : nullptr;
        if (clicked == nullptr || clicked->caliper != traced->clicked) return;  // somebody has gone on with it
        if (!outcome) {
          if (outcome.error().code != ErrorCode::cancelled) Q_EMIT self->said(words(outcome.error().message));
          return;
        }
        drawing->refine(number, std::move(traced->outline));
        self->measureAll();
        Q_EMIT self->changed();
      });
}

CaliperDrawing* Calipers::drawingOf(const Still& picture) {
  if (of_ == picture) return &drawing_;
  const auto found = ofOthers_.find(picture);
  return found != ofOthers_.end() ? &found->second : nullptr;
}

void Calipers::turnTo(const Still& picture) {
  const auto tool = drawing_.tool();
  const CaliperDrawing::Purpose purpose = drawing_.purpose();
  const bool wasEmpty = drawing_.isEmpty();
  if (!wasEmpty) ofOthers_.insert_or_assign(*of_, std::move(drawing_));
  const auto known = ofOthers_.extract(picture);
  drawing_ = known ? std::move(known.mapped()) : CaliperDrawing();
  if (drawing_.tool() != tool || drawing_.purpose() != purpose) {
    if (tool)
      drawing_.take(*tool, purpose);
    else
      while (drawing_.tool()) drawing_.cancel();
  }
  of_ = picture;
  if (pictures_.try_emplace(picture, nextPicture_).second) ++nextPicture_;
  uncertaintyAt_ = {};
}

void Calipers::look() {
  if (!of_) return;
  if (!session_.isFrozen() && !session_.isPlaying()) return forget();
  if (*of_ != still()) turnTo(still());
  if (uncertaintyAt_ && geometry_ == session_.geometry()) return;
  // The same picture in a window of another size: other pixels.
  geometry_ = session_.geometry();
  uncertaintyAt_ = measurement::uncertaintyOn(session_.pictureProbe(), session_.pictureKnobs(), session_.pictureScene(), geometry_);
  lines_.clear();
  measureAll();
  Q_EMIT changed();
}

void Calipers::forget() {
  if (!of_) return;
  of_.reset();
  ofOthers_.clear();
  pictures_.clear();
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
