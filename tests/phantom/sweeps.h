#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "ew/phantom/virtual_sweep.h"
#include "recipes.h"
#include "shipped_probe.h"

namespace ew::testing {

/// A ball of even tissue, radius 60 mm, all of it in the patient's box.
inline std::shared_ptr<const Patient> ballPatient(const std::string& extra = "") {
  const Folder folder;
  folder.write("ball.json", bodyRecipe(R"({"ellipsoid": {"centre_mm": [0, 0, 0], "radii_mm": [60, 60, 60]}})"));
  auto patient = readPatient(folder.write(
      "patient.json",
      R"({"format": 1, "name": "ball", "mannequin": "ball.json",
    "box": {"lowest_mm": [-70, -70, -70], "highest_mm": [70, 70, 70]},
    "tissues": [{"name": "even", "echo_level": 100, "speckle": 1}], "background": "even", )" +
          extra +
          R"( "organs": [{"name": "bead", "tissue": "even", "shape": {"ellipsoid": {"centre_mm": [0, 0, 0], "radii_mm": [1, 1, 1]}}}]})"));
  if (!patient) {
    ADD_FAILURE() << patient.error();
    std::abort();
  }
  return *patient;
}

/// A thin straight thread, or a bead when `along` is zero.
struct Thread {
  glm::dvec3 at_mm;
  glm::dvec3 along{0.0};
  [[nodiscard]] double distance_mm(const glm::dvec3& p_mm) const {
    const glm::dvec3 to = p_mm - at_mm;
    return glm::length(to - glm::dot(to, along) * along);
  }
};

/// A machine that sees threads in the resting body through a round, even point spread function, and nothing else: what a sweep does with
/// images can be checked to a part of a pixel.
class ThreadScanner final : public VirtualScanner {
 public:
  ThreadScanner(Probe probe, double depth_mm, std::vector<Thread> threads, double blur_mm = 0.5)
      : probe_(std::move(probe)), threads_(std::move(threads)), blur_mm_(blur_mm) {
    options_.depth_mm = depth_mm;
    Knobs knobs;
    knobs.depth_mm = depth_mm;
    grid_ = makeBeamGrid(probe_, knobs, depth_mm, 0.15);
  }
  [[nodiscard]] const FormationOptions& options() const override { return options_; }
  [[nodiscard]] const Probe& probe() const override { return probe_; }
  [[nodiscard]] const BeamGrid& grid() const override { return grid_; }
  [[nodiscard]] PointSpread pointSpreadAt(double) const override { return {blur_mm_, blur_mm_, blur_mm_}; }
  [[nodiscard]] std::unique_ptr<Scratch> makeScratch() const override { return std::make_unique<Scratch>(); }
  void envelope(const Transform<frame::World, frame::Probe>& probeToWorld, const Deformation& deformation, std::uint64_t /*frame*/,
                Scratch& /*scratch*/, Image<float>& envelope) const override {
    envelope = Image<float>(static_cast<int>(grid_.lines.size()), grid_.samples);
    for (int s = 0; s < grid_.samples; ++s) {
      for (int l = 0; l < envelope.width; ++l) {
        const auto& line = grid_.lines[static_cast<std::size_t>(l)];
        const glm::dvec2 at = line.origin_mm + grid_.depth_mm(s) * line.direction;
        const glm::dvec3 rest = deformation.rest((probeToWorld * Point<frame::Probe>{{at, 0.0}}).at);
        double sum = 0.0;
        for (const Thread& thread : threads_) {
          const double away = thread.distance_mm(rest) / blur_mm_;
          if (away < 6.0) sum += std::exp(-0.5 * away * away);
        }
        envelope.pixels[static_cast<std::size_t>(s) * grid_.lines.size() + static_cast<std::size_t>(l)] = static_cast<float>(sum);
      }
    }
  }

 private:
  Probe probe_;
  std::vector<Thread> threads_;
  double blur_mm_;
  FormationOptions options_;
  BeamGrid grid_;
};

}  // namespace ew::testing
