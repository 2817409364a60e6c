#include "scan/zoom/wide_scan.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace ew::ui {
namespace {

constexpr std::size_t kMostImagesWaiting = 2;
constexpr int kWideOverview_px = 176;  // the longer side of the small one

}  // namespace

/// What the worker weaves with.
struct WideScan::Loom {
  Panorama wide;
  Growth growth;
};

WideScan::WideScan(Session& session, QObject* parent) : QObject(parent), session_(session) {
  connect(&session_, &Session::imageChanged, this, &WideScan::takeImage);
  connect(&session_, &Session::frozenChanged, this, &WideScan::freeze);
  connect(&session_, &Session::subjectReplaced, this, &WideScan::drop);
  connect(&session_.console(), &ScanConsole::probeChanged, this, [this] {
    if (state_ == State::growing) cancel();
  });
  connect(&session_.cineLoop(), &CineLoop::changed, this, [this] {
    if (state_ == State::kept) toggle();  // another image is looked at
  });
  connect(&session_.console(), &ScanConsole::wideDetailAsked, this, [this](const Detail& detail) {
    detail_ = detail;
    render();
  });
}

WideScan::~WideScan() = default;

void WideScan::toggle() {
  switch (state_) {
    case State::off:
      return start();
    case State::growing:
      return cancel();
    case State::kept:
      state_ = State::hidden;
      session_.showWide({});
      break;
    case State::hidden:
      state_ = State::kept;
      if (last_) session_.showWide(*last_);
      render();
      break;
  }
  Q_EMIT changed();
}

void WideScan::start() {
  if (!session_.subject() || session_.fanImage().isEmpty()) return;
  if (session_.isPlaying()) return Q_EMIT said(tr("A wide image grows from a scan that runs. Close the recording (Escape) first."));
  if (session_.console().knobs().mode != DisplayMode::bMode)
    return Q_EMIT said(tr("A wide image grows from B-mode images. Switch to B (M) first."));
  session_.setFrozen(false);
  session_.console().setDetail(1.0, {});
  ++scan_;
  state_ = State::growing;
  growth_ = {};
  said_ = Woven::woven;
  detail_ = {};
  loom_ = std::make_shared<Loom>();
  takenFrame_ = session_.frames().framesMade();
  session_.frames().ask();
  Q_EMIT said(tr("Slide the probe slowly along its image. Freezing ends the wide image, Escape gives it up."));
  Q_EMIT changed();
}

void WideScan::cancel() {
  if (state_ != State::growing) return;
  drop();
  Q_EMIT said(tr("The wide image was given up."));
}

void WideScan::drop() {
  if (state_ == State::off) return;
  state_ = State::off;
  ++scan_;
  loom_.reset();
  last_.reset();
  growth_ = {};
  session_.showWide({});
  Q_EMIT changed();
}

void WideScan::freeze(bool frozen) {
  if (!frozen) return drop();
  if (state_ != State::growing) return;
  if (growth_.images == 0 && isSettled()) {
    drop();
    return Q_EMIT said(tr("No image was woven into the wide one: the probe has no position."));
  }
  state_ = State::kept;
  Q_EMIT changed();
}

void WideScan::takeImage() {
  if (state_ == State::off || state_ == State::hidden) return;
  if (session_.imageSize_px() != askedSize_px_ && last_) render();
  if (state_ != State::growing || session_.isFrozen() || session_.frames().framesMade() == takenFrame_) return;
  takenFrame_ = session_.frames().framesMade();
  const ScanState& shown = session_.shownState();
  if (shown.knobs.mode != DisplayMode::bMode) return cancel();
  if (worker_.waiting() >= kMostImagesWaiting) return;
  post(scan_, [image = std::make_shared<const GreyImage>(copyOf(session_.fanImage().grey)), geometry = session_.fanGeometry(),
               probe = shown.probe, knobs = shown.knobs, pose = shown.pose](Loom& loom) {
    Growth& growth = loom.growth;
    growth.latest = loom.wide.add(viewOf(*image), geometry, probe, knobs, pose);
    growth.images = loom.wide.imageCount();
    if (growth.latest != Woven::woven) ++growth.leftOut;
    growth.fan_mm.clear();
    if (loom.wide.empty() || growth.latest == Woven::noPose) return;
    growth.length_mm = loom.wide.geometry().width * loom.wide.geometry().pixel_mm;
    const Transform<frame::Wide, frame::Probe> probeToWide = rigidInverse(loom.wide.wideToWorld()) * pose.probeToWorld;
    for (const glm::dvec2& p_mm : fanOutline_mm(probe, knobs, geometry.depth_mm, 24))
      growth.fan_mm.emplace_back(carried(probeToWide, glm::dvec3(p_mm, 0.0)));
  });
}

