#include "case/frame_files.h"

#include <utility>
#include <vector>

#include "ew/acquisition/recorded_images.h"
#include "ew/imaging/frame_stack.h"

namespace ew {
namespace {

constexpr const char* kField = "volume.frames";

tl::unexpected<Error> refused(Message expected) {
  return failure(ErrorCode::badField, say<"'volume.frames' in case.json must name %1.">(std::move(expected)), {{"field", kField}});
}

/// Whether what the header says can be sliced, before the pixels are read.
Result<void> checkFrames(const Sequence& images) {
  if (images.width < 2 || images.height < 2 || images.frames.size() < 2) return refused(say<"at least two recorded images">());
  if (images.orientation != "MF") return refused(say<"recorded images whose x runs towards the marker and y away from the probe (MF)">());
  for (const SequenceFrame& frame : images.frames)
    if (frame.transforms.size() != 1 || frame.transforms.front().from != kImageFrame || frame.transforms.front().to != kReferenceFrame ||
        frame.transforms.front().status != PoseStatus::ok)
      return refused(say<"recorded images each of which has an ImageToReferenceTransform and no other">());
  return {};
}

}  // namespace

Result<Sequence> readFrames(const Case& opened, Progress& progress) {
  const auto file = fileOfCase(opened.folder, opened.volume.frames, kField);
  if (!file) return passOn(file.error());
  auto images = readSequence(*file, progress, {}, checkFrames);
  if (!images) return passOn(images.error());
  if (images->pixels.empty()) return refused(say<"recorded images, and not poses alone">());
  return images;
}

Result<std::shared_ptr<const FrameStack>> readFrameStack(const Case& opened, const Grid& own, Progress& progress) {
  auto images = readFrames(opened, progress);
  if (!images) return passOn(images.error());
  const Transform<frame::Voxel, frame::File> toVoxel = inverse(own.voxelTo<frame::File>());
  std::vector<Transform<frame::Voxel, frame::Image>> places;
  places.reserve(images->frames.size());
  for (const SequenceFrame& each : images->frames)
    places.push_back(toVoxel * Transform<frame::File, frame::Image>{each.transforms.front().matrix});
  auto stack = FrameStack::make(std::move(images->pixels), images->width, images->height, places);
  if (!stack) return passOn(stack.error());
  return std::make_shared<const FrameStack>(std::move(*stack));
}

}  // namespace ew
