#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
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
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

  ~StepStore();
  StepStore(StepStore&& other) noexcept;
  StepStore& operator=(StepStore&&) = delete;

 private:
  StepStore(std::filesystem::path folder, sdk::Files& files) : folder_(std::move(folder)), files_(&files) {}
  void clearLeftovers() const;

  std::filesystem::path folder_;
  sdk::Files* files_;
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
