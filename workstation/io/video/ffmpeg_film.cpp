extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/display.h>
#include <libavutil/imgutils.h>
#include <libavutil/pixdesc.h>
#include <libswscale/swscale.h>
}

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

#include "ffmpeg_owners.h"
#include "film_parts.h"

namespace {

using ew_video::Codec;
using ew_video::Frame;
using ew_video::Packet;
using ew_video::saidOf;

double secondsOf(std::int64_t time, AVRational base) { return static_cast<double>(time) * av_q2d(base); }

/// The bytes of one file and of nothing else: FFmpeg's own way to files is never asked.
class OwnBytes {
 public:
  explicit OwnBytes(const char* file) : file_(::open(file, O_RDONLY | O_CLOEXEC)) {
    struct stat about {};
    if (file_ >= 0 && ::fstat(file_, &about) == 0) size_ = about.st_size;
    constexpr int kBuffer_bytes = 1 << 16;
    auto* const buffer = static_cast<unsigned char*>(av_malloc(kBuffer_bytes));
    if (file_ >= 0 && buffer != nullptr) io_ = avio_alloc_context(buffer, kBuffer_bytes, 0, this, read, nullptr, seek);
    if (io_ == nullptr) av_free(buffer);
  }
  ~OwnBytes() {
    if (io_ != nullptr) av_freep(&io_->buffer);
    avio_context_free(&io_);
    if (file_ >= 0) ::close(file_);
  }
  OwnBytes(const OwnBytes&) = delete;
  OwnBytes& operator=(const OwnBytes&) = delete;
  [[nodiscard]] AVIOContext* io() const { return io_; }

 private:
  static int read(void* self, std::uint8_t* to, int room) {
    auto& own = *static_cast<OwnBytes*>(self);
    const auto got = ::pread(own.file_, to, static_cast<std::size_t>(room), own.at_);
    if (got <= 0) return got == 0 ? AVERROR_EOF : AVERROR(EIO);
    own.at_ += got;
    return static_cast<int>(got);
  }
  static std::int64_t seek(void* self, std::int64_t offset, int whence) {
    auto& own = *static_cast<OwnBytes*>(self);
    if ((whence & AVSEEK_SIZE) != 0) return own.size_;
    const int from = whence & ~AVSEEK_FORCE;
    const std::int64_t base = from == SEEK_SET ? 0 : from == SEEK_CUR ? own.at_ : own.size_;
    if (offset > std::numeric_limits<std::int64_t>::max() - base || base + offset < 0) return AVERROR(EINVAL);
    own.at_ = base + offset;
    return own.at_;
  }

  int file_;
  std::int64_t size_ = 0;
  std::int64_t at_ = 0;
  AVIOContext* io_ = nullptr;
};

int openNothing(AVFormatContext*, AVIOContext**, const char*, int, AVDictionary**) { return AVERROR(EACCES); }

class Video final : public EwFilmParts {
 public:
  explicit Video(const char* file) : bytes_(file) {}
  ~Video() override {
    sws_freeContext(toRgb_);
    avformat_close_input(&in_);
  }

  bool open(const char* container, const char* codecs, std::string& why) {
    if (!openContainer(container, why) || !openDecoder(codecs, why)) return false;
    const AVCodecParameters& said = *stream_->codecpar;
    facts.width_px = said.width;
    facts.height_px = said.height;
    // What decodes counts: containers state sizes that their frames do not have.
    waiting_ = decode();
    if (waiting_ == 1) {
      facts.width_px = frame_->width;
      facts.height_px = frame_->height;
    }
    sayTimes();
    sayShape();
    return facts.width_px > 0 && facts.height_px > 0;
  }

  int next(unsigned char* rgb, double& time_s) override {
    const int got = waiting_ != kNone ? std::exchange(waiting_, kNone) : decode();
    if (got != 1) {
      time_s = reached_s_;
      return got;
    }
    if (frame_->width != facts.width_px || frame_->height != facts.height_px) return -2;
    if (!convert(rgb)) return -1;
    if (frame_->best_effort_timestamp == AV_NOPTS_VALUE) {
      time_s = -1.0;
      return 1;
    }
    if (first_ == AV_NOPTS_VALUE) first_ = frame_->best_effort_timestamp;
    time_s = secondsOf(frame_->best_effort_timestamp - first_, stream_->time_base);
    return 1;
  }
  [[nodiscard]] int faults() const override { return faults_; }

 private:
  static constexpr int kNone = 2;

  bool openContainer(const char* container, std::string& why) {
    const AVInputFormat* const format = av_find_input_format(container);
    if (format == nullptr || bytes_.io() == nullptr) return false;
    in_ = avformat_alloc_context();
    if (in_ == nullptr) return false;
    in_->pb = bytes_.io();
    in_->flags |= AVFMT_FLAG_CUSTOM_IO;
    in_->io_open = openNothing;
    int problem = avformat_open_input(&in_, nullptr, format, nullptr);
    if (problem >= 0) problem = avformat_find_stream_info(in_, nullptr);
    if (problem < 0) why = saidOf(problem);
    return problem >= 0;
  }

