#pragma once

// Also the vector units that a part of the library asks for on its own.
#ifndef HWY_WANT_AVX3_DL
#define HWY_WANT_AVX3_DL
#endif
#include <hwy/highway.h>

namespace ew::testing {

/// Calls `work` with the name of each vector unit this processor has, the last the plain build, while kernels run on it alone; then they
/// run on the best one again.
template <class Work>
void onEveryTarget(const Work& work) {
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    hwy::GetChosenTarget().Update(target);
    work(hwy::TargetName(target));
  }
  hwy::GetChosenTarget().DeInit();
}

}  // namespace ew::testing
