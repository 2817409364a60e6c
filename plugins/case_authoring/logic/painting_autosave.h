#pragma once

#include <filesystem>
#include <mutex>
#include <optional>
#include <string>

#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/core/volume.h"
#include "ew/io/own_folder.h"

namespace ew::case_authoring {

/// Painting that is not in its case yet, kept where a crash does not take it, as the library keeps edits of a case
/// (ew/library/edit_autosave.h). Each program has a folder of its own below `root` (OwnFolder).
class PaintingAutosave {
 public:
  struct Left {
    std::filesystem::path kept;        ///< the folder below `root`
    std::filesystem::path caseFolder;  ///< of the case that was painted in
    std::string labels;                ///< the file with the labels, relative to `kept`
    std::string before;                ///< what the case named as its labels then; may be empty
  };
  explicit PaintingAutosave(std::filesystem::path root);
  ~PaintingAutosave();  ///< forgets: a program that ends in order has asked
  PaintingAutosave(const PaintingAutosave&) = delete;
  PaintingAutosave& operator=(const PaintingAutosave&) = delete;

  /// Keeps these labels in place of those before: they are named once they are complete. May run on a worker.
  /// @error notWritable, cancelled
  [[nodiscard]] Result<void> keep(const Volume& labels, const std::filesystem::path& caseFolder, const std::string& before,
                                  Progress& progress);
  void forget();
  /// What was kept stays, as if the program had ended.
  void leave();
  [[nodiscard]] const std::filesystem::path& root() const { return own_.root(); }

  /// What another program left behind for a case, the latest; empty: nothing, or it cannot be read.
  [[nodiscard]] std::optional<Left> leftFor(const std::filesystem::path& caseFolder) const;
  [[nodiscard]] static Result<Volume> read(const Left& left, Progress& progress);
  static void remove(const Left& decided);

 private:
  OwnFolder own_;
  mutable std::mutex guard_;
};

}  // namespace ew::case_authoring
