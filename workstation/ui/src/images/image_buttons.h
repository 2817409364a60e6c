#pragma once

#include <QWidget>
#include <array>

class QPushButton;

namespace ew::ui {

class ImageGrid;

/// On the console: how many images there are, which is next, and whether all have one scale.
class ImageButtons final : public QWidget {
  Q_OBJECT

 public:
  explicit ImageButtons(ImageGrid& grid, QWidget* parent = nullptr);

 private:
  void showAll();

  ImageGrid& grid_;
  std::array<QPushButton*, 3> counts_{};
  QWidget* severalOnly_ = nullptr;  ///< means something with more than one
  QPushButton* next_ = nullptr;
  QPushButton* scale_ = nullptr;
};

}  // namespace ew::ui
