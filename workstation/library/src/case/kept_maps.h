#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "ew/imaging/tissue_maps.h"
#include "ew/io/step_store.h"

namespace ew {

/// How files hold a surface.
[[nodiscard]] nlohmann::ordered_json keptJsonOf(const ReflectingSurface& surface);

/// Keeps maps of tissue as a result: each map a file of one byte a voxel, the surfaces in the result's data.
/// @error notWritable
[[nodiscard]] Result<void> keepMaps(const StepStore& store, const char* step, const std::string& key, const TissueMaps& maps);

/// Maps that were made and kept are read from their files from now on, as those are that readKeptMaps reads (restInFile).
void restWhereKept(const StepStore& store, const char* step, const std::string& key, TissueMaps& maps);

/// @param grid of the volume they belong to, and theirs
/// @return null when they are not there as they were kept
[[nodiscard]] std::shared_ptr<TissueMaps> readKeptMaps(const StepStore& store, const char* step, const std::string& key, const Grid& grid);

}  // namespace ew
