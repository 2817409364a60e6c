#include "scan/cine_loop.h"

#include <utility>

namespace ew::ui {
namespace {

constexpr double kFormedAtOnce_ms = 40.0;  // of images of the ring; what takes longer goes on between other events
constexpr std::size_t kFormedAtOnce = 4;   // images, whatever they take: playing at any speed needs no more
constexpr double kFormedInATurn_ms = 12.0;

}  // namespace

CineLoop::CineLoop(ScanContents& scan, FrameTimer& frames) : scan_(scan), frames_(frames) {
  connect(&formOn_, &QTimer::timeout, this, &CineLoop::formOn);
}

void CineLoop::freezeLatest() {
  if (!scan_.cine.empty()) scan_.cineFrame = scan_.cine.frameCount() - 1;
}

void CineLoop::runOn() {
  formOn_.stop();
  scan_.cineFrame.reset();
  scan_.cine.beginAnew();
}

void CineLoop::forget() {
  scan_.cine.clear();
  formOn_.stop();
  if (!std::exchange(scan_.cineFrame, std::nullopt)) return;
  Q_EMIT changed();
}

void CineLoop::show(std::size_t frame) {
  if (!scan_.frozen || !scan_.cineFrame || frame >= scan_.cine.frameCount() || frame == *scan_.cineFrame) return;
  scan_.cineFrame = frame;
  form();
  Q_EMIT changed();
}

void CineLoop::form() {
  if (!scan_.subject() || !scan_.hasSize()) return;
  if (!scan_.forming)
    scan_.forming = std::make_unique<ScanContents::Forming>(
        ScanContents::Forming{{CineForming(*scan_.subject(), 0), CineForming(*scan_.subject(), 0)}});
  const glm::ivec2 size_px(scan_.width_px, scan_.height_px);
  const auto isQuick = [this](std::size_t left) {
    return left <= kFormedAtOnce || static_cast<double>(left) * frames_.lastFrame_ms() <= kFormedAtOnce_ms;
  };
  ScanContents::Forming& forming = *scan_.forming;
  const std::size_t shown = forming.shown, other = 1 - shown;
  if (isQuick(forming.two[shown].aim(scan_.cine, *scan_.cineFrame, size_px, scan_.processing))) return showFormed(shown);
  if (isQuick(forming.two[other].aim(scan_.cine, *scan_.cineFrame, size_px, scan_.processing))) return showFormed(other);
  formOn_.start(0);
}

void CineLoop::formOn() {
  CineForming& there = scan_.forming->two[1 - scan_.forming->shown];
  const double until_s = frames_.now_s() + 0.001 * kFormedInATurn_ms;
  do there.makeNext(scan_.cine);
  while (there.left() > 0 && frames_.now_s() < until_s);
  if (there.left() == 0) showFormed(1 - scan_.forming->shown);
}

void CineLoop::showFormed(std::size_t which) {
  formOn_.stop();
  CineForming& here = scan_.forming->two[which];
  const double begin_s = frames_.now_s();
  const std::size_t left = here.left();
  while (here.left() > 0) here.makeNext(scan_.cine);
  std::optional<double> frame_ms;
  if (left > 0) frame_ms = 1000.0 * (frames_.now_s() - begin_s) / static_cast<double>(left);
  scan_.forming->shown = which;
  scan_.forming->isSeen = true;
  scan_.asScanned = scan_.cine.frame(*scan_.cineFrame);
  scan_.frozen = processed(scan_.asScanned, scan_.processing);
  scan_.shown = *scan_.frozen;
  scan_.image = here.image();
  frames_.countFormed(frame_ms);
  Q_EMIT formed();
}

}  // namespace ew::ui
