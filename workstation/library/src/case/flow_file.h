#pragma once

#include <nlohmann/json_fwd.hpp>

#include "ew/core/json_fields.h"
#include "ew/imaging/flow_field.h"

namespace ew {

/// How a file holds a flow: numbers to the last bit, names of streams where they have one.
[[nodiscard]] nlohmann::ordered_json fileJsonOf(const FlowField& flow);

/// The flow that such an object holds; nothing usable after a problem. Whoever wrote it is not trusted: every number has its range, and the
/// memory that a FlowSampler takes for it is bounded.
[[nodiscard]] FlowField flowIn(const JsonFields& object);

/// Rhythms of a body as files of cases hold them: keptJsonOf.
[[nodiscard]] BodyRhythms rhythmsIn(const JsonFields& object);

/// Without the streams that pass the box farther than `margin_mm` from it.
/// @param box in the frame of the flow
[[nodiscard]] FlowField flowWithin(const FlowField& flow, const Bounds& box, double margin_mm);

}  // namespace ew
