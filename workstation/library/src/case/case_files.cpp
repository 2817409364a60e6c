#include <algorithm>
#include <set>
#include <string_view>

#include "case/manifest.h"
#include "case/outgoing_case.h"
#include "ew/library/checksums.h"
#include "files/guarded_case.h"

namespace ew {
namespace {

namespace fs = std::filesystem;

bool isUtf8(const std::string& text) {
  try {
    return !nlohmann::json(text).dump().empty();  // refuses what no document can hold
  } catch (const nlohmann::json::exception&) {
    return false;
  }
}

/// Names that differ in their capitals alone are one file on some systems.
std::string withoutCapitals(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

std::vector<std::string_view> partsOf(std::string_view path) {
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0;;) {
    const auto end = path.find('/', begin);
    parts.push_back(path.substr(begin, end - begin));
    if (end == std::string_view::npos) return parts;
    begin = end + 1;
  }
}

bool isHidden(const fs::path& name) { return name.string().starts_with('.'); }

tl::unexpected<Error> folderNotReadable(const fs::path& folder, const std::error_code& problem) {
  return failure(problem == std::errc::no_such_file_or_directory ? ErrorCode::notFound : ErrorCode::notReadable,
                 say<"The case folder '%1' cannot be read (%2); check that it is there and that you may open it.">(
                     folder, verbatim(problem.message())),
                 {{"file", folder.string()}});
}

tl::unexpected<Error> isNoFile(const fs::path& file, Message sentence) {
  return failure(ErrorCode::unsupported, std::move(sentence), {{"file", file.string()}});
}

/// Whether a link of the case folder leads to a regular file in it that is handed on, too, or would be under its own name.
bool staysInside(const fs::path& link, const fs::path& root) {
  std::error_code problem;
  const fs::path target = fs::canonical(link, problem);
  if (problem || !fs::is_regular_file(target, problem)) return false;
  return std::mismatch(root.begin(), root.end(), target.begin(), target.end()).first == root.end();
}

/// Everything that belongs to the case, with its size, in no order.
Result<std::vector<FileSum>> collect(const fs::path& folder) {
  std::error_code problem;
  const fs::path root = fs::canonical(folder, problem);
  if (problem) return folderNotReadable(folder, problem);
  std::vector<FileSum> files;
  fs::recursive_directory_iterator at(root, problem);
  for (; !problem && at != fs::recursive_directory_iterator(); at.increment(problem)) {
    const fs::path relative = at->path().lexically_relative(root);
    const auto type = at->symlink_status(problem).type();
    if (problem) break;
    if (isHidden(relative.filename())) {
      if (type == fs::file_type::directory) at.disable_recursion_pending();
      continue;
    }
    if (relative == kSumsName || type == fs::file_type::directory) continue;
    if (type == fs::file_type::symlink && !staysInside(at->path(), root))
      return isNoFile(
          at->path(),
          say<"\"%1\" in the case folder is a link that leads out of it, to a folder or to nothing; copy the file itself into the case "
              "folder.">(relative));
    if (type != fs::file_type::symlink && type != fs::file_type::regular)
      return isNoFile(at->path(), say<"\"%1\" in the case folder is neither a file nor a folder; take it out of there.">(relative));
    const auto size = fs::file_size(at->path(), problem);
    if (problem) break;
    files.push_back({.path = relative.generic_string(), .size_bytes = size, .sha256 = {}});
  }
  if (problem) return folderNotReadable(folder, problem);
  return files;
}

std::optional<std::string> neededHidden(const nlohmann::json& value, const fs::path& folder);

template <class Values>
std::optional<std::string> neededHiddenAmong(const Values& values, const fs::path& folder) {
  for (const auto& each : values)
    if (auto found = neededHidden(each, folder)) return found;
  return std::nullopt;
}

/// A file that the manifest names and that would be left behind because it is hidden.
std::optional<std::string> neededHidden(const nlohmann::json& value, const fs::path& folder) {
  if (value.is_structured()) return neededHiddenAmong(value, folder);
  if (!value.is_string()) return std::nullopt;
  const auto& text = value.get_ref<const std::string&>();
  if (text.size() > 4096 || text.find('\0') != std::string::npos) return std::nullopt;
  const auto parts = partsOf(text);
  const bool hidden = std::any_of(parts.begin(), parts.end(), [](auto part) { return part.size() > 1 && part[0] == '.' && part != ".."; });
  std::error_code ignored;
  if (hidden && !fs::path(text).is_absolute() && fs::is_regular_file(folder / text, ignored)) return text;
  return std::nullopt;
}

}  // namespace

std::optional<Message> problemOfPath(const std::string& path, const CaseFileLimits& limits) {
  if (path.empty()) return say<"it is empty">();
  if (path.front() == '/') return say<"it is an absolute path">();
  if (path.size() > limits.maxPath_bytes) return say<"it is longer than %1 bytes">(limits.maxPath_bytes);
  const auto isOdd = [](char c) { return (c >= 0 && c < ' ') || c == 127 || c == '\\'; };
  if (std::any_of(path.begin(), path.end(), isOdd) || !isUtf8(path)) return say<"it has characters that not every system knows in names">();
  const auto parts = partsOf(path);
  if (std::find(parts.begin(), parts.end(), "..") != parts.end()) return say<"it leads out of the case folder">();
  if (std::any_of(parts.begin(), parts.end(), [](auto part) { return part.empty() || part.front() == '.'; }))
    return say<"a part of it is empty or hidden">();
  if (withoutCapitals(path) == kSumsName) return say<"the library itself has a file of that name">();
  return std::nullopt;
}

Result<void> checkFileList(const std::vector<FileSum>& files, const Message& where, const CaseFileLimits& limits) {
  const auto refuse = [&](const std::string& path, Message reason) {
    std::string english = reason.english();
    return failure(ErrorCode::badField,
                   say<"%1 names the file \"%2\", which is refused (%3); rename the file, or, when it is not yours, do not use what "
                       "names it.">(where, path, std::move(reason)),
                   {{"file", path}, {"reason", std::move(english)}});
  };
  if (files.size() > limits.maxFiles)
    return failure(ErrorCode::tooLarge,
                   say<"%1 names %2 files, and more than %3 are not taken; divide the case.">(where, files.size(), limits.maxFiles));
  std::set<std::string> seen;
  std::uint64_t bytes = 0;
  for (const FileSum& each : files) {
    if (auto problem = problemOfPath(each.path, limits)) return refuse(each.path, std::move(*problem));
    if (!seen.insert(withoutCapitals(each.path)).second) return refuse(each.path, say<"another one has that name, but for capitals">());
    // Sizes come from a file that anybody may have written: their sum may not run over.
    if (each.size_bytes > limits.maxBytes - bytes)
      return failure(ErrorCode::tooLarge, say<"%1 names files of more than %2 MiB in all, and no more is taken; divide the case.">(
                                              where, limits.maxBytes >> 20));
    bytes += each.size_bytes;
  }
  for (const FileSum& each : files)
    for (auto slash = each.path.find('/'); slash != std::string::npos; slash = each.path.find('/', slash + 1))
      if (seen.contains(withoutCapitals(each.path.substr(0, slash))))
        return refuse(each.path, say<"another file has the name of its folder">());
  return {};
}

Result<std::vector<FileSum>> filesOfCase(const fs::path& folder) {
  return guardedCase(folder, [&]() -> Result<std::vector<FileSum>> {
    auto files = collect(folder);
    if (!files) return files;
    std::sort(files->begin(), files->end(), [](const FileSum& a, const FileSum& b) { return a.path < b.path; });
    if (auto good = checkFileList(*files, say<"The case folder '%1'">(folder)); !good) return passOn(good.error());
    return files;
  });
}

Result<void> checkNothingHiddenIsNeeded(const nlohmann::json& manifest, const fs::path& folder) {
  const auto hidden = neededHidden(manifest, folder);
  if (!hidden) return {};
  return failure(ErrorCode::badField,
                 say<"case.json names \"%1\", and hidden files are not handed on; give it a name without a dot in front, there and in the "
                     "case folder.">(*hidden),
                 {{"file", *hidden}});
}

}  // namespace ew
