#pragma once

#include <QWidget>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ew/assessment/review_comment.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QStackedWidget;
class QToolButton;

namespace ew {
class NumberField;
}

namespace ew::review {

class AttemptComments;
class BodyView;
class ImageView;
class Playback;
class ReviewSelection;
class ReviewSession;
class ScanPair;
class TrackView;

/// Both images side by side and both scans on the body; below them the clock and both scans along it. Or, in their place, the overview of
/// a class.
class ReviewStage final : public QWidget {
  Q_OBJECT

 public:
  explicit ReviewStage(ReviewSession& session, QWidget* parent = nullptr);

  /// What the keys do, for the window's page of keys.
  [[nodiscard]] static std::vector<std::pair<std::string, std::string>> keyLines();

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  bool event(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  enum Page { kScansPage, kClassPage, kEmptyPage };
  QWidget* makeViews();
  QWidget* makeBodyFrame();
  QWidget* makeTransport();
  QWidget* makeDrawing();
  QToolButton* iconButton(const char* name, const char* icon, const QString& tip);
  void showIcons();
  void showClock();
  void showTools();
  bool writeComment();
  [[nodiscard]] bool isCommentBegun() const;
  /// @param act false: only asked whether the key is one of the stage's. @return whether it is
  bool handleKey(const QKeyEvent& event, bool act);
  void chooseTool(std::optional<CommentStroke::Kind> tool);

  ReviewSession& session_;
  const ReviewSelection& selection_;
  const ScanPair& scans_;
  Playback& playback_;
  AttemptComments& comments_;
  std::shared_ptr<void> held_;
  QStackedWidget* pages_ = nullptr;
  ImageView* reviewed_ = nullptr;
  ImageView* compared_ = nullptr;
  BodyView* body_ = nullptr;
  TrackView* tracks_ = nullptr;
  QToolButton* play_ = nullptr;
  QLabel* time_ = nullptr;
  QComboBox* speed_ = nullptr;
  QComboBox* heat_ = nullptr;
  QPushButton* oneClock_ = nullptr;
  QPushButton* aligned_ = nullptr;
  NumberField* offset_ = nullptr;
  QPushButton* atEnd_ = nullptr;
  QWidget* drawing_ = nullptr;
  std::vector<QPushButton*> tools_;
  QPushButton* addComment_ = nullptr;
  QLineEdit* commentText_ = nullptr;
  QPushButton* dropDrawing_ = nullptr;
  std::vector<std::pair<QToolButton*, QString>> icons_;
  bool showing_ = false;
};

}  // namespace ew::review
