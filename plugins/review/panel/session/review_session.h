#pragma once

#include <QObject>
#include <QString>
#include <array>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "ew/sdk/host.h"
#include "logic/scan_shelf.h"
#include "panel/session/attempt_comments.h"
#include "panel/session/lesson_scores.h"
#include "panel/session/playback.h"
#include "panel/session/review_document.h"
#include "panel/session/review_reports.h"
#include "panel/session/review_selection.h"
#include "panel/session/reviewer.h"
#include "panel/session/scan_pair.h"

namespace ew::review {

/// What column and stage share: it owns what can be reviewed, what is, and where it stands, and opens what is chosen. Whatever it opens,
/// what was written before is kept first. On the window's thread; long work runs in the host's jobs on copies.
class ReviewSession final : public QObject {
  Q_OBJECT

 public:
  explicit ReviewSession(sdk::Host& host);

  [[nodiscard]] sdk::Host& host() { return host_; }
  [[nodiscard]] Reviewer& reviewer() { return reviewer_; }
  [[nodiscard]] const ReviewSelection& selection() const { return selection_; }
  [[nodiscard]] const ScanPair& scans() const { return scans_; }
  [[nodiscard]] Playback& playback() { return playback_; }
  [[nodiscard]] AttemptComments& comments() { return comments_; }
  [[nodiscard]] LessonScores& scores() { return scores_; }
  [[nodiscard]] ReviewDocument& document() { return document_; }
  [[nodiscard]] ReviewReports& reports() { return reports_; }

  void readShelf();  ///< in a job; ReviewSelection::shelfChanged() when it is there
  void chooseLesson(std::size_t lesson);
  void chooseAttempt(std::size_t attempt);  ///< and the first of its steps that was recorded
  void chooseStep(const std::string& stepId);
  void compareWith(std::optional<std::size_t> comparison);  ///< one of ReviewSelection::comparisons(), or nothing
  /// Any recording. It stays until another attempt or step is chosen.
  void openFile(Side side, const std::filesystem::path& file);
  void setReviewer(const QString& name);

  /// The overview of the class is in front, in place of the scans.
  [[nodiscard]] bool showsClass() const { return showsClass_; }
  void setShowsClass(bool shown);

 Q_SIGNALS:
  void pageChanged();

 private:
  void openChosen();
  void start(std::array<std::optional<ScanChoice>, 2> choices);
  void take(Opening& made);

  // Each uses only those above it.
  sdk::Host& host_;
  Reviewer reviewer_;
  ReviewSelection selection_;
  ScanPair scans_;
  Playback playback_;
  AttemptComments comments_;
  LessonScores scores_;
  ReviewDocument document_;
  ReviewReports reports_;
  bool showsClass_ = false;
  std::shared_ptr<bool> alive_ = std::make_shared<bool>(true);
};

}  // namespace ew::review
