#include "ew/assessment/step_metrics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <set>

#include "assessment/assessed_world.h"

namespace ew {
namespace {

using test::heldAt;
using test::imageAt;
using test::scanAlong;

TEST(Metrics, AreNamedInPlainWordsAndSayWhichWayIsSmoother) {
  int smooth = 0;
  for (const Metric& metric : metrics()) {
    const std::string name = metric.name.english(), definition = metric.definition.english();
    EXPECT_EQ(name.find("dimensionless"), std::string::npos) << name;
    EXPECT_EQ(name.find("spectral"), std::string::npos) << name;
    if (name.find("Smoothness") == std::string::npos) continue;
    ++smooth;
    EXPECT_NE(definition.find("the smoother"), std::string::npos) << definition;
    EXPECT_NE(definition.find("without unit"), std::string::npos) << definition;
  }
  EXPECT_EQ(smooth, 2);
}

TEST(HeldFrames, LastUntilTheNextImageAndNotWhileFrozenOrPaused) {
  ScanLog log;
  log.addFrame(imageAt(heldAt(), 1.0));
  log.addFrame(imageAt(heldAt(), 3.0));
  log.setFrozen(4.0, true);
  log.setFrozen(9.0, false);
  log.addFrame(imageAt(heldAt(), 10.0));
  log.addNote(11.0, "pause", {});
  log.addNote(20.0, "resume", {});
  log.addNote(20.5, "handed in", {});
  const auto held = heldFramesOf(log);
  ASSERT_EQ(held.size(), 3u);
  EXPECT_DOUBLE_EQ(held[0].seconds, 2.0);
  EXPECT_DOUBLE_EQ(held[1].seconds, 2.0) << "a second before the freeze and one after it";
  EXPECT_DOUBLE_EQ(held[2].seconds, 1.5) << "a second before the pause, half a second after it";
}

TEST(HeldPoses, KnowThatAProbeWithoutNewImagesRests) {
  ScanLog log;  // ten seconds at rest, which makes no image, then a second of motion
  log.addFrame(imageAt(heldAt(0.0), 0.0));
  for (int n = 0; n <= 50; ++n) log.addFrame(imageAt(heldAt(0.6 * n), 10.0 + 0.02 * n));
  const auto figures = figuresOf(motionOf(heldPosesOf(log)));
  EXPECT_NEAR(figures.known_s, 11.0, 0.05);
  EXPECT_NEAR(figures.idleShare, 10.0 / 11.0, 0.03);
  EXPECT_NEAR(figures.path_mm, 30.0, 0.5);
}

TEST(Contact, IsCountedByTimeFromTheFirstTouch) {
  const auto image = [](double time_s, std::vector<float> gaps_mm) {
    ScanState state = imageAt(heldAt(), time_s);
    state.gaps_mm = std::move(gaps_mm);
    return state;
  };
  ScanLog log;
  log.addFrame(image(0.0, std::vector<float>(17, 30.0F)));  // in the air
  log.addFrame(image(5.0, std::vector<float>(17, -2.0F)));  // pressed in by 2 mm
  log.addFrame(image(11.0, std::vector<float>(17, 10.0F)));
  log.addFrame(image(13.0, std::vector<float>(17, -4.0F)));
  log.addNote(15.0, "handed in", {});
  const ContactFigures contact = contactOf(log);
  ASSERT_TRUE(contact.first_s);
  EXPECT_DOUBLE_EQ(*contact.first_s, 5.0);
  EXPECT_DOUBLE_EQ(contact.lossShare, 0.2) << "two of ten seconds";
  ASSERT_TRUE(contact.press_mm);
  EXPECT_DOUBLE_EQ(*contact.press_mm, (6.0 * 2.0 + 2.0 * 4.0) / 8.0);
}

TEST(HullVolume, IsExactForABoxAndATetrahedron) {
  std::vector<glm::dvec3> box;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int n = 0; n < 5000; ++n) box.emplace_back(30.0 * unit(random), 20.0 * unit(random), 10.0 * unit(random));
  for (int n = 0; n < 8; ++n) box.emplace_back(30.0 * (n & 1), 20.0 * ((n >> 1) & 1), 10.0 * (n >> 2));
  EXPECT_NEAR(hullVolume_mm3(box), 6000.0, 6.0);
  EXPECT_NEAR(hullVolume_mm3(std::vector<glm::dvec3>{{0, 0, 0}, {6, 0, 0}, {0, 6, 0}, {0, 0, 6}}), 36.0, 1e-9);
}

TEST(HullVolume, DoesNotDependOnWhereTheWorldIs) {
  std::vector<glm::dvec3> points, moved;
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  const glm::dmat4 turn =
      glm::rotate(glm::translate(glm::dmat4(1.0), glm::dvec3(900.0, -400.0, 70.0)), 1.1, glm::normalize(glm::dvec3(1, 2, 3)));
  for (int n = 0; n < 400; ++n) {
    points.emplace_back(20.0 * normal(random), 10.0 * normal(random), 5.0 * normal(random));
    moved.emplace_back(turn * glm::dvec4(points.back(), 1.0));
  }
  EXPECT_NEAR(hullVolume_mm3(moved) / hullVolume_mm3(points), 1.0, 0.01) << "the 1024 directions stay in the world";
}

TEST(HullVolume, OfABallIsNearlyItsVolumeAndOfAPlaneNothing) {
  std::vector<glm::dvec3> ball, plane;
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  for (int n = 0; n < 20'000; ++n) {
    const glm::dvec3 p(normal(random), normal(random), normal(random));
    ball.push_back(30.0 * glm::normalize(p));
    plane.emplace_back(p.x, p.y, 4.0);
  }
  EXPECT_NEAR(hullVolume_mm3(ball) / (4.0 / 3.0 * std::numbers::pi * 27'000.0), 0.99, 0.01);
  EXPECT_DOUBLE_EQ(hullVolume_mm3(plane), 0.0);
  EXPECT_DOUBLE_EQ(hullVolume_mm3(std::vector<glm::dvec3>(10, {1.0, 2.0, 3.0})), 0.0);
  EXPECT_DOUBLE_EQ(hullVolume_mm3({}), 0.0);
}

class MetricsOfAStep : public ::testing::Test {
 protected:
  [[nodiscard]] const LessonStep& step(const std::string& id) const {
    for (const LessonStep& each : world_.lesson().steps)
      if (each.id == id) return each;
    throw std::out_of_range(id);
  }
  [[nodiscard]] std::vector<MetricValue> of(const std::string& id, const ScanLog& scan, StepOutcome outcome = {},
                                            const ExpertStep& expert = {}) const {
    const auto ground = world_.ground();
    const auto found = metricsOf({step(id), outcome, &scan}, *ground->caseOf(step(id)), expert);
    EXPECT_TRUE(found) << found.error();
    return found ? *found : std::vector<MetricValue>{};
  }
  test::AssessedWorld world_;
};

TEST_F(MetricsOfAStep, StateThePlaneOfTheLastImage) {
  const auto values = of("plane", scanAlong([](double t) { return heldAt(10.0 - t, 3.0); }, 7.0));
  EXPECT_NEAR(*valueOf(values, "plane_angle"), 3.0, 1e-6);
  const double interest_mm = 40.0;  // half of the depth
  EXPECT_NEAR(*valueOf(values, "plane_distance"), std::abs(3.0 * std::cos(glm::radians(3.0)) + interest_mm * std::sin(glm::radians(3.0))),
              0.01);
  EXPECT_NEAR(*valueOf(values, "plane_roll"), 0.0, 1e-6);
}

TEST_F(MetricsOfAStep, CountTimeFromTheFirstContact) {
  ScanLog log;
  ScanState air = imageAt(heldAt(), 0.0);
  air.gaps_mm.assign(17, 50.0F);
  log.addFrame(air);
  for (int n = 0; n <= 160; ++n) {
    ScanState image = imageAt(heldAt(0.1 * n), 4.0 + 0.05 * n);
    image.gaps_mm.assign(17, 0.0F);
    log.addFrame(image);
  }
  StepOutcome outcome;
  outcome.seconds = 12.0;
  EXPECT_NEAR(*valueOf(of("plane", log, outcome), "time"), 8.0, 1e-9);
}

TEST_F(MetricsOfAStep, AreTheSameFrom20And100PosesASecond) {
  const auto path = [](double t) { return heldAt(20.0 * std::sin(0.9 * t), 10.0 * std::sin(1.3 * t), 15.0 * std::cos(0.6 * t)); };
  StepOutcome outcome;
  outcome.seconds = 20.0;
  const ScanLog slow = scanAlong(path, 20.0, 20.0), fast = scanAlong(path, 20.0, 100.0);
  const ScanLog expert = scanAlong([](double t) { return heldAt(2.0 * t - 20.0); }, 20.0, 25.0);
  const auto few = of("sweep", slow, outcome, {&expert, {}}), many = of("sweep", fast, outcome, {&expert, {}});
  ASSERT_EQ(few.size(), many.size());
  for (std::size_t n = 0; n < few.size(); ++n) {
    ASSERT_EQ(few[n].id, many[n].id);
    // Coverage and overlap count what images saw: a hand faster than the images leaves gaps.
    const double bound = few[n].id == "coverage" || few[n].id == "plane_overlap" ? 0.05 : 0.02;
    EXPECT_NEAR(few[n].value, many[n].value, std::max(0.1, bound * std::abs(many[n].value))) << few[n].id;
  }
}

TEST_F(MetricsOfAStep, FindNoDifferenceFromOneself) {
  const ScanLog scan = scanAlong([](double t) { return heldAt(3.0 * t - 20.0, t); }, 12.0);
  const auto values = of("sweep", scan, {}, {&scan, {}});
  EXPECT_NEAR(*valueOf(values, "expert_distance"), 0.0, 1e-9);
  EXPECT_DOUBLE_EQ(*valueOf(values, "plane_overlap"), 100.0);
}

TEST_F(MetricsOfAStep, MeasureHowFarAParallelScanIsAway) {
  const ScanLog expert = scanAlong([](double t) { return heldAt(3.0 * t - 20.0); }, 12.0);
  const ScanLog beside = scanAlong([](double t) { return heldAt(3.0 * t - 20.0, 0.0, 7.0); }, 12.0);
  EXPECT_NEAR(*valueOf(of("sweep", beside, {}, {&expert, {}}), "expert_distance"), 7.0, 0.05);
  const ScanLog elsewhere = scanAlong([](double t) { return heldAt(3.0 * t - 20.0, 0.0, 70.0); }, 12.0);
  EXPECT_DOUBLE_EQ(*valueOf(of("sweep", elsewhere, {}, {&expert, {}}), "plane_overlap"), 0.0);
}

TEST_F(MetricsOfAStep, CountTheExpertsPlanesThatWereVisited) {
  const ScanLog expert = scanAlong([](double t) { return heldAt(6.0 * t - 30.0); }, 10.0);
  const ScanLog half = scanAlong([](double t) { return heldAt(3.0 * t - 30.0); }, 10.0);
  EXPECT_NEAR(*valueOf(of("sweep", half, {}, {&expert, {}}), "plane_overlap"), 100.0 * 40.0 / 60.0, 8.0) << "30 mm, and 10 mm beyond it";
}

TEST_F(MetricsOfAStep, CompareTheSettingsOfTheStoredImage) {
  const ScanLog scan = scanAlong([](double) { return heldAt(); }, 2.0);
  ScanState expert = imageAt(heldAt());
  expert.knobs.gain_db = 4.0;
  expert.knobs.depth_mm = 65.0;
  expert.knobs.focus_mm = 50.0;
  const auto values = of("plane", scan, {}, {nullptr, expert});
  EXPECT_DOUBLE_EQ(*valueOf(values, "gain_difference"), 4.0);
  EXPECT_DOUBLE_EQ(*valueOf(values, "depth_difference"), 15.0);
  EXPECT_DOUBLE_EQ(*valueOf(values, "focus_difference"), 10.0);
}

TEST_F(MetricsOfAStep, LeaveInvalidPosesOut) {
  ScanLog scan = scanAlong([](double t) { return heldAt(2.0 * t); }, 10.0);
  ScanLog broken;
  for (std::size_t n = 0; n < scan.frameCount(); ++n) {
    ScanState image = scan.frame(n);
    if (n % 4 == 1) {
      image.pose.status = PoseStatus::invalid;
      image.pose.probeToWorld = heldAt(1e4);
    }
    broken.addFrame(image);
  }
  EXPECT_NEAR(validShareOf(broken), 151.0 / 201.0, 1e-12);
  const auto values = of("plane", broken);
  EXPECT_NEAR(*valueOf(values, "path_length"), 20.0, 0.1);
}

TEST_F(MetricsOfAStep, CoverWhatImagesPassThrough) {
  const ScanLog half = scanAlong([](double t) { return heldAt(-25.0 + 2.5 * t); }, 10.0);
  EXPECT_NEAR(*valueOf(of("sweep", half), "coverage"), 53.0, 4.0) << "half of the ball and the plane's thickness";
  const ScanLog all = scanAlong([](double t) { return heldAt(-25.0 + 2.5 * t); }, 20.0);
  EXPECT_DOUBLE_EQ(*valueOf(of("sweep", all), "coverage"), 100.0);
}

TEST_F(MetricsOfAStep, AreTheSameWhereTheJudgeHasCountedWhatWasPassed) {
  const ScanLog part = scanAlong([](double t) { return heldAt(-25.0 + 2.5 * t, 3.0 * t); }, 7.0);
  const auto ground = world_.ground();
  auto work = workOf(step("free"), ground->caseOf(step("free")));
  ASSERT_TRUE(work) << work.error();
  for (std::size_t n = 0; n < part.frameCount(); ++n) (*work)->see(part.frame(n));
  const auto passed = (*work)->passedVoxels();
  ASSERT_TRUE(passed);
  EXPECT_GT(passed->passed, 0u);
  EXPECT_LT(passed->passed, passed->of);
  const StepOutcome outcome;
  const auto counted = metricsOf({step("free"), outcome, &part, passed}, *ground->caseOf(step("free")), {});
  ASSERT_TRUE(counted) << counted.error();
  EXPECT_EQ(*counted, of("free", part)) << "to the last bit";
  const auto other = metricsOf({step("free"), outcome, &part, VoxelPass{1, 4}}, *ground->caseOf(step("free")), {});
  ASSERT_TRUE(other) << other.error();
  EXPECT_EQ(valueOf(*other, "coverage"), 25.0) << "nothing is counted again";
}

TEST(Metrics, SayWhatTheyAreAndAreFoundByName) {
  std::set<std::string_view> ids;
  for (const Metric& each : metrics()) {
    EXPECT_TRUE(ids.insert(each.id).second) << each.id;
    EXPECT_EQ(metricOf(each.id), &each);
    for (const Message* text : {&each.name, &each.definition, &each.source, &each.validity}) EXPECT_FALSE(text->empty()) << each.id;
    EXPECT_FALSE(each.stepKinds.empty()) << each.id;
    for (const auto kind : each.stepKinds) EXPECT_TRUE(taskOfWord(kind)) << each.id << " " << kind;
  }
  EXPECT_EQ(metricOf("none"), nullptr);
}

}  // namespace
}  // namespace ew
