#include "scanner/record_sweep.h"

#include <gtest/gtest.h>

#include <map>
#include <numbers>
#include <thread>

#include "counted_stop.h"
#include "ew/acquisition/reconstruct.h"
#include "ew/core/numbers.h"
#include "ew/io/gating_fields.h"
#include "ew/io/sweep.h"
#include "sweeps.h"

namespace ew::record_sweep_test {
namespace {

using testing::ballPatient;
using testing::shippedProbe;
using testing::Thread;
using testing::ThreadScanner;

const std::vector<Thread> kThreads = {{{-12, -30, 0}, glm::normalize(glm::dvec3(0.2, 0.1, 1))},
                                      {{10, -22, 0}, glm::normalize(glm::dvec3(-0.3, -0.1, 1))},
                                      {{0, -12, 0}, glm::normalize(glm::dvec3(1, 0, 0.6))}};

Probe coarse(const std::string& id, int lines = 96) {
  Probe probe = shippedProbe(id);
  probe.lines = lines;
  return probe;
}

SweepRecipe sweepOf(SweepKind kind) {
  SweepRecipe recipe;
  recipe.name = "test";
  recipe.kind = kind;
  recipe.frames = 9;
  recipe.framesPerSecond = 20.0;
  recipe.formation.depth_mm = 60.0;
  recipe.pixel_mm = 0.25;
  recipe.stations = {{.near_mm = {0, -60, kind == SweepKind::parallel ? -10.0 : 0.0},
                      .towards_mm = glm::dvec3(0, 0, kind == SweepKind::parallel ? -10.0 : 0.0)}};
  if (kind == SweepKind::freehand) {
    recipe.stations = {{.near_mm = {-5, -60, -10}, .lateral = {1, 0, 0.2}},
                       {.near_mm = {0, -60, 0}, .towards_mm = glm::dvec3(4, 0, 3)},
                       {.near_mm = {6, -60, 10}}};
    recipe.unevenness = 1.0;
  }
  if (kind == SweepKind::parallel) recipe.extent_mm = 20.0;
  if (kind == SweepKind::fan) recipe.extent_deg = 30.0, recipe.axisBehindFace_mm = 10.0;
  if (kind == SweepKind::rotational) recipe.extent_deg = 90.0;
  return recipe;
}

Result<VirtualSweep> record(const Probe& probe, const SweepRecipe& recipe, int threads = 0, Progress& progress = noProgress(),
                            const Patient* patient = nullptr) {
  static const auto ball = ballPatient();
  const ThreadScanner scanner(probe, recipe.formation.depth_mm, kThreads);
  return phantom::recordWith(scanner, patient != nullptr ? *patient : *ball, recipe, threads, progress, 1ull << 30);
}

VirtualSweep recorded(const Probe& probe, const SweepRecipe& recipe) {
  auto sweep = record(probe, recipe);
  if (!sweep) {
    ADD_FAILURE() << sweep.error();
    std::abort();
  }
  return *std::move(sweep);
}

/// Where threads are seen in the images, in the world: the centre of gravity of each bright spot, one a thread and frame, found near where
/// the thread crosses the true image plane, and the distance of that spot to the thread.
struct Seen {
  int spots = 0;
  double worst_mm = 0.0;
};
Seen look(const VirtualSweep& sweep, const std::vector<std::optional<Transform<frame::World, frame::Image>>>& imageToWorld) {
  Seen seen;
  for (std::size_t n = 0; n < imageToWorld.size(); ++n) {
    if (!imageToWorld[n]) continue;
    const auto pixels = sweep.sequence.framePixels(n);
    const auto trueImageToWorld = sweep.trueProbeToWorld[n].matrix * sweep.imageToProbe;
    for (const Thread& thread : kThreads) {
      // The crossing of thread and true image plane, in pixels.
      const glm::dvec3 at = glm::inverse(trueImageToWorld) * glm::dvec4(thread.at_mm, 1.0);
      const glm::dvec3 along = glm::inverse(trueImageToWorld) * glm::dvec4(thread.along, 0.0);
      if (std::abs(along.z) < 0.5 * glm::length(along)) continue;  // too slanting for a spot
      const glm::dvec2 cross = glm::dvec2(at) - at.z / along.z * glm::dvec2(along);
      const glm::ivec2 centre(glm::round(cross));
      const int reach = 6;
      if (centre.x < reach || centre.y < reach || centre.x >= sweep.sequence.width - reach || centre.y >= sweep.sequence.height - reach)
        continue;
      double sum = 0.0;
      glm::dvec2 mean(0.0);
      bool atEdge = false;
      for (int y = centre.y - reach; y <= centre.y + reach; ++y) {
        for (int x = centre.x - reach; x <= centre.x + reach; ++x) {
          const auto level =
              pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(sweep.sequence.width) + static_cast<std::size_t>(x)];
          // Amplitude, from decibels.
          const double weight = level > 0 ? std::pow(10.0, (level - 255.0) / 255.0 * 60.0 / 20.0) : 0.0;
          atEdge = atEdge || (weight > 0.2 && (std::abs(x - centre.x) == reach || std::abs(y - centre.y) == reach));
          sum += weight;
          mean += weight * glm::dvec2(x, y);
        }
      }
      if (sum < 1.0 || atEdge) continue;  // outside the fan, or the next thread beside it
      const glm::dvec3 world = imageToWorld[n]->matrix * glm::dvec4(mean / sum, 0.0, 1.0);
      ++seen.spots;
      seen.worst_mm = std::max(seen.worst_mm, thread.distance_mm(world));
    }
  }
  return seen;
}

TEST(RecordSweep, BrightSpotsLieOnTheThreadsThroughTheWrittenPoses) {
  for (const char* id : {"linear-7.5", "convex-3.5", "endocavity-6.5", "swept-sector-3.5"}) {
    for (const auto kind : {SweepKind::freehand, SweepKind::parallel, SweepKind::fan, SweepKind::rotational}) {
      auto recipe = sweepOf(kind);
      const Probe probe = coarse(id, 192);
      recipe.formation.depth_mm = std::clamp(60.0, probe.minDepth_mm, probe.maxDepth_mm);
      const auto sweep = recorded(probe, recipe);
      const auto poses = sweepPoses(sweep.sequence);
      ASSERT_TRUE(poses) << poses.error();
      EXPECT_EQ(poses->toFrame, "Reference");
      EXPECT_EQ(poses->usable, 9u);
      const Seen seen = look(sweep, poses->imageToWorld);
      EXPECT_GE(seen.spots, 4) << id << " " << static_cast<int>(kind);
      EXPECT_LT(seen.worst_mm, 0.5 * recipe.pixel_mm) << id << " " << static_cast<int>(kind);
      // The device set beside it says the same.
      const auto calibrated = sweepPoses(sweep.sequence, &sweep.deviceSet);
      ASSERT_TRUE(calibrated);
      EXPECT_EQ(calibrated->imageToWorld, poses->imageToWorld);
    }
  }
}

TEST(RecordSweep, PixelsHaveTheCalibrationInClosedForm) {
  auto recipe = sweepOf(SweepKind::freehand);
  const auto sweep = recorded(coarse("convex-3.5"), recipe);
  const Probe probe = coarse("convex-3.5");
  // The face's foremost point, and the ends of the face beside it.
  const int width = sweep.sequence.width;
  const glm::dmat4 pixelToProbe = sweep.imageToProbe;
  EXPECT_EQ(width % 2, 1);
  EXPECT_NEAR(glm::distance(glm::dvec3(pixelToProbe * glm::dvec4(0.5 * (width - 1), 0, 0, 1)).x, 0.0), 0.0, 1e-9);
  EXPECT_EQ(pixelToProbe[0], glm::dvec4(0.25, 0, 0, 0)) << "x towards the marker";
  EXPECT_EQ(pixelToProbe[1], glm::dvec4(0, 0.25, 0, 0)) << "y away from the probe";
  EXPECT_NEAR(glm::determinant(glm::dmat3(pixelToProbe)), 0.25 * 0.25 * 0.25, 1e-12);
  const auto& set = sweep.deviceSet;
  ASSERT_TRUE(set.fanOrigin_px && set.fanAngles_deg && set.fanRadiusStart_px && set.fanRadiusStop_px);
  const glm::dvec4 apex = pixelToProbe * glm::dvec4(*set.fanOrigin_px, 0, 1);
  EXPECT_NEAR(glm::distance(apex, glm::dvec4(0, -probe.radius_mm, 0, 1)), 0.0, 1e-9);
  EXPECT_NEAR(*set.fanRadiusStart_px, probe.radius_mm / 0.25, 1e-9);
  EXPECT_NEAR(*set.fanRadiusStop_px, (probe.radius_mm + 60.0) / 0.25, 1e-9);
  EXPECT_NEAR(set.fanAngles_deg->y, 31.0, 1e-9);
  EXPECT_NEAR(set.fanAngles_deg->x, -31.0, 1e-9);
  // Pixels are image exactly inside the fan of the device set.
  const auto pixels = sweep.sequence.framePixels(0);
  int wrong = 0;
  for (int y = 0; y < sweep.sequence.height; ++y) {
    for (int x = 0; x < width; ++x) {
      const glm::dvec2 from = glm::dvec2(x, y) - *set.fanOrigin_px;
      const double radius = glm::length(from), angle = std::atan2(from.x, from.y) * 180.0 / std::numbers::pi;
      const bool outside = radius < *set.fanRadiusStart_px - 1e-6 || radius > *set.fanRadiusStop_px + 1e-6 || std::abs(angle) > 31.0 + 1e-6;
      wrong += outside && pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)] > 0 ? 1 : 0;
    }
  }
  EXPECT_EQ(wrong, 0);
}

