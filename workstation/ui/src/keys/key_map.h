#pragma once

#include <QObject>
#include <map>
#include <string>
#include <vector>

#include "keys/key_table.h"

class QKeyEvent;

namespace ew::ui {

/// Which keys every command has now: the usual ones, and those the user chose. Two commands that can be wanted in the same state never
/// share a key: a chosen key goes before a usual one.
class KeyMap final : public QObject {
  Q_OBJECT

 public:
  using Own = std::map<std::string, std::vector<std::string>>;

  explicit KeyMap(QObject* parent = nullptr);

  [[nodiscard]] const std::vector<KeyCommand>& commands() const { return commands_; }
  [[nodiscard]] const KeyCommand* find(const std::string& id) const;
  [[nodiscard]] QList<QKeySequence> keysOf(const std::string& id) const;
  /// Of one command or several ("depth.less | depth.more"), as the system's language calls them: "Bild auf, Bild ab". Empty: no key.
  [[nodiscard]] QString words(const std::string& ids) const;
  [[nodiscard]] bool hasUsualKeys(const std::string& id) const { return own_.find(id) == own_.end(); }

  /// Those that have the key in a state in which `id` needs it.
  [[nodiscard]] std::vector<const KeyCommand*> holdersOf(const QKeySequence& key, const std::string& id) const;
  /// The command of a view that a key press means in that state; empty: none. @param state one KeyState
  [[nodiscard]] std::string meant(const QKeyEvent& event, unsigned state) const;

  /// Gives a command these keys and takes them from those that have them.
  void setKeys(const std::string& id, const QList<QKeySequence>& keys);
  void reset(const std::string& id);
  void resetAll();

  /// What the user chose, also for commands of plugins that are not there.
  [[nodiscard]] const Own& own() const { return own_; }
  /// @return what of it cannot be used, in sentences: names of no key, a key given twice; the rest holds
  QStringList setOwn(const Own& own);

  /// A command of a plugin; its usual keys are dropped where others have them. @return false: there is one of that id
  bool add(KeyCommand command);
  void remove(const std::string& id);

  /// Whether one press can mean both.
  [[nodiscard]] static bool collide(const KeyCommand& a, const QKeySequence& keyOfA, const KeyCommand& b, const QKeySequence& keyOfB);
  /// The stroke of a key press, as key sequences count it.
  [[nodiscard]] static int strokeOf(const QKeyEvent& event);
  /// A key that can be given: one stroke, not a modifier alone, not Escape.
  [[nodiscard]] static bool isKey(const QKeySequence& key);

 Q_SIGNALS:
  void changed();

 private:
  void settle();

  std::vector<KeyCommand> commands_;
  Own own_;
  std::map<std::string, QList<QKeySequence>> keys_;
};

/// The usual keys, for views that no window gave any others.
[[nodiscard]] const KeyMap& usualKeys();

}  // namespace ew::ui
