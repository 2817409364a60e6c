#include "run/input_files.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "ew/core/ending.h"
#include "ew/core/foreign_json.h"
#include "ew/core/output_set.h"
#include "ew/io/safe_file.h"
#include "ew/io/volume_file.h"

namespace ew::cli {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::size_t kMostJson_bytes = 16u << 20;
constexpr std::size_t kMostFiles = 20000;

bool isFile(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

std::vector<fs::path> imagesIn(const fs::path& folder) {
  std::vector<fs::path> images;
  std::error_code problem;
  for (fs::directory_iterator at(folder, problem), end; !problem && at != end && images.size() < kMostFiles; at.increment(problem)) {
    const std::string ending = endingOf(at->path());
    if (ending == ".png" || ending == ".jpg" || ending == ".jpeg" || ending == ".pgm") images.push_back(at->path());
  }
  return images;
}

/// Walks what files name, each once.
class Walk {
 public:
  void take(const fs::path& file) {
    if (files.size() >= kMostFiles || std::find(files.begin(), files.end(), file) != files.end()) return;
    files.push_back(file);
    const std::string ending = endingOf(file);
    if (ending == ".json") takeNamedByJson(file);
    if (ending != ".mhd" && ending != ".nhdr") return;
    if (const auto header = readVolumeHeader(file)) files.insert(files.end(), header->files.begin(), header->files.end());
  }

  std::vector<fs::path> files;

 private:
  void takeNamedByJson(const fs::path& file) {
    const auto text = readTextFile(file, kMostJson_bytes);
    if (text) takeNamedIn(jsonOrNull(*text), file.parent_path());
  }

  void takeNamedIn(const json& value, const fs::path& folder) {
    if (value.is_string()) {
      const fs::path named = value.get_ref<const std::string&>();
      if (named.has_filename() && isFile(folder / named)) take(folder / named);
    }
    if (value.is_structured())
      for (const auto& each : value) takeNamedIn(each, folder);
  }
};

}  // namespace

std::vector<fs::path> filesBehind(const fs::path& input) {
  std::error_code ignored;
  Walk walk;
  if (input.empty()) return {};
  if (!fs::is_directory(input, ignored)) {
    walk.take(input);
  } else if (isFile(input / "case.json")) {
    walk.take(input / "case.json");
  } else {
    walk.files = imagesIn(input);
  }
  return walk.files;
}

Result<void> checkSamplesAreItsOwn(const fs::path& output) {
  std::error_code ignored;
  const auto files = filesNamedBy(output);
  if (files.size() < 2 || !fs::exists(fs::symlink_status(files.front(), ignored))) return {};
  if (const auto header = readVolumeHeader(output))
    for (const auto& file : header->files)
      if (fs::equivalent(file, files.front(), ignored)) return {};
  return failure(ErrorCode::badUsage,
                 say<"'%1' would write its voxels over '%2', which is there already and is not its own; give the output another name or "
                     "move that file away.">(output.string(), files.front().string()),
                 {{"file", files.front().string()}});
}

}  // namespace ew::cli
