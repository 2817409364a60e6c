#include "beam_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "ew/core/contract.h"
#include "ew/imaging/effects/contact.h"
#include "ew/imaging/effects/noise.h"
#include "planning.h"

namespace ew::detail {
namespace {

void transpose(ImageView<const std::uint8_t> linesAsRows, ImageView<std::uint8_t> out) {
  for (int s = 0; s < out.height; ++s) {
    std::uint8_t* row = out.row(s);
    for (int line = 0; line < out.width; ++line) row[line] = linesAsRows.data[line * linesAsRows.stride + s];
  }
}

}  // namespace

void BeamPath::configure(const Plan& plan, const Probe& probe, const Knobs& knobs, const Scene& scene, const DisplayGeometry& geometry,
                         double spacing_mm, double look_rad) {
  const auto has = [&](StepKind kind) {
    return std::any_of(plan.steps.begin(), plan.steps.end(), [kind](const Step& step) { return step.kind == kind; });
  };
  if (!plan.onBeams && !has(StepKind::mMode)) return;
  probe_ = probe;
  knobs_ = withCarrierOf(probe, knobs);
  scene_ = scene;
  greyPerDb_ = 255.0 / scene.recordedDynamicRange_db;
  if (gridFrom_.changesTo(probe, knobs.steering_rad, knobs.trapezoid, geometry.depth_mm, spacing_mm, look_rad))
    grid_ = makeBeamGrid(probe, knobs, geometry.depth_mm, spacing_mm, look_rad);
  const int lineCount = static_cast<int>(grid_.lines.size());
  if (!plan.onBeams) return;
  if (linesAsRows_.width != grid_.samples || linesAsRows_.height != lineCount) linesAsRows_ = GreyImage(grid_.samples, lineCount);
  if (echoes_.width != lineCount || echoes_.height != grid_.samples) echoes_ = BeamImage(lineCount, grid_.samples);
  contact_.resize(grid_.lines.size());

  if (has(StepKind::scanConversion) && conversionFrom_.changesTo(grid_, geometry))
    conversion_ = makeScanConversion(probe, knobs, grid_, geometry);
  if (!has(StepKind::elevationPlanes)) {
    planes_.clear();
    planesFrom_ = {};
  } else if (planesFrom_.changesTo(grid_, *scene.sliceThickness, knobs_.carrier_hz, knobs.elevationPlanes)) {
    planes_ = makeElevationPlanes(probe, knobs_.carrier_hz, *scene.sliceThickness, grid_, knobs.elevationPlanes);
  }
  if (has(StepKind::focusKernel) || has(StepKind::focusStretch)) {
    const BeamModel model = beamModelOf(probe, knobs_, *scene.focus, geometry.depth_mm);
    if (has(StepKind::focusKernel)) {
      if (kernelsFrom_.changesTo(grid_, model)) kernels_ = makeLateralKernels(model, grid_);
    } else if (samplesOfRowFrom_.changesTo(grid_, model)) {
      rowResolutions(model, grid_, samplesOfRow_);
    }
  }
  if (has(StepKind::noise) && noiseFrom_.changesTo(grid_, *scene.noise, knobs_.carrier_hz, scene.recordedDynamicRange_db))
    noise_ = noiseLevels(*scene.noise, knobs_.carrier_hz, scene.recordedDynamicRange_db, grid_);
  isLive_ = has(StepKind::scatterers);
  if (isLive_) {
    const EchoBeams beams = echoBeamsOf(probe, knobs_, scene, geometry.depth_mm);
    if (liveFrom_.changesTo(probe, beams, scene, grid_, knobs.steering_rad, knobs.trapezoid, look_rad, echoPlanesOf(knobs.quality)))
      live_.configure(probe, knobs_, scene, beams, grid_, look_rad);
  }
  if (has(StepKind::ownGrain)) {
    ownGrain_ = ownGrainOf(*scene.liveEchoes, scene.recordedDynamicRange_db);
    if (own_.width != grid_.samples || own_.height != lineCount) own_ = GreyImage(grid_.samples, lineCount);
  }
  gainSetting_ = beamGainOf(knobs, scene);
  if (has(StepKind::gain) && gainFrom_.changesTo(grid_, gainSetting_)) gain_ = makeBeamGain(gainSetting_, grid_);
  hasLabels_ = false;
  if (has(StepKind::attenuation)) losses_ = makeTissueLosses(scene, knobs_.carrier_hz, grid_.sampleSpacing_mm);
  if (has(StepKind::labels) && (labels_.width != lineCount || labels_.height != grid_.samples))
    labels_ = GreyImage(lineCount, grid_.samples);
}

ImageView<float> BeamPath::lines(int first, int count) { return {echoes_.pixels.data() + first, count, echoes_.height, echoes_.width}; }
ImageView<float> BeamPath::depths(int first, int count) {
  return {echoes_.pixels.data() + static_cast<std::ptrdiff_t>(first) * echoes_.width, echoes_.width, count, echoes_.width};
}

void BeamPath::sampleRowsOf(const SliceSource& source, Quality quality, Bands& bands, std::span<ThreadScratch> scratch) {
  // rows_ holds all lines of a piece of depth, then all of the next piece.
  const auto lineCount = static_cast<std::size_t>(echoes_.width);
  bands.run(echoes_.width, [&](int firstLine, int count, int slot) {
    for (std::size_t piece = 0; piece < firstSamples_.size(); ++piece) {
      const auto from = piece * lineCount + static_cast<std::size_t>(firstLine);
      const int first = firstSamples_[piece];
      sampleRows(quality, source, std::span(rows_).subspan(from, static_cast<std::size_t>(count)),
                 {linesAsRows_.pixels.data() + first, linesAsRows_.width - first, linesAsRows_.height, linesAsRows_.width},
                 scratch[static_cast<std::size_t>(slot)].slicing);
    }
  });
}

void BeamPath::accumulate(float weight, bool isFirst, Bands& bands) {
  bands.run(echoes_.width, [&](int firstLine, int count, int) {
    accumulatePlane({viewOf(linesAsRows_).row(firstLine), linesAsRows_.width, count, linesAsRows_.width}, weight, isFirst,
                    lines(firstLine, count));
  });
}

void BeamPath::layMiddlePlane(const Transform<frame::Voxel, frame::Probe>& probeToVoxel) {
  rowsOf(grid_, probeToVoxel, {0.0, 0.0}, rows_);
  firstSamples_.assign(1, 0);
}

/// The rows of a plane beside the middle one, each from its own first sample on, so that a short piece is laid as a short row.
void BeamPath::layPlane(const ElevationPlane& plane) {
  rowsOf(grid_, plane, probeToVoxel_, planeRows_);
  const std::size_t pieces = plane.pieces.size(), lineCount = grid_.lines.size();
  rows_.resize(planeRows_.size());
  firstSamples_.resize(pieces);
  for (std::size_t piece = 0; piece < pieces; ++piece) {
    firstSamples_[piece] = plane.pieces[piece].firstSample;
    for (std::size_t line = 0; line < lineCount; ++line) {
      SampleRow row = planeRows_[line * pieces + piece];
      row.start_voxel += static_cast<double>(row.span.begin) * row.step_voxel;
      row.span = {0, row.span.end - row.span.begin};
      rows_[piece * lineCount + line] = row;
    }
  }
}

void BeamPath::sample(const SliceSource& echo, Bands& bands, std::span<ThreadScratch> scratch) {
  layMiddlePlane(probeToVoxel_);
  sampleRowsOf(echo, knobs_.quality, bands, scratch);
  accumulate(planes_.empty() ? 1.0F : planes_.front().weight, true, bands);
}

void BeamPath::addElevationPlanes(const SliceSource& echo, Bands& bands, std::span<ThreadScratch> scratch) {
  for (std::size_t n = 1; n < planes_.size(); ++n) {
    layPlane(planes_[n]);
    sampleRowsOf(echo, knobs_.quality, bands, scratch);
    accumulate(planes_[n].weight, false, bands);
  }
}

void BeamPath::sampleLabels(const SliceSource& labels, const Transform<frame::Voxel, frame::Probe>& probeToLabel, Bands& bands,
                            std::span<ThreadScratch> scratch) {
  hasLabels_ = !labels.empty();
  if (!hasLabels_) return;
  layMiddlePlane(probeToLabel);
  // Labels are names, so the nearest one is taken, never a mean.
  sampleRowsOf(labels, Quality::weave, bands, scratch);
  bands.run(echoes_.width, [&](int firstLine, int count, int) {
    transpose({viewOf(linesAsRows_).row(firstLine), linesAsRows_.width, count, linesAsRows_.width},
              {labels_.pixels.data() + firstLine, count, labels_.height, labels_.width});
  });
}

bool BeamPath::findContact(std::span<const float> gaps_mm) {
  contactOfLines(*scene_.contact, gaps_mm, faceLength_mm(probe_), probe_.aperture_mm, contact_);
  return std::any_of(contact_.begin(), contact_.end(), [](float touch) { return touch < 1.0F; });
}

void BeamPath::loseContact(Bands& bands, std::span<ThreadScratch> scratch) {
  bands.run(echoes_.width, [&](int firstLine, int count, int slot) {
    ew::loseContact(*scene_.contact,
                    std::span<const float>(contact_).subspan(static_cast<std::size_t>(firstLine), static_cast<std::size_t>(count)),
                    greyPerDb_, grid_.sampleSpacing_mm, lines(firstLine, count), scratch[static_cast<std::size_t>(slot)].row);
  });
}

void BeamPath::scatter(const FrameInput& input, Bands& bands) {
  const Transform<frame::World, frame::World> ownToWorld = input.tissueGrid.voxelToWorld() * input.tissue->grid.worldToVoxel();
  // Tissue that a probe was pressed into when it was recorded has given way already.
  const SliceSource level(VolumeView<const std::uint8_t>{input.tissue->level.data(), input.tissueGrid});
  const bool gives = scene_.contact && !input.tissue->isRecorded;
  live_.move(scene_.motion ? input.motion : nullptr, input.body, scene_.motion ? scene_.motion->strength : 0.0,
             inverse(input.pose.probeToWorld) * ownToWorld, gives ? &level : nullptr,
             input.tissueGrid.worldToVoxel() * input.pose.probeToWorld, bands);
  live_.scatter(*input.tissue, input.tissueVersion, input.tissueGrid, input.pose.probeToWorld, bands);
  hasField_ = true;
}

void BeamPath::takeEnvelope(Bands& bands) {
  live_.takeEnvelope(greyPerDb_, bands, viewOf(echoes_));
  hasField_ = false;
}

void BeamPath::keepOwnGrain(const SliceSource& echo, const TissueMaps& maps, const Grid& placed,
                            const Transform<frame::World, frame::Probe>& probeToWorld, Bands& bands, std::span<ThreadScratch> scratch) {
  layMiddlePlane(probeToVoxel_);
  sampleRowsOf(echo, knobs_.quality, bands, scratch);
  std::swap(own_, linesAsRows_);
  const SliceSource level(VolumeView<const std::uint8_t>{maps.level.data(), placed});
  layMiddlePlane(placed.worldToVoxel() * probeToWorld);
  sampleRowsOf(level, knobs_.quality, bands, scratch);
  bands.run(echoes_.width, [&](int firstLine, int count, int) {
    blendOwnGrain(ownGrain_, {viewOf(std::as_const(own_)).row(firstLine), own_.width, count, own_.width},
                  {viewOf(std::as_const(linesAsRows_)).row(firstLine), own_.width, count, own_.width}, lines(firstLine, count));
  });
}

void BeamPath::attenuate(const FrameInput& input, Bands& bands, std::span<ThreadScratch> scratch) {
  if (hasField_) {
    const auto& probeToWorld = input.pose.probeToWorld;
    const SliceSource level(VolumeView<const std::uint8_t>{input.tissue->level.data(), input.tissueGrid});
    return live_.lose(input.labels, input.labels.grid.worldToVoxel() * probeToWorld, level, input.tissueGrid.worldToVoxel() * probeToWorld,
                      bands);
  }
  bands.run(echoes_.width, [&](int firstLine, int count, int slot) {
    ImageView<const std::uint8_t> tissue;
    if (hasLabels_) tissue = {labels_.pixels.data() + firstLine, count, labels_.height, labels_.width};
    ew::attenuate(*scene_.attenuation, losses_, tissue, greyPerDb_, knobs_.carrier_hz, grid_.sampleSpacing_mm, lines(firstLine, count),
                  scratch[static_cast<std::size_t>(slot)].row);
  });
}

void BeamPath::reverberate(const SliceSource& labels, const Transform<frame::Voxel, frame::Probe>& probeToLabel, Bands& bands) {
  if (hasField_) return live_.reverberate(labels, probeToLabel, bands);
  const int firstSample = static_cast<int>(std::ceil(probe_.nearField_mm / grid_.sampleSpacing_mm));
  ew::reverberate(*scene_.reverberation, greyPerDb_, firstSample, viewOf(echoes_), reverberation_);
}

void BeamPath::focusByRows(Bands& bands, std::span<ThreadScratch> scratch) {
  bands.run(echoes_.height, [&](int firstRow, int count, int slot) {
    stretchRows(samplesOfRow_, firstRow, depths(firstRow, count), scratch[static_cast<std::size_t>(slot)].row);
  });
}

void BeamPath::focusByKernels(Bands& bands, std::span<ThreadScratch> scratch) {
  bands.run(echoes_.height, [&](int firstRow, int count, int slot) {
    blurLaterally(kernels_, firstRow, depths(firstRow, count), scratch[static_cast<std::size_t>(slot)].row);
  });
}

void BeamPath::openBlack(Bands& bands) {
  bands.run(echoes_.height, [&](int firstRow, int count, int) { ew::openBlack(gain_, firstRow, depths(firstRow, count)); });
}

void BeamPath::addNoise(std::uint64_t frameNumber, Bands& bands) {
  if (hasField_) return live_.addNoise(*scene_.noise, frameNumber, bands);
  const double lift_db = gainSetting_.largestLift_db();
  bands.run(echoes_.height, [&](int firstRow, int count, int) {
    ew::addNoise(noise_, greyPerDb_, frameNumber, firstRow, depths(firstRow, count), lift_db);
  });
}

void BeamPath::amplify(Bands& bands) {
  bands.run(echoes_.height, [&](int firstRow, int count, int) { ew::amplify(gain_, firstRow, depths(firstRow, count)); });
}

void BeamPath::compound(const CompoundTable& table, std::span<BeamPath> asides, Bands& bands) {
  std::array<BeamImage*, kMostCompoundAngles> levels{};
  EW_EXPECTS(asides.size() <= levels.size());
  for (std::size_t n = 0; n < asides.size(); ++n) levels[n] = &asides[n].echoes_;
  ew::detail::compound(table, compoundBrightens_db(static_cast<int>(asides.size()) + 1, scene_.liveEchoes->looks), greyPerDb_,
                       std::span(levels).first(asides.size()), bands, echoes_);
}

void BeamPath::convert(Bands& bands, ImageView<std::uint8_t> image) const {
  bands.run(image.height, [&](int firstRow, int count, int) { scanConvert(conversion_, viewOf(echoes_), firstRow, count, image); });
}

void BeamPath::takeLine(int line, std::span<std::uint8_t> beam) const {
  const float* level = echoes_.pixels.data() + line;
  for (std::uint8_t& value : beam) {
    value = static_cast<std::uint8_t>(std::min(255.0F, std::max(0.0F, *level)) + 0.5F);
    level += echoes_.width;
  }
}

void BeamPath::sampleLine(int line, const SliceSource& echo, ThreadScratch& scratch, std::span<std::uint8_t> beam) {
  lineGrid_.lines.assign(1, grid_.lines[static_cast<std::size_t>(line)]);
  lineGrid_.samples = grid_.samples;
  lineGrid_.sampleSpacing_mm = grid_.sampleSpacing_mm;
  rowsOf(lineGrid_, probeToVoxel_, {0.0, 0.0}, lineRow_);
  sampleRows(knobs_.quality, echo, lineRow_, {beam.data(), static_cast<int>(beam.size()), 1, static_cast<std::ptrdiff_t>(beam.size())},
             scratch.slicing);
}

}  // namespace ew::detail
