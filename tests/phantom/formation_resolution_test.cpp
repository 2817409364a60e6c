// The point spread function: of single points, of speckle over depth, and between views.
#include <algorithm>
#include <functional>
#include <numbers>

#include "formation.h"

namespace ew::testing::formation_resolution_test {
namespace {

double at(const Image<float>& image, int line, int sample) {
  return static_cast<double>(
      image.pixels[static_cast<std::size_t>(sample) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(line)]);
}

/// Correlation of intensities of two lists of amplitudes.
double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  double sa = 0, sb = 0, saa = 0, sbb = 0, sab = 0;
  for (std::size_t n = 0; n < a.size(); ++n) {
    const double x = a[n] * a[n], y = b[n] * b[n];
    sa += x, sb += y, saa += x * x, sbb += y * y, sab += x * y;
  }
  const double count = static_cast<double>(a.size());
  return (sab / count - sa * sb / count / count) /
         std::sqrt((saa / count - sa * sa / count / count) * (sbb / count - sb * sb / count / count));
}

/// Full width at half maximum of a Gaussian autocovariance that has fallen to `correlated` at `lag_mm`. The intensity's autocovariance is
/// the square of the field's, which is the autocorrelation of the point spread function: a Gaussian of the same width as that function's
/// amplitude (Wagner et al. 1983).
double widthFrom(double correlated, double lag_mm) { return lag_mm * std::sqrt(std::log(2.0) * 4.0 / -std::log(correlated)); }

struct Setting {
  const char* probe;
  double depth_mm;
};
void PrintTo(const Setting& setting, std::ostream* out) { *out << setting.probe; }
class SpeckleSize : public ::testing::TestWithParam<Setting> {};

TEST_P(SpeckleSize, FollowsPulseAndBeamOverDepthWithinATenth) {
  const Setting setting = GetParam();
  const auto scanner = scannerOf(blockOfTissue(), shippedProbe(setting.probe), onlySpeckle(setting.depth_mm));
  constexpr int kBands = 4, kFrames = 4, kAxialLag = 3;
  std::vector<Image<float>> frames;
  for (int n = 0; n < kFrames; ++n) frames.push_back(envelopeOf(*scanner, held(12.0 * (n - 1.5))));
  for (int b = 0; b < kBands; ++b) {
    const int from = static_cast<int>((0.15 + 0.2 * b) * scanner->grid().samples), to = from + scanner->grid().samples / 12;
    std::vector<double> here, deeper, beside;
    for (const Image<float>& frame : frames) {
      for (int s = from; s < to; ++s) {
        for (int l = 4; l + 5 < frame.width; ++l) {
          here.push_back(at(frame, l, s));
          deeper.push_back(at(frame, l, s + kAxialLag));
          beside.push_back(at(frame, l + 1, s));
        }
      }
    }
    const double depth = scanner->grid().depth_mm(0.5 * (from + to));
    const PointSpread model = scanner->pointSpreadAt(depth);
    const double axial = widthFrom(correlation(here, deeper), kAxialLag * scanner->grid().sampleSpacing_mm);
    const double lateral = widthFrom(correlation(here, beside), scanner->grid().lineSpacing_mm(depth));
    RecordProperty("at " + std::to_string(depth), "axial " + std::to_string(axial / model.axial_mm) + " lateral " +
                                                      std::to_string(lateral / model.lateral_mm) + " of the model");
    EXPECT_NEAR(axial, model.axial_mm, 0.1 * model.axial_mm) << "at " << depth << " mm";
    EXPECT_NEAR(lateral, model.lateral_mm, 0.1 * model.lateral_mm) << "at " << depth << " mm";
  }
}
INSTANTIATE_TEST_SUITE_P(OfProbes, SpeckleSize,
                         ::testing::Values(Setting{"linear-7.5", 40.0}, Setting{"convex-3.5", 120.0}, Setting{"phased-2.5", 120.0}));

/// Points so far from one another that each is seen alone.
std::shared_ptr<const Patient> dust() {
  return blockOfTissue(
      R"({"name": "dust", "tissue": "dust", "shape": {"ellipsoid": {"centre_mm": [0, 60, 0], "radii_mm": [50, 57, 3]}}},
         {"name": "rest", "tissue": "water", "shape": {"ellipsoid": {"centre_mm": [0, 100, 0], "radii_mm": [900, 200, 900]}}})",
      R"({"name": "dust", "echo_level": 150, "speckle": 1, "scatterers_per_mm3": 0.01, "attenuation_db_per_cm_mhz": 0})");
}

