#include "ew/acquisition/line_data.h"
#include "recordings.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numbers>

namespace ew::line_data_test {
namespace {

namespace fs = std::filesystem;

/// 41 lines of 101 samples, 0.5 mm apart, over +-40 degrees from an arc of 20 mm; the level is twice the line plus the sample.
Sequence lines(const std::string& orientation = "FM") {
  Sequence sequence;
  sequence.width = 101;
  sequence.height = 41;
  sequence.orientation = orientation;
  sequence.imageType = "BRIGHTNESS";
  sequence.frames.resize(2);
  sequence.otherFields = {{"ScanConversionTransducerGeometry", "CURVILINEAR"},
                          {"ScanConversionRadiusStartMm", "20"},
                          {"ScanConversionRadiusStopMm", "70"},
                          {"ScanConversionThetaStartDeg", "-40"},
                          {"ScanConversionThetaStopDeg", "40"},
                          {"ScanConversionOutputImageSizePixel", "200 120"},
                          {"ScanConversionOutputImageSpacingMmPerPixel", "0.5 0.5"},
                          {"ScanConversionTransducerCenterPixel", "100 5"}};
  for (int frame = 0; frame < 2; ++frame)
    for (int line = 0; line < 41; ++line)
      for (int sample = 0; sample < 101; ++sample) {
        const int l = orientation[1] == 'M' ? line : 40 - line, s = orientation[0] == 'F' ? sample : 100 - sample;
        sequence.pixels.push_back(static_cast<std::uint8_t>(2 * l + s + 5 * frame));
      }
  return sequence;
}

TEST(LineData, BecomesAnImageWhosePixelsLieWhereTheGeometrySays) {
  for (const char* orientation : {"FM", "FU", "NM", "NU"}) {
    const Sequence recorded = lines(orientation);
    const auto geometry = lineGeometryOf(recorded, nullptr);
    ASSERT_TRUE(geometry.has_value()) << geometry.error();
    const auto images = convertLines(recorded, *geometry, 1, noProgress());
    ASSERT_TRUE(images.has_value()) << images.error();
    EXPECT_EQ(images->orientation, "MF");
    int inside = 0;
    for (int y = 0; y < 120; ++y)
      for (int x = 0; x < 200; ++x) {
        const double u = 0.5 * (x - 100), v = 0.5 * (y - 5) + 20.0;
        const double line = (std::atan2(u, v) * 180.0 / std::numbers::pi + 40.0) / 80.0 * 40.0, sample = (std::hypot(u, v) - 20.0) / 0.5;
        const int level = images->framePixels(1)[static_cast<std::size_t>(200 * y + x)];
        if (line > 0.01 && line < 39.99 && sample > 0.01 && sample < 99.99) {
          ASSERT_NEAR(level, 2.0 * line + sample + 5.0, 0.51) << orientation << " at " << x << ", " << y;
          ++inside;
        } else if (line < -0.1 || line > 40.1 || sample < -0.1 || sample > 100.1) {
          ASSERT_EQ(level, 0) << orientation << " at " << x << ", " << y;
        }
      }
    EXPECT_GT(inside, 5000);
  }
}

TEST(LineData, FromALinearProbeKeepsConstantsAndItsClip) {
  Sequence recorded = lines();
  recorded.otherFields = {{"ScanConversionTransducerGeometry", "LINEAR"},
                          {"ScanConversionImagingDepthMm", "50"},
                          {"ScanConversionTransducerWidthMm", "40"},
                          {"ScanConversionOutputImageSizePixel", "120 120"},
                          {"ScanConversionOutputImageSpacingMmPerPixel", "0.5 0.5"},
                          {"ScanConversionTransducerCenterPixel", "60 10"}};
  std::fill(recorded.pixels.begin(), recorded.pixels.end(), std::uint8_t{77});
  const auto geometry = lineGeometryOf(recorded, nullptr);
  ASSERT_TRUE(geometry.has_value()) << geometry.error();
  const auto images = convertLines(recorded, *geometry, 1, noProgress());
  ASSERT_TRUE(images.has_value());
  const Clip clip = clipOf(*geometry);
  EXPECT_EQ(clip.origin_px, glm::dvec2(20, 10));
  EXPECT_EQ(clip.size_px, glm::dvec2(81, 101));
  for (int y = 0; y < 120; ++y)
    for (int x = 0; x < 120; ++x) {
      const bool inside = x >= 20 && x <= 100 && y >= 10 && y <= 110;
      ASSERT_EQ(images->framePixels(0)[static_cast<std::size_t>(120 * y + x)], inside ? 77 : 0) << x << ", " << y;
    }
}

TEST(LineData, IsTheSameOnAnyNumberOfThreads) {
  const auto geometry = lineGeometryOf(lines(), nullptr);
  ASSERT_TRUE(geometry.has_value());
  const auto one = convertLines(lines(), *geometry, 1, noProgress());
  const auto eight = convertLines(lines(), *geometry, 8, noProgress());
  ASSERT_TRUE(one.has_value() && eight.has_value());
  EXPECT_EQ(one->pixels, eight->pixels);
}

TEST(LineData, WithoutItsGeometryIsRefusedByName) {
  for (std::size_t missing = 0; missing < 8; ++missing) {
    Sequence recorded = lines();
    const std::string field = recorded.otherFields[missing].first;
    recorded.otherFields.erase(recorded.otherFields.begin() + static_cast<std::ptrdiff_t>(missing));
    const auto refused = lineGeometryOf(recorded, nullptr);
    ASSERT_FALSE(refused.has_value()) << field;
    EXPECT_NE(refused.error().sentence().find("ScanConversion"), std::string::npos) << refused.error();
  }
  Sequence lopsided = lines();
  lopsided.otherFields[3].second = "-10";
  EXPECT_EQ(lineGeometryOf(lopsided, nullptr).error().code, ErrorCode::unsupported);
  Sequence radio = lines();
  radio.imageType = "RF_REAL";
  EXPECT_EQ(convertLines(radio, *lineGeometryOf(lines(), nullptr), 1, noProgress()).error().code, ErrorCode::unsupported);
}

TEST(LineData, OfARealProbeBecomesWhatItsDeviceSetPromises) {
  EW_NEEDS_RECORDING("curvilinear-scanlines");
  const fs::path data = test::recording("curvilinear-scanlines");
  auto recorded = readSequence(data / "UltrasonixCurvilinearBrightnessData.igs.mha");
  const auto reference = readSequence(data / "UltrasonixCurvilinearScanConvertedData.igs.mha");
  const auto device = readDeviceSet(data / "PlusDeviceSet_RfProcessingAlgoCurvilinearTest.xml");
  ASSERT_TRUE(recorded.has_value() && reference.has_value() && device.has_value());
  const auto geometry = lineGeometryOf(*recorded, &*device);
  ASSERT_TRUE(geometry.has_value()) << geometry.error();
  const auto images = convertLines(std::move(*recorded), *geometry, 0, noProgress());
  ASSERT_TRUE(images.has_value()) << images.error();
  ASSERT_EQ(images->pixels.size(), reference->pixels.size());
  double n = 0, sx = 0, sy = 0, sxx = 0, syy = 0, sxy = 0;
  for (std::size_t i = 0; i < images->pixels.size(); ++i) {
    const double x = images->pixels[i], y = reference->pixels[i];
    n += 1, sx += x, sy += y, sxx += x * x, syy += y * y, sxy += x * y;
  }
  const double correlation = (n * sxy - sx * sy) / std::sqrt((n * sxx - sx * sx) * (n * syy - sy * sy));
  std::printf("correlation with the other program's images: %.4f\n", correlation);
  EXPECT_GT(correlation, 0.97);
}

}  // namespace
}  // namespace ew::line_data_test
