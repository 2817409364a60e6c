#include "keys/keys_dialog.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QScreen>
#include <QTabWidget>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <map>

#include "ew/controls/keys_file.h"
#include "ew/widgets/look.h"
#include "ew/widgets/save_file.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"
#include "keys/control_surface.h"
#include "keys/control_words.h"
#include "keys/key_field.h"

namespace ew::ui {
namespace {

using controls::Binding;
using controls::Encoding;
using controls::Target;

constexpr int kMostKeys = 8;  // of one action; what the file may hold
constexpr int kId = Qt::UserRole;

QLabel* sentenceLabel(const char* name) {
  auto* label = new QLabel;
  label->setObjectName(QLatin1String(name));
  label->setWordWrap(true);
  return label;
}

QPushButton* button(const QString& text, const char* name, const QString& tip) {
  auto* made = new QPushButton(text);
  made->setObjectName(QLatin1String(name));
  made->setToolTip(tip);
  made->setAccessibleName(text);
  made->setAutoDefault(false);
  return made;
}

QTreeWidget* makeList(const char* name, const QString& what, const QStringList& heads) {
  auto* list = new QTreeWidget;
  list->setObjectName(QLatin1String(name));
  list->setAccessibleName(what);
  list->setColumnCount(heads.size());
  list->setHeaderLabels(heads);
  list->setUniformRowHeights(true);
  list->setAllColumnsShowFocus(true);
  list->header()->setStretchLastSection(false);
  list->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  for (int n = 1; n < heads.size(); ++n) list->header()->setSectionResizeMode(n, QHeaderView::ResizeToContents);
  return list;
}

/// Commands that a button of a device can do: those that need no focus.
bool isForButtons(const KeyCommand& command) {
  return command.isAction || command.group == KeyGroup::probe || command.group == KeyGroup::frozen;
}

}  // namespace

KeysDialog::KeysDialog(KeyMap& keys, ControlSurface& surface, std::vector<PanelKey> ofPanels, QWidget* parent)
    : QDialog(parent), keys_(keys), surface_(surface), ofPanels_(std::move(ofPanels)) {
  setObjectName(QStringLiteral("keysDialog"));
  setWindowTitle(tr("Keys and controls"));
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(16, 16, 16, 16);
  outer->setSpacing(12);
  auto* pages = new QTabWidget;
  pages->setObjectName(QStringLiteral("keysPages"));
  pages->setDocumentMode(true);
  pages->addTab(makeKeys(), tr("Keys"));
  pages->addTab(makeControls(), tr("Controls"));
  pages->setTabToolTip(0, tr("What the keyboard and foot pedals do"));
  pages->setTabToolTip(1, tr("What knobs, faders, jog wheels and buttons of other devices do"));
  outer->addWidget(pages, 1);
  fileSaid_ = sentenceLabel("keysFileSaid");
  fileSaid_->hide();
  outer->addWidget(fileSaid_);
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(8);
  auto* all = button(tr("Reset all keys"), "resetAllKeys", tr("Give every action its usual keys again; controls stay"));
  auto* take = button(tr("Open a file…"), "openKeys", tr("Take over keys and controls that somebody saved"));
  auto* give = button(tr("Save as a file…"), "saveKeys", tr("Save your keys and controls, to give them to others"));
  auto* close = button(tr("Close"), "closeKeysDialog", tr("Close; everything is kept already"));
  for (QPushButton* each : {all, take, give}) buttons->addWidget(each);
  buttons->addStretch(1);
  buttons->addWidget(close);
  outer->addLayout(buttons);
  connect(close, &QPushButton::clicked, this, &QDialog::close);
  connect(give, &QPushButton::clicked, this, &KeysDialog::saveFile);
  connect(take, &QPushButton::clicked, this, [this] {
    const QString file = QFileDialog::getOpenFileName(this, tr("Open keys and controls"), QString(), tr("Keys and controls (*.json)"));
    if (!file.isEmpty()) takeFile(file);
  });
  connect(all, &QPushButton::clicked, this, [this, pages] {
    pages->setCurrentIndex(0);  // where the question stands
    ask(tr("Give every action its usual keys again?"), tr("Reset all"), [this] {
      keys_.resetAll();
      Q_EMIT changed();
    });
  });
  connect(&keys_, &KeyMap::changed, this, &KeysDialog::fillKeys);
  connect(&surface_, &ControlSurface::bindingsChanged, this, &KeysDialog::fillControls);
  connect(&surface_, &ControlSurface::learningChanged, this, &KeysDialog::showLearning);
  connect(&surface_, &ControlSurface::stateChanged, this, &KeysDialog::showDevices);
  connect(&surface_, &ControlSurface::learnt, this, [this](const QString& before) {
    learning_->setText(before.isEmpty() ? tr("Bound. It acts from now on.")
                                        : tr("Bound. Until now this control did '%1'; it does that no longer.").arg(before));
  });
  surface_.setLooking(true);
  fillKeys();
  for (const int column : {1, 2}) {  // as wide as the whole list needs: nothing jumps while it is filtered
    list_->header()->setSectionResizeMode(column, QHeaderView::Interactive);
    const int wanted_px = static_cast<const QAbstractItemView*>(list_)->sizeHintForColumn(column) + 16;
    list_->header()->resizeSection(column, std::clamp(wanted_px, 120, 280));
  }
  fillTargets();
  fillControls();
  showLearning();
  showDevices();
  const QSize room = QApplication::primaryScreen()->availableSize();
  resize(std::min(860, room.width() - 48), std::min(680, room.height() - 80));
  filter_->setFocus();
}

KeysDialog::~KeysDialog() {
  surface_.disconnect(this);
  if (surface_.isLearning()) surface_.stopLearning();
  surface_.setLooking(false);
}

QWidget* KeysDialog::makeKeys() {
  auto* page = new QWidget;
  auto* rows = new QVBoxLayout(page);
  rows->setContentsMargins(0, 12, 0, 0);
  rows->setSpacing(8);
  filter_ = new QLineEdit;
  filter_->setObjectName(QStringLiteral("findKey"));
  filter_->setPlaceholderText(tr("Find an action or a key"));
  filter_->setAccessibleName(filter_->placeholderText());
  filter_->setToolTip(tr("Part of an action's name, of its group or of a key: freeze, 3D, F13"));
  filter_->setClearButtonEnabled(true);
  list_ = makeList("keyList", tr("Actions and their keys"), {tr("Action"), tr("Keys"), tr("When")});
  rows->addWidget(filter_);
  rows->addWidget(list_, 1);
  rows->addWidget(makeChosen());
  connect(filter_, &QLineEdit::textChanged, this, &KeysDialog::filter);
  connect(list_, &QTreeWidget::currentItemChanged, this, [this] {
    tell({});
    showChosen();
  });
  connect(list_, &QTreeWidget::itemActivated, this, [this] {
    if (field_->isEnabled()) field_->setFocus();
  });
  return page;
}

QWidget* KeysDialog::makeChosen() {
  auto* box = new QWidget;
  auto* rows = new QVBoxLayout(box);
  rows->setContentsMargins(0, 4, 0, 0);
  rows->setSpacing(8);
  name_ = new QLabel;
  name_->setObjectName(QStringLiteral("chosenKey"));
  setLook(name_, Look::heading);
  rows->addWidget(name_);
  auto* line = new QHBoxLayout;
  line->setSpacing(8);
  present_ = new QHBoxLayout;
  present_->setSpacing(4);
  field_ = new KeyField;
  field_->setObjectName(QStringLiteral("keyField"));
  field_->setPlaceholderText(tr("Click here, then press a key"));
  field_->setAccessibleName(tr("New key"));
  field_->setToolTip(tr("Takes the next key, also F13 to F24, media keys and a foot pedal; Escape leaves it"));
  holdFixedWidth(*field_, 232);
  reset_ = button(tr("Usual keys"), "resetKey", tr("Give this action its usual keys again"));
  line->addWidget(field_);
  line->addLayout(present_);
  line->addStretch(1);
  line->addWidget(reset_);
  rows->addLayout(line);
  auto* answer = new QHBoxLayout;
  answer->setSpacing(8);
  said_ = sentenceLabel("keySaid");
  said_->setMinimumHeight(fontMetrics().height() * 2 + 4);  // nothing jumps when it speaks
  yes_ = button({}, "keyYes", tr("Do what the sentence says"));
  no_ = button(tr("Cancel"), "keyNo", tr("Leave everything as it is"));
  answer->addWidget(said_, 1);
  answer->addWidget(yes_);
  answer->addWidget(no_);
  rows->addLayout(answer);
  connect(field_, &KeyField::pressed, this, [this](const QKeySequence& key) { addKey(key, false); });
  connect(field_, &KeyField::nameless, this, [this] { tell(tr("This key has no name on this system, so nothing can be bound to it.")); });
  connect(field_, &KeyField::left, this, [this] { list_->setFocus(); });
  connect(reset_, &QPushButton::clicked, this, [this] {
    const KeyCommand* command = chosen();
    if (command == nullptr) return;
    QStringList others;
    for (const QKeySequence& key : command->usual)
      for (const KeyCommand* each : keys_.holdersOf(key, command->id)) others << each->name();
    const auto reset = [this, id = command->id] {
      keys_.reset(id);
      Q_EMIT changed();
    };
    if (others.isEmpty()) return reset();
    ask(tr("A usual key of this action now does '%1'. Take it away there?").arg(others.join(QStringLiteral("', '"))), tr("Take it away"),
        reset);
  });
  connect(yes_, &QPushButton::clicked, this, [this] {
    const auto yes = std::exchange(onYes_, {});
    tell({});
    if (yes) yes();
  });
  connect(no_, &QPushButton::clicked, this, [this] { tell({}); });
  tell({});
  return box;
}

void KeysDialog::fillKeys() {
  const std::string before = chosen() != nullptr ? chosen()->id : std::string();
  const QSignalBlocker quiet(list_);
  list_->clear();
  std::map<KeyGroup, QTreeWidgetItem*> groups;
  const auto groupOf = [this](const QString& title) {
    auto* item = new QTreeWidgetItem(list_, {title});
    item->setFlags(Qt::ItemIsEnabled);
    item->setFirstColumnSpanned(true);
    QFont bold = item->font(0);
    bold.setBold(true);
    item->setFont(0, bold);
    return item;
  };
  for (int n = 0; n <= static_cast<int>(KeyGroup::tools); ++n) {
    const auto group = static_cast<KeyGroup>(n);
    for (const KeyCommand& each : keys_.commands()) {
      if (each.group != group) continue;
      QTreeWidgetItem*& above = groups[group];
      if (above == nullptr) above = groupOf(titleOf(group));
      auto* item = new QTreeWidgetItem(above, {each.name(), keys_.words(each.id), wordsOfStates(each.when)});
      item->setData(0, kId, QString::fromStdString(each.id));
      if (!keys_.hasUsualKeys(each.id)) {
        QFont bold = item->font(1);
        bold.setBold(true);
        item->setFont(1, bold);
        item->setToolTip(1, tr("Chosen by you; usually: %1")
                                .arg(each.usual.isEmpty() ? tr("none") : each.usual.front().toString(QKeySequence::NativeText)));
      }
      if (each.isFixed) item->setForeground(1, currentTheme().quiet);
      if (each.id == before) list_->setCurrentItem(item);
    }
  }
  QString panel;
  QTreeWidgetItem* above = nullptr;
  for (const PanelKey& each : ofPanels_) {
    if (above == nullptr || each.panel != panel) above = groupOf(panel = each.panel);
    auto* item = new QTreeWidgetItem(above, {each.what, each.key, tr("in its panel")});
    item->setForeground(1, currentTheme().quiet);
  }
  list_->expandAll();
  filter();
  showChosen();
}

void KeysDialog::filter() {
  const QStringList parts = filter_->text().split(QLatin1Char(' '), Qt::SkipEmptyParts);
  for (int n = 0; n < list_->topLevelItemCount(); ++n) {
    QTreeWidgetItem* group = list_->topLevelItem(n);
    bool isAny = false;
    for (int m = 0; m < group->childCount(); ++m) {
      QTreeWidgetItem* item = group->child(m);
      const QString whole = group->text(0) + QLatin1Char(' ') + item->text(0) + QLatin1Char(' ') + item->text(1);
      const bool fits =
          std::all_of(parts.begin(), parts.end(), [&](const QString& part) { return whole.contains(part, Qt::CaseInsensitive); });
      item->setHidden(!fits);
      isAny = isAny || fits;
    }
    group->setHidden(!isAny);
  }
}

const KeyCommand* KeysDialog::chosen() const {
  const QTreeWidgetItem* item = list_->currentItem();
  return item != nullptr ? keys_.find(item->data(0, kId).toString().toStdString()) : nullptr;
}

void KeysDialog::showChosen() {
  while (QLayoutItem* item = present_->takeAt(0)) {
    item->widget()->deleteLater();
    delete item;
  }
  const KeyCommand* command = chosen();
  const bool isOpen = command != nullptr && !command->isFixed;
  field_->setEnabled(isOpen);
  reset_->setEnabled(isOpen && !keys_.hasUsualKeys(command->id));
  if (command == nullptr) {
    name_->setText(list_->currentItem() != nullptr && list_->currentItem()->parent() != nullptr
                       ? tr("A key of a panel: the plugin decides about it")
                       : tr("Choose an action above"));
    return;
  }
  const QString when = wordsOfStates(command->when);
  name_->setText(command->isFixed ? tr("%1: always this key").arg(command->name())
                 : when.isEmpty() ? command->name()
                                  : QStringLiteral("%1, %2").arg(command->name(), when));
  if (command->isFixed) return;
  const QList<QKeySequence> now = keys_.keysOf(command->id);
  for (const QKeySequence& key : now) {
    auto* each =
        button(key.toString(QKeySequence::NativeText) + QStringLiteral("  ×"), "takeKey", tr("Take this key away from the action"));
    each->setAccessibleName(tr("Take %1 away").arg(key.toString(QKeySequence::NativeText)));
    connect(each, &QPushButton::clicked, this, [this, key, now] {
      QList<QKeySequence> left = now;
      left.removeAll(key);
      setKeys(left);
    });
    present_->addWidget(each);
  }
}

void KeysDialog::setKeys(const QList<QKeySequence>& keys) {
  const KeyCommand* command = chosen();
  if (command == nullptr) return;
  tell({});
  keys_.setKeys(command->id, keys);
  Q_EMIT changed();
}

void KeysDialog::addKey(const QKeySequence& key, bool takesAway) {
  const KeyCommand* command = chosen();
  if (command == nullptr || command->isFixed) return;
  const QString said = key.toString(QKeySequence::NativeText);
  QList<QKeySequence> wanted = keys_.keysOf(command->id);
  if (wanted.contains(key)) return tell(tr("%1 does that already.").arg(said));
  if (wanted.size() >= kMostKeys) return tell(tr("An action has at most %1 keys; take one away first.").arg(kMostKeys));
  QStringList others;
  for (const KeyCommand* holder : keys_.holdersOf(key, command->id)) {
    const QString when = wordsOfStates(holder->when);
    const QString name = when.isEmpty() ? holder->name() : QStringLiteral("%1 (%2)").arg(holder->name(), when);
    if (holder->isFixed) return tell(tr("%1 always does '%2'; press another key.").arg(said, name));
    others << name;
  }
  if (!others.isEmpty() && !takesAway)
    return ask(tr("%1 now does '%2'. Take it away there?").arg(said, others.join(QStringLiteral("', '"))), tr("Take it away"),
               [this, key] { addKey(key, true); });
  wanted << key;
  setKeys(wanted);
  tell(tr("%1 does '%2' from now on.").arg(said, command->name()));
}

void KeysDialog::ask(const QString& question, const QString& answer, std::function<void()> yes) {
  said_->setText(question);
  yes_->setText(answer);
  yes_->setAccessibleName(answer);
  onYes_ = std::move(yes);
  yes_->show();
  no_->show();
}

void KeysDialog::tell(const QString& sentence) {
  said_->setText(sentence);
  onYes_ = {};
  yes_->hide();
  no_->hide();
}

QWidget* KeysDialog::makeControls() {
  auto* page = new QWidget;
  auto* rows = new QVBoxLayout(page);
  rows->setContentsMargins(0, 12, 0, 0);
  rows->setSpacing(8);
  auto* line = new QHBoxLayout;
  line->setSpacing(8);
  targets_ = new QComboBox;
  targets_->setObjectName(QStringLiteral("controlTarget"));
  targets_->setAccessibleName(tr("What the control shall do"));
  targets_->setToolTip(tr("A setting for a knob, or an action for a button"));
  targets_->setMaxVisibleItems(20);
  learn_ = button(tr("Learn"), "learnControl", tr("Bind what you move next"));
  setLook(learn_, Look::primary);
  line->addWidget(targets_, 1);
  line->addWidget(learn_);
  rows->addLayout(line);
  learning_ = sentenceLabel("learning");
  learning_->setMinimumHeight(fontMetrics().height() + 4);
  rows->addWidget(learning_);
  controls_ =
      makeList("controlList", tr("Controls and what they do"), {tr("Does"), tr("Device"), tr("Control"), tr("Read as"), tr("Reversed")});
  controls_->setRootIsDecorated(false);
  rows->addWidget(controls_, 1);
  auto* below = new QHBoxLayout;
  below->setSpacing(8);
  devices_ = sentenceLabel("controlDevices");
  setLook(devices_, Look::quiet);
  remove_ = button(tr("Remove"), "removeControl", tr("The chosen control does nothing any more"));
  below->addWidget(devices_, 1);
  below->addWidget(remove_, 0, Qt::AlignTop);
  rows->addLayout(below);
  connect(learn_, &QPushButton::clicked, this, &KeysDialog::learn);
  connect(remove_, &QPushButton::clicked, this, &KeysDialog::removeBinding);
  connect(controls_, &QTreeWidget::currentItemChanged, this, [this] { remove_->setEnabled(controls_->currentItem() != nullptr); });
  return page;
}

void KeysDialog::fillTargets() {
  targets_->clear();
  for (const SurfaceSetting& each : surface_.settings())
    targets_->addItem(QStringLiteral("%1: %2").arg(each.group, each.name),
                      QStringList{QStringLiteral("setting"), QString::fromStdString(each.id)});
  targets_->insertSeparator(targets_->count());
  for (const KeyCommand& each : keys_.commands())
    if (isForButtons(each) && !each.isFixed)
      targets_->addItem(tr("Button: %1: %2").arg(titleOf(each.group), each.name()),
                        QStringList{QStringLiteral("action"), QString::fromStdString(each.id)});
}

QString KeysDialog::nameOf(const Target& target) const {
  if (target.kind == Target::Kind::setting) {
    const SurfaceSetting* found = surface_.setting(target.id);
    return found != nullptr ? found->name : QString::fromStdString(target.id);
  }
  const KeyCommand* found = keys_.find(target.id);
  return found != nullptr ? found->name() : QString::fromStdString(target.id);
}

void KeysDialog::fillControls() {
  controls_->clear();
  const std::vector<Binding>& bindings = surface_.bindings();
  for (int n = 0; n < static_cast<int>(bindings.size()); ++n) {
    const Binding& each = bindings[static_cast<std::size_t>(n)];
    auto* item = new QTreeWidgetItem(
        controls_, {nameOf(each.target), QString::fromStdString(each.control.device), ControlWords::nameOf(each.control)});
    if (each.encoding == Encoding::button) {
      item->setText(3, ControlWords::nameOf(Encoding::button));
      continue;
    }
    auto* encoding = new QComboBox;
    encoding->setAccessibleName(tr("How %1 is read").arg(item->text(2)));
    encoding->setToolTip(tr("How its values are read; change it when it moves the wrong way or jumps"));
    for (const Encoding one : {Encoding::absolute, Encoding::twosComplement, Encoding::offset64, Encoding::signBit, Encoding::counter})
      if (controls::fits(one, each.control.kind)) encoding->addItem(ControlWords::nameOf(one), static_cast<int>(one));
    encoding->setCurrentIndex(encoding->findData(static_cast<int>(each.encoding)));
    connect(encoding, QOverload<int>::of(&QComboBox::activated), this, [this, n, encoding] {
      changeBinding(n, [&](Binding& binding) { binding.encoding = static_cast<Encoding>(encoding->currentData().toInt()); });
    });
    controls_->setItemWidget(item, 3, encoding);
    auto* reversed = new QCheckBox;
    reversed->setAccessibleName(tr("%1, reversed").arg(item->text(2)));
    reversed->setToolTip(tr("To the right is less"));
    reversed->setChecked(each.reversed);
    connect(reversed, &QCheckBox::toggled, this,
            [this, n](bool on) { changeBinding(n, [on](Binding& binding) { binding.reversed = on; }); });
    controls_->setItemWidget(item, 4, reversed);
  }
  remove_->setEnabled(controls_->currentItem() != nullptr);
}

void KeysDialog::changeBinding(int row, const std::function<void(Binding&)>& change) {
  std::vector<Binding> bindings = surface_.bindings();
  change(bindings[static_cast<std::size_t>(row)]);
  surface_.setBindings(std::move(bindings));
  Q_EMIT changed();
}

void KeysDialog::removeBinding() {
  const int row = controls_->indexOfTopLevelItem(controls_->currentItem());
  if (row < 0) return;
  std::vector<Binding> bindings = surface_.bindings();
  bindings.erase(bindings.begin() + row);
  surface_.setBindings(std::move(bindings));
  fillControls();
  Q_EMIT changed();
}

void KeysDialog::learn() {
  if (surface_.isLearning()) return surface_.stopLearning();
  const QStringList target = targets_->currentData().toStringList();
  if (target.size() != 2) return;
  surface_.learn({target[0] == QStringLiteral("action") ? Target::Kind::action : Target::Kind::setting, target[1].toStdString()});
}

void KeysDialog::showLearning() {
  const bool isLearning = surface_.isLearning();
  learn_->setText(isLearning ? tr("Stop") : tr("Learn"));
  learn_->setAccessibleName(learn_->text());
  targets_->setEnabled(!isLearning);
  const QStringList target = targets_->currentData().toStringList();
  const bool isAction = !target.isEmpty() && target[0] == QStringLiteral("action");
  learning_->setText(isLearning ? ControlWords::sentenceOf(surface_.learnerNeeds(), isAction ? Target::Kind::action : Target::Kind::setting)
                                : tr("Choose what a knob or a button shall do, press Learn, then move it."));
}

void KeysDialog::showDevices() {
  const controls::Hub::State state = surface_.state();
  QStringList lines, names;
  for (const controls::Device& each : state.devices)
    names << QStringLiteral("%1 (%2)").arg(QString::fromStdString(each.name),
                                           each.bus == controls::Device::Bus::midi ? QStringLiteral("MIDI") : QStringLiteral("HID"));
  lines << (names.isEmpty() ? tr("No control surface is plugged in.") : tr("Plugged in: %1.").arg(names.join(QStringLiteral(", "))));
  for (const Error& problem : state.problems) lines << words(problem.message);
  devices_->setText(lines.join(QLatin1Char('\n')));
}

void KeysDialog::saveFile() {
  const QString file = askSaveFile(
      this, {tr("Save keys and controls"), QStringLiteral("keys.json"), tr("Keys and controls (*.json)"), {QStringLiteral(".json")}});
  if (file.isEmpty()) return;
  const auto written = controls::writeKeys({keys_.own(), surface_.bindings()}, pathOf(file));
  fileSaid_->setText(written ? tr("Saved to %1. Whoever opens it here has the same keys and controls.").arg(file)
                             : words(written.error().message));
  fileSaid_->show();
}

void KeysDialog::takeFile(const QString& file) {
  const auto read = controls::readKeys(pathOf(file));
  fileSaid_->show();
  if (!read) return fileSaid_->setText(words(read.error().message) + QLatin1Char(' ') + tr("Your keys stay as they are."));
  if (!keys_.own().empty() || !surface_.bindings().empty()) {
    QMessageBox question(this);
    question.setObjectName(QStringLiteral("replaceKeysQuestion"));
    question.setIcon(QMessageBox::NoIcon);
    question.setText(tr("The keys and controls of this file take the place of yours."));
    question.setInformativeText(tr("Save yours as a file first if you want to have them back."));
    question.addButton(tr("Take them over"), QMessageBox::AcceptRole);
    question.addButton(QMessageBox::Cancel);
    if (question.exec() == QMessageBox::Cancel) return fileSaid_->hide();
  }
  const QStringList problems = keys_.setOwn(read->keys);
  surface_.setBindings(read->controls);
  fillControls();
  fileSaid_->setText(problems.isEmpty() ? tr("Taken over from %1.").arg(file)
                                        : tr("Taken over from %1, but: %2").arg(file, problems.join(QLatin1Char(' '))));
  Q_EMIT changed();
}

}  // namespace ew::ui
