#include <algorithm>
#include <chrono>
#include <optional>

#include "doubts.h"
#include "ew/core/elapsed.h"
#include "ew/core/parallel.h"
#include "ew/registration/rigid.h"
#include "refine.h"

namespace ew::registration {

namespace {

/// The refinement of a pair that shows something.
/// @param doubt what speaks against a result that is called aligned
Result<RigidResult> refinePair(const PairLevels& pair, const Transform<frame::Moving, frame::Fixed>& start, const RefineOptions& options,
                               int threads, Progress& progress, const OnLevel& onLevel, std::optional<Remark>& doubt) {
  doubt.reset();
  const auto cancelled = [] { return failure(ErrorCode::cancelled, say<"Registration was cancelled.">()); };
  RigidResult result;
  result.fixedToMoving = start;
  const auto finish = [&](Verdict verdict, Remark remark) {
    result.verdict = verdict;
    result.remarks = {std::move(remark)};
    return result;
  };
  const std::size_t at = pair.agreement;
  Evidence before;
  if (!evidenceAt(pair, at, start, pair.voxelsPerSample, threads, progress, before)) return cancelled();
  result.before = before.agreement;
  if (before.agreement.overlapShare <= 0.0) {
    result.stop = StopReason::noOverlap;
    return finish(Verdict::cannotTell, {RemarkCode::apartAtTheStart});
  }
  PartOfProgress refining(progress, 0.0, 0.85);
  if (!refineThrough(pair, 0, pair.fixed.size() - 1, start, options, threads, refining, onLevel, result)) return cancelled();
  if (result.stop == StopReason::noOverlap || result.stop == StopReason::singular) {
    const bool lost = result.stop == StopReason::noOverlap;
    result.fixedToMoving = start;
    result.after = result.before;
    return finish(Verdict::cannotTell, {lost ? RemarkCode::fewSharedVoxels : RemarkCode::poseNotHeld});
  }
  Evidence after;
  if (!evidenceAt(pair, at, result.fixedToMoving, pair.voxelsPerSample, threads, progress, after)) return cancelled();
  PartOfProgress halves(progress, 0.85, 1.0);
  if (!halvesApart(pair, 0, at, start, threads, halves, result.halvesDisagree_mm)) return cancelled();
  if (after.significance < before.significance) {
    // Nothing gained: the start is no worse than what was found.
    keepInstead(start, result);
    after = before;
  }
  result.after = after.agreement;
  if (after.significance < kChanceOfDescent) {
    if (mostSignificance(after) < kSureOfDescent) {
      return finish(Verdict::cannotTell, remarkWith(RemarkCode::overlapTooSmall, {}, after));
    }
    return finish(Verdict::notAligned, remarkWith(RemarkCode::unrelatedNearStart, {}, after));
  }
  if (after.significance < kSureOfDescent) {
    return finish(Verdict::cannotTell, remarkWith(RemarkCode::hardlyBetter, {}, after));
  }
  if (!(result.halvesDisagree_mm <= kHalvesApart_mm)) {
    return finish(Verdict::cannotTell, remarkWith(RemarkCode::startMayBeFar, {result.halvesDisagree_mm}, after));
  }
  if (!doubtsAbout(pair, start, result.fixedToMoving, after, threads, halves, doubt)) return cancelled();
  return finish(Verdict::aligned, remarkWith(RemarkCode::halvesAgree, {result.halvesDisagree_mm}, after));
}

/// Descending from the start alone, with shadows taken out where they decide.
Result<RigidResult> refineFrom(const Input& fixed, const Input& moving, const Transform<frame::Moving, frame::Fixed>& start,
                               const RefineOptions& options, int threads, Progress& progress, const OnLevel& onLevel) {
  const auto voxels = levelVoxels_mm(fixed.volume->grid, moving.volume->grid, options.coarsest_mm, options.finest_mm);
  PartOfProgress preparing(progress, 0.0, 0.3);
  auto prepared = preparePair(fixed, moving, voxels, threads, preparing);
  if (!prepared) return passOn(prepared.error());
  RigidResult result;
  result.fixedToMoving = start;
  const auto finish = [&](Verdict verdict, std::vector<Remark> remarks) {
    result.verdict = verdict;
    result.remarks = std::move(remarks);
    result.reason = messageOf(result.remarks);
    return result;
  };
  if (auto why = whyNothingCanBeSaid(*prepared)) {
    result.stop = StopReason::noOverlap;
    return finish(Verdict::cannotTell, {std::move(*why)});
  }
  PartOfProgress refining(progress, 0.3, 0.9);
  std::optional<Remark> doubt;
  auto refined = refinePair(*prepared, start, options, threads, refining, onLevel, doubt);
  if (!refined) return passOn(refined.error());
  result = std::move(*refined);
  if (result.verdict != Verdict::aligned) return finish(result.verdict, result.remarks);

  // Would it be found without what runs along the beams?
  PartOfProgress checking(progress, 0.9, 1.0);
  const Streaks streaks = streaksOf(fixed, moving, *prepared, threads, checking);
  if (progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"Registration was cancelled.">());
  // Streaks are the better reason where both are one.
  const auto unlessInDoubt = [&] { return doubt ? finish(Verdict::cannotTell, {*doubt}) : finish(result.verdict, result.remarks); };
  if (!streaks.found) return unlessInDoubt();
  const auto fare =
      fareWithoutStreaks(fixed, moving, streaks, voxels, 0, result.fixedToMoving, kSureOfDescent, threads, checking, *prepared);
  if (!fare) return passOn(fare.error());
  if (!fare->rests) return unlessInDoubt();
  if (!whyNothingCanBeSaid(*prepared)) {
    // From the start, and from where the pose went without streaks: either may be the nearer one.
    for (const Transform<frame::Moving, frame::Fixed>& from : {start, fare->fixedToMoving}) {
      auto again = refinePair(*prepared, from, options, threads, checking, onLevel, doubt);
      if (!again) return passOn(again.error());
      const PoseDifference moved = differenceOf(result.fixedToMoving, again->fixedToMoving, again->centre_mm);
      if (again->verdict != Verdict::aligned || doubt || !elsewhere(moved)) continue;
      result = std::move(*again);
      return finish(Verdict::aligned, {{RemarkCode::streaksTakenOut, {moved.shift_mm, moved.rotation_deg}}, result.remarks.front()});
    }
  }
  return finish(Verdict::cannotTell, {onlyStreaks(*fare, kSureOfDescent)});
}

}  // namespace

Result<RigidResult> refineRigid(const Input& fixed, const Input& moving, const Transform<frame::Moving, frame::Fixed>& start,
                                const RefineOptions& options, Progress& progress, const OnLevel& onLevel) {
  const auto begun = std::chrono::steady_clock::now();
  if (auto checked = checkInput(fixed, say<"fixed">()); !checked) return passOn(checked.error());
  if (auto checked = checkInput(moving, say<"moving">()); !checked) return passOn(checked.error());
  if (auto checked = checkOptions(options); !checked) return passOn(checked.error());
  if (auto checked = checkRigid(start); !checked) return passOn(checked.error());
  const int threads = threadCount(options.threads);
  const bool mayBeSearched = options.searchRotation_deg > 0.0;
  PartOfProgress descending(progress, 0.0, mayBeSearched ? 0.3 : 1.0);
  auto result = refineFrom(fixed, moving, start, options, threads, descending, onLevel);
  if (!result) return result;
  if (mayBeSearched && result->verdict != Verdict::aligned) {
    PartialOptions search;
    search.maxRotation_deg = options.searchRotation_deg;
    search.cell_mm = options.coarsest_mm;
    search.refine = options;
    search.threads = threads;
    PartOfProgress searching(progress, 0.3, 1.0);
    auto found = matchAbout(fixed, moving, start, search, searching, onLevel);
    if (!found) return passOn(found.error());
    const PoseDifference moved = differenceOf(start, found->best.fixedToMoving, found->best.centre_mm);
    if (found->best.verdict == Verdict::aligned && moved.shift_mm <= options.searchShift_mm) {
      const Agreement before = result->before;
      *result = std::move(found->best);
      result->before = before;
      result->remarks.insert(result->remarks.begin(), {RemarkCode::foundAboutTheStart, {moved.shift_mm, moved.rotation_deg}});
      result->reason = messageOf(result->remarks);
    }
  }
  result->seconds = secondsSince(begun);
  return result;
}

}  // namespace ew::registration
