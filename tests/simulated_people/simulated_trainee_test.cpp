#include "ew/simulated_people/simulated_trainee.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <numeric>
#include <set>
#include <sstream>

#include "../counted_stop.h"
#include "../library/temporary_folder.h"
#include "../tracking/skins.h"
#include "ew/assessment/hand_path.h"
#include "ew/assessment/motion.h"
#include "ew/assessment/step_work.h"
#include "ew/library/step_answer.h"
#include "ew/scanning/contact.h"
#include "ew/simulated_people/skin_distance.h"
#include "places.h"

namespace ew {
namespace {

namespace fs = std::filesystem;

LessonStep stepOf(const std::string& id, LessonTask task) {
  LessonStep step;
  step.id = id;
  step.title = id;
  step.task = std::move(task);
  return step;
}

/// A trunk of 120 mm with a ball of 12 mm below its skin, and a lesson with a step of every kind.
class Trunk {
 public:
  explicit Trunk(std::shared_ptr<const Skin> skin = std::make_shared<test::CylinderSkin>(120.0)) {
    teaching_.skin = std::move(skin);
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
    teaching_.labels = labels;
    teaching_.region.placedGrid = labels->grid;
    const auto probe = readProbe(*resourceFolder() / "probes" / "convex-3.5.json");
    EXPECT_TRUE(probe) << probe.error().sentence();
    teaching_.probe = *probe;
    teaching_.opened.id = "trunk";
    teaching_.opened.probes = {"convex-3.5"};
    teaching_.opened.scene.contact.emplace();
    teaching_.opened.startPose = poseAt({40.0, -200.0, -20.0});
    addTruth();
    addLesson();
  }

  [[nodiscard]] Pose poseAt(const glm::dvec3& near_mm) const {
    Hold hold;
    hold.contact = teaching_.skin->nearest(near_mm);
    return poseOf(hold);
  }
  [[nodiscard]] TraineeCase made() {
    teaching_.opened.otherFields["parts"]["lessons"] = jsonOf(std::vector<Lesson>{lesson_});
    auto made = TraineeCase::of(teaching_, noProgress());
    EXPECT_TRUE(made) << made.error().sentence();
    return *std::move(made);
  }
  Lesson& lesson() { return lesson_; }
  TeachingCase& teaching() { return teaching_; }

 private:
  void addTruth() {
    ReferencePlane plane;
    plane.name = "across the ball";
    plane.probeToWorld = poseAt({-30.0, -500.0, 20.0}).probeToWorld;
    CaseTruth& truth = teaching_.truth;
    truth.planes = {plane};
    truth.structures = {{"ball", "ball", 1}};
    truth.points = {{"middle", {-30.0, -70.0, 20.0}, 10.0}};
    // In the plane across: the ball's middle lies in it, and so does the plane's lateral axis.
    const glm::dvec3 x(plane.probeToWorld.matrix[0]), middle_mm(-30.0, -70.0, 20.0);
    truth.measurements = {{"width", "distance", 24.0, "mm", 3.0, {middle_mm - 12.0 * x, middle_mm + 12.0 * x}, plane.name},
                          {"volume", "volume", 7.24, "ml", 1.0, {}, plane.name}};
  }
  void addLesson() {
    lesson_.id = "all-kinds";
    lesson_.title = "All kinds";
    AnswerTask choice;
    choice.options = {{"a", false, ""}, {"b", true, ""}, {"c", false, ""}, {"d", true, ""}};
    AnswerTask number;
    number.number = 24.0;
    number.tolerance = 2.0;
    number.unit = "mm";
    lesson_.steps = {stepOf("read", ReadingTask{}),
                     stepOf("watch", WatchTask{}),
                     stepOf("settings", SettingsTask{{}, {{"depth_mm", 120.0, 160.0}, {"gain_db", 4.0, 8.0}, {"focus_mm", 40.0, 60.0}}}),
                     stepOf("plane", PlaneTask{"across the ball", {}, {}}),
                     stepOf("sweep", SweepTask{"ball", 0.9}),
                     stepOf("point", PointTask{"ball"}),
                     stepOf("middle", PointTask{"middle"}),
                     stepOf("width", MeasureTask{"width", {}}),
                     stepOf("volume", MeasureTask{"volume", {}}),
                     stepOf("choice", choice),
                     stepOf("number", number),
                     stepOf("free", FreeTask{20.0, {"across the ball", "ball"}})};
    lesson_.steps[3].text = std::string(90, 'x');  // five seconds to read
    lesson_.steps[3].hints = {"one", "two"};
    lesson_.steps[11].time_s = 60.0;
  }

