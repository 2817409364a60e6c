#pragma once

#include <optional>
#include <span>
#include <utility>

namespace ew::review {

inline constexpr double kSlowest = 0.25, kFastest = 4.0;

/// The part of a recording that is reviewed, on the recording's own clock.
struct Part {
  double begin_s = 0.0;
  double end_s = 0.0;
  [[nodiscard]] double length_s() const { return end_s - begin_s; }
  bool operator==(const Part&) const = default;
};

enum class AtEnd {
  rest,       ///< stays at the end
  beginAnew,  ///< and goes on from the beginning
};

/// The clock of a review: where it stands between two moments, whether it runs, and how fast. A value without a clock of its own: whoever
/// has one tells how much time has passed.
class ReviewClock {
 public:
  /// What there is to see. Where it stands is kept as far as it lies within; a loop that does not is given up.
  /// @param first_s <= last_s
  void setRange(double first_s, double last_s);
  [[nodiscard]] double first_s() const { return first_s_; }
  [[nodiscard]] double last_s() const { return last_s_; }
  [[nodiscard]] double at_s() const { return at_s_; }

  /// From where it stands; from the beginning (of the loop) when it stands at the end and would rest there.
  void play();
  void pause() { playing_ = false; }
  [[nodiscard]] bool isPlaying() const { return playing_; }
  /// @param speed 1: as it was recorded; brought within kSlowest and kFastest
  void setSpeed(double speed);
  [[nodiscard]] double speed() const { return speed_; }
  void setAtEnd(AtEnd end) { atEnd_ = end; }
  [[nodiscard]] AtEnd atEnd() const { return atEnd_; }

  /// Goes there, within what there is; it runs on when it ran.
  void seek(double time_s);
  /// To the nearest of `events_s` after where it stands, or before it; stays when there is none. What lies nearer than 1 ms is where it
  /// stands. @param events_s in any order @return whether there was one
  bool jump(std::span<const double> events_s, bool forward);

  /// A loop's beginning (A) or end (B) is where it stands; the same place again takes the mark away, and a mark on the wrong side of the
  /// other takes the other away.
  void markBegin();
  void markEnd();
  void setLoop(std::optional<double> begin_s, std::optional<double> end_s);
  [[nodiscard]] std::optional<double> loopBegin_s() const { return loopBegin_s_; }
  [[nodiscard]] std::optional<double> loopEnd_s() const { return loopEnd_s_; }
  /// Both ends of a loop are marked.
  [[nodiscard]] bool isLooping() const { return loopBegin_s_ && loopEnd_s_; }

  /// So much time has passed outside. In a loop, and with AtEnd::beginAnew, what is beyond the end goes on from the beginning.
  void advance(double passed_s);

 private:
  double first_s_ = 0.0, last_s_ = 0.0, at_s_ = 0.0, speed_ = 1.0;
  bool playing_ = false;
  AtEnd atEnd_ = AtEnd::rest;
  std::optional<double> loopBegin_s_, loopEnd_s_;
};

}  // namespace ew::review
