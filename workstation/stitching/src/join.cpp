#include "ew/stitching/join.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>

#include "ew/core/contract.h"
#include "ew/core/elapsed.h"
#include "ew/core/parallel.h"
#include "ew/stitching/distance.h"
#include "grid_flow.h"
#include "joiner.h"
#include "seam_measure.h"

namespace ew::stitching {
namespace {

constexpr std::size_t kMostViews = 255;  // a source is one byte per voxel
/// The voxels one thread makes at a time: long along the rows, small enough that a cancel is heard soon.
constexpr glm::ivec3 kTile{64, 32, 32};
constexpr int kSmallestBlock = 8;
constexpr double kFewestInCube = 64.0;

bool finite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// Beams that say where depth grows, or none.
bool known(const std::optional<Beams>& beams) {
  if (!beams) return true;
  const double length = glm::length(beams->direction);
  return length > 1e-6 && length < 1e6 && (!beams->fan || (finite(beams->fan->from_mm) && finite(beams->fan->to_mm)));
}

/// Keeps the result in memory.
class MemorySink final : public BlockSink {
 public:
  MemorySink(const Grid& grid, JoinResult& result) : result_(result) {
    result.volume.grid = grid;
    result.volume.echo.assign(grid.voxelCount(), 0);
    result.volume.coverage.assign(grid.voxelCount(), 0);
    result.source.assign(grid.voxelCount(), 0);
  }
  Result<void> put(const glm::ivec3& corner, const glm::ivec3& size, std::span<const std::uint8_t> echo,
                   std::span<const std::uint8_t> coverage, std::span<const std::uint8_t> source) override {
    const auto row = static_cast<std::size_t>(size.x);
    std::size_t from = 0;
    for (int k = corner.z; k < corner.z + size.z; ++k)
      for (int j = corner.y; j < corner.y + size.y; ++j, from += row) {
        const std::size_t to = result_.volume.grid.indexOf(corner.x, j, k);
        std::memcpy(result_.volume.echo.data() + to, echo.data() + from, row);
        std::memcpy(result_.volume.coverage.data() + to, coverage.data() + from, row);
        std::memcpy(result_.source.data() + to, source.data() + from, row);
      }
    return {};
  }

