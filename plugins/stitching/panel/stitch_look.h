#pragma once

#include <QObject>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "ew/core/frames.h"
#include "ew/core/volume.h"
#include "ew/registration/landmarks.h"
#include "ew/stitching/project.h"
#include "logic/slices.h"
#include "panel/stitch_results.h"

namespace ew::stitching {

class ProjectDocument;
class ProjectInputs;

/// What is looked at, in all views alike: the pair, volume and landmark that are chosen, the transform the pair is seen with, the planes
/// and the two places that cross-hairs mark. On the window's thread.
class StitchLook final : public QObject {
  Q_OBJECT

 public:
  StitchLook(ProjectDocument& document, const ProjectInputs& inputs, const StitchResults& results);

  void followProject();  ///< what is chosen is there, and landmarks are those of the project
  void followResults();  ///< the pair as it was found comes into view
  void forget();         ///< another project

  [[nodiscard]] const std::optional<VolumePair>& pair() const { return pair_; }
  void choosePair(std::size_t a, std::size_t b);
  [[nodiscard]] std::optional<std::size_t> chosenVolume() const { return chosenVolume_; }
  void chooseVolume(std::size_t volume);
  [[nodiscard]] int chosenLandmark() const { return chosenLandmark_; }
  void chooseLandmark(int landmark);

  // Landmarks of the pair.
  [[nodiscard]] std::vector<registration::LandmarkPair> landmarks() const;
  [[nodiscard]] const std::optional<registration::LandmarkResult>& landmarkResult() const { return landmarkResult_; }
  [[nodiscard]] std::optional<glm::dvec3> pickedFixed() const { return pickedFixed_; }
  [[nodiscard]] std::optional<glm::dvec3> pickedMoving() const { return pickedMoving_; }
  void pick(bool moving, const glm::dvec3& p_mm);  ///< the second of two makes a landmark
  void dropPick();

  /// Which transform the pair is seen with.
  enum class Stage { start, rigid, elastic };
  [[nodiscard]] Stage stage() const { return stage_; }
  void setStage(Stage stage);
  void expectRigid() { stage_ = Stage::rigid; }  ///< before an edit of the pose, which is seen so
  [[nodiscard]] bool hasElastic() const;
  /// Fixed to moving as it is at present: nudged, found, by landmarks, or from the places.
  [[nodiscard]] Transform<frame::Moving, frame::Fixed> transform() const;
  [[nodiscard]] Transform<frame::Moving, frame::Fixed> startTransform() const;
  /// From the fixed frame to each side's own grid, for a stage.
  [[nodiscard]] Mapping fixedMapping(Stage stage) const;
  [[nodiscard]] Mapping movingMapping(Stage stage) const;
  [[nodiscard]] QuickAgreement agreement() const;  ///< at the present transform

  // The two places that cross-hairs mark: linked, or each for itself.
  [[nodiscard]] const Plane& plane() const { return plane_; }       ///< fixed frame
  [[nodiscard]] const glm::dvec3& cross() const { return cross_; }  ///< fixed frame
  [[nodiscard]] Plane movingPlane() const;                          ///< the moving volume's own frame
  [[nodiscard]] glm::dvec3 movingCross() const;                     ///< the moving volume's own frame
  void setPlane(const Plane& plane);
  void setCross(const glm::dvec3& p_mm);        ///< the plane follows when the place lies off it
  void setMovingPlane(const Plane& plane);      ///< linked: moves the fixed one
  void setMovingCross(const glm::dvec3& p_mm);  ///< linked: moves the fixed one
  [[nodiscard]] bool isLinked() const { return linked_; }
  void setLinked(bool linked);
  void setCut(Cut cut);
  void setViewSide(int px);  ///< the shorter side of a view: what was seen stays seen when views grow
  void fit();                ///< the whole of both volumes in view, cross-hairs in the middle of what both cover

 Q_SIGNALS:
  void changed();        ///< plane, cross-hairs, stage
  void choiceChanged();  ///< pair, volume, landmark, places that were picked, whether cross-hairs are linked
  void pairChosen();     ///< after choiceChanged()
  void landmarkPicked(const glm::dvec3& fixed_mm, const glm::dvec3& moving_mm);  ///< of the pair; the project does not have it yet
  void nextPairAsked(int step);

 private:
  [[nodiscard]] const StitchProject& project() const;
  void afterChoice();

  ProjectDocument& document_;
  const ProjectInputs& inputs_;
  const StitchResults& results_;

  std::optional<VolumePair> pair_;
  std::optional<std::size_t> chosenVolume_;
  int chosenLandmark_ = -1;
  std::optional<registration::LandmarkResult> landmarkResult_;
  std::optional<glm::dvec3> pickedFixed_, pickedMoving_;
  Stage stage_ = Stage::rigid;
  Plane plane_;
  glm::dvec3 cross_{0.0};
  Plane movingPlane_;
  glm::dvec3 movingCross_{0.0};
  bool linked_ = true;
  int viewSide_px_ = 330;
  struct AgreementOf {
    std::shared_ptr<const Volume> fixed, moving;
    Transform<frame::Moving, frame::Fixed> transform;
    QuickAgreement found;
  };
  mutable AgreementOf agreementOf_;
};

}  // namespace ew::stitching
