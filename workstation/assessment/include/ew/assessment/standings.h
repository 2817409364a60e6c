#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "ew/assessment/rating_statistics.h"
#include "ew/core/result.h"

namespace ew {

inline constexpr int kStandingsFormat = 1;  ///< `format`; a larger one is refused with newerFormat

/// What instructors have said of those who made attempts, by the attempt's id. Attempts of which nothing was said are not in it.
using StandingsByAttempt = std::map<std::string, Standing>;
/// unknown: nothing was said.
[[nodiscard]] Standing standingIn(const StandingsByAttempt& standings, const std::string& attemptId);

/// LIBRARY/assessment/standings.json: {"format": 1, "standings": {ATTEMPT: "should_pass" or "should_fail"}}. Other fields are kept.
[[nodiscard]] std::filesystem::path standingsFile(const std::filesystem::path& library);
/// What is kept; nothing where nobody has said anything yet. @error notReadable, tooLarge, badHeader, badField, newerFormat
[[nodiscard]] Result<StandingsByAttempt> readStandings(const std::filesystem::path& library);
/// Keeps what is said of one attempt and leaves what is said of others as it is, also what another window says meanwhile: the file is
/// written whole or not at all, under the folder's lock, and the change goes into the instructors' log. A file that cannot be read is not
/// written over.
/// @param attemptId not empty
/// @param standing unknown: what was said of it is taken back
/// @param person who says it, as they call themselves; may be empty
/// @return all that is kept now @error as readStandings, notWritable
[[nodiscard]] Result<StandingsByAttempt> keepStanding(const std::filesystem::path& library, const std::string& attemptId, Standing standing,
                                                      const std::string& person = {});

}  // namespace ew
