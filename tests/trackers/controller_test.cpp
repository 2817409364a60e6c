#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <functional>
#include <mutex>
#include <thread>

#include "ew/trackers/hand_controller.h"

#if __has_include(<SDL2/SDL.h>)
#include <SDL2/SDL.h>
#endif

namespace ew::controller_test {
namespace {

namespace fs = std::filesystem;

bool waitUntil(const std::function<bool()>& isSo, double most_s = 20.0) {
  const double until_s = steadyNow_s() + most_s;
  while (!isSo()) {
    if (steadyNow_s() > until_s) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return true;
}

int threadsNow() {
  int count = 0;
  for ([[maybe_unused]] const auto& each : fs::directory_iterator("/proc/self/task")) ++count;
  return count;
}

/// What spacenavd says on its socket: packets of eight 32-bit numbers. The library asks for protocol 1 first; an old daemon does not
/// answer.
class MadeSpacenavd {
 public:
  MadeSpacenavd(const fs::path& socket, bool answers) : path_(socket), answers_(answers) {
    fs::remove(path_);
    listening_ = ::socket(AF_UNIX, SOCK_STREAM, 0);
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::strncpy(address.sun_path, path_.c_str(), sizeof address.sun_path - 1);
    EXPECT_EQ(bind(listening_, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    EXPECT_EQ(listen(listening_, 4), 0);
    serving_ = std::thread([this] { serve(); });
  }
  ~MadeSpacenavd() {
    ends_ = true;
    serving_.join();
    hangUp();
    close(listening_);
    fs::remove(path_);
  }
  MadeSpacenavd(const MadeSpacenavd&) = delete;
  MadeSpacenavd& operator=(const MadeSpacenavd&) = delete;

  bool isAsked() {
    const std::scoped_lock lock(mutex_);
    return client_ >= 0;
  }
  void hangUp() {
    const std::scoped_lock lock(mutex_);
    if (client_ >= 0) close(client_);
    client_ = -1;
  }
  void send(const std::array<std::int32_t, 8>& packet) {
    const std::scoped_lock lock(mutex_);
    if (client_ < 0) return;
    EXPECT_EQ(::send(client_, packet.data(), sizeof packet, MSG_NOSIGNAL), static_cast<ssize_t>(sizeof packet));
  }
  void move(std::int32_t x, std::int32_t y, std::int32_t z, std::int32_t rx, std::int32_t ry, std::int32_t rz) {
    send({0, x, y, z, rx, ry, rz, 16});
  }
  void press(int button, bool isDown) { send({isDown ? 1 : 2, button, 0, 0, 0, 0, 0, 0}); }
  void pullOut() { send({3, 1, 0, 0, 0, 0, 0, 0}); }

 private:
  void serve() {
    while (!ends_) {
      pollfd waits{listening_, POLLIN, 0};
      if (poll(&waits, 1, 20) <= 0) continue;
      const int client = accept(listening_, nullptr, nullptr);
      std::int32_t asked = 0;
      if (recv(client, &asked, sizeof asked, 0) == sizeof asked && answers_) ::send(client, &asked, sizeof asked, MSG_NOSIGNAL);
      const std::scoped_lock lock(mutex_);
      if (client_ >= 0) close(client_);
      client_ = client;
    }
  }

  fs::path path_;
  bool answers_;
  int listening_ = -1;
  std::mutex mutex_;
  int client_ = -1;
  std::atomic<bool> ends_ = false;
  std::thread serving_;
};

class SpaceMouseTest : public ::testing::Test {
 protected:
  SpaceMouseTest() : socket(fs::path(::testing::TempDir()) / ("ew_spnav_" + std::to_string(getpid()))) {
    setenv("SPNAV_SOCKET", socket.c_str(), 1);
  }
  ~SpaceMouseTest() override { unsetenv("SPNAV_SOCKET"); }
  void SetUp() override {
    const auto device = makeSpaceMouse();
    device->start();
    ASSERT_TRUE(waitUntil([&] { return device->status().link != LinkState::off; }));
    if (device->status().sentence.english().find("built without") != std::string::npos) GTEST_SKIP() << device->status().sentence;
    if (fs::exists("/var/run/spnav.sock") || fs::exists("/etc/spnavrc")) GTEST_SKIP() << "a spacenavd of this computer would answer";
  }
  fs::path socket;
};

}  // namespace

TEST_F(SpaceMouseTest, SaysThatTheDaemonDoesNotRunAndFindsItOnceItDoes) {
  const auto device = makeSpaceMouse();
  device->start();
  ASSERT_TRUE(waitUntil([&] { return device->status().link == LinkState::connecting; }));
  EXPECT_NE(device->status().sentence.english().find("spacenavd does not run"), std::string::npos);
  EXPECT_EQ(device->axes(), std::vector<double>(6, 0.0));
  MadeSpacenavd daemon(socket, true);
  ASSERT_TRUE(waitUntil([&] { return device->status().link == LinkState::connected; }));
}

TEST_F(SpaceMouseTest, GivesAxesAndButtonsOfDaemonsOfBothProtocols) {
  for (const bool answers : {true, false}) {
    MadeSpacenavd daemon(socket, answers);
    const auto device = makeSpaceMouse();
    std::atomic<int> news = 0;
    device->onNews([&] { ++news; });
    device->start();
    ASSERT_TRUE(waitUntil([&] { return device->status().link == LinkState::connected; }));
    daemon.move(350, -175, 35, 700, 0, -350);
    ASSERT_TRUE(waitUntil([&] { return device->axes() == std::vector<double>{1.0, -0.5, 0.1, 1.0, 0.0, -1.0}; }));
    daemon.press(1, true);
    ASSERT_TRUE(waitUntil([&] { return device->buttons() == std::vector<bool>{false, true}; }));
    daemon.press(1, false);
    daemon.move(0, 0, 0, 0, 0, 0);
    ASSERT_TRUE(waitUntil([&] { return device->axes() == std::vector<double>(6, 0.0); }));
    EXPECT_EQ(device->buttons(), (std::vector<bool>{false, false}));
    EXPECT_GE(news, 4);
    EXPECT_EQ(device->status().name, "SpaceMouse");
  }
}

TEST_F(SpaceMouseTest, RestsWhenItIsPulledOutOrTheDaemonEndsAndComesBackByItself) {
  auto daemon = std::make_unique<MadeSpacenavd>(socket, true);
  const auto device = makeSpaceMouse();
  device->start();
  ASSERT_TRUE(waitUntil([&] { return device->status().link == LinkState::connected; }));
  daemon->move(350, 0, 0, 0, 0, 0);
  ASSERT_TRUE(waitUntil([&] { return device->axes()[0] == 1.0; }));
  daemon->pullOut();
  ASSERT_TRUE(waitUntil([&] { return device->axes()[0] == 0.0; })) << "nobody pushes one that is not there";
  EXPECT_NE(device->status().sentence.english().find("pulled out"), std::string::npos);
  daemon->move(0, 350, 0, 0, 0, 0);
  ASSERT_TRUE(waitUntil([&] { return device->axes()[1] == 1.0; }));
  daemon.reset();
  ASSERT_TRUE(waitUntil([&] { return device->status().link == LinkState::connecting; }));
  EXPECT_EQ(device->axes(), std::vector<double>(6, 0.0));
  daemon = std::make_unique<MadeSpacenavd>(socket, true);
  ASSERT_TRUE(waitUntil([&] { return device->status().link == LinkState::connected; }));
  daemon->move(0, 0, 175, 0, 0, 0);
  ASSERT_TRUE(waitUntil([&] { return device->axes()[2] == 0.5; }));
}

TEST_F(SpaceMouseTest, LivesThroughADaemonThatHangsUpAtOnceAndThroughNonsense) {
  MadeSpacenavd daemon(socket, true);
  const auto device = makeSpaceMouse();
  device->start();
  for (int round = 0; round < 3; ++round) {
    ASSERT_TRUE(waitUntil([&] { return daemon.isAsked(); }));
    daemon.hangUp();
  }
  ASSERT_TRUE(waitUntil([&] { return daemon.isAsked() && device->status().link == LinkState::connected; }));
  daemon.send({-7, 1, 2, 3, 4, 5, 6, 7});
  daemon.send({99, 1, 2, 3, 4, 5, 6, 7});
  daemon.press(1 << 30, true);
  daemon.press(-5, true);
  daemon.move(-2147483647, 2147483647, 0, 0, 0, 35);
  ASSERT_TRUE(waitUntil([&] { return device->axes() == std::vector<double>{-1.0, 1.0, 0.0, 0.0, 0.0, 0.1}; }));
  EXPECT_TRUE(device->buttons().empty());
}

TEST_F(SpaceMouseTest, LeavesNoThreadBehindAndStartsAgain) {
  MadeSpacenavd daemon(socket, true);
  const int before = threadsNow();
  const auto device = makeSpaceMouse();
  for (int round = 0; round < 3; ++round) {
    device->start();
    device->start();
    ASSERT_TRUE(waitUntil([&] { return device->status().link == LinkState::connected; }));
    device->stop();
    EXPECT_EQ(device->status().link, LinkState::off);
    EXPECT_EQ(threadsNow(), before);
  }
}

#if __has_include(<SDL2/SDL.h>)
namespace {

/// A controller that SDL makes up: its own library reads it, as one that is plugged in.
class MadeController {
 public:
  MadeController() {
    SDL_LockJoysticks();
    index_ = SDL_JoystickAttachVirtual(SDL_JOYSTICK_TYPE_GAMECONTROLLER, SDL_CONTROLLER_AXIS_MAX, SDL_CONTROLLER_BUTTON_MAX, 0);
    if (index_ >= 0) joystick_ = SDL_JoystickOpen(index_);
    SDL_UnlockJoysticks();
  }
  ~MadeController() {
    if (joystick_ == nullptr) return;
    SDL_LockJoysticks();
    const SDL_JoystickID id = SDL_JoystickInstanceID(joystick_);
    SDL_JoystickClose(joystick_);
    for (int index = 0; index < SDL_NumJoysticks(); ++index)
      if (SDL_JoystickGetDeviceInstanceID(index) == id) SDL_JoystickDetachVirtual(index);
    SDL_UnlockJoysticks();
  }
  MadeController(const MadeController&) = delete;
  MadeController& operator=(const MadeController&) = delete;
  [[nodiscard]] bool isThere() const { return joystick_ != nullptr; }
  void push(int axis, Sint16 value) { SDL_JoystickSetVirtualAxis(joystick_, axis, value); }
  void press(int button, bool isDown) { SDL_JoystickSetVirtualButton(joystick_, button, isDown ? 1 : 0); }

 private:
  int index_ = -1;
  SDL_Joystick* joystick_ = nullptr;
};

class GameControllerTest : public ::testing::Test {
 protected:
  GameControllerTest() : device(makeGameController()) {}
  void SetUp() override {
    device->start();
    ASSERT_TRUE(waitUntil([&] { return device->status().link != LinkState::off; }));
    const std::string sentence = device->status().sentence.english();
    if (sentence.find("built without") != std::string::npos) GTEST_SKIP() << sentence;
    // A controller of this computer would be taken first.
    if (device->status().link == LinkState::connected) GTEST_SKIP() << "a game controller is plugged in: " << device->status().name;
  }
  std::unique_ptr<AxisDevice> device;
};

}  // namespace

TEST_F(GameControllerTest, FindsAControllerThatIsPluggedInAndGivesItsAxesAndButtons) {
  EXPECT_EQ(device->status().link, LinkState::connecting);
  EXPECT_NE(device->status().sentence.english().find("No game controller"), std::string::npos);
  MadeController controller;
  if (!controller.isThere()) GTEST_SKIP() << "SDL makes no virtual controllers here: " << SDL_GetError();
  ASSERT_TRUE(waitUntil([&] { return device->status().link == LinkState::connected; }));
  EXPECT_FALSE(device->status().name.empty());
  controller.push(SDL_CONTROLLER_AXIS_TRIGGERLEFT, -32768);
  controller.push(SDL_CONTROLLER_AXIS_TRIGGERRIGHT, -32768);
  controller.push(SDL_CONTROLLER_AXIS_LEFTX, 32767);
  controller.push(SDL_CONTROLLER_AXIS_LEFTY, -32768);
  controller.push(SDL_CONTROLLER_AXIS_RIGHTX, 16384);
  ASSERT_TRUE(waitUntil([&] {
    const auto axes = device->axes();
    return axes[0] == 1.0 && axes[1] == -1.0 && std::abs(axes[2] - 0.5) < 0.001;
  }));
  EXPECT_EQ(device->axes()[4], 0.0) << "both triggers are up";
  controller.push(SDL_CONTROLLER_AXIS_TRIGGERRIGHT, 32767);
  ASSERT_TRUE(waitUntil([&] { return device->axes()[4] > 0.9; }));
  controller.press(SDL_CONTROLLER_BUTTON_LEFTSHOULDER, true);
  ASSERT_TRUE(waitUntil([&] { return device->axes()[5] == -1.0; }));
  EXPECT_TRUE(device->buttons()[SDL_CONTROLLER_BUTTON_LEFTSHOULDER]);
  EXPECT_FALSE(device->buttons()[SDL_CONTROLLER_BUTTON_A]);
}

TEST_F(GameControllerTest, RestsWhenTheControllerIsPulledOutAndTakesTheNextOne) {
  {
    MadeController first;
    if (!first.isThere()) GTEST_SKIP() << "SDL makes no virtual controllers here: " << SDL_GetError();
    ASSERT_TRUE(waitUntil([&] { return device->status().link == LinkState::connected; }));
    first.push(SDL_CONTROLLER_AXIS_LEFTX, 32767);
    ASSERT_TRUE(waitUntil([&] { return device->axes()[0] == 1.0; }));
  }
  ASSERT_TRUE(waitUntil([&] { return device->status().link == LinkState::connecting; }));
  EXPECT_EQ(device->axes(), std::vector<double>(6, 0.0));
  MadeController second;
  ASSERT_TRUE(waitUntil([&] { return device->status().link == LinkState::connected; }));
  second.push(SDL_CONTROLLER_AXIS_LEFTY, 32767);
  ASSERT_TRUE(waitUntil([&] { return device->axes()[1] == 1.0; }));
}

TEST_F(GameControllerTest, LeavesNoThreadBehindAndStartsAgain) {
  device->stop();
  const int before = threadsNow();
  for (int round = 0; round < 3; ++round) {
    device->start();
    ASSERT_TRUE(waitUntil([&] { return device->status().link == LinkState::connecting; }));
    device->stop();
    EXPECT_EQ(device->status().link, LinkState::off);
    EXPECT_EQ(threadsNow(), before);
  }
}
#endif

}  // namespace ew::controller_test
