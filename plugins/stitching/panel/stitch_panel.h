#pragma once

#include <QWidget>
#include <memory>
#include <vector>

#include "ew/sdk/host.h"
#include "ew/sdk/panel.h"
#include "logic/output.h"

class QComboBox;
class QLabel;
class QListWidget;
class QPushButton;
class QStackedWidget;

namespace ew::stitching {

/// Joins volumes by hand: a list with places, the options of the result, a forecast, and a job. Volumes are added with the button or by
/// dropping files; a stitch project (.json) adds everything in it.
class StitchPanel final : public QWidget {
  Q_OBJECT

 public:
  explicit StitchPanel(sdk::Host& host, QWidget* parent = nullptr);

  /// Reads volumes (or stitch projects) in a job each and appends them to the list.
  void addFiles(const std::vector<std::filesystem::path>& files);
  /// Starts the job; the result is shown in the workstation.
  void startStitching();
  /// Writes the last result into `folder`, as `echoweave stitch` does.
  void saveResult(const std::filesystem::path& folder);
  [[nodiscard]] StitchProject project() const;

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  struct Entry {
    ProjectVolume place;
    std::shared_ptr<const Volume> volume;
  };
  struct Finished {
    StitchResult result;
    StitchProject project;
  };

  QWidget* makeWorkPage();
  QWidget* makeVolumeBox();
  QWidget* makeResultBox();
  /// Takes over the project's options and gives its volumes; says why when it cannot.
  std::vector<ProjectVolume> readProject(const std::filesystem::path& file);
  void readEntries(std::vector<ProjectVolume> places);
  void appendEntry(Entry entry);
  void removeSelected();
  void chooseTransform();
  void chooseCoverage();
  void askForFiles();
  void askWhereToSave();
  void askWhereToSaveProject();
  void showSelected();
  void showForecast();
  void showFinished();
  void say(const Error& problem);
  [[nodiscard]] Entry* selected();

  sdk::Host& host_;
  std::vector<Entry> entries_;
  std::shared_ptr<const Finished> finished_;
  bool stitching_ = false;

  QStackedWidget* pages_ = nullptr;
  QListWidget* list_ = nullptr;
  QWidget* volumeBox_ = nullptr;
  QLabel* volumeLine_ = nullptr;
  QLabel* coverageLine_ = nullptr;
  sdk::PlacementFields* placement_ = nullptr;
  sdk::NumberField* spacing_ = nullptr;
  sdk::NumberField* feather_ = nullptr;
  QComboBox* axes_ = nullptr;
  QLabel* forecast_ = nullptr;
  QLabel* problem_ = nullptr;
  QLabel* outcome_ = nullptr;
  QPushButton* start_ = nullptr;
  QPushButton* save_ = nullptr;
};

}  // namespace ew::stitching
