#pragma once

#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "chain/chain_inputs.h"
#include "chain/chain_keys.h"
#include "chain/group_warp.h"
#include "ew/stitching/chain.h"
#include "ew/stitching/result_files.h"

namespace ew::stitching {

/// What the steps of one run hand on to each other. A step reads what earlier ones left here, and the store for what an earlier run left.
struct ChainRun {
  ChainRun(const StitchProject& asked, const std::filesystem::path& into, const ChainOptions& how, StepStore& stepStore);

  const StitchProject& project;
  const ProjectSettings& settings;
  const std::filesystem::path& folder;
  const ChainOptions& options;
  StepStore& store;

  std::optional<ResultFiles> resultFiles;  ///< what lay in the folder when the run began; none when it stops before the volume

  ChainInputs inputs;
  std::vector<Candidate> candidates;  ///< after reconstruct
  Keys keys;                          ///< after reconstruct
  ChainState state;
  std::vector<Decision> decisions;      ///< after rigid: one per state.pairs
  std::vector<std::size_t> included;    ///< after graph: volumes that go into the result
  SeamMap seams;                        ///< after seam: views counted among `included`
  std::optional<WaitingResult> result;  ///< after volume

  [[nodiscard]] StepOutcome& outcomeOf(Step step) { return state.steps[static_cast<std::size_t>(step)]; }
  /// To the world, as the graph has it.
  [[nodiscard]] const Transform<frame::World, frame::View>& poseOf(std::size_t v) const { return state.graph->toWorld[v]; }
  /// From the fixed to the moving volume, as the graph has it.
  [[nodiscard]] Transform<frame::Moving, frame::Fixed> startOf(std::size_t fixed, std::size_t moving) const;
  /// The views that go into the result; all are in memory afterwards.
  /// @error what reading says; cancelled
  [[nodiscard]] Result<std::vector<View>> views(Progress& progress);
  /// The boxes of those views; before the graph, of all at the places the project gives them.
  [[nodiscard]] std::vector<GridPlacement> placedGrids() const;
  /// Of the result. @error tooLarge
  [[nodiscard]] Result<Grid> resultGrid() const;

  /// The project's options as the steps use them: views are counted among `included`.
  [[nodiscard]] JoinOptions joinOptions() const;
  [[nodiscard]] WarpOptions warpOptions() const { return {.fallOff_mm = settings.fallOff_mm, .threads = options.threads}; }
  [[nodiscard]] registration::ElasticOptions elasticOptions(std::size_t fixed, std::size_t moving) const;
  /// Tells whoever asked of the levels of a pair's registration, one at a time.
  [[nodiscard]] registration::OnLevel levelsOf(std::size_t fixed, std::size_t moving);
  /// Threads of each of so many pairs beside each other.
  [[nodiscard]] int threadsOfEach(int atOnce) const;

 private:
  std::mutex onLevelGuard_;
};

[[nodiscard]] tl::unexpected<Error> cancelledChain();

/// A result that is read back: what a damaged file throws becomes "not there".
template <class Value, class From>
std::optional<Value> readBack(const std::optional<nlohmann::json>& data, const From& from) {
  if (!data) return std::nullopt;
  try {
    return from(*data);
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  }
}

}  // namespace ew::stitching
