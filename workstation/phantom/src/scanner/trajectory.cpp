#include "scanner/trajectory.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <numbers>

#include "ew/core/numbers.h"
#include "ew/phantom/contact_pressure.h"
#include "patient/skin_contact.h"

namespace ew::phantom {
namespace {

constexpr double kDegree_rad = std::numbers::pi / 180.0;
constexpr double kFlattestLook = 0.17;     // cosine of the angle between beam and inward normal: 80 degrees
constexpr double kOutsideBox_mm = 5.0;     // how far from the patient's box a probe may touch
constexpr double kDeepestFold_mm = 60.0;   // how far a probe is drawn back before it counts as stuck in a fold
constexpr double kRotationArm_mm = 50.0;   // turning by an angle is as much way as the image's middle makes by it
constexpr int kStepsBetweenStations = 32;  // where the way along the path is measured
constexpr int kStepsOfTime = 512;

// An unsteady hand (unevenness 1). Tremor of 8 to 12 Hz: Elble and Koller, Tremor, 1990 (physiological tremor).
constexpr double kLean_deg = 2.5, kWander_mm = 1.5, kTremor_deg = 0.15, kTremor_mm = 0.15, kSpeedSpread = 0.45;

std::string placeText(const glm::dvec3& p_mm) {
  const auto tenth = [](double value) { return textOf(std::round(value * 10.0) / 10.0); };
  return "(" + tenth(p_mm.x) + ", " + tenth(p_mm.y) + ", " + tenth(p_mm.z) + ") mm";
}

tl::unexpected<Error> refused(std::size_t station, const Message& what, const Message& advice) {
  const std::string place = "stations[" + std::to_string(station) + "]";
  return failure(ErrorCode::badField, say<"The sweep's %1 %2; %3.">(place, what, advice), {{"field", place}, {"found", what.english()}});
}

/// `along` made square to `to`, of unit length; empty when it points along `to`.
std::optional<glm::dvec3> squareTo(const glm::dvec3& to, const glm::dvec3& along) {
  const double length = glm::length(along);
  if (!(length > 0.0)) return std::nullopt;
  const glm::dvec3 square = along / length - glm::dot(along / length, to) * to;
  if (glm::length(square) < 0.05) return std::nullopt;
  return glm::normalize(square);
}

Transform<frame::World, frame::Probe> poseOf(const glm::dmat3& axes, const glm::dvec3& origin_mm) {
  Transform<frame::World, frame::Probe> pose;
  for (int axis = 0; axis < 3; ++axis) pose.matrix[axis] = glm::dvec4(axes[axis], 0.0);
  pose.matrix[3] = glm::dvec4(origin_mm, 1.0);
  return pose;
}

glm::dmat3 turned(int axis, double angle_rad) {
  glm::dvec3 about(0.0);
  about[axis] = 1.0;
  return glm::mat3_cast(glm::angleAxis(angle_rad, about));
}

}  // namespace

Trajectory::Trajectory(const Patient& patient, const Probe& probe, const SweepRecipe& recipe)
    : patient_(&patient), probe_(probe), recipe_(recipe) {
  duration_s_ = (recipe.frames - 1) / recipe.framesPerSecond;
  patch_mm_ = std::clamp(0.25 * faceLength_mm(probe), 1.0, 12.0);
  const std::uint64_t seed = recipe.handSeed;
  for (int n = 0; n < 3; ++n) lean_.emplace_back(seed, 1 + n, 0.1, 0.6);
  for (int n = 0; n < 2; ++n) wander_.emplace_back(seed, 11 + n, 0.1, 0.5);
  for (int n = 0; n < 4; ++n) tremor_.emplace_back(seed, 21 + n, 8.0, 12.0);
}

/// The probe's axes when it looks straight into the skin: x along `lateral`, y against the normal.
glm::dmat3 Trajectory::skinFrame(const glm::dvec3& p_mm, const glm::dvec3& lateral) const {
  const glm::dvec3 inward = -skinNormal(*patient_->skin, p_mm, patch_mm_);
  const glm::dvec3 x = squareTo(inward, lateral).value_or(glm::normalize(glm::cross(inward, glm::dvec3(0.31, 0.57, 0.76))));
  return {x, inward, glm::cross(x, inward)};
}

/// Puts the face on the skin at a point and presses it in.
Transform<frame::World, frame::Probe> Trajectory::pressed(const glm::dmat3& axes, const glm::dvec3& contact_mm) const {
  auto pose = poseOf(axes, contact_mm);
  const double back_mm = drawnBack_mm(*patient_->skin, probe_, pose, kDeepestFold_mm).value_or(kDeepestFold_mm);
  pose.matrix[3] += (recipe_.indentation_mm - back_mm) * pose.matrix[1];
  return pose;
}

Result<void> Trajectory::placeStations() {
  const Bounds& box = patient_->box;
  for (std::size_t n = 0; n < recipe_.stations.size(); ++n) {
    const auto& station = recipe_.stations[n];
    glm::dvec3 contact_mm = station.near_mm;
    if (recipe_.onSkin) {
      const auto skin = skinPointNear(*patient_->skin, station.near_mm);
      if (!skin)
        return refused(n, say<"at %1 has no skin within %2 mm">(placeText(station.near_mm), textOf(kFarthestFromSkin_mm)),
                       say<"give a point near the skin, or say \"on_skin\": false to place the probe freely">());
      contact_mm = *skin;
    }
    if (glm::any(glm::lessThan(contact_mm, box.lowest_mm - kOutsideBox_mm)) ||
        glm::any(glm::greaterThan(contact_mm, box.highest_mm + kOutsideBox_mm)))
      return refused(n,
                     say<"puts the probe at %1, outside the patient's box from %2 to %3">(placeText(contact_mm), placeText(box.lowest_mm),
                                                                                          placeText(box.highest_mm)),
                     say<"move it to where there is anatomy">());
    glm::dmat3 axes = skinFrame(contact_mm, station.lateral);
    const glm::dmat3 straight = axes;
    if (station.towards_mm) {
      const glm::dvec3 look = *station.towards_mm - contact_mm;
      if (glm::length(look) < 1.0)
        return refused(n, say<"looks towards the very point where it stands">(), say<"look at a point inside the body">());
      axes[1] = glm::normalize(look);
      if (recipe_.onSkin && glm::dot(axes[1], straight[1]) < kFlattestLook)
        return refused(n, say<"looks along the skin or out of the body">(),
                       say<"look at a point inside the body, less than 80 degrees from straight in">());
    } else if (!recipe_.onSkin) {
      return refused(n, say<"does not say where it looks (towards_mm)">(), say<"a probe that is not on the skin needs it">());
    }
    const auto x = squareTo(axes[1], station.lateral);
    if (!x)
      return refused(n, say<"has a lateral direction along its beam">(),
                     say<"give the direction of the image's x axis, square to the beam">());
    axes[0] = *x;
    axes[2] = glm::cross(axes[0], axes[1]);
    if (recipe_.onSkin && !drawnBack_mm(*patient_->skin, probe_, poseOf(axes, contact_mm), kDeepestFold_mm))
      return refused(n, say<"is in a fold of the skin that the probe %1 does not fit into">(probe_.id),
                     say<"choose a smaller probe or another place">());
    if (n == 0) start_ = recipe_.onSkin ? pressed(axes, contact_mm) : poseOf(axes, contact_mm);

    // Off the skin there is nothing to lean against but the first station.
    const glm::dmat3 base = recipe_.onSkin ? skinFrame(contact_mm, station.lateral) : glm::dmat3(start_.matrix);
    glm::dquat lean = glm::quat_cast(glm::transpose(base) * axes);
    Knot knot{contact_mm.x, contact_mm.y, contact_mm.z};
    const glm::dvec3 lateral = glm::normalize(station.lateral);
    for (int axis = 0; axis < 3; ++axis) knot[static_cast<std::size_t>(3 + axis)] = lateral[axis];
    double rotation_rad = 0.0;
    if (n > 0) {
      const Knot& before = knots_.back();
      const glm::dquat leanBefore(before[6], before[7], before[8], before[9]);
      if (glm::dot(lean, leanBefore) < 0.0) lean = -lean;
      const glm::dvec3 lateralBefore(before[3], before[4], before[5]);
      if (glm::dot(lateral, lateralBefore) < -0.7 || glm::dot(lean, leanBefore) < 0.5)
        return refused(n, say<"turns the image by more than a hand can on the way from the station before">(),
                       say<"put a station between the two, or swap the sign of lateral">());
      rotation_rad = std::acos(std::clamp(glm::dot(lateral, lateralBefore), -1.0, 1.0)) +
                     2.0 * std::acos(std::clamp(glm::dot(lean, leanBefore), -1.0, 1.0));
      const double way_mm = glm::distance(contact_mm, glm::dvec3(before[0], before[1], before[2])) + kRotationArm_mm * rotation_rad;
      // Centripetal spacing: no loops where stations lie unevenly. Equal stations stay a step apart: there the hand rests.
      knotAt_.push_back(knotAt_.back() + std::max(std::sqrt(way_mm), 1e-3));
    } else {
      knotAt_.push_back(0.0);
    }
    knot[6] = lean.w, knot[7] = lean.x, knot[8] = lean.y, knot[9] = lean.z;
    knots_.push_back(knot);
  }
  return {};
}

/// Cubic through the knots whose slope at each is that of the parabola through it and its neighbours.
Trajectory::Knot Trajectory::between(double at) const {
  if (knots_.size() == 1) return knots_.front();
  const std::size_t last = knots_.size() - 1;
  const auto after = std::upper_bound(knotAt_.begin(), knotAt_.end(), at);
  const auto i =
      static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(after - knotAt_.begin() - 1, 0, static_cast<std::ptrdiff_t>(last) - 1));
  const auto chord = [&](std::size_t from, std::size_t c) {
    return (knots_[from + 1][c] - knots_[from][c]) / (knotAt_[from + 1] - knotAt_[from]);
  };
  const auto slope = [&](std::size_t n, std::size_t c) {
    if (n == 0) return chord(0, c);
    if (n == last) return chord(last - 1, c);
    const double before = knotAt_[n] - knotAt_[n - 1], behind = knotAt_[n + 1] - knotAt_[n];
    return (chord(n - 1, c) * behind + chord(n, c) * before) / (before + behind);
  };
  const double width = knotAt_[i + 1] - knotAt_[i];
  const double t = std::clamp((at - knotAt_[i]) / width, 0.0, 1.0);
  Knot result{};
  for (std::size_t c = 0; c < result.size(); ++c) {
    const double a = knots_[i][c], b = knots_[i + 1][c];
    result[c] = a * (1.0 + 2.0 * t) * (1.0 - t) * (1.0 - t) + b * t * t * (3.0 - 2.0 * t) +
                width * (slope(i, c) * t * (1.0 - t) * (1.0 - t) - slope(i + 1, c) * t * t * (1.0 - t));
  }
  return result;
}

