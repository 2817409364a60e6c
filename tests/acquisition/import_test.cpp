#include "ew/acquisition/import.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "acquisition/import_sweep.h"
#include "ew/acquisition/recorded_images.h"
#include "ew/acquisition/sweep_geometry.h"
#include "ew/acquisition/sweep_volume.h"
#include "ew/io/volume_file.h"
#include "recordings.h"

namespace ew::import_test {
namespace {

using namespace test;

TEST_F(ImportSweep, PlacesEveryPixelByPoseAndCalibration) {
  const auto imported = importFile(written(sweep()), nearestAt(0.5, deviceSet("")), noProgress());
  ASSERT_TRUE(imported.has_value()) << imported.error();
  const Volume& volume = imported->reconstruction.volume;
  ASSERT_EQ(volume.grid.dims, glm::ivec3(20, 10, 9));
  EXPECT_EQ(imported->plan.grid, volume.grid);
  EXPECT_EQ(imported->plan.toFrame, "Reference");
  for (int n = 0; n < 5; ++n)
    for (int y = 0; y < 10; ++y)
      for (int x = 0; x < 20; ++x) EXPECT_EQ(volume.echo[volume.grid.indexOf(x, y, 2 * n)], 4 * x + 5 * y + 6 * n);
  EXPECT_EQ(imported->plan.frames.total, 5u);
  EXPECT_EQ(imported->plan.frames.used, 5u);
  EXPECT_EQ(imported->reconstruction.measuredVoxels, 1000u);
}

TEST_F(ImportSweep, LeavesInvalidFramesOutAndCountsThem) {
  Sequence sequence = sweep();
  sequence.frames[1].transforms[0].status = PoseStatus::invalid;
  sequence.frames[3].transforms.clear();
  const auto imported = importFile(written(sequence), nearestAt(0.5, deviceSet("")), noProgress());
  ASSERT_TRUE(imported.has_value()) << imported.error();
  EXPECT_EQ(imported->plan.frames.used, 3u);
  EXPECT_EQ(imported->plan.frames.invalid, 1u);
  EXPECT_EQ(imported->plan.frames.missing, 1u);
  EXPECT_EQ(imported->reconstruction.framesUsed, 3u);
  EXPECT_EQ(imported->reconstruction.volume.coverageAt(imported->reconstruction.volume.grid.indexOf(3, 3, 2)), Coverage::absent);
}

TEST_F(ImportSweep, RefusesASweepWithoutAnyValidPoseAndOneWithoutCalibration) {
  Sequence sequence = sweep();
  for (SequenceFrame& frame : sequence.frames) frame.transforms[0].status = PoseStatus::invalid;
  const auto untracked = importFile(written(sequence), nearestAt(0.5, deviceSet("")), noProgress());
  ASSERT_FALSE(untracked.has_value());
  EXPECT_EQ(untracked.error().code, ErrorCode::noValidPose);
  const auto uncalibrated = importFile(written(sweep()), nearestAt(0.5, {}), noProgress());
  ASSERT_FALSE(uncalibrated.has_value());
  EXPECT_EQ(uncalibrated.error().code, ErrorCode::missingCalibration);
}

TEST_F(ImportSweep, TakesTheClipThatTheRecordingStatesUnlessSomebodyElseNamesOne) {
  Sequence stating = sweep();
  stating.otherFields = {{"ClipRectangleOrigin", "4 2"}, {"ClipRectangleSize", "8 4"}};
  SweepImportOptions options = nearestAt(0.5, deviceSet(""));
  const auto clipped = planFile(written(stating), options, noProgress());
  ASSERT_TRUE(clipped.has_value()) << clipped.error();
  EXPECT_EQ(clipped->grid.origin_mm, glm::dvec3(2, 1, 0));
  options.reconstruct.clip.origin_px = {6, 2};
  const auto asked = planFile(written(stating), options, noProgress());
  ASSERT_TRUE(asked.has_value()) << asked.error();
  EXPECT_EQ(asked->grid.origin_mm, glm::dvec3(3, 1, 0));
  const auto device =
      planFile(written(stating), nearestAt(0.5, deviceSet("ClipRectangleOrigin=\"8 2\" ClipRectangleSize=\"8 4\"")), noProgress());
  ASSERT_TRUE(device.has_value()) << device.error();
  EXPECT_EQ(device->grid.origin_mm, glm::dvec3(4, 1, 0));
  stating.otherFields[0].second = "4 two";
  const auto refused = planFile(written(stating), nearestAt(0.5, deviceSet("")), noProgress());
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ErrorCode::badField);
}

TEST_F(ImportSweep, TakesClipSpacingAndMethodFromTheDeviceSetOnlyWhenAllowed) {
  const fs::path device = deviceSet(
      "OutputSpacing=\"1 1 1\" ClipRectangleOrigin=\"4 2\" ClipRectangleSize=\"8 4\" Interpolation=\"LINEAR\" "
      "CompoundingMode=\"MAXIMUM\"");
  SweepImportOptions options = nearestAt(0.5, device);
  const auto clipped = planFile(written(sweep()), options, noProgress());
  ASSERT_TRUE(clipped.has_value()) << clipped.error();
  EXPECT_EQ(clipped->grid.origin_mm, glm::dvec3(2, 1, 0));
  EXPECT_EQ(clipped->grid.dims, glm::ivec3(9, 5, 9));
  EXPECT_EQ(clipped->reconstruct.interpolation, Interpolation::nearest);
  options.clipFromCalibration = false;
  options.usual.spacing = true;
  options.usual.interpolation = true;
  options.usual.compounding = true;
  const auto whole = planFile(written(sweep()), options, noProgress());
  ASSERT_TRUE(whole.has_value()) << whole.error();
  EXPECT_EQ(whole->grid.dims, glm::ivec3(11, 6, 5));  // round(9.5) + 1 and round(4.5) + 1
  EXPECT_EQ(whole->reconstruct.interpolation, Interpolation::linear);
  EXPECT_EQ(whole->reconstruct.compounding, Compounding::maximum);
}

TEST_F(ImportSweep, UnderstandsTheSwitchOfOldDeviceSetsAndSaysHow) {
  SweepImportOptions options;
  for (const auto& [word, expected] : {std::pair{"On", Compounding::mean}, {"OFF", Compounding::latest}}) {
    options = nearestAt(0.5, deviceSet(std::string("Compounding=\"") + word + "\""));
    options.usual.compounding = true;
    const auto plan = planFile(written(sweep()), options, noProgress());
    ASSERT_TRUE(plan.has_value()) << plan.error();
    EXPECT_EQ(plan->reconstruct.compounding, expected) << word;
  }
  options = nearestAt(0.5, deviceSet("Compounding=\"Sometimes\""));
  options.usual.compounding = true;
  const auto refused = planFile(written(sweep()), options, noProgress());
  ASSERT_FALSE(refused.has_value());
  EXPECT_NE(refused.error().sentence().find("choose the compounding yourself"), std::string::npos) << refused.error();
}

/// Two frames in one place: one sees tissue everywhere, the other is black from a third of its depth on in a few columns.
Sequence shadowedPair() {
  Sequence sequence;
  sequence.width = 48;
  sequence.height = 60;
  sequence.orientation = "MF";
  sequence.imageType = "BRIGHTNESS";
  for (int n = 0; n < 2; ++n) {
    SequenceFrame frame;
    frame.time_s = 0.1 * n;
    frame.transforms.push_back({"Probe", "Reference", glm::dmat4(1.0), PoseStatus::ok});
    sequence.frames.push_back(frame);
    for (int y = 0; y < sequence.height; ++y)
      for (int x = 0; x < sequence.width; ++x)
        sequence.pixels.push_back(n == 1 && y >= 20 && x >= 20 && x < 28 ? 0 : static_cast<std::uint8_t>(120 + (7 * x + 11 * y) % 17));
  }
  return sequence;
}

TEST_F(ImportSweep, WeighsPixelsByConfidenceSoThatAShadowInOneViewDarkensLess) {
  const fs::path file = written(shadowedPair());
  for (const auto method : {ConfidenceMethod::beamwise, ConfidenceMethod::randomWalk}) {
    SweepImportOptions options = nearestAt(0.5, deviceSet(""));
    options.confidence.method = method;
    const auto mean = importFile(file, options, noProgress());
    options.reconstruct.compounding = Compounding::weighted;
    const auto weighted = importFile(file, options, noProgress());
    ASSERT_TRUE(mean.has_value()) << mean.error();
    ASSERT_TRUE(weighted.has_value()) << weighted.error();
    const Volume& plain = mean->reconstruction.volume;
    const Volume& weighed = weighted->reconstruction.volume;
    ASSERT_EQ(plain.grid, weighed.grid);
    const std::size_t inShadow = plain.grid.indexOf(24, 45, 0);
    EXPECT_LT(plain.echo[inShadow], 75) << "half of black and tissue";
    EXPECT_GT(weighed.echo[inShadow], 105) << "the black half is not believed";
    EXPECT_NEAR(weighed.echo[plain.grid.indexOf(6, 45, 0)], plain.echo[plain.grid.indexOf(6, 45, 0)], 1) << "both views agree here";
    const std::uint64_t frames = 2u * 48u * 60u;
    EXPECT_EQ(mean->plan.bytes, frames + forecastBytes(plain.grid, mean->plan.reconstruct));
    EXPECT_EQ(weighted->plan.bytes, 2u * frames + forecastBytes(weighed.grid, weighted->plan.reconstruct)) << "the maps are counted";
  }
}

TEST_F(ImportSweep, RefusesConfidenceThatCannotBe) {
  SweepImportOptions options = nearestAt(0.5, deviceSet(""));
  options.reconstruct.compounding = Compounding::weighted;
  options.confidence.shadow_db = -1.0;
  const auto refused = importFile(written(shadowedPair()), options, noProgress());
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ErrorCode::badField);
}