TEST(RecordSweep, ACalibrationErrorMovesTheWrittenPlaceAndNothingElse) {
  auto recipe = sweepOf(SweepKind::parallel);
  const Probe probe = coarse("linear-7.5");
  const auto good = recorded(probe, recipe);
  recipe.tracker.calibrationError[3] = glm::dvec4(2, -1, 0.5, 1);
  const auto off = recorded(probe, recipe);
  EXPECT_EQ(off.sequence.pixels, good.sequence.pixels);
  EXPECT_EQ(off.imageToProbe, good.imageToProbe);
  const auto poses = sweepPoses(off.sequence), truth = sweepPoses(good.sequence);
  ASSERT_TRUE(poses && truth);
  const auto rotation = glm::dmat3(off.trueProbeToWorld[0].matrix);
  const glm::dvec3 moved = glm::dvec3(poses->imageToWorld[0]->matrix[3] - truth->imageToWorld[0]->matrix[3]);
  EXPECT_NEAR(glm::distance(moved, rotation * glm::dvec3(2, -1, 0.5)), 0.0, 1e-9);
}

TEST(RecordSweep, LostPosesAreInvalidAndCounted) {
  auto recipe = sweepOf(SweepKind::parallel);
  recipe.frames = 40;
  recipe.tracker.dropOutShare = 0.3;
  const auto sweep = recorded(coarse("linear-7.5", 16), recipe);
  const auto poses = sweepPoses(sweep.sequence);
  ASSERT_TRUE(poses) << poses.error();
  EXPECT_EQ(poses->invalid, 12u);
  EXPECT_EQ(poses->usable, 28u);
  EXPECT_EQ(poses->missing, 0u);
  recipe.tracker.dropOutShare = 1.0;
  EXPECT_EQ(sweepPoses(recorded(coarse("linear-7.5", 16), recipe).sequence).error().code, ErrorCode::noValidPose);
}

