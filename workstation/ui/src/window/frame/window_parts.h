#pragma once

#include <QHBoxLayout>
#include <QMainWindow>
#include <QSplitter>
#include <QStackedWidget>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "annotate/annotation_layer.h"
#include "annotate/body_mark_view.h"
#include "body/body_tools.h"
#include "body/hand_input.h"
#include "body/view3d.h"
#include "case/case_document.h"
#include "case/case_info.h"
#include "case/case_preparation.h"
#include "ew/core/responsive_thread.h"
#include "ew/door/door.h"
#include "ew/library/access.h"
#include "images/examination_store.h"
#include "images/image_grid.h"
#include "import/opener.h"
#include "jobs/jobs.h"
#include "jobs/jobs_line.h"
#include "jobs/message_bar.h"
#include "keys/control_surface.h"
#include "keys/focus_keys.h"
#include "keys/key_map.h"
#include "keys/key_tips.h"
#include "measure/calipers/caliper_layer.h"
#include "measure/calipers/calipers.h"
#include "measure/measure_page.h"
#include "measure/worksheets/worksheets.h"
#include "plugins/workspace_panels.h"
#include "plugins/workstation_host.h"
#include "scan/cine/cine_bar.h"
#include "scan/cine/recorder.h"
#include "scan/cine/replay_bar.h"
#include "scan/console/console_panel.h"
#include "scan/scan_view.h"
#include "scan/session.h"
#include "scan/source/source_picker.h"
#include "scan/status_line.h"
#include "scan/zoom/box_zoom.h"
#include "scan/zoom/wide_scan.h"
#include "start/case_details.h"
#include "start/learning.h"
#include "start/library_browser.h"
#include "start/recent_files.h"
#include "start/start_page.h"
#include "trackers/control/tracker_control.h"
#include "window/frame/feature.h"
#include "window/frame/top_bar.h"
#include "window/frame/unsaved_work.h"
#include "window/frame/view_columns.h"
#include "window/frame/work_autosave.h"

namespace ew::ui {

class AccessLock;
class Annotating;
class Appearance;
class BodyAndProbe;
class CaseLibrary;
class CaseSaving;
class Cine;
class Columns;
class Commands;
class ConsoleMenus;
class Help;
class Images;
class Inspecting;
class Measuring;
class Opening;
class OwnKeys;
class PluginHosting;
class Preparing;
class Presets;
class Recording;
class Resuming;
class Storing;
class TitleLine;
class Tracking;
class Undo;
class UnsavedVolumes;
class Workspaces;
class ZoomAndWide;

/// Folder of what the program keeps for the user.
[[nodiscard]] std::filesystem::path ownDataFolder();

/// What the window is made of and its features share. Values first, so that they outlive the widgets and plugins that use them.
struct WindowParts {
  explicit WindowParts(QMainWindow& window);
  ~WindowParts();

  ResponsiveThread thread;  ///< on which nobody waits for a case: what reads one is a job
  QMainWindow& window;      ///< that dialogs belong to
  Session session;
  CaseDocument document;
  Jobs jobs;
  CasePreparation preparation{jobs};
  LibraryBrowser library{jobs};
  CaseDetails details;
  Learning learning;
  RecentFiles recent;
  AccessPolicy access = AccessPolicy::of(libraryFolder());
  KeyMap keys;
  KeyTips keyTips{keys};
  ControlSurface surface;
  HandInput hand{session.probeControl().hand()};
  Trackers trackers{session, jobs};
  Recorder recorder{session};
  WideScan wide{session};
  Calipers calipers{session, jobs};
  Worksheets worksheets{session, calipers};
  ExaminationStore stored{session, worksheets};
  WorkAutosave autosave;  ///< what was recorded, measured and made, against a crash
  ImageAnnotations annotated{session};
  ImageBodyMark bodyMark{session};
  UnsavedWork unsaved;  ///< all that could be lost; every way to lose something asks it
  FocusKeys focusKeys;

  QWidget* central = nullptr;
  TopBar* topBar = nullptr;
  QStackedWidget* pages = nullptr;
  StartPage* startPage = nullptr;
  QWidget* workspacePage = nullptr;
  WorkspacePanels* panels = nullptr;
  QStackedWidget* stages = nullptr;  ///< what panels bring in place of the views
  QHBoxLayout* work = nullptr;       ///< columns and console
  QSplitter* columnSplitter = nullptr;
  View3D* view3d = nullptr;
  CaseInfo* caseInfo = nullptr;
  BodyColumn* body = nullptr;  ///< 3D view and case
  ViewColumns* viewColumns = nullptr;
  ScanView* scanView = nullptr;
  ImageGrid* imageGrid = nullptr;  ///< with the scan view, and what stands beside it
  PickLayer* pointing = nullptr;   ///< for plugins that ask for a point
  BodyTools* bodyTools = nullptr;  ///< for plugins that move something in the body or ask for a place on it
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

  // The features, for those that need something of another one.
  Commands* commands = nullptr;
  Workspaces* workspaces = nullptr;
  Columns* columns = nullptr;
  TitleLine* titleLine = nullptr;
  Undo* undo = nullptr;
  Appearance* appearance = nullptr;
  Opening* opening = nullptr;
  CaseSaving* caseSaving = nullptr;
  UnsavedVolumes* volumes = nullptr;
  Recording* recording = nullptr;
  Measuring* measuring = nullptr;
  Storing* storing = nullptr;
  Resuming* resuming = nullptr;
  Preparing* preparing = nullptr;
  CaseLibrary* caseLibrary = nullptr;
  AccessLock* accessLock = nullptr;
  Cine* cine = nullptr;
  Images* images = nullptr;
  Annotating* annotating = nullptr;
  Presets* presets = nullptr;
  ZoomAndWide* zoomAndWide = nullptr;
  ConsoleMenus* consoleMenus = nullptr;
  BodyAndProbe* bodyAndProbe = nullptr;
  Inspecting* inspecting = nullptr;
  Tracking* tracking = nullptr;
  OwnKeys* ownKeys = nullptr;
  Help* help = nullptr;
  PluginHosting* pluginHosting = nullptr;

  /// Every feature shows the present state.
  void refresh();
  /// ... in the present theme and size of words.
  void restyle();
  /// Whether something may be done; says why not.
  [[nodiscard]] bool may(Permission permission);
  /// Waits for what is being saved.
  [[nodiscard]] bool isSavedNow();
  /// Begins to listen, every feature, and fills the list of what can be lost.
  void connectFeatures();
  /// No feature hears of the sender any more.
  void stopHearing(QObject& sender);
  /// Features go, and their dialogs with them: after the plugins, whose last words go through features, and before the views.
  void deleteFeatures();

 private:
  void makeFeatures();
  template <class Made>
  void make(Made*& into);
  std::unique_ptr<Commands> ownedCommands_;
  std::vector<std::unique_ptr<Feature>> features_;  ///< in the order in which they connect, show and are asked
};

}  // namespace ew::ui
