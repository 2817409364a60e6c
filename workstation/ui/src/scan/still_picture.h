#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>

#include "scan/session.h"

namespace ew::ui {

/// A picture that stands still: frozen, of the cine loop, or of a recording.
struct StillPicture {
  bool isPlayed = false;
  bool isWide = false;  ///< the wide picture that ended with it
  double time_s = 0.0;
  std::uint64_t number = 0;
  auto operator<=>(const StillPicture&) const = default;
};
[[nodiscard]] inline StillPicture stillOf(const Session& session) {
  const ScanState& shown = session.shownState();
  return {session.isPlaying(), session.wide() != nullptr, shown.time_s, shown.number};
}

/// What belongs to pictures that stand still, to each its own: it is there again when the picture is.
template <class Value>
class OfPictures {
 public:
  /// Of the picture that is shown; of none before the first turnTo().
  [[nodiscard]] Value& now() { return now_; }
  [[nodiscard]] const Value& now() const { return now_; }
  [[nodiscard]] const std::optional<StillPicture>& picture() const { return of_; }
  /// Of any picture that had its turn; null when it had none.
  [[nodiscard]] Value* find(const StillPicture& picture) {
    if (of_ == picture) return &now_;
    const auto other = others_.find(picture);
    return other != others_.end() ? &other->second : nullptr;
  }

  /// Of a picture that is not shown now, and will be.
  void put(const StillPicture& picture, Value value) { others_.insert_or_assign(picture, std::move(value)); }
  /// False when it is shown already.
  bool turnTo(const StillPicture& picture) {
    if (of_ == picture) return false;
    if (of_) others_.insert_or_assign(*of_, std::move(now_));
    const auto known = others_.extract(picture);
    now_ = known ? std::move(known.mapped()) : Value();
    of_ = picture;
    return true;
  }
  /// False when there is nothing.
  bool forget() {
    if (!of_) return false;
    of_.reset();
    others_.clear();
    now_ = Value();
    return true;
  }

 private:
  Value now_{};
  std::optional<StillPicture> of_;
  std::map<StillPicture, Value> others_;  ///< pictures that are not shown now
};

}  // namespace ew::ui
