#pragma once

#include <QImage>
#include <QRect>
#include <QString>
#include <optional>

#include "ew/core/pose.h"
#include "ew/core/volume.h"
#include "ew/imaging/display.h"

class QPainter;

namespace ew::ui {

class Session;

/// What of the image looks at nothing recorded, kept while the probe rests: an image with noise comes thirty times a second.
class GapVeil {
 public:
  /// Made anew where the probe, the image or the volume lie elsewhere than they did. @param ratio device pixels of a widget pixel
  void follow(const Session& session, double ratio);
  /// Over the image in `box`. @param word said where there is enough of it and room, and the rest of the image sees the volume
  void paint(QPainter& painter, const QRect& box, const Session& session, const QString& word) const;
  /// Where data end below the middle of the probe's face, mm; none: beyond the image.
  [[nodiscard]] const std::optional<double>& end_mm() const { return end_mm_; }

 private:
  struct Seen {
    Pose pose;
    DisplayGeometry geometry;
    Grid grid;
    bool operator==(const Seen&) const = default;
  };
  Seen seen_;
  QImage image_;  ///< to lie on the image at `at_px_`, in device pixels
  QPoint at_px_;
  QRect widest_px_;  ///< the widest run of it in a row
  std::optional<double> end_mm_;
  double share_ = 0.0;
};

}  // namespace ew::ui
