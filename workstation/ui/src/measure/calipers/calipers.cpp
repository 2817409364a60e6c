#include "measure/calipers/calipers.h"

#include <QPointer>
#include <QSettings>
#include <algorithm>
#include <iterator>
#include <memory>
#include <utility>

#include "ew/measurement/on_image.h"
#include "ew/widgets/words.h"
#include "jobs/jobs.h"
#include "scan/session.h"
#include "scan/spectrum_on_image.h"

namespace ew::ui {
namespace {

using measurement::CaliperDrawing;
using measurement::CaliperKind;
using measurement::Measured;
using measurement::Measurement;

const auto kFollowsSetting = QStringLiteral("calipersFollowEdges");
const auto kSnapsSetting = QStringLiteral("calipersSnap");
const auto kBeatsSetting = QStringLiteral("heartRateBeats");
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
    case measurement::ItemMeasure::volume:
      return CaliperKind::discs;
    case measurement::ItemMeasure::slope:
      return CaliperKind::slope;
    case measurement::ItemMeasure::heartRate:
      return CaliperKind::heartRate;
    case measurement::ItemMeasure::duration:
      return CaliperKind::interval;
    default:
      return std::nullopt;
  }
}

}  // namespace

Calipers::Calipers(Session& session, Jobs& jobs, QObject* parent)
    : QObject(parent),
      session_(session),
      jobs_(jobs),
      followsEdges_(QSettings().value(kFollowsSetting, false).toBool()),
      snaps_(QSettings().value(kSnapsSetting, false).toBool()) {
  const int beats = std::clamp(QSettings().value(kBeatsSetting, 1).toInt(), 1, measurement::kMostCycles);
  for (CaliperDrawing& strip : strips_) strip.setCycles(beats);
  connect(&session_, &Session::imageChanged, this, &Calipers::look);
  connect(&session_, &Session::subjectReplaced, this, &Calipers::forgetDrawn);
  connect(&session_, &Session::patientReplaced, this, &Calipers::forgetAll);
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
  if (!session_.subject() || session_.image().isEmpty()) return;
  if (kind == CaliperKind::distance && session_.imageKnobs().mode == DisplayMode::mMode) kind = CaliperKind::depthDistance;
  if (measurement::shapeOf(kind).isInStrip) return takeInStrip(kind, asked);
  if (drawing().tool() == kind && drawing().purpose() == asked) {
    return change([](CaliperDrawing& drawing) {
      while (drawing.tool()) drawing.cancel();
    });
  }
  if (session_.imageKnobs().mode == DisplayMode::mMode) {
    Q_EMIT said(tr("This tool measures in the image, and only the strip of the M-mode is shown. Switch to B or B + M."));
    return;
  }
  const CaliperDrawing::Purpose purpose = asked;  // it may be the drawing's own, and the drawing may change
  hold();
  if (!session_.isPlaying()) session_.setFrozen(true);
  turnTo(stillOf(session_));
  look();
  changeIn(Where::image, [&](CaliperDrawing& drawing) { drawing.take(kind, purpose); });
}

void Calipers::takeInStrip(CaliperKind kind, const CaliperDrawing::Purpose& asked) {
  if (knobsWithGate(session_)) {
    Q_EMIT said(tr("This tool measures the strip of the M-mode. Velocities and times of a spectrum are read automatically, below it."));
    return;
  }
  if (!hasStrip()) {
    Q_EMIT said(tr("This is measured in the strip of the M-mode. Switch to B + M or M (M)."));
    return;
  }
  if (drawing().tool() == kind && drawing().purpose() == asked) {
    return change([](CaliperDrawing& drawing) {
      while (drawing.tool()) drawing.cancel();
    });
  }
  const CaliperDrawing::Purpose purpose = asked;  // it may be the drawing's own, and the drawing may change
  followStrip();
  changeIn(Where::strip, [&](CaliperDrawing& drawing) { drawing.take(kind, purpose); });
}

bool Calipers::hasStrip() const {
  // The rows of a spectrum are velocities: nothing of an M-mode's depth is measured there.
  return !knobsWithGate(session_) && session_.seen().strip().width > 0 && session_.seen().strip().height > 1 &&
         session_.geometry().depth_mm > 0.0;
}

measurement::StripPlane Calipers::stripPlane() const { return {session_.seen().mMode(), session_.geometry().depth_mm}; }

void Calipers::putDownOther() {
  CaliperDrawing& other = mine(where_ == Where::strip ? Where::image : Where::strip);
  while (other.tool()) other.cancel();
  other.select(0);
}