/// Width of a bump about its greatest value, between the places where it falls to half of it; 0 when it does not.
double halfWidth(const std::function<double(double)>& value, double peak, double step) {
  const double top = value(peak);
  const auto fall = [&](double direction) {
    for (double t = step;; t += step) {
      const double here = value(peak + direction * t);
      if (here < 0.0) return -1e9;
      if (here <= 0.5 * top) {
        const double before = value(peak + direction * (t - step));
        return t - step * (0.5 * top - here) / (before - here);
      }
    }
  };
  return std::max(0.0, fall(-1.0) + fall(1.0));
}

TEST(PointTarget, IsAsWideAsTheBeamsInAllThreeDirections) {
  Probe probe = shippedProbe("linear-7.5");
  probe.lines = 384;
  const auto scanner = scannerOf(dust(), probe, onlySpeckle(40.0));
  constexpr int kSteps = 61;
  constexpr double kStep_mm = 0.15;
  std::vector<Image<float>> frames;
  for (int n = 0; n < kSteps; ++n) frames.push_back(envelopeOf(*scanner, held(kStep_mm * (n - kSteps / 2))));
  const BeamGrid& grid = scanner->grid();
  const Image<float>& first = frames.front();
  // The greatest value over elevation, and where: points are the local maxima of it that stand alone.
  std::vector<int> best(first.pixels.size());
  for (std::size_t n = 0; n < best.size(); ++n)
    for (int f = 1; f < kSteps; ++f)
      if (frames[static_cast<std::size_t>(f)].pixels[n] > frames[static_cast<std::size_t>(best[n])].pixels[n]) best[n] = f;
  const auto brightest = [&](int l, int s) {
    return at(frames[static_cast<std::size_t>(best[static_cast<std::size_t>(s * first.width + l)])], l, s);
  };
  int measured = 0;
  double axialSum = 0.0, lateralSum = 0.0, elevationalSum = 0.0;
  const double lineSpacing = grid.lineSpacing_mm(10.0);
  for (int s = 150; s + 60 < grid.samples; ++s) {
    for (int l = 24; l + 24 < first.width; ++l) {
      const double peak = brightest(l, s);
      if (peak < 1e-4) continue;
      bool alone = true;
      for (int ds = -30; ds <= 30 && alone; ++ds)
        for (int dl = -20; dl <= 20 && alone; ++dl) {
          const double other = brightest(l + dl, s + ds);
          const double a = ds * grid.sampleSpacing_mm / 0.6, b = dl * lineSpacing / 1.2;
          alone = other <= peak && (a * a + b * b < 1.0 || other < 0.05 * peak);
        }
      const int f = best[static_cast<std::size_t>(s * first.width + l)];
      if (!alone || f < 12 || f + 12 >= kSteps) continue;
      const auto along = [&](double sample) {
        const int k = static_cast<int>(sample);
        return at(frames[static_cast<std::size_t>(f)], l, k) * (1.0 - sample + k) +
               at(frames[static_cast<std::size_t>(f)], l, k + 1) * (sample - k);
      };
      const auto across = [&](double line) {
        const int k = static_cast<int>(line);
        return at(frames[static_cast<std::size_t>(f)], k, s) * (1.0 - line + k) +
               at(frames[static_cast<std::size_t>(f)], k + 1, s) * (line - k);
      };
      const auto through = [&](double frame) {
        const int k = static_cast<int>(frame);
        if (k < 0 || k + 1 >= kSteps) return -1.0;
        double top[2] = {0.0, 0.0};  // the lens' wavefront is curved: the echo shifts a little in depth
        for (int side = 0; side < 2; ++side)
          for (int ds = -6; ds <= 6; ++ds) top[side] = std::max(top[side], at(frames[static_cast<std::size_t>(k + side)], l, s + ds));
        return top[0] * (1.0 - frame + k) + top[1] * (frame - k);
      };
      const PointSpread model = scanner->pointSpreadAt(grid.depth_mm(s));
      const double elevational = halfWidth(through, f, 0.25);
      if (elevational == 0.0) continue;
      axialSum += halfWidth(along, s, 0.25) * grid.sampleSpacing_mm / model.axial_mm;
      lateralSum += halfWidth(across, l, 0.25) * lineSpacing / model.lateral_mm;
      elevationalSum += elevational * kStep_mm / model.elevational_mm;
      ++measured;
    }
  }
  ASSERT_GE(measured, 8);
  RecordProperty("of the model", std::to_string(axialSum / measured) + " " + std::to_string(lateralSum / measured) + " " +
                                     std::to_string(elevationalSum / measured) + " of " + std::to_string(measured));
  EXPECT_NEAR(axialSum / measured, 1.0, 0.05);
  EXPECT_NEAR(lateralSum / measured, 1.0, 0.05);
  EXPECT_NEAR(elevationalSum / measured, 1.0, 0.05);
}

