#pragma once

#include <QObject>

#include "ew/scanning/breathing.h"
#include "scan/frame_timer.h"
#include "scan/scan_contents.h"

namespace ew::ui {

/// What the patient who is scanned is asked to do with the breath.
class PatientBreath final : public QObject {
  Q_OBJECT

 public:
  /// @param scan,frames must live longer
  PatientBreath(const ScanContents& scan, FrameTimer& frames) : scan_(scan), frames_(frames) {}

  /// From now on.
  void ask(BreathingRequest request);
  [[nodiscard]] BreathingRequest asked() const { return breathing_.asked(); }
  /// Whether there is a patient who can be asked: one whose tissue moves with the breath.
  [[nodiscard]] bool canBeAsked() const;
  /// Why a breath that is asked for does not show; null when it does. Translatable in the context "ew::ui::PatientBreath".
  [[nodiscard]] const char* whyItIsNotSeen() const;
  /// Another patient, who breathes freely.
  void beginAnew();
  /// How the body lies, and whether it moves after that moment; of a subject that moves.
  [[nodiscard]] BodyState at(double time_s) const;
  [[nodiscard]] bool movesAfter(double time_s) const;

 Q_SIGNALS:
  void changed();

 private:
  const ScanContents& scan_;
  FrameTimer& frames_;
  BreathControl breathing_;
};

}  // namespace ew::ui