TEST_F(ImportSweep, RefusesASpacingOfTheDeviceSetThatDiffersBetweenAxes) {
  SweepImportOptions options = nearestAt(0.5, deviceSet("OutputSpacing=\"1 1 2\""));
  options.usual.spacing = true;
  const auto plan = planFile(written(sweep()), options, noProgress());
  ASSERT_FALSE(plan.has_value());
  EXPECT_EQ(plan.error().code, ErrorCode::badField);
}

TEST_F(ImportSweep, ChoosesSpacingAndReachFromTheFramesWhereNobodyNamesThem) {
  SweepImportOptions options = nearestAt(0.75, deviceSet(""));
  options.usual = {.spacing = true, .interpolation = true, .compounding = true, .fillReach = true};
  auto opened = openSweep(written(sweep()), options, noProgress());
  ASSERT_TRUE(opened.has_value()) << opened.error();
  const auto frames = posedFrames(*opened);
  const ReconstructOptions& planned = opened->plan.reconstruct;
  EXPECT_EQ(planned.spacing_mm, carriedSpacing_mm(frames));
  EXPECT_EQ(planned.fillReach_mm, usualFillReach_mm(frames, planned.spacing_mm));
  EXPECT_EQ(planned.interpolation, Interpolation::linear);
  EXPECT_EQ(planned.compounding, Compounding::mean);
  std::vector<Message> notes;
  const auto asked = defaultsFor(frames, nullptr, options.usual, {}, notes);
  ASSERT_TRUE(asked.has_value()) << asked.error();
  EXPECT_EQ(planned.spacing_mm, asked->spacing_mm) << "the plan asks the function that everybody asks";
  EXPECT_EQ(planned.fillReach_mm, asked->fillReach_mm);
  EXPECT_EQ(opened->plan.grid.spacing_mm.x, planned.spacing_mm);
}

