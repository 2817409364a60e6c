#pragma once

#include <cstddef>

/// What the module `ew_video` offers. It links OpenCV's video, and with it more than two hundred libraries: a program loads it when it
/// meets a film, not when it starts. Every function catches what is thrown; `why` gets what OpenCV said, in at most `room` bytes with the
/// NUL, and is left alone when it said nothing.
extern "C" {
using EwClip = struct EwClipParts;
/// @return null when the film cannot be begun
using EwClipOpen = EwClip*(const char* file, int width_px, int height_px, double rate_hz, char* why, std::size_t room);
/// @param rgb width_px x height_px pixels of three bytes, row after row. @return whether it was written
using EwClipAdd = bool(EwClip* clip, const unsigned char* rgb, char* why, std::size_t room);
/// Ends the film and forgets it.
using EwClipClose = void(EwClip* clip);

using EwFilm = struct EwFilmParts;
/// What a film, or a TIFF of several pages, says about itself.
struct EwFilmFacts {
  int width_px;
  int height_px;
  double frames;   ///< as promised; 0: it does not say
  double rate_hz;  ///< 0: it does not say
};
enum EwFilmKind { ewFilmOfVideo, ewFilmOfPages };
/// @return null when it cannot be read
using EwFilmOpen = EwFilm*(const char* file, int kind, EwFilmFacts* facts, char* why, std::size_t room);
/// The next frame. @param rgb room for width_px x height_px pixels of three bytes. @param time_s below 0: not known.
/// @return 1 for a frame, 0 at the end, -1 when what follows cannot be read, -2 when the next frame has another size
using EwFilmNext = int(EwFilm* film, unsigned char* rgb, double* time_s, char* why, std::size_t room);
using EwFilmClose = void(EwFilm* film);
}
