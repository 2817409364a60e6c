#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "ew/core/message.h"
#include "ew/library/placing.h"
#include "ew/tracking/alignment.h"
#include "ew/tracking/tracker_calibration.h"

namespace ew {

class Skin;

}

namespace ew::ui {

class Session;

/// A place of the mannequin and where the tracker saw the probe's face touch it.
struct TrackerTouch {
  std::string landmark;
  glm::dvec3 at_mm{0.0};       ///< world
  glm::dvec3 at_tracker{0.0};  ///< mm
  double spread_mm = 0.0;      ///< while it was held
};

/// What the touched places, and the traced surface, make of the tracker's frame.
struct TrackerAlignment {
  bool isFound = false;
  bool isTraced = false;
  std::vector<double> residuals_mm;  ///< of each touch
  std::string wrong;                 ///< landmark that does not fit to the others; empty: none
  double rms_mm = 0.0, expected_mm = 0.0;
  Message sentence;  ///< in words, with what to do
};

/// The mannequin that lies there, what was touched and traced of it with each tracker, and the alignment that follows. All of it on the
/// window's thread.
class MannequinTouches {
 public:
  /// What the window lends.
  struct Window {
    std::function<std::string()> mannequin;                 ///< as Case::mannequin
    std::function<std::vector<glm::vec3>()> bodyPoints_mm;  ///< corners of its surface, world
  };
  /// Keeps an alignment that was found; `quality` says everything but when it was made.
  using Keep = std::function<void(const std::string& id, const Transform<frame::World, frame::Tracker>& trackerToWorld,
                                  const CalibrationQuality& quality)>;

  MannequinTouches(const Session& session, Keep keep);

  void setWindow(Window window) { window_ = std::move(window); }

  [[nodiscard]] std::string name() const;  ///< as Case::mannequin
  [[nodiscard]] std::vector<BodyLandmark> landmarks() const;
  [[nodiscard]] std::vector<glm::dvec3> landmarkPlaces() const;  ///< world
  [[nodiscard]] std::vector<glm::vec3> bodyPoints() const;
  [[nodiscard]] std::shared_ptr<const Skin> skin() const;
  /// How far from the skin a point is; below it less than 0.
  [[nodiscard]] static double gap_mm(const Skin& skin, const glm::dvec3& at_world);

  [[nodiscard]] const std::vector<TrackerTouch>& touches(const std::string& id) { return aligning_[id].touches; }
  void setTouches(const std::string& id, std::vector<TrackerTouch> touches);
  [[nodiscard]] const TrackerAlignment& alignment(const std::string& id) { return aligning_[id].found; }
  /// What was touched and found with this tracker holds no longer.
  void forget(const std::string& id) { aligning_.erase(id); }
  void beginTracing() { traced_.clear(); }
  void trace(const glm::dvec3& at_tracker);
  [[nodiscard]] int tracedCount() const { return static_cast<int>(traced_.size()); }
  void endTracing(const std::string& id) { findAlignment(id, traced_); }

 private:
  struct Aligning {
    std::vector<TrackerTouch> touches;
    TrackerAlignment found;
  };
  void findAlignment(const std::string& id, const std::vector<glm::dvec3>& traced);

  const Session& session_;
  Keep keep_;
  Window window_;
  std::map<std::string, Aligning> aligning_;  ///< by tracker
  std::vector<glm::dvec3> traced_;
};

}  // namespace ew::ui
