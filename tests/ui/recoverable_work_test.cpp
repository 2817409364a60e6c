// What a window left behind that ended without being asked: what of it cannot be read is told from what is not there.
#include <gtest/gtest.h>

#include <map>

#include "ew/scanning/recording_journal.h"
#include "ew/ui_test_door/work_autosave.h"
#include "library/temporary_folder.h"
#include "scanning/small_scan.h"

namespace ew::ui::recoverable_work_test {
namespace {

RecoverableWork leftWith(const std::map<std::string, std::string>& items,
                         const std::string& about = R"({"kind": "window", "path": "/cases/one", "volumes": []})") {
  const test::TemporaryFolder folder;
  const auto own = folder / "kept" / "one";
  test::writeText(own / "lock", "");
  test::writeText(own / "about.json", about);
  for (const auto& [name, text] : items) test::writeText(own / name, text);
  return readLeftWork(std::move(Autosave(folder / "kept").takeLeft().at(0)));
}

std::string scanned(int frames) {
  ScanRecording recording;
  recording.size_px = {320, 240};
  for (int n = 0; n < frames; ++n) recording.log.addFrame(test::movingState(n));
  return journalHead(recording) + journalLines(recording.log, 0);
}

TEST(RecoverableWork, IsNothingWhereNobodyWouldMissAnything) {
  const std::string scan = scanned(1);
  const std::vector<std::map<std::string, std::string>> nothing = {
      {},
      {{"recording.jsonl", ""}},
      {{"recording.jsonl", scan.substr(0, scan.find('\n') + 20)}},
      {{"volume-7.mha", "given up"}, {".new-volume-8.mha", "half"}},
  };
  for (const auto& items : nothing) {
    const RecoverableWork work = leftWith(items);
    EXPECT_TRUE(work.isEmpty());
    EXPECT_TRUE(work.unread.empty());
  }
}

TEST(RecoverableWork, SaysWhatOfItCannotBeRead) {
  std::string newer = scanned(3);
  newer.replace(newer.find("\"recording\":1,"), 14, "\"recording\":99,");
  for (const auto& [name, text] : std::map<std::string, std::string>{
           {"recording.jsonl", newer}, {"measured.json", "{\"work\": {}, "}, {"film.mkv", "of a newer program"}}) {
    const RecoverableWork work = leftWith({{name, text}});
    EXPECT_TRUE(work.isEmpty()) << name;
    ASSERT_EQ(work.unread.size(), 1u) << name;
    EXPECT_NE(work.unread[0].english().find(name), std::string::npos) << work.unread[0].english();
    EXPECT_EQ(linesOf(work).size(), 1) << name;
  }
}

TEST(RecoverableWork, BelongsToAPatientOnceSomethingOfItWasRecorded) {
  EXPECT_FALSE(leftWith({}).isOfPatient());
  EXPECT_TRUE(leftWith({{"recording.jsonl", scanned(3)}}).isOfPatient());
}

/// What an author was recording for a lesson when the program ended is offered as that.
TEST(RecoverableWork, OfAnExpertsScanSaysWhatItWasFor) {
  const RecoverableWork work =
      leftWith({{"recording.jsonl", scanned(3)}}, R"({"kind": "expert_scan", "path": "/cases/one", "title": "A ball"})");
  EXPECT_EQ(work.kind, kExpertScanWork);
  ASSERT_TRUE(work.recording);
  EXPECT_EQ(work.recording->log.frameCount(), 3u);
  ASSERT_EQ(linesOf(work).size(), 1);
  EXPECT_TRUE(linesOf(work).front().startsWith(QStringLiteral("An expert's scan that was being recorded for a lesson:")));
}

TEST(RecoverableWork, HasWhatCouldBeReadBesideWhatCouldNot) {
  std::string scan = scanned(6);
  const std::size_t ofTheLast = scan.rfind("\"number\"");
  ASSERT_NE(ofTheLast, std::string::npos);
  scan[ofTheLast] = '#';
  const RecoverableWork work = leftWith({{"recording.jsonl", scan}});
  ASSERT_TRUE(work.recording);
  EXPECT_EQ(work.recording->log.frameCount(), 5u);
  EXPECT_EQ(work.unread.size(), 1u);
}

}  // namespace
}  // namespace ew::ui::recoverable_work_test