TEST_F(ImportSweep, IsPlannedAgainWithoutItsFile) {
  const SweepImportOptions first = nearestAt(0.5, deviceSet(""));
  SweepImportOptions second = nearestAt(1.0, deviceSet("ClipRectangleOrigin=\"4 2\" ClipRectangleSize=\"8 4\""));
  const fs::path file = written(sweep());
  const auto expected = openSweep(file, second, noProgress());
  ASSERT_TRUE(expected.has_value()) << expected.error();
  second.toFrame = "Nowhere";
  auto opened = openSweep(file, first, noProgress());
  ASSERT_TRUE(opened.has_value()) << opened.error();
  fs::remove(file);
  EXPECT_FALSE(planAgain(*opened, second, noProgress())) << "a frame that is not there; the images stay";
  second.toFrame.clear();
  ASSERT_TRUE(planAgain(*opened, second, noProgress()));
  EXPECT_EQ(opened->plan.grid, expected->plan.grid);
  EXPECT_EQ(opened->plan.notes, expected->plan.notes);
  EXPECT_EQ(opened->plan.bytes, expected->plan.bytes);
  EXPECT_EQ(opened->plan.reconstruct.clip, expected->plan.reconstruct.clip);
  const auto made = importSweep(std::move(*opened), noProgress());
  ASSERT_TRUE(made.has_value()) << made.error();
  EXPECT_GT(made->reconstruction.measuredVoxels, 0u);
}