void Calipers::choose(Where where, int number) {
  changeIn(where, [number](CaliperDrawing& drawing) { drawing.select(number); });
}

void Calipers::clear() {
  for (const Where where : {where_ == Where::strip ? Where::image : Where::strip, where_}) mine(where).clear();
  measureAll();
  Q_EMIT changed();
}

int Calipers::beats() const {
  const CaliperDrawing& strip = drawingIn(Where::strip);
  const Measurement* chosen = strip.shown().find(strip.selected());
  return chosen != nullptr && chosen->caliper.kind == CaliperKind::heartRate ? chosen->caliper.cycles : strip.cycles();
}

void Calipers::setBeats(int beats) {
  if (beats == this->beats() || beats < 1 || beats > measurement::kMostCycles) return;
  QSettings().setValue(kBeatsSetting, beats);
  for (CaliperDrawing& strip : strips_) strip.setCycles(beats);
  changeIn(Where::strip, [beats](CaliperDrawing& drawing) { drawing.setCyclesOf(drawing.selected(), beats); });
}

void Calipers::setSnaps(bool snaps) {
  if (snaps == snaps_) return;
  snaps_ = snaps;
  QSettings().setValue(kSnapsSetting, snaps);
  Q_EMIT changed();
}

measurement::UncertaintyAt Calipers::uncertaintyIn(const ImageMeasurements& image) {
  const ScanState& state = image.state;
  if (image.image < measurement::kStripImage) return measurement::uncertaintyOn(state.probe, state.knobs, state.scene, image.geometry);
  MModeStrip strip;  // its echoes are gone: a column is known, and not what it was interpolated from
  strip.configure(image.geometry.width, image.geometry.height, state.knobs.mSweep_s);
  return measurement::uncertaintyInStrip(state.probe, state.knobs, state.scene, image.geometry, strip);
}

void Calipers::restore(const std::vector<ImageMeasurements>& images, const std::vector<StillImage>& frames,
                       const std::vector<measurement::Combination>& combinations) {
  forgetDrawn();
  forgetAll();
  for (std::size_t n = 0; n < images.size(); ++n) {
    const ImageMeasurements& image = images[n];
    const auto at = uncertaintyIn(image);
    std::vector<measurement::Finding> found;
    for (const Measurement& each : image.measurements.all) found.push_back({image.image, each, measured(each.caliper, at), at});
    findings_.measuredIn(image.image, std::move(found));
    if (image.image >= measurement::kStripImage) {
      stripNumber_ = nextStrip_ = std::max(nextStrip_, (image.image - measurement::kStripImage) / 2 + 1);
      continue;
    }
    nextImage_ = std::max(nextImage_, image.image + 1);
    if (n < frames.size()) drawn_.put(frames[n], {CaliperDrawing(0, image.measurements), image.image});
  }
  for (const measurement::Combination& each : combinations) findings_.add(each.kind, each.of);
  if (!frames.empty() && session_.isPlaying()) {
    turnTo(stillOf(session_));
    look();
  }
  measureAll();
  Q_EMIT linesChanged();
  Q_EMIT changed();
}

int Calipers::combine(measurement::CombinationKind kind, std::vector<measurement::FigureRef> of) {
  const int number = findings_.add(kind, std::move(of));
  Q_EMIT changed();
  return number;
}

void Calipers::removeCombination(int number) {
  if (findings_.remove(number)) Q_EMIT changed();
}

std::optional<std::uint64_t> Calipers::image() const { return drawn_.image() ? std::optional(drawn_.now().image) : std::nullopt; }

void Calipers::putDown() {
  for (const Where where : {Where::image, Where::strip})
    while (drawingIn(where).tool()) mine(where).cancel();
}

void Calipers::exchange(Calipers& other) {
  for (Calipers* each : {this, &other}) {
    each->putDown();
    each->unfinished_.reset();
  }
  std::swap(drawn_, other.drawn_);
  std::swap(geometry_, other.geometry_);
  std::swap(uncertaintyAt_, other.uncertaintyAt_);
  std::swap(lines_, other.lines_);
  std::swap(strips_, other.strips_);
  std::swap(where_, other.where_);
  std::swap(stripAt_, other.stripAt_);
  if (!std::exchange(other.hadStrip_, true)) other.stripNumber_ = ++nextStrip_;
  hadStrip_ = true;
  std::swap(stripNumber_, other.stripNumber_);
  // No two images of the window have the same number, whichever of the two drew on them.
  nextImage_ = other.nextImage_ = std::max(nextImage_, other.nextImage_);
  nextStrip_ = other.nextStrip_ = std::max(nextStrip_, other.nextStrip_);
}

