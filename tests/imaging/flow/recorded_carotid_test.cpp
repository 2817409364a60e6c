#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <numbers>
#include <opencv2/imgcodecs.hpp>
#include <vector>

#include "ew/imaging/doppler.h"
#include "recordings.h"

namespace ew::recorded_carotid_test {
namespace {

constexpr int kLines = 104, kShots = 12, kSamples = 352;
constexpr double kScale_cmPerS = 38.5;  // of the scanner's picture: the file does not say the pulse rate

/// A frame of colour Doppler that a scanner recorded, and the picture it showed.
class RecordedCarotid : public ::testing::Test {
 protected:
  void SetUp() override {
    EW_NEEDS_RECORDING("carotid-doppler-iq");
    std::ifstream in(folder_ / "carotid_iq.raw", std::ios::binary);
    const std::vector<char> bytes((std::istreambuf_iterator<char>(in)), {});
    constexpr std::size_t kHead_bytes = 28;
    ASSERT_EQ(bytes.size(), kHead_bytes + std::size_t{kLines} * kShots * kSamples * 4);
    std::vector<std::int16_t> numbers((bytes.size() - kHead_bytes) / 2);
    std::memcpy(numbers.data(), bytes.data() + kHead_bytes, bytes.size() - kHead_bytes);
    // Of each line sample after sample, and of each sample its shots.
    packets_.resize(std::size_t{kLines} * kSamples);
    for (std::size_t place = 0; place < packets_.size(); ++place)
      for (std::size_t shot = 0; shot < kShots; ++shot) {
        const std::int16_t* at = numbers.data() + 2 * (place * kShots + shot);
        packets_[place].emplace_back(static_cast<float>(at[0]), static_cast<float>(at[1]));
      }
    picture_ = cv::imread((folder_ / "carotid.jpeg").string());
    ASSERT_EQ(picture_.cols, 544);
    ASSERT_EQ(picture_.rows, 800);
  }

  /// Sums behind a wall filter, averaged over the two neighbours across and four along the line.
  [[nodiscard]] std::vector<PacketSums> sums(int order) const {
    const WallFilter filter(kShots, order);
    std::vector<PacketSums> single;
    for (auto packet : packets_) {
      filter.apply(packet);
      single.push_back(sumsOf(packet));
    }
    std::vector<PacketSums> mean(single.size());
    for (int line = 0; line < kLines; ++line)
      for (int sample = 0; sample < kSamples; ++sample) {
        PacketSums& sum = mean[static_cast<std::size_t>(line * kSamples + sample)];
        double count = 0.0;
        for (int l = std::max(0, line - 1); l <= std::min(kLines - 1, line + 1); ++l)
          for (int s = std::max(0, sample - 4); s <= std::min(kSamples - 1, sample + 4); ++s, count += 1.0) {
            sum.r0 += single[static_cast<std::size_t>(l * kSamples + s)].r0;
            sum.r1 += single[static_cast<std::size_t>(l * kSamples + s)].r1;
          }
        sum.r0 /= count;
        sum.r1 /= count;
      }
    return mean;
  }

  /// What the scanner shows at a sample of a line: cm/s, by the colours of its own bar; 0 where it is grey.
  [[nodiscard]] double shownAt(int line, int sample) const {
    constexpr double kPixelsPerMm = 14.2, kPitch_mm = 0.2, kSteering = 15.0 * std::numbers::pi / 180.0;
    constexpr int kMiddle_px = 272, kFace_px = 187, kFirstSample = 92, kBarTop_px = 373, kBarEnd_px = 428, kBarMiddle_px = 40;
    const double range_mm = (kFirstSample + sample) * 1.54e6 / (2.0 * 15e6);
    const double x_mm = (line + 30 - 95.5) * kPitch_mm + range_mm * std::sin(kSteering), y_mm = range_mm * std::cos(kSteering);
    const int x = std::clamp(static_cast<int>(std::lround(kMiddle_px + kPixelsPerMm * x_mm)), 0, picture_.cols - 1);
    const int y = std::clamp(static_cast<int>(std::lround(kFace_px + kPixelsPerMm * y_mm)), 0, picture_.rows - 1);
    const auto pixel = picture_.at<cv::Vec3b>(y, x);
    const auto [least, most] = std::minmax({pixel[0], pixel[1], pixel[2]});
    if (most - least <= 60) return 0.0;
    double best = 1e300, found = 0.0;
    for (int row = kBarTop_px; row < kBarEnd_px; ++row) {
      const auto bar = picture_.at<cv::Vec3b>(row, kBarMiddle_px);
      double off = 0.0;
      for (int c = 0; c < 3; ++c) off += (bar[c] - pixel[c]) * (bar[c] - pixel[c]);
      if (off >= best) continue;
      best = off;
      found = kScale_cmPerS * (1.0 - 2.0 * (row - kBarTop_px) / (kBarEnd_px - 1.0 - kBarTop_px));
    }
    return found;
  }

