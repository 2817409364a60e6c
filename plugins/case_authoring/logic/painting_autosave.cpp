#include "logic/painting_autosave.h"

#include <nlohmann/json.hpp>
#include <system_error>

#include "ew/core/foreign_json.h"
#include "ew/io/volume_file.h"
#include "ew/library/content_name.h"

namespace ew::case_authoring {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPaintingFile = "painting.json";

std::optional<PaintingAutosave::Left> paintingIn(const OwnFolder::Left& left) {
  const auto field = [&](const char* key) { return textAt(left.note, key); };
  // A name made by addVolume, never a path that leads elsewhere.
  if (field("case_folder").empty() || !isContentNamed(field("labels"))) return std::nullopt;
  return PaintingAutosave::Left{left.folder, field("case_folder"), field("labels"), field("before")};
}

}  // namespace

PaintingAutosave::PaintingAutosave(fs::path root) : own_(std::move(root)) {}

PaintingAutosave::~PaintingAutosave() { forget(); }

Result<void> PaintingAutosave::keep(const Volume& labels, const fs::path& caseFolder, const std::string& before, Progress& progress) {
  const std::lock_guard lock(guard_);
  if (!own_.make().empty())
    return failure(ErrorCode::notWritable,
                   say<"What is painted cannot be kept in '%1', so a crash would lose it; keep it in the case often.">(own_.root()),
                   {{"folder", own_.root().string()}});
  auto name = addVolume(labels, own_.path(), progress);
  if (!name) return passOn(name.error());
  if (auto written = own_.writeNote(kPaintingFile, {{"case_folder", caseFolder.string()}, {"labels", *name}, {"before", before}}); !written)
    return written;
  // Those before are not named any more.
  std::error_code ignored;
  for (fs::directory_iterator at(own_.path() / "volumes", ignored); !ignored && at != fs::directory_iterator(); at.increment(ignored))
    if (at->path().filename() != fs::path(*name).filename()) fs::remove(at->path(), ignored);
  return {};
}

void PaintingAutosave::forget() {
  const std::lock_guard lock(guard_);
  own_.remove();
}

void PaintingAutosave::leave() {
  const std::lock_guard lock(guard_);
  own_.leave();
}

std::optional<PaintingAutosave::Left> PaintingAutosave::leftFor(const fs::path& caseFolder) const {
  const std::lock_guard lock(guard_);
  for (const OwnFolder::Left& each : own_.leftWith(kPaintingFile))
    if (auto left = paintingIn(each); left && left->caseFolder == caseFolder) return left;
  return std::nullopt;
}

Result<Volume> PaintingAutosave::read(const Left& left, Progress& progress) {
  auto labels = readLabelVolume(left.kept / left.labels, progress);
  if (!labels) return passOn(labels.error());
  return std::move(labels->volume);
}

void PaintingAutosave::remove(const Left& decided) { OwnFolder::discard(decided.kept, {decided.labels, "volumes", kPaintingFile}); }

}  // namespace ew::case_authoring
