#pragma once

#include <QElapsedTimer>
#include <QImage>
#include <QObject>
#include <QString>
#include <QTimer>
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "ew/imaging/adaptive_quality.h"
#include "ew/imaging/latency.h"
#include "ew/imaging/resolved.h"
#include "ew/scanning/breathing.h"
#include "ew/scanning/cine.h"
#include "ew/scanning/contact.h"
#include "ew/scanning/post_processing.h"
#include "ew/scanning/recorded.h"
#include "ew/scanning/scanner.h"
#include "ew/scanning/tracked_pace.h"
#include "ew/tracking/pose_source.h"
#include "ew/tracking/tracked_probe.h"

namespace ew::ui {

/// The scan in the window: a Scanner, where its poses come from, and when the next picture is due. No widgets. Every change asks for a new
/// picture; changes of one turn of the event loop make one picture. Where the picture changes by
/// itself (noise, a persistence that has not settled, M-mode, a lowered quality) frames keep coming while somebody watches, at most about
/// 28 a second and never more than half of the time, so that the window stays responsive: frames are skipped, not queued.
class Session final : public QObject {
  Q_OBJECT

 public:
  explicit Session(QObject* parent = nullptr);
  ~Session() override;

  void setProbes(std::vector<Probe> all);
  [[nodiscard]] const std::vector<Probe>& probes() const { return usable_; }
  [[nodiscard]] const Probe& probe() const { return console().probe; }
  void chooseProbe(const std::string& id);

  /// Whose examination goes on: with the same patient, loaded again or moved into another body, what was stored and measured stays.
  enum class Patient { same, another };
  void show(ScanSubject subject, Patient patient = Patient::another);
  void clear(Patient patient = Patient::another);
  /// Whether what is shown is a draft and may become finer now: not while somebody looks at a picture that stands or is played, or paints.
  [[nodiscard]] bool canRefine() const;
  /// The subject of a draft as it was asked for: nothing else changes, neither console nor hand, and what was recorded goes on.
  void refine(ScanSubject better);
  [[nodiscard]] const std::optional<ScanSubject>& subject() const { return scanner_.subject(); }
  /// The picture and all that it is made with change places with those of another session of the same subject: its console, its cine loop
  /// and who makes it, so that nothing is formed again. Expects that neither runs: frozen, or without a picture; and that none plays.
  /// Where the probe is, the clock and the breath are not a picture's and stay.
  void exchangePicture(Session& other);
  /// The same subject and the same console as another session, and no picture yet.
  void beginLike(const Session& other);
  /// Moves the volume, and its labels with it, to where `ownToWorld` (rigid, mm) takes the grids of their own; ignored without one.
  /// A transform and no grid: whoever moves something cannot give it the grid of something else.
  void place(const Transform<frame::World, frame::World>& ownToWorld);
  void setTitle(const std::string& title);
  /// The case names other labels now, on a grid in the frame of the voxels' own; null: none.
  void setLabels(std::shared_ptr<const Volume> labels);
  /// Shows labels that are being edited, on a grid in the world, where the volume lies now; empty: those of the case again.
  void previewLabels(std::optional<Volume> labels);

  /// What the frames run: the case's scene until the console switches an effect. Only the console's is set here; the case keeps its own.
  void setScene(const Scene& scene);
  [[nodiscard]] const Scene& scene() const { return console().scene; }
  /// Back to the case's scene; undoSceneReset takes that back until the scene changes again.
  void resetScene();
  void undoSceneReset();
  [[nodiscard]] bool canUndoSceneReset() const { return sceneBeforeReset_.has_value(); }
  [[nodiscard]] bool hasCaseScene() const { return subject() && scene() == subject()->scene; }
  /// What was found out of the voxels that are shown; live echoes that a scene asked for meanwhile begin.
  void know(std::shared_ptr<const TissueMaps> ofVoxels);
  /// The case was edited: its scene is shown as it is now.
  void setCaseScene(const Scene& scene);

