#include "ew/io/json_files.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "ew/core/ending.h"
#include "ew/core/json_fields.h"
#include "ew/io/safe_file.h"

namespace ew {

namespace fs = std::filesystem;

Result<nlohmann::json> readJsonFile(const fs::path& file, const Message& where, std::size_t maxBytes) {
  const auto text = readTextFile(file, maxBytes);
  if (!text) return passOn(text.error());
  return parseJsonObject(*text, where);
}

Result<std::vector<fs::path>> jsonFilesIn(const fs::path& folder, const Message& what) {
  std::error_code problem;
  fs::directory_iterator entries(folder, problem);
  if (problem)
    return failure(ErrorCode::notFound, say<"The folder %1 with the %2 cannot be opened: %3.">(folder.string(), what, problem.message()),
                   {{"folder", folder.string()}});
  std::vector<fs::path> files;
  while (entries != fs::directory_iterator()) {
    if (hasEnding(entries->path(), ".json")) files.push_back(entries->path());
    entries.increment(problem);
    if (problem)
      return failure(ErrorCode::notReadable, say<"The folder %1 with the %2 cannot be read: %3.">(folder.string(), what, problem.message()),
                     {{"folder", folder.string()}});
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace ew
