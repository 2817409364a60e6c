#include "bench/volumes/bench_register.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>
#include <random>
#include <set>
#include <string>

#include "bench/tools/bench_parts.h"
#include "bench/volumes/bench_register_peers.h"
#include "ew/core/memory_watch.h"
#include "ew/core/numbers.h"
#include "ew/core/quiet_progress.h"
#include "ew/io/volume_file.h"
#include "ew/phantom/speckle_tissue.h"
#include "ew/registration/deformation.h"
#include "ew/registration/elastic.h"
#include "ew/registration/landmarks.h"
#include "ew/registration/rigid.h"
#include "run/report.h"

namespace ew {
namespace {

using namespace registration;
using nlohmann::json;

constexpr double kVoxel_mm = 0.6;
constexpr double kWideVoxel_mm = 0.9;  // of the pairs without a tracker
constexpr double kPeak_mm = 5.0;
constexpr double kWave_mm = 100.0;  // of the elastic motion: smooth, as tissue under a probe moves
constexpr double kShared = 0.8;     // of the speckle's amplitude: two thirds of its power

tl::unexpected<Error> registerStopped() { return failure(ErrorCode::cancelled, say<"The benchmark was stopped.">()); }

using Motion = std::function<glm::dvec3(const glm::dvec3&)>;  // a fixed point's true place in the moving volume

/// Two views and how they lie to each other.
struct Pair {
  std::string name;
  Volume fixed;
  Volume moving;
  Motion truth;
  Transform<frame::Moving, frame::Fixed> start = {};  // what the error at the start is measured with
};

/// Smooth motion up to kPeak_mm, different in each direction.
struct Warp {
  std::array<glm::dvec3, 3> phase;
  explicit Warp(std::uint64_t seed) {
    std::mt19937_64 draw(seed);
    for (auto& p : phase)
      for (int axis = 0; axis < 3; ++axis) p[axis] = 2.0 * std::numbers::pi * static_cast<double>(draw() >> 11) * 0x1p-53;
  }
  [[nodiscard]] glm::dvec3 at(const glm::dvec3& p_mm) const {
    glm::dvec3 u;
    for (int axis = 0; axis < 3; ++axis) {
      const glm::dvec3 wave = 2.0 * std::numbers::pi / kWave_mm * p_mm + phase[static_cast<std::size_t>(axis)];
      u[axis] = std::sin(wave.x) * std::cos(0.8 * wave.y) * std::cos(0.6 * wave.z + 0.3 * wave.x);
    }
    return kPeak_mm / std::sqrt(3.0) * u;
  }
  /// The tissue that moved to q.
  [[nodiscard]] glm::dvec3 before(const glm::dvec3& q_mm) const {
    glm::dvec3 p = q_mm;
    for (int step = 0; step < 30; ++step) p = q_mm - at(p);
    return p;
  }
};

Grid cubeAt(int side, double voxel_mm, const glm::dvec3& origin_mm) {
  Grid grid;
  grid.dims = glm::ivec3(side);
  grid.spacing_mm = glm::dvec3(voxel_mm);
  grid.origin_mm = origin_mm;
  return grid;
}

Result<Pair> pairOf(std::string name, const Grid& grid, const SpeckleTissue& fixedTissue, const SpeckleTissue& movingTissue,
                    const Motion& truth, const Motion& movingToTissue, bool differing, Progress& progress) {
  Pair pair{.name = std::move(name), .fixed = {}, .moving = {}, .truth = truth};
  auto fixed = imageOf(fixedTissue, {.grid = grid, .toTissue = {}, .shared = kShared, .view = 1}, 0, progress);
  if (!fixed) return passOn(fixed.error());
  TissueView view{.grid = grid, .toTissue = movingToTissue, .shared = kShared, .view = 2};
  view.gain_db = differing ? 5.0 : 0.0;
  view.shadow = differing;
  auto moving = imageOf(movingTissue, view, 0, progress);
  if (!moving) return passOn(moving.error());
  pair.fixed = std::move(*fixed);
  pair.moving = std::move(*moving);
  return pair;
}

Transform<frame::Moving, frame::Fixed> turnAbout(const glm::dvec3& middle_mm, double angle_deg, const glm::dvec3& axis,
                                                 const glm::dvec3& shift_mm) {
  return {glm::translate(glm::dmat4(1.0), middle_mm + shift_mm) *
          glm::rotate(glm::dmat4(1.0), glm::radians(angle_deg), glm::normalize(axis)) * glm::translate(glm::dmat4(1.0), -middle_mm)};
}

template <class To, class From>
Motion rigidMotion(const Transform<To, From>& t) {
  return [t](const glm::dvec3& p) { return carried(t, p); };
}

struct Errors {
  double mean_mm = 0.0;
  double p95_mm = 0.0;
};

/// Over every third voxel whose true place lies in the moving view.
Errors errorsOf(const Pair& pair, const Motion& found) {
  const Grid& grid = pair.fixed.grid;
  const auto toWorld = grid.voxelToWorld();
  const auto toMoving = pair.moving.grid.worldToVoxel();
  std::vector<double> errors;
  const glm::ivec3 step(3, 3, grid.dims.z == 1 ? 1 : 3);
  for (int k = 0; k < grid.dims.z; k += step.z)
    for (int j = 0; j < grid.dims.y; j += step.y)
      for (int i = 0; i < grid.dims.x; i += step.x) {
        const glm::dvec3 p = (toWorld * Point<frame::Voxel>{{i, j, k}}).at;
        const glm::dvec3 q = pair.truth(p);
        const glm::dvec3 v = (toMoving * Point<frame::World>{q}).at;
        if (glm::any(glm::lessThan(v, glm::dvec3(-0.5))) || glm::any(glm::greaterThan(v, glm::dvec3(pair.moving.grid.dims) - 0.5)))
          continue;
        errors.push_back(glm::length(found(p) - q));
      }
  Errors result;
  if (errors.empty()) return result;
  std::sort(errors.begin(), errors.end());
  for (const double error : errors) result.mean_mm += error / static_cast<double>(errors.size());
  result.p95_mm = errors[std::min(errors.size() - 1, errors.size() * 95 / 100)];
  return result;
}

/// What one run of one setting gives.
struct Answer {
  Motion found;
  Verdict verdict = Verdict::cannotTell;
  std::optional<double> jacobianMin;
};

struct Trial {
  std::string method;
  std::string setting;
  const Pair* pair = nullptr;
  std::function<Result<Answer>(Progress&)> work;
};

json rowOf(const std::string& method, const std::string& setting, const Pair& pair, double median_us, const Motion& found) {
  const Errors before = errorsOf(pair, rigidMotion(pair.start));
  const Errors after = errorsOf(pair, found);
  return {{"name", "register_" + method + "/" + pair.name + "/" + setting},
          {"method", method},
          {"setting", setting},
          {"pair", pair.name},
          {"median_us", median_us},
          {"error_start_mm", before.mean_mm},
          {"error_mm", after.mean_mm},
          {"error_p95_mm", after.p95_mm},
          {"removed_percent", before.mean_mm > 0.0 ? 100.0 * (1.0 - after.mean_mm / before.mean_mm) : 0.0}};
}

Answer answerOf(Deformation deformation, Verdict verdict, std::optional<double> jacobianMin = {}) {
  auto kept = std::make_shared<Deformation>(std::move(deformation));
  return {[kept](const glm::dvec3& p) { return movingPoint(*kept, p); }, verdict, jacobianMin};
}

/// The middle slice of the elastic pair's motion, in the plane.
Result<Pair> images(const RegisterBenchOptions& options, Progress& progress) {
  const SpeckleTissue tissue(options.seed + 2);
  const Warp warp(options.seed + 2);
  Grid grid = cubeAt(256, 0.4, {10.0, 20.0, 30.0});
  grid.dims.z = 1;
  const auto flat = [warp](const glm::dvec3& p) {
    glm::dvec3 u = warp.at({p.x, p.y, 30.0});
    u.z = 0.0;
    return u;
  };
  const Motion truth = [flat](const glm::dvec3& p) { return p + flat(p); };
  const Motion back = [flat](const glm::dvec3& q) {
    glm::dvec3 p = q;
    for (int step = 0; step < 30; ++step) p = q - flat(p);
    return p;
  };
  return pairOf("pictures", grid, tissue, tissue, truth, back, true, progress);
}

struct Pairs {
  Pair elastic;
  Pair flat;
  Pair turned;
  std::vector<Pair> partial;
  Pair strangers;
};

Result<Pairs> makePairs(const RegisterBenchOptions& options, Progress& progress) {
  Pairs pairs;
  const auto take = [](Pair& into, Result<Pair> made) -> Result<void> {
    if (!made) return passOn(made.error());
    into = std::move(*made);
    return {};
  };
  const SpeckleTissue tissue(options.seed);
  const SpeckleTissue other(options.seed + 77);
  const Warp warp(options.seed);
  const Grid grid = cubeAt(options.side, kVoxel_mm, {-12.0, 5.0, 40.0});
  if (auto made = take(pairs.elastic, pairOf(
                                          "elastic", grid, tissue, tissue, [warp](const glm::dvec3& p) { return p + warp.at(p); },
                                          [warp](const glm::dvec3& q) { return warp.before(q); }, true, progress));
      !made)
    return passOn(made.error());
  if (auto made = take(pairs.flat, images(options, progress)); !made) return passOn(made.error());
  const Grid wide = cubeAt(options.side, kWideVoxel_mm, glm::dvec3(0.0));
  const double extent_mm = kWideVoxel_mm * (options.side - 1);
  const glm::dvec3 middle(0.5 * extent_mm);
  const auto rigidPair = [&](const std::string& name, const SpeckleTissue& seen, double angle_deg, const glm::dvec3& shift_mm) {
    const auto fixedToMoving = turnAbout(middle, angle_deg, {0.5, 0.6, -0.62}, shift_mm);
    return pairOf(name, wide, tissue, seen, rigidMotion(fixedToMoving), rigidMotion(inverse(fixedToMoving)), true, progress);
  };
  if (auto made = take(pairs.turned, rigidPair("turned", tissue, 9.0, {4.0, -3.0, 3.5})); !made) return passOn(made.error());
  for (const auto& [name, angle_deg, share] : {std::tuple{"half", 12.0, 0.5}, {"third", 24.0, 0.66}}) {
    pairs.partial.emplace_back();
    if (auto made = take(pairs.partial.back(), rigidPair(name, tissue, angle_deg, {share * extent_mm, 3.0, -5.0})); !made)
      return passOn(made.error());
  }
  if (auto made = take(pairs.strangers, rigidPair("strangers", other, 12.0, {0.5 * extent_mm, 3.0, -5.0})); !made)
    return passOn(made.error());
  return pairs;
}

std::vector<Trial> elastic2dTrials(const Pair& pair) {
  std::vector<Trial> trials;
  const auto add = [&](const std::string& setting, const Elastic2dOptions& options) {
    trials.push_back(
        {"elastic2d", setting, &pair, [&pair, options](Progress& progress) -> Result<Answer> {
           const auto view = [](const Volume& volume) {
             return ImageView<const std::uint8_t>{volume.echo.data(), volume.grid.dims.x, volume.grid.dims.y, volume.grid.dims.x};
           };
           const Grid& grid = pair.fixed.grid;
           auto result = registerElastic2d(view(pair.fixed), view(pair.moving), {grid.spacing_mm.x, grid.spacing_mm.y}, options, progress);
           if (!result) return passOn(result.error());
           Deformation deformation;
           deformation.control.nodes = grid;
           for (const glm::vec2& d : result->displacement_mm) deformation.control.displacement_mm.emplace_back(d.x, d.y, 0.0F);
           return answerOf(std::move(deformation), result->verdict, result->smallestJacobian);
         }});
  };
  add("chosen by size", {});
  add("one level", {.factors = {}, .singleResolution = true});
  add("down to 48 px", {.factors = {48.0}});
  add("down to 24 px", {.factors = {48.0, 24.0}});
  add("down to 12 px", {.factors = {48.0, 24.0, 12.0}});
  add("48, 24, 6 px as in 1998", {.factors = {48.0, 24.0, 6.0}});
  Elastic2dOptions plain;
  plain.intensityTerm = false;
  add("without the intensity term", plain);
  return trials;
}

std::vector<Trial> elastic3dTrials(const Pair& pair) {
  std::vector<Trial> trials;
  const auto add = [&](const std::string& setting, ElasticOptions options) {
    options.threads = 1;
    trials.push_back({"elastic3d", setting, &pair, [&pair, options](Progress& progress) -> Result<Answer> {
                        auto result = registerElastic({&pair.fixed}, {&pair.moving}, pair.start, options, progress);
                        if (!result) return passOn(result.error());
                        return answerOf(std::move(result->fixedToMoving), result->verdict, result->jacobian.smallest);
                      }});
  };
  for (const auto& [effort, name] :
       {std::pair{ElasticEffort::fast, "fast"}, {ElasticEffort::balanced, "balanced"}, {ElasticEffort::accurate, "accurate"}}) {
    ElasticOptions options;
    options.effort = effort;
    add(name, options);
  }
  for (const double node_mm : {4.0, 12.0}) {
    ElasticOptions options;
    options.finestNode_mm = node_mm;
    add("nodes of " + textOf(node_mm) + " mm", options);
  }
  for (const double voxel_mm : {1.2, 2.4}) {
    ElasticOptions options;
    options.finestVoxel_mm = voxel_mm;
    add("voxels down to " + textOf(voxel_mm) + " mm", options);
  }
  ElasticOptions narrow;
  narrow.largestMotion_mm = 0.0;
  add("without the wide search", narrow);
  return trials;
}

std::vector<Trial> rigidTrials(const Pair& pair) {
  std::vector<Trial> trials;
  for (const double finest_mm : {3.0, 1.5, 0.9})
    trials.push_back(
        {"rigid", "voxels down to " + textOf(finest_mm) + " mm", &pair, [&pair, finest_mm](Progress& progress) -> Result<Answer> {
           RefineOptions options;
           options.finest_mm = finest_mm;
           options.threads = 1;
           auto result = refineRigid({&pair.fixed}, {&pair.moving}, pair.start, options, progress);
           if (!result) return passOn(result.error());
           return answerOf({.rigid = result->fixedToMoving, .control = {}}, result->verdict);
         }});
  return trials;
}

std::vector<Trial> partialTrials(const Pairs& pairs) {
  std::vector<Trial> trials;
  const auto add = [&](const Pair& pair, const std::string& setting, PartialOptions options) {
    options.threads = options.refine.threads = 1;
    trials.push_back({"partial", setting, &pair, [&pair, options](Progress& progress) -> Result<Answer> {
                        auto result = matchPartial({&pair.fixed}, {&pair.moving}, options, progress);
                        if (!result) return passOn(result.error());
                        return answerOf({.rigid = result->best.fixedToMoving, .control = {}}, result->best.verdict);
                      }});
  };
  for (const Pair& pair : pairs.partial) {
    add(pair, "as it comes", {});
    PartialOptions turns;
    turns.stepRotation_deg = 15.0;
    add(pair, "turns of 15 degrees", turns);
    PartialOptions cells;
    cells.cell_mm = 4.5;
    add(pair, "cells of 4.5 mm", cells);
    PartialOptions coarse;
    coarse.refine.finest_mm = 1.8;
    add(pair, "refined to 1.8 mm", coarse);
    PartialOptions few;
    few.hypotheses = 3;
    add(pair, "3 hypotheses", few);
  }
  add(pairs.strangers, "as it comes", {});
  return trials;
}

/// Landmarks picked with an error of 1 mm, one in five of them wrong: a figure per number of pairs, over many draws.
json landmarkRows(std::uint64_t seed, Progress& progress) {
  json rows = json::array();
  std::mt19937_64 engine(seed);
  const auto even = [&](double span) { return span * (static_cast<double>(engine() >> 11) * 0x1p-53 - 0.5); };
  const auto vector = [&](double span) {
    const double x = even(span);
    const double y = even(span);
    return glm::dvec3(x, y, even(span));
  };
  const double pickSpan = std::sqrt(12.0);  // an even spread whose deviation is 1
  for (const bool robust : {false, true})
    for (const int count : {4, 5, 7, 10, 15, 25}) {
      if (progress.cancelRequested()) break;
      double mean_mm = 0.0;
      double start_mm = 0.0;
      double expected_mm = 0.0;
      std::vector<double> times_us;
      constexpr int kDraws = 60;
      for (int n = 0; n < kDraws; ++n) {
        const auto truth = turnAbout(glm::dvec3(0.0), even(60.0), vector(1.0), vector(40.0));
        std::vector<LandmarkPair> pairs;
        for (int p = 0; p < count; ++p) {
          const glm::dvec3 place = vector(80.0);
          LandmarkPair pair{std::to_string(p), place + vector(pickSpan), carried(truth, place) + vector(pickSpan)};
          if (p % 5 == 4) pair.moving_mm += 30.0 * glm::normalize(vector(1.0));
          pairs.push_back(pair);
        }
        const double begin_s = threadTime_s();
        const auto result = registerLandmarks(pairs, {.pickError_mm = 1.0, .robust = robust});
        times_us.push_back(1e6 * (threadTime_s() - begin_s));
        if (!result) continue;
        expected_mm += result->expectedError_mm / kDraws;
        for (int corner = 0; corner < 8; ++corner) {
          const glm::dvec3 p(corner & 1 ? 40.0 : -40.0, corner & 2 ? 40.0 : -40.0, corner & 4 ? 40.0 : -40.0);
          mean_mm += glm::length(carried(result->fixedToMoving, p) - carried(truth, p)) / (8.0 * kDraws);
          start_mm += glm::length(p - carried(truth, p)) / (8.0 * kDraws);
        }
      }
      const std::string setting = std::to_string(count) + (robust ? " pairs, robust" : " pairs, closed form alone");
      rows.push_back({{"name", "register_landmarks/" + setting},
                      {"method", "landmarks"},
                      {"setting", setting},
                      {"pair", "landmarks"},
                      {"median_us", medianOf(times_us)},
                      {"error_start_mm", start_mm},
                      {"error_mm", mean_mm},
                      {"error_p95_mm", nullptr},
                      {"expected_mm", std::isfinite(expected_mm) ? json(expected_mm) : json()},
                      {"removed_percent", 100.0 * (1.0 - mean_mm / start_mm)}});
    }
  return rows;
}

/// A folder for the peers' files that goes with it.
class WorkFolder {
 public:
  static Result<std::unique_ptr<WorkFolder>> create() {
    std::error_code problem;
    auto base = std::filesystem::temp_directory_path(problem);
    if (!problem) {
      std::string name = (base / "echoweave-bench-XXXXXX").string();
      if (::mkdtemp(name.data()) != nullptr) return std::unique_ptr<WorkFolder>(new WorkFolder(name));
    }
    return failure(ErrorCode::notWritable, say<"There is no folder for temporary files; set TMPDIR to one, or leave the peers out.">());
  }
  ~WorkFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;
  const std::filesystem::path path;

