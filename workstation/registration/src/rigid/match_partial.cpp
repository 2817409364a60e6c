#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "ew/core/elapsed.h"
#include "ew/core/parallel.h"
#include "ew/registration/rigid.h"
#include "refine.h"
#include "translations.h"

namespace ew::registration {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr int kPeaksPerTurn = 3;
constexpr int kCandidatesPerHypothesis = 4;  // descended at the cells of the search, for each that goes on
// Poses further apart than this after descending are different answers; descents that end are within a tenth of it.
constexpr double kSame_mm = 4.0;
constexpr double kSame_deg = 4.0;
constexpr double kDifferent_mm = 10.0;
constexpr double kDifferent_deg = 10.0;
constexpr double kAsGood = 0.8;

struct Candidate {
  Transform<frame::Moving, frame::Fixed> start;   ///< as the search found it
  Transform<frame::Moving, frame::Fixed> coarse;  ///< descended at the cells of the search
  Transform<frame::Moving, frame::Fixed> pose;
  Evidence evidence;
};

/// Levels of refinement with the cells of the search among them, and which that is.
std::vector<double> voxelsFor(const Grid& fixed, const Grid& moving, const PartialOptions& options, std::size_t& search) {
  auto voxels = levelVoxels_mm(fixed, moving, options.refine.coarsest_mm, options.refine.finest_mm);
  const double cell_mm = std::max(options.cell_mm, voxels.back());
  for (search = 0; search < voxels.size(); ++search) {
    if (std::abs(voxels[search] / cell_mm - 1.0) < 0.15) return voxels;
  }
  search = 0;
  while (search < voxels.size() && voxels[search] > cell_mm) ++search;
  voxels.insert(voxels.begin() + static_cast<std::ptrdiff_t>(search), cell_mm);
  return voxels;
}

/// Best first, without those that repeat a better one.
void keepDifferent(std::vector<Candidate>& pool, const glm::dvec3& at_mm, double same_mm, double same_deg, std::size_t most) {
  std::stable_sort(pool.begin(), pool.end(),
                   [](const Candidate& a, const Candidate& b) { return a.evidence.significance > b.evidence.significance; });
  std::vector<Candidate> kept;
  for (const Candidate& candidate : pool) {
    if (kept.size() >= most) break;
    const bool repeats = std::any_of(kept.begin(), kept.end(), [&](const Candidate& better) {
      const PoseDifference d = differenceOf(better.pose, candidate.pose, at_mm);
      return d.rotation_deg <= same_deg && d.shift_mm <= same_mm;
    });
    if (!repeats) kept.push_back(candidate);
  }
  pool = std::move(kept);
}

Result<void> checkOptions(const PartialOptions& options) {
  const auto wrong = [](const char* field, double found, const Message& expected) {
    return failure(ErrorCode::badField,
                   say<"The matching option %1 is %2; it must be %3.">(verbatim(field), numeral(std::to_string(found)), expected));
  };
  if (!(options.maxRotation_deg >= 0.0 && options.maxRotation_deg <= 180.0))
    return wrong("maxRotation_deg", options.maxRotation_deg, say<"from 0 to 180">());
  if (!(options.stepRotation_deg >= 2.0 && options.stepRotation_deg <= 90.0))
    return wrong("stepRotation_deg", options.stepRotation_deg, say<"from 2 to 90">());
  if (!(options.cell_mm > 0.0 && options.cell_mm <= 100.0)) return wrong("cell_mm", options.cell_mm, say<"above 0 and at most 100">());
  if (!(options.leastOverlap > 0.0 && options.leastOverlap < 1.0))
    return wrong("leastOverlap", options.leastOverlap, say<"between 0 and 1">());
  if (options.hypotheses < 1 || options.hypotheses > 1000) return wrong("hypotheses", options.hypotheses, say<"from 1 to 1000">());
  return checkOptions(options.refine);
}

/// The search over a pair that shows something: peaks of all shifts, descents from the best of them, and what is to be said of the best.
class PairSearch {
 public:
  PairSearch(const PairLevels& pair, std::size_t search, const PartialOptions& options, int threads, Progress& progress)
      : pair_(pair),
        search_(search),
        at_(std::max(pair.agreement, search)),
        options_(options),
        threads_(threads),
        progress_(progress),
        middle_mm_(carried(pair.fixed[search].grid.voxelTo<frame::Fixed>(), 0.5 * glm::dvec3(pair.fixed[search].grid.dims - 1))) {}

