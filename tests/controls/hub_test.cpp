#include "ew/controls/hub.h"

#include <gtest/gtest.h>

#include <atomic>
#include <map>
#include <thread>

#include "backends.h"
#include "made_controls.h"

namespace ew::controls {
namespace {

using test::backendOf;
using Desk = test::MadeDesk;

TEST(Hub, OpensWhatIsWantedAgainAfterItWasUnplugged) {
  Desk desk;
  desk.plugged = {{Device::Bus::midi, "Desk", "Desk 20:0", 0, 0}, {Device::Bus::midi, "Other", "Other 24:0", 0, 0}};
  std::atomic<int> told = 0;
  Hub hub(backendOf(desk), [&] { ++told; });
  hub.lookNow();
  EXPECT_TRUE(hub.state().devices.empty());  // nothing is wanted: nothing is looked for
  hub.want({"Desk"}, false);
  hub.lookNow();
  EXPECT_EQ(hub.state().devices.size(), 2U);
  EXPECT_EQ(desk.opened, 1);
  desk.send("Desk 20:0", {0xB0, 7, 1, 7, 2});
  desk.send("Other 24:0", {0xB0, 7, 9});
  EXPECT_EQ(hub.takeEvents(),
            (std::vector<ControlEvent>{{{"Desk", ControlKind::midiControl, 1, 7}, 1}, {{"Desk", ControlKind::midiControl, 1, 7}, 2}}));
  EXPECT_TRUE(hub.takeEvents().empty());
  EXPECT_GE(told, 2);

  desk.plugged.erase(desk.plugged.begin());
  hub.lookNow();
  desk.send("Desk 20:0", {0xB0, 7, 3});
  EXPECT_TRUE(hub.takeEvents().empty());
  desk.plugged.push_back({Device::Bus::midi, "Desk", "Desk 28:0", 0, 0});
  hub.lookNow();
  EXPECT_EQ(desk.opened, 2);
  desk.send("Desk 28:0", {0xB0, 7, 4});
  EXPECT_EQ(hub.takeEvents().size(), 1U);

  hub.want({}, false);
  hub.lookNow();
  EXPECT_TRUE(desk.listening.empty());
}

TEST(Hub, TellsWhyADeviceCannotBeOpenedAndTriesAgain) {
  Desk desk;
  desk.plugged = {{Device::Bus::hid, "Shuttle", "/dev/hidraw9", 0x0b33, 0x20}};
  desk.refuses = true;
  Hub hub(backendOf(desk), [] {});
  hub.want({}, true);
  hub.lookNow();
  ASSERT_EQ(hub.state().problems.size(), 1U);
  EXPECT_EQ(hub.state().problems.front().sentence(), "taken");
  desk.refuses = false;
  hub.lookNow();
  EXPECT_TRUE(hub.state().problems.empty());
  desk.send("/dev/hidraw9", {0, 0, 0, 0, 0});
  desk.send("/dev/hidraw9", {0, 1, 0, 0, 0});
  EXPECT_EQ(hub.takeEvents(),
            (std::vector<ControlEvent>{{{"Shuttle", ControlKind::hidByte, 0, 1}, 1}, {{"Shuttle", ControlKind::hidBit, 0, 8}, 1}}));
}

TEST(Hub, TakesEventsFromManyThreadsAndLosesNone) {
  Desk desk;
  for (int n = 0; n < 4; ++n) desk.plugged.push_back({Device::Bus::midi, "Desk" + std::to_string(n), std::to_string(n), 0, 0});
  Hub hub(backendOf(desk), [] {});
  hub.want({}, true);
  hub.lookNow();
  std::vector<std::thread> playing;
  for (int n = 0; n < 4; ++n)
    playing.emplace_back([&desk, n] {
      for (int each = 0; each < 500; ++each) desk.send(std::to_string(n), {0xB0, 7, static_cast<std::uint8_t>(each % 128)});
    });
  for (std::thread& each : playing) each.join();
  std::map<std::string, int> counted;
  for (const ControlEvent& event : hub.takeEvents()) ++counted[event.id.device];
  EXPECT_EQ(counted, (std::map<std::string, int>{{"Desk0", 500}, {"Desk1", 500}, {"Desk2", 500}, {"Desk3", 500}}));
}

TEST(SystemBackends, SayInASentenceWhyThereIsNoMidi) {
  // Whatever this machine has: either devices, or a reason that ends with a full stop. No crash without /dev/snd.
  for (const auto& backend : systemBackends()) {
    const auto devices = backend->devices();
    if (devices) continue;
    EXPECT_TRUE(devices.error().sentence().ends_with('.')) << devices.error();
  }
  Hub hub(systemBackends(), [] {});
  hub.want({}, true);
  hub.lookNow();
  for (const Error& problem : hub.state().problems) EXPECT_TRUE(problem.sentence().ends_with('.')) << problem;
}

TEST(MidiPorts, KeepTheirNameWhenTheyArePluggedInAgain) {
  EXPECT_EQ(lastingPortName("nanoKONTROL2:nanoKONTROL2 _ CTRL 20:0"), "nanoKONTROL2 _ CTRL");
  EXPECT_EQ(lastingPortName("nanoKONTROL2:nanoKONTROL2 _ CTRL 128:12"), "nanoKONTROL2 _ CTRL");
  EXPECT_EQ(lastingPortName("X-TOUCH MINI:Port 1 24:0"), "X-TOUCH MINI Port 1");
  EXPECT_EQ(lastingPortName("Plain"), "Plain");
}

}  // namespace
}  // namespace ew::controls
