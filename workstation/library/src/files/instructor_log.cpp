#include "ew/library/instructor_log.h"

#include <pwd.h>
#include <unistd.h>

#include <array>
#include <sstream>

#include "ew/core/json_fields.h"
#include "ew/io/private_file.h"
#include "ew/library/timestamp.h"

namespace ew {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::size_t kLargestLog_bytes = 256u << 20;

std::optional<InstructorChange> changeIn(const std::string& line) {
  const Message where = say<"a line of the instructors' log">();
  const auto document = parseJsonObject(line, where);
  if (!document) return std::nullopt;
  JsonReading reading(where);
  const JsonFields fields(*document, reading);
  InstructorChange change;
  const auto at = readTimestamp(fields, "at", true);
  change.who = fields.text("who", std::string(), 0);
  change.what = fields.text("what");
  change.of = fields.text("of", std::string(), 0, 1000);
  if (const json* before = fields.find("before")) change.before = *before;
  if (const json* after = fields.find("after")) change.after = *after;
  if (!at || reading.problem()) return std::nullopt;
  change.at = *at;
  return change;
}

}  // namespace

fs::path assessmentFolder(const fs::path& library) { return library / "assessment"; }
fs::path instructorLogFile(const fs::path& library) { return assessmentFolder(library) / "changes.jsonl"; }

std::string accountName(const std::string& person) {
  std::array<char, 4096> room{};
  passwd entry{};
  passwd* found = nullptr;
  const bool known = ::getpwuid_r(::geteuid(), &entry, room.data(), room.size(), &found) == 0 && found != nullptr;
  const std::string account = known ? std::string(entry.pw_name) : std::to_string(::geteuid());
  return person.empty() ? account : account + " (" + person + ")";
}

Result<void> logChange(const fs::path& library, const InstructorChange& change) {
  std::error_code ignored;
  fs::create_directories(library, ignored);  // the library itself may be for several
  if (auto made = makePrivateFolder(assessmentFolder(library)); !made) return made;
  json line = {{"at", timestampText(change.at)}, {"who", change.who}, {"what", change.what}};
  if (!change.of.empty()) line["of"] = change.of;
  if (!change.before.is_null()) line["before"] = change.before;
  if (!change.after.is_null()) line["after"] = change.after;
  return appendPrivateLine(instructorLogFile(library), line.dump(-1, ' ', false, json::error_handler_t::replace));
}

Result<void> logChange(const fs::path& library, const std::string& what, const std::string& of, json before, json after,
                       const std::string& person) {
  return logChange(library, {.at = std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now()),
                             .who = accountName(person),
                             .what = what,
                             .of = of,
                             .before = std::move(before),
                             .after = std::move(after)});
}

Result<InstructorLog> readInstructorLog(const fs::path& library) {
  const auto text = readPrivateFile(instructorLogFile(library), kLargestLog_bytes);
  if (!text && text.error().code == ErrorCode::notFound) return InstructorLog{};
  if (!text) return passOn(text.error());
  InstructorLog log;
  std::istringstream lines(*text);
  for (std::string line; std::getline(lines, line);) {
    if (line.empty()) continue;
    if (auto change = changeIn(line))
      log.changes.push_back(std::move(*change));
    else
      ++log.damaged;
  }
  return log;
}

}  // namespace ew