 private:
  explicit WorkFolder(std::filesystem::path where) : path(std::move(where)) {}
};

Result<void> measurePeers(const Pair& pair, json& report, Progress& progress) {
  std::set<std::string> missing;
  std::unique_ptr<WorkFolder> work;
  const auto peers = registerPeers();
  for (std::size_t n = 0; n < peers.size(); ++n) {
    if (!isInstalled(peers[n].program)) {
      missing.insert(peers[n].program);
      continue;
    }
    if (!work) {
      auto made = WorkFolder::create();
      if (!made) return passOn(made.error());
      work = std::move(*made);
      for (const auto& [volume, name] : {std::pair{&pair.fixed, "fixed.mha"}, {&pair.moving, "moving.mha"}})
        if (auto written = writeVolume(*volume, work->path / name, noProgress(), {.compress = false}); !written)
          return passOn(written.error());
    }
    progress.report(say<"Waiting for %1">(peers[n].program), static_cast<double>(n) / static_cast<double>(peers.size()));
    const auto folder = work->path / std::to_string(n);
    std::error_code ignored;
    std::filesystem::create_directories(folder, ignored);
    const auto run = runPeer(peers[n], work->path / "fixed.mha", work->path / "moving.mha", folder, progress);
    if (!run && run.error().code == ErrorCode::cancelled) return passOn(run.error());
    if (!run) {
      report["peers"].push_back({{"name", peers[n].program + ", " + peers[n].setting}, {"failed", run.error().sentence()}});
      continue;
    }
    ControlGrid field{run->field.grid, {}};
    if (run->field.components != 3 || run->field.grid.dims != pair.fixed.grid.dims) continue;
    for (std::size_t i = 0; i + 2 < run->field.values.size(); i += 3)
      field.displacement_mm.emplace_back(run->field.values[i], run->field.values[i + 1], run->field.values[i + 2]);
    json row = rowOf(peers[n].program, peers[n].setting, pair, 1e6 * run->cpu_s,
                     [&field](const glm::dvec3& p) { return p + displacementAt(field, p); });
    row["jacobian_min"] = jacobianOf(DisplacementField{field.nodes, field.displacement_mm}).smallest;
    report["peers"].push_back(std::move(row));
  }
  report["peers_missing"] = missing;
  return {};
}

Result<void> checkOptions(const RegisterBenchOptions& options) {
  if (options.side < 48 || options.side > 256)
    return failure(ErrorCode::badUsage, say<"The side of the volumes must lie between 48 and 256 voxels.">());
  if (options.repetitions < 1 || options.repetitions > 100)
    return failure(ErrorCode::badUsage, say<"The number of repetitions must lie between 1 and 100.">());
  return {};
}

}  // namespace

Result<json> benchRegister(const RegisterBenchOptions& options, Progress& progress) {
  if (auto usable = checkOptions(options); !usable) return passOn(usable.error());
  PartOfProgress preparing(progress, 0.0, 0.1);
  PartOfProgress timing(progress, 0.1, options.peers ? 0.6 : 1.0);
  PartOfProgress waiting(progress, 0.6, 1.0);
  preparing.report(say<"Imaging speckled tissue">(), 0.0);
  PartOfProgress silent(noProgress(), 0.0, 1.0);
  auto pairs = makePairs(options, preparing);
  if (!pairs) return passOn(pairs.error());

  std::vector<Trial> trials;
  const auto append = [&](std::vector<Trial> more) {
    for (auto& trial : more) trials.push_back(std::move(trial));
  };
  append(elastic3dTrials(pairs->elastic));
  append(rigidTrials(pairs->turned));
  append(partialTrials(*pairs));
  append(elastic2dTrials(pairs->flat));

  json report = {{"machine", machineName()}, {"side", options.side},   {"repetitions", options.repetitions}, {"seed", options.seed},
                 {"results", json::array()}, {"peers", json::array()}, {"peers_missing", json::array()},     {"steps", json::array()}};
  for (std::size_t n = 0; n < trials.size(); ++n) {
    const Trial& trial = trials[n];
    timing.report(say<"Registering">(), static_cast<double>(n) / static_cast<double>(trials.size()));
    std::vector<double> times_us;
    Result<Answer> answer = Answer{};
    MemoryWatch memory;
    for (int repetition = 0; repetition < options.repetitions; ++repetition) {
      if (progress.cancelRequested()) return registerStopped();
      // The work's own progress would move the bar backwards; the wish to cancel has to reach it.
      QuietProgress ask(progress);
      answer = Answer{};
      const double begin_s = threadTime_s();
      answer = trial.work(ask);
      times_us.push_back(1e6 * (threadTime_s() - begin_s));
      if (!answer) return passOn(answer.error());
    }
    json row = rowOf(trial.method, trial.setting, *trial.pair, medianOf(times_us), answer->found);
    row["peak_mib"] = peakOf(memory);
    row["verdict"] = nameOf(answer->verdict);
    row["jacobian_min"] = answer->jacobianMin ? json(*answer->jacobianMin) : json();
    report["steps"].push_back(json(cli::stepRow(row["name"].get<std::string>(), std::move(times_us))));
    report["results"].push_back(std::move(row));
  }
  for (auto& row : landmarkRows(options.seed, progress)) report["results"].push_back(std::move(row));
  if (progress.cancelRequested()) return registerStopped();
  if (options.peers)
    if (auto measured = measurePeers(pairs->elastic, report, waiting); !measured) return passOn(measured.error());
  return report;
}

}  // namespace ew
