#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "ew/imaging/frame.h"
#include "ew/imaging/resolved.h"
#include "ew/imaging/tissue_level.h"
#include "imaging/support/every_target.h"
#include "imaging/support/live_echoes_support.h"

namespace ew::live_echoes_test {
namespace {

using namespace testing::live;

/// Images of the same place, moved between them.
double correlationWhenMoved(const TissueMaps& maps, Shot shot, const glm::dmat4& moved, double from_mm = 55.0, double to_mm = 85.0) {
  const std::vector<double> still = levelsBetween(imageOf(maps, shot), shot, from_mm, to_mm);
  shot.probeToWorld = moved;
  return correlation(still, levelsBetween(imageOf(maps, shot), shot, from_mm, to_mm));
}

TEST(LiveEchoes, HaveTheLevelOfTheTissueAtEveryDepthAndWithAnyNumberOfLooks) {
  const TissueMaps maps = tissueOf([](const glm::dvec3&) { return 150.0; });
  Shot shot;
  for (const int looks : {1, 3, 5}) {
    shot.scene.liveEchoes->looks = looks;
    const GreyImage image = imageOf(maps, shot);
    for (const double depth_mm : {20.0, 45.0, 70.0, 95.0})
      EXPECT_NEAR((meanOf(levelsBetween(image, shot, depth_mm, depth_mm + 20.0)) - 150.0) / kGreyPerDb, 0.0, 0.7)
          << looks << " " << depth_mm;
  }
}

TEST(LiveEchoes, AreFullyDevelopedSpeckle) {
  const TissueMaps maps = tissueOf([](const glm::dvec3&) { return 150.0; });
  Shot shot;
  shot.probe.lines = 400;  // what lies between lines is a mean of their levels
  std::vector<double> amplitudes;
  for (const double level : levelsBetween(imageOf(maps, shot), shot, 30.0, 110.0, 40.0))
    amplitudes.push_back(std::pow(10.0, (level - 255.0) / kGreyPerDb / 20.0));
  const double mean = meanOf(amplitudes);
  double square = 0.0;
  for (const double amplitude : amplitudes) square += (amplitude - mean) * (amplitude - mean);
  // Of a Rayleigh distribution (Burckhardt 1978).
  EXPECT_NEAR(mean / std::sqrt(square / static_cast<double>(amplitudes.size())), 1.91, 0.08);
}

TEST(LiveEchoes, StayWithTheTissueAndLeaveItWhenTheProbeTurnsOrSlides) {
  const TissueMaps maps = tissueOf([](const glm::dvec3&) { return 150.0; });
  const Shot shot;
  const auto turned = [](double deg) {
    // About an elevational axis through a point of the tissue 70 mm deep.
    glm::dmat4 turn(1.0);
    const double c = std::cos(deg * std::numbers::pi / 180.0), s = std::sin(deg * std::numbers::pi / 180.0);
    turn[1] = {0.0, c, s, 0.0};
    turn[2] = {0.0, -s, c, 0.0};
    return turn;
  };
  const auto slid = [](double z_mm) {
    glm::dmat4 slide(1.0);
    slide[3].z = z_mm;
    return slide;
  };
  EXPECT_NEAR(correlationWhenMoved(maps, shot, glm::dmat4(1.0)), 1.0, 1e-9);
  double last = 1.0;
  for (const double z_mm : {0.3, 0.7, 1.2, 2.0}) {
    const double here = correlationWhenMoved(maps, shot, slid(z_mm));
    EXPECT_LT(here, last) << z_mm;
    last = here;
  }
  EXPECT_LT(last, 0.45);  // a slice of 3 mm
  EXPECT_GT(correlationWhenMoved(maps, shot, slid(0.3)), 0.8);
  EXPECT_LT(correlationWhenMoved(maps, shot, turned(3.0)), 0.6);
}

/// One maker for image after image, as a window has it: what it keeps between them must not show.
class KeepingMaker {
 public:
  explicit KeepingMaker(int threads) : maker_(threads) {}
  GreyImage imageOf(const TissueMaps& maps, std::uint64_t version, const Shot& shot) {
    Knobs knobs = shot.knobs;
    knobs.greyMap = GreyMap::linear;
    maker_.configure(shot.probe, knobs, shot.scene, maps.grid, 640, 512, {.tissue = true});
    FrameInput input = inputOf(maps);
    input.tissueVersion = version;
    input.pose.probeToWorld.matrix = shot.probeToWorld;
    const DisplayImage made = maker_.make(input);
    GreyImage copy(made.width(), made.height());
    for (int y = 0; y < copy.height; ++y) std::copy_n(made.grey.row(y), copy.width, viewOf(copy).row(y));
    return copy;
  }

