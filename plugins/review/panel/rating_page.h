#pragma once

#include <QTimer>
#include <QWidget>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "ew/assessment/rating.h"
#include "ew/sdk/host.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QPushButton;
class QVBoxLayout;

namespace ew::review {

class LessonScores;
class ReviewSelection;
class ReviewSession;
class Reviewer;

/// A rating form that is filled in beside the scan, and kept as a draft by itself: after a pause, and before anything else is shown. Until
/// one's own is finished neither names nor others' ratings are seen, unless names are shown.
class RatingPage final : public QWidget {
  Q_OBJECT

 public:
  explicit RatingPage(ReviewSession& session, QWidget* parent = nullptr);

 private:
  void makeBody();
  void refresh();
  void makeItems();
  void readRating();
  void showOthers();
  void showTotal();
  [[nodiscard]] const RatingForm* form() const;       ///< that is chosen
  [[nodiscard]] const RatingForm* shownForm() const;  ///< that the rows are of
  [[nodiscard]] Rating rating(bool finished) const;
  bool keep(bool finished);
  [[nodiscard]] bool isChanged() const;
  bool keepDraft();

  sdk::Host& host_;
  const ReviewSelection& selection_;
  const Reviewer& reviewer_;
  LessonScores& lessonScores_;
  RatingFormList forms_;
  std::filesystem::path attempt_;  ///< whose rating is shown
  std::string madeFor_;            ///< form id that the rows are of
  std::map<std::string, QComboBox*> scores_;
  std::map<std::string, QLineEdit*> remarks_;
  QComboBox* form_ = nullptr;
  QComboBox* level_ = nullptr;
  QLabel* blind_ = nullptr;
  QLabel* problem_ = nullptr;
  QVBoxLayout* items_ = nullptr;
  QPlainTextEdit* remark_ = nullptr;
  QLabel* total_ = nullptr;
  QLabel* kept_ = nullptr;
  QLabel* others_ = nullptr;
  QPushButton* draft_ = nullptr;
  QPushButton* finish_ = nullptr;
  QWidget* body_ = nullptr;
  bool showing_ = false;
  std::optional<Rating> read_;  ///< what is shown as it was read or kept last; none: nothing is shown
  QTimer idle_;                 ///< a pause in typing: then a draft is kept
  std::shared_ptr<void> held_;
};

}  // namespace ew::review
