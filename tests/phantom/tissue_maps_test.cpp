#include <cmath>
#include <nlohmann/json.hpp>

#include "counted_stop.h"
#include "recipes.h"

namespace ew::tissue_maps_test {
namespace {

using testing::Folder;
using testing::patientOf;
using testing::shippedPatient;

constexpr double kSpacing_mm = 0.8;

/// A ball of skin of radius 60 mm around organs, with tissues of different impedance.
std::string recipeOf(const std::string& organs) {
  return R"({"format": 1, "name": "test", "mannequin": "ball.json", "box": {"lowest_mm": [-30, -30, -30], "highest_mm": [30, 30, 30]},
    "tissues": [{"name": "even", "echo_level": 100, "speckle": 1, "impedance_mrayl": 1.63},
                {"name": "bright", "echo_level": 180, "speckle": 0.6, "impedance_mrayl": 1.63},
                {"name": "dark", "echo_level": 0, "speckle": 0, "impedance_mrayl": 1.63},
                {"name": "fat", "echo_level": 80, "speckle": 0.6, "impedance_mrayl": 1.38},
                {"name": "like even", "echo_level": 90, "speckle": 1, "impedance_mrayl": 1.6305}],
    "background": "even", "organs": [)" +
         organs + "]}";
}

constexpr const char* kBall = R"({"name": "ball", "tissue": "bright", "border": {"echo_level": 230, "width_mm": 2, "shine": "all round"},
    "shape": {"ellipsoid": {"centre_mm": [0.3, -0.2, 0.1], "radii_mm": [12, 12, 12]}}})";
constexpr const char* kPlane = R"({"name": "plane", "tissue": "dark", "border": {"echo_level": 200, "width_mm": 0.5},
    "shape": {"half_space": {"point_mm": [0, 0, 3.3], "outward": [0.36, 0.48, 0.8]}}})";

VoxelPatient mapped(const std::string& recipe, double spacing_mm = kSpacing_mm, int threads = 0) {
  const auto patient = patientOf(recipe);
  if (!patient) {
    ADD_FAILURE() << patient.error();
    std::abort();
  }
  auto made = voxelise(**patient, {.spacing_mm = spacing_mm, .threads = threads, .maps = true}, noProgress());
  if (!made) {
    ADD_FAILURE() << made.error();
    std::abort();
  }
  return std::move(*made);
}

template <class Visit>
void forEachVoxel(const Grid& grid, const Visit& visit) {
  for (int k = 0; k < grid.dims.z; ++k)
    for (int j = 0; j < grid.dims.y; ++j)
      for (int i = 0; i < grid.dims.x; ++i) visit(grid.indexOf(i, j, k), grid.origin_mm + grid.spacing_mm * glm::dvec3(i, j, k));
}

double distanceAt(const TissueMaps& maps, std::size_t at) { return (maps.surfaceDistance[at] - 128.0) / TissueMaps::kDistanceStepsPerMm; }

/// Half a step of the map, and what is allowed beside it.
constexpr double kHalfStep_mm = 0.5 / TissueMaps::kDistanceStepsPerMm;

TEST(TissueMaps, AreMadeOnlyWhenAskedForAndLeaveTheVolumeAsItIs) {
  const auto patient = patientOf(recipeOf(kBall));
  const auto without = voxelise(**patient, {.spacing_mm = kSpacing_mm}, noProgress());
  const auto with = mapped(recipeOf(kBall));
  EXPECT_FALSE(without->maps);
  EXPECT_EQ(without->volume.echo, with.volume.echo);
  EXPECT_EQ(without->volume.coverage, with.volume.coverage);
  EXPECT_EQ(without->labels, with.labels);
  EXPECT_EQ(with.maps->grid, with.volume.grid);
}

TEST(TissueMaps, HoldTheLevelOfTissuesWithoutSpeckleAndBorders) {
  const auto made = mapped(recipeOf(kBall));
  forEachVoxel(made.maps->grid, [&](std::size_t at, const glm::dvec3& p) {
    const double r = glm::length(p - glm::dvec3(0.3, -0.2, 0.1));
    if (std::abs(r - 12.0) > 0.5 * kSpacing_mm) {
      ASSERT_EQ(made.maps->level[at], r < 12.0 ? 180 : 100) << r;
    }
  });
}

