#pragma once

#include <QAction>
#include <QActionGroup>
#include <QMenu>
#include <QPointer>
#include <QSplitter>
#include <QStackedWidget>
#include <QTabWidget>
#include <QTimer>
#include <QTranslator>
#include <optional>

#include "annotate/annotation_layer.h"
#include "annotate/body_mark_view.h"
#include "body/body_tools.h"
#include "body/hand_input.h"
#include "body/view3d.h"
#include "case/case_document.h"
#include "case/case_info.h"
#include "case/case_preparation.h"
#include "ew/door/door.h"
#include "ew/library/access.h"
#include "ew/library/kept_edits.h"
#include "ew/scanning/preset.h"
#include "ew/ui/main_window.h"
#include "images/examination_dialog.h"
#include "images/picture_grid.h"
#include "images/stored_examination.h"
#include "import/opener.h"
#include "jobs/jobs.h"
#include "jobs/jobs_line.h"
#include "jobs/message_bar.h"
#include "keys/control_surface.h"
#include "keys/focus_keys.h"
#include "keys/key_map.h"
#include "keys/key_tips.h"
#include "keys/keys_dialog.h"
#include "keys/shortcuts_overlay.h"
#include "measure/calipers/caliper_layer.h"
#include "measure/calipers/calipers.h"
#include "measure/combine_dialog.h"
#include "measure/measure_page.h"
#include "measure/worksheets/worksheet_dialog.h"
#include "measure/worksheets/worksheets.h"
#include "plugins/workspace_panels.h"
#include "plugins/workstation_host.h"
#include "scan/cine/cine_bar.h"
#include "scan/cine/recorder.h"
#include "scan/cine/replay_bar.h"
#include "scan/console/console_panel.h"
#include "scan/cost/cost_panel.h"
#include "scan/scan_view.h"
#include "scan/session.h"
#include "scan/source/source_dialog.h"
#include "scan/source/source_picker.h"
#include "scan/status_line.h"
#include "scan/zoom/box_zoom.h"
#include "scan/zoom/scan_pan.h"
#include "scan/zoom/wide_layer.h"
#include "scan/zoom/wide_scan.h"
#include "scan/zoom/zoom_overview.h"
#include "start/case_details.h"
#include "start/learning.h"
#include "start/library_browser.h"
#include "start/start_page.h"
#include "trackers/control/tracker_control.h"
#include "trackers/tracker_page.h"
#include "trackers/wizard/tracker_wizard.h"
#include "widgets/window_layout.h"
#include "window/top_bar.h"
#include "window/tour.h"
#include "window/unsaved_work.h"
#include "window/view_columns.h"
#include "window/work_autosave.h"

class QHBoxLayout;
class QPushButton;

namespace ew::ui {

class ColumnTabs;

/// A volume that was made here and lies in no file yet.
struct MadeVolume {
  QString path;   ///< of what it was made from
  QString title;  ///< for people
  ScanVoxels voxels;
  std::shared_ptr<const Provenance> provenance;  ///< may be null
};

inline const std::string kExplore = "explore";
inline const std::string kAuthor = "author";

/// Of messages about a case that is prepared behind what is open.
inline QString readyTopic(const std::string& caseId) { return QStringLiteral("ready ") + QString::fromStdString(caseId); }
inline QString draftTopic(const std::string& caseId) { return QStringLiteral("draft ") + QString::fromStdString(caseId); }

/// What the window is made of. Values first, so that they outlive the widgets and plugins that use them.
struct MainWindow::Parts {
  Parts();

