#pragma once

#include <QObject>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>

#include "ew/scanning/contact.h"
#include "ew/tracking/pose_source.h"
#include "ew/tracking/tracked_probe.h"
#include "scan/frame_timer.h"
#include "scan/scan_contents.h"

namespace ew::ui {

/// Who moves the probe, and where it is: a hand on the skin, a tracker, or a plugin. What is shown while nobody knows where it is.
class ProbeControl final : public QObject {
  Q_OBJECT

 public:
  /// @param scan,frames must live longer
  ProbeControl(ScanContents& scan, FrameTimer& frames);
  ~ProbeControl() override;

  void setSkin(std::shared_ptr<const Skin> skin);
  [[nodiscard]] const std::shared_ptr<const Skin>& skin() const { return skin_; }

  /// The hand on the skin: the one hold there is. While a tracker has the probe the hand goes on by itself and shows nowhere; once the
  /// tracker has lost it for a second, a hand that moves has the probe until the tracker finds it again.
  void setHold(const Hold& hold);
  [[nodiscard]] const Hold& hold() const { return hand_.hold(); }
  [[nodiscard]] const HandOnSkin& hand() const { return hand_; }
  /// The hand presses another probe as that one is pressed; who changes the probe tells of the hold.
  void pressAsUsual(const Probe& probe);
  /// Poses come from `source` until it is null again: then from the tracker, or without one from the hand. A free pose is not pulled to the
  /// skin.
  void follow(std::shared_ptr<const PoseSource> source);
  [[nodiscard]] bool isFollowing() const { return source_ != nullptr; }

  enum class Mover {
    hand,           ///< no tracker is there, or the user chose the mouse
    tracker,        ///< also while it has lost the probe
    handMeanwhile,  ///< the tracker has lost it, and the hand has moved it since
    plugin,         ///< a plugin drives it (follow)
  };
  [[nodiscard]] Mover mover() const { return source_ ? Mover::plugin : !tracked_ || isMouseChosen_ ? Mover::hand : base_; }
  /// Who has the probe as long as no plugin drives it and the user did not choose the mouse; null: the hand, which goes on where the
  /// tracker was last. Another tracker is another beginning: it is followed.
  void setTracked(std::shared_ptr<const TrackedProbe> probe);
  [[nodiscard]] const std::shared_ptr<const TrackedProbe>& tracked() const { return tracked_; }
  /// The user wants to go on with the mouse, at the place that was tracked last, or with the tracker again.
  void chooseMouse(bool mouse);
  /// Whether a hand that moves is refused: the image stands, or somebody else has the probe.
  [[nodiscard]] bool handRests() const;
  /// To be called when readings came, from any thread and as often as one likes: an image of them is made as soon as one is due. Does
  /// nothing once the session is gone.
  [[nodiscard]] std::function<void()> newsOfTracker();
  /// The image would be one of now, and there is no pose of now: it is the one before, and has to look like it.
  [[nodiscard]] bool isLost() const { return lost_.has_value() && scan_.isLive() && !scan_.wide && mover() == Mover::tracker; }
  /// How the tracker did when it was asked last: with every image, and ten times a second. Of state `off` without one.
  [[nodiscard]] const TrackingReport& tracking() const { return tracking_; }
  /// What the image would have been made with while isLost(), with the last place and a status that is not ok.
  [[nodiscard]] const ScanState& missedState() const { return missed_; }
  /// How the face of a tracked probe lies on the skin in the present image; empty where nobody tracks it or contact does not count.
  [[nodiscard]] std::optional<FaceReport> face() const;
  /// What steadyNow_s() is ahead of the scan's clock: the clock of a TrackedProbe.
  [[nodiscard]] double steadyMinusScan_s() const { return steadyNow_s() - frames_.now_s(); }
  /// Where the probe is now.
  [[nodiscard]] Pose pose() const;
  /// Where it is without a recording, at a moment of the scan's clock.
  [[nodiscard]] Pose poseAt(double time_s) const { return poses().poseAt(time_s); }
  /// What the console's scene is for who has the probe.
  [[nodiscard]] Scene scene() const;
  /// Whether it may be elsewhere after `time_s` although no hand moves.
  [[nodiscard]] bool movesAfter(double time_s) const;

  /// A tracker has the probe, and an image of now is made at `pose`, which is ok.
  void keepTracked(const Pose& pose) { lastTracked_ = pose; }
  /// Instead of an image: there is no pose to make `next` from.
  /// @returns whether the tracker still has the probe, so that frames go on
  bool miss(ScanState next);
  /// Whether the pose was lost until now.
  bool endLoss();
  /// Of a loss that ended with the image of `time_s`.
  void tellFound(double time_s);
  /// From the reading to the image that shows it.
  void measureLatency();

 Q_SIGNALS:
  void holdChanged();
  void poseMissed();       ///< while isLost(), as often as images would have come: missedState() is new
  void trackingChanged();  ///< who has the probe, whether it is lost, or the state of the tracker
  void lastImageMade();    ///< once more while isLost(), for a window of another size

 private:
  struct News;
  void takeNews();
  void lookAtTracker();
  void takeBackByHand();
  void putHandAtTracked();
  [[nodiscard]] const PoseSource& poses() const;

  ScanContents& scan_;
  FrameTimer& frames_;
  std::shared_ptr<const Skin> skin_;
  HandOnSkin hand_;
  std::shared_ptr<const PoseSource> source_;  ///< of a plugin; null: none drives
  std::shared_ptr<const TrackedProbe> tracked_;
  std::shared_ptr<News> news_;
  Mover base_ = Mover::tracker;  ///< or handMeanwhile: who has it while a tracker is chosen
  bool isMouseChosen_ = false;
  bool isHandReady_ = false;         ///< it waits where the tracker was last
  std::optional<Pose> lastTracked_;  ///< the latest that was ok
  std::optional<double> lost_;       ///< since when
  ScanState missed_;
  TrackingReport tracking_;
  QTimer trackerTimer_;
  double newest_s_ = 0.0;  ///< when the latest reading was measured that an image showed
};

}  // namespace ew::ui
