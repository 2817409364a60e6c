#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>

#include "scan/session.h"

namespace ew::ui {

/// An image that stands still: frozen, of the cine loop, or of a recording.
struct StillImage {
  bool isPlayed = false;
  bool isWide = false;  ///< the wide image that ended with it
  double time_s = 0.0;
  std::uint64_t number = 0;
  auto operator<=>(const StillImage&) const = default;  // NOLINT(modernize-use-nullptr): the 0 is the compiler's own
};
[[nodiscard]] inline StillImage stillOf(const Session& session) {
  const ScanState& shown = session.shownState();
  return {session.isPlaying(), session.wide() != nullptr, shown.time_s, shown.number};
}

/// What belongs to images that stand still, to each its own: it is there again when the image is.
template <class Value>
class OfImages {
 public:
  /// Of the image that is shown; of none before the first turnTo().
  [[nodiscard]] Value& now() { return now_; }
  [[nodiscard]] const Value& now() const { return now_; }
  [[nodiscard]] const std::optional<StillImage>& image() const { return of_; }
  /// Of any image that had its turn; null when it had none.
  [[nodiscard]] Value* find(const StillImage& image) {
    if (of_ == image) return &now_;
    const auto other = others_.find(image);
    return other != others_.end() ? &other->second : nullptr;
  }

  /// Of an image that is not shown now, and will be.
  void put(const StillImage& image, Value value) { others_.insert_or_assign(image, std::move(value)); }
  /// False when it is shown already.
  bool turnTo(const StillImage& image) {
    if (of_ == image) return false;
    if (of_) others_.insert_or_assign(*of_, std::move(now_));
    const auto known = others_.extract(image);
    now_ = known ? std::move(known.mapped()) : Value();
    of_ = image;
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
  std::optional<StillImage> of_;
  std::map<StillImage, Value> others_;  ///< images that are not shown now
};

}  // namespace ew::ui
