#pragma once

#include <memory>

#include "ew/assessment/scannable_region.h"
#include "ew/core/progress.h"
#include "ew/imaging/probe.h"
#include "ew/library/case_truth.h"

namespace ew {

/// A case as whoever teaches with it needs it; its volume need not be prepared.
struct TeachingCase {
  Case opened;
  CaseTruth truth;
  std::shared_ptr<const Skin> skin;
  Probe probe;  ///< the case's first
  ScannableRegion region;
  std::shared_ptr<const Volume> labels;  ///< of the patient at rest, or of the recorded volume; null unless asked for
};

/// @param withLabels takes some seconds
/// @error as loadCaseTruth, readBodySkin, readProbes, readPatientBox, labelsOn, readVolumeHeader; notFound (the probe); unsupported (no
///        volume)
[[nodiscard]] Result<TeachingCase> teachingCaseOf(const Case& opened, bool withLabels, int threads, Progress& progress);

}  // namespace ew
