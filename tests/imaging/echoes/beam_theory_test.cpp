#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdio>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "ew/imaging/frame.h"
#include "imaging/support/live_echoes_support.h"

/// Live echoes of tissue of known levels against what the physics of a beam says, written out once more here. The tables are printed.
namespace ew::beam_theory_test {
namespace {

using namespace testing::live;

constexpr double kSpeedOfSound_mmPerUs = 1.54;
constexpr double kRange_db = 120.0;  // of the levels: nothing is clamped
constexpr double kTissueLevel = 150.0;

double wavelength_mm(double carrier_hz) { return kSpeedOfSound_mmPerUs / (1e-6 * carrier_hz); }

/// Scatterers alone, on lines close enough for the narrowest beam.
Shot rawShot() {
  Shot shot;
  shot.probe.lines = 400;
  shot.knobs.depth_mm = 165.0;
  shot.scene.recordedDynamicRange_db = kRange_db;
  return shot;
}

/// Echoes on the lines of one frame, as power.
struct Lines {
  BeamGrid grid;
  std::vector<double> power;  ///< (lines x samples), a row for each sample
  [[nodiscard]] double at(int line, int sample) const {
    return power[static_cast<std::size_t>(sample) * grid.lines.size() + static_cast<std::size_t>(line)];
  }
  [[nodiscard]] int count() const { return static_cast<int>(grid.lines.size()); }
  [[nodiscard]] int sampleAt(double depth_mm) const { return static_cast<int>(std::lround(depth_mm / grid.sampleSpacing_mm)); }
};

Lines linesOf(const TissueMaps& maps, const Shot& shot, const glm::dmat4& probeToWorld = glm::dmat4(1.0)) {
  FrameMaker maker(shot.threads);
  maker.configure(shot.probe, shot.knobs, shot.scene, maps.grid, 64, 64, {.labels = shot.labels != nullptr, .tissue = true});
  FrameInput input = inputOf(maps);
  if (shot.labels != nullptr) input.labels = shot.labels->view();
  input.pose.probeToWorld.matrix = probeToWorld;
  [[maybe_unused]] const DisplayImage image = maker.make(input);
  Lines made{maker.beamGrid(), {}};
  for (const float level : maker.beamLevels().pixels)
    made.power.push_back(std::pow(10.0, kRange_db / 2550.0 * (static_cast<double>(level) - 255.0)));
  return made;
}

glm::dmat4 slidAcross(double z_mm) { return glm::translate(glm::dmat4(1.0), {0.0, 0.0, z_mm}); }

/// Places beside each other across the slice: other scatterers.
constexpr std::array<double, 4> kPlaces_mm{-10.5, -3.5, 3.5, 10.5};

std::vector<Lines> viewsOf(const TissueMaps& maps, const Shot& shot) {
  std::vector<Lines> views;
  for (const double z_mm : kPlaces_mm) views.push_back(linesOf(maps, shot, slidAcross(z_mm)));
  return views;
}

/// Where a falling row of correlations by lag, 1 first, passes one half.
double halfWayOf(const std::vector<double>& correlations) {
  for (std::size_t n = 1; n < correlations.size(); ++n)
    if (correlations[n] < 0.5) return static_cast<double>(n) - (0.5 - correlations[n]) / (correlations[n - 1] - correlations[n]);
  return 0.0;
}

/// Full width at half maximum of the autocovariance of intensity about a depth: (across the beam, along it), mm.
glm::dvec2 grainWidths_mm(const std::vector<Lines>& views, double depth_mm, double half_mm = 7.0) {
  constexpr int kLags = 60;
  std::vector<double> across(kLags), along(kLags);
  for (const Lines& view : views) {
    const int first = view.sampleAt(depth_mm - half_mm), last = view.sampleAt(depth_mm + half_mm);
    double mean = 0.0;
    for (int s = first; s < last; ++s)
      for (int l = 0; l < view.count(); ++l) mean += view.at(l, s);
    mean /= static_cast<double>((last - first) * view.count());
    for (int lag = 0; lag < kLags; ++lag) {
      double ofLines = 0.0, ofSamples = 0.0;
      for (int s = first; s < last; ++s) {
        for (int l = 0; l + lag < view.count(); ++l) ofLines += (view.at(l, s) / mean - 1.0) * (view.at(l + lag, s) / mean - 1.0);
        if (s + lag < last)
          for (int l = 0; l < view.count(); ++l) ofSamples += (view.at(l, s) / mean - 1.0) * (view.at(l, s + lag) / mean - 1.0);
      }
      across[static_cast<std::size_t>(lag)] += ofLines / ((last - first) * (view.count() - lag));
      along[static_cast<std::size_t>(lag)] += last - first > lag ? ofSamples / ((last - first - lag) * view.count()) : 0.0;
    }
  }
  for (std::vector<double>* covariances : {&across, &along}) {
    const double variance = covariances->front();
    for (double& each : *covariances) each /= variance;
  }
  const BeamGrid& grid = views.front().grid;
  return {2.0 * halfWayOf(across) * grid.lineSpacing_mm(depth_mm), 2.0 * halfWayOf(along) * grid.sampleSpacing_mm};
}

/// The same width across the beam by delay and sum: elements on the curved face, one wave, F-number 2 at least both ways, the focus of
/// reception follows the depth. Speckle of a point spread has the squared magnitude of its autocorrelation as autocovariance.
double theoreticalWidth_mm(double carrier_hz, double focus_mm, double depth_mm, bool isApodised) {
  constexpr int kElements = 81;
  constexpr double kFNumber = 2.0, kStep_mm = 0.05, kReach_mm = 24.0;
  const Probe probe = convex();
  const double widest_mm = LiveEchoesEffect{}.apertureShare * probe.aperture_mm, wave = 2.0 * std::numbers::pi / wavelength_mm(carrier_hz);
  const auto placeAt = [&](double radius_mm, double arc_mm) {
    const double angle = arc_mm / radius_mm;
    return glm::dvec2(radius_mm * std::sin(angle), radius_mm * std::cos(angle));
  };
  const auto fieldAt = [&](double aperture_mm, double towards_mm, double arc_mm) {
    const glm::dvec2 focus = placeAt(probe.radius_mm + towards_mm, 0.0), at = placeAt(probe.radius_mm + depth_mm, arc_mm);
    std::complex<double> sum = 0.0;
    for (int n = 0; n < kElements; ++n) {
      const double share = (n + 0.5) / kElements - 0.5;
      const glm::dvec2 element = placeAt(probe.radius_mm, share * aperture_mm);
      const double weight = isApodised ? 0.5 + 0.5 * std::cos(2.0 * std::numbers::pi * share) : 1.0;
      sum += weight * std::polar(1.0, wave * (glm::distance(element, at) - glm::distance(element, focus)));
    }
    return sum;
  };
  std::vector<std::complex<double>> spread;
  for (double arc_mm = -kReach_mm; arc_mm <= kReach_mm; arc_mm += kStep_mm)
    spread.push_back(fieldAt(std::min(widest_mm, focus_mm / kFNumber), focus_mm, arc_mm) *
                     fieldAt(std::min(widest_mm, depth_mm / kFNumber), depth_mm, arc_mm));
  std::vector<double> covariance;
  for (std::size_t lag = 0; lag < 300; ++lag) {
    std::complex<double> sum = 0.0;
    for (std::size_t n = 0; n + lag < spread.size(); ++n) sum += std::conj(spread[n]) * spread[n + lag];
    covariance.push_back(std::norm(sum));
  }
  const double most = covariance.front();
  for (double& each : covariance) each /= most;
  return 2.0 * kStep_mm * halfWayOf(covariance);
}

TEST(BeamTheory, TheGrainIsAsWideAsDelayAndSumMakesItAndTheFocusShows) {
  const TissueMaps maps = tissueOf([](const glm::dvec3&) { return kTissueLevel; });
  constexpr std::array<double, 3> kFoci_mm{20.0, 70.0, 150.0};
  constexpr std::array<double, 5> kDepths_mm{20.0, 37.0, 70.0, 90.0, 118.0};
  for (const double carrier_hz : {2.5e6, 3.5e6}) {
    std::array<std::array<double, kDepths_mm.size()>, kFoci_mm.size()> widths_mm{};
    for (std::size_t f = 0; f < kFoci_mm.size(); ++f) {
      Shot shot = rawShot();
      shot.knobs.carrier_hz = carrier_hz;
      shot.knobs.focus_mm = kFoci_mm[f];
      const std::vector<Lines> views = viewsOf(maps, shot);
      std::printf("%.1f MHz, focus %3.0f mm:", 1e-6 * carrier_hz, kFoci_mm[f]);
      for (std::size_t d = 0; d < kDepths_mm.size(); ++d) {
        const double width_mm = grainWidths_mm(views, kDepths_mm[d]).x;
        const double narrowest_mm = theoreticalWidth_mm(carrier_hz, kFoci_mm[f], kDepths_mm[d], false),
                     widest_mm = theoreticalWidth_mm(carrier_hz, kFoci_mm[f], kDepths_mm[d], true);
        std::printf("  %3.0f mm %.2f (%.2f to %.2f)", kDepths_mm[d], width_mm, narrowest_mm, widest_mm);
        const std::string place = std::to_string(kFoci_mm[f]) + " seen at " + std::to_string(kDepths_mm[d]);
        EXPECT_GT(width_mm, 0.95 * narrowest_mm) << place;
        EXPECT_LT(width_mm, 1.05 * widest_mm) << place;
        widths_mm[f][d] = width_mm;
      }
      std::printf("\n");
    }
    // Where a focus lies the beam is clearly narrower than with either other focus.
    EXPECT_LT(widths_mm[0][0], 0.85 * std::min(widths_mm[1][0], widths_mm[2][0]));
    EXPECT_LT(widths_mm[1][2], 0.85 * std::min(widths_mm[0][2], widths_mm[2][2]));
    EXPECT_LT(widths_mm[2][4], 0.95 * std::min(widths_mm[0][4], widths_mm[1][4]));
  }
}

TEST(BeamTheory, TheGrainIsAsLongAsThePulseAtEveryFrequency) {
  const TissueMaps maps = tissueOf([](const glm::dvec3&) { return kTissueLevel; });
  for (const double carrier_hz : {2.5e6, 3.5e6, 5e6}) {
    Shot shot = rawShot();
    shot.knobs.carrier_hz = carrier_hz;
    const std::vector<Lines> views = viewsOf(maps, shot);
    const double pulse_mm = LiveEchoesEffect{}.pulseCycles * wavelength_mm(carrier_hz) / 2.0;
    std::printf("%.1f MHz, along the beam (%.2f mm):", 1e-6 * carrier_hz, pulse_mm);
    for (const double depth_mm : {37.0, 70.0, 118.0}) {
      const double length_mm = grainWidths_mm(views, depth_mm).y;
      std::printf("  %3.0f mm %.2f", depth_mm, length_mm);
      EXPECT_NEAR(length_mm, pulse_mm, 0.12 * pulse_mm) << carrier_hz << " at " << depth_mm;
    }
    std::printf("\n");
  }
}

TEST(BeamTheory, TheEnvelopeIsRayleighAtEveryDepthAndFrequency) {
  const TissueMaps maps = tissueOf([](const glm::dvec3&) { return kTissueLevel; });
  for (const double carrier_hz : {2.5e6, 3.5e6, 5e6}) {
    Shot shot = rawShot();
    shot.knobs.carrier_hz = carrier_hz;
    const std::vector<Lines> views = viewsOf(maps, shot);
    std::printf("%.1f MHz, mean of the envelope over its deviation (1.91):", 1e-6 * carrier_hz);
    for (const double depth_mm : {37.0, 70.0, 118.0}) {
      double sum = 0.0, square = 0.0, count = 0.0;
      for (const Lines& view : views)
        for (int s = view.sampleAt(depth_mm - 10.0); s < view.sampleAt(depth_mm + 10.0); ++s)
          for (int l = 0; l < view.count(); ++l) {
            sum += std::sqrt(view.at(l, s));
            square += view.at(l, s);
            count += 1.0;
          }
      const double mean = sum / count, ratio = mean / std::sqrt(square / count - mean * mean);
      std::printf("  %3.0f mm %.2f", depth_mm, ratio);
      EXPECT_NEAR(ratio, 1.91, 0.2) << carrier_hz << " at " << depth_mm;
    }
    std::printf("\n");
  }
}

/// Correlation of the intensities about the pivot's depth between two poses of each place.
double correlationAt(const TissueMaps& maps, const Shot& shot, double pivot_mm, const glm::dmat4& step) {
  std::vector<double> still, moved;
  for (const double z_mm : kPlaces_mm) {
    const Lines a = linesOf(maps, shot, slidAcross(z_mm)), b = linesOf(maps, shot, slidAcross(z_mm) * step);
    for (int s = a.sampleAt(pivot_mm - 3.0); s < a.sampleAt(pivot_mm + 3.0); ++s)
      for (int l = a.count() / 2 - 100; l < a.count() / 2 + 100; ++l) {
        still.push_back(a.at(l, s));
        moved.push_back(b.at(l, s));
      }
  }
  return correlation(still, moved);
}

TEST(BeamTheory, TippingThePlaneTakesTheGrainAwayAsItsThicknessSays) {
  const TissueMaps maps = tissueOf([](const glm::dvec3&) { return kTissueLevel; });
  const Shot shot = rawShot();
  constexpr double kPivot_mm = 70.0;
  // Of two places d apart across the slice the speckle of a Gaussian slice correlates by exp(-d^2 / (2 sigma^2)): that tells sigma.
  constexpr double kApart_mm = 0.9;
  const double apart = correlationAt(maps, shot, kPivot_mm, slidAcross(kApart_mm));
  const double sigma_mm = kApart_mm / std::sqrt(-2.0 * std::log(apart));
  EXPECT_GT(sigma_mm, 0.5);
  EXPECT_LT(sigma_mm, 1.3);
  std::printf("slice of sigma %.2f mm, tipped by", sigma_mm);
  for (const double tip_deg : {1.0, 2.0, 3.0, 5.0, 8.0}) {
    const double tip_rad = tip_deg * std::numbers::pi / 180.0;
    glm::dmat4 step = glm::translate(glm::dmat4(1.0), {0.0, kPivot_mm, 0.0});
    step = glm::rotate(step, tip_rad, glm::dvec3(1.0, 0.0, 0.0));
    step = glm::translate(step, {0.0, -kPivot_mm, 0.0});
    const double phase = 4.0 * std::numbers::pi / wavelength_mm(shot.probe.carrier_hz) * tip_rad * sigma_mm,
                 theory = std::exp(-0.5 * phase * phase), seen = correlationAt(maps, shot, kPivot_mm, step);
    std::printf("  %.0f deg %.2f (%.2f)", tip_deg, seen, theory);
    EXPECT_NEAR(seen, theory, 0.07) << tip_deg << " degrees";
  }
  std::printf("\n");
}

double meanPower(const std::vector<Lines>& views, double depth_mm, double half_mm, double halfWidth_mm) {
  double sum = 0.0, count = 0.0;
  for (const Lines& view : views)
    for (int s = view.sampleAt(depth_mm - half_mm); s < view.sampleAt(depth_mm + half_mm); ++s)
      for (int l = 0; l < view.count(); ++l) {
        const BeamGrid::Line& line = view.grid.lines[static_cast<std::size_t>(l)];
        if (std::abs(line.origin_mm.x + view.grid.depth_mm(s) * line.direction.x) > halfWidth_mm) continue;
        sum += view.at(l, s);
        count += 1.0;
      }
  return sum / count;
}
double inDecibel(double power) { return 10.0 * std::log10(power); }

TEST(BeamTheory, TissueTakesItsDecibelsByDepthAndFrequency) {
  const TissueMaps maps = tissueOf([](const glm::dvec3&) { return kTissueLevel; });
  const Volume labels = layersOf(maps, 1000.0);
  for (const double carrier_hz : {2.5e6, 3.5e6, 5e6}) {
    Shot shot = rawShot();
    shot.knobs.carrier_hz = carrier_hz;
    const std::vector<Lines> lossless = viewsOf(maps, shot);
    shot.labels = &labels;
    shot.scene.attenuation = AttenuationEffect{};
    shot.scene.attenuation->expected_dbPerCmMhz = 0.0;
    shot.scene.tissues = {{.label = 1, .name = "liver", .attenuation_dbPerCmMhz = 0.5}};
    const std::vector<Lines> views = viewsOf(maps, shot);
    const auto lost_db = [&](double depth_mm) {
      return inDecibel(meanPower(views, depth_mm, 5.0, 40.0) / meanPower(lossless, depth_mm, 5.0, 40.0));
    };
    const double seen_dbPerCm = (lost_db(80.0) - lost_db(30.0)) / 5.0, theory_dbPerCm = -2.0 * 0.5 * 1e-6 * carrier_hz;
    std::printf("%.1f MHz: %.2f dB/cm (%.2f)\n", 1e-6 * carrier_hz, seen_dbPerCm, theory_dbPerCm);
    EXPECT_NEAR(seen_dbPerCm, theory_dbPerCm, 0.03 * std::abs(theory_dbPerCm)) << carrier_hz;
  }
}

/// A cylinder across the image, 50 mm deep on the axis, within even tissue.
TissueMaps cylinderIn(double level, double radius_mm) {
  return tissueOf([=](const glm::dvec3& p) { return std::hypot(p.x, p.y - 50.0) < radius_mm ? level : kTissueLevel; }, 0.5);
}

TEST(BeamTheory, LesionsDifferByWhatTheyScatterMore) {
  const Shot shot = rawShot();
  const std::vector<Lines> even = viewsOf(tissueOf([](const glm::dvec3&) { return kTissueLevel; }, 0.5), shot);
  for (const double grey : {26.0, -25.0}) {
    const std::vector<Lines> views = viewsOf(cylinderIn(kTissueLevel + grey, 8.0), shot);
    const double seen_db = inDecibel(meanPower(views, 50.0, 5.0, 5.0) / meanPower(even, 50.0, 5.0, 5.0));
    std::printf("lesion of %+.2f dB: %+.2f dB\n", grey / kGreyPerDb, seen_db);
    EXPECT_NEAR(seen_db, grey / kGreyPerDb, 0.2);
  }
}

TEST(BeamTheory, FluidIsDarkAndFillsInWhereItIsNarrow) {
  const Shot shot = rawShot();
  const std::vector<Lines> even = viewsOf(tissueOf([](const glm::dvec3&) { return kTissueLevel; }, 0.5), shot);
  double wider_db = -200.0;
  // Below the tissue beside it, at least and at most.
  for (const auto& [width_mm, darkest_db, brightest_db] :
       {std::tuple{16.0, -200.0, -30.0}, std::tuple{8.0, -200.0, -27.0}, std::tuple{4.0, -40.0, -18.0}, std::tuple{2.0, -14.0, -4.0}}) {
    const std::vector<Lines> views = viewsOf(cylinderIn(0.0, 0.5 * width_mm), shot);
    const double half_mm = 0.25 * width_mm,
                 seen_db = inDecibel(meanPower(views, 50.0, half_mm, half_mm) / meanPower(even, 50.0, half_mm, half_mm));
    std::printf("cylinder of fluid, %2.0f mm wide: %.1f dB\n", width_mm, seen_db);
    EXPECT_GT(seen_db, darkest_db) << width_mm;
    EXPECT_LT(seen_db, brightest_db) << width_mm;
    EXPECT_GT(seen_db, wider_db) << width_mm;
    wider_db = seen_db;
  }
}

}  // namespace
}  // namespace ew::beam_theory_test
