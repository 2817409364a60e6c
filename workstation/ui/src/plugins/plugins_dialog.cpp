#include "plugins/plugins_dialog.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>
#include <QVariant>

#include "ew/widgets/look.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"

namespace ew::ui {
namespace {

QString stateOf(const door::PluginStatus& plugin) {
  switch (plugin.state) {
    case door::PluginState::loaded:
      return PluginsDialog::tr("running");
    case door::PluginState::found:
      return PluginsDialog::tr("found");
    default:
      return PluginsDialog::tr("not loaded");
  }
}

QLabel* quiet(const QString& text) {
  auto* label = new QLabel(text);
  setLook(label, Look::quiet);
  setLook(label, Look::small);
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

QWidget* rowOf(const door::PluginStatus& plugin) {
  auto* row = new QFrame;
  row->setObjectName(QStringLiteral("jobCard"));
  auto* lines = new QVBoxLayout(row);
  lines->setContentsMargins(16, 12, 16, 12);
  lines->setSpacing(4);
  auto* head = new QHBoxLayout;
  auto* title = new QLabel(words(plugin.title()));
  setLook(title, Look::heading);
  head->addWidget(title);
  if (plugin.manifest) head->addWidget(quiet(words(plugin.manifest->version)));
  head->addStretch(1);
  auto* state = new QLabel(stateOf(plugin));
  const bool runs = plugin.state == door::PluginState::loaded || plugin.state == door::PluginState::found;
  state->setStyleSheet(QStringLiteral("color: %1;").arg((runs ? currentTheme().accent : currentTheme().danger).name()));
  head->addWidget(state);
  lines->addLayout(head);
  if (plugin.manifest && !plugin.manifest->description.empty()) lines->addWidget(quiet(words(plugin.manifest->description)));
  if (!plugin.message.empty()) {
    auto* sentence = new QLabel(words(plugin.message));
    sentence->setWordWrap(true);
    sentence->setTextInteractionFlags(Qt::TextSelectableByMouse);
    lines->addWidget(sentence);
  }
  lines->addWidget(quiet(wordsOf(plugin.folder)));
  return row;
}

}  // namespace

PluginsDialog::PluginsDialog(const std::vector<door::PluginStatus>& plugins, QWidget* parent) : QDialog(parent) {
  setObjectName(QStringLiteral("pluginsDialog"));
  setWindowTitle(tr("Plugins"));
  resize(640, 480);
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(16, 16, 16, 16);
  outer->setSpacing(16);
  auto* list = new QWidget;
  auto* rows = new QVBoxLayout(list);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(8);
  for (const door::PluginStatus& plugin : plugins) rows->addWidget(rowOf(plugin));
  if (plugins.empty()) {
    QStringList folders;
    for (const auto& folder : door::pluginFolders()) folders << wordsOf(folder);
    rows->addWidget(quiet(
        folders.isEmpty() ? tr("There are no plugin folders. Put a plugin's folder into lib/plugins beside the program, or name a folder "
                               "in ECHOWEAVE_PLUGINS, and start again.")
                          : tr("No plugins were found in %1. Put a plugin's folder there and start again.").arg(folders.join(tr(" or ")))));
  }
  rows->addStretch(1);
  auto* scroll = new QScrollArea;
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidget(list);
  outer->addWidget(scroll, 1);
  auto* close = new QPushButton(tr("Close"));
  auto* buttons = new QHBoxLayout;
  buttons->addStretch(1);
  buttons->addWidget(close);
  outer->addLayout(buttons);
  connect(close, &QPushButton::clicked, this, &QDialog::accept);
}

}  // namespace ew::ui
