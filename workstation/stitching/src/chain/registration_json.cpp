#include "chain/registration_json.h"

#include "ew/core/message_json.h"

namespace ew::stitching {

using nlohmann::json;
using nlohmann::ordered_json;
using registration::PoseCovariance;
using registration::StopReason;
using registration::Verdict;

namespace {

PoseCovariance covarianceFrom(const json& list) {
  PoseCovariance covariance{};
  for (std::size_t i = 0; i < covariance.size(); ++i) covariance[i] = numberFrom(list.at(i));
  return covariance;
}

StopReason stopFrom(const json& value) {
  return wordFrom(value, {StopReason::notRun, StopReason::converged, StopReason::iterationLimit, StopReason::timeLimit,
                          StopReason::noImprovement, StopReason::singular, StopReason::noOverlap, StopReason::cancelled});
}
}  // namespace

Verdict verdictFrom(const json& value) { return wordFrom(value, {Verdict::aligned, Verdict::notAligned, Verdict::cannotTell}); }

ordered_json jsonOf(const registration::Agreement& agreement) {
  return {{"correlation", number(agreement.correlation)},
          {"overlap_share", number(agreement.overlapShare)},
          {"chance", number(agreement.chance)}};
}

ordered_json jsonOf(const std::vector<registration::Level>& levels) {
  ordered_json list = ordered_json::array();
  for (const auto& level : levels)
    list.push_back({{"voxel_mm", number(level.voxel_mm)},
                    {"node_mm", number(level.node_mm)},
                    {"iterations", level.iterations},
                    {"correlation_before", number(level.correlationBefore)},
                    {"correlation_after", number(level.correlationAfter)},
                    {"seconds", number(level.seconds)}});
  return list;
}
std::vector<registration::Level> levelsFrom(const json& data) {
  std::vector<registration::Level> levels;
  for (const auto& each : data)
    levels.push_back({numberFrom(each.at("voxel_mm")), numberFrom(each.at("node_mm")), each.at("iterations").get<int>(),
                      numberFrom(each.at("correlation_before")), numberFrom(each.at("correlation_after")), numberFrom(each.at("seconds"))});
  return levels;
}

registration::Agreement agreementFrom(const json& data) {
  return {numberFrom(data.at("correlation")), numberFrom(data.at("overlap_share")), numberFrom(data.at("chance"))};
}

ordered_json jsonOf(const std::vector<registration::Remark>& remarks) {
  ordered_json list = ordered_json::array();
  for (const auto& remark : remarks)
    list.push_back({{"says", nameOf(remark.what)}, {"figures", numbers(remark.figures)}, {"names", remark.names}});
  return list;
}
std::vector<registration::Remark> remarksFrom(const json& list) {
  std::vector<registration::Remark> remarks;
  for (const auto& each : list) {
    const auto what = registration::saysFrom(each.at("says").get<std::string>());
    if (!what) throw json::other_error::create(501, "a remark that is not known", &each);
    remarks.push_back({*what, numbersFrom(each.at("figures")), each.at("names").get<std::vector<std::string>>()});
  }
  return remarks;
}

ordered_json jsonOf(const registration::RigidResult& rigid) {
  ordered_json made;
  tellVerdict(made, rigid);
  made["fixed_to_moving"] = jsonOf(rigid.fixedToMoving);
  made["before"] = jsonOf(rigid.before);
  made["after"] = jsonOf(rigid.after);
  if (rigid.covariance) made["covariance"] = numbers(*rigid.covariance);
  made["centre_mm"] = jsonOf(rigid.centre_mm);
  made["conditioning"] = number(rigid.conditioning);
  made["halves_disagree_mm"] = number(rigid.halvesDisagree_mm);
  made["residual_rms"] = number(rigid.residualRms);
  made["levels"] = jsonOf(rigid.levels);
  made["stop"] = nameOf(rigid.stop);
  made["seconds"] = number(rigid.seconds);
  return made;
}

registration::RigidResult rigidFrom(const json& data) {
  registration::RigidResult rigid;
  readVerdict(data, rigid);
  rigid.fixedToMoving = transformFrom<frame::Moving, frame::Fixed>(data.at("fixed_to_moving"));
  rigid.before = agreementFrom(data.at("before"));
  rigid.after = agreementFrom(data.at("after"));
  if (data.contains("covariance")) rigid.covariance = covarianceFrom(data.at("covariance"));
  rigid.centre_mm = vectorFrom(data.at("centre_mm"));
  rigid.conditioning = numberFrom(data.at("conditioning"));
  rigid.halvesDisagree_mm = numberFrom(data.at("halves_disagree_mm"));
  rigid.residualRms = numberFrom(data.at("residual_rms"));
  rigid.levels = levelsFrom(data.at("levels"));
  rigid.stop = stopFrom(data.at("stop"));
  rigid.seconds = numberFrom(data.at("seconds"));
  return rigid;
}

ordered_json jsonOf(const registration::LandmarkResult& found) {
  ordered_json made;
  tellVerdict(made, found);
  made["fixed_to_moving"] = jsonOf(found.fixedToMoving);
  made["residual_mm"] = numbers(found.residual_mm);
  made["weight"] = numbers(found.weight);
  made["outlying"] = found.outlying;
  made["coincident"] = found.coincident;
  made["collinear"] = found.collinear;
  made["rms_mm"] = number(found.rms_mm);
  made["expected_error_mm"] = number(found.expectedError_mm);
  made["conditioning"] = number(found.conditioning);
  made["stop"] = nameOf(found.stop);
  return made;
}

registration::LandmarkResult landmarksFrom(const json& data) {
  registration::LandmarkResult found;
  readVerdict(data, found);
  found.fixedToMoving = transformFrom<frame::Moving, frame::Fixed>(data.at("fixed_to_moving"));
  found.residual_mm = numbersFrom(data.at("residual_mm"));
  found.weight = numbersFrom(data.at("weight"));
  found.outlying = data.at("outlying").get<std::vector<std::size_t>>();
  found.coincident = data.at("coincident").get<std::vector<std::size_t>>();
  found.collinear = data.at("collinear").get<bool>();
  found.rms_mm = numberFrom(data.at("rms_mm"));
  found.expectedError_mm = numberFrom(data.at("expected_error_mm"));
  found.conditioning = numberFrom(data.at("conditioning"));
  found.stop = stopFrom(data.at("stop"));
  return found;
}

ordered_json jsonOf(const registration::GraphResult& graph) {
  ordered_json made;
  made["verdict"] = nameOf(graph.verdict);
  made["reason"] = graph.reason;
  made["to_world"] = ordered_json::array();
  for (const auto& matrix : graph.toWorld) made["to_world"].push_back(jsonOf(matrix));
  made["edges"] = ordered_json::array();
  for (const auto& edge : graph.edges)
    made["edges"].push_back({{"residual_mm", number(edge.residual_mm)},
                             {"residual_deg", number(edge.residual_deg)},
                             {"weight", number(edge.weight)},
                             {"wrong", edge.wrong},
                             {"confirmed", edge.confirmed}});
  made["part"] = graph.part;
  made["parts"] = graph.parts;
  made["wrong"] = graph.wrong;
  made["suspects"] = graph.suspects;
  made["wrong_priors"] = graph.wrongPriors;
  made["suspect_priors"] = graph.suspectPriors;
  made["undetermined"] = graph.undetermined;
  made["without_information"] = graph.withoutInformation;
  made["covariance"] = ordered_json::array();
  for (const auto& covariance : graph.covariance) made["covariance"].push_back(numbers(covariance));
  made["centre_mm"] = ordered_json::array();
  for (const auto& centre : graph.centre_mm) made["centre_mm"].push_back(jsonOf(centre));
  made["variance_factor"] = number(graph.varianceFactor);
  made["closure_mm"] = number(graph.closure_mm);
  made["closure_deg"] = number(graph.closure_deg);
  made["stop"] = nameOf(graph.stop);
  made["iterations"] = graph.iterations;
  made["seconds"] = number(graph.seconds);
  return made;
}
registration::GraphResult graphFrom(const json& data) {
  registration::GraphResult graph;
  graph.verdict = verdictFrom(data.at("verdict"));
  graph.reason = data.at("reason").get<Message>();
  for (const auto& matrix : data.at("to_world")) graph.toWorld.push_back(transformFrom<frame::World, frame::View>(matrix));
  for (const auto& edge : data.at("edges")) {
    registration::GraphEdgeReport report;
    report.residual_mm = numberFrom(edge.at("residual_mm"));
    report.residual_deg = numberFrom(edge.at("residual_deg"));
    report.weight = numberFrom(edge.at("weight"));
    report.wrong = edge.at("wrong").get<bool>();
    report.confirmed = edge.at("confirmed").get<bool>();
    graph.edges.push_back(report);
  }
  graph.part = data.at("part").get<std::vector<int>>();
  graph.parts = data.at("parts").get<int>();
  graph.wrong = data.at("wrong").get<std::vector<std::size_t>>();
  graph.suspects = data.at("suspects").get<std::vector<std::size_t>>();
  graph.wrongPriors = data.at("wrong_priors").get<std::vector<std::size_t>>();
  graph.suspectPriors = data.at("suspect_priors").get<std::vector<std::size_t>>();
  graph.undetermined = data.at("undetermined").get<std::vector<std::size_t>>();
  graph.withoutInformation = data.at("without_information").get<std::vector<std::size_t>>();
  for (const auto& covariance : data.at("covariance")) graph.covariance.push_back(covarianceFrom(covariance));
  for (const auto& centre : data.at("centre_mm")) graph.centre_mm.push_back(vectorFrom(centre));
  graph.varianceFactor = numberFrom(data.at("variance_factor"));
  graph.closure_mm = numberFrom(data.at("closure_mm"));
  graph.closure_deg = numberFrom(data.at("closure_deg"));
  graph.stop = stopFrom(data.at("stop"));
  graph.iterations = data.at("iterations").get<int>();
  graph.seconds = numberFrom(data.at("seconds"));
  return graph;
}

}  // namespace ew::stitching
