#pragma once

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
#include <type_traits>
#include <utility>
#include <vector>

#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/sdk/host.h"

namespace ew::stitching {

/// What the steps of a chain leave in `folder`/steps. A result is NAME/KEY.json, written last, and files NAME/KEY-… beside it, each written
/// whole or not at all; so what lies there without its .json is no result, and a program killed at any moment leaves results or nothing.
/// Held by one program at a time.
class StepStore {
 public:
  /// Makes the folder and takes it; clears away what a killed run left half-written.
  /// @error notWritable (also while another program works in the folder)
  [[nodiscard]] static Result<StepStore> open(const std::filesystem::path& folder, sdk::Files& files);
  /// The same to look only: nothing is made or taken, and a folder that is not there is empty.
  [[nodiscard]] static StepStore peek(const std::filesystem::path& folder, sdk::Files& files);

  /// The data of a finished result, if it is there with all its files.
  [[nodiscard]] std::optional<nlohmann::json> find(const std::string& step, const std::string& key) const;
  /// Where a file of a result lies: steps/STEP/KEY-NAME.
  [[nodiscard]] std::filesystem::path fileOf(const std::string& step, const std::string& key, const std::string& name) const;
  /// Reads a file of a result that holds exactly `count` values: how large it may be is known from what it belongs to, so that no file is
  /// too large, and none that was damaged takes memory.
  /// @param into left as it is unless true is returned
  /// @return whether the file is there with exactly this size and was read
  template <class Value>
  [[nodiscard]] bool readValues(const std::string& step, const std::string& key, const std::string& name, std::size_t count,
                                std::vector<Value>& into) const {
    static_assert(std::is_trivially_copyable_v<Value>);
    if (bytesOf(step, key, name) != count * sizeof(Value)) return false;
    std::vector<Value> values(count);
    if (!readBytes(step, key, name, std::as_writable_bytes(std::span(values)))) return false;
    into = std::move(values);
    return true;
  }
  /// How large a file of a result is; nothing when it is not there.
  [[nodiscard]] std::optional<std::uintmax_t> bytesOf(const std::string& step, const std::string& key, const std::string& name) const;
  /// Makes room for the files of a result. @error notWritable
  [[nodiscard]] Result<void> prepare(const std::string& step) const;
  /// Declares a result finished. @param names of its files, which have been written
  /// @error notWritable
  [[nodiscard]] Result<void> keep(const std::string& step, const std::string& key, nlohmann::ordered_json data,
                                  const std::vector<std::string>& names = {}) const;
  /// Takes a result away, its .json first.
  void remove(const std::string& step, const std::string& key) const;
  /// Takes all results of a step away but these.
  void removeAllBut(const std::string& step, const std::vector<std::string>& keys) const;
  /// Notes that this run builds on a result without reading it; what it finds and keeps is noted anyway.
  void use(const std::string& step, const std::string& key) const;
  /// Takes away what earlier runs left and this one did not use, the longest unused first, until it takes no more than `keepBytes`. What
  /// this run used stays whatever it takes. Each result goes as a whole, so that a program killed meanwhile leaves results or nothing.
  /// Which finished run used what last is remembered in steps/uses.txt; lost, results are as good as new.
  /// @return what was freed
  std::uint64_t prune(std::uint64_t keepBytes) const;
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

  ~StepStore();
  StepStore(StepStore&& other) noexcept;
  StepStore& operator=(StepStore&&) = delete;

 private:
  /// Results of this run by name: "STEP/KEY".
  struct Uses {
    std::mutex guard;
    std::set<std::string> names;
  };
  StepStore(std::filesystem::path folder, sdk::Files& files)
      : folder_(std::move(folder)), files_(&files), uses_(std::make_unique<Uses>()) {}
  [[nodiscard]] std::map<std::string, std::uint64_t> bytesOfAll() const;
  void clearLeftovers() const;
  [[nodiscard]] bool readBytes(const std::string& step, const std::string& key, const std::string& name, std::span<std::byte> into) const;

  std::filesystem::path folder_;
  sdk::Files* files_;
  std::unique_ptr<Uses> uses_;
  int lock_ = -1;
};

/// The content of files by name, size and time of change; read again only when one of these changed.
class FileContents {
 public:
  explicit FileContents(const StepStore& store, sdk::Files& files);
  /// @return empty when the file cannot be opened
  /// @error notReadable, cancelled
  [[nodiscard]] Result<std::optional<std::string>> keyOf(const std::filesystem::path& file, Progress& progress);
  /// Remembers what was read. Without room nothing is remembered, and nothing is lost.
  void save();

 private:
  std::filesystem::path memory_;
  sdk::Files& files_;
  nlohmann::json known_;
  bool changed_ = false;
};

}  // namespace ew::stitching