 private:
  FrameMaker maker_;
};

TEST(LiveEchoes, AreThoseOfAFirstImageWhateverWasKeptOfTheImagesBefore) {
  TissueMaps maps = tissueOf([](const glm::dvec3& p) { return p.y > 60.0 ? 160.0 : p.x > 10.0 ? 90.0 : 0.0; });
  addPlane(maps, {.name = "plane"}, 60.3);
  for (const int threads : {1, 3}) {
    Shot shot;
    shot.scene.liveEchoes = LiveEchoesEffect{};
    KeepingMaker keeping(threads);
    const auto expectAsFirst = [&](std::uint64_t version, const char* what) {
      EXPECT_EQ(keeping.imageOf(maps, version, shot), testing::live::imageOf(maps, shot)) << what << ", " << threads << " threads";
    };
    expectAsFirst(1, "first");
    expectAsFirst(1, "the same once more");
    for (int n = 1; n <= 3; ++n) {
      shot.probeToWorld[3] = glm::dvec4(0.7 * n, 0.0, 0.4 * n, 1.0);
      expectAsFirst(1, "moved");
    }
    shot.scene.liveEchoes->gain_db += 3.0;
    expectAsFirst(1, "brighter");
    shot.scene.liveEchoes->texture_db = 3.0;
    expectAsFirst(1, "more texture");
    shot.knobs.carrier_hz = 5e6;
    expectAsFirst(1, "another lattice");
    shot.knobs.quality = Quality::weave;
    expectAsFirst(1, "thinner slice");
    shot.knobs = {};
    expectAsFirst(1, "as before");
    // At the same address.
    for (std::uint8_t& level : maps.level) level = level > 0 ? static_cast<std::uint8_t>(level - 30) : 120;
    expectAsFirst(2, "other tissue");
    for (std::uint8_t& level : maps.level) level = 100;
    expectAsFirst(0, "tissue that nobody vouches for");
    for (std::uint8_t& level : maps.level) level = 140;
    expectAsFirst(0, "and again");
    expectAsFirst(2, "vouched for anew");
    const TissueMaps other = tissueOf([](const glm::dvec3& p) { return p.x > 0.0 ? 130.0 : 80.0; }, 1.5);
    EXPECT_EQ(keeping.imageOf(other, 3, shot), testing::live::imageOf(other, shot)) << "other voxels";
    maps = tissueOf([](const glm::dvec3& p) { return p.y > 60.0 ? 160.0 : p.x > 10.0 ? 90.0 : 0.0; });
  }
}

TEST(LiveEchoes, HaveFinerGrainAtAHigherFrequency) {
  const TissueMaps maps = tissueOf([](const glm::dvec3&) { return 150.0; });
  Shot shot;
  const auto axialCorrelation = [&](double carrier_hz) {
    shot.knobs.carrier_hz = carrier_hz;
    const GreyImage image = imageOf(maps, shot);
    GreyImage lower = image;
    const auto shift = static_cast<std::ptrdiff_t>(image.width);
    std::copy(image.pixels.begin() + shift, image.pixels.end(), lower.pixels.begin());
    return correlation(levelsBetween(image, shot, 55.0, 85.0), levelsBetween(lower, shot, 55.0, 85.0));
  };
  EXPECT_GT(axialCorrelation(2.5e6), axialCorrelation(3.5e6) + 0.03);
  EXPECT_GT(axialCorrelation(3.5e6), axialCorrelation(5e6) + 0.03);
}

TEST(LiveEchoes, AreTheSamePixelsOnEveryTargetAndWithAnyNumberOfThreads) {
  TissueMaps maps = tissueOf([](const glm::dvec3& p) { return p.y > 60.0 ? 160.0 : p.x > 10.0 ? 90.0 : 0.0; });
  addPlane(maps, {.name = "plane"}, 60.3);
  Shot shot;
  shot.scene.liveEchoes = LiveEchoesEffect{};
  shot.scene.noise = NoiseEffect{};
  const GreyImage one = imageOf(maps, shot);
  for (const int threads : {2, 8}) {
    shot.threads = threads;
    EXPECT_EQ(imageOf(maps, shot), one) << threads;
  }
  shot.threads = 1;
  testing::onEveryTarget([&](const char* target) { EXPECT_EQ(imageOf(maps, shot), one) << target; });
}

TEST(LiveEchoes, AreBrighterWhereTheBeamIsFocusedAsItsEnergySays) {
  const TissueMaps tissue = tissueOf([](const glm::dvec3&) { return 140.0; });
  constexpr double kDepth_mm = 120.0;  // the probe's
  const auto meanNear = [&](double focus_mm, double at_mm) {
    Shot shot;
    shot.knobs.focus_mm = focus_mm;
    return meanOf(levelsBetween(imageOf(tissue, shot), shot, at_mm - 5.0, at_mm + 5.0, 30.0));
  };
  // The energy of a Gaussian beam as wide as an apodised aperture's, two-way with dynamic reception, written out once more.
  const auto brightness_db = [&](double focus_mm, double at_mm) {
    const double wavelength = 1540.0 / 3500.0, width = 1.4 * wavelength / 2.3548200450309493, aperture = 0.75 * convex().aperture_mm;
    const double waist = width * std::max(2.0, focus_mm / aperture), range = 2.0 * std::numbers::pi * waist * waist / wavelength;
    const double transmit = waist * std::hypot(1.0, (at_mm - focus_mm) / range), receive = std::max(2.0 * width, width * at_mm / aperture);
    return 10.0 * std::log10(receive / std::hypot(transmit, receive));
  };
  for (const double focus_mm : {20.0, 90.0, 110.0})
    for (const double at_mm : {20.0, 60.0, 105.0}) {
      const double raw_db = brightness_db(focus_mm, at_mm) - brightness_db(0.5 * kDepth_mm, at_mm);
      EXPECT_NEAR((meanNear(focus_mm, at_mm) - meanNear(0.0, at_mm)) / kGreyPerDb, 6.0 * std::tanh(raw_db / 6.0), 0.7)
          << "focus " << focus_mm << " mm, seen at " << at_mm << " mm";
    }
}

TEST(LiveEchoes, KeepTheirScatterersAndTheirUsualBrightnessWhateverTheFocus) {
  const TissueMaps tissue = tissueOf([](const glm::dvec3&) { return 140.0; });
  Shot shot, half;
  half.knobs.focus_mm = 60.0;
  EXPECT_EQ(imageOf(tissue, half), imageOf(tissue, shot)) << "half of the depth is the usual focus";
  for (const double carrier_hz : {2.5e6, 3.5e6, 5e6}) {
    Shot usual, turned;
    usual.knobs.carrier_hz = turned.knobs.carrier_hz = carrier_hz;
    turned.knobs.focus_mm = 40.0;
    EXPECT_GT(
        correlation(levelsBetween(imageOf(tissue, usual), usual, 20.0, 110.0), levelsBetween(imageOf(tissue, turned), turned, 20.0, 110.0)),
        0.7)
        << carrier_hz;
  }
  // What comes behind the beam does not know of it.
  const TissueMaps nothing = tissueOf([](const glm::dvec3&) { return 0.0; });
  Shot noise;
  noise.scene.noise = NoiseEffect{.atFace_db = -30.0, .growth_dbPerCmMhz = 0.0};
  Shot turned = noise;
  turned.knobs.focus_mm = 20.0;
  EXPECT_EQ(imageOf(nothing, turned), imageOf(nothing, noise));
}

TEST(LiveEchoes, OfSurfacesAreBrightenedByTheFocusAsSpeckleIs) {
  TissueMaps maps = tissueOf([](const glm::dvec3&) { return 0.0; });
  addPlane(maps, {.name = "plane", .echoLevel = 170.0, .rough_db = -60.0}, 100.0);
  const TissueMaps tissue = tissueOf([](const glm::dvec3&) { return 140.0; });
  const auto peakOf = [&](double focus_mm) {
    Shot shot;
    shot.scene.sliceThickness.reset();
    shot.knobs.focus_mm = focus_mm;
    const std::vector<double> levels = levelsBetween(imageOf(maps, shot), shot, 95.0, 105.0, 4.0);
    return *std::max_element(levels.begin(), levels.end());
  };
  const auto speckleOf = [&](double focus_mm) {
    Shot shot;
    shot.knobs.focus_mm = focus_mm;
    return meanOf(levelsBetween(imageOf(tissue, shot), shot, 95.0, 105.0, 30.0));
  };
  const double mirror_db = (peakOf(20.0) - peakOf(0.0)) / kGreyPerDb, speckle_db = (speckleOf(20.0) - speckleOf(0.0)) / kGreyPerDb;
  EXPECT_LT(speckle_db, -3.0);
  EXPECT_NEAR(mirror_db, speckle_db, 1.0);
}

TEST(LiveEchoes, OfSeveralFociAreAtEachDepthThoseOfTheNarrowest) {
  const TissueMaps tissue = tissueOf([](const glm::dvec3&) { return 140.0; });
  const auto meanNear = [&](double first_mm, double second_mm, double at_mm) {
    Shot shot;
    shot.knobs.focus_mm = first_mm;
    shot.knobs.moreFoci_mm[0] = second_mm;
    return meanOf(levelsBetween(imageOf(tissue, shot), shot, at_mm - 5.0, at_mm + 5.0, 30.0)) / kGreyPerDb;
  };
  EXPECT_NEAR(meanNear(25.0, 105.0, 25.0), meanNear(25.0, 0.0, 25.0), 0.2);
  EXPECT_NEAR(meanNear(25.0, 105.0, 105.0), meanNear(105.0, 0.0, 105.0), 0.2);
  EXPECT_GT(meanNear(25.0, 105.0, 105.0), meanNear(25.0, 0.0, 105.0) + 3.0);
}

TEST(LiveEchoes, MirrorWhereASurfaceLiesSquareToTheBeam) {
  // A plane at 60 mm, square to the middle beam, or turned away by 20 degrees.
  const auto peakOf = [](double lean_deg) {
    TissueMaps maps = tissueOf([](const glm::dvec3&) { return 0.0; });
    addPlane(maps, {.name = "plane", .echoLevel = 220.0, .rough_db = -60.0}, 60.0, lean_deg * std::numbers::pi / 180.0);
    Shot shot;
    shot.scene.sliceThickness.reset();
    const std::vector<double> levels = levelsBetween(imageOf(maps, shot), shot, 50.0, 70.0, 4.0);
    return *std::max_element(levels.begin(), levels.end());
  };
  const double square = peakOf(0.0);
  EXPECT_NEAR(square, 220.0, 12.0);
  EXPECT_NEAR((square - peakOf(20.0)) / kGreyPerDb, 20.0, 4.0);
}

/// How far a usual surface's echo lies below that of one that is square to the beam.
double usualLobes_db(double lean_deg) {
  const double sine2 = std::pow(std::sin(lean_deg * std::numbers::pi / 180.0), 2.0);
  const auto lobe = [&](double fall_deg) { return std::exp(-0.5 * sine2 / std::pow(std::sin(fall_deg * std::numbers::pi / 180.0), 2.0)); };
  const ReflectingSurface usual;
  return -20.0 * std::log10(std::hypot(lobe(usual.fall_deg), std::pow(10.0, 0.05 * usual.rough_db) * lobe(usual.roughFall_deg)));
}

TEST(LiveEchoes, ShowASurfaceThirtyToFortyDegreesOffByWhatIsRoughOfIt) {
  const auto peakOf = [](double lean_deg) {
    TissueMaps maps = tissueOf([](const glm::dvec3&) { return 0.0; });
    addPlane(maps, {.name = "plane", .echoLevel = 250.0}, 60.0, lean_deg * std::numbers::pi / 180.0);
    Shot shot;
    shot.scene.sliceThickness.reset();
    const std::vector<double> levels = levelsBetween(imageOf(maps, shot), shot, 50.0, 70.0, 4.0);
    return *std::max_element(levels.begin(), levels.end());
  };
  const double square = peakOf(0.0);
  // The lines of a beam meet a plane that leans at other depths: what they add up to is longer, and fainter by up to 7 dB.
  for (const double lean_deg : {20.0, 30.0, 40.0}) {
    const double found_db = (square - peakOf(lean_deg)) / kGreyPerDb;
    EXPECT_GT(found_db, usualLobes_db(lean_deg) - 2.0) << lean_deg;
    EXPECT_LT(found_db, usualLobes_db(lean_deg) + 7.0) << lean_deg;
  }
}

TEST(LiveEchoes, ShowTissueThatGivesWayToTheFaceWhereTheSceneHasContact) {
  // The face stands 5 mm below a flat skin, a plane 10 mm and another 75 mm below it.
  TissueMaps maps = tissueOf([](const glm::dvec3& p) { return p.y > -5.0 ? 20.0 : 0.0; });
  Shot shot;
  const auto brightestBetween = [&](double plane_mm, double from_mm, double to_mm) {
    maps.surfaces.clear();
    addPlane(maps, {.name = "plane", .echoLevel = 230.0}, plane_mm);
    const GreyImage image = imageOf(maps, shot);
    double at_mm = 0.0, most = 0.0;
    for (double depth_mm = from_mm; depth_mm < to_mm; depth_mm += 0.1) {
      const std::vector<double> levels = levelsBetween(image, shot, depth_mm - 0.15, depth_mm + 0.15, 2.0);
      if (!levels.empty() && meanOf(levels) > most) {
        most = meanOf(levels);
        at_mm = depth_mm;
      }
    }
    return at_mm;
  };
  EXPECT_NEAR(brightestBetween(5.0, 2.0, 14.0), 5.0, 0.4) << "as it lies at rest";
  shot.scene.contact = ContactEffect{};
  EXPECT_NEAR(brightestBetween(5.0, 2.0, 14.0), 5.0 + 5.0 * std::exp(-std::pow(10.0 / 35.0, 2.0)), 0.5);
  EXPECT_NEAR(brightestBetween(70.0, 65.0, 75.0), 70.0, 0.4) << "too deep to be moved";
  maps.isRecorded = true;
  EXPECT_NEAR(brightestBetween(5.0, 2.0, 14.0), 5.0, 0.4) << "what was recorded was pressed then";
}

TEST(LiveEchoes, ShowTheSheetsOfASurfaceOneBehindTheOther) {
  TissueMaps maps = tissueOf([](const glm::dvec3&) { return 0.0; });
  addPlane(maps, {.name = "plane", .echoLevel = 220.0, .sheets = 3, .sheetGap_mm = 2.0}, 60.0);
  Shot shot;
  shot.scene.sliceThickness.reset();
  const GreyImage image = imageOf(maps, shot);
  const auto peakNear = [&](double depth_mm) {
    const std::vector<double> levels = levelsBetween(image, shot, depth_mm - 0.7, depth_mm + 0.7, 4.0);
    return *std::max_element(levels.begin(), levels.end());
  };
  // 2.5 dB each, and unevenness of at most 4.
  EXPECT_NEAR((peakNear(60.0) - peakNear(62.0)) / kGreyPerDb, 2.5, 4.5);
  EXPECT_NEAR((peakNear(62.0) - peakNear(64.0)) / kGreyPerDb, 2.5, 4.5);
  EXPECT_LT(peakNear(66.0), peakNear(64.0) - 20.0);
  EXPECT_LT(meanOf(levelsBetween(image, shot, 60.8, 61.2, 4.0)), peakNear(60.0) - 20.0) << "dark between them";
}

TEST(LiveEchoes, OfACurvedSurfaceAreALineWithoutBeads) {
  const glm::dvec2 middle_mm(0.0, 65.0);
  constexpr double kRadius_mm = 30.0;
  TissueMaps maps = tissueOf([](const glm::dvec3&) { return 0.0; });
  // What is rough of it shows at every angle here: a slope of its brightness would be no beads.
  addSurface(maps, {.name = "tube", .echoLevel = 250.0, .rough_db = -20.0, .roughFall_deg = 90.0},
             [&](const glm::dvec3& p) { return glm::distance(glm::dvec2(p), middle_mm) - kRadius_mm; });
  for (const double carrier_hz : {2.5e6, 3.5e6, 5e6}) {
    Shot shot;
    shot.probe.lines = 600;  // what lies between lines is a mean of their levels
    shot.knobs.carrier_hz = carrier_hz;
    const GreyImage image = imageOf(maps, shot);
    const DisplayGeometry geometry = fitDisplay(shot.probe, shot.knobs, image.width, image.height, {});
    for (const double side : {-1.0, 1.0}) {
      // Along the surface from 15 to 60 degrees off its top, the brightest within 2 mm of it.
      std::vector<double> along;
      for (double angle_deg = 15.0; angle_deg <= 60.0; angle_deg += 0.25) {
        double most = 0.0;
        for (double off_mm = -2.0; off_mm <= 2.0; off_mm += 0.1) {
          const double angle = side * angle_deg * std::numbers::pi / 180.0;
          const glm::dvec2 at_mm = middle_mm + (kRadius_mm + off_mm) * glm::dvec2(std::sin(angle), -std::cos(angle));
          const glm::dvec2 at_px = geometry.face_px + glm::dvec2(geometry.markerLeft ? -at_mm.x : at_mm.x, at_mm.y) / geometry.pixel_mm;
          const int x = static_cast<int>(std::lround(at_px.x)), y = static_cast<int>(std::lround(at_px.y));
          most = std::max(most, static_cast<double>(viewOf(image).at(x, y)));
        }
        along.push_back(std::pow(10.0, most / kGreyPerDb / 20.0));
      }
      // Against the mean over 12 degrees, in amplitudes.
      double squares = 0.0;
      int count = 0;
      constexpr int kHalf = 24;
      for (int n = kHalf; n + kHalf < static_cast<int>(along.size()); ++n, ++count) {
        const double mean = meanOf({along.begin() + n - kHalf, along.begin() + n + kHalf + 1});
        squares += std::pow(along[static_cast<std::size_t>(n)] / mean - 1.0, 2.0);
      }
      // At 5 MHz the pixels of 0.25 mm hardly resolve a line of 0.33 mm.
      EXPECT_LT(std::sqrt(squares / count), carrier_hz < 4e6 ? 0.05 : 0.065) << "at " << carrier_hz << (side < 0.0 ? ", left" : ", right");
    }
  }
}

TEST(LiveEchoes, LoseWhatTissueTakesBeyondTheMachinesCompensation) {
  const TissueMaps maps = tissueOf([](const glm::dvec3&) { return 170.0; });
  Volume labels;
  labels.grid = maps.grid;
  labels.echo.assign(maps.level.size(), 1);
  Shot shot;
  shot.labels = &labels;
  shot.scene.attenuation = AttenuationEffect{};
  shot.scene.attenuation->expected_dbPerCmMhz = 0.5;
  shot.scene.tissues = {{.label = 1, .name = "liver", .attenuation_dbPerCmMhz = 0.7}};
  const GreyImage image = imageOf(maps, shot);
  const double near = meanOf(levelsBetween(image, shot, 25.0, 35.0)), far = meanOf(levelsBetween(image, shot, 85.0, 95.0));
  // 2 x 0.2 dB/(cm MHz) x 3.5 MHz x 6 cm
  EXPECT_NEAR((near - far) / kGreyPerDb, 8.4, 0.8);
}

TEST(LiveEchoes, ThrowAShadowThatSoftensWithDepth) {
  const TissueMaps maps = tissueOf([](const glm::dvec3&) { return 180.0; });
  Volume labels;
  labels.grid = maps.grid;
  labels.echo.assign(maps.level.size(), 1);
  for (int k = 0; k < labels.grid.dims.z; ++k)
    for (int j = 0; j < labels.grid.dims.y; ++j)
      for (int i = 0; i < labels.grid.dims.x; ++i) {
        const glm::dvec3 p = labels.grid.origin_mm + glm::dvec3(i, j, k);
        if (p.y > 40.0 && p.y < 46.0 && std::abs(p.x) < 8.0) labels.echo[labels.grid.indexOf(i, j, k)] = 2;
      }
  Shot shot;
  shot.labels = &labels;
  shot.scene.attenuation = AttenuationEffect{};
  shot.scene.tissues = {{.label = 1, .name = "liver", .attenuation_dbPerCmMhz = 0.5},
                        {.label = 2, .name = "stone", .attenuation_dbPerCmMhz = 10.0, .reflection_db = 25.0}};
  const GreyImage image = imageOf(maps, shot);
  const double before = meanOf(levelsBetween(image, shot, 25.0, 35.0, 3.0));
  EXPECT_GT(before - meanOf(levelsBetween(image, shot, 52.0, 60.0, 3.0)), 20.0 * kGreyPerDb);
  EXPECT_NEAR(meanOf(levelsBetween(image, shot, 38.0, 40.5, 3.0)), before, 8.0);  // nothing is lost in front of it
}

TEST(LiveEchoes, ShadeWithSidesAsSoftAsTheApertureIsWide) {
  const TissueMaps maps = tissueOf([](const glm::dvec3&) { return 220.0; });
  Shot shot;
  const auto imageBehind = [&](double edge_mm) {
    Volume labels = layersOf(maps, 1000.0);
    for (int k = 0; k < labels.grid.dims.z; ++k)
      for (int j = 0; j < labels.grid.dims.y; ++j)
        for (int i = 0; i < labels.grid.dims.x; ++i) {
          const glm::dvec3 p = labels.grid.origin_mm + glm::dvec3(i, j, k);
          if (p.y >= 40.0 && p.y < 43.0 && p.x >= edge_mm) labels.echo[labels.grid.indexOf(i, j, k)] = 2;
        }
    shot.labels = &labels;
    shot.scene.attenuation = AttenuationEffect{};
    shot.scene.tissues = {{.label = 1, .name = "liver", .attenuation_dbPerCmMhz = 0.5},
                          {.label = 2, .name = "bone", .attenuation_dbPerCmMhz = 0.5, .reflection_db = 60.0}};
    return imageOf(maps, shot);
  };
  constexpr double kDepth_mm = 90.0;
  const auto levelOf = [&](const GreyImage& image) { return meanOf(levelsBetween(image, shot, kDepth_mm - 8.0, kDepth_mm + 8.0, 1.5)); };
  const double open = levelOf(imageBehind(1000.0));
  for (const double edge_mm : {-5.0, -2.0, 0.0, 2.0, 5.0, 7.0}) {
    // The edge lies halfway between two voxels; rays come in from the front or through the side.
    const double u = std::clamp((edge_mm - 0.5) / (1.0 - (edge_mm < 0.0 ? 42.5 : 39.5) / kDepth_mm) / shot.probe.aperture_mm, -0.5, 0.5);
    const double seen = 0.5 + (0.35 * u + 0.65 / std::numbers::pi * std::sin(std::numbers::pi * u)) / (0.35 + 1.3 / std::numbers::pi);
    EXPECT_NEAR((levelOf(imageBehind(edge_mm)) - open) / kGreyPerDb, 40.0 * std::log10(seen), 1.5) << edge_mm << " mm to the edge";
  }
}

TEST(LiveEchoes, TakeGelBeforeTheSkinForWhatItIs) {
  // 3 mm of gel lose nothing, although they bear the label of what is behind them.
  constexpr double kGel_mm = 3.0;
  Shot shot;
  shot.scene.attenuation = AttenuationEffect{};
  shot.scene.tissues = {{.label = 1, .name = "tissue", .attenuation_dbPerCmMhz = 1.5}};
  const auto levelBehind = [&](double gel_mm) {
    const TissueMaps maps = tissueOf([&](const glm::dvec3& p) { return p.y > gel_mm ? 220.0 : 0.0; }, 0.5);
    const Volume labels = layersOf(maps, 1000.0);
    shot.labels = &labels;
    return meanOf(levelsBetween(imageOf(maps, shot), shot, 20.0, 30.0));
  };
  // 2 x 1.5 dB/(cm MHz) x 3.5 MHz
  EXPECT_NEAR((levelBehind(kGel_mm) - levelBehind(0.0)) / kGreyPerDb, 10.5 * 0.1 * kGel_mm, 0.4);
}

TEST(LiveEchoes, PayOnceForASurfaceTheyGraze) {
  const TissueMaps maps = tissueOf([](const glm::dvec3&) { return 220.0; });
  Shot shot;
  shot.scene.attenuation = AttenuationEffect{};
  shot.scene.tissues = {{.label = 1, .name = "tissue", .attenuation_dbPerCmMhz = 0.5},
                        {.label = 2, .name = "cartilage", .attenuation_dbPerCmMhz = 0.5, .reflection_db = 12.0}};
  const auto levelBehind = [&](const std::vector<glm::dvec2>& layers) {
    Volume labels = layersOf(maps, 1000.0);
    for (int k = 0; k < labels.grid.dims.z; ++k)
      for (int j = 0; j < labels.grid.dims.y; ++j)
        for (int i = 0; i < labels.grid.dims.x; ++i)
          for (const glm::dvec2& layer : layers)
            if (const double y = labels.grid.origin_mm.y + j; y >= layer.x && y < layer.y) labels.echo[labels.grid.indexOf(i, j, k)] = 2;
    shot.labels = &labels;
    return meanOf(levelsBetween(imageOf(maps, shot), shot, 60.0, 80.0)) / kGreyPerDb;
  };
  const double open = levelBehind({}), once = levelBehind({{30.0, 34.0}});
  EXPECT_NEAR(once - open, -12.0, 0.5);
  EXPECT_NEAR(levelBehind({{30.0, 32.0}, {34.0, 36.0}}), once, 0.5);         // 2 mm between them
  EXPECT_NEAR(levelBehind({{30.0, 34.0}, {42.0, 46.0}}), once - 12.0, 0.5);  // 8 mm
}

TEST(LiveEchoes, CostASceneNothingThatDoesNotAskForThem) {
  const Probe probe = convex();
  const Knobs knobs;
  Scene scene = sceneWithEverything();
  const DisplayGeometry geometry = fitDisplay(probe, knobs, 640, 480, {});
  Grid grid;
  grid.dims = glm::ivec3(100);
  scene.liveEchoes.reset();
  EXPECT_FALSE(formsEchoes(scene));
  EXPECT_EQ(makePlan(probe, knobs, scene, geometry, grid, {.labels = true, .tissue = true}),
            makePlan(probe, knobs, scene, geometry, grid, {.labels = true}));
  const Plan recorded = makePlan(probe, knobs, scene, geometry, grid, {.labels = true});
  scene.liveEchoes = LiveEchoesEffect{};
  // Nor one whose tissue nobody knows.
  EXPECT_EQ(makePlan(probe, knobs, scene, geometry, grid, {.labels = true}), recorded);
  EXPECT_NE(makePlan(probe, knobs, scene, geometry, grid, {.labels = true, .tissue = true}), recorded);
}

/// A recorded volume beside maps made of it, seen with a curve that shows decibels as they are.
GreyImage imageOfRecorded(const Volume& volume, const TissueMaps& maps, double ownGrain, const Shot& shot) {
  FrameMaker maker(shot.threads);
  Scene scene = shot.scene;
  if (scene.liveEchoes) scene.liveEchoes->ownGrain = ownGrain;
  maker.configure(shot.probe, shot.knobs, scene, volume.grid, 640, 512, {.tissue = true, .recorded = maps.isRecorded});
  FrameInput input;
  input.tissue = &maps;
  input.tissueGrid = maps.grid;
  input.echo = volume.view();
  input.pose.probeToWorld.matrix = shot.probeToWorld;
  const DisplayImage made = maker.make(input);
  GreyImage copy(made.width(), made.height());
  for (int y = 0; y < copy.height; ++y) std::copy_n(made.grey.row(y), copy.width, viewOf(copy).row(y));
  return copy;
}

/// Speckle as one machine recorded it, of tissue with a dark and a bright half.
Volume recordedHalves() {
  const TissueMaps drawn = tissueOf([](const glm::dvec3& mm) { return mm.y < 50.0 ? 90.0 : 125.0; });
  Volume volume{drawn.grid, drawn.level, {}};
  std::mt19937 random(21);
  std::exponential_distribution<double> power;
  for (auto& voxel : volume.echo)
    voxel = static_cast<std::uint8_t>(std::lround(std::clamp(voxel + kGreyPerDb * (10.0 * std::log10(power(random)) + 2.507), 1.0, 255.0)));
  return volume;
}

TEST(LiveEchoes, OfARecordedVolumesLevelAreAsBrightAsTheTissueWasDrawn) {
  const TissueMaps drawn = tissueOf([](const glm::dvec3& mm) { return mm.y < 50.0 ? 90.0 : 125.0; });
  const Volume volume = recordedHalves();
  const auto level = levelOf(volume, {.shownWith = GreyMap::linear, .gain_db = 0.0});
  ASSERT_TRUE(level);
  const TissueMaps found = recordedMaps(volume.grid, *level);
  const Shot shot;
  const GreyImage asDrawn = imageOf(drawn, shot), asFound = imageOf(found, shot);
  for (const auto& [from_mm, to_mm] : {std::pair{20.0, 44.0}, std::pair{56.0, 90.0}})
    EXPECT_NEAR(meanOf(levelsBetween(asFound, shot, from_mm, to_mm)), meanOf(levelsBetween(asDrawn, shot, from_mm, to_mm)), kGreyPerDb);
}

TEST(LiveEchoes, BecomeTheSliceAsMoreOfTheVolumesOwnGrainIsKept) {
  const Volume volume = recordedHalves();
  const auto level = levelOf(volume);
  ASSERT_TRUE(level);
  const TissueMaps maps = recordedMaps(volume.grid, *level);
  Shot shot;
  shot.scene.sliceThickness.reset();
  shot.scene.focus.reset();
  shot.scene.liveEchoes->gain_db = LiveEchoesEffect{}.gain_db;
  shot.knobs.gainLaw = GainLaw::decibel;
  shot.knobs.greyMap = GreyMap::clinical;
  const auto seen = [&](const GreyImage& image) { return levelsBetween(image, shot, 20.0, 100.0); };
  const std::vector<double> none = seen(imageOfRecorded(volume, maps, 0.0, shot)), half = seen(imageOfRecorded(volume, maps, 0.5, shot)),
                            all = seen(imageOfRecorded(volume, maps, 1.0, shot));
  // The slice: on beams as well, and with the curve that the volume's grey already has.
  Shot sliced = shot;
  sliced.scene.liveEchoes.reset();
  sliced.scene.sliceThickness.reset();
  sliced.knobs.greyMap = GreyMap::linear;
  const std::vector<double> slice = seen(imageOfRecorded(volume, maps, 0.0, sliced));
  EXPECT_GT(correlation(all, slice), 0.98);
  EXPECT_NEAR(meanOf(all), meanOf(slice), 2.0);
  const double ofNone = correlation(none, slice), ofHalf = correlation(half, slice);
  EXPECT_LT(ofNone + 0.1, ofHalf);
  EXPECT_LT(ofHalf + 0.1, 0.98);
  shot.threads = 3;
  EXPECT_TRUE(seen(imageOfRecorded(volume, maps, 0.5, shot)) == half);
  // Recorded tissue has little walls and a texture of its own.
  shot.scene.liveEchoes->fragmentsPerCm3 = 37.0;
  shot.scene.liveEchoes->texture_db = 3.0;
  EXPECT_TRUE(seen(imageOfRecorded(volume, maps, 0.5, shot)) == half);
}

TEST(LiveEchoes, TakeUpAVolumesOwnGrainOnlyWhereThereIsARecording) {
  const Probe probe = convex();
  const Knobs knobs;
  Scene scene;
  scene.liveEchoes = LiveEchoesEffect{};
  scene.liveEchoes->ownGrain = 0.5;
  const DisplayGeometry geometry = fitDisplay(probe, knobs, 640, 480, {});
  Grid grid;
  grid.dims = glm::ivec3(100);
  const auto keeps = [&](bool isRecorded) {
    const Plan plan = makePlan(probe, knobs, scene, geometry, grid, {.labels = true, .tissue = true, .recorded = isRecorded});
    return std::any_of(plan.steps.begin(), plan.steps.end(), [](const Step& step) { return step.kind == StepKind::ownGrain; });
  };
  EXPECT_TRUE(keeps(true));
  EXPECT_FALSE(keeps(false));
  scene.liveEchoes->ownGrain = 0.0;
  EXPECT_FALSE(keeps(true));
  EXPECT_EQ(makePlan(probe, knobs, scene, geometry, grid, {.labels = true, .tissue = true, .recorded = true}),
            makePlan(probe, knobs, scene, geometry, grid, {.labels = true, .tissue = true}));
}

}  // namespace
}  // namespace ew::live_echoes_test
