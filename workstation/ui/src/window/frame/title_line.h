#pragma once

#include "window/frame/feature.h"

namespace ew::ui {

/// What is open, in the bar at the top, in the window's title and where the case is told of.
class TitleLine final : public Feature {
  Q_OBJECT

 public:
  using Feature::Feature;

  void connectParts() override;
  void refresh() override;
};

}  // namespace ew::ui
