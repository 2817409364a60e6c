#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <utility>

#include "beam_path.h"
#include "colour/colour_path.h"
#include "compound.h"
#include "ew/core/contract.h"
#include "ew/imaging/effects/edge_enhancement.h"
#include "ew/imaging/effects/gain.h"
#include "ew/imaging/effects/persistence.h"
#include "ew/imaging/frame.h"
#include "ew/imaging/m_mode.h"
#include "ew/imaging/resolved.h"
#include "planning.h"
#include "spectrum/spectrum_path.h"

namespace ew {
namespace {

/// What the caller asked for, to see whether anything changed.
struct Asked {
  Probe probe;
  Knobs knobs;
  Scene scene;
  Grid grid;
  int width = 0;
  int height = 0;
  FrameParts parts;
  Pan pan;
  bool operator==(const Asked&) const = default;
};

using Clock = std::chrono::steady_clock;
double since_us(Clock::time_point start) { return std::chrono::duration<double, std::micro>(Clock::now() - start).count(); }

void blacken(GreyImage& image) { std::fill(image.pixels.begin(), image.pixels.end(), std::uint8_t{0}); }

}  // namespace

struct FrameMaker::Parts {
  explicit Parts(int threads) : bands_(threads), scratch_(static_cast<std::size_t>(bands_.threads())) {}

  void configure(const Probe& probe, const Knobs& knobs, const Scene& scene, const Grid& grid, int width, int height,
                 const FrameParts& parts, const Pan& pan);
  ImageView<const std::uint8_t> make(const FrameInput& input);
  [[nodiscard]] const BeamGrid& beamGrid() const { return beams_.grid(); }
  [[nodiscard]] const BeamImage& beamLevels() const { return beams_.levels(); }

  Plan plan_;  ///< of the last frame
  DisplayGeometry geometry_;
  Spans spans_;
  std::vector<StepTime> times_;
  PoseStatus status_ = PoseStatus::missing;
  MModeStrip strip_;
  PersistenceMemory persistence_;
  ColourMemory colourMemory_;
  FrameBefore before_;
  detail::ColourPath colour_;
  bool hasColour_ = false;
  detail::SpectrumPath spectrum_;
  bool hasSpectrum_ = false;
  [[nodiscard]] const MModeStrip& strip() const { return hasSpectrum_ ? spectrum_.spectrogram().strip() : strip_; }
  [[nodiscard]] ImageView<const Rgba> colours() const {
    return hasColour_ && status_ == PoseStatus::ok ? colour_.image() : ImageView<const Rgba>{};
  }

 private:
  void makeGreyTables(bool hasStrip);
  void layCompound(const Probe& probe, double spacing_mm);
  void runTimed(StepKind kind, const FrameInput& input);
  void run(StepKind kind, const FrameInput& input);
  void runOnBeams(StepKind kind, const FrameInput& input, detail::BeamPath& beams);
  void compound(const FrameInput& input);
  void sampleDisplay(const SliceSource& echo, const Pose& pose);
  void sharpen();
  void drawStrip(const FrameInput& input);

