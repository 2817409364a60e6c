#include "sentences.h"

#include <cmath>
#include <cstdio>

namespace ew::registration {

std::string withDigits(double value, int digits) {
  if (!std::isfinite(value)) return "any amount";
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}
std::string millimetres(double mm) { return std::isfinite(mm) ? withDigits(mm, 1) + " mm" : "any distance"; }
std::string percent(double share) { return withDigits(100.0 * share, 0) + " %"; }

std::string agreementFigures(const Evidence& evidence) {
  return "correlation " + withDigits(evidence.agreement.correlation, 2) + " over " + percent(evidence.agreement.overlapShare) +
         " overlap, " + withDigits(evidence.significance, 1) + " deviations above chance";
}

double mostSignificance(const Evidence& evidence) { return std::atanh(0.7) * std::sqrt(evidence.samples); }

std::string onlyStreaks(const WithoutStreaks& fare, double sure) {
  const std::string why = "What agrees are mostly streaks, such as shadows along the beam, which turn with the probe: ";
  if (fare.evidence.significance < sure) {
    return why + "without them the volumes agree hardly better than unrelated tissue does (" + agreementFigures(fare.evidence) + ").";
  }
  return why + "without them the pose lies " + millimetres(fare.moved.shift_mm) + " and " + withDigits(fare.moved.turn_deg, 1) +
         " degrees elsewhere. A tracker, landmarks or the direction of the beams can decide.";
}

std::string withoutStreaks(const PoseDifference& moved) {
  return "Shadows and other streaks were taken out, which drew the volumes " + millimetres(moved.shift_mm) + " and " +
         withDigits(moved.turn_deg, 1) + " degrees elsewhere. ";
}

}  // namespace ew::registration
