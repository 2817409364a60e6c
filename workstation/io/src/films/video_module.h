#pragma once

#include <cstddef>

/// What the module `ew_video` offers. It links OpenCV's video and FFmpeg, and with them more than two hundred libraries: a program loads it
/// when it meets a film, not when it starts. Every function catches what is thrown; `why` gets what the library said, in at most `room`
/// bytes with the NUL, and is left alone when it said nothing.
extern "C" {
using EwClip = struct EwClipParts;
/// @return null when the film cannot be begun
using EwClipOpen = EwClip*(const char* file, int width_px, int height_px, double rate_hz, char* why, std::size_t room);
/// @param rgb width_px x height_px pixels of three bytes, row after row. @return whether it was written
using EwClipAdd = bool(EwClip* clip, const unsigned char* rgb, char* why, std::size_t room);
/// Ends the film, to which nothing can be added any more. @return whether all of it is in its file
using EwClipFinish = bool(EwClip* clip, char* why, std::size_t room);
/// Forgets the film; one that was not finished is of no use.
using EwClipClose = void(EwClip* clip);

using EwFilm = struct EwFilmParts;
/// What a film, or a TIFF of several pages, says about itself.
struct EwFilmFacts {
  int width_px;
  int height_px;
  double frames;       ///< as promised, or guessed from duration and rate; 0: it does not say
  int framesAreGuess;  ///< from duration and rate: of a film of varying rate it may be far off
  double rate_hz;      ///< 0: it does not say
  double duration_s;   ///< as its header states; 0: it does not say
  double pixelAspect;  ///< how much wider than high a stored pixel is; 0: it does not say
  double matrix[4];    ///< x' = [0] x + [2] y, y' = [1] x + [3] y puts a stored image upright; all 0: it does not say
  int orientationTag;  ///< of a TIFF, 1 to 8; 0: it does not say
  int isOtherCodec;    ///< it was not opened, because its codec is none of those that were named
  bool operator==(const EwFilmFacts&) const = default;
};
enum EwFilmKind { ewFilmOfVideo, ewFilmOfPages };
/// @param container of a video: the short name of the one FFmpeg demuxer that may open it; nothing but `file` is opened whatever stands in
/// it
/// @param codecs FFmpeg's names of those it may have, parted by commas; empty: any
/// @return null when it cannot be read
using EwFilmOpen = EwFilm*(const char* file, int kind, const char* container, const char* codecs, EwFilmFacts* facts, char* why,
                           std::size_t room);
/// The next frame, as it is stored. @param rgb room for width_px x height_px pixels of three bytes
/// @param time_s of the frame, below 0: not known; at the end: how far the film's streams reached
/// @return 1 for a frame, 0 at the end, -1 when what follows cannot be read, -2 when the next frame has another size
using EwFilmNext = int(EwFilm* film, unsigned char* rgb, double* time_s, char* why, std::size_t room);
/// Packets and frames so far that could not be decoded.
using EwFilmFaults = int(const EwFilm* film);
using EwFilmClose = void(EwFilm* film);

using EwLive = struct EwLiveParts;
struct EwLiveImage {
  const unsigned char* grey;  ///< height_px rows, stride_bytes apart; valid until the next call
  int width_px;
  int height_px;
  std::ptrdiff_t stride_bytes;
  double stamp_s;    ///< when it was exposed, by the driver's clock; not above 0: not known
  double arrival_s;  ///< std::chrono::steady_clock, before it was decoded
};
/// A camera by its device file, asked for images of that size and rate, or a film, which has its own.
/// @param rate_hz asked for, and what it is; 0: it does not say. @return null when it cannot be opened
using EwLiveOpen = EwLive*(const char* file, int isFilm, int width_px, int height_px, double* rate_hz);
/// @return 1 for an image, 0 when none came within wait_s or one could not be decoded, -1 when the film is over or the camera gone
using EwLiveNext = int(EwLive* live, double wait_s, EwLiveImage* image);
using EwLiveClose = void(EwLive* live);
}
