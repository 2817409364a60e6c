#pragma once

#include <QWidget>

namespace ew::ui {

/// A line drawing of what is to be done (resources/icons/NAME.svg) in the colours of the window: "currentColor" are its lines, #00ffff
/// what matters in it.
class TrackerDrawing final : public QWidget {
  Q_OBJECT

 public:
  /// @param said what it shows, for those who do not see it
  TrackerDrawing(const QString& name, const QString& said, QWidget* parent = nullptr);
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QByteArray svg_;
};

}  // namespace ew::ui
