#pragma once

#include <functional>
#include <glm/gtc/matrix_transform.hpp>

#include "ew/assessment/attempt_scoring.h"
#include "ew/io/volume_file.h"
#include "ew/library/case.h"
#include "ew/library/learning_progress.h"
#include "ew/library/step_answer.h"
#include "library/temporary_folder.h"

namespace ew::test {

/// A probe of 60 mm that looks along the world's +y from y = -40 at z, tilted about its own x.
inline Transform<frame::World, frame::Probe> heldAt(double z_mm = 0.0, double tilt_deg = 0.0, double x_mm = 0.0) {
  glm::dmat4 pose(1.0);
  const double c = std::cos(glm::radians(tilt_deg)), s = std::sin(glm::radians(tilt_deg));
  pose[1] = {0.0, c, s, 0.0};
  pose[2] = {0.0, -s, c, 0.0};
  pose[3] = {x_mm, -40.0, z_mm, 1.0};
  return {pose};
}

inline ScanState imageAt(const Transform<frame::World, frame::Probe>& probeToWorld, double time_s = 0.0) {
  ScanState state;
  state.probe.id = "linear-7.5";
  state.probe.name = "Linear";
  state.probe.kind = ProbeKind::linear;
  state.probe.width_mm = 60.0;
  state.probe.maxDepth_mm = 120.0;
  state.knobs.depth_mm = 80.0;
  state.pose.probeToWorld = probeToWorld;
  state.time_s = state.pose.time_s = time_s;
  return state;
}

/// A scan of even images along a path.
inline ScanLog scanAlong(const std::function<Transform<frame::World, frame::Probe>(double time_s)>& path, double seconds,
                         double rate_hz = 20.0, double begin_s = 0.0) {
  ScanLog log;
  const auto count = static_cast<int>(std::lround(seconds * rate_hz));
  for (int n = 0; n <= count; ++n) {
    ScanState image = imageAt(path(n / rate_hz), begin_s + n / rate_hz);
    image.number = static_cast<std::uint64_t>(n);
    log.addFrame(image);
  }
  return log;
}

/// A library with the case "ball": a ball of 20 mm with the label 7 about (0, 0, 0) in a box of 80 mm, and a lesson with a step of each
/// kind that is judged.
class AssessedWorld {
 public:
  AssessedWorld() : cache_("ECHOWEAVE_CACHE", folder_ / "cache"), library_("ECHOWEAVE_LIBRARY", folder_ / "library") { makeCase(); }

  [[nodiscard]] std::filesystem::path library() const { return folder_ / "library"; }
  [[nodiscard]] std::filesystem::path caseFolder() const { return library() / "cases" / "ball"; }
  [[nodiscard]] const Lesson& lesson() const { return lesson_; }

  /// Changes the lesson of the case on disk.
  void teach(Lesson lesson) {
    lesson_ = std::move(lesson);
    auto opened = loadCase(caseFolder());
    ASSERT_TRUE(opened) << opened.error();
    opened->otherFields["parts"]["lessons"] = jsonOf(std::vector<Lesson>{lesson_});
    const auto saved = saveCase(*opened, caseFolder());
    ASSERT_TRUE(saved) << saved.error();
  }

  struct Tried {
    std::string step;
    std::optional<ScanLog> scan = {};
    StepAnswer answer = {};
    double seconds = 10.0;
    StepVerdict verdict = StepVerdict::failed;
    double score = 0.0;  ///< as the lesson said
  };
  /// An attempt on disk. @return its folder
  std::filesystem::path keep(const std::string& id, const std::vector<Tried>& steps) const {
    Attempt attempt;
    attempt.id = id;
    attempt.caseId = "ball";
    attempt.lessonId = lesson_.id;
    attempt.lessonTitle = lesson_.title;
    attempt.lessonContent = contentOf(lesson_);
    attempt.person = "Somebody";
    auto kept = AttemptFolder::begin(attemptsFolder(library()), attempt);
    EXPECT_TRUE(kept) << kept.error();
    for (const Tried& tried : steps) {
      StepOutcome outcome;
      outcome.stepId = tried.step;
      outcome.verdict = tried.verdict;
      outcome.score = tried.score;
      outcome.seconds = tried.seconds;
      outcome.answer = tried.answer;
      if (tried.scan) {
        outcome.recording = kept->nameForFile(tried.step, ".seq.mha");
        EXPECT_TRUE(writeRecording({"ball", "Ball", {640, 480}, *tried.scan, {}}, kept->folder() / outcome.recording));
      }
      EXPECT_TRUE(kept->endStep(outcome));
    }
    EXPECT_TRUE(kept->finish({}));
    return kept->folder();
  }