  std::optional<Asked> asked_;
  Knobs knobs_;  ///< within limits, as the scene is
  Scene scene_;
  Plan touching_;  ///< while the whole face touches the skin
  Plan lifted_;    ///< while a part of it does not
  Bands bands_;
  std::vector<detail::ThreadScratch> scratch_;  ///< one for each thread
  detail::BeamPath beams_;
  std::vector<detail::BeamPath> asides_;  ///< the other directions of a compound image
  detail::CompoundTable compound_;
  detail::ChangeDetector<Probe, BeamGrid, double, int> compoundFrom_;
  detail::ChangeDetector<Probe, double, bool, DisplayGeometry> imagesFrom_;
  detail::ChangeDetector<Probe, double, bool, double, double> stripFrom_;
  GreyImage sampled_;               ///< black outside the fan, for good: steps write inside alone
  GreyImage sharpened_;             ///< likewise
  GreyImage* image_ = nullptr;      ///< the one shown
  double zoomSamplingShare_ = 1.0;  ///< of the last slice; the rest was its stretch
  detail::ChangeDetector<double, std::array<double, kDgcSliders>, Tone> tableFrom_;
  detail::ChangeDetector<double, std::array<double, kDgcSliders>, Tone, std::size_t> beamTableFrom_;
  std::vector<double> rowPosition_;  ///< depth of each row, 0 at the face, 1 at the bottom
  std::vector<std::uint8_t> table_;  ///< 256 grey levels of each row
  std::vector<double> samplePosition_;
  std::vector<std::uint8_t> beamTable_;  ///< 256 grey levels of each sample of the M-mode beam
  std::vector<std::uint8_t> beam_;
};

FrameMaker::FrameMaker(int threads) : parts_(std::make_unique<Parts>(threads)) {}
FrameMaker::~FrameMaker() = default;
FrameMaker::FrameMaker(FrameMaker&&) noexcept = default;
FrameMaker& FrameMaker::operator=(FrameMaker&&) noexcept = default;
void FrameMaker::configure(const Probe& probe, const Knobs& knobs, const Scene& scene, const Grid& grid, int width, int height,
                           const FrameParts& parts, const Pan& pan) {
  parts_->configure(probe, knobs, scene, grid, width, height, parts, pan);
}
DisplayImage FrameMaker::make(const FrameInput& input) {
  const ImageView<const std::uint8_t> grey = parts_->make(input);
  return {grey, parts_->colours()};
}
DisplayImage FrameMaker::make(const VolumeView<const std::uint8_t>& volume, const Pose& pose) {
  FrameInput input;
  input.echo = volume;
  input.pose = pose;
  return make(input);
}
ImageView<const std::uint8_t> FrameMaker::strip() const { return parts_->strip().image(); }
const MModeStrip& FrameMaker::mMode() const { return parts_->strip(); }
int FrameMaker::stripCursor() const { return parts_->strip().cursor(); }
void FrameMaker::forget() {
  parts_->persistence_.empty = true;
  parts_->strip_.clear();
  parts_->colourMemory_ = {};
  parts_->before_ = {};
  parts_->spectrum_.clear();
}
FrameMemory FrameMaker::memory() const {
  FrameMemory memory;
  if (!parts_->persistence_.empty) memory.persistence = parts_->persistence_;
  memory.strip = parts_->strip_;
  memory.colour = parts_->colourMemory_;
  memory.before = parts_->before_;
  if (parts_->hasSpectrum_) memory.spectrum = std::make_shared<SpectrumMemory>(parts_->spectrum_.memory());
  return memory;
}
void FrameMaker::recall(const FrameMemory& memory) {
  const ImageView<const std::uint8_t> mine = parts_->strip_.image(), theirs = memory.strip.image();
  if (mine.width == theirs.width && mine.height == theirs.height) parts_->strip_ = memory.strip;
  parts_->before_ = memory.before;
  if (parts_->hasSpectrum_ && memory.spectrum)
    parts_->spectrum_.recall(*memory.spectrum);
  else
    parts_->spectrum_.clear();
  parts_->colourMemory_ = memory.colour;  // sums of another box start afresh with the next frame
  if (memory.persistence.empty)
    parts_->persistence_.empty = true;
  else
    parts_->persistence_ = memory.persistence;  // one of another size starts afresh with the next frame (beginPersistence)
}
const Plan& FrameMaker::plan() const { return parts_->plan_; }
const DisplayGeometry& FrameMaker::geometry() const { return parts_->geometry_; }
const std::vector<StepTime>& FrameMaker::lastTimes() const { return parts_->times_; }
PoseStatus FrameMaker::lastStatus() const { return parts_->status_; }
const Spans& FrameMaker::spans() const { return parts_->spans_; }
const BeamGrid& FrameMaker::beamGrid() const {
  static const BeamGrid none;
  return parts_->plan_.onBeams ? parts_->beamGrid() : none;
}
const Spectrogram* FrameMaker::spectrogram() const { return parts_->hasSpectrum_ ? &parts_->spectrum_.spectrogram() : nullptr; }
std::span<const std::complex<float>> FrameMaker::dopplerSamples() const { return parts_->spectrum_.samples(); }
const BeamGrid& FrameMaker::colourGrid() const {
  static const BeamGrid none;
  return parts_->hasColour_ ? parts_->colour_.grid() : none;
}
const BeamImage& FrameMaker::beamLevels() const {
  static const BeamImage none;
  return parts_->plan_.onBeams ? parts_->beamLevels() : none;
}

void FrameMaker::Parts::configure(const Probe& probe, const Knobs& knobs, const Scene& scene, const Grid& grid, int width, int height,
                                  const FrameParts& parts, const Pan& pan) {
  EW_EXPECTS(width >= 1 && height >= 1);
  const auto isAsked = [&](const Asked& last) {
    return last.width == width && last.height == height && last.parts == parts && last.knobs == knobs && last.probe == probe &&
           last.scene == scene && last.grid == grid && last.pan == pan;
  };
  if (asked_ && isAsked(*asked_)) return;
  asked_ = Asked{probe, knobs, scene, grid, width, height, parts, pan};
  scene_ = detail::knownScene(limited(scene), parts, limited(knobs));
  knobs_ = detail::knownKnobs(limited(knobs), probe, scene_, parts);
  if (knobs_.persistence == 0.0) persistence_.empty = true;

  geometry_ = fitDisplay(probe, knobs_, width, height, pan);
  if (imagesFrom_.changesTo(probe, knobs_.steering_rad, knobs_.trapezoid, geometry_)) {
    spans_ = fanSpans(probe, knobs_, geometry_);
    sampled_ = GreyImage(width, height);
    sharpened_ = GreyImage(width, height);
    persistence_.empty = true;
    rowPosition_.resize(static_cast<std::size_t>(height));
    for (int y = 0; y < height; ++y)
      rowPosition_[static_cast<std::size_t>(y)] = std::clamp(geometry_.probePoint_mm(0, y).y / geometry_.depth_mm, 0.0, 1.0);
    tableFrom_ = {};
  }
  image_ = knobs_.edgeEnhancement > 0.0 ? &sharpened_ : &sampled_;

  const double spacing_mm =
      formsEchoes(scene_) ? detail::liveSpacing_mm(probe, knobs_, scene_, geometry_.depth_mm) : detail::beamSpacing_mm(geometry_, grid);
  const detail::FrameSize size = detail::frameSizeOf(probe, geometry_, spacing_mm, spans_);
  touching_ = detail::planOf(probe, knobs_, scene_, geometry_, grid, size, parts.labels, false);
  lifted_ = detail::planOf(probe, knobs_, scene_, geometry_, grid, size, parts.labels, true);
  plan_ = touching_;
  plan_.steps.reserve(lifted_.steps.size());
  times_.reserve(lifted_.steps.size());
  beams_.configure(lifted_, probe, knobs_, scene_, geometry_, spacing_mm);
  layCompound(probe, spacing_mm);
  hasColour_ = knobs_.colour.has_value();
  if (hasColour_)
    colour_.configure(probe, knobs_, scene_, geometry_);
  else
    colourMemory_ = {};

  hasSpectrum_ = knobs_.mode == DisplayMode::spectrum;
  if (hasSpectrum_)
    spectrum_.configure(probe, knobs_, scene_, geometry_);
  else
    spectrum_.clear();
  const bool hasStrip = knobs_.mode == DisplayMode::mMode || knobs_.mode == DisplayMode::both;
  if (!hasStrip) {
    strip_.configure(0, 0, knobs_.mSweep_s);
  } else {
    strip_.configure(width, height, knobs_.mSweep_s);
    if (stripFrom_.changesTo(probe, knobs_.steering_rad, knobs_.trapezoid, geometry_.depth_mm, knobs_.mLine)) strip_.clear();
    beam_.resize(static_cast<std::size_t>(beams_.grid().samples));
  }
  makeGreyTables(hasStrip);
}

void FrameMaker::Parts::layCompound(const Probe& probe, double spacing_mm) {
  const auto isCompound = [](const Step& step) { return step.kind == StepKind::compound; };
  const auto step = std::find_if(lifted_.steps.begin(), lifted_.steps.end(), isCompound);
  if (step == lifted_.steps.end()) {
    asides_.clear();
    compound_ = {};
    compoundFrom_ = {};
    return;
  }
  const Plan before{{lifted_.steps.begin(), step}, true};
  const std::vector<double> looks_rad = detail::looksBeside(knobs_.compoundAngles, isSector(probe.kind));
  if (asides_.size() != looks_rad.size())
    asides_ = std::vector<detail::BeamPath>(looks_rad.size());  // they must not move: parts of them
                                                                // point at one another
  std::vector<BeamGrid> grids;
  for (std::size_t look = 0; look < asides_.size(); ++look) {
    asides_[look].configure(before, probe, knobs_, scene_, geometry_, spacing_mm, looks_rad[look]);
    grids.push_back(asides_[look].grid());
  }
  if (compoundFrom_.changesTo(probe, beams_.grid(), knobs_.steering_rad, knobs_.compoundAngles))
    compound_ = detail::makeCompound(probe, knobs_, beams_.grid(), grids, looks_rad);
}

void FrameMaker::Parts::compound(const FrameInput& input) {
  for (std::size_t look = 0; look < asides_.size(); ++look) {
    detail::BeamPath& beams = asides_[look];
    beams.place(input.echo.grid.worldToVoxel() * input.pose.probeToWorld);
    if (scene_.contact && input.gaps_mm.size() >= 2) beams.findContact(input.gaps_mm);
    FrameInput own = input;
    own.number += (look + 1) * 0x9e3779b97f4a7c15ULL;  // noise of its own
    for (const Step& step : plan_.steps) {
      if (step.kind == StepKind::compound) break;
      runOnBeams(step.kind, own, beams);
    }
  }
  beams_.compound(compound_, asides_, bands_);
}

void FrameMaker::Parts::makeGreyTables(bool hasStrip) {
  const auto isTable = [](const Step& step) { return step.kind == StepKind::table; };
  if (std::none_of(plan_.steps.begin(), plan_.steps.end(), isTable)) {
    beamTable_.clear();
    beamTableFrom_ = {};
    return;
  }
  const Knobs neutral;
  const bool hasGain = detail::hasPaperGain(knobs_, scene_);
  const double gain = hasGain ? knobs_.gain : neutral.gain;
  const auto& dgc = hasGain ? knobs_.dgc : neutral.dgc;
  const Tone tone = detail::toneOf(knobs_, scene_);
  if (tableFrom_.changesTo(gain, dgc, tone)) buildGainTable(gain, dgc, tone, rowPosition_, table_);
  if (!hasStrip || !beamTableFrom_.changesTo(gain, dgc, tone, beam_.size())) return;
  samplePosition_.resize(beam_.size());
  for (std::size_t s = 0; s < beam_.size(); ++s) samplePosition_[s] = static_cast<double>(s) / static_cast<double>(beam_.size() - 1);
  buildGainTable(gain, dgc, tone, samplePosition_, beamTable_);
}

ImageView<const std::uint8_t> FrameMaker::Parts::make(const FrameInput& input) {
  EW_EXPECTS(asked_.has_value());
  times_.clear();
  status_ = input.pose.status;
  if (status_ == PoseStatus::ok && !checkRigid(input.pose.probeToWorld.matrix)) status_ = PoseStatus::invalid;
  if (status_ != PoseStatus::ok) {
    blacken(*image_);
    persistence_.empty = true;
    colourMemory_ = {};
    before_ = {};
    return viewOf(std::as_const(*image_));
  }
  beams_.place(input.echo.grid.worldToVoxel() * input.pose.probeToWorld);
  const bool isLifted = scene_.contact && input.gaps_mm.size() >= 2 && beams_.findContact(input.gaps_mm);
  const Plan& plan = isLifted ? lifted_ : touching_;
  if (plan_ != plan) plan_ = plan;  // configure made room for the longer one
  const auto runAll = [&] {
    for (const Step& step : plan.steps) runTimed(step.kind, input);
  };
  // Of live echoes a frame is many steps, and each would wake the other threads anew.
  formsEchoes(scene_) ? bands_.together(runAll) : runAll();
  if (hasColour_ || hasSpectrum_) before_ = detail::frameBeforeOf(input);
  return viewOf(std::as_const(*image_));
}

void FrameMaker::Parts::runTimed(StepKind kind, const FrameInput& input) {
  const auto start = Clock::now();
  run(kind, input);
  times_.push_back({kind, since_us(start)});
  if (kind != StepKind::zoomStretch) return;
  // The stretch is interleaved with the sampling, which told its share.
  StepTime& sampling = times_[times_.size() - 2];
  times_.back().measured_us = sampling.measured_us * (1.0 - zoomSamplingShare_);
  sampling.measured_us *= zoomSamplingShare_;
}

void FrameMaker::Parts::run(StepKind kind, const FrameInput& input) {
  switch (kind) {
    case StepKind::sampleWeave:
    case StepKind::sampleLinear:
    case StepKind::sampleCubic:
      return plan_.onBeams ? runOnBeams(kind, input, beams_) : sampleDisplay(input.echo, input.pose);
    case StepKind::zoomStretch:
      return;
    case StepKind::compound:
      return compound(input);
    case StepKind::mMode:
      return drawStrip(input);
    case StepKind::scanConversion:
      return beams_.convert(bands_, viewOf(sampled_));
    case StepKind::edges:
      return sharpen();
    case StepKind::spectrum:
      return spectrum_.run(input, beams_.motion(), before_);
    case StepKind::colour:
      colour_.form(input, beams_.motion(), before_, colourMemory_, bands_);
      return colour_.draw(viewOf(std::as_const(*image_)), colourMemory_, bands_);
    case StepKind::persistence:
      beginPersistence(image_->width, image_->height, persistence_);
      return bands_.run(image_->height, [this](int firstRow, int count, int) {
        persist(knobs_.persistence, spans_, firstRow, count, viewOf(*image_), persistence_);
      });
    case StepKind::table:
      return bands_.run(image_->height, [this](int firstRow, int count, int) {
        const auto first = static_cast<std::size_t>(firstRow), rows = static_cast<std::size_t>(count);
        applyGainTable({viewOf(*image_).row(firstRow), image_->width, count, image_->width}, std::span(spans_).subspan(first, rows),
                       std::span(table_).subspan(256 * first, 256 * rows));
      });
    case StepKind::scatterers:
    case StepKind::elevationPlanes:
    case StepKind::labels:
    case StepKind::contact:
    case StepKind::attenuation:
    case StepKind::reverberation:
    case StepKind::focusStretch:
    case StepKind::focusKernel:
    case StepKind::black:
    case StepKind::noise:
    case StepKind::envelope:
    case StepKind::ownGrain:
    case StepKind::gain:
      return runOnBeams(kind, input, beams_);
  }
}

void FrameMaker::Parts::runOnBeams(StepKind kind, const FrameInput& input, detail::BeamPath& beams) {
  switch (kind) {
    case StepKind::scatterers:
      EW_EXPECTS(input.tissue != nullptr);
      return beams.scatter(input, bands_);
    case StepKind::envelope:
      return beams.takeEnvelope(bands_);
    case StepKind::ownGrain:
      return beams.keepOwnGrain(input.echo, *input.tissue, input.tissueGrid, input.pose.probeToWorld, bands_, scratch_);
    case StepKind::sampleWeave:
    case StepKind::sampleLinear:
    case StepKind::sampleCubic:
      return beams.sample(input.echo, bands_, scratch_);
    case StepKind::elevationPlanes:
      return beams.addElevationPlanes(input.echo, bands_, scratch_);
    case StepKind::labels:
      return beams.sampleLabels(input.labels, input.labels.grid.worldToVoxel() * input.pose.probeToWorld, bands_, scratch_);
    case StepKind::contact:
      return beams.loseContact(bands_, scratch_);
    case StepKind::attenuation:
      return beams.attenuate(input, bands_, scratch_);
    case StepKind::reverberation:
      return beams.reverberate(input.labels, input.labels.grid.worldToVoxel() * input.pose.probeToWorld, bands_);
    case StepKind::focusStretch:
      return beams.focusByRows(bands_, scratch_);
    case StepKind::focusKernel:
      return beams.focusByKernels(bands_, scratch_);
    case StepKind::black:
      return beams.openBlack(bands_);
    case StepKind::noise:
      return beams.addNoise(input.number, bands_);
    case StepKind::gain:
      return beams.amplify(bands_);
    case StepKind::zoomStretch:
    case StepKind::compound:
    case StepKind::mMode:
    case StepKind::scanConversion:
    case StepKind::edges:
    case StepKind::persistence:
    case StepKind::table:
    case StepKind::spectrum:
    case StepKind::colour:
      EW_EXPECTS(false);  // of the image, not of lines
  }
}

void FrameMaker::Parts::sampleDisplay(const SliceSource& echo, const Pose& pose) {
  const Transform<frame::Voxel, frame::Image> imageToVoxel = echo.grid.worldToVoxel() * pose.probeToWorld * geometry_.imageToProbe();
  for (detail::ThreadScratch& each : scratch_) each.slicing_us = each.zoomSampling_us = 0.0;
  bands_.run(sampled_.height, [&](int firstRow, int count, int slot) {
    detail::ThreadScratch& mine = scratch_[static_cast<std::size_t>(slot)];
    const auto start = Clock::now();
    mine.slicing.zoomSampling_us = 0.0;
    sliceBand(knobs_.quality, echo, imageToVoxel, spans_, firstRow, count, viewOf(sampled_), mine.slicing);
    mine.zoomSampling_us += mine.slicing.zoomSampling_us;
    mine.slicing_us += since_us(start);
  });
  double slicing_us = 0.0, zoomSampling_us = 0.0;
  for (const detail::ThreadScratch& each : scratch_) {
    slicing_us += each.slicing_us;
    zoomSampling_us += each.zoomSampling_us;
  }
  zoomSamplingShare_ = slicing_us > 0.0 ? zoomSampling_us / slicing_us : 1.0;
}

void FrameMaker::Parts::sharpen() {
  bands_.run(sampled_.height, [this](int firstRow, int count, int) {
    enhanceEdges(knobs_.edgeEnhancement, spans_, viewOf(std::as_const(sampled_)), firstRow, count, viewOf(sharpened_));
  });
}

void FrameMaker::Parts::drawStrip(const FrameInput& input) {
  const int lastLine = static_cast<int>(beams_.grid().lines.size()) - 1;
  const int line = static_cast<int>(std::lround(0.5 * (knobs_.mLine + 1.0) * lastLine));
  if (plan_.onBeams)
    beams_.takeLine(line, beam_);
  else
    beams_.sampleLine(line, input.echo, scratch_.front(), beam_);
  for (std::size_t s = 0; s < beam_.size() && !beamTable_.empty(); ++s) beam_[s] = beamTable_[256 * s + beam_[s]];
  strip_.add(input.time_s, beam_);
}

}  // namespace ew
