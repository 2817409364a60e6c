#pragma once

#include <compare>
#include <string>

namespace ew::controls {

/// What kind of thing sends its value.
enum class ControlKind {
  midiControl,    ///< a control change of 7 bits; number 0..127
  midiControl14,  ///< a pair of control changes, number and number + 32; number 0..31
  midiParameter,  ///< a non-registered parameter (NRPN), 14 bits; number 0..16383
  midiNote,       ///< a key or a pad; its value is the velocity, 0 when it is let go
  midiBend,       ///< pitch bend, 14 bits, as the faders of mixing desks send it; number 0
  hidByte,        ///< a byte of a report
  hidBit          ///< a bit of a report; number = 8 * byte + bit
};

/// One knob, fader, wheel or button.
struct ControlId {
  std::string device;  ///< as the device calls itself: "nanoKONTROL2"
  ControlKind kind = ControlKind::midiControl;
  int channel = 0;  ///< MIDI: 1..16; HID: the number of the report, 0 when its reports have none
  int number = 0;
  auto operator<=>(const ControlId&) const = default;  // NOLINT(modernize-use-nullptr): the 0 is the compiler's own
};

/// It was moved.
struct ControlEvent {
  ControlId id;
  int value = 0;  ///< 0..highestValue(id.kind)
  bool operator==(const ControlEvent&) const = default;
};

[[nodiscard]] int highestValue(ControlKind kind);
[[nodiscard]] int highestNumber(ControlKind kind);

}  // namespace ew::controls