TEST_F(ImportSweep, LeavesWhatWasChosenAsItIs) {
  std::vector<Message> notes;
  const ReconstructOptions said{
      .spacing_mm = 0.75, .interpolation = Interpolation::nearest, .compounding = Compounding::maximum, .fillReach_mm = 7.0};
  const auto made = defaultsFor({}, nullptr, {}, said, notes);
  ASSERT_TRUE(made.has_value());
  EXPECT_EQ(made->spacing_mm, 0.75);
  EXPECT_EQ(made->interpolation, Interpolation::nearest);
  EXPECT_EQ(made->compounding, Compounding::maximum);
  EXPECT_EQ(made->fillReach_mm, 7.0);
}

TEST_F(ImportSweep, RefusesASpacingThatMakesOneVoxelOfTheRecording) {
  const auto plan = planFile(written(sweep()), nearestAt(1000.0, deviceSet("")), noProgress());
  ASSERT_FALSE(plan.has_value());
  EXPECT_EQ(plan.error().code, ErrorCode::badField);
  EXPECT_NE(plan.error().sentence().find("finer spacing"), std::string::npos) << plan.error();
}

TEST_F(ImportSweep, NamesNoFigureThatNobodyCanAllow) {
  const auto refused = importFile(written(sweep()), nearestAt(1e-4, deviceSet("")), noProgress());
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ErrorCode::tooLarge);
  EXPECT_EQ(refused.error().sentence().find("17179869184"), std::string::npos) << refused.error();
}

TEST_F(ImportSweep, AsksForTheCalibrationBeforeItReadsThePixels) {
  const fs::path file = written(sweep());
  fs::resize_file(file, fs::file_size(file) - 8);  // reading the pixels would fail
  ASSERT_EQ(planFile(file, nearestAt(0.5, deviceSet("")), noProgress()).error().code, ErrorCode::truncated);
  const auto uncalibrated = planFile(file, nearestAt(0.5, {}), noProgress());
  ASSERT_FALSE(uncalibrated.has_value());
  EXPECT_EQ(uncalibrated.error().code, ErrorCode::missingCalibration);
}

TEST_F(ImportSweep, TurnsImagesRecordedMirroredAndUpsideDown) {
  const auto straight = importFile(written(sweep()), nearestAt(0.5, deviceSet("")), noProgress());
  ASSERT_TRUE(straight.has_value()) << straight.error();
  for (const char* orientation : {"UN", "MN", "UF"}) {
    Sequence turned = sweep();
    turned.orientation = orientation;
    for (std::size_t n = 0; n < 5; ++n)
      for (int y = 0; y < 10; ++y)
        for (int x = 0; x < 20; ++x) {
          const int xMf = orientation[0] == 'U' ? 19 - x : x, yMf = orientation[1] == 'N' ? 9 - y : y;
          turned.pixels[n * 200 + static_cast<std::size_t>(y * 20 + x)] =
              static_cast<std::uint8_t>(4 * xMf + 5 * yMf + 6 * static_cast<int>(n));
        }
    const auto imported = importFile(written(turned), nearestAt(0.5, deviceSet("")), noProgress());
    ASSERT_TRUE(imported.has_value()) << imported.error();
    EXPECT_TRUE(imported->reconstruction.volume == straight->reconstruction.volume) << orientation;
  }
}

TEST_F(ImportSweep, RefusesScanLinesWhoseGeometryNobodyStates) {
  Sequence lines = sweep();
  lines.orientation = "FM";
  const auto imported = importFile(written(lines), nearestAt(0.5, deviceSet("")), noProgress());
  ASSERT_FALSE(imported.has_value());
  EXPECT_EQ(imported.error().code, ErrorCode::badField);
  EXPECT_NE(imported.error().sentence().find("ScanConversion"), std::string::npos) << imported.error();
}

