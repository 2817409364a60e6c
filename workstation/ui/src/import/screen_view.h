#pragma once

#include <QImage>
#include <QPoint>
#include <QRectF>
#include <QWidget>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "ew/acquisition/screen_edit.h"
#include "measure/calipers/calipers.h"

namespace ew::ui {

/// A frame of a recorded screen with what was found in it. The mouse drags the grips of the outline; a click on a box of text takes it or
/// leaves it, a drag beside every grip draws a new one. With the tool for distances the mouse measures instead. On the keyboard H takes
/// hold of the next grip and arrows with Ctrl move it a pixel (Shift: ten); plain arrows step through the frames, space plays.
class ScreenView final : public QWidget {
  Q_OBJECT

 public:
  explicit ScreenView(QWidget* parent = nullptr);

  /// @param screen_px size of the recording's images @param at where `image` lies in them
  void setImage(const QImage& image, const QPoint& at, const QSize& screen_px);
  /// What is corrected; as long as it lives, or null.
  void setEdit(ScreenEdit* edit);
  void setMarksShown(bool shown);  ///< outline and boxes: the cleaned image goes without
  /// Distances of the frame that is shown, in pixels of the recording; null: none are.
  void setDrawing(measurement::CaliperDrawing* drawing);
  void setMeasuring(bool measuring);
  /// As they are painted: points in pixels, and what stands at each.
  struct Label {
    Calipers::Line line;
    QString text;
    bool isChosen = false;
  };
  void setLabels(std::vector<Label> labels);

  /// Screen pixels of the widget for each of the recording.
  [[nodiscard]] double scale() const;
  /// Where a place of the recording is drawn; centres of its pixels at integers.
  [[nodiscard]] QPointF placeOf(glm::dvec2 p_px) const;
  [[nodiscard]] glm::dvec2 pixelAt(const QPointF& at) const;

  [[nodiscard]] QSize sizeHint() const override { return {640, 480}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {320, 240}; }

 Q_SIGNALS:
  void edited();    ///< outline or boxes
  void measured();  ///< what is drawn of distances
  void stepAsked(int frames);
  void endAsked(bool last);
  void playAsked();
  void pauseAsked();  ///< the frame that is shown is measured

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  [[nodiscard]] QPointF origin() const;  ///< of the recording's images, in the widget
  void makeRoom();
  [[nodiscard]] bool corrects() const { return edit_ != nullptr && marksShown_ && !measuring_; }
  [[nodiscard]] std::optional<OutlineGrip> gripAt(const QPointF& at) const;
  [[nodiscard]] PixelRect between(const QPointF& a, const QPointF& b) const;
  void moveGripBy(glm::dvec2 by_px);
  void paintMarks(QPainter& painter);
  void showCursor(const QPointF& at);

  QImage image_;
  QPoint at_;
  QSize screen_px_;
  QRectF room_px_;  ///< what is in sight, in pixels of the recording: the apex often lies above the images
  ScreenEdit* edit_ = nullptr;
  measurement::CaliperDrawing* drawing_ = nullptr;
  std::vector<Label> labels_;
  bool marksShown_ = true;
  bool measuring_ = false;
  std::optional<OutlineGrip> held_;    ///< by the mouse
  std::optional<OutlineGrip> chosen_;  ///< for keys
  QPointF grabbed_;                    ///< from the pointer to the grip that it holds
  std::optional<QPointF> from_, to_;   ///< of a drag that draws a box
};

}  // namespace ew::ui
