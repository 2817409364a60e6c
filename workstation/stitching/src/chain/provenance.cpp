#include "chain/provenance.h"

#include <algorithm>

#include "chain/chain_json.h"
#include "ew/core/version.h"

namespace ew::stitching {
namespace {

using nlohmann::ordered_json;

ordered_json inputOf(const StitchProject& project, const ChainState& state, std::size_t v) {
  const ProjectVolume& volume = project.volumes[v];
  ordered_json input = {{"source_value", v + 1}, {"name", volume.name}, {"file", volume.file.generic_string()}};
  if (!volume.coverage.empty()) input["coverage"] = volume.coverage.generic_string();
  if (!volume.confidence.empty()) input["confidence"] = volume.confidence.generic_string();
  if (volume.spacing_mm > 0.0) input["spacing_mm"] = volume.spacing_mm;
  input["placement"] = nameOf(volume.placement);
  if (volume.placement != Placement::unknown) input["placed_to_world"] = jsonOf(volume.toWorld);
  input["to_world"] = jsonOf(state.graph ? state.graph->toWorld[v] : volume.toWorld);
  input["left_out"] = std::find(state.leftOut.begin(), state.leftOut.end(), v) != state.leftOut.end();
  if (v < state.corrections.size() && !state.corrections[v].grey.empty()) input["grey_correction"] = jsonOf(state.corrections[v]);
  return input;
}

ordered_json pairOf(const StitchProject& project, const PairOutcome& pair) {
  const auto entry = std::find_if(project.pairs.begin(), project.pairs.end(),
                                  [&](const ProjectPair& each) { return each.fixed == pair.fixed && each.moving == pair.moving; });
  return {{"fixed", project.volumes[pair.fixed].name},
          {"moving", project.volumes[pair.moving].name},
          {"method", nameOf(pair.used)},
          {"decision", nameOf(entry == project.pairs.end() ? Decision::undecided : entry->decision)},
          {"verdict", registration::nameOf(pair.rigid.verdict)},
          {"reason", pair.rigid.reason.english()},
          {"wrong", pair.wrong},
          {"before", jsonOf(pair.rigid.before)},
          {"after", jsonOf(pair.rigid.after)},
          {"fixed_to_moving", jsonOf(pair.rigid.fixedToMoving)}};
}

}  // namespace

std::string provenanceText(const StitchProject& project, const ChainState& state, const std::string& key, std::vector<ResultFile> volumes) {
  ordered_json document;
  document["made_by"] = std::string("EchoWeave ") + kVersion + ", stitch";
  document["key"] = key;
  for (ResultFile& file : volumes) file.changed_ns = 0;
  document["files"] = jsonOf(volumes);
  document["verdict"] = registration::nameOf(state.verdict);
  document["reason"] = state.reason.english();
  document["inputs"] = ordered_json::array();
  std::size_t joined = 0;
  for (std::size_t v = 0; v < project.volumes.size(); ++v) {
    ordered_json input = inputOf(project, state, v);
    if (state.report && input["left_out"] == false && joined < state.report->contributions.size()) {
      input["contributed_voxels"] = state.report->contributions[joined].voxels;
      input["dominant_voxels"] = state.report->contributions[joined].dominantVoxels;
      ++joined;
    }
    document["inputs"].push_back(std::move(input));
  }
  document["pairs"] = ordered_json::array();
  for (const PairOutcome& pair : state.pairs) document["pairs"].push_back(pairOf(project, pair));
  const WarpSummary& warps = state.warpSummary;
  document["bends"] = {{"pairs", warps.pairs},
                       {"largest_mm", warps.largest_mm},
                       {"smallest_jacobian", warps.smallestJacobian},
                       {"disagreement_median_mm", warps.disagreementMedian_mm},
                       {"disagreement_95_mm", warps.disagreement95_mm},
                       {"of_pairs", ordered_json::array()}};
  for (const PairDeformation& warped : state.warpedPairs)
    document["bends"]["of_pairs"].push_back({{"fixed", project.volumes[warped.fixed].name},
                                             {"moving", project.volumes[warped.moving].name},
                                             {"effort", nameOf(warped.effort)},
                                             {"verdict", registration::nameOf(warped.verdict)},
                                             {"reason", warped.reason.english()},
                                             {"before", jsonOf(warped.before)},
                                             {"after", jsonOf(warped.after)},
                                             {"largest_motion_mm", warped.largestMotion_mm},
                                             {"smallest_jacobian", warped.smallestJacobian}});
  const auto text = projectText(project, {});
  const auto asked = ordered_json::parse(text);
  for (const char* part : {"settings", "result", "seam"}) document["options"][part] = asked.at(part);
  if (state.report) {
    const JoinReport& report = *state.report;
    const Grid& grid = report.grid;
    document["grid"] = {{"dims", {grid.dims.x, grid.dims.y, grid.dims.z}},
                        {"spacing_mm", jsonOf(grid.spacing_mm)},
                        {"voxel_to_world", jsonOf(grid.voxelToWorld())}};
    document["seam"] = jsonOf(report).at("seam");
    document["overlap_share"] = report.overlapShare;
    document["disagreement_rms"] = report.disagreementRms;
    document["notes"] = english(report.notes);
  }
  return document.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace ew::stitching