TEST(Views, OfTheSameScatterersDecorrelateWithAngleAsTheBeamsDo) {
  Probe probe = shippedProbe("linear-7.5");
  probe.lines = 768;  // so close that interpolating between them loses nothing
  FormationOptions options = onlySpeckle(22.0);
  options.focus_mm = 15.0;
  const auto scanner = scannerOf(blockOfTissue(), probe, options);
  const double pivot_mm = 15.0, wave = 4.0 * std::numbers::pi * probe.carrier_hz / (1540.0 * 1e3);
  const auto turned = [&](double angle, double elevation_mm) {
    Transform<frame::World, frame::Probe> pose = held(elevation_mm, 0.0, {0, 20, 0});
    pose.matrix = glm::translate(pose.matrix, {0, pivot_mm, 0});
    pose.matrix = glm::rotate(pose.matrix, angle, glm::dvec3(0, 0, 1));
    pose.matrix = glm::translate(pose.matrix, {0, -pivot_mm, 0});
    return pose;
  };
  constexpr int kPlanes = 6;
  std::vector<Image<float>> straight;
  for (int plane = 0; plane < kPlanes; ++plane) straight.push_back(envelopeOf(*scanner, turned(0.0, 6.0 * plane - 15.0)));
  const BeamGrid& grid = scanner->grid();
  double lastMeasured = 2.0;
  for (const double angle_deg : {1.0, 3.0, 5.0, 8.0, 14.0}) {
    const double angle = angle_deg * std::numbers::pi / 180.0;
    std::vector<double> a, b;
    for (int plane = 0; plane < kPlanes; ++plane) {
      const double elevation_mm = 6.0 * plane - 15.0;
      const Image<float> other = envelopeOf(*scanner, turned(angle, elevation_mm));
      const auto back = inverse(turned(angle, elevation_mm)) * turned(0.0, elevation_mm);
      for (int s = 0; s < grid.samples; s += 2) {
        if (std::abs(grid.depth_mm(s) - pivot_mm) > 2.0) continue;
        for (int l = 128; l < 640; l += 4) {
          const BeamGrid::Line& line = grid.lines[static_cast<std::size_t>(l)];
          const glm::dvec2 p = line.origin_mm + grid.depth_mm(s) * line.direction;
          const glm::dvec3 q = (back * Point<frame::Probe>{{p, 0.0}}).at;
          const glm::dvec2 place = lineAndSampleAt(probe, Knobs{}, grid, {q.x, q.y});
          const int l0 = static_cast<int>(place.x), s0 = static_cast<int>(place.y);
          const double u = place.x - l0, v = place.y - s0;
          a.push_back(at(straight[static_cast<std::size_t>(plane)], l, s));
          const auto cubic = [&](int l1) {  // Catmull-Rom along the line: straight lines between samples would cost correlation
            const double p0 = at(other, l1, s0 - 1), p1 = at(other, l1, s0), p2 = at(other, l1, s0 + 1), p3 = at(other, l1, s0 + 2);
            return p1 + 0.5 * v * (p2 - p0 + v * (2 * p0 - 5 * p1 + 4 * p2 - p3 + v * (3 * (p1 - p2) + p3 - p0)));
          };
          b.push_back((1 - u) * cubic(l0) + u * cubic(l0 + 1));
        }
      }
    }
    // The spectrum of the point spread function turns about the origin: it moves sideways by 2 k sin(angle) and its overlap with itself
    // is that of two Gaussians; of intensities the square.
    const double sigma = scanner->pointSpreadAt(pivot_mm).lateral_mm / 2.3548, shift = wave * std::sin(angle) * sigma;
    const double model = std::exp(-0.5 * shift * shift), found = correlation(a, b);
    RecordProperty("turned by " + std::to_string(angle_deg), std::to_string(found) + " model " + std::to_string(model));
    EXPECT_NEAR(found, model, angle_deg < 10.0 ? 0.04 : 0.1) << angle_deg << " degrees";
    EXPECT_LT(found, lastMeasured + 0.03);
    lastMeasured = found;
  }
}

