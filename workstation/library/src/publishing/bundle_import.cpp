#include "case/manifest.h"
#include "case/revisions.h"
#include "ew/core/json_fields.h"
#include "ew/library/case.h"
#include "files/guarded_case.h"
#include "publishing/bundle_reader.h"

namespace ew {
namespace {

namespace fs = std::filesystem;

/// Keeps case.json and lets everything else go by, or into a folder.
class CaseSink final : public BundleSink {
 public:
  explicit CaseSink(fs::path folder = {}) : folder_(std::move(folder)) {}

  Result<void> begin(const FileSum& file) override {
    isManifest_ = file.path == kManifestName;
    if (folder_.empty()) return {};
    auto out = PieceWriter::create(folder_ / file.path);
    if (!out) return passOn(out.error());
    out_.emplace(std::move(*out));
    return {};
  }
  Result<void> data(std::span<const std::byte> piece) override {
    constexpr std::size_t kMost_bytes = 5u << 20;  // more than loadCase reads
    if (isManifest_ && manifest_.size() < kMost_bytes) manifest_.append(reinterpret_cast<const char*>(piece.data()), piece.size());
    return out_ ? out_->write(piece) : Result<void>();
  }
  Result<void> end() override {
    if (!out_) return {};
    auto finished = out_->finish();
    out_.reset();
    return finished;
  }
  [[nodiscard]] const std::string& manifest() const { return manifest_; }

 private:
  fs::path folder_;
  std::optional<PieceWriter> out_;
  bool isManifest_ = false;
  std::string manifest_;
};

Error ofBundle(Error inner, const fs::path& file) {
  inner.message = say<"The case in the bundle '%1' cannot be used: %2">(file, std::move(inner.message));
  inner.context.emplace_back("bundle", file.string());
  return inner;
}

/// That case.json is one this program knows and the bundle's own. Files it names are looked for when they are there.
Result<void> checkManifestText(const std::string& text, const BundleHeader& header, const fs::path& file, const fs::path& folder) {
  const auto manifest = parseJson(text, verbatim(kManifestName));
  if (!manifest) return passOn(ofBundle(manifest.error(), file));
  const auto opened = caseFromManifest(*manifest, folder);
  if (!opened) return passOn(ofBundle(opened.error(), file));
  if (opened->id != header.id)
    return failure(ErrorCode::badField,
                   say<"The bundle '%1' says that it holds the case \"%2\", and it holds \"%3\"; ask for it to be exported again.">(
                       file, header.id, opened->id),
                   {{"file", file.string()}});
  return {};
}

}  // namespace

Result<BundleHeader> readBundleHeader(const fs::path& file, const BundleLimits& limits) {
  return guardedCase(file, [&]() -> Result<BundleHeader> {
    auto bundle = BundleReader::open(file, limits, noProgress());
    if (!bundle) return passOn(bundle.error());
    return bundle->header();
  });
}

Result<BundleHeader> verifyBundle(const fs::path& file, const BundleLimits& limits, Progress& progress) {
  return guardedCase(file, [&]() -> Result<BundleHeader> {
    auto bundle = BundleReader::open(file, limits, progress);
    if (!bundle) return passOn(bundle.error());
    CaseSink sink;
    ByteCount count(say<"Checking the bundle">(), bytesOf(bundle->header().files), progress);
    if (auto read = bundle->readFiles(sink, count); !read) return passOn(read.error());
    if (auto good = checkManifestText(sink.manifest(), bundle->header(), file, {}); !good) return passOn(good.error());
    return bundle->header();
  });
}

Result<CaseRevision> importBundle(const fs::path& file, const fs::path& library, const BundleLimits& limits, Progress& progress) {
  return guardedCase(file, [&]() -> Result<CaseRevision> {
    const auto header = readBundleHeader(file, limits);
    if (!header) return passOn(header.error());
    if (auto same = revisionWith(library, header->id, header->files)) return *same;
    if (auto room = checkRoom(library, bytesOf(header->files)); !room) return passOn(room.error());
    const auto there = [&] { return revisionWith(library, header->id, header->files); };
    return makeRevision(library, header->id, header->revision, header->files, there, [&](const fs::path& aside) -> Result<void> {
      auto bundle = BundleReader::open(file, limits, progress);
      if (!bundle) return passOn(bundle.error());
      if (bundle->header() != *header)
        return failure(ErrorCode::notReadable, say<"The bundle '%1' was changed while it was read; do it again.">(file),
                       {{"file", file.string()}});
      CaseSink sink(aside);
      ByteCount count(say<"Importing the case">(), bytesOf(header->files), progress);
      if (auto read = bundle->readFiles(sink, count); !read) return read;
      return checkManifestText(sink.manifest(), *header, file, aside);
    });
  });
}

}  // namespace ew
