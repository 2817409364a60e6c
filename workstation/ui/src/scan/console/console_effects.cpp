// The console's page of effects: a switch for each, and a slider for its strength.
#include <QCheckBox>
#include <QPushButton>
#include <QSlider>
#include <QVBoxLayout>
#include <QVariant>

#include "ew/imaging/effect_info.h"
#include "ew/widgets/figures.h"
#include "ew/widgets/look.h"
#include "keys/effect_words.h"
#include "scan/console/console_panel.h"

namespace ew::ui {
namespace {

QString strengthText(const EffectStrength& strength, double value) {
  return effectText(strength.pattern).arg(figure(value * strength.shownFactor, strength.decimals));
}

}  // namespace

QString ConsolePanel::switchOf(const char* effectKey) { return QStringLiteral("effect_") + QLatin1String(effectKey); }

QString ConsolePanel::strengthOf(const char* effectKey) { return QStringLiteral("strength_") + QLatin1String(effectKey); }

void ConsolePanel::addEffect(QVBoxLayout* rows, const EffectInfo& effect) {
  QCheckBox* box = addSwitch(rows, effectText(effect.name), switchOf(effect.key), effectTip(effect.tip, effect.key));
  connect(box, &QCheckBox::toggled, this, [this, &effect](bool on) {
    changeScene([this, &effect, on](Scene& scene) {
      if (on)
        effect.copy(remembered_, scene);
      else
        effect.switchTo(scene, false);
    });
  });
  shows_.emplace_back([this, box, &effect] {
    if (effect.isOn(session_.console().scene())) effect.copy(session_.console().scene(), remembered_);
    box->setChecked(effect.isOn(session_.console().scene()));
    Scene with = remembered_;
    effect.switchTo(with, true);
    box->setEnabled(!session_.subject() || effect.isOn(session_.subject()->possible(with)));
  });
  if (effect.strength)
    addStrength(rows, effect, *effect.strength);
  else
    rows->addSpacing(4);
  if (effect.option) addOption(rows, effect, *effect.option);
}

void ConsolePanel::addStrength(QVBoxLayout* rows, const EffectInfo& effect, const EffectStrength& strength) {
  const auto steps = [&strength](double value) { return rounded(value / strength.step); };
  SliderParts parts;
  parts.objectName = strengthOf(effect.key);
  parts.widest = QStringLiteral("20.0 dB/mm");
  parts.tip = effectText(strength.tip);
  parts.lowest = steps(strength.lowest);
  parts.highest = steps(strength.highest);
  parts.page = steps(strength.page);
  parts.get = [this, &strength, steps] { return steps(strength.of(remembered_)); };
  parts.set = [this, &strength](int v) { changeScene([&](Scene& scene) { strength.set(scene, v * strength.step); }); };
  parts.text = [this, &strength] { return strengthText(strength, strength.of(remembered_)); };
  parts.isOn = [this, &effect] { return effect.isOn(session_.console().scene()); };
  addSlider(rows, std::move(parts))->setAccessibleName(effectText(effect.name));
}

void ConsolePanel::addOption(QVBoxLayout* rows, const EffectInfo& effect, const EffectOption& option) {
  QCheckBox* box = addSwitch(rows, effectText(option.name), switchOf(option.key), effectTip(option.tip, option.key));
  connect(box, &QCheckBox::toggled, this,
          [this, &option](bool on) { changeScene([&option, on](Scene& scene) { option.switchTo(scene, on); }); });
  shows_.emplace_back([this, box, &effect, &option] {
    box->setChecked(option.isOn(session_.console().scene()));
    box->setEnabled(effect.isOn(session_.console().scene()));
  });
}

void ConsolePanel::addEffectsPage(QVBoxLayout* rows) {
  for (const EffectInfo& effect : sceneEffects()) addEffect(rows, effect);

  auto* reset = new QPushButton;
  reset->setObjectName(QStringLiteral("sceneReset"));
  setLook(reset, Look::compact);
  reset->setFocusPolicy(Qt::TabFocus);
  rows->addSpacing(8);
  rows->addWidget(reset);
  connect(reset, &QPushButton::clicked, this, [this] {
    if (session_.console().canUndoSceneReset()) {
      session_.console().undoSceneReset();
    } else {
      session_.console().resetScene();
    }
  });
  shows_.emplace_back([this, reset] {
    const bool undo = session_.console().canUndoSceneReset();
    reset->setText(undo ? tr("Undo: effects of the case") : tr("Effects of the case"));
    reset->setToolTip(undo ? tr("Back to the effects as they were switched before") : tr("Back to the effects that the case calls for"));
    reset->setEnabled(undo || (session_.subject() && !session_.console().hasCaseScene()));
  });
  connect(&session_, &Session::subjectChanged, this, [this] { remembered_ = sceneWithEverything(); });
}

}  // namespace ew::ui
