#include "chance.h"

#include <cmath>

#include "ew/core/contract.h"

namespace ew {

double chanceAbove(double x, int freedoms) {
  EW_EXPECTS(freedoms > 0);
  if (!(x > 0.0)) return 1.0;
  // Q(k + 2) = Q(k) + (x / 2)^(k / 2) e^(-x / 2) / Gamma(k / 2 + 1), from Q(1) or Q(2): exact, and all terms are positive.
  int k = freedoms % 2 == 0 ? 2 : 1;
  double above = k == 2 ? std::exp(-0.5 * x) : std::erfc(std::sqrt(0.5 * x));
  for (; k < freedoms; k += 2) above += std::exp(0.5 * k * std::log(0.5 * x) - 0.5 * x - std::lgamma(0.5 * k + 1.0));
  return above;
}

}  // namespace ew