  Session session;
  CaseDocument document;
  Jobs jobs;
  CasePreparation preparation{jobs};
  LibraryBrowser library{jobs};
  CaseDetails details;
  Learning learning;
  AccessPolicy access = AccessPolicy::of(libraryFolder());
  QTimer detailsSoon;
  std::vector<MadeVolume> made;  ///< never saved: the one that is shown, and those that wait
  KeptEdits keptEdits;           ///< of the open case, against a crash
  QTimer keepSoon;
  std::vector<std::filesystem::path> decideLater;  ///< kept edits that the user wants to decide about another time
  std::optional<KeptEdits::Left> restoring;        ///< edits that are taken over once their case is open
  bool asksAboutKept = false;                      ///< the question about kept edits is open: none is asked in the middle of it
  bool dropsEdits = false;                         ///< the case is being opened again, and the user gave up the changes made here
  QStringList calibrations;                        ///< dropped together with the sweep that is opened
  QString preparing;                               ///< the case that is opened and has to be made first
  std::map<std::string, QString> readyOffers;      ///< cases by id, with their paths, that are prepared behind what is open
  QString imported;                                ///< folder of the case that was taken into the library and is to be shown there
  KeyMap keys;
  KeyTips keyTips{keys};
  ControlSurface surface;
  struct KeyedAction {
    QAction* action;
    std::string command;
  };
  std::vector<KeyedAction> keyedActions;  ///< an action may be several commands
  bool ownKeysAreBroken = false;          ///< the user's file of keys cannot be read
  HandInput hand{session.hand()};
  Trackers trackers{session, jobs};
  Recorder recorder{session};
  WideScan wide{session};
  Calipers calipers{session, jobs};
  Worksheets worksheets{session, calipers};
  StoredExamination stored{session, worksheets};
  WorkAutosave autosave;          ///< what was recorded, measured and made, against a crash
  std::vector<LeftWork> resumed;  ///< what a crash has left and is gone on with, one after the other, the first first
  bool isResuming = false;        ///< what the first one belongs to is being opened
  std::string storesFor;          ///< who stored the images of the examination, as they call themselves
  bool isSending = false;
  bool patientSoon = false;  ///< another patient is about to be scanned
  AnnotatedPictures annotated{session};
  ShownMark bodyMark{session};
  std::vector<Preset> presets;         ///< of the program
  measurement::Measurements measured;  ///< as they were when they changed last
  std::optional<std::uint64_t> measuredPicture;
  std::shared_ptr<const ScanRecording> savedRecording;  ///< that lies in a file; another one in the replay bar does not
  std::filesystem::path replayed;                       ///< the file of its recording; empty: none yet
  UnsavedWork unsaved;                                  ///< all that could be lost; every way to lose something asks it
  struct {
    QString path;
    std::shared_ptr<const ScanRecording> recording;
  } waitingRecording;  ///< for its case, which is being opened

  QWidget* central = nullptr;
  TopBar* topBar = nullptr;
  QStackedWidget* pages = nullptr;
  StartPage* startPage = nullptr;
  QWidget* workspacePage = nullptr;
  WorkspacePanels* panels = nullptr;
  QStackedWidget* stages = nullptr;  ///< what panels bring in place of the views
  bool staged = false;
  QHBoxLayout* work = nullptr;  ///< columns and console
  QSplitter* columns = nullptr;
  std::vector<std::pair<Column, ColumnTabs*>> columnTabs;  ///< one in each of panels, body and console
  QPushButton* comeBack = nullptr;                         ///< from the scan alone
  std::optional<Column> askedColumn;                       ///< of those that take turns, when somebody has chosen
  View3D* view3d = nullptr;
  QTimer coverageSoon;                     ///< runs out when what is scanned is not moved any more
  std::weak_ptr<const Volume> coverageOf;  ///< whose tint the skin has
  CaseInfo* caseInfo = nullptr;
  BodyColumn* body = nullptr;  ///< 3D view and case
  ViewColumns* viewColumns = nullptr;
  Hold beforePress;  ///< where the probe was before the last press in a view
  ScanView* scanView = nullptr;
  PictureGrid* pictures = nullptr;  ///< with the scan view, and what stands beside it
  PickLayer* pointing = nullptr;    ///< for plugins that ask for a point
  BodyTools* bodyTools = nullptr;   ///< for plugins that move something in the body or ask for a place on it
  SourcePicker* sourcePicker = nullptr;
  CaliperLayer* caliperLayer = nullptr;
  CaliperLayer* stripCaliperLayer = nullptr;
  AnnotationLayer* annotationLayer = nullptr;
  BodyMarkView* bodyMarkView = nullptr;
  BoxZoom* boxZoom = nullptr;
  ConsolePanel* console = nullptr;
  MeasurePage* measurePage = nullptr;
  ReplayBar* replayBar = nullptr;
  CineBar* cineBar = nullptr;
  StatusLine* status = nullptr;
  MessageBar* messages = nullptr;
  JobsLine* jobsLine = nullptr;
  Opener* opener = nullptr;
  WorkstationHost* host = nullptr;
  std::optional<door::PluginList> plugins;
  QPointer<ShortcutsOverlay> shortcuts;
  QPointer<KeysDialog> keysDialog;
  QPointer<Tour> tour;
  FocusKeys focusKeys;
  QPointer<CostPanel> cost;
  QPointer<TrackerPage> trackerPage;
  QPointer<TrackerWizard> trackerWizard;
  QPointer<SourceDialog> source;
  QPointer<WorksheetDialog> worksheet;
  QPointer<ExaminationDialog> examination;
  QPointer<CombineDialog> combine;

