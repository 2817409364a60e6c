#include "ew/stitching/result_files.h"

#include <sys/stat.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>
#include <system_error>

#include "chain/chain_inputs.h"
#include "ew/core/foreign_json.h"
#include "ew/core/output_set.h"
#include "ew/io/content_key.h"
#include "ew/io/safe_file.h"
#include "ew/stitching/chain.h"
#include "ew/stitching/value_json.h"

namespace ew::stitching {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using nlohmann::ordered_json;

tl::unexpected<Error> cannotWrite(const fs::path& file, const Message& reason) {
  return failure(ErrorCode::notWritable, say<"'%1' cannot be written (%2); choose another folder.">(file, reason),
                 {{"file", file.string()}});
}

tl::unexpected<Error> isForeign(const fs::path& file) {
  return failure(ErrorCode::notWritable,
                 say<"'%1' is not a result that was written here before, and would be lost; move it away or choose another folder.">(file),
                 {{"file", file.string()}});
}

/// Of a provenance: what it says was written beside it. Empty: it is none of this program.
std::optional<std::vector<ResultFile>> filesOfProvenance(const std::string& text) {
  const json read = jsonOrNull(text);
  const std::string madeBy = textAt(read, "made_by");
  if (!read.contains("files") || !madeBy.starts_with("EchoWeave") || !madeBy.ends_with(", stitch")) return std::nullopt;
  return resultFilesFrom(read["files"]);
}

}  // namespace

Result<ResultFiles::Seen> ResultFiles::seenAt(const fs::path& file, const std::vector<ResultFile>& known, const Progress& progress) {
  Seen seen;
  struct stat status {};
  if (::lstat(file.c_str(), &status) != 0) return seen;
  seen.isThere = true;
  seen.changed_ns = std::int64_t{1000000000} * status.st_mtim.tv_sec + status.st_mtim.tv_nsec;
  if (!S_ISREG(status.st_mode)) return seen;  // a folder, or a link to who knows what: it holds nothing of this program
  seen.bytes = static_cast<std::uintmax_t>(status.st_size);
  // Of another size than anything that was written it is somebody else's, whatever it holds.
  const std::string name = file.filename().string();
  if (std::none_of(known.begin(), known.end(), [&](const ResultFile& each) { return each.name == name && each.bytes == seen.bytes; }))
    return seen;
  auto content = ew::contentOf(file, progress);
  if (!content) return passOn(content.error());
  seen.content = content->value_or(std::string());
  return seen;
}

Result<ResultFiles> ResultFiles::look(const fs::path& folder, const std::vector<ResultFile>& written, const Progress& progress) {
  ResultFiles found;
  found.folder_ = folder;
  std::vector<ResultFile> known = written;
  bool isProvenanceOwn = false;
  std::error_code ignored;
  if (fs::symlink_status(folder / kProvenance, ignored).type() == fs::file_type::regular)
    if (const auto text = readTextFile(folder / kProvenance))
      if (const auto named = filesOfProvenance(*text)) {
        isProvenanceOwn = true;
        known.insert(known.end(), named->begin(), named->end());
      }
  for (const char* name : kNames) {
    auto seen = seenAt(folder / name, known, progress);
    if (!seen) return passOn(seen.error());
    seen->isOwn =
        (std::string_view(name) == kProvenance && isProvenanceOwn) || std::any_of(known.begin(), known.end(), [&](const ResultFile& file) {
          if (file.name != name || seen->content.empty() || file.bytes != seen->bytes) return false;
          return file.content == seen->content || (file.changed_ns != 0 && file.changed_ns == seen->changed_ns);
        });
    found.seen_[name] = std::move(*seen);
  }
  return found;
}

std::vector<std::string> ResultFiles::foreign() const {
  std::vector<std::string> names;
  for (const char* name : kNames)
    if (const Seen& seen = seen_.at(name); seen.isThere && !seen.isOwn) names.emplace_back(name);
  return names;
}

Result<void> ResultFiles::checkOwn() const {
  if (const auto names = foreign(); !names.empty()) return isForeign(folder_ / names.front());
  return {};
}

std::string ResultFiles::contentOf(const std::string& name) const {
  const auto at = seen_.find(name);
  return at == seen_.end() ? std::string() : at->second.content;
}

Result<void> ResultFiles::checkUnchanged(const char* name) const {
  const Seen& before = seen_.at(name);
  struct stat status {};
  const bool isThere = ::lstat((folder_ / name).c_str(), &status) == 0;
  const std::int64_t changed_ns = std::int64_t{1000000000} * status.st_mtim.tv_sec + status.st_mtim.tv_nsec;
  if (isThere && (!before.isThere || changed_ns != before.changed_ns)) return isForeign(folder_ / name);
  return {};
}

Result<void> ResultFiles::publish(const Waiting& waiting, const Waiting& aside, bool replaceForeign) const {
  std::error_code error;
  std::vector<const char*> names;  // that wait
  for (const char* name : kNames)
    if (fs::exists(waiting(name), error)) names.push_back(name);
  for (const char* name : names) {
    if (seen_.at(name).isThere && !seen_.at(name).isOwn && !replaceForeign) return isForeign(folder_ / name);
    if (auto unchanged = checkUnchanged(name); !unchanged) return unchanged;
  }
  // The provenance goes first and comes last: with it the others belong together, whenever the program is stopped.
  std::vector<const char*> away, in;
  const auto takeBack = [&] {
    std::error_code ignored;
    for (const char* name : in) fs::rename(folder_ / name, waiting(name), ignored);
    for (const char* name : away) fs::rename(aside(name), folder_ / name, ignored);
  };
  for (auto name = names.rbegin(); name != names.rend(); ++name) {
    if (!fs::exists(fs::symlink_status(folder_ / *name, error))) continue;
    fs::rename(folder_ / *name, aside(*name), error);
    if (error) {
      const Message reason = verbatim(error.message());
      takeBack();
      return cannotWrite(folder_ / *name, reason);
    }
    away.push_back(*name);
  }
  for (const char* name : names) {
    fs::rename(waiting(name), folder_ / name, error);
    if (error) {
      const Message reason = verbatim(error.message());
      takeBack();
      return cannotWrite(folder_ / name, reason);
    }
    in.push_back(name);
  }
  for (const char* name : kNames) fs::remove_all(aside(name), error);  // also what a killed run left of it
  return {};
}

