#pragma once

#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "ew/assessment/metric.h"
#include "ew/core/result.h"
#include "ew/library/attempt.h"

namespace ew {

inline constexpr int kScoreFormat = 1;     ///< `format` of a score's file; a larger one is refused with newerFormat
inline constexpr int kScoringVersion = 2;  ///< of how metrics become scores; part of every key. 2: a value at its tolerance is within it

/// What a step of an attempt is worth by a plan: its score is that of the task with what else counts.
struct StepScore : StepResult {
  std::string stepId;
  std::string title;                 ///< as the lesson has it
  std::string kind;                  ///< taskWord
  double task = 0.0;                 ///< score of the task itself, 0 to 1
  double passLevel = 0.7;            ///< that the verdict was given by
  double weight = 1.0;               ///< in the lesson's score
  bool isJudgedAnew = false;         ///< from the raw data; false: as it was judged in the lesson, for the raw data are not there
  std::optional<double> validShare;  ///< of the images' poses, 0..1; metrics stand on these alone; empty: there was no recording to look at
  std::vector<MetricValue> metrics;
  bool operator==(const StepScore&) const = default;
};

/// What an attempt is worth by one version of everything that decides it.
struct AttemptScore {
  std::string attemptId;
  std::string caseId;
  std::string lessonId;
  std::string key;      ///< ContentKey of all that went in: raw data, lesson, case, plan, expert, versions
  std::string program;  ///< version
  int scoring = kScoringVersion;
  int planRevision = 0;
  std::string expertAttempt;  ///< that it was compared with; empty: none
  std::chrono::sys_seconds madeAt{};
  double score = 0.0;  ///< weighted mean of the steps', 0 to 1
  bool passed = false;
  std::optional<std::size_t> outcomes;  ///< that the attempt had then; empty: scores of version 1 do not say
  bool wasFinished = false;             ///< the attempt, then
  std::vector<StepScore> steps;         ///< of the lesson, in its order; one that was never ended counts 0
  std::vector<Message> notes;           ///< what scoring had to decide, in sentences
  int number = 0;                       ///< of the file it was read from; not saved
  bool operator==(const AttemptScore&) const = default;

  [[nodiscard]] const StepScore* of(const std::string& stepId) const;
};

/// @error badField, newerFormat
[[nodiscard]] Result<AttemptScore> scoreFromJson(const nlohmann::json& document);
/// scoreFromJson(jsonOf(s)) == s but for the number.
[[nodiscard]] nlohmann::json jsonOf(const AttemptScore& score);

/// ATTEMPT/scores/0001.json and on: the last one counts, earlier ones are never changed.
[[nodiscard]] std::vector<AttemptScore> scoresOf(const std::filesystem::path& attemptFolder);
/// Empty: it was never scored, or no score can be read.
[[nodiscard]] std::optional<AttemptScore> latestScore(const std::filesystem::path& attemptFolder);
/// Keeps a score as the next one. @return with its number. @error notWritable
[[nodiscard]] Result<AttemptScore> keepScore(const std::filesystem::path& attemptFolder, AttemptScore score);

}  // namespace ew
