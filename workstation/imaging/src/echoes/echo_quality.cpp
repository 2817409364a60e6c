#include "ew/imaging/echo_quality.h"

#include <algorithm>
#include <cmath>

#include "echo_layout.h"
#include "ew/core/contract.h"
#include "plan/planning.h"
#include "probes/fan_shape.h"

namespace ew {
namespace {

/// What is multiplied into the settings, and where they end. Chosen with `echoweave bench echoes`
/// (resources/docs/science/log/measurements.md). Scatterers a cell are no part of it: they decide the lattice, another one is another grain
/// everywhere. Nor are planes (echoPlanesOf in echo_layout.h), which are no setting.
struct Price {
  double samplesPerPulse = 1.0;
  double reach = 1.0;
};
constexpr Price kFast{2.0 / 3.0, 0.65}, kFine{4.0 / 3.0, 1.25};

double scaled(double value, double by, double lowest, double highest) { return std::clamp(value * by, lowest, highest); }

}  // namespace

LiveEchoesEffect qualityOf(const LiveEchoesEffect& asked, Quality quality) {
  if (quality == Quality::linear) return asked;
  const Price& price = quality == Quality::weave ? kFast : kFine;
  LiveEchoesEffect result = asked;
  result.samplesPerPulse = scaled(asked.samplesPerPulse, price.samplesPerPulse, 3.0, 10.0);
  result.reach = scaled(asked.reach, price.reach, 1.0, 3.0);
  return result;
}

EchoWork echoWorkOf(const Probe& probe, const Knobs& knobs, const Scene& scene, double depth_mm) {
  EW_EXPECTS(scene.liveEchoes.has_value() && depth_mm > 0.0);
  const Knobs asked = limited(knobs);
  const Scene known = detail::knownScene(limited(scene), {.tissue = true}, asked);
  return detail::knownEchoWork(probe, detail::knownKnobs(asked, probe, known, {.tissue = true}), known, depth_mm);
}

namespace detail {

EchoWork knownEchoWork(const Probe& probe, const Knobs& knobs, const Scene& scene, double depth_mm) {
  const EchoBeams beams = echoBeamsOf(probe, withCarrierOf(probe, knobs), scene, depth_mm);
  const FanShape fan = fanShapeOf(probe, knobs);
  const double pitch_mm = echoPitch_mm(beams, depth_mm, scene.liveEchoes->scatterersPerCell);
  EchoWork work;
  work.lines = probe.lines;
  work.looks = beams.looks;
  work.samples = static_cast<int>(std::lround(depth_mm / liveSpacing_mm(probe, knobs, scene, depth_mm))) + 1;
  constexpr int kSteps = 64;
  double volume_mm3 = 0.0;
  for (int n = 0; n < kSteps; ++n) {
    const double at_mm = depth_mm * (n + 0.5) / kSteps;
    const FanShape::Line first = fan.lineAt(-1.0), last = fan.lineAt(1.0);
    const double wide_mm = fan.kind == FanShape::Kind::sector
                               ? 2.0 * fan.halfAngle_rad * (fan.apexToFace_mm + at_mm)
                               : glm::length(last.origin_mm + at_mm * last.direction - first.origin_mm - at_mm * first.direction);
    volume_mm3 += wide_mm * 2.0 * scene.liveEchoes->reach * beams.elevationalSigma_mm(at_mm) * depth_mm / kSteps;
  }
  work.scatterers = volume_mm3 / (pitch_mm * pitch_mm * pitch_mm);
  return work;
}

}  // namespace detail
}  // namespace ew
