#include <algorithm>
#include <numeric>

#include "chain/chain_json.h"
#include "chain/chain_memory.h"
#include "chain/concurrent.h"
#include "chain/steps/steps.h"
#include "chain/steps/warp_pair.h"

namespace ew::stitching {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

bool isRejected(const StitchProject& project, std::size_t fixed, std::size_t moving) {
  return std::any_of(project.pairs.begin(), project.pairs.end(), [&](const ProjectPair& pair) {
    return pair.fixed == fixed && pair.moving == moving && pair.decision == Decision::rejected;
  });
}

/// Two views that overlap at the graph's poses.
struct PairMeeting {
  std::size_t fixed = 0;
  std::size_t moving = 0;
  Overlap overlap;
  std::size_t voxels = 0;  ///< of the overlap's box in the fixed view
  std::uint64_t bytes = 0;
};

/// All of them, of loaded views, in order of fixed, then moving.
Result<std::vector<PairMeeting>> meetingsOf(const ChainRun& run, const Progress& progress) {
  std::vector<PairMeeting> meetings;
  for (const std::size_t f : run.included)
    for (const std::size_t m : run.included) {
      if (f >= m || isRejected(run.project, f, m)) continue;
      if (progress.cancelRequested()) return cancelledChain();
      const ChainInput &fixed = run.inputs[f], &moving = run.inputs[m];
      const auto start = run.startOf(f, m);
      const auto overlap = overlapOf(*fixed.view->volume, *moving.view->volume, start);
      if (!overlap) continue;
      meetings.push_back({f, m, *overlap, gridOf(fixed.grid, overlap->fixed).voxelCount(),
                          warpBytes(fixed.grid, moving.grid, start, run.elasticOptions(f, m))});
    }
  return meetings;
}

/// Each pair by itself, in the order of `meetings`.
Result<std::vector<Warped>> warpPairs(ChainRun& run, const std::vector<PairMeeting>& meetings, Progress& progress) {
  // Large ones first, so that no thread is left alone with one in the end.
  std::vector<std::size_t> order(meetings.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return meetings[a].voxels > meetings[b].voxels; });
  std::vector<std::uint64_t> bytes;
  for (const PairMeeting& meeting : meetings) bytes.push_back(meeting.bytes);
  const int atOnce = besideEachOther_bytes(run, std::move(bytes)).pairs;
  std::vector<Warped> warped(meetings.size());
  const auto done = runConcurrently(meetings.size(), atOnce, progress, [&](std::size_t n, Progress& part) -> Result<void> {
    const PairMeeting& each = meetings[order[n]];
    part.report(say<"Deforming %1 and %2">(run.project.volumes[each.fixed].name, run.project.volumes[each.moving].name), 0.0);
    auto made = warpPair(run, each.fixed, each.moving, each.overlap, run.threadsOfEach(atOnce), part);
    if (!made) return passOn(made.error());
    warped[order[n]] = std::move(*made);
    return {};
  });
  if (!done) return passOn(done.error());
  return warped;
}

/// Brings the warps of all pairs together: one warp for each view.
Result<void> share(ChainRun& run, std::vector<PairWarp> warps, Progress& progress) {
  std::vector<const ViewData*> views;
  std::vector<Transform<frame::World, frame::View>> poses;
  std::vector<std::size_t> place(run.inputs.size());
  for (std::size_t n = 0; n < run.included.size(); ++n) {
    place[run.included[n]] = n;
    views.push_back(run.inputs[run.included[n]].view.get());
    poses.push_back(run.poseOf(run.included[n]));
  }
  for (PairWarp& warp : warps) {
    warp.fixed = place[warp.fixed];
    warp.moving = place[warp.moving];
  }
  auto group = warpGroup(views, poses, warps, run.warpOptions(), progress);
  if (!group) return passOn(group.error());
  WarpSummary& summary = run.state.warpSummary;
  for (std::size_t n = 0; n < run.included.size(); ++n) {
    run.state.warps[run.included[n]] = std::move(group->warps[n]);
    summary.largest_mm = std::max(summary.largest_mm, group->largest_mm[n]);
  }
  summary.smallestJacobian = group->smallestJacobian;
  summary.disagreementMedian_mm = group->disagreementMedian_mm;
  summary.disagreement95_mm = group->disagreement95_mm;
  return {};
}

