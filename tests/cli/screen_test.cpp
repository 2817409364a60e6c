#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <random>

#include "cli/cli_world.h"
#include "ew/acquisition/import.h"
#include "ew/acquisition/screen.h"
#include "ew/io/clip_file.h"
#include "ew/io/image_file.h"
#include "ew/io/sequence.h"

namespace ew::test::screen_test {
namespace {

FanOutline drawnFan() {
  FanOutline fan;
  fan.shape = FanShape::convex;
  fan.apex_px = {200.0, -40.0};
  fan.left_rad = -0.5;
  fan.right_rad = 0.5;
  fan.near_px = 90.0;
  fan.far_px = 310.0;
  return fan;
}

/// A film of noise in a fan, with a scale of marks 22 pixels apart at its right.
void writeScreenFilm(const std::filesystem::path& file, bool withScan = true) {
  auto clip = ClipWriter::open(file, 420, 300, 20.0);
  ASSERT_TRUE(clip) << clip.error();
  const GreyImage mask = maskOf(drawnFan(), 420, 300);
  std::mt19937 random(7);
  for (int n = 0; n < 10; ++n) {
    RgbImage image(420, 300);
    for (std::size_t p = 0; p < image.pixels.size(); ++p)
      if (withScan && mask.pixels[p] != 0) image.pixels[p] = Rgb(static_cast<std::uint8_t>(40 + random() % 180));
    for (int tick = 0; tick < 11; ++tick)
      for (int x = 380; x < 388; ++x) viewOf(image).at(x, 50 + 22 * tick) = Rgb(240);
    ASSERT_TRUE(clip->add(image));
  }
  ASSERT_TRUE(clip->finish());
}

TEST(ScreenCommand, AFilmBecomesACleanedSequenceThatAcquisitionOpens) {
  const TemporaryFolder folder;
  writeScreenFilm(folder / "screen.avi");
  const auto made = run({"screen", folder / "screen.avi", "-o", folder / "scan.igs.mha", "--tick", "5", "--device-set", folder / "scan.xml",
                         "--report", folder / "r.json"});
  ASSERT_EQ(made.status, 0) << made.err;
  EXPECT_NE(made.out.find("convex"), std::string::npos) << made.out;
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"r.json", "scan.igs.mha", "scan.screen.json", "scan.xml", "screen.avi"}));
  const auto report = readJson(folder / "r.json");
  EXPECT_EQ(report["verdict"], "found");
  EXPECT_EQ(report["command"], "screen");
  EXPECT_NEAR(report["quality"]["tick_spacing_px"].get<double>(), 22.0, 0.1);
  EXPECT_NEAR(report["quality"]["pixel_mm"].get<double>(), 5.0 / 22.0, 0.002);
  EXPECT_NEAR(report["outline"]["apex_px"][1].get<double>(), -40.0, 4.0);
  const auto sequence = readSequence(folder / "scan.igs.mha");
  ASSERT_TRUE(sequence) << sequence.error();
  EXPECT_EQ(sequence->frames.size(), 10u);
  EXPECT_NEAR(*sequence->frames[3].time_s, 0.15, 0.002);
  ASSERT_EQ(sequence->frames[0].transforms.size(), 1u);
  EXPECT_NEAR(sequence->frames[0].transforms[0].matrix[0][0], 5.0 / 22.0, 0.002);

  // With a motor that says how the probe moved it becomes a volume.
  writeText(folder / "motor.json", R"({"format": 1, "kind": "parallel", "first_mm": 0, "step_mm": 1})");
  SweepImportOptions options;
  options.calibrations = {folder / "scan.xml"};
  options.motor = folder / "motor.json";
  const auto opened = openSweep(folder / "scan.igs.mha", options, noProgress());
  ASSERT_TRUE(opened) << opened.error();
  EXPECT_EQ(opened->plan.frames.used, 10u);
  EXPECT_TRUE(opened->plan.reconstruct.clip.fan);
}

