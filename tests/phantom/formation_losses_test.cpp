// Levels: attenuation, contrast, shadow, noise.
#include <algorithm>

#include "formation.h"

namespace ew::testing::formation_losses_test {
namespace {

/// A cylinder across the image plane (along z), seen by a probe held at y = 2.
std::string across(const std::string& name, const std::string& tissue, double x, double y, double radius) {
  const auto point = [&](double z) { return "[" + std::to_string(x) + ", " + std::to_string(y) + ", " + std::to_string(z) + "]"; };
  return R"({"name": ")" + name + R"(", "tissue": ")" + tissue + R"(", "shape": {"capsule": {"from_mm": )" + point(-60) + R"(, "to_mm": )" +
         point(60) + R"(, "from_radius_mm": )" + std::to_string(radius) + R"(, "to_radius_mm": )" + std::to_string(radius) + "}}}";
}

FormationOptions plain(double depth_mm) {
  FormationOptions options;
  options.depth_mm = depth_mm;
  options.specular = false;
  options.noise_db = -300.0;
  options.tgc = {{0.0, 0.0}};
  return options;
}

/// Mean power over the frames of what lies within `radius_mm` of a place in the image plane.
double powerNear_db(const VirtualScanner& scanner, const std::vector<Image<float>>& frames, const glm::dvec2& centre_mm, double radius_mm) {
  std::vector<double> values;
  for (const Image<float>& frame : frames) {
    for (int s = 0; s < frame.height; ++s) {
      for (int l = 0; l < frame.width; ++l) {
        const BeamGrid::Line& line = scanner.grid().lines[static_cast<std::size_t>(l)];
        if (glm::distance(line.origin_mm + scanner.grid().depth_mm(s) * line.direction, centre_mm) < radius_mm)
          values.push_back(static_cast<double>(
              frame.pixels[static_cast<std::size_t>(s) * static_cast<std::size_t>(frame.width) + static_cast<std::size_t>(l)]));
      }
    }
  }
  return meanPower_db(values);
}

std::vector<Image<float>> framesOf(const VirtualScanner& scanner, int count, double apart_mm) {
  std::vector<Image<float>> frames;
  for (int n = 0; n < count; ++n)
    frames.push_back(envelopeOf(scanner, held(apart_mm * (n - 0.5 * (count - 1))), static_cast<std::uint64_t>(n)));
  return frames;
}

TEST(Losses, AttenuationHasTheTissuesSlopeWithinATwentieth) {
  for (const double slope : {0.5, 1.1}) {
    const auto patient = blockOfTissue(
        R"({"name": "all", "tissue": "lossy", "shape": {"ellipsoid": {"centre_mm": [0, 100, 0], "radii_mm": [900, 200, 900]}}})",
        R"({"name": "lossy", "echo_level": 150, "speckle": 1, "attenuation_db_per_cm_mhz": )" + std::to_string(slope) + "}");
    for (const char* name : {"linear-7.5", "convex-3.5"}) {
      const Probe probe = shippedProbe(name);
      const double depth_mm = probe.kind == ProbeKind::linear ? 40.0 : 100.0;
      const auto scanner = scannerOf(patient, probe, plain(depth_mm));
      const auto frames = framesOf(*scanner, 3, 12.0);
      double n = 0, x = 0, y = 0, xx = 0, xy = 0;  // a straight line through the mean powers of bands
      for (double from = 0.15 * depth_mm; from < 0.9 * depth_mm; from += 0.05 * depth_mm) {
        std::vector<double> values;
        for (const auto& frame : frames) {
          const auto more = band(*scanner, frame, from, from + 0.02 * depth_mm);
          values.insert(values.end(), more.begin(), more.end());
        }
        const double at_cm = 0.1 * (from + 0.01 * depth_mm), power = meanPower_db(values);
        n += 1, x += at_cm, y += power, xx += at_cm * at_cm, xy += at_cm * power;
      }
      const double fitted = -(n * xy - x * y) / (n * xx - x * x), expected = 2.0 * slope * probe.carrier_hz * 1e-6;
      RecordProperty(std::string(name) + " " + std::to_string(slope), std::to_string(fitted / expected) + " of the truth");
      EXPECT_NEAR(fitted, expected, 0.05 * expected) << name;
    }
  }
}

TEST(Losses, DepthGainOfTheRecordingTakesTheExpectedLossBack) {
  FormationOptions options = plain(40.0);
  options.tgc = {};
  const auto scanner = scannerOf(blockOfTissue(), shippedProbe("linear-7.5"), options);
  const auto frames = framesOf(*scanner, 2, 12.0);
  for (const double depth : {8.0, 20.0, 35.0}) {
    std::vector<double> values;
    for (const auto& frame : frames) {
      const auto more = band(*scanner, frame, depth - 2.0, depth + 2.0);
      values.insert(values.end(), more.begin(), more.end());
    }
    EXPECT_NEAR(meanLevel(values), 150.0, 4.0) << depth;
  }
}

TEST(Losses, LesionsHaveTheirContrastWithinADecibelAndCystsAreEmpty) {
  const auto patient = blockOfTissue(across("bright", "brighter", -9, 22, 4) + "," + across("dark", "darker", 0, 22, 4) + "," +
                                     across("cyst", "water", 9, 22, 4));
  const auto even = blockOfTissue();
  FormationOptions options = onlySpeckle(35.0);
  options.noise_db = -70.0;
  const auto scanner = scannerOf(patient, shippedProbe("linear-7.5"), options),
             without = scannerOf(even, shippedProbe("linear-7.5"), options);
  const auto frames = framesOf(*scanner, 6, 6.0), reference = framesOf(*without, 6, 6.0);
  const auto contrast = [&](double x) {
    return powerNear_db(*scanner, frames, {x, 20.0}, 2.6) - powerNear_db(*without, reference, {x, 20.0}, 2.6);
  };
  RecordProperty("contrast", std::to_string(contrast(-9)) + " " + std::to_string(contrast(0)) + " cyst " +
                                 std::to_string(powerNear_db(*scanner, frames, {9, 20}, 2.6)));
  EXPECT_NEAR(contrast(-9.0), 6.0, 1.0);
  EXPECT_NEAR(contrast(0.0), -6.0, 1.0);
  EXPECT_NEAR(powerNear_db(*scanner, frames, {9.0, 20.0}, 2.6), -70.0, 1.0);  // nothing but the machine's noise
}

TEST(Losses, AStoneCastsItsShadowWhereRaysSay) {
  const double x = 4.0, y = 32.0, radius = 6.0;
  const auto patient = blockOfTissue(across("stone", "stone", x, y, radius)), even = blockOfTissue();
  FormationOptions options = plain(90.0);
  options.tgc = {{0.0, 0.0}, {90.0, 63.0}};
  options.penumbra = false;
  for (const char* name : {"convex-3.5", "linear-7.5"}) {
    Probe probe = shippedProbe(name);
    const auto scanner = scannerOf(patient, probe, options), without = scannerOf(even, probe, options);
    const auto frames = framesOf(*scanner, 5, 8.0), reference = framesOf(*without, 5, 8.0);
    const BeamGrid& grid = scanner->grid();
    int inShadow = 0;
    for (std::size_t l = 3; l + 3 < grid.lines.size(); ++l) {
      const BeamGrid::Line& line = grid.lines[l];
      // How far the ray passes the stone's middle, and how deep it leaves it.
      const glm::dvec2 toStone = glm::dvec2(x, y - 2.0) - line.origin_mm;
      const double along = glm::dot(toStone, line.direction), miss = std::sqrt(glm::dot(toStone, toStone) - along * along);
      double shadowed = 0.0, open = 0.0;
      for (std::size_t n = 0; n < frames.size(); ++n) {
        for (int s = 0; s < grid.samples; ++s) {
          if (grid.depth_mm(s) < along + radius + 3.0 || grid.depth_mm(s) > along + radius + 30.0) continue;
          const auto at = static_cast<std::size_t>(s) * grid.lines.size() + l;
          shadowed += static_cast<double>(frames[n].pixels[at]) * static_cast<double>(frames[n].pixels[at]);
          open += static_cast<double>(reference[n].pixels[at]) * static_cast<double>(reference[n].pixels[at]);
        }
      }
      // The stone's own path loses nothing, the tissue it replaces does: a few decibels come back.
      const double chord_cm = miss < radius ? 0.2 * std::sqrt(radius * radius - miss * miss) : 0.0;
      const double drop_db = 10.0 * std::log10(open / shadowed) + probe.carrier_hz * 1e-6 * chord_cm;
      const double blurred = 2.5 * grid.lineSpacing_mm(along) + 0.7;
      if (miss < radius - blurred) {
        EXPECT_NEAR(drop_db, 30.0, 2.0) << name << " line " << l << " through the stone, " << miss << " mm off its middle";
        ++inShadow;
      } else if (miss > radius + blurred) {
        EXPECT_NEAR(drop_db, 0.0, 1.0) << name << " line " << l << " beside the stone, " << miss << " mm off its middle";
      }
    }
    EXPECT_GT(inShadow, 10);
  }
}

TEST(Losses, TheSideOfAShadowIsAsSoftAsTheApertureIsWide) {
  // A thing without end to the left, 18 mm deep: of the aperture a place behind its edge sees what rays reach it.
  const std::string half = R"({"name": "half", "tissue": "bone", "shape": {"intersection": [
    {"half_space": {"point_mm": [0, 0, 0], "outward": [1, 0, 0]}}, {"half_space": {"point_mm": [0, 20, 0], "outward": [0, -1, 0]}},
    {"half_space": {"point_mm": [0, 24, 0], "outward": [0, 1, 0]}}]}})";
  const std::string bone = R"({"name": "bone", "echo_level": 150, "speckle": 1, "reflection_db": 30})";
  const FormationOptions options = plain(60.0);
  const Probe probe = shippedProbe("linear-7.5");
  const auto scanner = scannerOf(blockOfTissue(half, bone), probe, options), without = scannerOf(blockOfTissue(), probe, options);
  const auto frames = framesOf(*scanner, 6, 6.0), reference = framesOf(*without, 6, 6.0);
  constexpr double kRadius = 1.0;
  for (const double depth : {28.0, 36.0, 50.0})
    for (const double x : {-9.0, -5.0, -2.5, 0.0, 2.5, 5.0, 9.0}) {
      const double halfAperture = 0.5 * std::min(probe.aperture_mm, 0.5 * depth), reach = 1.0 - 18.0 / depth;
      double power = 0.0, weight = 0.0;
      for (double aside = -kRadius; aside <= kRadius; aside += 0.1) {
        const double hidden = std::clamp((-(x + aside) / reach + halfAperture) / (2.0 * halfAperture), 0.0, 1.0);
        const double chord = std::sqrt(std::max(kRadius * kRadius - aside * aside, 0.0));
        power += chord * std::pow(1.0 - hidden * (1.0 - std::pow(10.0, -30.0 / 40.0)), 4.0);
        weight += chord;
      }
      const glm::dvec2 at(x, depth);
      EXPECT_NEAR(powerNear_db(*scanner, frames, at, kRadius) - powerNear_db(*without, reference, at, kRadius),
                  10.0 * std::log10(power / weight), 1.5)
          << x << " mm beside the edge, " << depth << " mm deep";
    }
}

TEST(Losses, NoiseHasItsLevelBeforeDepthGainAndChangesWithTheFrameAlone) {
  const auto patient = blockOfTissue(
      R"({"name": "all", "tissue": "water", "shape": {"ellipsoid": {"centre_mm": [0, 100, 0], "radii_mm": [900, 200, 900]}}})");
  FormationOptions options = plain(40.0);
  options.noise_db = -50.0;
  options.tgc = {{0.0, 0.0}, {40.0, 20.0}};
  const auto scanner = scannerOf(patient, shippedProbe("linear-7.5"), options);
  const Image<float> frame = envelopeOf(*scanner);
  EXPECT_NEAR(meanPower_db(band(*scanner, frame, 19.0, 21.0)), -40.0, 0.5);
  EXPECT_NEAR(meanPower_db(band(*scanner, frame, 37.0, 39.0)), -31.0, 0.5);
  EXPECT_TRUE(frame == envelopeOf(*scanner));
  EXPECT_FALSE(frame == envelopeOf(*scanner, held(), 1));
}

}  // namespace
}  // namespace ew::testing::formation_losses_test
