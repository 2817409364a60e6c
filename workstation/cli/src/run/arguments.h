#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ew/core/pose.h"
#include "ew/core/result.h"

namespace ew::cli {

// CLI11 reads numbers with the C library, which follows the user's locale; these read them in the C locale, always.

struct Range {
  double lowest;
  double highest;
};

/// `--name 0.5`: a number within the range, both ends included.
CLI::Option& addNumber(CLI::App& app, const std::string& name, double& target, Range range, const std::string& description);
CLI::Option& addNumber(CLI::App& app, const std::string& name, std::optional<double>& target, Range range, const std::string& description);
/// `--name 3`: a whole number within the range.
CLI::Option& addCount(CLI::App& app, const std::string& name, int& target, int lowest, int highest, const std::string& description);
CLI::Option& addCount(CLI::App& app, const std::string& name, std::optional<int>& target, int lowest, int highest,
                      const std::string& description);
/// A whole number from 0 to 2^64 - 1.
CLI::Option& addSeed(CLI::App& app, const std::string& name, std::uint64_t& target, const std::string& description);
/// `--name 640x480`.
CLI::Option& addSize(CLI::App& app, const std::string& name, glm::ivec2& target, const std::string& description);
/// `--name A B C`, as several words or as one.
CLI::Option& addNumberList(CLI::App& app, const std::string& name, std::optional<std::vector<double>>& target, std::size_t count,
                           const std::string& valueNames, const std::string& description);

/// Joins what the parser would take apart: the numbers of a list after its option, and a value that starts with a minus sign.
/// `--clip 0 0 739 593` becomes `--clip=0 0 739 593`.
[[nodiscard]] std::vector<std::string> joinNumberLists(std::span<const std::string> args);

/// The poses of `--pose`. @error badUsage (numbers on the line that are not 16), otherwise as posesFromArgument
[[nodiscard]] Result<std::vector<Pose>> posesOf(const std::string& argument);

/// `out.png` itself for one image; `out_0000.png`, `out_0001.png` … for several.
[[nodiscard]] std::filesystem::path numbered(const std::filesystem::path& file, std::size_t index, std::size_t count);

/// "1 frame", "3 frames".
[[nodiscard]] std::string counted(std::size_t count, std::string_view noun);
/// With a few digits, in the C locale: "12.3".
[[nodiscard]] std::string rounded(double value, int digits);

}  // namespace ew::cli
