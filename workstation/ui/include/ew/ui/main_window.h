#pragma once

#include <QMainWindow>
#include <memory>
#include <string>

namespace ew::ui {

class ImageAnnotations;
class Calipers;
class CaseDocument;
class CineBar;
class ConsolePanel;
class ControlSurface;
class HandInput;
class Jobs;
class KeyMap;
class MessageBar;
class ImageGrid;
class Recorder;
class ReplayBar;
class ScanView;
class Session;
class ImageBodyMark;
class ExaminationStore;
class Trackers;
class View3D;
class WideScan;
class Worksheets;
struct WindowParts;

enum class Workspace { explore, author };

/// The window of the workstation. It opens nothing by itself; run() or a test says what.
class MainWindow final : public QMainWindow {
  Q_OBJECT

 public:
  explicit MainWindow(QWidget* parent = nullptr);
  ~MainWindow() override;

  /// A case folder, a case.json, a volume or a sweep; a problem becomes a message and changes nothing.
  void open(const QString& path);
  /// Opens a case, or goes back to it, and begins or goes on with a lesson of it.
  void openLesson(const QString& folder, const QString& lessonId);
  /// The first shipped case that is prepared, else the one that is prepared soonest, or the start page when there is none.
  void openDefaultCase();
  /// What was open when the program ended last; when that is not known, is gone, or could not be opened then, the default case.
  void openWhereOneWas();
  /// Asks about edits of cases that a crash has interrupted, one after the other.
  void offerKeptEdits();
  /// Asks about what else a crash has left: recordings, measurements, made volumes, a running lesson. It is read in a job first.
  void offerUnsavedWork();
  void showStartPage();
  /// Makes the volumes of the shipped cases that have none yet, in the background.
  void prepareCases();
  void setWorkspace(Workspace workspace);
  void showWorkspace(const std::string& id);  ///< "explore", "author" or one of a plugin's; any other changes nothing
  void setDarkTheme(bool dark);
  /// Finds and opens the plugins; their panels become tabs of their workspaces.
  void openPlugins();

  /// Shows the tour when nobody has seen it yet; it asks nothing and can be left at any moment.
  void offerTour();

  /// Nothing is being loaded, and there is an image of the scan; on a plugin's stage no body is being drawn.
  [[nodiscard]] bool isSettled() const;

  [[nodiscard]] Session& session();
  [[nodiscard]] CaseDocument& document();
  [[nodiscard]] Jobs& jobs();
  [[nodiscard]] MessageBar& messages();
  [[nodiscard]] ScanView& scanView();
  [[nodiscard]] View3D& view3d();
  [[nodiscard]] HandInput& hand();
  [[nodiscard]] ConsolePanel& console();
  [[nodiscard]] Recorder& recorder();
  [[nodiscard]] WideScan& wideScan();
  [[nodiscard]] Calipers& calipers();
  [[nodiscard]] Worksheets& worksheets();
  [[nodiscard]] ExaminationStore& stored();
  [[nodiscard]] ImageAnnotations& annotated();
  [[nodiscard]] ImageBodyMark& bodyMark();
  [[nodiscard]] ImageGrid& images();
  [[nodiscard]] ReplayBar& replayBar();
  [[nodiscard]] CineBar& cineBar();
  [[nodiscard]] KeyMap& keys();
  [[nodiscard]] ControlSurface& surface();
  [[nodiscard]] Trackers& trackers();

 protected:
  void closeEvent(QCloseEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void makeViews();
  void makePanelColumn();
  void makeColumns();
  void watchViews();
  [[nodiscard]] bool mayClose();
  std::unique_ptr<WindowParts> parts_;
};

}  // namespace ew::ui