  void setSkin(std::shared_ptr<const Skin> skin);
  [[nodiscard]] const std::shared_ptr<const Skin>& skin() const { return skin_; }

  void setKnobs(const Knobs& knobs);
  [[nodiscard]] const Knobs& knobs() const { return console().knobs; }
  /// Which part of the fan a zoomed picture shows.
  void setPan(const Pan& pan) { setDetail(knobs().zoom, pan); }
  /// How large, and which part.
  void setDetail(double zoom, const Pan& pan);
  [[nodiscard]] const Pan& pan() const { return console().pan; }
  [[nodiscard]] double depth_mm() const;  ///< resolved and within the probe's range
  [[nodiscard]] double focus_mm() const;  ///< resolved
  [[nodiscard]] GainLaw gainLaw() const { return resolvedGainLaw(knobs(), scene()); }
  /// The sliders of the law that acts, back to neutral.
  void resetTgc();
  /// All settings as they are before anybody turned them, but the quality, which is the machine's.
  void setNeutral();

  /// Whether quality may fall while the probe moves fast (imaging/adaptive_quality.h). A frozen picture is always made in full.
  void setAdaptive(bool adaptive);
  [[nodiscard]] bool isAdaptive() const { return isAdaptive_; }
  /// Whether the present picture was made with less than the console asks for.
  [[nodiscard]] bool isLowered() const { return isAdaptive_ && !frozen_ && !played_ && adaptive_.isLowered(); }
  /// What the present picture was made with.
  [[nodiscard]] const Knobs& usedKnobs() const { return shown_.knobs; }
  /// Replaces the limits of the adaptive quality (tests make every frame count as slow).
  void setAdaptiveOptions(const AdaptiveQuality::Options& options) { adaptive_ = AdaptiveQuality(options); }

  /// The hand on the skin: the one hold there is. While a tracker has the probe the hand goes on by itself and shows nowhere; once the
  /// tracker has lost it for a second, a hand that moves has the probe until the tracker finds it again.
  void setHold(const Hold& hold);
  [[nodiscard]] const Hold& hold() const { return hand_.hold(); }
  [[nodiscard]] const HandOnSkin& hand() const { return hand_; }
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
  /// Whether a hand that moves is refused: the picture stands, or somebody else has the probe.
  [[nodiscard]] bool handRests() const;
  /// To be called when readings came, from any thread and as often as one likes: a picture of them is made as soon as one is due. Does
  /// nothing once the session is gone.
  [[nodiscard]] std::function<void()> newsOfTracker();
  /// The picture would be one of now, and there is no pose of now: it is the one before, and has to look like it.
  [[nodiscard]] bool isLost() const { return lost_.has_value() && !frozen_ && !played_ && !wide_ && mover() == Mover::tracker; }
  /// How the tracker did when it was asked last: with every picture, and ten times a second. Of state `off` without one.
  [[nodiscard]] const TrackingReport& tracking() const { return tracking_; }
  /// What the picture would have been made with while isLost(), with the last place and a status that is not ok.
  [[nodiscard]] const ScanState& missedState() const { return missed_; }
  /// How the face of a tracked probe lies on the skin in the present picture; empty where nobody tracks it or contact does not count.
  [[nodiscard]] std::optional<FaceReport> face() const;
  /// What steadyNow_s() is ahead of now_s(): the clock of a TrackedProbe.
  [[nodiscard]] double steadyMinusScan_s() const { return steadyNow_s() - now_s(); }
  /// Where the probe is now.
  [[nodiscard]] Pose pose() const;
  /// On the scan's clock.
  [[nodiscard]] double now_s() const { return static_cast<double>(clock_.nsecsElapsed()) * 1e-9; }
  /// Part of the probe's face that touches skin below which there are data, 0..1; gaps of up to 3 mm are filled by gel. Empty without a
  /// skin.
  [[nodiscard]] std::optional<double> contact() const;
  /// Where the subject has data.
  [[nodiscard]] const Recorded& recorded() const { return recorded_; }
  /// What of the present picture looks at nothing recorded.
  [[nodiscard]] UnrecordedPart unrecorded() const;
  /// Whether any part of the fan, as the picture shows it, lies within the volume.
  [[nodiscard]] bool seesVolume() const;

