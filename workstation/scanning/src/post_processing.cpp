#include "ew/scanning/post_processing.h"

#include "ew/core/contract.h"

namespace ew {

ScanState processed(ScanState state, const PostProcessing& by) {
  Knobs& knobs = state.knobs;
  knobs.greyMap = by.greyMap.value_or(knobs.greyMap);
  knobs.dynamicRange_db = by.dynamicRange_db.value_or(knobs.dynamicRange_db);
  knobs.markerLeft = by.markerLeft.value_or(knobs.markerLeft);
  knobs.upsideDown = by.upsideDown.value_or(knobs.upsideDown);
  if (by.detail) {
    knobs.zoom = by.detail->zoom;
    state.pan = by.detail->pan;
  }
  return state;
}

bool differInProcessingOnly(const Knobs& a, const Knobs& b) {
  Knobs alike = a;
  alike.greyMap = b.greyMap;
  alike.dynamicRange_db = b.dynamicRange_db;
  alike.markerLeft = b.markerLeft;
  alike.upsideDown = b.upsideDown;
  alike.zoom = b.zoom;
  return alike == b;
}

PostProcessing withChange(PostProcessing before, const ScanState& from, const Knobs& to, const Pan& toPan) {
  EW_EXPECTS(differInProcessingOnly(from.knobs, to));
  if (to.greyMap != from.knobs.greyMap) before.greyMap = to.greyMap;
  if (to.dynamicRange_db != from.knobs.dynamicRange_db) before.dynamicRange_db = to.dynamicRange_db;
  if (to.markerLeft != from.knobs.markerLeft) before.markerLeft = to.markerLeft;
  if (to.upsideDown != from.knobs.upsideDown) before.upsideDown = to.upsideDown;
  if (to.zoom != from.knobs.zoom || !(toPan == from.pan)) before.detail = Detail{to.zoom, toPan};
  return before;
}

bool leavesMemory(const PostProcessing& by, const Knobs& knobs) {
  // Persistence remembers levels before the grey map; the strip of the M-mode remembers grey levels.
  const bool mapAlone = !by.dynamicRange_db && !by.markerLeft && !by.upsideDown && !by.detail;
  return mapAlone && (!by.greyMap || *by.greyMap == knobs.greyMap || knobs.mode == DisplayMode::bMode);
}

}  // namespace ew
