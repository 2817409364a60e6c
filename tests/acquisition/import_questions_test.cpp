#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "acquisition/import_sweep.h"
#include "ew/acquisition/sweep_geometry.h"
#include "ew/acquisition/sweep_volume.h"
#include "ew/io/volume_file.h"
#include "recordings.h"

namespace ew::import_questions_test {
namespace {

using namespace test;

TEST_F(ImportSweep, AResultOfAlmostNothingIsAskedAbout) {
  const fs::path file = written(sweep()), device = deviceSet("ClipRectangleOrigin=\"3 3\" ClipRectangleSize=\"1 5\"");
  SweepImportOptions options = nearestAt(0.5, device);
  const auto asked = importFile(file, options, noProgress());
  ASSERT_FALSE(asked.has_value());
  EXPECT_EQ(asked.error().code, ErrorCode::unsupported);
  EXPECT_NE(asked.error().sentence().find("Only 6 % of the pixels"), std::string::npos) << asked.error();
  const auto plan = planFile(file, options, noProgress());
  ASSERT_TRUE(plan.has_value()) << "what there is to ask can be shown first";
  EXPECT_FALSE(plan->smallQuestion.empty());
  options.acceptsSmall = true;
  EXPECT_TRUE(importFile(file, options, noProgress()).has_value());

  Sequence few = sweep();
  few.pixels.clear();
  few.frames.resize(1);
  for (int n = 1; n < 30; ++n) {
    few.frames.push_back(few.frames.front());
    few.frames.back().transforms[0].status = n < 2 ? PoseStatus::ok : PoseStatus::invalid;
    few.frames.back().transforms[0].matrix[3].z = n;
  }
  few.pixels.assign(30u * 200u, 9);
  const auto frames = importFile(written(few), nearestAt(0.5, deviceSet("")), noProgress());
  ASSERT_FALSE(frames.has_value());
  EXPECT_NE(frames.error().sentence().find("Only 2 of the 30 frames"), std::string::npos) << frames.error();
}

TEST_F(ImportSweep, ASubvolumeOfAlmostNothingIsAskedAboutToo) {
  const fs::path file = written(sweep());
  SweepVolumeOptions options{.spacing_mm = 0.5, .calibration = deviceSet("ClipRectangleOrigin=\"3 3\" ClipRectangleSize=\"1 5\"")};
  const auto opened = openSweepVolume(file, options, noProgress());
  ASSERT_TRUE(opened.has_value()) << "what there is to ask can be shown first";
  const auto asked = makeSweepVolume(*opened, noProgress());
  ASSERT_FALSE(asked.has_value());
  EXPECT_EQ(asked.error().code, ErrorCode::unsupported);
  EXPECT_NE(asked.error().sentence().find("Only 6 % of the pixels"), std::string::npos) << asked.error();
  options.acceptsSmall = true;
  const auto accepted = openSweepVolume(file, options, noProgress());
  ASSERT_TRUE(accepted.has_value()) << accepted.error();
  EXPECT_TRUE(makeSweepVolume(*accepted, noProgress()).has_value());
}

/// Frames of 120 x 110 pixels, so many mm apart, that any matrix may calibrate.
Sequence wideSweep(int frames, double step_mm) {
  Sequence sequence;
  sequence.width = 120;
  sequence.height = 110;
  sequence.orientation = "MF";
  for (int n = 0; n < frames; ++n) {
    SequenceFrame frame;
    frame.imageStatus = PoseStatus::ok;
    frame.transforms.push_back({"Probe", "Reference", glm::dmat4(1.0), PoseStatus::ok});
    frame.transforms.back().matrix[3].z = n * step_mm;
    sequence.frames.push_back(frame);
  }
  sequence.pixels.assign(static_cast<std::size_t>(frames) * 120u * 110u, 7);
  return sequence;
}

/// Image to Probe with pixels of this size.
fs::path calibratedAt(const fs::path& folder, double pixel_mm) {
  std::ostringstream rows;
  rows << pixel_mm << " 0 0 0 0 " << pixel_mm << " 0 0 0 0 " << pixel_mm << " 0 0 0 0 1";
  std::ofstream(folder / "c.xml") << "<PlusConfiguration><CoordinateDefinitions><Transform From=\"Image\" To=\"Probe\" Matrix=\""
                                  << rows.str() << "\"/></CoordinateDefinitions></PlusConfiguration>";
  return folder / "c.xml";
}

TEST_F(ImportSweep, AMatrixInAnotherUnitIsAskedAbout) {
  const fs::path file = written(wideSweep(12, 1.0));
  SweepImportOptions metres = nearestAt(0.5, calibratedAt(folder_, 0.0001));
  const auto asked = importFile(file, metres, noProgress());
  ASSERT_FALSE(asked.has_value());
  EXPECT_EQ(asked.error().code, ErrorCode::unsupported);
  EXPECT_EQ(asked.error().sentence(),
            "With this calibration a pixel is 0.0001 x 0.0001 mm and the whole image 0.012 x 0.011 mm: is the matrix in metres? Matrices "
            "count millimetres; correct it, or say that so small an image is meant.");
  const std::pair<std::string, std::string> question("ask", "accept-small");
  EXPECT_NE(std::find(asked.error().context.begin(), asked.error().context.end(), question), asked.error().context.end());
  const auto plan = planFile(file, metres, noProgress());
  ASSERT_TRUE(plan.has_value()) << "what there is to ask can be shown first";
  EXPECT_FALSE(plan->smallQuestion.empty());
  metres.acceptsSmall = true;
  EXPECT_TRUE(importFile(file, metres, noProgress()).has_value());
  const auto large = planFile(file, nearestAt(20.0, calibratedAt(folder_, 6.0)), noProgress());
  ASSERT_TRUE(large.has_value()) << large.error();
  EXPECT_NE(large->smallQuestion.english().find("a pixel is 6 x 6 mm and the whole image 720 x 660 mm: is the matrix in micrometres?"),
            std::string::npos)
      << large->smallQuestion;
  for (const double usual_mm : {0.006, 0.05, 0.3, 4.9}) {
    const auto quiet = planFile(file, nearestAt(0.5 * std::max(0.1, usual_mm), calibratedAt(folder_, usual_mm)), noProgress());
    ASSERT_TRUE(quiet.has_value()) << quiet.error();
    EXPECT_TRUE(quiet->smallQuestion.empty()) << quiet->smallQuestion;
  }
}

TEST_F(ImportSweep, ManyPixelsThatBecomeOneOrTwoVoxelsAreAskedAbout) {
  const auto plan = planFile(written(wideSweep(12, 10.0)), nearestAt(10.0, calibratedAt(folder_, 0.1)), noProgress());
  ASSERT_TRUE(plan.has_value()) << plan.error();
  EXPECT_NE(plan->smallQuestion.english().find("With voxels of 10 mm an image of 120 x 110 pixels would become 1 x 1 voxels"),
            std::string::npos)
      << plan->smallQuestion;
}

TEST_F(ImportSweep, PosesInMetresAreAskedAbout) {
  const SweepImportOptions options = nearestAt(0.5, calibratedAt(folder_, 0.1));
  const auto metres = planFile(written(wideSweep(12, 0.001)), options, noProgress());
  ASSERT_TRUE(metres.has_value()) << metres.error();
  EXPECT_NE(metres->smallQuestion.english().find(
                "Through all 12 frames the image moves by no more than 0.011 mm, which is less than two voxels: are the poses in metres?"),
            std::string::npos)
      << metres->smallQuestion;
  const auto few = planFile(written(wideSweep(2, 0.001)), options, noProgress());
  ASSERT_TRUE(few.has_value()) << few.error();
  EXPECT_TRUE(few->smallQuestion.empty()) << few->smallQuestion;
  const auto moving = planFile(written(wideSweep(12, 0.1)), options, noProgress());
  ASSERT_TRUE(moving.has_value()) << moving.error();
  EXPECT_TRUE(moving->smallQuestion.empty()) << moving->smallQuestion;
}

TEST_F(ImportSweep, AFewSmallImagesOfPosesInAnotherUnitAreAskedAbout) {
  const auto questionAt = [&](double perMm) {
    Sequence sequence = sweep();
    for (SequenceFrame& frame : sequence.frames)
      for (FrameTransform& one : frame.transforms) one.matrix[3] = glm::dvec4(glm::dvec3(one.matrix[3]) * perMm, 1.0);
    const auto plan = planFile(written(sequence), nearestAt(0.5, deviceSet("")), noProgress());
    if (!plan) ADD_FAILURE() << plan.error();
    return plan ? plan->smallQuestion.english() : std::string();
  };
  EXPECT_EQ(questionAt(0.001),
            "Through all 5 frames the image moves by no more than 0.004 mm, which is less than two voxels: are the poses in metres? They "
            "count millimetres; correct them, or say that the probe was held still.");
  EXPECT_EQ(questionAt(1000.0),
            "Neighbouring frames lie 1000 mm apart, which is more than the image of 10 x 5 mm is large, so that next to nothing of the "
            "volume would be measured: are the poses in micrometres? They count millimetres; correct them, or say that so large a volume "
            "is meant.");
  EXPECT_EQ(questionAt(1.0), "");
  EXPECT_EQ(questionAt(0.0), "") << "poses that are all the same were written so";
}

TEST_F(ImportSweep, ASubvolumeOfAnotherUnitIsAskedAboutToo) {
  const fs::path file = written(wideSweep(12, 1.0));
  const auto opened = openSweepVolume(file, {.spacing_mm = 0.5, .calibration = calibratedAt(folder_, 0.0001)}, noProgress());
  ASSERT_TRUE(opened.has_value()) << opened.error();
  const auto asked = makeSweepVolume(*opened, noProgress());
  ASSERT_FALSE(asked.has_value());
  EXPECT_NE(asked.error().sentence().find("is the matrix in metres?"), std::string::npos) << asked.error();
}

}  // namespace
}  // namespace ew::import_questions_test
