#include "scanner/line_losses.h"

#include <algorithm>
#include <array>

#include "scanner/penumbra.h"
#include "scanner/slice_blocks.h"

namespace ew::phantom {
namespace {

constexpr double kGelGap_mm = 4.0;  // between face and skin, filled with gel
constexpr double kAir_db = 60.0;    // lost where the line leaves the body, or never meets it
constexpr double kAirPerGap_dbPerMm = 15.0;
constexpr double kSameThing_mm = 3.0;  // a line that comes back so soon meets no second surface

/// Beams are about a line wide: (1 2 1) / 4 across them.
void acrossLines(std::size_t steps, std::vector<float>& values, std::vector<float>& smooth) {
  const std::size_t lines = values.size() / steps;
  smooth.resize(values.size());
  for (std::size_t l = 0; l < lines; ++l) {
    const float* before = values.data() + (l > 0 ? l - 1 : 0) * steps;
    const float* here = values.data() + l * steps;
    const float* after = values.data() + std::min(l + 1, lines - 1) * steps;
    for (std::size_t s = 0; s < steps; ++s) smooth[l * steps + s] = 0.25F * (before[s] + after[s]) + 0.5F * here[s];
  }
  values.swap(smooth);
}

/// What one line loses from the face on, and how late its echoes come.
class LineWalk {
 public:
  explicit LineWalk(const ScannerSetup& setup) : setup_(setup) {}
  /// The next step.
  void pass(std::uint8_t tissue, double depth_mm) {
    if (tissue != ScattererBlock::kOutside) {
      passTissue(tissue, depth_mm);
    } else if (entered_) {
      lost_db_ += kAir_db;
    } else {
      lost_db_ = std::clamp((depth_mm - kGelGap_mm) * kAirPerGap_dbPerMm, 0.0, kAir_db);
    }
    last_ = tissue;
  }
  [[nodiscard]] double lost_db() const { return lost_db_; }  ///< both ways
  /// Of the tissue the line is in.
  [[nodiscard]] double reflection_db() const { return last_ != ScattererBlock::kOutside ? setup_.lostAtSurface_db[last_] : 0.0; }
  [[nodiscard]] double delay_mm() const { return delay_mm_; }

 private:
  void passTissue(std::uint8_t tissue, double depth_mm) {
    entered_ = true;
    lost_db_ += setup_.lostPerStep_db[tissue];
    delay_mm_ += setup_.delayPerStep_mm[tissue];
    const double reflection_db = setup_.lostAtSurface_db[tissue];
    if (!(reflection_db > 0.0)) return;
    if (tissue != last_ && !(tissue == reflected_ && depth_mm - reflected_mm_ < kSameThing_mm)) lost_db_ += reflection_db;
    reflected_ = tissue;
    reflected_mm_ = depth_mm;
  }

  const ScannerSetup& setup_;
  double lost_db_ = 0.0, delay_mm_ = 0.0;
  std::uint8_t last_ = ScattererBlock::kOutside, reflected_ = ScattererBlock::kOutside;
  double reflected_mm_ = -1e9;  ///< where the line last was in the tissue that reflected it
  bool entered_ = false;
};

}  // namespace

void walkLines(const ScannerSetup& setup, const ScattererField& field, const View& view, FrameScratch& work) {
  const std::size_t lines = setup.grid.lines.size(), steps = static_cast<std::size_t>(setup.steps);
  work.gain.assign(lines * steps, setup.options.attenuation ? 0.0F : 1.0F);
  work.delay_mm.assign(setup.options.speedOfSound ? lines * steps : 0, 0.0F);
  if (!setup.options.attenuation && !setup.options.speedOfSound) return;

  // Where a deformed body's lines lie at rest: exact every few steps and lines, straight in between.
  constexpr std::size_t kEveryLine = 8, kEveryStep = 8;
  const std::size_t coarseLines = (lines - 1) / kEveryLine + 2, coarseSteps = (steps - 1) / kEveryStep + 2;
  const auto pointOn = [&](std::size_t line, double depth) {
    const BeamGrid::Line& at = setup.grid.lines[line];
    return view.toWorld(glm::dvec3(at.origin_mm + at.direction * depth, 0.0));
  };
  if (view.deforms) {
    work.restOnLines.resize(coarseLines * coarseSteps);
    for (std::size_t l = 0; l < coarseLines; ++l)
      for (std::size_t s = 0; s < coarseSteps; ++s) {
        const glm::dvec3 world = pointOn(std::min(l * kEveryLine, lines - 1), static_cast<double>(s * kEveryStep) * setup.step_mm);
        work.restOnLines[l * coarseSteps + s] = view.deformation.rest(world) - world;
      }
  }
  const glm::dvec3 aside = (view.probeToWorld * Direction<frame::Probe>{{0.0, 0.0, 1.0}}).along;
  constexpr std::array<double, 3> kPlanes{0.0, -0.75, 0.75}, kWeights{0.5, 0.25, 0.25};
  work.lost_db.resize(lines * steps);
  work.reflection_db.assign(lines * steps, 0.0F);
  for (std::size_t plane = 0; plane < kPlanes.size(); ++plane) {
    for (std::size_t l = 0; l < lines; ++l) {
      LineWalk walk(setup);
      for (std::size_t s = 0; s < steps; ++s) {
        if (s > 0) {
          const double depth = (static_cast<double>(s) - 0.5) * setup.step_mm;
          glm::dvec3 at = pointOn(l, depth);
          if (view.deforms) {
            const std::size_t l0 = l / kEveryLine, s0 = s / kEveryStep;
            const double tl = static_cast<double>(l % kEveryLine) / kEveryLine;
            const double ts = static_cast<double>(s % kEveryStep) / kEveryStep;
            const glm::dvec3* near = &work.restOnLines[l0 * coarseSteps + s0];
            const glm::dvec3* far = near + coarseSteps;
            at += (1.0 - tl) * ((1.0 - ts) * near[0] + ts * near[1]) + tl * ((1.0 - ts) * far[0] + ts * far[1]);
          }
          at += aside * (kPlanes[plane] * setup.beams.elevationalSigma_mm(depth));
          walk.pass(tissueAt(field, at, work), depth);
        }
        const std::size_t at = l * steps + s;
        work.lost_db[at] = static_cast<float>(walk.lost_db());
        work.reflection_db[at] = static_cast<float>(walk.reflection_db());
        if (setup.options.speedOfSound) work.delay_mm[at] += static_cast<float>(kWeights[plane] * walk.delay_mm());
      }
    }
    if (!setup.options.attenuation) continue;
    if (setup.options.penumbra) {
      seenFromAperture(setup, work.lost_db, work.reflection_db, work.left);
    } else {
      work.left.resize(lines * steps);
      std::transform(work.lost_db.begin(), work.lost_db.end(), work.left.begin(),
                     [](float lost_db) { return static_cast<float>(factorOf(static_cast<double>(lost_db))); });
    }
    for (std::size_t n = 0; n < work.gain.size(); ++n) work.gain[n] += static_cast<float>(kWeights[plane]) * work.left[n];
  }
  acrossLines(steps, work.gain, work.smooth);
  if (setup.options.speedOfSound) acrossLines(steps, work.delay_mm, work.smooth);
}

}  // namespace ew::phantom
