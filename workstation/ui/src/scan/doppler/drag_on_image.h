#pragma once

#include <QPointF>
#include <QString>
#include <Qt>
#include <optional>

class QEvent;

namespace ew::ui {

class ScanView;
class Session;

/// Something that lies on the image and is dragged there: it gets the mouse where it is, before anybody else. Only while the image runs:
/// one that stands still or is played keeps what lies on it.
class DragOnImage {
 public:
  DragOnImage(Session& session, ScanView& scan) : session_(session), scan_(scan) {}
  virtual ~DragOnImage() = default;
  DragOnImage(const DragOnImage&) = delete;
  DragOnImage& operator=(const DragOnImage&) = delete;

  /// What the mouse does in the view. @return whether it was this one's, and nobody else's
  bool handle(const QEvent& event);
  /// What the pointer looks like where it is now; empty: it is not there.
  [[nodiscard]] std::optional<Qt::CursorShape> cursor() const;
  [[nodiscard]] bool isDragging() const { return isDragging_; }
  void end();

 protected:
  static constexpr double kReach_px = 6.0;  ///< off an edge that is still at it
  /// Where it is taken.
  struct Grip {
    int part = 0;  ///< as the thing names them
    Qt::CursorShape cursor = Qt::OpenHandCursor;
    QString hint = {};  ///< what a drag does
  };
  /// Whether there is anything to drag on an image that runs.
  [[nodiscard]] virtual bool hasAny() const = 0;
  /// Asked only while there is, and within the image.
  [[nodiscard]] virtual std::optional<Grip> gripAt(const QPointF& at) const = 0;
  virtual void begin(int part, const QPointF& at) = 0;
  virtual void moveTo(int part, const QPointF& at) = 0;
  /// Where the wheel is turned over a part. @return whether that means anything
  virtual bool turn(int /*steps*/) { return false; }

  Session& session_;
  ScanView& scan_;

 private:
  [[nodiscard]] bool isThere() const;
  [[nodiscard]] std::optional<Grip> findGrip(const QPointF& at) const;
  [[nodiscard]] bool press(const QEvent& event);
  [[nodiscard]] bool move(const QEvent& event);
  [[nodiscard]] bool release(const QEvent& event);
  [[nodiscard]] bool wheel(const QEvent& event);
  void tellHint();

  std::optional<Grip> grip_;  ///< under the pointer, or held
  bool isDragging_ = false;
  int turned_ = 0;  ///< of the wheel, less than a step
};

}  // namespace ew::ui
