#pragma once

#include <filesystem>
#include <vector>

#include "ew/scanning/preset.h"
#include "window/frame/feature.h"

class QMenu;

namespace ew::ui {

/// Presets of the program, of the case and of the user.
class Presets final : public Feature {
  Q_OBJECT

 public:
  using Feature::Feature;

  void readData(const std::filesystem::path& resources);
  void addMenu(QMenu& presets);
  /// Of the program.
  [[nodiscard]] const std::vector<Preset>& all() const { return all_; }
  /// The scan begins as the case on show asks for: with its preset, or neutral.
  void beginScanOfCase();

 private:
  void fill(QMenu& menu);
  void take(const Preset& preset);
  [[nodiscard]] std::vector<Preset> ofCase() const;  ///< that the case on show offers, the one it starts with first
  void saveOwn();
  void import();

  std::vector<Preset> all_;
};

}  // namespace ew::ui
