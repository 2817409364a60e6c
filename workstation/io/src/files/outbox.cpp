#include "ew/io/outbox.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <system_error>
#include <thread>
#include <unordered_map>
#include <utility>

#include "ew/core/contract.h"
#include "ew/core/foreign_json.h"
#include "ew/core/word_table.h"
#include "ew/io/file_lock.h"
#include "ew/io/private_file.h"
#include "ew/io/safe_file.h"

namespace ew {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* kNotes = "notes";
constexpr const char* kDamagedNotes = "notes-damaged";
constexpr int kNotesFormat = 1;
constexpr std::size_t kLargestNotes_bytes = std::size_t{1} << 30;
constexpr long long kMostAttempts = 1'000'000'000;
constexpr std::size_t kNumberLetters = 10;

bool isThere(OutboxStatus status) {
  return status == OutboxStatus::accepted || status == OutboxStatus::verified || status == OutboxStatus::arrived;
}

Message inQuotes(const fs::path& file) { return verbatim("'" + file.string() + "'"); }

tl::unexpected<Error> outboxNotWritable(const fs::path& folder, const std::string& reason) {
  return failure(ErrorCode::notWritable,
                 say<"The outbox %1 cannot be written (%2); check the folder, its permissions and the free space.">(inQuotes(folder),
                                                                                                                    verbatim(reason)),
                 {{"file", folder.string()}});
}
tl::unexpected<Error> outboxNotWritable(const fs::path& folder) {
  return outboxNotWritable(folder, std::generic_category().message(errno));
}

bool writeWhole(int file, std::string_view text, std::size_t at) {
  while (!text.empty()) {
    const ssize_t written = ::pwrite(file, text.data(), text.size(), static_cast<off_t>(at));
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    text.remove_prefix(static_cast<std::size_t>(written));
    at += static_cast<std::size_t>(written);
  }
  return true;
}

/// What a receiver said need not be UTF-8.
std::string lineOf(const json& note) { return note.dump(-1, ' ', false, json::error_handler_t::replace) + "\n"; }

std::string lineOf(const OutboxEntry& entry) {
  json note = {{"id", entry.id}, {"status", wordOf(entry.status)}};
  if (entry.status != OutboxStatus::arrived) {
    if (entry.attempts > 0) note["attempts"] = entry.attempts;
    if (!entry.problem.empty()) note["problem"] = entry.problem;
    if (!entry.about.empty()) note["about"] = entry.about;
  }
  return lineOf(note);
}

std::string headOfNotes() { return lineOf(json{{"format", kNotesFormat}}); }

std::optional<OutboxEntry> entryIn(const json& note) {
  const auto status = outboxStatusOf(textAt(note, "status"));
  OutboxEntry entry{.id = textAt(note, "id")};
  if (entry.id.empty() || !status) return std::nullopt;
  entry.status = *status;
  entry.attempts = static_cast<int>(std::clamp(wholeAt(note, "attempts").value_or(0), 0LL, kMostAttempts));
  entry.problem = textAt(note, "problem");
  const json& about = memberOf(note, "about");
  for (const auto& each : about.items())
    if (each.value().is_string()) entry.about[each.key()] = textAt(about, each.key());
  return entry;
}

/// A copy's id by the name of its file; empty: it is none.
std::string idOf(const fs::path& file, const OutboxKind& kind) {
  if (file.extension() != kind.ending) return {};
  std::string stem = file.stem().string();
  if (kind.isNumbered) stem.erase(0, std::min(stem.size(), kNumberLetters + 1));
  return kind.isId(stem) ? stem : std::string();
}

constexpr WordTable<OutboxStatus, 7> kOutboxStatusWords{{{"waiting", OutboxStatus::waiting},
                                                         {"doubtful", OutboxStatus::doubtful},
                                                         {"stored", OutboxStatus::stored},
                                                         {"accepted", OutboxStatus::accepted},
                                                         {"verified", OutboxStatus::verified},
                                                         {"arrived", OutboxStatus::arrived},
                                                         {"refused", OutboxStatus::refused}}};

}  // namespace