  /// Shows a state of a recording in place of the console's and the hand's, which are as they were once it is empty again. Meanwhile
  /// nothing is changed by hand: the console shows what was set when the recording was made.
  void play(std::optional<ScanState> state);
  [[nodiscard]] bool isPlaying() const { return played_.has_value(); }
  /// Earlier pictures no longer show in later ones.
  void forgetPictures();

  /// What the patient is asked to do with the breath, from now on.
  void askBreathing(BreathingRequest request);
  [[nodiscard]] BreathingRequest breathing() const { return breathing_.asked(); }
  /// Whether there is a patient who can be asked: one whose tissue moves with the breath.
  [[nodiscard]] bool canBreathe() const { return subject() && subject()->motion && subject()->motion->rhythms.breathing; }
  /// Why a breath that is asked for does not show; null when it does. Translatable in the context "ew::ui::Session".
  [[nodiscard]] const char* whyBreathingIsNotSeen() const;

  /// Freezing keeps the picture and all that it was made with; the hand may move on. Settings that need new echoes are refused as long as
  /// it lasts. How the echoes are shown may be changed (scanning/post_processing.h): that acts on all images of the ring until the scan
  /// runs on, which then has the settings it had.
  void setFrozen(bool frozen);
  [[nodiscard]] bool isFrozen() const { return frozen_.has_value(); }

  /// The last seconds of this scan, since it was let run last, another probe was taken or a recording was shown. It rests while frozen.
  [[nodiscard]] const CineRing& cine() const { return cine_; }
  /// Frozen, shows another image of the ring: the same pixels, formed again. Where many before it have to be formed as well (persistence,
  /// M-mode), that goes on between other events, and the present image stays meanwhile; who asks for another one by then gets that.
  void showCine(std::size_t frame);
  /// Which image of the ring is frozen, or wanted; empty while it runs, and when the ring is empty.
  [[nodiscard]] std::optional<std::size_t> cineFrame() const { return cineFrame_; }
  [[nodiscard]] bool isFormingCine() const { return formOn_.isActive(); }
  /// What the picture is made with: the console's and the hand's of this moment, or the frozen ones.
  [[nodiscard]] Pose picturePose() const { return frozen_ ? frozen_->pose : pose(); }
  [[nodiscard]] const Knobs& pictureKnobs() const { return settings().knobs; }
  [[nodiscard]] const Scene& pictureScene() const { return settings().scene; }
  [[nodiscard]] const Probe& pictureProbe() const { return settings().probe; }
  /// All that the latest picture was made with.
  [[nodiscard]] const ScanState& shownState() const { return shown_; }

  /// Size of the picture in device pixels.
  void setPictureSize(int width, int height);
  [[nodiscard]] glm::ivec2 pictureSize_px() const { return {width_, height_}; }
  /// What is shown: the latest picture, or the wide one in its place. Its views are valid until the next one. Empty before the first.
  [[nodiscard]] const Picture& picture() const { return wide_ ? wide_->picture : picture_; }
  [[nodiscard]] const DisplayGeometry& geometry() const { return wide_ ? wide_->shown.geometry : fanGeometry(); }
  /// What the probe sees, whatever is shown.
  [[nodiscard]] const Picture& fanPicture() const { return picture_; }
  [[nodiscard]] const DisplayGeometry& fanGeometry() const { return seen().geometry(); }

