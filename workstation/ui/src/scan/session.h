#pragma once

#include <QObject>
#include <memory>
#include <optional>
#include <string>

#include "ew/scanning/contact.h"
#include "ew/scanning/recorded.h"
#include "scan/cine_loop.h"
#include "scan/frame_timer.h"
#include "scan/patient_breath.h"
#include "scan/probe_control.h"
#include "scan/scan_console.h"
#include "scan/scan_contents.h"
#include "scan/spectrum_trace.h"

namespace ew::ui {

/// The scan in the window: a Scanner, where its poses come from, and when the next image is due. No widgets. Every change asks for a new
/// image; changes of one turn of the event loop make one image. Where the image changes by itself (noise, blood in colours, a persistence
/// that has not settled, M-mode, a spectrum, a lowered quality) frames keep coming while somebody watches, at most about 28 a second and
/// never more than half of the time, so that the window stays responsive: frames are skipped, not queued. Its topics are objects of their
/// own, each with its signals; here is what holds them together: the subject, the image, and what is shown in place of a live one.
class Session final : public QObject {
  Q_OBJECT

 public:
  explicit Session(QObject* parent = nullptr);

  /// Who moves the probe.
  [[nodiscard]] ProbeControl& probeControl() { return probeControl_; }
  [[nodiscard]] const ProbeControl& probeControl() const { return probeControl_; }
  /// What is set: probe, knobs, scene.
  [[nodiscard]] ScanConsole& console() { return console_; }
  [[nodiscard]] const ScanConsole& console() const { return console_; }
  /// When frames are due, and what they take.
  [[nodiscard]] FrameTimer& frames() { return frames_; }
  [[nodiscard]] const FrameTimer& frames() const { return frames_; }
  /// The images before the present one.
  [[nodiscard]] CineLoop& cineLoop() { return cineLoop_; }
  [[nodiscard]] const CineLoop& cineLoop() const { return cineLoop_; }
  /// What is read off the spectrum that is shown.
  [[nodiscard]] SpectrumTrace& spectrumTrace() { return spectrumTrace_; }
  [[nodiscard]] const SpectrumTrace& spectrumTrace() const { return spectrumTrace_; }
  /// What the patient is asked to do.
  [[nodiscard]] PatientBreath& breath() { return breath_; }
  [[nodiscard]] const PatientBreath& breath() const { return breath_; }

  /// Whose examination goes on: with the same patient, loaded again or moved into another body, what was stored and measured stays.
  enum class Patient { same, another };
  void show(ScanSubject subject, Patient patient = Patient::another);
  void clear(Patient patient = Patient::another);
  /// Whether what is shown is a draft and may become finer now: not while somebody looks at an image that stands or is played, or paints.
  [[nodiscard]] bool canRefine() const;
  /// The subject of a draft as it was asked for: nothing else changes, neither console nor hand, and what was recorded goes on.
  void refine(ScanSubject better);
  [[nodiscard]] const std::optional<ScanSubject>& subject() const { return scan_.subject(); }
  /// The image and all that it is made with change places with those of another session of the same subject: its console, its cine loop
  /// and who makes it, so that nothing is formed again. Expects that neither runs: frozen, or without an image; and that none plays.
  /// Where the probe is, the clock and the breath are not an image's and stay.
  void exchangeImage(Session& other);
  /// The same subject and the same console as another session, and no image yet.
  void beginLike(const Session& other);
  /// Moves the volume, and its labels with it, to where `ownToWorld` (rigid, mm) takes the grids of their own; ignored without one.
  /// A transform and no grid: whoever moves something cannot give it the grid of something else.
  void place(const Transform<frame::World, frame::World>& ownToWorld);
  void setTitle(const std::string& title);
  /// The case names other labels now, on a grid in the frame of the voxels' own; null: none.
  void setLabels(std::shared_ptr<const Volume> labels);
  /// Shows labels that are being edited, on a grid in the world, where the volume lies now; empty: those of the case again.
  void previewLabels(std::optional<Volume> labels);
  /// What was found out of the voxels that are shown; live echoes that a scene asked for meanwhile begin.
  void know(std::shared_ptr<const TissueMaps> ofVoxels);
  /// The case was edited: its scene is shown as it is now.
  void setCaseScene(const Scene& scene);