  [[nodiscard]] std::shared_ptr<const LessonGround> ground() const {
    auto made = lessonGroundOf("ball", lesson_.id, contentOf(lesson_), library());
    EXPECT_TRUE(made) << made.error();
    return made ? *made : nullptr;
  }

 private:
  void makeCase() {
    Volume volume;
    volume.grid.dims = glm::ivec3(41);
    volume.grid.spacing_mm = glm::dvec3(2.0);
    volume.grid.origin_mm = glm::dvec3(-40.0);
    volume.echo.assign(volume.grid.voxelCount(), 60);
    Volume labels = volume;
    for (int k = 0; k < 41; ++k)
      for (int j = 0; j < 41; ++j)
        for (int i = 0; i < 41; ++i)
          labels.echo[labels.grid.indexOf(i, j, k)] = glm::length(glm::dvec3(i, j, k) * 2.0 - 40.0) <= 20.0 ? 7 : 0;
    std::filesystem::create_directories(caseFolder() / "volumes");
    ASSERT_TRUE(writeVolume(volume, caseFolder() / "volumes" / "ball.mha", noProgress()));
    ASSERT_TRUE(writeVolume(labels, caseFolder() / "volumes" / "labels.mha", noProgress()));
    Case made;
    made.id = "ball";
    made.title = "Ball";
    made.volume.file = "volumes/ball.mha";
    made.volume.labels = "volumes/labels.mha";
    CaseTarget plane{CaseTarget::Kind::plane, "middle"};
    plane.probeToFile = Transform<frame::File, frame::Probe>{heldAt().matrix};
    plane.positionTolerance_mm = 5.0;
    plane.angleTolerance_deg = 10.0;
    CaseTarget structure{CaseTarget::Kind::structure, "ball"};
    structure.label = 7;
    CaseTarget point{CaseTarget::Kind::point, "middle of the ball"};
    point.at_mm = glm::dvec3(0.0);
    point.tolerance_mm = 4.0;
    made.targets = {plane, structure, point};
    CaseMeasurement across{"ball, across"};
    across.value = 40.0;
    across.kind = "distance";
    across.unit = "mm";
    across.tolerance = 2.0;
    across.points_mm = {{-20.0, 0.0, 0.0}, {20.0, 0.0, 0.0}};
    made.measurements = {across};
    made.folder = caseFolder();
    const auto saved = saveCase(made, caseFolder());
    ASSERT_TRUE(saved) << saved.error();
    Lesson lesson;
    lesson.id = "about-balls";
    lesson.title = "About balls";
    for (const auto& [id, task] : {std::pair<const char*, LessonTask>{"read", ReadingTask{}},
                                   {"plane", PlaneTask{"middle", {}, {}}},
                                   {"sweep", SweepTask{"ball", 0.9}},
                                   {"measure", MeasureTask{"ball, across", {}}},
                                   {"point", PointTask{"middle of the ball"}},
                                   {"answer", AnswerTask{{{"a", true, ""}, {"b", false, ""}}, {}, 0.0, ""}},
                                   {"free", FreeTask{1.0, {"middle", "ball"}}}}) {
      LessonStep step;
      step.id = id;
      step.title = std::string("Step ") + id;
      step.text = "Do it.";
      step.task = task;
      lesson.steps.push_back(std::move(step));
    }
    teach(std::move(lesson));
  }

  TemporaryFolder folder_;
  EnvironmentValue cache_, library_;
  Lesson lesson_;
};

}  // namespace ew::test
