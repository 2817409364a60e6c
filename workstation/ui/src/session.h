#pragma once

#include <QImage>
#include <QObject>
#include <QString>
#include <memory>
#include <optional>
#include <vector>

#include "ew/core/volume.h"
#include "ew/imaging/frame.h"
#include "ew/tracking/hand.h"

namespace ew::ui {

/// What is scanned: voxels, and where they lie. Placing a volume elsewhere changes the grid and shares the voxels.
struct Subject {
  QString title;
  std::shared_ptr<const Volume> volume;
  Grid placedGrid;  ///< of the same dims as the volume's own grid
  Scene scene;
  std::vector<std::string> probes;  ///< ids that may be used, the first is the default; empty: all
};

/// How firmly a hand presses a probe on when nothing else says so: 1 mm, and four fifths of how far the ends of a curved face lie behind
/// its foremost point, so that on flat skin the whole face touches; gel fills the rest. A convex face of 60 mm radius and 62 degrees: 7.9
/// mm.
[[nodiscard]] double usualPress_mm(const Probe& probe);

/// The scan as it stands: what is scanned, with which probe, how it is held, how the console is set, and the picture that results. No
/// widgets. Every change asks for a new picture; changes of one turn of the event loop make one picture.
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
  /// Moves the volume; ignored without one.
  void setPlacedGrid(const Grid& grid);
  void setTitle(const QString& title);

  void setSkin(std::shared_ptr<const Skin> skin);
  [[nodiscard]] const Skin* skin() const { return skin_.get(); }

  void setKnobs(const Knobs& knobs);
  [[nodiscard]] const Knobs& knobs() const { return knobs_; }
  [[nodiscard]] double depth_mm() const;  ///< resolved and within the probe's range
  [[nodiscard]] double focus_mm() const;  ///< resolved

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
  [[nodiscard]] const Probe& pictureProbe() const { return frozen_ ? frozenProbe_ : probe_; }

  /// Size of the picture in device pixels.
  void setPictureSize(int width, int height);
  /// The latest picture; its view is valid until the next one. Empty (width 0) before the first.
  [[nodiscard]] ImageView<const std::uint8_t> picture() const { return picture_; }
  [[nodiscard]] const DisplayGeometry& geometry() const { return maker_.geometry(); }
  [[nodiscard]] const Plan& plan() const { return maker_.plan(); }
  /// Median time of each step over the last frames, in the plan's order.
  [[nodiscard]] std::vector<StepTime> stepTimes() const;

  /// Makes the picture now when one is due (tests and the screenshot wait for it).
  void makePictureNow();

 Q_SIGNALS:
  void subjectChanged();
  void probeChanged();
  void knobsChanged();
  void holdChanged();
  void frozenChanged(bool frozen);
  void pictureChanged();

 private:
  void due();
  void updateUsableProbes();
  void takeProbe(const Probe& probe);

  std::vector<Probe> all_, usable_;
  Probe probe_, frozenProbe_;
  std::optional<Subject> subject_;
  std::shared_ptr<const Skin> skin_;
  Knobs knobs_, frozenKnobs_;
  Hold hold_, frozenHold_;
  bool frozen_ = false;
  bool due_ = false;
  int width_ = 0, height_ = 0;
  FrameMaker maker_;
  ImageView<const std::uint8_t> picture_;
  std::vector<std::vector<StepTime>> recent_;
};

}  // namespace ew::ui
