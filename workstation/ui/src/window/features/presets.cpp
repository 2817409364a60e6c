#include "window/features/presets.h"

#include <QFileDialog>
#include <QInputDialog>
#include <QLineEdit>
#include <QMenu>
#include <algorithm>
#include <utility>

#include "ew/library/case_start.h"
#include "ew/widgets/words.h"
#include "window/frame/commands.h"
#include "window/frame/menu_text.h"
#include "window/frame/window_parts.h"

namespace ew::ui {
namespace {

const auto kPreset = QStringLiteral("preset");

}  // namespace

void Presets::readData(const std::filesystem::path& resources) {
  if (auto presets = readPresets(resources / "presets"))
    all_ = std::move(*presets);
  else
    parts_.messages->showError(presets.error());
}

std::vector<Preset> Presets::ofCase() const {
  const WindowParts& p = parts_;
  std::vector<Preset> offered;
  const auto& opened = p.document.current();
  if (!opened || !p.opener->showsCase()) return offered;
  const std::vector<std::string> ids = presetsOf(*opened);
  if (ids.empty()) return offered;
  const std::vector<Preset> own = readOwnPresets(ownPresetsFolder()).presets;
  for (const std::string& id : ids)
    for (const std::vector<Preset>* all : {&all_, &own}) {
      const auto found = std::find_if(all->begin(), all->end(), [&](const Preset& each) { return each.id == id; });
      if (found == all->end()) continue;
      offered.push_back(*found);
      break;
    }
  return offered;
}

void Presets::beginScanOfCase() {
  Session& session = parts_.session;
  if (session.isFrozen() || session.isPlaying() || !session.subject() || !parts_.opener->showsCase()) return;
  const std::vector<Preset> offered = ofCase();
  if (const Preset* start = startPreset(session.subject()->presets, offered, session.console().probes()))
    take(*start);
  else
    session.console().setNeutral();
}

void Presets::addMenu(QMenu& presets) {
  presets.setObjectName(QStringLiteral("presetMenu"));
  parts_.console->setPresetMenu(presets);
  connect(&presets, &QMenu::aboutToShow, this, [this, &presets] { fill(presets); });
}

/// Those of the probe at hand first, then the user's own, then those of the other probes.
void Presets::fill(QMenu& menu) {
  WindowParts& p = parts_;
  for (QObject* child : menu.children())  // menus within it, which clear() leaves
    if (qobject_cast<QMenu*>(child) != nullptr) child->deleteLater();
  menu.clear();
  const auto& probes = p.session.console().probes();
  const std::string present = p.session.console().probe().id;
  const auto add = [&](QMenu& into, const QString& text, const Preset& preset) {
    QAction* action = p.commands->addPlain(into, menuText(text), [this, preset] { take(preset); });
    action->setData(QString::fromStdString(preset.id));
    action->setEnabled(checkPreset(preset, probes).has_value());
    action->setToolTip(QString::fromStdString(preset.source));
  };
  const auto nameOf = [&](const std::string& id) {
    const auto probe = std::find_if(probes.begin(), probes.end(), [&](const Probe& each) { return each.id == id; });
    return probe != probes.end() ? nameOfProbe(probe->name) : QString::fromStdString(id);
  };
  const auto nameWithProbe = [&](const Preset& preset) {
    return preset.probe == present ? words(preset.title)
                                   : tr("%1 (%2)", "a preset and its probe").arg(words(preset.title), nameOf(preset.probe));
  };
  for (const Preset& preset : ofCase()) add(menu, nameWithProbe(preset), preset);
  if (!menu.isEmpty()) menu.addSeparator();
  for (const Preset& preset : all_)
    if (preset.probe == present) add(menu, words(preset.title), preset);
  const OwnPresets own = readOwnPresets(ownPresetsFolder());
  for (const Error& problem : own.problems) p.messages->showError(problem, kPreset);
  if (!own.presets.empty()) menu.addSeparator();
  for (const Preset& preset : own.presets) add(menu, nameWithProbe(preset), preset);
  menu.addSeparator();
  for (const Probe& probe : probes) {
    if (probe.id == present) continue;
    QMenu* others = menu.addMenu(menuText(nameOfProbe(probe.name)));
    for (const Preset& preset : all_)
      if (preset.probe == probe.id) add(*others, words(preset.title), preset);
    if (others->isEmpty()) others->deleteLater();
  }
  menu.addSeparator();
  p.commands->addPlain(menu, tr("Save as preset…"), [this] { saveOwn(); });
  p.commands->addPlain(menu, tr("Take over a preset file…"), [this] { import(); });
}

void Presets::take(const Preset& preset) {
  WindowParts& p = parts_;
  Session& session = p.session;
  if (!session.subject()) return;
  if (session.isFrozen() || session.isPlaying()) {
    Q_EMIT session.console().changeRefused();
    return;
  }
  if (session.console().probe().id != preset.probe) session.console().chooseProbe(preset.probe);
  session.console().setKnobs(applied(preset, session.console().knobs()));
  p.annotated.chooseList(preset.annotations);
  p.bodyMark.choose(preset.bodyMark);
  p.console->showPreset(words(preset.title));
  p.scanView->say(words(preset.title));
}

void Presets::saveOwn() {
  WindowParts& p = parts_;
  bool isWanted = false;
  const QString title =
      QInputDialog::getText(&p.window, tr("Save as preset"), tr("Name of the examination:"), QLineEdit::Normal, QString(), &isWanted);
  if (!isWanted) return;
  Preset preset = presetOf(title.trimmed().toStdString(), p.session.imageProbe(), p.session.imageKnobs());
  if (const annotation::WordList* list = p.annotated.wordList()) preset.annotations = list->id;
  preset.bodyMark = p.bodyMark.choice().mark;
  const auto saved = saveOwnPreset(preset, ownPresetsFolder());
  if (saved)
    p.messages->showNote(tr("Saved to %1. Give this file to others who want the same.").arg(wordsOf(*saved)), kPreset);
  else
    p.messages->showError(saved.error(), kPreset);
}

void Presets::import() {
  WindowParts& p = parts_;
  const QString file = QFileDialog::getOpenFileName(&p.window, tr("Take over a preset file"), QString(), tr("Presets (*.json)"));
  if (file.isEmpty()) return;
  const auto preset = readPreset(pathOf(file));
  if (!preset) return p.messages->showError(preset.error(), kPreset);
  if (const auto fits = checkPreset(*preset, p.session.console().probes()); !fits) return p.messages->showError(fits.error(), kPreset);
  const auto saved = saveOwnPreset(*preset, ownPresetsFolder());
  if (saved)
    p.messages->showNote(tr("'%1' is now among your presets.").arg(words(preset->title)), kPreset);
  else
    p.messages->showError(saved.error(), kPreset);
}

}  // namespace ew::ui