std::string_view wordOf(OutboxStatus status) { return wordIn(kOutboxStatusWords, status); }

std::optional<OutboxStatus> outboxStatusOf(std::string_view word) { return meaningIn(kOutboxStatusWords, word); }

std::string aboutOf(const OutboxEntry& entry, const std::string& name) {
  const auto found = entry.about.find(name);
  return found == entry.about.end() ? std::string() : found->second;
}

struct Outbox::Parts {
  fs::path folder;
  OutboxKind kind;
  std::optional<FileLock> lock;
  std::vector<OutboxEntry> entries;
  std::unordered_map<std::string, std::size_t> at;  ///< in entries, by id
  std::map<std::string, fs::path> copies;           ///< by id
  std::set<std::string> arrived;
  std::map<std::string, Error> unreadable;  ///< by id
  long long nextNumber = 1;
  std::size_t notes_bytes = 0;  ///< whole lines; what lies beyond was written in part
  std::string damagedLines;     ///< of the notes: whole, and nobody can read them
  std::optional<Message> damage;

  [[nodiscard]] fs::path notes() const { return folder / kNotes; }
  [[nodiscard]] Result<void> takeLock();
  [[nodiscard]] Result<void> read();
  [[nodiscard]] Result<void> findCopies(std::vector<fs::path>& found);
  void take(OutboxEntry entry, std::map<std::string, OutboxEntry>& noted);
  [[nodiscard]] Result<std::size_t> readNotes(std::map<std::string, OutboxEntry>& noted);
  [[nodiscard]] Result<void> readEarlier(std::map<std::string, OutboxEntry>& noted);
  void takeCopy(const fs::path& copy, std::map<std::string, OutboxEntry>& noted);
  [[nodiscard]] Result<void> append(const std::vector<OutboxEntry>& changed);
  bool shorten();
  void setDamagedLinesAside();
  void order();
};

Result<void> Outbox::Parts::takeLock() {
  if (std::error_code ignored; !fs::exists(folder, ignored))
    if (auto made = makePrivateFolder(folder); !made) return made;
  auto taken = FileLock::tryTake(folder / ".lock", FileLock::Kind::alone, 0600);
  if (!taken) return outboxNotWritable(folder);
  if (!*taken)
    return failure(ErrorCode::notWritable,
                   say<"Another program is sending from the outbox %1; wait until it has finished.">(inQuotes(folder)),
                   {{"file", folder.string()}});
  lock = std::move(*taken);
  closeFileToOthers(folder / ".lock");
  return {};
}

/// Copies by the names of their files; what a program that was ended left aside goes.
Result<void> Outbox::Parts::findCopies(std::vector<fs::path>& found) {
  std::vector<fs::path> left;
  std::error_code problem;
  for (fs::directory_iterator each(folder, problem); !problem && each != fs::directory_iterator(); each.increment(problem)) {
    if (each->path().filename().string().starts_with(kPrivateAside)) left.push_back(each->path());
    if (idOf(each->path(), kind).empty()) continue;
    // Earlier versions left what they wrote open to others.
    closeFileToOthers(each->path());
    found.push_back(each->path());
  }
  if (problem) return outboxNotWritable(folder, problem.message());
  for (const fs::path& aside : left) fs::remove(aside, problem);
  std::sort(found.begin(), found.end());
  return {};
}

/// The latest word about something; that it arrived is the last.
void Outbox::Parts::take(OutboxEntry entry, std::map<std::string, OutboxEntry>& noted) {
  if (entry.status == OutboxStatus::arrived) {
    noted.erase(entry.id);
    arrived.insert(std::move(entry.id));
  } else if (!arrived.contains(entry.id)) {
    noted.insert_or_assign(entry.id, std::move(entry));
  }
}