Transform<frame::World, frame::Probe> Trajectory::handPose(double at, double time_s) const {
  const Knot knot = between(at);
  glm::dvec3 contact_mm(knot[0], knot[1], knot[2]);
  const glm::dvec3 lateral(knot[3], knot[4], knot[5]);
  glm::dmat3 base = recipe_.onSkin ? skinFrame(contact_mm, lateral) : glm::dmat3(start_.matrix);
  const double unevenness = recipe_.unevenness;
  if (unevenness > 0.0) {
    contact_mm += unevenness * (kWander_mm * wander_[0].at(time_s) + kTremor_mm * tremor_[0].at(time_s)) * base[0];
    contact_mm += unevenness * (kWander_mm * wander_[1].at(time_s) + kTremor_mm * tremor_[1].at(time_s)) * base[2];
  }
  if (recipe_.onSkin) {
    contact_mm = skinPointNear(*patient_->skin, contact_mm).value_or(contact_mm);
    base = skinFrame(contact_mm, lateral);
  }
  glm::dmat3 axes = base * glm::mat3_cast(glm::normalize(glm::dquat(knot[6], knot[7], knot[8], knot[9])));
  if (unevenness > 0.0) {
    const double degree = unevenness * kDegree_rad;
    axes = axes * turned(0, degree * (kLean_deg * lean_[0].at(time_s) + kTremor_deg * tremor_[2].at(time_s))) *
           turned(1, degree * kLean_deg * lean_[1].at(time_s)) *
           turned(2, degree * (kLean_deg * lean_[2].at(time_s) + kTremor_deg * tremor_[3].at(time_s)));
  }
  return recipe_.onSkin ? pressed(axes, contact_mm) : poseOf(axes, contact_mm);
}

