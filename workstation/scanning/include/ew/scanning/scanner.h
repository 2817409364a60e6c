#pragma once

#include <complex>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "ew/imaging/frame.h"
#include "ew/scanning/state.h"
#include "ew/scanning/subject.h"

namespace ew {

/// Images until persistence, of grey levels and of a colour box, shows less than half a grey level of what was there before. A colour box
/// takes one more: what moved since the image before shows in it.
[[nodiscard]] std::size_t framesToSettle(const Knobs& knobs);

/// Makes the images of one subject, one after another. No window, no clock, no thread of its own.
class Scanner {
 public:
  /// @param threads that work on one image; 0: one per processor. Images do not depend on it.
  explicit Scanner(int threads = 1) : maker_(threads) {}

  /// What is scanned from now on; earlier images are forgotten.
  void show(ScanSubject subject);
  /// The same subject with better voxels, labels and maps; title, scene and place are those of `better`. What earlier images leave in
  /// later ones stays.
  void refine(ScanSubject better);
  void clear();
  /// Earlier images no longer show in later ones: persistence and M-mode start afresh.
  void forget() { maker_.forget(); }
  /// What shows of images so far in those that follow. @see FrameMaker::memory, recall; `prepare` the state of the last of them before.
  [[nodiscard]] FrameMemory memory() const { return maker_.memory(); }
  void recall(const FrameMemory& memory) { maker_.recall(memory); }
  [[nodiscard]] const std::optional<ScanSubject>& subject() const { return subject_; }
  /// The subject as it is edited: title, scene, place. Voxels and labels stay those of show().
  void setTitle(std::string title);
  void setScene(Scene scene);
  void know(std::shared_ptr<const TissueMaps> ofVoxels);
  void place(const Transform<frame::World, frame::World>& ownToWorld);
  /// Other labels of the same subject, on a grid in the frame of the voxels' own; null: none. They are placed as the voxels are.
  void setLabels(std::shared_ptr<const Volume> labels);

  /// Tables for a state, made now rather than with the next image.
  void prepare(const ScanState& state, int width_px, int height_px);
  /// The image of a state; its views stay valid until the next one. Expects a subject. A scene that names no tissues, as those of
  /// recordings do, has the subject's: one pose with one console is the same image whoever asks for it.
  /// A pose that is not PoseStatus::ok, or whose matrix checkRigid refuses, gives a black image; one that is not ok also
  /// forgets what was before it: behind a gap a scan begins anew.
  DisplayImage make(const ScanState& state, int width_px, int height_px);
  /// Whether any part of the fan of the last image, seen from `pose`, lies within the voxels.
  [[nodiscard]] bool seesVolume(const Pose& pose) const;

  /// Of the last image.
  [[nodiscard]] const DisplayGeometry& geometry() const { return maker_.geometry(); }
  [[nodiscard]] const Plan& plan() const { return maker_.plan(); }
  [[nodiscard]] const Spans& spans() const { return maker_.spans(); }
  [[nodiscard]] const std::vector<StepTime>& lastTimes() const { return maker_.lastTimes(); }
  /// The strip of the M-mode or the spectrum, as wide and high as the image; width 0 when the mode has none.
  [[nodiscard]] ImageView<const std::uint8_t> strip() const { return maker_.strip(); }
  [[nodiscard]] int stripCursor() const { return maker_.stripCursor(); }
  [[nodiscard]] const MModeStrip& mMode() const { return maker_.mMode(); }
  /// Spectra of the sample volume, whose strip is strip(); null without one.
  [[nodiscard]] const Spectrogram* spectrogram() const { return maker_.spectrogram(); }
  /// What the sample volume gave since the image before, a value for each pulse; empty without one.
  [[nodiscard]] std::span<const std::complex<float>> dopplerSamples() const { return maker_.dopplerSamples(); }

 private:
  FrameMaker maker_;
  std::optional<ScanSubject> subject_;
  std::optional<ScanVoxels> sliced_;              ///< the subject's, with their bricks as long as images are slices
  std::shared_ptr<const TissueMaps> seenTissue_;  ///< of the last frame, held so that no other maps come to lie at its address
  std::uint64_t tissueVersion_ = 0;
};

}  // namespace ew
