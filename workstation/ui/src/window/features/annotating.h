#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "ew/measurement/measurement_list.h"
#include "window/frame/feature.h"

class QAction;
class QMenu;

namespace ew::ui {

/// Texts, arrows and the body mark on the scan.
class Annotating final : public Feature {
  Q_OBJECT

 public:
  using Feature::Feature;

  /// Word lists and body marks of the program.
  void readData(const std::filesystem::path& resources);
  void addMenu(QMenu& annotate);
  void addBodyMarkMenu(QMenu& mark);
  void connectParts() override;
  void refresh() override;  ///< whose words and body marks are offered

 private:
  void fillWordMenu(QMenu& menu);
  void putCalipersDown();

  measurement::Measurements measured_;  ///< as they were when they changed last
  std::optional<std::uint64_t> measuredImage_;
  QAction* text_ = nullptr;
  QAction* arrow_ = nullptr;
  QAction* bodyMark_ = nullptr;
};

}  // namespace ew::ui
