// Surfaces between tissues, moving tissue, speeds of sound, and options that cannot be used.
#include <algorithm>

#include "formation.h"

namespace ew::testing::formation_surfaces_test {
namespace {

FormationOptions surfacesAlone(double depth_mm) {
  FormationOptions options;
  options.depth_mm = depth_mm;
  options.attenuation = false;
  options.noise_db = -300.0;
  return options;
}

/// Water with a sheet: a plane at y = 20 whose normal leans by `lean` in x; below it water again.
std::shared_ptr<const Patient> plane(double lean_rad, const std::string& border) {
  const std::string normal = "[" + std::to_string(std::sin(lean_rad)) + ", " + std::to_string(-std::cos(lean_rad)) + ", 0]";
  return blockOfTissue(
      R"({"name": "below", "tissue": "water", "shape": {"half_space": {"point_mm": [0, 20, 0], "outward": )" + normal + "}}" + border +
      R"(}, {"name": "above", "tissue": "water", "shape": {"ellipsoid": {"centre_mm": [0, 100, 0], "radii_mm": [900, 200, 900]}}})");
}

struct Peak {
  double depth_mm = 0.0;
  double amplitude = 0.0;
};
Peak peakOf(const VirtualScanner& scanner, const Image<float>& frame, int line, double from_mm = 5.0) {
  Peak peak;
  for (int s = 0; s < frame.height; ++s) {
    const auto value = static_cast<double>(
        frame.pixels[static_cast<std::size_t>(s) * static_cast<std::size_t>(frame.width) + static_cast<std::size_t>(line)]);
    if (scanner.grid().depth_mm(s) > from_mm && value > peak.amplitude) peak = {scanner.grid().depth_mm(s), value};
  }
  return peak;
}
double middlePower_db(const VirtualScanner& scanner, const Image<float>& frame) {
  std::vector<double> peaks;
  for (int l = frame.width / 4; l < 3 * frame.width / 4; ++l) peaks.push_back(peakOf(scanner, frame, l).amplitude);
  return meanPower_db(peaks);
}

constexpr const char* kGlint = R"(, "border": {"echo_level": 191.25, "width_mm": 0.05})";  // -15 dB

TEST(Surfaces, SquareToTheBeamReturnTheirLevelAtTheirDepthAndFadeWithTheAngle) {
  for (const char* name : {"linear-7.5", "convex-3.5"}) {
    double last_db = 100.0;
    for (const double lean_deg : {0.0, 10.0, 25.0, 50.0}) {
      const double lean = lean_deg * 3.14159265358979 / 180.0;
      Probe probe = shippedProbe(name);
      if (probe.kind == ProbeKind::convex) probe.radius_mm = 600.0, probe.halfAngle_rad = 0.03;  // nearly parallel lines
      const auto scanner = scannerOf(plane(lean, kGlint), probe, surfacesAlone(60.0));
      const Image<float> frame = envelopeOf(*scanner);
      const double power_db = middlePower_db(*scanner, frame);
      RecordProperty(std::string(name) + " leaning " + std::to_string(lean_deg), std::to_string(power_db));
      if (lean_deg == 0.0) {
        EXPECT_NEAR(power_db, -15.0, 1.5) << name;
        for (int l = 10; l + 10 < frame.width; ++l) EXPECT_NEAR(peakOf(*scanner, frame, l).depth_mm, 18.0, 0.3) << name << " line " << l;
      }
      EXPECT_LT(power_db, last_db - (lean_deg > 0.0 ? 2.0 : 0.0)) << name << " leaning by " << lean_deg;
      last_db = power_db;
    }
    EXPECT_LT(last_db, -15.0 - 20.0) << name;
  }
}

TEST(Surfaces, WithoutABorderReturnWhatTheStepOfImpedanceSays) {
  const auto layered = [](double impedance) {
    return blockOfTissue(
        R"({"name": "below", "tissue": "other", "shape": {"half_space": {"point_mm": [0, 20, 0], "outward": [0, -1, 0]}}},
           {"name": "above", "tissue": "water", "shape": {"ellipsoid": {"centre_mm": [0, 100, 0], "radii_mm": [900, 200, 900]}}})",
        R"({"name": "other", "echo_level": 0, "speckle": 0, "impedance_mrayl": )" + std::to_string(impedance) + "}");
  };
  const Probe probe = shippedProbe("linear-7.5");
  const auto power_db = [&](double impedance) {
    const auto scanner = scannerOf(layered(impedance), probe, surfacesAlone(40.0));
    return middlePower_db(*scanner, envelopeOf(*scanner));
  };
  // Reflection coefficients 0.1 and 0.2 from 1.63 MRayl: 6 dB apart.
  const double weak = power_db(1.63 * 1.1 / 0.9), strong = power_db(1.63 * 1.2 / 0.8);
  EXPECT_NEAR(strong - weak, 6.02, 0.1);
  EXPECT_LT(power_db(1.63), -90.0);
}

TEST(Surfaces, ThatAreSeenFromTheFrontAloneAreDarkFromBehind) {
  const auto scanner = scannerOf(blockOfTissue(
                                     R"({"name": "sheet", "tissue": "water", "shape": {"intersection": [
             {"half_space": {"point_mm": [0, 15, 0], "outward": [0, -1, 0]}}, {"half_space": {"point_mm": [0, 25, 0], "outward": [0, 1, 0]}}]},
             "border": {"echo_level": 200, "width_mm": 0.05, "shine": "front"}},
             {"name": "rest", "tissue": "water", "shape": {"ellipsoid": {"centre_mm": [0, 100, 0], "radii_mm": [900, 200, 900]}}})"),
                                 shippedProbe("linear-7.5"), surfacesAlone(40.0));
  const Image<float> frame = envelopeOf(*scanner);
  EXPECT_GT(peakOf(*scanner, frame, 96, 5.0).amplitude, 0.1);
  EXPECT_LT(peakOf(*scanner, frame, 96, 18.0).amplitude, 3e-3);
}

