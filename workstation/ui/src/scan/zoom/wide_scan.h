#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "ew/imaging/panorama.h"
#include "ew/widgets/worker.h"
#include "scan/session.h"

namespace ew::ui {

/// A wide image in the window: it grows from the live images while the probe slides along its plane, ends with a freeze, and stays until
/// the scan runs again. Images are woven on a thread of their own; those that come while two wait for it are left out.
class WideScan final : public QObject {
  Q_OBJECT

 public:
  enum class State {
    off,
    growing,
    kept,    ///< ended with the freeze, and shown
    hidden,  ///< the frozen image is shown in its place
  };
  explicit WideScan(Session& session, QObject* parent = nullptr);
  ~WideScan() override;

  /// Off: begins. Growing: given up. Ended: hidden, or shown again.
  void toggle();
  /// Gives up what grows.
  void cancel();
  [[nodiscard]] State state() const { return state_; }
  /// Whether nothing is under way: all images that came are woven and shown.
  [[nodiscard]] bool isSettled() const { return underWay_ == 0; }

  struct Growth {
    std::size_t images = 0;
    double length_mm = 0.0;  ///< across
    Woven latest = Woven::woven;
    std::size_t leftOut = 0;         ///< images that were not woven for what they are
    std::vector<glm::dvec2> fan_mm;  ///< outline of the latest image, in the plane of the wide image
  };
  [[nodiscard]] const Growth& growth() const { return growth_; }

 Q_SIGNALS:
  void changed();  ///< state or growth
  void said(const QString& sentence);

 private:
  struct Loom;
  void start();
  void drop();
  void takeImage();
  void freeze(bool frozen);
  void render();
  void post(std::uint64_t scan, const std::function<void(Loom&)>& weave);
  void take(std::uint64_t scan, std::optional<WideImage> shown, Growth growth);
  void sayWhy(ew::Woven outcome);

  Session& session_;
  State state_ = State::off;
  Growth growth_;
  std::uint64_t scan_ = 0;        ///< number of the present wide image: what comes late of another one is dropped
  std::uint64_t takenFrame_ = 0;  ///< FrameTimer::framesMade of the latest image that was taken
  std::optional<WideImage> last_;
  Detail detail_;
  glm::ivec2 askedSize_px_{0};
  int underWay_ = 0;
  ew::Woven said_ = ew::Woven::woven;
  std::shared_ptr<Loom> loom_;  ///< the worker's
  Worker worker_;
};

}  // namespace ew::ui
