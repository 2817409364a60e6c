#include "run/volume_input.h"

#include <algorithm>
#include <optional>

#include "ew/core/ending.h"
#include "ew/core/numbers.h"
#include "ew/io/volume_file.h"
#include "ew/library/bundle.h"
#include "ew/library/learning_progress.h"
#include "run/arguments.h"

namespace ew::cli {
namespace fs = std::filesystem;

Result<Volume> readInputVolume(Run& run, const fs::path& file) {
  if (auto kept = run.input(file); !kept) return passOn(kept.error());
  auto loaded = [&] {
    const StepClock clock(run.report, "read");
    PartOfProgress reading(run.progress, 0.0, kShareOfReading);
    return readVolume(file, reading);
  }();
  if (!loaded) return passOn(loaded.error());
  for (const auto& note : loaded->notes) run.remark(note);
  return std::move(loaded->volume);
}

Result<ScanVoxels> openInputVoxels(Run& run, const fs::path& file, bool map) {
  if (!map && mappableBytes(file) < kMapFrom_bytes) {
    auto read = readInputVolume(run, file);
    if (!read) return passOn(read.error());
    return ScanVoxels::asStored(std::make_shared<const Volume>(std::move(*read)));
  }
  if (auto kept = run.input(file); !kept) return passOn(kept.error());
  auto mapped = [&] {
    const StepClock clock(run.report, "map");
    return mapVolume(file);
  }();
  if (!mapped) return passOn(mapped.error());
  for (const auto& note : mapped->notes()) run.remark(note);
  return ScanVoxels::of(std::make_shared<const MappedVolume>(std::move(*mapped)));
}

Result<std::vector<Pose>> readPoses(Run& run, const std::string& argument) {
  std::error_code ignored;
  if (fs::is_regular_file(argument, ignored))
    if (auto kept = run.protect(argument); !kept) return passOn(kept.error());
  return posesOf(argument);
}

bool meansCase(const std::string& argument) {
  std::error_code ignored;
  const fs::path path(argument);
  if (fs::is_directory(path, ignored) || hasEnding(path, ".json")) return true;
  return !fs::exists(path, ignored) && !path.has_extension() && !path.has_parent_path();
}

Result<void> expectNoBundle(const std::string& caseOrId) {
  std::error_code ignored;
  if (!hasEnding(caseOrId, kBundleEnding) || !fs::is_regular_file(caseOrId, ignored)) return {};
  return failure(ErrorCode::badUsage,
                 say<"'%1' is a bundle, in which a case is handed on; take it into the library with 'echoweave case import', and name the "
                     "case by its id then.">(caseOrId),
                 {{"file", caseOrId}});
}

Result<Case> findCase(const std::string& caseOrId) {
  std::error_code ignored;
  if (auto isCase = expectNoBundle(caseOrId); !isCase) return passOn(isCase.error());
  if (fs::exists(caseOrId, ignored)) return loadCase(caseOrId);
  if (const auto known = ew::findCase(caseOrId, libraryFolder())) return loadCase(*known);
  const auto shipped = shippedCasesFolder();
  std::string ids;
  if (shipped)
    for (const auto& each : listCases(*shipped).cases) ids += (ids.empty() ? "" : ", ") + each.id;
  return failure(
      ErrorCode::notFound,
      say<"There is no case '%1'; give a case folder, its case.json, the id of a case that is your own or published, or a shipped "
          "case (%2). 'echoweave case list' shows them all.">(caseOrId, ids.empty() ? say<"none found">() : verbatim(ids)),
      {{"case", caseOrId}});
}

Result<CaseContents> readCaseContents(Run& run, const Case& opened) {
  if (auto kept = run.input(opened.folder / "case.json"); !kept) return passOn(kept.error());
  auto contents = [&] {
    const StepClock clock(run.report, "read");
    PartOfProgress reading(run.progress, 0.0, kShareOfReading);
    return readContents(opened, reading);
  }();
  if (!contents) return passOn(contents.error());
  for (const auto& note : contents->notes) run.remark(note);
  return contents;
}

Result<CaseContents> readCaseContentsFor(Run& run, const Case& opened, const StillImages& images) {
  if (auto kept = run.input(opened.folder / "case.json"); !kept) return passOn(kept.error());
  std::optional<double> share;  // of what was made
  auto contents = [&]() -> Result<CaseContents> {
    const StepClock clock(run.report, "read");
    PartOfProgress reading(run.progress, 0.0, kShareOfReading);
    auto seen = readContentsFor(opened, images, reading);
    if (!seen) return passOn(seen.error());
    if (!*seen) return readContents(opened, reading);
    share = (*seen)->share;
    return std::move((*seen)->contents);
  }();
  if (!contents) return passOn(contents.error());
  for (const auto& note : contents->notes) run.remark(note);
  if (share)
    run.remark(
        say<"The case is not prepared; %1 % of it were made, which is what is shown here, and not kept. 'echoweave case prepare %2' makes "
            "all of it, once.">(rounded(std::max(1.0, 100.0 * *share), 0), opened.folder.string()));
  return contents;
}

Result<void> formEchoes(Run& run, ScanSubject& subject, const Scene& asked) {
  if (!asked.liveEchoes || subject.tissue) return {};
  const StepClock clock(run.report, "level");
  auto tissue = recordedTissueOf(subject.voxels, asked, 0, run.progress);
  if (!tissue) return passOn(tissue.error());
  const double level_mib = static_cast<double>((*tissue)->level.size()) / 1048576.0;
  subject.know(std::move(*tissue));
  subject.scene.liveEchoes = asked.liveEchoes;
  run.say("Made the level of the recorded tissue for live echoes (" + rounded(level_mib, 0) +
          " MiB); `echoweave level` keeps it in a file.");
  return {};
}

}  // namespace ew::cli
