#include "ew/tracking/pose_filter.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>

#include "ew/core/contract.h"
#include "pose_filter_parts.h"

namespace ew {

namespace {

using tracking::KalmanPose;
using tracking::OneEuroPose;
using tracking::PlaceAndTurn;
using tracking::placeOf;
using tracking::ReadingNoise;
using tracking::transformOf;

constexpr double kHistory_s = 0.5;
constexpr std::size_t kMostHistory = 1024;
/// A hand may turn back within that: a tracker slower than 20 Hz is not predicted by its whole period.
constexpr double kFurthest_s = 0.05;
/// Before the noise is known: that of an ordinary optical tracker.
constexpr double kUsualNoise_mm = 0.3, kUsualNoise_rad = 0.004;
/// A filter that believes its readings entirely divides by nothing and trusts a bad one for ever.
constexpr double kLeastNoise_mm = 0.005, kLeastNoise_rad = 5e-5;
/// Below this noise an image of half a millimetre a pixel does not show any jitter, so that nothing is worth any delay.
constexpr double kUnseen_mm = 0.05, kUnseen_rad = 0.0009;

bool isFinite(const PlaceAndTurn& p) {
  return std::isfinite(p.place_mm.x + p.place_mm.y + p.place_mm.z) && std::isfinite(p.turn.x + p.turn.y + p.turn.z + p.turn.w);
}

}  // namespace

struct PoseFilter::State {
  PoseFilterOptions options;
  ReadingNoise noise;
  KalmanPose kalman;
  OneEuroPose euro;
  FilterKind chosen = FilterKind::kalman;
  struct Filtered {
    double time_s;
    PlaceAndTurn pose;
  };
  std::deque<Filtered> history;
  std::optional<Filtered> held;
  int sinceBegin = 0;
  double spreadUsual_mm = 0.0;
  std::uint64_t outliers = 0, beginnings = 0;

  [[nodiscard]] FilterKind used() const { return options.kind == FilterKind::automatic ? chosen : options.kind; }
  [[nodiscard]] double noise_mm() const { return noise.isKnown() ? std::max(noise.noise_mm(), kLeastNoise_mm) : kUsualNoise_mm; }
  [[nodiscard]] double noise_rad() const { return noise.isKnown() ? std::max(noise.noise_rad(), kLeastNoise_rad) : kUsualNoise_rad; }

  void begin(double time_s, const PlaceAndTurn& reading) {
    kalman.begin(reading, noise_mm(), noise_rad());
    euro.begin(reading);
    history.clear();
    history.push_back({time_s, reading});
    held.reset();
    sinceBegin = 0;
    ++beginnings;
  }

  /// How much worse than usual a reading is, as the tracker judges it.
  double worseBy(double spread_mm) {
    if (!(spread_mm > 0.0) || !std::isfinite(spread_mm)) return 1.0;
    if (spreadUsual_mm <= 0.0) spreadUsual_mm = spread_mm;
    const double worse = std::clamp(spread_mm / spreadUsual_mm, 0.5, 4.0);
    spreadUsual_mm += 0.05 * (spread_mm - spreadUsual_mm);
    return worse;
  }

  void keep(double time_s, const PlaceAndTurn& reading) {
    const FilterKind kind = used();
    const PlaceAndTurn& pose = kind == FilterKind::kalman ? kalman.now() : kind == FilterKind::oneEuro ? euro.now() : reading;
    if (!history.empty() && history.back().time_s == time_s) history.pop_back();
    history.push_back({time_s, pose});
    while (history.size() > 1 && (history.size() > kMostHistory || time_s - history.front().time_s > kHistory_s)) history.pop_front();
  }