TEST(TissueMaps, MixLevelsAtEdgesAsPower) {
  const auto made = mapped(recipeOf(kPlane));
  const glm::dvec3 normal(0.36, 0.48, 0.8);
  forEachVoxel(made.maps->grid, [&](std::size_t at, const glm::dvec3& p) {
    const double d = glm::dot(p - glm::dvec3(0, 0, 3.3), normal);
    const double part = std::clamp(0.5 + d / kSpacing_mm, 0.0, 1.0);  // of the bright side: the other one is empty
    const double level = part > 0.0 ? std::max(0.0, 100.0 + 10.0 * std::log10(part) * 255.0 / 60.0) : 0.0;
    ASSERT_NEAR(made.maps->level[at], level, part < 0.01 ? 12.0 : 1.0) << d;
  });
}

TEST(TissueMaps, FadeAtTheSkinAndAreEmptyOutside) {
  std::string recipe =
      recipeOf(R"({"name": "speck", "tissue": "even", "shape": {"ellipsoid": {"centre_mm": [0, 0, 0], "radii_mm": [1, 1, 1]}}})");
  recipe.replace(recipe.find("[30, 30, 30]"), 12, "[30, 30, 70]");
  const auto made = mapped(recipe, 1.0);
  int faded = 0;
  forEachVoxel(made.maps->grid, [&](std::size_t at, const glm::dvec3& p) {
    const double outside = glm::length(p) - 60.0;  // the skin is kept on a grid, right to 0.1 mm
    if (outside < -0.7) {
      ASSERT_EQ(made.maps->level[at], 100);
    }
    if (outside > 0.7) {
      ASSERT_EQ(made.maps->level[at], 0);
    }
    if (std::abs(outside) < 0.05) {
      ASSERT_NEAR(made.maps->level[at], 100.0 - 3.01 * 255.0 / 60.0, 5.0);
      ++faded;
    }
  });
  EXPECT_GT(faded, 10);
}

TEST(TissueMaps, KnowTheDistanceToASphereAndItsKind) {
  const auto made = mapped(recipeOf(kBall));
  const TissueMaps& maps = *made.maps;
  ASSERT_EQ(maps.surfaces.size(), 1u);
  EXPECT_EQ(maps.surfaces[0].name, "ball");
  EXPECT_EQ(maps.surfaces[0].echoLevel, 230.0);
  EXPECT_LE(maps.surfaces[0].thickness_mm, 1.0);
  EXPECT_EQ(maps.surfaces[0].fall_deg, 9.0);
  EXPECT_FALSE(maps.surfaces[0].frontOnly);
  double worstFar = 0.0;
  forEachVoxel(maps.grid, [&](std::size_t at, const glm::dvec3& p) {
    const double d = glm::length(p - glm::dvec3(0.3, -0.2, 0.1)) - 12.0;
    if (std::abs(d) < TissueMaps::kSurfaceReach_mm - 0.15) {
      ASSERT_EQ(maps.surfaceKind[at], 1) << d;
      if (std::abs(d) < kSpacing_mm) {
        ASSERT_NEAR(distanceAt(maps, at), d, 0.05);
      }
      if (std::abs(d) < 0.85 * kSpacing_mm) {
        ASSERT_NEAR(distanceAt(maps, at), d, kHalfStep_mm + 0.005);  // these voxels asked the shape itself
      }
      worstFar = std::max(worstFar, std::abs(distanceAt(maps, at) - d));
    } else if (std::abs(d) > TissueMaps::kSurfaceReach_mm + 0.15) {
      ASSERT_EQ(maps.surfaceKind[at], 0) << d;
      ASSERT_EQ(maps.surfaceDistance[at], 0) << d;
    }
  });
  EXPECT_LT(worstFar, 0.1);
}

TEST(TissueMaps, KnowTheDistanceToAPlaneAsFarAsTheyReach) {
  const auto made = mapped(recipeOf(kPlane));
  const TissueMaps& maps = *made.maps;
  forEachVoxel(maps.grid, [&](std::size_t at, const glm::dvec3& p) {
    const double d = glm::dot(p - glm::dvec3(0, 0, 3.3), glm::dvec3(0.36, 0.48, 0.8));
    if (glm::length(p) > 24.0 || std::abs(d) > TissueMaps::kSurfaceReach_mm - 0.01) return;  // the plane ends with the box
    ASSERT_EQ(maps.surfaceKind[at], 1) << d;
    ASSERT_NEAR(distanceAt(maps, at), d, kHalfStep_mm + 0.005);
  });
}

