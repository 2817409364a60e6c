#pragma once

#include <QObject>
#include <QTimer>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ew/library/placing.h"
#include "ew/trackers/camera_calibration.h"
#include "ew/trackers/camera_device.h"
#include "ew/trackers/hand_controller.h"
#include "ew/trackers/paper_body.h"
#include "ew/trackers/tracker_settings.h"
#include "ew/tracking/alignment.h"
#include "ew/tracking/fit_check.h"
#include "ew/tracking/tracked_probe.h"
#include "scan/session.h"
#include "widgets/worker.h"

namespace ew::ui {

class Jobs;
class ScanServer;

/// A place of the mannequin and where the tracker saw the probe's face touch it.
struct TrackerTouch {
  std::string landmark;
  glm::dvec3 at_mm{0.0};       ///< world
  glm::dvec3 at_tracker{0.0};  ///< mm
  double spread_mm = 0.0;      ///< while it was held
};

/// What the touched places, and the traced surface, make of the tracker's frame.
struct TrackerAlignment {
  bool isFound = false;
  bool isTraced = false;
  std::vector<double> residuals_mm;  ///< of each touch
  std::string wrong;                 ///< landmark that does not fit to the others; empty: none
  double rms_mm = 0.0, expected_mm = 0.0;
  Message sentence;  ///< in words, with what to do
};

/// Where the middle of the probe's face is.
struct TrackedFace {
  glm::dvec3 at_tracker{0.0};  ///< mm
  glm::dvec3 at_world{0.0};    ///< mm; of meaning once the tracker is aligned
  double time_s = 0.0;         ///< on steadyNow_s()
};

/// The user's trackers, and the one that moves the probe: kept in a file, started and stopped beside the scan, calibrated. No widgets; all
/// of it on the window's thread, and nothing waits for a device there.
class Trackers final : public QObject {
  Q_OBJECT

 public:
  /// What the window lends.
  struct Window {
    std::function<std::string()> mannequin;                 ///< as Case::mannequin
    std::function<std::vector<glm::vec3>()> bodyPoints_mm;  ///< corners of its surface, world
  };

  Trackers(Session& session, Jobs& jobs, QObject* parent = nullptr);
  ~Trackers() override;

  void setWindow(Window window) { window_ = std::move(window); }
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
  [[nodiscard]] const std::vector<PaperBody>& papers() const { return papers_; }
  [[nodiscard]] const Message& paperProblem() const { return paperProblem_; }
  [[nodiscard]] std::string bodyOf(const std::string& id) const;
  void chooseBody(const std::string& id, const std::string& body);
  [[nodiscard]] double measuredScale_mm() const;
  void setMeasuredScale(double mm);  ///< of the printed line of 100 mm
  [[nodiscard]] CharucoBoard charucoBoard() const;
  /// The body to hold, the board for the mannequin and the chess board.
  [[nodiscard]] Result<void> writeSheet(const std::filesystem::path& file, const std::string& body, bool isLetter) const;
  using LensFound = std::function<void(const Result<CameraCalibration>&)>;
  void solveLens(const std::string& id, const std::vector<CharucoView>& views, const CharucoBoard& board, int width, int height,
                 LensFound found);

  // The mannequin.
  [[nodiscard]] std::vector<BodyLandmark> landmarks() const;
  [[nodiscard]] std::vector<glm::dvec3> landmarkPlaces() const;  ///< world
  [[nodiscard]] std::vector<glm::vec3> bodyPoints() const;
  [[nodiscard]] std::shared_ptr<const Skin> skin() const { return session_.probeControl().skin(); }
  /// How far from the skin a point is; below it less than 0.
  [[nodiscard]] static double gap_mm(const Skin& skin, const glm::dvec3& at_world);
  /// Empty while the tool is not seen.
  [[nodiscard]] std::optional<TrackedFace> face() const;
  [[nodiscard]] std::optional<ToolReading> reading() const;
  [[nodiscard]] TrackerCalibration calibrationOf(const std::string& id) const;
  /// Where the face lies has to be found by touching: of every tool but a paper body that is a probe itself.
  [[nodiscard]] bool needsFace(const std::string& id) const;
  [[nodiscard]] bool isAligned(const std::string& id) const;
  [[nodiscard]] const std::vector<TrackerTouch>& touches(const std::string& id);
  void setTouches(const std::string& id, std::vector<TrackerTouch> touches);
  [[nodiscard]] const TrackerAlignment& alignment(const std::string& id);
  void beginTracing(const std::string& id);
  void trace(const glm::dvec3& at_tracker);
  [[nodiscard]] int tracedCount() const { return static_cast<int>(traced_.size()); }
  void endTracing(const std::string& id);
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
  struct Aligning {
    std::vector<TrackerTouch> touches;
    TrackerAlignment found;
  };
  [[nodiscard]] TrackerSettings* findMutable(const std::string& id);
  void keepList();
  void start(const TrackerSettings& settings);
  void startHandController(const HandControllerSettings& settings);
  void stopDevice();
  void readPapers();
  [[nodiscard]] std::vector<MarkerBody> bodies() const;
  [[nodiscard]] MarkerBody bodyCalled(const std::string& body) const;
  void applyCamera(const TrackerSettings& settings, const CameraSettings& before);
  void lookAtDevice();
  void moveByAxes();
  void checkFit();
  [[nodiscard]] std::string toolOf(const std::string& id) const;
  [[nodiscard]] double printedFactorNow() const;
  void readCalibration(const std::string& id);
  void keep(const std::string& id, TrackerCalibration calibration);
  void findAlignment(const std::string& id, const std::vector<glm::dvec3>& traced);

  Session& session_;
  Jobs& jobs_;
  Window window_;
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
  std::vector<PaperBody> papers_;
  Message paperProblem_;
  std::map<std::string, TrackerCalibration> calibrations_;  ///< by tracker, as far as they were asked for
  std::string readTool_;                                    ///< of the tracker in use, that its calibration was read for
  std::map<std::string, Aligning> aligning_;
  std::vector<glm::dvec3> traced_;
  FitCheck fit_;
  bool fitIsLost_ = false;
  std::unique_ptr<ScanServer> server_;
  Message serverProblem_;
  Worker devices_;  ///< starts and stops them, which may take half a second
};

}  // namespace ew::ui