  QAction* startPageAction = nullptr;
  QAction* undoAction = nullptr;
  QAction* redoAction = nullptr;
  QAction* saveAction = nullptr;
  QAction* saveAsAction = nullptr;
  QAction* saveVolumeAction = nullptr;
  QAction* savePictureAction = nullptr;
  QAction* storeAction = nullptr;
  QAction* caseVolumeAction = nullptr;
  QAction* madeVolumeAction = nullptr;
  QAction* exploreAction = nullptr;
  QAction* authorAction = nullptr;
  QActionGroup* workspaceActions = nullptr;
  QMenu* viewMenu = nullptr;
  QAction* beforeLooks = nullptr;  ///< in the view menu, behind the workspaces
  QMenu* toolsMenu = nullptr;      ///< of plugins; seen once it has an entry
  QMenu* fileMenu = nullptr;
  QAction* beforeOpening = nullptr;  ///< in the menu of files: before it stands what plugins begin a case with
  QAction* systemThemeAction = nullptr;
  QAction* darkAction = nullptr;
  QAction* lightAction = nullptr;
  QActionGroup* textSizes = nullptr;
  QMenu* scanMenu = nullptr;
  QAction* freezeAction = nullptr;
  std::vector<QAction*> cineActions;    ///< while there is a loop to look through
  std::vector<QAction*> ofRunningScan;  ///< whose keys those of the loop are
  QAction* recordAction = nullptr;
  QAction* markAction = nullptr;
  QAction* saveRecordingAction = nullptr;
  QAction* scanOnlyAction = nullptr;
  QAction* sourceAction = nullptr;
  std::vector<QAction*> caliperActions;  ///< as measurement::drawnKinds(), then stripKinds()
  QAction* followEdgesAction = nullptr;
  QAction* snapAction = nullptr;
  QAction* textAction = nullptr;
  QAction* arrowAction = nullptr;
  QAction* boxZoomAction = nullptr;
  QAction* wholeImageAction = nullptr;
  QAction* wideAction = nullptr;
  QAction* bodyMarkAction = nullptr;
  std::vector<QAction*> pictureCounts;  ///< 1, 2, 4
  QAction* nextPictureAction = nullptr;
  QAction* sameScaleAction = nullptr;
  QAction* lockAction = nullptr;
  QAction* unlockAction = nullptr;
  QAction* removeLockAction = nullptr;
  QAction* transducerAction = nullptr;  ///< shares its key with texts: of a picture that moves
  QMenu* recentMenu = nullptr;
  std::string workspace = kExplore;
  struct OwnWorkspace {
    sdk::Workspace what;
    QAction* action;
  };
  std::vector<OwnWorkspace> ownWorkspaces;  ///< of plugins
  struct ToolEntry {
    QAction* action;
    std::string workspace;
  };
  std::vector<ToolEntry> tools;
  std::vector<std::unique_ptr<QTranslator>> pluginWords;
  [[nodiscard]] bool isAuthor() const { return workspace == kAuthor; }
  /// Whether undo and redo mean the calipers: an author's case has edits of its own, so there the calipers must have the keys.
  [[nodiscard]] bool editsCalipers() const;
  /// ... or the texts and arrows, by the same rule.
  [[nodiscard]] bool editsAnnotations() const;
  /// Of a plugin, when such a one is in front.
  [[nodiscard]] const sdk::Workspace* ownWorkspace() const;
  [[nodiscard]] bool hasPanels() const;
  [[nodiscard]] bool keepsBody() const { return ownWorkspace() == nullptr || ownWorkspace()->keepsBody; }
  [[nodiscard]] bool keepsScan() const { return ownWorkspace() == nullptr || ownWorkspace()->keepsScan; }
};

}  // namespace ew::ui
