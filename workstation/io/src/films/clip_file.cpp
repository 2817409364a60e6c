#include "ew/io/clip_file.h"

#include <utility>

#include "ew/core/contract.h"
#include "ew/core/ending.h"
#include "files/image_header.h"
#include "films/video_loader.h"

namespace ew {
namespace {
using namespace detail;
namespace fs = std::filesystem;

tl::unexpected<Error> notWritten(const fs::path& file, const Message& reason) {
  return failure(ErrorCode::notWritable,
                 hasEnding(file, ".avi")
                     ? say<"%1 could not be written: %2; check the folder and the free space.">(quoted(file), reason)
                     : say<"%1 could not be written: %2; check the folder and the free space, or write .avi.">(quoted(file), reason),
                 {{"file", file.string()}, {"reason", reason.english()}});
}

/// What a library said, or what is known without it.
Message reasonOr(const Reason& why, Message otherwise) { return why.front() == '\0' ? std::move(otherwise) : verbatim(why.data()); }

}  // namespace

struct ClipWriter::Parts {
  fs::path file;
  int width_px = 0, height_px = 0;
  EwClip* clip = nullptr;

  void close() {
    if (clip != nullptr) (*videoModule()->close)(std::exchange(clip, nullptr));
  }
  ~Parts() { close(); }
};

ClipWriter::ClipWriter(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
ClipWriter::~ClipWriter() = default;
ClipWriter::ClipWriter(ClipWriter&&) noexcept = default;
ClipWriter& ClipWriter::operator=(ClipWriter&&) noexcept = default;

bool isClipFile(const fs::path& file) { return hasEnding(file, ".avi") || hasEnding(file, ".mp4"); }

Result<ClipWriter> ClipWriter::open(const fs::path& file, int width_px, int height_px, double rate_hz) {
  EW_EXPECTS(rate_hz > 0.0);
  if (!isClipFile(file))
    return failure(ErrorCode::unsupported, say<"%1 has an ending that is not written; end its name in .avi or .mp4.">(quoted(file)),
                   {{"file", file.string()}});
  if (width_px < 2 || height_px < 2)
    return failure(ErrorCode::badField, say<"A film of %1 x %2 pixels cannot be made; give at least 2x2.">(width_px, height_px),
                   {{"file", file.string()}});
  if (!videoModule()) return passOn(videoModule().error());
  Reason why{};
  EwClip* const clip = (*videoModule()->open)(file.c_str(), width_px, height_px, rate_hz, why.data(), why.size());
  if (clip == nullptr) return notWritten(file, reasonOr(why, say<"the film could not be begun">()));
  auto parts = std::make_unique<Parts>();
  parts->file = file;
  parts->width_px = width_px;
  parts->height_px = height_px;
  parts->clip = clip;
  return ClipWriter(std::move(parts));
}

Result<void> ClipWriter::add(const RgbImage& image) {
  EW_EXPECTS(parts_->clip != nullptr && image.width == parts_->width_px && image.height == parts_->height_px);
  Reason why{};
  const auto* const bytes = reinterpret_cast<const unsigned char*>(image.pixels.data());
  if (!(*videoModule()->add)(parts_->clip, bytes, why.data(), why.size()))
    return notWritten(parts_->file, reasonOr(why, say<"an image could not be added">()));
  return {};
}

Result<void> ClipWriter::finish() {
  EW_EXPECTS(parts_->clip != nullptr);
  Reason why{};
  const bool isWhole = (*videoModule()->finish)(parts_->clip, why.data(), why.size());
  parts_->close();
  if (!isWhole) return notWritten(parts_->file, reasonOr(why, say<"the end of the film is missing">()));
  std::error_code problem;
  const auto size = fs::file_size(parts_->file, problem);
  if (problem || size == 0) return notWritten(parts_->file, problem ? verbatim(problem.message()) : say<"it is empty">());
  return {};
}

}  // namespace ew