TEST(Views, ShiftedAlongElevationDecorrelateAsTheLensDoes) {
  const auto scanner = scannerOf(blockOfTissue(), shippedProbe("linear-7.5"), onlySpeckle(40.0));
  const BeamGrid& grid = scanner->grid();
  const double wave = 4.0 * std::numbers::pi * 7.5e6 / (1540.0 * 1e3);
  for (const double depth : {12.0, 30.0}) {
    // The lens of the probe's data: width 4 mm at the face and 1.6 mm at 30 mm; its wavefront's curvature belongs to that widening.
    const double sigma = scanner->pointSpreadAt(depth).elevational_mm / 2.3548;
    const double range = 30.0 / std::sqrt(2.5 * 2.5 - 1.0), off = depth - 30.0, curvature = 0.5 * off / (off * off + range * range);
    for (const double shift : {0.3, 0.6, 1.2}) {
      std::vector<double> a, b;
      for (int n = 0; n < 3; ++n) {
        const Image<float> here = envelopeOf(*scanner, held(9.0 * n)), there = envelopeOf(*scanner, held(9.0 * n + shift));
        for (int s = 0; s < grid.samples; ++s) {
          if (std::abs(grid.depth_mm(s) - depth) > 1.5) continue;
          for (int l = 4; l + 4 < here.width; ++l) a.push_back(at(here, l, s)), b.push_back(at(there, l, s));
        }
      }
      const double phaseCurvature = wave * curvature * sigma;
      const double model = std::exp(-2.0 * shift * shift * (0.25 / (sigma * sigma) + phaseCurvature * phaseCurvature)),
                   found = correlation(a, b);
      RecordProperty("at " + std::to_string(depth) + " shifted by " + std::to_string(shift),
                     std::to_string(found) + " model " + std::to_string(model));
      EXPECT_NEAR(found, model, 0.08) << "depth " << depth << " mm, shift " << shift << " mm";
    }
  }
}

}  // namespace
}  // namespace ew::testing::formation_resolution_test
