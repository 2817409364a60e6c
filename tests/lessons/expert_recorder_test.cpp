#include "logic/expert_recorder.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <random>
#include <thread>

#include "ew/io/volume_file.h"
#include "ew/library/case.h"
#include "ew/library/lesson_links.h"
#include "lessons/made_scene.h"
#include "library/temporary_folder.h"
#include "logic/lesson_edits.h"

namespace ew::lessons {
namespace {

namespace fs = std::filesystem;
using ew::test::TemporaryFolder;
using test::held;
using test::image;

void show(ExpertRecorder& recorder, double time_s) {
  const ScanState state = image(held(time_s), time_s);
  recorder.see({time_s, FrameMade{state.pose, {}, state.number, {}}}, state, {640, 480});
}

ScanRecording recorded(int images, double offset_mm = 0.0) {
  ScanRecording made;
  made.caseId = "home";
  for (int n = 0; n < images; ++n) made.log.addFrame(image(held(offset_mm + n), 0.1 * n));
  return made;
}

TEST(ExpertRecorder, HasItsOwnClockThatStandsWhileItIsPaused) {
  ExpertRecorder recorder;
  recorder.start("home", "Title", 100.0);
  show(recorder, 100.5);
  show(recorder, 101.0);
  recorder.pause(102.0);
  show(recorder, 103.0);
  EXPECT_DOUBLE_EQ(recorder.length_s(150.0), 2.0);
  recorder.goOn(200.0);
  show(recorder, 200.5);
  recorder.mark(201.0);
  const auto made = recorder.stop(201.0);
  ASSERT_TRUE(made);
  ASSERT_EQ(made->log.frameCount(), 3u);
  EXPECT_DOUBLE_EQ(made->log.frameTime_s(0), 0.5);
  EXPECT_DOUBLE_EQ(made->log.frameTime_s(1), 1.0);
  EXPECT_DOUBLE_EQ(made->log.frameTime_s(2), 2.5);
  EXPECT_EQ(recorder.marks_s(), std::vector<double>{3.0});
  EXPECT_EQ(made->log.frame(2).pose.probeToWorld, held(200.5));
  EXPECT_EQ(made->size_px, glm::ivec2(640, 480));
}

TEST(ExpertRecorder, HoldsWhatWasRecordedUntilItIsDiscarded) {
  ExpertRecorder recorder;
  recorder.start("home", "Title", 0.0);
  show(recorder, 0.5);
  recorder.mark(0.7);
  ASSERT_TRUE(recorder.stop(1.0));
  ASSERT_TRUE(recorder.isPaused()) << "whoever writes it may fail";
  const auto again = recorder.stop(9.0);
  ASSERT_TRUE(again);
  EXPECT_EQ(again->log.frameCount(), 1u);
  EXPECT_EQ(recorder.marks_s(), std::vector<double>{0.7});
  EXPECT_DOUBLE_EQ(recorder.length_s(20.0), 1.0);
  recorder.goOn(10.0);
  show(recorder, 10.5);
  EXPECT_EQ(recorder.stop(11.0)->log.frameCount(), 2u) << "and it can be gone on with";
  recorder.discard();
  EXPECT_FALSE(recorder.isRecording());
}

TEST(ExpertRecorder, TakesNothingBeyondItsLongestTime) {
  ExpertRecorder recorder;
  recorder.start("home", "Title", 0.0);
  show(recorder, 1.0);
  show(recorder, kLongestExpertScan_s + 1.0);
  EXPECT_TRUE(recorder.isFull(kLongestExpertScan_s));
  EXPECT_FALSE(recorder.isFull(kLongestExpertScan_s - 1.0));
  EXPECT_EQ(recorder.stop(kLongestExpertScan_s + 1.0)->log.frameCount(), 1u);
}

TEST(ExpertRecorder, SaysThatNothingWasScanned) {
  ExpertRecorder recorder;
  recorder.start("home", "Title", 0.0);
  const auto made = recorder.stop(1.0);
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, ErrorCode::badUsage);
  EXPECT_FALSE(recorder.isRecording());
}

TEST(KeptRecording, IsCalledByItsContentAndNeverWrittenOver) {
  const TemporaryFolder folder;
  const auto first = keepRecording(recorded(5), folder.path());
  ASSERT_TRUE(first) << first.error();
  const auto again = keepRecording(recorded(5), folder.path());
  const auto other = keepRecording(recorded(6), folder.path());
  ASSERT_TRUE(again && other);
  EXPECT_EQ(*first, *again);
  EXPECT_NE(*first, *other);
  EXPECT_EQ(first->size(), std::string("scans/0123456789abcdef.seq.mha").size());
  EXPECT_EQ(readRecording(folder.path() / *first)->log.frameCount(), 5u);
  EXPECT_EQ(readRecording(folder.path() / *other)->log.frameCount(), 6u);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path() / "scans"), {}), 2);
}

