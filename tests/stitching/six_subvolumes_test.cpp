#include <gtest/gtest.h>
#include <sys/resource.h>

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "ew/core/memory_watch.h"
#include "ew/io/image_file.h"
#include "ew/io/safe_file.h"
#include "ew/io/volume_file.h"
#include "ew/stitching/chain.h"
#include "library/temporary_folder.h"
#include "places.h"
#include "six_subvolumes/recordings.h"

namespace ew::stitching::six_subvolumes_test {
namespace {

namespace fs = std::filesystem;
const fs::path kSource(EW_SOURCE_DIR);
constexpr double kDbPerGrey = 60.0 / 255.0;

/// Recordings, results and images go to EW_SIX_SUBVOLUMES, and stay there; without it to a folder that is removed.
class Home {
 public:
  explicit Home(const std::string& name) {
    const char* asked = std::getenv("EW_SIX_SUBVOLUMES");
    if (asked == nullptr)
      temporary_.emplace();
    else
      fs::create_directories(fs::path(asked) / name);
    path_ = asked == nullptr ? temporary_->path() : fs::path(asked) / name;
  }
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  std::optional<test::TemporaryFolder> temporary_;
  fs::path path_;
};

double processorSeconds() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  const auto seconds = [](const timeval& t) { return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec); };
  return seconds(used.ru_utime) + seconds(used.ru_stime);
}

struct Spread {
  std::vector<double> values;
  void add(double value) { values.push_back(value); }
  [[nodiscard]] double mean() const {
    double sum = 0.0;
    for (const double each : values) sum += each;
    return values.empty() ? 0.0 : sum / static_cast<double>(values.size());
  }
  [[nodiscard]] double at(double share) {
    if (values.empty()) return 0.0;
    const auto place = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), place, values.end());
    return *place;
  }
};

/// What was found, and what is true about it.
class Judge {
 public:
  Judge(const test::SixRecordings& truth, const ChainState& state) : truth_(truth), state_(state) {
    for (std::size_t v = 0; v < test::SixRecordings::kViews; ++v) toWorld_.push_back(state.graph->toWorld[v]);
  }

  /// Mean distance over what a view covers between its place and another one, both seen from the first view.
  [[nodiscard]] double apart_mm(std::size_t view, const std::vector<Transform<frame::World, frame::View>>& places) const {
    const auto found = inverse(toWorld_[0]) * toWorld_[view];
    const auto meant = inverse(places[0]) * places[view];
    Spread apart;
    forEachSample(view, [&](const glm::dvec3& p) { apart.add(glm::distance(carried(found, p), carried(meant, p))); });
    return apart.mean();
  }

  /// Where the probes were.
  [[nodiscard]] std::vector<Transform<frame::World, frame::View>> ofProbes() const {
    std::vector<Transform<frame::World, frame::View>> places;
    for (std::size_t v = 0; v < toWorld_.size(); ++v) places.push_back(inverse(truth_.fromWorld(v)));
    return places;
  }

  /// The rigid places that bring the same tissue together best, which is not where the probes were: each view pressed it another way.
  [[nodiscard]] std::vector<Transform<frame::World, frame::View>> ofTissue() const {
    auto places = ofProbes();
    struct Meeting {
      std::size_t f, m;
      std::vector<glm::dvec3> inFixed, inMoving;
    };
    std::vector<Meeting> meetings;
    for (std::size_t f = 0; f < places.size(); ++f)
      for (std::size_t m = f + 1; m < places.size(); ++m) {
        Meeting meeting{f, m, {}, {}};
        forEachSample(f, [&](const glm::dvec3& p) {
          const glm::dvec3 there = truth_.shownAt(m, truth_.tissueAt(f, p));
          if (!covered(m, there)) return;
          meeting.inFixed.push_back(p);
          meeting.inMoving.push_back(there);
        });
        if (!meeting.inFixed.empty()) meetings.push_back(std::move(meeting));
      }
    for (int round = 0; round < 60; ++round)
      for (std::size_t v = 1; v < places.size(); ++v) {
        std::vector<glm::dvec3> own, others;
        for (const Meeting& meeting : meetings) {
          if (meeting.f != v && meeting.m != v) continue;
          const bool fixed = meeting.f == v;
          const auto& mine = fixed ? meeting.inFixed : meeting.inMoving;
          const auto& theirs = fixed ? meeting.inMoving : meeting.inFixed;
          for (std::size_t n = 0; n < mine.size(); ++n) {
            own.push_back(mine[n]);
            others.push_back(carried(places[fixed ? meeting.m : meeting.f], theirs[n]));
          }
        }
        places[v] = fitted(own, others);
      }
    return places;
  }

