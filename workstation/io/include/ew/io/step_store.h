#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "ew/core/large_pages.h"
#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/io/file_lock.h"

namespace ew {

/// How files in FOLDER/steps that belong to no result say whose they are; they have names that others use too.
inline constexpr const char* kOwnMark = "#made_by";  ///< field of a JSON object, in front of all others
inline constexpr const char* kOwner = "EchoWeave";
[[nodiscard]] bool isMarkedAsOwn(std::string_view text);

/// What steps of some work leave in `folder`/steps. A result is STEP/KEY.json, written last, and files STEP/KEY-… beside it, each written
/// whole or not at all; so what lies there without its .json is no result, and a program killed at any moment leaves results or nothing.
/// STEP is one of the names given, KEY 32 hexadecimal digits (content_key.h); what is called otherwise belongs to somebody else and is left
/// alone. A result is believed when its .json and, once they are read, its files hold what was kept, by their content.
class StepStore {
 public:
  /// Makes the folder and takes it for one program; clears away what a killed run left half-written.
  /// @param steps names of the folders below `folder`/steps
  /// @error notWritable (also while another program works in the folder)
  [[nodiscard]] static Result<StepStore> open(const std::filesystem::path& folder, const std::vector<std::string>& steps);
  /// The same for several programs at a time: whoever makes a result holds its lock meanwhile (lock()). Results that are found remember
  /// when that was (removeUnused()). @error notWritable (also while a program has the folder for itself)
  [[nodiscard]] static Result<StepStore> share(const std::filesystem::path& folder, const std::vector<std::string>& steps);
  /// The same to look only: nothing is made or taken, and a folder that is not there is empty.
  [[nodiscard]] static StepStore peek(const std::filesystem::path& folder, const std::vector<std::string>& steps);

  /// The lock of a result in a shared folder. @error notWritable, cancelled
  [[nodiscard]] Result<FileLock> lock(const std::string& step, const std::string& key, const Message& waiting, Progress& progress) const;
  /// Takes away what was not used for so long, and files without a result; what somebody holds the lock of stays.
  void removeUnused(std::chrono::seconds unusedFor) const;

  /// The data of a finished result, if it is there undamaged with all its files, which have the sizes they had.
  [[nodiscard]] std::optional<nlohmann::json> find(const std::string& step, const std::string& key) const;
  /// Whether something lies there as a result, which find() may refuse because it is damaged.
  [[nodiscard]] bool claims(const std::string& step, const std::string& key) const;
  /// Where a file of a result lies: steps/STEP/KEY-NAME.
  [[nodiscard]] std::filesystem::path fileOf(const std::string& step, const std::string& key, const std::string& name) const;
  /// Whether a file of a result that was found or kept holds what it held then. The file is read for it, once in the life of this store.
  [[nodiscard]] bool isSound(const std::string& step, const std::string& key, const std::string& name) const;
  /// Reads a file of a result that was found or kept and holds exactly `count` values: how large it may be is known from what it belongs
  /// to, so that no file is too large, and none that was damaged takes memory.
  /// @param into left as it is unless true is returned
  /// @return whether the file is there with exactly this size, was read, and holds what was kept
  template <class Value>
  [[nodiscard]] bool readValues(const std::string& step, const std::string& key, const std::string& name, std::size_t count,
                                std::vector<Value>& into) const {
    static_assert(std::is_trivially_copyable_v<Value>);
    if (bytesOf(step, key, name) != count * sizeof(Value)) return false;
    auto values = zerosInLargePages<Value>(count);
    if (!readBytes(step, key, name, std::as_writable_bytes(std::span(values)))) return false;
    into = std::move(values);
    return true;
  }
  /// How large a file of a result is; nothing when it is not there.
  [[nodiscard]] std::optional<std::uintmax_t> bytesOf(const std::string& step, const std::string& key, const std::string& name) const;
  /// Makes room for the files of a result. @error notWritable
  [[nodiscard]] Result<void> prepare(const std::string& step) const;
  /// Declares a result finished. @param names of its files, which have been written and are read for their content
  /// @error notWritable
  [[nodiscard]] Result<void> keep(const std::string& step, const std::string& key, nlohmann::ordered_json data,
                                  const std::vector<std::string>& names = {}) const;
  /// Takes a result away, its .json first.
  void remove(const std::string& step, const std::string& key) const;
  /// Takes all results of a step away but these.
  void removeAllBut(const std::string& step, const std::vector<std::string>& keys) const;
  /// Notes that this run builds on a result without reading it; what it finds and keeps is noted anyway.
  void use(const std::string& step, const std::string& key) const;
  /// The data of all results of a step, in no order.
  [[nodiscard]] std::vector<nlohmann::json> all(const std::string& step) const;
  /// Takes away what earlier runs left and this one did not use, the longest unused first, until it takes no more than `keepBytes`. What
  /// this run used stays whatever it takes. Each result goes as a whole, so that a program killed meanwhile leaves results or nothing.
  /// Which finished run used what last is remembered in steps/uses.txt; lost, results are as good as new.
  /// @return what was freed
  std::uint64_t prune(std::uint64_t keepBytes) const;
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

 private:
  struct Content {
    std::string key;
    bool seen = false;  ///< that the file holds it
  };
  /// What this run knows.
  struct Known {
    std::mutex guard;
    std::set<std::string> used;               ///< results by name: "STEP/KEY"
    std::map<std::string, Content> contents;  ///< of files by path: what was kept
  };
  StepStore(std::filesystem::path folder, std::vector<std::string> steps)
      : folder_(std::move(folder)), steps_(std::move(steps)), known_(std::make_unique<Known>()) {}
  [[nodiscard]] Result<void> takeFolder(FileLock::Kind kind);
  [[nodiscard]] std::filesystem::path lockOf(const std::string& step, const std::string& key) const;
  [[nodiscard]] std::map<std::string, std::uint64_t> bytesOfAll() const;
  void clearLeftovers() const;
  [[nodiscard]] std::vector<std::string> keysOf(const std::string& step) const;
  [[nodiscard]] std::optional<nlohmann::json> entryOf(const std::string& step, const std::string& key) const;
  void promise(const std::filesystem::path& file, const std::string& content) const;
  [[nodiscard]] std::string promised(const std::filesystem::path& file) const;
  [[nodiscard]] bool readBytes(const std::string& step, const std::string& key, const std::string& name, std::span<std::byte> into) const;

  std::filesystem::path folder_;
  std::vector<std::string> steps_;
  std::unique_ptr<Known> known_;
  std::optional<FileLock> lock_;  ///< of the folder
  bool isShared_ = false;
};

}  // namespace ew