/// Where along the path's parameter which share of the way is made, and at which time: then speed along the skin can be even, or uneven by
/// as much as the hand is.
void Trajectory::measurePath() {
  const int steps = kStepsBetweenStations * static_cast<int>(knots_.size() - 1);
  wayAt_.assign(1, 0.0);
  Knot before = between(0.0);
  for (int step = 1; step <= steps; ++step) {
    const Knot now = between(knotAt_.back() * step / steps);
    double moved = 0.0, turned = 0.0;
    for (std::size_t c = 0; c < 3; ++c) moved += (now[c] - before[c]) * (now[c] - before[c]);
    for (std::size_t c = 3; c < 10; ++c) turned += (c < 6 ? 1.0 : 4.0) * (now[c] - before[c]) * (now[c] - before[c]);
    wayAt_.push_back(wayAt_.back() + std::sqrt(moved + kRotationArm_mm * kRotationArm_mm * turned));
    before = now;
  }
  const double whole = wayAt_.back();
  for (std::size_t step = 0; step < wayAt_.size(); ++step)
    wayAt_[step] = whole > 1e-9 ? wayAt_[step] / whole : static_cast<double>(step) / std::max(1, steps);

  const SmoothNoise speed(recipe_.handSeed, 31, 0.15, 0.8);
  shareOfTime_.assign(1, 0.0);
  double speedBefore = 1.0;
  for (int step = 0; step <= kStepsOfTime; ++step) {
    const double now = std::exp(kSpeedSpread * recipe_.unevenness * speed.at(duration_s_ * step / kStepsOfTime));
    if (step > 0) shareOfTime_.push_back(shareOfTime_.back() + 0.5 * (speedBefore + now));
    speedBefore = now;
  }
  for (double& share : shareOfTime_) share /= shareOfTime_.back();
}

