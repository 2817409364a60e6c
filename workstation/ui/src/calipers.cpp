#include "calipers.h"

#include <QPointer>
#include <QSettings>
#include <algorithm>
#include <iterator>
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
  const auto& tool = drawing().tool();
  const bool staysFor = tool && (*tool == kind || (isOutline(*tool) && isOutline(kind)));
  takeInto(kind, staysFor ? drawing().purpose() : CaliperDrawing::Purpose{});
}

void Calipers::takeFor(const measurement::PackageItem& item, const std::string& side) {
  if (const auto kind = toolFor(item.measure)) takeInto(*kind, {item.label, side});
}

void Calipers::takeInto(CaliperKind kind, const CaliperDrawing::Purpose& asked) {
  if (!session_.subject() || session_.picture().isEmpty()) return;
  if (drawing().tool() == kind && drawing().purpose() == asked) {
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
  turnTo(stillOf(session_));
  look();
  change([&](CaliperDrawing& drawing) { drawing.take(kind, purpose); });
}

std::optional<std::uint64_t> Calipers::picture() const { return drawn_.picture() ? std::optional(drawn_.now().picture) : std::nullopt; }

void Calipers::change(const std::function<void(CaliperDrawing&)>& edit) {
  const int next = drawing().shown().nextNumber;
  edit(mine());
  if (followsEdges_ && drawing().shown().nextNumber == next + 1) followEdge(next);
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
  const Measurement* made = drawing().shown().find(number);
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
      [self = QPointer<Calipers>(this), traced, number, picture = stillOf(session_)](const Result<void>& outcome) {
        if (!self) return;
        Drawn* drawn = self->drawn_.find(picture);
        const Measurement* clicked = drawn != nullptr ? drawn->drawing.shown().find(number) : nullptr;
        if (clicked == nullptr || clicked->caliper != traced->clicked) return;  // somebody has gone on with it
        if (!outcome) {
          if (outcome.error().code != ErrorCode::cancelled) Q_EMIT self->said(words(outcome.error().message));
          return;
        }
        drawn->drawing.refine(number, std::move(traced->outline));
        self->measureAll();
        Q_EMIT self->changed();
      });
}

void Calipers::turnTo(const StillPicture& picture) {
  const auto tool = drawing().tool();
  const CaliperDrawing::Purpose purpose = drawing().purpose();
  if (!drawn_.turnTo(picture)) return;
  if (drawn_.now().picture == 0) drawn_.now().picture = nextPicture_++;
  uncertaintyAt_ = {};
  if (drawing().tool() == tool && drawing().purpose() == purpose) return;
  if (tool)
    mine().take(*tool, purpose);
  else
    while (drawing().tool()) mine().cancel();
}

void Calipers::look() {
  if (!drawn_.picture()) return;
  if (!session_.isFrozen() && !session_.isPlaying()) return forget();
  turnTo(stillOf(session_));
  if (uncertaintyAt_ && geometry_ == session_.geometry()) return;
  // The same picture in a window of another size: other pixels.
  geometry_ = session_.geometry();
  uncertaintyAt_ = measurement::uncertaintyOn(session_.pictureProbe(), session_.pictureKnobs(), session_.pictureScene(), geometry_);
  lines_.clear();
  measureAll();
  Q_EMIT changed();
}

void Calipers::forget() {
  if (!drawn_.forget()) return;
  uncertaintyAt_ = {};
  measureAll();
  Q_EMIT changed();
}

Measured Calipers::measured(const measurement::Caliper& caliper) const {
  auto found = measure(caliper, uncertaintyAt_);
  return found ? std::move(*found) : Measured{};
}

void Calipers::measureAll() {
  const auto& all = drawing().shown().all;
  std::vector<Line> now;
  bool isSame = all.size() == lines_.size();
  for (const Measurement& measurement : all) {
    const auto known = std::find_if(lines_.begin(), lines_.end(), [&](const Line& line) { return line.measurement == measurement; });
    isSame = isSame && known - lines_.begin() == std::ssize(now);
    now.push_back(known != lines_.end() ? *known : Line{measurement, measured(measurement.caliper)});
  }
  lines_ = std::move(now);
  unfinished_.reset();
  if (const auto caliper = drawing().unfinished()) {
    Measurement next;
    next.number = drawing().shown().nextNumber;
    next.caliper = *caliper;
    unfinished_ = Line{next, measured(*caliper)};
  }
  if (!isSame) Q_EMIT linesChanged();
}

}  // namespace ew::ui
