// The user's keys and the control surface: what they act on, where they are kept, and the editor.
#include <QDir>
#include <QFileInfo>
#include <QSettings>
#include <QSlider>
#include <algorithm>
#include <map>

#include "ew/controls/keys_file.h"
#include "keys/keys_dialog.h"
#include "widgets/figures.h"
#include "widgets/words.h"
#include "window/main_window_parts.h"

namespace ew::ui {
namespace {

const auto kKeysTopic = QStringLiteral("keys");

/// Beside the settings.
std::filesystem::path ownKeysFile() { return pathOf(QFileInfo(QSettings().fileName()).dir().filePath(QStringLiteral("keys.json"))); }

/// A slider of the console or of the TGC.
SurfaceSetting settingOf(QSlider* slider, const QString& group, bool hasBox) {
  SurfaceSetting made;
  made.id = slider->objectName().toStdString();
  made.group = group;
  made.name = slider->accessibleName();
  // A slider is hidden with the box around it, which says that the probe does not have it.
  made.isThere = [slider, hasBox] { return slider->isEnabled() && !(hasBox && slider->parentWidget()->isHidden()); };
  made.present = [slider]() -> std::optional<double> {
    const int range = slider->maximum() - slider->minimum();
    return range > 0 ? static_cast<double>(slider->value() - slider->minimum()) / range : 0.0;
  };
  made.to = [slider](double share) {
    slider->setValue(slider->minimum() + static_cast<int>(std::lround(share * (slider->maximum() - slider->minimum()))));
  };
  made.by = [slider](double steps) {
    const double step = std::max(1.0, static_cast<double>(slider->maximum() - slider->minimum()) / controls::Follower::kStepsOfRange);
    slider->setValue(slider->value() + static_cast<int>(std::lround(steps * step)));
  };
  made.words = [slider, hasBox] { return hasBox ? slider->accessibleDescription() : figure(slider->value(), 0); };
  return made;
}

/// What has no range: it is moved by steps.
SurfaceSetting motionOf(const char* id, const QString& group, const QString& name, std::function<void(double)> by) {
  SurfaceSetting made;
  made.id = id;
  made.group = group;
  made.name = name;
  made.present = [] { return std::optional<double>(); };
  made.by = std::move(by);
  return made;
}

}  // namespace

void MainWindow::connectKeys() {
  Parts& p = *parts_;
  p.hand.setKeys(p.keys);
  p.cineBar->setKeys(p.keys);
  p.caliperLayer->setKeys(p.keys);
  p.annotationLayer->setKeys(p.keys);
  p.sourcePicker->setKeys(p.keys);
  p.pointing->setKeys(p.keys);
  p.bodyTools->setKeys(p.keys);
  connect(&p.keys, &KeyMap::changed, this, [this] {
    showOwnKeys();
    parts_->console->showKeys(parts_->keyTips);
    showHistory();
  });
  // One key for two things, as on a machine: which of them, a picture that runs or stands decides.
  connect(&p.session, &Session::frozenChanged, this, &MainWindow::showOwnKeys);
  connect(&p.session, &Session::pictureChanged, this, [this, stood = false]() mutable {
    const bool stands = parts_->session.isFrozen() || parts_->session.isPlaying();
    if (stands != std::exchange(stood, stands)) showOwnKeys();
  });

  ControlSurface::Window window;
  for (QSlider* slider : p.console->findChildren<QSlider*>()) {
    const bool isOfEffect = slider->objectName().startsWith(QStringLiteral("strength_"));
    window.settings.push_back(settingOf(slider, isOfEffect ? tr("Effects") : tr("Console"), true));
    if (window.settings.back().name.isEmpty()) window.settings.pop_back();
  }
  for (int n = 1; n <= kDgcSliders; ++n)
    if (auto* slider = p.scanView->findChild<QSlider*>(QStringLiteral("dgc%1").arg(n)))
      window.settings.push_back(settingOf(slider, tr("Console"), false));
  const auto holdsScan = [this] {
    return parts_->session.subject() && !parts_->staged && parts_->pages->currentWidget() == parts_->workspacePage;
  };
  const auto turning = [&](const char* id, const QString& name, HandInput::Turn axis) {
    window.settings.push_back(motionOf(id, tr("Probe"), name, [this, axis](double steps) { parts_->hand.turn(axis, steps / 2.0); }));
  };
  turning("probe.tilt", tr("Tilt"), HandInput::Turn::tilt);
  turning("probe.rock", tr("Rock"), HandInput::Turn::rock);
  turning("probe.rotation", tr("Rotate"), HandInput::Turn::rotation);
  window.settings.push_back(
      motionOf("probe.lateral", tr("Probe"), tr("Slide along the image"), [this](double steps) { parts_->hand.slide(steps, 0.0); }));
  window.settings.push_back(
      motionOf("probe.elevational", tr("Probe"), tr("Slide across the image"), [this](double steps) { parts_->hand.slide(0.0, steps); }));
  for (SurfaceSetting& each : window.settings)
    if (each.group == tr("Probe")) each.isThere = holdsScan;
  window.settings.push_back(motionOf("cine.image", tr("Frozen image"), tr("Image of the cine loop"),
                                     [this](double steps) { parts_->cineBar->step(static_cast<int>(std::lround(steps))); }));
  window.settings.back().isThere = [this] { return parts_->cineBar->isOpen(); };
  window.doCommand = [this](const std::string& command) { return doCommand(command); };
  window.say = [this](const QString& sentence) { parts_->scanView->say(sentence); };
  p.surface.setWindow(std::move(window));
  connect(&p.surface, &ControlSurface::bindingsChanged, this, &MainWindow::keepOwnKeys);
  connect(&p.surface, &ControlSurface::stateChanged, this, [this] {
    if (parts_->keysDialog != nullptr) return;  // which tells it itself
    for (const Error& problem : parts_->surface.state().problems)
      if (problem.code == ErrorCode::notReadable) parts_->messages->showError(problem, kKeysTopic);
  });
  readOwnKeys();
  showOwnKeys();
  p.console->showKeys(p.keyTips);
}

void MainWindow::readOwnKeys() {
  Parts& p = *parts_;
  const std::filesystem::path file = ownKeysFile();
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) return;
  const auto own = controls::readKeys(file);
  p.ownKeysAreBroken = !own.has_value();
  if (!own) {
    p.messages->showError(own.error(), kKeysTopic);
    p.messages->showNote(
        tr("The usual keys act meanwhile. The file stays as it is: as soon as you change a key, it is put aside and a new one is begun."));
    return;
  }
  for (const QString& problem : p.keys.setOwn(own->keys)) p.messages->showNote(problem);
  p.surface.setBindings(own->controls);
}

