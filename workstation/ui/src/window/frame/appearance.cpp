#include "window/frame/appearance.h"

#include <QActionGroup>
#include <QLayout>
#include <QMenu>
#include <QSettings>
#include <algorithm>
#include <utility>

#include "ew/widgets/apply_theme.h"
#include "window/frame/columns.h"
#include "window/frame/commands.h"
#include "window/frame/window_parts.h"
#include "window/frame/workspaces.h"

namespace ew::ui {
namespace {

const auto kThemeSetting = QStringLiteral("theme");
const auto kTextSizeSetting = QStringLiteral("textSize");

}  // namespace

void Appearance::begin() {
  rememberSystemTheme();
  const QSettings settings;
  setTextSize(settings.value(kTextSizeSetting, kTextSizes_percent.front()).toInt());
  applyTheme(themeCalled(settings.value(kThemeSetting, QStringLiteral("dark")).toString()));
}

void Appearance::addMenus(QMenu& view) {
  addThemeMenu(*view.addMenu(tr("&Theme")));
  addTextSizeMenu(*view.addMenu(tr("Te&xt size")));
  addLanguageMenu(*view.addMenu(tr("La&nguage")));
}

void Appearance::addThemeMenu(QMenu& theme) {
  auto* themes = new QActionGroup(&parts_.window);
  system_ = parts_.commands->add(theme, "theme.system", [this] { chooseTheme(QStringLiteral("system")); });
  dark_ = parts_.commands->add(theme, "theme.dark", [this] { chooseTheme(QStringLiteral("dark")); });
  light_ = parts_.commands->add(theme, "theme.light", [this] { chooseTheme(QStringLiteral("light")); });
  for (QAction* action : {system_, dark_, light_}) {
    action->setCheckable(true);
    themes->addAction(action);
  }
}

void Appearance::addTextSizeMenu(QMenu& sizes) {
  sizes_ = new QActionGroup(&parts_.window);
  for (const int percent : kTextSizes_percent) {
    QAction* action = parts_.commands->addPlain(sizes, tr("%1 %").arg(percent), [this, percent] { chooseTextSize(percent); });
    action->setCheckable(true);
    action->setChecked(percent == textSize_percent());
    action->setData(percent);
    sizes_->addAction(action);
  }
  sizes.addSeparator();
  parts_.commands->add(sizes, "words.larger", [this] { stepTextSize(1); });
  parts_.commands->add(sizes, "words.smaller", [this] { stepTextSize(-1); });
}

void Appearance::addLanguageMenu(QMenu& language) {
  auto* languages = new QActionGroup(&parts_.window);
  const QString chosen = QSettings().value(QStringLiteral("language")).toString();
  const std::pair<QString, QString> offered[] = {{QString(), tr("System language")}, {"en", "English"}, {"de", "Deutsch"}};
  for (const auto& [code, name] : offered) {
    QAction* action = parts_.commands->addPlain(language, name, [this, code = code] {
      QSettings().setValue(QStringLiteral("language"), code);
      parts_.messages->showNote(tr("The window speaks the chosen language from the next start on. Close EchoWeave and open it again."),
                                QStringLiteral("language"));
    });
    action->setCheckable(true);
    action->setChecked(code == chosen);
    languages->addAction(action);
  }
}

void Appearance::stepTextSize(int steps) {
  const auto at = std::find(kTextSizes_percent.begin(), kTextSizes_percent.end(), textSize_percent()) - kTextSizes_percent.begin();
  const auto last = static_cast<std::ptrdiff_t>(kTextSizes_percent.size()) - 1;
  chooseTextSize(kTextSizes_percent[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(at + steps, 0, last))]);
}

void Appearance::chooseTextSize(int percent) {
  setTextSize(percent);
  QSettings().setValue(kTextSizeSetting, textSize_percent());
  for (QAction* action : sizes_->actions()) action->setChecked(action->data().toInt() == textSize_percent());
  applyTheme(currentTheme());
  parts_.restyle();
  parts_.workspaces->showPanels();
  parts_.refresh();
  parts_.window.centralWidget()->layout()->activate();
  parts_.columns->placeMessages();
}

void Appearance::chooseTheme(const QString& choice) {
  applyTheme(themeCalled(choice));
  QSettings().setValue(kThemeSetting, choice);
  parts_.restyle();
}

void Appearance::restyle() {
  const QString choice = QSettings().value(kThemeSetting).toString();
  (choice == QLatin1String("system") ? system_ : currentTheme().dark ? dark_ : light_)->setChecked(true);
  parts_.topBar->refreshIcons();
  parts_.caseInfo->refreshIcons();
  parts_.console->refreshIcons();
  parts_.measurePage->refreshIcons();
  parts_.scanView->refreshIcons();
  parts_.imageGrid->refreshIcons();
  parts_.replayBar->refreshIcons();
  parts_.cineBar->refreshIcons();
  parts_.messages->refreshIcons();
}

}  // namespace ew::ui
