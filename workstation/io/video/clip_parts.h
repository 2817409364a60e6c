#pragma once

#include <memory>
#include <string>

#include "films/video_module.h"

struct EwClipParts {
  EwClipParts() = default;
  EwClipParts(const EwClipParts&) = delete;
  EwClipParts& operator=(const EwClipParts&) = delete;
  virtual ~EwClipParts() = default;
  virtual bool add(const unsigned char* rgb, std::string& why) = 0;
  /// Once, after the last image. @return whether all of the film is in its file
  virtual bool finish(std::string& why) = 0;
};

/// H.264 in an MP4, or MPEG-4 part 2 where the installed FFmpeg cannot write that. Null: it cannot be begun.
std::unique_ptr<EwClipParts> openMp4(const char* file, int width_px, int height_px, double rate_hz, std::string& why);