  /// Part of the probe's face that touches skin below which there are data, 0..1; gaps of up to 3 mm are filled by gel. Empty without a
  /// skin.
  [[nodiscard]] std::optional<double> contact() const;
  /// Where the subject has data.
  [[nodiscard]] const Recorded& recorded() const { return recorded_; }
  /// What of the present image looks at nothing recorded.
  [[nodiscard]] RecordingGap unrecorded() const;
  /// Whether any part of the fan, as the image shows it, lies within the volume.
  [[nodiscard]] bool seesVolume() const;

  /// Shows a state of a recording in place of the console's and the hand's, which are as they were once it is empty again. Meanwhile
  /// nothing is changed by hand: the console shows what was set when the recording was made.
  void play(std::optional<ScanState> state);
  [[nodiscard]] bool isPlaying() const { return scan_.played.has_value(); }
  /// Earlier images no longer show in later ones.
  void forgetImages();

  /// Freezing keeps the image and all that it was made with; the hand may move on. Settings that need new echoes are refused as long as
  /// it lasts. How the echoes are shown may be changed (scanning/post_processing.h): that acts on all images of the ring until the scan
  /// runs on, which then has the settings it had.
  void setFrozen(bool frozen);
  [[nodiscard]] bool isFrozen() const { return scan_.frozen.has_value(); }

  /// What the image is made with: the console's and the hand's of this moment, or the frozen ones.
  [[nodiscard]] Pose imagePose() const { return scan_.frozen ? scan_.frozen->pose : probeControl_.pose(); }
  [[nodiscard]] const Knobs& imageKnobs() const { return scan_.settings().knobs; }
  [[nodiscard]] const Scene& imageScene() const { return scan_.settings().scene; }
  [[nodiscard]] const Probe& imageProbe() const { return scan_.settings().probe; }
  /// All that the latest image was made with; its knobs ask for less than the console where quality is lowered.
  [[nodiscard]] const ScanState& shownState() const { return scan_.shown; }

  /// Size of the image in device pixels.
  void setImageSize(int width, int height);
  [[nodiscard]] glm::ivec2 imageSize_px() const { return {scan_.width_px, scan_.height_px}; }
  /// What is shown: the latest image, or the wide one in its place. Its views are valid until the next one. Empty before the first.
  [[nodiscard]] const DisplayImage& image() const { return scan_.wide ? scan_.wide->image : scan_.image; }
  [[nodiscard]] const DisplayGeometry& geometry() const { return scan_.wide ? scan_.wide->shown.geometry : fanGeometry(); }
  /// What the probe sees, whatever is shown.
  [[nodiscard]] const DisplayImage& fanImage() const { return scan_.image; }
  [[nodiscard]] const DisplayGeometry& fanGeometry() const { return seen().geometry(); }
  /// Who made the present image: its M-mode strip (width 0 in B-mode), its spans and its plan are there.
  [[nodiscard]] const Scanner& seen() const { return scan_.seen(); }
  /// Shown in place of the fan's image until it is empty again. Points of the image plane are those of the wide image meanwhile.
  void showWide(std::optional<WideImage> wide);
  [[nodiscard]] const WideImage* wide() const { return scan_.wide ? &scan_.wide->shown : nullptr; }
  [[nodiscard]] bool changesByItself() const;

  /// Makes the image now when one is due (tests and the screenshot wait for it).
  void makeImageNow();

 Q_SIGNALS:
  void subjectChanged();
  void subjectReplaced();  ///< by another one, or by none
  void patientReplaced();  ///< likewise, after subjectReplaced: another examination begins
  void frozenChanged(bool frozen);
  void imageChanged();

 private:
  /// Nothing of what was shown is shown any more, and everybody is told.
  void endSubject(Patient patient);
  void takeLabels(std::shared_ptr<const Volume> labels);
  /// What is shown at this moment, as well as console and hand can say it.
  [[nodiscard]] ScanState stateToFreeze() const;
  /// Everything the next image is made with.
  [[nodiscard]] ScanState nextState();
  void keepComing();
  /// Everybody who shows something of the image or its console looks again. @param wasFrozen before
  void notifyImageChanged(bool wasFrozen);

  ScanContents scan_;
  FrameTimer frames_{scan_};
  ProbeControl probeControl_{scan_, frames_};
  ScanConsole console_{scan_, frames_, probeControl_};
  CineLoop cineLoop_{scan_, frames_};
  PatientBreath breath_{scan_, frames_};
  SpectrumTrace spectrumTrace_{scan_, frames_};
  Recorded recorded_;
  std::shared_ptr<const Volume> caseLabels_;  ///< while others are shown that are being edited
  bool isFreezing_ = false;
  bool isOwnFrame_ = false;  ///< nothing was changed: the frame comes by itself
};

}  // namespace ew::ui
