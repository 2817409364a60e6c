#pragma once

#include <QWidget>

class QLabel;
class QMenuBar;
class QPushButton;

namespace ew::ui {

/// Name, menus and workspaces at the left, what is open in the middle, what this is not at the right.
class TopBar final : public QWidget {
  Q_OBJECT

 public:
  explicit TopBar(QWidget* parent = nullptr);

  [[nodiscard]] QMenuBar& menus() { return *menus_; }
  void setTitle(const QString& title, const QString& remark);
  void setWorkspace(int index);  ///< 0 Explore, 1 Author

 Q_SIGNALS:
  void workspaceChosen(int index);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void placeTitle();
  QMenuBar* menus_ = nullptr;
  QPushButton* explore_ = nullptr;
  QPushButton* author_ = nullptr;
  QLabel* disclaimer_ = nullptr;
  QLabel* title_ = nullptr;
  QLabel* remark_ = nullptr;
  QString fullTitle_;
};

}  // namespace ew::ui
