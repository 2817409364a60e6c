#include "ew/phantom/flow.h"

#include <algorithm>
#include <cmath>

#include "patient/anatomy.h"

namespace ew {
namespace {

constexpr int kMoments = 256;        // of a beat
constexpr double kBeforePeak = 0.4;  // of a beat: there lies the end of diastole

}  // namespace

const FlowField& flowOf(const Patient& patient) { return patient.flow.field; }

const std::vector<TrueStenosis>& stenosesOf(const Patient& patient) { return patient.flow.stenoses; }

double TrueWaveform::resistiveIndex() const {
  return peakSystolic_mmPerS != 0.0 ? (peakSystolic_mmPerS - endDiastolic_mmPerS) / peakSystolic_mmPerS : 0.0;
}

std::optional<double> TrueWaveform::pulsatilityIndex() const {
  if (!(std::abs(timeAverageMax_mmPerS) > 0.05 * std::abs(peakSystolic_mmPerS))) return std::nullopt;
  const bool reverses = peakSystolic_mmPerS * least_mmPerS < 0.0;
  return (peakSystolic_mmPerS - (reverses ? least_mmPerS : endDiastolic_mmPerS)) / timeAverageMax_mmPerS;
}

std::optional<TrueWaveform> waveformNear(const FlowTruth& truth, int stream, const glm::dvec3& p_mm) {
  FlowField even = truth.field();
  even.rhythms.breathing.reset();
  if (even.rhythms.pulse) even.rhythms.pulse->variation = 0.0;
  const double period_s = even.rhythms.pulse ? even.rhythms.pulse->period_s : 1.0;
  const FlowTruth beat(std::move(even));
  const auto place = beat.sectionNear(stream, p_mm, 0.0);
  if (!place) return std::nullopt;
  TrueWaveform found{.stream = stream, .at_mm = place->middle_mm, .radius_mm = place->radius_mm};
  std::vector<double> greatest_mmPerS;
  for (int n = 0; n < kMoments; ++n) {
    const FlowSection now = *beat.sectionNear(stream, p_mm, period_s * n / kMoments);
    greatest_mmPerS.push_back(now.greatest_mmPerS());
    found.flow_mm3PerS += now.flow_mm3PerS / kMoments;
    found.timeAverageMax_mmPerS += now.greatest_mmPerS() / kMoments;
    found.timeAverageMean_mmPerS += now.mean_mmPerS / kMoments;
  }
  const auto peak =
      std::max_element(greatest_mmPerS.begin(), greatest_mmPerS.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  found.peakSystolic_mmPerS = *peak;
  const double sign = *peak < 0.0 ? -1.0 : 1.0;
  double least = *peak;
  const auto at = static_cast<int>(peak - greatest_mmPerS.begin());
  for (int n = 1; n < static_cast<int>(kBeforePeak * kMoments); ++n) {
    const double before = greatest_mmPerS[static_cast<std::size_t>((at - n + kMoments) % kMoments)];
    if (sign * before < sign * least) least = before;
  }
  found.endDiastolic_mmPerS = least;
  found.least_mmPerS =
      *std::min_element(greatest_mmPerS.begin(), greatest_mmPerS.end(), [&](double a, double b) { return sign * a < sign * b; });
  return found;
}

}  // namespace ew
