#include <unistd.h>

#include <array>

#include "ew/core/version.h"
#include "logic/project.h"

namespace ew::stitching {
namespace {

namespace fs = std::filesystem;

/// What was joined and how, without times or absolute machine facts: the same inputs give the same text.
std::string provenanceText(const StitchResult& result, const StitchProject& project) {
  nlohmann::ordered_json document;
  document["made_by"] = std::string("EchoWeave ") + kVersion + ", stitch";
  document["inputs"] = nlohmann::ordered_json::array();
  for (std::size_t n = 0; n < result.contributions.size(); ++n) {
    nlohmann::ordered_json input;
    input["source_value"] = n + 1;
    input["name"] = result.contributions[n].name;
    if (n < project.volumes.size()) {
      input["file"] = project.volumes[n].file.generic_string();
      if (!project.volumes[n].coverage.empty()) input["coverage"] = project.volumes[n].coverage.generic_string();
      input["to_world"] = rowsOf(project.volumes[n].toWorld);
    }
    input["contributed_voxels"] = result.contributions[n].voxels;
    input["dominant_voxels"] = result.contributions[n].dominantVoxels;
    document["inputs"].push_back(input);
  }
  document["options"] = {{"spacing_mm", project.options.spacing_mm},
                         {"feather_mm", project.options.featherWidth_mm},
                         {"interpolated_weight", project.options.interpolatedWeight},
                         {"axes", project.options.axes == GridAxes::world ? "world" : "first"}};
  const Grid& grid = result.volume.grid;
  document["grid"] = {{"dims", {grid.dims.x, grid.dims.y, grid.dims.z}},
                      {"spacing_mm", {grid.spacing_mm.x, grid.spacing_mm.y, grid.spacing_mm.z}},
                      {"voxel_to_world", rowsOf(grid.voxelToWorld().matrix)}};
  document["overlap_share"] = result.overlapShare;
  document["disagreement_rms"] = result.disagreementRms;
  document["notes"] = result.notes;
  return document.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

/// Removes what was made aside, and the folder itself when it was made for this.
class Aside {
 public:
  Aside(fs::path folder, bool folderIsNew) : folder_(std::move(folder)), isNew_(folderIsNew) {}
  ~Aside() {
    std::error_code ignored;
    fs::remove_all(path(), ignored);
    if (isNew_ && !kept_) fs::remove(folder_, ignored);
  }
  Aside(const Aside&) = delete;
  Aside& operator=(const Aside&) = delete;
  [[nodiscard]] fs::path path() const { return folder_ / (".stitch-" + std::to_string(::getpid())); }
  void keepFolder() { kept_ = true; }

 private:
  fs::path folder_;
  bool isNew_;
  bool kept_ = false;
};

}  // namespace

Result<StitchFiles> writeStitch(const StitchResult& result, const StitchProject& project, const fs::path& folder, sdk::Volumes& volumes,
                                sdk::Files& files, Progress& progress) {
  std::error_code error;
  const bool isNew = !fs::exists(folder, error);
  const auto refuse = [&] {
    return failure(ErrorCode::notWritable,
                   "The folder '" + folder.string() + "' cannot be written (" + error.message() + "); choose one you may write to.",
                   {{"file", folder.string()}});
  };
  Aside aside(folder, isNew);
  fs::create_directories(aside.path(), error);
  if (error) return refuse();

  PartOfProgress echoPart(progress, 0.0, 0.5);
  if (auto written = volumes.write(result.volume, aside.path() / "volume.mha", echoPart); !written) return passOn(written.error());
  PartOfProgress coveragePart(progress, 0.5, 0.75);
  if (auto written = volumes.writeCoverage(result.volume, aside.path() / "coverage.mha", coveragePart); !written)
    return passOn(written.error());
  PartOfProgress sourcePart(progress, 0.75, 1.0);
  const Volume source{result.volume.grid, result.source, {}};
  if (auto written = volumes.write(source, aside.path() / "source.mha", sourcePart); !written) return passOn(written.error());
  if (auto written = files.writeText(aside.path() / "provenance.json", provenanceText(result, project)); !written)
    return passOn(written.error());
  // Past this point the files only change places, so a cancel comes too late to leave a mixture behind.
  if (progress.cancelRequested()) return failure(ErrorCode::cancelled, "The stitching was cancelled; nothing was written.");
  for (const char* name : {"volume.mha", "coverage.mha", "source.mha", "provenance.json"}) {
    fs::rename(aside.path() / name, folder / name, error);
    if (error) return refuse();
    aside.keepFolder();
  }
  return StitchFiles{folder / "volume.mha", folder / "coverage.mha", folder / "source.mha", folder / "provenance.json"};
}

Result<sdk::Commands::Outcome> runStitchCommand(const std::vector<std::string>& args, sdk::Volumes& volumes, sdk::Files& files,
                                                sdk::Log& log, Progress& progress) {
  const auto usage = [](const std::string& what) { return failure(ErrorCode::badUsage, what + " Usage: echoweave " + kStitchUsage + "."); };
  std::string projectFile;
  std::string folder;
  int threads = 0;
  for (std::size_t i = 0; i < args.size(); ++i) {
    const bool takesValue = args[i] == "-o" || args[i] == "--output" || args[i] == "--threads";
    if (takesValue && i + 1 == args.size()) return usage("A value is missing after " + args[i] + ".");
    if (args[i] == "-o" || args[i] == "--output") {
      folder = args[++i];
    } else if (args[i] == "--threads") {
      const auto& word = args[++i];
      if (word.empty() || word.size() > 4 || word.find_first_not_of("0123456789") != std::string::npos)
        return usage("--threads is '" + word + "' and must be a whole number from 0 to 9999.");
      threads = std::stoi(word);
    } else if (args[i].size() > 1 && args[i].front() == '-') {
      return usage("'" + args[i] + "' is not an option of stitch.");
    } else if (projectFile.empty()) {
      projectFile = args[i];
    } else {
      return usage("There are two projects, '" + projectFile + "' and '" + args[i] + "', and only one can be stitched.");
    }
  }
  if (projectFile.empty()) return usage("The project file is missing.");
  if (folder.empty()) return usage("The output folder is missing.");

  auto text = files.readText(projectFile);
  if (!text) return passOn(text.error());
  auto project = parseProject(*text, fs::path(projectFile).parent_path(), files);
  if (!project) return passOn(project.error());
  project->options.threads = threads;
  PartOfProgress reading(progress, 0.0, 0.3);
  auto inputs = readVolumes(*project, volumes, reading);
  if (!inputs) return passOn(inputs.error());
  auto forecast = forecastStitch(*inputs, project->options);
  if (!forecast) return passOn(forecast.error());
  PartOfProgress blending(progress, 0.3, 0.8);
  auto result = stitch(*inputs, project->options, blending);
  if (!result) return passOn(result.error());
  for (const auto& note : result->notes) log.warn(note);
  PartOfProgress writing(progress, 0.8, 1.0);
  auto written = writeStitch(*result, *project, folder, volumes, files, writing);
  if (!written) return passOn(written.error());

  sdk::Commands::Outcome outcome;
  for (const auto& file : {written->volume, written->coverage, written->source, written->provenance})
    outcome.outputs.push_back(file.string());
  outcome.quality = {{"overlap_share", result->overlapShare},
                     {"disagreement_rms_grey", result->disagreementRms},
                     {"stitch_seconds", result->seconds},
                     {"forecast_mib", static_cast<double>(forecast->bytes) / (1024.0 * 1024.0)}};
  for (std::size_t n = 0; n < result->contributions.size(); ++n)
    outcome.quality.emplace_back("contributed_voxels_" + std::to_string(n + 1), static_cast<double>(result->contributions[n].voxels));
  return outcome;
}

}  // namespace ew::stitching
