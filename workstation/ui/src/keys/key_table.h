#pragma once

#include <QByteArray>
#include <QKeySequence>
#include <QList>
#include <QString>
#include <string>
#include <vector>

#include "ew/measurement/caliper.h"

namespace ew::ui {

/// Where a key means what it does; two commands may share a key when no state is common to both.
enum KeyState : unsigned {
  kWhileRunning = 1,   ///< the image runs
  kWhileStill = 2,     ///< frozen, or a recording is shown
  kWithTool = 4,       ///< calipers, an arrow or the question for the source frame are in the hand; they go before the states above
  kWithChosen = 8,     ///< a text or an arrow is chosen; goes before the states above
  kWhileWriting = 16,  ///< a text is being typed; goes before all others
  kWithHandles = 32,   ///< in the 3D view while something in it has handles; goes before the states of the image
  kAlways = kWhileRunning | kWhileStill
};

/// As the page of keys (F1) and the editor have them, in that order.
enum class KeyGroup { probe, image, frozen, measure, annotate, view3d, settings, effects, author, window, tools };

/// What a key can do. The one list of them: the window's actions, the hand, the layers, the page of keys and the editor read it.
struct KeyCommand {
  std::string id;
  KeyGroup group = KeyGroup::window;
  const char* context = nullptr;  ///< of the translator; null: `source` stands for itself
  QByteArray source;              ///< what the menu says, with its "&"
  QList<QKeySequence> usual;      ///< keys as long as the user chose none
  unsigned when = kAlways;
  Qt::KeyboardModifiers widens = Qt::NoModifier;  ///< held with the key, they change how far it goes and not what it does
  bool isFixed = false;                           ///< the key cannot be another one: Escape, and what belongs to typing
  bool isAction = true;                           ///< of the menus; else of a view that has the focus

  [[nodiscard]] QString text() const;  ///< as a menu shows it
  [[nodiscard]] QString name() const;  ///< without "&" and "…"
};

/// All but those of plugins.
[[nodiscard]] std::vector<KeyCommand> keyTable();
[[nodiscard]] QString titleOf(KeyGroup group);
[[nodiscard]] QString wordsOfStates(unsigned when);

/// Ids of the commands that are made of other lists.
[[nodiscard]] std::string effectCommand(const char* effectKey);
[[nodiscard]] std::string caliperCommand(measurement::CaliperKind kind);

}  // namespace ew::ui
