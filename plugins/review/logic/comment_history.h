#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "ew/assessment/review_comment.h"
#include "ew/core/history.h"

namespace ew::review {

/// One reviewer's comments on one attempt while they are edited: every edit is a step of undo, and nothing is on disk before save(). No
/// clock of its own.
class CommentHistory {
 public:
  CommentHistory() = default;
  /// @error as readComments
  [[nodiscard]] static Result<CommentHistory> open(const std::filesystem::path& attempt, const std::string& author);

  [[nodiscard]] const std::vector<ReviewComment>& comments() const { return states_.now().comments; }  ///< by step and time
  [[nodiscard]] const std::filesystem::path& attempt() const { return attempt_; }
  [[nodiscard]] const std::string& author() const { return states_.now().author; }
  [[nodiscard]] const ReviewComment* find(const std::string& id) const;

  /// @param comment its id is given here @param what name of the step of undo, in the user's words @return the id
  std::string add(ReviewComment comment, const std::string& what);
  /// Takes the place of the one with its id; edits with the same non-empty mergeKey in a row are one step. What changes nothing is none.
  void replace(const ReviewComment& comment, const std::string& what, const std::string& mergeKey = {});
  void remove(const std::string& id, const std::string& what);

  [[nodiscard]] std::string undoName() const { return states_.undoName(); }
  [[nodiscard]] std::string redoName() const { return states_.redoName(); }
  void undo() { states_.undo(); }
  void redo() { states_.redo(); }
  void endMerging() { states_.endMerging(); }

  [[nodiscard]] bool isSaved() const { return states_.now() == saved_; }
  /// @error as writeComments
  [[nodiscard]] Result<void> save();

 private:
  void change(CommentFile next, const std::string& what, const std::string& mergeKey);

  std::filesystem::path attempt_;
  History<CommentFile> states_;
  CommentFile saved_;
  int given_ = 0;
};

}  // namespace ew::review
