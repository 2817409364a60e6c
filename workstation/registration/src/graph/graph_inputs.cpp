#include "graph/graph_inputs.h"

#include <cmath>
#include <string>

#include "ew/core/frames.h"
#include "graph/covariance.h"
#include "graph/names.h"

namespace ew::registration::graph {
namespace {

bool allFinite(const glm::dvec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

}  // namespace

Result<void> checkGraph(std::span<const GraphNode> nodes, std::span<const GraphEdge> edges, const GraphOptions& options) {
  if (nodes.empty()) return failure(ErrorCode::emptyVolume, "There is no subvolume to place; add at least one.");
  for (const auto& [value, name] : {std::pair{options.lossScale, "lossScale"},
                                    {options.wrongAbove_mm, "wrongAbove_mm"},
                                    {options.wrongAbove_deg, "wrongAbove_deg"},
                                    {options.leastError_mm, "leastError_mm"},
                                    {options.leastError_deg, "leastError_deg"}})
    if (!std::isfinite(value) || value <= 0.0)
      return failure(ErrorCode::badField, std::string("The option ") + name + " must be above 0.", {{"field", name}});
  if (options.iterations < 1) return failure(ErrorCode::badField, "At least one iteration is needed.", {{"field", "iterations"}});
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    if (auto rigid = checkRigid(nodes[n].toWorld); !rigid)
      return failure(ErrorCode::notRigid, "The pose of " + nameOfNode(nodes, n) + " cannot be used: " + rigid.error().sentence());
    if (!allFinite(nodes[n].priorCentre_mm))
      return failure(ErrorCode::badField, "The centre of the tracker's covariance of " + nameOfNode(nodes, n) + " is not a number.",
                     {{"field", "priorCentre_mm"}});
    if (nodes[n].prior)
      if (auto fine = checkCovariance(*nodes[n].prior, "the tracker's pose of " + nameOfNode(nodes, n)); !fine) return fine;
  }
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const GraphEdge& edge = edges[e];
    const std::string number = "Pair " + std::to_string(e + 1);
    if (edge.fixed >= nodes.size() || edge.moving >= nodes.size())
      return failure(ErrorCode::badField,
                     number + " names a subvolume that does not exist; there are " + std::to_string(nodes.size()) + ".",
                     {{"field", "edges"}});
    if (edge.fixed == edge.moving)
      return failure(ErrorCode::badField, number + " joins " + nameOfNode(nodes, edge.fixed) + " with itself.", {{"field", "edges"}});
    const std::string name = nameOfEdge(nodes, edge);
    if (auto rigid = checkRigid(edge.fixedToMoving); !rigid)
      return failure(ErrorCode::notRigid, "The transform of the pair " + name + " cannot be used: " + rigid.error().sentence());
    if (!allFinite(edge.centre_mm) || !std::isfinite(edge.trust) || edge.trust < 0.0 || edge.trust > 1.0)
      return failure(ErrorCode::badField, "The pair " + name + " has a centre that is not a number or a trust outside 0..1.",
                     {{"field", "edges"}});
    if (edge.covariance)
      if (auto fine = checkCovariance(*edge.covariance, "the pair " + name); !fine) return fine;
  }
  return {};
}

}  // namespace ew::registration::graph
