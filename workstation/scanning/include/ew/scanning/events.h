#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "ew/scanning/state.h"

namespace ew {

/// What can happen during a scan. Everything but FrameMade and Note changes what the frames after it are made with.
struct ProbeChosen {
  Probe probe;
  bool operator==(const ProbeChosen&) const = default;
};
struct SettingsChanged {
  Knobs knobs;
  Pan pan;
  bool operator==(const SettingsChanged&) const = default;
};
struct SceneChanged {
  Scene scene;
  bool operator==(const SceneChanged&) const = default;
};
/// An image was made, with the settings of that moment.
struct FrameMade {
  Pose pose;
  std::vector<float> gaps_mm;
  std::uint64_t number = 0;
  BodyState body = {};
  bool operator==(const FrameMade&) const = default;
};
struct FreezeChanged {
  bool isFrozen = false;
  bool operator==(const FreezeChanged&) const = default;
};
/// A moment that somebody wants to find again, a measurement, an answer: `what` belongs to whoever knows the kind, and is kept as it is.
struct Note {
  std::string kind;  ///< "mark", "measurement", "answer" ...
  nlohmann::json what;
  bool operator==(const Note&) const = default;
};

struct ScanEvent {
  double time_s = 0.0;  ///< on the scan's clock
  std::variant<ProbeChosen, SettingsChanged, SceneChanged, FrameMade, FreezeChanged, Note> what;
  bool operator==(const ScanEvent&) const = default;
};

/// What happened during a scan, in the order it happened. It only grows, and whatever was asked of it stays true.
class ScanLog {
 public:
  /// Adds a frame with everything that changed since the frame before: the first one adds probe, settings and scene.
  void addFrame(const ScanState& made);
  void setFrozen(double time_s, bool isFrozen);
  void addNote(double time_s, std::string kind, nlohmann::json what);
  /// Any event. Times never fall: one before the last event's counts as the last event's. A frame before the first probe is not kept.
  void add(ScanEvent event);

  [[nodiscard]] const std::vector<ScanEvent>& events() const { return events_; }
  [[nodiscard]] bool empty() const { return events_.empty(); }
  [[nodiscard]] double begin_s() const;
  [[nodiscard]] double end_s() const;

  [[nodiscard]] std::size_t frameCount() const { return frames_.size(); }
  /// All that the n-th frame was made with.
  [[nodiscard]] ScanState frame(std::size_t n) const;
  /// The same into a state that may be that of another frame: its memory serves again.
  void frame(std::size_t n, ScanState& state) const;
  /// What the n-th frame does not have from the events before it.
  [[nodiscard]] const FrameMade& made(std::size_t n) const;
  [[nodiscard]] double frameTime_s(std::size_t n) const;
  /// The frame that is seen at a moment: the last one made by then, the first one before that. Expects a frame.
  [[nodiscard]] std::size_t frameAt(double time_s) const;
  [[nodiscard]] bool isFrozenAt(double time_s) const;

 private:
  struct Frame {
    std::size_t event, probe, settings, scene;  ///< indices of events
  };
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  std::vector<ScanEvent> events_;
  std::vector<Frame> frames_;
  std::size_t probe_ = kNone, settings_ = kNone, scene_ = kNone;  ///< the latest
};

}  // namespace ew
