#include "panel/stitch_session.h"

#include <algorithm>

#include "ew/sdk/panel.h"
#include "ew/stitching/places.h"
#include "panel/session_parts.h"

namespace ew::stitching {

std::optional<std::size_t> StitchSession::foundIndex(std::size_t index) const {
  if (!found_ || index >= project().volumes.size()) return std::nullopt;
  const auto at = std::find(foundKeys_.begin(), foundKeys_.end(), keyOf(project().volumes[index]));
  if (at == foundKeys_.end()) return std::nullopt;
  return static_cast<std::size_t>(at - foundKeys_.begin());
}

bool StitchSession::samePlaces(std::size_t index) const {
  const auto at = foundIndex(index);
  if (!at || *at >= asked_.volumes.size()) return false;
  const ProjectVolume& before = asked_.volumes[*at];
  const ProjectVolume& now = project().volumes[index];
  return before.placement == now.placement && before.toWorld == now.toWorld;
}

bool StitchSession::isFoundFresh() const { return found_ && asked_ == project(); }

const PairOutcome* StitchSession::outcomeOf(std::size_t fixed, std::size_t moving) const {
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

StitchSession::PairLine StitchSession::pairLine(std::size_t a, std::size_t b) const {
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
    switch (line.outcome->rigid.verdict) {
      case registration::Verdict::aligned:
        line.mark = line.wrong                                    ? Mark::notAligned
                    : line.outcome->used == PairMethod::byHand    ? Mark::byHand
                    : line.outcome->used == PairMethod::landmarks ? Mark::landmarks
                                                                  : Mark::aligned;
        break;
      case registration::Verdict::cannotTell:
        line.mark = Mark::cannotTell;
        break;
      case registration::Verdict::notAligned:
        line.mark = Mark::notAligned;
        break;
    }
  }
  if (line.stale && said.method == PairMethod::byHand) line.mark = Mark::byHand;  // moved away from what was proved
  if (said.decision == Decision::rejected) line.mark = Mark::rejected;
  const bool isHeld = line.mark == Mark::aligned || line.mark == Mark::landmarks;
  const WarpedPair* warp = warpedOf(low, high);
  line.warpDoubted = isHeld && warp != nullptr && warp->verdict != registration::Verdict::aligned;
  line.needsLook = line.outcome != nullptr && said.decision == Decision::undecided && (line.stale || !isHeld || line.warpDoubted);
  return line;
}

std::vector<StitchSession::PairLine> StitchSession::pairs() const {
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
          (pair_ && *pair_ == Shown{a, b}))
        lines.push_back(line);
    }
  }
  return lines;
}

