#include "window/menus.h"

#include <QCoreApplication>
#include <QMenuBar>

#include "window/features/access_lock.h"
#include "window/features/annotating.h"
#include "window/features/body_and_probe.h"
#include "window/features/case_library.h"
#include "window/features/case_saving.h"
#include "window/features/cine.h"
#include "window/features/console_menus.h"
#include "window/features/help.h"
#include "window/features/images.h"
#include "window/features/inspecting.h"
#include "window/features/measuring.h"
#include "window/features/opening.h"
#include "window/features/plugin_hosting.h"
#include "window/features/presets.h"
#include "window/features/recording.h"
#include "window/features/storing.h"
#include "window/features/tracking.h"
#include "window/features/unsaved_volumes.h"
#include "window/frame/appearance.h"
#include "window/frame/columns.h"
#include "window/frame/commands.h"
#include "window/frame/undo.h"
#include "window/frame/window_parts.h"
#include "window/frame/workspaces.h"

namespace ew::ui {
namespace {

/// Titles of menus.
struct Menus {
  Q_DECLARE_TR_FUNCTIONS(ew::ui::Menus)
};

void fillFileMenu(WindowParts& p, QMenu& file) {
  p.pluginHosting->setFileMenu(file);
  p.opening->addFileActions(file);
  p.caseLibrary->addImportAction(file);
  p.opening->addRecentMenu(file);
  p.caseLibrary->addStartActions(file);
  file.addSeparator();
  p.caseSaving->addActions(file);
  p.volumes->addSaveAction(file);
  p.images->addSaveAction(file);
  p.storing->addActions(file);
  file.addSeparator();
  p.accessLock->addActions(file);
  file.addSeparator();
  p.commands->add(file, "quit", [&p] { p.window.close(); });
}

void fillViewMenu(WindowParts& p, QMenu& view) {
  p.workspaces->addMenu(view);
  p.bodyAndProbe->addLooks(view);
  p.volumes->addViewActions(view);
  view.addSeparator();
  p.appearance->addMenus(view);
  p.columns->addMenu(view);
  p.commands->add(view, "fullScreen", [&p] { p.window.setWindowState(p.window.windowState() ^ Qt::WindowFullScreen); });
}

void fillScanMenu(WindowParts& p, QMenu& scan) {
  p.commands->setScanMenu(scan);
  scan.setToolTipsVisible(true);
  p.cine->addFreezeAction(scan);
  p.cine->addMenu(*scan.addMenu(Menus::tr("&Cine loop")));
  p.recording->addMenu(*scan.addMenu(Menus::tr("&Recording")));
  p.inspecting->addSourceAction(scan);
  scan.addSeparator();
  p.presets->addMenu(*scan.addMenu(Menus::tr("Prese&ts")));
  p.consoleMenus->addConsoleMenu(*scan.addMenu(Menus::tr("C&onsole")));
  p.consoleMenus->addBreathingMenu(*scan.addMenu(Menus::tr("&Breathing")));
  p.measuring->addMenu(*scan.addMenu(Menus::tr("Mea&sure")));
  p.annotating->addMenu(*scan.addMenu(Menus::tr("&Annotate")));
  p.annotating->addBodyMarkMenu(*scan.addMenu(Menus::tr("Body mar&k")));
  p.images->addMenu(*scan.addMenu(Menus::tr("P&ictures")));
  scan.addSeparator();
  p.tracking->addAction(scan);
  p.inspecting->addCostAction(scan);
}

}  // namespace

void fillMenus(WindowParts& parts) {
  QMenuBar& bar = parts.topBar->menus();
  fillFileMenu(parts, *bar.addMenu(Menus::tr("&File")));
  parts.undo->addMenu(*bar.addMenu(Menus::tr("&Edit")));
  fillViewMenu(parts, *bar.addMenu(Menus::tr("&View")));
  fillScanMenu(parts, *bar.addMenu(Menus::tr("&Scan")));
  parts.pluginHosting->setToolsMenu(*bar.addMenu(Menus::tr("&Tools")));
  parts.help->addMenu(*bar.addMenu(Menus::tr("&Help")));
}

}  // namespace ew::ui
