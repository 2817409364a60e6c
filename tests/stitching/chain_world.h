#pragma once

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "ew/io/volume_file.h"
#include "ew/stitching/chain.h"
#include "library/temporary_folder.h"

namespace ew::test {

/// A scene of soft blobs and speckle, of which volumes are cut: small, but with something to register everywhere.
class BlobScene {
 public:
  explicit BlobScene(unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> place(-60.0, 60.0), radius(3.0, 9.0), height(-70.0, 90.0);
    for (int n = 0; n < 160; ++n) blobs_.push_back({{place(random), place(random), place(random)}, radius(random), height(random)});
  }
  [[nodiscard]] double at(const glm::dvec3& p) const {
    double level = 90.0;
    for (const Blob& blob : blobs_) {
      const glm::dvec3 apart = p - blob.centre;
      const double share = 1.0 - glm::dot(apart, apart) / (blob.radius * blob.radius);
      if (share > 0.0) level += blob.height * share * share;
    }
    // A hash of the millimetre the point lies in: speckle that belongs to the tissue.
    const glm::ivec3 cell(glm::floor(p * 0.8));
    unsigned hash =
        static_cast<unsigned>(cell.x) * 73856093u ^ static_cast<unsigned>(cell.y) * 19349663u ^ static_cast<unsigned>(cell.z) * 83492791u;
    hash = (hash ^ (hash >> 13)) * 0x5bd1e995u;
    return level + static_cast<double>(hash >> 24) / 6.0 - 21.0;
  }
  /// @param toWorld of the volume; its own grid begins at its origin
  [[nodiscard]] Volume cut(const glm::ivec3& dims, double spacing_mm, const Transform<frame::World, frame::View>& toWorld) const {
    Volume volume;
    volume.grid.dims = dims;
    volume.grid.spacing_mm = glm::dvec3(spacing_mm);
    volume.echo.resize(volume.grid.voxelCount());
    for (int k = 0; k < dims.z; ++k)
      for (int j = 0; j < dims.y; ++j)
        for (int i = 0; i < dims.x; ++i)
          volume.echo[volume.grid.indexOf(i, j, k)] =
              static_cast<std::uint8_t>(std::clamp(at(carried(toWorld, spacing_mm * glm::dvec3(i, j, k))), 1.0, 255.0));
    return volume;
  }

 private:
  struct Blob {
    glm::dvec3 centre;
    double radius;
    double height;
  };
  std::vector<Blob> blobs_;
};

template <class To, class From>
Transform<To, From> shiftedBy(const glm::dvec3& by_mm) {
  Transform<To, From> shift;
  shift.matrix[3] = glm::dvec4(by_mm, 1.0);
  return shift;
}

/// Three volumes in a row, each overlapping the next, in files, and a project about them.
class ChainWorld {
 public:
  explicit ChainWorld(int size = 36) {
    const BlobScene scene(7);
    for (int n = 0; n < 3; ++n) {
      const auto place = shiftedBy<frame::World, frame::View>({-40.0 + 0.6 * size * n, -0.5 * size, -0.5 * size});
      const auto file = folder / (std::string(1, static_cast<char>('a' + n)) + ".mha");
      static_cast<void>(writeVolume(scene.cut(glm::ivec3(size, size - 4, size - 8), 0.999, place), file));
      stitching::ProjectVolume volume;
      volume.file = file;
      volume.name = file.filename().string();
      volume.toWorld = place * shiftedBy<frame::View, frame::View>({n == 1 ? 0.8 : 0.0, 0.0, n == 2 ? -0.6 : 0.0});
      project.volumes.push_back(std::move(volume));
    }
    project.settings.effort = registration::ElasticEffort::fast;
    project.settings.join.seam.cell_mm = 2.0;
    project.settings.fallOff_mm = 15.0;
  }

  Result<stitching::ChainState> run(const std::filesystem::path& into, Progress& progress = noProgress(),
                                    const stitching::ChainOptions& options = {}) {
    return stitching::runChain(project, into, options, progress);
  }

  /// The bytes of the four files of a result.
  [[nodiscard]] static std::map<std::string, std::string> resultIn(const std::filesystem::path& folder) {
    std::map<std::string, std::string> bytes;
    for (const char* name : {"volume.mha", "coverage.mha", "source.mha", "level.mha", "provenance.json"})
      bytes[name] = textOf(folder / name);
    return bytes;
  }

  /// When each finished entry below steps was written.
  [[nodiscard]] static std::map<std::string, std::filesystem::file_time_type> entriesIn(const std::filesystem::path& folder) {
    std::map<std::string, std::filesystem::file_time_type> entries;
    std::error_code ignored;
    for (auto at = std::filesystem::recursive_directory_iterator(folder / "steps", ignored);
         at != std::filesystem::recursive_directory_iterator(); at.increment(ignored))
      if (at->path().extension() == ".json" && at->path().filename() != "inputs.json" &&
          at->path().filename().string().find('-') == std::string::npos &&
          !at->path().parent_path().filename().string().starts_with(".ew-"))  // what lies aside is not finished
        entries[std::filesystem::relative(at->path(), folder).string()] = at->last_write_time();
    return entries;
  }

  /// Files that are neither an entry nor belong to one.
  [[nodiscard]] static std::vector<std::string> leftoversIn(const std::filesystem::path& folder) {
    std::vector<std::string> leftovers;
    for (const auto& each : std::filesystem::recursive_directory_iterator(folder)) {
      if (!each.is_regular_file()) continue;
      const std::string name = each.path().filename().string();
      const std::size_t dash = name.find('-');
      const bool hidden = name.starts_with('.') && name != ".lock";
      const bool orphan =
          dash != std::string::npos && !std::filesystem::exists(each.path().parent_path() / (name.substr(0, dash) + ".json"));
      if (hidden || orphan) leftovers.push_back(each.path().string());
    }
    return leftovers;
  }

  TemporaryFolder folder;
  stitching::StitchProject project;
};

}  // namespace ew::test
