#include "keys/key_map.h"

#include <QKeyEvent>
#include <algorithm>

namespace ew::ui {
namespace {

constexpr int kModifiers = static_cast<int>(Qt::KeyboardModifierMask);

QKeySequence sequenceOf(const std::string& name) { return QKeySequence(QString::fromStdString(name), QKeySequence::PortableText); }

std::vector<std::string> namesOf(const QList<QKeySequence>& keys) {
  std::vector<std::string> names;
  for (const QKeySequence& key : keys) names.push_back(key.toString(QKeySequence::PortableText).toStdString());
  return names;
}

}  // namespace

KeyMap::KeyMap(QObject* parent) : QObject(parent), commands_(keyTable()) { settle(); }

const KeyCommand* KeyMap::find(const std::string& id) const {
  const auto found = std::find_if(commands_.begin(), commands_.end(), [&](const KeyCommand& each) { return each.id == id; });
  return found != commands_.end() ? &*found : nullptr;
}

QList<QKeySequence> KeyMap::keysOf(const std::string& id) const {
  const auto found = keys_.find(id);
  return found != keys_.end() ? found->second : QList<QKeySequence>{};
}

QString KeyMap::words(const std::string& ids) const {
  QStringList shown;
  for (const QString& id : QString::fromStdString(ids).split(QStringLiteral(" | ")))
    for (const QKeySequence& key : keysOf(id.toStdString())) shown << key.toString(QKeySequence::NativeText);
  return shown.join(QStringLiteral(", "));
}

int KeyMap::strokeOf(const QKeyEvent& event) {
  int key = event.key();
  Qt::KeyboardModifiers modifiers = event.modifiers() & ~Qt::KeypadModifier;
  if (key == Qt::Key_Enter) key = Qt::Key_Return;
  if (key == Qt::Key_Backtab) key = Qt::Key_Tab;
  // Shift that only chose a sign is part of that sign: "!" and not "Shift+!".
  const QString text = event.text();
  if (!text.isEmpty() && text.at(0).isPrint() && !text.at(0).isLetterOrNumber() && !text.at(0).isSpace()) modifiers &= ~Qt::ShiftModifier;
  return key | static_cast<int>(modifiers);
}

bool KeyMap::isKey(const QKeySequence& key) {
  if (key.count() != 1) return false;
  switch (key[0] & ~kModifiers) {
    case 0:
    case Qt::Key_unknown:
    case Qt::Key_Escape:
    case Qt::Key_Shift:
    case Qt::Key_Control:
    case Qt::Key_Alt:
    case Qt::Key_AltGr:
    case Qt::Key_Meta:
      return false;
    default:
      return true;
  }
}

bool KeyMap::collide(const KeyCommand& a, const QKeySequence& keyOfA, const KeyCommand& b, const QKeySequence& keyOfB) {
  if ((a.when & b.when) == 0 || keyOfA.isEmpty() || keyOfB.isEmpty()) return false;
  const int widens = static_cast<int>(a.widens | b.widens);
  return (keyOfA[0] & ~widens) == (keyOfB[0] & ~widens);
}

std::vector<const KeyCommand*> KeyMap::holdersOf(const QKeySequence& key, const std::string& id) const {
  std::vector<const KeyCommand*> holders;
  const KeyCommand* wants = find(id);
  if (wants == nullptr) return holders;
  for (const KeyCommand& each : commands_) {
    if (each.id == id) continue;
    for (const QKeySequence& its : keysOf(each.id))
      if (collide(*wants, key, each, its)) {
        holders.push_back(&each);
        break;
      }
  }
  return holders;
}

std::string KeyMap::meant(const QKeyEvent& event, unsigned state) const {
  const int stroke = strokeOf(event);
  for (const KeyCommand& each : commands_) {
    if (each.isAction || (each.when & state) == 0) continue;
    const int widens = static_cast<int>(each.widens);
    for (const QKeySequence& its : keysOf(each.id))
      if ((stroke & ~widens) == (its[0] & ~widens)) return each.id;
  }
  return {};
}

void KeyMap::setKeys(const std::string& id, const QList<QKeySequence>& keys) {
  const KeyCommand* command = find(id);
  if (command == nullptr || command->isFixed) return;
  for (const QKeySequence& key : keys)
    for (const KeyCommand* holder : holdersOf(key, id)) {
      if (holder->isFixed) return;
      QList<QKeySequence> left = keysOf(holder->id);
      left.erase(std::remove_if(left.begin(), left.end(), [&](const QKeySequence& its) { return collide(*command, key, *holder, its); }),
                 left.end());
      own_[holder->id] = namesOf(left);
    }
  if (keys == command->usual)
    own_.erase(id);
  else
    own_[id] = namesOf(keys);
  settle();
  Q_EMIT changed();
}

void KeyMap::reset(const std::string& id) {
  const KeyCommand* command = find(id);
  if (command != nullptr) setKeys(id, command->usual);
}

void KeyMap::resetAll() {
  own_.clear();
  settle();
  Q_EMIT changed();
}

/// The keys of every command: first what is fixed, then what the user chose, then what is usual and still free.
void KeyMap::settle() {
  keys_.clear();
  const auto give = [&](const KeyCommand& command, const QKeySequence& key) {
    if (holdersOf(key, command.id).empty()) keys_[command.id] << key;
  };
  for (const KeyCommand& each : commands_)
    if (each.isFixed) keys_[each.id] = each.usual;
  for (const KeyCommand& each : commands_) {
    const auto own = own_.find(each.id);
    if (each.isFixed || own == own_.end()) continue;
    for (const std::string& name : own->second) give(each, sequenceOf(name));
  }
  for (const KeyCommand& each : commands_)
    if (!each.isFixed && own_.find(each.id) == own_.end())
      for (const QKeySequence& key : each.usual) give(each, key);
}

QStringList KeyMap::setOwn(const Own& own) {
  QStringList problems;
  own_.clear();
  for (const auto& [id, names] : own) {
    const KeyCommand* command = find(id);
    std::vector<std::string>& kept = own_[id];
    for (const std::string& name : names) {
      if (isKey(sequenceOf(name)))
        kept.push_back(name);
      else
        problems << tr("'%1' is the name of no key that can be given to '%2'.")
                        .arg(QString::fromStdString(name), command != nullptr ? command->name() : QString::fromStdString(id));
    }
    // Nothing that can be read is no wish to have none.
    if ((kept.empty() && !names.empty()) || (command != nullptr && command->isFixed)) own_.erase(id);
  }
  settle();
  for (const auto& [id, names] : own_) {
    const KeyCommand* command = find(id);
    if (command == nullptr) continue;
    for (const std::string& name : names)
      if (!keysOf(id).contains(sequenceOf(name)))
        problems << tr("'%1' is given to '%2' and to another action; that one has it.").arg(QString::fromStdString(name), command->name());
  }
  Q_EMIT changed();
  return problems;
}

bool KeyMap::add(KeyCommand command) {
  if (find(command.id) != nullptr) return false;
  commands_.push_back(std::move(command));
  settle();
  Q_EMIT changed();
  return true;
}

void KeyMap::remove(const std::string& id) {
  std::erase_if(commands_, [&](const KeyCommand& each) { return each.id == id; });
  settle();
  Q_EMIT changed();
}

const KeyMap& usualKeys() {
  static const KeyMap keys;
  return keys;
}

}  // namespace ew::ui
