#include "panel/stitch_results.h"

#include <algorithm>
#include <utility>

#include "ew/stitching/places.h"
#include "logic/stitch_document.h"
#include "panel/project_document.h"
#include "panel/project_files.h"
#include "panel/project_inputs.h"

namespace ew::stitching {

StitchResults::StitchResults(const ProjectDocument& document, ProjectInputs& inputs) : document_(document), inputs_(inputs) {}

const StitchProject& StitchResults::project() const { return document_.project(); }

void StitchResults::settle(ChainState state, StitchProject asked) {
  foundKeys_.clear();
  for (std::size_t n = 0; n < asked.volumes.size(); ++n) {
    foundKeys_.push_back(keyOf(asked.volumes[n]));
    if (n < state.volumes.size() && state.volumes[n]) inputs_.keep(asked.volumes[n], state.volumes[n]);
  }
  turnedOutcomes_.clear();
  found_ = std::make_shared<const ChainState>(std::move(state));
  asked_ = std::move(asked);
  Q_EMIT settled();
}

void StitchResults::forget() {
  turnedOutcomes_.clear();
  found_.reset();
}

void StitchResults::moveFiles(const std::filesystem::path& before, const std::filesystem::path& after) {
  if (!found_) return;
  auto state = std::make_shared<ChainState>(*found_);
  for (std::filesystem::path* path : {&state->volume, &state->coverage, &state->source, &state->level, &state->provenance})
    if (!path->empty()) *path = after / path->lexically_relative(before);
  turnedOutcomes_.clear();
  found_ = std::move(state);
}

std::optional<std::size_t> StitchResults::foundIndex(std::size_t index) const {
  if (!found_ || index >= project().volumes.size()) return std::nullopt;
  const auto at = std::find(foundKeys_.begin(), foundKeys_.end(), keyOf(project().volumes[index]));
  if (at == foundKeys_.end()) return std::nullopt;
  return static_cast<std::size_t>(at - foundKeys_.begin());
}

bool StitchResults::samePlaces(std::size_t index) const {
  const auto at = foundIndex(index);
  if (!at || *at >= asked_.volumes.size()) return false;
  const ProjectVolume& before = asked_.volumes[*at];
  const ProjectVolume& now = project().volumes[index];
  return before.placement == now.placement && before.toWorld == now.toWorld;
}

bool StitchResults::isFoundFresh() const { return found_ && asked_ == project(); }

const PairOutcome* StitchResults::outcomeOf(std::size_t fixed, std::size_t moving) const {
  const auto [low, high] = std::minmax(fixed, moving);
  for (const PairOutcome& outcome : found_->pairs) {
    if (outcome.fixed != low || outcome.moving != high) continue;
    if (fixed < moving) return &outcome;
    // The list was put into another order since: the same answer, told from the other side.
    const auto [at, isNew] = turnedOutcomes_.try_emplace(&outcome, outcome);
    if (isNew) {
      PairOutcome& turned = at->second;
      std::swap(turned.fixed, turned.moving);
      turned.rigid.fixedToMoving = withRolesSwapped(outcome.rigid.fixedToMoving);
      for (auto& hypothesis : turned.hypotheses) hypothesis.fixedToMoving = withRolesSwapped(hypothesis.fixedToMoving);
    }
    return &at->second;
  }
  return nullptr;
}

StitchResults::PairLine StitchResults::pairLine(std::size_t a, std::size_t b) const {
  const auto [low, high] = std::minmax(a, b);
  PairLine line{low, high};
  const auto i = foundIndex(low);
  const auto j = foundIndex(high);
  if (i && j) line.outcome = outcomeOf(*i, *j);
  const ProjectPair said = pairOf(project(), low, high);
  if (line.outcome != nullptr) {
    ProjectPair before = pairOf(asked_, *i, *j);
    if (*i > *j) before = swapped(before);
    before.fixed = low;
    before.moving = high;
    before.decision = said.decision;
    before.effort = said.effort;  // of bending, which is another question
    line.stale = !(before == said) || !samePlaces(low) || !samePlaces(high);
    line.wrong = line.outcome->wrong;
  }
  const PairReview review = reviewOf(line.outcome, warpedOf(low, high), said, line.stale);
  line.mark = review.mark;
  line.warpDoubted = review.warpDoubted;
  line.needsLook = review.needsLook;
  return line;
}

std::vector<StitchResults::PairLine> StitchResults::pairs(const std::optional<VolumePair>& shown) const {
  const std::size_t count = project().volumes.size();
  std::vector<PairLine> lines;
  const bool any = found_ && !found_->pairs.empty();
  for (std::size_t a = 0; a < count; ++a) {
    for (std::size_t b = a + 1; b < count; ++b) {
      PairLine line = pairLine(a, b);
      ProjectPair nothing;
      nothing.fixed = a;
      nothing.moving = b;
      const bool isNew = any && (!foundIndex(a) || !foundIndex(b));
      if (line.outcome != nullptr || !(pairOf(project(), a, b) == nothing) || ((!any || isNew) && count <= 12) ||
          (shown == VolumePair{a, b}))
        lines.push_back(line);
    }
  }
  return lines;
}

StitchResults::Mark StitchResults::markOf(std::size_t index) const {
  Mark best = Mark::unknown;
  const auto rank = [](Mark mark) {
    switch (mark) {
      case Mark::aligned:
        return 6;
      case Mark::landmarks:
        return 5;
      case Mark::byHand:
        return 4;
      case Mark::cannotTell:
        return 3;
      case Mark::notAligned:
        return 2;
      case Mark::rejected:
        return 1;
      case Mark::unknown:
        return 0;
    }
    return 0;
  };
  for (std::size_t other = 0; other < project().volumes.size(); ++other) {
    if (other == index) continue;
    const PairLine line = pairLine(index, other);
    if (line.outcome != nullptr && rank(line.mark) > rank(best)) best = line.mark;
  }
  return best;
}

int StitchResults::pairsToLookAt() const {
  const auto all = pairs({});
  return static_cast<int>(std::count_if(all.begin(), all.end(), [](const PairLine& line) { return line.needsLook; }));
}

QString StitchResults::pairSummary(const std::optional<VolumePair>& shown) const {
  const auto all = pairs(shown);
  const auto matched = std::count_if(all.begin(), all.end(), [](const PairLine& line) { return line.outcome != nullptr; });
  const int look = pairsToLookAt();
  const int left = static_cast<int>(all.size()) - static_cast<int>(matched);
  if (matched == 0) return {};
  if (look > 0) return tr("%1 of %2 pairs need review").arg(look).arg(all.size());
  if (left > 0) return tr("%1 of %2 pairs not matched").arg(left).arg(all.size());
  return tr("no pair needs a look");
}

bool StitchResults::isMatchFresh() const {
  if (!found_ || !found_->graph) return false;
  for (std::size_t n = 0; n < project().volumes.size(); ++n)
    if (!foundIndex(n) || !samePlaces(n)) return false;
  const auto all = pairs({});
  return std::none_of(all.begin(), all.end(), [](const PairLine& line) { return line.stale; });
}

const Transform<frame::World, frame::View>* StitchResults::foundPlace(std::size_t index) const {
  const auto at = foundIndex(index);
  return at && found_->graph && *at < found_->graph->toWorld.size() && samePlaces(index) ? &found_->graph->toWorld[*at] : nullptr;
}

Transform<frame::Placed, frame::View> StitchResults::placeGiven(std::size_t index) const {
  return renamed<frame::Placed, frame::View>(project().volumes[index].toWorld);
}

Transform<frame::World, frame::Placed> StitchResults::placedToShown(std::size_t index) const {
  for (std::size_t other = 0; other < project().volumes.size(); ++other) {
    if (other == index) continue;
    if (const auto* place = foundPlace(other)) return *place * rigidInverse(placeGiven(other));
  }
  return {};
}

Transform<frame::World, frame::View> StitchResults::toWorld(std::size_t index) const {
  if (index >= project().volumes.size()) return {};
  if (const auto* place = foundPlace(index)) return *place;
  return placedToShown(index) * placeGiven(index);
}

bool StitchResults::hasElastic(std::size_t a, std::size_t b) const {
  if (!found_ || found_->warps.empty() || !found_->graph) return false;
  const auto i = foundIndex(a);
  const auto j = foundIndex(b);
  return i && j && *i < found_->warps.size() && *j < found_->warps.size() && *i < found_->graph->toWorld.size() &&
         *j < found_->graph->toWorld.size() && samePlaces(a) && samePlaces(b);
}

const PairDeformation* StitchResults::warpedOf(std::size_t a, std::size_t b) const {
  if (!found_) return nullptr;
  const auto i = foundIndex(a);
  const auto j = foundIndex(b);
  if (!i || !j) return nullptr;
  for (const PairDeformation& each : found_->warpedPairs)
    if (std::minmax(each.fixed, each.moving) == std::minmax(*i, *j)) return &each;
  return nullptr;
}

bool StitchResults::isWarpedStale(std::size_t a, std::size_t b) const {
  const PairDeformation* pair = warpedOf(a, b);
  return pair != nullptr && (pair->effort != effortOf(project(), a, b) || !hasElastic(a, b) || pairLine(a, b).stale);
}

std::vector<std::optional<Grid>> StitchResults::gridsFound() const {
  std::vector<std::optional<Grid>> grids(asked_.volumes.size());
  for (std::size_t n = 0; n < grids.size(); ++n)
    if (const auto volume = inputs_.volumeOf(asked_.volumes[n])) grids[n] = volume->grid;
  return grids;
}

MachinePace StitchResults::warpPace() const { return found_ ? paceOf(found_->warpedPairs, gridsFound()) : MachinePace{}; }

MachinePace StitchResults::searchPace() const {
  if (!found_) return {};
  const auto grids = gridsFound();
  std::vector<Timed> timed;
  for (const PairOutcome& pair : found_->pairs) {
    if (pair.used != PairMethod::search || pair.moving >= grids.size() || !grids[pair.fixed] || !grids[pair.moving]) continue;
    const double rotation_deg =
        ew::stitching::pairOf(asked_, pair.fixed, pair.moving).maxRotation_deg.value_or(asked_.settings.maxRotation_deg);
    timed.push_back({expectedSearch_s(*grids[pair.fixed], *grids[pair.moving], rotation_deg), pair.processor_s});
  }
  return paceOf(timed);
}

}  // namespace ew::stitching
