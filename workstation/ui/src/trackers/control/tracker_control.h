#pragma once

#include <QObject>
#include <QTimer>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ew/trackers/camera_calibration.h"
#include "ew/trackers/camera_device.h"
#include "ew/trackers/hand_controller.h"
#include "ew/trackers/tracker_settings.h"
#include "ew/tracking/fit_check.h"
#include "ew/tracking/tracked_probe.h"
#include "ew/widgets/worker.h"
#include "scan/session.h"
#include "trackers/control/mannequin_touches.h"
#include "trackers/control/tracker_papers.h"

namespace ew::ui {

class Jobs;
class ScanServer;

/// Where the middle of the probe's face is.
struct ProbeFacePosition {
  glm::dvec3 at_tracker{0.0};  ///< mm
  glm::dvec3 at_world{0.0};    ///< mm; of meaning once the tracker is aligned
  double time_s = 0.0;         ///< on steadyNow_s()
};

/// The user's trackers, and the one that moves the probe: kept in a file, started and stopped beside the scan, calibrated. No widgets; all
/// of it on the window's thread, and nothing waits for a device there.
class Trackers final : public QObject {
  Q_OBJECT

 public:
  Trackers(Session& session, Jobs& jobs, QObject* parent = nullptr);
  ~Trackers() override;

  /// Reads what was kept, and goes on with the tracker that was in use.
  void load();
  /// Another mannequin lies there: its alignment is looked for.
  void mannequinChanged();

  [[nodiscard]] const std::vector<TrackerSettings>& all() const { return list_.trackers; }
  [[nodiscard]] const TrackerSettings* find(const std::string& id) const;
  std::string add(TrackerSettings settings);  ///< gives it an id, and a name unlike the others
  void change(const TrackerSettings& settings);
  void remove(const std::string& id);

  /// The probe follows this tracker from now on; where it runs already, nothing happens.
  void use(const std::string& id);
  void useMouse();
  [[nodiscard]] const std::string& used() const { return used_; }  ///< empty: the mouse
  [[nodiscard]] TrackingReport report() const;
  [[nodiscard]] DeviceStatus deviceStatus() const;
  [[nodiscard]] const std::shared_ptr<TrackedProbe>& probe() const { return probe_; }

  [[nodiscard]] bool soundsLost() const { return list_.soundsLost; }
  void setSoundsLost(bool sounds);
  /// Sends the scan to others over OpenIGTLink.
  void serve(bool serves, int port, bool toNetwork);
  [[nodiscard]] bool serves() const { return list_.serves; }
  [[nodiscard]] int servePort() const { return list_.servePort; }
  [[nodiscard]] bool servesNetwork() const { return list_.servesNetwork; }
  [[nodiscard]] QString serverSentence() const;  ///< how it goes

  // Cameras and paper.
  [[nodiscard]] const CameraSettings* cameraOf(const std::string& id) const;  ///< null: it is no camera
  /// Another device, or a film. The lens that was measured stays only from film to film: films are of one camera unless somebody says
  /// otherwise.
  void chooseCamera(const std::string& id, const std::string& device);
  void changeCamera(const std::string& id, const std::function<void(CameraSettings&)>& apply);
  [[nodiscard]] CameraDevice* camera() const { return camera_.get(); }  ///< in use; null: none
  [[nodiscard]] const std::shared_ptr<CameraDevice>& sharedCamera() const { return camera_; }
  [[nodiscard]] std::optional<CameraView> cameraView() const;
  [[nodiscard]] const TrackerPapers& papers() const { return papers_; }  ///< what there is to look for
  [[nodiscard]] std::string bodyOf(const std::string& id) const;
  void chooseBody(const std::string& id, const std::string& body);
  /// Keeps what the printed line of 100 mm measures; a camera in use goes by it at once.
  void setMeasuredScale(double mm);
  using LensFound = std::function<void(const Result<CameraCalibration>&)>;
  void solveLens(const std::string& id, const std::vector<CharucoView>& views, const CharucoBoard& board, int width, int height,
                 LensFound found);

  // The mannequin.
  /// What was touched of it; an alignment found there is kept here, and the probe follows it at once.
  [[nodiscard]] MannequinTouches& mannequin() { return mannequin_; }
  /// Empty while the tool is not seen.
  [[nodiscard]] std::optional<ProbeFacePosition> face() const;
  [[nodiscard]] std::optional<ToolReading> reading() const;
  [[nodiscard]] TrackerCalibration calibrationOf(const std::string& id) const;
  /// Where the face lies has to be found by touching: of every tool but a paper body that is a probe itself.
  [[nodiscard]] bool needsFace(const std::string& id) const;
  [[nodiscard]] bool isAligned(const std::string& id) const;
  /// Keeps where the face of a tool lies.
  void keepFace(const std::string& id, const Transform<frame::Tool, frame::Probe>& probeToTool, const CalibrationQuality& quality);

 Q_SIGNALS:
  void listChanged();  ///< trackers, their names or settings, or which one is used
  void reported();     ///< at most ten times a second: state and figures may be new
  void stateChanged(ew::TrackingState state);
  void problem(const ew::Error& error);
  void fitLost(const QString& sentence);  ///< the calibration no longer fits
  void fitFound();                        ///< it does again

 private:
  [[nodiscard]] TrackerSettings* findMutable(const std::string& id);
  void keepList();
  void start(const TrackerSettings& settings);
  void startHandController(const HandControllerSettings& settings);
  void stopDevice();
  void applyCamera(const TrackerSettings& settings, const CameraSettings& before);
  void lookAtDevice();
  void moveByAxes();
  void checkFit();
  [[nodiscard]] std::string toolOf(const std::string& id) const;
  void readCalibration(const std::string& id);
  void keep(const std::string& id, TrackerCalibration calibration);
  void keepAlignment(const std::string& id, const Transform<frame::World, frame::Tracker>& trackerToWorld,
                     const CalibrationQuality& quality);

  Session& session_;
  Jobs& jobs_;
  TrackerList list_;
  bool listIsBroken_ = false;  ///< the file cannot be read: it is left alone
  std::string used_;
  std::shared_ptr<TrackerDevice> device_;
  std::shared_ptr<CameraDevice> camera_;  ///< the same, where it is one
  std::shared_ptr<TrackedProbe> probe_;
  std::shared_ptr<AxisDevice> axes_;
  std::optional<RateHand> rateHand_;
  double movedAt_s_ = 0.0;
  QTimer poll_, axisTimer_;
  TrackingState told_ = TrackingState::off;
  TrackerPapers papers_;
  std::map<std::string, TrackerCalibration> calibrations_;  ///< by tracker, as far as they were asked for
  std::string readTool_;                                    ///< of the tracker in use, that its calibration was read for
  MannequinTouches mannequin_;
  FitCheck fit_;
  bool fitIsLost_ = false;
  std::unique_ptr<ScanServer> server_;
  Message serverProblem_;
  Worker devices_;  ///< starts and stops them, which may take half a second
};

}  // namespace ew::ui
