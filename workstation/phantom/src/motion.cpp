#include "ew/phantom/motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "anatomy.h"

namespace ew {
namespace {

using phantom::PulsingVessel;
using phantom::Rhythm;

constexpr double kExact_mm = 1e-4;  // of the inverses, well within what a Deformation promises

/// A number -0.5..0.5 that looks random but is the same for the same cycle.
double unevenness(long long cycle) {
  auto z = static_cast<std::uint64_t>(cycle) + 0x9e3779b97f4a7c15ull;  // the finaliser of splitmix64
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
  z ^= z >> 31;
  return static_cast<double>(z >> 11) * 0x1p-53 - 0.5;
}

double beginningOf_s(const Rhythm& rhythm, long long cycle) {
  return rhythm.period_s * (static_cast<double>(cycle) + rhythm.variation * unevenness(cycle));
}

struct Cycle {
  double since_s = 0.0;     ///< its beginning
  double duration_s = 1.0;  ///< to the beginning of the next
};

Cycle cycleAt(const Rhythm& rhythm, double time_s) {
  if (!(std::abs(time_s) < 1e9)) return {};
  auto cycle = static_cast<long long>(std::floor(time_s / rhythm.period_s));
  if (beginningOf_s(rhythm, cycle) > time_s) --cycle;
  if (beginningOf_s(rhythm, cycle + 1) <= time_s) ++cycle;
  const double begin = beginningOf_s(rhythm, cycle);
  return {time_s - begin, beginningOf_s(rhythm, cycle + 1) - begin};
}

double risen(double t) { return 0.5 - 0.5 * std::cos(std::numbers::pi * std::clamp(t, 0.0, 1.0)); }

/// In and out like sin^2 (Lujan et al., Med. Phys. 26(5), 1999, n = 1, turned upside down), then the pause.
double breathAt(const phantom::Breathing& breathing, double time_s) {
  const Cycle cycle = cycleAt(breathing.rhythm, time_s);
  const double moving_s = (1.0 - breathing.pause) * cycle.duration_s;
  if (cycle.since_s >= moving_s) return 0.0;
  const double s = std::sin(std::numbers::pi * cycle.since_s / moving_s);
  return s * s;
}

// After the R peak the pressure wave takes a tenth of a second to the abdominal aorta, which is widest a sixth of a second later and then
// narrows until the next beat (Nichols and O'Rourke, McDonald's Blood Flow in Arteries, pulses of diameter; times rounded).
constexpr double kWaveArrives_s = 0.10;
constexpr double kWaveRises_s = 0.16;

double pulseAt(const phantom::Pulse& pulse, double time_s) {
  const Cycle cycle = cycleAt(pulse.rhythm, time_s);
  const double stretch = std::min(1.0, cycle.duration_s / 0.6);  // everything comes sooner in a fast heart
  const double arrives = kWaveArrives_s * stretch, widest = arrives + kWaveRises_s * stretch;
  if (cycle.since_s <= widest) return risen((cycle.since_s - arrives) / (widest - arrives));
  const double fall = (cycle.since_s - widest) / (cycle.duration_s - widest);
  return 1.0 - risen(std::sqrt(std::max(fall, 0.0)));  // the root lets it fall faster at first
}

/// One vessel's push: across its line, within the plane of constant z, so that a place keeps its plane and its direction from the line.
class VesselPush {
 public:
  VesselPush(const PulsingVessel& vessel, double pulse) : vessel_(vessel), growth_(0.5 * vessel.growth_mm * pulse) {}

  [[nodiscard]] glm::dvec3 moved(const glm::dvec3& p) const {
    Ring ring;
    if (!ringAt(p.z, ring)) return p;
    const glm::dvec2 offset = glm::dvec2(p) - ring.centre;
    const double rho = glm::length(offset);
    if (rho < 1e-9 || rho >= ring.radius + vessel_.reach_mm) return p;
    return {ring.centre + offset * (widened(ring, rho) / rho), p.z};
  }

  [[nodiscard]] glm::dvec3 rest(const glm::dvec3& q) const {
    Ring ring;
    if (!ringAt(q.z, ring)) return q;
    const glm::dvec2 offset = glm::dvec2(q) - ring.centre;
    const double wanted = glm::length(offset);
    if (wanted < 1e-9 || wanted >= ring.radius + vessel_.reach_mm) return q;
    // widened is monotone and never moves a ring inwards, so the answer lies below.
    double low = std::max(0.0, wanted - ring.growth), high = wanted;
    while (high - low > kExact_mm) {
      // Regula falsi kept honest by a bisection whenever it would shrink the bracket too little.
      const double atLow = widened(ring, low) - wanted, atHigh = widened(ring, high) - wanted;
      double guess = atHigh > atLow ? low - atLow * (high - low) / (atHigh - atLow) : 0.5 * (low + high);
      guess = std::clamp(guess, low + 0.05 * (high - low), high - 0.05 * (high - low));
      (widened(ring, guess) < wanted ? low : high) = guess;
    }
    return {ring.centre + offset * (0.5 * (low + high) / wanted), q.z};
  }

  [[nodiscard]] double reach_mm() const { return growth_; }

