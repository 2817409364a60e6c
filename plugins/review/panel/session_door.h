#pragma once

#include <QObject>
#include <QPointF>
#include <QString>
#include <QStringList>

namespace ew::review {

class BodyView;
class ImageView;
class ReviewReports;
class TrackView;

/// For tests alone, which load the plugin and reach what they cannot click by name (QMetaObject::invokeMethod): the child "reviewDoor" of
/// the stage. An image is named as its view is: "reviewedPicture", "comparedPicture".
class SessionDoor final : public QObject {
  Q_OBJECT

 public:
  SessionDoor(ReviewReports& reports, const ImageView& reviewed, const ImageView& compared, const TrackView& tracks, const BodyView& body,
              QObject* parent);

  /// No image that was asked for is still to come.
  Q_INVOKABLE bool isIdle(const QString& image) const;
  /// "depth 12.0 cm", the differing ones with a leading "≠ "
  Q_INVOKABLE QStringList shownSettings(const QString& image) const;
  /// Of a point of the reviewed image's plane, and of a moment of the clock, in pixels of their widgets.
  Q_INVOKABLE QPointF pixelOfPoint(double lateral_mm, double axial_mm) const;
  Q_INVOKABLE double pixelOfTime(double clock_s) const;
  /// How many regions are shown on the body.
  Q_INVOKABLE int shownRegions() const;
  /// A report without the question where to.
  Q_INVOKABLE void writeReportFile(const QString& file, bool isOfClass);

 private:
  [[nodiscard]] const ImageView* viewOf(const QString& image) const;  ///< null: none is called so

  ReviewReports& reports_;
  const ImageView& reviewed_;
  const ImageView& compared_;
  const TrackView& tracks_;
  const BodyView& body_;
};

}  // namespace ew::review