/// @return how many lines there are
Result<std::size_t> Outbox::Parts::readNotes(std::map<std::string, OutboxEntry>& noted) {
  std::error_code ignored;
  if (!fs::exists(notes(), ignored)) return std::size_t{0};
  const auto text = readTextFile(notes(), kLargestNotes_bytes);
  if (!text) return passOn(text.error());
  if (!text->empty() && wholeAt(jsonOrNull(std::string_view(*text).substr(0, text->find('\n'))), "format").value_or(0) < 1)
    return failure(ErrorCode::notReadable,
                   say<"%1 is no file of notes of an outbox; move it away, or choose another folder for the outbox.">(inQuotes(notes())),
                   {{"file", notes().string()}});
  closeFileToOthers(notes());
  std::size_t lines = 0;
  for (std::size_t begin = 0, end = 0; (end = text->find('\n', begin)) != std::string::npos; begin = notes_bytes = end + 1) {
    const std::string_view line = std::string_view(*text).substr(begin, end + 1 - begin);
    const json note = jsonOrNull(line);
    if (wholeAt(note, "format").value_or(0) > kNotesFormat)
      return failure(ErrorCode::newerFormat, say<"%1 was written by a newer version of EchoWeave; send with that one.">(inQuotes(notes())));
    ++lines;
    if (auto entry = entryIn(note); entry && kind.isId(entry->id))
      take(std::move(*entry), noted);
    else if (!wholeAt(note, "format"))
      damagedLines += line;
  }
  return lines;
}

/// They are later than what is noted here: an earlier version has been at work since.
Result<void> Outbox::Parts::readEarlier(std::map<std::string, OutboxEntry>& noted) {
  if (kind.earlierNotes == nullptr) return {};
  auto earlier = kind.earlierNotes(folder);
  if (!earlier) return passOn(earlier.error());
  unreadable = std::move(earlier->unreadable);
  if (auto kept = append(earlier->entries); !kept) return kept;
  for (OutboxEntry& entry : earlier->entries) take(std::move(entry), noted);
  std::error_code ignored;
  for (const fs::path& file : earlier->files) fs::remove(file, ignored);
  return {};
}

void Outbox::Parts::takeCopy(const fs::path& copy, std::map<std::string, OutboxEntry>& noted) {
  const std::string id = idOf(copy, kind);
  if (kind.isNumbered) nextNumber = std::max(nextNumber, std::atoll(copy.filename().c_str()) + 1);
  if (unreadable.contains(id)) return;  // whether it was sent stands in a note that nobody can read
  const auto known = noted.find(id);
  if (arrived.contains(id) || copies.contains(id) || (known != noted.end() && isThere(known->second.status))) {
    std::error_code ignored;
    fs::remove(copy, ignored);  // stopped between the note and the removal
    return;
  }
  auto entry = known != noted.end()      ? Result<OutboxEntry>(std::move(known->second))
               : kind.entryOf != nullptr ? kind.entryOf(copy)  // stopped between the copy and its note
                                         : Result<OutboxEntry>(OutboxEntry{.id = id});
  if (entry && entry->id != id)
    entry =
        failure(ErrorCode::badHeader, say<"%1 holds something else than its name says; move it away, and add it again.">(inQuotes(copy)),
                {{"file", copy.string()}});
  if (!entry) {
    unreadable.emplace(id, entry.error());
    return;
  }
  if (known != noted.end()) noted.erase(known);
  copies[id] = copy;
  entries.push_back(std::move(*entry));
}

Result<void> Outbox::Parts::read() {
  std::vector<fs::path> found;
  if (auto listed = findCopies(found); !listed) return listed;
  std::map<std::string, OutboxEntry> noted;
  const auto lines = readNotes(noted);
  if (!lines) return passOn(lines.error());
  if (auto taken = readEarlier(noted); !taken) return taken;
  for (const fs::path& copy : found) takeCopy(copy, noted);
  // They are there, or their copies are lost, which is told. Of what was refused only a person takes the copy away, who has given it up.
  for (auto& [id, entry] : noted)
    if (!unreadable.contains(id) && entry.status != OutboxStatus::refused) entries.push_back(std::move(entry));
  order();
  if (!damagedLines.empty())
    setDamagedLinesAside();
  else if (*lines > 2 * (entries.size() + arrived.size()) + 100)
    shorten();
  return {};
}

