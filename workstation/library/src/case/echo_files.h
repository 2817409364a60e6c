#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/imaging/flow_field.h"
#include "ew/imaging/tissue_maps.h"
#include "ew/imaging/tissue_motion.h"
#include "ew/library/case_echoes.h"

namespace ew {

/// What is wrong with "echoes" of a case that the schema takes, and with the files it names as far as their headers tell.
[[nodiscard]] std::vector<Error> problemsOfEchoes(const Case& opened);

struct CaseTissue {
  std::shared_ptr<TissueMaps> maps;
  std::shared_ptr<TissueMotion> motion = nullptr;   ///< null: it does not move
  std::shared_ptr<const FlowField> flow = nullptr;  ///< null: nobody says how blood flows
};
/// Tissue of a case of files, not placed. Whoever sent the files is not trusted: sizes are checked before memory is taken.
/// @param level the case's, as read
/// @param volume grid of what is scanned; the maps' of a case with "echoes"
/// @param notes what a user should know is appended
/// @error as readLabelVolume and readJsonFile; badField (another grid, a surface that is not there, a shift that is none, a flow that is
///        none); truncated, tooLarge
[[nodiscard]] Result<CaseTissue> readTissue(const Case& opened, Volume level, const Grid& volume, Progress& progress,
                                            std::vector<Message>& notes);

/// Puts surfaces, motion and flow into a case folder, without their names, and names the files in the case. The level is not written.
/// @param maps on the level's grid @param motion fields along the axes of the case's own frame; null: it does not move
/// @param flow in that frame; streams that pass the maps' grid farther than 10 mm from it are left out; null: nobody says how blood flows
/// @error as addVolume, notWritable
[[nodiscard]] Result<void> addEchoes(Case& into, const std::filesystem::path& folder, const TissueMaps& maps, const TissueMotion* motion,
                                     const FlowField* flow, Progress& progress);

}  // namespace ew
