#pragma once

#include <array>
#include <filesystem>
#include <optional>

namespace ew {

/// The kinds of steps of a preparation, each with a unit of work of its own.
enum class PreparationStep { patient, voxelise, record, reconstruct, stitch };
inline constexpr std::array kPreparationSteps = {PreparationStep::patient, PreparationStep::voxelise, PreparationStep::record,
                                                 PreparationStep::reconstruct, PreparationStep::stitch};
static_assert(kPreparationSteps.size() == 1 + static_cast<std::size_t>(PreparationStep::stitch));

/// Seconds per unit of work of each kind of step, as earlier preparations took them.
struct MachineSpeed {
  std::array<double, kPreparationSteps.size()> secondsPerWork{};
  std::array<bool, kPreparationSteps.size()> isMeasured{};
  [[nodiscard]] double of(PreparationStep kind) const { return secondsPerWork[static_cast<std::size_t>(kind)]; }
};

/// The kept speed, or that of the machine the program was written on.
[[nodiscard]] MachineSpeed readMachineSpeed(const std::filesystem::path& folder);

/// Mixes a measured step into the kept speed. Best effort: without it only estimates are worse.
void keepMachineSpeed(const std::filesystem::path& folder, PreparationStep kind, double work, double seconds);

}  // namespace ew
