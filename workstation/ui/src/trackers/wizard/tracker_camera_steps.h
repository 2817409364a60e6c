#pragma once

#include <deque>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>

#include "ew/trackers/camera_calibration.h"
#include "ew/trackers/camera_device.h"
#include "ew/widgets/worker.h"
#include "trackers/wizard/tracker_step.h"

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace ew::ui {

class TrackerCameraView;
class Trackers;

/// The image of a camera with what was found in it, in the words and colours of the window.
void showCameraView(TrackerCameraView& image, const CameraView& view);

/// Which camera, or which film of one; its image, and whether light and sharpness will do.
class TrackerCameraStep final : public TrackerStep {
  Q_OBJECT

 public:
  TrackerCameraStep(Trackers& trackers, std::string tracker, QWidget* parent = nullptr);
  [[nodiscard]] bool isDone() const override { return seen_; }
  void enter() override;
  void poll() override;

 private:
  void fillCameras();
  void choose(const QString& device);
  void chooseFilm();
  void chooseSize(const QSize& size);

  Trackers& trackers_;
  std::string tracker_;
  bool seen_ = false;
  QComboBox *cameras_ = nullptr, *sizes_ = nullptr;
  TrackerCameraView* image_ = nullptr;
  QLabel* verdict_ = nullptr;
};

/// The lens: images of the chess board are kept by themselves when they show something new, and the camera's own measures are found from
/// them.
class TrackerLensStep final : public TrackerStep {
  Q_OBJECT

 public:
  TrackerLensStep(Trackers& trackers, std::string tracker, QWidget* parent = nullptr);
  ~TrackerLensStep() override;
  [[nodiscard]] bool isDone() const override;
  [[nodiscard]] bool mayGoOn() const override { return true; }  ///< an assumed lens will do for a look
  void enter() override;
  void poll() override;
  [[nodiscard]] int views() const { return coverage_.views; }

 private:
  struct Gathering;
  void begin();
  void look();
  void take(const CalibrationCollector::Look& look, const CalibrationCoverage& coverage);
  void solve();
  void showAll();

  Trackers& trackers_;
  std::string tracker_;
  std::shared_ptr<Gathering> gathering_;  ///< null: not begun
  CalibrationCoverage coverage_;
  bool isLooking_ = false, isSolving_ = false;
  TrackerCameraView* image_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QLabel *next_ = nullptr, *verdict_ = nullptr;
  QPushButton *solve_ = nullptr, *again_ = nullptr;
  Worker worker_;  ///< last: it ends first
};

/// The folded body in the hand: is it seen, how far away, how still.
class TrackerHoldStep final : public TrackerStep {
  Q_OBJECT

 public:
  TrackerHoldStep(Trackers& trackers, std::string tracker, QWidget* parent = nullptr);
  [[nodiscard]] bool isDone() const override;
  [[nodiscard]] bool mayGoOn() const override { return true; }
  void enter() override;
  void poll() override;

 private:
  Trackers& trackers_;
  std::string tracker_;
  std::deque<glm::dvec3> recent_;  ///< places of the body, the last second of them
  std::uint64_t lastImage_ = 0;
  int seenImages_ = 0;
  TrackerCameraView* image_ = nullptr;
  QLabel *verdict_ = nullptr, *figures_ = nullptr;
};

}  // namespace ew::ui
