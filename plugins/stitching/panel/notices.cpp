#include "panel/notices.h"

#include "ew/widgets/words.h"

namespace ew::stitching {

void Notices::say(const Error& error) {
  if (error.code == ErrorCode::cancelled) return;  // the user knows
  log_.warn(error.sentence());
  Q_EMIT problem(words(error.message));
}

}  // namespace ew::stitching