  bool openDecoder(const char* codecs, std::string& why) {
    const int best = av_find_best_stream(in_, AVMEDIA_TYPE_VIDEO, -1, -1, nullptr, 0);
    if (best < 0) {
      why = "it has no images";
      return false;
    }
    stream_ = in_->streams[best];
    const AVCodecParameters& said = *stream_->codecpar;
    const char* const name = avcodec_get_name(said.codec_id);
    const std::string wanted = "," + std::string(codecs) + ",";
    if (*codecs != '\0' && wanted.find("," + std::string(name) + ",") == std::string::npos) {
      facts.isOtherCodec = 1;
      why = name;
      return false;
    }
    const AVCodec* const codec = avcodec_find_decoder(said.codec_id);
    decoder_.reset(codec == nullptr ? nullptr : avcodec_alloc_context3(codec));
    frame_.reset(av_frame_alloc());
    packet_.reset(av_packet_alloc());
    if (!decoder_ || !frame_ || !packet_ || avcodec_parameters_to_context(decoder_.get(), &said) < 0) {
      why = name;
      return false;
    }
    decoder_->pkt_timebase = stream_->time_base;
    decoder_->thread_count = 0;  // as many as there are processors
    const int problem = avcodec_open2(decoder_.get(), codec, nullptr);
    if (problem < 0) why = saidOf(problem);
    return problem >= 0;
  }

  /// The next frame into frame_. @return 1, or 0 at the end
  int decode() {
    while (true) {
      const int got = avcodec_receive_frame(decoder_.get(), frame_.get());
      if (got == 0) {
        if ((frame_->flags & AV_FRAME_FLAG_DISCARD) != 0) continue;
        return 1;
      }
      if (got == AVERROR_EOF) return 0;
      if (got != AVERROR(EAGAIN) && !goesOnAfterFault()) return 0;
      if (!feed()) return 0;
    }
  }
  /// The next packet of the film to the decoder, or its end.
  bool feed() {
    while (!isDrained_) {
      const int read = av_read_frame(in_, packet_.get());
      if (read < 0) {
        isDrained_ = true;
        return avcodec_send_packet(decoder_.get(), nullptr) >= 0;
      }
      noteReach();
      // A frame that was dropped while the film was made has no bytes. To a decoder that is the end of all frames, or a fault.
      const bool isOurs = packet_->stream_index == stream_->index && packet_->size > 0;
      const int sent = isOurs ? avcodec_send_packet(decoder_.get(), packet_.get()) : 0;
      av_packet_unref(packet_.get());
      if (isOurs && sent >= 0) return true;
      if (sent < 0 && !goesOnAfterFault()) return false;
    }
    return true;
  }
  bool goesOnAfterFault() {
    constexpr int kMost = 4096;
    return ++faults_ < kMost;
  }
  /// How far any stream reached: sound often goes on while an image stands.
  void noteReach() {
    const std::int64_t at = packet_->pts != AV_NOPTS_VALUE ? packet_->pts : packet_->dts;
    if (at == AV_NOPTS_VALUE) return;
    const AVStream& of = *in_->streams[packet_->stream_index];
    const std::int64_t start = in_->start_time != AV_NOPTS_VALUE ? in_->start_time : 0;
    const double end_s =
        secondsOf(at + std::max<std::int64_t>(packet_->duration, 0), of.time_base) - static_cast<double>(start) / AV_TIME_BASE;
    reached_s_ = std::max(reached_s_, end_s);
  }

  void sayTimes() {
    AVRational rate = stream_->avg_frame_rate;
    if (rate.num <= 0 || rate.den <= 0) rate = stream_->r_frame_rate;
    const double rate_hz = rate.num > 0 && rate.den > 0 ? av_q2d(rate) : 0.0;
    facts.rate_hz = rate_hz > 0.01 && rate_hz < 10000.0 ? rate_hz : 0.0;
    // A duration that was guessed from a rate of bytes says nothing.
    if (in_->duration != AV_NOPTS_VALUE && in_->duration > 0 && in_->duration_estimation_method != AVFMT_DURATION_FROM_BITRATE)
      facts.duration_s = static_cast<double>(in_->duration) / AV_TIME_BASE;
    const double counted = static_cast<double>(stream_->nb_frames);
    // Of an AVI that was cut off FFmpeg shortens the duration to what is there; its header still counts all frames.
    if (std::strcmp(in_->iformat->name, "avi") == 0 && facts.rate_hz > 0.0 && counted < 1e9)
      facts.duration_s = std::max(facts.duration_s, counted / facts.rate_hz);
    const bool isCounted = counted > 0.0 && counted < 1e9;
    // A rate that stands in for a mean one is as fine as the times of frames are written (1000 Hz), and counts nothing.
    const double mean_hz = stream_->avg_frame_rate.num > 0 && stream_->avg_frame_rate.den > 0 ? facts.rate_hz : 0.0;
    const double guessed = std::round(facts.duration_s * mean_hz);
    facts.frames = isCounted ? counted : guessed < 1e9 ? guessed : 0.0;
    facts.framesAreGuess = !isCounted && facts.frames > 0.0 ? 1 : 0;
  }
  void sayShape() {
    const AVRational aspect = av_guess_sample_aspect_ratio(in_, stream_, nullptr);
    if (aspect.num > 0 && aspect.den > 0) facts.pixelAspect = av_q2d(aspect);
    const std::uint8_t* side = av_stream_get_side_data(stream_, AV_PKT_DATA_DISPLAYMATRIX, nullptr);
    if (side == nullptr && waiting_ == 1)  // some cameras say it in the stream itself
      if (const AVFrameSideData* const said = av_frame_get_side_data(frame_.get(), AV_FRAME_DATA_DISPLAYMATRIX); said != nullptr)
        side = said->data;
    if (side == nullptr) return;
    std::array<std::int32_t, 9> matrix{};
    std::memcpy(matrix.data(), side, sizeof matrix);
    constexpr std::array<std::size_t, 4> places{0, 1, 3, 4};
    for (std::size_t n = 0; n < places.size(); ++n) facts.matrix[n] = matrix[places[n]] / 65536.0;
  }

