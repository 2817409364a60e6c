#include "window/frame/window_parts.h"

#include <QStandardPaths>

#include "ew/widgets/words.h"
#include "jobs/saving_dialog.h"
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
#include "window/features/own_keys.h"
#include "window/features/plugin_hosting.h"
#include "window/features/preparing.h"
#include "window/features/presets.h"
#include "window/features/recording.h"
#include "window/features/resuming.h"
#include "window/features/storing.h"
#include "window/features/tracking.h"
#include "window/features/unsaved_volumes.h"
#include "window/features/zoom_and_wide.h"
#include "window/frame/appearance.h"
#include "window/frame/columns.h"
#include "window/frame/commands.h"
#include "window/frame/title_line.h"
#include "window/frame/undo.h"
#include "window/frame/workspaces.h"

// In this room and not beside its header, because it names every feature.

namespace ew::ui {

std::filesystem::path ownDataFolder() {
  return pathOf(QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation)) / "echoweave";
}

WindowParts::WindowParts(QMainWindow& owner)
    : window(owner), autosave(ownDataFolder() / "unsaved-work", session, recorder, calipers, worksheets) {
  makeFeatures();
}

WindowParts::~WindowParts() { deleteFeatures(); }

template <class Made>
void WindowParts::make(Made*& into) {
  auto made = std::make_unique<Made>(*this);
  into = made.get();
  features_.push_back(std::move(made));
}

/// The order counts twice: of two that listen to one signal the earlier hears it first, and questions about unsaved work come in it.
void WindowParts::makeFeatures() {
  ownedCommands_ = std::make_unique<Commands>(*this);
  commands = ownedCommands_.get();
  make(cine);
  make(caseSaving);
  make(volumes);
  make(recording);
  make(bodyAndProbe);
  make(titleLine);
  make(measuring);
  make(storing);
  make(inspecting);
  make(annotating);
  make(zoomAndWide);
  make(images);
  make(undo);
  make(columns);
  make(workspaces);
  make(caseLibrary);
  make(opening);
  make(preparing);
  make(resuming);
  make(pluginHosting);
  make(tracking);
  make(ownKeys);
  make(presets);
  make(consoleMenus);
  make(accessLock);
  make(help);
  make(appearance);
}

void WindowParts::refresh() {
  for (const auto& each : features_) each->refresh();
}

void WindowParts::restyle() {
  for (const auto& each : features_) each->restyle();
}

bool WindowParts::may(Permission permission) {
  const auto allowed = access.require(permission);
  if (!allowed) messages->showError(allowed.error(), QStringLiteral("access"));
  return allowed.has_value();
}

bool WindowParts::isSavedNow() { return SavingDialog(jobs, false, &window).wait() == SavingDialog::Outcome::saved; }

void WindowParts::connectFeatures() {
  for (const auto& each : features_) each->connectParts();
  for (const auto& each : features_) each->holdUnsavedWork(unsaved);
}

void WindowParts::stopHearing(QObject& sender) {
  for (const auto& each : features_) sender.disconnect(each.get());
}

void WindowParts::deleteFeatures() {
  while (!features_.empty()) features_.pop_back();
}

}  // namespace ew::ui
