#pragma once

#include <QMainWindow>
#include <QPoint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ew/core/result.h"
#include "ew/ui/run.h"

namespace ew {
enum class BreathingRequest;
enum class Permission;
struct DicomStudy;
struct Preset;
struct ScanRecording;
struct Thrown;
}  // namespace ew

namespace ew::door {
struct PluginStatus;
}

namespace ew::sdk {
class PanelDocument;
struct MenuEntry;
struct ShownVolume;
struct Workspace;
}  // namespace ew::sdk

class QAction;
class QDialog;
class QMenu;

namespace ew::ui {

class AnnotatedPictures;
class Calipers;
class WideScan;
class Worksheets;
class CaseDocument;
class CineBar;
class ConsolePanel;
class ControlSurface;
class HandInput;
class Jobs;
class KeyMap;
class MessageBar;
class Recorder;
class PictureGrid;
class ReplayBar;
class ScanView;
class Session;
class ShownMark;
class StoredExamination;
class Trackers;
class View3D;
struct LayoutRequest;
struct LeftWork;
struct MadeVolume;
struct SavedPart;
struct WindowLayout;

enum class Loss;
enum class Column;
enum class TourPlace;
enum class TrackerCourse;
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
  [[nodiscard]] Recorder& recorder();
  [[nodiscard]] WideScan& wideScan();
  [[nodiscard]] Calipers& calipers();
  [[nodiscard]] Worksheets& worksheets();
  [[nodiscard]] StoredExamination& stored();
  [[nodiscard]] AnnotatedPictures& annotated();
  [[nodiscard]] ShownMark& bodyMark();
  [[nodiscard]] PictureGrid& pictures();
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
  struct Parts;
  void makeViews();
  void makePanelColumn();
  void makeColumns();
  void watchViews();
  void makeActions();
  /// An entry of a menu without keys.
  QAction* addPlainAction(QMenu& menu, const QString& text, std::function<void()> run);
  /// An entry that is a command of key_table.h: it has that one's text and keys.
  QAction* addMenuAction(QMenu& menu, const std::string& command, std::function<void()> run);
  /// An entry that moves a control of the console. It is here and not at the control: the console may be hidden beside an author's panels.
  /// @param steps of ConsolePanel::step
  QAction* addConsoleAction(QMenu& menu, const std::string& command, const QString& control, int steps);
  void addFileMenu(QMenu& file);
  void addEditMenu(QMenu& edit);
  void addViewMenu(QMenu& view);
  void addThemeMenu(QMenu& theme);
  void addTextSizeMenu(QMenu& sizes);
  void chooseTextSize(int percent);
  void stepTextSize(int steps);
  [[nodiscard]] static int keptTextSize_percent();
  void beginTour();
  [[nodiscard]] bool goToForTour(TourPlace place);
  void addLanguageMenu(QMenu& language);
  void addScanMenu(QMenu& scan);
  void addCineMenu(QMenu& cine);
  void addRecordingMenu(QMenu& recording);
  void addConsoleMenu(QMenu& console);
  void addBreathingMenu(QMenu& breathing);
  void addMeasureMenu(QMenu& measure);
  void addAnnotateMenu(QMenu& annotate);
  void addWordMenu(QMenu& menu);
  void addBodyMarkMenu(QMenu& mark);
  void addPicturesMenu(QMenu& pictures);
  void addPresetMenu(QMenu& presets);
  void addZoomAndWideActions(QMenu& scan);
  void askBreathing(BreathingRequest request);
  void addImageMenu(QMenu& image);
  void addEffectsMenu(QMenu& effects);
  void addProbeMenu(QMenu& transducer);
  void addTimeMenu(QMenu& time);
  void addQualityMenu(QMenu& quality);
  void addHelpMenu(QMenu& help);
  void connectParts();
  void connectSession();   ///< what is scanned, recorded and shown
  void connectCalipers();  ///< tools, list and undo of what is measured
  void connectAnnotations();
  void connectZoomAndWide();
  void showWideState();
  void sayWhyRefused();
  void connectPictures();
  [[nodiscard]] std::vector<SavedPart> shownParts() const;  ///< all pictures, as they are saved
  [[nodiscard]] int pictureColumns() const;
  void showPictures();     ///< how many there are, and what was measured on each
  void connectDocument();  ///< the case, its edits and the panels of plugins
  void connectPages();
  void connectOpener();
  void connectImports();  ///< what has to be asked or made before it can be scanned
  void connectPreparation();
  void connectPlugins();
  void connectKeys();  ///< of the window, and the control surface
  void readOwnKeys();
  void showOwnKeys();  ///< of every action, as the present state has them
  void keepOwnKeys();  ///< in the user's file
  void editKeys();
  /// Does what a key of the command does. @return false: there is no such command now
  bool doCommand(const std::string& command);
  void placeOverlays();
  /// Prepares a case without taking what is open away, and offers it when it is ready. @return false: it needs no time, or takes nothing
  /// away
  bool prepareBehind(const QString& path, bool isSomethingWorkedWith);
  void offerReady(const QString& caseId);
  void chooseFile();
  void chooseBundle();
  void importCase(const QString& bundle);  ///< into the user's library, as a job; then the start page shows it
  void save(bool elsewhere);               ///< the case, or the document of the panel whose stage is shown
  bool saveCase(bool elsewhere);           ///< shows what went wrong. @return whether it is saved
  /// Asks first when the case is shipped or was saved by another program. @error cancelled: the user wants it unsaved for now
  [[nodiscard]] Result<void> saveCaseInPlace();
  /// Asks for a new folder. @param why it is asked for; may be empty
  [[nodiscard]] Result<void> saveCaseCopy(const QString& why);
  [[nodiscard]] Result<void> saveCaseFor(const std::filesystem::path& folder);  ///< for a plugin; empty: in place
  [[nodiscard]] Result<void> makeCaseOwn();
  void reloadCase();  ///< as its folder holds it; the changes made here go
  void saveShownVolume();
  /// Asks for a name and begins to save. @return false: nothing is saved
  bool saveVolume(const MadeVolume& made);
  void savePicture();
  void readAnnotationData(const std::filesystem::path& resources);  ///< word lists, body marks, presets
  void showRegion();                                                ///< whose words and body marks are offered
  void showPresets(QMenu& menu);
  void takePreset(const Preset& preset);
  [[nodiscard]] std::vector<Preset> presetsOfCase() const;  ///< that the case on show offers, the one it starts with first
  void beginScanOfCase();                                   ///< as firstState has it
  void savePreset();
  void importPreset();
  void withdraw(const QString& folder, const QString& title);  ///< takes a case out of the library, after a question
  void takeMade(const MadeVolume& made);                       ///< shows what was just made, or lets it wait
  void takeImported(const MadeVolume& imported);               ///< likewise of what lies in a file of another kind
  void showMade(const MadeVolume& made);
  void showWaitingVolume();
  [[nodiscard]] const MadeVolume* shownMadeVolume() const;            ///< null: what is shown was not made here, or is saved
  [[nodiscard]] std::optional<sdk::ShownVolume> shownVolume() const;  ///< that is no case's; empty: none
  [[nodiscard]] const MadeVolume* waitingMadeVolume() const;          ///< null: none
  void keepEdits();  ///< of the open case as it is now, or forgets them when there are none
  /// @param caseFolder empty: of whatever case
  void offerKeptEditsOf(const std::filesystem::path& caseFolder);
  void restoreKeptEdits();
  void rememberOpen(const QString& path);  ///< for openWhereOneWas
  void rememberClosing();
  void keepMadeVolumes();  ///< against a crash
  void askAboutLeft(std::vector<LeftWork> left);
  void resumeNext();  ///< opens what the first of Parts::resumed belongs to
  /// Whether what it was recorded and measured on is scanned now.
  [[nodiscard]] bool isOpenFor(const LeftWork& work) const;
  void resumeIfOpen();
  /// What is resumed is opened by a dialog that asks about its file: the dialog's end decides.
  void resumeWithAnswersOf(const QDialog& dialog, const QString& path);
  void resume();         ///< the first of Parts::resumed, as it is open
  void leaveForLater();  ///< it was not opened: the next start offers it again
  /// What it is of is not scanned: it stays where it is, and says how it comes back.
  void leaveUnshown(const LeftWork& work);
  void showLeftMeasured(const LeftWork& work);
  void takeLeftVolumes(const LeftWork& work);
  void remember(const QString& path);  ///< as opened recently
  void showCost();
  void connectTrackers();
  void showTrackerState();
  void showTracker();
  void leadToTracker(const std::string& tracker, TrackerCourse course);
  void showKeys();
  void showSource(const QPoint& pixel);
  void showCoverage();
  void showCoverageSoon();
  void showTitle();
  void showHistory();
  void showPanels();  ///< of the workspace in front, when it has any
  /// Puts the stage of the panel in front in place of the views, or the views back.
  void showStage();
  [[nodiscard]] std::shared_ptr<sdk::PanelDocument> panelDocument() const;  ///< of the stage that is shown
  void makeColumnHandles();
  void connectFocusKeys();
  bool doKeyInScan(QKeyEvent& event);
  [[nodiscard]] LayoutRequest layoutRequest() const;
  void showColumns();  ///< each where the window has room for it
  void showColumnTabs(const WindowLayout& layout);
  void showColumn(Column column);  ///< in front of those it takes turns with
  void showNextColumn();
  void setScanOnly(bool scanOnly);
  /// From the start page to what is open.
  void backToWork();
  void showRecent();
  void addAccessMenu(QMenu& file);
  void lockForTrainees();
  void unlockForInstructors();
  void showAccess();  ///< as the lock is now: rooms, tools, menus
  /// Whether something may be done; says why not.
  [[nodiscard]] bool may(Permission permission);
  /// Whether a file may be opened: not while it is in somebody else's attempt and the library is locked.
  [[nodiscard]] bool mayOpenPath(const QString& path);
  void showPicture();
  void paintOverBody();
  /// @param choice "dark", "light" or "system"
  void chooseTheme(const QString& choice);
  void refreshTheme();
  void connectLibrary();
  void readDetails();  ///< of the cards in sight
  /// Says what a handler of an event let through, and of whom: of the plugin whose panel `receiver` is a part of, or of the program.
  void showThrown(const QObject* receiver, const Thrown& thrown);
  void showPreparation();
  void fillStartPage();  ///< with the cases as they are now
  /// Asks about everything that is lost when something else is shown. @param next what that is. @return whether to go on
  [[nodiscard]] bool mayReplaceShown(const QString& next);
  /// The same where the case stays open and another volume is scanned.
  [[nodiscard]] bool mayReplaceScan(const QString& next);
  void holdUnsavedWork();           ///< the list of what can be lost, which every way to lose something asks
  [[nodiscard]] bool isSavedNow();  ///< waits for what is being saved
  [[nodiscard]] bool mayLeaveCase(const QString& next);
  [[nodiscard]] bool mayLeaveVolumes(Loss loss, const QString& next);
  [[nodiscard]] bool mayLeaveVolume(const MadeVolume& made, const QString& next);
  void forgetShownVolume();  ///< the user agreed to lose it
  void toggleRecording();
  void endRecording();  ///< and shows what was recorded, at rest
  void showRecordingState();
  void closeRecording();
  /// Asks for a name and begins to save. @return false: nothing is saved
  bool saveRecording();
  void showCineState();
  void saveClip();  ///< what runs in the loop of a frozen scan: as states, film or DICOM
  /// Asks for a name and begins to save. @param saved called when it is @return false: nothing is saved
  bool saveRecordingAs(const std::shared_ptr<const ScanRecording>& recording, const QString& title, const QString& proposal,
                       std::function<void()> saved);
  void startSavingRecording(const std::shared_ptr<const ScanRecording>& recording, const QString& file, std::function<void()> saved);
  [[nodiscard]] std::string recordedCase() const;  ///< id of the case that is scanned; empty: none
  /// Plays what was opened, once what was scanned is shown.
  void takeRecording(const QString& path, std::shared_ptr<const ScanRecording> recording);
  [[nodiscard]] bool mayLeaveRecording(const QString& next);
  [[nodiscard]] bool isRecordingUnsaved() const;
  [[nodiscard]] bool mayLeaveWorksheet(const QString& next);
  [[nodiscard]] bool mayLeaveStored(const QString& next);
  [[nodiscard]] bool mayLeaveMeasurements(const QString& next);
  void addStoringMenu(QMenu& file);
  [[nodiscard]] DicomStudy studyNow() const;  ///< of the patient who is scanned
  void storePicture();
  void followPatient();  ///< whose stored images are shown
  void showExamination();
  bool saveExamination();  ///< asks for a folder and begins to save. @return false: nothing is saved
  void sendExamination();
  void showWorksheet();
  void showCombine();
  bool saveMeasurements();
  bool saveWorksheet();
  [[nodiscard]] bool mayLeavePanels();
  [[nodiscard]] bool mayLeavePlugins(Loss loss, const QString& next);
  [[nodiscard]] bool mayClose();
  void loadWordsOf(const door::PluginStatus& plugin);
  [[nodiscard]] bool addWorkspace(const sdk::Workspace& workspace);
  [[nodiscard]] std::shared_ptr<void> addTool(const sdk::MenuEntry& entry, std::function<void()> run);
  std::unique_ptr<Parts> parts_;
};

}  // namespace ew::ui
