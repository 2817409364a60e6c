#include <gtest/gtest.h>

#include "ew/core/quiet_progress.h"
#include "ew/library/case.h"
#include "ew/simulated_people/simulated_trainee.h"
#include "ew/tracking/fit_check.h"
#include "places.h"
#include "skins.h"

namespace ew::fit_trainees_test {
namespace {

LessonStep stepOf(const std::string& id, LessonTask task) {
  LessonStep step;
  step.id = step.title = id;
  step.task = std::move(task);
  return step;
}

/// A trunk of 120 mm with a ball of 12 mm below its skin, and steps that let people search, sweep and look about.
struct TrunkToLearnOn {
  Lesson lesson;
  TraineeCase on;
};

TrunkToLearnOn trunk() {
  TeachingCase teaching;
  teaching.skin = std::make_shared<test::CylinderSkin>(120.0);
  auto labels = std::make_shared<Volume>();
  labels->grid.dims = {120, 60, 100};
  labels->grid.spacing_mm = glm::dvec3(2.0);
  labels->grid.origin_mm = {-119.0, -129.0, -99.0};
  labels->echo.assign(labels->grid.voxelCount(), 0);
  for (int k = 0; k < 100; ++k)
    for (int j = 0; j < 60; ++j)
      for (int i = 0; i < 120; ++i)
        if (glm::distance(carried(labels->grid.voxelToWorld(), glm::dvec3(i, j, k)), glm::dvec3(-30.0, -70.0, 20.0)) < 12.0)
          labels->echo[labels->grid.indexOf(i, j, k)] = 1;
  teaching.labels = labels;
  teaching.region.placedGrid = labels->grid;
  teaching.probe = *readProbe(std::filesystem::path(EW_SOURCE_DIR) / "resources" / "probes" / "convex-3.5.json");
  teaching.opened.id = "trunk";
  teaching.opened.probes = {"convex-3.5"};
  teaching.opened.scene.contact.emplace();
  const auto poseAt = [&](const glm::dvec3& near_mm) {
    Hold hold;
    hold.contact = teaching.skin->nearest(near_mm);
    return poseOf(hold);
  };
  teaching.opened.startPose = poseAt({40.0, -200.0, -20.0});
  ReferencePlane plane;
  plane.name = "across the ball";
  plane.probeToWorld = poseAt({-30.0, -500.0, 20.0}).probeToWorld;
  teaching.truth.planes = {plane};
  teaching.truth.structures = {{"ball", "ball", 1}};
  Lesson lesson;
  lesson.id = lesson.title = "trunk";
  lesson.steps = {stepOf("plane", PlaneTask{"across the ball", {}, {}}), stepOf("sweep", SweepTask{"ball", 0.9}),
                  stepOf("point", PointTask{"ball"}), stepOf("free", FreeTask{20.0, {"across the ball", "ball"}})};
  lesson.steps[3].time_s = 60.0;
  teaching.opened.otherFields["parts"]["lessons"] = jsonOf(std::vector<Lesson>{lesson});
  auto made = TraineeCase::of(teaching, noProgress());
  if (!made) throw std::runtime_error(made.error().sentence());
  return {lesson, *std::move(made)};
}

/// How often a person's scans make the check speak, of all steps that were scanned in.
struct Spoken {
  int steps = 0, told = 0;
  double seconds = 0.0;
};

Spoken spokenOver(const TrunkToLearnOn& world, const glm::dvec3& off_mm) {
  Spoken spoken;
  for (const SkillLevel level : {SkillLevel::novice, SkillLevel::intermediate, SkillLevel::expert})
    for (std::uint64_t seed = 1; seed <= 4; ++seed)
      for (const SimulatedStep& step :
           simulateAttempt(world.lesson, world.on, personOf(level, seed), seed, {.rate_hz = 30.0, .shortest_s = 120.0})) {
        if (step.log.frameCount() == 0) continue;
        FitCheck check;
        bool told = false;
        for (std::size_t n = 0; n < step.log.frameCount(); ++n) {
          Pose pose = step.log.frame(n).pose;
          pose.time_s = step.log.frameTime_s(n);
          pose.probeToWorld.matrix[3] += glm::dvec4(off_mm, 0.0);
          check.add(pose, *world.on.teaching().skin, true);
          told = told || !check.problem().empty();
        }
        ++spoken.steps;
        spoken.told += told ? 1 : 0;
        spoken.seconds += step.log.frameTime_s(step.log.frameCount() - 1) - step.log.frameTime_s(0);
      }
  return spoken;
}

TEST(FitOfACalibration, SimulatedTraineesHearNothingUnlessTheBodyMoved) {
  const TrunkToLearnOn world = trunk();
  const Spoken good = spokenOver(world, glm::dvec3(0.0));
  EXPECT_EQ(good.told, 0);
  EXPECT_GT(good.seconds, 600.0) << "enough to say something";
  const Spoken off = spokenOver(world, {0.0, -12.0, 0.0});
  EXPECT_GT(off.told, off.steps / 4);
  RecordProperty("seconds", static_cast<int>(good.seconds));
  RecordProperty("steps", good.steps);
  RecordProperty("told_of_steps_when_off_by_12_mm", off.told);
}

}  // namespace
}  // namespace ew::fit_trainees_test
