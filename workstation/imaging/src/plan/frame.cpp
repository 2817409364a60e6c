#include "ew/imaging/frame.h"

#include <algorithm>
#include <chrono>
#include <ostream>
#include <utility>

#include "ew/imaging/effects/gain.h"

namespace ew {
namespace {

// Nanoseconds a pixel inside the fan, as measured with `echoweave bench slicing` and lastTimes().
constexpr double kWeave_ns = 1.1;
constexpr double kLinear_ns = 3.4;
constexpr double kStretch_ns = 1.1;
constexpr double kTable_ns = 0.4;

double pixelsOf(const Spans& spans) {
  double pixels = 0.0;
  for (const auto& row : spans)
    for (const RowSpan& span : row) pixels += span.end - span.begin;
  return pixels;
}

bool hasTable(const Knobs& knobs, const Scene& scene) {
  const bool neutral = knobs.gain == 1.0 && std::all_of(knobs.dgc.begin(), knobs.dgc.end(), [](double factor) { return factor == 1.0; });
  return scene.gainAndDgc && !neutral;
}

Plan planFor(double pixels, const Knobs& knobs, const Scene& scene, const DisplayGeometry& geometry, const Grid& grid) {
  const auto estimate = [pixels](double perPixel_ns) { return 1e-3 * perPixel_ns * pixels; };
  Plan plan;
  if (knobs.quality == Quality::linear) {
    plan.steps.push_back({StepKind::sampleLinear, estimate(kLinear_ns)});
  } else {
    plan.steps.push_back({StepKind::sampleWeave, estimate(kWeave_ns)});
    const double largestVoxel_mm = std::max({grid.spacing_mm.x, grid.spacing_mm.y, grid.spacing_mm.z});
    if (geometry.pixel_mm < largestVoxel_mm) {
      const double samplesPerPixel = geometry.pixel_mm / largestVoxel_mm;
      plan.steps.back().estimated_us *= samplesPerPixel * samplesPerPixel;
      plan.steps.push_back({StepKind::zoomStretch, estimate(kStretch_ns)});
    }
  }
  if (hasTable(knobs, scene)) plan.steps.push_back({StepKind::table, estimate(kTable_ns)});
  return plan;
}

}  // namespace

const char* nameOf(StepKind kind) {
  switch (kind) {
    case StepKind::sampleWeave:
      return "weave";
    case StepKind::sampleLinear:
      return "linear";
    case StepKind::sampleCubic:
      return "cubic";
    case StepKind::zoomStretch:
      return "zoom stretch";
    case StepKind::elevationPlanes:
      return "slice thickness";
    case StepKind::labels:
      return "tissues";
    case StepKind::contact:
      return "contact";
    case StepKind::attenuation:
      return "shadow";
    case StepKind::reverberation:
      return "reverberation";
    case StepKind::focusStretch:
      return "focus (stretch)";
    case StepKind::focusKernel:
      return "focus";
    case StepKind::noise:
      return "noise";
    case StepKind::scanConversion:
      return "scan conversion";
    case StepKind::edges:
      return "edges";
    case StepKind::persistence:
      return "persistence";
    case StepKind::table:
      return "gain and DGC";
    case StepKind::mMode:
      return "M-mode";
  }
  return "unknown";
}

std::ostream& operator<<(std::ostream& out, const Plan& plan) {
  const char* separator = "";
  for (const Step& step : plan.steps) {
    out << separator << nameOf(step.kind);
    separator = " + ";
  }
  return out;
}

Plan makePlan(const Probe& probe, const Knobs& knobs, const Scene& scene, const DisplayGeometry& geometry, const Grid& grid, bool) {
  return planFor(pixelsOf(fanSpans(probe, knobs, geometry)), knobs, scene, geometry, grid);
}

struct FrameMaker::Parts {
  bool configured_ = false;
  Probe probe_;
  Knobs knobs_;
  Scene scene_;
  Grid grid_;
  DisplayGeometry geometry_;
  Plan plan_;
  Spans spans_;
  double spanPixels_ = 0.0;
  std::vector<double> rowPosition_;  ///< depth of each row, 0 at the face, 1 at the bottom
  std::vector<std::uint8_t> table_;  ///< 256 x rows of Eq. 5
  SliceScratch scratch_;
  GreyImage picture_;
  std::vector<StepTime> times_;
  PoseStatus status_ = PoseStatus::missing;

