#include "window/frame/unsaved_work.h"

#include <algorithm>

namespace ew::ui {

bool UnsavedWork::loses(const Holder& holder, Loss loss) {
  return std::find(holder.lostWith.begin(), holder.lostWith.end(), loss) != holder.lostWith.end() && holder.isUnsaved();
}

bool UnsavedWork::mayLose(Loss loss, const std::string& next) const {
  return std::all_of(holders_.begin(), holders_.end(),
                     [&](const Holder& holder) { return !loses(holder, loss) || holder.mayGo(loss, next); });
}

std::vector<std::string> UnsavedWork::heldAgainst(Loss loss) const {
  std::vector<std::string> names;
  for (const Holder& holder : holders_)
    if (loses(holder, loss)) names.push_back(holder.name);
  return names;
}

}  // namespace ew::ui
