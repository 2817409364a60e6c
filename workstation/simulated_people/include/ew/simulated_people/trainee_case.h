#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ew/assessment/case_ground.h"
#include "ew/library/lesson.h"
#include "ew/scanning/recording.h"
#include "ew/simulated_people/skin_distance.h"
#include "ew/simulated_people/teaching_case.h"

namespace ew {

/// What a name in a lesson means: cases may call a plane and a structure the same.
enum class TargetKind {
  plane,
  place,       ///< a point or a structure
  measurement  ///< the plane it is taken in
};

/// From where a target is seen, and how far a sweep has to go from there.
struct TargetView {
  Hold hold;
  // Of a structure, along the skin's tangents at the hold; 0 of planes and points.
  double left_mm = 0.0, right_mm = 0.0;  ///< lateral extents, right_mm >= left_mm
  double front_mm = 0.0, back_mm = 0.0;  ///< elevational extents, back_mm >= front_mm
  double depth_mm = 0.0;                 ///< of its middle, from the face
};

/// What simulated trainees work on: a case, its lessons, and for every target of their steps the hold that shows it. Made once, read by
/// many; reading is safe from several threads.
class TraineeCase {
 public:
  /// Takes seconds: of many holds those are chosen that show each structure best.
  /// @param teaching with labels where steps name structures
  /// @error as lessonsOf, readRecording, readProbes; cancelled
  [[nodiscard]] static Result<TraineeCase> of(TeachingCase teaching, Progress& progress);

  [[nodiscard]] const TeachingCase& teaching() const { return teaching_; }
  [[nodiscard]] const std::vector<Lesson>& lessons() const { return lessons_; }
  [[nodiscard]] const std::shared_ptr<const CaseGround>& ground() const { return ground_; }
  /// Of the case, the first its default; at least one.
  [[nodiscard]] const std::vector<Probe>& probes() const { return probes_; }
  [[nodiscard]] const SkinDistance& skinDistance() const { return *distance_; }
  /// Where trainees begin.
  [[nodiscard]] const Hold& start() const { return start_; }
  /// Null: it is seen from nowhere on the skin, or the case has none of that name.
  [[nodiscard]] const TargetView* viewOf(TargetKind kind, const std::string& name) const;
  /// Length of an expert's recording, s; 0: there is none of that name.
  [[nodiscard]] double lengthOf_s(const std::string& recording) const;
  /// The settings of that image of the experts that was taken nearest to a pose; those of a console that nobody touched where there is
  /// none.
  [[nodiscard]] Knobs expertKnobsAt(const Pose& pose) const;

 private:
  struct Look {
    Pose pose;
    Knobs knobs;
  };
  Result<void> readExperts(Progress& progress);
  void findViews(Progress& progress);
  [[nodiscard]] std::optional<TargetView> found(TargetKind kind, const std::string& name) const;

  TeachingCase teaching_;
  std::vector<Lesson> lessons_;
  std::shared_ptr<const CaseGround> ground_;
  std::shared_ptr<const SkinDistance> distance_;
  std::vector<Probe> probes_;
  Hold start_;
  std::map<std::pair<TargetKind, std::string>, TargetView> views_;
  std::map<std::string, double> lengths_s_;
  std::vector<Look> looks_;
};

}  // namespace ew