  void configure(const Probe& probe, const Knobs& knobs, const Scene& scene, const Grid& grid, int width, int height);
  ImageView<const std::uint8_t> make(const FrameInput& input);
};

FrameMaker::FrameMaker(int) : parts_(std::make_unique<Parts>()) {}
FrameMaker::~FrameMaker() = default;
FrameMaker::FrameMaker(FrameMaker&&) noexcept = default;
FrameMaker& FrameMaker::operator=(FrameMaker&&) noexcept = default;
void FrameMaker::configure(const Probe& probe, const Knobs& knobs, const Scene& scene, const Grid& grid, int width, int height, bool) {
  parts_->configure(probe, knobs, scene, grid, width, height);
}
ImageView<const std::uint8_t> FrameMaker::make(const FrameInput& input) { return parts_->make(input); }
ImageView<const std::uint8_t> FrameMaker::make(const VolumeView<const std::uint8_t>& volume, const Pose& pose) {
  FrameInput input;
  input.echo = volume;
  input.pose = pose;
  return make(input);
}
ImageView<const std::uint8_t> FrameMaker::strip() const { return {}; }
int FrameMaker::stripCursor() const { return 0; }
void FrameMaker::forget() {}
const Plan& FrameMaker::plan() const { return parts_->plan_; }
const DisplayGeometry& FrameMaker::geometry() const { return parts_->geometry_; }
const std::vector<StepTime>& FrameMaker::lastTimes() const { return parts_->times_; }
PoseStatus FrameMaker::lastStatus() const { return parts_->status_; }
const Spans& FrameMaker::spans() const { return parts_->spans_; }

void FrameMaker::Parts::configure(const Probe& probe, const Knobs& knobs, const Scene& scene, const Grid& grid, int width, int height) {
  EW_EXPECTS(width >= 1 && height >= 1);
  if (configured_ && probe == probe_ && knobs == knobs_ && scene == scene_ && grid == grid_ && width == geometry_.width &&
      height == geometry_.height)
    return;
  const DisplayGeometry geometry = fitDisplay(probe, knobs, width, height);
  const bool geometryChanged = !configured_ || geometry != geometry_ || probe != probe_;
  const bool gainChanged = geometryChanged || knobs.gain != knobs_.gain || knobs.dgc != knobs_.dgc;
  probe_ = probe;
  knobs_ = knobs;
  scene_ = scene;
  grid_ = grid;
  geometry_ = geometry;
  if (geometryChanged) {
    spans_ = fanSpans(probe_, knobs_, geometry_);
    spanPixels_ = pixelsOf(spans_);
    rowPosition_.resize(static_cast<std::size_t>(height));
    for (int y = 0; y < height; ++y) {
      const double axial_mm = (static_cast<double>(y) - geometry_.face_px.y) * geometry_.pixel_mm;
      rowPosition_[static_cast<std::size_t>(y)] = std::clamp(axial_mm / geometry_.depth_mm, 0.0, 1.0);
    }
    // Slicing writes inside the fan alone, so what surrounds it stays black from here on.
    picture_.width = width;
    picture_.height = height;
    picture_.pixels.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
  }
  plan_ = planFor(spanPixels_, knobs_, scene_, geometry_, grid_);
  if (gainChanged || table_.empty()) {
    if (hasTable(knobs_, scene_))
      buildGainTable(knobs_.gain, knobs_.dgc, rowPosition_, table_);
    else
      table_.clear();
  }
  times_.reserve(4);
  configured_ = true;
}

ImageView<const std::uint8_t> FrameMaker::Parts::make(const FrameInput& input) {
  EW_EXPECTS(configured_);
  times_.clear();
  status_ = input.pose.status;
  if (status_ == PoseStatus::ok && !checkRigid(input.pose.probeToWorld.matrix)) status_ = PoseStatus::invalid;
  if (status_ != PoseStatus::ok) {
    std::fill(picture_.pixels.begin(), picture_.pixels.end(), std::uint8_t{0});
    return viewOf(std::as_const(picture_));
  }

  using Clock = std::chrono::steady_clock;
  const auto since = [](Clock::time_point start) { return std::chrono::duration<double, std::micro>(Clock::now() - start).count(); };
  const ImageView<std::uint8_t> picture = viewOf(picture_);
  const Transform<frame::Voxel, frame::Image> imageToVoxel =
      input.echo.grid.worldToVoxel() * input.pose.probeToWorld * geometry_.imageToProbe();

  const auto sliceStart = Clock::now();
  scratch_.zoomSampling_us = 0.0;
  slice(knobs_.quality, input.echo, imageToVoxel, spans_, picture, scratch_);
  const double slice_us = since(sliceStart);
  for (const Step& step : plan_.steps) {
    switch (step.kind) {
      case StepKind::sampleWeave:
      case StepKind::sampleLinear:
        times_.push_back({step.kind, scratch_.zoomSampling_us > 0.0 ? scratch_.zoomSampling_us : slice_us});
        break;
      case StepKind::zoomStretch:
        times_.push_back({step.kind, scratch_.zoomSampling_us > 0.0 ? slice_us - scratch_.zoomSampling_us : 0.0});
        break;
      case StepKind::table: {
        const auto start = Clock::now();
        applyGainTable(picture, spans_, table_);
        times_.push_back({step.kind, since(start)});
        break;
      }
      default:
        break;
    }
  }
  return viewOf(std::as_const(picture_));
}

}  // namespace ew
