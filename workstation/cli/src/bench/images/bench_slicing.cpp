#include "bench/images/bench_slicing.h"

#include <benchmark/benchmark.h>
#include <vtkMultiThreader.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <memory>
#include <random>
#include <set>
#include <string>

#include "bench/tools/bench_parts.h"
#include "ew/core/simd.h"
#include "ew/core/word_table.h"
#include "ew/imaging/bands.h"
#include "ew/imaging/layout_times.h"
#include "ew/imaging/slicing.h"
#include "run/report.h"

namespace ew {
namespace {

using nlohmann::json;
using ImageToVoxel = Transform<frame::Voxel, frame::Image>;

struct SlicingScene {
  Volume volume;
  BrickVolume bricks;
  LayoutTimes times;  ///< by which the program chooses for each slice; each layout alone is shown beside it
  BenchField field;
  std::map<std::string, std::vector<ImageToVoxel>> poses;  // by kind
};

ImageToVoxel planeThrough(const glm::dvec3& middle_voxel, const glm::dquat& turn, int side) {
  const glm::dmat3 axes = glm::mat3_cast(turn);
  ImageToVoxel plane;
  for (int axis = 0; axis < 3; ++axis) plane.matrix[axis] = glm::dvec4(axes[axis], 0.0);
  plane.matrix[3] = glm::dvec4(middle_voxel - 0.5 * (side - 1) * (axes[0] + axes[1]), 1.0);
  return plane;
}

/// Random poses pass within a tenth of the volume's middle; smooth ones rock and slide like a hand, 30 to the second.
std::map<std::string, std::vector<ImageToVoxel>> posesFor(const BenchOptions& options, int volumeSide) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> offset(-0.1, 0.1);
  std::map<std::string, std::vector<ImageToVoxel>> poses;
  const glm::dvec3 middle(0.5 * (volumeSide - 1));
  for (int n = 0; n < options.poses; ++n) {
    const double w = normal(random), x = normal(random), y = normal(random), z = normal(random);
    const double dx = offset(random), dy = offset(random), dz = offset(random);
    const glm::dvec3 aside = glm::dvec3(dx, dy, dz) * static_cast<double>(volumeSide);
    poses["random"].push_back(planeThrough(middle + aside, glm::normalize(glm::dquat(w, x, y, z)), options.sliceSide));
    const double t = n / 30.0;
    const glm::dvec3 slide = 0.06 * volumeSide * glm::dvec3(std::sin(1.3 * t), std::sin(0.7 * t), std::cos(1.1 * t));
    poses["smooth"].push_back(planeThrough(middle + slide, rockingTurn(t), options.sliceSide));
  }
  return poses;
}

Result<std::unique_ptr<SlicingScene>> makeScene(const BenchOptions& options, int volumeSide, Progress& progress) {
  auto scene = std::make_unique<SlicingScene>(SlicingScene{{}, {}, {}, BenchField(volumeSide), posesFor(options, volumeSide)});
  auto volume = scene->field.volume(progress);
  if (!volume) return passOn(volume.error());
  scene->volume = std::move(*volume);
  auto bricks = bricksOf(scene->volume.view(), 1, 0, noProgress());
  if (!bricks) return passOn(bricks.error());
  scene->bricks = std::move(*bricks);
  scene->times = timeLayouts(scene->volume.view(), scene->bricks);
  return scene;
}

/// What an own slicer reads: what the program chooses for each slice, or one layout always.
enum class Read { chosen, rows, bricks };
constexpr WordTable<Read, 3> kReadWords{{{"chosen", Read::chosen}, {"rows", Read::rows}, {"bricks", Read::bricks}}};
const char* wordOf(Read read) { return wordIn(kReadWords, read); }

SliceSource sourceOf(const SlicingScene& scene, Read read) {
  const LayoutChoice choice = read == Read::chosen ? scene.times.choice() : read == Read::rows ? LayoutChoice() : LayoutChoice().set();
  return inBothLayouts(scene.volume.view(), scene.bricks, choice);
}

/// Whether the program reads a slice from bricks.
bool readsBricks(const SlicingScene& scene, Quality quality, const ImageToVoxel& plane) {
  return scene.times.choice().test(sliceClassOf(quality, glm::dvec3(plane.matrix[0]), glm::dvec3(plane.matrix[1])).index());
}

double bricksShare(const SlicingScene& scene, Quality quality, const std::vector<ImageToVoxel>& poses) {
  const auto fromBricks =
      std::count_if(poses.begin(), poses.end(), [&](const ImageToVoxel& plane) { return readsBricks(scene, quality, plane); });
  return static_cast<double>(fromBricks) / static_cast<double>(poses.size());
}

BenchSlicer ownSlicer(Quality quality, const SliceSource& source, int side) {
  struct State {
    SliceScratch scratch;
    GreyImage image;
  };
  auto state = std::make_shared<State>();
  state->image = GreyImage(side, side);
  return [state, source, quality](const ImageToVoxel& plane) {
    switch (quality) {
      case Quality::weave:
        sliceWeave(source, plane, viewOf(state->image), state->scratch);
        break;
      case Quality::linear:
        sliceLinear(source, plane, viewOf(state->image), state->scratch);
        break;
      case Quality::cubic:
        sliceCubic(source, plane, viewOf(state->image), state->scratch);
        break;
    }
    return static_cast<const std::uint8_t*>(state->image.pixels.data());
  };
}

struct SlicingCase {
  std::string name;  ///< "slice_400x400_of_256cubed/weave/random"
  std::string method;
  Quality quality = Quality::weave;
  bool peer = false;
  Read read = Read::rows;        ///< of a peer: rows
  double bricksShare = 0.0;      ///< of its slices
  std::size_t voxels_bytes = 0;  ///< that it reads from
  std::string poseKind;
  BenchSlicer slicer;
  std::vector<double> slices_us;       ///< every slice
  std::vector<double> repetitions_us;  ///< mean of each repetition
  double psnr_db = 0.0;                ///< against the analytic field
  double psnrDouble_db = 0.0;          ///< against the same interpolation of the same voxels in double precision; 0: equal
  double worst_grey = 0.0;
};

/// Nearest, trilinear or cubic (Keys, a = -1/2) in double precision, neighbours clamped to the volume.
double inDoublePrecision(Quality quality, const Volume& volume, const glm::dvec3& p_voxel) {
  const glm::ivec3 last = volume.grid.dims - 1;
  const auto voxel = [&](const glm::ivec3& at) {
    const glm::ivec3 there = glm::clamp(at, glm::ivec3(0), last);
    return static_cast<double>(volume.echo[volume.grid.indexOf(there.x, there.y, there.z)]);
  };
  if (quality == Quality::weave) return voxel(glm::ivec3(glm::floor(p_voxel + 0.5)));
  const auto weight = [quality](double distance) {
    const double s = std::abs(distance);
    if (quality == Quality::linear) return std::max(0.0, 1.0 - s);
    if (s < 1.0) return (1.5 * s - 2.5) * s * s + 1.0;
    return s < 2.0 ? ((-0.5 * s + 2.5) * s - 4.0) * s + 2.0 : 0.0;
  };
  const glm::ivec3 low(glm::floor(p_voxel));
  double sum = 0.0;
  for (int k = -1; k <= 2; ++k)
    for (int j = -1; j <= 2; ++j) {
      const double across = weight(p_voxel.y - (low.y + j)) * weight(p_voxel.z - (low.z + k));
      if (across == 0.0) continue;
      for (int i = -1; i <= 2; ++i) sum += across * weight(p_voxel.x - (low.x + i)) * voxel(low + glm::ivec3(i, j, k));
    }
  return std::clamp(sum, 0.0, 255.0);
}

double psnrOf(double squares, double count) { return squares > 0.0 ? 10.0 * std::log10(255.0 * 255.0 * count / squares) : 0.0; }

void measureError(SlicingCase& tested, const SlicingScene& scene, int side) {
  double squares = 0.0, squaresDouble = 0.0, count = 0.0;
  const glm::dvec3 last = glm::dvec3(scene.volume.grid.dims - 1);
  const auto& poses = scene.poses.at(tested.poseKind);
  const std::size_t step = std::max<std::size_t>(1, poses.size() / 8);  // eight poses hold a million pixels
  for (std::size_t n = 0; n < poses.size(); n += step) {
    const std::uint8_t* pixels = tested.slicer(poses[n]);
    for (int y = 0; y < side; y += 2)
      for (int x = 0; x < side; x += 2) {
        const glm::dvec3 p(poses[n].matrix * glm::dvec4(x, y, 0.0, 1.0));
        if (glm::any(glm::lessThan(p, glm::dvec3(0.0))) || glm::any(glm::greaterThan(p, last))) continue;
        const double error = pixels[static_cast<std::ptrdiff_t>(y) * side + x] - scene.field.at(p);
        squares += error * error;
        const double fromDouble = pixels[static_cast<std::ptrdiff_t>(y) * side + x] - inDoublePrecision(tested.quality, scene.volume, p);
        squaresDouble += fromDouble * fromDouble;
        count += 1.0;
        tested.worst_grey = std::max(tested.worst_grey, std::abs(error));
      }
  }
  tested.psnr_db = psnrOf(squares, count);
  tested.psnrDouble_db = psnrOf(squaresDouble, count);
}

/// Collects the mean of each repetition.
class Collector final : public benchmark::BenchmarkReporter {
 public:
  explicit Collector(std::map<std::string, SlicingCase*> cases) : cases_(std::move(cases)) {}
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      const auto found = cases_.find(run.run_name.function_name);
      if (found == cases_.end() || run.run_type != Run::RT_Iteration || run.error_occurred) continue;
      found->second->repetitions_us.push_back(run.GetAdjustedRealTime());
    }
  }

 private:
  std::map<std::string, SlicingCase*> cases_;
};

