#include "outputs.h"

#include <unistd.h>

#include <fcntl.h>
#include <algorithm>
#include <cerrno>
#include <cstring>

namespace ew::cli {
namespace fs = std::filesystem;
namespace {

std::string lowerEnding(const fs::path& file) {
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c); });
  return ending;
}

bool sameFile(const fs::path& a, const fs::path& b) {
  std::error_code ignored;
  if (fs::equivalent(a, b, ignored)) return true;
  return fs::weakly_canonical(a, ignored) == fs::weakly_canonical(b, ignored);
}

fs::path folderOf(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : fs::path("."); }

/// Asking for permissions answers for the wrong user on some file systems; making a file does not.
Result<void> tryToWriteIn(const fs::path& folder, const fs::path& probe, const fs::path& wanted) {
  const int handle = ::open(probe.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (handle < 0) {
    const std::string reason = std::strerror(errno);
    return failure(
        ErrorCode::notWritable,
        "Nothing can be written into the folder '" + folder.string() + "' (" + reason + "); choose another place for the output.",
        {{"file", wanted.string()}, {"reason", reason}});
  }
  ::close(handle);
  std::error_code ignored;
  fs::remove(probe, ignored);
  return {};
}

}  // namespace

Outputs::~Outputs() {
  if (committed_) return;
  std::error_code ignored;
  for (const auto& entry : entries_) {
    if (entry.staged != entry.target)
      fs::remove(entry.staged, ignored);
    else if (!entry.existedBefore) {
      fs::remove(entry.target, ignored);
      fs::remove(fs::path(entry.target).replace_extension(".raw"), ignored);
    }
  }
  for (const auto& folder : madeFolders_) fs::remove(folder, ignored);  // only when it is still empty
}

void Outputs::protect(const fs::path& input) { inputs_.push_back(input); }

Result<void> Outputs::announce(const fs::path& file, std::string_view endings) {
  if (file.empty()) return failure(ErrorCode::badUsage, "The name of an output is empty; give a file name.");
  const std::string ending = lowerEnding(file);
  if (!endings.empty() && (ending.empty() || (" " + std::string(endings) + " ").find(" " + ending + " ") == std::string::npos)) {
    std::string list(endings);
    for (auto at = list.find(' '); at != std::string::npos; at = list.find(' ', at + 4)) list.replace(at, 1, " or ");
    return failure(ErrorCode::badUsage, "The output '" + file.string() + "' must end in " + list + ".", {{"file", file.string()}});
  }
  for (const auto& input : inputs_)
    if (sameFile(file, input))
      return failure(ErrorCode::badUsage, "The output '" + file.string() + "' is also an input; give it another name.",
                     {{"file", file.string()}});
  for (const auto& entry : entries_)
    if (sameFile(file, entry.target))
      return failure(ErrorCode::badUsage, "The output '" + file.string() + "' is named twice; give each output its own name.",
                     {{"file", file.string()}});
  std::error_code problem;
  if (fs::is_directory(file, problem))
    return failure(ErrorCode::notWritable, "'" + file.string() + "' is a folder; give the name of a file to write.",
                   {{"file", file.string()}});
  if (fs::exists(file, problem) && !fs::is_regular_file(file, problem))  // renaming over a device would replace the device
    return failure(ErrorCode::notWritable, "'" + file.string() + "' is not an ordinary file; give the name of a file to write.",
                   {{"file", file.string()}});
  const fs::path target = fs::is_symlink(file, problem) ? fs::weakly_canonical(file, problem) : file;
  const fs::path folder = folderOf(target);
  if (!fs::is_directory(folder, problem))
    return failure(ErrorCode::notWritable,
                   "The folder '" + folder.string() + "' of the output does not exist; make it first or choose another place.",
                   {{"file", file.string()}});
  Entry entry;
  entry.given = file;
  entry.target = target;
  entry.existedBefore = fs::exists(file, problem);
  const fs::path aside =
      folder / (".ew-" + std::to_string(::getpid()) + "-" + std::to_string(entries_.size()) + "-" + target.filename().string());
  if (auto writable = tryToWriteIn(folder, aside, file); !writable) return writable;
  entry.staged = ending == ".mhd" ? target : aside;
  entries_.push_back(std::move(entry));
  return {};
}

Result<void> Outputs::announceFolder(const fs::path& folder) {
  std::error_code problem;
  const bool existed = fs::exists(folder, problem);
  fs::create_directories(folder, problem);
  if (!existed && !problem) madeFolders_.push_back(folder);
  if (problem || !fs::is_directory(folder, problem))
    return failure(ErrorCode::notWritable, "The folder '" + folder.string() + "' cannot be made; choose another place for the output.",
                   {{"file", folder.string()}});
  return tryToWriteIn(folder, folder / (".ew-" + std::to_string(::getpid()) + "-try"), folder);
}

fs::path Outputs::staged(const fs::path& file) const {
  for (const auto& entry : entries_)
    if (entry.given == file) return entry.staged;
  return file;
}

std::string Outputs::inGivenNames(std::string text) const {
  for (const auto& entry : entries_) {
    if (entry.staged == entry.target) continue;
    const std::pair<std::string, std::string> names[] = {{entry.staged.string(), entry.given.string()},
                                                         {entry.staged.filename().string(), entry.given.filename().string()}};
    for (const auto& [staged, given] : names)
      for (auto at = text.find(staged); at != std::string::npos; at = text.find(staged, at + given.size()))
        text.replace(at, staged.size(), given);
  }
  return text;
}

Result<void> Outputs::commit() {
  for (auto& entry : entries_) {
    if (entry.staged == entry.target) continue;
    std::error_code problem;
    if (!fs::exists(entry.staged, problem)) continue;
    fs::rename(entry.staged, entry.target, problem);
    if (!problem) entry.staged = entry.target;  // so that a later failure takes back what is new
    if (problem)
      return failure(
          ErrorCode::notWritable,
          "The output '" + entry.target.string() + "' could not be put in place (" + problem.message() + "); choose another place.",
          {{"file", entry.target.string()}});
  }
  committed_ = true;
  return {};
}

}  // namespace ew::cli
