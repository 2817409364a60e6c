#include "ew/io/live_video.h"

#include <utility>

#include "ew/io/cine_reader.h"
#include "films/video_loader.h"

namespace ew {

struct LiveVideo::Opened {
  EwLive* live = nullptr;
};

Result<std::unique_ptr<LiveVideo>> LiveVideo::open(const Asked& asked) {
  const auto& module = detail::videoModule();
  if (!module) return passOn(module.error());
  // By its content: what only has the name of a film could be a list that makes a decoder open other files.
  if (asked.isFilm && !isFilm(asked.file)) return nullptr;
  double rate_hz = asked.rate_hz;
  EwLive* const live = module->openLive(asked.file.c_str(), asked.isFilm ? 1 : 0, asked.width_px, asked.height_px, &rate_hz);
  if (live == nullptr) return nullptr;
  return std::unique_ptr<LiveVideo>(new LiveVideo(std::make_unique<Opened>(Opened{live}), rate_hz));
}

LiveVideo::LiveVideo(std::unique_ptr<Opened> opened, double rate_hz) : opened_(std::move(opened)), rate_hz_(rate_hz) {}

LiveVideo::~LiveVideo() { detail::videoModule()->closeLive(opened_->live); }

LiveVideo::Next LiveVideo::next(double wait_s, DisplayImage& image) {
  EwLiveImage got{};
  const int came = detail::videoModule()->nextOfLive(opened_->live, wait_s, &got);
  if (came != 1) return came == 0 ? Next::notYet : Next::gone;
  image.grey = {got.grey, got.width_px, got.height_px, got.stride_bytes};
  image.stamp_s = got.stamp_s;
  image.arrival_s = got.arrival_s;
  return Next::image;
}

}  // namespace ew
