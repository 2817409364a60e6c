#include "ew/records/statement_outbox.h"

#include <algorithm>
#include <cctype>
#include <ostream>
#include <system_error>

#include "ew/io/safe_file.h"
#include "ew/records/xapi.h"
#include "iri.h"

namespace ew {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::size_t kLargestStatement_bytes = 256u << 10;
constexpr std::size_t kLargestList_bytes = 1u << 30;

std::string smallLetters(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return text;
}

/// The complete lines of a list, each an id; a line that a crash cut off does not count.
Result<std::vector<std::string>> idsIn(const fs::path& file) {
  std::error_code ignored;
  if (!fs::exists(file, ignored)) return std::vector<std::string>{};
  const auto text = readTextFile(file, kLargestList_bytes);
  if (!text) return passOn(text.error());
  std::vector<std::string> ids;
  for (std::size_t begin = 0; begin < text->size();) {
    const auto end = text->find('\n', begin);
    if (end == std::string::npos) break;
    if (std::string line = text->substr(begin, end - begin); isUuid(line)) ids.push_back(std::move(line));
    begin = end + 1;
  }
  return ids;
}

/// What versions before the common notes have left: lists of those that arrived and of those that were being sent, and a note of each that
/// was refused.
Result<EarlierNotes> listsOfStatements(const fs::path& folder) {
  const fs::path sent = folder / "sent", sending = folder / "sending";
  const auto arrived = idsIn(sent), underWay = idsIn(sending);
  if (!arrived) return passOn(arrived.error());
  if (!underWay) return passOn(underWay.error());
  EarlierNotes earlier;
  earlier.files = {sent, sending};
  for (const std::string& id : *underWay) earlier.entries.push_back({.id = id, .status = OutboxStatus::doubtful});
  std::error_code problem;
  for (fs::directory_iterator each(folder, problem); !problem && each != fs::directory_iterator(); each.increment(problem)) {
    const std::string id = each->path().stem().string();
    if (each->path().extension() != ".refused" || !isUuid(id)) continue;
    const auto note = readTextFile(each->path(), 64u << 10);  // that there is one says so, whatever it holds
    earlier.entries.push_back(
        {.id = id, .status = OutboxStatus::refused, .problem = records::tamed(note ? *note : note.error().sentence())});
    earlier.files.push_back(each->path());
  }
  for (const std::string& id : *arrived) earlier.entries.push_back({.id = id, .status = OutboxStatus::arrived});
  return earlier;
}

}  // namespace

Result<StatementOutbox> StatementOutbox::open(const fs::path& folder) {
  auto opened = Outbox::open(folder, {.ending = ".json", .isNumbered = true, .isId = isUuid, .earlierNotes = listsOfStatements});
  if (!opened) return passOn(opened.error());
  return StatementOutbox(std::move(*opened));
}

Result<bool> StatementOutbox::add(const json& statement) {
  const auto refused = [](const char* field, Message expected) {
    return failure(ErrorCode::badField,
                   say<"This is no statement that can be sent: '%1' must be %2.">(std::string(field), std::move(expected)),
                   {{"field", field}});
  };
  if (!statement.is_object()) return refused("statement", say<"an object">());
  const auto id = statement.find("id");
  if (id == statement.end() || !id->is_string() || !isUuid(id->get<std::string>())) return refused("id", say<"a UUID">());
  for (const char* part : {"actor", "verb", "object"})
    if (const auto at = statement.find(part); at == statement.end() || !at->is_object()) return refused(part, say<"an object">());
  const std::string name = smallLetters(id->get<std::string>());
  if (knows(name)) return false;
  std::string text;
  try {
    text = statement.dump();
  } catch (const json::exception&) {
    return refused("statement", say<"valid UTF-8">());
  }
  if (text.size() > kLargestStatement_bytes)
    return failure(ErrorCode::tooLarge, say<"The statement has %1 bytes; a statement may have %2.">(text.size(), kLargestStatement_bytes));
  return Outbox::add({.id = name}, [&](std::ostream& out) -> Result<void> {
    out << text;
    return {};
  });
}

Result<std::string> StatementOutbox::textOf(const std::string& id) const {
  const OutboxEntry* const entry = find(id);
  if (entry == nullptr)
    return failure(ErrorCode::notFound, say<"The outbox has no statement %1; list what it has.">(std::string(id)), {{"id", id}});
  return readTextFile(copyOf(*entry), 2 * kLargestStatement_bytes);
}

void StatementOutbox::withdraw(const std::vector<std::string>& ids) {
  std::vector<std::string> doubtful;
  for (const std::string& id : ids)
    if (const OutboxEntry* const entry = find(id); entry != nullptr && entry->status == OutboxStatus::doubtful) doubtful.push_back(id);
  (void)keep(doubtful, OutboxStatus::waiting);  // one more question when it cannot be written
}

Result<void> StatementOutbox::keepRefused(const std::string& id, const std::string& problem) {
  const OutboxEntry* const known = find(id);
  if (known == nullptr) return {};
  OutboxEntry refused = *known;
  refused.status = OutboxStatus::refused;
  refused.problem = records::tamed(problem);
  return Outbox::keep(refused);
}

}  // namespace ew
