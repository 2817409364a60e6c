#include "ew/export/outbox.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "dicom_elements.h"
#include "ew/core/foreign_json.h"
#include "ew/io/dicom.h"
#include "ew/io/private_file.h"
#include "ew/io/safe_file.h"

namespace ew {
namespace {
using namespace exporting;
namespace fs = std::filesystem;

constexpr int kOutboxFormat = 1;
constexpr long long kMostAttempts = 1'000'000'000;

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
  OutboxEntry entry{.id = textIn(data, DCM_SOPInstanceUID)};
  entry.about = {{kObjectClass, textIn(data, DCM_SOPClassUID)},
                 {kObjectStudy, textIn(data, DCM_StudyInstanceUID)},
                 {kObjectSeries, textIn(data, DCM_SeriesInstanceUID)}};
  for (const std::string& uid : {entry.id, entry.about[kObjectClass], entry.about[kObjectStudy], entry.about[kObjectSeries]})
    if (!isDicomUid(uid))
      return failure(ErrorCode::badHeader,
                     say<"%1 lacks an identifier that archives need; only whole DICOM objects can be sent.">(quoted(file)));
  return entry;
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
  OutboxEntry entry{.id = word("instance"), .problem = word("problem")};
  for (const char* name : {kObjectClass, kObjectStudy, kObjectSeries}) entry.about[name] = word(name);
  entry.attempts = static_cast<int>(std::clamp(wholeAt(json, "attempts").value_or(0), 0LL, kMostAttempts));
  const auto status = outboxStatusOf(word("status"));
  if (!status || !isDicomUid(entry.id) || file.stem() != entry.id) return unusable();
  entry.status = *status;
  return entry;
}

/// Those that versions before the common notes have left: one beside each copy.
Result<EarlierNotes> notesOfObjects(const fs::path& folder) {
  EarlierNotes earlier;
  std::error_code problem;
  for (fs::directory_iterator each(folder, problem); !problem && each != fs::directory_iterator(); each.increment(problem)) {
    if (each->path().extension() != ".json" || !isDicomUid(each->path().stem().string())) continue;
    closeFileToOthers(each->path());
    auto note = readNote(each->path());
    if (note) {
      earlier.entries.push_back(std::move(*note));
      earlier.files.push_back(each->path());
    } else {
      earlier.unreadable.emplace(each->path().stem().string(), note.error());
    }
  }
  return earlier;
}

}  // namespace

Result<DicomOutbox> DicomOutbox::open(const fs::path& folder) {
  auto opened = Outbox::open(folder, {.ending = ".dcm", .isId = isDicomUid, .entryOf = entryOf, .earlierNotes = notesOfObjects});
  if (!opened) return passOn(opened.error());
  return DicomOutbox(std::move(*opened));
}

Result<bool> DicomOutbox::add(const fs::path& file) {
  const auto entry = entryOf(file);
  if (!entry) return passOn(entry.error());
  return Outbox::add(*entry, [&](std::ostream& out) -> Result<void> {
    std::ifstream in(file, std::ios::binary);
    out << in.rdbuf();
    if (!in) return failure(ErrorCode::notReadable, say<"%1 cannot be read; check its permissions.">(quoted(file)));
    return {};
  });
}

}  // namespace ew