void Outbox::Parts::order() {
  if (!kind.isNumbered) std::sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
  at.clear();
  for (std::size_t n = 0; n < entries.size(); ++n) at[entries[n].id] = n;
}

/// They are kept in a file of their own before the notes are written without them. Where that fails they stay, and are told of again.
void Outbox::Parts::setDamagedLinesAside() {
  const fs::path aside = folder / kDamagedNotes;
  const auto count = std::count(damagedLines.begin(), damagedLines.end(), '\n');
  std::error_code ignored;
  const auto earlier = fs::exists(aside, ignored) ? readTextFile(aside, kLargestNotes_bytes) : Result<std::string>();
  const bool isKept = earlier && writePrivateFile(aside, *earlier + damagedLines) && shorten();
  damage = isKept ? say<"%1 held lines that nobody can read (%2); they lie in %3 now. No copy is lost; where something stands is not "
                        "known so well any more, and it may be sent once more. Look whether the receiver has something twice; then "
                        "delete that file.">(inQuotes(notes()), count, inQuotes(aside))
                  : say<"%1 holds lines that nobody can read (%2), and they cannot be moved to %3. No copy is lost; where something stands "
                        "is not known so well any more, and it may be sent once more. Check the folder, its permissions and the free "
                        "space.">(inQuotes(notes()), count, inQuotes(aside));
}

/// Lines that later ones have made idle go; where that fails they stay. @return whether they went
bool Outbox::Parts::shorten() {
  std::string text = headOfNotes();
  for (const std::string& id : arrived) text += lineOf(OutboxEntry{.id = id, .status = OutboxStatus::arrived});
  for (const OutboxEntry& entry : entries) text += lineOf(entry);
  if (!writePrivateFile(notes(), text)) return false;
  notes_bytes = text.size();
  return true;
}

/// Behind the last whole line, and on the disk.
Result<void> Outbox::Parts::append(const std::vector<OutboxEntry>& changed) {
  if (changed.empty()) return {};
  std::string lines = notes_bytes == 0 ? headOfNotes() : std::string();
  for (const OutboxEntry& entry : changed) lines += lineOf(entry);
  if (notes_bytes == 0) {
    if (auto written = writePrivateFile(notes(), lines); !written) return written;  // its name is on the disk as well
  } else {
    const int file = ::open(notes().c_str(), O_WRONLY | O_CLOEXEC | O_NOFOLLOW);
    if (file < 0) return outboxNotWritable(folder);
    const auto whole = static_cast<off_t>(notes_bytes);
    const bool isWritten = ::ftruncate(file, whole) == 0 && writeWhole(file, lines, notes_bytes) && ::fsync(file) == 0;
    const std::string reason = isWritten ? std::string() : std::generic_category().message(errno);
    ::close(file);
    if (!isWritten) return outboxNotWritable(folder, reason);
  }
  notes_bytes += lines.size();
  return {};
}

