#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ew/assessment/attempt_result.h"
#include "ew/core/result.h"
#include "ew/library/attempt.h"
#include "ew/library/lesson.h"

namespace ew {

// Statements of the Experience API, version 1.0.3 (ADL, xAPI Specification, Part Two): "somebody did something with something, with this
// result, in this context, then". A statement is its JSON.

inline constexpr const char* kXapiVersion = "1.0.3";

/// UUID of a name (RFC 4122, version 5: SHA-1), in small letters: the same on every machine. @param space a UUID
[[nodiscard]] std::string uuidOfName(std::string_view space, std::string_view name);
/// 8-4-4-4-12 hexadecimal digits, large or small.
[[nodiscard]] bool isUuid(std::string_view text);

/// A figure worked out from an attempt, with the version of its definition.
struct XapiMetric {
  std::string id;  ///< "path-length"
  int version = 1;
  double value = 0.0;  ///< finite
  std::string unit;    ///< "mm"; empty for a ratio
  std::string stepId;  ///< empty: of the whole attempt
  bool operator==(const XapiMetric&) const = default;
};

struct XapiOptions {
  /// Of the system in which people have accounts: an address of the site ("https://school.example/"). Has to be given unless `actor` is.
  std::string homePage;
  /// What the person is called instead of a name, the same in all their attempts (Pseudonyms::ofPerson). Has to be given unless `actor` is.
  std::string pseudonym;
  bool names = false;  ///< say the person's name beside the pseudonym
  /// An agent that somebody else has named, as a learning management system does at a launch; null: account with a pseudonym.
  nlohmann::json actor;
  std::string registration;  ///< UUID of the enrolment; empty: one of the attempt
  /// What ids of lessons, steps and cases begin with; a site that has an address of its own for them gives that.
  std::string activityBase = "urn:echoweave:";
  std::string language = "en";  ///< of the lesson's texts, as in a locale
  std::string courseId;         ///< of the course it belongs to; empty: none
  std::string caseTitle;        ///< for trainees; empty: not said
  /// The lesson as it was when it was tried: titles and kinds of steps. Without it a step is named by its id.
  std::optional<Lesson> lesson;
  /// What the attempt amounts to, as an instructor sees it (AttemptResults); empty: by the default plan, from what the lesson said.
  std::optional<AttemptResult> result;
  std::vector<XapiMetric> metrics;
};

/// What an attempt says, in the order in which it happened: attempted; for each outcome answered, completed, passed, failed or skipped; and
/// when it has ended completed, and passed or failed. Ids come from the attempt's id and from which of its events it is, so an event has
/// one id however often, wherever and with whatever options it is told; who wants it told differently has to void the statement.
///
/// What was handed in and is not judged yet is said without a score, and judged by a statement of its own afterwards.
///
/// Scores are those of the result: scaled 0 to 1, raw 0 to 100, of the attempt and of the latest outcome of each step; those of earlier
/// tries are as the lesson said them. Durations leave pauses out; the attempt's is that of all tries. Remarks and recordings stay here.
/// @error badField (home page, pseudonym, registration, base or language that cannot be used; a metric that is not finite; text that is not
/// UTF-8)
[[nodiscard]] Result<std::vector<nlohmann::json>> statementsOf(const Attempt& attempt, const XapiOptions& options);

/// Whether two statements of one id say the same (Part Three, 2.1.1 leaves out what servers may add or rewrite): who, verb, object, result,
/// registration, and when, to the millisecond.
[[nodiscard]] bool saysTheSame(const nlohmann::json& a, const nlohmann::json& b);

/// "PT83.42S", "PT1H2M3S" (ISO 8601, to the hundredth). @param seconds >= 0
[[nodiscard]] std::string isoDuration(double seconds);
/// "2026-11-26T09:30:00.000Z".
[[nodiscard]] std::string timestampText(std::chrono::sys_time<std::chrono::milliseconds> moment);
/// Nothing when it is not "YYYY-MM-DDThh:mm:ss", with or without a fraction, with Z or an offset behind it.
[[nodiscard]] std::optional<std::chrono::sys_time<std::chrono::milliseconds>> momentOfTimestamp(const std::string& text);

/// A verb with what it is called: {"id", "display": {"en", "de"}}.
enum class XapiVerb { attempted, answered, completed, passed, failed, skipped, initialized, terminated };
[[nodiscard]] nlohmann::json jsonOf(XapiVerb verb);

}  // namespace ew