void MainWindow::keepOwnKeys() {
  Parts& p = *parts_;
  const std::filesystem::path file = ownKeysFile();
  std::error_code problem;
  std::filesystem::create_directories(file.parent_path(), problem);
  if (p.ownKeysAreBroken) {
    std::filesystem::path aside;
    for (int n = 1; aside.empty() || std::filesystem::exists(aside, problem); ++n)
      aside = file.parent_path() / ("keys-unreadable-" + std::to_string(n) + ".json");
    std::filesystem::rename(file, aside, problem);
    if (problem) return p.messages->showError(tr("The file %1 cannot be put aside, so your keys are not kept.").arg(wordsOf(file)));
    p.ownKeysAreBroken = false;
    p.messages->showNote(tr("What could not be read is now in %1.").arg(wordsOf(aside)), kKeysTopic);
  }
  if (const auto written = controls::writeKeys({p.keys.own(), p.surface.bindings()}, file); !written)
    p.messages->showError(written.error(), kKeysTopic);
}

void MainWindow::showOwnKeys() {
  Parts& p = *parts_;
  const unsigned state = p.session.isFrozen() || p.session.isPlaying() ? kWhileStill : kWhileRunning;
  std::map<QAction*, QList<QKeySequence>> keys;
  for (const auto& [action, command] : p.keyedActions) {
    const KeyCommand* entry = p.keys.find(command);
    QList<QKeySequence>& its = keys[action];
    // What is off takes no key from others, and its menu says which it has.
    if (entry != nullptr && ((entry->when & state) != 0 || !action->isEnabled())) its << p.keys.keysOf(command);
  }
  for (const auto& [action, its] : keys)
    if (action->shortcuts() != its) action->setShortcuts(its);
}

bool MainWindow::doCommand(const std::string& command) {
  Parts& p = *parts_;
  for (const auto& [action, id] : p.keyedActions) {
    if (id != command) continue;
    if (action->isEnabled()) action->trigger();
    return true;
  }
  const bool isScanning = p.session.subject() && !p.staged && p.pages->currentWidget() == p.workspacePage;
  return isScanning && (p.cineBar->run(command) || p.hand.run(command));
}

void MainWindow::editKeys() {
  Parts& p = *parts_;
  if (p.keysDialog == nullptr) {
    std::vector<KeysDialog::PanelKey> ofPanels;
    for (const sdk::StagedPanel* panel : p.host->panelsAdded())
      for (const auto& [key, what] : panel->keys) ofPanels.push_back({words(panel->title), words(key), words(what)});
    p.keysDialog = new KeysDialog(p.keys, p.surface, std::move(ofPanels), this);
    p.keysDialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(p.keysDialog, &KeysDialog::changed, this, &MainWindow::keepOwnKeys);
  }
  p.keysDialog->show();
  p.keysDialog->raise();
  p.keysDialog->activateWindow();
}

KeyMap& MainWindow::keys() { return parts_->keys; }
ControlSurface& MainWindow::surface() { return parts_->surface; }
Trackers& MainWindow::trackers() { return parts_->trackers; }

}  // namespace ew::ui
