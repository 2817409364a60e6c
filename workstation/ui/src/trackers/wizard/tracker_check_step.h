#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "trackers/control/tracker_still.h"
#include "trackers/wizard/tracker_step.h"

class QLabel;

namespace ew {
class FigureLabel;
}

namespace ew::ui {

class TrackerBodyDrawing;
class Trackers;

/// The proof: the probe's face is laid on the skin in three places, and the program says how far from it it believes to be.
class TrackerCheckStep final : public TrackerStep {
  Q_OBJECT

 public:
  static constexpr double kGood_mm = 3.0;
  static constexpr std::size_t kPlaces = 3;

  TrackerCheckStep(Trackers& trackers, std::string tracker, QWidget* parent = nullptr);
  [[nodiscard]] bool isDone() const override;
  [[nodiscard]] bool mayGoOn() const override { return true; }
  void enter() override;
  void poll() override;
  [[nodiscard]] std::size_t places() const { return checked_.size(); }

 private:
  struct Checked {
    glm::dvec3 at_mm;
    double gap_mm;
  };
  void take(const glm::dvec3& at_world);
  void showAll();

  Trackers& trackers_;
  std::string tracker_;
  TrackerStill still_;
  std::vector<Checked> checked_;
  TrackerBodyDrawing* body_ = nullptr;
  FigureLabel* gap_ = nullptr;
  QLabel *hand_ = nullptr, *verdict_ = nullptr;
};

}  // namespace ew::ui
