#include "trainee_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ew/core/contract.h"
#include "ew/core/order_statistics.h"
#include "ew/scanning/contact.h"

namespace ew::assessment {
namespace {

constexpr double kThroughAir_mm = 40.0;  // how high a hand goes that finds no way over the skin
constexpr double kGelFills_mm = 3.0;     // as contactShare has it
constexpr double kBeyondGel_mm = 0.05;   // more than gaps are rounded by

glm::dquat attitude(const Pose& pose) { return glm::normalize(glm::quat_cast(glm::dmat3(pose.probeToWorld.matrix))); }

Pose throughAir(const Hold& from, const Hold& to, double share) {
  const Pose a = poseOf(from), b = poseOf(to);
  const glm::dvec3 outward = glm::normalize(from.contact.outward + to.contact.outward + glm::dvec3(0.0, -1e-3, 0.0));
  Pose pose = a;
  const glm::dmat3 turn = glm::mat3_cast(glm::slerp(attitude(a), attitude(b), share));
  for (int column = 0; column < 3; ++column) pose.probeToWorld.matrix[column] = glm::dvec4(turn[column], 0.0);
  pose.probeToWorld.matrix[3] = glm::mix(a.probeToWorld.matrix[3], b.probeToWorld.matrix[3], share) +
                                glm::dvec4(4.0 * share * (1.0 - share) * kThroughAir_mm * outward, 0.0);
  return pose;
}

template <std::size_t... N>
std::array<BandNoise, sizeof...(N)> noises(RandomNumbers& random, double lowest_hz, double highest_hz, std::index_sequence<N...>) {
  return {((void)N, BandNoise(random, lowest_hz, highest_hz))...};
}

}  // namespace

BandNoise::BandNoise(RandomNumbers& random, double lowest_hz, double highest_hz) {
  const double step_hz = (highest_hz - lowest_hz) / kWaves;
  for (int n = 0; n < kWaves; ++n) {
    const auto wave = static_cast<std::size_t>(n);
    radPerS_[wave] = 2.0 * std::numbers::pi * (lowest_hz + step_hz * (n + random.unit()));
    phase_rad_[wave] = random.between(0.0, 2.0 * std::numbers::pi);
  }
}

double BandNoise::at(double time_s) const {
  double sum = 0.0;
  for (std::size_t n = 0; n < radPerS_.size(); ++n) sum += std::sin(radPerS_[n] * time_s + phase_rad_[n]);
  return sum * std::sqrt(2.0 / kWaves);
}

Route::Route(const Hold& from, const Hold& to, const Skin& skin) {
  add(from, to, skin, 3);
  for (const Leg& leg : legs_) {
    length_mm_ += leg.length_mm;
    if (leg.path) turn_rad_ += leg.path->turn_rad();
  }
}

void Route::add(const Hold& from, const Hold& to, const Skin& skin, int mostStops) {
  if (auto path = HandPath::between(from, to, skin)) {
    const double length_mm = path->length_mm();
    legs_.push_back({from, to, std::move(path), length_mm});
    return;
  }
  constexpr double kAround_mm = 200.0;  // so far above the straight line the nearest skin lies between both
  const glm::dvec3 outward = from.contact.outward + to.contact.outward;
  if (mostStops > 0 && glm::length(outward) > 0.1) {
    const glm::dvec3 above_mm = glm::mix(from.contact.point_mm, to.contact.point_mm, 0.5) + kAround_mm * glm::normalize(outward);
    Hold between = movedTo(from, skin.nearest(above_mm));
    add(from, between, skin, mostStops - 1);
    add(between, to, skin, mostStops - 1);
    return;
  }
  const double length_mm = glm::distance(from.contact.point_mm, to.contact.point_mm) + 2.0 * kThroughAir_mm;
  legs_.push_back({from, to, std::nullopt, length_mm});
}

Pose Route::at(double share, const Skin& skin) const {
  double wanted_mm = share * length_mm_;
  std::size_t n = 0;
  while (n + 1 < legs_.size() && wanted_mm > legs_[n].length_mm) wanted_mm -= legs_[n++].length_mm;
  const Leg& leg = legs_[n];
  const bool whole = legs_.size() == 1;  // a probe may turn without going anywhere
  const double within = whole ? share : leg.length_mm > 0.0 ? std::clamp(wanted_mm / leg.length_mm, 0.0, 1.0) : 1.0;
  return leg.path ? leg.path->at(within, skin) : throughAir(leg.from, leg.to, within);
}

void HandPlan::move(std::shared_ptr<const Route> route, const Hold& to, double seconds) {
  EW_EXPECTS(seconds > 0.0);
  parts_.push_back({end_s_, end_s_ + seconds, std::move(route), poseOf(to)});
  end_s_ += seconds;
  now_ = to;
}

void HandPlan::rest(double seconds) {
  if (seconds <= 0.0) return;
  parts_.push_back({end_s_, end_s_ + seconds, nullptr, poseOf(now_)});
  end_s_ += seconds;
}

HandNoise::HandNoise(RandomNumbers& random)
    : tremor(noises(random, 8.0, 12.0, std::make_index_sequence<5>())),
      wobble(noises(random, 0.5, 3.0, std::make_index_sequence<2>())),
      press(random, 0.02, 0.3) {}

Liftings::Liftings(double share, double begin_s, double end_s, RandomNumbers& random) {
  constexpr double kUsual_s = 0.8, kUsualRise_s = 0.4;
  const double lost_s = share * (end_s - begin_s);
  if (lost_s <= 0.0) return;
  const double count = std::max(1.0, std::round(lost_s / kUsual_s));
  each_s_ = lost_s / count;
  const double slot_s = (end_s - begin_s) / count;
  rise_s_ = std::min({kUsualRise_s, each_s_, slot_s - each_s_});  // half of it lies before, half within
  for (int n = 0; n < static_cast<int>(count); ++n) {
    const double free_s = std::max(0.0, slot_s - each_s_ - rise_s_);
    begins_s_.push_back(begin_s + n * slot_s + 0.5 * rise_s_ + free_s * random.unit());
  }
}

double Liftings::at(double time_s) const {
  for (const double begin_s : begins_s_) {
    const double up = time_s - begin_s + 0.5 * rise_s_, down = begin_s + each_s_ + 0.5 * rise_s_ - time_s;
    if (up <= 0.0 || down <= 0.0) continue;
    return 2.0 * leastJerk(std::clamp(std::min(up, down) / rise_s_, 0.0, 1.0));
  }
  return 0.0;
}

Pose Filming::disturbed(const Pose& meant, double speed_mmPerS, double time_s, const TraineeHabits& habits) const {
  std::array<double, 5> tremor{};
  if (habits.tremor_mm > 0.0 || habits.tremor_deg > 0.0)
    for (std::size_t n = 0; n < tremor.size(); ++n)
      tremor[n] = (n < 2 ? habits.tremor_mm : glm::radians(habits.tremor_deg)) * noise_.tremor[n].at(time_s);
  glm::dvec3 shift_mm(tremor[0], 0.0, tremor[1]);
  if (const double wobble_mm = habits.wobble_s * speed_mmPerS; wobble_mm > 0.0)
    shift_mm += wobble_mm * glm::dvec3(noise_.wobble[0].at(time_s), 0.0, noise_.wobble[1].at(time_s));
  if (habits.pressDrift_mm > 0.0) shift_mm.y = habits.pressDrift_mm * noise_.press.at(time_s);
  const glm::dvec3 turn_rad(tremor[2], tremor[3], tremor[4]);
  const double angle_rad = glm::length(turn_rad);
  if (angle_rad == 0.0 && shift_mm == glm::dvec3(0.0)) return meant;
  Pose pose = meant;
  glm::dmat4& matrix = pose.probeToWorld.matrix;
  matrix[3] += glm::dvec4(glm::dmat3(matrix) * shift_mm, 0.0);
  if (angle_rad > 0.0) {
    const glm::dmat3 turned = glm::mat3_cast(glm::normalize(attitude(meant) * glm::angleAxis(angle_rad, turn_rad / angle_rad)));
    for (int column = 0; column < 3; ++column) matrix[column] = glm::dvec4(turned[column], 0.0);
  }
  return pose;
}

Pose Filming::lifted(const Probe& probe, const Pose& pose, double lifting) const {
  if (lifting <= 0.0) return pose;
  auto gaps_mm = distance_.gaps_mm(probe, pose);
  const double off_mm = std::max(0.0, kGelFills_mm + kBeyondGel_mm - static_cast<double>(upperMedianOf(gaps_mm)));
  Pose up = pose;
  up.probeToWorld.matrix[3] += glm::dvec4(lifting * off_mm * skin_.nearest(glm::dvec3(pose.probeToWorld.matrix[3])).outward, 0.0);
  return up;
}

void Filming::film(const HandPlan& plan, const TraineeHabits& habits, const Liftings& liftings, double until_s, ScanState& state,
                   ScanLog& log, const std::function<bool()>& stopped) const {
  std::size_t part = 0, setting = 0;
  const auto timeOf = [&](std::uint64_t number) { return static_cast<double>(number) / rate_hz_; };
  while (timeOf(state.number) < plan.begin_s() - 1e-9) ++state.number;
  for (; timeOf(state.number) < std::min(plan.end_s(), until_s) - 1e-9; ++state.number) {
    if (stopped && stopped()) return;
    state.time_s = timeOf(state.number);
    for (; setting < plan.settings().size() && plan.settings()[setting].time_s <= state.time_s; ++setting) {
      state.probe = plan.settings()[setting].probe;
      state.knobs = plan.settings()[setting].knobs;
    }
    while (part + 1 < plan.parts().size() && plan.parts()[part].end_s <= state.time_s) ++part;
    const HandPlan::Part& now = plan.parts()[part];
    Pose meant = now.still;
    double speed_mmPerS = 0.0;
    if (now.route) {
      const double share = std::clamp((state.time_s - now.begin_s) / (now.end_s - now.begin_s), 0.0, 1.0);
      meant = now.route->at(leastJerk(share), skin_);
      speed_mmPerS = 30.0 * share * share * (1.0 - share) * (1.0 - share) * now.route->length_mm() / (now.end_s - now.begin_s);
    }
    state.pose = lifted(state.probe, disturbed(meant, speed_mmPerS, state.time_s, habits), liftings.at(state.time_s));
    state.pose.time_s = state.time_s;
    state.gaps_mm.clear();
    if (state.scene.contact) state.gaps_mm = shortened(distance_.gaps_mm(state.probe, state.pose));
    log.addFrame(state);
  }
}

}  // namespace ew::assessment
