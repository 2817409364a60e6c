#pragma once

#include <QAbstractButton>
#include <QSettings>
#include <QSlider>
#include <string>

#include "ew/imaging/effect_info.h"
#include "gui/support/window_fixture.h"

namespace ew::ui::testing {

/// A window with a case, whose console is used as a person uses it: a control that is off or not there fails the test.
class ConsoleFixture : public WindowFixture {
 protected:
  void slide(const char* name, int value) const {
    auto* slider = find<QSlider>(name);
    QVERIFY2(slider != nullptr, name);
    QVERIFY2(slider->isEnabled() && !slider->parentWidget()->isHidden(), name);
    QVERIFY2(slider->minimum() <= value && value <= slider->maximum(), name);
    slider->setValue(value);
  }
  void press(const char* name) const {
    auto* button = find<QAbstractButton>(name);
    QVERIFY2(button != nullptr, name);
    QVERIFY2(button->isEnabled() && !button->isHidden(), name);
    button->click();
  }
  void pressEffect(const char* key) const { press(qPrintable(ConsolePanel::switchOf(key))); }
  void slideEffect(const char* key, int value) const { slide(strengthOf(key).c_str(), value); }
  [[nodiscard]] static std::string strengthOf(const char* key) { return ConsolePanel::strengthOf(key).toStdString(); }
  /// What can be switched on: the case's volume is a recorded one, whose tissue nobody knows.
  [[nodiscard]] Scene everything() const { return session().subject()->known(sceneWithEverything()); }
  [[nodiscard]] bool isOffered(const EffectInfo& effect) const { return effect.isOn(everything()); }
  void everythingOn() const {
    for (const EffectInfo& effect : sceneEffects()) {
      if (isOffered(effect) && !effect.isOn(scene())) pressEffect(effect.key);
    }
  }
  [[nodiscard]] const Knobs& knobs() const { return session().console().knobs(); }
  [[nodiscard]] const Scene& scene() const { return session().console().scene(); }
  void openConsole() {
    QSettings().clear();
    QSettings().setValue(QStringLiteral("fold/advanced"), true);
    showWindowWithCase(files_.writeCase(QStringLiteral("case")));
  }
};

}  // namespace ew::ui::testing
