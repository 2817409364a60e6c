#include <atomic>
#include <cmath>
#include <map>
#include <mutex>
#include <span>

#include "counted_stop.h"
#include "ew/phantom/speckle.h"
#include "ew/phantom/voxel_pieces.h"
#include "recipes.h"

namespace ew::voxelise_test {
namespace {

using testing::patientOf;
using testing::patientRecipe;
using testing::shipped;

std::uint64_t fnv1a(const std::vector<std::uint8_t>& values) {
  std::uint64_t hash = 14695981039346656037ull;
  for (const std::uint8_t value : values) hash = (hash ^ value) * 1099511628211ull;
  return hash;
}

constexpr const char* kBallOrgan =
    R"({"name": "ball", "tissue": "dark", "shape": {"ellipsoid": {"centre_mm": [0, 0, 0], "radii_mm": [15, 15, 15]}},
        "border": {"echo_level": 230, "width_mm": 2, "shine": "all round"}})";

TEST(Speckle, IsFullyDevelopedBeforeCompression) {
  SpeckleScratch scratch;
  std::vector<float> power;
  specklePower(7, {0, 0, 0}, {96, 96, 96}, scratch, power);
  double sum = 0.0, sumOfSquares = 0.0, sumOfPower = 0.0, sumOfPowerSquares = 0.0;
  for (const float p : power) {
    const double amplitude = std::sqrt(static_cast<double>(p));
    sum += amplitude;
    sumOfSquares += amplitude * amplitude;
    sumOfPower += static_cast<double>(p);
    sumOfPowerSquares += static_cast<double>(p) * static_cast<double>(p);
  }
  const auto n = static_cast<double>(power.size());
  const double mean = sum / n;
  EXPECT_NEAR(mean / std::sqrt(sumOfSquares / n - mean * mean), 1.91, 0.04) << "Rayleigh: sqrt(pi / (4 - pi))";
  EXPECT_NEAR(sumOfPower / n, 1.0, 0.02);
  EXPECT_NEAR(sumOfPowerSquares / n / (sumOfPower / n) / (sumOfPower / n), 2.0, 0.06) << "exponential power";
}

TEST(Speckle, HasACorrelationLengthBetweenOneAndTwoVoxelsInEveryDirection) {
  constexpr int kSize = 64;
  SpeckleScratch scratch;
  std::vector<float> power;
  specklePower(11, {0, 0, 0}, {kSize, kSize, kSize}, scratch, power);
  double mean = 0.0, variance = 0.0;
  for (const float p : power) mean += static_cast<double>(p);
  mean /= static_cast<double>(power.size());
  for (const float p : power) variance += (static_cast<double>(p) - mean) * (static_cast<double>(p) - mean);
  variance /= static_cast<double>(power.size());
  const std::ptrdiff_t steps[3] = {1, kSize, kSize * kSize};
  for (const std::ptrdiff_t step : steps) {
    const auto correlation = [&](int lag) {
      double sum = 0.0;
      std::size_t count = 0;
      for (int k = 0; k + 4 < kSize; ++k)
        for (int j = 0; j + 4 < kSize; ++j)
          for (int i = 0; i + 4 < kSize; ++i, ++count) {
            const std::ptrdiff_t at = (static_cast<std::ptrdiff_t>(k) * kSize + j) * kSize + i;
            sum += (static_cast<double>(power[static_cast<std::size_t>(at)]) - mean) *
                   (static_cast<double>(power[static_cast<std::size_t>(at + lag * step)]) - mean);
          }
      return sum / static_cast<double>(count) / variance;
    };
    // The taps' own correlation is 56/70, 28/70, 8/70, 1/70; the power's is its square.
    EXPECT_NEAR(correlation(1), 0.64, 0.04);
    EXPECT_NEAR(correlation(2), 0.16, 0.04);
    EXPECT_NEAR(correlation(3), 0.013, 0.04);
  }
}

TEST(Speckle, OfNeighbouringBoxesFitsTogether) {
  SpeckleScratch scratch;
  std::vector<float> all, part;
  specklePower(3, {0, 0, 0}, {17, 9, 20}, scratch, all);
  specklePower(3, {5, 3, 8}, {7, 4, 6}, scratch, part);
  for (int k = 0; k < 6; ++k)
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 7; ++i)
        ASSERT_EQ(part[static_cast<std::size_t>((k * 4 + j) * 7 + i)], all[static_cast<std::size_t>(((k + 8) * 9 + j + 3) * 17 + i + 5)]);
}

TEST(Decibel, IsTenTimesTheLogarithm) {
  const Decibel decibel;
  for (double power = 1e-5; power < 100.0; power *= 1.0173)
    EXPECT_NEAR(static_cast<double>(decibel.of(static_cast<float>(power))), 10.0 * std::log10(power), 0.003);
  EXPECT_NEAR(static_cast<double>(decibel.of(0.0F)), -60.206, 0.01);
}

