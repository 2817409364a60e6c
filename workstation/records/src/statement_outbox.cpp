#include "ew/records/statement_outbox.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <map>
#include <optional>
#include <set>
#include <system_error>

#include "ew/io/file_lock.h"
#include "ew/io/private_file.h"
#include "ew/io/safe_file.h"
#include "ew/records/xapi.h"
#include "iri.h"

namespace ew {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::size_t kLargestStatement_bytes = 256u << 10;
constexpr std::size_t kLargestList_bytes = 1u << 30;
constexpr std::size_t kNumberLetters = 10, kIdLetters = 36;

std::string smallLetters(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return text;
}

tl::unexpected<Error> cannotWrite(const fs::path& folder) {
  return failure(ErrorCode::notWritable,
                 say<"The outbox %1 cannot be written (%2); check the folder, its permissions and the free space.">(
                     records::inQuotes(folder.string()), verbatim(std::generic_category().message(errno))),
                 {{"file", folder.string()}});
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

/// Adds whole lines behind the last whole line, and has them on the disk.
Result<void> appendLines(const fs::path& file, const std::vector<std::string>& ids) {
  const int out = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  if (out < 0) return cannotWrite(file.parent_path());
  std::string lines;
  for (const std::string& id : ids) lines += id + "\n";
  const off_t whole = ::lseek(out, 0, SEEK_END) / static_cast<off_t>(kIdLetters + 1) * static_cast<off_t>(kIdLetters + 1);
  bool isWritten = ::lseek(out, whole, SEEK_SET) == whole;
  for (std::size_t done = 0; isWritten && done < lines.size();) {
    const auto count = ::write(out, lines.data() + done, lines.size() - done);
    isWritten = count > 0 || (count < 0 && errno == EINTR);
    if (count > 0) done += static_cast<std::size_t>(count);
  }
  isWritten = isWritten && ::fsync(out) == 0;
  const auto problem = isWritten ? Result<void>() : Result<void>(cannotWrite(file.parent_path()));
  ::close(out);
  return problem;
}

Result<void> syncFolder(const fs::path& folder) {
  const int opened = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  const bool isSynced = opened >= 0 && ::fsync(opened) == 0;
  if (opened >= 0) ::close(opened);
  return isSynced ? Result<void>() : Result<void>(cannotWrite(folder));
}

}  // namespace

std::string_view wordOf(StatementStatus status) {
  switch (status) {
    case StatementStatus::waiting:
      return "waiting";
    case StatementStatus::doubtful:
      return "doubtful";
    case StatementStatus::refused:
      return "refused";
  }
  return "";
}

struct StatementOutbox::Parts {
  fs::path folder;
  std::optional<FileLock> lock;
  std::vector<StatementEntry> entries;    // by number
  std::map<std::string, fs::path> files;  // of entries
  std::set<std::string> sent;
  long long nextNumber = 1;

