#include "chain/chain_json.h"
#include "ew/core/message_json.h"

namespace ew::stitching {

using nlohmann::json;
using nlohmann::ordered_json;

namespace {

PairMethod methodFrom(const json& value) {
  return wordFrom(value, {PairMethod::automatic, PairMethod::search, PairMethod::refine, PairMethod::landmarks, PairMethod::byHand});
}

}  // namespace

ordered_json jsonOf(const PairOutcome& outcome) {
  ordered_json made;
  made["used"] = nameOf(outcome.used);
  made["rigid"] = jsonOf(outcome.rigid);
  if (outcome.landmarks) made["landmarks"] = jsonOf(*outcome.landmarks);
  made["hypotheses"] = ordered_json::array();
  for (const auto& each : outcome.hypotheses)
    made["hypotheses"].push_back({{"fixed_to_moving", jsonOf(each.fixedToMoving)},
                                  {"significance", number(each.significance)},
                                  {"correlation", number(each.correlation)},
                                  {"overlap_share", number(each.overlapShare)}});
  made["processor_s"] = number(outcome.processor_s);
  return made;
}
PairOutcome pairFrom(const json& data) {
  PairOutcome outcome;
  outcome.used = methodFrom(data.at("used"));
  outcome.rigid = rigidFrom(data.at("rigid"));
  if (data.contains("landmarks")) outcome.landmarks = landmarksFrom(data.at("landmarks"));
  for (const auto& each : data.at("hypotheses"))
    outcome.hypotheses.push_back({transformFrom<frame::Moving, frame::Fixed>(each.at("fixed_to_moving")),
                                  numberFrom(each.at("significance")), numberFrom(each.at("correlation")),
                                  numberFrom(each.at("overlap_share"))});
  if (data.contains("processor_s")) outcome.processor_s = numberFrom(data.at("processor_s"));
  return outcome;
}

ordered_json jsonOf(const PairDeformation& warped) {
  ordered_json made;
  made["effort"] = nameOf(warped.effort);
  tellVerdict(made, warped);
  made["before"] = jsonOf(warped.before);
  made["after"] = jsonOf(warped.after);
  made["largest_motion_mm"] = number(warped.largestMotion_mm);
  made["smallest_jacobian"] = number(warped.smallestJacobian);
  made["levels"] = jsonOf(warped.levels);
  made["seconds"] = number(warped.seconds);
  made["processor_s"] = number(warped.processor_s);
  return made;
}
PairDeformation warpedFrom(const json& data) {
  PairDeformation warped;
  using registration::ElasticEffort;
  warped.effort = wordFrom(data.at("effort"), {ElasticEffort::fast, ElasticEffort::balanced, ElasticEffort::accurate});
  readVerdict(data, warped);
  warped.before = agreementFrom(data.at("before"));
  warped.after = agreementFrom(data.at("after"));
  warped.largestMotion_mm = numberFrom(data.at("largest_motion_mm"));
  warped.smallestJacobian = numberFrom(data.at("smallest_jacobian"));
  warped.levels = levelsFrom(data.at("levels"));
  warped.seconds = numberFrom(data.at("seconds"));
  if (data.contains("processor_s")) warped.processor_s = numberFrom(data.at("processor_s"));
  return warped;
}

ordered_json jsonOf(const std::optional<Beams>& beams) {
  if (!beams) return nullptr;
  ordered_json made = {{"direction", jsonOf(beams->direction)}};
  if (beams->fan) made["apex_way_mm"] = {jsonOf(beams->fan->from_mm), jsonOf(beams->fan->to_mm)};
  return made;
}
std::optional<Beams> beamsFrom(const json& data) {
  if (data.is_null()) return std::nullopt;
  Beams beams{vectorFrom(data.at("direction"))};
  if (data.contains("apex_way_mm")) beams.fan = Beams::Fan{vectorFrom(data["apex_way_mm"].at(0)), vectorFrom(data["apex_way_mm"].at(1))};
  return beams;
}

ordered_json jsonOf(const GreyCorrection& correction) {
  return {{"beams", jsonOf(correction.beams)},
          {"first_knot_mm", number(correction.firstKnot_mm)},
          {"knot_mm", number(correction.knot_mm)},
          {"grey", numbers(correction.grey)}};
}
GreyCorrection correctionFrom(const json& data) {
  return {beamsFrom(data.at("beams")), numberFrom(data.at("first_knot_mm")), numberFrom(data.at("knot_mm")), numbersFrom(data.at("grey"))};
}

ordered_json jsonOf(const JoinReport& report) {
  ordered_json made;
  made["grid"] = jsonOf(report.grid);
  made["contributions"] = ordered_json::array();
  for (const auto& each : report.contributions)
    made["contributions"].push_back({{"name", each.name}, {"voxels", each.voxels}, {"dominant_voxels", each.dominantVoxels}});
  made["seam"] = {{"derivative_ratio", number(report.seam.derivativeRatio)},
                  {"speckle_ratio", number(report.seam.speckleRatio)},
                  {"mean_step_db", number(report.seam.meanStep_db)},
                  {"voxels", report.seam.voxels}};
  made["overlap_share"] = number(report.overlapShare);
  made["disagreement_rms"] = number(report.disagreementRms);
  made["notes"] = report.notes;
  made["seconds"] = number(report.seconds);
  return made;
}
JoinReport reportFrom(const json& data) {
  JoinReport report;
  report.grid = gridFrom(data.at("grid"));
  for (const auto& each : data.at("contributions"))
    report.contributions.push_back(
        {each.at("name").get<std::string>(), each.at("voxels").get<std::size_t>(), each.at("dominant_voxels").get<std::size_t>()});
  report.seam.derivativeRatio = numberFrom(data.at("seam").at("derivative_ratio"));
  report.seam.speckleRatio = numberFrom(data.at("seam").at("speckle_ratio"));
  report.seam.meanStep_db = numberFrom(data.at("seam").at("mean_step_db"));
  report.seam.voxels = data.at("seam").at("voxels").get<std::size_t>();
  report.overlapShare = numberFrom(data.at("overlap_share"));
  report.disagreementRms = numberFrom(data.at("disagreement_rms"));
  report.notes = data.at("notes").get<std::vector<Message>>();
  report.seconds = numberFrom(data.at("seconds"));
  return report;
}

}  // namespace ew::stitching