  const std::filesystem::path folder_ = test::recording("carotid-doppler-iq");
  std::vector<std::vector<std::complex<float>>> packets_;
  cv::Mat picture_;
};

double medianOf(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

TEST_F(RecordedCarotid, HasTheVelocitiesThatTheScannerShowed) {
  const std::vector<PacketSums> found = sums(1);
  std::vector<double> powers;
  for (const PacketSums& each : found) powers.push_back(each.r0);
  // Most of the box is tissue, of which the filter leaves noise.
  const double shown = medianOf(powers) * std::pow(10.0, 0.6);
  std::vector<double> ours, theirs;
  int right = 0, both = 0, either = 0;
  double sumA = 0.0, sumB = 0.0, sumAA = 0.0, sumBB = 0.0, sumAB = 0.0;
  for (int line = 0; line < kLines; ++line)
    for (int sample = 0; sample < kSamples; ++sample) {
      const PacketSums& at = found[static_cast<std::size_t>(line * kSamples + sample)];
      const double velocity = kScale_cmPerS * meanVelocity(at), scanner = shownAt(line, sample);
      const double a = at.r0 > shown ? velocity : 0.0, b = scanner;
      sumA += a, sumB += b, sumAA += a * a, sumBB += b * b, sumAB += a * b;
      both += a != 0.0 && b != 0.0;
      either += a != 0.0 || b != 0.0;
      if (scanner == 0.0) continue;
      ours.push_back(velocity);
      theirs.push_back(scanner);
      right += velocity > 0.0;
    }
  const double n = kLines * kSamples;
  const double correlation = (n * sumAB - sumA * sumB) / std::sqrt((n * sumAA - sumA * sumA) * (n * sumBB - sumB * sumB));
  const double sameSign = static_cast<double>(right) / static_cast<double>(ours.size());
  std::cout << "correlation over the box " << correlation << ", same sign " << sameSign << ", medians " << medianOf(ours) << " and "
            << medianOf(theirs) << " cm/s, coloured by both " << static_cast<double>(both) / either << " of what either colours\n";
  ASSERT_GT(ours.size(), 9000U);
  EXPECT_GT(sameSign, 0.95);
  EXPECT_NEAR(medianOf(ours), medianOf(theirs), 0.1 * medianOf(theirs));
  EXPECT_GT(correlation, 0.7);
  EXPECT_GT(static_cast<double>(both) / either, 0.7);
}

TEST_F(RecordedCarotid, NeedsItsWallFilter) {
  // Without one the slow wall decides; with one blood stands out of what surrounds it.
  const auto contrast_db = [&](int order) {
    const std::vector<PacketSums> found = sums(order);
    std::vector<double> in, out;
    for (int line = 0; line < kLines; ++line)
      for (int sample = 0; sample < kSamples; ++sample)
        (shownAt(line, sample) != 0.0 ? in : out).push_back(found[static_cast<std::size_t>(line * kSamples + sample)].r0);
    return 10.0 * std::log10(medianOf(in) / medianOf(out));
  };
  EXPECT_LT(contrast_db(-1), -5.0);
  EXPECT_GT(contrast_db(1), 10.0);
}

}  // namespace
}  // namespace ew::recorded_carotid_test