TEST_F(ImportSweep, PlansAVolumeThatDoesNotFitAndRefusesToMakeIt) {
  SweepImportOptions options = nearestAt(0.005, deviceSet(""));
  options.reconstruct.maxBytes = 1ull << 30;
  const auto plan = planFile(written(sweep()), options, noProgress());
  ASSERT_TRUE(plan.has_value()) << plan.error();
  EXPECT_FALSE(plan->fits);
  EXPECT_GT(plan->bytes, 1ull << 30);
  const auto imported = importFile(written(sweep()), options, noProgress());
  ASSERT_FALSE(imported.has_value());
  EXPECT_EQ(imported.error().code, ErrorCode::tooLarge);
}

TEST_F(ImportSweep, ValuesThatSayNotSetInDeviceSetOrRecordingKeepTheWholeImages) {
  const auto dims = [&](const Sequence& sequence, const std::string& reconstruction) {
    const auto imported = importFile(written(sequence), nearestAt(0.5, deviceSet(reconstruction)), noProgress());
    if (!imported) ADD_FAILURE() << imported.error();
    return imported ? imported->plan.grid.dims : glm::ivec3(0);
  };
  for (const char* unset : {"ClipRectangleOrigin=\"0 0\" ClipRectangleSize=\"0 0\" OutputOrigin=\"0 0 0\" OutputExtent=\" \"",
                            "ClipRectangleOrigin=\"-1 -1\" ClipRectangleSize=\"-1 -1\"", "ClipRectangleOrigin=\"0 0\"",
                            "FanAnglesDeg=\"0 0\" FanRadiusStopPixel=\"0\"", "ClipRectangleSize=\"\""})
    EXPECT_EQ(dims(sweep(), unset), glm::ivec3(20, 10, 9)) << unset;
  for (const auto& [field, value] : {std::pair("ClipRectangleSize", "0 0"), std::pair("ClipRectangleSize", "-1 -1"),
                                     std::pair("ClipRectangleOrigin", "0 0"), std::pair("FanAnglesDeg", "0 0")}) {
    Sequence sequence = sweep();
    sequence.otherFields.emplace_back(field, value);
    EXPECT_EQ(dims(sequence, ""), glm::ivec3(20, 10, 9)) << field;
  }
}

TEST_F(ImportSweep, AFanThatIsStatedInPartIsNamed) {
  const auto notesOf = [&](const Sequence& sequence, const std::string& reconstruction) {
    const auto plan = planFile(written(sequence), nearestAt(0.5, deviceSet(reconstruction)), noProgress());
    if (!plan) ADD_FAILURE() << plan.error();
    std::vector<std::string> notes;
    if (plan)
      for (const Message& note : plan->notes) notes.push_back(note.english());
    return notes;
  };
  const auto has = [](const std::vector<std::string>& notes, const std::string& note) {
    return std::find(notes.begin(), notes.end(), note) != notes.end();
  };
  EXPECT_TRUE(has(notesOf(sweep(), "FanAngles=\"-30 30\""),
                  "The device set states the angles of a fan without its apex (FanOriginPixel); the pixel (0, 0) was taken."));
  EXPECT_TRUE(has(notesOf(sweep(), "FanOrigin=\"20 -10\" FanRadiusStartPixel=\"3\" FanDepth=\"25\""),
                  "The device set states a fan (apex (20, -10), begin at radius 3, end at radius 25) without its angles (FanAnglesDeg), so "
                  "that it is not used."));
  Sequence stating = sweep();
  stating.otherFields = {{"FanOriginPixel", "20 -10"}};
  EXPECT_TRUE(
      has(notesOf(stating, ""), "The recording states a fan (apex (20, -10)) without its angles (FanAnglesDeg), so that it is not used."));
  stating.otherFields = {{"FanAnglesDeg", "-60 60"}};
  EXPECT_TRUE(
      has(notesOf(stating, ""), "The recording states the angles of a fan without its apex (FanOriginPixel); the pixel (0, 0) was taken."));
  EXPECT_EQ(notesOf(sweep(), "FanOrigin=\"0 0\" FanRadiusStartPixel=\"0\""), notesOf(sweep(), ""))
      << "zeros are written where there is none";
}