  /// A wide picture (imaging/wide_picture.h) in the directions of the fan's, and how it is shown.
  struct Wide {
    GreyImage grey;
    DisplayGeometry geometry;
    Detail detail;
    GreyImage whole;  ///< small
    DisplayGeometry wholeGeometry;
  };
  /// Shown in place of the fan's picture until it is empty again. Points of the image plane are those of the wide picture meanwhile.
  void showWide(std::optional<Wide> wide);
  [[nodiscard]] const Wide* wide() const { return wide_ ? &wide_->shown : nullptr; }
  /// How what is shown is zoomed, and the pan that acts.
  [[nodiscard]] Detail detail() const;
  /// The M-mode strip; width 0 in B-mode.
  [[nodiscard]] ImageView<const std::uint8_t> strip() const { return seen().strip(); }
  [[nodiscard]] int stripCursor() const { return seen().stripCursor(); }
  [[nodiscard]] const MModeStrip& mMode() const { return seen().mMode(); }
  [[nodiscard]] const Spans& spans() const { return seen().spans(); }
  [[nodiscard]] const Plan& plan() const { return seen().plan(); }
  /// From a change of the hold to the picture that shows it; of a tracked probe from the measurement to the picture.
  [[nodiscard]] const LatencyHistogram& latency() const { return latency_; }
  /// Frames made since the start; they come by themselves only while something changes by itself.
  [[nodiscard]] std::uint64_t framesMade() const { return framesMade_; }
  [[nodiscard]] bool changesByItself() const;
  /// Whether anybody sees the picture; nobody: no frames come by themselves.
  void setWatched(bool watched);
  /// Median time of each step over the last frames, in the plan's order.
  [[nodiscard]] std::vector<StepTime> stepTimes() const;

  /// Asks for a new picture although nothing changed.
  void refresh();
  /// Makes the picture now when one is due (tests and the screenshot wait for it).
  void makePictureNow();

 Q_SIGNALS:
  void subjectChanged();
  void subjectReplaced();  ///< by another one, or by none
  void patientReplaced();  ///< likewise, after subjectReplaced: another examination begins
  void sceneChanged();
  void echoesWanted();  ///< a scene asks for live echoes of voxels of which nothing is known yet, but can be (ScanSubject::possible)
  void probeChanged();
  void knobsChanged();
  void adaptiveChanged(bool adaptive);
  void holdChanged();
  void frozenChanged(bool frozen);
  void breathingChanged();
  void cineChanged();                              ///< which image of the ring is wanted, or the ring itself while frozen
  void cineReplaced();                             ///< by the ring of another picture
  void changeRefused();                            ///< of settings, because the image is frozen
  void wideDetailAsked(const ew::Detail& detail);  ///< the wide picture is to be shown so
  void pictureChanged();
  void poseMissed();       ///< while isLost(), as often as pictures would have come: missedState() is new
  void trackingChanged();  ///< who has the probe, whether it is lost, or the state of the tracker

 private:
  struct News;
  void takeNews();
  void lookAtTracker();
  void miss(ScanState next);
  void takeBackByHand();
  void putHandAtTracked();
  void measureLatency();
  [[nodiscard]] const PoseSource& poses() const;
  [[nodiscard]] Scene sceneOf(Mover mover) const;
  void due();
  void askForEchoes(const Scene& scene);
  void updateUsableProbes();
  void takeProbe(const Probe& probe);
  void takeScene(const Scene& scene);
  void takeLabels(std::shared_ptr<const Volume> labels);
  void keepComing();
  /// A change of settings while frozen: refused, and who asked is told the settings there are.
  [[nodiscard]] bool refuses();
  /// Of a frozen picture: shown so from now on. Expects nothing that needs new echoes.
  void process(const Knobs& knobs, const Pan& pan);
  void forgetCine();
  /// Everybody who shows something of the picture or its console looks again. @param wasFrozen before
  void tellOfPicture(bool wasFrozen);
  /// Forms the wanted image of the ring: now where that is quick, else between other events.
  void formCine();
  void formOn();
  void showFormed(std::size_t which);
  /// Who made the present picture.
  [[nodiscard]] const Scanner& seen() const { return forming_ && forming_->isSeen ? forming_->two[forming_->shown].scanner() : scanner_; }
  [[nodiscard]] const ScanState& console() const {
    return wide_ ? wide_->state : played_ ? *played_ : consoleWhileFrozen_ ? *consoleWhileFrozen_ : live_;
  }
  [[nodiscard]] const ScanState& settings() const { return wide_ ? wide_->state : frozen_ ? *frozen_ : console(); }
  /// The zoom of the console is that of the wide picture, while one is shown.
  void showWideSettings();
  void setKnobsOfWide(Knobs asked);
  /// Everything the next picture is made with.
  [[nodiscard]] ScanState nextState();

