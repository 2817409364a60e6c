#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ew/measurement/measurement_list.h"

namespace ew::measurement {

/// The caliper with a handle put elsewhere, as it is dragged: the axes of an ellipse stay square to each other in one middle, the end of
/// one that is moved takes the other end along; of an outline with many points the neighbours follow, and what was smooth stays smooth.
[[nodiscard]] Caliper withHandleAt(const Caliper& caliper, Handle handle, glm::dvec2 to);

/// The tools that draw in one image, in the order in which they are offered.
[[nodiscard]] const std::vector<CaliperKind>& drawnKinds();
/// Those that draw in the strip of an M-mode.
[[nodiscard]] const std::vector<CaliperKind>& stripKinds();
/// Whether a person says when it has all of its points.
[[nodiscard]] bool endsWhenAsked(CaliperKind kind);

/// How a person draws calipers with a pointer or keys: the tool at hand, the points set so far, what is being dragged, what is selected,
/// and the list that everything goes to. No window, no image: points are mm of the image's plane, or s and mm of a strip. Not for
/// several threads.
class CaliperDrawing {
 public:
  explicit CaliperDrawing(int image = 0) : image_(image) {}
  /// One in which something is drawn already; no step of undo leads back behind it.
  CaliperDrawing(int image, Measurements drawn) : image_(image), list_(std::move(drawn)) {}

  /// By how much differences of x and y are multiplied before they are distances to the pointer: of a strip, mm for each s.
  void setScale(glm::dvec2 scale) { scale_ = scale; }
  /// Heart beats between the cursors of those that are drawn from now on.
  void setCycles(int cycles) { cycles_ = cycles; }
  [[nodiscard]] int cycles() const { return cycles_; }
  /// Of a heart rate that is there already, as a step. False when there is no such one, or nothing changes.
  bool setCyclesOf(int number, int cycles);

  [[nodiscard]] const Measurements& shown() const { return list_.now(); }
  [[nodiscard]] bool isEmpty() const { return shown().all.empty() && points_.empty(); }

  /// What a tool is taken for: an item of a package, and its side. Empty: for none.
  struct Purpose {
    std::string item;
    std::string side;
    bool operator==(const Purpose&) const = default;
  };
  /// Takes a tool into the hand; points that were set with the one before go. What is drawn with it is measured for its purpose.
  void take(CaliperKind kind, Purpose purpose = {});
  [[nodiscard]] std::optional<CaliperKind> tool() const { return tool_; }
  [[nodiscard]] const Purpose& purpose() const { return purpose_; }

  enum class Press {
    nothing,   ///< no tool, and no handle there: what was selected no longer is
    handle,    ///< taken, to be dragged
    point,     ///< set
    finished,  ///< set, and with it the caliper is whole
  };
  /// The pointer goes down, or Enter is pressed. With a tool that has set points already, handles of others are in nobody's way.
  Press press(glm::dvec2 at, double reach_mm);
  /// The pointer moves, pressed or not.
  void moveTo(glm::dvec2 at, double reach_mm);
  /// The pointer comes up. A drag from the first end to the second sets both, and one along an outline draws it.
  void release(glm::dvec2 at, double reach_mm);
  [[nodiscard]] bool isDragging() const { return dragged_.has_value(); }
  [[nodiscard]] bool isPressed() const { return pressedAt_.has_value(); }
  /// The pointer comes up where no point can be: what was dragged stays where it was last.
  void letGo();
  [[nodiscard]] bool isNearHandle(glm::dvec2 at, double reach_mm) const;
  /// Of a caliper of two points one of which is dragged, the other.
  [[nodiscard]] std::optional<glm::dvec2> fixedEnd() const;

  /// Ends a caliper that may have any number of points. False when it has too few.
  bool finish();
  /// The last point goes; without one what is selected, or else the last caliper. False when there was nothing.
  bool takeBack();
  /// The points go; without any the tool; without one the selection. False when there was nothing.
  bool cancel();
  bool remove(int number);
  bool clear();

  void select(int number);
  [[nodiscard]] int selected() const { return selected_; }  ///< 0: none

  /// Points that are set are no step of the list: undo takes them back first.
  [[nodiscard]] bool canUndo() const { return !points_.empty() || list_.canUndo(); }
  [[nodiscard]] bool canRedo() const { return points_.empty() && list_.canRedo(); }
  bool undo();
  bool redo();

  /// The caliper being drawn, with the pointer's place as its next point, when that makes one that can be measured or shown; with no tool
  /// or no point set: empty.
  [[nodiscard]] std::optional<Caliper> unfinished() const;
  [[nodiscard]] const std::vector<glm::dvec2>& points() const { return points_; }
  /// Replaces the points of an outline by the edge that they go around: a step of its own, so that undo gives back what was clicked.
  bool refine(int number, std::vector<glm::dvec2> outline);

 private:
  [[nodiscard]] Caliper of(CaliperKind kind, std::vector<glm::dvec2> points) const {
    return {kind, {{image_, std::move(points)}}, kind == CaliperKind::heartRate ? cycles_ : 1};
  }
  [[nodiscard]] double apart(glm::dvec2 a, glm::dvec2 b) const { return glm::length(scale_ * (a - b)); }
  Press set(glm::dvec2 at, double reach_mm);
  void add(std::vector<glm::dvec2> points);

  int image_;
  glm::dvec2 scale_{1.0};
  int cycles_ = 1;
  MeasurementList list_;
  std::optional<CaliperKind> tool_;
  Purpose purpose_;  ///< of the tool
  std::vector<glm::dvec2> points_;
  std::optional<glm::dvec2> pointer_;
  std::optional<glm::dvec2> pressedAt_;  ///< where a press that goes on has set a point
  bool isDrawn_ = false;                 ///< the press that goes on draws an outline
  struct Dragged {
    int number = 0;
    Handle handle;
    Caliper before;
    bool hasMoved = false;
  };
  std::optional<Dragged> dragged_;
  int selected_ = 0;
};

}  // namespace ew::measurement