double Trajectory::shareOfWay(double time_s) const {
  const double share = duration_s_ > 0.0 ? std::clamp(time_s / duration_s_, 0.0, 1.0) : 0.0;
  if (recipe_.kind != SweepKind::freehand) return share;
  const double at = share * kStepsOfTime;
  const auto step = std::min(static_cast<std::size_t>(at), static_cast<std::size_t>(kStepsOfTime - 1));
  return shareOfTime_[step] + (at - static_cast<double>(step)) * (shareOfTime_[step + 1] - shareOfTime_[step]);
}

double Trajectory::motorAt(double time_s) const {
  const double share = shareOfWay(time_s);
  switch (recipe_.kind) {
    case SweepKind::freehand:
      return 0.0;
    case SweepKind::parallel:
      return share * recipe_.extent_mm;
    case SweepKind::fan:
      return (share - 0.5) * recipe_.extent_deg;
    case SweepKind::rotational:
      return share * recipe_.extent_deg;
  }
  return 0.0;
}

Transform<frame::World, frame::Probe> Trajectory::poseAt(double time_s) const {
  const double motor = motorAt(time_s);
  Transform<frame::Probe, frame::Probe> moved;
  const auto turn = [&](int axis, double behind_mm) {
    const glm::dmat3 rotation = turned(axis, motor * kDegree_rad);
    const glm::dvec3 centre_mm(0.0, -behind_mm, 0.0);
    moved.matrix = glm::dmat4(rotation);
    moved.matrix[3] = glm::dvec4(centre_mm - rotation * centre_mm, 1.0);
  };
  switch (recipe_.kind) {
    case SweepKind::freehand: {
      if (knots_.size() == 1) return handPose(0.0, time_s);
      const double share = shareOfWay(time_s);
      const auto after = std::upper_bound(wayAt_.begin(), wayAt_.end(), share);
      const auto step = std::clamp<std::ptrdiff_t>(after - wayAt_.begin() - 1, 0, std::ssize(wayAt_) - 2);
      const double low = wayAt_[static_cast<std::size_t>(step)], high = wayAt_[static_cast<std::size_t>(step) + 1];
      const double part = high > low ? std::clamp((share - low) / (high - low), 0.0, 1.0) : 0.0;
      return handPose(knotAt_.back() * (static_cast<double>(step) + part) / static_cast<double>(wayAt_.size() - 1), time_s);
    }
    case SweepKind::parallel:
      moved.matrix[3].z = motor;
      break;
    case SweepKind::fan:
      turn(0, recipe_.axisBehindFace_mm);
      break;
    case SweepKind::rotational:
      turn(1, 0.0);
      break;
  }
  return start_ * moved;
}

Result<Trajectory> Trajectory::along(const Patient& patient, const Probe& probe, const SweepRecipe& recipe) {
  if (recipe.stations.empty())
    return failure(ErrorCode::badField, say<"The sweep has no station; say at least one point near the skin where the probe is put.">(),
                   {{"field", "stations"}});
  if (recipe.kind != SweepKind::freehand && recipe.stations.size() != 1)
    return failure(ErrorCode::badField,
                   say<"The sweep has %1 stations, but a motor starts from one; give one station, or make the sweep freehand.">(
                       recipe.stations.size()),
                   {{"field", "stations"}, {"found", std::to_string(recipe.stations.size())}, {"expected", "1"}});
  if (const double deepest_mm = deepestIndentation_mm(probe); recipe.indentation_mm > deepest_mm)
    return failure(ErrorCode::badField,
                   say<"The sweep presses the probe %1 mm into the skin, but %2 can press %3 mm at most; use a smaller indentation_mm.">(
                       textOf(recipe.indentation_mm), probe.id, textOf(std::floor(deepest_mm * 10.0) / 10.0)),
                   {{"field", "indentation_mm"}, {"found", textOf(recipe.indentation_mm)}, {"expected", textOf(deepest_mm)}});
  Trajectory trajectory(patient, probe, recipe);
  if (auto placed = trajectory.placeStations(); !placed) return passOn(placed.error());
  if (trajectory.knots_.size() > 1 || recipe.kind == SweepKind::freehand) trajectory.measurePath();
  return trajectory;
}

}  // namespace ew::phantom
