#pragma once

#include <QPointF>
#include <QStringList>
#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "ew/assessment/review_comment.h"
#include "panel/image_maker.h"
#include "panel/session/review_scan.h"

namespace ew::review {

class AttemptComments;
class Playback;
class ReviewSelection;
class ReviewSession;
class Reviewer;
class ScanPair;

/// One scan as it was seen: the image of the moment, what it was made with, and what was drawn on it. Settings that differ from the other
/// scan's are marked. On the reviewed one a stroke is drawn with the mouse while a tool is chosen.
class ImageView final : public QWidget {
  Q_OBJECT

 public:
  ImageView(Side side, ReviewSession& session, QWidget* parent = nullptr);
  ~ImageView() override;

  /// Whose settings are compared with; may be null.
  void setOther(ImageView* other) { other_ = other; }
  /// Nothing is drawn by hand while it is empty.
  void setTool(std::optional<CommentStroke::Kind> tool);
  /// What was drawn and belongs to no comment yet.
  [[nodiscard]] const std::vector<CommentStroke>& drawn() const { return drawn_; }
  void setDrawn(std::vector<CommentStroke> strokes);
  /// Nothing that was asked for is still to come.
  [[nodiscard]] bool isIdle() const;
  /// Where a point of the image plane is, in pixels of the widget, and back.
  [[nodiscard]] QPointF pixelOf(const glm::dvec2& p_mm) const;
  [[nodiscard]] glm::dvec2 pointAt(const QPointF& at) const;
  [[nodiscard]] QStringList shownSettings() const;  ///< "depth 12.0 cm", the differing ones with a leading "≠ "

 Q_SIGNALS:
  void drawnChanged();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;

 private:
  void show(const std::shared_ptr<const ReplayImage>& image);
  void ask();
  [[nodiscard]] QRectF imageRect() const;
  void paintImage(QPainter& painter);
  void paintStroke(QPainter& painter, const CommentStroke& stroke, const QColor& colour) const;
  void paintHead(QPainter& painter) const;
  void paintSettings(QPainter& painter) const;
  void paintEmpty(QPainter& painter) const;
  [[nodiscard]] int headHeight() const;
  [[nodiscard]] bool showsAllSettings() const;
  [[nodiscard]] int settingsHeight(int rows) const;
  [[nodiscard]] int settingsHeight() const;
  void showSettings();
  [[nodiscard]] QString titleOfScan() const;

  Side side_;
  const ScanPair& scans_;
  const ReviewSelection& selection_;
  const Reviewer& reviewer_;
  Playback& playback_;
  const AttemptComments& comments_;
  ImageView* other_ = nullptr;
  ImageMaker maker_;
  std::shared_ptr<const ReplayImage> shown_;
  std::optional<CommentStroke::Kind> tool_;
  std::vector<CommentStroke> drawn_;
  std::weak_ptr<const ReviewScan> source_;  ///< that was drawn on
  std::optional<CommentStroke> drawing_;
};

}  // namespace ew::review
