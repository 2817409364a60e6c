#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <string>

#include "ew/core/frames.h"
#include "ew/registration/elastic.h"
#include "ew/stitching/project.h"

namespace ew::stitching {

class Notices;
class ProjectDocument;
class StitchLook;
class StitchResults;
class StitchRuns;

/// What a person says about how volumes lie, each a step of the document: where a volume is placed, and of the pair that is looked at the
/// landmarks, the pose, the decision, and how it is matched and deformed again. On the window's thread.
class AlignmentEdits final : public QObject {
  Q_OBJECT

 public:
  AlignmentEdits(Notices& notices, ProjectDocument& document, const StitchResults& results, StitchLook& look, StitchRuns& runs);

  /// Puts a volume where `shown` says, in the frame of StitchResults::toWorld.
  void setPlace(std::size_t volume, const Transform<frame::World, frame::View>& shown, const QString& what, const std::string& mergeKey);
  void setPlacement(std::size_t volume, Placement placement);

  // Landmarks of the pair.
  void addLandmark(const glm::dvec3& fixed_mm, const glm::dvec3& moving_mm);
  void removeLandmark(int landmark);
  void renameLandmark(int landmark, const QString& name);
  void useLandmarks();  ///< the pair's method becomes landmarks, and the pair is matched again

  // Decisions and nudges.
  void setDecision(Decision decision);
  void nudge(const glm::dvec3& shift_mm, const glm::dvec3& rotation_deg);  ///< along and about the plane's right, down, normal
  void setTransform(const Transform<frame::Moving, frame::Fixed>& fixedToMoving, const QString& what, const std::string& mergeKey);

  // Once more.
  void pinStart();  ///< what is seen now becomes the start of the next refinement; a step with it
  void redoPair(PairMethod method, std::optional<double> maxRotation_deg);
  void setEffort(registration::ElasticEffort effort);  ///< of deforming all pairs that have none of their own
  void setPairEffort(std::optional<registration::ElasticEffort> effort);
  void warpAgain();  ///< runs the elastic step: what did not change is kept

 Q_SIGNALS:
  void refused();  ///< what was typed is not taken: what shows it shows it as it is

 private:
  [[nodiscard]] const StitchProject& project() const;
  void editPair(const std::function<void(ProjectPair&)>& change, const QString& what, const std::string& mergeKey = {});
  [[nodiscard]] QString nameOfPair() const;

  Notices& notices_;
  ProjectDocument& document_;
  const StitchResults& results_;
  StitchLook& look_;
  StitchRuns& runs_;
};

}  // namespace ew::stitching
