#include "scan/scan_console.h"

#include <algorithm>
#include <utility>

namespace ew::ui {

void ScanConsole::setProbes(std::vector<Probe> all) {
  all_ = std::move(all);
  updateUsableProbes();
}

void ScanConsole::updateUsableProbes() {
  usable_.clear();
  if (scan_.subject()) {
    for (const std::string& id : scan_.subject()->probes) {
      const auto found = std::find_if(all_.begin(), all_.end(), [&](const Probe& p) { return p.id == id; });
      if (found != all_.end()) usable_.push_back(*found);
    }
  }
  if (usable_.empty()) usable_ = all_;
  const bool stillThere = std::any_of(usable_.begin(), usable_.end(), [this](const Probe& p) { return p == scan_.live.probe; });
  if (!stillThere && !usable_.empty()) {
    takeProbe(usable_.front());
    frames_.ask();
    Q_EMIT probeControl_.holdChanged();
  }
  Q_EMIT probeChanged();
  Q_EMIT knobsChanged();
}

void ScanConsole::takeProbe(const Probe& probe) {
  scan_.live.probe = probe;
  // Another probe sees to another depth: its own default, rather than a depth it may not reach.
  Knobs& knobs = scan_.live.knobs;
  knobs.depth_mm = 0.0;
  knobs.focus_mm = 0.0;
  knobs.moreFoci_mm = {};
  knobs.carrier_hz = 0.0;
  knobs.steering_rad = 0.0;
  knobs.trapezoid = false;
  if (knobs.colour) knobs.colour->boxMiddle_mm = knobs.colour->boxHeight_mm = knobs.colour->steering_rad = knobs.colour->carrier_hz = 0.0;
  if (knobs.spectral) {
    knobs.spectral->line = knobs.spectral->depth_mm = knobs.spectral->steering_rad = knobs.spectral->carrier_hz = 0.0;
  }
  probeControl_.pressAsUsual(probe);
}

void ScanConsole::chooseProbe(const std::string& id) {
  const auto found = std::find_if(usable_.begin(), usable_.end(), [&](const Probe& p) { return p.id == id; });
  if (scan_.played || found == usable_.end() || *found == scan_.live.probe || refuses()) return;
  scan_.cine.beginAnew();
  takeProbe(*found);
  frames_.ask();
  Q_EMIT probeChanged();
  Q_EMIT knobsChanged();
  Q_EMIT probeControl_.holdChanged();
}

void ScanConsole::takeSubject() {
  takeScene(scan_.subject()->scene);
  if (scan_.live.knobs.mode == DisplayMode::spectrum && !scan_.subject()->showsColour()) scan_.live.knobs.mode = DisplayMode::bMode;
  if (!scan_.subject()->probes.empty()) {
    const auto first = std::find_if(all_.begin(), all_.end(), [this](const Probe& p) { return p.id == scan_.subject()->probes.front(); });
    if (first != all_.end()) takeProbe(*first);
  }
  updateUsableProbes();
}

void ScanConsole::takeScene(const Scene& scene) {
  scan_.live.scene = scan_.subject() ? scan_.subject()->known(scene) : scene;
  if (scan_.consoleWhileFrozen) scan_.consoleWhileFrozen = processed(scan_.live, scan_.processing);
  frames_.forgetTimes();
  frames_.ask();
  Q_EMIT sceneChanged();
}

void ScanConsole::setScene(const Scene& scene) {
  if (scan_.played || scene == scan_.live.scene || refuses()) return;
  sceneBeforeReset_.reset();
  wantedEchoes_ = scene.liveEchoes;
  takeScene(scene);
  askForEchoes(scene);
}

void ScanConsole::askForEchoes(const Scene& scene) {
  const std::optional<ScanSubject>& subject = scan_.subject();
  if (scene.liveEchoes && subject && !subject->tissue && subject->canFormEchoes()) Q_EMIT echoesWanted();
}

void ScanConsole::beginWantedEchoes() {
  frames_.forgetTimes();
  frames_.ask();
  Scene scene = scan_.live.scene;
  scene.liveEchoes = std::exchange(wantedEchoes_, std::nullopt);
  if (scene != scan_.live.scene) takeScene(scene);
}

void ScanConsole::resetScene() {
  if (!scan_.subject() || scan_.played || hasCaseScene() || refuses()) return;
  sceneBeforeReset_ = scan_.live.scene;
  takeScene(scan_.subject()->scene);
}

void ScanConsole::undoSceneReset() {
  if (!sceneBeforeReset_ || scan_.played || refuses()) return;
  const Scene before = *sceneBeforeReset_;
  sceneBeforeReset_.reset();
  takeScene(before);
}

void ScanConsole::takeCaseScene() {
  sceneBeforeReset_.reset();
  takeScene(scan_.subject()->scene);
}

void ScanConsole::forgetWishes() {
  sceneBeforeReset_.reset();
  wantedEchoes_.reset();
}

void ScanConsole::tellWhatChanged(const ScanState& before) {
  const ScanState& now = scan_.console();
  if (now.probe != before.probe) Q_EMIT probeChanged();
  if (now.knobs != before.knobs || !(now.pan == before.pan) || now.probe != before.probe) Q_EMIT knobsChanged();
  if (now.scene != before.scene) {
    frames_.forgetTimes();
    Q_EMIT sceneChanged();
  }
}

void ScanConsole::setKnobs(const Knobs& knobs) {
  if (scan_.played || knobs == scan_.console().knobs) return;
  if (scan_.wide) return setKnobsOfWide(knobs);
  if (scan_.frozen && differInProcessingOnly(knobs, scan_.console().knobs)) return process(knobs, knobs.zoom > 1.0 ? pan() : Pan{});
  if (refuses()) return;
  scan_.live.knobs = knobs;
  if (!(knobs.zoom > 1.0)) scan_.live.pan = {};  // the next zoom begins in the middle
  frames_.ask();
  Q_EMIT knobsChanged();
}

void ScanConsole::setKnobsOfWide(Knobs asked) {
  Knobs sameZoom = asked;
  sameZoom.zoom = knobs().zoom;
  if (sameZoom == knobs()) return setDetail(asked.zoom, asked.zoom > 1.0 ? pan() : Pan{});
  if (refuses()) return;
  asked.zoom = scan_.live.knobs.zoom;
  scan_.live.knobs = asked;
  scan_.takeWideSettings();
  frames_.ask();
  Q_EMIT knobsChanged();
}

bool ScanConsole::refuses() {
  if (!scan_.frozen) return false;
  Q_EMIT knobsChanged();
  Q_EMIT changeRefused();
  return true;
}

void ScanConsole::process(const Knobs& asked, const Pan& part) {
  scan_.processing = withChange(scan_.processing, scan_.console(), asked, part);
  scan_.consoleWhileFrozen = processed(scan_.live, scan_.processing);
  scan_.frozen = processed(scan_.asScanned, scan_.processing);
  scan_.isProcessedAnew = true;
  frames_.ask();
  Q_EMIT knobsChanged();
}

Detail ScanConsole::detail() const {
  if (scan_.wide) return scan_.wide->shown.detail;
  const ScanState& at = scan_.settings();
  return {at.knobs.zoom > 1.0 ? at.knobs.zoom : 1.0, panWithinFan(at.probe, at.knobs, at.pan)};
}

void ScanConsole::setDetail(double zoom, const Pan& part) {
  // An older image of the loop may have been scanned with another zoom than the console has.
  if (scan_.played || (zoom == scan_.settings().knobs.zoom && part == scan_.settings().pan)) return;
  if (scan_.wide) {
    scan_.wide->shown.detail = {zoom, part};
    scan_.takeWideSettings();
    Q_EMIT knobsChanged();
    return Q_EMIT wideDetailAsked({zoom, part});
  }
  if (scan_.frozen) {
    scan_.processing.detail = Detail{zoom, part};
    return process(scan_.console().knobs, scan_.console().pan);
  }
  scan_.live.knobs.zoom = zoom;
  scan_.live.pan = part;
  frames_.ask();
  Q_EMIT knobsChanged();
}

double ScanConsole::depth_mm() const { return resolvedDepth_mm(probe(), knobs()); }

double ScanConsole::focus_mm() const { return knobs().focus_mm > 0.0 ? std::min(knobs().focus_mm, depth_mm()) : depth_mm() / 2.0; }

void ScanConsole::resetTgc() {
  Knobs reset = knobs();
  if (gainLaw() == GainLaw::decibel)
    reset.tgc_db = Knobs{}.tgc_db;
  else
    reset.dgc = Knobs{}.dgc;
  setKnobs(reset);
}

void ScanConsole::setNeutral() {
  Knobs neutral;
  neutral.quality = knobs().quality;
  setKnobs(neutral);
}

}  // namespace ew::ui
