#include "ew/core/order_statistics.h"
#include "pose_filter_parts.h"

namespace ew::tracking {

namespace {

void keepNewest(std::deque<double>& values, double value, std::size_t most) {
  values.push_back(value);
  if (values.size() > most) values.pop_front();
}

}  // namespace

void ReadingNoise::add(double time_s, const PlaceAndTurn& reading) {
  if (!recent_.empty()) {
    const double interval_s = time_s - recent_.back().time_s;
    if (!(interval_s > 1e-5)) return;  // a second reading of one moment has no place among neighbours
    keepNewest(intervals_, interval_s, kMost);
  }
  recent_.push_back({time_s, reading});
  if (recent_.size() > 5) recent_.pop_front();
  // The median of the intervals is wanted at once, the noise needs all five.
  if (recent_.size() == 5) measure();
  if (++sinceMeasured_ >= 8 || intervals_.size() < kFewest) {
    sinceMeasured_ = 0;
    if (intervals_.size() >= 2) period_s_ = quantileOf(intervals_, 0.5);
    if (placeResiduals_.size() >= kFewest) {
      isKnown_ = true;
      constexpr double kQuartileOfThree = 1.21253;  // of a chi-square distribution with three degrees of freedom
      noise_mm_ = std::sqrt(quantileOf(placeResiduals_, 0.25) / kQuartileOfThree);
      noise_rad_ = std::sqrt(quantileOf(turnResiduals_, 0.25) / kQuartileOfThree);
    }
  }
}

void ReadingNoise::measure() {
  // Lagrange's weights of the cubic through the four neighbours, at the middle one's time; readings need not be even in time.
  constexpr std::array<std::size_t, 4> kNeighbours{0, 1, 3, 4};
  const double t = recent_[2].time_s;
  const glm::dquat back = glm::conjugate(recent_[2].pose.turn);
  glm::dvec3 place(recent_[2].pose.place_mm), turn(0.0);
  double variance = 1.0;
  for (const std::size_t i : kNeighbours) {
    double weight = 1.0;
    for (const std::size_t j : kNeighbours)
      if (j != i) weight *= (t - recent_[j].time_s) / (recent_[i].time_s - recent_[j].time_s);
    place -= weight * recent_[i].pose.place_mm;
    turn -= weight * logOf(back * recent_[i].pose.turn);
    variance += weight * weight;
  }
  keepNewest(placeResiduals_, glm::dot(place, place) / variance, kMost);
  keepNewest(turnResiduals_, glm::dot(turn, turn) / variance, kMost);
}

}  // namespace ew::tracking
