#include "ew/phantom/motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ew/core/parallel.h"
#include "patient/anatomy.h"

namespace ew {
namespace {

using phantom::BeatingChamber;
using phantom::PulsingVessel;

constexpr double kExact_mm = 1e-4;  // of the inverses, well within what a Deformation promises

double risen(double t) { return 0.5 - 0.5 * std::cos(std::numbers::pi * std::clamp(t, 0.0, 1.0)); }

/// Where `excess`, which rises from below 0 at `low` to above at `high`, is 0.
template <class Excess>
double zeroOf(const Excess& excess, double low, double high) {
  while (high - low > kExact_mm) {
    // Regula falsi kept honest by a bisection whenever it would shrink the bracket too little.
    const double atLow = excess(low), atHigh = excess(high);
    double guess = atHigh > atLow ? low - atLow * (high - low) / (atHigh - atLow) : 0.5 * (low + high);
    guess = std::clamp(guess, low + 0.05 * (high - low), high - 0.05 * (high - low));
    (excess(guess) < 0.0 ? low : high) = guess;
  }
  return 0.5 * (low + high);
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
    const double rho = zeroOf([&](double at) { return widened(ring, at) - wanted; }, std::max(0.0, wanted - ring.growth), wanted);
    return {ring.centre + offset * (rho / wanted), q.z};
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

/// One chamber's contraction. The ellipsoid whose radii are longer than the wall's by d becomes the one whose radii are longer by
/// drawnIn(d), d < 0 being shorter ones, and a place keeps its share of each radius: on the wall every place moves by `inward`. Within the
/// wall all shrinks alike. No two ellipsoids of the family meet, so tissue does not fold while drawnIn rises.
class ChamberPull {
 public:
  ChamberPull(const BeatingChamber& chamber, double pulse)
      : wall_(chamber.wall),
        toAxes_(glm::transpose(chamber.wall.axes)),
        longest_(std::max({wall_.radii_mm.x, wall_.radii_mm.y, wall_.radii_mm.z})),
        reach_(chamber.reach_mm),
        inward_(chamber.inward_mm * pulse) {}

  [[nodiscard]] glm::dvec3 moved(const glm::dvec3& p) const {
    const glm::dvec3 q = toAxes_ * (p - wall_.centre_mm);
    if (isWithin(q, wall_.radii_mm)) return placed(q * (wall_.radii_mm - inward_) / wall_.radii_mm);
    if (glm::length(q) >= longest_ + reach_) return p;
    const double beyond = beyondWall(q, 0.0);
    return beyond < reach_ ? placed(q * (wall_.radii_mm + drawnIn(beyond)) / (wall_.radii_mm + beyond)) : p;
  }

  [[nodiscard]] glm::dvec3 rest(const glm::dvec3& p) const {
    const glm::dvec3 q = toAxes_ * (p - wall_.centre_mm);
    if (isWithin(q, wall_.radii_mm - inward_)) return placed(q * wall_.radii_mm / (wall_.radii_mm - inward_));
    if (glm::length(q) >= longest_ + reach_) return p;
    const double wanted = beyondWall(q, -inward_);
    if (wanted >= reach_) return p;
    const double beyond = zeroOf([&](double at) { return drawnIn(at) - wanted; }, std::max(0.0, wanted), wanted + inward_);
    return placed(q * (wall_.radii_mm + beyond) / (wall_.radii_mm + wanted));
  }

  [[nodiscard]] double reach_mm() const { return inward_; }

 private:
  [[nodiscard]] static bool isWithin(const glm::dvec3& q, const glm::dvec3& radii) {
    const glm::dvec3 share = q / radii;
    return glm::dot(share, share) <= 1.0;
  }
  [[nodiscard]] glm::dvec3 placed(const glm::dvec3& q) const { return wall_.centre_mm + wall_.axes * q; }
  /// The d of the ellipsoid through q, which lies outside the one of `from`: the sum of (q_i / (r_i + d))^2 falls to 1 with d and is
  /// convex, so that Newton's steps come from below.
  [[nodiscard]] double beyondWall(const glm::dvec3& q, double from) const {
    double d = std::max(from, glm::length(q) - longest_);
    for (double step = 1.0; step > 1e-9;) {
      const glm::dvec3 radii = wall_.radii_mm + d, share = q / radii, square = share * share;
      step = (square.x + square.y + square.z - 1.0) / (2.0 * glm::dot(square, 1.0 / radii));
      d += step;
    }
    return d;
  }
  /// By how much the volume of the ellipsoid of d grows with d, over 4 pi / 3, mm^2.
  [[nodiscard]] double area(double d) const {
    const glm::dvec3 r = wall_.radii_mm + d;
    return r.x * r.y + r.y * r.z + r.z * r.x;
  }
  /// Around the wall shells keep their volume (1 / area) and the pull fades.
  [[nodiscard]] double drawnIn(double d) const { return d - inward_ * (area(0.0) / area(d)) * (1.0 - risen(d / reach_)); }

  phantom::Ellipsoid wall_;
  glm::dmat3 toAxes_;
  double longest_;
  double reach_;
  double inward_;
};

class BodyMotion final : public Deformation {
 public:
  BodyMotion(const phantom::Motion& motion, const BodyState& state) {
    if (motion.breathing && state.breath != 0.0) {
      share_ = motion.breathing->share.get();
      breath_ = motion.breathing->displacement_mm * state.breath;
    }
    if (motion.pulse && state.pulse > 0.0) {
      for (const PulsingVessel& vessel : motion.pulse->vessels) pushes_.emplace_back(vessel, state.pulse);
      for (const BeatingChamber& chamber : motion.pulse->chambers) pulls_.emplace_back(chamber, state.pulse);
    }
  }

  glm::dvec3 moved(const glm::dvec3& rest_mm) const override {
    glm::dvec3 p = rest_mm;
    for (const VesselPush& push : pushes_) p = push.moved(p);
    for (const ChamberPull& pull : pulls_) p = pull.moved(p);
    return share_ ? p + breath_ * (*share_)(p) : p;
  }

  glm::dvec3 rest(const glm::dvec3& moved_mm) const override {
    glm::dvec3 p = moved_mm;
    if (share_) p -= breath_ * shareAtRest(moved_mm);
    for (auto pull = pulls_.rbegin(); pull != pulls_.rend(); ++pull) p = pull->rest(p);
    for (auto push = pushes_.rbegin(); push != pushes_.rend(); ++push) p = push->rest(p);
    return p;
  }

  double reach_mm() const override {
    double reach = glm::length(breath_);
    for (const VesselPush& push : pushes_) reach += push.reach_mm();
    for (const ChamberPull& pull : pulls_) reach += pull.reach_mm();
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
  std::vector<ChamberPull> pulls_;
};

}  // namespace

bool moves(const Patient& patient) { return patient.motion.breathing || patient.motion.pulse || patient.motion.bowel; }

BodyRhythms rhythmsOf(const Patient& patient) {
  BodyRhythms rhythms;
  if (const auto& breathing = patient.motion.breathing) rhythms.breathing = {breathing->rhythm, breathing->pause, breathing->tidal};
  if (patient.motion.pulse) rhythms.pulse = patient.motion.pulse->rhythm;
  if (patient.motion.bowel) rhythms.bowel = patient.motion.bowel->rhythm;
  return rhythms;
}

BodyState stateAt(const Patient& patient, double time_s) { return bodyAt(rhythmsOf(patient), time_s); }

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

namespace {

constexpr double kBowelNodes_mm = 4.0;

Grid nodesOver(const Bounds& box, double spacing_mm) {
  Grid grid;
  grid.origin_mm = box.lowest_mm;
  grid.spacing_mm = glm::dvec3(spacing_mm);
  grid.dims = glm::max(glm::ivec3(glm::ceil((box.highest_mm - box.lowest_mm) / spacing_mm)), glm::ivec3(1)) + 1;
  return grid;
}

/// A field of what `shiftAt` says at each node.
template <class ShiftAt>
bool addMode(TissueMotion::Kind kind, const Grid& grid, int threads, Progress& progress, TissueMotion& motion, const ShiftAt& shiftAt) {
  TissueMotion::Mode& mode = motion.modes.emplace_back(TissueMotion::Mode{kind, grid, std::vector<glm::vec3>(grid.voxelCount())});
  return forEachTask(
      grid.dims.z, threads, progress, say<"Finding how the patient moves">(), [&](int k, int /*worker*/, const auto& stopped) {
        for (int j = 0; j < grid.dims.y && !stopped(); ++j)
          for (int i = 0; i < grid.dims.x; ++i)
            mode.shift_mm[grid.indexOf(i, j, k)] = glm::vec3(shiftAt(grid.origin_mm + grid.spacing_mm * glm::dvec3(i, j, k)));
      });
}

bool addVessel(const PulsingVessel& vessel, int threads, Progress& progress, TissueMotion& motion) {
  Bounds box{glm::dvec3(1e9), glm::dvec3(-1e9)};
  double thinnest_mm = 1e9;
  for (const glm::dvec4& point : vessel.line_mm) {
    const glm::dvec3 around(point.w + vessel.reach_mm, point.w + vessel.reach_mm, 0.0);
    box.lowest_mm = glm::min(box.lowest_mm, glm::dvec3(point) - around);
    box.highest_mm = glm::max(box.highest_mm, glm::dvec3(point) + around);
    thinnest_mm = std::min(thinnest_mm, point.w);
  }
  const VesselPush push(vessel, 1.0);
  const Grid grid = nodesOver(box, std::clamp(0.25 * thinnest_mm, 1.0, 2.5));
  return addMode(TissueMotion::Kind::pulse, grid, threads, progress, motion, [&](const glm::dvec3& p) { return push.moved(p) - p; });
}

bool addChamber(const BeatingChamber& chamber, int threads, Progress& progress, TissueMotion& motion) {
  const phantom::Ellipsoid& wall = chamber.wall;
  const glm::dvec3 radii = wall.radii_mm + chamber.reach_mm;
  const glm::dvec3 half = glm::sqrt(glm::matrixCompMult(wall.axes, wall.axes) * (radii * radii));
  const ChamberPull pull(chamber, 1.0);
  const double shortest_mm = std::min({wall.radii_mm.x, wall.radii_mm.y, wall.radii_mm.z});
  const Grid grid = nodesOver({wall.centre_mm - half, wall.centre_mm + half}, std::clamp(0.1 * shortest_mm, 1.0, 2.5));
  return addMode(TissueMotion::Kind::pulse, grid, threads, progress, motion, [&](const glm::dvec3& p) { return pull.moved(p) - p; });
}

/// How far a place lies within the gut, 0 outside and 1 where it sways fully.
double shareOfGut(const phantom::Bowel& bowel, const glm::dvec3& p_mm) {
  double deepest_mm = 0.0;
  for (const phantom::ShapePtr& organ : bowel.organs)
    if (organ->atLeast_mm(p_mm) <= 0.0) deepest_mm = std::max(deepest_mm, -organ->distance_mm(p_mm));
  const double t = std::min(1.0, deepest_mm / bowel.fade_mm);
  return t * t * (3.0 - 2.0 * t);
}

bool addBowel(const phantom::Bowel& bowel, const Bounds& within, int threads, Progress& progress, TissueMotion& motion) {
  Bounds box{glm::dvec3(1e9), glm::dvec3(-1e9)};
  for (const phantom::ShapePtr& organ : bowel.organs) {
    box.lowest_mm = glm::min(box.lowest_mm, organ->bounds().lowest_mm);
    box.highest_mm = glm::max(box.highest_mm, organ->bounds().highest_mm);
  }
  // A node beyond each side, where nothing sways.
  box.lowest_mm = glm::max(box.lowest_mm, within.lowest_mm) - kBowelNodes_mm;
  box.highest_mm = glm::min(box.highest_mm, within.highest_mm) + kBowelNodes_mm;
  if (!glm::all(glm::lessThan(box.lowest_mm, box.highest_mm))) return true;
  // Waves run from the patient's right to the left and downwards; tissue sways front to back.
  const glm::dvec3 wave = 2.0 * std::numbers::pi / bowel.wavelength_mm * glm::normalize(glm::dvec3(1.0, 0.0, -1.0));
  const glm::dvec3 sway_mm(0.0, 0.5 * bowel.sway_mm, 0.0);
  const Grid grid = nodesOver(box, kBowelNodes_mm);
  if (!addMode(TissueMotion::Kind::bowelCosine, grid, threads, progress, motion,
               [&](const glm::dvec3& p) { return shareOfGut(bowel, p) * std::cos(glm::dot(wave, p)) * sway_mm; }))
    return false;
  return addMode(TissueMotion::Kind::bowelSine, grid, threads, progress, motion,
                 [&](const glm::dvec3& p) { return shareOfGut(bowel, p) * std::sin(glm::dot(wave, p)) * sway_mm; });
}

}  // namespace

Result<std::shared_ptr<TissueMotion>> tissueMotionOf(const Patient& patient, int threads, Progress& progress) {
  if (!moves(patient)) return std::shared_ptr<TissueMotion>();
  const phantom::Motion& from = patient.motion;
  auto motion = std::make_shared<TissueMotion>();
  motion->rhythms = rhythmsOf(patient);
  bool finished = true;
  PartOfProgress breath(progress, 0.0, 0.1), pulse(progress, 0.1, 0.5), bowel(progress, 0.5, 1.0);
  if (from.breathing) {
    const phantom::ShareField& share = *from.breathing->share;
    const Grid grid = nodesOver({share.placeOf(glm::ivec3(0)), share.placeOf(share.nodes() - 1)},
                                share.placeOf(glm::ivec3(1)).x - share.placeOf(glm::ivec3(0)).x);
    finished = addMode(TissueMotion::Kind::breath, grid, threads, breath, *motion,
                       [&](const glm::dvec3& p) { return from.breathing->displacement_mm * share(p); });
  }
  if (from.pulse) {
    for (const PulsingVessel& vessel : from.pulse->vessels) finished = finished && addVessel(vessel, threads, pulse, *motion);
    for (const BeatingChamber& chamber : from.pulse->chambers) finished = finished && addChamber(chamber, threads, pulse, *motion);
  }
  if (from.bowel) finished = finished && addBowel(*from.bowel, patient.box, threads, bowel, *motion);
  if (!finished) return failure(ErrorCode::cancelled, say<"Building the virtual patient was stopped.">());
  return motion;
}

std::unique_ptr<Deformation> bodyMotion(const Patient& patient, const BodyState& state) {
  return std::make_unique<BodyMotion>(patient.motion, state);
}

}  // namespace ew