void timeCases(std::vector<SlicingCase>& cases, const SlicingScene& scene, const BenchOptions& options, Progress& progress) {
  std::map<std::string, SlicingCase*> byName;
  [[maybe_unused]] const double total = static_cast<double>(cases.size()) * options.repetitions;
  double done = 0.0;
  benchmark::ClearRegisteredBenchmarks();
  for (SlicingCase& tested : cases) {
    byName[tested.name] = &tested;
#ifndef __clang_analyzer__  // it does not see that the library keeps what is registered
    const auto body = [&](benchmark::State& state) {
      const auto& poses = scene.poses.at(tested.poseKind);
      std::size_t next = 0;
      for ([[maybe_unused]] auto unused : state) {
        if (progress.cancelRequested()) {
          state.SkipWithError("cancelled");
          break;
        }
        // Processor time of the one thread that works: what other programs take from it meanwhile does not count.
        const double start_s = threadTime_s();
        benchmark::DoNotOptimize(tested.slicer(poses[next++ % poses.size()]));
        const double spent_s = threadTime_s() - start_s;
        state.SetIterationTime(spent_s);
        tested.slices_us.push_back(1e6 * spent_s);
      }
      progress.report(say<"Timing the slicers">(), (done += 1.0) / total);
    };
    benchmark::RegisterBenchmark(tested.name.c_str(), body)
        ->UseManualTime()
        ->Unit(benchmark::kMicrosecond)
        ->Iterations(options.poses)
        ->Repetitions(options.repetitions);
#endif
  }
  Collector collector(byName);
  benchmark::RunSpecifiedBenchmarks(&collector, ".");
  benchmark::ClearRegisteredBenchmarks();
}