  std::vector<Probe> all_, usable_;
  Scanner scanner_{0};
  Recorded recorded_;
  std::shared_ptr<const Skin> skin_;
  HandOnSkin hand_;
  std::shared_ptr<const PoseSource> source_;     ///< of a plugin; null: none drives
  ScanState live_;                               ///< as the console has it, and the number of the last live picture
  std::optional<ScanState> frozen_;              ///< as it is shown
  ScanState asScanned_;                          ///< what is frozen, before anybody changed how it is shown
  PostProcessing processing_;                    ///< of what is frozen
  std::optional<ScanState> consoleWhileFrozen_;  ///< once something of a frozen picture was changed
  std::optional<ScanState> played_;
  struct ShownWide {
    Wide shown;
    Picture picture;
    ScanState state;
  };
  std::optional<ShownWide> wide_;
  ScanState shown_;
  CineRing cine_;
  std::optional<std::size_t> cineFrame_;
  /// Two, so that what one forms on its way to an image is not seen: the other one holds the present picture.
  struct Forming {
    std::array<CineForming, 2> two;
    std::size_t shown = 0;
    bool isSeen = false;  ///< the present picture was formed here
  };
  std::unique_ptr<Forming> forming_;  ///< once another image than the last one was asked for
  QTimer formOn_;
  std::optional<Scene> sceneBeforeReset_;
  std::shared_ptr<const Volume> caseLabels_;      ///< while others are shown that are being edited
  std::optional<LiveEchoesEffect> wantedEchoes_;  ///< that begin once tissue is known
  AskedBreathing breathing_;
  bool due_ = false;
  bool isFreezing_ = false;
  bool isProcessedAnew_ = false;  ///< the frozen picture is to be shown otherwise
  bool isOwnFrame_ = false;       ///< nothing was changed: the frame comes by itself
  bool isWatched_ = true;
  int width_ = 0, height_ = 0;
  Picture picture_;
  std::vector<std::vector<StepTime>> recent_;

  QElapsedTimer clock_;
  QTimer nextFrame_;
  AdaptiveQuality adaptive_;
  bool isAdaptive_ = true;
  double lastFrame_ms_ = 0.0;
  std::uint64_t framesMade_ = 0;
  std::size_t unsettledFrames_ = 0;  ///< due until persistence shows nothing of earlier pictures any more
  std::optional<double> movedAt_s_;
  LatencyHistogram latency_;

  std::shared_ptr<const TrackedProbe> tracked_;
  std::shared_ptr<News> news_;
  Mover base_ = Mover::tracker;  ///< or handMeanwhile: who has it while a tracker is chosen
  bool isMouseChosen_ = false;
  bool isHandReady_ = false;         ///< it waits where the tracker was last
  bool isOfThisScan_ = false;        ///< the picture is one of the live scan of this subject, and may be shown once the pose is lost
  std::optional<Pose> lastTracked_;  ///< the latest that was ok
  std::optional<double> lost_;       ///< since when
  ScanState missed_;
  TrackingReport tracking_;
  QTimer trackerTimer_;
  TrackedPace pace_;
  double frameBegan_s_ = 0.0;
  double newest_s_ = 0.0;  ///< when the latest reading was measured that a picture showed
};

}  // namespace ew::ui