TEST(Voxelise, GivesTheSameVoxelsOnOneTwoAndEightThreads) {
  const auto patient = patientOf(patientRecipe(kBallOrgan));
  ASSERT_TRUE(patient) << patient.error();
  std::vector<std::uint64_t> hashes;
  for (const int threads : {1, 2, 8}) {
    const auto made = voxelise(**patient, {.spacing_mm = 1.0, .seed = 5, .threads = threads}, noProgress());
    ASSERT_TRUE(made) << made.error();
    hashes.push_back(fnv1a(made->volume.echo) ^ fnv1a(made->labels) ^ fnv1a(made->volume.coverage));
  }
  EXPECT_EQ(hashes[0], hashes[1]);
  EXPECT_EQ(hashes[0], hashes[2]);
}

TEST(Voxelise, GivesOtherSpeckleForAnotherSeedButTheSameLabels) {
  const auto patient = patientOf(patientRecipe(kBallOrgan));
  const auto one = voxelise(**patient, {.spacing_mm = 2.0, .seed = 1}, noProgress());
  const auto two = voxelise(**patient, {.spacing_mm = 2.0, .seed = 2}, noProgress());
  EXPECT_NE(one->volume.echo, two->volume.echo);
  EXPECT_EQ(one->labels, two->labels);
}

TEST(Voxelise, CompressesSixtyDecibelsIntoTheGreyScale) {
  const auto patient = patientOf(patientRecipe(kBallOrgan));
  const auto made = voxelise(**patient, {.spacing_mm = 1.0}, noProgress());
  double sum = 0.0, squares = 0.0, n = 0.0;
  for (std::size_t at = 0; at < made->volume.echo.size(); ++at) {
    const Grid& grid = made->volume.grid;
    const int k = static_cast<int>(at / grid.indexOf(0, 0, 1));
    if (k > 15) continue;  // away from the ball and its border
    const double grey = made->volume.echo[at];
    if (made->volume.coverageAt(at) != Coverage::measured) continue;
    sum += grey, squares += grey * grey, ++n;
  }
  EXPECT_NEAR(sum / n, 100.0, 1.5) << "the tissue's echo level is its mean grey";
  EXPECT_NEAR(std::sqrt(squares / n - sum * sum / n / n), 5.57 * 255.0 / 60.0, 1.5) << "log-compressed Rayleigh speckle spreads by 5.57 dB";
}

TEST(Voxelise, ShowsADarkLumenInsideABrightBorder) {
  const auto patient = patientOf(patientRecipe(kBallOrgan));
  const auto made = voxelise(**patient, {.spacing_mm = 1.0}, noProgress());
  const Grid& grid = made->volume.grid;
  double border = 0.0, n = 0.0;
  for (int k = 0; k < grid.dims.z; ++k)
    for (int j = 0; j < grid.dims.y; ++j)
      for (int i = 0; i < grid.dims.x; ++i) {
        const double r = glm::length(grid.origin_mm + glm::dvec3(i, j, k));
        const int grey = made->volume.echo[grid.indexOf(i, j, k)];
        if (r < 12.5) {
          EXPECT_LE(grey, 1) << r;
        }
        if (std::abs(r - 15.0) < 0.3) border += grey, ++n;
      }
  EXPECT_GT(border / n, 170.0);
}

TEST(Voxelise, LeavesEverythingOutsideTheSkinUncovered) {
  std::string recipe = patientRecipe(kBallOrgan);
  recipe.replace(recipe.find("[40, 40, 40]"), 12, "[70, 70, 70]");
  const auto patient = patientOf(recipe);
  const auto made = voxelise(**patient, {.spacing_mm = 2.0}, noProgress());
  const Grid& grid = made->volume.grid;
  for (int k = 0; k < grid.dims.z; ++k)
    for (int j = 0; j < grid.dims.y; ++j)
      for (int i = 0; i < grid.dims.x; ++i) {
        const double r = glm::length(grid.origin_mm + 2.0 * glm::dvec3(i, j, k));
        const std::size_t at = grid.indexOf(i, j, k);
        if (std::abs(r - 60.0) < 0.2) continue;
        ASSERT_EQ(made->volume.coverageAt(at), r < 60.0 ? Coverage::measured : Coverage::absent);
        if (r > 60.0) {
          ASSERT_EQ(made->volume.echo[at] + made->labels[at], 0);
        }
      }
}

