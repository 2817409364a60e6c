#pragma once

#include <QElapsedTimer>
#include <QImage>
#include <QObject>
#include <QString>
#include <QTimer>
#include <memory>
#include <optional>
#include <vector>

#include "ew/core/volume.h"
#include "ew/imaging/adaptive_quality.h"
#include "ew/imaging/frame.h"
#include "ew/imaging/latency.h"
#include "ew/imaging/slice_source.h"
#include "ew/tracking/hand.h"

namespace ew {
struct Provenance;
}

namespace ew::ui {

/// What is scanned: voxels, and where they lie. Placing a volume elsewhere changes the grid and shares the voxels.
struct Subject {
  QString title;
  std::shared_ptr<const Volume> volume;
  Grid placedGrid;  ///< of the same dims as the volume's own grid
  Scene scene;      ///< what the case calls for
  std::shared_ptr<const BrickedVolume> bricks =
      nullptr;                                     ///< the same voxels as slicing reads them fastest; null: there was no room for them
  std::shared_ptr<const Volume> labels = nullptr;  ///< which tissue each voxel is, on a grid of its own; null: grey levels decide
  Grid placedLabels = {};                          ///< where the labels lie
  std::vector<std::string> probes = {};            ///< ids that may be used, the first is the default; empty: all
  std::shared_ptr<const Provenance> provenance = nullptr;  ///< which frame each voxel came from; null: nobody knows
};

/// How firmly a hand presses a probe on when nothing else says so: 1 mm, and four fifths of how far the ends of a curved face lie behind
/// its foremost point, so that on flat skin the whole face touches; gel fills the rest. A convex face of 60 mm radius and 62 degrees: 7.9
/// mm.
[[nodiscard]] double usualPress_mm(const Probe& probe);

/// The scan as it stands: what is scanned, with which probe, how it is held, how the console is set, and the picture that results. No
/// widgets. Every change asks for a new picture; changes of one turn of the event loop make one picture. Where the picture changes by
/// itself (noise, a persistence that has not settled, M-mode, a lowered quality) frames keep coming while somebody watches, at most about
/// 28 a second and never more than half of the time, so that the window stays responsive: frames are skipped, not queued.
class Session final : public QObject {
  Q_OBJECT

 public:
  explicit Session(QObject* parent = nullptr);

  void setProbes(std::vector<Probe> all);
  [[nodiscard]] const std::vector<Probe>& probes() const { return usable_; }
  [[nodiscard]] const Probe& probe() const { return probe_; }
  void chooseProbe(const std::string& id);

  void show(Subject subject);
  void clear();
  [[nodiscard]] const std::optional<Subject>& subject() const { return subject_; }
  /// Moves the volume, and its labels with it, to where `ownToWorld` (rigid, mm) takes the grids of their own; ignored without one.
  /// A transform and no grid: whoever moves something cannot give it the grid of something else.
  void place(const glm::dmat4& ownToWorld);
  void setTitle(const QString& title);

  /// What the frames run: the case's scene until the console switches an effect. Only the console's is set here; the case keeps its own.
  void setScene(const Scene& scene);
  [[nodiscard]] const Scene& scene() const { return scene_; }
  /// Back to the case's scene; undoSceneReset takes that back until the scene changes again.
  void resetScene();
  void undoSceneReset();
  [[nodiscard]] bool canUndoSceneReset() const { return sceneBeforeReset_.has_value(); }
  [[nodiscard]] bool hasCaseScene() const { return subject_ && scene_ == subject_->scene; }
  /// The case was edited: its scene is shown as it is now.
  void setCaseScene(const Scene& scene);

  void setSkin(std::shared_ptr<const Skin> skin);
  [[nodiscard]] const Skin* skin() const { return skin_.get(); }

  void setKnobs(const Knobs& knobs);
  [[nodiscard]] const Knobs& knobs() const { return knobs_; }
  /// Which part of the fan a zoomed picture shows; a frozen picture keeps its own.
  void setPan(const Pan& pan);
  [[nodiscard]] const Pan& pan() const { return pan_; }
  [[nodiscard]] double depth_mm() const;  ///< resolved and within the probe's range
  [[nodiscard]] double focus_mm() const;  ///< resolved

  /// Whether quality may fall while the probe moves fast (imaging/adaptive_quality.h). A frozen picture is always made in full.
  void setAdaptive(bool adaptive);
  [[nodiscard]] bool isAdaptive() const { return isAdaptive_; }
  /// Whether the present picture was made with less than the console asks for.
  [[nodiscard]] bool isLowered() const { return isAdaptive_ && !frozen_ && adaptive_.isLowered(); }
  /// What the present picture was made with.
  [[nodiscard]] const Knobs& usedKnobs() const { return usedKnobs_; }
  /// Replaces the limits of the adaptive quality (tests make every frame count as slow).
  void setAdaptiveOptions(const AdaptiveQuality::Options& options) { adaptive_ = AdaptiveQuality(options); }

