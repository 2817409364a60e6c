#include "ew/imaging/frame_stack.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <vector>

#include "ew/imaging/slicing.h"

namespace ew::frame_stack_test {
namespace {

using Place = Transform<frame::Voxel, frame::Image>;

constexpr int kWidth = 60, kHeight = 50;

/// What there is to see: grey over place, even and known everywhere.
double seen(const glm::dvec3& p) { return 128.0 + 50.0 * std::sin(0.11 * p.x) * std::cos(0.09 * p.y) + 40.0 * std::sin(0.07 * p.z + 0.4); }

std::vector<std::uint8_t> imagesOf(const std::vector<Place>& places) {
  std::vector<std::uint8_t> pixels;
  for (const Place& place : places)
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x)
        pixels.push_back(static_cast<std::uint8_t>(std::lround(seen(glm::dvec3(place.matrix * glm::dvec4(x, y, 0.0, 1.0))))));
  return pixels;
}

/// One behind the other, `apart` voxels.
std::vector<Place> shifted(int count, double apart) {
  std::vector<Place> places(static_cast<std::size_t>(count));
  for (int n = 0; n < count; ++n) places[static_cast<std::size_t>(n)].matrix[3] = glm::dvec4(0.0, 0.0, apart * n, 1.0);
  return places;
}

/// A probe that is rocked about a line along x, `above` voxels before the first row.
std::vector<Place> rocked(int count, double step_rad, double above) {
  std::vector<Place> places;
  for (int n = 0; n < count; ++n) {
    const glm::dmat4 toPivot = glm::translate(glm::dmat4(1.0), glm::dvec3(0.0, -above, 0.0));
    const glm::dmat4 rocking = glm::rotate(glm::dmat4(1.0), (n - 0.5 * (count - 1)) * step_rad, glm::dvec3(1.0, 0.0, 0.0));
    places.push_back({toPivot * rocking * glm::translate(glm::dmat4(1.0), glm::dvec3(0.0, above, 0.0))});
  }
  return places;
}

FrameStack stackOf(const std::vector<Place>& places) {
  auto made = FrameStack::make(imagesOf(places), kWidth, kHeight, places);
  EXPECT_TRUE(made);
  return std::move(*made);
}

std::vector<int> sampled(const FrameStack& stack, Quality quality, const glm::dvec3& start, const glm::dvec3& step, int count) {
  std::vector<std::uint8_t> row(static_cast<std::size_t>(count), std::uint8_t{255});
  stack.sampleRow(quality, start, step, {0, count}, row.data());
  return {row.begin(), row.end()};
}

TEST(FrameStack, ShowsARecordedPlanePixelForPixel) {
  for (const auto& places : {shifted(9, 2.0), rocked(41, 0.01, 40.0)}) {
    const FrameStack stack = stackOf(places);
    const std::vector<std::uint8_t> images = imagesOf(places);
    for (const std::size_t n : {std::size_t{2}, places.size() / 2, places.size() - 2})
      for (int y : {0, 17, kHeight - 1})
        for (const Quality quality : {Quality::weave, Quality::linear, Quality::cubic}) {
          const glm::dmat4& m = places[n].matrix;
          const auto row = sampled(stack, quality, glm::dvec3(m * glm::dvec4(0.0, y, 0.0, 1.0)), glm::dvec3(m[0]), kWidth);
          for (int x = 0; x < kWidth; ++x)
            EXPECT_NEAR(row[static_cast<std::size_t>(x)],
                        images[(n * kHeight + static_cast<std::size_t>(y)) * kWidth + static_cast<std::size_t>(x)], 1)
                << "image " << n << " pixel " << x << ", " << y;
        }
  }
}

TEST(FrameStack, BlendsBetweenRecordedPlanes) {
  const FrameStack parallel = stackOf(shifted(9, 2.0)), fan = stackOf(rocked(41, 0.01, 40.0));
  for (const FrameStack* stack : {&parallel, &fan}) {
    // Across all planes, aslant in all three directions.
    const glm::dvec3 start(8.0, 12.0, stack == &parallel ? 0.7 : -5.0), step(0.7, 0.3, 0.25);
    const auto row = sampled(*stack, Quality::linear, start, step, 40);
    for (int n = 0; n < 40; ++n) EXPECT_NEAR(row[static_cast<std::size_t>(n)], seen(start + static_cast<double>(n) * step), 1.6) << n;
  }
}

TEST(FrameStack, IsAsGoodAsStraightBetweenThePlacesThatAreWorkedOut) {
  const auto places = rocked(141, 0.005, 160.0);  // 40 degrees about a point 50 mm above the face, pixels of 0.31 mm
  const FrameStack stack = stackOf(places);
  const glm::dvec3 start(2.0, 20.0, -60.0), step(0.1, 0.05, 0.75);
  int near = 0;
  for (int begin = 0; begin + 16 < 160; begin += 16) {
    const glm::dvec3 first = stack.at(start + static_cast<double>(begin) * step, near),
                     last = stack.at(start + (begin + 16.0) * step, near);
    const glm::dvec3 middle = stack.at(start + (begin + 8.0) * step, near);
    if (std::isnan(first.z) || std::isnan(last.z)) continue;
    EXPECT_LT(glm::distance(glm::dvec2(middle), 0.5 * glm::dvec2(first + last)), 0.25) << "pixels, at " << begin;
  }
}

TEST(FrameStack, IsBlackWhereNothingWasRecordedAndWritesNothingElse) {
  const FrameStack stack = stackOf(shifted(9, 2.0));
  std::vector<std::uint8_t> row(80, std::uint8_t{7});
  stack.sampleRow(Quality::linear, {-10.0, 20.0, 8.0}, {1.0, 0.0, 0.0}, {3, 75}, row.data());
  for (int x = 0; x < 80; ++x) {
    const double at = x - 10.0;
    const bool isAsked = x >= 3 && x < 75, isRecorded = at >= -0.5 && at < kWidth - 0.5;
    if (!isAsked)
      EXPECT_EQ(row[static_cast<std::size_t>(x)], 7) << x;
    else if (!isRecorded)
      EXPECT_EQ(row[static_cast<std::size_t>(x)], 0) << x;
    else
      EXPECT_GT(row[static_cast<std::size_t>(x)], 0) << x;
  }
  // The first and the last image reach half a step outwards.
  EXPECT_GT(sampled(stack, Quality::linear, {20.0, 20.0, -0.9}, {0.0, 0.0, 0.0}, 1)[0], 0);
  EXPECT_EQ(sampled(stack, Quality::linear, {20.0, 20.0, -1.1}, {0.0, 0.0, 0.0}, 1)[0], 0);
  EXPECT_GT(sampled(stack, Quality::linear, {20.0, 20.0, 16.9}, {0.0, 0.0, 0.0}, 1)[0], 0);
  EXPECT_EQ(sampled(stack, Quality::linear, {20.0, 20.0, 17.1}, {0.0, 0.0, 0.0}, 1)[0], 0);
}

TEST(FrameStack, ReadsTheNearestImageWherePlanesCross) {
  const auto places = rocked(41, 0.01, -10.0);  // about a line in the tenth row
  const FrameStack stack = stackOf(places);
  const auto row = sampled(stack, Quality::linear, {0.0, 10.0, 0.0}, {1.0, 0.0, 0.0}, kWidth);
  for (int x = 0; x < kWidth; ++x) EXPECT_NEAR(row[static_cast<std::size_t>(x)], seen({x, 10.0, 0.0}), 3.0) << x;
}

TEST(FrameStack, DoesNotMindWhichWayAFileTurnsItsNormalsOrItsSweep) {
  auto places = rocked(41, 0.01, 40.0);
  const FrameStack usual = stackOf(places);
  std::vector<Place> turned = places, back(places.rbegin(), places.rend());
  for (std::size_t n = 0; n < turned.size(); n += 2) turned[n].matrix[2] *= -3.0;
  const FrameStack otherNormals = stackOf(turned), otherWay = stackOf(back);
  const glm::dvec3 start(4.0, 15.0, -6.0), step(0.9, 0.2, 0.2);
  EXPECT_EQ(sampled(usual, Quality::linear, start, step, 50), sampled(otherNormals, Quality::linear, start, step, 50));
  const auto there = sampled(usual, Quality::linear, start, step, 50), again = sampled(otherWay, Quality::linear, start, step, 50);
  for (std::size_t n = 0; n < there.size(); ++n) EXPECT_NEAR(there[n], again[n], 1) << n;
}

TEST(FrameStack, IsReadByEverySlicer) {
  const auto places = rocked(41, 0.01, 40.0);
  const FrameStack stack = stackOf(places);
  const std::vector<std::uint8_t> voxels(8, std::uint8_t{255});
  SliceSource source(VolumeView<const std::uint8_t>{voxels.data(), Grid{.dims = {2, 2, 2}}});
  source.frames = &stack;
  Image<std::uint8_t> plane(kWidth, kHeight), rows(kWidth, kHeight);
  SliceScratch scratch;
  slice(Quality::linear, source, places[20], viewOf(plane), scratch);
  std::vector<SampleRow> asked;
  for (int y = 0; y < kHeight; ++y)
    asked.push_back({glm::dvec3(places[20].matrix * glm::dvec4(0.0, y, 0.0, 1.0)), glm::dvec3(places[20].matrix[0]), y, {0, kWidth}});
  sampleRows(Quality::linear, source, asked, viewOf(rows), scratch);
  EXPECT_EQ(plane.pixels, rows.pixels);
  const auto images = imagesOf(places);
  for (std::size_t n = 0; n < plane.pixels.size(); ++n) ASSERT_NEAR(plane.pixels[n], images[20 * plane.pixels.size() + n], 1) << n;
}

TEST(FrameStack, RefusesWhatLiesNowhere) {
  const auto places = shifted(3, 1.0);
  const auto images = imagesOf(places);
  EXPECT_FALSE(FrameStack::make(images, kWidth, kHeight, std::vector<Place>(places.begin(), places.begin() + 1)));
  EXPECT_FALSE(FrameStack::make({images.begin(), images.end() - 1}, kWidth, kHeight, places));
  for (const double bad : {0.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    auto broken = places;
    broken[1].matrix[0] = glm::dvec4(bad, 0.0, 0.0, 0.0);
    const auto made = FrameStack::make(images, kWidth, kHeight, broken);
    ASSERT_FALSE(made);
    EXPECT_EQ(made.error().code, ErrorCode::badField);
  }
  const FrameStack stack = stackOf(places);
  const double none = std::numeric_limits<double>::quiet_NaN(), far = 1e300;
  for (const double bad : {none, far, -far, std::numeric_limits<double>::infinity()})
    for (const int grey : sampled(stack, Quality::linear, {bad, 5.0, 1.0}, {1.0, 0.0, 0.0}, 20)) EXPECT_EQ(grey, 0);
}

}  // namespace
}  // namespace ew::frame_stack_test
