#pragma once

#include "window/frame/feature.h"

class QMenu;

namespace ew {
enum class BreathingRequest;
}

namespace ew::ui {

/// What the console sets and what the patient is asked for, for keys and for who prefers menus.
class ConsoleMenus final : public Feature {
  Q_OBJECT

 public:
  using Feature::Feature;

  void addConsoleMenu(QMenu& console);
  void addBreathingMenu(QMenu& breathing);

 private:
  void addImageMenu(QMenu& image);
  void addDopplerMenu(QMenu& doppler);
  void addEffectsMenu(QMenu& effects);
  void addProbeMenu(QMenu& transducer);
  void addTimeMenu(QMenu& time);
  void addQualityMenu(QMenu& quality);
  void askBreathing(BreathingRequest request);
};

}  // namespace ew::ui
