#pragma once

#include <QObject>
#include <optional>
#include <string>
#include <vector>

#include "ew/imaging/resolved.h"
#include "scan/frame_timer.h"
#include "scan/probe_control.h"
#include "scan/scan_contents.h"

namespace ew::ui {

/// What is set for a scan: the probe, the knobs, the part of the fan that is shown, and the scene. While an image is frozen only what needs
/// no new echoes is taken, and acts on it; while a recording is played nothing is, and the console shows what the recording has.
class ScanConsole final : public QObject {
  Q_OBJECT

 public:
  /// @param scan,frames,probe must live longer
  ScanConsole(ScanContents& scan, FrameTimer& frames, ProbeControl& probe) : scan_(scan), frames_(frames), probeControl_(probe) {}

  void setProbes(std::vector<Probe> all);
  [[nodiscard]] const std::vector<Probe>& allProbes() const { return all_; }
  /// Of all probes those that the subject is scanned with.
  [[nodiscard]] const std::vector<Probe>& probes() const { return usable_; }
  [[nodiscard]] const Probe& probe() const { return scan_.console().probe; }
  void chooseProbe(const std::string& id);

  /// What the frames run: the case's scene until the console switches an effect. Only the console's is set here; the case keeps its own.
  void setScene(const Scene& scene);
  [[nodiscard]] const Scene& scene() const { return scan_.console().scene; }
  /// Back to the case's scene; undoSceneReset takes that back until the scene changes again.
  void resetScene();
  void undoSceneReset();
  [[nodiscard]] bool canUndoSceneReset() const { return sceneBeforeReset_.has_value(); }
  [[nodiscard]] bool hasCaseScene() const { return scan_.subject() && scene() == scan_.subject()->scene; }

  void setKnobs(const Knobs& knobs);
  [[nodiscard]] const Knobs& knobs() const { return scan_.console().knobs; }
  /// Which part of the fan a zoomed image shows.
  void setPan(const Pan& pan) { setDetail(knobs().zoom, pan); }
  /// How large, and which part.
  void setDetail(double zoom, const Pan& pan);
  [[nodiscard]] const Pan& pan() const { return scan_.console().pan; }
  /// How what is shown is zoomed, and the pan that acts.
  [[nodiscard]] Detail detail() const;
  [[nodiscard]] double depth_mm() const;  ///< resolved and within the probe's range
  [[nodiscard]] double focus_mm() const;  ///< resolved
  [[nodiscard]] GainLaw gainLaw() const { return resolvedGainLaw(knobs(), scene()); }
  /// The sliders of the law that acts, back to neutral.
  void resetTgc();
  /// All settings as they are before anybody turned them, but the quality, which is the machine's.
  void setNeutral();

  /// The scene, the probes and the first probe of the subject that is scanned from now on.
  void takeSubject();
  /// The case has another scene now, which is that of the subject already.
  void takeCaseScene();
  /// No reset of the scene can be taken back, and no echoes are waited for.
  void forgetWishes();
  /// The tissue of the subject is known: live echoes that a scene asked for begin.
  void beginWantedEchoes();
  void askForEchoes(const Scene& scene);
  /// To be called when a recording shows something else, or ends. @param before what the console said
  void tellWhatChanged(const ScanState& before);

 Q_SIGNALS:
  void sceneChanged();
  void echoesWanted();  ///< a scene asks for live echoes of voxels of which nothing is known yet, but can be (ScanSubject::possible)
  void probeChanged();
  void knobsChanged();
  void changeRefused();                            ///< of settings, because the image is frozen
  void wideDetailAsked(const ew::Detail& detail);  ///< the wide image is to be shown so

 private:
  void updateUsableProbes();
  void takeProbe(const Probe& probe);
  void takeScene(const Scene& scene);
  /// A change of settings while frozen: refused, and who asked is told the settings there are.
  [[nodiscard]] bool refuses();
  /// Of a frozen image: shown so from now on. Expects nothing that needs new echoes.
  void process(const Knobs& knobs, const Pan& pan);
  void setKnobsOfWide(Knobs asked);

  ScanContents& scan_;
  FrameTimer& frames_;
  ProbeControl& probeControl_;
  std::vector<Probe> all_, usable_;
  std::optional<Scene> sceneBeforeReset_;
  std::optional<LiveEchoesEffect> wantedEchoes_;  ///< that begin once tissue is known
};

}  // namespace ew::ui