TEST(TissueMaps, DrawASheetThatIsThinnerThanTheirVoxelsOnceAlongItsMiddle) {
  // 40 mm below a skin of 60 mm radius: from one side to the other the distance changes its sign, as a line that crosses it has to see.
  const auto made = mapped(recipeOf(R"({"name": "sheet", "tissue": "bright", "border": {"echo_level": 200, "width_mm": 0.4, "sheets": 2},
      "shape": {"sheets": {"of": "skin surface", "from_depth_mm": 40, "to_depth_mm": 41, "spacing_mm": 50, "thickness_mm": 0.3,
                           "undulation_mm": 0, "missing": 0}}})"));
  const TissueMaps& maps = *made.maps;
  ASSERT_EQ(maps.surfaces.size(), 1u);
  EXPECT_EQ(maps.surfaces[0].sheets, 2);
  int above = 0, below = 0;
  forEachVoxel(maps.grid, [&](std::size_t at, const glm::dvec3& p) {
    const double d = glm::length(p) - 20.0;
    if (std::abs(d) > 1.5 * kSpacing_mm) return;
    ASSERT_EQ(maps.surfaceKind[at], 1) << d;
    ASSERT_NEAR(distanceAt(maps, at), d, 0.3);  // the skin is kept on a grid, and 40 mm below it its distance is less exact
    ++(d > 0.0 ? above : below);
  });
  EXPECT_GT(above, 1000);
  EXPECT_GT(below, 1000);
}

TEST(TissueMaps, ChooseTheNearerOfTwoSurfaces) {
  const auto made = mapped(recipeOf(std::string(kBall) + R"(, {"name": "other", "tissue": "dark",
      "border": {"echo_level": 240, "width_mm": 1, "shine": "front"},
      "shape": {"ellipsoid": {"centre_mm": [0.3, -0.2, 18.1], "radii_mm": [4, 4, 4]}}})"));
  const TissueMaps& maps = *made.maps;
  ASSERT_EQ(maps.surfaces.size(), 2u);
  EXPECT_FALSE(maps.surfaces[0].frontOnly);
  EXPECT_TRUE(maps.surfaces[1].frontOnly);
  EXPECT_EQ(maps.surfaces[1].name, "other");
  forEachVoxel(maps.grid, [&](std::size_t at, const glm::dvec3& p) {
    const double first = glm::length(p - glm::dvec3(0.3, -0.2, 0.1)) - 12.0, second = glm::length(p - glm::dvec3(0.3, -0.2, 18.1)) - 4.0;
    const double nearer = std::min(std::abs(first), std::abs(second)), farther = std::max(std::abs(first), std::abs(second));
    if (nearer > 3.7 || farther - nearer < 0.3) return;
    ASSERT_EQ(maps.surfaceKind[at], std::abs(first) < std::abs(second) ? 1 : 2);
    ASSERT_NEAR(distanceAt(maps, at), std::abs(first) < std::abs(second) ? first : second, nearer < kSpacing_mm ? 0.05 : 0.25);
  });
}

TEST(TissueMaps, LeaveOutWhatAnOrganOfHigherPriorityCovers) {
  const auto made = mapped(recipeOf(std::string(kBall) + "," + kPlane));  // the plane runs through the ball
  const TissueMaps& maps = *made.maps;
  forEachVoxel(maps.grid, [&](std::size_t at, const glm::dvec3& p) {
    const glm::dvec3 normal(0.36, 0.48, 0.8), centre(0.3, -0.2, 0.1);
    const double plane = glm::dot(p - glm::dvec3(0, 0, 3.3), normal), ball = glm::length(p - centre) - 12.0;
    if (glm::length(p) > 24.0) return;
    if (ball < -5.0) {
      ASSERT_EQ(maps.surfaceKind[at], 0) << "the plane is drawn inside the ball, where nothing of it can be seen";
    }
    if (std::abs(plane) < 2.0 && ball > 5.0) {
      ASSERT_EQ(maps.surfaceKind[at], 2);
      ASSERT_NEAR(distanceAt(maps, at), plane, 0.03);
    }
  });
}

