#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "ew/io/step_store.h"
#include "ew/stitching/project.h"

namespace ew::stitching {

/// A file of a result as it was when it was written. Read back later, `content` says whether it still is that file; where it is not,
/// `changed_ns` tells a medium that lost something (the same time) from somebody who wrote a file of his own (another one).
struct ResultFile {
  std::string name;
  std::uintmax_t bytes = 0;
  std::string content;          ///< content_key.h
  std::int64_t changed_ns = 0;  ///< since the epoch of files; 0: not known
};

/// The files of a result: volume, coverage, source, level (imaging/tissue_level.h), provenance. One that is not there has no path.
using ResultPaths = std::array<std::filesystem::path, 5>;

/// The files of a result in a folder that may hold other people's files as well. What lies there under one of their names and was not
/// written by this program is never touched, and neither is what the project reads.
class ResultFiles {
 public:
  /// Volumes first; the provenance belongs to them and names them.
  static constexpr std::array<const char*, 5> kNames = {"volume.mha", "coverage.mha", "source.mha", "level.mha", "provenance.json"};
  static constexpr const char* kProvenance = kNames.back();

  /// Where a file of a result waits for its place: of the same file system as the folder.
  using Waiting = std::function<std::filesystem::path(const char* name)>;

  /// Looks; nothing is written.
  /// @param written by earlier runs, as far as it is remembered elsewhere than in the folder's own provenance
  /// @error notReadable, cancelled
  [[nodiscard]] static Result<ResultFiles> look(const std::filesystem::path& folder, const std::vector<ResultFile>& written,
                                                const Progress& progress);

  /// Names that somebody else's files have.
  [[nodiscard]] std::vector<std::string> foreign() const;
  /// @error notWritable: somebody else's file has one of the names
  [[nodiscard]] Result<void> checkOwn() const;
  /// What a file of the folder holds (content_key.h); empty: it is not there, or of a size that was never written.
  [[nodiscard]] std::string contentOf(const std::string& name) const;

  /// Moves the files that wait to their places, all or none: what was there comes back when one of them cannot be moved.
  /// @param aside where what lies there goes meanwhile, of the same file system
  /// @param replaceForeign somebody was asked and wants it
  /// @error notWritable, also when a file came or changed since look()
  [[nodiscard]] Result<void> publish(const Waiting& waiting, const Waiting& aside, bool replaceForeign = false) const;

 private:
  struct Seen {
    bool isThere = false;
    bool isOwn = false;
    std::uintmax_t bytes = 0;
    std::int64_t changed_ns = 0;
    std::string content;
  };
  [[nodiscard]] static Result<Seen> seenAt(const std::filesystem::path& file, const std::vector<ResultFile>& known,
                                           const Progress& progress);
  [[nodiscard]] Result<void> checkUnchanged(const char* name) const;

  std::filesystem::path folder_;
  std::map<std::string, Seen> seen_;
};

/// A finished result that lies in the store under its key.
struct WaitingResult {
  ResultFiles files;
  std::string key;
  bool mayReplaceForeign = false;
  std::vector<std::string> sweeps;  ///< keys of those the project names
};

/// Where a file of a result waits in the store.
[[nodiscard]] std::filesystem::path waitingFile(const StepStore& store, const std::string& key, const char* name);

/// Moves a result to its names, and takes what it leaves behind: results before it, and sweeps the project no longer names. A result that
/// was half moved goes on. @error as ResultFiles::publish
[[nodiscard]] Result<void> putInPlace(const WaitingResult& result, const StepStore& store);

/// Nothing that the project reads would be written over or cleared away by its results in `folder`.
/// @error badUsage, naming the file
[[nodiscard]] Result<void> checkNoInputIsOutput(const StitchProject& project, const std::filesystem::path& folder);

/// What is written down of files, each under its name.
/// @error notWritable: one of them is not there
[[nodiscard]] Result<std::vector<ResultFile>> resultFilesAt(const std::vector<const char*>& names, const ResultFiles::Waiting& at);
[[nodiscard]] nlohmann::ordered_json jsonOf(const std::vector<ResultFile>& files);
/// Empty when it is no such list.
[[nodiscard]] std::vector<ResultFile> resultFilesFrom(const nlohmann::json& list);
/// What earlier runs wrote, as the store remembers it.
[[nodiscard]] std::vector<ResultFile> resultFilesIn(const StepStore& store);

/// Copies a finished result (its volumes and its provenance; an empty path is left out) into another folder: synced beside their places,
/// then moved there together.
/// @param replaceForeign somebody was asked and wants files of these names replaced that this program did not write
/// @error notWritable, cancelled, badUsage (checkNoInputIsOutput)
[[nodiscard]] Result<void> copyResult(const ResultPaths& result, const StitchProject& project, const std::filesystem::path& folder,
                                      bool replaceForeign, Progress& progress);

}  // namespace ew::stitching