Outbox::Outbox(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
Outbox::~Outbox() = default;
Outbox::Outbox(Outbox&&) noexcept = default;
Outbox& Outbox::operator=(Outbox&&) noexcept = default;

Result<Outbox> Outbox::open(const fs::path& folder, const OutboxKind& kind) {
  EW_EXPECTS(kind.isId != nullptr && !kind.ending.empty());
  auto parts = std::make_unique<Parts>();
  parts->folder = folder;
  parts->kind = kind;
  if (auto locked = parts->takeLock(); !locked) return passOn(locked.error());
  if (auto read = parts->read(); !read) return passOn(read.error());
  return Outbox(std::move(parts));
}

const std::vector<OutboxEntry>& Outbox::entries() const { return parts_->entries; }

const OutboxEntry* Outbox::find(const std::string& id) const {
  const auto found = parts_->at.find(id);
  return found == parts_->at.end() ? nullptr : &parts_->entries[found->second];
}

std::size_t Outbox::count(OutboxStatus status) const {
  if (status == OutboxStatus::arrived) return parts_->arrived.size();
  return static_cast<std::size_t>(
      std::count_if(parts_->entries.begin(), parts_->entries.end(), [&](const OutboxEntry& entry) { return entry.status == status; }));
}

std::vector<Error> Outbox::unreadable() const {
  std::vector<Error> all;
  for (const auto& [id, problem] : parts_->unreadable) all.push_back(problem);
  return all;
}

const std::optional<Message>& Outbox::damage() const { return parts_->damage; }

fs::path Outbox::copyOf(const OutboxEntry& entry) const {
  const auto found = parts_->copies.find(entry.id);
  return found != parts_->copies.end() ? found->second : parts_->folder / (entry.id + parts_->kind.ending);
}

bool Outbox::knows(const std::string& id) const { return find(id) != nullptr || parts_->arrived.contains(id); }

Result<bool> Outbox::add(const OutboxEntry& entry, const std::function<Result<void>(std::ostream&)>& write) {
  Parts& parts = *parts_;
  EW_EXPECTS(parts.kind.isId(entry.id));
  if (knows(entry.id)) return false;
  if (const auto known = parts.unreadable.find(entry.id); known != parts.unreadable.end()) return passOn(known->second);
  std::string name = entry.id + parts.kind.ending;
  if (parts.kind.isNumbered) {
    const std::string number = std::to_string(parts.nextNumber);
    name = std::string(kNumberLetters - std::min(kNumberLetters, number.size()), '0') + number + "-" + name;
  }
  if (auto written = writePrivateFile(parts.folder / name, write); !written) return passOn(written.error());
  ++parts.nextNumber;
  parts.copies[entry.id] = parts.folder / name;
  parts.entries.push_back(entry);
  parts.at[entry.id] = parts.entries.size() - 1;
  if (!parts.kind.isNumbered) parts.order();
  if (parts.kind.entryOf != nullptr)  // else its name says all
    if (auto kept = parts.append({entry}); !kept) return passOn(kept.error());
  return true;
}

Result<void> Outbox::keep(const std::vector<OutboxEntry>& changed) {
  Parts& parts = *parts_;
  if (auto kept = parts.append(changed); !kept) return kept;
  bool isFewer = false;
  for (const OutboxEntry& entry : changed) {
    if (const auto found = parts.at.find(entry.id); found != parts.at.end()) parts.entries[found->second] = entry;
    if (!isThere(entry.status)) continue;
    std::error_code ignored;
    fs::remove(copyOf(entry), ignored);
    parts.copies.erase(entry.id);
    if (entry.status == OutboxStatus::arrived) isFewer = parts.arrived.insert(entry.id).second || isFewer;
  }
  if (!isFewer) return {};
  std::erase_if(parts.entries, [](const OutboxEntry& entry) { return entry.status == OutboxStatus::arrived; });
  parts.order();
  return {};
}

Result<void> Outbox::keep(const std::vector<std::string>& ids, OutboxStatus status) {
  std::vector<OutboxEntry> changed;
  for (const std::string& id : ids) {
    const OutboxEntry* const known = find(id);
    if (known == nullptr || known->status == status) continue;
    changed.push_back(*known);
    changed.back().status = status;
  }
  return keep(changed);
}

Result<void> Outbox::retryRefused() {
  std::vector<OutboxEntry> changed;
  for (const OutboxEntry& entry : parts_->entries) {
    if (entry.status != OutboxStatus::refused) continue;
    changed.push_back(entry);
    changed.back().status = OutboxStatus::waiting;
    changed.back().problem.clear();
  }
  return keep(changed);
}

double RetryOptions::waitAfter_s(int failed) const { return std::min(firstWait_s * std::pow(2.0, failed - 1), longestWait_s); }

bool RetryOptions::waitFor(double seconds, const Progress& progress) const {
  if (wait) return wait(seconds);
  const auto until = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  while (std::chrono::steady_clock::now() < until) {
    if (progress.cancelRequested()) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  return !progress.cancelRequested();
}

}  // namespace ew
