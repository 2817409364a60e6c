#include "ew/stitching/project.h"

#include <algorithm>
#include <tuple>

namespace ew::stitching {

bool speaksOfPose(const ProjectPair& pair) {
  ProjectPair rest = pair;
  rest.effort.reset();
  ProjectPair nothing;
  nothing.fixed = pair.fixed;
  nothing.moving = pair.moving;
  return !pair.effort || !(rest == nothing);
}

registration::ElasticEffort effortOf(const StitchProject& project, std::size_t fixed, std::size_t moving) {
  const auto [low, high] = std::minmax(fixed, moving);
  for (const ProjectPair& pair : project.pairs)
    if (pair.fixed == low && pair.moving == high && pair.effort) return *pair.effort;
  return project.settings.effort;
}

bool operator==(const StitchProject& a, const StitchProject& b) {
  const auto grid = [](const StitchProject& p) {
    const StitchOptions& g = p.settings.join.grid;
    return std::tuple(g.spacing_mm, g.featherWidth_mm, g.interpolatedWeight, g.axes);
  };
  const auto seam = [](const StitchProject& p) {
    SeamOptions s = p.settings.join.seam;
    s.threads = 0;
    return s;
  };
  const auto rest = [](const StitchProject& p) {
    const ProjectSettings& s = p.settings;
    return std::tuple(s.maxRotation_deg, s.trackerError_mm, s.trackerError_deg, s.equalise, s.elastic, s.effort, s.fallOff_mm);
  };
  return a.volumes == b.volumes && a.pairs == b.pairs && rest(a) == rest(b) && grid(a) == grid(b) && seam(a) == seam(b);
}

const char* nameOf(Placement placement) {
  switch (placement) {
    case Placement::unknown:
      return "unknown";
    case Placement::tracker:
      return "tracker";
    case Placement::hand:
      return "hand";
  }
  return "unknown";
}

const char* nameOf(PairMethod method) {
  switch (method) {
    case PairMethod::automatic:
      return "automatic";
    case PairMethod::search:
      return "search";
    case PairMethod::refine:
      return "refine";
    case PairMethod::landmarks:
      return "landmarks";
    case PairMethod::byHand:
      return "by hand";
  }
  return "automatic";
}

const char* nameOf(Decision decision) {
  switch (decision) {
    case Decision::undecided:
      return "undecided";
    case Decision::accepted:
      return "accepted";
    case Decision::rejected:
      return "rejected";
  }
  return "undecided";
}

const char* nameOf(registration::ElasticEffort effort) {
  switch (effort) {
    case registration::ElasticEffort::fast:
      return "fast";
    case registration::ElasticEffort::balanced:
      return "balanced";
    case registration::ElasticEffort::accurate:
      return "accurate";
  }
  return "balanced";
}

const char* nameOf(SeamMethod method) {
  switch (method) {
    case SeamMethod::feather:
      return "feather";
    case SeamMethod::nearest:
      return "nearest";
    case SeamMethod::graphCut:
      return "graph cut";
  }
  return "graph cut";
}

const char* nameOf(GridAxes axes) {
  switch (axes) {
    case GridAxes::first:
      return "first";
    case GridAxes::world:
      return "world";
  }
  return "first";
}

}  // namespace ew::stitching