TEST(RecordSweep, APressedInProbeSeesTissueWhereItWasPushedTo) {
  // Threads are drawn at rest; the image shows them pushed away from the face by the pressure there.
  auto recipe = sweepOf(SweepKind::parallel);
  recipe.frames = 1;
  recipe.stations[0] = {.near_mm = {0, -60, 0}};
  const Probe probe = coarse("convex-3.5", 192);
  const auto row = [&](const VirtualSweep& sweep) {
    // Depth of the brightest pixel in the columns of the second thread, in mm below the resting skin.
    const auto imageToWorld = sweep.trueProbeToWorld[0].matrix * sweep.imageToProbe;
    const auto pixels = sweep.sequence.framePixels(0);
    int best = 0;
    double y_mm = 0.0;
    for (int y = 0; y < sweep.sequence.height; ++y) {
      for (int x = 0; x < sweep.sequence.width; ++x) {
        const glm::dvec4 at = imageToWorld * glm::dvec4(x, y, 0, 1);
        const auto level =
            pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(sweep.sequence.width) + static_cast<std::size_t>(x)];
        if (std::abs(at.x - 10.0) < 1.0 && level > best) best = level, y_mm = at.y;
      }
    }
    return y_mm;
  };
  const double resting = row(recorded(probe, recipe));
  recipe.indentation_mm = 6.0;
  const double pressed = row(recorded(probe, recipe));
  EXPECT_NEAR(resting, -22.0, 0.25);
  EXPECT_GT(pressed, resting + 0.5);
  EXPECT_LT(pressed, resting + 4.0);
}

