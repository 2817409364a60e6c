#include "access/seal_index.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "case/manifest.h"
#include "ew/core/json_fields.h"

namespace ew {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::size_t kLength_bytes = 8;
constexpr std::uint64_t kLongestIndex_bytes = 64ull << 20;
constexpr int kIndexFormat = 1;
Message where() { return say<"the index of %1">(std::string(kSealedName)); }

json jsonOf(const SealIndex& index) {
  json lessons = json::array();
  for (const auto& [id, lesson] : index.lessons) lessons.push_back({{"id", id}, {"original", lesson.id}, {"steps", lesson.steps}});
  return {{"format", kIndexFormat},
          {"case", index.caseId},
          {"examination", index.examinationId},
          {"lessons", lessons},
          {"files", json(ew::jsonOf(index.files))},
          {"among_trainees", index.amongTrainees}};
}

std::map<std::string, std::string> namesIn(const JsonFields& fields, std::string_view key) {
  std::map<std::string, std::string> names;
  const JsonFields object = fields.object(key);
  for (const auto& [name, value] : object.value().items()) {
    if (!value.is_string())
      object.refuse(name, say<"text">());
    else
      names[name] = value.get<std::string>();
  }
  return names;
}

Result<SealIndex> indexIn(const std::string& text) {
  const auto document = parseJsonObject(text, where());
  if (!document) return passOn(document.error());
  JsonReading reading(where());
  const JsonFields fields(*document, reading);
  const auto format = fields.whole("format", 1, 1'000'000);
  if (reading.good() && format > kIndexFormat)
    return failure(
        ErrorCode::newerFormat,
        say<"%1 has format %2, and this program reads formats up to %3; open it with a newer EchoWeave.">(where(), format, kIndexFormat));
  SealIndex index;
  index.caseId = fields.text("case", {}, 1, 100);
  index.examinationId = fields.text("examination", {}, 1, 100);
  for (const JsonFields& each : fields.objects("lessons", 0, 1000))
    index.lessons[each.text("id", {}, 1, 100)] = {each.text("original", {}, 1, 100), namesIn(each, "steps")};
  index.files = fileSumsIn(fields);
  index.amongTrainees = namesIn(fields, "among_trainees");
  if (reading.problem()) return passOn(*reading.problem());
  if (auto good = checkFileList(index.files, where()); !good) return passOn(good.error());
  for (const auto& [own, theirs] : index.amongTrainees)
    if (problemOfPath(own) || problemOfPath(theirs))
      return failure(ErrorCode::badField,
                     say<"%1 names a file, \"%2\", that is none of the case; do not use the examination.">(where(), theirs));
  return index;
}

tl::unexpected<Error> notAsListed() {
  return failure(ErrorCode::badField, say<"The sealed answers do not hold what they list; use the bundle as it was exported.">());
}

}  // namespace

SealIndex indexOf(const CaseToHandOn& from, const std::string& examinationId, const LessonsView& lessons,
                  const std::vector<FileSum>& there) {
  SealIndex index{.caseId = from.opened.id, .examinationId = examinationId, .lessons = {}, .files = from.files, .amongTrainees = {}};
  for (const auto& [id, original] : lessons.originalLessons) index.lessons[id] = {original, lessons.originalSteps.at(id)};
  for (const FileSum& each : from.files) {
    const auto same = std::find_if(there.begin(), there.end(), [&](const FileSum& file) { return file.sha256 == each.sha256; });
    if (same != there.end() && same->path != kManifestName && same->path != kSealedName) index.amongTrainees[each.path] = same->path;
  }
  return index;
}

std::uint64_t bytesToSeal(const SealIndex& index) {
  std::uint64_t bytes = 0;
  for (const FileSum& each : index.files)
    if (!index.amongTrainees.contains(each.path)) bytes += each.size_bytes;
  return bytes;
}

