#include "flow/womersley.h"

#include <cmath>
#include <numbers>

#include "ew/core/contract.h"
#include "ew/imaging/flow_field.h"

namespace ew {
namespace {

using Complex = std::complex<double>;

// Beyond it the series loses digits to cancellation, and eight terms of the asymptotic one are right to 1e-11.
constexpr double kSeriesEnds = 22.0;

/// J of order 0 or 1 at i^(3/2) x, times exp(-x / sqrt 2) so that it does not overflow; x >= kSeriesEnds.
/// Source: Abramowitz and Stegun 9.2.8 and 9.2.10: there J is half of H2, for H1 is smaller by exp(-sqrt 2 x).
Complex scaledBessel(int order, double x) {
  const Complex z = std::polar(x, 0.75 * std::numbers::pi);
  Complex term(1.0, 0.0), sum = term;
  const double mu = 4.0 * order * order;
  for (int k = 1; k <= 8; ++k) {
    const double odd = 2.0 * k - 1.0;
    term *= Complex(0.0, -1.0) * (mu - odd * odd) / (8.0 * k * z);
    sum += term;
  }
  const double turn_rad = x / std::numbers::sqrt2 + std::numbers::pi * (0.5 * order + 0.25);  // -i z = (1 + i) x / sqrt 2
  return 0.5 * std::sqrt(2.0 / (std::numbers::pi * z)) * sum * std::polar(1.0, turn_rad);
}

/// Numerators and denominator divided by t = i alpha^2 / 4, so that alpha = 0 is no special case:
/// J0(i^(3/2) a) = sum over k of t^k / k!^2.
detail::WomersleyValue bySeries(double alpha, double y) {
  const Complex t(0.0, 0.25 * alpha * alpha);
  Complex term(1.0, 0.0), profile(0.0), within(0.0), whole(0.0);
  double power = y * y;  // y^(2k)
  for (int k = 1; k < 200; ++k) {
    profile += term * (1.0 - power);
    within += term * (y * y - power * y * y / (k + 1.0));
    whole += term * (k / (k + 1.0));
    if (std::abs(term) < 1e-17 * std::abs(whole)) break;
    term *= t / ((k + 1.0) * (k + 1.0));
    power *= y * y;
  }
  return {profile / whole, within / whole};
}

detail::WomersleyValue byAsymptotes(double alpha, double y) {
  const Complex z = std::polar(alpha, 0.75 * std::numbers::pi);
  const Complex whole0 = scaledBessel(0, alpha), whole1 = scaledBessel(1, alpha);
  Complex at0, at1;  // at y, on the scale of the wall
  const double x = alpha * y;
  if (x >= kSeriesEnds) {
    const double fall = std::exp((x - alpha) / std::numbers::sqrt2);
    at0 = fall * scaledBessel(0, x);
    at1 = fall * scaledBessel(1, x);
  } else {
    const Complex t(0.0, 0.25 * x * x);
    Complex term(1.0, 0.0), sum0(0.0), sum1(0.0);
    for (int k = 0; k < 200; ++k) {
      sum0 += term;
      sum1 += term / (k + 1.0);
      if (std::abs(term) < 1e-17 * std::abs(sum0)) break;
      term *= t / ((k + 1.0) * (k + 1.0));
    }
    const double fall = std::exp(-alpha / std::numbers::sqrt2);
    at0 = fall * sum0;
    at1 = fall * 0.5 * z * y * sum1;
  }
  const Complex below = whole0 - 2.0 * whole1 / z;
  return {(whole0 - at0) / below, (y * y * whole0 - 2.0 * y * at1 / z) / below};
}

}  // namespace

detail::WomersleyValue detail::womersleyAt(double alpha, double y) {
  EW_EXPECTS(alpha >= 0.0 && y >= 0.0 && y <= 1.0);
  return alpha < kSeriesEnds ? bySeries(alpha, y) : byAsymptotes(alpha, y);
}

std::complex<double> womersleyProfile(double alpha, double y) { return detail::womersleyAt(alpha, y).profile; }

double womersleyNumber(double radius_mm, double frequency_hz, double density_kgPerM3, double viscosity_mPaS) {
  return 1e-3 * radius_mm * std::sqrt(2.0 * std::numbers::pi * frequency_hz * density_kgPerM3 / (1e-3 * viscosity_mPaS));
}

}  // namespace ew
