#pragma once

#include <QWidget>
#include <vector>

class QButtonGroup;
class QHBoxLayout;
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
  /// A button behind those that are there. @param icon the text of an SVG; empty: none
  void addWorkspace(const QString& id, const QString& title, const QString& tip, const QByteArray& icon);
  void setWorkspace(const QString& id);
  void setShown(const QString& id, bool shown);
  void refreshIcons();

 Q_SIGNALS:
  void workspaceChosen(const QString& id);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void placeTitle();
  QMenuBar* menus_ = nullptr;
  struct Button {
    QString id;
    QPushButton* button;
    QByteArray icon;
  };
  std::vector<Button> workspaces_;
  QButtonGroup* group_ = nullptr;
  QHBoxLayout* switch_ = nullptr;
  QLabel* brand_ = nullptr;
  QLabel* disclaimer_ = nullptr;
  QLabel* title_ = nullptr;
  QLabel* remark_ = nullptr;
  QString fullTitle_;
};

}  // namespace ew::ui
