#pragma once

#include <QDialog>
#include <vector>

#include "ew/door/door.h"

namespace ew::ui {

/// Every plugin that was found, whether it runs, and if not why and what to do.
class PluginsDialog final : public QDialog {
  Q_OBJECT

 public:
  PluginsDialog(const std::vector<door::PluginStatus>& plugins, QWidget* parent);
};

}  // namespace ew::ui
