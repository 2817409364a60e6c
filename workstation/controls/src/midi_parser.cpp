#include "ew/controls/midi_parser.h"

namespace ew::controls {
namespace {

constexpr int kNoteOff = 0x8, kNoteOn = 0x9, kControlChange = 0xB, kPitchBend = 0xE;
constexpr int kNull = 127;  // both halves: no parameter is chosen

int dataBytesOf(int status) {
  const int kind = status >> 4;
  return kind == 0xC || kind == 0xD ? 1 : 2;
}

}  // namespace

std::optional<int> MidiParser::Channel::parameter() const {
  if (!parameterUpper || !parameterLower || (*parameterUpper == kNull && *parameterLower == kNull)) return std::nullopt;
  return *parameterUpper << 7 | *parameterLower;
}

void MidiParser::take(std::span<const std::uint8_t> bytes, std::vector<ControlEvent>& events) {
  for (const std::uint8_t byte : bytes) {
    if (byte >= 0xF8) continue;  // clock and the like
    if (byte >= 0x80) {
      status_ = byte < 0xF0 ? byte : 0;  // system messages end running status
      count_ = 0;
      continue;
    }
    if (status_ == 0) continue;
    data_[static_cast<std::size_t>(count_++)] = byte;
    if (count_ < dataBytesOf(status_)) continue;
    count_ = 0;
    message(events);
  }
}

void MidiParser::add(ControlKind kind, int number, int value, std::vector<ControlEvent>& events) const {
  events.push_back({{device_, kind, (status_ & 0xF) + 1, number}, value});
}

void MidiParser::message(std::vector<ControlEvent>& events) {
  switch (status_ >> 4) {
    case kNoteOff:
      return add(ControlKind::midiNote, data_[0], 0, events);
    case kNoteOn:
      return add(ControlKind::midiNote, data_[0], data_[1], events);
    case kControlChange:
      return controlChange(data_[0], data_[1], events);
    case kPitchBend:
      return add(ControlKind::midiBend, 0, data_[1] << 7 | data_[0], events);
    default:
      return;
  }
}

void MidiParser::controlChange(int number, int value, std::vector<ControlEvent>& events) {
  Channel& channel = channels_[static_cast<std::size_t>(status_ & 0xF)];
  if (number >= 120) return;  // channel mode messages: all notes off and the like
  switch (number) {
    case 99:
      channel.parameterUpper = value;
      channel.dataUpper.reset();
      return;
    case 98:
      channel.parameterLower = value;
      channel.dataUpper.reset();
      return;
    case 100:  // a registered parameter is none of ours
    case 101:
      channel.parameterUpper.reset();
      channel.parameterLower.reset();
      return;
    case 6:
      if (const auto parameter = channel.parameter()) {
        channel.dataUpper = value;
        return add(ControlKind::midiParameter, *parameter, value << 7, events);
      }
      break;
    case 38:
      if (const auto parameter = channel.parameter(); parameter && channel.dataUpper)
        return add(ControlKind::midiParameter, *parameter, *channel.dataUpper << 7 | value, events);
      break;
    default:
      break;
  }
  add(ControlKind::midiControl, number, value, events);
  if (number < 32) channel.upper[static_cast<std::size_t>(number)] = value;
  if (number < 32 || number >= 64) return;
  if (const auto upper = channel.upper[static_cast<std::size_t>(number - 32)])
    add(ControlKind::midiControl14, number - 32, *upper << 7 | value, events);
}

}  // namespace ew::controls
