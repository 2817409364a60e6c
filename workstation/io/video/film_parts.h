#pragma once

#include <memory>
#include <string>

#include "films/video_module.h"

struct EwFilmParts {
  EwFilmParts() = default;
  EwFilmParts(const EwFilmParts&) = delete;
  EwFilmParts& operator=(const EwFilmParts&) = delete;
  virtual ~EwFilmParts() = default;
  virtual int next(unsigned char* rgb, double& time_s) = 0;
  [[nodiscard]] virtual int faults() const { return 0; }
  EwFilmFacts facts{};
};

/// Null: it cannot be read, and `why` may say why. @param facts may tell that it is the codec
std::unique_ptr<EwFilmParts> openVideo(const char* file, const char* container, const char* codecs, EwFilmFacts& facts, std::string& why);
std::unique_ptr<EwFilmParts> openPages(const char* file, std::string& why);