void WideScan::render() {
  if (state_ == State::off || !loom_) return;
  post(scan_, [](Loom&) {});
}

void WideScan::post(std::uint64_t scan, const std::function<void(Loom&)>& weave) {
  ++underWay_;
  askedSize_px_ = session_.imageSize_px();
  worker_.add([this, scan, weave, loom = loom_, detail = detail_, size_px = askedSize_px_] {
    weave(*loom);
    std::optional<WideImage> shown;
    if (!loom->wide.empty() && worker_.waiting() <= 1) {  // what waits shows more
      WideImage& made = shown.emplace();
      made.detail = {detail.zoom, loom->wide.panWithin(detail.zoom, detail.pan)};
      made.geometry = loom->wide.fit(size_px.x, size_px.y, detail.zoom, detail.pan);
      made.grey = loom->wide.render(made.geometry);
      if (detail.zoom > 1.0) {
        const double scale = static_cast<double>(kWideOverview_px) / std::max(size_px.x, size_px.y);
        made.wholeGeometry = loom->wide.fit(std::max(1, static_cast<int>(std::lround(scale * size_px.x))),
                                            std::max(1, static_cast<int>(std::lround(scale * size_px.y))));
        made.whole = loom->wide.render(made.wholeGeometry);
      }
    }
    QMetaObject::invokeMethod(
        this, [this, scan, shown = std::move(shown), growth = loom->growth]() mutable { take(scan, std::move(shown), std::move(growth)); },
        Qt::QueuedConnection);
  });
}

void WideScan::take(std::uint64_t scan, std::optional<WideImage> shown, Growth growth) {
  --underWay_;
  if (scan != scan_ || state_ == State::off) return;
  growth_ = std::move(growth);
  if (shown) {
    last_ = std::move(shown);
    // What is asked for by now is on its way; until then the mouse goes on from there.
    if (!isSettled()) last_->detail = detail_;
    if (state_ != State::hidden) session_.showWide(*last_);
  }
  sayWhy(growth_.latest);
  Q_EMIT changed();
}

void WideScan::sayWhy(Woven outcome) {
  if (std::exchange(said_, outcome) == outcome || state_ != State::growing) return;
  const WideOptions limits;
  const auto degrees = static_cast<int>(std::lround(limits.mostTilt_rad * 180.0 / std::numbers::pi));
  switch (outcome) {
    case Woven::woven:
      break;
    case Woven::noPose:
      return Q_EMIT said(tr("The probe has no position: its images are not woven."));
    case Woven::tilted:
      return Q_EMIT said(tr("Tilted out of the plane of the wide image, by more than %1°: not woven. Tilt back.").arg(degrees));
    case Woven::offPlane:
      return Q_EMIT said(
          tr("Beside the plane of the wide image, by more than %1 mm: not woven. Slide back.").arg(static_cast<int>(limits.mostOff_mm)));
    case Woven::tooFast:
      return Q_EMIT said(tr("Too fast: there would be a gap. Go back to where the wide image ends, and slide slower."));
    case Woven::full:
      return Q_EMIT said(tr("The wide image is as large as it can be. Freezing keeps it."));
  }
}

}  // namespace ew::ui
