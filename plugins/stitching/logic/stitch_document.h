#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ew/core/history.h"
#include "ew/sdk/host.h"
#include "ew/stitching/project.h"

namespace ew::stitching {

// Edits: each takes a project and gives the next one. Indices of volumes are those of the project given; what names a volume by its index
// (pairs, strokes) follows when volumes move or go. @error is none: an index outside changes nothing.
[[nodiscard]] StitchProject withVolumes(StitchProject project, std::vector<ProjectVolume> added);  ///< names made unique
[[nodiscard]] StitchProject withoutVolume(StitchProject project, std::size_t volume);
[[nodiscard]] StitchProject withVolumeMoved(StitchProject project, std::size_t from, std::size_t to);
[[nodiscard]] StitchProject withPlace(StitchProject project, std::size_t volume, const Transform<frame::World, frame::View>& toWorld,
                                      Placement placement);
/// The pair as the project has it, or as nobody has said anything about it. @param fixed, moving different; the smaller is the fixed one
[[nodiscard]] ProjectPair pairOf(const StitchProject& project, std::size_t fixed, std::size_t moving);
/// The same pair with its volumes in the other roles.
[[nodiscard]] ProjectPair swapped(ProjectPair pair);
/// With this pair in place of what was said about it before; nothing said: the pair is left out of the project.
[[nodiscard]] StitchProject withPair(StitchProject project, const ProjectPair& pair);
[[nodiscard]] StitchProject withStroke(StitchProject project, const SeamStroke& stroke);

/// Why a name cannot be given to a volume, or empty: names are not empty and unique.
[[nodiscard]] std::optional<Error> problemOfName(const StitchProject& project, std::size_t volume, const std::string& name);

/// "A" … "Z", "AA" …: what a volume is called in a graph.
[[nodiscard]] std::string letterOf(std::size_t volume);

/// A stitch project that is being edited: with undo and redo of every edit, and a recovery file that follows it, so that closing the
/// program or a crash loses nothing. It never holds what was found, only what was asked for.
class StitchDocument {
 public:
  /// @param recovery file that holds an unsaved project; its folder is made when it is needed
  StitchDocument(sdk::Files& files, std::filesystem::path recovery);

  [[nodiscard]] const StitchProject& project() const { return states_.now(); }
  [[nodiscard]] const std::filesystem::path& file() const { return file_; }  ///< empty: never saved
  [[nodiscard]] bool hasUnsavedChanges() const { return !(project() == saved_); }

  /// Replaces the project as one step called `what`. Steps with the same non-empty mergeKey in a row become one, with the later name; an
  /// edit that changes nothing is no step.
  void edit(StitchProject next, std::string what, std::string mergeKey = {});
  /// The project as it was before the step that an edit with this key would merge with; null: it would be a step of its own.
  [[nodiscard]] const StitchProject* beforeMerging(const std::string& mergeKey) const { return states_.beforeMerging(mergeKey); }
  /// The next edit is a step of its own, whatever its key: a hand has let go.
  void endMerging() { states_.endMerging(); }
  [[nodiscard]] std::string undoName() const { return states_.undoName(); }
  [[nodiscard]] std::string redoName() const { return states_.redoName(); }
  void undo() { states_.undo(); }
  void redo() { states_.redo(); }

  /// Starts anew, without steps.
  void clear();
  /// @error what reading and parseProject say; the present project stays then
  [[nodiscard]] Result<void> open(const std::filesystem::path& file);
  /// Whether somebody else wrote the project's file since it was opened or saved here.
  [[nodiscard]] bool isChangedOnDisk() const;
  /// Writes the project, complete or not at all, and forgets the recovery file; whoever calls has looked at isChangedOnDisk().
  /// @error notWritable, emptyVolume (no volume in it)
  [[nodiscard]] Result<void> save(const std::filesystem::path& file);

  /// Writes the recovery file when there are unsaved changes, removes it when there are none. Nothing is written twice.
  /// @error notWritable
  [[nodiscard]] Result<void> keepRecovery();
  /// What a recovery file holds that an earlier run left.
  struct Left {
    std::filesystem::path file;  ///< of the project; empty: never saved
    StitchProject project;
  };
  /// @return empty when there is no such file
  /// @error of a file that is there and cannot be used
  [[nodiscard]] Result<std::optional<Left>> leftIn(const std::filesystem::path& recovery) const;
  /// Takes it over as an unsaved project, which keepRecovery() then keeps. Without steps.
  void takeOver(const Left& left);
  void forgetRecovery();

 private:
  void begin(StitchProject project, StitchProject saved, std::filesystem::path file, std::string textOfFile);

  sdk::Files& files_;
  std::filesystem::path recovery_;
  std::filesystem::path file_;
  std::string textOfFile_;  ///< as it was read or written here
  History<StitchProject> states_;
  StitchProject saved_;
  std::optional<StitchProject> kept_;  ///< what the recovery file holds
};

}  // namespace ew::stitching