TEST(KeptRecording, LeavesNothingBehindWhereItCannotBeWritten) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "scans") << "a file in the way";
  const auto kept = keepRecording(recorded(3), folder.path());
  ASSERT_FALSE(kept);
  EXPECT_EQ(kept.error().code, ErrorCode::notWritable);
}

// A case with a step that names a recording; each kill comes somewhere between recording and saving, as in the editor: the recording is
// put into the case, and only then named.
TEST(ExpertScanKilled, WhileItIsWrittenLeavesACaseThatOpensAndNoHalfRecording) {
  const TemporaryFolder folder;
  const fs::path home = folder.path() / "case";
  fs::create_directories(home);
  Volume volume;
  volume.grid.dims = glm::ivec3(4);
  volume.echo.assign(volume.grid.voxelCount(), 7);
  ASSERT_TRUE(writeVolume(volume, home / "volume.mha"));
  std::ofstream(home / "case.json") << R"({"format": 1, "id": "home", "title": "Home", "region": "abdomen",
    "volume": {"file": "volume.mha", "file_to_world": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]}, "probes": ["convex-3.5"]})";
  const auto prepared = loadCase(home);
  ASSERT_TRUE(prepared) << prepared.error();
  const auto work = [&](int n) {
    const auto name = keepRecording(recorded(200, n), home / "parts/lessons");
    auto opened = loadCase(home);
    if (!name || !opened) ::_exit(1);
    Lesson lesson = newLesson("Lesson", "en", {{"watch", "Watch"}});
    lesson.id = "lesson";
    lesson.steps.front().task = WatchTask{*name, {}, {}, {}};
    opened->otherFields["parts"]["lessons"] = withLessons(nullptr, {lesson});
    if (!saveCase(*opened, home)) ::_exit(2);
  };
  const auto begun = std::chrono::steady_clock::now();
  work(0);
  const auto usual = std::chrono::duration_cast<std::chrono::microseconds>(std::chrono::steady_clock::now() - begun);

  std::mt19937 dice(5);
  int killed = 0;
  for (int n = 1; n <= 50; ++n) {
    const pid_t child = ::fork();
    if (child == 0) {
      work(n);
      ::_exit(0);
    }
    std::this_thread::sleep_for(usual * static_cast<int>(dice() % 1200) / 1000);
    ::kill(child, SIGKILL);
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    killed += WIFSIGNALED(status) ? 1 : 0;
    ASSERT_TRUE(WIFSIGNALED(status) || WEXITSTATUS(status) == 0);

    const auto opened = loadCase(home);
    ASSERT_TRUE(opened) << opened.error();
    const auto lessons = lessonsOf(*opened);
    ASSERT_TRUE(lessons && lessons->size() == 1);
    const auto& task = std::get<WatchTask>(lessons->front().steps.front().task);
    const auto named = readRecording(home / "parts/lessons" / task.recording);
    ASSERT_TRUE(named) << named.error();
    EXPECT_TRUE(named->notes.empty());
    for (const auto& each : fs::directory_iterator(home / "parts/lessons/scans")) {
      if (each.path().filename().string().starts_with(".")) continue;  // left aside: no file of the case
      const auto read = readRecording(each.path());
      ASSERT_TRUE(read) << each.path() << ": " << read.error();
      EXPECT_EQ(read->log.frameCount(), 200u) << each.path();
    }
  }
  EXPECT_GT(killed, 5) << "too few were killed in the middle to show anything";
  ASSERT_TRUE(keepRecording(recorded(3), home / "parts/lessons"));
  for (const auto& each : fs::directory_iterator(home / "parts/lessons/scans"))
    EXPECT_FALSE(each.path().filename().string().starts_with(".ew-new-")) << "what killed programs left aside is swept out";
}

}  // namespace
}  // namespace ew::lessons
