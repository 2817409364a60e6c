#include "ew/phantom/virtual_sweep.h"

#include "scanner/record_sweep.h"

namespace ew {

Result<VirtualSweep> recordSweep(const std::shared_ptr<const Patient>& patient, const Probe& probe, const SweepRecipe& recipe, int threads,
                                 Progress& progress, std::uint64_t maxBytes) {
  if (auto expected = forecastSweep(*patient, probe, recipe); !expected) return passOn(expected.error());
  auto scanner = makeVirtualScanner(patient, probe, recipe.formation, recipe.seed);
  if (!scanner) return passOn(scanner.error());
  return phantom::recordWith(**scanner, *patient, recipe, threads, progress, maxBytes);
}

}  // namespace ew