TEST(RecordSweep, IsTheSameOnAnyNumberOfThreads) {
  auto recipe = sweepOf(SweepKind::freehand);
  recipe.indentation_mm = 2.0;
  recipe.tracker = {.noise_mm = 0.2, .noise_deg = 0.3, .jitter_s = 0.002, .latency_s = 0.05, .dropOutShare = 0.2};
  const Probe probe = coarse("convex-3.5", 32);
  const auto one = record(probe, recipe, 1);
  ASSERT_TRUE(one) << one.error();
  for (const int threads : {2, 8}) {
    const auto more = record(probe, recipe, threads);
    ASSERT_TRUE(more);
    EXPECT_EQ(more->sequence.pixels, one->sequence.pixels);
    EXPECT_EQ(more->sequence.frames, one->sequence.frames);
    EXPECT_EQ(more->sequence.otherFields, one->sequence.otherFields);
    EXPECT_EQ(more->trueProbeToWorld, one->trueProbeToWorld);
  }
}

TEST(RecordSweep, ScanLinesSayWhereTheyLie) {
  auto recipe = sweepOf(SweepKind::parallel);
  recipe.scanLines = true;
  recipe.pixel_mm = 0.2;
  recipe.frames = 2;
  const Probe probe = coarse("convex-3.5", 192);
  const auto sweep = recorded(probe, recipe);
  EXPECT_EQ(sweep.sequence.orientation, "FM");
  EXPECT_EQ(sweep.sequence.imageType, "BRIGHTNESS");
  EXPECT_EQ(sweep.sequence.height, 192);
  EXPECT_EQ(sweep.sequence.width, 301);
  std::map<std::string, std::string> fields(sweep.sequence.otherFields.begin(), sweep.sequence.otherFields.end());
  const auto number = [&](std::string_view name) { return parseNumber(fields[std::string(name)]).value(); };
  EXPECT_EQ(fields[std::string(fields::kTransducerGeometry)], "CURVILINEAR");
  // The brightest sample, placed by the fields alone, lies on a thread.
  const double start = number(fields::kRadiusStart), stop = number(fields::kRadiusStop);
  const double from = number(fields::kThetaStart), to = number(fields::kThetaStop);
  const auto pixels = sweep.sequence.framePixels(0);
  int spots = 0;
  for (int line = 0; line < 192; ++line) {
    for (int s = 0; s < 301; ++s) {
      if (pixels[static_cast<std::size_t>(line * 301 + s)] < 250) continue;
      const double radius = start + (stop - start) * s / 300.0, angle = (from + (to - from) * line / 191.0) * std::numbers::pi / 180.0;
      const glm::dvec3 p_probe(radius * std::sin(angle), radius * std::cos(angle) - start, 0.0);
      const glm::dvec3 world = sweep.trueProbeToWorld[0].matrix * glm::dvec4(p_probe, 1.0);
      double nearest = 1e9;
      for (const Thread& thread : kThreads) nearest = std::min(nearest, thread.distance_mm(world));
      EXPECT_LT(nearest, 0.5 * std::sqrt(2.0 * std::log(10.0) * 5.0 / 255.0 * 3.0) + 0.1);  // 250 of 255 at a blur of 0.5 mm
      ++spots;
    }
  }
  EXPECT_GT(spots, 5);
}

