#pragma once

#include <QEvent>
#include <QLabel>
#include <algorithm>

#include "ew/widgets/look.h"

namespace ew::stitching {

/// A quiet text of as many lines as it takes at the width it is given. A plain label that wraps asks for height by width, which scrolled
/// columns do not grant: they share the lack among all their rows, and the last line is cut off. This one is as high as its lines.
class Paragraph final : public QLabel {
 public:
  explicit Paragraph(const QString& text = {}, QWidget* parent = nullptr) : QLabel(text, parent) {
    setLook(this, Look::quiet);
    setWordWrap(true);
    fit();
  }
  void say(const QString& text) {
    setText(text);
    fit();
  }
  [[nodiscard]] bool hasHeightForWidth() const override { return false; }

 protected:
  void resizeEvent(QResizeEvent* event) override {
    QLabel::resizeEvent(event);
    fit();
  }
  void changeEvent(QEvent* event) override {
    QLabel::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) fit();
  }

 private:
  void fit() {
    setMinimumHeight(0);                                   // a label never asks for less than its least height
    setFixedHeight(std::max(0, heightForWidth(width())));  // -1 without any text
  }
};

/// Holds wrapping texts without passing their wish for height by width on: a scrolled column takes that wish for its least height, and
/// scrolls although all of it would fit.
class PlainHeight final : public QWidget {
 public:
  using QWidget::QWidget;
  [[nodiscard]] bool hasHeightForWidth() const override { return false; }
};

}  // namespace ew::stitching
