#pragma once

#include <QTimer>
#include <QWidget>
#include <functional>
#include <optional>
#include <vector>

#include "scan/gap_veil.h"
#include "scan/session.h"

namespace ew::ui {

class DgcColumn;
class FocusScale;

/// The scan: the image pixel for pixel on black, and around it what a machine shows: depth scale, marker, focus marks, DGC sliders at
/// their depths, and in M-mode the strip of one beam over time, below the image or instead of it; likewise the spectrum of a sample volume.
/// Scale and sliders stand in the black corners beside the fan where it leaves them room, so that the image may be as large as the view; no
/// slider lies on the fan.
class ScanView final : public QWidget {
  Q_OBJECT

 public:
  explicit ScanView(Session& session, QWidget* parent = nullptr);

  /// Where the image lies in the widget, in widget pixels. In M-mode alone nothing is drawn there but the strip.
  [[nodiscard]] QRect imageRect() const;
  /// Where the strip of the M-mode or the spectrum lies; empty in B-mode.
  [[nodiscard]] QRect stripRect() const;
  /// What the fan of the image covers, in widget pixels; all of a wide image. Empty without an image.
  [[nodiscard]] std::vector<QRect> fanRects() const;
  /// What results of measurements cover, in widget pixels, whatever else lies beside the fan; empty: nothing.
  void setResultsRect(const QRect& rect);
  /// What the bar of colours covers; empty: there is none.
  [[nodiscard]] const QRect& colourBarRect() const { return bar_; }
  [[nodiscard]] const QRect& resultsRect() const { return resultsRect_; }
  /// Whether the image fills the view, and leaves no black beside it.
  [[nodiscard]] bool isZoomed() const { return mode() != DisplayMode::mMode && session_.imageKnobs().zoom > 1.0; }
  /// Millimetres of tissue that a widget pixel shows; what a drag of the mouse is worth.
  [[nodiscard]] double mmPerWidgetPixel() const;
  /// Widget y of a depth below the middle of the probe's face, on the image or, in M-mode alone, on the strip.
  [[nodiscard]] double yOfDepth(double depth_mm) const;
  [[nodiscard]] double depthAt_mm(double y) const;
  [[nodiscard]] QSize minimumSizeHint() const override { return {320, 320}; }
  /// Widget position of a point of the probe's image plane, wherever zoom, pan and inversion put it.
  [[nodiscard]] QPointF positionOf(const Point<frame::Probe>& at) const;
  /// The inverse: the point of the image plane that is shown at a widget position.
  [[nodiscard]] Point<frame::Probe> pointAt(const QPointF& position) const;
  /// Paints over the image, clipped to it. Not on the strip of the M-mode.
  std::function<void(QPainter&)> paintOver;
  void refreshIcons();
  /// What is said while there is no image; empty: the usual.
  void setNothing(const QString& sentence);
  /// A sentence over the image for a few seconds.
  void say(const QString& sentence);
  [[nodiscard]] QString said() const { return said_; }
  /// What a drag would do where the pointer is; empty: what it does elsewhere.
  void setDragHint(const QString& hint);
  [[nodiscard]] QString dragHint() const { return dragHint_; }
  /// Sliders and marks on the image that change settings.
  void setControlsEnabled(bool enabled);
  /// Which of several images it is, before the name of the probe; empty: the only one.
  void setLabel(const QString& label);
  [[nodiscard]] const QString& label() const { return label_; }
  /// One of several images: the sliders are left out, and the scale stands as far in as there is black, so that the room is the fan's.
  void setCompact(bool compact);
  [[nodiscard]] bool isCompact() const { return isCompact_; }
  /// Millimetres that a pixel of the screen shows when the image is as large as the view has room; 0 without one.
  [[nodiscard]] double pixelOfWhole_mm() const;
  /// The image is made smaller than the room it has until a pixel shows as many millimetres, so that several have one scale. Only in
  /// B-mode.
  /// @param pixel_mm of device pixels; 0: as large as there is room
  void setLeastPixel(double pixel_mm);
  /// Rings the bell once when a tracker loses the probe; off at first. The bell is the desktop's own, which may be silent.
  void setSoundsLoss(bool sounds) { soundsLoss_ = sounds; }
  /// A red dot and how long the recording is by now; empty: none is made.
  void setRecording(std::optional<double> length_s);

 Q_SIGNALS:
  void arranged();  ///< image, strip and results may lie elsewhere

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void enterEvent(QEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  void arrange();
  /// On an image that fills the view only while the pointer is at them.
  void showSliders();
  void fitMargins();
  /// @return whether sliders and scale lie beside the fan at these margins
  [[nodiscard]] bool fitsBeside(const Knobs& whole);
  [[nodiscard]] int leftMost_px() const;   ///< room for the sliders
  [[nodiscard]] int rightMost_px() const;  ///< room for the scale
  [[nodiscard]] int barRoom_px() const;    ///< room for the bar of colours
  [[nodiscard]] QRect roomOfBar() const;
  void placeColourBar();
  [[nodiscard]] QRect wholeRect() const;   ///< room for the image, beside the scales
  [[nodiscard]] DisplayMode mode() const;  ///< that is shown: without blood there is no spectrum
  [[nodiscard]] bool isBesideVolume() const;
  [[nodiscard]] bool isInAir() const;
  void paintEndOfData(QPainter& painter, double end_mm);
  void paintDepthScale(QPainter& painter);
  void paintFoci(QPainter& painter);
  void paintMarker(QPainter& painter);
  void paintMLine(QPainter& painter);
  void paintStrip(QPainter& painter);
  void paintWords(QPainter& painter);
  void paintSaid(QPainter& painter);
  void paintLost(QPainter& painter);
  [[nodiscard]] bool paintTracked(QPainter& painter);

  Session& session_;
  DgcColumn* dgc_ = nullptr;
  FocusScale* scale_ = nullptr;
  int left_px_ = 0, right_px_ = 0;  ///< kept free beside the image
  int besideFan_px_ = 0;            ///< what is free left of the fan at every slider
  bool isCompact_ = false;
  bool isNearSliders_ = false;  ///< the pointer
  struct Fitted {
    QSize size;
    std::string probe;
    Knobs knobs;
    bool isCompact = false;
    bool operator==(const Fitted&) const = default;
  };
  Fitted fitted_;  ///< what the margins were fitted to
  GapVeil veil_;
  std::optional<double> recorded_s_;
  QString label_;
  double leastPixel_mm_ = 0.0;
  double share_ = 1.0;  ///< of the room that the image takes
  bool soundsLoss_ = false;
  bool isLost_ = false;  ///< as it was told last
  QString said_;
  QRect resultsRect_, bar_;
  QString dragHint_;
  QString nothing_;
  QTimer saidLong_;
};

}  // namespace ew::ui
