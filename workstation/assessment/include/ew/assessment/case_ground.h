#pragma once

#include <map>
#include <memory>
#include <mutex>

#include "ew/assessment/organ_voxels.h"
#include "ew/library/case_truth.h"

namespace ew {

/// What the work on a case is judged against, in the world: its truth, and where its structures lie. Reading is safe from several threads.
class CaseGround {
 public:
  /// @param truth not null
  /// @param labels `echo` holds a label for each voxel; null: nobody knows where structures lie
  /// @param placedLabels where the labels lie in the world, of the labels' own dims
  CaseGround(std::shared_ptr<const CaseTruth> truth, std::shared_ptr<const Volume> labels, const Grid& placedLabels);

  [[nodiscard]] const CaseTruth& truth() const { return *truth_; }
  [[nodiscard]] bool hasLabels() const { return labels_ != nullptr; }
  /// The voxels of a structure, found when they are first asked for; empty where nobody knows.
  [[nodiscard]] std::shared_ptr<const OrganVoxels> organ(int label) const;

 private:
  std::shared_ptr<const CaseTruth> truth_;
  std::shared_ptr<const Volume> labels_;
  Grid placedLabels_;
  mutable std::mutex guard_;
  mutable std::map<int, std::shared_ptr<const OrganVoxels>> organs_;
};

}  // namespace ew
