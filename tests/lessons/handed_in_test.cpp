// Steps of an examination: kept as handed in, and judged afterwards exactly as they would have been at once.
#include <gtest/gtest.h>

#include "ew/library/sealed_answers.h"
#include "ew/library/step_answer.h"
#include "ew/scanning/recording.h"
#include "lessons/made_scene.h"
#include "library/temporary_folder.h"
#include "logic/lesson_run.h"

namespace ew::lessons {
namespace {

using ew::test::TemporaryFolder;
using test::held;
using test::image;
using test::scene;

struct Tried {
  const char* what;
  LessonTask task;  ///< with its answer
  LessonTask open;  ///< as the trainee of an examination has it
  std::vector<ScanState> images;
  Handed handed;
};

std::vector<Tried> everyKind() {
  const AnswerTask options{{{"right", true, "because"}, {"wrong", false, "no"}}, {}, 0.0, ""};
  const AnswerTask open{{{"right", false, ""}, {"wrong", false, ""}}, {}, 0.0, ""};
  const AnswerTask number{{}, 12.0, 1.0, "mm"};
  AnswerTask openNumber;
  openNumber.unit = "mm";
  MeasurementSubmission angle;
  angle.kind = "angle";
  angle.figures.push_back({"angle", 40.0, "deg"});
  const MeasureTask measure{"ball, across", {}};
  const std::vector<ScanState> here = {image(held(3.0, 4.0))};
  std::vector<ScanState> sweep;
  for (double z_mm = -25.0; z_mm <= 5.0; z_mm += 1.0) sweep.push_back(image(held(z_mm), z_mm));
  return {{"plane", PlaneTask{"middle", {}, {}}, PlaneTask{}, here, {}},
          {"sweep", SweepTask{"ball", 0.9}, SweepTask{}, sweep, {}},
          {"measure", measure, MeasureTask{}, here, {.measurements = {test::length(41.0), angle}}},
          {"measure, wrong", measure, MeasureTask{}, here, {.measurements = {test::length(70.0)}}},
          {"measure, nothing that fits", measure, MeasureTask{}, here, {.measurements = {angle}}},
          {"point", PointTask{"ball"}, PointTask{}, here, {.point = Point<frame::Probe>{{2.0, 41.0, 0.0}}}},
          {"point beside", PointTask{"ball"}, PointTask{}, here, {.point = Point<frame::Probe>{{24.0, 70.0, 0.0}}}},
          {"settings", SettingsTask{{"linear-7.5"}, {{"depth_mm", 70.0, 75.0}}}, SettingsTask{}, here, {}},
          {"options", options, open, here, {.chosen = {0}}},
          {"options, wrong", options, open, here, {.chosen = {1}}},
          {"number", number, openNumber, here, {.number = 12.5}},
          {"number, wrong", number, openNumber, here, {.number = 14.0}}};
}

TEST(HandedIn, IsJudgedAfterwardsAsItWouldHaveBeenAtOnce) {
  for (const Tried& each : everyKind()) {
    const auto direct = workOf(test::step(each.task), scene().ground());
    ASSERT_TRUE(direct) << each.what;
    const auto sealed = handedInWork(test::step(each.open));
    for (const ScanState& shown : each.images) {
      (*direct)->see(shown);
      sealed->see(shown);
    }
    StepOutcome atOnce, handedIn;
    (*direct)->hand(each.handed, atOnce);
    sealed->hand(each.handed, handedIn);
    EXPECT_TRUE(handedIn.figures.empty() && handedIn.remarks.empty() && handedIn.score == 0.0) << each.what << ": it knows nothing";
    const StepResult afterwards = (*direct)->judge(stepAnswerFromJson(jsonOf(handedIn.answer)));  // as an attempt kept it
    EXPECT_DOUBLE_EQ(afterwards.score, atOnce.score) << each.what;
    EXPECT_EQ(afterwards.figures, atOnce.figures) << each.what;
    EXPECT_EQ(afterwards.remarks, atOnce.remarks) << each.what;
  }
}

TEST(HandedIn, SaysWhatIsMissingAndNotWhetherItFits) {
  const auto measure = handedInWork(test::step(MeasureTask{}));
  EXPECT_TRUE(measure->missing({}));
  measure->see(image(held()));
  EXPECT_TRUE(measure->missing({}));
  EXPECT_FALSE(measure->missing({.measurements = {test::length(1.0)}}));
  const auto question = handedInWork(test::step(AnswerTask{{{"a", false, ""}, {"b", false, ""}}, {}, 0.0, ""}));
  EXPECT_TRUE(question->missing({}));
  EXPECT_FALSE(question->missing({.chosen = {1}}));
  EXPECT_TRUE(question->live().empty());
}

TEST(HandedIn, OfALessonIsKeptWithItsRecordingAndTheAnswersItIsJudgedBy) {
  const TemporaryFolder folder;
  Lesson lesson;
  lesson.id = "lesson-1";
  lesson.title = "L";
  lesson.steps = {test::step(ReadingTask{}), test::step(PlaneTask{})};
  lesson.steps[0].id = "step-1";
  lesson.steps[1].id = "step-2";
  auto run = LessonRun::begin(lesson, "examination-x", "me", folder.path(), std::string(64, 'a'));
  ASSERT_TRUE(run) << run.error();
  StepScene sealed = scene();
  sealed.truth = std::make_shared<CaseTruth>();
  sealed.isSealed = true;
  ASSERT_TRUE(run->startStep(sealed, 0.0));
  EXPECT_EQ(run->endStep({}, 1.0)->verdict, StepVerdict::passed) << "what is read is read";
  ASSERT_TRUE(run->next());
  ASSERT_TRUE(run->startStep(sealed, 2.0));
  const ScanState state = image(held(), 3.0);
  run->see({state.time_s, FrameMade{state.pose, {}, state.number, {}}}, state);
  const auto outcome = run->endStep({}, 4.0);
  ASSERT_TRUE(outcome) << outcome.error();
  EXPECT_EQ(outcome->verdict, StepVerdict::handedIn);
  ASSERT_TRUE(run->next());
  const auto kept = AttemptFolder::open(run->attempt()->folder());
  ASSERT_TRUE(kept) << kept.error();
  EXPECT_EQ(sealedAnswersOf(kept->attempt()), std::string(64, 'a'));
  EXPECT_EQ(kept->attempt().outcomes.at(1).verdict, StepVerdict::handedIn);
  EXPECT_TRUE(readRecording(kept->folder() / kept->attempt().outcomes.at(1).recording));
}

}  // namespace
}  // namespace ew::lessons
