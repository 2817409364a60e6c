#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "ew/tracking/tool_reading.h"
#include "trackers/wizard/tracker_step.h"

class QLabel;
class QPushButton;

namespace ew::ui {

class Trackers;

/// Where the transducer's face lies on the tool: the tip is turned about a fixed point, the face slid flat on a table, and the probe pushed
/// along its long side.
class TrackerFaceStep final : public TrackerStep {
  Q_OBJECT

 public:
  TrackerFaceStep(Trackers& trackers, std::string tracker, QWidget* parent = nullptr);
  [[nodiscard]] bool isDone() const override;
  [[nodiscard]] bool isNeeded() const override;
  [[nodiscard]] bool mayGoOn() const override { return true; }
  void enter() override;
  void leave() override;
  void poll() override;

 private:
  static constexpr std::size_t kMotions = 3;
  struct Motion {
    QPushButton* record = nullptr;
    QLabel* answer = nullptr;
    bool isKnown = false;
  };
  void addMotion(std::size_t n, const QString& what);
  void setRecording(std::size_t n, bool recording);
  void judge(std::size_t n);
  void finish();

  Trackers& trackers_;
  std::string tracker_;
  std::array<Motion, kMotions> motions_;
  std::optional<std::size_t> recording_;
  std::vector<ToolReading> readings_;
  double latest_s_ = 0.0;
  glm::dvec3 tip_{0.0}, axial_{0.0}, lateral_{0.0};
  double rms_mm_ = 0.0, spread_mm_ = 0.0;
  int tipReadings_ = 0;
  QLabel* verdict_ = nullptr;
};

}  // namespace ew::ui
