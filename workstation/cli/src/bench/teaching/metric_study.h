#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ew/assessment/statistics.h"
#include "ew/simulated_people/trainee_habits.h"

namespace ew {

/// One metric's figures in one step of one lesson: of each level's persons, the same person at the same place in every step. Nothing: it
/// could not be worked out.
struct StudyCell {
  std::string lesson;  ///< "case/lesson"
  std::string step;
  std::string kind;  ///< taskWord
  std::array<std::vector<std::optional<double>>, std::size(kSkillLevels)> values;
};

/// How far a metric tells two levels apart in the steps that it is worked out in, one step as the next. What is compared is always two
/// persons in one and the same step, so that steps of other lengths do not blur it.
struct Discrimination {
  int steps = 0;
  int persons = 0;  ///< of each level
  /// The probability that the better of two persons, one of each level, is the one of the higher level; ties counted half. Mean over the
  /// steps; the interval covers 95 %, by drawing persons again with all their steps (percentile bootstrap).
  std::optional<Estimate> area;
  /// Difference of the means in pooled standard deviations, corrected for small groups (Hedges, J Educ Stat 6:107, 1981); above 0: the
  /// higher level is better. Mean over the steps where any two values differ; the interval as above.
  std::optional<Estimate> effect;
};

/// @param cells of one metric, with as many persons each; @param moreIsBetter of the metric
[[nodiscard]] Discrimination discriminationOf(const std::vector<const StudyCell*>& cells, SkillLevel lower, SkillLevel higher,
                                              bool moreIsBetter, const Bootstrap& bootstrap);

}  // namespace ew
