#include "hand_controller_thread.h"

#ifdef EW_WITH_SPNAV
#include <poll.h>
#include <pthread.h>
#include <spnav.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#endif

namespace ew {

#ifdef EW_WITH_SPNAV
namespace {

constexpr double kLookForDaemon_s = 1.0;
constexpr double kFullCounts = 350.0;  ///< what every SpaceMouse gives at its stop
constexpr int kMostButtons = 64;

/// libspnav has one connection for the whole program.
std::mutex& spaceMouseConnection() {
  static std::mutex connection;
  return connection;
}

/// Each call of spnav_open() that fails leaves a little memory behind, so that it is not called while there is clearly nobody to answer.
bool mayHaveDaemon() {
  std::error_code ignored;
  const char* given = std::getenv("SPNAV_SOCKET");
  return (given != nullptr && std::filesystem::exists(given, ignored)) || std::filesystem::exists("/etc/spnavrc", ignored) ||
         std::filesystem::exists("/var/run/spnav.sock", ignored);
}

class SpaceMouse final : public AxisDeviceThread {
 public:
  SpaceMouse() : wake_(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {}
  ~SpaceMouse() override {
    SpaceMouse::stop();
    close(wake_);
  }

 protected:
  void wake() override {
    constexpr std::uint64_t kOne = 1;
    static_cast<void>(!write(wake_, &kOne, sizeof kOne));
  }

  void run() override {
    // The library writes to a daemon that may just have gone; the signal of that would end the program.
    sigset_t pipe;
    sigemptyset(&pipe);
    sigaddset(&pipe, SIGPIPE);
    pthread_sigmask(SIG_BLOCK, &pipe, nullptr);
    std::uint64_t old = 0;
    static_cast<void>(!read(wake_, &old, sizeof old));
    while (!ends()) {
      std::unique_lock connection(spaceMouseConnection(), std::try_to_lock);
      if (!connection) {
        rest({LinkState::connecting, say<"Another part of the program uses the SpaceMouse.">(), {}});
      } else if (!mayHaveDaemon() || spnav_open() == -1) {
        rest({LinkState::connecting,
              say<"The program spacenavd does not run, without which no SpaceMouse can be read; install the package 'spacenavd' and start "
                  "it.">(),
              {}});
      } else {
        listen();
        spnav_close();
      }
      connection = {};
      pause(kLookForDaemon_s);
    }
  }

 private:
  void listen() {
    moved_.fill(0.0);
    pressed_.clear();
    // Whether a SpaceMouse is plugged in is not asked: the library waits for ever for an answer of a daemon that is gone.
    rest({LinkState::connected, say<"spacenavd runs; push the SpaceMouse.">(), {}});
    while (!ends()) {
      std::array<pollfd, 2> waits{pollfd{spnav_fd(), POLLIN, 0}, pollfd{wake_, POLLIN, 0}};
      if (poll(waits.data(), waits.size(), -1) < 0 && errno != EINTR) return;
      if (ends()) return;
      if (waits[0].revents == 0) continue;
      char byte = 0;
      if (recv(spnav_fd(), &byte, 1, MSG_PEEK | MSG_DONTWAIT) == 0) return;
      if ((waits[0].revents & (POLLERR | POLLNVAL)) != 0) return;
      spnav_event event{};
      if (spnav_poll_event(&event) > 0) take(event);
    }
  }

  void take(const spnav_event& event) {
    if (event.type == SPNAV_EVENT_DEV) {
      moved_.fill(0.0);
      if (event.dev.op == SPNAV_DEV_RM)
        rest({LinkState::connected, say<"The SpaceMouse was pulled out; plug it in again.">(), {}});
      else
        rest({LinkState::connected, say<"spacenavd runs; push the SpaceMouse.">(), {}});
      return;
    }
    if (event.type == SPNAV_EVENT_MOTION) {
      const int counts[] = {event.motion.x, event.motion.y, event.motion.z, event.motion.rx, event.motion.ry, event.motion.rz};
      for (std::size_t n = 0; n < kAxes; ++n) moved_[n] = std::clamp(counts[n] / kFullCounts, -1.0, 1.0);
    } else if (event.type == SPNAV_EVENT_BUTTON) {
      const int number = event.button.bnum;
      if (number < 0 || number >= kMostButtons) return;
      const auto index = static_cast<std::size_t>(number);
      if (pressed_.size() <= index) pressed_.resize(index + 1);
      pressed_[index] = event.button.press != 0;
    } else {
      return;
    }
    put({moved_.begin(), moved_.end()}, pressed_);
    putStatus({LinkState::connected, say<"The SpaceMouse moves the probe.">(), "SpaceMouse"});
  }

  int wake_;
  std::array<double, kAxes> moved_{};
  std::vector<bool> pressed_;
};

}  // namespace

std::unique_ptr<AxisDevice> makeSpaceMouse() { return std::make_unique<SpaceMouse>(); }
#else
namespace {

class NoSpaceMouse final : public AxisDeviceThread {
 public:
  ~NoSpaceMouse() override { NoSpaceMouse::stop(); }

 protected:
  void run() override {
    rest({LinkState::connecting,
          say<"This EchoWeave was built without SpaceMouse; install libspnav-dev and build it again to use one.">(),
          {}});
    while (!ends()) pause(1.0);
  }
};

}  // namespace

std::unique_ptr<AxisDevice> makeSpaceMouse() { return std::make_unique<NoSpaceMouse>(); }
#endif

}  // namespace ew
