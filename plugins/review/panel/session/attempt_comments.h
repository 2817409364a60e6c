#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <optional>
#include <string>
#include <vector>

#include "ew/assessment/review_comment.h"
#include "ew/sdk/host.h"
#include "logic/comment_history.h"
#include "panel/session/playback.h"
#include "panel/session/reviewer.h"
#include "panel/session/scan_pair.h"

namespace ew::review {

/// The comments on the attempt that is reviewed: the reviewer's own, which can be edited, and everybody else's. A pause after an edit saves
/// them, so that a crash takes no more than what came since.
class AttemptComments final : public QObject {
  Q_OBJECT

 public:
  AttemptComments(sdk::Host& host, const ScanPair& scans, Playback& playback, const Reviewer& reviewer);

  /// The reviewer's own; null: nothing can be commented.
  [[nodiscard]] const CommentHistory* history() const { return history_ ? &*history_ : nullptr; }
  /// This reviewer's comments on the scan that is open.
  [[nodiscard]] std::vector<ReviewComment> here() const;
  [[nodiscard]] const std::vector<CommentFile>& others() const { return others_; }
  /// At the present moment. @return its id; empty: nothing can be commented, or the reviewer has no name
  std::string add(const QString& text, std::vector<CommentStroke> strokes);
  void edit(const ReviewComment& comment, const QString& what, const std::string& mergeKey = {});
  void remove(const std::string& id);
  void show(const ReviewComment& comment);  ///< goes there
  [[nodiscard]] const std::string& chosen() const { return chosen_; }
  void choose(const std::string& id);

  [[nodiscard]] bool isSaved() const { return !history_ || history_->isSaved(); }
  /// @return false: they could not be kept, and the window was told why
  bool save();
  void undo();
  void redo();

  /// Those on the scans that are open now, or by the reviewer as they are called now. They tell nobody: ReviewSession does, when the rest
  /// has followed.
  void takeScans();
  void takeReviewer();

 Q_SIGNALS:
  void changed();
  void documentChanged();  ///< what can be undone or is to be saved may be another
  void reviewerWanted();   ///< something is to be kept by its writer, who has not said who they are

 private:
  void open();
  void setTracks();
  void tellEdited();

  sdk::Host& host_;
  const ScanPair& scans_;
  Playback& playback_;
  const Reviewer& reviewer_;
  std::optional<CommentHistory> history_;
  std::vector<CommentFile> others_;
  std::string chosen_;
  QTimer pause_;  ///< in what is said
};

}  // namespace ew::review