Result<void> writeSealed(const SealIndex& index, const fs::path& caseFolder, ByteCount& count, const TakePiece& put) {
  const std::string text = jsonOf(index).dump();
  std::string length;
  for (std::size_t n = 0; n < kLength_bytes; ++n) length += static_cast<char>((text.size() >> (8 * n)) & 0xff);
  for (const std::string& each : {length, text})
    if (auto written = put(std::as_bytes(std::span(each))); !written) return written;
  for (const FileSum& each : index.files) {
    if (index.amongTrainees.contains(each.path)) continue;
    Sha256 sum;
    std::uint64_t size_bytes = 0;
    auto read = readInPieces(caseFolder / each.path, count, [&](std::span<const std::byte> piece) {
      sum.add(piece);
      size_bytes += piece.size();
      return put(piece);
    });
    if (!read) return read;
    if (size_bytes != each.size_bytes || sum.hex() != each.sha256)
      return failure(ErrorCode::notReadable,
                     say<"\"%1\" was changed while the case was read; do it again when nobody is writing to the case folder.">(each.path),
                     {{"file", each.path}});
  }
  return {};
}

Result<void> ContentUnpacker::take(std::span<const std::byte> piece) {
  while (!piece.empty()) {
    const std::uint64_t wanted = !indexLength_ ? kLength_bytes - head_.size() : !hasIndex_ ? *indexLength_ - head_.size() : left_;
    const auto part = piece.first(static_cast<std::size_t>(std::min<std::uint64_t>(wanted, piece.size())));
    piece = piece.subspan(part.size());
    if (hasIndex_) {
      if (!out_) return notAsListed();  // more than is listed
      sum_->add(part);
      if (auto written = out_->write(part); !written) return written;
      left_ -= part.size();
      if (left_ == 0)
        if (auto next = nextFile(); !next) return next;
      continue;
    }
    head_.append(reinterpret_cast<const char*>(part.data()), part.size());
    if (!indexLength_ && head_.size() == kLength_bytes) {
      std::uint64_t length = 0;
      for (std::size_t n = kLength_bytes; n-- > 0;) length = (length << 8) | static_cast<std::uint8_t>(head_[n]);
      if (length == 0 || length > kLongestIndex_bytes) return notAsListed();
      indexLength_ = length;
      head_.clear();
    } else if (indexLength_ && head_.size() == *indexLength_) {
      if (auto begun = begin(); !begun) return begun;
    }
  }
  return {};
}

Result<void> ContentUnpacker::begin() {
  auto index = indexIn(head_);
  if (!index) return passOn(index.error());
  index_ = std::move(*index);
  hasIndex_ = true;
  if (auto room = checkRoom(to_, bytesOf(index_.files)); !room) return room;
  return nextFile();
}

Result<void> ContentUnpacker::copyFromTrainees(const FileSum& file) {
  const auto copied = copyInPieces(examination_ / index_.amongTrainees.at(file.path), to_ / file.path, count_);
  if (!copied) return passOn(copied.error());
  return copied->sha256 == file.sha256 ? Result<void>() : notAsListed();
}

Result<void> ContentUnpacker::nextFile() {
  for (;;) {
    if (out_) {
      if (auto finished = out_->finish(); !finished) return finished;
      if (sum_->hex() != index_.files[at_].sha256) return notAsListed();
      out_.reset();
      ++at_;
    }
    if (at_ == index_.files.size()) return {};
    const FileSum& file = index_.files[at_];
    if (index_.amongTrainees.contains(file.path)) {
      if (auto copied = copyFromTrainees(file); !copied) return copied;
      ++at_;
      continue;
    }
    auto out = PieceWriter::create(to_ / file.path);
    if (!out) return passOn(out.error());
    out_.emplace(std::move(*out));
    sum_.emplace();
    left_ = file.size_bytes;
    if (left_ > 0) return {};
  }
}

Result<void> ContentUnpacker::finish() {
  if (!hasIndex_ || at_ != index_.files.size() || out_) return notAsListed();
  return {};
}

}  // namespace ew
