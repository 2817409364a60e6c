#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "ew/trackers/igtl_bodies.h"
#include "ew/trackers/igtl_client.h"

namespace ew {

/// What the bytes and the silences of a connection mean, without a socket and without a clock of its own: the client drives it with real
/// ones, tests with eight hours in a few seconds. Times are on steadyNow_s() or a clock that plays it, and never fall.
class IgtlSession {
 public:
  /// @param queue outlives the session; gets readings, link and refusals
  IgtlSession(IgtlSettings settings, IgtlTiming timing, ReadingQueue& queue);

  void opened(double now_s);
  /// The connection could not be opened, or ended. attempt_s() says when to try again.
  void closed(double now_s, Message why);
  /// @return false: the stream is of no use any more; the connection has to be closed (closed() was called)
  [[nodiscard]] bool received(std::span<const std::uint8_t> bytes, double now_s);
  /// What time alone brings: to be called at tick_s() or earlier.
  /// @return as received()
  [[nodiscard]] bool tick(double now_s);
  /// When tick() is due next, seconds. A tick at exactly this time does what is due: afterwards it is later, or the connection is closed.
  [[nodiscard]] double tick_s() const;
  [[nodiscard]] double attempt_s() const { return attempt_s_; }
  /// What is to be sent; given once.
  [[nodiscard]] std::vector<std::uint8_t> takeToSend();
  /// What is held in memory beside the queue: bytes of a message in progress, names of tools.
  [[nodiscard]] std::size_t held_bytes() const;
  /// As a person writes it: "localhost:18944", "[::1]:18944".
  [[nodiscard]] const std::string& address() const { return address_; }

 private:
  enum class Told { nothing, connected, noPoses, noBytes, trouble };
  struct Tool {
    std::string list;     ///< device and type of the list it stands in; empty: it comes in messages of its own
    double latest_s = 0;  ///< when something was said of it
  };
  void take(const IgtlMessage& message, double now_s);
  void takePoses(const IgtlMessage& message, const std::vector<IgtlPose>& poses, double now_s);
  void takeStatus(const IgtlStatus& status, double now_s);
  void sayMissing(const std::string& tool, double device_s, double now_s);
  void lookForMissing(double now_s);
  [[nodiscard]] double questionPause_s() const;
  void tell(Told what, double now_s);
  [[nodiscard]] Message sentenceFor(Told what) const;
  void ask(const char* type, std::vector<std::uint8_t> content, int version);

  IgtlSettings settings_;
  IgtlTiming timing_;
  ReadingQueue& queue_;
  IgtlReader reader_;
  std::string address_;
  bool isOpen_ = false, heardPose_ = false;
  Told told_ = Told::nothing;
  IgtlStatus trouble_;
  double opened_s_ = 0.0, bytes_s_ = 0.0, message_s_ = 0.0, pose_s_ = 0.0, asked_s_ = 0.0, looked_s_ = 0.0, trouble_s_ = 0.0;
  double attempt_s_ = 0.0, pause_s_ = 0.0;
  std::map<std::string, Tool> tools_;
  std::vector<std::uint8_t> toSend_;
};

}  // namespace ew
