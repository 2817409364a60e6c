#include "ew/assessment/repetition_record.h"

#include <algorithm>

#include "ew/core/json_fields.h"
#include "ew/io/content_key.h"
#include "ew/io/file_lock.h"
#include "ew/io/json_files.h"
#include "ew/io/safe_file.h"
#include "ew/library/lesson.h"

namespace ew {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLargestRepetition_bytes = 64u << 20;

Result<FileLock> lockOf(const fs::path& file) {
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  if (error)
    return failure(ErrorCode::notWritable,
                   say<"The folder '%1' for your exercises cannot be made (%2); free some space, or choose a library you may write to.">(
                       file.parent_path(), verbatim(error.message())),
                   {{"file", file.string()}});
  auto taken = FileLock::tryTakeSoon(file.parent_path() / ".lock");
  if (!taken) return passOn(taken.error());
  if (*taken) return std::move(**taken);
  return failure(ErrorCode::notWritable, say<"Another window is writing '%1'; try again in a moment.">(file), {{"file", file.string()}});
}

Result<std::vector<RepetitionState>> statesIn(const fs::path& file) {
  std::error_code ignored;
  if (!fs::exists(file, ignored)) return std::vector<RepetitionState>();
  auto document = readJsonFile(file, verbatim(file.filename().string()), kLargestRepetition_bytes);
  if (!document) return passOn(document.error());
  return repetitionFromJson(*document);
}

/// A name beside the file that nothing has.
fs::path asideOf(const fs::path& file) {
  std::error_code ignored;
  fs::path aside = file.parent_path() / "repetition-unreadable.json";
  for (int n = 2; fs::exists(aside, ignored); ++n) aside = file.parent_path() / ("repetition-unreadable-" + std::to_string(n) + ".json");
  return aside;
}

/// While the lock is held.
Result<RepetitionRecord> readLocked(const fs::path& file) {
  auto states = statesIn(file);
  if (states) return RepetitionRecord{std::move(*states), std::nullopt};
  if (states.error().code == ErrorCode::newerFormat || states.error().code == ErrorCode::notReadable) return passOn(states.error());
  const fs::path aside = asideOf(file);
  std::error_code error;
  fs::rename(file, aside, error);
  if (error)
    return failure(ErrorCode::notWritable,
                   say<"'%1' cannot be read, nor be put aside (%2); move it away.">(file, verbatim(error.message())),
                   {{"file", file.string()}});
  return RepetitionRecord{
      {},
      say<"What was known of your exercises cannot be read; it was put aside as '%1', and the exercises begin anew. %2">(
          aside.filename(), states.error().message)};
}

}  // namespace

fs::path repetitionFile(const fs::path& library, const std::string& person) {
  const fs::path learning = library / "learning";
  if (person.empty()) return learning / "repetition.json";
  const std::string letters = idFor(person.substr(0, 60), {}, "person");
  return learning / (letters + "-" + ContentKey().add(person).text().substr(0, 12)) / "repetition.json";
}

Result<RepetitionRecord> readRepetition(const fs::path& file) {
  auto states = statesIn(file);
  if (states) return RepetitionRecord{std::move(*states), std::nullopt};
  if (states.error().code == ErrorCode::newerFormat || states.error().code == ErrorCode::notReadable) return passOn(states.error());
  auto lock = lockOf(file);
  if (!lock) return passOn(lock.error());
  return readLocked(file);
}

std::vector<RepetitionState> withTry(std::vector<RepetitionState> states, const std::string& exerciseId, int grade,
                                     std::chrono::sys_seconds when) {
  auto state = std::find_if(states.begin(), states.end(), [&](const RepetitionState& each) { return each.exerciseId == exerciseId; });
  if (state == states.end()) {
    states.emplace_back().exerciseId = exerciseId;
    state = states.end() - 1;
  }
  *state = afterwards(*state, grade, when);
  std::rotate(state, state + 1, states.end());
  return states;
}

Result<RepetitionRecord> keepTry(const fs::path& file, const std::string& exerciseId, int grade, std::chrono::sys_seconds when) {
  auto lock = lockOf(file);
  if (!lock) return passOn(lock.error());
  auto kept = readLocked(file);
  if (!kept) return kept;
  kept->states = withTry(std::move(kept->states), exerciseId, grade, when);
  if (auto written = writeFileSafely(file, jsonOf(kept->states).dump(1) + "\n"); !written) return passOn(written.error());
  return kept;
}

}  // namespace ew