fs::path waitingFile(const StepStore& store, const std::string& key, const char* name) {
  return store.fileOf(nameOf(Step::volume), key, name);
}

Result<void> putInPlace(const WaitingResult& result, const StepStore& store) {
  const auto waiting = [&](const char* name) { return waitingFile(store, result.key, name); };
  const auto aside = [&](const char* name) { return waitingFile(store, result.key, (std::string("earlier-") + name).c_str()); };
  if (auto moved = result.files.publish(waiting, aside, result.mayReplaceForeign); !moved) return moved;
  store.removeAllBut(nameOf(Step::volume), {result.key});
  store.removeAllBut(ChainInputs::kStep, result.sweeps);
  return {};
}

Result<void> checkNoInputIsOutput(const StitchProject& project, const fs::path& folder) {
  std::error_code ignored;
  const fs::path steps = fs::weakly_canonical(folder / "steps", ignored);
  for (const ProjectVolume& volume : project.volumes)
    for (const fs::path& file : {volume.file, volume.coverage, volume.confidence, volume.calibration}) {
      if (file.empty()) continue;
      for (const char* name : ResultFiles::kNames)
        if (fs::equivalent(file, folder / name, ignored))
          return failure(ErrorCode::badUsage,
                         say<"'%1' is read by this project and would be written over by its result; choose another folder.">(file),
                         {{"file", file.string()}});
      const fs::path relative = fs::weakly_canonical(file, ignored).lexically_relative(steps);
      if (!relative.empty() && *relative.begin() != "..")
        return failure(ErrorCode::badUsage,
                       say<"'%1' lies among the intermediate results of '%2', which come and go; copy it to a place of its own or choose "
                           "another folder.">(file, folder),
                       {{"file", file.string()}});
    }
  return {};
}

Result<std::vector<ResultFile>> resultFilesAt(const std::vector<const char*>& names, const ResultFiles::Waiting& at) {
  std::vector<ResultFile> found;
  for (const char* name : names) {
    struct stat status {};
    const fs::path file = at(name);
    if (::stat(file.c_str(), &status) != 0) return cannotWrite(file, say<"what was just written is gone">());
    auto content = contentOf(file, noProgress());
    if (!content) return passOn(content.error());
    found.push_back({name, static_cast<std::uintmax_t>(status.st_size), content->value_or(std::string()),
                     std::int64_t{1000000000} * status.st_mtim.tv_sec + status.st_mtim.tv_nsec});
  }
  return found;
}

ordered_json jsonOf(const std::vector<ResultFile>& files) {
  ordered_json list = ordered_json::array();
  for (const ResultFile& file : files) {
    list.push_back({{"name", file.name}, {"bytes", file.bytes}, {"content", file.content}});
    if (file.changed_ns != 0) list.back()["changed_ns"] = file.changed_ns;
  }
  return list;
}

std::vector<ResultFile> resultFilesFrom(const json& list) {
  try {
    std::vector<ResultFile> files;
    for (const auto& each : list)
      files.push_back({each.at("name").get<std::string>(), each.at("bytes").get<std::uintmax_t>(), each.at("content").get<std::string>(),
                       each.value("changed_ns", std::int64_t{0})});
    return files;
  } catch (const json::exception&) {
    return {};
  }
}

std::vector<ResultFile> resultFilesIn(const StepStore& store) {
  std::vector<ResultFile> all;
  for (const json& data : store.all(nameOf(Step::volume))) {
    if (!data.is_object() || !data.contains("results")) continue;
    const auto files = resultFilesFrom(data["results"]);
    all.insert(all.end(), files.begin(), files.end());
  }
  return all;
}

Result<void> copyResult(const ResultPaths& result, const StitchProject& project, const fs::path& folder, bool replaceForeign,
                        Progress& progress) {
  if (auto free = checkNoInputIsOutput(project, folder); !free) return free;
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return cannotWrite(folder, verbatim(error.message()));
  const auto seen = ResultFiles::look(folder, {}, progress);
  if (!seen) return passOn(seen.error());
  if (!replaceForeign)
    if (auto own = seen->checkOwn(); !own) return own;
  OutputSet outputs;
  for (std::size_t n = 0; n < result.size(); ++n)
    if (!result[n].empty())
      if (auto announced = outputs.announce(folder / ResultFiles::kNames[n]); !announced) return announced;
  for (std::size_t n = 0; n < result.size(); ++n) {
    if (result[n].empty()) continue;
    if (progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"Saving was cancelled.">());
    const fs::path target = folder / ResultFiles::kNames[n];
    fs::copy_file(result[n], outputs.staged(target), error);
    if (error) return cannotWrite(target, verbatim(error.message()));
    progress.report(say<"Copying">(), static_cast<double>(n + 1) / static_cast<double>(result.size()));
  }
  return outputs.commit();
}

}  // namespace ew::stitching