TEST(Surfaces, OfAThinLayerAreNeitherLostNorDoubled) {
  // 0.3 mm: less than the pitch of the scatterers. Both of its faces fall into one pulse.
  const auto sheet = [](double thickness) {
    return blockOfTissue(
        R"({"name": "sheet", "tissue": "water", "shape": {"intersection": [
             {"half_space": {"point_mm": [0, 20, 0], "outward": [0, -1, 0]}}, {"half_space": {"point_mm": [0, )" +
        std::to_string(20.0 + thickness) +
        R"(, 0], "outward": [0, 1, 0]}}]}, "border": {"echo_level": 191.25, "width_mm": 0.05, "shine": "front"}},
           {"name": "rest", "tissue": "water", "shape": {"ellipsoid": {"centre_mm": [0, 100, 0], "radii_mm": [900, 200, 900]}}})");
  };
  const auto scanner = scannerOf(sheet(0.3), shippedProbe("convex-3.5"), surfacesAlone(60.0));
  const Image<float> frame = envelopeOf(*scanner);
  std::vector<double> square;  // to the beam
  for (int l = 70; l < 122; ++l) {
    const BeamGrid::Line& line = scanner->grid().lines[static_cast<std::size_t>(l)];
    const Peak peak = peakOf(*scanner, frame, l);
    EXPECT_NEAR(peak.depth_mm, (18.0 - line.origin_mm.y) / line.direction.y, 0.5) << l;
    EXPECT_GT(20.0 * std::log10(peak.amplitude), -45.0) << l;
    if (std::abs(line.direction.x) < 0.03) square.push_back(peak.amplitude);
  }
  EXPECT_NEAR(meanPower_db(square), -15.0, 2.0);
}

TEST(Surfaces, DrawnByTwoOrgansAreOneSurface) {
  // The second organ begins where the first ends, as fat below skin.
  const auto layers = [](const std::string& secondBorder) {
    return blockOfTissue(
        R"({"name": "upper", "tissue": "water", "shape": {"half_space": {"point_mm": [0, 20, 0], "outward": [0, 1, 0]}}, "border": {"echo_level": 191.25, "width_mm": 0.05}},
           {"name": "lower", "tissue": "water", "shape": {"half_space": {"point_mm": [0, 20, 0], "outward": [0, -1, 0]}})" +
        secondBorder + "}");
  };
  const Probe probe = shippedProbe("linear-7.5");
  const auto once = scannerOf(layers(""), probe, surfacesAlone(40.0)), twice = scannerOf(layers(kGlint), probe, surfacesAlone(40.0));
  EXPECT_NEAR(middlePower_db(*once, envelopeOf(*once)), middlePower_db(*twice, envelopeOf(*twice)), 0.1);
}

class Shifted final : public Deformation {
 public:
  explicit Shifted(const glm::dvec3& by_mm) : by_(by_mm) {}
  glm::dvec3 moved(const glm::dvec3& rest_mm) const override { return rest_mm + by_; }
  glm::dvec3 rest(const glm::dvec3& moved_mm) const override { return moved_mm - by_; }
  double reach_mm() const override { return glm::length(by_); }

 private:
  glm::dvec3 by_;
};

TEST(Motion, OfTheBodyIsTheOppositeMotionOfTheProbe) {
  const auto patient = blockOfTissue(
      R"({"name": "vessel", "tissue": "water", "shape": {"ellipsoid": {"centre_mm": [0, 14, 0], "radii_mm": [4, 4, 9]}}, "border": {"echo_level": 200, "width_mm": 1}},
         {"name": "stone", "tissue": "stone", "shape": {"ellipsoid": {"centre_mm": [8, 14, 0], "radii_mm": [3, 3, 3]}}})");
  FormationOptions options;
  options.depth_mm = 30.0;
  options.noise_db = -300.0;
  const auto scanner = scannerOf(patient, shippedProbe("linear-7.5"), options);
  const glm::dvec3 by(0.7, -1.3, 2.1);
  const Image<float> body = envelopeOf(*scanner, held(), 0, Shifted(by)),
                     probe = envelopeOf(*scanner, held(0.0, 0.0, glm::dvec3(0, 2, 0) - by));
  double difference = 0.0, size = 0.0;
  for (std::size_t n = 0; n < body.pixels.size(); ++n) {
    const double a = static_cast<double>(body.pixels[n]), b = static_cast<double>(probe.pixels[n]);
    difference += (a - b) * (a - b), size += b * b;
  }
  EXPECT_LT(std::sqrt(difference / size), 0.02);  // points round to another cell of the fine grid here and there
}

TEST(Motion, SpeedsOfSoundMoveEchoesByTheTimeTheyTake) {
  const auto patient = blockOfTissue(
      R"({"name": "below", "tissue": "slow", "shape": {"half_space": {"point_mm": [0, 22, 0], "outward": [0, -1, 0]}}, "border": {"echo_level": 200, "width_mm": 0.05}},
         {"name": "above", "tissue": "slow", "shape": {"ellipsoid": {"centre_mm": [0, 100, 0], "radii_mm": [900, 200, 900]}}})",
      R"({"name": "slow", "echo_level": 0, "speckle": 0, "speed_m_per_s": 1450})");
  FormationOptions options = surfacesAlone(40.0);
  const auto right = scannerOf(patient, shippedProbe("linear-7.5"), options);
  EXPECT_NEAR(peakOf(*right, envelopeOf(*right), 96).depth_mm, 20.0, 0.1);
  options.speedOfSound = true;
  const auto displaced = scannerOf(patient, shippedProbe("linear-7.5"), options);
  EXPECT_NEAR(peakOf(*displaced, envelopeOf(*displaced), 96).depth_mm, 20.0 * 1540.0 / 1450.0, 0.1);
}

TEST(VirtualScanner, RefusesOptionsThatCannotBeUsedAndNamesThem) {
  const auto patient = blockOfTissue();
  const Probe probe = shippedProbe("linear-7.5");
  const auto refused = [&](auto change) {
    FormationOptions options;
    change(options);
    const auto made = makeVirtualScanner(patient, probe, options);
    if (made) return std::string();
    EXPECT_EQ(made.error().code, ErrorCode::badField);
    return made.error().context.at(0).second;
  };
  EXPECT_EQ(refused([](FormationOptions& o) { o.depth_mm = 500.0; }), "depth_mm");
  EXPECT_EQ(refused([](FormationOptions& o) { o.depth_mm = std::nan(""); }), "depth_mm");
  EXPECT_EQ(refused([](FormationOptions& o) { o.pulseCycles = 0.0; }), "pulseCycles");
  EXPECT_EQ(refused([](FormationOptions& o) { o.noise_db = std::nan(""); }), "noise_db");
  EXPECT_EQ(refused([](FormationOptions& o) { o.dynamicRange_db = 0.0; }), "dynamicRange_db");
  EXPECT_EQ(refused([](FormationOptions& o) { o.tgc = {{10.0, 0.0}, {5.0, 1.0}}; }), "tgc.depth_mm");
  EXPECT_EQ(refused([](FormationOptions&) {}), "");
}

TEST(CompressEnvelope, TakesFullWhiteTo255AndTheDynamicRangeTo0) {
  Image<float> envelope(5, 1);
  envelope.pixels = {1.0F, 10.0F, 0.001F, 0.0F, 0.0316227766F};
  Image<std::uint8_t> levels;
  compressEnvelope(envelope, 60.0, levels);
  EXPECT_EQ(levels.pixels, (std::vector<std::uint8_t>{255, 255, 0, 0, 128}));
}

}  // namespace
}  // namespace ew::testing::formation_surfaces_test
