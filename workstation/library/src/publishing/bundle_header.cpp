#include "publishing/bundle_header.h"

#include <algorithm>

#include "case/manifest.h"
#include "case/revisions.h"
#include "ew/core/data_file.h"
#include "ew/core/json_fields.h"
#include "ew/core/version.h"
#include "files/file_pieces.h"

namespace ew {
namespace {

constexpr const char* kKind = "case";

Result<void> checkExpansion(const BundleHeader& header, const std::filesystem::path& bundle, std::uint64_t bundle_bytes,
                            const BundleLimits& limits) {
  const std::uint64_t bytes = bytesOf(header.files);
  if (bytes <= limits.freeExpansion_bytes || static_cast<double>(bytes) <= limits.maxExpansion * static_cast<double>(bundle_bytes))
    return {};
  return failure(
      ErrorCode::tooLarge,
      say<"The bundle '%1' would grow from %2 KiB to %3 KiB, as no case does; do not use it.">(bundle, bundle_bytes >> 10, bytes >> 10),
      {{"file", bundle.string()}});
}

}  // namespace

std::string textOf(const BundleHeader& header) {
  const nlohmann::ordered_json document = {{"format", kBundleFormat},
                                           {"kind", kKind},
                                           {"id", header.id},
                                           {"title", header.title},
                                           {"revision", header.revision},
                                           {"program", header.program},
                                           {"files", jsonOf(header.files)}};
  return document.dump(1) + "\n";
}

Result<BundleHeader> bundleHeaderFrom(const std::string& text, const std::filesystem::path& bundle, std::uint64_t bundle_bytes,
                                      const BundleLimits& limits) {
  const Message where = say<"bundle.json of '%1'">(bundle);
  const auto document = parseJsonObject(text, where);
  if (!document) return passOn(document.error());
  JsonReading reading(where);
  const JsonFields fields(*document, reading);
  requireFormat(fields, kBundleFormat);
  const std::string kind = fields.text("kind");
  if (reading.good() && kind != kKind)
    return failure(ErrorCode::unsupported,
                   say<"The bundle '%1' holds no case but a \"%2\", which this program does not know; update EchoWeave.">(bundle, kind),
                   {{"file", bundle.string()}, {"kind", kind}});
  fields.only({"format", "kind", "id", "title", "revision", "program", "files"});
  BundleHeader header;
  header.id = fields.text("id", {}, 1, 1000);
  if (reading.good() && !isCaseId(header.id)) fields.refuse("id", say<"letters, digits, '-', '_' and '.', at most 100">());
  header.title = fields.text("title", {}, 1, 1000);
  header.revision = static_cast<int>(fields.whole("revision", 0, 1'000'000'000));
  header.program = fields.text("program", std::string(), 0);
  if (const auto* list = fields.find("files"); list != nullptr && list->is_array() && list->size() > limits.maxFiles)
    return failure(ErrorCode::tooLarge,
                   say<"The bundle '%1' lists %2 files, and more than %3 are not taken; do not use it, or ask for a smaller one.">(
                       bundle, list->size(), limits.maxFiles),
                   {{"file", bundle.string()}});
  header.files = fileSumsIn(fields, limits);
  if (reading.problem()) return passOn(*reading.problem());
  if (auto good = checkFileList(header.files, say<"The bundle '%1'">(bundle), limits); !good) return passOn(good.error());
  if (std::none_of(header.files.begin(), header.files.end(), [](const FileSum& each) { return each.path == kManifestName; }))
    return failure(ErrorCode::badField, say<"The bundle '%1' lists no case.json, so there is no case in it; ask for another one.">(bundle),
                   {{"file", bundle.string()}});
  if (auto good = checkExpansion(header, bundle, bundle_bytes, limits); !good) return passOn(good.error());
  return header;
}

}  // namespace ew
