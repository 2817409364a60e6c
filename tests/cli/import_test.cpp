#include <gtest/gtest.h>

#include "cli/cli_world.h"
#include "ew/io/sequence.h"
#include "ew/io/volume_file.h"
#include "io/dicom_files.h"

namespace ew::test::import_test {
namespace {

TEST(ImportCommand, ACineBecomesASequenceAndTheReportNamesWhatWasLeftOut) {
  const TemporaryFolder folder;
  CineOf of;
  of.pixels = ramp(144);
  writeText(folder / "a.dcm", cineFile(of));
  const auto outcome = run({"import", folder / "a.dcm", "-o", folder / "a.igs.mha", "--report", folder / "r.json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto sequence = readSequence(folder / "a.igs.mha");
  ASSERT_TRUE(sequence.has_value());
  EXPECT_EQ(sequence->pixels.size(), 144u);
  EXPECT_NEAR(sequence->frames[1].transforms.at(0).matrix[0][0], 0.2, 1e-12);
  const auto report = readJson(folder / "r.json");
  EXPECT_EQ(report["removed"]["private_fields"], 1);
  EXPECT_NE(report["removed"]["fields"].dump().find("Patient's Name"), std::string::npos);
  for (const std::string& text : {readText(folder / "r.json"), readText(folder / "a.igs.mha"), outcome.out, outcome.err})
    EXPECT_EQ(text.find("Doe"), std::string::npos);
}

TEST(ImportCommand, WhatIsMissingIsAskedForByTheNameOfItsOptionAndNothingIsWritten) {
  const TemporaryFolder folder;
  CineOf of;
  of.pixels = ramp(144);
  of.regions = {{0, 0, 3, 5}, {4, 0, 7, 5}};
  writeText(folder / "a.dcm", cineFile(of));
  const auto asked = run({"import", folder / "a.dcm", "-o", folder / "a.igs.mha"});
  EXPECT_EQ(asked.status, 1);
  EXPECT_NE(asked.err.find("--region N."), std::string::npos) << asked.err;
  EXPECT_EQ(folder.names(), std::vector<std::string>{"a.dcm"});
  EXPECT_EQ(run({"import", folder / "a.dcm", "-o", folder / "a.igs.mha", "--region", "2", "--blank", "0,0,1,1"}).status, 0);
  writeText(folder / "x.bin", ramp(100));
  const auto raw = run({"import", folder / "x.bin", "-o", folder / "x.mha"});
  EXPECT_NE(raw.err.find("--raw"), std::string::npos) << raw.err;
  EXPECT_EQ(run({"import", folder / "x.bin", "-o", folder / "x.mha", "--raw", "5x5x4:u8:0.5"}).status, 0);
  EXPECT_EQ(readVolume(folder / "x.mha")->volume.grid.dims, glm::ivec3(5, 5, 4));
  EXPECT_NE(run({"import", folder / "x.bin", "-o", folder / "x.mha", "--raw", "5x5:u8:0.5"}).status, 0);
}

TEST(ImportCommand, ARegionOfAlmostNothingIsRefusedUntilItIsMeant) {
  const TemporaryFolder folder;
  CineOf of;
  of.pixels = ramp(144);
  of.regions = {{0, 0, 1, 1}};
  writeText(folder / "a.dcm", cineFile(of));
  const auto refused = run({"import", folder / "a.dcm", "-o", folder / "a.igs.mha"});
  EXPECT_EQ(refused.status, 1);
  EXPECT_NE(refused.err.find(": --accept-small."), std::string::npos) << refused.err;
  EXPECT_EQ(folder.names(), std::vector<std::string>{"a.dcm"});
  EXPECT_EQ(run({"import", folder / "a.dcm", "-o", folder / "a.igs.mha", "--accept-small"}).status, 0);
}

TEST(ImportCommand, ARateIsGivenToACineWithoutTimes) {
  const TemporaryFolder folder;
  CineOf of;
  of.pixels = ramp(144);
  of.frameTime = "0";
  writeText(folder / "a.dcm", cineFile(of));
  ASSERT_EQ(run({"import", folder / "a.dcm", "-o", folder / "a.igs.mha", "--rate", "25"}).status, 0);
  const auto sequence = readSequence(folder / "a.igs.mha");
  ASSERT_TRUE(sequence.has_value());
  EXPECT_NEAR(sequence->frames[2].time_s.value_or(0.0), 0.08, 1e-9);
}

TEST(ImportCommand, EverythingThatIsMissingIsAskedForAtOnce) {
  const TemporaryFolder folder;
  CineOf of;
  of.pixels = ramp(144);
  of.regions = {};
  of.burnedIn = "YES";
  writeText(folder / "a.dcm", cineFile(of));
  const auto asked = run({"import", folder / "a.dcm", "-o", folder / "a.igs.mha"});
  EXPECT_EQ(asked.status, 1);
  EXPECT_NE(asked.err.find("--pixel-mm"), std::string::npos) << asked.err;
  EXPECT_NE(asked.err.find("It also asks for --region N, --blank X,Y,W,H or --keep-text."), std::string::npos) << asked.err;
  EXPECT_EQ(run({"import", folder / "a.dcm", "-o", folder / "a.igs.mha", "--pixel-mm", "0.2", "--keep-text"}).status, 0);
}

TEST(ImportCommand, AnImportedCineIsReconstructedOnceSomebodySaysHowTheProbeMoved) {
  const TemporaryFolder folder;
  CineOf of;
  of.pixels = ramp(144);
  writeText(folder / "a.dcm", cineFile(of));
  ASSERT_EQ(run({"import", folder / "a.dcm", "-o", folder / "a.igs.mha"}).status, 0);
  const auto asked = run({"reconstruct", folder / "a.igs.mha", "-o", folder / "v.mha"});
  EXPECT_EQ(asked.status, 1);
  EXPECT_NE(asked.err.find("--motor"), std::string::npos) << asked.err;
  EXPECT_EQ(asked.err.find("as the target"), std::string::npos) << asked.err;
  writeText(folder / "m.json", R"({"format": 1, "kind": "parallel", "step_mm": 0.5})");
  const auto made = run({"reconstruct", folder / "a.igs.mha", "-o", folder / "v.mha", "--motor", folder / "m.json", "--spacing", "0.1"});
  EXPECT_EQ(made.status, 0) << made.err;
  EXPECT_NE(made.err.find("middle of their upper edge"), std::string::npos) << made.err;
  const auto volume = readVolume(folder / "v.mha");
  ASSERT_TRUE(volume.has_value());
  EXPECT_EQ(volume->volume.grid.dims.z, 11);
}

}  // namespace
}  // namespace ew::test::import_test
