#include "ew/imaging/frame_reach.h"

#include <algorithm>
#include <cmath>

#include "compound.h"
#include "echoes/echo_beams.h"
#include "echoes/scatterers.h"
#include "ew/imaging/beam_grid.h"
#include "ew/imaging/display.h"
#include "ew/imaging/resolved.h"
#include "planning.h"

namespace ew {
namespace {

constexpr double kStep_mm = 3.0;    // between capsules, along lines and across them
constexpr double kBeside_mm = 4.0;  // of a place: its voxels and theirs, bent ranges, pulses, walls too small for maps
constexpr double kBehind_mm = 6.0;  // the last sample: the pulse, and blocks that reach in
constexpr double kBlock_mm = 8.0;   // beside a piece of the slab: what its blocks hold

/// Of the pieces whose blocks may hold what lies at a depth, with those blocks: they are all as wide as where a beam is widest there.
detail::DepthRange piecesAt(double at_mm, double depth_mm) {
  const int pieces = detail::piecesIn(depth_mm);
  const auto pieceAt = [&](double mm) { return std::clamp(static_cast<int>(std::floor(mm / detail::kPiece_mm)), 0, pieces - 1); };
  const int first = pieceAt(at_mm - kBlock_mm), last = pieceAt(at_mm + kBlock_mm);
  return {first * detail::kPiece_mm - kBlock_mm, (last + 1 == pieces ? depth_mm : (last + 1) * detail::kPiece_mm) + kBlock_mm};
}

/// The lines of one direction of a frame.
class LookReach {
 public:
  LookReach(const BeamGrid& grid, const detail::EchoBeams& beams, const LiveEchoesEffect& effect, bool presses)
      : grid_(grid),
        beams_(beams),
        depth_mm_(grid.depth_mm(grid.samples - 1)),
        reach_(effect.reach),
        press_mm_(presses ? detail::kFarthestSkin_mm : 0.0) {}

  void addTo(std::vector<Capsule>& capsules) const {
    const auto endOf = [&](const BeamGrid::Line& line) { return line.origin_mm + depth_mm_ * line.direction; };
    const BeamGrid::Line* last = nullptr;
    for (const BeamGrid::Line& line : grid_.lines) {
      const bool isOutermost = &line == &grid_.lines.front() || &line == &grid_.lines.back();
      if (last != nullptr && !isOutermost && glm::distance(endOf(line), endOf(*last)) < kStep_mm &&
          glm::distance(line.origin_mm, last->origin_mm) < kStep_mm)
        continue;
      last = &line;
      for (double at_mm = -press_mm_ - kStep_mm; at_mm < depth_mm_ + kBehind_mm; at_mm += kStep_mm) {
        addAt(line, at_mm, 0.0, capsules);
        if (!isOutermost) continue;
        const double side = &line == &grid_.lines.front() ? -1.0 : 1.0, aside_mm = seenAside_mm(at_mm);
        for (double off_mm = kStep_mm; off_mm < aside_mm + kStep_mm; off_mm += kStep_mm) addAt(line, at_mm, side * off_mm, capsules);
      }
    }
  }

 private:
  /// Beside the outermost lines.
  [[nodiscard]] double seenAside_mm(double at_mm) const {
    const double below_mm = std::max(0.0, at_mm - press_mm_) / detail::kGives_mm;
    return detail::kLateralSigmas * widestAt([&](double depth_mm) { return beams_.lateralSigma_mm(depth_mm); }, at_mm) +
           press_mm_ * std::exp(-below_mm * below_mm);
  }
  template <class Sigma>
  [[nodiscard]] double widestAt(const Sigma& sigma_mm, double at_mm) const {
    const detail::DepthRange pieces = piecesAt(at_mm, depth_mm_);
    return std::max(sigma_mm(pieces.near_mm), sigma_mm(pieces.far_mm));
  }
  void addAt(const BeamGrid::Line& line, double at_mm, double aside_mm, std::vector<Capsule>& capsules) const {
    const glm::dvec2 across(line.direction.y, -line.direction.x);  // towards the probe's +x
    const glm::dvec2 at = line.origin_mm + at_mm * line.direction + aside_mm * across;
    const double elevation_mm = reach_ * widestAt([&](double depth_mm) { return beams_.elevationalSigma_mm(depth_mm); }, at_mm);
    capsules.push_back({{at, -elevation_mm}, {at, elevation_mm}, kBeside_mm + 0.71 * kStep_mm});
  }

  const BeamGrid& grid_;
  const detail::EchoBeams& beams_;
  double depth_mm_;
  double reach_;
  double press_mm_;
};

}  // namespace

std::vector<Capsule> reachOfFrame(const Probe& probe, const Knobs& asked, const Scene& askedScene) {
  const Scene scene = detail::knownScene(limited(askedScene), {.tissue = true}, limited(asked));
  if (!formsEchoes(scene)) return {};
  const Knobs knobs = detail::withCarrierOf(probe, detail::knownKnobs(limited(asked), probe, scene, {.tissue = true}));
  const double depth_mm = resolvedDepth_mm(probe, knobs);
  const double spacing_mm = detail::liveSpacing_mm(probe, knobs, scene, depth_mm);
  const detail::EchoBeams beams = detail::echoBeamsOf(probe, knobs, scene, depth_mm);
  std::vector<double> looks_rad = detail::looksBeside(knobs.compoundAngles, isSector(probe.kind));
  looks_rad.push_back(0.0);
  std::vector<Capsule> capsules;
  for (const double look_rad : looks_rad) {
    const BeamGrid grid = makeBeamGrid(probe, knobs, depth_mm, spacing_mm, look_rad);
    LookReach(grid, beams, *scene.liveEchoes, scene.contact.has_value()).addTo(capsules);
  }
  return capsules;
}

}  // namespace ew
