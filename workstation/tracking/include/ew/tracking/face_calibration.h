#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "ew/core/frames.h"
#include "ew/core/message.h"
#include "ew/core/result.h"
#include "ew/tracking/tool_reading.h"

namespace ew {

struct PivotOptions {
  double noise_mm = 1.0;     ///< of a reading's position, for what counts as slipped
  double widest_rad = 0.35;  ///< the tool has to be tipped at least so far both ways (standard deviation times two): 20 degrees
  bool operator==(const PivotOptions&) const = default;
};

/// The tip of a tool that was turned about a fixed point.
struct Pivot {
  bool isKnown = false;
  Message sentence;                  ///< what was found, or which motion was missing
  glm::dvec3 tip_tool_mm{0.0};       ///< in the tool's frame
  glm::dvec3 point_tracker_mm{0.0};  ///< the fixed point
  double rms_mm = 0.0;               ///< distance of the tip from the point, over readings that took part
  double spread_mm = 0.0;            ///< standard deviation of the tip, worst direction
  int readings = 0;                  ///< that took part
  int slipped = 0;                   ///< that did not
  double tipped_rad = 0.0;           ///< how far the tool was tipped in the narrower of two directions
};

/// Algebraic solution of R_i tip + t_i = point, then reweighted so that moments when the tip slipped do not count (Tukey's loss).
/// Source: Yaniv, Proc. SPIE 9415, 2015 (algebraic one step method). Readings that are not live are passed over.
/// @error noValidPose: fewer than 20 live readings
[[nodiscard]] Result<Pivot> pivotOf(std::span<const ToolReading> readings, const PivotOptions& options = {});

/// The direction out of a transducer face that was laid flat on a table and slid about on it, turned at least a quarter meanwhile.
struct FlatFace {
  bool isKnown = false;
  Message sentence;
  glm::dvec3 axial_tool{0.0, 1.0, 0.0};  ///< out of the face, into the table; unit, in the tool's frame
  double spread_rad = 0.0;               ///< standard deviation of that direction
  double rms_rad = 0.0;                  ///< how far single readings lean from it
  double turned_rad = 0.0;               ///< how far the tool was turned on the table
  int readings = 0;
};

/// The one direction of the tool that keeps its direction in the tracker's frame while the tool turns on a table.
/// @param towardsTip_tool roughly out of the face: the tip of a pivot, or from the body's file; decides between the two senses
/// @error noValidPose: fewer than 20 live readings
[[nodiscard]] Result<FlatFace> flatFaceOf(std::span<const ToolReading> readings, const glm::dvec3& towardsTip_tool);

/// The direction in which the probe was slid straight along its lateral axis, towards its marker, on a table: unit, in the tool's frame.
/// @error noValidPose: fewer than 20 live readings; badField: it went less than 40 mm, not straight, or turned on the way
[[nodiscard]] Result<glm::dvec3> lateralOf(std::span<const ToolReading> readings);

struct Face {
  Transform<frame::Tool, frame::Probe> probeToTool;
};

/// Puts the three together. @error badField: lateral and axial directions are less than 60 degrees apart (sentence says what to repeat)
[[nodiscard]] Result<Face> faceFrom(const glm::dvec3& tip_tool_mm, const glm::dvec3& axial_tool, const glm::dvec3& lateral_tool);

}  // namespace ew
