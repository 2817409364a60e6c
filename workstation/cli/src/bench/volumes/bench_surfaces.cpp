#include "bench/volumes/bench_surfaces.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "bench/tools/bench_parts.h"
#include "bench/volumes/surfaces_peer.h"
#include "bench/volumes/surfaces_truth.h"
#include "ew/core/elapsed.h"
#include "ew/core/figures.h"
#include "ew/core/foreign_json.h"
#include "ew/core/order_statistics.h"

namespace ew {
namespace {

using labelling::LabelSurfaces;
using nlohmann::json;

/// One way to make the surfaces.
struct SurfacesMaker {
  std::string name;
  std::function<Result<void>()> make;
  std::function<LabelSurfaces()> made;  ///< by the last call of `make`
  std::vector<double> wall_us, cpu_us;
};

/// They take turns, so that a busy moment of the machine falls on no one alone. The first turn, in which pools start, does not count.
Result<void> timeMakers(std::vector<SurfacesMaker>& makers, int repetitions, Progress& progress) {
  for (int turn = 0; turn <= repetitions; ++turn)
    for (SurfacesMaker& each : makers) {
      progress.report(say<"Timing surfaces">(), static_cast<double>(turn) / (repetitions + 1));
      if (progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"The benchmark was stopped.">());
      const std::clock_t cpu = std::clock();
      const auto start = std::chrono::steady_clock::now();
      if (auto made = each.make(); !made) return made;
      if (turn == 0) continue;
      each.wall_us.push_back(1e6 * secondsSince(start));
      each.cpu_us.push_back(1e6 * static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC);
    }
  return {};
}

json rowOf(const SurfacesMaker& maker, const TrueOrgans& organs, const Volume& labels) {
  const LabelSurfaces surfaces = maker.made();
  const SurfacesAccuracy accuracy = accuracyOf(surfaces, organs, labels);
  return {{"name", maker.name},
          {"median_us", medianOf(maker.wall_us)},
          {"cpu_us", medianOf(maker.cpu_us)},
          {"points", surfaces.points_mm.size()},
          {"triangles", surfaces.triangles.size()},
          {"farthest_voxel", accuracy.farthest},
          {"farthest_back_voxel", accuracy.farthestBack},
          {"mean_voxel", accuracy.mean},
          {"normal_deg", accuracy.normal_deg},
          {"volume_percent", accuracy.volume_percent}};
}

json shown(const std::string& name, double value, double limit) {
  return {{"name", name}, {"value", value}, {"limit", limit}, {"met", value <= limit}};
}

json mustShow(const json& own, const json* peer) {
  json all = json::array();
  all.push_back(shown("seconds for all organs", own["median_us"].get<double>() * 1e-6, 1.0));
  all.push_back(shown("farthest from the shapes, in voxels", own["farthest_voxel"].get<double>(), 1.0));
  all.push_back(shown("farthest from the surfaces, in voxels", own["farthest_back_voxel"].get<double>(), 1.0));
  if (peer != nullptr)
    all.push_back(shown("share of VTK's time", own["median_us"].get<double>() / (*peer)["median_us"].get<double>(), 0.25));
  return all;
}

Result<void> checkSurfacesBench(const SurfacesBenchOptions& options) {
  if (options.side < 32 || options.side > 512 || options.threads < 1 || options.threads > 256 || options.repetitions < 1 ||
      options.repetitions > 1000)
    return failure(ErrorCode::badUsage,
                   say<"A bench of surfaces takes 32 to 512 voxels a side, 1 to 256 threads and 1 to 1000 repetitions.">());
  return {};
}

}  // namespace

Result<json> benchSurfaces(const SurfacesBenchOptions& options, Progress& progress) {
  if (auto usable = checkSurfacesBench(options); !usable) return passOn(usable.error());
  PartOfProgress drawing(progress, 0.0, 0.3), timing(progress, 0.3, 0.9);
  const TrueOrgans organs(options.side);
  const auto labels = organs.labels(drawing);
  if (!labels) return passOn(labels.error());
  const std::string size = "surfaces/" + std::to_string(options.side) + "cubed/";
  const auto own = [&](int threads) {
    const auto made = std::make_shared<LabelSurfaces>();
    return SurfacesMaker{size + std::to_string(threads) + (threads == 1 ? "thread" : "threads"),
                         [made, &labels, threads]() -> Result<void> {
                           auto surfaces = labelling::labelSurfaces(labels->view(), {.threads = threads}, noProgress());
                           if (!surfaces) return passOn(surfaces.error());
                           *made = *std::move(surfaces);
                           return {};
                         },
                         [made] { return *made; },
                         {},
                         {}};
  };
  std::vector<SurfacesMaker> makers = {own(options.threads)};
  if (options.threads != 1) makers.push_back(own(1));
  std::optional<PeerSurfaces> peer;
  if (options.peers) {
    peer.emplace(*labels);
    makers.push_back({size + "VTK",
                      [&peer]() -> Result<void> {
                        peer->make();
                        return {};
                      },
                      [&peer] { return peer->made(); },
                      {},
                      {}});
  }
  if (auto timed = timeMakers(makers, options.repetitions, timing); !timed) return passOn(timed.error());
  json results = json::array(), steps = json::array();
  for (const SurfacesMaker& each : makers) results.push_back(rowOf(each, organs, *labels));
  const json* const theirs = options.peers ? &results.back() : nullptr;
  if (theirs != nullptr)
    for (json& row : results)
      if (&row != theirs) row["of_peer"] = row["median_us"].get<double>() / (*theirs)["median_us"].get<double>();
  const json must = mustShow(results.front(), theirs);
  return json{
      {"machine", machineName()},           {"side", options.side},          {"labels", organs.count()}, {"threads", options.threads},
      {"repetitions", options.repetitions}, {"results", std::move(results)}, {"must_show", must},        {"steps", std::move(steps)}};
}

std::vector<BenchSection> surfacesSections(const json& report) {
  BenchSection section;
  section.title =
      "Surfaces of " + std::to_string(report["labels"].get<int>()) + " labels, " + std::to_string(report["side"].get<int>()) + " cubed";
  section.text =
      "Smooth, closed surfaces of labelled organs whose shapes are known. VTK: vtkDiscreteFlyingEdges3D with vtkWindowedSincPolyDataFilter "
      "(20 iterations, pass band 0.05), a surface of its own for each label; ours are joint.";
  section.table.columns = {"way",          "time, ms",     "processor, ms",    "triangles",      "farthest, voxels",
                           "back, voxels", "mean, voxels", "normals, degrees", "worst volume, %"};
  for (const json& row : listAt(report, "results")) {
    const auto number = [&](const char* key, double scale, int decimals) { return fixedText(scale * row[key].get<double>(), decimals); };
    section.table.rows.push_back({row["name"].get<std::string>(), number("median_us", 1e-3, 1), number("cpu_us", 1e-3, 1),
                                  number("triangles", 1.0, 0), number("farthest_voxel", 1.0, 2), number("farthest_back_voxel", 1.0, 2),
                                  number("mean_voxel", 1.0, 3), number("normal_deg", 1.0, 2), number("volume_percent", 1.0, 2)});
    section.bars.push_back({row["name"].get<std::string>(), 1e-3 * row["median_us"].get<double>(),
                            row.contains("of_peer") ? BenchMark::own : BenchMark::peer});
  }
  return {section};
}

}  // namespace ew
