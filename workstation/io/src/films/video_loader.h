#pragma once

#include <array>

#include "ew/core/result.h"
#include "films/video_module.h"

namespace ew::detail {

/// The functions of the module that knows films, loaded once and never unloaded.
struct VideoModule {
  EwClipOpen* open = nullptr;
  EwClipAdd* add = nullptr;
  EwClipFinish* finish = nullptr;
  EwClipClose* close = nullptr;
  EwFilmOpen* openFilm = nullptr;
  EwFilmNext* nextOfFilm = nullptr;
  EwFilmFaults* faultsOfFilm = nullptr;
  EwFilmClose* closeFilm = nullptr;
  EwLiveOpen* openLive = nullptr;
  EwLiveNext* nextOfLive = nullptr;
  EwLiveClose* closeLive = nullptr;
};
/// @error unsupported (a part of the program is missing)
[[nodiscard]] const Result<VideoModule>& videoModule();

using Reason = std::array<char, 256>;  ///< what another library said; empty when it said nothing

}  // namespace ew::detail
