#include "ew/registration/quality.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "registration/fields.h"

namespace quality_test {
namespace {

using namespace ew;
using namespace ew::registration;
using namespace ew::test;

/// Smooth blobs of about 3 mm on 1 mm voxels, between 60 and 180; of period `side` along every axis.
Volume blobs(int side, unsigned seed, bool alikeAlongK = false) {
  Volume volume;
  volume.grid = uprightGrid(glm::ivec3(side), 1.0);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> phase(0.0, 6.283);
  struct Wave {
    glm::ivec3 k;
    double phase;
  };
  std::vector<Wave> waves;
  for (int n = 0; n < 24; ++n)
    waves.push_back(
        {{static_cast<int>(random() % 7) - 3, static_cast<int>(random() % 7) - 3, alikeAlongK ? 0 : static_cast<int>(random() % 7) - 3},
         phase(random)});
  for (int k = 0; k < side; ++k)
    for (int j = 0; j < side; ++j)
      for (int i = 0; i < side; ++i) {
        double sum = 0.0;
        for (const Wave& w : waves) sum += std::cos(6.283185307 / side * (w.k.x * i + w.k.y * j + w.k.z * k) + w.phase);
        volume.echo.push_back(static_cast<std::uint8_t>(std::lround(std::fmin(180.0, std::fmax(60.0, 120.0 + 12.0 * sum)))));
      }
  return volume;
}

template <class To = frame::Moving, class From = frame::Fixed>
Transform<To, From> shifted(double x, double y = 0.0, double z = 0.0) {
  glm::dmat4 m(1.0);
  m[3] = glm::dvec4(x, y, z, 1.0);
  return {m};
}

Quality assessed(const Volume& fixed, const Volume& moving, const Transform<frame::Moving, frame::Fixed>& before, const Deformation& after,
                 const Deformation* backward = nullptr, const QualityOptions& options = {}) {
  auto found = assessQuality({&fixed, {}}, {&moving, {}}, before, after, backward, options, noProgress());
  EXPECT_TRUE(found) << (found ? "" : found.error().sentence());
  return found ? *found : Quality{};
}

TEST(AssessQuality, FindsNothingToBlameInAVolumeOnItself) {
  const Volume volume = blobs(32, 1);
  const Deformation rest;
  const Quality q = assessed(volume, volume, {}, rest, &rest);
  EXPECT_NEAR(q.after.correlation, 1.0, 1e-6);
  EXPECT_NEAR(q.after.overlapShare, 1.0, 1e-12);
  EXPECT_NEAR(q.greyCorrelationAfter, 1.0, 1e-12);
  EXPECT_NEAR(q.localCorrelationAfter, 1.0, 1e-6);
  EXPECT_EQ(q.residualRms_grey, 0.0);
  EXPECT_EQ(q.residualHistogram[32], volume.echo.size());
  EXPECT_EQ(q.jacobian.smallest, 1.0);
  EXPECT_EQ(q.inverseConsistencyMedian_mm.value(), 0.0);
  EXPECT_EQ(q.inverseConsistency95_mm.value(), 0.0);
  std::size_t voxels = 0;
  for (const RegionQuality& region : q.regions) {
    voxels += region.voxels;
    EXPECT_NEAR(region.uncertainty_mm, 0.0, 1e-3);  // no residual, no doubt
  }
  EXPECT_EQ(voxels, volume.echo.size());
}

TEST(AssessQuality, PutsAGainIntoTheResidualAndNotIntoTheAgreement) {
  const Volume fixed = blobs(32, 2);
  Volume moving = fixed;
  for (std::uint8_t& e : moving.echo) e = static_cast<std::uint8_t>(e - 13);
  const Quality q = assessed(fixed, moving, {}, {});
  EXPECT_NEAR(q.after.correlation, 1.0, 1e-5);
  EXPECT_DOUBLE_EQ(q.residualRms_grey, 13.0);
  EXPECT_EQ(q.residualHistogram[35], fixed.echo.size());  // 12 to 15
}

TEST(AssessQuality, TellsBeforeFromAfterAndCountsTheOverlap) {
  const Volume fixed = blobs(40, 3);
  Volume moving = fixed;
  moving.grid.origin_mm = {500.0, 0.0, 0.0};
  const Quality q = assessed(fixed, moving, shifted(520.0), {shifted(500.0), {}});
  EXPECT_NEAR(q.before.overlapShare, 0.5, 0.03);  // half of the width lies beyond
  EXPECT_NEAR(q.after.overlapShare, 1.0, 1e-9);
  EXPECT_LT(q.before.correlation, 0.6);
  EXPECT_NEAR(q.after.correlation, 1.0, 1e-6);
  EXPECT_LT(q.greyCorrelationBefore, 0.6);
  EXPECT_NEAR(q.greyCorrelationAfter, 1.0, 1e-12);
  EXPECT_LT(q.after.chance, 0.5);
}

TEST(AssessQuality, SaysHowFarThereAndBackIsFromHome) {
  const Volume volume = blobs(32, 4);
  const Deformation backward{shifted(-1.0, 0.5), {}};
  const Quality q = assessed(volume, volume, {}, {shifted(3.0, -0.5), {}}, &backward);
  EXPECT_NEAR(q.inverseConsistencyMedian_mm.value(), 2.0, 1e-9);
  EXPECT_NEAR(q.inverseConsistency95_mm.value(), 2.0, 1e-9);
  EXPECT_FALSE(assessed(volume, volume, {}, {}).inverseConsistencyMedian_mm.has_value());
}

TEST(AssessQuality, GivesTheJacobianOfTheElasticPart) {
  const Volume volume = blobs(32, 5);
  const glm::dmat3 squeeze{{-0.4, 0.0, 0.0}, {0.0, 0.1, 0.0}, {0.0, 0.0, 0.0}};
  const Deformation squeezed{{}, affineField(uprightGrid(glm::ivec3(5), 8.0), squeeze, glm::dvec3(0.0))};
  const Quality q = assessed(volume, volume, {}, squeezed);
  EXPECT_NEAR(q.jacobian.smallest, 0.66, 1e-6);
  EXPECT_NEAR(q.jacobian.largest, 0.66, 1e-6);
}

TEST(AssessQuality, CallsADirectionOpenThatNothingFixes) {
  const Volume volume = blobs(32, 6, true);  // the same along k
  for (const RegionQuality& region : assessed(volume, volume, {}, {}).regions) EXPECT_TRUE(std::isinf(region.uncertainty_mm));
}

TEST(AssessQuality, ExpectsAboutTheErrorThatNoiseReallyMakes) {
  // Blobs under noise of their own in each volume; the best shift of a block is sought by brute force and compared with what was expected.
  const Volume tissue = blobs(48, 7);
  double expected = 0.0, found = 0.0;
  int count = 0;
  for (unsigned seed = 1; seed <= 4; ++seed) {
    Volume fixed = tissue, moving = tissue;
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0.0, 40.0);
    for (Volume* v : {&fixed, &moving})
      for (std::uint8_t& e : v->echo) e = static_cast<std::uint8_t>(std::lround(std::fmin(255.0, std::fmax(0.0, e + noise(random)))));
    QualityOptions options;
    options.region_mm = 48.0;
    const Quality q = assessed(fixed, moving, {}, {}, nullptr, options);
    ASSERT_EQ(q.regions.size(), 1U);
    expected += std::pow(q.regions[0].uncertainty_mm, 2.0);
    // The parabola through three correlations along each axis has its top at the shift this pair would be registered with.
    double squared = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
      std::array<double, 3> at{};
      for (int s = -1; s <= 1; ++s) {
        glm::dvec3 shift(0.0);
        shift[axis] = 0.75 * s;
        at[static_cast<std::size_t>(s + 1)] = assessed(fixed, moving, {}, {shifted(shift.x, shift.y, shift.z), {}}).after.correlation;
      }
      const double top = 0.75 * 0.5 * (at[0] - at[2]) / (at[0] - 2.0 * at[1] + at[2]);
      squared += top * top;
    }
    found += squared;
    ++count;
  }
  expected = std::sqrt(expected / count);
  found = std::sqrt(found / count);
  EXPECT_GT(expected, 0.4 * found);
  EXPECT_LT(expected, 2.5 * found) << "found " << found;
}

