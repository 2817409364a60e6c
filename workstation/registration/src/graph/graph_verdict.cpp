#include "graph/graph_verdict.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "ew/core/numbers.h"
#include "graph/names.h"
#include "listed.h"

namespace ew::registration::graph {
namespace {

Message rounded(double value) { return numeral(textOf(std::round(value * 10.0) / 10.0)); }

/// Believed pairs on no loop.
std::vector<std::size_t> uncheckedOf(const GraphResult& result) {
  std::vector<bool> known(result.edges.size(), true);
  for (const std::size_t e : result.withoutInformation) known[e] = false;
  std::vector<std::size_t> unchecked;
  for (std::size_t e = 0; e < result.edges.size(); ++e)
    if (known[e] && !result.edges[e].wrong && !result.edges[e].confirmed) unchecked.push_back(e);
  return unchecked;
}

Message namesOfEdges(std::span<const GraphNode> nodes, std::span<const GraphEdge> edges, const std::vector<std::size_t>& which,
                     const std::vector<std::size_t>& priors = {}) {
  std::vector<Message> names;
  for (const std::size_t e : which) names.push_back(nameOfEdge(nodes, edges[e]));
  for (const std::size_t i : priors) names.push_back(nameOfPrior(nodes, i));
  return listed(std::move(names));
}

/// "'a', 'b'; 'c'": the parts that nothing joins.
Message namesOfParts(std::span<const GraphNode> nodes, const GraphResult& result) {
  std::vector<std::vector<Message>> parts(static_cast<std::size_t>(result.parts));
  for (std::size_t i = 0; i < nodes.size(); ++i) parts[static_cast<std::size_t>(result.part[i])].push_back(nameOfNode(nodes, i));
  std::vector<Message> shown;
  for (auto& part : parts) {
    if (shown.size() == kMostNames) break;
    shown.push_back(part.size() > kMostNames ? listed(std::move(part)) : joined(std::move(part), ", "));
  }
  Message all = joined(std::move(shown), "; ");
  return parts.size() > kMostNames ? say<"%1; and more">(std::move(all)) : all;
}

Message wrongOnes(std::span<const GraphNode> nodes, std::span<const GraphEdge> edges, const GraphResult& result) {
  std::vector<Message> names;
  for (const std::size_t e : result.wrong)
    names.push_back(say<"%1 (by %2 mm and %3 degrees)">(nameOfEdge(nodes, edges[e]), rounded(result.edges[e].residual_mm),
                                                        rounded(result.edges[e].residual_deg)));
  for (const std::size_t i : result.wrongPriors) names.push_back(nameOfPrior(nodes, i));
  return names.size() == 1 ? say<"Wrong, and left out, is %1.">(listed(std::move(names)))
                           : say<"Wrong, and left out, are %1.">(listed(std::move(names)));
}

Message together(std::size_t nodes, std::size_t confirmed) {
  return confirmed == 1 ? say<"%1 subvolumes lie together, %2 pair confirmed by loops.">(nodes, confirmed)
                        : say<"%1 subvolumes lie together, %2 pairs confirmed by loops.">(nodes, confirmed);
}

}  // namespace

void judge(std::span<const GraphNode> nodes, std::span<const GraphEdge> edges, GraphResult& result) {
  std::vector<Message> sentences;
  Verdict verdict = Verdict::aligned;
  std::size_t confirmed = 0;
  for (const GraphEdgeReport& edge : result.edges) confirmed += edge.confirmed ? 1 : 0;

  if (nodes.size() == 1) {
    sentences.push_back(say<"There is one subvolume; it stays where it is.">());
  } else if (result.parts > 1) {
    verdict = Verdict::cannotTell;
    sentences.push_back(say<"Nothing joins these %1 parts: %2. How they lie to each other is not known: match a pair between them.">(
        result.parts, namesOfParts(nodes, result)));
  }
  if (!result.undetermined.empty() && nodes.size() > 1) {
    verdict = Verdict::cannotTell;
    std::vector<Message> names;
    for (const std::size_t i : result.undetermined) names.push_back(nameOfNode(nodes, i));
    sentences.push_back(say<"The pairs leave %1 free to slide or turn.">(listed(std::move(names))));
  }
  if (!result.wrong.empty() || !result.wrongPriors.empty()) sentences.push_back(wrongOnes(nodes, edges, result));
  if (!result.suspects.empty() || !result.suspectPriors.empty()) {
    verdict = Verdict::cannotTell;
    sentences.push_back(
        say<"It could as well be %1: they lie on the same loop and nothing else tells them apart. Match another pair across it.">(
            namesOfEdges(nodes, edges, result.suspects, result.suspectPriors)));
  } else if (result.wrong.size() > confirmed) {
    verdict = Verdict::notAligned;
    sentences.push_back(say<"More pairs contradict each other than agree.">());
  }
  if (const auto unchecked = uncheckedOf(result); !unchecked.empty() && nodes.size() > 1) {
    const Message names = namesOfEdges(nodes, edges, unchecked);
    sentences.push_back(unchecked.size() == 1 ? say<"No loop checks the pair %1: were it wrong, nothing would show it.">(names)
                                              : say<"No loop checks the pairs %1: were one of them wrong, nothing would show it.">(names));
    const bool doubtful = std::any_of(unchecked.begin(), unchecked.end(), [&](std::size_t e) { return edges[e].trust < 0.5; });
    if (doubtful && verdict == Verdict::aligned) verdict = Verdict::cannotTell;
  }
  if (!result.withoutInformation.empty())
    sentences.push_back(say<"Without information, and left out: %1.">(namesOfEdges(nodes, edges, result.withoutInformation)));
  if (result.stop == StopReason::iterationLimit || result.stop == StopReason::singular) {
    verdict = verdict == Verdict::aligned ? Verdict::cannotTell : verdict;
    sentences.push_back(say<"The solution did not settle; allow more iterations.">());
  }
  if (verdict == Verdict::aligned && nodes.size() > 1) sentences.insert(sentences.begin(), together(nodes.size(), confirmed));
  result.verdict = verdict;
  result.reason = joined(std::move(sentences));
}

}  // namespace ew::registration::graph