Result<void> checkOptions(const BenchOptions& options) {
  const auto refuse = [](const Message& what) { return failure(ErrorCode::badUsage, what); };
  if (options.volumeSides.empty()) return refuse(say<"The slicing benchmark needs at least one volume side; give --side 256.">());
  for (const int side : options.volumeSides)
    if (side < 8 || side > 1024) return refuse(say<"A volume side must lie between 8 and 1024 voxels.">());
  if (options.sliceSide < 16 || options.sliceSide > 4096) return refuse(say<"The side of a slice must lie between 16 and 4096 pixels.">());
  if (options.poses < 2 || options.poses > 1000) return refuse(say<"The number of poses must lie between 2 and 1000.">());
  if (options.repetitions < 1 || options.repetitions > 1000) return refuse(say<"The number of repetitions must lie between 1 and 1000.">());
  return {};
}

std::vector<SlicingCase> casesFor(const BenchOptions& options, const SlicingScene& scene, int volumeSide) {
  std::vector<SlicingCase> cases;
  const std::string size = std::to_string(options.sliceSide);
  const std::string prefix = "slice_" + size + "x" + size + "_of_" + std::to_string(volumeSide) + "cubed/";
  struct Way {
    Quality quality;
    const char* method;
    const char* id;
    bool peer;
    Read read;
  };
  const Way ways[] = {{Quality::weave, "weave", "weave", false, Read::chosen},
                      {Quality::weave, "weave, rows", "weave_rows", false, Read::rows},
                      {Quality::weave, "weave, bricks", "weave_bricks", false, Read::bricks},
                      {Quality::weave, "VTK nearest", "vtk_nearest", true, Read::rows},
                      {Quality::linear, "linear", "linear", false, Read::chosen},
                      {Quality::linear, "linear, rows", "linear_rows", false, Read::rows},
                      {Quality::linear, "linear, bricks", "linear_bricks", false, Read::bricks},
                      {Quality::linear, "VTK linear", "vtk_linear", true, Read::rows},
                      {Quality::cubic, "cubic", "cubic", false, Read::chosen},
                      {Quality::cubic, "cubic, rows", "cubic_rows", false, Read::rows},
                      {Quality::cubic, "cubic, bricks", "cubic_bricks", false, Read::bricks},
                      {Quality::cubic, "VTK cubic", "vtk_cubic", true, Read::rows}};
  for (const std::string kind : {"random", "smooth"})
    for (const Way& way : ways) {
      if (way.peer && !options.peers) continue;
      SlicingCase tested;
      tested.method = way.method;
      tested.name = prefix + way.id + "/" + kind;
      tested.quality = way.quality;
      tested.peer = way.peer;
      tested.read = way.read;
      tested.poseKind = kind;
      if (way.read != Read::rows)
        tested.bricksShare = way.read == Read::bricks ? 1.0 : bricksShare(scene, way.quality, scene.poses.at(kind));
      tested.voxels_bytes = (way.read == Read::bricks ? 0 : scene.volume.echo.size()) + (way.read == Read::rows ? 0 : scene.bricks.bytes());
      tested.slicer = way.peer ? peerSlicer(way.quality, scene.volume, options.sliceSide, options.sliceSide)
                               : ownSlicer(way.quality, sourceOf(scene, way.read), options.sliceSide);
      cases.push_back(std::move(tested));
    }
  return cases;
}

