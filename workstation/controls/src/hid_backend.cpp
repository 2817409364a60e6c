#include "ew/controls/hid_parser.h"

#include "backends.h"

#ifdef EW_WITH_HIDAPI
#include <hidapi/hidapi.h>

#include <array>
#include <atomic>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <thread>
#endif

namespace ew::controls {

#ifdef EW_WITH_HIDAPI
namespace {

constexpr int kWait_ms = 100;

std::string utf8Of(const wchar_t* text) {
  std::string made;
  for (; text != nullptr && *text != 0; ++text) {
    const auto c = static_cast<unsigned>(*text);  // NOLINT(bugprone-signed-char-misuse): no letter is negative
    if (c < 0x80U) {
      made += static_cast<char>(c);
    } else if (c < 0x800U) {
      made += static_cast<char>(0xC0U | c >> 6U);
      made += static_cast<char>(0x80U | (c & 0x3FU));
    } else if (c < 0x10000U) {
      made += static_cast<char>(0xE0U | c >> 12U);
      made += static_cast<char>(0x80U | (c >> 6U & 0x3FU));
      made += static_cast<char>(0x80U | (c & 0x3FU));
    }
  }
  return made;
}

/// Keyboards (and foot pedals, which are such), mice and media keys reach the window as keys.
bool isOfTheSystem(const hid_device_info& info) {
  constexpr int kDesktop = 0x01, kConsumer = 0x0C;
  if (info.usage_page == kDesktop) return info.usage == 0x01 || info.usage == 0x02 || info.usage == 0x06 || info.usage == 0x07;
  return info.usage_page == kConsumer && info.vendor_id != kContourVendor;
}

class HidConnection final : public Connection {
 public:
  HidConnection(hid_device* device, Backend::Take take) : device_(device), take_(std::move(take)), reading_([this] { read(); }) {}
  ~HidConnection() override {
    ends_ = true;
    reading_.join();
    hid_close(device_);
  }
  [[nodiscard]] bool isLost() const override { return lost_; }

 private:
  void read() {
    std::array<unsigned char, 4096> report{};
    while (!ends_) {
      const int length = hid_read_timeout(device_, report.data(), report.size(), kWait_ms);
      if (length < 0) {
        lost_ = true;
        return;
      }
      if (length > 0) take_({report.data(), static_cast<std::size_t>(length)});
    }
  }

  hid_device* device_;
  Backend::Take take_;
  std::atomic<bool> ends_ = false, lost_ = false;
  std::thread reading_;
};

class HidBackend final : public Backend {
 public:
  ~HidBackend() override { hid_exit(); }

  Result<std::vector<Device>> devices() override {
    std::map<std::string, Device> found;
    std::map<std::string, bool> keeps;
    hid_device_info* all = hid_enumerate(0, 0);
    for (const hid_device_info* info = all; info != nullptr; info = info->next) {
      std::string name = utf8Of(info->product_string);
      if (name.empty()) name = "HID " + std::to_string(info->vendor_id) + ":" + std::to_string(info->product_id);
      found[info->path] = {Device::Bus::hid, std::move(name), info->path, info->vendor_id, info->product_id};
      const auto [kept, isNew] = keeps.try_emplace(info->path, true);
      kept->second = kept->second && !isOfTheSystem(*info);
    }
    hid_free_enumeration(all);
    std::vector<Device> devices;
    for (auto& [path, device] : found)
      if (keeps[path]) devices.push_back(std::move(device));
    return devices;
  }

  Result<std::unique_ptr<Connection>> open(const Device& device, Take take) override {
    hid_device* opened = hid_open_path(device.path.c_str());
    if (opened == nullptr)
      return failure(ErrorCode::notReadable,
                     say<"'%1' cannot be read (%2). Linux lets only root read such devices until a rule allows it; 'Keys and controls' in "
                         "the documentation has the line for it.">(device.name, device.path));
    return std::make_unique<HidConnection>(opened, std::move(take));
  }

  bool hasNumberedReports(const Device& device) const override {
    const std::filesystem::path node(device.path);
    std::ifstream in(std::filesystem::path("/sys/class/hidraw") / node.filename() / "device" / "report_descriptor", std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(in), {}};
    return numbersReports({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
  }
};

}  // namespace

std::unique_ptr<Backend> hidBackend() { return std::make_unique<HidBackend>(); }
#else
namespace {

class NoHid final : public Backend {
 public:
  Result<std::vector<Device>> devices() override {
    return failure(
        ErrorCode::unsupported,
        say<"This EchoWeave was built without HID; install libhidapi-dev and build it again to use jog dials and game controllers.">());
  }
  Result<std::unique_ptr<Connection>> open(const Device&, Take) override { return passOn(devices().error()); }
};

}  // namespace

std::unique_ptr<Backend> hidBackend() { return std::make_unique<NoHid>(); }
#endif

std::vector<std::unique_ptr<Backend>> systemBackends() {
  std::vector<std::unique_ptr<Backend>> backends;
  backends.push_back(midiBackend());
  backends.push_back(hidBackend());
  return backends;
}

}  // namespace ew::controls
