#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "ew/imaging/tissue_motion.h"
#include "ew/io/step_store.h"

namespace ew {

/// How files hold the rhythms of a body; what has none is left out.
[[nodiscard]] nlohmann::ordered_json keptJsonOf(const BodyRhythms& rhythms);

/// Keeps how tissue moves as a result: each field a file of three floats a node, grids and rhythms in the result's data.
/// @param motion null: that it does not move is kept
/// @error notWritable
[[nodiscard]] Result<void> keepMotion(const StepStore& store, const char* step, const std::string& key, const TissueMotion* motion);

/// @param motion null when what was kept does not move, and when nothing is there as it was kept
/// @return whether it is there as it was kept; true for an empty key
[[nodiscard]] bool readKeptMotion(const StepStore& store, const char* step, const std::string& key, std::shared_ptr<TissueMotion>& motion);

}  // namespace ew
