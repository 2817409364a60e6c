#pragma once

#include <QWidget>
#include <vector>

#include "start/recent_files.h"

class QLabel;
class QPushButton;

namespace ew::ui {

/// What was open recently, the latest first, in one line: as many as there is room for.
class RecentStrip final : public QWidget {
  Q_OBJECT

 public:
  explicit RecentStrip(QWidget* parent = nullptr);
  void show(const std::vector<RecentFile>& files);
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override { return {0, sizeHint().height()}; }

 Q_SIGNALS:
  void chosen(const QString& file);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void arrange();
  QLabel* title_ = nullptr;
  std::vector<QPushButton*> buttons_;
};

}  // namespace ew::ui
