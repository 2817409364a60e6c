#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "ew/core/result.h"
#include "ew/labelling/between.h"
#include "ew/labelling/grow.h"
#include "ew/labelling/label_edits.h"
#include "ew/sdk/scan.h"

namespace ew::case_authoring {

/// What a stroke over the image does.
enum class PaintTool { paint, erase, trace, grow };
struct PaintSettings {
  PaintTool tool = PaintTool::paint;
  double radius_mm = 3.0;
  bool inPlane = false;        ///< a disc in the image plane; else a ball
  bool onlyUnlabelled = true;  ///< other structures are not painted over
  double thickness_mm = 2.0;   ///< of discs and traced outlines, about the image plane
  labelling::GrowOptions grow = {};
  bool operator==(const PaintSettings& other) const {
    return tool == other.tool && radius_mm == other.radius_mm && inPlane == other.inPlane && onlyUnlabelled == other.onlyUnlabelled &&
           thickness_mm == other.thickness_mm;
  }
};

/// The labels of the open case while somebody paints: in the frame of the case's file, so that moving the volume in the body changes
/// nothing.
class Painting {
 public:
  /// @param fileToWorld where the case places its file now
  /// @error badUsage (nothing is scanned, or its voxels stay in their file)
  [[nodiscard]] static Result<std::unique_ptr<Painting>> begin(const sdk::Scanned& scanned,
                                                               const Transform<frame::World, frame::File>& fileToWorld);
  /// Goes on with labels that were kept. @error as begin
  [[nodiscard]] static Result<std::unique_ptr<Painting>> goOn(Volume labels, const sdk::Scanned& scanned,
                                                              const Transform<frame::World, frame::File>& fileToWorld);

  [[nodiscard]] labelling::LabelEdits& edits() { return edits_; }
  [[nodiscard]] const Volume& labels() const { return edits_.labels(); }  ///< on a grid in the frame of the file
  [[nodiscard]] bool isChanged() const { return edits_.steps() > 0 || wasKept_; }
  /// The labels where `fileToWorld` puts them.
  [[nodiscard]] Volume inWorld(const Transform<frame::World, frame::File>& fileToWorld) const;

  // A stroke of the pointer over the image, whose plane lies in the file as `planeToFile` says; `what` names the step of undo.
  void strokeBegun(const PaintSettings& settings, int label, const std::string& what,
                   const Transform<frame::File, frame::Probe>& planeToFile, const glm::dvec2& at_mm);
  void strokeMoved(const glm::dvec2& at_mm);
  void strokeEnded();
  [[nodiscard]] bool isDrawing() const { return isDrawing_; }
  /// The line of the stroke so far, in the image plane.
  [[nodiscard]] const std::vector<glm::dvec2>& stroke() const { return stroke_; }

  /// Outlines that were traced and filled since the label was chosen, each in its own plane: between them is filled at will.
  [[nodiscard]] const std::vector<labelling::ContourTrace>& traced() const { return traced_; }
  void forgetTraced() { traced_.clear(); }
  /// @error as labelling::fillBetween
  [[nodiscard]] Result<void> fillBetween(int label, bool onlyUnlabelled, const std::string& what, Progress& progress);
  /// From a point of the file. Works on a copy, so that it may run beside the window: `take` puts the outcome in place.
  struct Growth {
    Volume labels;
    labelling::GrowResult result;
  };
  [[nodiscard]] std::function<Result<Growth>(Progress&)> growing(const glm::dvec3& seed_mm, const labelling::GrowOptions& options,
                                                                 int label, bool onlyUnlabelled) const;
  void take(Growth growth, const std::string& what);
  [[nodiscard]] Result<void> keepLargest(int label, const std::string& what, Progress& progress);
  [[nodiscard]] Result<void> smooth(int label, const std::string& what, Progress& progress);

 private:
  Painting(Volume labels, std::shared_ptr<const Volume> echo, Grid echoGrid, bool wasKept)
      : edits_(std::move(labels)), echo_(std::move(echo)), echoGrid_(echoGrid), wasKept_(wasKept) {}
  void dab(const glm::dvec2& from_mm, const glm::dvec2& to_mm);

  labelling::LabelEdits edits_;
  std::shared_ptr<const Volume> echo_;
  Grid echoGrid_;  ///< where the echoes lie in the frame of the file
  bool wasKept_ = false;
  bool isDrawing_ = false;
  PaintSettings drawn_;
  int label_ = 0;
  Transform<frame::File, frame::Probe> planeToFile_;
  std::vector<glm::dvec2> stroke_;
  std::vector<labelling::ContourTrace> traced_;
};

}  // namespace ew::case_authoring
