#pragma once

#include <QWidget>
#include <array>

class QPushButton;

namespace ew::ui {

class PictureGrid;

/// On the console: how many pictures there are, which is next, and whether all have one scale.
class PictureButtons final : public QWidget {
  Q_OBJECT

 public:
  explicit PictureButtons(PictureGrid& grid, QWidget* parent = nullptr);

 private:
  void showAll();

  PictureGrid& grid_;
  std::array<QPushButton*, 3> counts_{};
  QWidget* severalOnly_ = nullptr;  ///< means something with more than one
  QPushButton* next_ = nullptr;
  QPushButton* scale_ = nullptr;
};

}  // namespace ew::ui
