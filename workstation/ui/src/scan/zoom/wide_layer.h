#pragma once

#include <QWidget>

namespace ew::ui {

class ScanView;
class Session;
class WideScan;

/// Over a wide image: where the probe is while it grows, in the colour of danger where its image is not woven, and how long it is.
class WideLayer final : public QWidget {
  Q_OBJECT

 public:
  WideLayer(Session& session, WideScan& wide, ScanView& scan);
  [[nodiscard]] QString text() const;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void follow();
  Session& session_;
  WideScan& wide_;
  ScanView& scan_;
};

}  // namespace ew::ui
