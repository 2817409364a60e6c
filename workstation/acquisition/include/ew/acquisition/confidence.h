#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "ew/acquisition/reconstruct.h"
#include "ew/core/image.h"
#include "ew/core/result.h"

namespace ew {

/// How the confidence in an echo is estimated.
enum class ConfidenceMethod {
  beamwise,   ///< each scan line against its neighbours at the same depth: a millisecond or two a frame
  randomWalk  ///< a random walk along the beams (Karamalis 2012): tens of milliseconds a frame, also tells shadows with echoes in them
};

struct ConfidenceOptions {
  ConfidenceMethod method = ConfidenceMethod::beamwise;
  double dynamicRange_db = 60.0;  ///< what grey levels 0..255 span
  double shadow_db = 10.0;  ///< beamwise: how much less than its neighbours a line brings from everywhere below for a confidence of 1/2
  int lines = 96;           ///< randomWalk: the graph has at most so many columns, 8..1024
  int samples = 112;        ///< and at most so many rows, 8..4096: block means tame the speckle that holds walkers up
  double alpha = 0.5;       ///< randomWalk: attenuation over the whole depth, 0..20
  double beta = 80.0;       ///< randomWalk: how much an edge holds a walker up, 1..1000
  double gamma = 0.05;      ///< randomWalk: what it costs to leave the beam, 0..1
};

/// Memory of confidence maps between frames of one size; one per thread.
class ConfidenceScratch {
 public:
  ConfidenceScratch();
  ~ConfidenceScratch();
  ConfidenceScratch(ConfidenceScratch&&) noexcept;
  ConfidenceScratch& operator=(ConfidenceScratch&&) noexcept;

  struct Memory;
  [[nodiscard]] Memory& memory() { return *memory_; }

 private:
  std::unique_ptr<Memory> memory_;
};

/// How far the echoes of a frame can be believed: 1 where the beam arrives as it does beside it, towards 0 in shadow, behind gas and where
/// the face has no contact.
/// beamwise: of each line the level, averaged along 5 % of the depth, falls short of the upper fifth of its row; with s the least such
/// shortfall from a sample to the end of the line, the confidence is 1 / (1 + (s / half)^6), half being `shadow_db` or, in rows so dark
/// that this would leave nothing, half of the row's level. A vessel, behind which the line recovers, keeps its confidence.
/// randomWalk: probability that a walker from a pixel reaches the face before the end of the depth, on an 8-connected graph whose weights
/// are exp(-beta d) along the beam, exp(-beta (d + gamma)) across and exp(-beta (d + sqrt 2 gamma)) between, d being the difference of the
/// levels times exp(-alpha depth). With p that probability over the upper two fifths of its row, since it falls with depth everywhere, the
/// confidence is p^2 / (p^2 + (1 - p)^2).
/// A frame with less than 1 % of its samples above level 8 gets 0 throughout: the probe is off the body.
/// Source: Karamalis et al., Med. Image Anal. 16(6), 2012, sections 2.2-2.4. Ours differs: block means on a coarser graph, alpha 0.5 in
/// place of 2 and beta 80 in place of 90, and what is done with the probability.
/// @param lines      (samples x lines) grey levels: a column is a scan line, row 0 lies at the face; at least 2 x 2
/// @param confidence resized to the same size, 0..1
/// @error badField (an option out of range, a size below 2 x 2)
[[nodiscard]] Result<void> confidenceOfLines(ImageView<const std::uint8_t> lines, const ConfidenceOptions& options,
                                             ConfidenceScratch& scratch, Image<float>& confidence);

/// The same for a frame of a sweep: with a fan, its pixels are taken to scan lines first and the result back; without, columns are lines.
/// Pixels outside the clip get 0.
/// @error as confidenceOfLines; badField (a clip outside the frame)
[[nodiscard]] Result<void> confidenceOfFrame(ImageView<const std::uint8_t> frame, const Clip& clip, const ConfidenceOptions& options,
                                             ConfidenceScratch& scratch, Image<std::uint8_t>& confidence);

/// The confidence of many frames of one size, 255 for 1, on several threads; the answer does not depend on how many.
/// @error as confidenceOfFrame, cancelled
[[nodiscard]] Result<std::vector<Image<std::uint8_t>>> confidenceOfFrames(std::span<const TrackedFrame> frames, const Clip& clip,
                                                                          const ConfidenceOptions& options, int threads,
                                                                          Progress& progress);

}  // namespace ew
