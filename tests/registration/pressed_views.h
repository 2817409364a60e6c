#pragma once

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <numbers>
#include <optional>
#include <vector>

#include "ew/acquisition/reconstruct.h"
#include "ew/imaging/probe.h"
#include "ew/io/sweep.h"
#include "ew/phantom/patient.h"
#include "ew/phantom/virtual_sweep.h"
#include "graphs.h"

/// Twelve overlapping views of one virtual patient, recorded as a hand would with the probe pressed in, and what is true of them.
namespace ew::registration::test {

struct ViewPlan {
  std::uint64_t seed = 1;       ///< of the scatterers, of where the probe is put, and of where each volume's own coordinates lie
  double indentation_mm = 2.0;  ///< the mean; views differ by a third of it either way
  double spacing_mm = 1.5;
  int frames = 36;
  int lines = 96;
  double depth_mm = 110.0;
};

/// A view in coordinates of its own, and where what it shows rests in the patient.
class PressedView {
 public:
  Volume volume;                                    ///< in its own mm
  Transform<frame::World, frame::View> ownToWorld;  ///< where the tracker would have put it
  glm::dvec3 middle_mm{0};                          ///< of what it covers, own mm

  /// Where the tissue seen at a place (own mm) rests, world mm.
  [[nodiscard]] glm::dvec3 restOf(const glm::dvec3& own_mm) const {
    const glm::dvec3 world = carried(ownToWorld, own_mm);
    const glm::dvec3 at = (world - lowest_mm) / kStep_mm;
    const glm::dvec3 low = glm::clamp(glm::floor(at), glm::dvec3(0.0), glm::dvec3(dims - 2));
    const glm::dvec3 t = at - low;
    glm::dvec3 push(0.0);
    for (int c = 0; c < 8; ++c) {
      const glm::ivec3 up(c & 1, (c >> 1) & 1, c >> 2);
      const glm::ivec3 n = glm::ivec3(low) + up;
      double w = 1.0;
      for (int a = 0; a < 3; ++a) w *= up[a] != 0 ? t[a] : 1.0 - t[a];
      push += w * push_mm[(static_cast<std::size_t>(n.z) * dims.y + n.y) * dims.x + n.x];
    }
    return world + push;
  }
  /// The place (own mm) at which tissue that rests at `rest_mm` is seen.
  [[nodiscard]] glm::dvec3 seenAt(const glm::dvec3& rest_mm) const {
    const auto worldToOwn = inverse(ownToWorld);
    glm::dvec3 world = rest_mm;
    for (int step = 0; step < 30; ++step) world += rest_mm - restOf(carried(worldToOwn, world));
    return carried(worldToOwn, world);
  }
  [[nodiscard]] bool covers(const glm::dvec3& own_mm) const {
    const glm::ivec3 v(glm::round(glm::dvec3(volume.grid.worldToVoxel().matrix * glm::dvec4(own_mm, 1.0))));
    return volume.grid.contains(v) && volume.coverageAt(volume.grid.indexOf(v.x, v.y, v.z)) != Coverage::absent;
  }
  /// Covered places, about `step_mm` apart, own mm.
  [[nodiscard]] std::vector<glm::dvec3> places(double step_mm) const {
    std::vector<glm::dvec3> found;
    const int stride = std::max(1, static_cast<int>(std::lround(step_mm / volume.grid.spacing_mm.x)));
    const auto toOwn = volume.grid.voxelToWorld();
    for (int k = 0; k < volume.grid.dims.z; k += stride)
      for (int j = 0; j < volume.grid.dims.y; j += stride)
        for (int i = 0; i < volume.grid.dims.x; i += stride)
          if (volume.coverageAt(volume.grid.indexOf(i, j, k)) != Coverage::absent)
            found.push_back((toOwn * Point<frame::Voxel>{glm::dvec3(i, j, k)}).at);
    return found;
  }

