#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ew/core/memory.h"
#include "ew/stitching/project.h"

namespace ew::stitching {

/// The steps from subvolumes to one volume, in their order. Grey levels are equalised once places are known: without a tracker nobody knows
/// before what overlaps, and registration does not need it (it is free of gain).
enum class Step { reconstruct, rigid, graph, equalise, elastic, seam, volume };
inline constexpr std::array kSteps = {Step::reconstruct, Step::rigid, Step::graph, Step::equalise, Step::elastic, Step::seam, Step::volume};
[[nodiscard]] const char* nameOf(Step step);  ///< "reconstruct" … as in `--until` and in reports

/// Below FOLDER/steps, where results of the chain lie: one for each step, and those of single pairs.
[[nodiscard]] const std::vector<std::string>& stepFolders();

/// What is known about a pair after the rigid step, and after the elastic one.
struct PairOutcome {
  std::size_t fixed = 0;
  std::size_t moving = 0;
  PairMethod used = PairMethod::automatic;
  registration::RigidResult rigid;
  std::optional<registration::LandmarkResult> landmarks;
  std::vector<registration::Hypothesis> hypotheses;      ///< of a search
  std::optional<registration::GraphEdgeReport> inGraph;  ///< what the graph made of it; none where it was not asked
  bool wrong = false;                                    ///< the graph does not believe it
  bool suspect = false;                                  ///< it could be the wrong one as well as another
  double processor_s = 0.0;                              ///< as of PairDeformation
};

/// What warping one pair of views found, before all warps were brought together.
struct PairDeformation {
  std::size_t fixed = 0;
  std::size_t moving = 0;
  registration::ElasticEffort effort = registration::ElasticEffort::balanced;
  registration::Verdict verdict = registration::Verdict::cannotTell;
  Message reason = {};
  std::vector<registration::Remark> remarks = {};
  registration::Agreement before = {};
  registration::Agreement after = {};
  double largestMotion_mm = 0.0;
  double smallestJacobian = 1.0;
  std::vector<registration::Level> levels = {};
  double seconds = 0.0;  ///< that it took when it was made
  /// Of these, what the thread that warped it worked; the others worked beside it. On a free machine both are the same, on a busy one only
  /// this tells what the pair costs. 0: not known.
  double processor_s = 0.0;
};

/// What one step left, read back from the output folder or just made.
struct StepOutcome {
  Step step = Step::reconstruct;
  bool done = false;
  bool reused = false;  ///< found finished for exactly these inputs and settings
  double seconds = 0.0;
  std::uint64_t forecast_bytes = 0;
};

/// How the group warps.
struct WarpSummary {
  std::size_t pairs = 0;
  double largest_mm = 0.0;
  double smallestJacobian = 1.0;
  double disagreementMedian_mm = 0.0;  ///< what the pairs still differ by when all are heard
  double disagreement95_mm = 0.0;
};

/// All that is known about a project in its output folder.
struct ChainState {
  std::vector<StepOutcome> steps;                      ///< one per Step
  std::vector<std::shared_ptr<const Volume>> volumes;  ///< one per line, after `reconstruct`
  std::vector<GreyCorrection> corrections;
  std::vector<PairOutcome> pairs;  ///< in order of fixed, then moving; a rejected one only where it is known from before
  std::optional<registration::GraphResult> graph;
  std::vector<registration::ControlGrid> warps;  ///< one per volume, world; empty lattices where nothing warps; after `elastic`
  WarpSummary warpSummary;
  std::vector<PairDeformation> warpedPairs;  ///< after `elastic`, in order of fixed, then moving
  std::optional<SeamMap> seams;              ///< of the project's volumes by their numbers
  std::vector<Message> notes;                ///< what readers of the inputs had to decide, a sentence each
  std::vector<std::size_t> leftOut;          ///< volumes that nothing holds to the others; not in the result
  std::optional<JoinReport> report;
  std::filesystem::path volume, coverage, source, level, provenance;  ///< of the result, when it is there
  std::function<Result<void>()> putInPlace;                           ///< with ChainOptions::putInPlaceLater: moves the result to these
  std::uint64_t pruned_bytes = 0;                                     ///< of results of earlier runs, taken away (ChainOptions::keepBytes)
  registration::Verdict verdict = registration::Verdict::cannotTell;  ///< of the whole: the worst of what holds it together
  Message reason;
};

struct ChainOptions {
  Step until = Step::volume;
  int threads = 0;
  std::uint64_t maxBytes = kLargestVolume_bytes;
  bool keepVolumes = true;  ///< false: ChainState::volumes stays empty when nothing had to be made from them
  /// The folder is the program's own: nobody else's files can lie there, so that nothing is asked about what does.
  bool isFolderOwn = false;
  /// The finished result waits in `folder`/steps for ChainState::putInPlace, so that what belongs to it can come first or not at all.
  bool putInPlaceLater = false;
  /// Results of more voxels are written block by block, uncompressed; the voxels do not depend on it.
  std::uint64_t streamAbove_voxels = 1ull << 28;
  /// Results of earlier runs that a finished run did not use may take so much of the disk, the last used the longest: an edit that is taken
  /// back finds its old answers. What this run used always stays.
  std::uint64_t keepBytes = 2ull << 30;
  /// Called on a working thread when a level of a pair's registration ends, one call at a time; pairs are registered beside each other.
  std::function<void(std::size_t fixed, std::size_t moving, const registration::Level&)> onLevel;
  /// Called on the caller's thread when a step ended and gave back the memory it had freed.
  std::function<void(const StepOutcome&)> onStep;
};

/// What a run would still do and need, before anything is read into memory.
struct ChainForecast {
  std::vector<StepOutcome> steps;
  std::uint64_t peak_bytes = 0;
};
[[nodiscard]] Result<ChainForecast> forecastChain(const StitchProject& project, const std::filesystem::path& folder,
                                                  const ChainOptions& options);

/// Runs the steps that are not finished for these inputs and settings. Each step leaves its result in `folder`/steps/NAME, complete or not
/// at all, under a key of everything it depends on; so a run that was cancelled or killed goes on where it stopped and ends with the same
/// bytes. A finished volume lies in `folder` under five names (result_files.h); a file there that no earlier run wrote is never touched.
/// @error what a step says, naming the volume or pair; notWritable (also: somebody else's file has a name of the result); badUsage (the
///        result would be written over an input); tooLarge (the forecast above maxBytes); cancelled (within 0.5 s)
[[nodiscard]] Result<ChainState> runChain(const StitchProject& project, const std::filesystem::path& folder, const ChainOptions& options,
                                          Progress& progress);

}  // namespace ew::stitching
