#include <archive.h>
#include <archive_entry.h>

#include <algorithm>

#include "case/outgoing_case.h"
#include "ew/core/output_set.h"
#include "ew/core/version.h"
#include "ew/library/kept_examination.h"
#include "ew/library/sealed_answers.h"
#include "files/file_pieces.h"
#include "files/guarded_case.h"
#include "files/utf8_names.h"
#include "publishing/bundle_header.h"

namespace ew {
namespace {

namespace fs = std::filesystem;

/// A tar in zstd that is written entry by entry.
class BundleWriter {
 public:
  explicit BundleWriter(PieceWriter& out) : out_(out), archive_(archive_write_new()) {
    if (archive_ == nullptr) throw std::bad_alloc();
  }
  ~BundleWriter() {
    if (!isClosed_) archive_write_fail(archive_);  // else what is missing of the entry would be filled up with zeros, gigabytes of them
    archive_write_free(archive_);
  }
  BundleWriter(const BundleWriter&) = delete;
  BundleWriter& operator=(const BundleWriter&) = delete;

  Result<void> open() {
    const bool ready = names_.good() && archive_write_set_format_pax_restricted(archive_) == ARCHIVE_OK &&
                       archive_write_set_options(archive_, "hdrcharset=UTF-8") == ARCHIVE_OK &&
                       archive_write_add_filter_zstd(archive_) == ARCHIVE_OK &&
                       archive_write_set_bytes_per_block(archive_, 0) == ARCHIVE_OK &&  // in the compressor's pieces
                       archive_write_set_bytes_in_last_block(archive_, 1) == ARCHIVE_OK &&
                       archive_write_open(archive_, this, nullptr, &BundleWriter::put, nullptr) == ARCHIVE_OK;
    return ready ? Result<void>() : problemNow();
  }

  /// Times and owners are the same for all: they say nothing about the case.
  Result<void> begin(const std::string& path, std::uint64_t size_bytes) {
    archive_entry* const entry = archive_entry_new2(archive_);
    if (entry == nullptr) throw std::bad_alloc();
    archive_entry_set_pathname_utf8(entry, path.c_str());
    archive_entry_set_size(entry, static_cast<la_int64_t>(size_bytes));
    archive_entry_set_filetype(entry, AE_IFREG);
    archive_entry_set_perm(entry, 0644);
    archive_entry_set_mtime(entry, 0, 0);
    const int written = archive_write_header(archive_, entry);
    archive_entry_free(entry);
    return written == ARCHIVE_OK ? Result<void>() : problemNow();
  }

  Result<void> data(std::span<const std::byte> piece) {
    const auto written = archive_write_data(archive_, piece.data(), piece.size());
    return written == static_cast<la_ssize_t>(piece.size()) ? Result<void>() : problemNow();
  }

  Result<void> close() {
    isClosed_ = archive_write_close(archive_) == ARCHIVE_OK;
    return isClosed_ ? Result<void>() : problemNow();
  }

 private:
  static la_ssize_t put(archive*, void* self, const void* bytes, size_t count) {
    auto& writer = *static_cast<BundleWriter*>(self);
    auto written = writer.out_.write({static_cast<const std::byte*>(bytes), count});
    if (written) return static_cast<la_ssize_t>(count);
    writer.problem_ = written.error();
    return -1;
  }

  [[nodiscard]] tl::unexpected<Error> problemNow() const {
    if (problem_) return passOn(*problem_);
    const char* said = archive_error_string(archive_);
    return failure(ErrorCode::internal,
                   say<"The bundle could not be written (%1); please report it.">(verbatim(said == nullptr ? "" : said)));
  }

  Utf8Names names_;
  PieceWriter& out_;
  archive* archive_;
  bool isClosed_ = false;
  std::optional<Error> problem_;  // of the file below
};

Result<void> writeFile(const FileSum& file, const fs::path& folder, BundleWriter& bundle, ByteCount& count) {
  if (auto begun = bundle.begin(file.path, file.size_bytes); !begun) return begun;
  Sha256 sum;
  std::uint64_t size_bytes = 0;
  const auto changed = [&] {
    return failure(ErrorCode::notReadable,
                   say<"\"%1\" was changed while the case was read; do it again when nobody is writing to the case folder.">(file.path),
                   {{"file", file.path}});
  };
  auto read = readInPieces(folder / file.path, count, [&](std::span<const std::byte> piece) -> Result<void> {
    size_bytes += piece.size();
    if (size_bytes > file.size_bytes) return changed();
    sum.add(piece);
    return bundle.data(piece);
  });
  if (!read) return read;
  if (size_bytes != file.size_bytes || sum.hex() != file.sha256) return changed();
  return {};
}

int publishedRevisionOf(const fs::path& folder) {
  std::error_code failed;
  if (!isPublished(folder)) return 0;
  const fs::path place = fs::weakly_canonical(folder, failed);
  return std::atoi(place.filename().c_str());
}

Result<void> writeBundle(const CaseToHandOn& from, const BundleHeader& header, const fs::path& to, Progress& progress) {
  auto out = PieceWriter::create(to);
  if (!out) return passOn(out.error());
  BundleWriter bundle(*out);
  if (auto opened = bundle.open(); !opened) return opened;
  const std::string text = textOf(header);
  if (auto begun = bundle.begin(kBundleHeaderName, text.size()); !begun) return begun;
  if (auto written = bundle.data(std::as_bytes(std::span(text))); !written) return written;
  ByteCount count(say<"Exporting the case">(), bytesOf(from.files), progress);
  for (const FileSum& each : from.files)
    if (auto written = writeFile(each, from.opened.folder, bundle, count); !written) return written;
  if (auto closed = bundle.close(); !closed) return closed;
  return out->finish();
}

}  // namespace

bool holdsExamination(const fs::path& file) {
  std::error_code failed;
  if (!fs::is_regular_file(file, failed)) return false;
  const auto header = readBundleHeader(file);
  return header && std::any_of(header->files.begin(), header->files.end(), [](const FileSum& each) { return each.path == kSealedName; });
}

Result<BundleHeader> exportBundle(const fs::path& caseFolder, const fs::path& file, Progress& progress) {
  return guardedCase(caseFolder, [&]() -> Result<BundleHeader> {
    if (auto kept = keepsExamination(file); !kept) return passOn(kept.error());
    OutputSet outputs;
    if (auto announced = outputs.announce(file, kBundleEnding); !announced) return passOn(announced.error());
    PartOfProgress summing(progress, 0.0, 0.3), writing(progress, 0.3, 1.0);
    const auto from = caseToHandOn(caseFolder, summing);
    if (!from) return passOn(from.error());
    BundleHeader header{.id = from->opened.id,
                        .title = titleForTrainees(from->opened),
                        .revision = publishedRevisionOf(from->opened.folder),
                        .program = kVersion,
                        .files = from->files};
    if (auto written = writeBundle(*from, header, outputs.staged(file), writing); !written)
      return passOn(outputs.inGivenNames(written.error()));
    if (auto committed = outputs.commit(); !committed) return passOn(committed.error());
    return header;
  });
}

}  // namespace ew
