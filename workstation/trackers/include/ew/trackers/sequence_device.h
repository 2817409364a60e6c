#pragma once

#include <filesystem>
#include <memory>

#include "ew/tracking/tracker_device.h"

namespace ew {

/// A recording of PLUS (.igs.mha, .mha, .mhd, .nrrd) as a tracker.
struct SequenceSettings {
  std::filesystem::path file;
  double speed = 1.0;  ///< 0.1..10
  bool loops = true;   ///< begins again at its end
  bool operator==(const SequenceSettings&) const = default;
};

class SequenceDevice : public TrackerDevice {
 public:
  /// Nothing comes while it is paused; the clock of the recording stands still.
  virtual void pause(bool isPaused) = 0;
  [[nodiscard]] virtual bool isPaused() const = 0;
  /// Where it is now, and how long it is, in seconds of the recording; 0 before it was read.
  [[nodiscard]] virtual double at_s() const = 0;
  [[nodiscard]] virtual double length_s() const = 0;
};

/// Readings of every transform of the frames, named "ProbeToTracker" as the file names them, at the pace they were recorded, stamped by a
/// clock of the recording's own, which goes on through repetitions and pauses. A pose that the recording marks INVALID is outOfView when
/// its matrix is the identity (a tool that was missing), else invalid. A frame without a time comes a thirtieth of a second after the one
/// before. Pixels are not kept. A file that cannot be read is said in the status and tried again every two seconds.
[[nodiscard]] std::unique_ptr<SequenceDevice> makeSequenceDevice(const SequenceSettings& settings);

}  // namespace ew