  /// The frame as red, green and blue, its levels as they are stored: a range from 16 to 235 is widened where the film says so, and only
  /// then.
  bool convert(unsigned char* rgb) {
    const auto width = static_cast<std::size_t>(frame_->width);
    if (frame_->format == AV_PIX_FMT_GRAY8) {
      for (int y = 0; y < frame_->height; ++y) {
        const unsigned char* const row = frame_->data[0] + static_cast<std::ptrdiff_t>(y) * frame_->linesize[0];
        for (std::size_t x = 0; x < width; ++x) rgb = std::fill_n(rgb, 3, row[x]);
      }
      return true;
    }
    if (!prepare()) return false;
    sws_scale(toRgb_, frame_->data, frame_->linesize, 0, frame_->height, packed_->data, packed_->linesize);
    for (int y = 0; y < frame_->height; ++y)
      std::memcpy(rgb + 3 * width * static_cast<std::size_t>(y), packed_->data[0] + static_cast<std::ptrdiff_t>(y) * packed_->linesize[0],
                  3 * width);
    return true;
  }
  bool prepare() {
    const Look look{frame_->format, frame_->color_range, frame_->colorspace};
    if (toRgb_ != nullptr && look == look_) return true;
    sws_freeContext(toRgb_);
    toRgb_ = sws_getContext(frame_->width, frame_->height, static_cast<AVPixelFormat>(frame_->format), frame_->width, frame_->height,
                            AV_PIX_FMT_RGB24, SWS_BILINEAR | SWS_ACCURATE_RND | SWS_FULL_CHR_H_INT, nullptr, nullptr, nullptr);
    if (toRgb_ == nullptr) return false;
    look_ = look;
    const bool isHigh = frame_->height >= 720;
    const int space = frame_->colorspace == AVCOL_SPC_UNSPECIFIED ? (isHigh ? SWS_CS_ITU709 : SWS_CS_ITU601) : frame_->colorspace;
    // Its own formats of full range (yuvj420p) stay of full range whatever is said here.
    const bool isFull = frame_->color_range == AVCOL_RANGE_JPEG || isOfFullRange(static_cast<AVPixelFormat>(frame_->format));
    sws_setColorspaceDetails(toRgb_, sws_getCoefficients(space), isFull ? 1 : 0, sws_getCoefficients(SWS_CS_DEFAULT), 1, 0, 1 << 16,
                             1 << 16);
    packed_.reset(av_frame_alloc());
    if (!packed_) return false;
    packed_->format = AV_PIX_FMT_RGB24;
    packed_->width = frame_->width;
    packed_->height = frame_->height;
    return av_frame_get_buffer(packed_.get(), 0) >= 0;  // rows with the room that the conversion writes over
  }
  static bool isOfFullRange(AVPixelFormat format) {
    const char* const name = av_get_pix_fmt_name(format);
    return name != nullptr && std::strncmp(name, "yuvj", 4) == 0;
  }

  struct Look {
    int format = AV_PIX_FMT_NONE;
    AVColorRange range = AVCOL_RANGE_UNSPECIFIED;
    AVColorSpace space = AVCOL_SPC_UNSPECIFIED;
    bool operator==(const Look&) const = default;
  };

  OwnBytes bytes_;
  AVFormatContext* in_ = nullptr;
  AVStream* stream_ = nullptr;
  Codec decoder_;
  Frame frame_, packed_;
  Packet packet_;
  SwsContext* toRgb_ = nullptr;
  Look look_;
  int waiting_ = kNone;  ///< what the first look for a frame gave
  bool isDrained_ = false;
  int faults_ = 0;
  std::int64_t first_ = AV_NOPTS_VALUE;
  double reached_s_ = 0.0;
};

}  // namespace

std::unique_ptr<EwFilmParts> openVideo(const char* file, const char* container, const char* codecs, EwFilmFacts& facts, std::string& why) {
  auto video = std::make_unique<Video>(file);
  if (!video->open(container, codecs, why)) {
    facts = video->facts;
    return nullptr;
  }
  return video;
}