  TeachingCase teaching_;
  Lesson lesson_;
};

StepOutcome judgedOf(const LessonStep& step, const SimulatedStep& made, const TraineeCase& on) {
  auto work = workOf(step, on.ground());
  EXPECT_TRUE(work) << work.error().sentence();
  StepOutcome outcome;
  if (!work) return outcome;
  for (std::size_t n = 0; n < made.log.frameCount(); ++n) (*work)->see(made.log.frame(n));
  outcome.result() = (*work)->judge(made.answer);
  return outcome;
}

glm::dvec3 faceOf(const ScanState& image) { return glm::dvec3(image.pose.probeToWorld.matrix[3]); }

std::string bytesOf(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

bool areSame(const std::vector<SimulatedStep>& a, const std::vector<SimulatedStep>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const SimulatedStep& one, const SimulatedStep& other) {
    return one.stepId == other.stepId && one.answer == other.answer && one.seconds == other.seconds && one.hints == other.hints &&
           one.log.events() == other.log.events();
  });
}

double meanOf(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

TEST(SkinDistance, IsThatOfTheSkinWithinHundredthsOfAMillimetre) {
  const auto skin = std::make_shared<const test::SphereSkin>(25.0);
  const SkinDistance distance(skin);
  for (int n = 0; n < 500; ++n) {
    const double height_mm = -15.0 + 0.06 * n, turn = 0.7 * n, fall = std::cos(0.3 * n);
    const glm::dvec3 direction(std::sqrt(1.0 - fall * fall) * glm::dvec2(std::cos(turn), std::sin(turn)), fall);
    EXPECT_NEAR(distance.at_mm((25.0 + height_mm) * direction), height_mm, height_mm > -5.0 ? 0.08 : 0.2) << n;
  }
  EXPECT_NEAR(SkinDistance(std::make_shared<const test::PlaneSkin>()).at_mm({3.3, -1234.5, 7.1}), 7.1, 1e-5);
}

TEST(TraineeHabits, StandBetweenNovicesAndExpertsAndOverlap) {
  const TraineeHabits novice = habitsOf(SkillLevel::novice), expert = habitsOf(SkillLevel::expert);
  const TraineeHabits between = habitsOf(SkillLevel::intermediate);
  const TraineeHabits faultless;
  std::set<double TraineeHabits::*> seen;
  for (const HabitRange& each : habitRanges()) {
    SCOPED_TRACE(each.name);
    EXPECT_NEAR(novice.*each.member, each.novice, 1e-12);
    EXPECT_NEAR(expert.*each.member, each.expert, 1e-12);
    const double sign = each.moreIsWorse ? 1.0 : -1.0;
    EXPECT_GE(sign * (novice.*each.member), sign * (between.*each.member) - 1e-12);
    EXPECT_GE(sign * (between.*each.member), sign * (expert.*each.member) - 1e-12);
    int better = 0;  // novices who are better at this than the median expert
    for (std::uint64_t seed = 0; seed < 400; ++seed)
      better += sign * (personOf(SkillLevel::novice, seed).*each.member) < sign * each.expert ? 1 : 0;
    EXPECT_GE(better, 4) << "of 400";
    EXPECT_LE(better, 240) << "of 400";
  }
  EXPECT_EQ(personOf(SkillLevel::novice, 5), personOf(SkillLevel::novice, 5));
  EXPECT_NE(personOf(SkillLevel::novice, 5), personOf(SkillLevel::novice, 6));
  EXPECT_EQ(onOneDay(faultless, 1).planeError_mm, 0.0);
}

TEST(TraineeHabits, AreAllVariedByTheModel) {
  // Whoever adds a habit and forgets its range would leave it without an error at all levels.
  EXPECT_EQ(habitRanges().size() * sizeof(double), sizeof(TraineeHabits));
}

TEST(TraineeHabits, AreWrittenDown) {
  const std::string page = bytesOf(fs::path(EW_SOURCE_DIR) / "resources/docs/science/simulated-trainees.md");
  for (const HabitRange& each : habitRanges()) {
    std::ostringstream numbers;
    numbers << " | " << each.novice << " | " << each.expert << " | " << each.personSpread << " | ";
    const std::size_t row = page.find("| " + std::string(each.name) + " | ");
    ASSERT_NE(row, std::string::npos) << each.name;
    EXPECT_NE(page.substr(row, page.find('\n', row) - row).find(numbers.str()), std::string::npos) << each.name << numbers.str();
  }
}

TEST(SimulatedTrainee, LeavesTheSameBytesForTheSameSeed) {
  Trunk trunk;
  const TraineeCase on = trunk.made();
  const TraineeHabits person = personOf(SkillLevel::novice, 3);
  const auto steps = simulateAttempt(trunk.lesson(), on, person, 7);
  EXPECT_TRUE(areSame(steps, simulateAttempt(trunk.lesson(), on, person, 7)));
  EXPECT_FALSE(areSame(steps, simulateAttempt(trunk.lesson(), on, person, 8)));

  const test::TemporaryFolder folder;
  const SimulatedPerson who{SkillLevel::novice, 7, 7};
  const std::chrono::sys_seconds begun{std::chrono::sys_days{std::chrono::year(2026) / 1 / 5}};
  std::vector<fs::path> kept;
  for (const char* root : {"a", "b"}) {
    const auto made = keepSimulatedAttempt(trunk.lesson(), on, steps, who, begun, fs::path(folder.path()) / root);
    ASSERT_TRUE(made) << made.error().sentence();
    kept.push_back(*made);
  }
  EXPECT_EQ(kept[0].filename(), kept[1].filename());
  int files = 0;
  for (const auto& each : fs::directory_iterator(kept[0])) {
    EXPECT_EQ(bytesOf(each.path()), bytesOf(kept[1] / each.path().filename())) << each.path();
    ++files;
  }
  EXPECT_EQ(files, 9) << "attempt.json and eight steps with a scan";
}

TEST(SimulatedTrainee, IsKeptAsTheWindowWouldAndReadBackAsItWas) {
  Trunk trunk;
  const TraineeCase on = trunk.made();
  const auto steps = simulateAttempt(trunk.lesson(), on, personOf(SkillLevel::novice, 3), 7);
  const test::TemporaryFolder folder;
  const auto made = keepSimulatedAttempt(trunk.lesson(), on, steps, {SkillLevel::novice, 7, 7}, {}, folder.path());
  ASSERT_TRUE(made) << made.error().sentence();
  const auto kept = AttemptFolder::open(*made);
  ASSERT_TRUE(kept) << kept.error().sentence();
  const Attempt& attempt = kept->attempt();
  EXPECT_EQ(attempt.person, "novice 07");
  EXPECT_EQ(attempt.lessonContent, contentOf(trunk.lesson()));
  EXPECT_EQ(attempt.otherFields["simulated"]["level"], "novice") << "nobody may take it for a person's";
  EXPECT_TRUE(attempt.finishedAt);
  ASSERT_EQ(attempt.outcomes.size(), steps.size());
  for (std::size_t n = 0; n < steps.size(); ++n) {
    const StepOutcome& outcome = attempt.outcomes[n];
    SCOPED_TRACE(outcome.stepId);
    EXPECT_EQ(outcome.answer, steps[n].answer);
    EXPECT_EQ(outcome.recording.empty(), steps[n].log.frameCount() == 0);
    EXPECT_NEAR(outcome.score, judgedOf(trunk.lesson().steps[n], steps[n], on).score, 1e-12);
    if (outcome.recording.empty()) continue;
    const auto recording = readRecording(*made / outcome.recording);
    ASSERT_TRUE(recording) << recording.error().sentence();
    ASSERT_EQ(recording->log.events().size(), steps[n].log.events().size());
    for (std::size_t e = 0; e < steps[n].log.events().size(); ++e) {
      ScanEvent event = steps[n].log.events()[e];
      if (auto* frame = std::get_if<FrameMade>(&event.what)) frame->pose.time_s = 0.0;  // said once, by the event
      ScanEvent read = recording->log.events()[e];
      if (auto* chosen = std::get_if<ProbeChosen>(&read.what)) {  // its angle is written in degrees
        const double angle_rad = std::get<ProbeChosen>(event.what).probe.halfAngle_rad;
        EXPECT_NEAR(chosen->probe.halfAngle_rad, angle_rad, 1e-12);
        chosen->probe.halfAngle_rad = angle_rad;
      }
      ASSERT_TRUE(read == event) << "event " << e;
    }
  }
}

TEST(SimulatedTrainee, MovesTheSameWayAtAnyRateOfImages) {
  Trunk trunk;
  const TraineeCase on = trunk.made();
  const TraineeHabits person = personOf(SkillLevel::intermediate, 4);
  const auto slow = simulateAttempt(trunk.lesson(), on, person, 9, {.rate_hz = 20.0});
  const auto fast = simulateAttempt(trunk.lesson(), on, person, 9, {.rate_hz = 100.0});
  for (std::size_t n = 0; n < slow.size(); ++n) {
    SCOPED_TRACE(slow[n].stepId);
    EXPECT_NEAR(slow[n].seconds, fast[n].seconds, 1e-9);
    for (std::size_t frame = 0; frame < slow[n].log.frameCount(); ++frame) {
      const ScanState image = slow[n].log.frame(frame);
      const ScanState same = fast[n].log.frame(fast[n].log.frameAt(image.time_s + 1e-6));
      ASSERT_NEAR(same.time_s, image.time_s, 1e-9);
      ASSERT_LT(glm::distance(faceOf(image), faceOf(same)), 1e-9);
    }
  }
}

TEST(SimulatedTrainee, WithoutErrorsFollowsTheMovementOfLeastJerkAndIsRight) {
  // On flat skin, 150 mm along a straight line at 30 mm/s and a quarter turn at 30 degrees/s, which takes no longer.
  Trunk trunk(std::make_shared<test::PlaneSkin>());
  TeachingCase& teaching = trunk.teaching();
  Hold hold;
  hold.contact = teaching.skin->nearest({0.0, 0.0, 50.0});
  const glm::dvec3 from_mm = hold.contact.point_mm;
  teaching.opened.startPose = poseOf(hold);
  hold.contact = teaching.skin->nearest({90.0, 120.0, 50.0});
  teaching.truth.planes[0].probeToWorld = poseOf(turned(hold, 0.5 * std::numbers::pi, 0.0, 0.0)).probeToWorld;
  teaching.probe.kind = ProbeKind::linear;  // on flat skin its face touches without being pressed
  trunk.lesson().steps = {stepOf("plane", PlaneTask{"across the ball", {}, {}})};
  const TraineeCase on = trunk.made();
  TraineeHabits habits;
  habits.slide_mmPerS = 30.0;
  habits.turn_degPerS = 30.0;
  const double press_mm = usualPress_mm(teaching.probe);
  const auto steps = simulateAttempt(trunk.lesson(), on, habits, 1, {.rate_hz = 100.0});
  const ScanLog& log = steps[0].log;
  ASSERT_GT(log.frameCount(), 500U);
  for (std::size_t n = 0; n < log.frameCount(); ++n) {
    const ScanState image = log.frame(n);
    const double t = std::min(image.time_s / 5.0, 1.0);
    const double share = t * t * t * (10.0 - 15.0 * t + 6.0 * t * t);
    const glm::dvec3 expected_mm = from_mm + share * glm::dvec3(90.0, 120.0, 0.0);
    EXPECT_LT(glm::distance(glm::dvec2(faceOf(image)), glm::dvec2(expected_mm)), 0.15) << image.time_s << " s";
    EXPECT_NEAR(faceOf(image).z, -press_mm * (1.0 - share), 1e-6) << "a start is pressed on, the plane is as it is";
    const double cosine = glm::dot(image.pose.probeToWorld.matrix[0], log.frame(0).pose.probeToWorld.matrix[0]);
    EXPECT_NEAR(std::acos(std::clamp(cosine, -1.0, 1.0)), share * 0.5 * std::numbers::pi, 1.6e-3) << image.time_s << " s";
  }
  const auto figures = figuresOf(motionOf(posesOf(log, 0.0, 5.0)));
  EXPECT_NEAR(figures.path_mm, std::hypot(150.0, 1.0), 0.15);
  EXPECT_NEAR(figures.angularPath_deg, 90.0, 0.09);
  EXPECT_NEAR(judgedOf(trunk.lesson().steps[0], steps[0], on).score, 1.0, 1e-6);
  EXPECT_TRUE(log.isFrozenAt(log.end_s()));
}

TEST(SimulatedTrainee, WithoutErrorsPassesEveryKindOfStep) {
  Trunk trunk;
  const TraineeCase on = trunk.made();
  const auto steps = simulateAttempt(trunk.lesson(), on, TraineeHabits{}, 1);
  ASSERT_EQ(steps.size(), trunk.lesson().steps.size());
  for (std::size_t n = 0; n < steps.size(); ++n) {
    const StepOutcome outcome = judgedOf(trunk.lesson().steps[n], steps[n], on);
    EXPECT_GE(outcome.score, 0.97) << steps[n].stepId << ": " << jsonOf(steps[n].answer);
    for (const AttemptRemark& remark : outcome.remarks) EXPECT_TRUE(remark.good) << steps[n].stepId << ": " << remark.text.english();
  }
  EXPECT_EQ(steps[0].answer, StepAnswer());
  EXPECT_EQ(steps[1].answer, StepAnswer(WatchAnswer{true}));
  EXPECT_EQ(steps[3].answer, StepAnswer());
  EXPECT_TRUE(std::holds_alternative<PointAnswer>(steps[5].answer));
  const auto &distance = std::get<MeasurementAnswer>(steps[7].answer), &volume = std::get<MeasurementAnswer>(steps[8].answer);
  EXPECT_NEAR(distance.value, 24.0, 1e-6);
  EXPECT_EQ(distance.caliper, "distance");
  EXPECT_EQ(distance.points_mm.size(), 2U);
  EXPECT_EQ(volume.unit, "ml");
  EXPECT_TRUE(volume.points_mm.empty());
  EXPECT_EQ(steps[9].answer, StepAnswer(OptionsAnswer{{1, 3}}));
  EXPECT_EQ(steps[10].answer, StepAnswer(NumberAnswer{24.0}));
  EXPECT_GE(steps[11].log.end_s() - steps[11].log.begin_s(), 20.0);
}

TEST(SimulatedTrainee, OfHigherLevelIsNearerFasterAndMoreOftenRight) {
  Trunk trunk;
  const TraineeCase on = trunk.made();
  std::vector<double> path_mm, error_mm, used_s, right;
  for (const SkillLevel level : kSkillLevels) {
    std::vector<double> paths, errors, times, rights;
    for (std::uint64_t n = 0; n < 60; ++n) {
      const auto steps = simulateAttempt(trunk.lesson(), on, onOneDay(personOf(level, n), n), n, {.rate_hz = 10.0});
      const ScanLog& log = steps[3].log;
      paths.push_back(figuresOf(motionOf(posesOf(log, log.begin_s(), log.end_s()))).path_mm);
      const ScanState last = log.frame(log.frameCount() - 1);
      errors.push_back(std::abs(glm::dot(glm::dvec3(-30.0, -70.0, 20.0) - faceOf(last), glm::dvec3(last.pose.probeToWorld.matrix[2]))));
      times.push_back(std::accumulate(steps.begin(), steps.end(), 0.0, [](double sum, const auto& step) { return sum + step.seconds; }));
      rights.push_back(judgedOf(trunk.lesson().steps[9], steps[9], on).score);
    }
    path_mm.push_back(meanOf(paths));
    error_mm.push_back(meanOf(errors));
    used_s.push_back(meanOf(times));
    right.push_back(meanOf(rights));
  }
  for (std::size_t n = 1; n < 3; ++n) {
    EXPECT_LT(path_mm[n], path_mm[n - 1]);
    EXPECT_LT(error_mm[n], error_mm[n - 1]);
    EXPECT_LT(used_s[n], used_s[n - 1]);
    EXPECT_GT(right[n], right[n - 1]);
  }
}

TEST(SimulatedTrainee, TremblesBetweenEightAndTwelveHertz) {
  Trunk trunk;
  trunk.lesson().steps = {stepOf("rest", SettingsTask{})};
  trunk.lesson().steps[0].text = std::string(400, 'x');  // about twenty seconds
  const TraineeCase on = trunk.made();
  TraineeHabits habits;
  habits.tremor_mm = 0.2;
  const auto steps = simulateAttempt(trunk.lesson(), on, habits, 5, {.rate_hz = 100.0});
  const ScanLog& log = steps[0].log;
  ASSERT_GT(log.frameCount(), 1200U);
  constexpr int kSamples = 1200;
  std::vector<double> x_mm;
  const ScanState first = log.frame(0);
  for (std::size_t n = 0; n < kSamples; ++n)
    x_mm.push_back(glm::dot(faceOf(log.frame(n)) - faceOf(first), glm::dvec3(first.pose.probeToWorld.matrix[0])));
  const double mean_mm = meanOf(x_mm);
  double within = 0.0, all = 0.0, peak = 0.0, peak_hz = 0.0, square = 0.0;
  for (const double each : x_mm) square += (each - mean_mm) * (each - mean_mm);
  for (int k = 1; k < kSamples / 2; ++k) {
    const double hz = k * 100.0 / kSamples;
    double re = 0.0, im = 0.0;
    for (int n = 0; n < kSamples; ++n) {
      const double window = 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * n / kSamples);
      re += window * (x_mm[static_cast<std::size_t>(n)] - mean_mm) * std::cos(2.0 * std::numbers::pi * k * n / kSamples);
      im += window * (x_mm[static_cast<std::size_t>(n)] - mean_mm) * std::sin(2.0 * std::numbers::pi * k * n / kSamples);
    }
    const double power = re * re + im * im;
    all += power;
    within += hz >= 7.8 && hz <= 12.2 ? power : 0.0;
    if (power > peak) {
      peak = power;
      peak_hz = hz;
    }
  }
  EXPECT_GE(peak_hz, 8.0);
  EXPECT_LE(peak_hz, 12.0);
  EXPECT_GT(within / all, 0.99);
  EXPECT_NEAR(std::sqrt(square / kSamples), 0.2, 0.03);
}

TEST(SimulatedTrainee, LosesContactForTheShareThatWasAsked) {
  Trunk trunk;
  const TraineeCase on = trunk.made();
  for (const double asked : {0.0, 0.03, 0.15}) {
    TraineeHabits habits;
    habits.press = 1.0;
    habits.tremor_mm = 0.1;
    habits.contactLoss = asked;
    const auto steps = simulateAttempt(trunk.lesson(), on, habits, 3, {.rate_hz = 50.0});
    for (const SimulatedStep& step : steps) {
      if (step.log.frameCount() == 0) continue;
      int lost = 0, changes = 0;
      bool before = false;
      for (std::size_t n = 0; n < step.log.frameCount(); ++n) {
        const double share = contactShare(step.log.frame(n).gaps_mm);
        EXPECT_TRUE(asked > 0.0 || share > 0.5) << step.stepId << " " << n;
        const bool isLost = share < 0.5;
        lost += isLost ? 1 : 0;
        changes += isLost != before ? 1 : 0;
        before = isLost;
      }
      EXPECT_FALSE(before) << "the last image is of a probe on the skin";
      const double frames = static_cast<double>(step.log.frameCount());
      EXPECT_NEAR(lost / frames, asked, (1.0 + changes) / frames) << step.stepId << " of " << frames << " images";
    }
  }
}

TEST(SimulatedTrainee, StopsWhenTheTimeOfAStepIsOver) {
  Trunk trunk;
  for (LessonStep& step : trunk.lesson().steps) step.time_s = 6.0;
  const TraineeCase on = trunk.made();
  const auto steps = simulateAttempt(trunk.lesson(), on, habitsOf(SkillLevel::novice), 2);
  for (const SimulatedStep& step : steps) {
    EXPECT_LE(step.seconds, 6.0 + 1e-9) << step.stepId;
    EXPECT_LE(step.log.end_s() - step.log.begin_s(), 6.0 + 1e-9) << step.stepId;
  }
  EXPECT_EQ(steps[7].answer, StepAnswer()) << "nobody sets calipers in no time";
}

TEST(SimulatedTrainee, StopsAtOnceWhenToldInTheMiddleOfAScan) {
  Trunk trunk;
  trunk.lesson().steps.back().time_s.reset();
  const TraineeCase on = trunk.made();
  int asked = 0;
  constexpr int kUntil = 200;
  const auto steps = simulateAttempt(trunk.lesson(), on, habitsOf(SkillLevel::expert), 2,
                                     {.shortest_s = 3600.0, .stopped = [&] { return ++asked > kUntil; }});
  std::size_t images = 0;
  for (const SimulatedStep& step : steps) images += step.log.frameCount();
  EXPECT_LE(images, static_cast<std::size_t>(kUntil));
  EXPECT_LT(asked, kUntil + 20) << "one question more for each level of calls";

  const auto whole = simulateAttempt(trunk.lesson(), on, habitsOf(SkillLevel::expert), 2);
  const test::TemporaryFolder folder;
  auto stop = test::CountedStop::atQuestion(50);
  const auto kept = keepSimulatedAttempt(trunk.lesson(), on, whole, {SkillLevel::expert, 1, 2}, {}, folder.path(), stop);
  ASSERT_FALSE(kept);
  EXPECT_EQ(kept.error().code, ErrorCode::cancelled);
  EXPECT_LE(stop.questionsAfter(), test::kMostQuestionsAfter);
}

TEST(SimulatedTrainee, LooksAboutUntilThereIsEnough) {
  Trunk trunk;
  const TraineeCase on = trunk.made();
  const auto steps = simulateAttempt(trunk.lesson(), on, habitsOf(SkillLevel::expert), 2, {.shortest_s = 200.0});
  double scanned_s = 0.0;
  for (const SimulatedStep& step : steps) scanned_s += static_cast<double>(step.log.frameCount()) / 20.0;
  EXPECT_LT(scanned_s, 200.0) << "the last step may take 60 s";
  trunk.lesson().steps.back().time_s.reset();
  const auto longer = simulateAttempt(trunk.lesson(), on, habitsOf(SkillLevel::expert), 2, {.shortest_s = 200.0});
  scanned_s = 0.0;
  for (const SimulatedStep& step : longer) scanned_s += static_cast<double>(step.log.frameCount()) / 20.0;
  EXPECT_NEAR(scanned_s, 200.0, 5.0);
}

}  // namespace
}  // namespace ew
