#include "files/machine_speed.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "ew/core/word_table.h"
#include "ew/io/json_files.h"
#include "ew/io/safe_file.h"

namespace ew {
namespace {

constexpr const char* kSpeedFile = "speed.json";
constexpr double kNewShare = 0.5;  // of what was just measured: a machine's load changes
// Two cores of 2.5 GHz: s a patient, s for a million voxels of its box (air and fluid cost little: 0.2 to 0.65), s for a million resolution
// cells, the same, s for a million voxels swept.
constexpr std::array<double, kPreparationSteps.size()> kNominal = {0.5, 0.55, 1.6, 0.15, 0.3};

/// In the file.
constexpr WordTable<PreparationStep, 5> kPreparationStepWords{{{"patient", PreparationStep::patient},
                                                               {"voxels", PreparationStep::voxelise},
                                                               {"recording", PreparationStep::record},
                                                               {"reconstructing", PreparationStep::reconstruct},
                                                               {"stitch", PreparationStep::stitch}}};
const char* wordOf(PreparationStep step) { return wordIn(kPreparationStepWords, step); }

nlohmann::json readKept(const std::filesystem::path& folder) {
  return readJsonFile(folder / kSpeedFile, verbatim(kSpeedFile), 1u << 16).value_or(nlohmann::json::object());
}

std::optional<double> keptRate(const nlohmann::json& kept, const char* name) {
  if (!kept.contains(name) || !kept[name].is_number()) return std::nullopt;
  const double rate = kept[name].get<double>();
  if (!std::isfinite(rate) || rate <= 0.0) return std::nullopt;
  return rate;
}

}  // namespace

MachineSpeed readMachineSpeed(const std::filesystem::path& folder) {
  MachineSpeed speed;
  speed.secondsPerWork = kNominal;
  const nlohmann::json kept = readKept(folder);
  double slower = 0.0;
  int known = 0;
  for (std::size_t n = 0; n < kPreparationSteps.size(); ++n) {
    const auto rate = keptRate(kept, wordOf(kPreparationSteps[n]));
    if (!rate) continue;
    speed.secondsPerWork[n] = *rate;
    speed.isMeasured[n] = true;
    slower += std::log(*rate / kNominal[n]);
    ++known;
  }
  if (known == 0) return speed;
  // What was never timed is taken to be as much slower as what was.
  for (std::size_t n = 0; n < kPreparationSteps.size(); ++n)
    if (!speed.isMeasured[n]) speed.secondsPerWork[n] *= std::exp(slower / known);
  return speed;
}

void keepMachineSpeed(const std::filesystem::path& folder, PreparationStep kind, double work, double seconds) {
  if (!(work > 0.0) || !(seconds > 0.0)) return;
  nlohmann::json kept = readKept(folder);
  const char* name = wordOf(kind);
  const double rate = seconds / work;
  const auto before = keptRate(kept, name);
  kept[name] = before ? (1.0 - kNewShare) * *before + kNewShare * rate : rate;
  std::error_code ignored;
  std::filesystem::create_directories(folder, ignored);
  static_cast<void>(writeFileSafely(folder / kSpeedFile, kept.dump(2) + "\n"));
}

}  // namespace ew
