#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ew/controls/event.h"

namespace ew::controls {

/// The bytes of one MIDI input, in any pieces, to what was moved. Reads control changes, notes and pitch bend with running status;
/// real-time bytes may stand between any others; system exclusive and everything else is passed over. A pair of control changes n and n +
/// 32 gives, with the second, one more event of 14 bits; who chose a non-registered parameter (98, 99) gets its value (6, 38) in place of
/// theirs. Source: MIDI 1.0 Detailed Specification 4.2, pages 5 (running status), 11 (control changes) and 18 (parameters).
class MidiParser {
 public:
  explicit MidiParser(std::string device) : device_(std::move(device)) {}

  void take(std::span<const std::uint8_t> bytes, std::vector<ControlEvent>& events);

 private:
  struct Channel {
    std::array<std::optional<int>, 32> upper;  ///< of control changes 0..31
    std::optional<int> parameterUpper, parameterLower, dataUpper;
    [[nodiscard]] std::optional<int> parameter() const;
  };
  void message(std::vector<ControlEvent>& events);
  void controlChange(int number, int value, std::vector<ControlEvent>& events);
  void add(ControlKind kind, int number, int value, std::vector<ControlEvent>& events) const;

  std::string device_;
  std::array<Channel, 16> channels_;
  int status_ = 0;  ///< 0: data bytes belong to nothing that is read
  std::array<int, 2> data_{};
  int count_ = 0;
};

}  // namespace ew::controls
