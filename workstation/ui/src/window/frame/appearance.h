#pragma once

#include <QString>

#include "window/frame/feature.h"

class QAction;
class QActionGroup;
class QMenu;

namespace ew::ui {

/// Theme, size of words and language.
class Appearance final : public Feature {
  Q_OBJECT

 public:
  using Feature::Feature;

  /// As it was left, dark on the first start; before the first widget is made.
  static void begin();
  void addMenus(QMenu& view);
  void restyle() override;

  /// @param choice "dark", "light" or "system"
  void chooseTheme(const QString& choice);

 private:
  void addThemeMenu(QMenu& theme);
  void addTextSizeMenu(QMenu& sizes);
  void addLanguageMenu(QMenu& language);
  void chooseTextSize(int percent);
  void stepTextSize(int steps);

  QAction* system_ = nullptr;
  QAction* dark_ = nullptr;
  QAction* light_ = nullptr;
  QActionGroup* sizes_ = nullptr;
};

}  // namespace ew::ui
