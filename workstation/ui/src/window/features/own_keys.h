#pragma once

#include <QPointer>

#include "window/frame/feature.h"

namespace ew::ui {

class KeysDialog;

/// The user's keys and the control surface: what they act on, where they are kept, and the editor.
class OwnKeys final : public Feature {
  Q_OBJECT

 public:
  using Feature::Feature;
  ~OwnKeys() override;

  void connectParts() override;
  void edit();

 private:
  void connectSurface();
  void read();
  void keep();  ///< in the user's file

  QPointer<KeysDialog> dialog_;
  bool isBroken_ = false;  ///< the user's file cannot be read
};

}  // namespace ew::ui