 private:
  struct Ring {
    glm::dvec2 centre{0.0};
    double radius = 1.0;
    double growth = 0.0;
  };
  [[nodiscard]] bool ringAt(double z, Ring& ring) const {
    const auto& line = vessel_.line_mm;
    if (growth_ == 0.0 || !(z > line.front().z && z < line.back().z)) return false;
    const auto above = std::upper_bound(line.begin(), line.end(), z, [](double value, const glm::dvec4& point) { return value < point.z; });
    const glm::dvec4& low = *(above - 1);
    const glm::dvec4 at = low + (*above - low) * ((z - low.z) / (above->z - low.z));
    const double end = std::min(z - line.front().z, line.back().z - z) / vessel_.fade_mm;
    ring = {glm::dvec2(at), at.w, growth_ * risen(end)};
    return true;
  }
  /// Where the ring of radius rho goes: inside the vessel all widens alike; outside, the ring keeps its area (1 / rho) and the push fades.
  [[nodiscard]] double widened(const Ring& ring, double rho) const {
    if (rho <= ring.radius) return rho * (1.0 + ring.growth / ring.radius);
    return rho + ring.growth * (ring.radius / rho) * (1.0 - risen((rho - ring.radius) / vessel_.reach_mm));
  }

  const PulsingVessel& vessel_;
  double growth_;
};

class BodyMotion final : public Deformation {
 public:
  BodyMotion(const phantom::Motion& motion, const BodyState& state) {
    if (motion.breathing && state.breath != 0.0) {
      share_ = motion.breathing->share.get();
      breath_ = motion.breathing->displacement_mm * state.breath;
    }
    if (motion.pulse && state.pulse > 0.0)
      for (const PulsingVessel& vessel : motion.pulse->vessels) pushes_.emplace_back(vessel, state.pulse);
  }

  glm::dvec3 moved(const glm::dvec3& rest_mm) const override {
    glm::dvec3 p = rest_mm;
    for (const VesselPush& push : pushes_) p = push.moved(p);
    return share_ ? p + breath_ * (*share_)(p) : p;
  }

  glm::dvec3 rest(const glm::dvec3& moved_mm) const override {
    glm::dvec3 p = moved_mm;
    if (share_) p -= breath_ * shareAtRest(moved_mm);
    for (auto push = pushes_.rbegin(); push != pushes_.rend(); ++push) p = push->rest(p);
    return p;
  }

  double reach_mm() const override {
    double reach = glm::length(breath_);
    for (const VesselPush& push : pushes_) reach += push.reach_mm();
    return reach;
  }

 private:
  /// The share t of the place that came here: t = share(q - t d), and t - share(q - t d) rises with t because nothing folds.
  [[nodiscard]] double shareAtRest(const glm::dvec3& q) const {
    const double enough = kExact_mm / std::max(glm::length(breath_), kExact_mm);
    double low = 0.0, high = 1.0;
    double t = (*share_)(q);
    for (int step = 0; step < 60 && high - low > enough; ++step) {
      const double excess = t - (*share_)(q - breath_ * t);
      if (std::abs(excess) < 0.1 * enough) return t;
      (excess < 0.0 ? low : high) = t;
      // The fixed point of share, where it stays inside the bracket and the bracket shrinks; else the middle.
      const double next = t - excess;
      t = step % 3 != 2 && next > low && next < high ? next : 0.5 * (low + high);
    }
    return t;
  }

  const phantom::ShareField* share_ = nullptr;
  glm::dvec3 breath_{0.0};
  std::vector<VesselPush> pushes_;
};

}  // namespace

bool moves(const Patient& patient) { return patient.motion.breathing || patient.motion.pulse; }

BodyState stateAt(const Patient& patient, double time_s) {
  BodyState state;
  if (patient.motion.breathing) state.breath = breathAt(*patient.motion.breathing, time_s);
  if (patient.motion.pulse) state.pulse = pulseAt(*patient.motion.pulse, time_s);
  return state;
}

double ecgAt_mv(const Patient& patient, double time_s) {
  if (!patient.motion.pulse) return 0.0;
  // P, Q, R, S and T as Gaussians at their times from the R peak: the waves of McSharry et al., IEEE Trans. Biomed. Eng. 50(3), 2003,
  // on a straight time axis.
  struct Wave {
    double at_s, width_s, height_mv;
  };
  constexpr Wave kWaves[] = {{-0.17, 0.022, 0.12}, {-0.032, 0.007, -0.10}, {0.0, 0.009, 1.0}, {0.032, 0.008, -0.18}, {0.26, 0.045, 0.28}};
  const Cycle cycle = cycleAt(patient.motion.pulse->rhythm, time_s);
  const double stretch = std::min(1.0, cycle.duration_s / 0.7);
  double sum_mv = 0.0;
  for (const double beat_s : {0.0, cycle.duration_s}) {
    for (const Wave& wave : kWaves) {
      const double far = (cycle.since_s - beat_s - wave.at_s * stretch) / (wave.width_s * stretch);
      sum_mv += wave.height_mv * std::exp(-0.5 * far * far);
    }
  }
  return sum_mv;
}

std::unique_ptr<Deformation> bodyMotion(const Patient& patient, const BodyState& state) {
  return std::make_unique<BodyMotion>(patient.motion, state);
}

}  // namespace ew
