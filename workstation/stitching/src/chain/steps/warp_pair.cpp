#include "chain/steps/warp_pair.h"

#include "chain/chain_json.h"
#include "chain/chain_memory.h"
#include "chain/thread_clock.h"
#include "ew/io/safe_file.h"

namespace ew::stitching {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;
using registration::Verdict;

constexpr const char* kWarpStep = "bends";
constexpr double kUnconfirmed = 0.1;  ///< trust in an elastic pair that the images did not confirm

/// What a pair needs of a view. Without a coverage map black at a volume's border counts as outside, so such a volume stays whole.
PartOfView around(const ViewData& view, const VoxelBox& box) {
  const Grid& grid = view.volume->grid;
  return partOf(view, view.volume->coverage.empty() ? VoxelBox{glm::ivec3(0), grid.dims} : widened(box, grid, kAroundOverlap_mm));
}

Warped named(Warped warped, std::size_t fixed, std::size_t moving) {
  warped.warp.fixed = warped.about.fixed = fixed;
  warped.warp.moving = warped.about.moving = moving;
  warped.warp.trust = warped.about.verdict == Verdict::aligned ? 1.0 : kUnconfirmed;
  return warped;
}

std::optional<Warped> keptWarp(const ChainRun& run, const std::string& key) {
  auto warped = readBack<Warped>(run.store.find(kWarpStep, key), [](const json& data) {
    Warped read;
    read.about = warpedFrom(data.at("outcome"));
    read.warp.fixedToMoving.rigid = transformFrom<frame::Moving, frame::Fixed>(data.at("rigid"));
    read.warp.fixedToMoving.control.nodes = gridFrom(data.at("nodes"));
    return read;
  });
  if (!warped || !readVectors(run, kWarpStep, key, "control.bin", warped->warp.fixedToMoving.control)) return std::nullopt;
  return warped;
}

std::string bytesOf(const std::vector<glm::vec3>& vectors) {
  return {reinterpret_cast<const char*>(vectors.data()), vectors.size() * sizeof(glm::vec3)};
}

}  // namespace

void useWarp(const ChainRun& run, std::size_t fixed, std::size_t moving) {
  run.store.use(kWarpStep,
                keyOfWarp(run.inputs[fixed], run.inputs[moving], run.startOf(fixed, moving), effortOf(run.project, fixed, moving)));
}

Result<void> writeVectors(const ChainRun& run, const char* step, const std::string& key, const std::string& name,
                          const registration::ControlGrid& control) {
  if (auto room = run.store.prepare(step); !room) return room;
  return writeFileSafely(run.store.fileOf(step, key, name), bytesOf(control.displacement_mm));
}

bool readVectors(const ChainRun& run, const char* step, const std::string& key, const std::string& name,
                 registration::ControlGrid& control) {
  const std::size_t count = run.store.bytesOf(step, key, name) == 0 ? 0 : control.nodes.voxelCount();
  return run.store.readValues(step, key, name, count, control.displacement_mm);
}

Result<Warped> warpPair(ChainRun& run, std::size_t f, std::size_t m, const Overlap& overlap, int threads, Progress& progress) {
  const auto start = run.startOf(f, m);
  registration::ElasticOptions options = run.elasticOptions(f, m);
  options.threads = threads;
  const std::string key = keyOfWarp(run.inputs[f], run.inputs[m], start, options.effort);
  if (auto kept = keptWarp(run, key)) return named(std::move(*kept), f, m);
  const PartOfView fixed = around(*run.inputs[f].view, overlap.fixed), moving = around(*run.inputs[m].view, overlap.moving);
  const std::string &fixedName = run.project.volumes[f].name, &movingName = run.project.volumes[m].name;
  const ThreadClock clock;
  auto made = registration::registerElastic(fixed.input(), moving.input(), start, options, progress, run.levelsOf(f, m));
  if (!made) {
    Error problem = made.error();
    if (problem.code != ErrorCode::cancelled)
      problem.message = say<"'%1' and '%2' could not be deformed onto each other. %3">(fixedName, movingName, problem.message);
    return passOn(std::move(problem));
  }
  Warped warped;
  warped.about = {.effort = options.effort,
                  .verdict = made->verdict,
                  .reason = std::move(made->reason),
                  .remarks = std::move(made->remarks),
                  .before = made->before,
                  .after = made->after,
                  .largestMotion_mm = made->largestMotion_mm,
                  .smallestJacobian = made->jacobian.smallest,
                  .levels = std::move(made->levels),
                  .seconds = made->seconds,
                  .processor_s = clock.seconds()};
  ordered_json data = {{"fixed", fixedName},
                       {"moving", movingName},
                       {"outcome", jsonOf(warped.about)},
                       {"rigid", jsonOf(made->fixedToMoving.rigid)},
                       {"nodes", jsonOf(made->fixedToMoving.control.nodes)}};
  if (auto w = writeVectors(run, kWarpStep, key, "control.bin", made->fixedToMoving.control); !w) return passOn(w.error());
  if (auto k = run.store.keep(kWarpStep, key, std::move(data), {"control.bin"}); !k) return passOn(k.error());
  warped.warp.fixedToMoving = std::move(made->fixedToMoving);
  return named(std::move(warped), f, m);
}

}  // namespace ew::stitching
