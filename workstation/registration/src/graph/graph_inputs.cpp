#include "graph/graph_inputs.h"

#include <cmath>

#include "ew/core/frames.h"
#include "graph/covariance.h"
#include "graph/names.h"

namespace ew::registration::graph {
namespace {

bool allFinite(const glm::dvec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

}  // namespace

Result<void> checkGraph(std::span<const GraphNode> nodes, std::span<const GraphEdge> edges, const GraphOptions& options) {
  if (nodes.empty()) return failure(ErrorCode::emptyVolume, say<"There is no subvolume to place; add at least one.">());
  for (const auto& [value, name] : {std::pair{options.lossScale, "lossScale"},
                                    {options.wrongAbove_mm, "wrongAbove_mm"},
                                    {options.wrongAbove_deg, "wrongAbove_deg"},
                                    {options.leastError_mm, "leastError_mm"},
                                    {options.leastError_deg, "leastError_deg"}})
    if (!std::isfinite(value) || value <= 0.0)
      return failure(ErrorCode::badField, say<"The option %1 must be above 0.">(verbatim(name)), {{"field", name}});
  if (options.iterations < 1) return failure(ErrorCode::badField, say<"At least one iteration is needed.">(), {{"field", "iterations"}});
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    if (auto rigid = checkRigid(nodes[n].toWorld); !rigid)
      return failure(ErrorCode::notRigid, say<"The pose of %1 cannot be used: %2">(nameOfNode(nodes, n), rigid.error().message));
    if (!allFinite(nodes[n].priorCentre_mm))
      return failure(ErrorCode::badField, say<"The centre of the tracker's covariance of %1 is not a number.">(nameOfNode(nodes, n)),
                     {{"field", "priorCentre_mm"}});
    if (nodes[n].prior)
      if (auto fine = checkCovariance(*nodes[n].prior, nameOfPrior(nodes, n)); !fine) return fine;
  }
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const GraphEdge& edge = edges[e];
    if (edge.fixed >= nodes.size() || edge.moving >= nodes.size())
      return failure(ErrorCode::badField, say<"Pair %1 names a subvolume that does not exist; there are %2.">(e + 1, nodes.size()),
                     {{"field", "edges"}});
    if (edge.fixed == edge.moving)
      return failure(ErrorCode::badField, say<"Pair %1 joins %2 with itself.">(e + 1, nameOfNode(nodes, edge.fixed)), {{"field", "edges"}});
    const Message name = nameOfEdge(nodes, edge);
    if (auto rigid = checkRigid(edge.fixedToMoving); !rigid)
      return failure(ErrorCode::notRigid, say<"The transform of the pair %1 cannot be used: %2">(name, rigid.error().message));
    if (!allFinite(edge.centre_mm) || !std::isfinite(edge.trust) || edge.trust < 0.0 || edge.trust > 1.0)
      return failure(ErrorCode::badField, say<"The pair %1 has a centre that is not a number or a trust outside 0..1.">(name),
                     {{"field", "edges"}});
    if (edge.covariance)
      if (auto fine = checkCovariance(*edge.covariance, say<"the pair %1">(name)); !fine) return fine;
  }
  return {};
}

}  // namespace ew::registration::graph