/// Wall time of a linear slice of 1024 x 768 pixels, all of them within the volume, on one and on two threads that take turns; medians.
json timeThreads(const SlicingScene& scene, int volumeSide) {
  constexpr int kWidth = 1024, kHeight = 768, kSlices = 31;
  GreyImage image(kWidth, kHeight);
  const Spans spans(kHeight, {{0, kWidth}});
  const SliceSource source = sourceOf(scene, Read::chosen);
  ImageToVoxel plane = scene.poses.at("smooth").front();
  const double step = 0.6 * volumeSide / static_cast<double>(kWidth);
  const glm::dvec3 x_voxel = step * glm::dvec3(plane.matrix[0]), y_voxel = step * glm::dvec3(plane.matrix[1]);
  const glm::dvec3 corner = glm::dvec3(0.5 * (volumeSide - 1)) - 0.5 * (kWidth - 1.0) * x_voxel - 0.5 * (kHeight - 1.0) * y_voxel;
  plane.matrix[0] = glm::dvec4(x_voxel, 0.0);
  plane.matrix[1] = glm::dvec4(y_voxel, 0.0);
  plane.matrix[3] = glm::dvec4(corner, 1.0);
  std::array<std::vector<double>, 2> times_us;
  std::array<Bands, 2> bands = {Bands(1), Bands(2)};
  std::array<SliceScratch, 2> scratch;
  for (int n = 0; n < kSlices; ++n)
    for (std::size_t which = 0; which < 2; ++which) {
      const auto start = std::chrono::steady_clock::now();
      bands[which].run(kHeight, [&](int firstRow, int rowCount, int slot) {
        sliceBand(Quality::linear, source, plane, spans, firstRow, rowCount, viewOf(image), scratch[static_cast<std::size_t>(slot)]);
      });
      times_us[which].push_back(std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count());
    }
  const double one_us = medianOf(times_us[0]), two_us = medianOf(times_us[1]);
  return {
      {"volume_side", volumeSide}, {"size", {kWidth, kHeight}}, {"one_us", one_us}, {"two_us", two_us}, {"times_faster", one_us / two_us}};
}

