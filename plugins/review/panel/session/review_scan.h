#pragma once

#include <array>
#include <memory>
#include <vector>

#include "ew/assessment/metric.h"
#include "ew/scanning/subject.h"
#include "logic/region_coverage.h"
#include "logic/scan_path.h"
#include "logic/scan_shelf.h"

namespace ew::review {

/// The two scans that are looked at: the one that is reviewed, and what it is compared with.
enum Side { kReviewed, kCompared };
inline constexpr std::array<Side, 2> kSides{kReviewed, kCompared};

/// The one that is reviewed is always the trainee's, so that two attempts are told apart.
[[nodiscard]] inline Who whoOf(Side side) { return side == kReviewed ? Who::trainee : Who::expert; }

/// One scan with all that is shown of it. Never changed after it was opened.
struct ReviewScan {
  std::shared_ptr<const ScanExcerpt> scan;
  ScanSubject subject;
  SkinPath path;
  std::vector<PlaneVisit> planes;
  std::shared_ptr<const VolumeRegions> regions;  ///< null: the voxels stay in their file
  RegionCoverage seen;                           ///< of the regions
  std::vector<MetricValue> metrics;              ///< of the step that is chosen, of the part that is reviewed
};

}  // namespace ew::review