void Calipers::tellOfAll() {
  Q_EMIT linesChanged();
  Q_EMIT changed();
}

void Calipers::changeIn(Where where, const std::function<void(CaliperDrawing&)>& edit) {
  const bool isOther = where != where_;
  where_ = where;
  if (isOther) putDownOther();
  const int next = drawing().shown().nextNumber;
  edit(mine(where));
  if (where == Where::image && followsEdges_ && drawing().shown().nextNumber == next + 1) followEdge(next);
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
  if (made == nullptr || (made->caliper.kind != CaliperKind::trace && made->caliper.kind != CaliperKind::fittedEllipse)) return;
  if (made->caliper.parts[0].points.size() > kMostClicks) return;
  struct Traced {
    GreyImage image;
    DisplayGeometry geometry;
    measurement::Caliper clicked;
    std::vector<glm::dvec2> outline;
  };
  auto traced = std::make_shared<Traced>(Traced{copyOf(session_.image().grey), session_.geometry(), made->caliper, {}});
  jobs_.start(
      tr("Following the edge"),
      [traced](Progress&) -> Result<void> {
        const auto follow = traced->clicked.kind == CaliperKind::trace ? measurement::traceOnImage : measurement::ellipseOnImage;
        auto outline = follow(viewOf(std::as_const(traced->image)), traced->geometry, traced->clicked.parts[0].points);
        if (!outline) return passOn(outline.error());
        traced->outline = std::move(*outline);
        return {};
      },
      [self = QPointer<Calipers>(this), traced, number, image = stillOf(session_)](const Result<void>& outcome) {
        if (!self) return;
        Drawn* drawn = self->drawn_.find(image);
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

void Calipers::turnTo(const StillImage& image) {
  const auto tool = mine().tool();
  const CaliperDrawing::Purpose purpose = mine().purpose();
  if (!drawn_.turnTo(image)) return;
  if (drawn_.now().image == 0) drawn_.now().image = nextImage_++;
  uncertaintyAt_ = {};
  if (mine().tool() == tool && mine().purpose() == purpose) return;
  if (tool)
    mine().take(*tool, purpose);
  else
    while (mine().tool()) mine().cancel();
}

void Calipers::look() {
  followStrip();
  if (!drawn_.image()) return;
  if (!session_.isFrozen() && !session_.isPlaying()) return forget();
  turnTo(stillOf(session_));
  if (uncertaintyAt_ && geometry_ == session_.geometry()) return;
  // The same image in a window of another size: other pixels.
  geometry_ = session_.geometry();
  uncertaintyAt_ = measurement::uncertaintyOn(session_.imageProbe(), session_.imageKnobs(), session_.imageScene(), geometry_);
  std::erase_if(lines_, [](const Line& line) { return line.where == Where::image; });
  measureAll();
  Q_EMIT changed();
}

/// Where its echoes are now: they move with the strip, and leave it.
void Calipers::followStrip() {
  if (std::exchange(wasPlaying_, session_.isPlaying()) != session_.isPlaying()) {
    if (!session_.isPlaying()) {
      const int beats = strips_[1].cycles();
      strips_[1] = CaliperDrawing();  // the recording was closed, and its moments with it
      strips_[1].setCycles(beats);
    }
    if (where_ == Where::strip && !hasStrip()) where_ = Where::image;
    measureAll();
    Q_EMIT changed();
  }
  if (hasStrip()) mine(Where::strip).setScale({stripPlane().mmPerS(), 1.0});
  if (!hasStrip() && mine(Where::strip).tool()) {  // its strip is gone
    changeIn(Where::strip, [](CaliperDrawing& drawing) {
      while (drawing.tool()) drawing.cancel();
    });
  }
  bool isOther = false;
  for (Line& line : lines_)
    if (line.where == Where::strip) isOther = std::exchange(line.hasLeft, hasLeft(line.measurement.caliper)) != line.hasLeft || isOther;
  if (isOther) Q_EMIT changed();
}

bool Calipers::hasLeft(const measurement::Caliper& caliper) const {
  if (!hasStrip()) return true;
  const measurement::StripPlane plane = stripPlane();
  const auto& points = caliper.parts[0].points;
  return std::any_of(points.begin(), points.end(), [&](const glm::dvec2& point) { return !plane.pixelOf(point); });
}

void Calipers::forgetAll() {
  findings_.clear();
  saved_.clear();
  Q_EMIT changed();
}

void Calipers::forgetDrawn() {
  // What was measured in a strip stays, so the next one has another number.
  if (std::any_of(lines_.begin(), lines_.end(), [](const Line& line) { return line.where == Where::strip; })) stripNumber_ = ++nextStrip_;
  for (CaliperDrawing& strip : strips_) {
    const int beats = strip.cycles();
    strip = CaliperDrawing();
    strip.setCycles(beats);
  }
  where_ = Where::image;
  stripAt_ = {};
  drawn_.forget();
  uncertaintyAt_ = {};
  measureAll();
  Q_EMIT changed();
}

std::size_t Calipers::unsavedCount() const {
  const auto isAsWritten = [this](std::uint64_t image, int number) {
    const measurement::Finding *now = findings_.find(image, number), *then = saved_.find(image, number);
    if (now == nullptr || then == nullptr) return now == then;  // a result may be left of a measurement that was deleted
    return now->measurement == then->measurement;
  };
  const auto measured = std::count_if(findings_.all().begin(), findings_.all().end(), [&](const measurement::Finding& each) {
    return each.measurement.item.empty() && !isAsWritten(each.image, each.measurement.number);
  });
  const auto& written = saved_.combinations();
  const auto combined =
      std::count_if(findings_.combinations().begin(), findings_.combinations().end(), [&](const measurement::Combination& each) {
        return std::find(written.begin(), written.end(), each) == written.end() ||
               !std::all_of(each.of.begin(), each.of.end(), [&](const auto& ref) { return isAsWritten(ref.image, ref.number); });
      });
  return static_cast<std::size_t>(measured + combined);
}

void Calipers::setSaved(const measurement::Findings& written) { saved_ = written; }

void Calipers::forget() {
  if (!drawn_.forget()) return;
  uncertaintyAt_ = {};
  measureAll();
  Q_EMIT changed();
}

Measured Calipers::measured(const measurement::Caliper& caliper, const measurement::UncertaintyAt& at) {
  auto found = measure(caliper, at);
  return found ? std::move(*found) : Measured{};
}

void Calipers::measureLines(Where where, const measurement::Measurements& shown, std::vector<Line>& now) {
  bool isStripKnown = false;
  for (const Measurement& measurement : shown.all) {
    const auto known = std::find_if(lines_.begin(), lines_.end(),
                                    [&](const Line& line) { return line.where == where && line.measurement == measurement; });
    if (known != lines_.end()) {
      now.push_back(*known);
      continue;
    }
    if (where == Where::strip && hasStrip() && !std::exchange(isStripKnown, true))
      stripAt_ = measurement::uncertaintyInStrip(session_.imageProbe(), session_.imageKnobs(), session_.imageScene(), session_.geometry(),
                                                 session_.seen().mMode());
    const measurement::UncertaintyAt& at = uncertainty(where);
    now.push_back({measurement, measured(measurement.caliper, at), where, at, where == Where::strip && hasLeft(measurement.caliper)});
  }
}

void Calipers::measureAll() {
  std::vector<Line> now;
  measureLines(Where::image, drawingIn(Where::image).shown(), now);
  const std::size_t ofImage = now.size();
  measureLines(Where::strip, drawingIn(Where::strip).shown(), now);
  const bool isSame = std::equal(now.begin(), now.end(), lines_.begin(), lines_.end(),
                                 [](const Line& a, const Line& b) { return a.where == b.where && a.measurement == b.measurement; });
  lines_ = std::move(now);
  unfinished_.reset();
  if (const auto caliper = drawing().unfinished()) {
    Measurement next;
    next.number = drawing().shown().nextNumber;
    next.caliper = *caliper;
    unfinished_ = Line{next, measured(*caliper, uncertainty(where_)), where_, {}, false};
  }
  if (isSame) return;
  std::vector<measurement::Finding> found, inStrip;
  for (std::size_t n = 0; n < lines_.size(); ++n) {
    const Line& line = lines_[n];
    const bool isOfImage = n < ofImage;
    (isOfImage ? found : inStrip).push_back({isOfImage ? drawn_.now().image : strip(), line.measurement, line.measured, line.at});
  }
  if (drawn_.image()) findings_.measuredIn(drawn_.now().image, std::move(found));
  findings_.measuredIn(strip(), std::move(inStrip));
  Q_EMIT linesChanged();
}

}  // namespace ew::ui
