#include "ew/imaging/frame_reach.h"

#include <algorithm>
#include <cmath>

#include "compound.h"
#include "echoes/echo_beams.h"
#include "ew/imaging/beam_grid.h"
#include "ew/imaging/display.h"
#include "ew/imaging/resolved.h"
#include "planning.h"

namespace ew {
namespace {

constexpr double kStep_mm = 3.0;        // between capsules, along lines and across them
constexpr double kLateralSigmas = 3.0;  // of beams, as the lateral filter has them
constexpr double kBeside_mm =
    4.0;  // of a place: its voxels and theirs, bent ranges, pulses; at least as far as walls too small for maps reach
constexpr double kPress_mm = 12.0;  // most that tissue gives way to the face, and how far before the face its skin is looked for
constexpr double kPressFalls_mm = 35.0;
constexpr double kBehind_mm = 6.0;    // the last sample: the pulse, and blocks that reach in
constexpr double kOfPiece_mm = 26.0;  // a piece of the slab is as thick and wide as at its ends, and a block beyond them
constexpr double kShallowest_mm = -8.0;

/// The lines of one direction of a frame.
class LookReach {
 public:
  LookReach(const detail::EchoBeams& beams, const LiveEchoesEffect& effect, bool presses)
      : beams_(beams), reach_(effect.reach), press_mm_(presses ? kPress_mm : 0.0) {}

  void add(const BeamGrid& grid, std::vector<Capsule>& capsules) const {
    const double depth_mm = grid.depth_mm(grid.samples - 1);
    const auto endOf = [depth_mm](const BeamGrid::Line& line) { return line.origin_mm + depth_mm * line.direction; };
    const BeamGrid::Line* last = nullptr;
    for (const BeamGrid::Line& line : grid.lines) {
      const bool isOutermost = &line == &grid.lines.front() || &line == &grid.lines.back();
      if (last != nullptr && !isOutermost && glm::distance(endOf(line), endOf(*last)) < kStep_mm &&
          glm::distance(line.origin_mm, last->origin_mm) < kStep_mm)
        continue;
      last = &line;
      for (double at_mm = -press_mm_ - kStep_mm; at_mm < depth_mm + kBehind_mm; at_mm += kStep_mm) {
        addAt(line, at_mm, 0.0, capsules);
        if (!isOutermost) continue;
        const double side = &line == &grid.lines.front() ? -1.0 : 1.0, aside_mm = seenAside_mm(at_mm);
        for (double off_mm = kStep_mm; off_mm < aside_mm + kStep_mm; off_mm += kStep_mm) addAt(line, at_mm, side * off_mm, capsules);
      }
    }
  }

 private:
  /// Beside the outermost lines.
  [[nodiscard]] double seenAside_mm(double at_mm) const {
    const double below_mm = std::max(0.0, at_mm - press_mm_) / kPressFalls_mm;
    return kLateralSigmas * widestAt([&](double depth_mm) { return beams_.lateralSigma_mm(depth_mm); }, at_mm) +
           press_mm_ * std::exp(-below_mm * below_mm);
  }
  template <class Sigma>
  [[nodiscard]] static double widestAt(const Sigma& sigma_mm, double at_mm) {
    return std::max(sigma_mm(std::max(at_mm - kOfPiece_mm, kShallowest_mm)), sigma_mm(at_mm + kOfPiece_mm));
  }
  void addAt(const BeamGrid::Line& line, double at_mm, double aside_mm, std::vector<Capsule>& capsules) const {
    const glm::dvec2 across(line.direction.y, -line.direction.x);  // towards the probe's +x
    const glm::dvec2 at = line.origin_mm + at_mm * line.direction + aside_mm * across;
    const double elevation_mm = reach_ * widestAt([&](double depth_mm) { return beams_.elevationalSigma_mm(depth_mm); }, at_mm);
    capsules.push_back({{at, -elevation_mm}, {at, elevation_mm}, kBeside_mm + 0.71 * kStep_mm});
  }

  const detail::EchoBeams& beams_;
  double reach_;
  double press_mm_;
};

}  // namespace

std::vector<Capsule> reachOfFrame(const Probe& probe, const Knobs& asked, const Scene& askedScene) {
  const Scene scene = detail::knownScene(limited(askedScene), true, false, limited(asked));
  if (!formsEchoes(scene)) return {};
  const Knobs knobs = detail::withCarrierOf(probe, detail::knownKnobs(limited(asked), probe, scene));
  const double depth_mm = resolvedDepth_mm(probe, knobs);
  const double spacing_mm = detail::liveSpacing_mm(probe, knobs, scene, depth_mm);
  const detail::EchoBeams beams = detail::echoBeamsOf(probe, knobs, scene, depth_mm);
  const LookReach look(beams, *scene.liveEchoes, scene.contact.has_value());
  std::vector<double> looks_rad = detail::looksBeside(knobs.compoundAngles, isSector(probe.kind));
  looks_rad.push_back(0.0);
  std::vector<Capsule> capsules;
  for (const double look_rad : looks_rad) look.add(makeBeamGrid(probe, knobs, depth_mm, spacing_mm, look_rad), capsules);
  return capsules;
}

}  // namespace ew
