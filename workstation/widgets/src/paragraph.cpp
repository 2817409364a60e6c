#include "ew/widgets/paragraph.h"

#include <QEvent>
#include <algorithm>

#include "ew/widgets/look.h"

namespace ew {

Paragraph::Paragraph(const QString& text, QWidget* parent) : QLabel(text, parent) {
  setLook(this, Look::quiet);
  setWordWrap(true);
  fit();
}

void Paragraph::say(const QString& text) {
  setText(text);
  fit();
}

void Paragraph::resizeEvent(QResizeEvent* event) {
  QLabel::resizeEvent(event);
  fit();
}

void Paragraph::changeEvent(QEvent* event) {
  QLabel::changeEvent(event);
  if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) fit();
}

void Paragraph::fit() {
  setMinimumHeight(0);                                   // a label never asks for less than its least height
  setFixedHeight(std::max(0, heightForWidth(width())));  // -1 without any text
}

}  // namespace ew