TEST(Voxelise, CastsNoShadowBehindTheStone) {
  // The tissue just behind the gall bladder, on the line from the front skin through the stone and on lines beside it.
  const auto made = voxelise(shipped(), {.spacing_mm = 1.0, .threads = 2}, noProgress());
  ASSERT_TRUE(made) << made.error();
  const Grid& grid = made->volume.grid;
  const auto meanBehind = [&](double x0) {
    double sum = 0.0, n = 0.0;
    for (double x = x0 - 3; x <= x0 + 3; ++x)
      for (double z = -58; z <= -52; ++z)
        for (double y = -4; y <= 8; ++y, ++n) {
          const glm::ivec3 ijk = glm::round(glm::dvec3(x, y, z) - grid.origin_mm);
          sum += made->volume.echo[grid.indexOf(ijk.x, ijk.y, ijk.z)];
        }
    return sum / n;
  };
  EXPECT_GT(meanBehind(-51.0), 0.6 * meanBehind(-66.0));
}

TEST(Voxelise, RefusesASpacingThatNeedsMoreMemoryThanAllowedAndSaysHowMuch) {
  const auto made = voxelise(shipped(), {.spacing_mm = 0.02, .maxBytes = 1ull << 30}, noProgress());
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, ErrorCode::tooLarge);
  EXPECT_NE(made.error().sentence().find("MiB"), std::string::npos) << made.error().sentence();
  EXPECT_GT(voxeliseForecast_bytes(shipped(), 0.02), 1e12);
}

TEST(Voxelise, AsksAtLeastOncePerHundredThousandVoxelsAndStopsAtItsNextQuestion) {
  const VoxeliseOptions options{.spacing_mm = 2.5, .threads = 1};
  auto whole = test::CountedStop::never();
  const auto made = voxelise(shipped(), options, whole);
  ASSERT_TRUE(made) << made.error();
  EXPECT_GT(whole.questions(), static_cast<long>(made->volume.grid.voxelCount() / 100000));
  for (const double part : {0.0, 0.1, 0.35, 0.6, 0.95}) {
    auto stop = test::CountedStop::atQuestion(1 + static_cast<long>(part * static_cast<double>(whole.questions() - 1)));
    const auto stopped = voxelise(shipped(), options, stop);
    ASSERT_FALSE(stopped) << part;
    EXPECT_EQ(stopped.error().code, ErrorCode::cancelled);
    EXPECT_LE(stop.questionsAfter(), test::kMostQuestionsAfter) << part;
    EXPECT_LE(stop.reportsAfter(), test::kMostReportsAfter) << part;
  }
}

/// Pieces in memory, which say how many were painted and how many were there.
class PiecesInMemory final : public VoxelPieces {
 public:
  bool recall(int piece, std::vector<std::uint8_t>& bytes) override {
    const auto found = kept_.find(piece);
    if (found != kept_.end()) bytes = found->second;
    return found != kept_.end();
  }
  void keep(int piece, std::span<const std::uint8_t> bytes) override {
    const std::lock_guard lock(guard_);
    kept_[piece].assign(bytes.begin(), bytes.end());
    ++painted;
  }
  void recalled(double part) override { share = part; }
  void cutShort(int piece) { kept_[piece].resize(kept_[piece].size() / 2); }
  [[nodiscard]] int first() const { return kept_.begin()->first; }

  int painted = 0;
  double share = -1.0;

 private:
  std::mutex guard_;
  std::map<int, std::vector<std::uint8_t>> kept_;
};

TEST(Voxelise, GoesOnWithThePiecesOfARunThatWasStopped) {
  const VoxeliseOptions once{.spacing_mm = 6.0, .threads = 1, .maps = true};
  const auto whole = voxelise(shipped(), once, noProgress());
  ASSERT_TRUE(whole) << whole.error();
  PiecesInMemory pieces;
  VoxeliseOptions options = once;
  options.pieces = &pieces;
  auto stop = test::CountedStop::atFraction(0.45);
  ASSERT_FALSE(voxelise(shipped(), options, stop));
  EXPECT_EQ(pieces.share, 0.0);
  const int before = pieces.painted;
  ASSERT_GT(before, 2);
  pieces.cutShort(pieces.first());
  const auto made = voxelise(shipped(), options, noProgress());
  ASSERT_TRUE(made) << made.error();
  EXPECT_NEAR(pieces.share, 0.45, 0.25) << "what was there is not painted again";
  EXPECT_GT(pieces.painted, before);
  EXPECT_EQ(made->volume.echo, whole->volume.echo);
  EXPECT_EQ(made->volume.coverage, whole->volume.coverage);
  EXPECT_EQ(made->labels, whole->labels);
  EXPECT_EQ(made->maps->level, whole->maps->level);
  EXPECT_EQ(made->maps->surfaceDistance, whole->maps->surfaceDistance);
  EXPECT_EQ(made->maps->surfaceKind, whole->maps->surfaceKind);
  const int painted = pieces.painted;
  ASSERT_TRUE(voxelise(shipped(), options, noProgress()));
  EXPECT_EQ(pieces.painted, painted) << "nothing is left to be painted";
}

}  // namespace
}  // namespace ew::voxelise_test
