#pragma once

#include "ew/imaging/slicing.h"
#include "imaging/support/support.h"

namespace ew::testing {

/// A slice without the weave's stretches: what each sample is, at every zoom.
inline GreyImage sliced(Quality quality, const SliceSource& source, const ImageToVoxel& plane, int width, int height) {
  SliceScratch scratch;
  GreyImage out(width, height, 99);
  if (quality == Quality::weave)
    sliceWeave(source, plane, viewOf(out), scratch);
  else
    slice(quality, source, plane, viewOf(out), scratch);
  return out;
}

}  // namespace ew::testing
