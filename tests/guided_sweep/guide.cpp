#include "guide.h"

#include <cmath>
#include <utility>

namespace guided_sweep {
namespace {

constexpr const char* kSection = "guided_sweep";
constexpr double kInImage_mm = 3.0;  // half the thickness of what an image shows

ew::Point<ew::frame::World> faceOf(const ew::Pose& pose) { return pose.probeToWorld * ew::Point<ew::frame::Probe>{}; }

}  // namespace

Guide::Guide(ew::sdk::Host& host, Words words)
    : host_(host), words_(std::move(words)), overScan_(host.overlays().overScan()), overBody_(host.overlays().overBody()) {
  auto section = host.caseParts().add(kSection, kSchema);
  if (section)
    section_ = std::move(*section);
  else
    host.log().error(section.error().sentence());
  edits_ = host.cases().onChanged([this] { readPlan(); });
  opened_ = host.caseParts().onOpened([this](const std::filesystem::path&) {
    giveBack();
    travelled_.clear();
    drawPlan();
  });
  events_ = host.scan().onEvent([this](const ew::ScanEvent& event) {
    const auto* frame = std::get_if<ew::FrameMade>(&event.what);
    if (frame == nullptr) return;
    follow(frame->pose);
    if (isRunning() && event.time_s >= end_s_) giveBack();
  });
}

ew::Result<ew::Pose> Guide::poseNow() const {
  const auto state = host_.scan().state();
  if (!state) return ew::failure(ew::ErrorCode::badUsage, ew::say<"Nothing is scanned; open a case first.">());
  ew::Pose pose;
  pose.probeToWorld = state->pose.probeToWorld;
  return pose;
}

ew::Result<void> Guide::edit(SweepPlan plan, const std::string& what, const std::string& mergeKey) {
  return host_.caseParts().edit(kSection, toJson(plan), what, mergeKey);
}

ew::Result<void> Guide::takeStart(const std::string& what) {
  const auto pose = poseNow();
  if (!pose) return ew::passOn(pose.error());
  SweepPlan plan = plan_;
  plan.start = *pose;
  return edit(plan, what, {});
}

ew::Result<void> Guide::takeEnd(const std::string& what) {
  const auto pose = poseNow();
  if (!pose) return ew::passOn(pose.error());
  SweepPlan plan = plan_;
  plan.end = *pose;
  return edit(plan, what, {});
}

ew::Result<void> Guide::setDuration(double duration_s, const std::string& what) {
  SweepPlan plan = plan_;
  plan.duration_s = duration_s;
  return edit(plan, what, "duration");
}

void Guide::run() {
  if (!plan_.isWhole()) return;
  travelled_.clear();
  const auto path = std::make_shared<SweepPath>(plan_, host_.scan().now_s());
  end_s_ = path->end_s();
  hold_ = host_.scan().drive(path, [this] { giveBack(); });
  tellChanged();
}

void Guide::giveBack() {
  if (hold_ == nullptr) return;
  hold_.reset();
  tellChanged();
}

void Guide::readPlan() {
  const auto section = host_.caseParts().read(kSection);
  SweepPlan plan = section ? planOf(*section) : SweepPlan{};
  if (plan == plan_) return;
  plan_ = std::move(plan);
  giveBack();
  travelled_.clear();
  drawPlan();
  if (const auto state = host_.scan().state()) follow(state->pose);
  tellChanged();
}

void Guide::follow(const ew::Pose& pose) {
  if (isRunning()) {
    travelled_.push_back(faceOf(pose));
    drawPlan();
  }
  ew::sdk::ScanDrawing drawing;
  if (plan_.end) {
    // What an expert has in the middle of the image at the end of the sweep.
    const auto target_world = plan_.end->probeToWorld * ew::Point<ew::frame::Probe>{{0.0, 60.0, 0.0}};
    const auto target = inverse(pose.probeToWorld) * target_world;
    const double off_mm = std::abs(target.at.z);
    const bool isHere = off_mm < kInImage_mm;
    std::string text = isHere ? words_.here : words_.ahead;
    if (const auto place = text.find("%1"); place != std::string::npos) text.replace(place, 2, std::to_string(std::lround(off_mm)));
    ew::sdk::OverlayLine<ew::frame::Probe> ring{.isClosed = true, .isDashed = !isHere};
    for (int n = 0; n < 48; ++n) {
      const double angle_rad = n * 2.0 * 3.14159265358979 / 48;
      ring.points.push_back({{target.at.x + 10.0 * std::cos(angle_rad), target.at.y + 10.0 * std::sin(angle_rad), 0.0}});
    }
    drawing.lines.push_back(std::move(ring));
    const double right = host_.scan().geometry().markerLeft ? -1.0 : 1.0;  // as the image is seen
    drawing.labels.push_back({.at = {{target.at.x + right * 10.0, target.at.y, 0.0}}, .text = std::move(text), .hasDot = false});
  }
  overScan_->show(std::move(drawing));
}

void Guide::drawPlan() {
  using ew::sdk::OverlayRole;
  ew::sdk::BodyDrawing drawing;
  if (plan_.isWhole())
    drawing.lines.push_back({.points = {faceOf(*plan_.start), faceOf(*plan_.end)}, .role = OverlayRole::expert, .isDashed = true});
  if (plan_.start) drawing.labels.push_back({.at = faceOf(*plan_.start), .text = words_.start, .role = OverlayRole::expert});
  if (plan_.end) {
    drawing.labels.push_back({.at = faceOf(*plan_.end), .text = words_.end, .role = OverlayRole::expert});
    drawing.planes.push_back({.probeToWorld = plan_.end->probeToWorld, .role = OverlayRole::expert});
  }
  if (travelled_.size() > 1) drawing.lines.push_back({.points = travelled_, .role = OverlayRole::trainee, .width_px = 2.5});
  overBody_->show(std::move(drawing));
}

}  // namespace guided_sweep
