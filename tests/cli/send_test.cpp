#include <gtest/gtest.h>

#include "cli/cli_world.h"
#include "ew/io/dicom.h"
#include "places.h"
#include "scanning/small_scan.h"

namespace ew::test::send_command_test {
namespace {

class SendCommand : public ::testing::Test {
 protected:
  Outcome report(const std::string& name) {
    return run({"measure", "--package", "obstetric", "--value", "BPD=82mm", "--dicom", folder_ / name});
  }
  Outcome send(std::vector<std::string> more) {
    std::vector<std::string> words{"send", "--outbox",  folder_ / "outbox", "--host",   "127.0.0.1", "--port",
                                   "1",    "--archive", "NOBODY",           "--rounds", "1"};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  }
  EnvironmentValue resources_{"ECHOWEAVE_RESOURCES", std::string(EW_SOURCE_DIR) + "/resources"};
  EnvironmentValue cases_{"ECHOWEAVE_CASES", std::string(EW_SOURCE_DIR) + "/cases"};
  const TemporaryFolder folder_;
};

TEST_F(SendCommand, WritesAWorksheetAsADicomReport) {
  const auto outcome = report("r.dcm");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "Wrote " + (folder_ / "r.dcm") + ".\n");
  const std::string bytes = readText(folder_ / "r.dcm");
  EXPECT_EQ(bytes.substr(128, 4), "DICM");
  EXPECT_NE(bytes.find("1.2.840.10008.5.1.4.1.1.88.33"), std::string::npos);
  const auto lonely = run({"measure", "--package", "obstetric", "--value", "BPD=82mm", "--patient", "fetal-biometry"});
  EXPECT_EQ(lonely.status, 2);
  EXPECT_NE(lonely.err.find("--dicom"), std::string::npos) << lonely.err;
}

TEST_F(SendCommand, WritesARecordingAsOneDicomClipWithItsTimes) {
  ASSERT_TRUE(writeVolume(*waves(), folder_ / "v.mha"));
  ScanRecording recording;
  recording.size_px = {160, 120};
  for (int n = 0; n < 12; ++n) recording.log.addFrame(movingState(n));
  ASSERT_TRUE(writeRecording(recording, folder_ / "r.seq.mha"));
  const auto outcome =
      run({"replay", folder_ / "v.mha", "--scan", folder_ / "r.seq.mha", "-o", folder_ / "clip.dcm", "--every", "2", "--quiet"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto clip = inspectDicom(folder_ / "clip.dcm");
  ASSERT_TRUE(clip) << clip.error();
  EXPECT_EQ(clip->frames, 6U);
  EXPECT_EQ(clip->columns, 160);
  ASSERT_EQ(clip->regions.size(), 1U);
  Replay replay(recording.log, waveSubject());
  replay.make(0, 160, 120);
  EXPECT_NEAR(clip->regions[0].pixel_mm().x, replay.scanner().geometry().pixel_mm, 1e-9);
}

TEST_F(SendCommand, RefusesAClipWhoseScaleChanges) {
  ASSERT_TRUE(writeVolume(*waves(), folder_ / "v.mha"));
  ScanRecording recording;
  recording.size_px = {160, 120};
  for (int n = 0; n < 6; ++n) {
    ScanState state = movingState(n);
    state.knobs.depth_mm = n < 3 ? 40.0 : 55.0;
    recording.log.addFrame(state);
  }
  ASSERT_TRUE(writeRecording(recording, folder_ / "r.seq.mha"));
  const auto outcome = run({"replay", folder_ / "v.mha", "--scan", folder_ / "r.seq.mha", "-o", folder_ / "clip.dcm"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("In image 4"), std::string::npos) << outcome.err;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "clip.dcm"));
}

TEST_F(SendCommand, KeepsWhatNoArchiveTookAndTakesNothingTwice) {
  ASSERT_EQ(report("r.dcm").status, 0);
  const auto outcome = send({folder_ / "r.dcm"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("safe in the outbox: 1."), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("NOBODY"), std::string::npos) << outcome.err;
  std::filesystem::remove(folder_ / "r.dcm");
  EXPECT_NE(send({}).err.find("safe in the outbox: 1."), std::string::npos);
  EXPECT_EQ(send({folder_ / "missing.dcm"}).status, 1);
  writeText(folder_ / "text.dcm", "no DICOM at all");
  const auto odd = send({folder_ / "text.dcm"});
  EXPECT_EQ(odd.status, 1);
  EXPECT_NE(odd.err.find("text.dcm"), std::string::npos) << odd.err;
  EXPECT_NE(send({"--archive", "a title that is far too long"}).status, 0);
}

TEST_F(SendCommand, SaysThatAnArchiveCannotBeReachedAndCountsNothing) {
  ASSERT_EQ(report("r.dcm").status, 0);
  const auto outcome = send({folder_ / "r.dcm"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("The archive NOBODY at 127.0.0.1 port 1 cannot be reached (Connection refused); check its host, its port and "
                             "the network."),
            std::string::npos)
      << outcome.err;
  EXPECT_EQ(outcome.out.find("The archive has"), std::string::npos) << outcome.out;
}

TEST_F(SendCommand, SaysThatBytesLieBehindTheDataSet) {
  ASSERT_TRUE(writeVolume(*waves(), folder_ / "v.mha"));
  ScanRecording recording;
  recording.size_px = {160, 120};
  for (int n = 0; n < 3; ++n) recording.log.addFrame(movingState(n));
  ASSERT_TRUE(writeRecording(recording, folder_ / "r.seq.mha"));
  ASSERT_EQ(run({"replay", folder_ / "v.mha", "--scan", folder_ / "r.seq.mha", "-o", folder_ / "clip.dcm", "--quiet"}).status, 0);
  writeText(folder_ / "tail.dcm", readText(folder_ / "clip.dcm") + "\r\n");
  const auto outcome = send({folder_ / "tail.dcm"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("tail.dcm' has bytes behind its data set, or lacks the mark that ends its pixels; its images are read here, "
                             "but archives take whole DICOM objects only: export it anew from the program that wrote it."),
            std::string::npos)
      << outcome.err;
}

TEST_F(SendCommand, SaysThatNothingWasWaiting) {
  const auto outcome = send({});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("Nothing was waiting"), std::string::npos) << outcome.out;
  EXPECT_EQ(outcome.out.find("The archive has"), std::string::npos) << outcome.out;
}

}  // namespace
}  // namespace ew::test::send_command_test
