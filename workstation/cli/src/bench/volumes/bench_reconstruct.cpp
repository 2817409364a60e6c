#include "bench/volumes/bench_reconstruct.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numeric>
#include <random>
#include <string>
#include <utility>

#include "bench/tools/bench_parts.h"
#include "ew/acquisition/reconstruct_words.h"
#include "ew/core/memory_watch.h"
#include "ew/core/numbers.h"
#include "run/report.h"

namespace ew {
namespace {

using nlohmann::json;

constexpr double kImage_mm = 60.0;
constexpr double kFieldVoxel_mm = 0.5;
constexpr std::size_t kJudgedVoxels = 300000;

struct Sweep {
  std::string name;
  std::vector<GreyImage> images;
  std::vector<TrackedFrame> frames;
};

/// Exact levels at some voxels of a grid, spread over all of it.
struct Truth {
  Grid grid;
  std::vector<std::size_t> index;
  std::vector<float> level;
};

tl::unexpected<Error> reconstructStopped() { return failure(ErrorCode::cancelled, say<"The benchmark was stopped.">()); }

double reconstructWall_us() {
  return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double levelAt(const BenchField& field, const glm::dvec3& p_world_mm) { return field.at(p_world_mm / kFieldVoxel_mm); }

glm::dmat4 translation(double x_mm, double y_mm, double z_mm) { return glm::translate(glm::dmat4(1.0), glm::dvec3(x_mm, y_mm, z_mm)); }

glm::dmat4 turn(double angle_rad, const glm::dvec3& axis) { return glm::rotate(glm::dmat4(1.0), angle_rad, axis); }

/// Where the probe is while frame n of the sweep is taken; `n` counts from the middle.
glm::dmat4 probeToWorld(const std::string& kind, double n) {
  if (kind == "parallel") return translation(0.0, 0.0, 1.5 * n);
  if (kind == "fan") return translation(0.0, -40.0, 0.0) * turn(0.02 * n, {1, 0, 0}) * translation(0.0, 40.0, 0.0);
  // A hand hurries, waits and goes back (steps from -0.6 to 3.6 mm), sways and rocks about all axes.
  return translation(2.0 * std::sin(0.23 * n), 0.8 * std::sin(0.31 * n), 1.5 * n + 3.0 * std::sin(0.7 * n)) *
         turn(0.10 * std::sin(0.17 * n), {0, 1, 0}) * turn(0.08 * std::sin(0.29 * n + 1.0), {1, 0, 0}) *
         turn(0.05 * std::sin(0.41 * n + 2.0), {0, 0, 1});
}

Result<Sweep> sweepOf(const std::string& kind, const ReconstructBenchOptions& options, const BenchField& field, Progress& progress) {
  Sweep sweep{kind, {}, {}};
  const int side = options.imageSide;
  const double pixel_mm = kImage_mm / side;
  const glm::dmat4 imageToProbe =
      translation(-0.5 * (kImage_mm - pixel_mm), 0.0, 0.0) * glm::scale(glm::dmat4(1.0), glm::dvec3(pixel_mm, pixel_mm, pixel_mm));
  for (int n = 0; n < options.frames; ++n) {
    if (progress.cancelRequested()) return reconstructStopped();
    const glm::dmat4 imageToWorld = probeToWorld(kind, n - 0.5 * (options.frames - 1)) * imageToProbe;
    GreyImage image(side, side);
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x)
        viewOf(image).at(x, y) = static_cast<std::uint8_t>(levelAt(field, glm::dvec3(imageToWorld * glm::dvec4(x, y, 0.0, 1.0))) + 0.5);
    sweep.images.push_back(std::move(image));
    sweep.frames.push_back({{}, {imageToWorld}});
  }
  for (std::size_t n = 0; n < sweep.frames.size(); ++n) sweep.frames[n].pixels = viewOf(std::as_const(sweep.images[n]));
  return sweep;
}

Truth truthOn(const Grid& grid, const BenchField& field) {
  Truth truth{grid, {}, {}};
  const std::size_t count = grid.voxelCount();
  // A step that shares no factor with the grid's sides meets every row and plane alike.
  std::size_t step = std::max<std::size_t>(1, count / kJudgedVoxels);
  const auto sharesAFactor = [&] {
    return std::any_of(&grid.dims[0], &grid.dims[0] + 3, [&](int side) { return std::gcd(step, static_cast<std::size_t>(side)) != 1; });
  };
  while (step > 1 && sharesAFactor()) ++step;
  const auto voxelToWorld = grid.voxelToWorld().matrix;
  for (std::size_t at = 0; at < count; at += step) {
    const auto nx = static_cast<std::size_t>(grid.dims.x), ny = static_cast<std::size_t>(grid.dims.y);
    const std::size_t i = at % nx, j = at / nx % ny, k = at / nx / ny;
    const glm::dvec4 voxel(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k), 1.0);
    truth.index.push_back(at);
    truth.level.push_back(static_cast<float>(levelAt(field, glm::dvec3(voxelToWorld * voxel))));
  }
  return truth;
}

struct ReconstructSetting {
  std::string name;  ///< "reconstruct_fan/0.5mm/linear/sweep_6mm"
  const Sweep* sweep = nullptr;
  const Truth* truth = nullptr;
  ReconstructOptions options;
  json measured, filled;
  std::size_t pixels = 0;
  json peak_mib;  ///< beyond the frames
  std::vector<double> cpu_us;
};

const char* fillNameOf(const ReconstructOptions& options) {
  if (options.fillReach_mm <= 0.0) return "none";
  return wordIn(kFillMethodWords, options.fillMethod);
}

std::vector<ReconstructSetting> settingsOf(const std::vector<Sweep>& sweeps, const std::vector<std::vector<Truth>>& truths,
                                           const std::vector<double>& spacings_mm) {
  std::vector<ReconstructSetting> settings;
  for (std::size_t s = 0; s < sweeps.size(); ++s)
    for (std::size_t v = 0; v < spacings_mm.size(); ++v)
      for (const auto interpolation : {Interpolation::nearest, Interpolation::linear, Interpolation::centred})
        for (const double reach_mm : {0.0, 2.0, 6.0})
          for (const auto method : {FillMethod::bridges, FillMethod::sweep}) {
            if (reach_mm == 0.0 && method == FillMethod::sweep) continue;
            ReconstructSetting setting;
            setting.options.spacing_mm = spacings_mm[v];
            setting.options.interpolation = interpolation;
            setting.options.fillReach_mm = reach_mm;
            setting.options.fillMethod = method;
            setting.options.threads = 1;
            setting.sweep = &sweeps[s];
            setting.truth = &truths[s][v];
            setting.name = "reconstruct_" + sweeps[s].name + "/" + textOf(spacings_mm[v]) + "mm/" +
                           wordIn(kInterpolationWords, interpolation) + "/" + fillNameOf(setting.options);
            if (reach_mm > 0.0) setting.name += "_" + textOf(reach_mm) + "mm";
            settings.push_back(std::move(setting));
          }
  return settings;
}

/// Errors of the voxels of one coverage; null when there are none.
json errorsOf(const Volume& volume, const Truth& truth, Coverage coverage, std::size_t voxels) {
  double squares = 0.0, absolute = 0.0, sum = 0.0, count = 0.0;
  for (std::size_t n = 0; n < truth.index.size(); ++n) {
    if (volume.coverageAt(truth.index[n]) != coverage) continue;
    const double error = static_cast<double>(volume.echo[truth.index[n]]) - static_cast<double>(truth.level[n]);
    squares += error * error;
    absolute += std::abs(error);
    sum += error;
    count += 1.0;
  }
  if (count == 0.0) return nullptr;
  return {{"share", static_cast<double>(voxels) / static_cast<double>(volume.grid.voxelCount())},
          {"psnr_db", 10.0 * std::log10(255.0 * 255.0 * count / std::max(squares, 1e-9))},
          {"mae", absolute / count},
          {"bias", sum / count}};
}

Result<void> measureErrors(std::vector<ReconstructSetting>& settings, Progress& progress) {
  for (std::size_t n = 0; n < settings.size(); ++n) {
    ReconstructSetting& setting = settings[n];
    const double share = 1.0 / static_cast<double>(settings.size());
    PartOfProgress part(progress, static_cast<double>(n) * share, static_cast<double>(n + 1) * share);
    const MemoryWatch memory;
    const auto made = reconstruct(setting.sweep->frames, setting.options, part);
    if (!made) return passOn(made.error());
    setting.peak_mib = peakOf(memory);
    if (made->volume.grid != setting.truth->grid)
      return failure(ErrorCode::internal, say<"'%1' made a volume on another grid than planned; report this.">(setting.name));
    setting.pixels = made->pixelsPasted;
    setting.measured = errorsOf(made->volume, *setting.truth, Coverage::measured, made->measuredVoxels);
    setting.filled = errorsOf(made->volume, *setting.truth, Coverage::interpolated, made->interpolatedVoxels);
  }
  return {};
}

/// Settings take turns, in another order each time, so that a busy moment of the machine falls on no one alone.
Result<void> timeSettings(std::vector<ReconstructSetting>& settings, int repetitions, Progress& progress) {
  std::vector<std::size_t> order(settings.size());
  for (std::size_t n = 0; n < order.size(); ++n) order[n] = n;
  std::mt19937 random(7);
  for (int repetition = 0; repetition < repetitions; ++repetition) {
    std::shuffle(order.begin(), order.end(), random);
    for (std::size_t n = 0; n < order.size(); ++n) {
      progress.report(say<"Timing reconstructions">(),
                      (repetition + static_cast<double>(n) / static_cast<double>(order.size())) / repetitions);
      if (progress.cancelRequested()) return reconstructStopped();
      ReconstructSetting& setting = settings[order[n]];
      const double start_s = threadTime_s();
      const auto made = reconstruct(setting.sweep->frames, setting.options, noProgress());
      setting.cpu_us.push_back(1e6 * (threadTime_s() - start_s));
      if (!made) return passOn(made.error());
    }
  }
  return {};
}

/// One thread and two in turns, by the clock on the wall: on a busy machine the ratio says less than it should.
Result<json> timeThreads(const std::vector<ReconstructSetting>& settings, int repetitions, Progress& progress) {
  json rows = json::array();
  const double finest_mm = settings.front().options.spacing_mm;
  for (const ReconstructSetting& setting : settings) {
    const bool chosen = setting.sweep->name == "freehand" && setting.options.spacing_mm == finest_mm &&
                        (setting.options.fillReach_mm == 0.0 || (setting.options.fillReach_mm > 4.0));
    if (!chosen) continue;
    std::vector<double> one_us, two_us;
    std::vector<std::uint8_t> voxels;
    bool same = true;
    for (int repetition = 0; repetition < repetitions; ++repetition)
      for (const int threads : {1, 2}) {
        if (progress.cancelRequested()) return reconstructStopped();
        ReconstructOptions options = setting.options;
        options.threads = threads;
        const double start_us = reconstructWall_us();
        auto made = reconstruct(setting.sweep->frames, options, noProgress());
        (threads == 1 ? one_us : two_us).push_back(reconstructWall_us() - start_us);
        if (!made) return passOn(made.error());
        if (threads == 2) same = same && made->volume.echo == voxels;
        if (threads == 1) voxels = std::move(made->volume.echo);
      }
    rows.push_back({{"name", setting.name},
                    {"one_us", medianOf(one_us)},
                    {"two_us", medianOf(two_us)},
                    {"times_faster", medianOf(one_us) / medianOf(two_us)},
                    {"same_voxels", same}});
  }
  return rows;
}

Result<void> checkOptions(const ReconstructBenchOptions& options) {
  const auto refuse = [](const Message& what) { return failure(ErrorCode::badUsage, what); };
  if (options.spacings_mm.empty()) return refuse(say<"The benchmark of reconstruction needs at least one spacing; give --spacing 0.5.">());
  for (const double spacing_mm : options.spacings_mm)
    if (!(spacing_mm >= 0.25 && spacing_mm <= 4.0)) return refuse(say<"A spacing must lie between 0.25 and 4 mm.">());
  if (options.frames < 6 || options.frames > 1000) return refuse(say<"The number of frames must lie between 6 and 1000.">());
  if (options.imageSide < 32 || options.imageSide > 1024) return refuse(say<"The side of an image must lie between 32 and 1024 pixels.">());
  if (options.views < 1 || options.views > 20) return refuse(say<"The number of virtual frames must lie between 1 and 20.">());
  if (options.repetitions < 1 || options.repetitions > 1000) return refuse(say<"The number of repetitions must lie between 1 and 1000.">());
  return {};
}

}  // namespace

