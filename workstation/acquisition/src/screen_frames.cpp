#include "ew/acquisition/screen_frames.h"

#include <iterator>

namespace ew {

Result<std::shared_ptr<const GreyImage>> ScreenFrames::at(CineReader& reader, std::size_t frame, const Progress& progress) {
  if (const auto found = kept_.find(frame); found != kept_.end()) return found->second;
  if (reader.given() > frame)
    if (auto begun = reader.rewind(); !begun) return passOn(begun.error());
  while (true) {
    const auto number = static_cast<std::size_t>(reader.given());
    const auto got = reader.next(read_, progress);
    if (!got) return passOn(got.error());
    if (!*got)
      return failure(ErrorCode::truncated, say<"The recording has no frame %1; it ends with frame %2.">(frame + 1, reader.given()));
    keep(number, frame);
    if (number == frame) return kept_.at(frame);
  }
}

void ScreenFrames::keep(std::size_t number, std::size_t wanted) {
  if (kept_.contains(number)) return;
  kept_.emplace(number, std::make_shared<const GreyImage>(read_.level));
  bytes_ += read_.level.pixels.size();
  // The one that lies farthest from what is wanted goes first.
  while (bytes_ > mostBytes_ && kept_.size() > 1) {
    const auto first = kept_.begin(), last = std::prev(kept_.end());
    const auto awayOf = [wanted](std::size_t n) { return n > wanted ? n - wanted : wanted - n; };
    auto goes = awayOf(first->first) >= awayOf(last->first) ? first : last;
    if (goes->first == number && number == wanted) goes = goes == first ? last : first;
    bytes_ -= goes->second->pixels.size();
    kept_.erase(goes);
  }
}

}  // namespace ew
