#include "ew/core/pose.h"

#include <fstream>
#include <sstream>

#include "ew/core/numbers.h"

namespace ew {
namespace {
constexpr std::size_t kMostBytesOfPoses = 64u << 20;
}  // namespace

Result<std::vector<Pose>> parsePoses(std::string_view text) {
  std::vector<Pose> poses;
  std::istringstream lines{std::string(text)};
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    const auto first = line.find_first_not_of(" \t\r");
    if (first == std::string::npos || line[first] == '#') continue;
    const auto numbers = parseNumbers(line);
    if (!numbers || numbers->size() != 16)
      return failure(ErrorCode::badField,
                     numbers ? say<"Line %1 of the poses holds %2 numbers; a pose is 16 numbers, row by row.">(number, numbers->size())
                             : say<"Line %1 of the poses holds something that is not a number; a pose is 16 numbers, row by row.">(number),
                     {{"line", std::to_string(number)}});
    std::array<double, 16> rows{};
    std::copy(numbers->begin(), numbers->end(), rows.begin());
    Pose pose;
    pose.probeToWorld.matrix = matrixFromRows(rows);
    if (auto rigid = checkRigid(pose.probeToWorld.matrix); !rigid) {
      Error error = rigid.error();
      error.context.emplace_back("line", std::to_string(number));
      return passOn(std::move(error));
    }
    poses.push_back(pose);
  }
  if (poses.empty())
    return failure(ErrorCode::badField, say<"There is no pose; give 16 numbers, row by row, or a file with one pose a line.">());
  return poses;
}

Result<std::vector<Pose>> posesFromArgument(const std::string& argument) {
  if (parseNumbers(argument)) return parsePoses(argument);
  // Asked before it is opened: opening a pipe waits for whoever writes into it.
  std::error_code problem;
  if (const auto status = std::filesystem::status(argument, problem);
      std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    return failure(ErrorCode::notReadable, say<"'%1' is a folder, a pipe or a device; give a file with one pose a line.">(argument),
                   {{"file", argument}});
  std::ifstream file(argument);
  if (!file)
    return failure(ErrorCode::notFound,
                   say<"'%1' is neither 16 numbers nor a file that can be read; give the pose in one of these two ways.">(argument),
                   {{"file", argument}});
  // Read in pieces: what stands in the name's place may change, and a growing file has an old size.
  std::string text;
  std::string piece(64u << 10, '\0');
  while (file) {
    file.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    text.append(piece, 0, static_cast<std::size_t>(file.gcount()));
    if (text.size() > kMostBytesOfPoses)
      return failure(ErrorCode::tooLarge,
                     say<"'%1' has more than 64 MiB, which is too much for poses; check that it is the right file.">(argument),
                     {{"file", argument}});
  }
  if (file.bad())
    return failure(ErrorCode::notReadable, say<"'%1' cannot be read; give a file with one pose a line.">(argument), {{"file", argument}});
  return parsePoses(text);
}

}  // namespace ew
