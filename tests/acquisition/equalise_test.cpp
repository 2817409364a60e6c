#include "ew/acquisition/equalise.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <functional>
#include <numeric>

#include "acquisition/pulse.h"

namespace ew::equalise_test {
namespace {

using sweeps::Sweep;

constexpr double kGreyPerDb = 255.0 / 60.0;
constexpr double kPixel_mm = 0.5;

/// What every sweep looks at: structure and speckle, which is as bright from every side but not the same.
double fieldAt(const glm::dvec3& p_mm, int view) {
  const double structure = 25.0 * pulse::texture(p_mm / 9.0) + 0.2 * p_mm.x;
  const glm::ivec3 grain(glm::round(p_mm * 2.0));
  // Fully developed speckle in decibels: 20 log10 of a Rayleigh amplitude spreads by 5.6 dB.
  const double u = pulse::hashed(grain.x + 977 * view, grain.y, grain.z) + 0.5;
  const double speckle_db = 10.0 * std::log10(std::clamp(-std::log(1.0 - 0.999999 * u), 0.01, 20.0));
  return 130.0 + structure + kGreyPerDb * speckle_db;
}

/// A sweep of parallel frames from one side of a cube of 60 mm; its machine adds dgc_db at each depth.
Sweep seenFrom(const glm::dvec3& across, const glm::dvec3& down, const glm::dvec3& origin, int view,
               const std::function<double(double)>& dgc_db) {
  Sweep sweep;
  const glm::dvec3 along = glm::cross(across, down);
  for (int n = 0; n < 24; ++n) {
    const glm::dmat4 imageToWorld =
        sweeps::matrixOf(kPixel_mm * across, kPixel_mm * down, kPixel_mm * along, origin + 2.5 * static_cast<double>(n) * along);
    sweep.add(sweeps::imageOf(121, 121,
                              [&](int x, int y) {
                                const glm::dvec3 p_mm(imageToWorld * glm::dvec4(x, y, 0.0, 1.0));
                                const double level = fieldAt(p_mm, view) + kGreyPerDb * dgc_db(kPixel_mm * y);
                                return static_cast<int>(std::clamp(std::lround(level), 0l, 255l));
                              }),
              imageToWorld);
  }
  return sweep;
}

double firstDgc_db(double depth_mm) { return 4.0 + 3.0 * std::sin(depth_mm / 12.0); }
double secondDgc_db(double depth_mm) { return -2.0 - 0.08 * depth_mm; }

/// From above (depth along y) and from the side (depth along x).
Sweep above(const std::function<double(double)>& dgc_db) { return seenFrom({1, 0, 0}, {0, 1, 0}, {0, 0, 0}, 0, dgc_db); }
Sweep aside(const std::function<double(double)>& dgc_db) { return seenFrom({0, 0, 1}, {1, 0, 0}, {0, 0, 0}, 1, dgc_db); }

/// Largest distance of correction + machine from one level, dB, over the depths that overlap.
double worst_db(const std::vector<std::pair<const DepthCorrection*, std::function<double(double)>>>& curves) {
  std::vector<double> left_db;
  for (const auto& [correction, machine_db] : curves)
    for (double depth_mm = std::ceil(correction->seenFrom_mm); depth_mm <= correction->seenTo_mm; depth_mm += 1.0)
      left_db.push_back(correction->at(depth_mm) / kGreyPerDb + machine_db(depth_mm));
  const double mean = std::accumulate(left_db.begin(), left_db.end(), 0.0) / static_cast<double>(left_db.size());
  double worst = 0.0;
  for (const double left : left_db) worst = std::max(worst, std::abs(left - mean));
  return worst;
}

TEST(Equalise, TwoKnownDgcCurvesAreRecoveredWithinHalfADecibel) {
  const Sweep first = above(firstDgc_db), second = aside(secondDgc_db);
  const SweepToEqualise sweeps[] = {{"above", first.frames, {}}, {"aside", second.frames, {}}};
  const auto found = estimateEqualisation(sweeps, {}, noProgress());
  ASSERT_TRUE(found.has_value()) << found.error();
  EXPECT_EQ(found->groups, 1);
  EXPECT_LT(worst_db({{&found->sweeps[0], firstDgc_db}, {&found->sweeps[1], secondDgc_db}}), 0.5);
  EXPECT_GT(found->disagreementBefore_db, 5.0);
  EXPECT_LT(found->disagreementAfter_db, 1.3) << "the speckle of a cell";
  EXPECT_TRUE(found->notes.empty());
}

TEST(Equalise, AShadowInOneViewDoesNotBendTheCurves) {
  Sweep first = above(firstDgc_db);
  const Sweep second = aside(secondDgc_db);
  for (auto& image : first.images)
    for (int y = 80; y < 121; ++y)
      for (int x = 20; x < 40; ++x) {
        auto& level = viewOf(image).at(x, y);
        level = static_cast<std::uint8_t>(std::max(1, level - 60));
      }
  const SweepToEqualise sweeps[] = {{"above", first.frames, {}}, {"aside", second.frames, {}}};
  const auto found = estimateEqualisation(sweeps, {}, noProgress());
  ASSERT_TRUE(found.has_value()) << found.error();
  EXPECT_LT(worst_db({{&found->sweeps[0], firstDgc_db}, {&found->sweeps[1], secondDgc_db}}), 0.7);
}

TEST(Equalise, AppliedToTheFramesItMakesTheSweepsAgree) {
  Sweep first = above(firstDgc_db), second = aside(secondDgc_db);
  std::vector<SweepToEqualise> sweeps{{"above", first.frames, {}}, {"aside", second.frames, {}}};
  const auto found = estimateEqualisation(sweeps, {}, noProgress());
  ASSERT_TRUE(found.has_value());
  for (const auto& [sweep, correction] : {std::pair{&first, &found->sweeps[0]}, std::pair{&second, &found->sweeps[1]}}) {
    const FrameEqualiser equaliser(*correction, {}, sweep->frames.front());
    for (auto& image : sweep->images) equaliser.apply(viewOf(std::as_const(image)), viewOf(image));
  }
  const auto again = estimateEqualisation(sweeps, {}, noProgress());
  ASSERT_TRUE(again.has_value());
  EXPECT_LT(again->disagreementBefore_db, 1.3) << "the speckle of a cell";
}

TEST(Equalise, SweepsThatDoNotOverlapAreNamedAndLeftAsTheyAre) {
  const Sweep first = above(firstDgc_db), second = aside(secondDgc_db);
  const Sweep far = seenFrom({1, 0, 0}, {0, 1, 0}, {500, 0, 0}, 2, firstDgc_db);
  const SweepToEqualise sweeps[] = {{"above", first.frames, {}}, {"far away", far.frames, {}}, {"aside", second.frames, {}}};
  const auto found = estimateEqualisation(sweeps, {}, noProgress());
  ASSERT_TRUE(found.has_value()) << found.error();
  EXPECT_EQ(found->groups, 2);
  EXPECT_EQ(found->sweeps[0].group, found->sweeps[2].group);
  EXPECT_NE(found->sweeps[0].group, found->sweeps[1].group);
  for (const double grey : found->sweeps[1].grey) EXPECT_NEAR(grey, 0.0, 1e-6);
  ASSERT_EQ(found->notes.size(), 2u);
  EXPECT_NE(found->notes[1].english().find("far away"), std::string::npos) << found->notes[1];
}

TEST(Equalise, DoesNotDependOnTheNumberOfThreads) {
  const Sweep first = above(firstDgc_db), second = aside(secondDgc_db);
  const SweepToEqualise sweeps[] = {{"above", first.frames, {}}, {"aside", second.frames, {}}};
  EqualiseOptions options;
  std::vector<std::vector<double>> curves;
  for (const int threads : {1, 2, 8}) {
    options.threads = threads;
    curves.push_back(estimateEqualisation(sweeps, options, noProgress())->sweeps[0].grey);
  }
  EXPECT_EQ(curves[0], curves[1]);
  EXPECT_EQ(curves[0], curves[2]);
}

TEST(Equalise, RefusesWhatCannotBeCompared) {
  const Sweep first = sweeps::stack(20, 20, 3, 1.0, [](int, int, int) { return 90; });
  const SweepToEqualise one[] = {{"a", first.frames, {}}};
  EXPECT_EQ(estimateEqualisation(one, {}, noProgress()).error().code, ErrorCode::badField);
  const SweepToEqualise empty[] = {{"a", first.frames, {}}, {"b", {}, {}}};
  EXPECT_EQ(estimateEqualisation(empty, {}, noProgress()).error().code, ErrorCode::noValidPose);
  const SweepToEqualise two[] = {{"a", first.frames, {}}, {"b", first.frames, {}}};
  EqualiseOptions options;
  options.cell_mm = 0.0;
  EXPECT_EQ(estimateEqualisation(two, options, noProgress()).error().code, ErrorCode::badField);
  options = {};
  options.fewestCells = 1;
  const auto constant = estimateEqualisation(two, options, noProgress());
  ASSERT_TRUE(constant.has_value()) << "constant images agree";
  for (const double grey : constant->sweeps[0].grey) EXPECT_NEAR(grey, 0.0, 1e-6);
}

RC_GTEST_PROP(FrameEqualiser, TablesRiseWithTheLevelAndKeepBlack, ()) {
  DepthCorrection correction;
  correction.knot_mm = 3.0;
  for (int k = 0; k < 5; ++k) correction.grey.push_back(*rc::gen::inRange(-300, 300));
  const Sweep ramp = sweeps::stack(256, 12, 1, 1.0, [](int x, int, int) { return x; });
  const FrameEqualiser equaliser(correction, {}, ramp.frames.front());
  GreyImage out(256, 12);
  equaliser.apply(ramp.frames.front().pixels, viewOf(out));
  for (int y = 0; y < 12; ++y) {
    RC_ASSERT(viewOf(out).at(0, y) == 0);
    for (int x = 2; x < 256; ++x) RC_ASSERT(viewOf(out).at(x, y) >= viewOf(out).at(x - 1, y));
    const double expected = std::clamp(128.0 + correction.at(y), 1.0, 255.0);
    RC_ASSERT(std::abs(viewOf(out).at(128, y) - expected) <= 0.51);
  }
}

}  // namespace
}  // namespace ew::equalise_test
