#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "chain/file_contents.h"
#include "chain/pair_match.h"
#include "ew/acquisition/sweep_volume.h"
#include "ew/io/step_store.h"
#include "ew/io/volume_file.h"
#include "ew/stitching/chain.h"

namespace ew::stitching {

/// What is known about an input before and after its voxels are read.
struct ChainInput {
  VolumeHeader header;
  std::string key;  ///< of its content, and of a sweep of how it is reconstructed
  Grid grid;        ///< of the volume; of a sweep once that is known
  std::uint64_t sweepBytes = 0;
  std::shared_ptr<const ViewData> view;  ///< once a step asked for its voxels
};

/// The inputs of a run: what names each, the volumes of sweeps (kept in the store under "reconstruct"), and voxels once a step asks for
/// them, which then stay in memory.
class ChainInputs {
 public:
  /// The step's folder in the store, in which each sweep's volume has a key of its own.
  static constexpr const char* kStep = "reconstruct";

  ChainInputs(const StitchProject& project, const ChainOptions& options, const StepStore& store);

  /// Finds out what each input is and under which key its results lie; files that did not change are not read again.
  /// @param planSweeps asks a sweep that is not reconstructed yet for its grid and for what reconstructing takes
  /// @error what looking at a file says; cancelled
  [[nodiscard]] Result<void> identify(Progress& progress, bool planSweeps);
  /// Remembers the contents of files for the next run.
  void rememberContents() { contents_.save(); }

  [[nodiscard]] std::size_t size() const { return inputs_.size(); }
  [[nodiscard]] const ChainInput& operator[](std::size_t v) const { return inputs_[v]; }

  /// A sweep whose volume is not in the store yet.
  [[nodiscard]] bool isToBeMade(std::size_t v) const;
  /// Its grid, and what reconstructing it takes. @error what planning says
  [[nodiscard]] Result<void> plan(std::size_t v, Progress& progress);
  /// Reconstructs a sweep into the store. @error what reconstructing or writing says; cancelled
  [[nodiscard]] Result<void> make(std::size_t v, Progress& progress);

  /// The voxels of an input, read once; a damaged reconstruction is made again.
  /// @error what reading says; cancelled
  [[nodiscard]] Result<std::shared_ptr<const ViewData>> load(std::size_t v, Progress& progress);

  /// What readers had to decide about the inputs that were read.
  [[nodiscard]] const std::vector<Message>& notes() const { return notes_; }

  /// Memory for all of them, which stay: echo, coverage and confidence; and for reading the largest.
  [[nodiscard]] std::uint64_t heldBytes() const;

 private:
  [[nodiscard]] Result<std::string> contentOf(const std::filesystem::path& file, Progress& progress);
  [[nodiscard]] Result<std::string> keyOf(std::size_t v, Progress& progress);
  [[nodiscard]] SweepVolumeOptions sweepOptions(std::size_t v) const;
  [[nodiscard]] Result<std::shared_ptr<ViewData>> readSweep(std::size_t v, Progress& progress);
  [[nodiscard]] Result<std::shared_ptr<ViewData>> readView(std::size_t v, Progress& progress);

  const StitchProject& project_;
  const ChainOptions& options_;
  const StepStore& store_;
  FileContents contents_;
  std::vector<ChainInput> inputs_;
  std::vector<Message> notes_;
};

}  // namespace ew::stitching
