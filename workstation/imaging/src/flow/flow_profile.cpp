#include "flow/flow_profile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "flow/womersley.h"

namespace ew::detail {
namespace {

/// Gauss's eight points on 0..1.
constexpr std::array<double, 4> kGaussPlace{0.18343464249564980, 0.52553240991632899, 0.79666647741362674, 0.96028985649753623};
constexpr std::array<double, 4> kGaussWeight{0.36268378337836198, 0.31370664587788729, 0.22238103445337447, 0.10122853629037626};
constexpr int kPieces = 6;  // of eight points each: the edge of a jet of a tenth of the lumen is met to 1e-6

template <class Function>
double integral(double to, const Function& f) {
  double sum = 0.0;
  const double half = 0.5 * to / kPieces;
  for (int piece = 0; piece < kPieces; ++piece) {
    const double middle = (2.0 * piece + 1.0) * half;
    for (std::size_t n = 0; n < kGaussPlace.size(); ++n)
      sum += kGaussWeight[n] * (f(middle - half * kGaussPlace[n]) + f(middle + half * kGaussPlace[n]));
  }
  return half * sum;
}

constexpr double kNarrowestJet = 0.05;

double inJet(double y, double radius) {
  const double q = y / radius;
  return std::exp(-q * q * q * q);
}
double slowedByWall(double y) {
  const double y2 = y * y, y4 = y2 * y2;
  return 1.0 - y4 * y4;
}

}  // namespace

WaveProfile::WaveProfile(const FlowStream& stream, double alpha, double phase)
    : bluntness_(std::max(stream.bluntness, 1.0)), steady_(stream.wave.mean), flow_(stream.wave.mean), alpha_(alpha) {
  for (std::size_t n = 0; n < stream.wave.harmonics.size(); ++n) {
    const double turn_rad = 2.0 * std::numbers::pi * phase * static_cast<double>(n + 1);
    harmonics_.push_back(stream.wave.harmonics[n] * std::polar(1.0, turn_rad));
    flow_ += harmonics_.back().real();
  }
}

ProfileValue WaveProfile::at(double y) const {
  const double power = std::pow(y, bluntness_), most = (bluntness_ + 2.0) / bluntness_;
  ProfileValue at{steady_ * most * (1.0 - power), steady_ * y * y * most * (1.0 - 2.0 * power / (bluntness_ + 2.0))};
  for (std::size_t n = 0; n < harmonics_.size(); ++n) {
    const WomersleyValue shape = womersleyAt(alpha_ * std::sqrt(static_cast<double>(n + 1)), y);
    at.velocity += (harmonics_[n] * shape.profile).real();
    at.within += (harmonics_[n] * shape.within).real();
  }
  return at;
}

JetProfile::JetProfile(double radius, double backflow) : radius_(std::clamp(radius, kNarrowestJet, 1.0)) {
  const double jet = 2.0 * integral(1.0, [&](double y) { return y * inJet(y, radius_) * slowedByWall(y); });
  const double ring = 2.0 * integral(1.0, [&](double y) { return y * y * y * (1.0 - inJet(y, radius_)) * slowedByWall(y); });
  const double share = std::clamp(backflow, 0.0, 1.0);
  forward_ = (1.0 + share) / jet;
  back_ = share / ring;
}

double JetProfile::share(double radius) {
  const double t = std::clamp((1.0 - radius) / 0.05, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

double JetProfile::raw(double y) const {
  const double jet = inJet(y, radius_);
  return (forward_ * jet - back_ * y * y * (1.0 - jet)) * slowedByWall(y);
}

ProfileValue JetProfile::at(double y) const {
  return {raw(y), 2.0 * integral(y, [this](double at) { return at * raw(at); })};
}

}  // namespace ew::detail
