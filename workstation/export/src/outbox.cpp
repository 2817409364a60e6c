#include "ew/export/outbox.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "dicom_elements.h"
#include "ew/core/foreign_json.h"
#include "ew/io/dicom.h"
#include "ew/io/file_lock.h"
#include "ew/io/private_file.h"
#include "ew/io/safe_file.h"

namespace ew {
namespace {
using namespace exporting;
namespace fs = std::filesystem;

constexpr int kOutboxFormat = 1;
constexpr long long kMostAttempts = 1'000'000'000;
constexpr OutboxStatus kStatuses[] = {OutboxStatus::waiting, OutboxStatus::stored, OutboxStatus::accepted, OutboxStatus::verified,
                                      OutboxStatus::refused};

bool isDone(OutboxStatus status) { return status == OutboxStatus::verified || status == OutboxStatus::accepted; }

std::string textIn(DcmItem& item, const DcmTagKey& tag) {
  OFString text;
  if (item.findAndGetOFString(tag, text).bad()) return {};
  return text.c_str();
}

/// Why a file that DCMTK does not take cannot be sent. The reader of images passes more over than an archive does.
tl::unexpected<Error> notSendable(const fs::path& file, const std::string& why) {
  const auto images = inspectDicom(file);
  if (images)
    return failure(ErrorCode::badHeader,
                   say<"%1 has bytes behind its data set, or lacks the mark that ends its pixels; its images are read here, but archives "
                       "take whole DICOM objects only: export it anew from the program that wrote it.">(quoted(file)));
  if (images.error().code == ErrorCode::badHeader || images.error().code == ErrorCode::truncated) return passOn(images.error());
  return failure(ErrorCode::badHeader,
                 say<"%1 is no DICOM file that can be read (%2); only such files can be sent.">(quoted(file), verbatim(why)));
}

/// The identifiers of an object; pixels stay on the disk.
Result<OutboxEntry> entryOf(const fs::path& file) {
  std::error_code ignored;
  if (!fs::exists(file, ignored)) return failure(ErrorCode::notFound, say<"%1 is not there; check the name.">(quoted(file)));
  quietDcmtk();
  DcmFileFormat dicom;
  if (const auto read = dicom.loadFile(file.c_str()); read.bad()) return notSendable(file, read.text());
  DcmItem& data = *dicom.getDataset();
  OutboxEntry entry;
  entry.object = {textIn(data, DCM_SOPClassUID), textIn(data, DCM_SOPInstanceUID)};
  entry.studyUid = textIn(data, DCM_StudyInstanceUID);
  entry.seriesUid = textIn(data, DCM_SeriesInstanceUID);
  for (const std::string& uid : {entry.object.classUid, entry.object.instanceUid, entry.studyUid, entry.seriesUid})
    if (!isDicomUid(uid))
      return failure(ErrorCode::badHeader,
                     say<"%1 lacks an identifier that archives need; only whole DICOM objects can be sent.">(quoted(file)));
  return entry;
}

nlohmann::ordered_json jsonOf(const OutboxEntry& entry) {
  return {{"format", kOutboxFormat},    {"class", entry.object.classUid}, {"instance", entry.object.instanceUid},
          {"study", entry.studyUid},    {"series", entry.seriesUid},      {"status", wordOf(entry.status)},
          {"attempts", entry.attempts}, {"problem", entry.problem}};
}

/// What an archive said need not be UTF-8.
std::string dumped(const nlohmann::ordered_json& note) {
  return note.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

Result<OutboxEntry> readNote(const fs::path& file) {
  const auto text = readTextFile(file, 1U << 20);
  if (!text) return passOn(text.error());
  const auto unusable = [&] {
    return failure(ErrorCode::badField, say<"%1 is no note of an outbox; move it away, and its object is sent again.">(quoted(file)));
  };
  const auto json = jsonOrNull(*text);
  const auto format = wholeAt(json, "format");
  if (!format || *format < 1) return unusable();
  if (*format > kOutboxFormat)
    return failure(ErrorCode::newerFormat, say<"%1 was written by a newer version of EchoWeave; send with that one.">(quoted(file)));
  const auto word = [&](const char* name) { return textAt(json, name); };
  OutboxEntry entry;
  entry.object = {word("class"), word("instance")};
  entry.studyUid = word("study");
  entry.seriesUid = word("series");
  entry.problem = word("problem");
  entry.attempts = static_cast<int>(std::clamp(wholeAt(json, "attempts").value_or(0), 0LL, kMostAttempts));
  const auto* const status =
      std::find_if(std::begin(kStatuses), std::end(kStatuses), [&](OutboxStatus each) { return wordOf(each) == word("status"); });
  if (status == std::end(kStatuses) || !isDicomUid(entry.object.instanceUid) || file.stem() != entry.object.instanceUid) return unusable();
  entry.status = *status;
  return entry;
}

/// Earlier versions left what they wrote open to others. Links and what another account owns stay as they are.
void leaveToOwner(const fs::path& file) {
  const int opened = ::open(file.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (opened < 0) return;
  struct stat found {};
  const bool isOwn = ::fstat(opened, &found) == 0 && S_ISREG(found.st_mode) && found.st_uid == ::geteuid();
  if (isOwn && (found.st_mode & 077) != 0) ::fchmod(opened, 0600);
  ::close(opened);
}

}  // namespace

std::string_view wordOf(OutboxStatus status) {
  switch (status) {
    case OutboxStatus::waiting:
      return "waiting";
    case OutboxStatus::stored:
      return "stored";
    case OutboxStatus::accepted:
      return "accepted";
    case OutboxStatus::verified:
      return "verified";
    case OutboxStatus::refused:
      return "refused";
  }
  return "";
}

struct Outbox::Parts {
  fs::path folder;
  std::optional<FileLock> lock;
  std::vector<OutboxEntry> entries;
  std::map<std::string, Error> unreadable;  ///< by the name of the file without its ending

  OutboxEntry* find(const std::string& instanceUid) {
    const auto at =
        std::find_if(entries.begin(), entries.end(), [&](const OutboxEntry& entry) { return entry.object.instanceUid == instanceUid; });
    return at == entries.end() ? nullptr : &*at;
  }
  [[nodiscard]] fs::path noteOf(const std::string& instanceUid) const { return folder / (instanceUid + ".json"); }
};

Outbox::Outbox(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
Outbox::~Outbox() = default;
Outbox::Outbox(Outbox&&) noexcept = default;
Outbox& Outbox::operator=(Outbox&&) noexcept = default;

Result<Outbox> Outbox::open(const fs::path& folder) {
  std::error_code problem;
  if (!fs::exists(folder, problem))
    if (auto made = makePrivateFolder(folder); !made) return passOn(made.error());
  auto parts = std::make_unique<Parts>();
  parts->folder = folder;
  auto lock = FileLock::tryTake(folder / ".lock", FileLock::Kind::alone, 0600);
  if (!lock)
    return failure(ErrorCode::notWritable, say<"The outbox %1 cannot be written; check the folder and its permissions.">(quoted(folder)));
  if (!*lock)
    return failure(ErrorCode::notWritable,
                   say<"Another program is sending from the outbox %1; wait until it has finished.">(quoted(folder)));
  parts->lock = std::move(*lock);
  leaveToOwner(folder / ".lock");
  std::map<std::string, OutboxEntry> entries;
  std::vector<fs::path> copies, left;
  for (const auto& each : fs::directory_iterator(folder, problem)) {
    if (each.path().filename().string().starts_with(kPrivateAside)) left.push_back(each.path());
    const bool isCopy = each.path().extension() == ".dcm", isNote = each.path().extension() == ".json";
    // The folder itself may be anybody's, and hold other things.
    if ((isCopy || isNote) && isDicomUid(each.path().stem().string())) leaveToOwner(each.path());
    if (isCopy) copies.push_back(each.path());
    if (!isNote) continue;
    auto note = readNote(each.path());
    if (note)
      entries.emplace(note->object.instanceUid, std::move(*note));
    else
      parts->unreadable.emplace(each.path().stem().string(), note.error());
  }
  for (const fs::path& aside : left) fs::remove(aside, problem);  // by whoever had the folder before and was ended
  for (const fs::path& copy : copies) {
    if (parts->unreadable.contains(copy.stem().string())) continue;  // whether it was sent stands in a note that nobody can read
    if (const auto known = entries.find(copy.stem().string()); known != entries.end()) {
      if (isDone(known->second.status)) fs::remove(copy, problem);  // stopped between note and removal
      continue;
    }
    auto entry = entryOf(copy);  // stopped between copy and note
    if (entry)
      entries.emplace(entry->object.instanceUid, std::move(*entry));
    else
      parts->unreadable.emplace(copy.stem().string(), entry.error());
  }
  for (auto& [uid, entry] : entries) parts->entries.push_back(std::move(entry));
  return Outbox(std::move(parts));
}

Result<bool> Outbox::add(const fs::path& file) {
  auto entry = entryOf(file);
  if (!entry) return passOn(entry.error());
  if (parts_->find(entry->object.instanceUid) != nullptr) return false;
  if (const auto known = parts_->unreadable.find(entry->object.instanceUid); known != parts_->unreadable.end())
    return passOn(known->second);
  const auto copied = writePrivateFile(copyOf(*entry), [&](std::ostream& out) -> Result<void> {
    std::ifstream in(file, std::ios::binary);
    out << in.rdbuf();
    if (!in) return failure(ErrorCode::notReadable, say<"%1 cannot be read; check its permissions.">(quoted(file)));
    return {};
  });
  if (!copied) return passOn(copied.error());
  const auto after = std::find_if(parts_->entries.begin(), parts_->entries.end(),
                                  [&](const OutboxEntry& each) { return each.object.instanceUid > entry->object.instanceUid; });
  parts_->entries.insert(after, *entry);
  if (auto kept = keep(*entry); !kept) return passOn(kept.error());
  return true;
}

const std::vector<OutboxEntry>& Outbox::entries() const { return parts_->entries; }

std::vector<Error> Outbox::unreadable() const {
  std::vector<Error> all;
  for (const auto& [name, problem] : parts_->unreadable) all.push_back(problem);
  return all;
}

std::size_t Outbox::count(OutboxStatus status) const {
  return static_cast<std::size_t>(
      std::count_if(parts_->entries.begin(), parts_->entries.end(), [&](const OutboxEntry& entry) { return entry.status == status; }));
}

fs::path Outbox::copyOf(const OutboxEntry& entry) const { return parts_->folder / (entry.object.instanceUid + ".dcm"); }

Result<void> Outbox::keep(const OutboxEntry& entry) {
  if (auto written = writePrivateFile(parts_->noteOf(entry.object.instanceUid), dumped(jsonOf(entry))); !written) return written;
  if (OutboxEntry* known = parts_->find(entry.object.instanceUid)) *known = entry;
  std::error_code ignored;
  if (isDone(entry.status)) fs::remove(copyOf(entry), ignored);
  return {};
}

Result<void> Outbox::retryRefused() {
  for (OutboxEntry entry : std::vector<OutboxEntry>(parts_->entries)) {
    if (entry.status != OutboxStatus::refused) continue;
    entry.status = OutboxStatus::waiting;
    if (auto kept = keep(entry); !kept) return kept;
  }
  return {};
}

}  // namespace ew