 private:
  JoinResult& result_;
};

Result<void> checkJoin(std::span<const View> views, const SeamMap& seams, const Grid& result, const JoinOptions& options) {
  if (auto good = checkViews(views); !good) return good;
  if (auto good = checkGrid(result); !good) return good;
  if (auto good = checkSeamOptions(options.seam, views.size()); !good) return good;
  if (options.block < kSmallestBlock)
    return failure(ErrorCode::badField, say<"The blocks of a join must be at least 8 voxels wide.">(), {{"field", "block"}});
  if (options.seam.method == SeamMethod::feather) return {};
  if (seams.view.size() != seams.cells.voxelCount() || !ratioOf(seams.cells, result))
    return failure(ErrorCode::badField, say<"The seams were found for another grid; find them again for this one.">(),
                   {{"field", "seams"}});
  bool whole = seams.levels.empty() || seams.levels.size() == views.size();
  for (const SeamMap::Levels& each : seams.levels)
    whole = whole && glm::all(glm::greaterThanEqual(glm::min(each.begin, each.size), glm::ivec3(0))) &&
            glm::all(glm::lessThanEqual(each.begin + each.size, seams.cells.dims)) &&
            each.offset.size() ==
                static_cast<std::size_t>(each.size.x) * static_cast<std::size_t>(each.size.y) * static_cast<std::size_t>(each.size.z);
  if (!whole) return failure(ErrorCode::badField, say<"The seams have levels of other volumes; find them again.">(), {{"field", "seams"}});
  const auto highest = seams.view.empty() ? seams.view.end() : std::max_element(seams.view.begin(), seams.view.end());
  if (highest != seams.view.end() && *highest > views.size())
    return failure(ErrorCode::badField, say<"The seams name more volumes than there are; find them again.">(), {{"field", "seams"}});
  return {};
}

/// Without coverage the black outside of a fan counts as seen, and darkens what another volume shows there.
void noteMissingCoverage(std::span<const View> views, std::vector<Message>& notes) {
  constexpr double suspicious = 0.05;
  if (views.size() < 2) return;
  for (const auto& view : views) {
    if (!view.volume->coverage.empty()) continue;
    const auto black = std::count(view.volume->echo.begin(), view.volume->echo.end(), std::uint8_t{0});
    if (static_cast<double>(black) > suspicious * static_cast<double>(view.volume->echo.size()))
      notes.push_back(say<"Volume '%1' has no coverage, so its black voxels count as measured and darken the blend; give its coverage "
                          "file if there is one.">(view.name));
  }
}

void report(const Tally& sums, std::span<const View> views, bool seams, JoinReport& report) {
  report.contributions = sums.contributions;
  for (std::size_t n = 0; n < views.size(); ++n) report.contributions[n].name = views[n].name;
  if (sums.covered > 0) report.overlapShare = static_cast<double>(sums.overlapping) / static_cast<double>(sums.covered);
  if (sums.blended > 0) report.disagreementRms = std::sqrt(sums.squaredSpread / static_cast<double>(sums.blended));
  for (const auto& each : report.contributions)
    if (each.voxels == 0)
      report.notes.push_back(seams ? say<"Volume '%1' contributed nothing: other volumes show all that it covers better.">(each.name)
                                   : say<"Volume '%1' contributed nothing: none of its voxels are covered.">(each.name));
  if (views.size() > 1 && sums.overlapping == 0)
    report.notes.push_back(say<"The volumes do not overlap anywhere, so nothing was blended; check their places if they should.">());
  noteMissingCoverage(views, report.notes);
}

std::uint64_t blockBytes(const glm::ivec3& dims, int block) {
  const glm::ivec3 size = glm::min(dims, glm::ivec3(block));
  return 3ull * static_cast<std::uint64_t>(size.x) * static_cast<std::uint64_t>(size.y) * static_cast<std::uint64_t>(size.z);
}

/// How wide the passage from view to view is, for measuring it.
double widthOf(const JoinOptions& options) {
  return options.seam.method == SeamMethod::feather ? std::max(1.0, 0.5 * options.grid.featherWidth_mm) : options.seam.blend_mm;
}

/// The cells that a view's box touches.
CellBox boxOf(const GridPlacement& view, const Grid& cells) {
  const auto voxelToCell = cells.worldToVoxel() * placed(view.grid, view.toWorld).voxelToWorld();
  glm::dvec3 low(1e300);
  glm::dvec3 high(-1e300);
  for (int corner = 0; corner < 8; ++corner) {
    const glm::ivec3 last = view.grid.dims - 1;
    const glm::dvec3 ijk((corner & 1) ? last.x : 0, (corner & 2) ? last.y : 0, (corner & 4) ? last.z : 0);
    const glm::dvec3 at = (voxelToCell * Point<frame::Voxel>{ijk}).at;
    low = glm::min(low, at);
    high = glm::max(high, at);
  }
  return {glm::max(glm::ivec3(glm::floor(low)), glm::ivec3(0)), glm::min(glm::ivec3(glm::ceil(high)) + 1, cells.dims)};
}

/// What findSeams needs beside the map itself: what each view shows on the cells it reaches, and the largest cut.
std::uint64_t seamBytes(std::span<const GridPlacement> views, const Grid& cells, const SeamOptions& options) {
  std::uint64_t kept = options.strokes.empty() ? 0 : cells.voxelCount();
  std::uint64_t largest = 0;
  std::vector<CellBox> boxes;
  for (const GridPlacement& view : views) boxes.push_back(boxOf(view, cells));
  for (std::size_t n = 0; n < boxes.size(); ++n) {
    kept += boxes[n].count() *
            (2 + 1 + 1 +
             std::max(2, options.levelBlend_mm > 0.0 ? 1 + 1 + 2 : 0));  // level, share, trust; cost, or border, nearness and offset
    largest = std::max<std::uint64_t>(largest, boxes[n].count() * 12);   // two sums while looking, or distances with their coverage
    CellBox contested{boxes[n].end, boxes[n].begin};
    for (std::size_t m = 0; m < boxes.size(); ++m) {
      const CellBox shared{glm::max(boxes[n].begin, boxes[m].begin), glm::min(boxes[n].end, boxes[m].end)};
      if (m == n || shared.count() == 0) continue;
      contested = {glm::min(contested.begin, shared.begin), glm::max(contested.end, shared.end)};
    }
    largest = std::max<std::uint64_t>(largest, contested.count() * GridFlow::kBytesPerCell);
  }
  if (options.levelBlend_mm > 0.0) largest = std::max<std::uint64_t>(largest, 9 * cells.voxelCount() + largest / 3);
  return kept + largest + (options.method == SeamMethod::nearest ? 4 * cells.voxelCount() : 0);
}

/// What joining needs before its first block: one distance per voxel of every view, for a feather.
Result<std::vector<std::vector<float>>> distancesOf(std::span<const View> views, const JoinOptions& options, Progress& progress) {
  std::vector<std::vector<float>> distances_mm;
  if (options.seam.method != SeamMethod::feather || options.grid.featherWidth_mm <= 0.0) return distances_mm;
  const auto all = static_cast<double>(views.size());
  for (const View& view : views) {
    const auto n = static_cast<double>(distances_mm.size());
    PartOfProgress part(progress, n / all, (n + 1.0) / all);
    auto distance = distanceFromBorder_mm(*view.volume, options.grid.featherWidth_mm, options.grid.threads, part);
    if (!distance) return passOn(distance.error());
    distances_mm.push_back(std::move(*distance));
  }
  return distances_mm;
}

}  // namespace

BlockSink::~BlockSink() = default;

Result<void> checkViews(std::span<const View> views) {
  if (views.empty()) return failure(ErrorCode::emptyVolume, say<"There is no volume to stitch; add at least one.">());
  if (views.size() > kMostViews)
    return failure(ErrorCode::unsupported, say<"At most %1 volumes can be stitched at once; stitch them in groups.">(kMostViews));
  for (const View& view : views) {
    EW_EXPECTS(view.volume != nullptr);
    const auto about = [&](Error problem) {
      problem.message = say<"Volume '%1' cannot be stitched. %2">(view.name, problem.message);
      problem.context.emplace_back("volume", view.name);
      return passOn(std::move(problem));
    };
    if (auto good = checkGrid(view.volume->grid); !good) return about(good.error());
    if (auto rigid = checkRigid(view.toWorld); !rigid) return about(rigid.error());
    const GreyCorrection& correction = view.correction;
    bool sound = correction.grey.empty() || (correction.knot_mm > 0.0 && std::isfinite(correction.firstKnot_mm) &&
                                             std::isfinite(correction.knot_mm) && known(correction.beams));
    for (const double grey : correction.grey) sound = sound && std::isfinite(grey);
    if (!sound)
      return about({ErrorCode::badField, say<"Its grey correction has a number that cannot be used.">(), {{"field", "correction"}}});
    if (view.warp == nullptr || view.warp->displacement_mm.empty()) continue;
    if (auto good = checkGrid(view.warp->nodes); !good) return about(good.error());
    sound = view.warp->displacement_mm.size() == view.warp->nodes.voxelCount();
    for (const glm::vec3& u : view.warp->displacement_mm) sound = sound && finite(u);
    if (!sound)
      return about(
          {ErrorCode::badField, say<"Its deformation has a displacement too many, too few or without a number.">(), {{"field", "bend"}}});
  }
  return {};
}

Result<void> checkSeamOptions(const SeamOptions& options, std::size_t views) {
  const auto refuse = [](const char* field, Message sentence) {
    return failure(ErrorCode::badField, std::move(sentence), {{"field", field}});
  };
  if (!(options.cell_mm > 0.0 && options.cell_mm < 1e3)) return refuse("cell_mm", say<"The cells of the seam must be wider than 0 mm.">());
  if (!(options.blend_mm >= 0.0 && options.blend_mm < 1e3))
    return refuse("blend_mm", say<"The blend beside the seam must be 0 or a positive number of mm.">());
  if (!(options.levelBlend_mm >= 0.0 && options.levelBlend_mm < 1e3))
    return refuse("level_blend_mm", say<"The blend of levels beside the seam must be 0 or a positive number of mm.">());
  if (!(options.confidenceWeight >= 0.0 && options.confidenceWeight < 1e3 && options.distanceWeight >= 0.0 && options.distanceWeight < 1e3))
    return refuse("confidence_weight", say<"The weights of a seam must be 0 or positive.">());
  for (const SeamStroke& stroke : options.strokes)
    if (stroke.view >= views || !finite(stroke.at_mm) || !(stroke.radius_mm > 0.0) || !std::isfinite(stroke.radius_mm))
      return refuse("strokes", say<"A stroke of the seam editor names a volume that is not there, or has no place or radius.">());
  return {};
}

Result<StitchForecast> forecastJoin(std::span<const GridPlacement> views, const JoinOptions& options) {
  StitchOptions unlimited = options.grid;
  unlimited.maxBytes = UINT64_MAX;
  auto forecast = forecastStitch(views, unlimited);
  if (!forecast) return forecast;
  const Grid& grid = forecast->grid;
  const auto threads = static_cast<std::uint64_t>(threadCount(options.grid.threads));
  const std::uint64_t blocks = blockBytes(grid.dims, std::max(options.block, kSmallestBlock));
  const glm::ivec3 ratio = cellRatio(grid, options.seam.cell_mm);
  const Grid cells = cellGrid(grid, ratio);
  if (options.seam.method == SeamMethod::feather) {
    std::uint64_t distances = 0;
    if (options.grid.featherWidth_mm > 0.0)
      for (const GridPlacement& view : views) distances += 4 * view.grid.voxelCount();
    forecast->bytes = distances + blocks + threads * Joiner::scratchBytes(kTile, 1, cells, ratio);
  } else {
    const std::uint64_t joining = blocks + threads * Joiner::scratchBytes(kTile, views.size(), cells, ratio);
    forecast->bytes = cells.voxelCount() + std::max(joining, seamBytes(views, cells, options.seam));
  }
  if (forecast->bytes > options.grid.maxBytes)
    return failure(ErrorCode::tooLarge,
                   say<"Joining would need %1 MiB, and the limit is %2 MiB; choose a coarser spacing or smaller blocks.">(
                       forecast->bytes >> 20, options.grid.maxBytes >> 20),
                   {{"bytes", std::to_string(forecast->bytes)}});
  return forecast;
}

namespace {

/// @param measure sums for the seams' visibility, block by block; null when someone else measures the whole
Result<JoinReport> joinBlocks(std::span<const View> views, const SeamMap& seams, const Grid& result, const JoinOptions& options,
                              BlockSink& sink, SeamMeasure* measure, Progress& progress) {
  const bool feathers = options.seam.method == SeamMethod::feather;
  const double begun = feathers && options.grid.featherWidth_mm > 0.0 ? 0.3 : 0.0;
  PartOfProgress first(progress, 0.0, begun);
  auto distances_mm = distancesOf(views, options, first);
  if (!distances_mm) return passOn(distances_mm.error());
  const Joiner joiner(views, feathers ? nullptr : &seams, result, options, *distances_mm);

  const glm::ivec3 blocks = (result.dims + options.block - 1) / options.block;
  const int count = blocks.x * blocks.y * blocks.z;
  std::vector<std::uint8_t> voxels;
  Tally all;
  all.contributions.resize(views.size());
  for (int b = 0; b < count; ++b) {
    const glm::ivec3 corner = options.block * glm::ivec3(b % blocks.x, b / blocks.x % blocks.y, b / blocks.x / blocks.y);
    const glm::ivec3 size = glm::min(result.dims - corner, glm::ivec3(options.block));
    const std::size_t each = samplesIn(size);
    voxels.assign(3 * each, 0);
    const BlockArrays arrays{corner, size, voxels.data(), voxels.data() + each, voxels.data() + 2 * each};
    const glm::ivec3 tiles = (size + kTile - 1) / kTile;
    std::vector<Tally> tallies(static_cast<std::size_t>(tiles.x * tiles.y * tiles.z));
    PartOfProgress part(progress, begun + (1.0 - begun) * b / count, begun + (1.0 - begun) * (b + 1) / count);
    const bool whole = forEachTask(
        static_cast<int>(tallies.size()), options.grid.threads, part, say<"Blending">(), [&](int task, int, const auto& stopped) {
          const glm::ivec3 begin = corner + kTile * glm::ivec3(task % tiles.x, task / tiles.x % tiles.y, task / tiles.x / tiles.y);
          joiner.make(begin, glm::min(begin + kTile, corner + size), arrays, tallies[static_cast<std::size_t>(task)], stopped);
        });
    if (!whole || progress.cancelRequested()) return stitchingCancelled();
    for (const Tally& tally : tallies) all.add(tally);
    const std::span<const std::uint8_t> made(voxels);
    if (auto put = sink.put(corner, size, made.first(each), made.subspan(each, each), made.last(each)); !put) return passOn(put.error());
    if (measure != nullptr) measure->look(corner, size, made.first(each), made.last(each), [&] { return progress.cancelRequested(); });
  }
  JoinReport made;
  made.grid = result;
  report(all, views, !feathers, made);
  if (!feathers) {
    CommonPart steps;
    for (const auto& [place, sum] : all.steps)
      if (sum.count >= kFewestInCube)
        steps.add({place[0], place[1], 0}, kStepCube_mm * (glm::dvec3(place[2], place[3], place[4]) + 0.5), sum.difference / sum.count,
                  sum.count);
    made.seam.meanStep_db = kDbPerGrey * steps.rms();
  }
  return made;
}

/// The views themselves tell a step of the mean from an edge of tissue that the seam follows; the joined volume alone cannot.
void takeSeam(const SeamVisibility& measured, const JoinOptions& options, JoinReport& report) {
  const double step_db = report.seam.meanStep_db;
  report.seam = measured;
  if (options.seam.method != SeamMethod::feather && options.seam.blend_mm > 0.0) report.seam.meanStep_db = step_db;
}

}  // namespace

Result<JoinReport> join(std::span<const View> views, const SeamMap& seams, const Grid& result, const JoinOptions& options, BlockSink& sink,
                        Progress& progress) {
  const auto started = std::chrono::steady_clock::now();
  if (auto good = checkJoin(views, seams, result, options); !good) return passOn(good.error());
  SeamMeasure measure(result.spacing_mm, widthOf(options));
  auto made = joinBlocks(views, seams, result, options, sink, &measure, progress);
  if (!made) return made;
  if (progress.cancelRequested()) return stitchingCancelled();
  takeSeam(measure.result(), options, *made);
  made->seconds = secondsSince(started);
  return made;
}

Result<JoinResult> join(std::span<const View> views, const SeamMap& seams, const Grid& result, const JoinOptions& options,
                        Progress& progress) {
  const auto started = std::chrono::steady_clock::now();
  if (auto good = checkJoin(views, seams, result, options); !good) return passOn(good.error());
  JoinResult made;
  MemorySink sink(result, made);
  auto report = joinBlocks(views, seams, result, options, sink, nullptr, progress);
  if (!report) return passOn(report.error());
  made.report = std::move(*report);
  SeamMeasure measure(result.spacing_mm, widthOf(options));
  measure.look(glm::ivec3(0), result.dims, made.volume.echo, made.source, [&] { return progress.cancelRequested(); });
  if (progress.cancelRequested()) return stitchingCancelled();
  takeSeam(measure.result(), options, made.report);
  made.report.seconds = secondsSince(started);
  return made;
}

}  // namespace ew::stitching
