#pragma once

#include <QWidget>

#include "annotate/image_annotations.h"
#include "annotate/image_body_mark.h"
#include "measure/calipers/calipers.h"
#include "scan/session.h"

namespace ew::ui {

class BodyMarkView;
class Jobs;
class ScanView;

/// An image that stands beside the one in hand, with all that belongs to it: console, cine loop, calipers, texts, body mark. It is looked
/// at; to be worked with it is taken in hand (ImageGrid). Its session is frozen: nothing is formed again but for a view of another size.
class ImageTile final : public QWidget {
  Q_OBJECT

 public:
  ImageTile(Jobs& jobs, QWidget* parent);
  ~ImageTile() override;

  [[nodiscard]] bool isEmpty() const { return session_.image().isEmpty(); }
  void clear();
  [[nodiscard]] Session& session() { return session_; }
  [[nodiscard]] Calipers& calipers() { return calipers_; }
  [[nodiscard]] ImageAnnotations& annotated() { return annotated_; }
  [[nodiscard]] ImageBodyMark& mark() { return mark_; }
  [[nodiscard]] const Session& session() const { return session_; }
  [[nodiscard]] const Calipers& calipers() const { return calipers_; }
  [[nodiscard]] const ImageAnnotations& annotated() const { return annotated_; }
  [[nodiscard]] const ImageBodyMark& mark() const { return mark_; }
  [[nodiscard]] ScanView& view() const { return *view_; }
  void setMarkCorner(int corner);
  /// Shows the image, or says that there is none.
  void showOrHide();

 Q_SIGNALS:
  void asked();  ///< a click: to be taken in hand

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;

 private:
  Session session_;
  Calipers calipers_;
  ImageAnnotations annotated_;
  ImageBodyMark mark_;
  ScanView* view_ = nullptr;
  BodyMarkView* markView_ = nullptr;
};

}  // namespace ew::ui