  /// How far apart the same tissue lies in two views of the result: mean and 95th percentile.
  [[nodiscard]] std::pair<double, double> tissueApart_mm(bool warped) const {
    Spread apart;
    const Grid& grid = state_.report->grid;
    for (int k = 0; k < grid.dims.z; k += 6)
      for (int j = 0; j < grid.dims.y; j += 6)
        for (int i = 0; i < grid.dims.x; i += 6) {
          const glm::dvec3 p = carried(grid.voxelToWorld(), glm::dvec3(i, j, k));
          std::vector<glm::dvec3> tissue;
          for (std::size_t v = 0; v < toWorld_.size(); ++v) {
            glm::dvec3 at = p;
            if (warped && v < state_.warps.size() && !state_.warps[v].displacement_mm.empty())
              at += registration::displacementAt(state_.warps[v], p);
            const glm::dvec3 own = carried(inverse(toWorld_[v]), at);
            if (covered(v, own)) tissue.push_back(truth_.tissueAt(v, own));
          }
          for (std::size_t a = 0; a < tissue.size(); ++a)
            for (std::size_t b = 0; b < a; ++b) apart.add(glm::distance(tissue[a], tissue[b]));
        }
    const double mean = apart.mean();
    return {mean, apart.at(0.95)};
  }

 private:
  template <class Take>
  void forEachSample(std::size_t view, const Take& take) const {
    const Volume& volume = *state_.volumes[view];
    constexpr int kStep = 8;
    for (int k = 0; k < volume.grid.dims.z; k += kStep)
      for (int j = 0; j < volume.grid.dims.y; j += kStep)
        for (int i = 0; i < volume.grid.dims.x; i += kStep)
          if (volume.coverageAt(volume.grid.indexOf(i, j, k)) != Coverage::absent)
            take(carried(volume.grid.voxelToWorld(), glm::dvec3(i, j, k)));
  }
  [[nodiscard]] bool covered(std::size_t view, const glm::dvec3& p) const {
    const Volume& volume = *state_.volumes[view];
    const glm::ivec3 voxel(glm::floor(carried(volume.grid.worldToVoxel(), p) + 0.5));
    return volume.grid.contains(voxel) && volume.coverageAt(volume.grid.indexOf(voxel.x, voxel.y, voxel.z)) != Coverage::absent;
  }
  static Transform<frame::World, frame::View> fitted(const std::vector<glm::dvec3>& from, const std::vector<glm::dvec3>& to) {
    Eigen::Matrix3Xd a(3, static_cast<Eigen::Index>(from.size())), b(3, static_cast<Eigen::Index>(to.size()));
    for (std::size_t n = 0; n < from.size(); ++n) {
      a.col(static_cast<Eigen::Index>(n)) << from[n].x, from[n].y, from[n].z;
      b.col(static_cast<Eigen::Index>(n)) << to[n].x, to[n].y, to[n].z;
    }
    const Eigen::Matrix4d found = Eigen::umeyama(a, b, false);
    Transform<frame::World, frame::View> out;
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 4; ++c) out.matrix[c][r] = found(r, c);
    return out;
  }

  const test::SixRecordings& truth_;
  const ChainState& state_;
  std::vector<Transform<frame::World, frame::View>> toWorld_;
};

