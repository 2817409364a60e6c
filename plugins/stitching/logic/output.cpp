#include <unistd.h>

#include <array>
#include <nlohmann/json.hpp>

#include "ew/core/version.h"
#include "logic/output.h"

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
  document["options"] = {{"spacing_mm", project.settings.join.grid.spacing_mm},
                         {"feather_mm", project.settings.join.grid.featherWidth_mm},
                         {"interpolated_weight", project.settings.join.grid.interpolatedWeight},
                         {"axes", nameOf(project.settings.join.grid.axes)}};
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

Result<std::vector<PlacedVolume>> readVolumes(const StitchProject& project, sdk::Volumes& volumes, Progress& progress) {
  std::vector<PlacedVolume> read;
  const double share = project.volumes.empty() ? 1.0 : 1.0 / static_cast<double>(project.volumes.size());
  for (const auto& each : project.volumes) {
    if (progress.cancelRequested()) return failure(ErrorCode::cancelled, "The stitching was cancelled.");
    PartOfProgress part(progress, share * static_cast<double>(read.size()), share * static_cast<double>(read.size() + 1));
    part.report("Reading " + each.name, 0.0);
    auto volume = volumes.read(each.file, part);
    if (!volume) return passOn(volume.error());
    if (!each.coverage.empty())
      if (auto coverage = volumes.readCoverageInto(*volume, each.coverage, part); !coverage) return passOn(coverage.error());
    read.push_back({std::move(*volume), each.toWorld, each.name});
  }
  return read;
}

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

}  // namespace ew::stitching