Result<json> benchReconstruct(const ReconstructBenchOptions& options, Progress& progress) {
  if (auto usable = checkOptions(options); !usable) return passOn(usable.error());
  PartOfProgress preparing(progress, 0.0, 0.05), comparing(progress, 0.05, 0.2), timing(progress, 0.2, 0.75),
      threading(progress, 0.75, 0.8), believing(progress, 0.8, 1.0);
  preparing.report(say<"Drawing sweeps of an exact field">(), 0.0);
  const BenchField field(1);
  std::vector<Sweep> sweeps;
  std::vector<std::vector<Truth>> truths;
  for (const char* kind : {"parallel", "fan", "freehand"}) {
    auto sweep = sweepOf(kind, options, field, preparing);
    if (!sweep) return passOn(sweep.error());
    truths.emplace_back();
    for (const double spacing_mm : options.spacings_mm) {
      ReconstructOptions planned;
      planned.spacing_mm = spacing_mm;
      const auto grid = gridFor(sweep->frames, planned);
      if (!grid) return passOn(grid.error());
      truths.back().push_back(truthOn(*grid, field));
    }
    sweeps.push_back(*std::move(sweep));
  }
  std::vector<ReconstructSetting> settings = settingsOf(sweeps, truths, options.spacings_mm);
  if (auto measured = measureErrors(settings, comparing); !measured) return passOn(measured.error());
  const auto once = [&] { static_cast<void>(reconstruct(settings.back().sweep->frames, settings.back().options, noProgress())); };
  if (!runsOnThisThreadAlone(once))
    return failure(ErrorCode::internal, say<"The reconstruction used more than one thread, so its times mean nothing; report this.">());
  if (auto timed = timeSettings(settings, options.repetitions, timing); !timed) return passOn(timed.error());
  auto threads = timeThreads(settings, options.repetitions, threading);
  if (!threads) return passOn(threads.error());

  json report = {{"machine", machineName()},
                 {"frames", options.frames},
                 {"image_side", options.imageSide},
                 {"pixels", settings.front().pixels},
                 {"repetitions", options.repetitions},
                 {"results", json::array()},
                 {"threads_measured", *std::move(threads)},
                 {"steps", json::array()}};
  for (ReconstructSetting& setting : settings) {
    const double median_us = medianOf(setting.cpu_us);
    report["results"].push_back({{"name", setting.name},
                                 {"sweep", setting.sweep->name},
                                 {"interpolation", wordIn(kInterpolationWords, setting.options.interpolation)},
                                 {"fill_method", fillNameOf(setting.options)},
                                 {"fill_reach_mm", setting.options.fillReach_mm},
                                 {"spacing_mm", setting.options.spacing_mm},
                                 {"median_us", median_us},
                                 {"peak_mib", setting.peak_mib},
                                 {"mpx_per_s", static_cast<double>(setting.pixels) / std::max(1e-3, median_us)},
                                 {"measured", std::move(setting.measured)},
                                 {"filled", std::move(setting.filled)}});
    report["steps"].push_back(json(cli::stepRow(setting.name, std::move(setting.cpu_us))));
  }
  auto confidence = benchConfidence(options, believing);
  if (!confidence) return passOn(confidence.error());
  report["confidence"] = *std::move(confidence);
  return report;
}

}  // namespace ew
