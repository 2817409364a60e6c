#include "window/features/console_menus.h"

#include <QActionGroup>
#include <QMenu>

#include "ew/imaging/effect_info.h"
#include "ew/imaging/knobs.h"
#include "ew/scanning/breathing.h"
#include "keys/key_table.h"
#include "window/features/cine.h"
#include "window/features/zoom_and_wide.h"
#include "window/frame/columns.h"
#include "window/frame/commands.h"
#include "window/frame/window_parts.h"
#include "window/layout/window_layout.h"

namespace ew::ui {

void ConsoleMenus::addConsoleMenu(QMenu& console) {
  Commands& commands = *parts_.commands;
  commands.addConsole(console, "gain.more", "gain", 1);
  commands.addConsole(console, "gain.less", "gain", -1);
  commands.add(console, "tgc.reset", [this] { parts_.session.console().resetTgc(); });
  commands.addConsole(console, "depth.more", "depth", 1);
  commands.addConsole(console, "depth.less", "depth", -1);
  commands.addConsole(console, "zoom.in", "zoom", 1);
  commands.addConsole(console, "zoom.out", "zoom", -1);
  parts_.zoomAndWide->addActions(console);
  console.addSeparator();
  addImageMenu(*console.addMenu(tr("&Image")));
  addDopplerMenu(*console.addMenu(tr("&Doppler")));
  addEffectsMenu(*console.addMenu(tr("&Effects")));
  addProbeMenu(*console.addMenu(tr("&Probe")));
  addTimeMenu(*console.addMenu(tr("&M-mode")));
  addQualityMenu(*console.addMenu(tr("&Quality")));
  commands.add(console, "console.nextPage", [this] {
    // A console that is not in front comes there first.
    if (!parts_.console->isVisible()) return parts_.columns->show(Column::console);
    parts_.console->showNextPage();
  });
}

void ConsoleMenus::addBreathingMenu(QMenu& breathing) {
  Commands& commands = *parts_.commands;
  auto* requests = new QActionGroup(this);
  const auto add = [&](const char* command, BreathingRequest request) {
    QAction* action = commands.add(breathing, command, [this, request] { askBreathing(request); });
    action->setCheckable(true);
    requests->addAction(action);
    if (request == BreathingRequest::free) parts_.cine->giveWay(action);
    connect(&parts_.session.breath(), &PatientBreath::changed, action,
            [&session = parts_.session, action, request] { action->setChecked(session.breath().asked() == request); });
    action->setChecked(request == BreathingRequest::free);
  };
  add("breathing.free", BreathingRequest::free);
  add("breathing.in", BreathingRequest::breatheInAndHold);
  add("breathing.out", BreathingRequest::breatheOutAndHold);
}

void ConsoleMenus::askBreathing(BreathingRequest request) {
  Session& session = parts_.session;
  session.breath().ask(request);
  // An action of a group checks itself, whatever came of it.
  Q_EMIT session.breath().changed();
  if (session.subject() && !session.isPlaying())
    if (const char* why = session.breath().whyItIsNotSeen()) parts_.messages->showNote(PatientBreath::tr(why), QStringLiteral("breathing"));
}

void ConsoleMenus::addImageMenu(QMenu& image) {
  Commands& commands = *parts_.commands;
  parts_.cine->giveWay(commands.addConsole(image, "focus.shallower", "focus", -1));
  parts_.cine->giveWay(commands.addConsole(image, "focus.deeper", "focus", 1));
  commands.addConsole(image, "focus.zones", "foci", 1);
  commands.addConsole(image, "focus.model", "focusMethod", 1);
  image.addSeparator();
  commands.addConsole(image, "range.wider", "dynamicRange", 1);
  commands.addConsole(image, "range.narrower", "dynamicRange", -1);
  commands.addConsole(image, "greyMap.next", "greyMap", 1);
  commands.addConsole(image, "edges.more", "edges", 1);
  commands.addConsole(image, "edges.less", "edges", -1);
  commands.addConsole(image, "persistence.more", "persistence", 1);
  commands.addConsole(image, "persistence.less", "persistence", -1);
  commands.addConsole(image, "compound.next", "compound", 1);
  image.addSeparator();
  commands.addConsole(image, "flip.sides", "flip", 1);
  commands.addConsole(image, "flip.upsideDown", "upsideDown", 1);
}

void ConsoleMenus::addDopplerMenu(QMenu& doppler) {
  Commands& commands = *parts_.commands;
  commands.addConsole(doppler, "colour", "colour", 1);
  doppler.addSeparator();
  commands.addConsole(doppler, "colour.scaleMore", "colourScale", 1);
  commands.addConsole(doppler, "colour.scaleLess", "colourScale", -1);
  commands.addConsole(doppler, "colour.gainMore", "colourGain", 1);
  commands.addConsole(doppler, "colour.gainLess", "colourGain", -1);
  doppler.addSeparator();
  commands.addConsole(doppler, "spectral", "modePw", 1);
  doppler.addSeparator();
  commands.addConsole(doppler, "spectral.angleMore", "spectralAngle", 1);
  commands.addConsole(doppler, "spectral.angleLess", "spectralAngle", -1);
  commands.addConsole(doppler, "spectral.scaleMore", "spectralScale", 1);
  commands.addConsole(doppler, "spectral.scaleLess", "spectralScale", -1);
  commands.addConsole(doppler, "spectral.mute", "spectralMute", 1);
}

void ConsoleMenus::addEffectsMenu(QMenu& effects) {
  Commands& commands = *parts_.commands;
  for (const EffectInfo& effect : sceneEffects()) {
    commands.addConsole(effects, effectCommand(effect.key), ConsolePanel::switchOf(effect.key), 1);
    if (effect.option) commands.addConsole(effects, effectCommand(effect.option->key), ConsolePanel::switchOf(effect.option->key), 1);
  }
  effects.addSeparator();
  commands.addConsole(effects, "effect.planes", "planes", 1);
}

void ConsoleMenus::addProbeMenu(QMenu& transducer) {
  Commands& commands = *parts_.commands;
  commands.addConsole(transducer, "probe.next", "probe", 1);
  commands.addConsole(transducer, "frequency.next", "frequency", 1);
  commands.addConsole(transducer, "harmonic", "harmonic", 1);
  commands.addConsole(transducer, "steering.less", "steering", -1);
  commands.addConsole(transducer, "steering.more", "steering", 1);
  commands.addConsole(transducer, "trapezoid", "trapezoid", 1);
}

void ConsoleMenus::addTimeMenu(QMenu& time) {
  Commands& commands = *parts_.commands;
  commands.addConsole(time, "mode.next", "mode", 1);
  commands.addConsole(time, "mode.lineLeft", "mLine", -1);
  commands.addConsole(time, "mode.lineRight", "mLine", 1);
  commands.addConsole(time, "mode.slower", "sweep", 1);
  commands.addConsole(time, "mode.faster", "sweep", -1);
}

void ConsoleMenus::addQualityMenu(QMenu& quality) {
  Commands& commands = *parts_.commands;
  const auto choose = [&](const char* command, Quality chosenQuality) {
    commands.add(quality, command, [this, chosenQuality] { parts_.console->chooseQuality(chosenQuality); });
  };
  choose("quality.fast", Quality::weave);
  choose("quality.fine", Quality::linear);
  choose("quality.cubic", Quality::cubic);
  commands.addConsole(quality, "quality.adaptive", "adaptive", 1);
}

}  // namespace ew::ui
