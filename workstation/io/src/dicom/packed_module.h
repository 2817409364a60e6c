#pragma once

#include <cstddef>

/// What the module `ew_packed` offers. It links GDCM, whose dictionary takes longer to begin than all other libraries of a program
/// together: a program loads it when it meets a packed image, not when it starts.
extern "C" {
enum EwPackedCodec { ewPackedJpeg, ewPackedJpegLs, ewPackedJpeg2000 };
/// What the stream is said to hold, and how its samples are wanted.
struct EwPackedImage {
  int codec;
  unsigned width_px;
  unsigned height_px;
  int components;  ///< 1 or 3
  int bitsAllocated;
  int bitsStored;
  int isSigned;
};
/// Decodes one image. It may end the process: see unpack (packed_frame.h).
/// @param samples room for `wanted` bytes. @return whether there were as many
using EwUnpack = bool(const EwPackedImage* image, const unsigned char* stream, std::size_t bytes, unsigned char* samples,
                      std::size_t wanted);
}
