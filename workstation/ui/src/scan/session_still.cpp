// What a session shows that does not run: the frozen image, a recording, a wide image.
#include <utility>

#include "scan/session.h"

namespace ew::ui {

void Session::setFrozen(bool frozen) {
  if (frozen == isFrozen() || (frozen && scan_.played)) return;
  const bool wasProcessed = scan_.consoleWhileFrozen.has_value();
  if (frozen) {
    frames_.askInFull();
    isFreezing_ = true;
    makeImageNow();
    isFreezing_ = false;
    scan_.asScanned = stateToFreeze();
    scan_.frozen = scan_.asScanned;
    cineLoop_.freezeLatest();
  } else {
    scan_.frozen.reset();
    scan_.processing = {};
    scan_.consoleWhileFrozen.reset();
    scan_.isProcessedAnew = false;
    cineLoop_.runOn();
    frames_.ask();
  }
  Q_EMIT frozenChanged(frozen);
  if (wasProcessed) Q_EMIT console_.knobsChanged();
}

ScanState Session::stateToFreeze() const {
  const ProbeControl::Mover mover = probeControl_.mover();
  const bool isByHand = mover == ProbeControl::Mover::hand || mover == ProbeControl::Mover::handMeanwhile;
  ScanState kept = scan_.live;
  // A probe that somebody else moves is where it was in the image, and after a loss it was there last.
  kept.pose = isByHand || scan_.image.isEmpty() ? probeControl_.pose() : scan_.shown.pose;
  kept.scene = mover == ProbeControl::Mover::tracker && scan_.isOfThisScan ? scan_.shown.scene : kept.scene;
  kept.gaps_mm = scan_.shown.gaps_mm;
  kept.time_s = scan_.shown.time_s;
  kept.number = scan_.shown.number;
  kept.body = scan_.shown.body;
  return kept;
}

void Session::play(std::optional<ScanState> state) {
  if ((!state && !scan_.played) || (state && !subject())) return;
  showWide({});
  if (state) setFrozen(false);
  if (state && !scan_.played) scan_.cine.beginAnew();  // what was scanned before a recording is another scan
  if (!state || !scan_.played) forgetImages();
  const ScanState before = scan_.console();
  scan_.played = std::move(state);
  if (scan_.played) console_.askForEchoes(scan_.played->scene);
  console_.tellWhatChanged(before);
  Q_EMIT probeControl_.holdChanged();
  frames_.ask();
}

void Session::showWide(std::optional<WideImage> wide) {
  const bool wasShown = scan_.wide.has_value();
  if (!wide && !wasShown) return;
  const Detail before = wasShown ? scan_.wide->shown.detail : Detail{};
  scan_.wide.reset();
  if (wide) {
    ScanContents::Wide& made = scan_.wide.emplace();
    made.shown = std::move(*wide);
    made.image.grey = viewOf(std::as_const(made.shown.grey));
    scan_.takeWideSettings();
  }
  if (wasShown != scan_.wide.has_value() || !(before == scan_.wide->shown.detail)) Q_EMIT console_.knobsChanged();
  Q_EMIT imageChanged();
}

}  // namespace ew::ui
