#include "films/video_loader.h"

#include <dlfcn.h>

#include "files/own_module.h"

namespace ew::detail {
namespace {

Result<VideoModule> load() {
  const auto [file, module] = openOwnModule("libew_video.so");
  VideoModule video;
  if (module != nullptr) {
    video.open = reinterpret_cast<EwClipOpen*>(dlsym(module, "ewClipOpen"));
    video.add = reinterpret_cast<EwClipAdd*>(dlsym(module, "ewClipAdd"));
    video.finish = reinterpret_cast<EwClipFinish*>(dlsym(module, "ewClipFinish"));
    video.close = reinterpret_cast<EwClipClose*>(dlsym(module, "ewClipClose"));
    video.openFilm = reinterpret_cast<EwFilmOpen*>(dlsym(module, "ewFilmOpen"));
    video.nextOfFilm = reinterpret_cast<EwFilmNext*>(dlsym(module, "ewFilmNext"));
    video.faultsOfFilm = reinterpret_cast<EwFilmFaults*>(dlsym(module, "ewFilmFaults"));
    video.closeFilm = reinterpret_cast<EwFilmClose*>(dlsym(module, "ewFilmClose"));
    video.openLive = reinterpret_cast<EwLiveOpen*>(dlsym(module, "ewLiveOpen"));
    video.nextOfLive = reinterpret_cast<EwLiveNext*>(dlsym(module, "ewLiveNext"));
    video.closeLive = reinterpret_cast<EwLiveClose*>(dlsym(module, "ewLiveClose"));
  }
  if (video.open == nullptr || video.add == nullptr || video.finish == nullptr || video.close == nullptr || video.openFilm == nullptr ||
      video.nextOfFilm == nullptr || video.faultsOfFilm == nullptr || video.closeFilm == nullptr || video.openLive == nullptr ||
      video.nextOfLive == nullptr || video.closeLive == nullptr) {
    return failure(ErrorCode::unsupported,
                   say<"Films can be neither written nor read, because a part of the program is missing; install EchoWeave again.">(),
                   {{"file", file.string()}, {"reason", whyNotOpened()}});
  }
  return video;
}

}  // namespace

const Result<VideoModule>& videoModule() {
  static const Result<VideoModule> loaded = load();
  return loaded;
}

}  // namespace ew::detail
