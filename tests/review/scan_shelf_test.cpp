#include "logic/scan_shelf.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "ew/io/safe_file.h"
#include "ew/io/volume_file.h"
#include "ew/library/learning_progress.h"
#include "made_log.h"

namespace ew::review {
namespace {

namespace fs = std::filesystem;

LessonStep stepOf(const char* id, LessonTask task, const char* caseId = "") {
  LessonStep made;
  made.id = id;
  made.title = std::string("Title of ") + id;
  made.caseId = caseId;
  made.task = std::move(task);
  return made;
}

class ScanShelfTest : public ::testing::Test {
 protected:
  void SetUp() override {
    root_ = fs::temp_directory_path() / (std::string("scan-shelf-") + ::testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(root_);
    fs::create_directories(root_ / "library");
  }
  void TearDown() override { fs::remove_all(root_); }

  static ScanRecording recordingOf(const char* caseId) {
    ScanRecording made;
    made.caseId = caseId;
    made.log = test::logOf(21, 0.5, [](int n, ScanState& state) { state.pose = test::at({1.0 * n, 0.0, 0.0}); });
    return made;
  }
  static void write(const ScanRecording& recording, const fs::path& file) {
    fs::create_directories(file.parent_path());
    const auto written = writeRecording(recording, file);
    ASSERT_TRUE(written) << written.error();
  }
  /// A case with a lesson of a watched scan, a plane to be found, and a free scan.
  fs::path makeCase(const std::string& name, const char* id) {
    const fs::path folder = root_ / "library" / "cases" / name;
    fs::create_directories(folder);
    Volume volume;
    volume.grid.dims = {8, 8, 8};
    volume.echo.assign(512, 100);
    EXPECT_TRUE(writeVolume(volume, folder / "volume.mha"));
    Case made;
    made.id = id;
    made.title = "Case " + name;
    made.volume.file = "volume.mha";
    WatchTask watch;
    watch.recording = "scans/expert.seq.mha";
    watch.begin_s = 1.0;
    watch.end_s = 4.0;
    watch.marks = {{2.0, "Here."}};
    Lesson lesson;
    lesson.id = "lesson";
    lesson.title = "A lesson";
    lesson.steps = {stepOf("watch", watch), stepOf("find", FreeTask{}), stepOf("again", FreeTask{})};
    made.otherFields["parts"]["lessons"] = jsonOf(std::vector<Lesson>{lesson});
    const auto saved = saveCase(made, folder);
    EXPECT_TRUE(saved) << saved.error();
    write(recordingOf(id), folder / "parts" / "lessons" / "scans" / "expert.seq.mha");
    return folder;
  }
  fs::path makeAttempt(const char* id, const char* caseId, const char* lessonId = "lesson") {
    Attempt attempt;
    attempt.id = id;
    attempt.caseId = caseId;
    attempt.lessonId = lessonId;
    attempt.person = "Ben";
    attempt.startedAt = std::chrono::sys_seconds(std::chrono::seconds(1'800'000'000));
    auto kept = AttemptFolder::begin(attemptsFolder(root_ / "library"), attempt);
    EXPECT_TRUE(kept) << kept.error();
    write(recordingOf(caseId), kept->folder() / "find.seq.mha");
    StepOutcome outcome;
    outcome.stepId = "find";
    outcome.recording = "find.seq.mha";
    outcome.score = 0.5;
    EXPECT_TRUE(kept->beginStep("find"));
    EXPECT_TRUE(kept->endStep(outcome));
    return kept->folder();
  }
  fs::path root_;
};

TEST(FormedIn, KeepsPosesSettingsAndNotesAndTakesTheSceneOfTheCase) {
  ScanLog log = test::logOf(5, 0.5, [](int n, ScanState& state) {
    state.pose = test::at({1.0 * n, 0.0, 0.0});
    state.knobs.gain = n < 3 ? 1.0 : 1.5;
    state.scene.noise.emplace();
  });
  log.addNote(2.0, "mark", {{"text", "here"}});
  Scene asked;
  asked.gainAndDgc = true;
  asked.tissues = {{.label = 3, .name = "liver"}};
  const ScanLog formed = formedIn(log, asked);
  ASSERT_EQ(formed.frameCount(), log.frameCount());
  for (std::size_t n = 0; n < log.frameCount(); ++n) {
    ScanState expected = log.frame(n);
    expected.scene = asked;
    EXPECT_EQ(formed.frame(n), expected) << n;
  }
  EXPECT_TRUE(std::holds_alternative<Note>(formed.events().back().what));
}

TEST_F(ScanShelfTest, HoldsLessonsThatWereTriedAndThoseAtHand) {
  const fs::path open = makeCase("b-open", "open");
  makeCase("a-tried", "tried");
  makeCase("c-untried", "untried");
  makeAttempt("20260101-000000-00000001", "tried");
  makeAttempt("20260102-000000-00000002", "tried");
  makeAttempt("20260103-000000-00000003", "nowhere");
  const auto shelf = readShelf(root_ / "library", open);
  ASSERT_TRUE(shelf) << shelf.error();
  ASSERT_EQ(shelf->lessons.size(), 2U);
  EXPECT_EQ(shelf->lessons[0].home.id, "tried");
  ASSERT_EQ(shelf->lessons[0].attempts.size(), 2U);
  EXPECT_GT(shelf->lessons[0].attempts[0].second.id, shelf->lessons[0].attempts[1].second.id) << "the latest first";
  EXPECT_EQ(shelf->lessons[1].home.id, "open");
  EXPECT_TRUE(shelf->lessons[1].attempts.empty());
  EXPECT_EQ(shelf->strayAttempts, 1U);
  EXPECT_TRUE(shelf->problems.empty());
}

TEST_F(ScanShelfTest, HoldsWhatTheLessonsAreCalledInTheReadersLanguage) {
  const fs::path folder = makeCase("a", "one");
  const auto asWritten = readShelf(root_ / "library", folder);
  ASSERT_TRUE(asWritten);
  const std::string title = asWritten->lessons.front().lesson.title;
  ASSERT_TRUE(setCaseWord(folder, "de", title, "Auf Deutsch"));
  EXPECT_EQ(asWritten->lessons.front().words.of(title), title);
  const auto german = readShelf(root_ / "library", folder, noProgress(), "de_AT");
  ASSERT_TRUE(german);
  EXPECT_EQ(german->lessons.front().lesson.title, title) << "attempts are compared with the lesson as it was written";
  EXPECT_EQ(german->lessons.front().words.of(title), "Auf Deutsch");
}

TEST_F(ScanShelfTest, OpensTheExpertsPartAndTheTraineesStep) {
  const fs::path folder = makeCase("a", "one");
  const fs::path attempt = makeAttempt("20260101-000000-00000001", "one");
  const auto shelf = readShelf(root_ / "library", folder);
  ASSERT_TRUE(shelf);
  const LessonAttempts& shelved = shelf->lessons.front();
  const auto experts = expertScansOf(shelved.home, shelved.lesson);
  ASSERT_EQ(experts.size(), 1U);
  EXPECT_EQ(usualExpertFor(shelved.lesson, "find", experts), 0U);
  const auto expert = openScan(experts[0]);
  ASSERT_TRUE(expert) << expert.error();
  EXPECT_EQ(expert->part, (Part{1.0, 4.0}));
  EXPECT_EQ(expert->marks().size(), 1U);
  const auto choice = scanOfStep(attempt, shelved.attempts[0].second, shelved.lesson.steps[1]);
  ASSERT_TRUE(choice);
  const auto trainee = openScan(*choice);
  ASSERT_TRUE(trainee) << trainee.error();
  EXPECT_EQ(trainee->part, (Part{0.0, 10.0}));
  EXPECT_FALSE(scanOfStep(attempt, shelved.attempts[0].second, shelved.lesson.steps[2])) << "never ended";
  const auto home = caseOf(*trainee, *shelf, root_ / "library");
  ASSERT_TRUE(home);
  EXPECT_EQ(*home, folder);
}

TEST_F(ScanShelfTest, SaysWhichCaseIsNotThere) {
  ScanExcerpt stray;
  stray.choice.file = "far.seq.mha";
  stray.recording = recordingOf("gone");
  const auto home = caseOf(stray, {}, root_ / "library");
  ASSERT_FALSE(home);
  EXPECT_EQ(home.error().code, ErrorCode::notFound);
  EXPECT_NE(home.error().sentence().find("far.seq.mha"), std::string::npos);
}

TEST_F(ScanShelfTest, PrefersTheExpertsScanOfTheSameCaseBeforeTheStep) {
  WatchTask watch;
  watch.recording = "a.seq.mha";
  Lesson lesson;
  lesson.steps = {stepOf("w1", watch),        stepOf("w2", watch, "other"), stepOf("w3", watch),
                  stepOf("find", FreeTask{}), stepOf("w4", watch),          stepOf("far", FreeTask{}, "other")};
  std::vector<ScanChoice> scans;
  for (const char* id : {"w1", "w2", "w3", "w4"}) {
    scans.emplace_back();
    scans.back().stepId = id;
  }
  EXPECT_EQ(usualExpertFor(lesson, "find", scans), 2U);
  EXPECT_EQ(usualExpertFor(lesson, "far", scans), 1U);
  EXPECT_EQ(usualExpertFor(lesson, "w1", scans), 0U);
}

}  // namespace
}  // namespace ew::review
