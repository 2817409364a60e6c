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

}  // namespace ew::registration
