#include "bench/volumes/bench_stitch.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <random>

#include "bench/tools/bench_parts.h"
#include "ew/core/memory_watch.h"
#include "ew/core/numbers.h"
#include "ew/core/word_table.h"
#include "ew/phantom/speckle_view.h"
#include "ew/stitching/equalise_views.h"
#include "run/report.h"

namespace ew {
namespace {

using nlohmann::json;
using namespace stitching;

constexpr double kSpacing_mm = 0.5;
constexpr double kDbPerGrey = kSpeckledRange_db / 255.0;

/// The left view has a shadow down the overlap; the right one is brighter, the more so the deeper.
struct Views {
  SpeckleViewRecipe leftRecipe, rightRecipe;
  SpeckleView left, right;
  std::vector<View> views;
  Grid grid;
};

Views viewsOf(const StitchBenchOptions& options) {
  Views made;
  const double wide_mm = kSpacing_mm * options.side;
  made.leftRecipe.dims = glm::ivec3(options.side);
  made.leftRecipe.spacing_mm = kSpacing_mm;
  made.leftRecipe.speckle = 2 * options.seed;
  made.rightRecipe = made.leftRecipe;
  made.rightRecipe.origin_mm.x = kSpacing_mm * std::round(0.6 * options.side);
  made.rightRecipe.speckle = 2 * options.seed + 1;
  made.rightRecipe.gain_db = 4.0;
  made.rightRecipe.depthGain_db = 3.0;
  made.leftRecipe.shadow = SpeckleViewRecipe::Shadow{0.75 * wide_mm, 0.88 * wide_mm, 0.3 * wide_mm, 30.0};
  made.left = speckledView(made.leftRecipe, 0);
  made.right = speckledView(made.rightRecipe, 0);
  for (const SpeckleView* one : {&made.left, &made.right}) {
    View view;
    view.volume = &one->volume;
    view.confidence = one->confidence;
    view.correction.beams = Beams{{0.0, 1.0, 0.0}};
    view.name = one == &made.left ? "left" : "right";
    made.views.push_back(std::move(view));
  }
  return made;
}

std::vector<GridPlacement> gridsOf(const std::vector<View>& views) {
  std::vector<GridPlacement> grids;
  for (const View& view : views) grids.push_back({view.volume->grid, view.toWorld, view.name});
  return grids;
}

/// Mean level in the shadow, edges left out, less the truth; dB. Corrections count as they were found: the right view's gain was its own.
double shadowError_db(const Views& made, const JoinResult& joined) {
  const auto& shadow = *made.leftRecipe.shadow;
  const Grid& grid = joined.volume.grid;
  double sum = 0.0, count = 0.0;
  for (int k = 4; k < grid.dims.z - 4; ++k)
    for (int j = 0; j < grid.dims.y - 4; ++j)
      for (int i = 0; i < grid.dims.x; ++i) {
        const glm::dvec3 p_mm = (grid.voxelToWorld() * Point<frame::Voxel>{glm::dvec3(i, j, k)}).at;
        if (p_mm.x < shadow.from_mm + 1.5 || p_mm.x > shadow.to_mm - 1.5 || p_mm.y < shadow.below_mm + 3.0) continue;
        // Half of the gain between the views went to each: the left view without its shadow, corrected, is what should stand there.
        const double expected_db = speckledScene_db(p_mm) - 2.5 + made.views[0].correction.at(p_mm) * kDbPerGrey;
        const double level_db = joined.volume.echo[grid.indexOf(i, j, k)] * kDbPerGrey - kSpeckledRange_db;
        sum += level_db - std::max(expected_db, -kSpeckledRange_db);
        count += 1.0;
      }
  return count > 0.0 ? sum / count : 0.0;
}

constexpr WordTable<SeamMethod, 3> kSeamMethodWords{
    {{"feather", SeamMethod::feather}, {"nearest", SeamMethod::nearest}, {"graph_cut", SeamMethod::graphCut}}};
const char* nameOf(SeamMethod method) { return wordIn(kSeamMethodWords, method); }

struct StitchSetting {  // NOLINT(bugprone-exception-escape): JSON is moved without an exception
  std::string name;
  JoinOptions options;
  int block = 0;  ///< 0: whole
  JoinResult result;
  std::vector<double> find_us, join_us;
  json peak_mib;  ///< beyond the views
};

std::vector<StitchSetting> settingsOf() {
  std::vector<StitchSetting> settings;
  const auto add = [&](SeamMethod method, double cell_mm, double blend_mm, int block) {
    StitchSetting setting;
    setting.options.seam.method = method;
    setting.options.seam.cell_mm = cell_mm;
    setting.options.seam.blend_mm = blend_mm;
    setting.options.seam.threads = setting.options.grid.threads = 1;
    setting.block = block;
    if (block > 0) setting.options.block = block;
    setting.name = std::string("stitch_") + nameOf(method);
    if (method != SeamMethod::feather) setting.name += "/cell_" + textOf(cell_mm) + "mm/blend_" + textOf(blend_mm) + "mm";
    if (block > 0) setting.name += "/block_" + std::to_string(block);
    settings.push_back(std::move(setting));
  };
  add(SeamMethod::feather, 1.5, 3.0, 0);
  for (const double blend_mm : {0.0, 3.0}) add(SeamMethod::nearest, 1.5, blend_mm, 0);
  for (const double blend_mm : {0.0, 1.5, 2.5, 3.0, 5.0}) add(SeamMethod::graphCut, 1.5, blend_mm, 0);
  for (const double cell_mm : {1.0, 2.0, 3.0}) add(SeamMethod::graphCut, cell_mm, 3.0, 0);
  for (const int block : {32, 64, 128}) add(SeamMethod::graphCut, 1.5, 3.0, block);
  return settings;
}

/// Blocks into memory, to compare them with the whole.
class Whole final : public BlockSink {
 public:
  explicit Whole(const Grid& grid) : grid_(grid), echo(grid.voxelCount()) {}
  Result<void> put(const glm::ivec3& corner, const glm::ivec3& size, std::span<const std::uint8_t> voxels, std::span<const std::uint8_t>,
                   std::span<const std::uint8_t>) override {
    auto from = voxels.begin();
    for (int k = corner.z; k < corner.z + size.z; ++k)
      for (int j = corner.y; j < corner.y + size.y; ++j, from += size.x)
        std::copy(from, from + size.x, echo.begin() + static_cast<std::ptrdiff_t>(grid_.indexOf(corner.x, j, k)));
    return {};
  }

