#include "chain/file_contents.h"

#include <sys/stat.h>

#include <algorithm>
#include <system_error>

#include "ew/core/foreign_json.h"
#include "ew/io/content_key.h"
#include "ew/io/safe_file.h"
#include "ew/io/step_store.h"
#include "ew/stitching/value_json.h"

namespace ew::stitching {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* kFiles = "files";
constexpr const char* kContent = "content";

std::string nameOfAll(const json& files) { return ContentKey().add(files.dump(-1, ' ', false, json::error_handler_t::replace)).text(); }

}  // namespace

FileContents::FileContents(const fs::path& folder) : memory_(folder / "steps" / "inputs.json") {
  std::error_code ignored;
  if (!fs::exists(fs::symlink_status(memory_, ignored))) return;
  const auto text = fs::is_regular_file(memory_, ignored) ? readTextFile(memory_) : Result<std::string>(std::string());
  if (!text || !isMarkedAsOwn(*text)) {
    isForeign_ = true;
    return;
  }
  json read = jsonOrNull(*text);
  if (!memberOf(read, kFiles).is_object()) return;
  if (textAt(read, kContent) == nameOfAll(read[kFiles])) known_ = std::move(read[kFiles]);  // else it was damaged
}

Result<std::optional<std::string>> FileContents::keyOf(const fs::path& file, const Progress& progress) {
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0) return std::optional<std::string>();
  std::error_code ignored;
  const std::string name = fs::absolute(file, ignored).lexically_normal().string();
  const json stamp = {status.st_size, status.st_mtim.tv_sec, status.st_mtim.tv_nsec, status.st_ino};
  if (const auto at = known_.find(name); at != known_.end() && memberOf(*at, "stamp") == stamp && memberOf(*at, kContent).is_string())
    return std::optional(textAt(*at, kContent));
  auto content = contentOf(file, progress);
  if (!content || !*content) return content;
  known_[name] = {{"stamp", stamp}, {kContent, **content}};
  changed_ = true;
  return content;
}

void FileContents::save() {
  if (!changed_ || isForeign_) return;
  const json all = {{kOwnMark, kOwner}, {kContent, nameOfAll(known_)}, {kFiles, known_}};
  static_cast<void>(writeFileSafely(memory_, all.dump(1, ' ', false, json::error_handler_t::replace) + "\n"));
  changed_ = false;
}

}  // namespace ew::stitching
