#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "ew/core/image.h"
#include "ew/core/result.h"

namespace ew {

/// Images of a camera as they come, or of a film one after another, in grey. The libraries for it are loaded when the first is opened.
class LiveVideo {
 public:
  struct Asked {
    std::string file;     ///< a device ("/dev/video0"), or a film
    bool isFilm = false;  ///< then the rest is what the film has
    int width_px = 1280, height_px = 720;
    double rate_hz = 30.0;
  };
  struct DisplayImage {
    ImageView<const std::uint8_t> grey;  ///< valid until the next call
    double stamp_s = 0.0;                ///< when it was exposed, by the driver's clock; not above 0: not known
    double arrival_s = 0.0;              ///< std::chrono::steady_clock, before it was decoded
  };
  enum class Next { image, notYet, gone };

  /// Null: the camera or film cannot be opened; why, the device file says to who asks the system.
  /// @error unsupported (a part of the program is missing)
  [[nodiscard]] static Result<std::unique_ptr<LiveVideo>> open(const Asked& asked);
  ~LiveVideo();
  LiveVideo(const LiveVideo&) = delete;
  LiveVideo& operator=(const LiveVideo&) = delete;

  /// Waits for a camera for `wait_s` at most; a film is read at once. `gone`: the film is over, or the camera was pulled out.
  [[nodiscard]] Next next(double wait_s, DisplayImage& image);
  [[nodiscard]] double rate_hz() const { return rate_hz_; }  ///< 0: it does not say

 private:
  struct Opened;
  LiveVideo(std::unique_ptr<Opened> opened, double rate_hz);
  std::unique_ptr<Opened> opened_;
  double rate_hz_ = 0.0;
};

}  // namespace ew
