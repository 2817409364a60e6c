#pragma once

#include <QMainWindow>
#include <QPoint>
#include <memory>

#include "ew/ui/run.h"

namespace ew {
struct Thrown;
}

namespace ew::sdk {
class PanelDocument;
}

namespace ew::ui {

class CaseDocument;
class ConsolePanel;
class HandInput;
class Jobs;
class MessageBar;
class ScanView;
class Session;
class View3D;

enum class Workspace { explore, author };

/// The window of the workstation. It opens nothing by itself; run() or a test says what.
class MainWindow final : public QMainWindow {
  Q_OBJECT

 public:
  explicit MainWindow(QWidget* parent = nullptr);
  ~MainWindow() override;

  /// A case folder, a case.json, a volume or a sweep; a problem becomes a message and changes nothing.
  void open(const QString& path);
  /// The first shipped case that is prepared, else the one that is prepared soonest, or the start page when there is none.
  void openDefaultCase();
  void showStartPage();
  /// Makes the volumes of the shipped cases that have none yet, in the background.
  void prepareCases();
  void setWorkspace(Workspace workspace);
  void setDarkTheme(bool dark);
  /// Finds and opens the plugins; their panels become tabs of the Author workspace.
  void openPlugins();

  /// Nothing is being loaded, and the picture and the 3D view are drawn.
  [[nodiscard]] bool isSettled() const;

  [[nodiscard]] Session& session();
  [[nodiscard]] CaseDocument& document();
  [[nodiscard]] Jobs& jobs();
  [[nodiscard]] MessageBar& messages();
  [[nodiscard]] ScanView& scanView();
  [[nodiscard]] View3D& view3d();
  [[nodiscard]] HandInput& hand();
  [[nodiscard]] ConsolePanel& console();

 protected:
  void closeEvent(QCloseEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  struct Parts;
  void makeViews();
  void makeActions();
  void connectParts();
  void placeOverlays();
  void chooseFile();
  void save(bool elsewhere);  ///< the case, or the document of the panel whose stage is shown
  void saveCase(bool elsewhere);
  void saveVolume();
  void savePicture();
  void showCost();
  void showSource(const QPoint& pixel);
  void showTitle();
  void showHistory();
  /// Puts the stage of the panel in front in place of the views, or the views back.
  void showStage();
  [[nodiscard]] sdk::PanelDocument* panelDocument() const;  ///< of the stage that is shown
  void showRecent();
  void showPicture();
  void refreshTheme();
  void prepareThumbnails();
  /// Says what a handler of an event let through, and of whom: of the plugin whose panel `receiver` is a part of, or of the program.
  void showThrown(const QObject* receiver, const Thrown& thrown);
  void showPreparation();
  /// Asks when the case has unsaved changes. @return whether to go on
  [[nodiscard]] bool mayLeaveCase();
  std::unique_ptr<Parts> parts_;
};

}  // namespace ew::ui
