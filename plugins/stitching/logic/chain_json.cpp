#include "logic/chain_json.h"

#include <cmath>
#include <limits>

namespace ew::stitching {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;
using registration::PoseCovariance;
using registration::StopReason;
using registration::Verdict;

/// JSON has no infinity.
ordered_json number(double value) {
  if (std::isfinite(value)) return value;
  return std::isnan(value) ? "nan" : value > 0.0 ? "inf" : "-inf";
}
double numberFrom(const json& value) {
  if (value.is_number()) return value.get<double>();
  const auto word = value.get<std::string>();
  const double infinite = std::numeric_limits<double>::infinity();
  return word == "inf" ? infinite : word == "-inf" ? -infinite : std::numeric_limits<double>::quiet_NaN();
}

template <class Numbers>
ordered_json numbers(const Numbers& values) {
  ordered_json list = ordered_json::array();
  for (const auto value : values) list.push_back(number(value));
  return list;
}
std::vector<double> numbersFrom(const json& list) {
  std::vector<double> values;
  for (const auto& value : list) values.push_back(numberFrom(value));
  return values;
}
PoseCovariance covarianceFrom(const json& list) {
  PoseCovariance covariance{};
  for (std::size_t i = 0; i < covariance.size(); ++i) covariance[i] = numberFrom(list.at(i));
  return covariance;
}

template <class Word>
Word wordFrom(const json& value, std::initializer_list<Word> words) {
  for (const Word word : words)
    if (value == nameOf(word)) return word;
  throw json::other_error::create(501, "a word that is not known", &value);
}
Verdict verdictFrom(const json& value) { return wordFrom(value, {Verdict::aligned, Verdict::notAligned, Verdict::cannotTell}); }
StopReason stopFrom(const json& value) {
  return wordFrom(value, {StopReason::notRun, StopReason::converged, StopReason::iterationLimit, StopReason::timeLimit,
                          StopReason::noImprovement, StopReason::singular, StopReason::noOverlap, StopReason::cancelled});
}
PairMethod methodFrom(const json& value) {
  return wordFrom(value, {PairMethod::automatic, PairMethod::search, PairMethod::refine, PairMethod::landmarks, PairMethod::byHand});
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
/// What another version of the program says in other words is left to its sentence.
std::vector<registration::Remark> remarksFrom(const json& list) {
  std::vector<registration::Remark> remarks;
  for (const auto& each : list) {
    const auto what = registration::saysFrom(each.at("says").get<std::string>());
    if (!what) return {};
    remarks.push_back({*what, numbersFrom(each.at("figures")), each.at("names").get<std::vector<std::string>>()});
  }
  return remarks;
}

ordered_json jsonOf(const registration::RigidResult& rigid) {
  ordered_json made;
  made["verdict"] = nameOf(rigid.verdict);
  made["reason"] = rigid.reason;
  made["remarks"] = jsonOf(rigid.remarks);
  made["fixed_to_moving"] = stitching::jsonOf(rigid.fixedToMoving);
  made["before"] = stitching::jsonOf(rigid.before);
  made["after"] = stitching::jsonOf(rigid.after);
  if (rigid.covariance) made["covariance"] = numbers(*rigid.covariance);
  made["centre_mm"] = stitching::jsonOf(rigid.centre_mm);
  made["conditioning"] = number(rigid.conditioning);
  made["halves_disagree_mm"] = number(rigid.halvesDisagree_mm);
  made["residual_rms"] = number(rigid.residualRms);
  made["levels"] = stitching::jsonOf(rigid.levels);
  made["stop"] = nameOf(rigid.stop);
  made["seconds"] = number(rigid.seconds);
  return made;
}

registration::RigidResult rigidFrom(const json& data) {
  registration::RigidResult rigid;
  rigid.verdict = verdictFrom(data.at("verdict"));
  rigid.reason = data.at("reason").get<std::string>();
  rigid.remarks = remarksFrom(data.at("remarks"));
  rigid.fixedToMoving = matrixFrom(data.at("fixed_to_moving"));
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
  return {{"verdict", nameOf(found.verdict)},
          {"reason", found.reason},
          {"remarks", jsonOf(found.remarks)},
          {"fixed_to_moving", stitching::jsonOf(found.fixedToMoving)},
          {"residual_mm", numbers(found.residual_mm)},
          {"weight", numbers(found.weight)},
          {"outlying", found.outlying},
          {"coincident", found.coincident},
          {"collinear", found.collinear},
          {"rms_mm", number(found.rms_mm)},
          {"expected_error_mm", number(found.expectedError_mm)},
          {"conditioning", number(found.conditioning)},
          {"stop", nameOf(found.stop)}};
}

registration::LandmarkResult landmarksFrom(const json& data) {
  registration::LandmarkResult found;
  found.verdict = verdictFrom(data.at("verdict"));
  found.reason = data.at("reason").get<std::string>();
  found.remarks = remarksFrom(data.at("remarks"));
  found.fixedToMoving = matrixFrom(data.at("fixed_to_moving"));
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

}  // namespace

ordered_json jsonOf(const glm::dmat4& matrix) { return numbers(rowsOf(matrix)); }
glm::dmat4 matrixFrom(const json& data) {
  std::array<double, 16> rows{};
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = numberFrom(data.at(i));
  return matrixFromRows(rows);
}
ordered_json jsonOf(const glm::dvec3& v) { return numbers(std::array{v.x, v.y, v.z}); }
glm::dvec3 vectorFrom(const json& data) { return {numberFrom(data.at(0)), numberFrom(data.at(1)), numberFrom(data.at(2))}; }

ordered_json jsonOf(const Grid& grid) {
  return {{"dims", {grid.dims.x, grid.dims.y, grid.dims.z}},
          {"spacing_mm", jsonOf(grid.spacing_mm)},
          {"origin_mm", jsonOf(grid.origin_mm)},
          {"directions", {jsonOf(grid.directions[0]), jsonOf(grid.directions[1]), jsonOf(grid.directions[2])}}};
}
Grid gridFrom(const json& data) {
  Grid grid;
  for (int axis = 0; axis < 3; ++axis) {
    grid.dims[axis] = data.at("dims").at(static_cast<std::size_t>(axis)).get<int>();
    grid.directions[axis] = vectorFrom(data.at("directions").at(static_cast<std::size_t>(axis)));
  }
  grid.spacing_mm = vectorFrom(data.at("spacing_mm"));
  grid.origin_mm = vectorFrom(data.at("origin_mm"));
  return grid;
}

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
  return made;
}
PairOutcome pairFrom(const json& data) {
  PairOutcome outcome;
  outcome.used = methodFrom(data.at("used"));
  outcome.rigid = rigidFrom(data.at("rigid"));
  if (data.contains("landmarks")) outcome.landmarks = landmarksFrom(data.at("landmarks"));
  for (const auto& each : data.at("hypotheses"))
    outcome.hypotheses.push_back({matrixFrom(each.at("fixed_to_moving")), numberFrom(each.at("significance")),
                                  numberFrom(each.at("correlation")), numberFrom(each.at("overlap_share"))});
  return outcome;
}

ordered_json jsonOf(const BentPair& bent) {
  return {{"effort", nameOf(bent.effort)},
          {"verdict", nameOf(bent.verdict)},
          {"reason", bent.reason},
          {"remarks", jsonOf(bent.remarks)},
          {"before", jsonOf(bent.before)},
          {"after", jsonOf(bent.after)},
          {"largest_motion_mm", number(bent.largestMotion_mm)},
          {"smallest_jacobian", number(bent.smallestJacobian)},
          {"levels", jsonOf(bent.levels)},
          {"seconds", number(bent.seconds)}};
}
BentPair bentFrom(const json& data) {
  BentPair bent;
  using registration::ElasticEffort;
  bent.effort = wordFrom(data.at("effort"), {ElasticEffort::fast, ElasticEffort::balanced, ElasticEffort::accurate});
  bent.verdict = verdictFrom(data.at("verdict"));
  bent.reason = data.at("reason").get<std::string>();
  bent.remarks = remarksFrom(data.at("remarks"));
  bent.before = agreementFrom(data.at("before"));
  bent.after = agreementFrom(data.at("after"));
  bent.largestMotion_mm = numberFrom(data.at("largest_motion_mm"));
  bent.smallestJacobian = numberFrom(data.at("smallest_jacobian"));
  bent.levels = levelsFrom(data.at("levels"));
  bent.seconds = numberFrom(data.at("seconds"));
  return bent;
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
  graph.reason = data.at("reason").get<std::string>();
  for (const auto& matrix : data.at("to_world")) graph.toWorld.push_back(matrixFrom(matrix));
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
  report.notes = data.at("notes").get<std::vector<std::string>>();
  report.seconds = numberFrom(data.at("seconds"));
  return report;
}

}  // namespace ew::stitching
