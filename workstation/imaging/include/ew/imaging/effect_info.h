#pragma once

#include <optional>
#include <span>

#include "ew/imaging/scene.h"

namespace ew {

/// The one number of an effect that a console has a slider for.
struct EffectStrength {
  const char* tip;                     ///< what it is; translatable
  const char* pattern;                 ///< how a value is written, "%1 dB/mm"; translatable
  double shownFactor;                  ///< a value times this stands for %1: 100 for a share in per cent, -1 for a level below full white
  int decimals;                        ///< of what stands for %1
  double lowest, highest, step, page;  ///< in the parameter's own unit
  double (*of)(const Scene&);          ///< the scene has the effect
  void (*set)(Scene&, double);         ///< nothing happens in a scene without the effect
};

/// A part of an effect with a switch of its own, which acts only while the effect is on.
struct EffectOption {
  const char* key;  ///< within the effect's object in case.json
  const char* name;
  const char* shortName;
  const char* tip;
  const char* keyStroke;
  bool (*isOn)(const Scene&);         ///< false in a scene without the effect
  void (*switchTo)(Scene&, bool on);  ///< nothing happens in a scene without the effect
};

/// One effect of a scene, for everything that offers, names or switches effects: console, menus, page of keys, author's panel, command
/// line, contact sheet, benchmark. Texts are English and translatable in the context kEffectTexts.
struct EffectInfo {
  const char* key;        ///< in the scene of case.json
  const char* name;       ///< of a switch: "Slice thickness"
  const char* shortName;  ///< in a list of several: "slice thickness"
  const char* tip;        ///< what is seen of it; a sentence without its full stop
  const char* keyStroke;  ///< "F3"; empty: none
  bool (*isOn)(const Scene&);
  void (*switchTo)(Scene&, bool on);           ///< on: at its usual strength, or as it is when it is on already
  void (*copy)(const Scene& from, Scene& to);  ///< presence and parameters
  std::optional<EffectStrength> strength;
  std::optional<EffectOption> option;
};

/// The translator's context of every text above.
inline constexpr const char* kEffectTexts = "ew::EffectInfo";

/// Every effect a scene can have, in the order a console shows them.
[[nodiscard]] std::span<const EffectInfo> sceneEffects();

}  // namespace ew