TEST(ScreenCommand, ACorrectionIsReadAndItsOutlineCounts) {
  const TemporaryFolder folder;
  writeScreenFilm(folder / "screen.avi");
  writeText(folder / "c.json",
            R"({"correction": {"outline": {"shape": "linear", "corners_px": [[150, 80], [250, 80], [250, 200], [150, 200]]},
                                   "depth_mm": 60, "added": [[160, 100, 20, 10]]}})");
  const auto made = run({"screen", folder / "screen.avi", "-o", folder / "scan.igs.mha", "--correction", folder / "c.json",
                         "--accept-small", "--report", folder / "r.json"});
  ASSERT_EQ(made.status, 0) << made.err;
  const auto report = readJson(folder / "r.json");
  EXPECT_EQ(report["outline"]["shape"], "rectangle");
  EXPECT_NEAR(report["quality"]["pixel_mm"].get<double>(), 0.5, 1e-9);
  const auto sequence = readSequence(folder / "scan.igs.mha");
  ASSERT_TRUE(sequence);
  EXPECT_EQ(sequence->width, 101);
  EXPECT_EQ(sequence->height, 121);
  // The file beside it says the same again, and is a correction itself.
  const auto again = readScreenCorrection(folder / "scan.screen.json");
  ASSERT_TRUE(again) << again.error();
  EXPECT_EQ(again, readScreenCorrection(folder / "c.json"));
  EXPECT_EQ(
      run({"screen", folder / "screen.avi", "-o", folder / "other.igs.mha", "--correction", folder / "scan.screen.json", "--accept-small"})
          .status,
      0);

  writeText(folder / "bad.json", R"({"correction": {"depth_mm": -3}})");
  const auto refused = run({"screen", folder / "screen.avi", "-o", folder / "no.igs.mha", "--correction", folder / "bad.json"});
  EXPECT_EQ(refused.status, 1);
  EXPECT_NE(refused.err.find("depth_mm"), std::string::npos) << refused.err;
}

TEST(ScreenCommand, WhatIsNotFoundIsSaidAndNothingIsWritten) {
  const TemporaryFolder folder;
  writeScreenFilm(folder / "empty.avi", false);
  const auto none = run({"screen", folder / "empty.avi", "-o", folder / "scan.igs.mha", "--report", folder / "r.json"});
  EXPECT_EQ(none.status, 3) << none.err;
  EXPECT_NE(none.out.find("not found"), std::string::npos) << none.out;
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"empty.avi", "r.json"}));
  EXPECT_EQ(readJson(folder / "r.json")["verdict"], "not found");
  EXPECT_EQ(run({"screen", folder / "none.mp4", "-o", folder / "scan.igs.mha"}).status, 1);
  EXPECT_EQ(run({"screen", folder / "empty.avi", "-o", folder / "scan.txt"}).status, 2);
}

TEST(ScreenCommand, AStatedRateTakesThePlaceOfTheAssumedOne) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "p");
  const GreyImage mask = maskOf(drawnFan(), 420, 300);
  std::mt19937 random(7);
  for (int n = 0; n < 10; ++n) {
    GreyImage image(420, 300);
    for (std::size_t p = 0; p < image.pixels.size(); ++p)
      if (mask.pixels[p] != 0) image.pixels[p] = static_cast<std::uint8_t>(40 + random() % 180);
    ASSERT_TRUE(writeImage(viewOf(image), 1.0, std::filesystem::path(folder / "p") / (std::to_string(n) + ".png")));
  }
  const auto assumed = run({"screen", folder / "p", "-o", folder / "a.igs.mha", "--depth", "100"});
  ASSERT_EQ(assumed.status, 0) << assumed.err;
  const std::string told = assumed.out + assumed.err;
  EXPECT_NE(told.find("25 a second were assumed"), std::string::npos) << told;
  EXPECT_NE(told.find("--rate"), std::string::npos) << told;
  EXPECT_EQ(told.find("the depth has to be stated"), std::string::npos) << "it was";
  const auto stated =
      run({"screen", folder / "p", "-o", folder / "b.igs.mha", "--depth", "100", "--rate", "10", "--report", folder / "r.json"});
  ASSERT_EQ(stated.status, 0) << stated.err;
  EXPECT_EQ((stated.out + stated.err).find("assumed"), std::string::npos);
  EXPECT_EQ(readJson(folder / "r.json")["options"]["rate_hz"], 10.0);
  const auto sequence = readSequence(folder / "b.igs.mha");
  ASSERT_TRUE(sequence) << sequence.error();
  EXPECT_NEAR(*sequence->frames[3].time_s, 0.3, 1e-6);
}