TEST(TissueMaps, TakeBoundariesWithoutBorderWhereImpedancesDiffer) {
  const auto made = mapped(recipeOf(
      R"({"name": "fat", "tissue": "fat", "shape": {"ellipsoid": {"centre_mm": [-12, 0, 0], "radii_mm": [8, 8, 8]}}},
         {"name": "hardly", "tissue": "like even", "shape": {"ellipsoid": {"centre_mm": [12, 0, 0], "radii_mm": [8, 8, 8]}}})"));
  const TissueMaps& maps = *made.maps;
  ASSERT_EQ(maps.surfaces.size(), 1u);
  EXPECT_EQ(maps.surfaces[0].name, "fat");
  // 2.7 times the reflection coefficient of 1.38 and 1.63 MRayl, over 60 dB.
  EXPECT_NEAR(maps.surfaces[0].echoLevel, 255.0 + 20.0 * std::log10(2.7 * 0.25 / 3.01) * 255.0 / 60.0, 0.01);
  forEachVoxel(maps.grid, [&](std::size_t at, const glm::dvec3& p) {
    const double d = glm::length(p - glm::dvec3(-12, 0, 0)) - 8.0;
    if (std::abs(d) < kSpacing_mm) {
      ASSERT_NEAR(distanceAt(maps, at), d, 0.05);
    }
    if (p.x > 0.0) {
      ASSERT_EQ(maps.surfaceKind[at], 0);
    }
  });
}

TEST(TissueMaps, DrawASurfaceThatTwoOrgansShareOnceWithItsBorder) {
  // A shell of fat around a ball of muscle: the fat comes first, the muscle has the border.
  const auto made = mapped(recipeOf(
      R"({"name": "fat", "tissue": "fat", "shape": {"difference": [{"ellipsoid": {"centre_mm": [0, 0, 0], "radii_mm": [20, 20, 20]}},
          {"ellipsoid": {"centre_mm": [0, 0, 0], "radii_mm": [14, 14, 14]}}]}},
         {"name": "muscle", "tissue": "even", "border": {"echo_level": 165, "width_mm": 1},
          "shape": {"ellipsoid": {"centre_mm": [0, 0, 0], "radii_mm": [14, 14, 14]}}})"));
  const TissueMaps& maps = *made.maps;
  forEachVoxel(maps.grid, [&](std::size_t at, const glm::dvec3& p) {
    const double d = glm::length(p) - 14.0;
    if (std::abs(d) > 2.5) return;
    ASSERT_EQ(maps.surfaces[maps.surfaceKind[at] - 1u].name, "muscle") << d;
    ASSERT_NEAR(distanceAt(maps, at), d, 0.1);
  });
}

TEST(TissueMaps, LetWallsOfVesselsShineOverAWiderAngle) {
  const auto made = mapped(recipeOf(R"({"name": "vessel", "tissue": "dark", "border": {"echo_level": 190, "width_mm": 2.2},
      "shape": {"tube": {"points": [[-20, 0, 0, 4], [20, 0, 0, 4]]}}})"));
  ASSERT_EQ(made.maps->surfaces.size(), 1u);
  EXPECT_EQ(made.maps->surfaces[0].fall_deg, 12.0);
}

TEST(TissueMaps, LetABorderSayHowItFallsAndHowRoughItIs) {
  const auto surfaceWith = [](const std::string& fields) {
    const auto made = mapped(recipeOf(R"({"name": "vessel", "tissue": "dark", "border": {"echo_level": 190, "width_mm": 0.3)" + fields +
                                      R"(}, "shape": {"tube": {"points": [[-20, 0, 0, 4], [20, 0, 0, 4]]}}})"));
    EXPECT_EQ(made.maps->surfaces.size(), 1u);
    return made.maps->surfaces.at(0);
  };
  const ReflectingSurface usual = surfaceWith(""), own = surfaceWith(R"(, "fall_deg": 16, "rough_db": -14.5)");
  EXPECT_EQ(usual.fall_deg, 12.0);
  EXPECT_EQ(usual.rough_db, -9.0);
  EXPECT_EQ(own.fall_deg, 16.0);
  EXPECT_EQ(own.rough_db, -14.5);
  EXPECT_EQ(surfaceWith(R"(, "rough_db": -3, "shine": "front")").fall_deg, 12.0) << "what is not said stays as it is";
  EXPECT_EQ(surfaceWith(R"(, "fall_deg": 25, "shine": "front")").rough_db, -13.0);
  ReflectingSurface same = own;
  same.fall_deg = usual.fall_deg;
  same.rough_db = usual.rough_db;
  EXPECT_EQ(same, usual) << "nothing else changes";
}