TEST_F(ImportSweep, AClipForOtherImagesIsRefusedByItsNumbers) {
  const auto refused =
      importFile(written(sweep()), nearestAt(0.5, deviceSet("ClipRectangleOrigin=\"0 0\" ClipRectangleSize=\"820 616\"")), noProgress());
  ASSERT_FALSE(refused.has_value());
  EXPECT_NE(refused.error().sentence().find("820 x 616 px"), std::string::npos) << refused.error();
}

TEST_F(ImportSweep, TheReferenceThatADeviceSetNamesBecomesTheWorld) {
  Sequence sequence = sweep();
  for (SequenceFrame& frame : sequence.frames) {
    FrameTransform phantom{"Phantom", "Reference", glm::dmat4(1.0), PoseStatus::ok};
    phantom.matrix[3] = glm::dvec4(100.0, 0.0, 0.0, 1.0);
    frame.transforms.push_back(phantom);
  }
  const fs::path file = written(sequence);
  const auto named = planFile(file, nearestAt(0.5, deviceSet("ReferenceCoordinateFrame=\"Phantom\"")), noProgress());
  ASSERT_TRUE(named.has_value()) << named.error();
  EXPECT_EQ(named->toFrame, "Phantom");
  EXPECT_NEAR(named->grid.origin_mm.x, -100.0, 1e-9);
  const auto unknown = planFile(file, nearestAt(0.5, deviceSet("ReferenceCoordinateFrame=\"Moon\"")), noProgress());
  ASSERT_TRUE(unknown.has_value()) << unknown.error();
  EXPECT_EQ(unknown->toFrame, "Reference");
  EXPECT_TRUE(std::any_of(unknown->notes.begin(), unknown->notes.end(),
                          [](const Message& note) { return note.english().find("names Moon as its reference") != std::string::npos; }));
}

TEST_F(ImportSweep, KeepsItsImagesCutToWhatIsImageAndWithNothingElse) {
  Sequence recorded = sweep();
  recorded.otherFields = {{"Operator", "somebody"}};
  recorded.frames[0].otherFields = {{"Note", "a name"}};
  recorded.frames[2].transforms[0].status = PoseStatus::missing;  // has no place
  SweepImportOptions options;
  options.calibrations = {deviceSet("")};
  options.reconstruct.clip = Clip{.origin_px = {4.0, 3.0}, .size_px = glm::dvec2(7.0, 4.0)};
  options.clipFromCalibration = false;
  const auto opened = openSweep(written(recorded), options, noProgress());
  ASSERT_TRUE(opened) << opened.error();
  const auto all = recordedImages(*opened, 1);
  const auto some = recordedImages(*opened, 3);
  ASSERT_TRUE(all) << all.error();
  ASSERT_TRUE(some);
  ASSERT_EQ(all->frames.size(), 4u);
  EXPECT_EQ(some->frames.size(), 2u);
  EXPECT_TRUE(all->otherFields.empty());
  const auto posed = posedFrames(*opened);
  for (std::size_t n = 0; n < 4; ++n) {
    EXPECT_TRUE(all->frames[n].otherFields.empty());
    EXPECT_FALSE(all->frames[n].time_s);
    ASSERT_EQ(all->frames[n].transforms.size(), 1u);
    const FrameTransform& place = all->frames[n].transforms[0];
    EXPECT_EQ(place.from + place.to, "ImageReference");
    // Every pixel keeps its place in the world and its grey, or is black beside the clip.
    for (int y = 0; y < all->height; ++y)
      for (int x = 0; x < all->width; ++x) {
        const glm::dvec4 world = place.matrix * glm::dvec4(x, y, 0.0, 1.0), pixel = glm::inverse(posed[n].imageToWorld.matrix) * world;
        const int u = static_cast<int>(std::lround(pixel.x)), v = static_cast<int>(std::lround(pixel.y));
        EXPECT_NEAR(glm::distance(pixel, glm::dvec4(u, v, 0.0, 1.0)), 0.0, 1e-9);
        const bool isImage = u >= 4 && u <= 11 && v >= 3 && v <= 7;
        const std::uint8_t grey = all->framePixels(n)[static_cast<std::size_t>(y * all->width + x)];
        if (isImage) {
          EXPECT_TRUE(grey == posed[n].pixels.row(v)[u] || u == 11 || v == 7) << "the clip's last pixel alone may be out";
        } else {
          EXPECT_EQ(grey, 0);
        }
      }
  }
}

}  // namespace
}  // namespace ew::import_test
