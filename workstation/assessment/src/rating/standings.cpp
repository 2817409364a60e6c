#include "ew/assessment/standings.h"

#include <array>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "attempts/folder_lock.h"
#include "ew/core/contract.h"
#include "ew/core/data_file.h"
#include "ew/core/json_fields.h"
#include "ew/io/safe_file.h"
#include "ew/library/instructor_log.h"

namespace ew {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::array<std::pair<std::string_view, Standing>, 2> kStandingWords = {
    {{"should_pass", Standing::shouldPass}, {"should_fail", Standing::shouldFail}}};
constexpr const char *kFormatField = "format", *kStandingsField = "standings";

/// null: nothing is said.
json standingJson(Standing standing) {
  for (const auto& [word, each] : kStandingWords)
    if (each == standing) return word;
  return nullptr;
}

/// The file, with fields that this program does not know.
struct StandingsDocument {
  StandingsByAttempt standings;
  json otherFields = json::object();
};

Result<StandingsDocument> readDocument(const fs::path& file) {
  const auto text = readTextFile(file);
  if (!text && text.error().code == ErrorCode::notFound) return StandingsDocument{};
  if (!text) return passOn(text.error());
  const Message where = verbatim(file.filename().string());
  const auto document = parseJsonObject(*text, where);
  if (!document) return passOn(document.error());
  JsonReading reading(where);
  const JsonFields fields(*document, reading);
  requireFormat(fields, kStandingsFormat);
  const JsonFields said = fields.object(kStandingsField);
  StandingsDocument made;
  for (const auto& [id, word] : said.value().items()) made.standings[id] = said.word<std::string_view, Standing>(id, kStandingWords);
  if (reading.problem()) return passOn(*reading.problem());
  made.otherFields = *document;
  made.otherFields.erase(kFormatField);
  made.otherFields.erase(kStandingsField);
  return made;
}

std::string textOfDocument(const StandingsDocument& document) {
  json made = document.otherFields;
  made[kFormatField] = kStandingsFormat;
  made[kStandingsField] = json::object();
  for (const auto& [id, standing] : document.standings) made[kStandingsField][id] = standingJson(standing);
  return made.dump(1, ' ', false, json::error_handler_t::replace) + "\n";
}

}  // namespace

Standing standingIn(const StandingsByAttempt& standings, const std::string& attemptId) {
  const auto said = standings.find(attemptId);
  return said == standings.end() ? Standing::unknown : said->second;
}

fs::path standingsFile(const fs::path& library) { return assessmentFolder(library) / "standings.json"; }

Result<StandingsByAttempt> readStandings(const fs::path& library) {
  auto document = readDocument(standingsFile(library));
  if (!document) return passOn(document.error());
  return std::move(document->standings);
}

Result<StandingsByAttempt> keepStanding(const fs::path& library, const std::string& attemptId, Standing standing,
                                        const std::string& person) {
  EW_EXPECTS(!attemptId.empty());
  const fs::path file = standingsFile(library);
  const auto lock = assessment::lockFolder(file.parent_path());
  if (!lock) return passOn(lock.error());
  auto document = readDocument(file);
  if (!document) return passOn(document.error());
  StandingsByAttempt& kept = document->standings;
  const Standing before = standingIn(kept, attemptId);
  if (before == standing) return std::move(kept);
  if (standing == Standing::unknown)
    kept.erase(attemptId);
  else
    kept[attemptId] = standing;
  // What is not written down is not decided.
  if (auto logged = logChange(library, "standing changed", attemptId, standingJson(before), standingJson(standing), person); !logged)
    return passOn(logged.error());
  if (auto written = writeFileSafely(file, textOfDocument(*document)); !written) return passOn(written.error());
  return std::move(kept);
}

}  // namespace ew
