#pragma once

#include "ew/core/json_fields.h"
#include "ew/trackers/paper_body.h"

namespace ew {

/// Refuses what cannot be printed, folded or seen: markers beyond the edge of their panel or without white around them, an id twice, edges
/// of a seam that do not meet in the folded body, pieces of the net that overlap.
void checkPaper(const PaperBody& body, const JsonFields& document);

}  // namespace ew
