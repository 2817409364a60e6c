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

using EwLive = struct EwLiveParts;
struct EwLivePicture {
  const unsigned char* grey;  ///< height_px rows, stride_bytes apart; valid until the next call
  int width_px;
  int height_px;
  std::ptrdiff_t stride_bytes;
  double stamp_s;    ///< when it was exposed, by the driver's clock; not above 0: not known
  double arrival_s;  ///< std::chrono::steady_clock, before it was decoded
};
/// A camera by its device file, asked for pictures of that size and rate, or a film, which has its own.
/// @param rate_hz asked for, and what it is; 0: it does not say. @return null when it cannot be opened
using EwLiveOpen = EwLive*(const char* file, int isFilm, int width_px, int height_px, double* rate_hz);
/// @return 1 for a picture, 0 when none came within wait_s or one could not be decoded, -1 when the film is over or the camera gone
using EwLiveNext = int(EwLive* live, double wait_s, EwLivePicture* picture);
using EwLiveClose = void(EwLive* live);
}
