#include "ew/stitching/project.h"

#include <algorithm>
#include <tuple>

#include "chain/project_words.h"

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

const char* nameOf(Placement placement) { return wordIn(kPlacementWords, placement); }

const char* nameOf(PairMethod method) { return wordIn(kPairMethodWords, method); }

const char* nameOf(Decision decision) { return wordIn(kDecisionWords, decision); }

const char* nameOf(registration::ElasticEffort effort) { return wordIn(kElasticEffortWords, effort); }

const char* nameOf(SeamMethod method) { return wordIn(kSeamMethodWords, method); }

const char* nameOf(GridAxes axes) { return wordIn(kGridAxesWords, axes); }

}  // namespace ew::stitching