 private:
  Grid grid_;

 public:
  std::vector<std::uint8_t> echo;
};

double wall_us() { return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

/// One run; the result of the last is kept.
Result<void> run(const Views& made, StitchSetting& setting, double (*clock_us)(), Progress& progress) {
  setting.result = {};
  const MemoryWatch memory;
  const double begun_us = clock_us();
  const auto seams = findSeams(made.views, made.grid, setting.options.seam, progress);
  if (!seams) return passOn(seams.error());
  const double found_us = clock_us();
  if (setting.block > 0) {
    Whole sink(made.grid);
    auto report = join(made.views, *seams, made.grid, setting.options, sink, progress);
    if (!report) return passOn(report.error());
    setting.join_us.push_back(clock_us() - found_us);
    setting.result.volume = {made.grid, std::move(sink.echo), {}};
    setting.result.report = std::move(*report);
  } else {
    auto joined = join(made.views, *seams, made.grid, setting.options, progress);
    if (!joined) return passOn(joined.error());
    setting.join_us.push_back(clock_us() - found_us);
    setting.result = std::move(*joined);
  }
  setting.find_us.push_back(found_us - begun_us);
  setting.peak_mib = peakOf(memory);
  return {};
}

double threadTime_us() { return 1e6 * threadTime_s(); }

json rowOf(const Views& made, const StitchSetting& setting) {
  const SeamVisibility& seam = setting.result.report.seam;
  const auto forecast = forecastJoin(gridsOf(made.views), setting.options);
  const double worst =
      std::max({std::abs(seam.derivativeRatio - 1.0) / 0.05, std::abs(seam.speckleRatio - 1.0) / 0.05, seam.meanStep_db / 0.5});
  std::vector<double> both_us;
  for (std::size_t n = 0; n < setting.find_us.size(); ++n) both_us.push_back(setting.find_us[n] + setting.join_us[n]);
  return {{"name", setting.name},
          {"method", nameOf(setting.options.seam.method)},
          {"cell_mm", setting.options.seam.cell_mm},
          {"blend_mm", setting.options.seam.blend_mm},
          {"block", setting.block},
          {"median_us", medianOf(both_us)},
          {"find_us", medianOf(setting.find_us)},
          {"join_us", medianOf(setting.join_us)},
          {"derivative_ratio", seam.derivativeRatio},
          {"speckle_ratio", seam.speckleRatio},
          {"step_db", seam.meanStep_db},
          {"shadow_error_db", shadowError_db(made, setting.result)},
          {"seam_times_limit", worst},
          {"peak_mib", setting.peak_mib},
          {"forecast_mib", forecast ? static_cast<double>(forecast->bytes) / (1024.0 * 1024.0) : 0.0}};
}

/// One thread and two in turns, by the clock on the wall, for the default setting.
Result<json> timeThreads(const Views& made, const StitchSetting& like, int repetitions, Progress& progress) {
  StitchSetting one = like, two = like;
  for (StitchSetting* setting : {&one, &two}) {
    setting->find_us.clear();
    setting->join_us.clear();
    setting->options.seam.threads = setting->options.grid.threads = setting == &one ? 1 : 2;
  }
  for (int repetition = 0; repetition < repetitions; ++repetition)
    for (StitchSetting* setting : {&one, &two})
      if (auto done = run(made, *setting, wall_us, progress); !done) return passOn(done.error());
  const auto total_us = [](const StitchSetting& setting) { return medianOf(setting.find_us) + medianOf(setting.join_us); };
  return json::array({{{"name", like.name},
                       {"one_us", total_us(one)},
                       {"two_us", total_us(two)},
                       {"times_faster", total_us(one) / total_us(two)},
                       {"same_voxels", one.result.volume.echo == two.result.volume.echo}}});
}

}  // namespace

Result<json> benchStitch(const StitchBenchOptions& options, Progress& progress) {
  if (options.side < 64 || options.side > 320)
    return failure(ErrorCode::badUsage, say<"The side of a view must lie between 64 and 320 voxels.">());
  if (options.repetitions < 1 || options.repetitions > 1000)
    return failure(ErrorCode::badUsage, say<"The number of repetitions must lie between 1 and 1000.">());
  progress.report(say<"Drawing views of a known scene">(), 0.0);
  Views made = viewsOf(options);
  StitchOptions unlimited;
  const auto forecast = forecastStitch(gridsOf(made.views), unlimited);
  if (!forecast) return passOn(forecast.error());
  made.grid = forecast->grid;

  EqualiseViewsOptions equalising;
  equalising.threads = 1;
  std::vector<double> equalise_us;
  PartOfProgress looking(progress, 0.05, 0.1);
  Result<ViewEqualisation> equalised = ViewEqualisation{};
  for (int repetition = 0; repetition < options.repetitions; ++repetition) {
    const double begun_us = threadTime_us();
    equalised = equaliseViews(made.views, equalising, noProgress());
    equalise_us.push_back(threadTime_us() - begun_us);
    if (!equalised) return passOn(equalised.error());
    if (progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"The benchmark was stopped.">());
  }
  for (std::size_t n = 0; n < made.views.size(); ++n) made.views[n].correction = equalised->corrections[n];

  std::vector<StitchSetting> settings = settingsOf();
  std::vector<std::size_t> order(settings.size());
  for (std::size_t n = 0; n < order.size(); ++n) order[n] = n;
  std::mt19937 random(7);
  for (int repetition = 0; repetition < options.repetitions; ++repetition) {
    std::shuffle(order.begin(), order.end(), random);
    for (std::size_t n = 0; n < order.size(); ++n) {
      const double done = (repetition + static_cast<double>(n) / static_cast<double>(order.size())) / options.repetitions;
      progress.report(say<"Timing seams and blends">(), 0.1 + 0.8 * done);
      if (progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"The benchmark was stopped.">());
      if (auto ran = run(made, settings[order[n]], threadTime_us, noProgress()); !ran) return passOn(ran.error());
    }
  }
  const auto standard = std::find_if(settings.begin(), settings.end(),
                                     [](const StitchSetting& s) { return s.name == "stitch_graph_cut/cell_1.5mm/blend_3mm"; });
  PartOfProgress threading(progress, 0.9, 1.0);
  auto threads = timeThreads(made, *standard, options.repetitions, threading);
  if (!threads) return passOn(threads.error());

  json report = {{"machine", machineName()},
                 {"side", options.side},
                 {"repetitions", options.repetitions},
                 {"seed", options.seed},
                 {"equalise",
                  {{"median_us", medianOf(equalise_us)},
                   {"before_db", equalised->disagreementBefore_db},
                   {"after_db", equalised->disagreementAfter_db}}},
                 {"results", json::array()},
                 {"threads_measured", *std::move(threads)},
                 {"steps", json::array()}};
  for (StitchSetting& setting : settings) {
    json row = rowOf(made, setting);
    if (setting.block > 0) row["same_as_whole"] = setting.result.volume.echo == standard->result.volume.echo;
    report["results"].push_back(std::move(row));
    std::vector<double> both_us;
    for (std::size_t n = 0; n < setting.find_us.size(); ++n) both_us.push_back(setting.find_us[n] + setting.join_us[n]);
    report["steps"].push_back(json(cli::stepRow(setting.name, std::move(both_us))));
  }
  return report;
}

}  // namespace ew
