// A recording that is kept while it grows is the same recording again, however it ends.
#include "ew/scanning/recording_journal.h"

#include <gtest/gtest.h>

#include "ew/io/safe_file.h"
#include "io/files.h"
#include "scanning/small_scan.h"

namespace ew::recording_journal_test {
namespace {

ScanRecording grown(int frames) {
  ScanRecording recording;
  recording.caseId = "a-case";
  recording.title = "Pain \"after\" meals \xC3\xBC\nand more";
  recording.size_px = {320, 240};
  for (int n = 0; n < frames; ++n) {
    ScanState state = test::movingState(n);
    state.gaps_mm = {0.25F, 1e-7F, 3.0F + 0.1F * static_cast<float>(n)};
    if (n == 3) state.pose.status = PoseStatus::missing;
    if (n % 2 == 1) state.body = {0.1 * n, 0.5, 1.0 / 3.0};
    recording.log.addFrame(state);
    if (n == 2) recording.log.setFrozen(state.time_s + 0.01, true);
  }
  recording.log.addNote(recording.log.end_s() + 0.5, "mark", {{"here", "it is"}});
  return recording;
}

class RecordingJournal : public ::testing::Test {
 protected:
  test::TempFolder folder;
  [[nodiscard]] std::filesystem::path keep(const std::string& text) const {
    const auto file = folder / "scan.jsonl";
    EXPECT_TRUE(writeFileSafely(file, text));
    return file;
  }
};

TEST_F(RecordingJournal, GivesTheRecordingAgainToTheBit) {
  const ScanRecording recording = grown(6);
  // As it grows: now and then what is new.
  std::string text = journalHead(recording);
  ScanLog growing;
  std::size_t kept = 0;
  for (const ScanEvent& event : recording.log.events()) {
    growing.add(event);
    if (growing.events().size() % 3 != 0) continue;
    text += journalLines(growing, kept);
    kept = growing.events().size();
  }
  text += journalLines(growing, kept);
  const auto again = readJournal(keep(text));
  ASSERT_TRUE(again) << again.error();
  EXPECT_EQ(again->caseId, recording.caseId);
  EXPECT_EQ(again->title, recording.title);
  EXPECT_EQ(again->size_px, recording.size_px);
  EXPECT_TRUE(again->notes.empty());
  EXPECT_TRUE(again->log.events() == recording.log.events());
}

TEST_F(RecordingJournal, LosesTheLineThatACrashFellIntoAndNoOther) {
  const ScanRecording recording = grown(6);
  const std::string lines = journalHead(recording) + journalLines(recording.log, 0);
  for (const std::size_t missing : {1U, 2U, 40U}) {
    const auto again = readJournal(keep(lines.substr(0, lines.size() - missing)));
    ASSERT_TRUE(again) << again.error();
    ASSERT_EQ(again->log.events().size() + 1, recording.log.events().size());
    EXPECT_TRUE(std::equal(again->log.events().begin(), again->log.events().end(), recording.log.events().begin()));
  }
}

TEST_F(RecordingJournal, DamageInTheMiddleEndsItWithANote) {
  const ScanRecording recording = grown(6);
  std::string lines = journalHead(recording) + journalLines(recording.log, 0);
  const std::size_t third = lines.find("\"number\"", lines.size() / 2);
  ASSERT_NE(third, std::string::npos);
  lines[third] = '#';
  const auto again = readJournal(keep(lines));
  ASSERT_TRUE(again) << again.error();
  EXPECT_LT(again->log.frameCount(), recording.log.frameCount());
  EXPECT_EQ(again->notes.size(), 1U);
}

TEST_F(RecordingJournal, RefusesWhatIsNone) {
  const ScanRecording recording = grown(1);
  EXPECT_EQ(readJournal(folder / "none.jsonl").error().code, ErrorCode::notFound);
  EXPECT_FALSE(readJournal(keep("[1, 2]\n")));
  EXPECT_FALSE(readJournal(keep(R"({"recording": 1, "case": "a", "title": "b", "size_px": [0, -4]})"
                                "\n")));
  EXPECT_EQ(readJournal(keep(R"({"recording": 7, "case": "a", "title": "b", "size_px": [4, 4]})"
                             "\n"))
                .error()
                .code,
            ErrorCode::newerFormat);
}

TEST_F(RecordingJournal, ThatEndsBeforeItsFirstImageIsToldFromOneThatCannotBeRead) {
  const ScanRecording recording = grown(1);
  const std::string head = journalHead(recording), lines = journalLines(recording.log, 0);
  for (const std::string& cut : {std::string(), head.substr(0, head.size() / 2), head, head + lines.substr(0, lines.find('\n'))})
    EXPECT_EQ(readJournal(keep(cut)).error().code, ErrorCode::truncated) << cut;
  const auto damaged = readJournal(keep(head + "#" + lines));
  ASSERT_FALSE(damaged);
  EXPECT_EQ(damaged.error().code, ErrorCode::badField) << "there may be images in it";
  EXPECT_NE(damaged.error().sentence().find("line 2"), std::string::npos) << damaged.error();
}

}  // namespace
}  // namespace ew::recording_journal_test
