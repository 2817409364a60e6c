#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <regex>
#include <sstream>

#include "ew/acquisition/reconstruct.h"
#include "ew/io/sweep.h"
#include "ew/registration/elastic.h"
#include "ew/registration/rigid.h"
#include "graphs.h"
#include "recordings.h"

/// Two recordings of one thing with given poses. The poses of the second are put wrong, frame by frame, before it becomes a volume; the
/// images alone have to find the given ones again.
namespace real_pairs_test {
namespace {

using namespace ew;
using namespace ew::registration;
using registration::test::Draw;
using registration::test::moved;

/// A recording with its given poses.
struct Recording {
  Sequence sequence;
  SweepPoses poses;

  /// The volume of these frames when every pose is `off` after the given one.
  [[nodiscard]] Volume volume(const Transform<frame::Moving, frame::World>& off, double spacing_mm) const {
    std::vector<TrackedFrame> frames;
    for (std::size_t n = 0; n < poses.imageToWorld.size(); ++n)
      if (poses.imageToWorld[n])
        frames.push_back({{sequence.framePixels(n).data(), sequence.width, sequence.height, sequence.width},
                          renamed<frame::World, frame::Image>(off * *poses.imageToWorld[n])});
    auto made = reconstruct(frames, {.spacing_mm = spacing_mm, .fillReach_mm = 2.0, .threads = 1}, noProgress());
    if (!made) {
      ADD_FAILURE() << made.error();
      return {};
    }
    return std::move(made->volume);
  }
};

Recording recordingOf(const std::filesystem::path& file, const std::filesystem::path& calibration = {}) {
  auto sequence = readSequence(file);
  if (!sequence) {
    ADD_FAILURE() << sequence.error();
    return {};
  }
  DeviceSet set;
  if (!calibration.empty()) set = readDeviceSet(calibration).value_or(DeviceSet{});
  auto poses = sweepPoses(*sequence, calibration.empty() ? nullptr : &set);
  if (!poses) {
    ADD_FAILURE() << poses.error();
    return {};
  }
  return {*std::move(sequence), *std::move(poses)};
}

/// The n-th wrong pose: 5, 10, 15 or 20 mm and 3.75 degrees for each 5 mm, along and about axes drawn by lot.
struct Wrong {
  double mm = 0.0;
  double deg = 0.0;
  Transform<frame::Moving, frame::World> off = {};
};
Wrong wrongPose(int n, const glm::dvec3& about_mm) {
  Draw draw(1000 + static_cast<std::uint64_t>(n));
  Wrong wrong{.mm = 5.0 * (n % 4 + 1), .deg = 3.75 * (n % 4 + 1)};
  const glm::dvec3 along = glm::normalize(draw.vector(1.0));
  const glm::dvec3 axis = glm::normalize(draw.vector(1.0));
  wrong.off = renamed<frame::Moving, frame::World>(moved<frame::World>(about_mm, wrong.mm * along, glm::radians(wrong.deg) * axis));
  return wrong;
}

/// What became of many wrong poses.
struct Tally {
  int found = 0;
  int undecided = 0;
  int wronglyAligned = 0;
  double worstMean_mm = 0.0;
  double worst_mm = 0.0;
};

/// How far the found pose takes places (mm of the given world) from where the given poses have them.
void count(const char* how, const Wrong& wrong, const RigidResult& result, const std::vector<glm::dvec3>& places, double goal_mm,
           Tally& tally) {
  const auto back = inverse(result.fixedToMoving) * wrong.off;
  double mean = 0.0, worst = 0.0;
  for (const glm::dvec3& p : places) {
    const double apart = glm::length(carried(back, p) - p);
    mean += apart / static_cast<double>(places.size());
    worst = std::max(worst, apart);
  }
  std::printf("%s, %4.1f mm and %5.2f degrees off: %s, %.2f mm (worst place %.2f)\n", how, wrong.mm, wrong.deg, nameOf(result.verdict),
              mean, worst);
  if (result.verdict != Verdict::aligned) {
    ++tally.undecided;
    EXPECT_FALSE(result.reason.empty());
    std::printf("  %s\n", result.reason.english().c_str());
  } else if (mean > goal_mm) {
    ++tally.wronglyAligned;
  } else {
    ++tally.found;
    tally.worstMean_mm = std::max(tally.worstMean_mm, mean);
    tally.worst_mm = std::max(tally.worst_mm, worst);
  }
}

PartialOptions oneThread() {
  PartialOptions options;
  options.threads = options.refine.threads = 1;
  return options;
}

std::string textOf(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

/// Wires of the phantom, and where recording B shows them.
struct Wires {
  struct Wire {
    std::string name;
    glm::dvec3 front_mm{0.0}, back_mm{0.0};  ///< phantom
  };
  struct Seen {
    std::size_t wire = 0;
    glm::dvec3 at_mm{0.0};  ///< in the world, by the given poses
  };
  std::vector<Wire> wires;
  std::vector<Seen> seen;
  glm::dmat4 worldToPhantom{1.0};

  [[nodiscard]] double distance_mm(const glm::dvec3& world_mm, std::size_t wire) const {
    const glm::dvec3 p(worldToPhantom * glm::dvec4(world_mm, 1.0));
    const glm::dvec3 along = glm::normalize(wires[wire].back_mm - wires[wire].front_mm);
    const glm::dvec3 from = p - wires[wire].front_mm;
    return glm::length(from - glm::dot(from, along) * along);
  }
  [[nodiscard]] double median_mm(const Transform<frame::Fixed, frame::World>& correction) const {
    std::vector<double> all;
    for (const Seen& point : seen) all.push_back(distance_mm(carried(correction, point.at_mm), point.wire));
    std::nth_element(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2), all.end());
    return all[all.size() / 2];
  }
};

Wires wiresOf(const std::filesystem::path& folder, const Recording& b) {
  Wires wires;
  const auto setFile = folder / "PlusDeviceSet_fCal_Sim_SpatialCalibration_2.0.xml";
  const std::string phantom = textOf(setFile);
  const std::regex wire(R"rx(Wire Name="([^"]+)"\s+EndPointFront="([^"]+)"\s+EndPointBack="([^"]+)")rx");
  const auto point = [](const std::string& text) {
    std::istringstream in(text);
    glm::dvec3 p(0.0);
    in >> p.x >> p.y >> p.z;
    return p;
  };
  for (std::sregex_iterator it(phantom.begin(), phantom.end(), wire), end; it != end; ++it)
    wires.wires.push_back({(*it)[1], point((*it)[2]), point((*it)[3])});
  const auto set = readDeviceSet(setFile);
  if (set)
    for (const auto& transform : set->transforms)
      if (transform.from == "Phantom" && transform.to == "Reference") wires.worldToPhantom = glm::inverse(transform.matrix);
  // Segmented by PLUS, frame by frame; the second recording is what it calls validation data.
  const std::string all = textOf(folder / "FreehandCalibration3NWires_fCal2.0.results.xml");
  const std::size_t begin = all.find("<ValidationData>");
  const std::string section = all.substr(begin, all.find("</ValidationData>") - begin);
  const std::regex item(R"rx(<Frame Index="(\d+)"|<Point WireName="([^"]+)" Position="([^"]+)"|(</SegmentedPoints>))rx");
  constexpr std::size_t kNone = ~std::size_t{0};
  std::size_t frame = kNone;
  for (std::sregex_iterator it(section.begin(), section.end(), item), end; it != end; ++it) {
    if ((*it)[1].matched) frame = std::stoul((*it)[1]);
    if ((*it)[4].matched) frame = kNone;  // what follows are the same points over again
    if (!(*it)[2].matched || frame >= b.poses.imageToWorld.size() || !b.poses.imageToWorld[frame]) continue;
    for (std::size_t w = 0; w < wires.wires.size(); ++w)
      if (wires.wires[w].name == (*it)[2])
        wires.seen.push_back({w, (*b.poses.imageToWorld[frame] * Point<frame::Image>{point((*it)[3])}).at});
  }
  return wires;
}

TEST(RealPairs, WiresAreFoundAgainFromWrongPosesAndWithoutAny) {
  EW_NEEDS_RECORDING("wire-phantom-pair");
  const auto folder = ew::test::recording("wire-phantom-pair");
  const auto calibration = folder / "FreehandCalibration3NWires_fCal2.0.results.xml";
  const Recording a = recordingOf(folder / "fCal_Test_Calibration_3NWires_fCal2.0.igs.mha", calibration);
  const Recording b = recordingOf(folder / "fCal_Test_Validation_3NWires_fCal2.0.igs.mha", calibration);
  const Wires wires = wiresOf(folder, b);
  ASSERT_EQ(wires.wires.size(), 9u);
  ASSERT_EQ(wires.seen.size(), 927u);
  const double given_mm = wires.median_mm({});
  EXPECT_LT(given_mm, 0.5);  // what tracker, calibration and segmentation are off by
  std::vector<glm::dvec3> places;
  glm::dvec3 middle(0.0);
  for (const auto& point : wires.seen) {
    places.push_back(point.at_mm);
    middle += point.at_mm / static_cast<double>(wires.seen.size());
  }
  const Volume fixed = a.volume({}, 0.4);
  constexpr int kWrong = 20;
  Tally refined, searched, alone;
  double worstMedian_mm = 0.0;
  for (int n = 0; n < kWrong; ++n) {
    const Wrong wrong = wrongPose(n, middle);
    const Volume moving = b.volume(wrong.off, 0.4);
    const auto from = refineRigid({&fixed}, {&moving}, {}, {.threads = 1}, noProgress());
    const auto about = refineRigid({&fixed}, {&moving}, {}, {.searchRotation_deg = 20.0, .threads = 1}, noProgress());
    const auto without = matchPartial({&fixed}, {&moving}, oneThread(), noProgress());
    ASSERT_TRUE(from && about && without);
    count("descending", wrong, *from, places, 1.0, alone);
    count("descending, then searching", wrong, *about, places, 1.0, refined);
    count("poses thrown away", wrong, without->best, places, 1.0, searched);
    for (const RigidResult* result : {&*about, &without->best})
      if (result->verdict == Verdict::aligned)
        worstMedian_mm = std::max(worstMedian_mm, wires.median_mm(inverse(result->fixedToMoving) * wrong.off));
  }
  std::printf(
      "wires: given poses %.2f mm from them (median), found ones at most %.2f; of %d: descending %d found, %d undecided; then searching "
      "%d, %d; thrown away %d, %d; at the wires at most %.2f mm from the given poses (worst point %.2f)\n",
      given_mm, worstMedian_mm, kWrong, alone.found, alone.undecided, refined.found, refined.undecided, searched.found, searched.undecided,
      std::max(refined.worstMean_mm, searched.worstMean_mm), std::max(refined.worst_mm, searched.worst_mm));
  EXPECT_EQ(alone.wronglyAligned + refined.wronglyAligned + searched.wronglyAligned, 0);
  EXPECT_EQ(refined.found, kWrong);
  EXPECT_EQ(searched.found, kWrong);
  EXPECT_LT(std::max(refined.worst_mm, searched.worst_mm), 1.0);
  EXPECT_LT(worstMedian_mm, given_mm + 0.3);
}

TEST(RealPairs, SimulatedLiverSweepsAreFoundAgainThoughTheirShadowsTurn) {
  EW_NEEDS_RECORDING("simulated-liver-pair");
  const auto folder = ew::test::recording("simulated-liver-pair");
  const Recording a = recordingOf(folder / "liver_sim_l2.igs.mha");
  const Recording b = recordingOf(folder / "liver_sim_r2.igs.mha");
  const Volume fixed = a.volume({}, 0.8);
  const Volume given = b.volume({}, 3.0);
  std::vector<glm::dvec3> places;
  glm::dvec3 middle(0.0);
  for (int k = 0; k < given.grid.dims.z; k += 3)
    for (int j = 0; j < given.grid.dims.y; j += 3)
      for (int i = 0; i < given.grid.dims.x; i += 3)
        if (given.coverageAt(given.grid.indexOf(i, j, k)) != Coverage::absent)
          places.push_back((given.grid.voxelToWorld() * Point<frame::Voxel>{glm::dvec3(i, j, k)}).at);
  for (const auto& p : places) middle += p / static_cast<double>(places.size());
#ifdef EW_SLOW_TESTS
  constexpr int kWrong = 20;
#else
  constexpr int kWrong = 6;  // nine seconds of processor time each
#endif
  Tally refined, searched;
  for (int n = 0; n < kWrong; ++n) {
    const Wrong wrong = wrongPose(n, middle);
    const Volume moving = b.volume(wrong.off, 0.8);
    const auto about = refineRigid({&fixed}, {&moving}, {}, {.searchRotation_deg = 20.0, .threads = 1}, noProgress());
    const auto without = matchPartial({&fixed}, {&moving}, oneThread(), noProgress());
    ASSERT_TRUE(about && without);
    count("descending, then searching", wrong, *about, places, 1.0, refined);
    count("poses thrown away", wrong, without->best, places, 1.0, searched);
  }
  std::printf(
      "simulated liver: of %d, descending, then searching: %d found, %d undecided; thrown away: %d found, %d undecided; at most %.2f mm "
      "from "
      "the given poses (worst place %.2f)\n",
      kWrong, refined.found, refined.undecided, searched.found, searched.undecided, std::max(refined.worstMean_mm, searched.worstMean_mm),
      std::max(refined.worst_mm, searched.worst_mm));
  EXPECT_EQ(refined.wronglyAligned + searched.wronglyAligned, 0);
  EXPECT_EQ(refined.found, kWrong);
  EXPECT_EQ(searched.found, kWrong);
}

TEST(RealPairs, SimulatedLiverSweepsAreHardlyBentThoughTheirShadowsTurn) {
  EW_NEEDS_RECORDING("simulated-liver-pair");
  const auto folder = ew::test::recording("simulated-liver-pair");
  const Volume fixed = recordingOf(folder / "liver_sim_l2.igs.mha").volume({}, 0.8);
  const Volume moving = recordingOf(folder / "liver_sim_r2.igs.mha").volume({}, 0.8);
  const auto found = registerElastic({&fixed}, {&moving}, {}, {.threads = 2}, noProgress());
  ASSERT_TRUE(found);
  std::vector<double> warped_mm;
  for (std::size_t n = 0; n < fixed.echo.size(); n += 7) {
    if (fixed.coverageAt(n) == Coverage::absent) continue;
    const int row = fixed.grid.dims.x, slice = row * fixed.grid.dims.y, at = static_cast<int>(n);
    const glm::dvec3 p = (fixed.grid.voxelToWorld() * Point<frame::Voxel>{glm::dvec3(at % row, at % slice / row, at / slice)}).at;
    warped_mm.push_back(glm::distance(movingPoint(found->fixedToMoving, p), p));
  }
  std::sort(warped_mm.begin(), warped_mm.end());
  const double mean_mm = std::accumulate(warped_mm.begin(), warped_mm.end(), 0.0) / static_cast<double>(warped_mm.size());
  const double p95_mm = warped_mm[warped_mm.size() * 95 / 100];
  std::printf("simulated liver at its exact poses: bent by %.2f mm in the mean, %.2f mm at 95 %%; %s\n", mean_mm, p95_mm,
              found->reason.english().c_str());
  EXPECT_EQ(found->verdict, Verdict::aligned) << found->reason;
  EXPECT_LT(mean_mm, 0.6);  // 3.9 and 11 mm when shadows are left in
  EXPECT_LT(p95_mm, 1.2);
}

}  // namespace
}  // namespace real_pairs_test
