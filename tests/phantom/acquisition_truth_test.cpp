#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ew/acquisition/gating.h"
#include "ew/acquisition/motor_sweep.h"
#include "ew/io/gating_fields.h"
#include "sweeps.h"

namespace ew::acquisition_truth_test {
namespace {

using testing::patientOf;
using testing::patientRecipe;
using testing::shippedProbe;

/// A ball of tissue of 60 mm, all of it in the box.
std::shared_ptr<const Patient> made(std::string recipe) {
  const std::string box = R"("lowest_mm": [-40, -40, -40], "highest_mm": [40, 40, 40])";
  recipe.replace(recipe.find(box), box.size(), R"("lowest_mm": [-70, -70, -70], "highest_mm": [70, 70, 70])");
  auto patient = patientOf(recipe);
  if (!patient) {
    ADD_FAILURE() << patient.error();
    std::abort();
  }
  return *patient;
}

std::vector<TrackedFrame> posed(const Sequence& sequence, const SweepPoses& poses) {
  std::vector<TrackedFrame> frames;
  for (std::size_t n = 0; n < sequence.frames.size(); ++n)
    frames.push_back({{sequence.framePixels(n).data(), sequence.width, sequence.height, sequence.width}, poses.imageToWorld[n].value()});
  return frames;
}

VirtualSweep recorded(const std::shared_ptr<const Patient>& patient, SweepRecipe recipe) {
  Probe probe = shippedProbe("linear-7.5");
  probe.lines = 48;
  recipe.probe = "linear-7.5";
  recipe.formation.specular = false;
  recipe.formation.attenuation = false;
  recipe.formation.tgc = {{0.0, 0.0}};
  auto sweep = recordSweep(patient, probe, recipe, 0, noProgress());
  if (!sweep) {
    ADD_FAILURE() << sweep.error();
    std::abort();
  }
  return *std::move(sweep);
}

TEST(MotorisedSweeps, OfOnePatientPutADarkBallWhereItIsToHalfAVoxel) {
  const glm::dvec3 centre_mm(2.0, -38.0, 1.5);
  const auto patient = made(
      patientRecipe(R"({"name": "cyst", "tissue": "dark", "shape": {"ellipsoid": {"centre_mm": [2, -38, 1.5], "radii_mm": [6, 6, 6]}}})"));
  constexpr double kSpacing_mm = 0.6;
  for (const SweepKind kind : {SweepKind::parallel, SweepKind::fan, SweepKind::rotational}) {
    SweepRecipe recipe;
    recipe.kind = kind;
    recipe.frames = kind == SweepKind::rotational ? 45 : 30;
    recipe.formation.depth_mm = 40.0;
    recipe.pixel_mm = 0.3;
    const double start_mm = kind == SweepKind::parallel ? -9.0 : 0.0;
    recipe.stations = {{.near_mm = {0.0, -60.0, start_mm}, .towards_mm = glm::dvec3(0.0, 0.0, start_mm)}};
    if (kind == SweepKind::parallel) recipe.extent_mm = 21.0;
    if (kind == SweepKind::fan) recipe.extent_deg = 50.0;
    if (kind == SweepKind::rotational) recipe.extent_deg = 177.0;
    const VirtualSweep sweep = recorded(patient, recipe);
    const auto motor = recordedMotor(sweep.sequence);
    ASSERT_TRUE(motor.has_value()) << motor.error();
    const auto poses = motorPoses(sweep.sequence, *motor, &sweep.deviceSet);
    ASSERT_TRUE(poses.has_value()) << poses.error();
    ASSERT_EQ(poses->usable, sweep.sequence.frames.size());
    for (std::size_t n = 0; n < poses->usable; ++n) {
      const glm::dmat4 truth = sweep.trueProbeToWorld[n].matrix * sweep.imageToProbe;
      for (const glm::dvec4 corner : {glm::dvec4(0, 0, 0, 1), glm::dvec4(sweep.sequence.width, sweep.sequence.height, 0, 1)})
        ASSERT_LT(glm::distance(poses->imageToWorld[n]->matrix * corner, truth * corner), 1e-4) << "frame " << n;
    }
    const auto volume = reconstruct(posed(sweep.sequence, *poses), {.spacing_mm = kSpacing_mm, .fillReach_mm = 3.0}, noProgress());
    ASSERT_TRUE(volume.has_value()) << volume.error();
    // The dark ball's centre of gravity: what is darker than half of the tissue, within 9 mm.
    const Grid& grid = volume->volume.grid;
    std::vector<std::uint8_t> around;
    const auto forEach = [&](const auto& work) {
      for (int k = 0; k < grid.dims.z; ++k)
        for (int j = 0; j < grid.dims.y; ++j)
          for (int i = 0; i < grid.dims.x; ++i) {
            const std::size_t index = grid.indexOf(i, j, k);
            const glm::dvec3 p_mm = (grid.voxelToWorld() * Point<frame::Voxel>{{i, j, k}}).at;
            if (volume->volume.coverageAt(index) != Coverage::absent && glm::distance(p_mm, centre_mm) < 9.5)
              work(p_mm, volume->volume.echo[index]);
          }
    };
    forEach([&](const glm::dvec3& p_mm, std::uint8_t echo) {
      if (glm::distance(p_mm, centre_mm) > 8.0) around.push_back(echo);
    });
    ASSERT_FALSE(around.empty());
    std::nth_element(around.begin(), around.begin() + static_cast<std::ptrdiff_t>(around.size() / 2), around.end());
    const double half = 0.5 * around[around.size() / 2];
    glm::dvec3 sum_mm(0.0);
    double count = 0.0;
    forEach([&](const glm::dvec3& p_mm, std::uint8_t echo) {
      if (echo >= half || glm::distance(p_mm, centre_mm) > 8.0) return;
      sum_mm += p_mm;
      count += 1.0;
    });
    const double error_mm = glm::distance(sum_mm / count, centre_mm);
    RecordProperty("error_mm_" + std::to_string(static_cast<int>(kind)), std::to_string(error_mm));
    EXPECT_LT(error_mm, 0.5 * kSpacing_mm) << "kind " << static_cast<int>(kind) << ", " << count << " voxels";
    EXPECT_NEAR(std::cbrt(count * std::pow(kSpacing_mm, 3) * 0.75 / std::numbers::pi), 6.0, 0.9) << "a ball of its size";
  }
}

/// Diameter of the dark vessel about the line x = 0, y = centre, along the beam: where the profile, averaged along z and over 1.5 mm to
/// either side, is 6 dB below the tissue, half of its amplitude.
double diameterIn(const Volume& volume, double centre_mm) {
  const Grid& grid = volume.grid;
  std::vector<double> profile(static_cast<std::size_t>(grid.dims.y), 0.0), weight(profile.size(), 0.0);
  for (int k = 0; k < grid.dims.z; ++k)
    for (int j = 0; j < grid.dims.y; ++j)
      for (int i = 0; i < grid.dims.x; ++i) {
        const std::size_t index = grid.indexOf(i, j, k);
        const double x_mm = grid.origin_mm.x + i * grid.spacing_mm.x;
        if (std::abs(x_mm) > 1.5 || volume.coverageAt(index) == Coverage::absent) continue;
        profile[static_cast<std::size_t>(j)] += volume.echo[index];
        weight[static_cast<std::size_t>(j)] += 1.0;
      }
  for (std::size_t j = 0; j < profile.size(); ++j) profile[j] = weight[j] > 0.0 ? profile[j] / weight[j] : 0.0;
  const auto indexOf = [&](double y_mm) { return static_cast<std::size_t>((y_mm - grid.origin_mm.y) / grid.spacing_mm.y); };
  const std::size_t middle = indexOf(centre_mm);
  double outside = 0.0, count = 0.0;
  for (const double side : {-1.0, 1.0})
    for (double away_mm = 10.0; away_mm < 13.0; away_mm += grid.spacing_mm.y, count += 1.0)
      outside += profile[indexOf(centre_mm + side * away_mm)];
  const double half = outside / count - 6.02 * 255.0 / 60.0;
  const auto crossing = [&](std::ptrdiff_t way) {
    auto j = static_cast<std::ptrdiff_t>(middle);
    while (j + way > 0 && j + way + 1 < static_cast<std::ptrdiff_t>(profile.size()) && profile[static_cast<std::size_t>(j + way)] < half)
      j += way;
    const double here = profile[static_cast<std::size_t>(j)], next = profile[static_cast<std::size_t>(j + way)];
    return static_cast<double>(j) + static_cast<double>(way) * (half - here) / (next - here);
  };
  return (crossing(1) - crossing(-1)) * grid.spacing_mm.y;
}

TEST(GatedSweeps, OfABeatingVesselKeepItsDiameterWithinHalfAMillimetreWhereUngatedOnesDoNot) {
  constexpr double kVessel_mm = -38.0, kRest_mm = 11.0, kGrowth_mm = 3.0;
  const auto patient = made(patientRecipe(
      R"({"name": "aorta", "tissue": "dark", "shape": {"tube": {"points": [[0, -38, -40, 5.5], [0, -38, 0, 5.5], [0, -38, 40, 5.5]]}}})",
      R"("motion": {"pulse": {"beats_per_minute": 75, "vessels": [{"of": "aorta", "diameter_growth_mm": 3, "reach_mm": 12}]}},)"));
  SweepRecipe recipe;
  recipe.kind = SweepKind::parallel;
  recipe.frames = 160;
  recipe.framesPerSecond = 40.0;
  recipe.extent_mm = 10.0;
  recipe.formation.depth_mm = 40.0;
  recipe.pixel_mm = 0.4;
  recipe.stations = {{.near_mm = {0.0, -60.0, -6.0}, .towards_mm = glm::dvec3(0.0, 0.0, -6.0)}};
  recipe.pulsating = true;
  recipe.ecg = true;
  const VirtualSweep sweep = recorded(patient, recipe);
  const auto poses = sweepPoses(sweep.sequence, &sweep.deviceSet);
  ASSERT_TRUE(poses.has_value()) << poses.error();
  const auto frames = posed(sweep.sequence, *poses);
  std::vector<double> times_s;
  std::vector<ImageView<const std::uint8_t>> images;
  for (std::size_t n = 0; n < frames.size(); ++n) {
    times_s.push_back(sweep.sequence.frames[n].time_s.value());
    images.push_back(frames[n].pixels);
  }
  const ReconstructOptions options{.spacing_mm = 0.4, .fillReach_mm = 3.0};
  const auto ungated = reconstruct(frames, options, noProgress());
  ASSERT_TRUE(ungated.has_value()) << ungated.error();
  const double blurred_mm = diameterIn(ungated->volume, kVessel_mm);

  const auto ecg = recordedSignal(sweep.sequence, fields::kEcg);
  ASSERT_TRUE(ecg.has_value()) << ecg.error();
  const auto byEcg = findHeartBeats(*ecg);
  ASSERT_TRUE(byEcg.has_value()) << byEcg.error();
  EXPECT_NEAR(byEcg->rate_perMin, 75.0, 2.0);
  const auto byImages = findCyclesInImages(images, times_s, {}, noProgress());
  ASSERT_TRUE(byImages.has_value()) << byImages.error();
  EXPECT_NEAR(byImages->rate_perMin, 75.0, 2.0);

  for (const auto& [name, cycles] : {std::pair<std::string, const Cycles*>{"ecg", &*byEcg}, {"images", &*byImages}}) {
    constexpr int kPhases = 10;
    const auto lists = framesOfPhase(phasesOf(*cycles, times_s), kPhases);
    ASSERT_TRUE(lists.has_value()) << lists.error();
    double worst_mm = 0.0, worstUngated_mm = 0.0;
    const auto grid = reconstructPhases(
        frames, *lists, options,
        [&](std::size_t phase, ReconstructResult gated) -> Result<void> {
          double truth_mm = kRest_mm;
          for (const std::size_t n : (*lists)[phase])
            truth_mm += kGrowth_mm * sweep.trueState[n].pulse / static_cast<double>((*lists)[phase].size());
          const double found_mm = diameterIn(gated.volume, kVessel_mm);
          EXPECT_NEAR(found_mm, truth_mm, 0.5) << name << ", phase " << phase;
          worst_mm = std::max(worst_mm, std::abs(found_mm - truth_mm));
          worstUngated_mm = std::max(worstUngated_mm, std::abs(blurred_mm - truth_mm));
          return {};
        },
        noProgress());
    ASSERT_TRUE(grid.has_value()) << grid.error();
    RecordProperty("gated_mm_" + name, std::to_string(worst_mm));
    RecordProperty("ungated_mm_" + name, std::to_string(worstUngated_mm));
    EXPECT_GT(worstUngated_mm, 1.0) << name;
  }
}

}  // namespace
}  // namespace ew::acquisition_truth_test
