#include "graph/graph_verdict.h"

#include <cmath>
#include <string>
#include <vector>

#include "ew/core/numbers.h"
#include "graph/names.h"

namespace ew::registration::graph {
namespace {

std::string rounded(double value) { return textOf(std::round(value * 10.0) / 10.0); }

/// Believed pairs on no loop.
std::vector<std::size_t> uncheckedOf(const GraphResult& result) {
  std::vector<bool> known(result.edges.size(), true);
  for (const std::size_t e : result.withoutInformation) known[e] = false;
  std::vector<std::size_t> unchecked;
  for (std::size_t e = 0; e < result.edges.size(); ++e)
    if (known[e] && !result.edges[e].wrong && !result.edges[e].confirmed) unchecked.push_back(e);
  return unchecked;
}

}  // namespace

void judge(std::span<const GraphNode> nodes, std::span<const GraphEdge> edges, GraphResult& result) {
  std::vector<std::string> sentences;
  const auto say = [&](const std::string& sentence) { sentences.push_back(sentence); };
  Verdict verdict = Verdict::aligned;
  std::size_t confirmed = 0;
  for (const GraphEdgeReport& edge : result.edges) confirmed += edge.confirmed ? 1 : 0;

  if (nodes.size() == 1) {
    say("There is one subvolume; it stays where it is.");
  } else if (result.parts > 1) {
    verdict = Verdict::cannotTell;
    std::vector<std::string> parts(static_cast<std::size_t>(result.parts));
    std::vector<std::size_t> size(parts.size(), 0);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const auto p = static_cast<std::size_t>(result.part[i]);
      ++size[p];
      if (size[p] <= 8) parts[p] += (parts[p].empty() ? "" : ", ") + nameOfNode(nodes, i);
    }
    std::string text;
    for (std::size_t p = 0; p < parts.size() && p < 8; ++p)
      text += (p > 0 ? "; " : "") + parts[p] + (size[p] > 8 ? " and " + std::to_string(size[p] - 8) + " more" : "");
    say("Nothing joins these " + std::to_string(result.parts) + " parts: " + text + (result.parts > 8 ? "; and more" : "") +
        ". How they lie to each other is not known: match a pair between them.");
  }
  if (!result.undetermined.empty() && nodes.size() > 1) {
    verdict = Verdict::cannotTell;
    std::vector<std::string> names;
    for (const std::size_t i : result.undetermined) names.push_back(nameOfNode(nodes, i));
    say("The pairs leave " + listed(names) + " free to slide or turn.");
  }
  if (!result.wrong.empty() || !result.wrongPriors.empty()) {
    std::vector<std::string> names;
    for (const std::size_t e : result.wrong)
      names.push_back(nameOfEdge(nodes, edges[e]) + " (by " + rounded(result.edges[e].residual_mm) + " mm and " +
                      rounded(result.edges[e].residual_deg) + " degrees)");
    for (const std::size_t i : result.wrongPriors) names.push_back("the tracker's pose of " + nameOfNode(nodes, i));
    say((names.size() == 1 ? "Wrong, and left out, is " : "Wrong, and left out, are ") + listed(names) + ".");
  }
  if (!result.suspects.empty() || !result.suspectPriors.empty()) {
    verdict = Verdict::cannotTell;
    std::vector<std::string> names;
    for (const std::size_t e : result.suspects) names.push_back(nameOfEdge(nodes, edges[e]));
    for (const std::size_t i : result.suspectPriors) names.push_back("the tracker's pose of " + nameOfNode(nodes, i));
    say("It could as well be " + listed(names) +
        ": they lie on the same loop and nothing else tells them apart. Match another pair across it.");
  } else if (result.wrong.size() > confirmed) {
    verdict = Verdict::notAligned;
    say("More pairs contradict each other than agree.");
  }
  if (const auto unchecked = uncheckedOf(result); !unchecked.empty() && nodes.size() > 1) {
    std::vector<std::string> names;
    bool doubtful = false;
    for (const std::size_t e : unchecked) {
      names.push_back(nameOfEdge(nodes, edges[e]));
      doubtful = doubtful || edges[e].trust < 0.5;
    }
    say((names.size() == 1 ? "No loop checks the pair " : "No loop checks the pairs ") + listed(names) + ": were " +
        (names.size() == 1 ? "it" : "one of them") + " wrong, nothing would show it.");
    if (doubtful && verdict == Verdict::aligned) verdict = Verdict::cannotTell;
  }
  if (!result.withoutInformation.empty()) {
    std::vector<std::string> names;
    for (const std::size_t e : result.withoutInformation) names.push_back(nameOfEdge(nodes, edges[e]));
    say("Without information, and left out: " + listed(names) + ".");
  }
  if (result.stop == StopReason::iterationLimit || result.stop == StopReason::singular) {
    verdict = verdict == Verdict::aligned ? Verdict::cannotTell : verdict;
    say("The solution did not settle; allow more iterations.");
  }
  if (verdict == Verdict::aligned && nodes.size() > 1)
    sentences.insert(sentences.begin(), std::to_string(nodes.size()) + " subvolumes lie together, " + std::to_string(confirmed) +
                                            (confirmed == 1 ? " pair" : " pairs") + " confirmed by loops.");
  result.verdict = verdict;
  for (const auto& sentence : sentences) result.reason += (result.reason.empty() ? "" : " ") + sentence;
}

}  // namespace ew::registration::graph
