#pragma once

#include <QWidget>

namespace ew {

/// A thin frame along the edge of a view whose image leaves no place for a mark, as long as the view has the focus by the keyboard. Who
/// clicks into a view knows where the keys go, and gets no frame.
class FocusRing final : public QWidget {
 public:
  /// @param around  has the ring within its edges, and owns it
  /// @param watched has the focus: the same widget, or a part of it
  FocusRing(QWidget& around, QWidget& watched);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void place();
  QWidget& around_;
  QWidget& watched_;
};

/// Whether the focus came with a key, and so has to be seen.
[[nodiscard]] bool isReachedByKeys(Qt::FocusReason reason);

}  // namespace ew
