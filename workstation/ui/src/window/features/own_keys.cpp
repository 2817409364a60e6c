#include "window/features/own_keys.h"

#include <QDir>
#include <QFileInfo>
#include <QSettings>
#include <QSlider>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <utility>

#include "ew/controls/keys_file.h"
#include "ew/widgets/figures.h"
#include "ew/widgets/words.h"
#include "keys/keys_dialog.h"
#include "window/frame/commands.h"
#include "window/frame/undo.h"
#include "window/frame/window_parts.h"
#include "window/frame/workspaces.h"

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

OwnKeys::~OwnKeys() { delete dialog_; }

void OwnKeys::connectParts() {
  WindowParts& p = parts_;
  p.hand.setKeys(p.keys);
  p.cineBar->setKeys(p.keys);
  p.caliperLayer->setKeys(p.keys);
  p.annotationLayer->setKeys(p.keys);
  p.sourcePicker->setKeys(p.keys);
  p.pointing->setKeys(p.keys);
  p.bodyTools->setKeys(p.keys);
  connect(&p.keys, &KeyMap::changed, this, [this] {
    parts_.commands->showKeys();
    parts_.console->showKeys(parts_.keyTips);
    parts_.undo->refresh();
  });
  // One key for two things, as on a machine: which of them, an image that runs or stands decides.
  connect(&p.session, &Session::frozenChanged, this, [this] { parts_.commands->showKeys(); });
  connect(&p.session, &Session::imageChanged, this, [this, stood = false]() mutable {
    const bool stands = parts_.session.isFrozen() || parts_.session.isPlaying();
    if (stands != std::exchange(stood, stands)) parts_.commands->showKeys();
  });
  connectSurface();
  read();
  parts_.commands->showKeys();
  p.console->showKeys(p.keyTips);
}

void OwnKeys::connectSurface() {
  WindowParts& p = parts_;
  ControlSurface::Window window;
  for (QSlider* slider : p.console->findChildren<QSlider*>()) {
    const bool isOfEffect = slider->objectName().startsWith(QStringLiteral("strength_"));
    window.settings.push_back(settingOf(slider, isOfEffect ? tr("Effects") : tr("Console"), true));
    if (window.settings.back().name.isEmpty()) window.settings.pop_back();
  }
  for (int n = 1; n <= kDgcSliders; ++n)
    if (auto* slider = p.scanView->findChild<QSlider*>(QStringLiteral("dgc%1").arg(n)))
      window.settings.push_back(settingOf(slider, tr("Console"), false));
  const auto holdsScan = [&p] { return p.session.subject() && !p.workspaces->isStaged() && p.workspaces->isAtWork(); };
  const auto turning = [&](const char* id, const QString& name, HandInput::Turn axis) {
    window.settings.push_back(motionOf(id, tr("Probe"), name, [&p, axis](double steps) { p.hand.turn(axis, steps / 2.0); }));
  };
  turning("probe.tilt", tr("Tilt"), HandInput::Turn::tilt);
  turning("probe.rock", tr("Rock"), HandInput::Turn::rock);
  turning("probe.rotation", tr("Rotate"), HandInput::Turn::rotation);
  window.settings.push_back(
      motionOf("probe.lateral", tr("Probe"), tr("Slide along the image"), [&p](double steps) { p.hand.slide(steps, 0.0); }));
  window.settings.push_back(
      motionOf("probe.elevational", tr("Probe"), tr("Slide across the image"), [&p](double steps) { p.hand.slide(0.0, steps); }));
  for (SurfaceSetting& each : window.settings)
    if (each.group == tr("Probe")) each.isThere = holdsScan;
  window.settings.push_back(motionOf("cine.image", tr("Frozen image"), tr("Image of the cine loop"),
                                     [&p](double steps) { p.cineBar->step(static_cast<int>(std::lround(steps))); }));
  window.settings.back().isThere = [&p] { return p.cineBar->isOpen(); };
  window.doCommand = [&p](const std::string& command) { return p.commands->run(command); };
  window.say = [&p](const QString& sentence) { p.scanView->say(sentence); };
  p.surface.setWindow(std::move(window));
  connect(&p.surface, &ControlSurface::bindingsChanged, this, &OwnKeys::keep);
  connect(&p.surface, &ControlSurface::stateChanged, this, [this] {
    if (dialog_ != nullptr) return;  // which tells it itself
    for (const Error& problem : parts_.surface.state().problems)
      if (problem.code == ErrorCode::notReadable) parts_.messages->showError(problem, kKeysTopic);
  });
}

void OwnKeys::read() {
  WindowParts& p = parts_;
  const std::filesystem::path file = ownKeysFile();
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) return;
  const auto own = controls::readKeys(file);
  isBroken_ = !own.has_value();
  if (!own) {
    p.messages->showError(own.error(), kKeysTopic);
    p.messages->showNote(
        tr("The usual keys act meanwhile. The file stays as it is: as soon as you change a key, it is put aside and a new one is begun."));
    return;
  }
  for (const QString& problem : p.keys.setOwn(own->keys)) p.messages->showNote(problem);
  p.surface.setBindings(own->controls);
}

void OwnKeys::keep() {
  WindowParts& p = parts_;
  const std::filesystem::path file = ownKeysFile();
  std::error_code problem;
  std::filesystem::create_directories(file.parent_path(), problem);
  if (isBroken_) {
    std::filesystem::path aside;
    for (int n = 1; aside.empty() || std::filesystem::exists(aside, problem); ++n)
      aside = file.parent_path() / ("keys-unreadable-" + std::to_string(n) + ".json");
    std::filesystem::rename(file, aside, problem);
    if (problem) return p.messages->showError(tr("The file %1 cannot be put aside, so your keys are not kept.").arg(wordsOf(file)));
    isBroken_ = false;
    p.messages->showNote(tr("What could not be read is now in %1.").arg(wordsOf(aside)), kKeysTopic);
  }
  if (const auto written = controls::writeKeys({p.keys.own(), p.surface.bindings()}, file); !written)
    p.messages->showError(written.error(), kKeysTopic);
}

void OwnKeys::edit() {
  WindowParts& p = parts_;
  if (dialog_ == nullptr) {
    std::vector<KeysDialog::PanelKey> ofPanels;
    for (const sdk::StagePanel* panel : p.host->panelsAdded())
      for (const auto& [key, what] : panel->keys) ofPanels.push_back({words(panel->title), words(key), words(what)});
    dialog_ = new KeysDialog(p.keys, p.surface, std::move(ofPanels), &p.window);
    dialog_->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog_, &KeysDialog::changed, this, &OwnKeys::keep);
  }
  dialog_->show();
  dialog_->raise();
  dialog_->activateWindow();
}

}  // namespace ew::ui
