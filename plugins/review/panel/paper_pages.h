#pragma once

#include <QPainter>
#include <QPdfWriter>
#include <QString>
#include <QStringList>

namespace ew::review {

/// Pages that fill from above: whoever puts something on them asks for room first and moves on by what it took. Lengths in dots.
class PaperPages {
 public:
  /// @param total pages, for "1 of 3"; 0: not known yet
  PaperPages(QPdfWriter& writer, QString title, QString foot, int total);

  [[nodiscard]] QPainter& painter() { return painter_; }
  [[nodiscard]] double mm(double length_mm) const { return length_mm * dotsPerMm_; }
  [[nodiscard]] double width() const { return width_; }
  [[nodiscard]] double y() const { return y_; }
  [[nodiscard]] double roomLeft() const { return bottom_ - y_; }
  [[nodiscard]] double roomOfAPage() const { return bottom_ - top_; }
  [[nodiscard]] int pages() const { return page_; }
  /// Nothing stands on this page yet.
  [[nodiscard]] bool isFresh() const { return y_ <= top_; }
  /// The next page, unless so much fits on this one, or on no page.
  void makeRoom(double height);
  void nextPage();
  void moveOn(double height) { y_ += height; }

  [[nodiscard]] static QFont font(double size_pt, bool isBold = false);
  /// The lines of a text in so much width; long words are broken.
  [[nodiscard]] QStringList linesOf(const QString& text, const QFont& font, double width);
  [[nodiscard]] double lineHeight(const QFont& font);
  [[nodiscard]] double widthOf(const QString& text, const QFont& font);
  /// One line with its upper edge at `y`.
  void line(const QString& text, const QFont& font, const QColor& colour, double x, double y, double width,
            Qt::Alignment alignment = Qt::AlignLeft);

 private:
  void drawEdges();

  QPdfWriter& writer_;
  QPainter painter_;
  QString title_, foot_;
  int total_ = 0, page_ = 1;
  double dotsPerMm_ = 1.0, width_ = 0.0, top_ = 0.0, bottom_ = 0.0, y_ = 0.0;
};

}  // namespace ew::review
