#include "ew/reports/attempt_report.h"

#include "reports/reports_world.h"

namespace ew {
namespace {

using test::holds;
using test::madeAttempt;
using test::madeLesson;
using test::plainTextOf;
using test::someCodes;

TEST(ReportOfAnAttempt, SaysWhoWhatWhenAndWhatItIsWorth) {
  const std::string text = plainTextOf(attemptReport(madeAttempt(3, 0.85, 0.4), madeLesson(), someCodes()));
  const std::string code = someCodes().ofPerson("Ana Gomez");
  for (const std::string& part :
       {std::string("About balls: ") + code, std::string("A ball, said to hurt"), std::string("Began: 2026-11-01 10:03 UTC"),
        std::string("Ended: 2026-11-01 10:08 UTC"), std::string("Time on steps: 3 min 45 s"), std::string("Score: 62 %"),
        std::string("Verdict: not passed"), std::string("Score number: 2"), std::string("0123456789abcdef")})
    EXPECT_TRUE(holds(text, part)) << part << "\n" << text;
  EXPECT_TRUE(holds(text, "Step plane | Find a plane | passed | 85 % | 70 % | 1 | 1 min 15 s | 0"));
  EXPECT_TRUE(holds(text, "Step answer | Answer a question | not passed | 40 %"));
  EXPECT_TRUE(holds(text, "Angle | 4.25 °"));
  EXPECT_TRUE(holds(text, "Path length | 203 mm | 1 | no"));
  EXPECT_TRUE(holds(text, "The plane is found: 4.2 degrees and 1.0 mm from the expert's."));
  EXPECT_TRUE(holds(text, validitySentence().english()));
}

TEST(ReportOfAnAttempt, SaysWhereALearningSystemWasToldAnotherVerdict) {
  ReportAttempt one = madeAttempt(3, 0.85, 0.4);
  EXPECT_FALSE(holds(plainTextOf(attemptReport(one, madeLesson(), someCodes())), "learning system"));
  one.attempt.masteryScore = 0.5;
  const std::string text = plainTextOf(attemptReport(one, madeLesson(), someCodes()));
  EXPECT_TRUE(holds(text, "Verdict: not passed")) << text;
  EXPECT_TRUE(holds(text, "The learning system asks for 50 of 100 points: passed there.")) << text;
  one.attempt.masteryScore = 0.7;
  EXPECT_FALSE(holds(plainTextOf(attemptReport(one, madeLesson(), someCodes())), "learning system")) << "not passed there either";
}

TEST(ReportOfAnAttempt, NamesNobodyUnlessAsked) {
  ReportAttempt one = madeAttempt(1, 0.9, 0.9, "Ana Gomez");
  one.ratings.ratings = {test::ratedBy("Dr. Rateress", 4, 3)};
  one.comments.files = {{"Prof. Comment", {ReviewComment{"a", "plane", "", 2.5, "Look here.", {}, {}, {}, {}}}, {}}};
  const std::string coded = htmlOf(attemptReport(one, madeLesson(), someCodes()), {});
  for (const char* name : {"Ana", "Gomez", "Rateress", "Prof. Comment"}) EXPECT_FALSE(holds(coded, name)) << name;
  EXPECT_TRUE(holds(coded, someCodes().ofReviewer("Dr. Rateress")));
  EXPECT_TRUE(holds(coded, "Look here."));
  const ReportOptions named{.names = true};
  const std::string text = htmlOf(attemptReport(one, madeLesson(), someCodes(), named), named);
  for (const char* name : {"Ana Gomez", "Dr. Rateress", "Prof. Comment, at 2.50 s of the scan: Look here."})
    EXPECT_TRUE(holds(text, name)) << name;
}

TEST(ReportOfAnAttempt, HasMetricsBesideTheExpertsOfTheSameVersion) {
  ReportLesson lesson = madeLesson();
  lesson.expert = madeAttempt(99, 1.0, 1.0).score;
  lesson.expert->steps[1].metrics = {{"path_length", 1, 120.0}, {"hints", 2, 0.0}};
  lesson.plan.at("plane").metrics = {{"path_length", 2.0, 500.0, 100.0}};
  lesson.offByDefault = {{"plane", "hints"}};
  const std::string text = plainTextOf(attemptReport(madeAttempt(1, 0.9, 0.9), lesson, someCodes()));
  EXPECT_TRUE(holds(text, "Path length | 201 mm | 120 mm | 1 | weight 2")) << text;
  EXPECT_FALSE(holds(text, "Hints | 2")) << "it is off by default: a page of such rows says nothing";
  EXPECT_TRUE(holds(text, "Left out, since they are off by default and do not count: 1 of")) << text;
  lesson.expert.reset();
  EXPECT_TRUE(holds(plainTextOf(attemptReport(madeAttempt(1, 0.9, 0.9), lesson, someCodes())), "Path length | 201 mm | 1 | weight 2"))
      << "and no column of dashes where there is no expert";
}

TEST(ReportOfAnAttempt, SaysNothingOfWeightsThatAnotherPlanHad) {
  ReportLesson lesson = madeLesson();
  lesson.plan.revision = 4;
  lesson.plan.at("plane").metrics = {{"path_length", 2.0, 500.0, 100.0}};
  EXPECT_FALSE(holds(plainTextOf(attemptReport(madeAttempt(1, 0.9, 0.9), lesson, someCodes())), "weight 2"));
}

TEST(ReportOfAnAttempt, ListsEarlierScoresAndRatings) {
  ReportAttempt one = madeAttempt(1, 0.9, 0.9);
  one.earlier = {*one.score};
  one.earlier[0].number = 1;
  one.earlier[0].score = 0.33;
  one.earlier[0].passed = false;
  one.ratings.ratings = {test::ratedBy("R", 2, 3), test::ratedBy("R", 4, 3)};
  one.ratings.ratings[1].rating.revision = 2;
  const std::string text = plainTextOf(attemptReport(one, madeLesson(), someCodes()));
  EXPECT_TRUE(holds(text, "1 | 2026-11-01 11:01 UTC | 33 % | not passed | 0 | 0.1.0")) << text;
  EXPECT_TRUE(holds(text, "Total: 3.50 of 5")) << text;
  EXPECT_FALSE(holds(text, "Total: 2.50 of 5")) << "an earlier revision no longer counts";
  EXPECT_TRUE(holds(text, "Item plan | 4 of 5"));
}

TEST(ReportOfAnAttempt, ListsTheLatestScoreAmongTheEarlierOnesWhereThePlanHasChangedSince) {
  ReportAttempt one = madeAttempt(1, 0.9, 0.2);
  one.lesson = test::triedLesson();
  const std::string listed = "2 | 2026-11-01 11:01 UTC | 55 % | not passed | 0 | 0.1.0";
  EXPECT_FALSE(holds(plainTextOf(attemptReport(one, madeLesson(), someCodes())), listed)) << "it counts";
  one.plan.revision = 1;
  const std::string text = plainTextOf(attemptReport(one, madeLesson(), someCodes()));
  EXPECT_TRUE(holds(text, "Earlier scores")) << text;
  EXPECT_TRUE(holds(text, listed)) << text;
  EXPECT_TRUE(holds(text, "Judged: as in the lesson; score 2 was made by an earlier revision of the plan")) << text;
  EXPECT_FALSE(holds(text, "not scored since")) << text;
  EXPECT_FALSE(holds(text, "Score number")) << "of what counts there is none: " << text;
}

TEST(ReportOfAnAttempt, SaysThatItsScoreIsOfAnEarlierStateOfIt) {
  ReportAttempt one = madeAttempt(1, 0.9, 0.2);
  one.lesson = test::triedLesson();
  one.score->outcomes = 2;
  one.score->wasFinished = true;
  const std::string text = plainTextOf(attemptReport(one, madeLesson(), someCodes()));
  EXPECT_TRUE(holds(text, "Judged: as in the lesson; score 2 was made of an earlier state of the attempt")) << text;
  EXPECT_TRUE(holds(text, "2 | 2026-11-01 11:01 UTC | 55 % | not passed | 0 | 0.1.0")) << text;
}

TEST(ReportOfAnAttempt, SaysOfALessonThatIsGoneThatItsScoreDoesNotCountRatherThanThatThereIsNone) {
  ReportAttempt one = madeAttempt(1, 0.9, 0.2);
  one.plan.revision = 1;
  const std::string text = plainTextOf(attemptReport(one, madeLesson(), someCodes()));
  EXPECT_TRUE(holds(text, "Score: none that counts now")) << text;
  EXPECT_FALSE(holds(text, "not scored yet")) << text;
  EXPECT_FALSE(holds(text, "passes from")) << "nobody knows which steps count: " << text;
}

TEST(ReportOfAnAttempt, OfReadingAloneSaysThatAllStepsCountAlike) {
  ReportAttempt unscored = test::readingAttempt(), scored = unscored;
  scored.score = scored.result().counted;  // what scoring makes of such a lesson
  scored.score->number = 1;
  scored.score->key = "0123456789abcdef";
  for (const ReportAttempt& one : {unscored, scored}) {
    const ReportDocument document = attemptReport(one, madeLesson(), someCodes());
    const std::string text = plainTextOf(document);
    EXPECT_TRUE(holds(text, "Score: 90 % | Verdict: passed | Steps passed: 2 of 2")) << text;
    EXPECT_FALSE(holds(text, "does not count")) << text;
    EXPECT_TRUE(holds(text, "Score: 80 % (passes from 70 %; all steps count alike)")) << text;
    EXPECT_EQ(test::countOf(text, "all steps count alike"), 2u) << text;
    EXPECT_TRUE(holds(text, "Step watch | Watch the expert | passed | 80 % | 70 % | 1 |")) << text;
    std::size_t bars = 0;
    for (const ReportBlock& block : document.blocks)
      if (const auto* plot = std::get_if<ReportPlot>(&block))
        if (const auto* shown = std::get_if<BarsPlot>(&plot->data)) bars += shown->bars.size();
    EXPECT_EQ(bars, 2u);
  }
  const ReportAttempt usual = madeAttempt(1, 0.9, 0.9);
  EXPECT_EQ(test::countOf(plainTextOf(attemptReport(usual, madeLesson(), someCodes())), "(does not count)"), 1u)
      << "where others count, reading does not";
}

TEST(ReportOfAnAttempt, WithoutAScoreHasWhatTheLessonSaid) {
  ReportAttempt one = madeAttempt(1, 0.9, 0.2);
  one.score.reset();
  one.attempt.finishedAt.reset();
  const std::string text = plainTextOf(attemptReport(one, madeLesson(), someCodes()));
  EXPECT_TRUE(holds(text, "Score: not scored yet"));
  EXPECT_TRUE(holds(text, "Ended: not finished"));
  EXPECT_TRUE(holds(text, "3. answer"));
}

TEST(ReportOfAnAttempt, SaysWhatWasHandedIn) {
  ReportAttempt one = madeAttempt(1, 0.9, 0.2);
  one.score.reset();
  for (StepOutcome& outcome : one.attempt.outcomes) outcome.verdict = StepVerdict::handedIn;
  for (const char* id : {"read", "plane", "answer"}) {
    if (!one.lesson) one.lesson.emplace();
    one.lesson->steps.emplace_back().id = id;
    one.lesson->steps.back().task = AnswerTask{};
  }
  const std::string text = plainTextOf(attemptReport(one, madeLesson(), someCodes()));
  EXPECT_FALSE(holds(text, "skipped")) << text;
  EXPECT_EQ(test::countOf(text, "Verdict: handed in"), 4u) << text;
  EXPECT_FALSE(holds(text, "Score: ")) << "nobody has judged it: " << text;
}

TEST(ReportOfAnAttempt, SaysWhenInTheScanACommentIsAndWhoWroteIt) {
  const test::TemporaryFolder folder;
  ReportAttempt one = madeAttempt(1, 0.9, 0.9);
  one.folder = folder.path();
  // The scan's clock began with the program, a quarter of an hour before the step.
  ScanRecording recording{"ball", "Ball", {64, 48}, test::scanAlong([](double) { return test::heldAt(); }, 5.0, 20.0, 892.6), {}};
  ASSERT_TRUE(writeRecording(recording, folder / "plane.seq.mha"));
  one.attempt.outcomes[1].recording = "plane.seq.mha";
  ReviewComment comment;
  comment.stepId = "plane";
  comment.recording = "plane.seq.mha";
  comment.time_s = 896.0;
  comment.text = "Here.";
  ReviewComment lost = comment;
  lost.recording = "gone.seq.mha";
  lost.text = "There.";
  one.comments.files = {{"Dr. Weiss", {comment, lost}, {}}};
  const std::string text = plainTextOf(attemptReport(one, madeLesson(), someCodes()));
  const std::string author = someCodes().ofReviewer("Dr. Weiss");
  EXPECT_TRUE(holds(text, author + ", at 3.40 s of the scan: Here.")) << text;
  EXPECT_TRUE(holds(text, author + ": There.")) << "no moment rather than a wrong one: " << text;
}

TEST(ReportOfAnAttempt, TellsFilesWithoutTheFoldersOfSomebodysComputer) {
  ReportAttempt one = madeAttempt(1, 0.9, 0.9);
  one.score->notes = {
      say<"The recording of the step '%1' cannot be read: %2">(std::string("plane"), verbatim("'/home/ana gomez/Library/x.mha' is torn."))};
  const std::string text = plainTextOf(attemptReport(one, madeLesson(), someCodes()));
  EXPECT_FALSE(holds(text, "ana gomez")) << text;
  EXPECT_TRUE(holds(text, "'x.mha' is torn."));
}

TEST(ReportOfAnAttempt, HasTheCasesOwnWordsInTheReportsLanguage) {
  ReportLesson lesson = madeLesson();
  lesson.words = CaseWords({{"Step plane", "Die Ebene"}, {"Because it is round.", "Weil sie rund ist."}});
  ReportAttempt one = madeAttempt(1, 0.9, 0.9);
  one.score->steps[2].remarks = {{false, verbatim("Because it is round.")}};
  const std::string text = plainTextOf(attemptReport(one, lesson, someCodes()));
  EXPECT_TRUE(holds(text, "2. Die Ebene")) << text;
  EXPECT_TRUE(holds(text, "Weil sie rund ist."));
  EXPECT_FALSE(holds(text, "Step plane"));
}

TEST(PathOfAProbe, IsSeenFromTheFrontAndBrokenWhereNoPoseIsKnown) {
  ScanLog log;
  for (int n = 0; n < 8; ++n) {
    ScanState state = test::imageAt(test::heldAt(10.0 * n, 0.0, 2.0 * n), 0.1 * n);
    if (n == 4) state.pose.status = PoseStatus::invalid;
    log.addFrame(state);
  }
  const auto path = pathOf(log);
  ASSERT_EQ(path.size(), 2u);
  EXPECT_EQ(path[0].size(), 4u);
  EXPECT_EQ(path[0][1], glm::dvec2(2.0, 10.0)) << "x is the patient's left, z towards the head";
  EXPECT_EQ(path[1].front(), glm::dvec2(10.0, 50.0));
}

TEST(PathOfAProbe, IsEmptyWhileItRests) {
  EXPECT_TRUE(pathOf(test::scanAlong([](double) { return test::heldAt(); }, 2.0)).empty());
  EXPECT_TRUE(pathOf(ScanLog()).empty());
}

}  // namespace
}  // namespace ew