TEST(TissueMaps, GiveTheZeroCrossingToATenthOfAMillimetreWhenInterpolated) {
  const auto made = mapped(recipeOf(kBall));
  const TissueMaps& maps = *made.maps;
  const auto value = [&](const glm::dvec3& p) {
    const glm::dvec3 at = (p - maps.grid.origin_mm) / kSpacing_mm, low = glm::floor(at), t = at - low;
    double sum = 0.0;
    for (int c = 0; c < 8; ++c) {
      const glm::ivec3 step(c & 1, (c >> 1) & 1, c >> 2), corner = glm::ivec3(low) + step;
      const glm::dvec3 weight = glm::mix(1.0 - t, t, glm::dvec3(step));
      sum += weight.x * weight.y * weight.z * distanceAt(maps, maps.grid.indexOf(corner.x, corner.y, corner.z));
    }
    return sum;
  };
  for (int n = 0; n < 500; ++n) {
    const double z = -1.0 + (2.0 * n + 1.0) / 500.0, around = 2.399963 * n, radius = std::sqrt(1.0 - z * z);
    const glm::dvec3 direction(radius * std::cos(around), radius * std::sin(around), z);
    ASSERT_NEAR(value(glm::dvec3(0.3, -0.2, 0.1) + 12.0 * direction), 0.0, 0.1);
  }
}

TEST(TissueMaps, AreTheSameOnOneTwoAndEightThreads) {
  const std::string recipe = recipeOf(std::string(kBall) + "," + kPlane);
  const auto one = mapped(recipe, kSpacing_mm, 1);
  EXPECT_EQ(*one.maps, *mapped(recipe, kSpacing_mm, 2).maps);
  EXPECT_EQ(*one.maps, *mapped(recipe, kSpacing_mm, 8).maps);
}

TEST(TissueMaps, AreStoppedWithinAPieceOfWorkAtAnyQuestion) {
  const auto patient = patientOf(recipeOf(std::string(kBall) + "," + kPlane));
  const VoxeliseOptions options{.spacing_mm = 1.0, .threads = 1, .maps = true};
  auto counting = test::CountedStop::never();
  ASSERT_TRUE(voxelise(**patient, options, counting));
  for (const double share : {0.02, 0.5, 0.9, 0.99}) {
    auto stop = test::CountedStop::atQuestion(1 + static_cast<long>(share * static_cast<double>(counting.questions())));
    const auto made = voxelise(**patient, options, stop);
    ASSERT_FALSE(made) << share;
    EXPECT_EQ(made.error().code, ErrorCode::cancelled);
    EXPECT_LE(stop.questionsAfter(), test::kMostQuestionsAfter) << share;
    EXPECT_LE(stop.reportsAfter(), test::kMostReportsAfter) << share;
  }
}

TEST(TissueMaps, CountIntoTheForecastOfMemory) {
  const auto patient = patientOf(recipeOf(kBall));
  const double without = voxeliseForecast_bytes(**patient, 0.8), with = voxeliseForecast_bytes(**patient, 0.8, true);
  EXPECT_GT(with, 2.0 * without);
  const auto made =
      voxelise(**patient, {.spacing_mm = 0.8, .maxBytes = static_cast<std::uint64_t>(0.5 * (with + without)), .maps = true}, noProgress());
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, ErrorCode::tooLarge);
}

TEST(TissueMaps, OfAShippedPatientKnowItsOrgans) {
  const auto patient = readPatient(shippedPatient());
  ASSERT_TRUE(patient) << patient.error();
  const auto made = voxelise(**patient, {.spacing_mm = 2.0, .maps = true}, noProgress());
  ASSERT_TRUE(made) << made.error();
  const TissueMaps& maps = *made->maps;
  for (const char* name : {"liver", "gall stone", "aorta", "ribs 8"})
    EXPECT_TRUE(std::any_of(maps.surfaces.begin(), maps.surfaces.end(), [&](const auto& surface) { return surface.name == name; })) << name;
  std::size_t near = 0, inside = 0;
  for (std::size_t at = 0; at < maps.level.size(); ++at) {
    near += maps.surfaceKind[at] != 0 ? 1u : 0u;
    inside += maps.level[at] != 0 ? 1u : 0u;
    ASSERT_LE(maps.surfaceKind[at], maps.surfaces.size());
    ASSERT_EQ(maps.surfaceKind[at] == 0, maps.surfaceDistance[at] == 0);
  }
  EXPECT_GT(near, maps.level.size() / 10);
  EXPECT_GT(inside, maps.level.size() / 2);
}

}  // namespace
}  // namespace ew::tissue_maps_test
