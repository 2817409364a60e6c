extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/opt.h>
#include <libswscale/swscale.h>
}

#include <algorithm>
#include <cstring>
#include <utility>

#include "clip_parts.h"
#include "ffmpeg_owners.h"

namespace {

using ew_video::Codec;
using ew_video::Frame;
using ew_video::Packet;
using ew_video::saidOf;

/// A film of even size, whose last row and column are repeated where the images have an odd one: players ask for even ones, and black there
/// would spread into the image.
class Mp4 final : public EwClipParts {
 public:
  Mp4(int width_px, int height_px) : width_px_(width_px), height_px_(height_px) {}
  ~Mp4() override {
    if (isBegun_) av_write_trailer(out_);  // of a film that was given up: it frees what the muxer holds
    sws_freeContext(toYuv_);
    if (out_ != nullptr) avio_closep(&out_->pb);
    avformat_free_context(out_);
  }

  bool open(const char* file, double rate_hz, std::string& why) {
    rate_ = av_d2q(rate_hz, 100000);
    if (avformat_alloc_output_context2(&out_, nullptr, "mp4", file) < 0) return false;
    if (!openEncoder("libx264", AV_CODEC_ID_H264) && !openEncoder("mpeg4", AV_CODEC_ID_MPEG4)) return false;
    stream_ = avformat_new_stream(out_, nullptr);
    packet_.reset(av_packet_alloc());
    if (stream_ == nullptr || !packet_ || !prepareFrames()) return false;
    avcodec_parameters_from_context(stream_->codecpar, encoder_.get());
    stream_->time_base = encoder_->time_base;
    stream_->avg_frame_rate = rate_;
    int problem = avio_open(&out_->pb, file, AVIO_FLAG_WRITE);
    if (problem >= 0) problem = avformat_write_header(out_, nullptr);
    if (problem < 0) why = saidOf(problem);
    isBegun_ = problem >= 0;
    return isBegun_;
  }

  bool add(const unsigned char* rgb, std::string& why) override {
    if (av_frame_make_writable(yuv_.get()) < 0) return false;
    const std::size_t row_bytes = 3 * static_cast<std::size_t>(width_px_);
    for (int y = 0; y < packed_->height; ++y) {
      unsigned char* const to = packed_->data[0] + static_cast<std::ptrdiff_t>(y) * packed_->linesize[0];
      std::memcpy(to, rgb + row_bytes * static_cast<std::size_t>(std::min(y, height_px_ - 1)), row_bytes);
      if (packed_->width > width_px_) std::memcpy(to + row_bytes, to + row_bytes - 3, 3);
    }
    sws_scale(toYuv_, packed_->data, packed_->linesize, 0, packed_->height, yuv_->data, yuv_->linesize);
    yuv_->pts = count_++;
    int problem = avcodec_send_frame(encoder_.get(), yuv_.get());
    if (problem >= 0) problem = writeReady();
    if (problem < 0) why = saidOf(problem);
    return problem >= 0;
  }

  /// What the encoder still holds, and the index, without which no player shows anything of the film.
  bool finish(std::string& why) override {
    if (!std::exchange(isBegun_, false)) return false;
    int sent = avcodec_send_frame(encoder_.get(), nullptr);
    if (sent >= 0) sent = writeReady();
    const int ended = av_write_trailer(out_);  // whatever came before: it frees what the muxer holds
    avio_flush(out_->pb);
    const int written = out_->pb->error;
    const int closed = avio_closep(&out_->pb);
    for (const int problem : {sent, ended, written, closed}) {
      if (problem >= 0) continue;
      why = saidOf(problem);
      return false;
    }
    return true;
  }

 private:
  bool openEncoder(const char* name, AVCodecID id) {
    const AVCodec* const codec = avcodec_find_encoder_by_name(name);
    encoder_.reset(codec == nullptr ? nullptr : avcodec_alloc_context3(codec));
    if (!encoder_) return false;
    encoder_->width = (width_px_ + 1) & ~1;
    encoder_->height = (height_px_ + 1) & ~1;
    encoder_->pix_fmt = AV_PIX_FMT_YUV420P;
    encoder_->time_base = av_inv_q(rate_);
    encoder_->framerate = rate_;
    encoder_->gop_size = 12;  // a player jumps to any moment at once
    encoder_->color_range = AVCOL_RANGE_MPEG;
    encoder_->colorspace = AVCOL_SPC_SMPTE170M;
    encoder_->color_primaries = AVCOL_PRI_SMPTE170M;
    encoder_->color_trc = AVCOL_TRC_SMPTE170M;
    if (id == AV_CODEC_ID_H264) {
      // Grain of speckle is what it is about; a usual 23 takes it away, and half of the rims of letters with it.
      av_opt_set(encoder_->priv_data, "crf", "10", 0);
      av_opt_set(encoder_->priv_data, "preset", "veryfast", 0);
    } else {
      encoder_->flags |= AV_CODEC_FLAG_QSCALE;
      encoder_->global_quality = 2 * FF_QP2LAMBDA;
    }
    if ((out_->oformat->flags & AVFMT_GLOBALHEADER) != 0) encoder_->flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
    return avcodec_open2(encoder_.get(), codec, nullptr) >= 0;
  }
  bool prepareFrames() {
    for (auto [frame, format] : {std::pair(&packed_, AV_PIX_FMT_RGB24), std::pair(&yuv_, AV_PIX_FMT_YUV420P)}) {
      frame->reset(av_frame_alloc());
      if (!*frame) return false;
      (*frame)->format = format;
      (*frame)->width = encoder_->width;
      (*frame)->height = encoder_->height;
      if (av_frame_get_buffer(frame->get(), 0) < 0) return false;
    }
    yuv_->color_range = encoder_->color_range;
    yuv_->colorspace = encoder_->colorspace;
    toYuv_ = sws_getContext(encoder_->width, encoder_->height, AV_PIX_FMT_RGB24, encoder_->width, encoder_->height, AV_PIX_FMT_YUV420P,
                            SWS_BILINEAR | SWS_ACCURATE_RND | SWS_FULL_CHR_H_INP, nullptr, nullptr, nullptr);
    return toYuv_ != nullptr;
  }
  /// @return 0, or the number of FFmpeg's problem
  int writeReady() {
    while (true) {
      const int got = avcodec_receive_packet(encoder_.get(), packet_.get());
      if (got == AVERROR(EAGAIN) || got == AVERROR_EOF) return 0;
      if (got < 0) return got;
      packet_->duration = packet_->duration > 0 ? packet_->duration : 1;
      av_packet_rescale_ts(packet_.get(), encoder_->time_base, stream_->time_base);
      packet_->stream_index = stream_->index;
      if (const int written = av_interleaved_write_frame(out_, packet_.get()); written < 0) return written;
    }
  }

  int width_px_, height_px_;
  AVRational rate_{25, 1};
  AVFormatContext* out_ = nullptr;
  AVStream* stream_ = nullptr;
  Codec encoder_;
  Frame packed_, yuv_;
  Packet packet_;
  SwsContext* toYuv_ = nullptr;
  std::int64_t count_ = 0;
  bool isBegun_ = false;
};

}  // namespace

std::unique_ptr<EwClipParts> openMp4(const char* file, int width_px, int height_px, double rate_hz, std::string& why) {
  auto clip = std::make_unique<Mp4>(width_px, height_px);
  if (!clip->open(file, rate_hz, why)) return nullptr;
  return clip;
}