StitchSession::Mark StitchSession::markOf(std::size_t index) const {
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

int StitchSession::pairsToLookAt() const {
  const auto all = pairs();
  return static_cast<int>(std::count_if(all.begin(), all.end(), [](const PairLine& line) { return line.needsLook; }));
}

QString StitchSession::pairSummary() const {
  const auto all = pairs();
  const auto matched = std::count_if(all.begin(), all.end(), [](const PairLine& line) { return line.outcome != nullptr; });
  const int look = pairsToLookAt();
  const int left = static_cast<int>(all.size()) - static_cast<int>(matched);
  if (matched == 0) return {};
  if (look > 0) return tr("%1 of %2 pairs need review").arg(look).arg(all.size());
  if (left > 0) return tr("%1 of %2 pairs not matched").arg(left).arg(all.size());
  return tr("no pair needs a look");
}

bool StitchSession::isMatchFresh() const {
  if (!found_ || !found_->graph) return false;
  for (std::size_t n = 0; n < project().volumes.size(); ++n)
    if (!foundIndex(n) || !samePlaces(n)) return false;
  const auto all = pairs();
  return std::none_of(all.begin(), all.end(), [](const PairLine& line) { return line.stale; });
}

const Transform<frame::World, frame::View>* StitchSession::foundPlace(std::size_t index) const {
  const auto at = foundIndex(index);
  return at && found_->graph && *at < found_->graph->toWorld.size() && samePlaces(index) ? &found_->graph->toWorld[*at] : nullptr;
}

Transform<frame::Placed, frame::View> StitchSession::placeGiven(std::size_t index) const {
  return renamed<frame::Placed, frame::View>(project().volumes[index].toWorld);
}

Transform<frame::World, frame::Placed> StitchSession::placedToShown(std::size_t index) const {
  for (std::size_t other = 0; other < project().volumes.size(); ++other) {
    if (other == index) continue;
    if (const auto* place = foundPlace(other)) return *place * rigidInverse(placeGiven(other));
  }
  return {};
}

Transform<frame::World, frame::View> StitchSession::toWorld(std::size_t index) const {
  if (index >= project().volumes.size()) return {};
  if (const auto* place = foundPlace(index)) return *place;
  return placedToShown(index) * placeGiven(index);
}

bool StitchSession::hasElastic() const {
  if (!found_ || !pair_ || found_->warps.empty() || !found_->graph) return false;
  const auto i = foundIndex(pair_->fixed);
  const auto j = foundIndex(pair_->moving);
  return i && j && *i < found_->warps.size() && *j < found_->warps.size() && *i < found_->graph->toWorld.size() &&
         *j < found_->graph->toWorld.size() && samePlaces(pair_->fixed) && samePlaces(pair_->moving);
}

std::vector<registration::Level> StitchSession::levelsSeen(bool ofWarp) const {
  std::vector<registration::Level> seen;
  const auto at = [&](std::size_t volume) {
    return std::find(runningKeys_.begin(), runningKeys_.end(), keyOf(project().volumes[volume])) - runningKeys_.begin();
  };
  const auto fixed = static_cast<std::size_t>(at(pair_->fixed));
  const auto moving = static_cast<std::size_t>(at(pair_->moving));
  for (const LevelSeen& each : runningLevels_)
    if (std::minmax(each.fixed, each.moving) == std::minmax(fixed, moving) && (each.level.node_mm > 0.0) == ofWarp)
      seen.push_back(each.level);
  return seen;
}

std::vector<registration::Level> StitchSession::levels() const {
  if (!pair_) return {};
  auto seen = levelsSeen(false);
  if (!seen.empty()) return seen;
  const PairLine line = pairLine(pair_->fixed, pair_->moving);
  return line.outcome != nullptr ? line.outcome->rigid.levels : seen;
}

std::vector<registration::Level> StitchSession::warpLevels() const {
  if (!pair_) return {};
  auto seen = levelsSeen(true);
  if (!seen.empty()) return seen;
  return warped() != nullptr ? warped()->levels : seen;
}

const WarpedPair* StitchSession::warped() const { return pair_ ? warpedOf(pair_->fixed, pair_->moving) : nullptr; }

const WarpedPair* StitchSession::warpedOf(std::size_t a, std::size_t b) const {
  if (!found_) return nullptr;
  const auto i = foundIndex(a);
  const auto j = foundIndex(b);
  if (!i || !j) return nullptr;
  for (const WarpedPair& each : found_->warpedPairs)
    if (std::minmax(each.fixed, each.moving) == std::minmax(*i, *j)) return &each;
  return nullptr;
}

bool StitchSession::isWarpedStale() const {
  const WarpedPair* pair = warped();
  return pair != nullptr &&
         (pair->effort != effortOf(project(), pair_->fixed, pair_->moving) || !hasElastic() || pairLine(pair_->fixed, pair_->moving).stale);
}

std::vector<std::optional<Grid>> StitchSession::gridsFound() const {
  std::vector<std::optional<Grid>> grids(asked_.volumes.size());
  for (std::size_t n = 0; n < grids.size(); ++n) {
    const auto at = volumes_.find(keyOf(asked_.volumes[n]));
    if (at != volumes_.end() && at->second) grids[n] = at->second->grid;
  }
  return grids;
}

MachinePace StitchSession::warpPace() const { return found_ ? paceOf(found_->warpedPairs, gridsFound()) : MachinePace{}; }

MachinePace StitchSession::searchPace() const {
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