  void setHold(const Hold& hold);
  [[nodiscard]] const Hold& hold() const { return hold_; }
  [[nodiscard]] Pose pose() const { return poseOf(hold_); }
  /// Part of the probe's face that touches the skin, 0..1, counting gaps of up to 3 mm, which gel fills; empty without a skin.
  [[nodiscard]] std::optional<double> contact() const;
  /// Whether any part of the fan, as the picture shows it, lies within the volume.
  [[nodiscard]] bool seesVolume() const;

  /// Freezing keeps the picture, its pose and its knobs; the hand may move on.
  void setFrozen(bool frozen);
  [[nodiscard]] bool isFrozen() const { return frozen_; }
  /// The pose the picture was made for: the hand's, or the frozen one.
  [[nodiscard]] Pose picturePose() const;
  /// The knobs the picture was made with: the console's, or the frozen ones.
  [[nodiscard]] const Knobs& pictureKnobs() const;
  [[nodiscard]] const Scene& pictureScene() const { return frozen_ ? frozenScene_ : scene_; }
  [[nodiscard]] const Probe& pictureProbe() const { return frozen_ ? frozenProbe_ : probe_; }

  /// Size of the picture in device pixels.
  void setPictureSize(int width, int height);
  /// The latest picture; its view is valid until the next one. Empty (width 0) before the first.
  [[nodiscard]] ImageView<const std::uint8_t> picture() const { return picture_; }
  [[nodiscard]] const DisplayGeometry& geometry() const { return maker_.geometry(); }
  /// The M-mode strip; width 0 in B-mode.
  [[nodiscard]] ImageView<const std::uint8_t> strip() const { return maker_.strip(); }
  [[nodiscard]] int stripCursor() const { return maker_.stripCursor(); }
  [[nodiscard]] const Spans& spans() const { return maker_.spans(); }
  [[nodiscard]] const Plan& plan() const { return maker_.plan(); }
  /// From a change of the hold to the picture that shows it.
  [[nodiscard]] const LatencyHistogram& latency() const { return latency_; }
  /// Frames made since the start; they come by themselves only while something changes by itself.
  [[nodiscard]] std::uint64_t framesMade() const { return framesMade_; }
  [[nodiscard]] bool changesByItself() const;
  /// Whether anybody sees the picture; nobody: no frames come by themselves.
  void setWatched(bool watched);
  /// Median time of each step over the last frames, in the plan's order.
  [[nodiscard]] std::vector<StepTime> stepTimes() const;

  /// Makes the picture now when one is due (tests and the screenshot wait for it).
  void makePictureNow();

 Q_SIGNALS:
  void subjectChanged();
  void sceneChanged();
  void probeChanged();
  void knobsChanged();
  void adaptiveChanged(bool adaptive);
  void holdChanged();
  void frozenChanged(bool frozen);
  void pictureChanged();

 private:
  void due();
  void updateUsableProbes();
  void takeProbe(const Probe& probe);
  void takeScene(const Scene& scene);
  void measureGaps(const Pose& pose);
  void keepComing();
  [[nodiscard]] double now_s() const { return static_cast<double>(clock_.nsecsElapsed()) * 1e-9; }

  std::vector<Probe> all_, usable_;
  Probe probe_, frozenProbe_;
  std::optional<Subject> subject_;
  std::shared_ptr<const Skin> skin_;
  Scene scene_, frozenScene_;
  std::optional<Scene> sceneBeforeReset_;
  Knobs knobs_, frozenKnobs_, usedKnobs_;
  Hold hold_, frozenHold_;
  Pan pan_, frozenPan_;
  bool frozen_ = false;
  bool due_ = false;
  bool isFreezing_ = false;
  bool isOwnFrame_ = false;  ///< nothing was changed: the frame comes by itself
  bool isWatched_ = true;
  int width_ = 0, height_ = 0;
  FrameMaker maker_{0};
  ImageView<const std::uint8_t> picture_;
  std::vector<std::vector<StepTime>> recent_;

  QElapsedTimer clock_;
  QTimer nextFrame_;
  AdaptiveQuality adaptive_;
  bool isAdaptive_ = true;
  double lastFrame_ms_ = 0.0;
  double time_s_ = 0.0;       ///< of the picture
  std::uint64_t number_ = 0;  ///< of the picture: decides its noise
  std::uint64_t framesMade_ = 0;
  int unsettledFrames_ = 0;  ///< due until persistence shows nothing of earlier pictures any more
  std::optional<double> movedAt_s_;
  LatencyHistogram latency_;

  std::vector<glm::dvec3> face_mm_;  ///< points of the face in the probe frame
  std::vector<float> gaps_mm_;       ///< skin to face at them
};

}  // namespace ew::ui
