#include "logic/kept_painting.h"

#include <nlohmann/json.hpp>
#include <system_error>

#include "ew/core/foreign_json.h"
#include "ew/io/safe_file.h"
#include "ew/io/volume_file.h"
#include "ew/library/content_name.h"

namespace ew::case_authoring {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPaintingFile = "painting.json";

std::optional<KeptPainting::Left> leftIn(const fs::path& folder) {
  const auto text = readTextFile(folder / kPaintingFile, 1u << 20);
  if (!text) return std::nullopt;
  const auto kept = jsonOrNull(*text);
  const auto field = [&](const char* key) { return textAt(kept, key); };
  // A name made by addVolume, never a path that leads elsewhere.
  if (field("case_folder").empty() || !isContentNamed(field("labels"))) return std::nullopt;
  return KeptPainting::Left{folder, field("case_folder"), field("labels"), field("before")};
}

}  // namespace

KeptPainting::KeptPainting(fs::path root) : own_(std::move(root)) {}

KeptPainting::~KeptPainting() { forget(); }

Result<void> KeptPainting::keep(const Volume& labels, const fs::path& caseFolder, const std::string& before, Progress& progress) {
  const std::lock_guard lock(guard_);
  if (!own_.make().empty())
    return failure(ErrorCode::notWritable,
                   say<"What is painted cannot be kept in '%1', so a crash would lose it; keep it in the case often.">(own_.root()),
                   {{"folder", own_.root().string()}});
  auto name = addVolume(labels, own_.path(), progress);
  if (!name) return passOn(name.error());
  const nlohmann::json kept = {{"case_folder", caseFolder.string()}, {"labels", *name}, {"before", before}};
  if (auto written =
          writeFileSafely(own_.path() / kPaintingFile, kept.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
      !written)
    return written;
  // Those before are not named any more.
  std::error_code ignored;
  for (fs::directory_iterator at(own_.path() / "volumes", ignored); !ignored && at != fs::directory_iterator(); at.increment(ignored))
    if (at->path().filename() != fs::path(*name).filename()) fs::remove(at->path(), ignored);
  return {};
}

void KeptPainting::forget() {
  const std::lock_guard lock(guard_);
  own_.remove();
}

void KeptPainting::leave() {
  const std::lock_guard lock(guard_);
  own_.leave();
}

std::optional<KeptPainting::Left> KeptPainting::leftFor(const fs::path& caseFolder) const {
  const std::lock_guard lock(guard_);
  std::optional<Left> latest;
  fs::file_time_type at = fs::file_time_type::min();
  for (const fs::path& folder : own_.left()) {
    std::error_code ignored;
    const auto left = leftIn(folder);
    const auto written = fs::last_write_time(folder / kPaintingFile, ignored);
    if (!left || left->caseFolder != caseFolder || (latest && written <= at)) continue;
    latest = left;
    at = written;
  }
  return latest;
}

Result<Volume> KeptPainting::read(const Left& left, Progress& progress) {
  auto labels = readLabelVolume(left.kept / left.labels, progress);
  if (!labels) return passOn(labels.error());
  return std::move(labels->volume);
}

void KeptPainting::remove(const Left& decided) {
  std::error_code ignored;
  fs::remove(decided.kept / decided.labels, ignored);
  fs::remove(decided.kept / "volumes", ignored);  // only when nothing else lies in it
  fs::remove(decided.kept / kPaintingFile, ignored);
  fs::remove(decided.kept / OwnFolder::kLock, ignored);
  fs::remove(decided.kept, ignored);
}

}  // namespace ew::case_authoring
