#pragma once

#include <QLabel>

namespace ew {

/// A line that gives way: where there is no room its text ends in an ellipsis, and the tip has all of it.
class EllipsisLabel final : public QLabel {
  Q_OBJECT

 public:
  using QLabel::QLabel;
  [[nodiscard]] QSize minimumSizeHint() const override;

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  [[nodiscard]] bool isCut() const;
};

}  // namespace ew