  [[nodiscard]] StatementEntry* find(const std::string& id) {
    const auto at = std::find_if(entries.begin(), entries.end(), [&](const StatementEntry& each) { return each.id == id; });
    return at == entries.end() ? nullptr : &*at;
  }
  [[nodiscard]] fs::path noteOf(const std::string& id) const { return folder / (id + ".refused"); }
  [[nodiscard]] fs::path sentFile() const { return folder / "sent"; }
  [[nodiscard]] fs::path sendingFile() const { return folder / "sending"; }
  Result<void> lockFolder();
  Result<void> read();
  Result<void> readNotes();
  Result<void> keepSending();
};

Result<void> StatementOutbox::Parts::lockFolder() {
  if (std::error_code ignored; !fs::exists(folder, ignored))
    if (auto made = makePrivateFolder(folder); !made) return made;
  auto taken = FileLock::tryTake(folder / ".lock", FileLock::Kind::alone, 0600);
  if (!taken) return cannotWrite(folder);
  if (!*taken)
    return failure(
        ErrorCode::notWritable,
        say<"Another program has the outbox %1 right now; wait until it has finished sending.">(records::inQuotes(folder.string())),
        {{"file", folder.string()}});
  lock = std::move(*taken);
  return {};
}

Result<void> StatementOutbox::Parts::read() {
  const auto arrived = idsIn(sentFile());
  if (!arrived) return passOn(arrived.error());
  sent.insert(arrived->begin(), arrived->end());
  std::error_code problem;
  std::vector<fs::path> found;
  for (const auto& each : fs::directory_iterator(folder, problem))
    if (each.path().extension() == ".json") found.push_back(each.path());
  if (problem) return cannotWrite(folder);
  std::sort(found.begin(), found.end());
  for (const fs::path& file : found) {
    const std::string stem = file.stem().string();
    if (stem.size() != kNumberLetters + 1 + kIdLetters || !isUuid(stem.substr(kNumberLetters + 1))) continue;
    const std::string id = stem.substr(kNumberLetters + 1);
    nextNumber = std::max(nextNumber, std::atoll(stem.c_str()) + 1);
    if (sent.contains(id) || files.contains(id)) {
      fs::remove(file, problem);  // stopped between the line and the removal
      continue;
    }
    files[id] = file;
    entries.push_back({id, StatementStatus::waiting, {}});
  }
  return readNotes();
}

Result<void> StatementOutbox::Parts::readNotes() {
  const auto underWay = idsIn(sendingFile());
  if (!underWay) return passOn(underWay.error());
  for (const std::string& id : *underWay)
    if (StatementEntry* entry = find(id)) entry->status = StatementStatus::doubtful;
  std::error_code ignored;
  for (StatementEntry& entry : entries) {
    if (!fs::exists(noteOf(entry.id), ignored)) continue;
    const auto note = readTextFile(noteOf(entry.id), 64u << 10);
    entry.status = StatementStatus::refused;  // that there is a note says so, whatever it holds
    entry.problem = records::tamed(note ? *note : note.error().sentence());
  }
  return {};
}

/// `sending` as it should be: those that are doubtful.
Result<void> StatementOutbox::Parts::keepSending() {
  std::string lines;
  for (const StatementEntry& entry : entries)
    if (entry.status == StatementStatus::doubtful) lines += entry.id + "\n";
  return writePrivateFile(sendingFile(), lines);
}

StatementOutbox::StatementOutbox(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
StatementOutbox::~StatementOutbox() = default;
StatementOutbox::StatementOutbox(StatementOutbox&&) noexcept = default;
StatementOutbox& StatementOutbox::operator=(StatementOutbox&&) noexcept = default;

Result<StatementOutbox> StatementOutbox::open(const fs::path& folder) {
  auto parts = std::make_unique<Parts>();
  parts->folder = folder;
  if (auto locked = parts->lockFolder(); !locked) return passOn(locked.error());
  if (auto read = parts->read(); !read) return passOn(read.error());
  return StatementOutbox(std::move(parts));
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
  if (parts_->sent.contains(name) || parts_->files.contains(name)) return false;
  std::string text;
  try {
    text = statement.dump();
  } catch (const json::exception&) {
    return refused("statement", say<"valid UTF-8">());
  }
  if (text.size() > kLargestStatement_bytes)
    return failure(ErrorCode::tooLarge, say<"The statement has %1 bytes; a statement may have %2.">(text.size(), kLargestStatement_bytes));
  std::string number = std::to_string(parts_->nextNumber);
  number.insert(0, kNumberLetters - std::min(kNumberLetters, number.size()), '0');
  const fs::path file = parts_->folder / (number + "-" + name + ".json");
  if (auto written = writePrivateFile(file, text); !written) return passOn(written.error());
  ++parts_->nextNumber;
  parts_->files[name] = file;
  parts_->entries.push_back({name, StatementStatus::waiting, {}});
  return true;
}

const std::vector<StatementEntry>& StatementOutbox::entries() const { return parts_->entries; }

std::size_t StatementOutbox::count(StatementStatus status) const {
  return static_cast<std::size_t>(
      std::count_if(parts_->entries.begin(), parts_->entries.end(), [&](const StatementEntry& each) { return each.status == status; }));
}

std::size_t StatementOutbox::sentCount() const { return parts_->sent.size(); }

Result<std::string> StatementOutbox::textOf(const std::string& id) const {
  const auto at = parts_->files.find(id);
  if (at == parts_->files.end())
    return failure(ErrorCode::notFound, say<"The outbox has no statement %1; list what it has.">(std::string(id)), {{"id", id}});
  return readTextFile(at->second, 2 * kLargestStatement_bytes);
}

Result<void> StatementOutbox::announce(const std::vector<std::string>& ids) {
  for (const std::string& id : ids)
    if (StatementEntry* entry = parts_->find(id)) entry->status = StatementStatus::doubtful;
  return parts_->keepSending();
}

void StatementOutbox::withdraw(const std::vector<std::string>& ids) {
  for (const std::string& id : ids)
    if (StatementEntry* entry = parts_->find(id); entry != nullptr && entry->status == StatementStatus::doubtful)
      entry->status = StatementStatus::waiting;
  (void)parts_->keepSending();  // one more question when it cannot be written
}

Result<void> StatementOutbox::keepSent(const std::vector<std::string>& ids) {
  std::error_code ignored;
  const bool isFirst = !fs::exists(parts_->sentFile(), ignored);
  if (auto kept = appendLines(parts_->sentFile(), ids); !kept) return kept;
  if (isFirst)
    if (auto synced = syncFolder(parts_->folder); !synced) return synced;
  for (const std::string& id : ids) {
    parts_->sent.insert(id);
    if (const auto at = parts_->files.find(id); at != parts_->files.end()) {
      fs::remove(at->second, ignored);
      parts_->files.erase(at);
    }
    fs::remove(parts_->noteOf(id), ignored);
  }
  std::erase_if(parts_->entries, [&](const StatementEntry& entry) { return parts_->sent.contains(entry.id); });
  return {};
}

Result<void> StatementOutbox::keepRefused(const std::string& id, const std::string& problem) {
  StatementEntry* entry = parts_->find(id);
  if (entry == nullptr) return {};
  if (auto written = writePrivateFile(parts_->noteOf(id), problem + "\n"); !written) return written;
  entry->status = StatementStatus::refused;
  entry->problem = records::tamed(problem);
  return {};
}

Result<void> StatementOutbox::retryRefused() {
  for (StatementEntry& entry : parts_->entries) {
    if (entry.status != StatementStatus::refused) continue;
    if (std::error_code problem; !fs::remove(parts_->noteOf(entry.id), problem) && problem) return cannotWrite(parts_->folder);
    entry.status = StatementStatus::waiting;
    entry.problem.clear();
  }
  return {};
}

}  // namespace ew
