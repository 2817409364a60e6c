#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "ew/core/result.h"
#include "ew/library/case.h"

namespace ew::cli {

// Options that several benches have: each is worded once, and where `bench all` runs them all it is asked once.

void addSides(CLI::App& app, std::vector<std::string>& sides);
void addFrameSize(CLI::App& app, glm::ivec2& size_px);
void addPoses(CLI::App& app, std::optional<int>& poses);
void addDrawSeed(CLI::App& app, std::uint64_t& seed);
void addRepetitions(CLI::App& app, std::optional<int>& repetitions);
void addNoPeers(CLI::App& app, bool& noPeers);

/// The sides that were given, or the usual ones. @error badUsage (no whole number from `smallest` to 1024)
[[nodiscard]] Result<std::vector<int>> sidesOf(const std::vector<std::string>& given, std::vector<int> usual, int smallest);

/// The cases that were named, or every shipped one. @error as findCase, shippedCasesFolder
[[nodiscard]] Result<std::vector<Case>> namedOrShipped(const std::vector<std::string>& names);

}  // namespace ew::cli