/// How far each view's voxels are to be trusted, as the chain kept it.
std::vector<std::vector<std::uint8_t>> confidencesOf(const ChainState& state, const fs::path& out) {
  std::vector<std::vector<std::uint8_t>> found(state.volumes.size());
  for (const auto& entry : fs::directory_iterator(out / "steps/reconstruct")) {
    const std::string name = entry.path().filename().string();
    if (!name.ends_with("-confidence.mha")) continue;
    const std::string volumeName = name.substr(0, name.size() - std::string("confidence.mha").size()) + "volume.mha";
    const auto volume = readVolume(entry.path().parent_path() / volumeName, noProgress());
    if (!volume) continue;
    for (std::size_t v = 0; v < found.size(); ++v)
      if (state.volumes[v]->echo == volume->volume.echo)
        if (auto read = readConfidence(volume->volume.grid, entry.path(), noProgress())) found[v] = std::move(*read);
  }
  return found;
}

std::vector<View> viewsOf(const ChainState& state, const std::vector<std::vector<std::uint8_t>>& confidences) {
  std::vector<View> views;
  for (std::size_t v = 0; v < state.volumes.size(); ++v) {
    View view;
    view.volume = state.volumes[v].get();
    view.confidence = confidences[v];
    view.toWorld = state.graph->toWorld[v];
    if (!state.warps[v].displacement_mm.empty()) view.warp = &state.warps[v];
    view.correction = state.corrections[v];
    view.name = std::to_string(v);
    views.push_back(view);
  }
  return views;
}

struct Shadows {
  double share = 0.0;        ///< of the overlap where one view is in its shadow and another sees
  double filledShare = 0.0;  ///< of these the share that a seeing view fills
};

/// Shadows of one view that another one sees into: whether the result takes the one that sees.
Shadows shadowsOf(const std::vector<View>& views, const Grid& grid, std::span<const std::uint8_t> source) {
  std::vector<std::vector<std::uint8_t>> trust;
  std::size_t overlap = 0, shadowed = 0, filled = 0;
  std::vector<double> seen(views.size());
  for (int k = 2; k < grid.dims.z; k += 5)
    for (int j = 2; j < grid.dims.y; j += 5)
      for (int i = 2; i < grid.dims.x; i += 5) {
        const glm::dvec3 p = carried(grid.voxelToWorld(), glm::dvec3(i, j, k));
        double least = 2.0, most = -1.0;
        int covering = 0;
        for (std::size_t v = 0; v < views.size(); ++v) {
          seen[v] = -1.0;
          const Volume& volume = *views[v].volume;
          glm::dvec3 at = p;
          if (views[v].warp != nullptr) at += registration::displacementAt(*views[v].warp, p);
          const auto toVoxel = volume.grid.toVoxel<frame::View>() * inverse(views[v].toWorld);
          const glm::ivec3 voxel(glm::floor(carried(toVoxel, at) + 0.5));
          if (!volume.grid.contains(voxel)) continue;
          const std::size_t index = volume.grid.indexOf(voxel.x, voxel.y, voxel.z);
          if (volume.coverageAt(index) == Coverage::absent) continue;
          ++covering;
          seen[v] = views[v].confidence[index] / 255.0;
          least = std::min(least, seen[v]);
          most = std::max(most, seen[v]);
        }
        if (covering < 2) continue;
        ++overlap;
        if (least > 0.3 || most < 0.8) continue;
        ++shadowed;
        const std::uint8_t taken = source[grid.indexOf(i, j, k)];
        if (taken > 0 && seen[taken - 1u] > 0.5) ++filled;
      }
  Shadows shadows;
  if (overlap > 0) shadows.share = static_cast<double>(shadowed) / static_cast<double>(overlap);
  if (shadowed > 0) shadows.filledShare = static_cast<double>(filled) / static_cast<double>(shadowed);
  return shadows;
}

