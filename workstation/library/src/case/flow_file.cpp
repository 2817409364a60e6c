#include "case/flow_file.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "case/kept_motion.h"

namespace ew {
namespace {

using nlohmann::ordered_json;

constexpr std::size_t kMostStreams = 2000, kMostFlowNodes = 200000, kMostHarmonics = 64;  // as recipes have at most, of harmonics 16
constexpr double kFarthestFlow_mm = 1e5, kWidest_mm = 1000.0, kNarrowest_mm = 1e-4;
constexpr double kLargestFlow_mm3PerS = 1e8, kLargestWave = 1e9;
constexpr double kMostFlowPieces = 67108864.0;  // in the cells of a sampler: 512 MB

/// A value of each node; left out where all are `usual`.
void addColumn(ordered_json& into, const char* key, const std::vector<FlowNode>& line, double FlowNode::*value, double usual) {
  if (std::all_of(line.begin(), line.end(), [&](const FlowNode& node) { return node.*value == usual; })) return;
  ordered_json& column = into[key] = ordered_json::array();
  for (const FlowNode& node : line) column.push_back(node.*value);
}

ordered_json fileJsonOf(const FlowStream& stream) {
  ordered_json written = ordered_json::object();
  if (!stream.name.empty()) written["name"] = stream.name;
  written["flow_mm3_per_s"] = stream.flow_mm3PerS;
  written["mean"] = stream.wave.mean;
  written["harmonics"] = ordered_json::array();
  for (const std::complex<double>& each : stream.wave.harmonics) {
    written["harmonics"].push_back(each.real());
    written["harmonics"].push_back(each.imag());
  }
  written["bluntness"] = stream.bluntness;
  written["pulse_wave_mm_per_s"] = stream.pulseWave_mmPerS;
  written["delay_s"] = stream.delay_s;
  written["breath"] = stream.breathShare;
  written["places_mm"] = ordered_json::array();
  for (const FlowNode& node : stream.line)
    for (int axis = 0; axis < 3; ++axis) written["places_mm"].push_back(node.place_mm[axis]);
  written["radii_mm"] = ordered_json::array();
  for (const FlowNode& node : stream.line) written["radii_mm"].push_back(node.radius_mm);
  addColumn(written, "jets", stream.line, &FlowNode::jet, 1.0);
  addColumn(written, "backflows", stream.line, &FlowNode::backflow, 0.0);
  addColumn(written, "turbulences", stream.line, &FlowNode::turbulence, 0.0);
  return written;
}

void readColumn(const JsonFields& object, const char* key, std::vector<FlowNode>& line, double FlowNode::*value, double lowest,
                double highest) {
  if (!object.has(key)) return;
  const std::vector<double> column = object.numbers(key, line.size(), line.size(), lowest, highest);
  for (std::size_t n = 0; n < std::min(column.size(), line.size()); ++n) line[n].*value = column[n];
}

FlowStream streamIn(const JsonFields& object) {
  FlowStream stream;
  object.only({"name", "flow_mm3_per_s", "mean", "harmonics", "bluntness", "pulse_wave_mm_per_s", "delay_s", "breath", "places_mm",
               "radii_mm", "jets", "backflows", "turbulences"});
  if (!object.good()) return stream;
  stream.name = object.text("name", std::string(), 0);
  stream.flow_mm3PerS = object.number("flow_mm3_per_s", -kLargestFlow_mm3PerS, kLargestFlow_mm3PerS);
  stream.wave.mean = object.number("mean", -kLargestWave, kLargestWave);
  const std::vector<double> harmonics = object.numbers("harmonics", 0, 2 * kMostHarmonics, -kLargestWave, kLargestWave);
  if (harmonics.size() % 2 != 0) object.refuse("harmonics", say<"two numbers for each harmonic">());
  for (std::size_t n = 0; n + 1 < harmonics.size(); n += 2) stream.wave.harmonics.emplace_back(harmonics[n], harmonics[n + 1]);
  stream.bluntness = object.number("bluntness", 2.0, 50.0);
  stream.pulseWave_mmPerS = object.number("pulse_wave_mm_per_s", 0.0, 1e5);
  stream.delay_s = object.number("delay_s", -1000.0, 1000.0);
  stream.breathShare = object.number("breath", -1.0, 1.0);
  const std::vector<double> radii_mm = object.numbers("radii_mm", 2, kMostFlowNodes, kNarrowest_mm, kWidest_mm);
  const std::vector<double> places_mm =
      object.numbers("places_mm", 3 * radii_mm.size(), 3 * radii_mm.size(), -kFarthestFlow_mm, kFarthestFlow_mm);
  if (!object.good()) return stream;
  for (std::size_t n = 0; n < radii_mm.size(); ++n)
    stream.line.push_back({.place_mm = {places_mm[3 * n], places_mm[3 * n + 1], places_mm[3 * n + 2]}, .radius_mm = radii_mm[n]});
  readColumn(object, "jets", stream.line, &FlowNode::jet, 0.01, 1.0);
  readColumn(object, "backflows", stream.line, &FlowNode::backflow, 0.0, 1.0);
  readColumn(object, "turbulences", stream.line, &FlowNode::turbulence, 0.0, 10.0);
  return stream;
}

/// How many pieces of vessels a FlowSampler's cells of 2 mm list; it takes larger ones where there would be too many.
double piecesInCells(const FlowStream& stream) {
  constexpr double kCell_mm = 2.0;
  double widest_mm = 0.0, pieces = 0.0;
  for (const FlowNode& node : stream.line) widest_mm = std::max(widest_mm, node.radius_mm);
  for (std::size_t n = 1; n < stream.line.size(); ++n) {
    const glm::dvec3 cells = (glm::abs(stream.line[n].place_mm - stream.line[n - 1].place_mm) + 2.0 * widest_mm) / kCell_mm + 2.0;
    constexpr double kMostCells = 4e6;
    pieces += std::min(cells.x * cells.y * cells.z, kMostCells);
  }
  return pieces;
}

BodyRhythm rhythmIn(const JsonFields& object) { return {object.number("period_s", 0.1, 120.0), object.number("variation", 0.0, 0.4)}; }

}  // namespace

ordered_json fileJsonOf(const FlowField& flow) {
  ordered_json written = {{"density_kg_per_m3", flow.density_kgPerM3},
                          {"viscosity_mpa_s", flow.viscosity_mPaS},
                          {"rhythms", keptJsonOf(flow.rhythms)},
                          {"streams", ordered_json::array()}};
  for (const FlowStream& stream : flow.streams) written["streams"].push_back(fileJsonOf(stream));
  return written;
}

FlowField flowIn(const JsonFields& object) {
  FlowField flow;
  object.only({"density_kg_per_m3", "viscosity_mpa_s", "rhythms", "streams"});
  if (!object.good()) return flow;
  flow.density_kgPerM3 = object.number("density_kg_per_m3", 900.0, 1200.0);
  flow.viscosity_mPaS = object.number("viscosity_mpa_s", 1.0, 20.0);
  flow.rhythms = rhythmsIn(object.object("rhythms"));
  std::size_t nodes = 0;
  double pieces = 0.0;
  for (const JsonFields& each : object.objects("streams", 1, kMostStreams)) {
    const FlowStream& stream = flow.streams.emplace_back(streamIn(each));
    if (!object.good()) return {};
    nodes += stream.line.size();
    pieces += piecesInCells(stream);
    if (nodes > kMostFlowNodes) each.refuse("radii_mm", say<"so few that all streams have at most %1 nodes">(kMostFlowNodes));
    if (pieces > kMostFlowPieces)
      each.refuseWhole(say<"with the streams before it too long and too wide to be looked up">(), say<"streams of a body">());
    if (!object.good()) return {};
  }
  return flow;
}

BodyRhythms rhythmsIn(const JsonFields& object) {
  BodyRhythms rhythms;
  if (object.has("breathing")) {
    const JsonFields breathing = object.object("breathing");
    rhythms.breathing = {rhythmIn(breathing.object("rhythm")), breathing.number("pause", 0.0, 0.9), breathing.number("tidal", 0.0, 1.0)};
  }
  if (object.has("pulse")) rhythms.pulse = rhythmIn(object.object("pulse"));
  if (object.has("bowel")) rhythms.bowel = rhythmIn(object.object("bowel"));
  return rhythms;
}

FlowField flowWithin(const FlowField& flow, const Bounds& box, double margin_mm) {
  FlowField within = flow;
  std::erase_if(within.streams, [&](const FlowStream& stream) {
    for (std::size_t n = 1; n < stream.line.size(); ++n) {
      const FlowNode &a = stream.line[n - 1], &b = stream.line[n];
      const double reach_mm = margin_mm + std::max(a.radius_mm, b.radius_mm);
      if (glm::all(glm::lessThanEqual(glm::min(a.place_mm, b.place_mm) - reach_mm, box.highest_mm)) &&
          glm::all(glm::greaterThanEqual(glm::max(a.place_mm, b.place_mm) + reach_mm, box.lowest_mm)))
        return false;
    }
    return true;
  });
  return within;
}

}  // namespace ew
