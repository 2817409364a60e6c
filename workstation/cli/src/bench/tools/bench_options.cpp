#include "bench/tools/bench_options.h"

#include <utility>

#include "ew/core/numbers.h"
#include "run/arguments.h"
#include "run/volume_input.h"

namespace ew::cli {

void addSides(CLI::App& app, std::vector<std::string>& sides) {
  app.add_option("--side", sides, "Voxels a side of the volume; may be given several times (256 and 512)")->type_name("COUNT");
}

void addFrameSize(CLI::App& app, glm::ivec2& size_px) { addSize(app, "--frame", size_px, "Pixels of a frame (1024x768)"); }

void addPoses(CLI::App& app, std::optional<int>& poses) {
  addCount(app, "--poses", poses, 2, 1000, "Poses of each kind (slices 40, frames 12, live echoes 3)");
}

void addDrawSeed(CLI::App& app, std::uint64_t& seed) {
  addSeed(app, "--seed", seed, "Which pairs are registered, which speckle is joined, which poses are compared (1)");
}

void addRepetitions(CLI::App& app, std::optional<int>& repetitions) {
  addCount(app, "--repetitions", repetitions, 1, 1000,
           "Interleaved repetitions (slices and frames 7, reconstructions 5, registrations 1, joining 3)");
}

void addNoPeers(CLI::App& app, bool& noPeers) { app.add_flag("--no-peers", noPeers, "Leave VTK's reslice, elastix and plastimatch out"); }

Result<std::vector<int>> sidesOf(const std::vector<std::string>& given, std::vector<int> usual, int smallest) {
  if (given.empty()) return usual;
  std::vector<int> sides;
  for (const auto& side : given) {
    const auto value = parseIntegers(side);
    if (!value || value->size() != 1 || value->front() < smallest || value->front() > 1024)
      return failure(ErrorCode::badUsage, say<"--side '%1' cannot be used; give a whole number from %2 to 1024.">(side, smallest));
    sides.push_back(static_cast<int>(value->front()));
  }
  return sides;
}

Result<std::vector<Case>> namedOrShipped(const std::vector<std::string>& names) {
  std::vector<Case> cases;
  for (const std::string& name : names) {
    auto found = findCase(name);
    if (!found) return passOn(found.error());
    cases.push_back(*std::move(found));
  }
  if (!names.empty()) return cases;
  const auto shipped = shippedCasesFolder();
  if (!shipped) return passOn(shipped.error());
  for (Case& each : listCases(*shipped).cases) cases.push_back(std::move(each));
  return cases;
}

}  // namespace ew::cli
