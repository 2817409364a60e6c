#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ew/library/placing.h"
#include "trackers/control/tracker_still.h"
#include "trackers/wizard/tracker_step.h"

class QCheckBox;
class QLabel;
class QListWidget;
class QPushButton;

namespace ew::ui {

class TrackerBodyDrawing;
class Trackers;

/// The tracker is aligned with the mannequin: places that it is known by are touched with the middle of the probe's face, at least three;
/// then, if wished, its surface is traced.
class TrackerAlignStep final : public TrackerStep {
  Q_OBJECT

 public:
  TrackerAlignStep(Trackers& trackers, std::string tracker, QWidget* parent = nullptr);
  [[nodiscard]] bool isDone() const override;
  void enter() override;
  void leave() override;
  void poll() override;

  /// Takes the place that is next, where the probe's face is now.
  void take();
  [[nodiscard]] const std::string& next() const { return next_; }

 private:
  void chooseNext(const std::string& id);
  void chooseFirstLeft();
  void keep(const glm::dvec3& at_tracker, double spread_mm);
  void removeChosen();
  void setTracing(bool tracing);
  void pollTracing();
  void pollTouching();
  void showAll();
  [[nodiscard]] const BodyLandmark* find(const std::string& id) const;

  Trackers& trackers_;
  std::string tracker_;
  std::vector<BodyLandmark> landmarks_;
  std::string next_;
  TrackerStill still_;
  bool isTracing_ = false;
  TrackerBodyDrawing* body_ = nullptr;
  QLabel *nextName_ = nullptr, *hand_ = nullptr, *result_ = nullptr;
  QListWidget* touched_ = nullptr;
  QCheckBox* byItself_ = nullptr;
  QPushButton *take_ = nullptr, *remove_ = nullptr, *trace_ = nullptr;
};

}  // namespace ew::ui
