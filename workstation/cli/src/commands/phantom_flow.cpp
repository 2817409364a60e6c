#include "commands/phantom_flow.h"

#include <set>
#include <string>

#include "ew/phantom/flow.h"
#include "run/arguments.h"

namespace ew::cli {
namespace {

using nlohmann::json;

constexpr double kMlPerMinOf = 60.0 / 1000.0;  // a mm^3/s
constexpr double kCmPerS = 0.1;                // a mm/s

json jsonOf(const glm::dvec3& p) { return {p.x, p.y, p.z}; }

/// Half way along a stream.
glm::dvec3 middleOf(const FlowStream& stream) {
  double length_mm = 0.0, done_mm = 0.0;
  for (std::size_t n = 1; n < stream.line.size(); ++n) length_mm += glm::distance(stream.line[n - 1].place_mm, stream.line[n].place_mm);
  for (std::size_t n = 1; n < stream.line.size(); ++n) {
    done_mm += glm::distance(stream.line[n - 1].place_mm, stream.line[n].place_mm);
    if (done_mm >= 0.5 * length_mm) return stream.line[n].place_mm;
  }
  return stream.line.front().place_mm;
}

json jsonOf(const TrueWaveform& waveform) {
  return {{"at_mm", jsonOf(waveform.at_mm)},
          {"diameter_mm", 2.0 * waveform.radius_mm},
          {"flow_ml_per_min", kMlPerMinOf * waveform.flow_mm3PerS},
          {"psv_cm_per_s", kCmPerS * waveform.peakSystolic_mmPerS},
          {"edv_cm_per_s", kCmPerS * waveform.endDiastolic_mmPerS},
          {"tamx_cm_per_s", kCmPerS * waveform.timeAverageMax_mmPerS},
          {"tamean_cm_per_s", kCmPerS * waveform.timeAverageMean_mmPerS},
          {"ri", waveform.resistiveIndex()},
          {"pi", waveform.pulsatilityIndex() ? json(*waveform.pulsatilityIndex()) : json()}};
}

}  // namespace

json flowTruthOf(const Patient& patient) {
  const FlowTruth truth(flowOf(patient));
  const auto& streams = truth.field().streams;
  json told = {{"streams", json::array()}, {"stenoses", json::array()}};
  std::set<std::string> named;  // a tree has a stream for each branch, all of its name; the first is its root
  for (std::size_t n = 0; n < streams.size(); ++n) {
    if (!named.insert(streams[n].name).second) continue;
    const auto waveform = waveformNear(truth, static_cast<int>(n), middleOf(streams[n]));
    if (!waveform) continue;
    json row = jsonOf(*waveform);
    row["name"] = streams[n].name;
    told["streams"].push_back(std::move(row));
  }
  for (const TrueStenosis& each : stenosesOf(patient))
    told["stenoses"].push_back({{"stream", streams[static_cast<std::size_t>(each.stream)].name},
                                {"at_mm", jsonOf(each.at_mm)},
                                {"diameter_lost", each.diameterLost},
                                {"diameter_lost_to_flow", each.diameterLostToFlow},
                                {"peak_cm_per_s", kCmPerS * each.peak_mmPerS}});
  return told;
}

Result<void> tellBlood(const FlowArguments& arguments, const Patient& patient, Run& run) {
  const FlowTruth truth(flowOf(patient));
  const auto& streams = truth.field().streams;
  if (streams.empty()) return failure(ErrorCode::unsupported, say<"This patient's recipe says nothing of flow; give it a \"flow\".">());
  const glm::dvec3 p_mm((*arguments.at_mm)[0], (*arguments.at_mm)[1], (*arguments.at_mm)[2]);
  const BloodVelocity blood = truth.at(p_mm, arguments.time_s);
  if (blood.stream < 0)
    return failure(ErrorCode::notFound, say<"No blood flows at that place; give one inside of a vessel that the recipe's flow names.">());
  const FlowSection section = *truth.sectionNear(blood.stream, p_mm, arguments.time_s);
  const double along_mmPerS = glm::dot(blood.mean_mmPerS, section.along);
  run.say(streams[static_cast<std::size_t>(blood.stream)].name + ": " + rounded(kCmPerS * along_mmPerS, 1) + " cm/s along the vessel, " +
          rounded(kMlPerMinOf * section.flow_mm3PerS, 0) + " ml/min through a lumen of " + rounded(2.0 * section.radius_mm, 2) +
          " mm, fastest " + rounded(kCmPerS * section.greatest_mmPerS(), 1) + " cm/s");
  run.report.details["blood"] = {{"stream", streams[static_cast<std::size_t>(blood.stream)].name},
                                 {"time_s", arguments.time_s},
                                 {"velocity_mm_per_s", jsonOf(blood.mean_mmPerS)},
                                 {"turbulence_mm_per_s", blood.turbulence_mmPerS},
                                 {"along", jsonOf(section.along)},
                                 {"diameter_mm", 2.0 * section.radius_mm},
                                 {"flow_ml_per_min", kMlPerMinOf * section.flow_mm3PerS},
                                 {"mean_cm_per_s", kCmPerS * section.mean_mmPerS},
                                 {"greatest_cm_per_s", kCmPerS * section.greatest_mmPerS()}};
  return {};
}

}  // namespace ew::cli
