#include <algorithm>
#include <cmath>
#include <iterator>
#include <ostream>

#include "echoes/echo_layout.h"
#include "ew/core/contract.h"
#include "ew/core/translatable.h"
#include "ew/imaging/colour_doppler.h"
#include "ew/imaging/effects/noise.h"
#include "ew/imaging/frame.h"
#include "ew/imaging/resolved.h"
#include "planning.h"

namespace ew {
namespace {

/// A step's names, and what it costs: so much for each pixel inside the fan, so much for each sample of the beam grid.
struct StepInfo {
  StepKind kind;
  const char* name;
  const char* label;
  double pixel_ns = 0.0;
  double sample_ns = 0.0;
};

// Costs are what lastTimes() gave in a release build on one thread: convex probe of 192 lines, 160 mm deep, 1024 x 768 pixels, voxels of
// 0.8 mm (2026-11-20, AMD EPYC of 2023; the tenth percentile of 150 frames, because the machine was not idle). They say what a step is
// worth next to the others, not what it takes on another machine. Planes beside the middle one cost what sampling does, M-mode one beam.
constexpr StepInfo kSteps[] = {
    {StepKind::scatterers, "live echoes", EW_TRANSLATE_NOOP("ew::StepKind", "live echoes"), 0.0, 8.0},
    {StepKind::sampleWeave, "weave", EW_TRANSLATE_NOOP("ew::StepKind", "sample nearest"), 1.5, 3.3},
    {StepKind::sampleLinear, "linear", EW_TRANSLATE_NOOP("ew::StepKind", "sample linear"), 3.0, 5.5},
    {StepKind::sampleCubic, "cubic", EW_TRANSLATE_NOOP("ew::StepKind", "sample cubic"), 9.3, 13.0},
    {StepKind::zoomStretch, "zoom stretch", EW_TRANSLATE_NOOP("ew::StepKind", "stretch"), 1.1, 0.0},
    {StepKind::elevationPlanes, "slice thickness", EW_TRANSLATE_NOOP("ew::StepKind", "slice thickness"), 0.0, 0.0},
    {StepKind::labels, "tissues", EW_TRANSLATE_NOOP("ew::StepKind", "tissues"), 0.0, 3.3},
    {StepKind::contact, "contact", EW_TRANSLATE_NOOP("ew::StepKind", "contact"), 0.0, 0.3},
    {StepKind::attenuation, "shadow", EW_TRANSLATE_NOOP("ew::StepKind", "shadow"), 0.0, 0.8},
    {StepKind::reverberation, "reverberation", EW_TRANSLATE_NOOP("ew::StepKind", "reverberation"), 0.0, 0.2},
    {StepKind::focusStretch, "focus (stretch)", EW_TRANSLATE_NOOP("ew::StepKind", "focus"), 0.0, 1.0},
    {StepKind::focusKernel, "focus", EW_TRANSLATE_NOOP("ew::StepKind", "focus"), 0.0, 0.4},
    {StepKind::black, "black", EW_TRANSLATE_NOOP("ew::StepKind", "black"), 0.0, 0.3},
    {StepKind::noise, "noise", EW_TRANSLATE_NOOP("ew::StepKind", "noise"), 0.0, 1.7},
    {StepKind::envelope, "envelope", EW_TRANSLATE_NOOP("ew::StepKind", "envelope"), 0.0, 4.0},
    {StepKind::compound, "compounding", EW_TRANSLATE_NOOP("ew::StepKind", "compounding"), 0.0, 2.0},
    {StepKind::ownGrain, "own grain", EW_TRANSLATE_NOOP("ew::StepKind", "own grain"), 0.0, 9.0},
    {StepKind::gain, "gain", EW_TRANSLATE_NOOP("ew::StepKind", "gain"), 0.0, 0.1},
    {StepKind::mMode, "M-mode", EW_TRANSLATE_NOOP("ew::StepKind", "M-mode"), 0.0, 0.0},
    {StepKind::scanConversion, "scan conversion", EW_TRANSLATE_NOOP("ew::StepKind", "scan conversion"), 1.2, 0.0},
    {StepKind::edges, "edges", EW_TRANSLATE_NOOP("ew::StepKind", "edges"), 0.45, 0.0},
    {StepKind::persistence, "persistence", EW_TRANSLATE_NOOP("ew::StepKind", "persistence"), 0.4, 0.0},
    {StepKind::table, "grey table", EW_TRANSLATE_NOOP("ew::StepKind", "table"), 0.06, 0.0},
    {StepKind::spectrum, "spectrum", EW_TRANSLATE_NOOP("ew::StepKind", "spectrum"), 0.0, 0.0},
    {StepKind::colour, "colour", EW_TRANSLATE_NOOP("ew::StepKind", "colour"), 0.0, 0.0},
};

// Harmonics lie this far below the echoes of what was sent, and the machine's gain lifts both (Averkiou, Roundhill & Powers 1997: 10 to
// 20 dB; the difference to the carrier's own).
constexpr double kHarmonicNoise_db = 10.0;
constexpr double kHarmonicHaze = 1.5;  // of the decibels: squared on transmission alone

// Of live echoes beside each sample's share: to place a scatterer, weigh it and add it up; the envelope costs its share for every look.
constexpr double kScatterer_ns = 15.0;

// Of a colour box: each pixel, and each sample of the packets of a hundred gates on each line.
constexpr double kColourPixel_ns = 3.0, kColourGate_ns = 8.0;
// Of a sample volume: 600 scatterers at 25 images a second.
constexpr double kSpectrum_us = 1800.0;

const StepInfo& infoOf(StepKind kind) {
  const auto found = std::find_if(std::begin(kSteps), std::end(kSteps), [&](const StepInfo& step) { return step.kind == kind; });
  EW_EXPECTS(found != std::end(kSteps));
  return *found;
}

StepKind samplingOf(Quality quality) {
  switch (quality) {
    case Quality::weave:
      return StepKind::sampleWeave;
    case Quality::linear:
      return StepKind::sampleLinear;
    case Quality::cubic:
      return StepKind::sampleCubic;
  }
  return StepKind::sampleLinear;
}

double shownDynamicRange_db(const Knobs& knobs, const Scene& scene) {
  return knobs.dynamicRange_db > 0.0 ? knobs.dynamicRange_db : scene.recordedDynamicRange_db;
}

/// Everything so far once more for each other direction, and their mean.
Step compoundingOf(const std::vector<Step>& soFar, double samples, int angles) {
  double once_us = 1e-3 * infoOf(StepKind::compound).sample_ns * samples;
  for (const Step& step : soFar) once_us += step.estimated_us;
  return {StepKind::compound, (angles - 1) * once_us};
}

/// What blood adds: a sample volume, a colour box.
void addDoppler(const Probe& probe, const Knobs& knobs, const DisplayGeometry& geometry, const detail::FrameSize& size, Plan& plan) {
  if (knobs.mode == DisplayMode::spectrum) plan.steps.push_back({StepKind::spectrum, kSpectrum_us});
  if (knobs.colour) {
    const ColourBox box = colourBoxOf(probe, knobs);
    const double share = std::clamp(0.5 * (box.right - box.left) * (box.bottom_mm - box.top_mm) / geometry.depth_mm, 0.0, 1.0);
    plan.steps.push_back(
        {StepKind::colour, 1e-3 * share * (kColourPixel_ns * size.pixels + kColourGate_ns * box.lines * box.packet * 100.0)});
  }
}

bool hasTable(const Knobs& knobs, const Scene& scene) {
  const bool gains = knobs.gain != 1.0 || std::any_of(knobs.dgc.begin(), knobs.dgc.end(), [](double factor) { return factor != 1.0; });
  return (gains && detail::hasPaperGain(knobs, scene)) || !detail::toneOf(knobs, scene).isNeutral();
}

/// Whether noise shows anywhere: it grows with depth.
/// @param lift_db how far below recorded black levels come into sight
bool isNoiseSeen(const NoiseEffect& noise, const Scene& scene, double carrier_hz, double depth_mm, double lift_db) {
  return noiseLevel_db(noise, carrier_hz, depth_mm) > -scene.recordedDynamicRange_db - kNoiseUnseen_db - lift_db;
}

}  // namespace

const char* nameOf(StepKind kind) { return infoOf(kind).name; }
const char* labelOf(StepKind kind) { return infoOf(kind).label; }

std::ostream& operator<<(std::ostream& out, const Plan& plan) {
  out << (plan.onBeams ? "beams: " : "display: ");
  const char* separator = "";
  for (const Step& step : plan.steps) {
    out << separator << nameOf(step.kind);
    separator = " + ";
  }
  return out;
}

Plan makePlan(const Probe& probe, const Knobs& knobs, const Scene& scene, const DisplayGeometry& geometry, const Grid& grid,
              const FrameParts& parts, bool hasGaps) {
  const Knobs asked = limited(knobs);
  const Scene limitedScene = detail::knownScene(limited(scene), parts, asked);
  const Knobs usable = detail::knownKnobs(asked, probe, limitedScene, parts);
  const double spacing_mm = formsEchoes(limitedScene) ? detail::liveSpacing_mm(probe, usable, limitedScene, geometry.depth_mm)
                                                      : detail::beamSpacing_mm(geometry, grid);
  return detail::planOf(probe, usable, limitedScene, geometry, grid,
                        detail::frameSizeOf(probe, geometry, spacing_mm, fanSpans(probe, usable, geometry)), parts.labels, hasGaps);
}

namespace detail {

Scene knownScene(Scene scene, const FrameParts& parts, const Knobs& knobs) {
  if (!parts.tissue) scene.liveEchoes.reset();
  if (!scene.liveEchoes) return scene;
  LiveEchoesEffect& echoes = *scene.liveEchoes;
  echoes = qualityOf(echoes, knobs.quality);
  if (!parts.recorded) echoes.ownGrain = 0.0;
  if (parts.recorded) {
    echoes.fragmentsPerCm3 = echoes.texture_db = 0.0;
    echoes.gain_db -= LiveEchoesEffect{}.gain_db - kLevelGain_db;
  }
  if (!knobs.harmonic || keepsOwnGrain(scene)) return scene;
  echoes.haze_db *= kHarmonicHaze;
  if (scene.noise) {
    scene.noise->atFace_db += kHarmonicNoise_db;
    scene.noise->largest_db += kHarmonicNoise_db;
  }
  return scene;
}

Knobs knownKnobs(Knobs knobs, const Probe& probe, const Scene& scene, const FrameParts& parts) {
  const bool knowsBlood = parts.flow && parts.tissue;
  if (!knowsBlood) knobs.colour.reset();
  if (!knowsBlood && knobs.mode == DisplayMode::spectrum) knobs.mode = DisplayMode::bMode;
  if (knobs.mode != DisplayMode::spectrum)
    knobs.spectral.reset();
  else if (!knobs.spectral)
    knobs.spectral.emplace();
  const bool isAnew = formsEchoes(scene) && !keepsOwnGrain(scene);
  if (!isAnew) knobs.harmonic = false;
  const bool fansOut = probe.kind == ProbeKind::linear && knobs.trapezoid && probe.trapezoidHalfAngle_rad > 0.0;
  const bool isArray = probe.kind == ProbeKind::linear || probe.kind == ProbeKind::convex;
  if (!isAnew || !isArray || fansOut || knobs.quality == Quality::weave) knobs.compoundAngles = 1;
  return knobs;
}

double beamSpacing_mm(const DisplayGeometry& geometry, const Grid& grid) {
  constexpr double kFewest = 200.0, kMost = 1200.0;
  const double finestVoxel_mm = std::min({grid.spacing_mm.x, grid.spacing_mm.y, grid.spacing_mm.z});
  const double wanted_mm = std::max(geometry.pixel_mm, 0.5 * finestVoxel_mm);
  return geometry.depth_mm / std::clamp(std::ceil(geometry.depth_mm / wanted_mm), kFewest, kMost);
}

double liveSpacing_mm(const Probe& probe, const Knobs& knobs, const Scene& scene, double depth_mm) {
  const double wanted_mm = echoSpacing_mm(echoBeamsOf(probe, withCarrierOf(probe, knobs), scene, depth_mm), *scene.liveEchoes);
  constexpr double kFewest = 200.0, kMost = 4000.0;
  return depth_mm / std::clamp(std::ceil(depth_mm / wanted_mm), kFewest, kMost);
}

FrameSize frameSizeOf(const Probe& probe, const DisplayGeometry& geometry, double spacing_mm, const Spans& spans) {
  FrameSize size;
  for (const auto& row : spans)
    for (const RowSpan& span : row) size.pixels += span.end - span.begin;
  size.lines = probe.lines;
  size.samples = static_cast<int>(std::lround(geometry.depth_mm / spacing_mm)) + 1;
  return size;
}

Knobs withCarrierOf(const Probe& probe, const Knobs& knobs) {
  Knobs result = knobs;
  if (!(knobs.carrier_hz > 0.0) || probe.carriers_hz.empty())
    result.carrier_hz = probe.carrier_hz;
  else
    result.carrier_hz = *std::min_element(probe.carriers_hz.begin(), probe.carriers_hz.end(), [&](double a, double b) {
      return std::abs(a - knobs.carrier_hz) < std::abs(b - knobs.carrier_hz);
    });
  return result;
}

BeamGainSetting beamGainOf(const Knobs& knobs, const Scene& scene) {
  const double recorded_db = scene.recordedDynamicRange_db;
  BeamGainSetting setting{
      .recordedDynamicRange_db = recorded_db, .dynamicRange_db = recorded_db, .middleLevel = middleLevel(formsEchoes(scene))};
  if (resolvedGainLaw(knobs, scene) != GainLaw::decibel) return setting;
  setting.dynamicRange_db = shownDynamicRange_db(knobs, scene);
  if (!scene.gainAndDgc) return setting;
  setting.gain_db = knobs.gain_db;
  setting.tgc_db = knobs.tgc_db;
  return setting;
}

Tone toneOf(const Knobs& knobs, const Scene& scene) {
  const bool isOnBeams = resolvedGainLaw(knobs, scene) == GainLaw::decibel;
  const double recorded_db = scene.recordedDynamicRange_db;
  return {recorded_db, isOnBeams ? recorded_db : shownDynamicRange_db(knobs, scene), resolvedGreyMap(knobs, scene),
          middleLevel(formsEchoes(scene))};
}

bool hasPaperGain(const Knobs& knobs, const Scene& scene) { return scene.gainAndDgc && resolvedGainLaw(knobs, scene) == GainLaw::paper; }

Plan planOf(const Probe& probe, const Knobs& knobs, const Scene& scene, const DisplayGeometry& geometry, const Grid& grid,
            const FrameSize& size, bool hasLabels, bool hasGaps) {
  const double samples = static_cast<double>(size.lines) * size.samples;
  const bool losesContact = scene.contact && hasGaps;
  const bool focuses = scene.focus && scene.focus->strength > 0.0;
  const BeamGainSetting gain = beamGainOf(knobs, scene);
  const bool hasNoise =
      scene.noise && isNoiseSeen(*scene.noise, scene, withCarrierOf(probe, knobs).carrier_hz, geometry.depth_mm, gain.largestLift_db());
  Plan plan;
  const bool live = formsEchoes(scene);
  plan.onBeams =
      live || losesContact || scene.sliceThickness || scene.attenuation || scene.reverberation || focuses || hasNoise || !gain.isNeutral();
  const auto add = [&](StepKind kind, double times = 1.0) {
    const StepInfo& cost = infoOf(kind);
    plan.steps.push_back({kind, 1e-3 * times * (cost.pixel_ns * size.pixels + cost.sample_ns * samples)});
  };
  // A sampling step is on one grid or on the other.
  const auto addSampling = [&](StepKind kind, double planes = 1.0) {
    const StepInfo& cost = infoOf(samplingOf(knobs.quality));
    plan.steps.push_back({kind, 1e-3 * planes * (plan.onBeams ? cost.sample_ns * samples : cost.pixel_ns * size.pixels)});
  };

  const bool tissuesKnown = hasLabels && !scene.tissues.empty();
  const bool tissuesDecide = scene.attenuation && tissuesKnown;
  const EchoWork work = live ? knownEchoWork(probe, knobs, scene, geometry.depth_mm) : EchoWork{};
  const auto addScatterers = [&] {
    add(StepKind::scatterers);
    plan.steps.back().estimated_us += 1e-3 * kScatterer_ns * work.scatterers;
  };
  if (live && !keepsOwnGrain(scene)) {
    addScatterers();
    if (tissuesDecide) add(StepKind::attenuation);
    if (scene.reverberation && tissuesKnown) add(StepKind::reverberation, 5.0);
    if (hasNoise) add(StepKind::noise);
    add(StepKind::envelope, work.looks);
    if (scene.attenuation && !tissuesDecide) add(StepKind::attenuation);
    if (losesContact) add(StepKind::contact);
    if (scene.reverberation && !tissuesKnown) add(StepKind::reverberation);
    if (knobs.compoundAngles > 1) plan.steps.push_back(compoundingOf(plan.steps, samples, knobs.compoundAngles));
    if (!gain.isNeutral()) add(StepKind::gain);
  } else if (plan.onBeams) {
    if (live) {
      // From here on levels are what a slice's are: whatever takes from them takes from the volume's own grain too.
      addScatterers();
      add(StepKind::envelope, work.looks);
      add(StepKind::ownGrain);
    } else {
      addSampling(samplingOf(knobs.quality));
      if (scene.sliceThickness) addSampling(StepKind::elevationPlanes, knobs.elevationPlanes - 1.0);
    }
    if (tissuesDecide) add(StepKind::labels);
    if (losesContact) add(StepKind::contact);
    if (scene.attenuation) add(StepKind::attenuation);
    if (scene.reverberation) add(StepKind::reverberation);
    if (focuses && !live) add(knobs.focusMethod == FocusMethod::rowStretch ? StepKind::focusStretch : StepKind::focusKernel);
    if (gain.largestLift_db() > 0.0) add(StepKind::black);
    if (hasNoise) add(StepKind::noise);
    if (!gain.isNeutral()) add(StepKind::gain);
  } else {
    addSampling(samplingOf(knobs.quality));
    const double largestVoxel_mm = std::max({grid.spacing_mm.x, grid.spacing_mm.y, grid.spacing_mm.z});
    if (knobs.quality == Quality::weave && geometry.pixel_mm < largestVoxel_mm) {
      const double samplesPerPixel = geometry.pixel_mm / largestVoxel_mm;
      plan.steps.back().estimated_us *= samplesPerPixel * samplesPerPixel;
      add(StepKind::zoomStretch);
    }
  }
  if (knobs.mode == DisplayMode::mMode || knobs.mode == DisplayMode::both) {
    const double beam_ns = size.samples * ((plan.onBeams ? 0.0 : infoOf(samplingOf(knobs.quality)).sample_ns) + 2.0);
    plan.steps.push_back({StepKind::mMode, 1e-3 * beam_ns});
  }
  if (plan.onBeams) add(StepKind::scanConversion);
  if (knobs.edgeEnhancement > 0.0) add(StepKind::edges);
  if (knobs.persistence > 0.0) add(StepKind::persistence);
  if (hasTable(knobs, scene)) add(StepKind::table);
  addDoppler(probe, knobs, geometry, size, plan);
  return plan;
}

}  // namespace detail
}  // namespace ew