  /// @param base   what rotations start from
  /// @param beside one more pose to descend from, found in another way; judged like the others
  [[nodiscard]] Result<PartialResult> run(const glm::dmat3& base, const std::optional<Transform<frame::Moving, frame::Fixed>>& beside,
                                          const OnLevel& onLevel);

 private:
  // What can be cancelled returns false then.
  [[nodiscard]] bool findPeaks(const glm::dmat3& base);
  [[nodiscard]] bool descendFromAll();
  [[nodiscard]] bool descendAt(std::size_t level, int iterations, Progress& progress);
  void rankAnswers();
  [[nodiscard]] bool refineBest(const OnLevel& onLevel);
  [[nodiscard]] PartialResult judge();
  [[nodiscard]] PartialResult finish(Verdict verdict, Remark remark);

  const PairLevels& pair_;
  std::size_t search_;  ///< the level of the search over shifts
  std::size_t at_;      ///< the level at which candidates are judged
  const PartialOptions& options_;
  int threads_;
  Progress& progress_;
  glm::dvec3 middle_mm_;  ///< of the fixed image
  std::vector<Candidate> pool_;
  Candidate best_;
  Evidence after_;
  PartialResult result_;
};

Result<PartialResult> PairSearch::run(const glm::dmat3& base, const std::optional<Transform<frame::Moving, frame::Fixed>>& beside,
                                      const OnLevel& onLevel) {
  const auto cancelled = [] { return failure(ErrorCode::cancelled, say<"Registration was cancelled.">()); };
  if (!findPeaks(base)) return cancelled();
  if (beside) pool_.push_back({*beside, *beside, *beside, {}});
  if (!descendFromAll()) return cancelled();
  if (pool_.empty() || pool_[0].evidence.significance <= 0.0) {
    result_.best.stop = StopReason::noOverlap;
    return finish(Verdict::notAligned, {RemarkCode::noPoseAgrees, {options_.leastOverlap}});
  }
  rankAnswers();
  if (!refineBest(onLevel)) return cancelled();
  return judge();
}

bool PairSearch::findPeaks(const glm::dmat3& base) {
  const auto turns = rotationLattice(options_.maxRotation_deg * kDegree, options_.stepRotation_deg * kDegree);
  result_.poses = static_cast<int>(turns.size());
  PartOfProgress searching(progress_, 0.0, 0.65);
  const auto peaks = correlateOverTranslations(pair_.fixed[search_], pair_.moving[search_], turns,
                                               {options_.leastOverlap, kPeaksPerTurn, threads_, base}, searching);
  if (progress_.cancelRequested()) return false;
  for (std::size_t p = 0; p < peaks.size() && static_cast<int>(p) < kCandidatesPerHypothesis * options_.hypotheses; ++p) {
    pool_.push_back({peaks[p].fixedToMoving, peaks[p].fixedToMoving, peaks[p].fixedToMoving, {}});
  }
  return true;
}

/// The most significant peaks descend at the cells of the search, the best of them at the level of agreement.
bool PairSearch::descendFromAll() {
  PartOfProgress descending(progress_, 0.65, 0.83);
  const auto most = static_cast<std::size_t>(options_.hypotheses);
  if (!descendAt(search_, 12, descending)) return false;
  for (Candidate& candidate : pool_) candidate.coarse = candidate.pose;
  keepDifferent(pool_, middle_mm_, kSame_mm, kSame_deg, most);
  for (std::size_t level = search_ + 1; level <= at_; ++level) {
    if (!descendAt(level, 20, descending)) return false;
  }
  keepDifferent(pool_, middle_mm_, kSame_mm, kSame_deg, most);
  return true;
}

bool PairSearch::descendAt(std::size_t level, int iterations, Progress& progress) {
  const double perSample = level == pair_.agreement ? pair_.voxelsPerSample : voxelsPerSample(pair_.fixed[level], pair_.moving[level]);
  const double voxel = pair_.fixed[level].grid.spacing_mm.x;
  DescentOptions descent;
  descent.iterations = iterations;
  descent.stop_mm = 0.03 * voxel;
  descent.limit_mm = 2.0 * voxel;
  for (Candidate& candidate : pool_) {
    const Descent found = descend(pair_.fixed[level], pair_.packedMoving[level], candidate.pose, descent, threads_, progress);
    if (found.stop == StopReason::cancelled) return false;
    candidate.pose = found.fixedToMoving;
    if (!evidenceAt(pair_, level, candidate.pose, perSample, threads_, progress, candidate.evidence)) return false;
    // Descents may slide to where hardly anything overlaps and anything agrees.
    if (candidate.evidence.agreement.overlapShare < 0.6 * options_.leastOverlap) candidate.evidence.significance = 0.0;
  }
  return true;
}

/// A different answer lies further off than descents go astray; one that is near counts only when it is about as good, as it is where
/// structure repeats within less than that.
void PairSearch::rankAnswers() {
  best_ = pool_[0];
  const double near = pool_.size() > 1 ? pool_[1].evidence.significance : 0.0;
  keepDifferent(pool_, middle_mm_, kDifferent_mm, kDifferent_deg, pool_.size());
  const double far = pool_.size() > 1 ? pool_[1].evidence.significance : 0.0;
  const double rival = near > kAsGood * best_.evidence.significance ? std::max(near, far) : far;
  result_.margin = best_.evidence.significance / std::max(1.0, rival);
  for (const Candidate& c : pool_) {
    result_.hypotheses.push_back({c.pose, c.evidence.significance, c.evidence.agreement.correlation, c.evidence.agreement.overlapShare});
  }
}

bool PairSearch::refineBest(const OnLevel& onLevel) {
  RigidResult& found = result_.best;
  PartOfProgress finishing(progress_, 0.83, 1.0);
  Evidence before;
  if (!evidenceAt(pair_, at_, best_.start, pair_.voxelsPerSample, threads_, finishing, before)) return false;
  found.before = before.agreement;
  if (!halvesApart(pair_, search_, at_, best_.coarse, threads_, finishing, found.halvesDisagree_mm)) return false;
  const std::size_t first = std::min(at_ + 1, pair_.fixed.size() - 1);
  if (!refineThrough(pair_, first, pair_.fixed.size() - 1, best_.pose, options_.refine, threads_, finishing, onLevel, found)) return false;
  if (!evidenceAt(pair_, at_, found.fixedToMoving, pair_.voxelsPerSample, threads_, finishing, after_)) return false;
  if (after_.significance < 0.9 * best_.evidence.significance) {
    // The finest images led astray what coarser ones had found.
    keepInstead(best_.pose, found);
    after_ = best_.evidence;
  }
  found.after = after_.agreement;
  return true;
}

PartialResult PairSearch::judge() {
  const double halves_mm = result_.best.halvesDisagree_mm;
  if (after_.significance < kChanceOfSearch) {
    if (mostSignificance(after_) < kSureOfSearch) return finish(Verdict::cannotTell, remarkWith(RemarkCode::foundTooSmall, {}, after_));
    return finish(Verdict::notAligned, remarkWith(RemarkCode::unrelatedEverywhere, {static_cast<double>(result_.poses)}, after_));
  }
  if (after_.significance < kSureOfSearch) return finish(Verdict::cannotTell, remarkWith(RemarkCode::bestHardlyBetter, {}, after_));
  if (result_.margin < kLeastMargin) return finish(Verdict::cannotTell, remarkWith(RemarkCode::twoPosesAlike, {result_.margin}, after_));
  if (!(halves_mm <= kHalvesApart_mm)) return finish(Verdict::cannotTell, remarkWith(RemarkCode::halvesContradict, {halves_mm}, after_));
  return finish(Verdict::aligned, remarkWith(RemarkCode::onePoseStandsOut, {result_.margin, halves_mm}, after_));
}

PartialResult PairSearch::finish(Verdict verdict, Remark remark) {
  result_.best.verdict = verdict;
  result_.best.remarks = {std::move(remark)};
  return std::move(result_);
}

}  // namespace

