#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "ew/core/image.h"
#include "ew/core/pose.h"
#include "ew/core/result.h"

namespace ew {

/// What a scan shows at one moment, to be seen by Slicer, PLUS or another of our windows.
struct IgtlFrame {
  Pose pose;                                           ///< no TRANSFORM is sent of one that is not ok: a STATUS says so
  ImageView<const std::uint8_t> image;                 ///< of width 0: none; at most 65535 x 65535
  Transform<frame::World, frame::Image> imageToWorld;  ///< centre of the first pixel and steps from pixel to pixel, in mm
  double time_s = 0.0;                                 ///< since 1970 (UTC) that pose and image belong to; 0: when it is sent
};

struct IgtlServerOptions {
  int port = 18944;                       ///< 0: any that is free
  bool everyone = false;                  ///< computers of the network may connect too; otherwise programs of this one alone
  std::string poseName = "ProbeToWorld";  ///< device names, at most 20 letters
  std::string imageName = "Image_World";  ///< PLUS's way: the image, placed in the world
  double idleAfter_s = 0.25;              ///< then STATUS is sent, so that silence means a fault
  bool operator==(const IgtlServerOptions&) const = default;
};

struct IgtlServerStatus {
  int port = 0;                     ///< 0: not started
  int clients = 0;                  ///< connected now
  std::uint64_t sent = 0;           ///< messages to all clients
  std::uint64_t droppedImages = 0;  ///< that a client was too slow for
  std::uint64_t droppedPoses = 0;
  std::size_t waiting_bytes = 0;  ///< that slow clients have not taken yet
};

/// An OpenIGTLink server for the scan's pose and image, to several clients at once. World is LPS here; everything is sent in RAS, since
/// Slicer takes transforms and images as RAS, whatever their flags. Each client is answered in header version 1 until it writes version 2.
/// A slow client loses old images, then old poses; never is there more than a few images of memory for it. One thread.
class IgtlServer {
 public:
  explicit IgtlServer(IgtlServerOptions options = {});
  ~IgtlServer();  ///< stops

  /// @return the port it listens on
  /// @error notWritable when the port is taken, with what to do
  [[nodiscard]] Result<int> start();
  /// Ends all connections and the thread, within half a second. May be started again.
  void stop();
  /// Hands a frame over and returns at once; the pixels are copied. From one thread at a time. Does nothing while not started or without
  /// clients.
  void send(const IgtlFrame& frame);
  [[nodiscard]] IgtlServerStatus status() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace ew