TEST(ScreenCommand, ImagesAreTurnedAndMirroredAsAsked) {
  const TemporaryFolder folder;
  writeScreenFilm(folder / "screen.avi");
  ASSERT_EQ(run({"screen", folder / "screen.avi", "-o", folder / "plain.igs.mha", "--tick", "5"}).status, 0);
  const auto turned = run({"screen", folder / "screen.avi", "-o", folder / "turned.igs.mha", "--turn", "180", "--mirror", "--keep-outside",
                           "--report", folder / "r.json"});
  ASSERT_EQ(turned.status, 0) << turned.err;
  EXPECT_EQ(readJson(folder / "r.json")["options"]["turn_deg"], 180);
  EXPECT_EQ(readJson(folder / "r.json")["options"]["mirror"], true);
  const auto whole = run({"screen", folder / "screen.avi", "-o", folder / "whole.igs.mha", "--keep-outside"});
  ASSERT_EQ(whole.status, 0) << whole.err;
  const auto before = readSequence(folder / "whole.igs.mha"), after = readSequence(folder / "turned.igs.mha");
  ASSERT_TRUE(before && after);
  ASSERT_EQ(after->width, before->width);
  // Half a turn and a mirror put the last row first. The scale stands beside the scan, where nothing is filled.
  const auto upright = before->framePixels(4), turnedPixels = after->framePixels(4);
  const auto width = static_cast<std::size_t>(before->width), height = static_cast<std::size_t>(before->height);
  for (std::size_t y = 0; y < height; ++y)
    for (std::size_t x = 370; x < 400; ++x) ASSERT_EQ(turnedPixels[(height - 1 - y) * width + x], upright[y * width + x]) << x << " " << y;

  const auto quarter = run({"screen", folder / "screen.avi", "-o", folder / "quarter.igs.mha", "--turn", "90", "--keep-outside"});
  ASSERT_EQ(quarter.status, 0) << quarter.err;
  const auto lying = readSequence(folder / "quarter.igs.mha");
  ASSERT_TRUE(lying);
  EXPECT_EQ(lying->width, before->height);
  // The file beside it says how the images lie, and is a correction that does the same again.
  const auto said = readScreenCorrection(folder / "quarter.screen.json");
  ASSERT_TRUE(said) << said.error();
  EXPECT_EQ(said->turned, (Orientation{1, false}));
  const auto again = run(
      {"screen", folder / "screen.avi", "-o", folder / "again.igs.mha", "--keep-outside", "--correction", folder / "quarter.screen.json"});
  ASSERT_EQ(again.status, 0) << again.err;
  EXPECT_EQ(readSequence(folder / "again.igs.mha")->pixels, lying->pixels);

  EXPECT_EQ(run({"screen", folder / "screen.avi", "-o", folder / "no.igs.mha", "--turn", "45"}).status, 2);
  writeText(folder / "bad.json", R"({"correction": {"turn_deg": 45}})");
  EXPECT_EQ(run({"screen", folder / "screen.avi", "-o", folder / "no.igs.mha", "--correction", folder / "bad.json"}).status, 1);
}

}  // namespace
}  // namespace ew::test::screen_test
