#pragma once

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
}

#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <functional>
#include <optional>
#include <stdexcept>
#include <vector>

namespace ew::test {

/// A small grey film with what containers say about films, written by FFmpeg itself.
struct FilmOf {
  AVCodecID codec = AV_CODEC_ID_FFV1;
  const char* container = "matroska";  ///< FFmpeg's short name of the muxer
  int width = 64, height = 48;
  std::vector<double> times_s = {0.0, 0.04, 0.08};
  AVRational aspect{0, 1};                        ///< of a pixel
  bool isFull = false;                            ///< its levels reach from 0 to 255, not from 16 to 235
  std::optional<std::array<int, 4>> matrix = {};  ///< of its track: a, b, c, d of x' = a x + c y, y' = b x + d y
  std::function<std::uint8_t(int n, int x, int y)> level = [](int n, int x, int y) {
    return static_cast<std::uint8_t>(16 + (x + y + n) % 200);
  };
};

inline bool canWrite(AVCodecID codec) { return avcodec_find_encoder(codec) != nullptr; }

inline void writeFilm(const std::filesystem::path& file, const FilmOf& film) {
  const auto must = [](bool good, const char* what) {
    if (!good) throw std::runtime_error(what);
  };
  AVFormatContext* out = nullptr;
  must(avformat_alloc_output_context2(&out, nullptr, film.container, file.c_str()) >= 0, "no such container");
  const AVCodec* const codec = avcodec_find_encoder(film.codec);
  must(codec != nullptr, "no such encoder");
  AVCodecContext* encoder = avcodec_alloc_context3(codec);
  encoder->width = film.width;
  encoder->height = film.height;
  encoder->pix_fmt = film.codec == AV_CODEC_ID_PNG ? AV_PIX_FMT_GRAY8 : AV_PIX_FMT_YUV420P;
  const bool isMpeg = film.codec == AV_CODEC_ID_MPEG2VIDEO;
  encoder->time_base = isMpeg ? AVRational{1, 25} : AVRational{1, 1000};
  encoder->framerate = {25, 1};
  encoder->sample_aspect_ratio = film.aspect;
  encoder->color_range = film.isFull ? AVCOL_RANGE_JPEG : AVCOL_RANGE_MPEG;
  encoder->gop_size = 4;
  encoder->bit_rate = 2000000;
  if ((out->oformat->flags & AVFMT_GLOBALHEADER) != 0) encoder->flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
  must(avcodec_open2(encoder, codec, nullptr) >= 0, "the encoder cannot be opened");
  AVStream* const stream = avformat_new_stream(out, nullptr);
  avcodec_parameters_from_context(stream->codecpar, encoder);
  stream->time_base = encoder->time_base;
  stream->avg_frame_rate = encoder->framerate;
  stream->sample_aspect_ratio = film.aspect;
  if (film.matrix) {
    const auto& m = *film.matrix;
    const std::array<std::int32_t, 9> matrix{m[0] * 65536, m[1] * 65536, 0, m[2] * 65536, m[3] * 65536, 0, 0, 0, 1 << 30};
    std::memcpy(av_stream_new_side_data(stream, AV_PKT_DATA_DISPLAYMATRIX, sizeof matrix), matrix.data(), sizeof matrix);
  }
  must(avio_open(&out->pb, file.c_str(), AVIO_FLAG_WRITE) >= 0, "the file cannot be written");
  must(avformat_write_header(out, nullptr) >= 0, "the header cannot be written");
  AVFrame* frame = av_frame_alloc();
  AVPacket* packet = av_packet_alloc();
  frame->format = encoder->pix_fmt;
  frame->width = film.width;
  frame->height = film.height;
  frame->color_range = encoder->color_range;
  av_frame_get_buffer(frame, 0);
  const auto drain = [&] {
    while (avcodec_receive_packet(encoder, packet) >= 0) {
      av_packet_rescale_ts(packet, encoder->time_base, stream->time_base);
      packet->stream_index = stream->index;
      av_interleaved_write_frame(out, packet);
    }
  };
  for (std::size_t n = 0; n < film.times_s.size(); ++n) {
    av_frame_make_writable(frame);
    for (int y = 0; y < film.height; ++y)
      for (int x = 0; x < film.width; ++x) frame->data[0][y * frame->linesize[0] + x] = film.level(static_cast<int>(n), x, y);
    if (encoder->pix_fmt != AV_PIX_FMT_GRAY8)
      for (const int plane : {1, 2})
        for (int y = 0; y < film.height / 2; ++y)
          std::memset(frame->data[plane] + y * frame->linesize[plane], 128, static_cast<std::size_t>(film.width / 2));
    frame->pts = static_cast<std::int64_t>(film.times_s[n] * encoder->time_base.den + 0.5);
    must(avcodec_send_frame(encoder, frame) >= 0, "a frame cannot be written");
    drain();
  }
  avcodec_send_frame(encoder, nullptr);
  drain();
  av_write_trailer(out);
  avio_closep(&out->pb);
  av_packet_free(&packet);
  av_frame_free(&frame);
  avcodec_free_context(&encoder);
  avformat_free_context(out);
}

}  // namespace ew::test