std::uint64_t forecastPartial_bytes(const Grid& fixed, const Grid& moving, const PartialOptions& options) {
  std::size_t search = 0;
  const auto voxels = voxelsFor(fixed, moving, options, search);
  const auto turns = rotationLattice(options.maxRotation_deg * kDegree, options.stepRotation_deg * kDegree).size();
  const ComparableMemory f = forecastComparable(fixed, voxels);
  const ComparableMemory m = forecastComparable(moving, voxels);
  return std::max(forecastPair_bytes(fixed, moving, voxels),
                  f.result_bytes + m.result_bytes +
                      forecastTranslations_bytes(levelGrid(fixed, voxels[search]), levelGrid(moving, voxels[search]),
                                                 threadCount(options.threads), turns));
}

Result<PartialResult> matchPartial(const Input& fixed, const Input& moving, const PartialOptions& options, Progress& progress,
                                   const OnLevel& onLevel) {
  return matchAbout(fixed, moving, {}, options, progress, onLevel);
}

Result<PartialResult> matchAbout(const Input& fixed, const Input& moving, const Transform<frame::Moving, frame::Fixed>& start,
                                 const PartialOptions& options, Progress& progress, const OnLevel& onLevel) {
  const auto begun = std::chrono::steady_clock::now();
  const auto cancelled = [] { return failure(ErrorCode::cancelled, say<"Registration was cancelled.">()); };
  if (auto checked = checkInput(fixed, say<"fixed">()); !checked) return passOn(checked.error());
  if (auto checked = checkInput(moving, say<"moving">()); !checked) return passOn(checked.error());
  if (auto checked = checkOptions(options); !checked) return passOn(checked.error());
  const int threads = threadCount(options.threads);
  std::size_t search = 0;
  const auto voxels = voxelsFor(fixed.volume->grid, moving.volume->grid, options, search);
  PartOfProgress preparing(progress, 0.0, 0.15);
  auto prepared = preparePair(fixed, moving, voxels, threads, preparing);
  if (!prepared) return passOn(prepared.error());
  PartialResult result;
  const auto finish = [&](Verdict verdict, std::vector<Remark> remarks) {
    result.best.verdict = verdict;
    result.best.remarks = std::move(remarks);
    result.best.reason = messageOf(result.best.remarks);
    result.seconds = secondsSince(begun);
    result.best.seconds = result.seconds;
    return result;
  };
  if (auto why = whyNothingCanBeSaid(*prepared)) {
    result.best.stop = StopReason::noOverlap;
    return finish(Verdict::cannotTell, {std::move(*why)});
  }

  PartOfProgress matching(progress, 0.15, 0.95);
  auto matched = PairSearch(*prepared, search, options, threads, matching).run(glm::dmat3(start.matrix), std::nullopt, onLevel);
  if (!matched) return passOn(matched.error());
  result = std::move(*matched);
  const bool aligned = result.best.verdict == Verdict::aligned;
  const bool ambiguous = result.best.verdict == Verdict::cannotTell && !result.hypotheses.empty() &&
                         result.hypotheses[0].significance >= kSureOfSearch;  // streaks may be what repeats or contradicts
  if (!aligned && !ambiguous) return finish(result.best.verdict, result.best.remarks);

  // Would it be found without what runs along the beams?
  PartOfProgress checking(progress, 0.95, 1.0);
  const Streaks streaks = streaksOf(fixed, moving, *prepared, threads, checking);
  if (progress.cancelRequested()) return cancelled();
  if (!streaks.found) return finish(result.best.verdict, result.best.remarks);
  const auto fare =
      fareWithoutStreaks(fixed, moving, streaks, voxels, search, result.best.fixedToMoving, kSureOfSearch, threads, checking, *prepared);
  if (!fare) return passOn(fare.error());
  if (aligned && !fare->rests) return finish(result.best.verdict, result.best.remarks);
  if (!whyNothingCanBeSaid(*prepared)) {
    // What is left without streaks may be fine enough to fall between two turns of the search: where the pose went is one more place to
    // look.
    auto again = PairSearch(*prepared, search, options, threads, checking).run(glm::dmat3(start.matrix), fare->fixedToMoving, onLevel);
    if (!again) return passOn(again.error());
    const PoseDifference moved = differenceOf(result.best.fixedToMoving, again->best.fixedToMoving, again->best.centre_mm);
    if (again->best.verdict == Verdict::aligned && (!aligned || elsewhere(moved))) {
      result = std::move(*again);
      return finish(Verdict::aligned, {{RemarkCode::streaksTakenOut, {moved.shift_mm, moved.rotation_deg}}, result.best.remarks.front()});
    }
  }
  return finish(Verdict::cannotTell, aligned ? std::vector{onlyStreaks(*fare, kSureOfSearch)} : result.best.remarks);
}

}  // namespace ew::registration
