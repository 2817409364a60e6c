#include "backends.h"

#include <filesystem>

#ifdef EW_WITH_RTMIDI
#include <rtmidi/RtMidi.h>
#endif

namespace ew::controls {

std::string lastingPortName(const std::string& port) {
  std::string name = port;
  const auto colon = name.rfind(':'), space = name.rfind(' ');
  const bool isNumbered = colon != std::string::npos && space != std::string::npos && space < colon && space + 1 < colon &&
                          name.find_first_not_of("0123456789", space + 1) == colon && colon + 1 < name.size() &&
                          name.find_first_not_of("0123456789", colon + 1) == std::string::npos;
  if (isNumbered) name.erase(space);
  const auto between = name.find(':');
  if (between == std::string::npos) return name;
  const std::string client = name.substr(0, between), own = name.substr(between + 1);
  return own.starts_with(client) ? own : client + " " + own;
}

#ifdef EW_WITH_RTMIDI
namespace {

constexpr const char* kSequencer = "/dev/snd/seq";
constexpr const char* kClient = "EchoWeave";

void quiet(RtMidiError::Type, const std::string&, void*) {}

class MidiConnection final : public Connection {
 public:
  explicit MidiConnection(Backend::Take take) : take_(std::move(take)), in_(RtMidi::UNSPECIFIED, kClient) {
    in_.setErrorCallback(&quiet);
    in_.setCallback(
        [](double, std::vector<unsigned char>* message, void* self) {
          if (message != nullptr) static_cast<MidiConnection*>(self)->take_(*message);
        },
        this);
  }
  ~MidiConnection() override {
    in_.cancelCallback();
    in_.closePort();
  }
  void open(unsigned port) { in_.openPort(port, "controls"); }
  [[nodiscard]] bool isOpen() const { return in_.isPortOpen(); }
  /// One that is unplugged is no longer among the ports, which is how it is let go.
  [[nodiscard]] bool isLost() const override { return false; }

 private:
  Backend::Take take_;
  RtMidiIn in_;
};

class MidiBackend final : public Backend {
 public:
  Result<std::vector<Device>> devices() override {
    // Asked for without one, the library of the sequencer writes to the terminal each time.
    std::error_code ignored;
    if (!std::filesystem::exists(kSequencer, ignored))
      return failure(
          ErrorCode::notFound,
          say<"This computer has no MIDI: %1 is not there. Plug the control surface in; if it stays so, the kernel module snd-seq "
              "is missing (sudo modprobe snd-seq).">(verbatim(kSequencer)));
    try {
      RtMidiIn in(RtMidi::UNSPECIFIED, kClient);
      in.setErrorCallback(&quiet);
      std::vector<Device> found;
      for (unsigned port = 0; port < in.getPortCount(); ++port) {
        const std::string name = in.getPortName(port);
        if (name.empty() || name.starts_with("Midi Through") || name.starts_with(kClient)) continue;
        found.push_back({Device::Bus::midi, lastingPortName(name), name, 0, 0});
      }
      return found;
    } catch (const RtMidiError& problem) {
      return failure(ErrorCode::notReadable, say<"MIDI cannot be used: %1.">(problem.getMessage()));
    }
  }

  Result<std::unique_ptr<Connection>> open(const Device& device, Take take) override {
    try {
      auto made = std::make_unique<MidiConnection>(std::move(take));
      RtMidiIn in(RtMidi::UNSPECIFIED, kClient);
      for (unsigned port = 0; port < in.getPortCount(); ++port) {
        if (in.getPortName(port) != device.path) continue;
        made->open(port);
        if (made->isOpen()) return made;
      }
      return failure(
          ErrorCode::notReadable,
          say<"'%1' cannot be listened to; another program may have it. Close that program, or plug the device in again.">(device.name));
    } catch (const RtMidiError& problem) {
      return failure(ErrorCode::notReadable, say<"'%1' cannot be listened to (%2).">(device.name, problem.getMessage()));
    }
  }
};

}  // namespace

std::unique_ptr<Backend> midiBackend() { return std::make_unique<MidiBackend>(); }
#else
namespace {

class NoMidi final : public Backend {
 public:
  Result<std::vector<Device>> devices() override {
    return failure(ErrorCode::unsupported,
                   say<"This EchoWeave was built without MIDI; install librtmidi-dev and build it again to use such control surfaces.">());
  }
  Result<std::unique_ptr<Connection>> open(const Device&, Take) override { return passOn(devices().error()); }
};

}  // namespace

std::unique_ptr<Backend> midiBackend() { return std::make_unique<NoMidi>(); }
#endif

}  // namespace ew::controls
