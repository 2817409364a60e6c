#include "scan/patient_breath.h"

namespace ew::ui {

bool PatientBreath::canBeAsked() const { return scan_.subject() && scan_.subject()->motion && scan_.subject()->motion->rhythms.breathing; }

void PatientBreath::ask(BreathingRequest request) {
  if (scan_.played || !canBeAsked() || request == breathing_.asked()) return;
  breathing_.ask(request, scan_.subject()->motion->rhythms, frames_.now_s());
  frames_.ask();
  Q_EMIT changed();
}

const char* PatientBreath::whyItIsNotSeen() const {
  if (!canBeAsked()) return QT_TR_NOOP("Nothing that is scanned here moves with the breath, so the image stays as it is.");
  if (!scan_.subject()->movesIn(scan_.live.scene))
    return QT_TR_NOOP("The patient breathes, but the image does not show it: switch live echoes and motion on (Effects).");
  return nullptr;
}

void PatientBreath::beginAnew() {
  breathing_ = {};
  Q_EMIT changed();
}

BodyState PatientBreath::at(double time_s) const { return breathing_.at(scan_.subject()->motion->rhythms, time_s); }

bool PatientBreath::movesAfter(double time_s) const { return breathing_.movesAfter(scan_.subject()->motion->rhythms, time_s); }

}  // namespace ew::ui
