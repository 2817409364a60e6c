#pragma once

#include <QWidget>

#include "annotate/annotated_pictures.h"
#include "annotate/shown_mark.h"
#include "measure/calipers/calipers.h"
#include "scan/session.h"

namespace ew::ui {

class BodyMarkView;
class Jobs;
class ScanView;

/// A picture that stands beside the one in hand, with all that belongs to it: console, cine loop, calipers, texts, body mark. It is looked
/// at; to be worked with it is taken in hand (PictureGrid). Its session is frozen: nothing is formed again but for a view of another size.
class KeptPicture final : public QWidget {
  Q_OBJECT

 public:
  KeptPicture(Jobs& jobs, QWidget* parent);
  ~KeptPicture() override;

  [[nodiscard]] bool isEmpty() const { return session_.picture().isEmpty(); }
  void clear();
  [[nodiscard]] Session& session() { return session_; }
  [[nodiscard]] Calipers& calipers() { return calipers_; }
  [[nodiscard]] AnnotatedPictures& annotated() { return annotated_; }
  [[nodiscard]] ShownMark& mark() { return mark_; }
  [[nodiscard]] const Session& session() const { return session_; }
  [[nodiscard]] const Calipers& calipers() const { return calipers_; }
  [[nodiscard]] const AnnotatedPictures& annotated() const { return annotated_; }
  [[nodiscard]] const ShownMark& mark() const { return mark_; }
  [[nodiscard]] ScanView& view() const { return *view_; }
  void setMarkCorner(int corner);
  /// Shows the picture, or says that there is none.
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
  AnnotatedPictures annotated_;
  ShownMark mark_;
  ScanView* view_ = nullptr;
  BodyMarkView* markView_ = nullptr;
};

}  // namespace ew::ui