/// What the project promises of its slicers, and what this run found.
json promises(const json& report) {
  json kept = json::array();
  const auto add = [&](const std::string& what, double found, double bar, bool passed) {
    kept.push_back({{"what", what}, {"found", found}, {"bar", bar}, {"passed", passed}});
  };
  const auto rowOf = [&](int side, const std::string& kind, const std::string& method) -> const json* {
    for (const auto& row : report["results"])
      if (row["volume_side"] == side && row["pose_kind"] == kind && row["method"] == method) return &row;
    return nullptr;
  };
  for (const auto& ratio : report["ratios"]) {
    const auto quality = ratio["quality"].get<std::string>();
    if (quality != "weave" && quality != "linear" && quality != "cubic") continue;
    const int side = ratio["volume_side"];
    const auto kind = ratio["pose_kind"].get<std::string>();
    // Without AVX-512 the weave is held up by the memory on smooth poses, and a cubic sample by its sixteen loads.
    const bool avx3 = simdInUse() == "avx3";
    const double weaveBar = kind == "smooth" && !avx3 ? 4.0 : 6.0, cubicBar = avx3 ? 10.0 : 8.0;
    const double bar = quality == "cubic" ? cubicBar : quality == "weave" ? weaveBar : 6.0, found = ratio["times_faster"];
    const std::string where = quality + ", " + std::to_string(side) + " cubed, " + kind;
    add(where + ": times as fast as VTK's", found, bar, found >= bar);
    const json *mine = rowOf(side, kind, quality), *theirs = rowOf(side, kind, "VTK " + quality);
    if (mine == nullptr || theirs == nullptr) continue;
    if (quality == "linear") {
      const double psnr_db = (*mine)["psnr_double_db"];
      add(where + ": PSNR against double precision, dB", psnr_db, 58.0, psnr_db >= 58.0);
    }
    // Both round to whole grey levels; a hundredth of a decibel is chance.
    const double more_db = (*mine)["psnr_db"].get<double>() - (*theirs)["psnr_db"].get<double>();
    add(where + ": PSNR against the field beyond VTK's, dB", more_db, -0.01, more_db >= -0.01);
  }
  for (const auto& row : report["layouts"]) {
    const double least_us = std::min(row["rows_us"].get<double>(), row["bricks_us"].get<double>());
    const double found = least_us / row["choice_us"].get<double>();
    add(row["quality"].get<std::string>() + ", " + std::to_string(row["volume_side"].get<int>()) + " cubed, " +
            row["pose_kind"].get<std::string>() + ": time of the faster of the two layouts over that of the choice",
        found, 0.95, found >= 0.95);
  }
  for (const auto& row : report["threads_measured"]) {
    const double found = row["times_faster"];
    add("two threads, 1024 x 768 of " + std::to_string(row["volume_side"].get<int>()) + " cubed: times as fast as one", found, 1.7,
        found >= 1.7);
  }
  for (const char* method : {"weave", "linear", "cubic"}) {
    const json *small = rowOf(256, "smooth", method), *large = rowOf(1024, "smooth", method);
    if (small == nullptr || large == nullptr) continue;
    const double found = (*small)["median_us"].get<double>() / (*large)["median_us"].get<double>();
    add(std::string(method) + ", smooth: time of 256 cubed over that of 1024 cubed", found, 0.5, found >= 0.5);
  }
  return kept;
}

/// Median time of the n-th of `poses`; repetitions visit them in the same order.
double medianOfPose_us(const SlicingCase& tested, std::size_t n, std::size_t poses) {
  std::vector<double> times_us;
  for (; n < tested.slices_us.size(); n += poses) times_us.push_back(tested.slices_us[n]);
  return medianOf(times_us);
}