  static constexpr double kStep_mm = 6.0;
  std::vector<glm::dvec3> push_mm;  // rest - seen, on a lattice of the tracker's world
  glm::dvec3 lowest_mm{0.0};
  glm::ivec3 dims{0};
};

/// The rigid motion that takes `from` to `to` with the least sum of squares (Arun, Huang and Blostein), and what it leaves.
struct RigidPart {
  glm::dmat4 matrix{1.0};
  double rms_mm = 0.0;
};
inline RigidPart rigidPart(const std::vector<glm::dvec3>& from, const std::vector<glm::dvec3>& to) {
  glm::dvec3 a(0.0), b(0.0);
  for (std::size_t n = 0; n < from.size(); ++n) a += from[n], b += to[n];
  a /= static_cast<double>(from.size());
  b /= static_cast<double>(from.size());
  Eigen::Matrix3d product = Eigen::Matrix3d::Zero();
  for (std::size_t n = 0; n < from.size(); ++n)
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) product(r, c) += (to[n] - b)[r] * (from[n] - a)[c];
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(product, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Vector3d sign(1.0, 1.0, (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0 ? -1.0 : 1.0);
  const Eigen::Matrix3d turn = svd.matrixU() * sign.asDiagonal() * svd.matrixV().transpose();
  RigidPart part;
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r) part.matrix[c][r] = turn(r, c);
  part.matrix[3] = glm::dvec4(b - glm::dmat3(part.matrix) * a, 1.0);
  double squares = 0.0;
  for (std::size_t n = 0; n < from.size(); ++n) {
    const glm::dvec3 left = glm::dvec3(part.matrix * glm::dvec4(from[n], 1.0)) - to[n];
    squares += glm::dot(left, left);
  }
  part.rms_mm = std::sqrt(squares / static_cast<double>(from.size()));
  return part;
}

/// Where a view belongs: the rigid part of what takes the tissue it shows to where that tissue rests, over all it covers. Pressed tissue
/// has no other pose: the rest of the motion is deformation, and a tracker that knows where the probe was knows nothing of it.
inline RigidPart truePose(const PressedView& view) {
  const auto seen = view.places(6.0);
  std::vector<glm::dvec3> rest;
  for (const auto& p : seen) rest.push_back(view.restOf(p));
  return rigidPart(seen, rest);
}

/// The rigid part of what takes tissue from where one view shows it to where the other does, over what both show.
inline std::optional<RigidPart> trueEdge(const PressedView& fixed, const PressedView& moving, std::size_t* count = nullptr) {
  std::vector<glm::dvec3> from, to;
  for (const auto& p : fixed.places(6.0)) {
    const glm::dvec3 q = moving.seenAt(fixed.restOf(p));
    if (!moving.covers(q)) continue;
    from.push_back(p);
    to.push_back(q);
  }
  if (count != nullptr) *count = from.size();
  if (from.size() < 50) return std::nullopt;
  return rigidPart(from, to);
}

inline Clip clipOf(const DeviceSet& set) {
  Clip clip{.origin_px = *set.clipOrigin_px, .size_px = *set.clipSize_px};
  if (set.fanOrigin_px) {
    const glm::dvec2 angles = *set.fanAngles_deg * std::numbers::pi / 180.0;
    clip.fan = ClipFan{*set.fanOrigin_px, angles.x, angles.y, *set.fanRadiusStart_px, *set.fanRadiusStop_px};
  }
  return clip;
}

/// Three rows of four fans over the upper abdomen; view n lies in row n / 4, column n % 4.
inline std::vector<PressedView> pressedViews(const ViewPlan& plan, const std::filesystem::path& source) {
  const auto patient = readPatient(source / "cases/upper-abdomen-gall-stone/patient.json", source / "resources/mannequin");
  auto probe = readProbe(source / "resources/probes/convex-3.5.json");
  if (!patient || !probe) {
    ADD_FAILURE() << "the patient or the probe cannot be read";
    return {};
  }
  probe->lines = plan.lines;
  Draw draw(plan.seed);
  std::vector<PressedView> views;
  for (int n = 0; n < 12; ++n) {
    SweepRecipe recipe;
    recipe.kind = SweepKind::fan;
    recipe.extent_deg = 50.0;
    recipe.frames = plan.frames;
    recipe.formation.depth_mm = plan.depth_mm;
    recipe.formation.focus_mm = 70.0;
    recipe.formation.gain_db = 6.0 + draw.even(-2.0, 2.0);
    recipe.formation.looks = 3;
    recipe.formation.noise_db = -104.0;
    recipe.formation.noiseSeed = plan.seed * 100 + static_cast<std::uint64_t>(n);
    recipe.seed = plan.seed;
    recipe.pixel_mm = 0.5;
    recipe.indentation_mm = plan.indentation_mm * draw.even(0.67, 1.33);
    const double x = -54.0 + 36.0 * (n % 4) + draw.even(-4.0, 4.0);
    const double z = -30.0 - 28.0 * (n / 4) + draw.even(-4.0, 4.0);
    recipe.stations = {
        {.near_mm = {x, -104.0, z}, .lateral = {-1.0, 0.0, draw.even(-0.1, 0.1)}, .towards_mm = glm::dvec3(0.4 * x, 40.0, z)}};
    const auto sweep = recordSweep(*patient, *probe, recipe, 0, noProgress());
    if (!sweep) {
      ADD_FAILURE() << sweep.error();
      return {};
    }
    std::vector<TrackedFrame> frames;
    std::vector<std::unique_ptr<Deformation>> pressed;
    for (std::size_t f = 0; f < sweep->trueProbeToWorld.size(); ++f) {
      const Transform<frame::World, frame::Image> imageToWorld{sweep->trueProbeToWorld[f].matrix * sweep->imageToProbe};
      frames.push_back(
          {{sweep->sequence.framePixels(f).data(), sweep->sequence.width, sweep->sequence.height, sweep->sequence.width}, imageToWorld});
      pressed.push_back(deformationOf(**patient, *probe, recipe, sweep->trueProbeToWorld[f], sweep->trueState[f]));
    }
    auto made = reconstruct(frames, {.spacing_mm = plan.spacing_mm, .fillReach_mm = 8.0, .clip = clipOf(sweep->deviceSet)}, noProgress());
    if (!made) {
      ADD_FAILURE() << made.error();
      return {};
    }
    PressedView view;
    view.volume = std::move(made->volume);
    const Bounds bounds = boundsOf(view.volume.grid);
    view.lowest_mm = bounds.lowest_mm - PressedView::kStep_mm;
    view.dims = glm::ivec3(glm::ceil((bounds.highest_mm - view.lowest_mm) / PressedView::kStep_mm)) + 2;
    for (int k = 0; k < view.dims.z; ++k)
      for (int j = 0; j < view.dims.y; ++j)
        for (int i = 0; i < view.dims.x; ++i) {
          const glm::dvec3 at = view.lowest_mm + PressedView::kStep_mm * glm::dvec3(i, j, k);
          // As the two nearest frames show it, by turns of the distance.
          std::size_t nearest[2] = {0, 0};
          double away[2] = {1e9, 1e9};
          for (std::size_t f = 0; f < frames.size(); ++f) {
            const double d = std::abs(projectionOnto(frames[f].imageToWorld, {at}).distance_mm);
            if (d < away[0]) {
              nearest[1] = nearest[0], away[1] = away[0];
              nearest[0] = f, away[0] = d;
            } else if (d < away[1]) {
              nearest[1] = f, away[1] = d;
            }
          }
          const double share = away[0] / std::max(1e-9, away[0] + away[1]);
          view.push_mm.push_back((1.0 - share) * pressed[nearest[0]]->rest(at) + share * pressed[nearest[1]]->rest(at) - at);
        }
    // Coordinates of its own, of which nobody knows how they lie in the world: within the 30 degrees that matching looks through.
    const glm::dvec3 middle = 0.5 * (bounds.lowest_mm + bounds.highest_mm);
    const glm::dvec3 about = glm::normalize(draw.vector(1.0));
    const glm::dvec3 shift = draw.vector(60.0);
    const auto worldToOwn = moved<frame::World>(middle, shift, glm::radians(draw.even(4.0, 13.0)) * about);
    view.volume.grid = placed(view.volume.grid, worldToOwn);
    view.ownToWorld = renamed<frame::World, frame::View>(inverse(worldToOwn));
    glm::dvec3 sum(0.0);
    const auto covered = view.places(6.0);
    for (const auto& p : covered) sum += p;
    view.middle_mm = sum / static_cast<double>(std::max<std::size_t>(1, covered.size()));
    views.push_back(std::move(view));
  }
  return views;
}

/// Neighbours to the side, below and across.
inline std::vector<std::pair<std::size_t, std::size_t>> neighbours() {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (int i = 0; i < 12; ++i)
    for (int j = i + 1; j < 12; ++j)
      if (std::abs(i / 4 - j / 4) <= 1 && std::abs(i % 4 - j % 4) <= 1) pairs.emplace_back(i, j);
  return pairs;
}

}  // namespace ew::registration::test