TEST(RecordSweep, MotorsTellTheirPositions) {
  const auto sweep = recorded(coarse("convex-3.5", 16), sweepOf(SweepKind::fan));
  std::map<std::string, std::string> fields(sweep.sequence.otherFields.begin(), sweep.sequence.otherFields.end());
  EXPECT_EQ(fields[std::string(fields::kMotorKind)], "FAN");
  EXPECT_EQ(fields[std::string(fields::kMotorAxisBehindFace)], "10");
  for (std::size_t n = 0; n < 9; ++n) {
    const auto& other = sweep.sequence.frames[n].otherFields;
    const auto found = std::find_if(other.begin(), other.end(), [](const auto& field) { return field.first == fields::kMotorAngle; });
    ASSERT_NE(found, other.end());
    EXPECT_NEAR(parseNumber(found->second).value(), -15.0 + 30.0 / 8.0 * static_cast<double>(n), 1e-9);
  }
}

TEST(RecordSweep, SurvivesItsFile) {
  const testing::Folder folder;
  auto recipe = sweepOf(SweepKind::fan);
  recipe.tracker = {.noise_mm = 0.2, .jitter_s = 0.002, .dropOutShare = 0.3};
  const auto sweep = recorded(coarse("linear-7.5", 32), recipe);
  ASSERT_TRUE(writeSequence(sweep.sequence, folder.path() / "s.igs.mha"));
  const auto read = readSequence(folder.path() / "s.igs.mha");
  ASSERT_TRUE(read) << read.error();
  EXPECT_EQ(read->pixels, sweep.sequence.pixels);
  EXPECT_EQ(read->frames, sweep.sequence.frames);
  EXPECT_EQ(read->orientation, "MF");
  ASSERT_TRUE(writeDeviceSet(sweep.deviceSet, folder.path() / "d.xml"));
  const auto set = readDeviceSet(folder.path() / "d.xml");
  ASSERT_TRUE(set) << set.error();
  EXPECT_EQ(set->transforms, sweep.deviceSet.transforms);
  EXPECT_EQ(set->clipOrigin_px, sweep.deviceSet.clipOrigin_px);
  EXPECT_EQ(set->clipSize_px, sweep.deviceSet.clipSize_px);
}

TEST(RecordSweep, StopsAtItsNextQuestion) {
  auto recipe = sweepOf(SweepKind::freehand);
  recipe.frames = 2000;
  for (const int question : {1, 5, 40, 200}) {
    auto progress = test::CountedStop::atQuestion(question);
    const auto sweep = record(coarse("convex-3.5", 32), recipe, 2, progress);
    ASSERT_FALSE(sweep) << question;
    EXPECT_EQ(sweep.error().code, ErrorCode::cancelled);
    EXPECT_LE(progress.questionsAfter(), test::kMostQuestionsAfter) << question;
    EXPECT_LE(progress.reportsAfter(), test::kMostReportsAfter) << question;
  }
}

TEST(RecordSweep, RefusesWhatDoesNotFitBeforeItBegins) {
  auto recipe = sweepOf(SweepKind::freehand);
  const ThreadScanner scanner(coarse("convex-3.5"), 60.0, kThreads);
  const auto patient = ballPatient();
  const auto refused = phantom::recordWith(scanner, *patient, recipe, 1, noProgress(), 100000);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::tooLarge);
  recipe.pixel_mm = 0.001;
  EXPECT_EQ(forecastSweep(*patient, scanner.probe(), recipe).error().code, ErrorCode::tooLarge);
  recipe = sweepOf(SweepKind::freehand);
  recipe.formation.depth_mm = 500.0;
  EXPECT_EQ(forecastSweep(*patient, scanner.probe(), recipe).error().code, ErrorCode::badField);
  recipe = sweepOf(SweepKind::freehand);
  recipe.breathing = true;
  EXPECT_EQ(forecastSweep(*patient, scanner.probe(), recipe).error().code, ErrorCode::badField);
  const auto forecast = forecastSweep(*patient, scanner.probe(), sweepOf(SweepKind::freehand));
  ASSERT_TRUE(forecast);
  const auto sweep = recorded(scanner.probe(), sweepOf(SweepKind::freehand));
  EXPECT_EQ(forecast->width_px, sweep.sequence.width);
  EXPECT_EQ(forecast->height_px, sweep.sequence.height);
  EXPECT_GT(forecast->bytes, sweep.sequence.pixels.size());
}

}  // namespace
}  // namespace ew::record_sweep_test
