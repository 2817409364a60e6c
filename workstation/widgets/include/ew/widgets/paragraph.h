#pragma once

#include <QLabel>
#include <QWidget>

namespace ew {

/// A quiet text of as many lines as it takes at the width it is given. A plain label that wraps asks for height by width, which scrolled
/// columns do not grant: they share the lack among all their rows, and the last line is cut off. This one is as high as its lines.
class Paragraph final : public QLabel {
 public:
  explicit Paragraph(const QString& text = {}, QWidget* parent = nullptr);
  void say(const QString& text);
  [[nodiscard]] bool hasHeightForWidth() const override { return false; }

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void fit();
};

/// Holds wrapping texts without passing their wish for height by width on: a scrolled column takes that wish for its least height, and
/// scrolls although all of it would fit.
class PlainHeight final : public QWidget {
 public:
  using QWidget::QWidget;
  [[nodiscard]] bool hasHeightForWidth() const override { return false; }
};

}  // namespace ew