Result<void> keepWarps(const ChainRun& run) {
  const std::string& key = run.keys[Step::elastic];
  const WarpSummary& summary = run.state.warpSummary;
  ordered_json data = {{"pairs", summary.pairs},
                       {"largest_mm", summary.largest_mm},
                       {"smallest_jacobian", summary.smallestJacobian},
                       {"disagreement_median_mm", summary.disagreementMedian_mm},
                       {"disagreement_95_mm", summary.disagreement95_mm},
                       {"views", ordered_json::array()},
                       {"bent", ordered_json::array()}};
  for (const auto& warped : run.state.warpedPairs)
    data["bent"].push_back({{"fixed", warped.fixed}, {"moving", warped.moving}, {"outcome", jsonOf(warped)}});
  std::vector<std::string> names;
  for (std::size_t v = 0; v < run.inputs.size(); ++v) {
    const auto& warp = run.state.warps[v];
    data["views"].push_back(warp.displacement_mm.empty() ? ordered_json(nullptr) : jsonOf(warp.nodes));
    if (warp.displacement_mm.empty()) continue;
    names.push_back(std::to_string(v) + ".bin");
    if (auto w = writeVectors(run, nameOf(Step::elastic), key, names.back(), warp); !w) return w;
  }
  return run.store.keep(nameOf(Step::elastic), key, std::move(data), names);
}

bool readWarps(ChainRun& run) {
  const std::string& key = run.keys[Step::elastic];
  ChainState& state = run.state;
  const auto data = run.store.find(nameOf(Step::elastic), key);
  const bool read = readBack<bool>(data, [&](const json& about) {
                      const auto& views = about.at("views");
                      if (views.size() != run.inputs.size()) return false;
                      state.warps.assign(run.inputs.size(), {});
                      for (std::size_t v = 0; v < run.inputs.size(); ++v) {
                        if (views.at(v).is_null()) continue;
                        state.warps[v].nodes = gridFrom(views.at(v));
                        if (!readVectors(run, nameOf(Step::elastic), key, std::to_string(v) + ".bin", state.warps[v])) return false;
                      }
                      state.warpSummary = {about.at("pairs").get<std::size_t>(), about.at("largest_mm").get<double>(),
                                           about.at("smallest_jacobian").get<double>(), about.at("disagreement_median_mm").get<double>(),
                                           about.at("disagreement_95_mm").get<double>()};
                      for (const auto& warped : about.at("bent")) {
                        state.warpedPairs.push_back(warpedFrom(warped.at("outcome")));
                        state.warpedPairs.back().fixed = warped.at("fixed").get<std::size_t>();
                        state.warpedPairs.back().moving = warped.at("moving").get<std::size_t>();
                      }
                      return true;
                    }).value_or(false);
  if (!read) state.warpedPairs.clear();
  return read;
}

}  // namespace

Result<void> elasticStep(ChainRun& run, Progress& progress) {
  if (auto fits = checkMemory(run, Step::elastic); !fits) return fits;
  StepOutcome& outcome = run.outcomeOf(Step::elastic);
  outcome.reused = readWarps(run);
  if (outcome.reused) {
    for (const PairDeformation& warped : run.state.warpedPairs) useWarp(run, warped.fixed, warped.moving);
    return {};
  }
  run.state.warps.assign(run.inputs.size(), {});
  if (run.settings.elastic && run.included.size() > 1) {
    for (const std::size_t v : run.included)
      if (auto loaded = run.inputs.load(v, progress); !loaded) return passOn(loaded.error());
    const auto meetings = meetingsOf(run, progress);
    if (!meetings) return passOn(meetings.error());
    PartOfProgress bending(progress, 0.0, 0.9), sharing(progress, 0.9, 1.0);
    auto warped = warpPairs(run, *meetings, bending);
    if (!warped) return passOn(warped.error());
    std::vector<PairWarp> warps;
    for (Warped& each : *warped) {
      warps.push_back(std::move(each.warp));
      run.state.warpedPairs.push_back(std::move(each.about));
    }
    if (auto shared = share(run, std::move(warps), sharing); !shared) return shared;
    run.state.warpSummary.pairs = meetings->size();
  }
  return keepWarps(run);
}

}  // namespace ew::stitching