  /// Simulated paths say: Kalman leaves less than One Euro wherever something has to be left out; a limit that is crossed by a quarter
  /// only keeps the choice from changing with every measurement.
  void choose() {
    if (!noise.isKnown()) return;
    const double seen = std::max(noise.noise_mm() / kUnseen_mm, noise.noise_rad() / kUnseen_rad);
    if (seen < 0.8) chosen = FilterKind::none;
    if (seen > 1.25) chosen = FilterKind::kalman;
  }
};

PoseFilter::PoseFilter(const PoseFilterOptions& options) : state_(std::make_unique<State>()) { state_->options = options; }
PoseFilter::PoseFilter(const PoseFilter& other) : state_(std::make_unique<State>(*other.state_)) {}
PoseFilter& PoseFilter::operator=(const PoseFilter& other) {
  if (this != &other) *state_ = *other.state_;
  return *this;
}
PoseFilter::~PoseFilter() = default;

PoseFilter::Taken PoseFilter::add(double time_s, const Transform<frame::Tracker, frame::Probe>& reading, double spread_mm) {
  State& s = *state_;
  const PlaceAndTurn pose = placeOf(reading);
  if (!std::isfinite(time_s) || !isFinite(pose)) return Taken::refused;
  if (empty()) {
    s.noise.gap();
    s.noise.add(time_s, pose);
    s.begin(time_s, pose);
    return Taken::used;
  }
  const double dt_s = time_s - latest_s();
  if (dt_s < 0.0) return Taken::refused;
  if (dt_s > std::max(s.options.longestGap_s, 4.0 * s.noise.period_s())) {
    s.noise.gap();
    s.noise.add(time_s, pose);
    s.begin(time_s, pose);
    return Taken::used;
  }
  const double worse = s.worseBy(spread_mm);
  const double noise_mm = worse * s.noise_mm(), noise_rad = worse * s.noise_rad();
  KalmanPose ahead = s.kalman;
  ahead.predict(dt_s);
  if (!ahead.accepts(pose, noise_mm, noise_rad, dt_s)) {
    // The tool was seen elsewhere, or the reading is a false one: the next decides.
    if (s.held) {
      s.noise.gap();
      s.noise.add(time_s, pose);
      s.begin(time_s, pose);
      return Taken::used;
    }
    s.held = State::Filtered{time_s, pose};
    return Taken::heldBack;
  }
  if (s.held) {
    ++s.outliers;
    s.held.reset();
  }
  s.noise.add(time_s, pose);
  s.kalman = ahead;
  s.kalman.update(pose, noise_mm, noise_rad, dt_s);
  s.euro.update(pose, dt_s);
  s.choose();
  s.keep(time_s, pose);
  ++s.sinceBegin;
  return Taken::used;
}

bool PoseFilter::empty() const { return state_->history.empty(); }

double PoseFilter::latest_s() const {
  EW_EXPECTS(!empty());
  return state_->history.back().time_s;
}

double PoseFilter::ahead_s(double time_s) const {
  const State& s = *state_;
  // A speed of two readings is one of noise.
  if (empty() || !s.options.predict || s.sinceBegin < 3) return 0.0;
  return std::clamp(time_s - latest_s(), 0.0, std::min(s.noise.period_s(), kFurthest_s));
}

Transform<frame::Tracker, frame::Probe> PoseFilter::at(double time_s) const {
  EW_EXPECTS(!empty());
  const State& s = *state_;
  const auto& history = s.history;
  if (!(time_s < history.back().time_s)) {
    const double ahead = ahead_s(time_s);
    if (ahead <= 0.0) return transformOf<frame::Probe>(history.back().pose);
    return transformOf<frame::Probe>(
        tracking::carriedOn(history.back().pose, s.kalman.trustedSpeed_mmPerS(), s.kalman.trustedTurning_radPerS(), ahead));
  }
  const auto after =
      std::upper_bound(history.begin(), history.end(), time_s, [](double t, const State::Filtered& each) { return t < each.time_s; });
  if (after == history.begin()) return transformOf<frame::Probe>(history.front().pose);
  const State::Filtered& before = *(after - 1);
  return transformOf<frame::Probe>(tracking::between(before.pose, after->pose, (time_s - before.time_s) / (after->time_s - before.time_s)));
}

PoseFilterReport PoseFilter::report() const {
  const State& s = *state_;
  PoseFilterReport report;
  report.used = s.used();
  report.period_s = s.noise.period_s();
  report.noise_mm = s.noise.noise_mm();
  report.noise_rad = s.noise.noise_rad();
  report.outliers = s.outliers;
  report.beginnings = s.beginnings;
  report.left_mm = report.noise_mm;
  report.left_rad = report.noise_rad;
  if (report.used == FilterKind::kalman && !empty() && s.noise.isKnown()) {
    report.left_mm = std::min(s.kalman.left_mm(), report.noise_mm);
    report.left_rad = std::min(s.kalman.left_rad(), report.noise_rad);
  }
  if (report.used == FilterKind::oneEuro && !empty()) {
    report.left_mm *= s.euro.leftOfPlace();
    report.left_rad *= s.euro.leftOfTurn();
    report.delay_s = s.euro.delay_s();
  }
  return report;
}

void PoseFilter::reset() {
  state_->history.clear();
  state_->held.reset();
  state_->noise.gap();
  state_->sinceBegin = 0;
}

void PoseFilter::setOptions(const PoseFilterOptions& options) { state_->options = options; }

}  // namespace ew
