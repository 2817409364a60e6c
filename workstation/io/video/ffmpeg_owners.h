#pragma once

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavutil/error.h>
}

#include <array>
#include <memory>
#include <string>

/// What FFmpeg gives out, with owners.
namespace ew_video {

template <auto release>
struct Frees {
  template <class T>
  void operator()(T* it) const {
    release(&it);
  }
};
using Frame = std::unique_ptr<AVFrame, Frees<av_frame_free>>;
using Packet = std::unique_ptr<AVPacket, Frees<av_packet_free>>;
using Codec = std::unique_ptr<AVCodecContext, Frees<avcodec_free_context>>;

/// The words for a problem's number.
inline std::string saidOf(int problem) {
  std::array<char, AV_ERROR_MAX_STRING_SIZE> text{};
  av_strerror(problem, text.data(), text.size());
  return text.data();
}

}  // namespace ew_video