/// Either layout alone, and the choice, for which each pose counts as long as the layout chosen for it took: the same slices timed apart
/// differ by more than the layouts do.
void addLayouts(const std::vector<SlicingCase>& cases, const SlicingScene& scene, int volumeSide, json& report) {
  for (const SlicingCase& rows : cases)
    for (const SlicingCase& bricks : cases) {
      if (rows.peer || rows.read != Read::rows || bricks.read != Read::bricks || rows.quality != bricks.quality ||
          rows.poseKind != bricks.poseKind)
        continue;
      const auto& poses = scene.poses.at(rows.poseKind);
      double rows_us = 0.0, bricks_us = 0.0, choice_us = 0.0;
      for (std::size_t n = 0; n < poses.size(); ++n) {
        const double fromRows_us = medianOfPose_us(rows, n, poses.size()), fromBricks_us = medianOfPose_us(bricks, n, poses.size());
        rows_us += fromRows_us;
        bricks_us += fromBricks_us;
        choice_us += readsBricks(scene, rows.quality, poses[n]) ? fromBricks_us : fromRows_us;
      }
      const auto count = static_cast<double>(poses.size());
      report["layouts"].push_back({{"volume_side", volumeSide},
                                   {"pose_kind", rows.poseKind},
                                   {"quality", rows.method.substr(0, rows.method.find(','))},
                                   {"rows_us", rows_us / count},
                                   {"bricks_us", bricks_us / count},
                                   {"choice_us", choice_us / count}});
    }
}

void addToReport(const std::vector<SlicingCase>& cases, int volumeSide, json& report) {
  for (const SlicingCase& tested : cases) {
    report["results"].push_back({{"name", tested.name},
                                 {"method", tested.method},
                                 {"peer", tested.peer},
                                 {"layout", wordOf(tested.read)},
                                 {"bricks_share", tested.bricksShare},
                                 {"voxels_mib", static_cast<double>(tested.voxels_bytes) / (1024.0 * 1024.0)},
                                 {"volume_side", volumeSide},
                                 {"pose_kind", tested.poseKind},
                                 {"median_us", medianOf(tested.repetitions_us)},
                                 {"psnr_db", tested.psnr_db},
                                 {"psnr_double_db", tested.psnrDouble_db},
                                 {"worst_grey", tested.worst_grey}});
    report["steps"].push_back(json(cli::stepRow(tested.name, tested.slices_us)));
    for (const SlicingCase& peer : cases)
      if (!tested.peer && peer.peer && peer.quality == tested.quality && peer.poseKind == tested.poseKind) {
        const double peer_us = medianOf(peer.repetitions_us);
        const auto [fastest, slowest] = std::minmax_element(tested.repetitions_us.begin(), tested.repetitions_us.end());
        report["ratios"].push_back({{"volume_side", volumeSide},
                                    {"pose_kind", tested.poseKind},
                                    {"quality", tested.method},
                                    {"times_faster", peer_us / std::max(1e-3, medianOf(tested.repetitions_us))},
                                    {"times_faster_least", peer_us / std::max(1e-3, *slowest)},
                                    {"times_faster_most", peer_us / std::max(1e-3, *fastest)}});
      }
  }
}

}  // namespace

