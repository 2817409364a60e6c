#pragma once

#include <QWidget>
#include <string>
#include <vector>

class QComboBox;
class QLabel;
class QPushButton;

namespace ew::ui {

class Calipers;
class Worksheets;

/// On the page of measurements: which worksheet is filled, and what it asks for with what was found. A click on an item takes its caliper.
class WorksheetList final : public QWidget {
  Q_OBJECT

 public:
  WorksheetList(Worksheets& worksheets, Calipers& calipers, QWidget* parent = nullptr);

 Q_SIGNALS:
  void worksheetAsked();

 private:
  void showPackages();
  void showItems();
  void showValues();
  void showHeld();

  Worksheets& worksheets_;
  Calipers& calipers_;
  QComboBox* choice_ = nullptr;
  QWidget* items_ = nullptr;
  QPushButton* open_ = nullptr;
  struct Entry {
    std::string item;
    std::string side;
    QPushButton* button = nullptr;
    QLabel* value = nullptr;
    QString tip;  ///< what it is, and where its calipers go
  };
  [[nodiscard]] QString imagesOf(const Entry& entry) const;
  std::vector<Entry> entries_;
  const void* shownPackage_ = nullptr;  ///< whose items are listed
};

}  // namespace ew::ui
