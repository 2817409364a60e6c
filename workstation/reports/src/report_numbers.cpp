#include "report_numbers.h"

#include <cmath>

#include "ew/assessment/judging.h"
#include "ew/reports/report_document.h"

namespace ew {
namespace reports {

std::string coordinate(double value) {
  std::string made = fixedText(value, 1);
  if (made.ends_with(".0")) made.erase(made.size() - 2);
  return made;
}

}  // namespace reports

Message percentText(double share) { return joined({fixedNumeral(100.0 * share, 0), verbatim("%")}); }

Message scoreText(double score, double passLevel) {
  if (reachesLevel(score, passLevel) || std::round(100.0 * score) < std::round(100.0 * passLevel)) return percentText(score);
  return joined({fixedNumeral(std::floor(1000.0 * score) / 10.0, 1), verbatim("%")});
}

Message figureText(double value, std::string_view unit) {
  const double size = std::abs(value);
  const bool isWhole = unit.empty() && value == std::round(value);
  Message number = fixedNumeral(value, isWhole || size >= 99.95 ? 0 : size >= 9.995 ? 1 : 2);
  if (unit.empty()) return number;
  return joined({std::move(number), verbatim(unit == "deg" ? "°" : std::string(unit))});
}

Message durationText(double seconds) {
  if (seconds < 59.95) return figureText(seconds, "s");
  const auto whole = static_cast<long long>(std::llround(seconds));
  const long long minutes = whole / 60;
  if (minutes < 60) return say<"%1 min %2 s">(minutes, whole % 60);
  return say<"%1 h %2 min">(minutes / 60, minutes % 60);
}

Message simulationSentence() { return say<"Simulation, training only: not for diagnosis.">(); }

Message validitySentence() {
  return say<
      "Scores say how near the work came to the case's own truth. Metrics are figures of one attempt in one simulation: most of them "
      "have not been shown to tell skilled people from beginners, and none of them decides alone about a person.">();
}

}  // namespace ew
