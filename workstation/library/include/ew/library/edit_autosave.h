#pragma once

#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

#include "ew/core/fingerprint.h"
#include "ew/core/result.h"
#include "ew/io/own_folder.h"
#include "ew/library/case.h"

namespace ew {

/// Edits of a case that are not saved yet, kept where a crash does not take them. Every program that keeps something has a folder of its
/// own below `root`, and a lock on it for as long as it lives: what lies in a folder that nobody holds was left behind by one that ended
/// without saving or discarding it.
class EditAutosave {
 public:
  /// What a program left behind.
  struct Left {
    std::filesystem::path kept;        ///< the folder below `root`
    std::filesystem::path caseFolder;  ///< of the case that was edited
    nlohmann::json manifest;           ///< of the case with its edits
    Fingerprint asRead;                ///< of case.json, which the edits began with
    std::chrono::system_clock::time_point at;
  };

  /// @param root need not be there yet; nothing is made before something is kept
  explicit EditAutosave(std::filesystem::path root);
  ~EditAutosave();  ///< forgets: a program that ends in order has asked
  EditAutosave(const EditAutosave&) = delete;
  EditAutosave& operator=(const EditAutosave&) = delete;

  /// Keeps the case as it is now in place of what was kept before. @error notWritable
  [[nodiscard]] Result<void> keep(const Case& edited, const Fingerprint& asRead);
  void forget();

  [[nodiscard]] const std::filesystem::path& root() const { return own_.root(); }
  /// What other programs left behind, the latest first. What a running program keeps, and what cannot be read, is not among them.
  [[nodiscard]] std::vector<Left> left() const;
  /// Removes what somebody has decided about.
  static void remove(const Left& decided);

 private:
  OwnFolder own_;
};

}  // namespace ew
