#include <algorithm>
#include <map>

#include "chain/chain_json.h"
#include "chain/chain_memory.h"
#include "chain/steps/steps.h"

namespace ew::stitching {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;
using registration::GraphEdge;
using registration::GraphNode;
using registration::GraphResult;
using registration::Verdict;

constexpr double kHandError_mm = 10.0;  ///< how far a place given by hand is believed
constexpr double kHandError_deg = 10.0;
constexpr double kAcceptedError_mm = 1.0;  ///< of a pair a person accepted although its images say nothing about its error
constexpr double kAcceptedError_deg = 1.0;

/// The pairs that the graph is asked about: aligned ones, and those a person accepted.
struct Asked {
  std::vector<GraphEdge> edges;
  std::vector<std::size_t> pairOf;  ///< of each edge, in ChainState::pairs
};
Asked askedOf(const ChainRun& run) {
  Asked asked;
  for (std::size_t n = 0; n < run.state.pairs.size(); ++n) {
    const PairOutcome& pair = run.state.pairs[n];
    const bool accepted = run.decisions[n] == Decision::accepted;
    if (run.decisions[n] == Decision::rejected || (pair.rigid.verdict != Verdict::aligned && !accepted)) continue;
    GraphEdge edge;
    edge.fixed = pair.fixed;
    edge.moving = pair.moving;
    edge.fixedToMoving = pair.rigid.fixedToMoving;
    edge.covariance = pair.rigid.covariance;
    if (!edge.covariance && accepted) edge.covariance = evenCovariance(kAcceptedError_mm, kAcceptedError_deg);
    edge.centre_mm = pair.rigid.centre_mm;
    asked.edges.push_back(edge);
    asked.pairOf.push_back(n);
  }
  return asked;
}

std::vector<GraphNode> nodesOf(const ChainRun& run) {
  std::vector<GraphNode> nodes;
  const double error_mm = run.settings.trackerError_mm, error_deg = run.settings.trackerError_deg;
  for (std::size_t v = 0; v < run.inputs.size(); ++v) {
    const ProjectVolume& volume = run.project.volumes[v];
    GraphNode node;
    node.name = volume.name;
    node.toWorld = volume.toWorld;
    node.priorCentre_mm = middleOf(run.inputs[v].grid);
    if (isExact(run.project, v)) {
      node.fixed = true;
    } else if (volume.placement == Placement::tracker) {
      node.prior = evenCovariance(error_mm, error_deg);
    } else if (volume.placement == Placement::hand) {
      node.prior = evenCovariance(std::max(kHandError_mm, 3.0 * error_mm), std::max(kHandError_deg, 3.0 * error_deg));
    }
    nodes.push_back(std::move(node));
  }
  return nodes;
}

GraphResult asPlaced(const StitchProject& project) {
  GraphResult graph;
  for (const auto& volume : project.volumes) graph.toWorld.push_back(volume.toWorld);
  graph.part.assign(project.volumes.size(), 0);
  graph.parts = 1;
  graph.verdict = Verdict::aligned;
  graph.reason = project.volumes.size() == 1 ? say<"There is one volume alone.">() : say<"The recorded places were taken as they are.">();
  return graph;
}

Result<GraphResult> solve(const ChainRun& run, const std::vector<GraphEdge>& edges, Progress& progress) {
  bool allExact = true;
  for (std::size_t v = 0; v < run.inputs.size(); ++v) allExact = allExact && isExact(run.project, v);
  if (run.inputs.size() == 1 || (allExact && edges.empty())) return asPlaced(run.project);
  return registration::solveGraph(nodesOf(run), edges, {}, progress);
}

/// The largest part goes into the result; what nothing holds to it would lie anywhere.
void include(ChainRun& run) {
  const auto& part = run.state.graph->part;
  std::map<int, std::size_t> sizes;
  for (const int p : part) ++sizes[p];
  const int main = std::max_element(sizes.begin(), sizes.end(), [](const auto& a, const auto& b) { return a.second < b.second; })->first;
  run.included.clear();
  for (std::size_t v = 0; v < run.inputs.size(); ++v) (part[v] == main ? run.included : run.state.leftOut).push_back(v);
}

}  // namespace

Result<void> graphStep(ChainRun& run, Progress& progress) {
  if (auto fits = checkMemory(run, Step::graph); !fits) return fits;
  const Asked asked = askedOf(run);
  const std::string& key = run.keys[Step::graph];
  auto found = readBack<GraphResult>(run.store.find(nameOf(Step::graph), key), [](const json& data) { return graphFrom(data); });
  if (found && (found->toWorld.size() != run.inputs.size() || found->part.size() != run.inputs.size())) found.reset();
  run.outcomeOf(Step::graph).reused = found.has_value();
  if (found) {
    run.state.graph = std::move(*found);
  } else {
    auto solved = solve(run, asked.edges, progress);
    if (!solved) return passOn(solved.error());
    // Read back, so that a run that goes on and one that starts here see the same bits.
    const ordered_json data = jsonOf(*solved);
    run.state.graph = graphFrom(data);
    if (auto kept = run.store.keep(nameOf(Step::graph), key, data); !kept) return kept;
  }
  const GraphResult& graph = *run.state.graph;
  for (std::size_t e = 0; e < asked.pairOf.size() && e < graph.edges.size(); ++e) {
    PairOutcome& pair = run.state.pairs[asked.pairOf[e]];
    pair.inGraph = graph.edges[e];
    pair.wrong = pair.inGraph->wrong;
    pair.suspect = std::find(graph.suspects.begin(), graph.suspects.end(), e) != graph.suspects.end();
  }
  run.state.verdict = graph.verdict;
  run.state.reason = graph.reason;
  include(run);
  return {};
}

}  // namespace ew::stitching