Result<json> benchSlicing(const BenchOptions& options, Progress& progress) {
  if (auto usable = checkOptions(options); !usable) return passOn(usable.error());
  vtkMultiThreader::SetGlobalMaximumNumberOfThreads(1);
  {
    std::string program = "echoweave", interleaved = "--benchmark_enable_random_interleaving=true";
    std::array<char*, 3> words = {program.data(), interleaved.data(), nullptr};
    int count = 2;
    benchmark::Initialize(&count, words.data());
  }
  json report = {{"machine", machineName()},
                 {"threads", 1},
                 {"slice_side", options.sliceSide},
                 {"poses", options.poses},
                 {"repetitions", options.repetitions},
                 {"results", json::array()},
                 {"ratios", json::array()},
                 {"layouts", json::array()},
                 {"threads_measured", json::array()},
                 {"steps", json::array()}};
  for (std::size_t n = 0; n < options.volumeSides.size(); ++n) {
    const int volumeSide = options.volumeSides[n];
    const double share = 1.0 / static_cast<double>(options.volumeSides.size());
    PartOfProgress part(progress, static_cast<double>(n) * share, static_cast<double>(n + 1) * share);
    part.report(say<"Filling a volume of %1 cubed">(volumeSide), 0.0);
    auto made = makeScene(options, volumeSide, progress);
    if (!made) return passOn(made.error());
    const SlicingScene& scene = **made;
    std::vector<SlicingCase> cases = casesFor(options, scene, volumeSide);
    for (SlicingCase& tested : cases) {
      if (progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"The benchmark was stopped.">());
      measureError(tested, scene, options.sliceSide);
      const auto sliceAll = [&] {
        for (const ImageToVoxel& pose : scene.poses.at(tested.poseKind)) tested.slicer(pose);
      };
      if (tested.peer && !runsOnThisThreadAlone(sliceAll))
        return failure(ErrorCode::internal,
                       say<"VTK's reslice used more than one thread, so its times cannot be compared; report this.">());
    }
    timeCases(cases, scene, options, part);
    if (progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"The benchmark was stopped.">());
    addToReport(cases, volumeSide, report);
    addLayouts(cases, scene, volumeSide, report);
    report["threads_measured"].push_back(timeThreads(scene, volumeSide));
  }
  report["promises"] = promises(report);
  return report;
}

std::vector<BenchSection> slicingSections(const json& report) {
  const std::string side = std::to_string(report["slice_side"].get<int>());
  std::vector<BenchSection> sections;
  std::set<int> volumeSides;
  for (const auto& row : report["results"]) volumeSides.insert(row["volume_side"].get<int>());
  for (const int volumeSide : volumeSides) {
    BenchSection section;
    section.title = "A slice of " + side + " x " + side + " pixels from " + std::to_string(volumeSide) + " cubed voxels";
    section.text =
        "One voxel a pixel, one thread. Random poses pass near the middle in any direction; smooth ones rock and slide like a hand. Voxels "
        "lie in rows and in bricks (twice the memory), and each slice is read from what was timed to be faster for its quality and "
        "direction; each layout "
        "alone is shown beside it.";
    section.legend = {{BenchMark::own, "EchoWeave, random poses"},
                      {BenchMark::ownHollow, "EchoWeave, smooth"},
                      {BenchMark::peer, "VTK, random"},
                      {BenchMark::peerHollow, "VTK, smooth"}};
    section.table = {
        2, {"Slicer", "Poses", "From bricks", "Voxels, MiB", "Median, ms", "Speed against VTK", "PSNR, dB", "Worst, grey levels"}, {}};
    for (const auto& row : report["results"]) {
      if (row["volume_side"] != volumeSide) continue;
      const bool peer = row["peer"].get<bool>(), smooth = row["pose_kind"] == "smooth";
      const std::string method = row["method"].get<std::string>(), poses = row["pose_kind"].get<std::string>();
      const double ms = row["median_us"].get<double>() * 1e-3, psnr = row["psnr_db"].get<double>();
      section.points.push_back({smooth ? "" : method, row["name"].get<std::string>(), ms, psnr,
                                peer     ? (smooth ? BenchMark::peerHollow : BenchMark::peer)
                                : smooth ? BenchMark::ownHollow
                                         : BenchMark::own,
                                peer ? "" : poses});
      std::string speed;
      for (const auto& ratio : report["ratios"])
        if (!peer && ratio["volume_side"] == row["volume_side"] && ratio["pose_kind"] == row["pose_kind"] &&
            ratio["quality"] == row["method"])
          speed = fixedText(ratio["times_faster"].get<double>(), 1) + " times (" + fixedText(ratio["times_faster_least"].get<double>(), 1) +
                  " to " + fixedText(ratio["times_faster_most"].get<double>(), 1) + ")";
      section.table.rows.push_back({method, poses, peer ? "" : fixedText(100.0 * row["bricks_share"].get<double>(), 0) + " %",
                                    fixedText(row["voxels_mib"].get<double>(), 0), fixedText(ms, 3), speed, fixedText(psnr, 1),
                                    fixedText(row["worst_grey"].get<double>(), 1)});
    }
    sections.push_back(std::move(section));
  }
  return sections;
}

}  // namespace ew