/// Planes through the result, one voxel a pixel: across the sweeps, along them, and level.
void drawPlanes(const Volume& volume, const glm::ivec3& middle, const std::string& name, const fs::path& folder) {
  const Grid& grid = volume.grid;
  const std::array<std::array<int, 3>, 3> planes{{{0, 1, 2}, {2, 1, 0}, {0, 2, 1}}};
  const std::array<const char*, 3> names{"across", "along", "level"};
  for (std::size_t n = 0; n < planes.size(); ++n) {
    GreyImage image;
    image.width = grid.dims[planes[n][0]];
    image.height = grid.dims[planes[n][1]];
    image.pixels.resize(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
    glm::ivec3 at = middle;
    std::size_t pixel = 0;
    for (at[planes[n][1]] = 0; at[planes[n][1]] < image.height; ++at[planes[n][1]])
      for (at[planes[n][0]] = 0; at[planes[n][0]] < image.width; ++at[planes[n][0]])
        image.pixels[pixel++] = volume.echo[grid.indexOf(at.x, at.y, at.z)];
    ASSERT_TRUE(writeImage(viewOf(std::as_const(image)), grid.spacing_mm.x, folder / (name + "-" + names[n] + ".png")));
  }
}

void printVisibility(const char* what, const SeamVisibility& seam) {
  std::cout << what << ": derivative " << seam.derivativeRatio << ", speckle " << seam.speckleRatio << ", step " << seam.meanStep_db
            << " dB, " << seam.voxels << " voxels beside\n";
}

struct Asked {
  const char* project = "";
  bool outOfFrame = false;
};

void runAndJudge(const Asked& asked) {
  const Home home(asked.project);
  test::SixRecordings truth;
  truth.make(home.path(), asked.outOfFrame);
  if (testing::Test::HasFatalFailure()) return;
  const auto text = readTextFile(kSource / "tests/stitching/six_subvolumes" / (std::string(asked.project) + ".json"));
  ASSERT_TRUE(text);
  auto project = parseProject(*text, home.path());
  ASSERT_TRUE(project) << project.error();
  const fs::path out = home.path() / "out";
  ChainOptions options;
  options.threads = 2;

  options.keepVolumes = false;
  MemoryWatch memory;
  double forecast_mib = 0.0, peak_mib = 0.0;
  double wall_s = 0.0, processor_s = processorSeconds();
  const double begun_s = processor_s;
  bool anyReused = false;
  options.onStep = [&](const StepOutcome& outcome) {
    const double worked = processorSeconds() - processor_s;
    processor_s += worked;
    wall_s += outcome.seconds;
    const double stepForecast_mib = static_cast<double>(outcome.forecast_bytes) / (1024.0 * 1024.0);
    const double stepPeak_mib = memory.peak_mib();
    forecast_mib = std::max(forecast_mib, stepForecast_mib);
    if (!outcome.reused) peak_mib = std::max(peak_mib, stepPeak_mib);
    std::cout << nameOf(outcome.step) << ": " << outcome.seconds << " s, processor " << worked << " s" << (outcome.reused ? ", reused" : "")
              << ", forecast " << stepForecast_mib << " MiB, peak " << stepPeak_mib << " MiB, afterwards " << memory.now_mib() << " MiB"
              << std::endl;
    if (memory.isKnown() && !outcome.reused) {
      EXPECT_GE(stepForecast_mib, stepPeak_mib) << nameOf(outcome.step);
    }
    anyReused = anyReused || outcome.reused;
    memory.forgetPeak();
  };
  auto state = runChain(*project, out, options, noProgress());
  ASSERT_TRUE(state) << state.error();
  processor_s -= begun_s;
  std::cout << "whole: " << wall_s << " s, processor " << processor_s << " s, forecast " << forecast_mib << " MiB, peak " << peak_mib
            << " MiB" << std::endl;
  if (memory.isKnown() && !anyReused) {
    EXPECT_LE(forecast_mib, 1.5 * peak_mib);
  }
  EXPECT_EQ(state->verdict, registration::Verdict::aligned) << state->reason;
  EXPECT_TRUE(state->leftOut.empty());
  for (const PairOutcome& pair : state->pairs)
    std::cout << "pair " << pair.fixed << " " << pair.moving << (pair.wrong ? " wrong" : "") << ": " << pair.rigid.reason << " ("
              << pair.rigid.seconds << " s)\n";

  options.keepVolumes = true;
  options.onStep = nullptr;
  state = runChain(*project, out, options, noProgress());  // what was found, with the volumes
  ASSERT_TRUE(state) << state.error();
  ASSERT_TRUE(state->report);
  const Judge judge(truth, *state);
  const auto probes = judge.ofProbes();
  const auto tissue = judge.ofTissue();
  for (std::size_t view = 1; view < test::SixRecordings::kViews; ++view) {
    const double fromTissue = judge.apart_mm(view, tissue);
    std::cout << "view " << view << ": " << judge.apart_mm(view, probes) << " mm from where the probe was, " << fromTissue
              << " mm from where the tissue lies\n";
    EXPECT_LT(fromTissue, 1.0) << view;
  }
  const auto [rigidMean, rigid95] = judge.tissueApart_mm(false);
  const auto [warpedMean, warped95] = judge.tissueApart_mm(true);
  std::cout << "tissue apart: rigid " << rigidMean << " (95 %: " << rigid95 << ") mm, bent " << warpedMean << " (95 %: " << warped95
            << ") mm\n";
  std::cout << "bends: largest " << state->warpSummary.largest_mm << " mm, Jacobian " << state->warpSummary.smallestJacobian
            << ", disagree " << state->warpSummary.disagreementMedian_mm << " / " << state->warpSummary.disagreement95_mm << " mm\n";
  EXPECT_GT(state->warpSummary.smallestJacobian, 0.1);

  const auto joined = readVolume(state->volume, noProgress());
  ASSERT_TRUE(joined);
  const auto source = readVolume(state->source, noProgress());
  ASSERT_TRUE(source);
  printVisibility("seam", state->report->seam);
  printVisibility("seam of the joined volume alone",
                  seamVisibility(joined->volume, source->volume.echo, project->settings.join.seam.blend_mm));
  EXPECT_NEAR(state->report->seam.derivativeRatio, 1.0, 0.05);
  EXPECT_NEAR(state->report->seam.speckleRatio, 1.0, 0.05);
  EXPECT_LT(std::abs(state->report->seam.meanStep_db), 0.5);
  const auto confidences = confidencesOf(*state, out);
  auto views = viewsOf(*state, confidences);
  const Shadows shadows = shadowsOf(views, joined->volume.grid, source->volume.echo);
  std::cout << "shadows that another view sees into: " << shadows.share << " of the overlap, filled " << shadows.filledShare << "\n";
  EXPECT_GT(shadows.filledShare, 0.9);

  // Before: pasted and feathered where the tracker said, grey levels as they came.
  const fs::path images = home.path() / "pictures";
  fs::create_directories(images);
  const glm::ivec3 middle = joined->volume.grid.dims / 2;
  drawPlanes(joined->volume, middle, "after", images);
  Volume labels = joined->volume;
  for (std::size_t n = 0; n < labels.echo.size(); ++n) labels.echo[n] = static_cast<std::uint8_t>(40 * source->volume.echo[n]);
  drawPlanes(labels, middle, "views", images);
  for (std::size_t v = 0; v < views.size(); ++v) {
    views[v].correction = {};
    views[v].warp = nullptr;
    if (!asked.outOfFrame) views[v].toWorld = project->volumes[v].toWorld;
  }
  JoinOptions plain = project->settings.join;
  plain.grid.threads = 2;
  for (const SeamMethod method : {SeamMethod::nearest, SeamMethod::feather}) {
    plain.seam.method = method;
    plain.seam.blend_mm = 0.0;
    const auto seams = findSeams(views, joined->volume.grid, plain.seam, noProgress());
    ASSERT_TRUE(seams) << seams.error();
    const auto made = join(views, *seams, joined->volume.grid, plain, noProgress());
    ASSERT_TRUE(made) << made.error();
    const bool pasted = method == SeamMethod::nearest;
    printVisibility(pasted ? "before, pasted" : "before, feathered", made->report.seam);
    drawPlanes(made->volume, middle, pasted ? "pasted" : "feathered", images);
  }
}

TEST(SixSubvolumes, BecomeOneFromRecordingsWithPerturbedPlaces) { runAndJudge({"tracker-perturbed", false}); }

TEST(SixSubvolumes, BecomeOneFromRecordingsWithoutATracker) { runAndJudge({"tracker-off", true}); }

}  // namespace
}  // namespace ew::stitching::six_subvolumes_test
