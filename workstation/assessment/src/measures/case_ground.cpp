#include "ew/assessment/case_ground.h"

#include <utility>

#include "ew/core/contract.h"

namespace ew {

CaseGround::CaseGround(std::shared_ptr<const CaseTruth> truth, std::shared_ptr<const Volume> labels, const Grid& placedLabels)
    : truth_(std::move(truth)), labels_(std::move(labels)), placedLabels_(placedLabels) {
  EW_EXPECTS(truth_ != nullptr);
}

std::shared_ptr<const OrganVoxels> CaseGround::organ(int label) const {
  const std::lock_guard lock(guard_);
  auto& organ = organs_[label];
  if (!organ) organ = labels_ ? std::make_shared<const OrganVoxels>(*labels_, placedLabels_, label) : std::make_shared<const OrganVoxels>();
  return organ;
}

}  // namespace ew