TEST(AssessQuality, SaysTheSameForEveryNumberOfThreads) {
  const Volume fixed = blobs(32, 8), moving = blobs(32, 9);
  const Deformation warped{shifted(1.0), wavyField(uprightGrid(glm::ivec3(6), 7.0), 1.0, 30.0)};
  const Quality one = assessed(fixed, moving, {}, warped, nullptr, {15.0, 12.0, 1});
  for (const int threads : {2, 8}) {
    const Quality more = assessed(fixed, moving, {}, warped, nullptr, {15.0, 12.0, threads});
    EXPECT_EQ(one.after, more.after);
    EXPECT_EQ(one.localCorrelationAfter, more.localCorrelationAfter);
    EXPECT_EQ(one.residualHistogram, more.residualHistogram);
    ASSERT_EQ(one.regions.size(), more.regions.size());
    for (std::size_t n = 0; n < one.regions.size(); ++n) EXPECT_EQ(one.regions[n].uncertainty_mm, more.regions[n].uncertainty_mm);
  }
}

TEST(AssessQuality, RefusesWhatItCannotUse) {
  const Volume volume = blobs(16, 10), empty;
  const auto code = [&](const Volume& fixed, const Transform<frame::Moving, frame::Fixed>& before, const QualityOptions& options) {
    const auto found = assessQuality({&fixed, {}}, {&volume, {}}, before, {}, nullptr, options, noProgress());
    return found ? ErrorCode::internal : found.error().code;
  };
  EXPECT_EQ(code(empty, {}, {}), ErrorCode::emptyVolume);
  EXPECT_EQ(code(volume, {glm::dmat4(2.0)}, {}), ErrorCode::notRigid);
  EXPECT_EQ(code(volume, {}, {0.0, 12.0, 1}), ErrorCode::badField);
  EXPECT_EQ(code(volume, {}, {15.0, std::nan(""), 1}), ErrorCode::badField);
}

class Impatient final : public Progress {
 public:
  void report(const Message&, double) override {}
  [[nodiscard]] bool cancelRequested() const override { return true; }
};

TEST(AssessQuality, StopsWhenAskedTo) {
  const Volume volume = blobs(24, 11);
  Impatient impatient;
  const auto found = assessQuality({&volume, {}}, {&volume, {}}, {}, {}, nullptr, {}, impatient);
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, ErrorCode::cancelled);
}

}  // namespace
}  // namespace quality_test
