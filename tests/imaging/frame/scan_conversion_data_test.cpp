#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <iostream>
#include <numbers>

#include "ew/imaging/scan_conversion.h"
#include "ew/io/sequence.h"
#include "recordings.h"

namespace ew::scan_conversion_data_test {
namespace {
namespace fs = std::filesystem;

/// Correlation of two images' grey levels over the pixels where `counts` says so.
template <class Counts>
double correlation(const std::vector<std::uint8_t>& a, std::span<const std::uint8_t> b, Counts counts) {
  double n = 0.0, sumA = 0.0, sumB = 0.0, sumAA = 0.0, sumBB = 0.0, sumAB = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!counts(i)) continue;
    const double x = a[i], y = b[i];
    n += 1.0;
    sumA += x, sumB += y, sumAA += x * x, sumBB += y * y, sumAB += x * y;
  }
  return (n * sumAB - sumA * sumB) / std::sqrt((n * sumAA - sumA * sumA) * (n * sumBB - sumB * sumB));
}

/// An endocavity probe's recorded lines and the images another program made of them.
class RecordedLines : public ::testing::Test {
 protected:
  void SetUp() override {
    EW_NEEDS_RECORDING("curvilinear-scanlines");
    auto lines = readSequence(folder_ / "UltrasonixCurvilinearBrightnessData.igs.mha");
    auto images = readSequence(folder_ / "UltrasonixCurvilinearScanConvertedData.igs.mha");
    ASSERT_TRUE(lines) << lines.error();
    ASSERT_TRUE(images) << images.error();
    lines_ = std::move(*lines);
    images_ = std::move(*images);
    ASSERT_EQ(lines_.frames.size(), images_.frames.size());

    // From the recording's own PlusDeviceSet_RfProcessingAlgoCurvilinearTest.xml.
    probe_.kind = ProbeKind::endocavity;
    probe_.radius_mm = 10.0;
    probe_.halfAngle_rad = 75.0 * std::numbers::pi / 180.0;
    probe_.lines = lines_.height;
    geometry_.width = images_.width;
    geometry_.height = images_.height;
    geometry_.pixel_mm = 0.15;
    geometry_.face_px = {410.0, 87.0};
    geometry_.markerLeft = false;
    geometry_.depth_mm = 72.0;
    grid_ = makeBeamGrid(probe_, {}, geometry_.depth_mm, geometry_.depth_mm / (lines_.width - 1));
    ASSERT_EQ(grid_.samples, lines_.width);
  }

  /// A row of the recording is a scan line; a row of a beam image is one depth.
  [[nodiscard]] BeamImage beams(std::size_t frame) const {
    BeamImage beams(lines_.height, lines_.width);
    const auto pixels = lines_.framePixels(frame);
    for (int line = 0; line < beams.width; ++line)
      for (int sample = 0; sample < beams.height; ++sample)
        viewOf(beams).at(line, sample) =
            pixels[static_cast<std::size_t>(line) * static_cast<std::size_t>(beams.height) + static_cast<std::size_t>(sample)];
    return beams;
  }

  const fs::path folder_ = test::recording("curvilinear-scanlines");
  Sequence lines_;
  Sequence images_;
  Probe probe_;
  DisplayGeometry geometry_;
  BeamGrid grid_;
};

TEST_F(RecordedLines, AreConvertedAsAnotherProgramConvertsThem) {
  const ScanConversionTable table = makeScanConversion(probe_, {}, grid_, geometry_);
  GreyImage inFan(geometry_.width, geometry_.height);
  for (int y = 0; y < inFan.height; ++y)
    for (const RowSpan& span : table.spans[static_cast<std::size_t>(y)])
      for (int x = span.begin; x < span.end; ++x) viewOf(inFan).at(x, y) = 1;
  for (std::size_t frame = 0; frame < lines_.frames.size(); ++frame) {
    const BeamImage echoes = beams(frame);
    GreyImage image(geometry_.width, geometry_.height);
    scanConvert(table, viewOf(echoes), 0, geometry_.height, viewOf(image));
    const auto reference = images_.framePixels(frame);
    std::size_t same = 0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) same += (image.pixels[i] > 0) == (reference[i] > 0);
    const double filled = static_cast<double>(same) / static_cast<double>(image.pixels.size());
    const double whole = correlation(image.pixels, reference, [](std::size_t) { return true; });
    const double fan = correlation(image.pixels, reference, [&](std::size_t i) { return inFan.pixels[i] != 0; });
    std::cout << "frame " << frame << ": correlation " << whole << ", within the fan " << fan << ", same filled pixels " << 100.0 * filled
              << " %\n";
    EXPECT_GT(whole, 0.93) << frame;
    EXPECT_GT(fan, 0.93) << frame;
    EXPECT_GE(filled, 0.995) << frame;
  }
}

TEST_F(RecordedLines, PlacedAboutTheArcsCentreWouldNotMatch) {
  // Another reading of the recording's geometry: the test above could not pass with it.
  geometry_.face_px.y += probe_.radius_mm / geometry_.pixel_mm;
  const BeamImage echoes = beams(0);
  GreyImage image(geometry_.width, geometry_.height);
  scanConvert(makeScanConversion(probe_, {}, grid_, geometry_), viewOf(echoes), 0, geometry_.height, viewOf(image));
  EXPECT_LT(correlation(image.pixels, images_.framePixels(0), [](std::size_t) { return true; }), 0.8);
}

}  // namespace
}  // namespace ew::scan_conversion_data_test
