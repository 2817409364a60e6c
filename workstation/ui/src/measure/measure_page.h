#pragma once

#include <QWidget>
#include <vector>

#include "measure/calipers/calipers.h"

class QCheckBox;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace ew::ui {

class CaliperToolRow;
/// A line of the list: number, what it is and its main result, and below it the others. A click chooses it.
class MeasurementLine;
class Session;
class StripTools;
class Worksheets;

/// The console's page of measurements: the tools, and the list of what they measured with its uncertainty.
class MeasurePage final : public QWidget {
  Q_OBJECT

 public:
  MeasurePage(Session& session, Calipers& calipers, Worksheets& worksheets, QWidget* parent = nullptr);
  ~MeasurePage() override;
  void refreshIcons();

  /// What was measured on an image that stands beside the one in hand.
  struct OfImage {
    int place = 0;
    QString name;
    std::vector<Calipers::Line> lines;
  };
  /// @param own name of the image in hand; empty: the only one
  void setImages(const QString& own, const std::vector<OfImage>& others);

 Q_SIGNALS:
  void worksheetAsked();
  void combineAsked();
  void saveAsked();
  void imageAsked(int place);  ///< to be taken in hand

 private:
  void addTools(Session& session, QVBoxLayout* rows);
  void addEdits(QVBoxLayout* rows);
  void showAll();

  Calipers& calipers_;
  CaliperToolRow* tools_ = nullptr;
  StripTools* strip_ = nullptr;
  QCheckBox* follows_ = nullptr;
  QCheckBox* snaps_ = nullptr;
  QLabel* empty_ = nullptr;
  QVBoxLayout* list_ = nullptr;
  std::vector<MeasurementLine*> lines_;
  QLabel* own_ = nullptr;
  QWidget* others_ = nullptr;  ///< of the images beside
  QLabel* explanation_ = nullptr;
  QWidget* edits_ = nullptr;
  QPushButton *undo_ = nullptr, *redo_ = nullptr, *remove_ = nullptr, *clear_ = nullptr;
};

}  // namespace ew::ui
