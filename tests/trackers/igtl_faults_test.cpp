#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <set>

#include "ew/trackers/igtl_client.h"
#include "igtl_partners.h"

namespace ew {
namespace {

using test::Bytes;
using test::eventually;
using test::igtlPoseNumber;
using test::Partner;
using test::Watched;

IgtlSettings at(int port) {
  IgtlSettings settings;
  settings.port = port;
  return settings;
}

/// A server with a client that gets its poses, and the threads there were before.
struct Connected {
  explicit Connected(IgtlTiming timing = {}) : client(makeIgtlClient(at(server.port()), timing)) {
    works = server.accept() && server.send(test::transformMessage(igtlPoseNumber(0))) && client.getsPose(0);
  }
  /// After a fault, without anybody doing anything here.
  bool recovers(int n) { return server.accept() && server.send(test::transformMessage(igtlPoseNumber(n))) && client.getsPose(n); }

  Partner server;
  Watched client;
  bool works = false;
};

/// How long it took until the link was that, printed: how fast is told, but no machine is failed for being slow.
bool shows(Watched& client, LinkState link, const char* fault) {
  const auto took_s = eventually([&] { return client.link() == link; });
  if (took_s) std::cout << fault << ": shown after " << *took_s << " s: " << client.sentence() << "\n";
  return took_s.has_value();
}

TEST(IgtlFaults, SilenceIsShownAndWokenForAndItsEndToo) {
  Connected it;
  ASSERT_TRUE(it.works);
  const int before = it.client.news;
  EXPECT_TRUE(shows(it.client, LinkState::silent, "silence"));
  EXPECT_TRUE(eventually([&] { return it.client.news > before; }));
  EXPECT_TRUE(eventually([&] { return it.client.sentence().find("Nothing comes from") == 0; })) << it.client.sentence();
  ASSERT_TRUE(it.server.send(test::transformMessage(igtlPoseNumber(5))));
  EXPECT_TRUE(it.client.getsPose(5));
  EXPECT_EQ(it.client.sentence().find("Connected with"), 0u);
}

TEST(IgtlFaults, AServerThatHangsUpIsConnectedWithAgain) {
  Connected it;
  ASSERT_TRUE(it.works);
  it.server.hangUp();
  EXPECT_TRUE(shows(it.client, LinkState::connecting, "closed"));
  EXPECT_TRUE(it.recovers(7));
}

TEST(IgtlFaults, AServerThatCrashesIsConnectedWithAgain) {
  Connected it;
  ASSERT_TRUE(it.works);
  it.server.crash();
  EXPECT_TRUE(shows(it.client, LinkState::connecting, "reset"));
  EXPECT_TRUE(it.recovers(8));
}

TEST(IgtlFaults, AServerThatStartsLaterOrAgainOnItsPortIsFoundWithoutAClick) {
  auto server = std::make_unique<Partner>();
  const int port = server->port();
  server.reset();
  Watched client(makeIgtlClient(at(port)));
  EXPECT_TRUE(eventually([&] { return client.sentence().find("No server listens at localhost:") == 0; })) << client.sentence();
  for (int n = 1; n <= 3; ++n) {
    server = std::make_unique<Partner>(port);
    ASSERT_TRUE(server->isListening());
    ASSERT_TRUE(server->accept());
    ASSERT_TRUE(server->send(test::transformMessage(igtlPoseNumber(n))));
    EXPECT_TRUE(client.getsPose(n));
    server.reset();
    EXPECT_TRUE(shows(client, LinkState::connecting, "server ended"));
  }
}

TEST(IgtlFaults, ACableThatIsPulledIsFoundOutAndTheConnectionOpenedAnew) {
  Connected it;
  ASSERT_TRUE(it.works);
  if (!it.server.vanish()) GTEST_SKIP() << "to end a connection without a word needs rights this test has not";
  EXPECT_TRUE(shows(it.client, LinkState::silent, "vanished"));
  EXPECT_TRUE(shows(it.client, LinkState::connecting, "found out"));
  EXPECT_TRUE(it.recovers(9));
}

TEST(IgtlFaults, AServerThatHangsForLongIsConnectedWithAnew) {
  IgtlTiming timing;
  timing.anewAfter_s = 1.5;
  Connected it(timing);
  ASSERT_TRUE(it.works);
  EXPECT_TRUE(shows(it.client, LinkState::silent, "server hangs"));
  EXPECT_TRUE(it.recovers(10)) << "though the old connection was never closed";
}

TEST(IgtlFaults, ADamagedMessageGivesNoPoseAndTheNextOneIsRead) {
  Connected it;
  ASSERT_TRUE(it.works);
  Bytes damaged = igtlBytes(test::transformMessage(igtlPoseNumber(11)));
  damaged[kIgtlHeader_bytes + 40] ^= 1u;
  ASSERT_TRUE(it.server.send(damaged));
  ASSERT_TRUE(it.server.send(test::transformMessage(igtlPoseNumber(12))));
  EXPECT_TRUE(it.client.getsPose(12));
  EXPECT_EQ(it.client.readings.size(), 2u);
  EXPECT_EQ(it.client.device->status().refused, 1u);
  EXPECT_NE(it.client.device->status().lastRefusal.english().find("check sum"), std::string::npos);
}

TEST(IgtlFaults, AMessageThatIsCutAndAStreamOfRubbishAreFollowedByAFreshConnection) {
  Connected it;
  ASSERT_TRUE(it.works);
  Bytes cut = igtlBytes(test::transformMessage(igtlPoseNumber(13)));
  cut.resize(80);
  ASSERT_TRUE(it.server.send(cut));
  it.server.hangUp();
  EXPECT_TRUE(it.recovers(14));
  ASSERT_TRUE(it.server.send(Bytes(500, 0xee)));
  EXPECT_TRUE(shows(it.client, LinkState::connecting, "rubbish"));
  EXPECT_TRUE(it.recovers(15));
  EXPECT_EQ(it.client.readings.size(), 3u) << "nothing of it became a reading";
}

TEST(IgtlFaults, NumbersThatAreNoPoseAreInvalidAndNeverLive) {
  Connected it;
  ASSERT_TRUE(it.works);
  glm::dmat4 notANumber = igtlPoseNumber(1), skewed = igtlPoseNumber(1);
  notANumber[0][0] = std::nan("");
  skewed[1] += 0.1 * skewed[0];
  for (const glm::dmat4& bad : {notANumber, skewed, glm::dmat4(0.0), glm::dmat4(1.0)})
    ASSERT_TRUE(it.server.send(test::transformMessage(bad)));
  ASSERT_TRUE(it.server.send(test::transformMessage(igtlPoseNumber(16))));
  EXPECT_TRUE(it.client.getsPose(16));
  ASSERT_EQ(it.client.readings.size(), 6u);
  for (std::size_t n = 1; n < 5; ++n) EXPECT_EQ(it.client.readings[n].state, TrackingState::invalid) << n;
}

TEST(IgtlFaults, BytesThatTrickleInOneByOneAreReadWhole) {
  Connected it;
  ASSERT_TRUE(it.works);
  IgtlMessage message = test::transformMessage(igtlPoseNumber(17), "ProbeToTracker", 5.0, 2);
  message.words = {{"TransformStatus", "OK"}};
  for (const std::uint8_t byte : igtlBytes(message)) {
    ASSERT_TRUE(it.server.send(Bytes{byte}));
    test::sleep_s(0.001);
  }
  EXPECT_TRUE(it.client.getsPose(17));
}

TEST(IgtlFaults, LargeBodiesOfOtherTypesBetweenPosesAreNotHeldInMemory) {
  Connected it;
  ASSERT_TRUE(it.works);
  IgtlMessage video;
  video.type = "VIDEO";
  video.content.assign(std::size_t{24} << 20u, 3);
  const Bytes large = igtlBytes(video);
  const double before_mb = test::resident_mb();
  for (int n = 1; n <= 10; ++n) {
    ASSERT_TRUE(it.server.send(large));
    ASSERT_TRUE(it.server.send(test::transformMessage(igtlPoseNumber(20 + n))));
    ASSERT_TRUE(it.client.getsPose(20 + n));
  }
  EXPECT_LT(test::resident_mb() - before_mb, test::kFlat_mb) << "240 MB went by";
}

TEST(IgtlFaults, AThousandPosesASecondAllArriveInOrder) {
  Connected it;
  ASSERT_TRUE(it.works);
  const double begin_s = steadyNow_s();
  constexpr int kPoses = 3000;
  for (int n = 1; n <= kPoses; ++n) {
    ASSERT_TRUE(it.server.send(test::transformMessage(igtlPoseNumber(n), "ProbeToTracker", n)));
    if (n % 200 == 0) it.client.all();
    const double ahead_s = begin_s + n * 1e-3 - steadyNow_s();
    if (ahead_s > 0.0) test::sleep_s(ahead_s);
  }
  ASSERT_TRUE(eventually([&] { return it.client.all().size() == kPoses + 1u; }));
  for (std::size_t n = 1; n <= kPoses; ++n) ASSERT_EQ(it.client.readings[n].device_s, static_cast<double>(n));
  EXPECT_EQ(it.client.device->status().dropped, 0u);
}

TEST(IgtlFaults, AFloodThatNobodyTakesKeepsTheNewestInFlatMemory) {
  Connected it;
  ASSERT_TRUE(it.works);
  Bytes many;
  constexpr std::uint64_t kMany = 1000, kTimes = 300;
  for (std::uint64_t n = 0; n < kMany; ++n) test::append(many, igtlBytes(test::transformMessage(igtlPoseNumber(static_cast<int>(n)))));
  ASSERT_TRUE(it.server.send(many));
  const double before_mb = test::resident_mb(), begin_s = steadyNow_s();
  for (std::uint64_t n = 1; n < kTimes; ++n) ASSERT_TRUE(it.server.send(many));
  ASSERT_TRUE(eventually([&] { return it.client.device->status().readings == kMany * kTimes + 1; }));
  std::cout << static_cast<double>(kMany * kTimes) / (steadyNow_s() - begin_s) << " poses a second\n";
  EXPECT_LT(test::resident_mb() - before_mb, test::kFlat_mb);
  const auto left = it.client.device->take();
  EXPECT_EQ(left.size(), 4096u);
  EXPECT_LT(test::difference(left.back().toolToTracker.matrix, igtlPoseNumber(999)), 1e-4) << "the newest stays";
}

TEST(IgtlFaults, AnotherAddressIsAnotherClientAndTheOldOneEnds) {
  const std::size_t before = test::threadsNow();
  {
    Partner first, second;
    auto client = std::make_unique<Watched>(makeIgtlClient(at(first.port())));
    ASSERT_TRUE(first.accept());
    ASSERT_TRUE(first.send(test::transformMessage(igtlPoseNumber(1))));
    EXPECT_TRUE(client->getsPose(1));
    client = std::make_unique<Watched>(makeIgtlClient(at(second.port())));
    EXPECT_TRUE(first.isLeft()) << "the old connection is closed";
    ASSERT_TRUE(second.accept());
    ASSERT_TRUE(second.send(test::transformMessage(igtlPoseNumber(2))));
    EXPECT_TRUE(client->getsPose(2));
  }
  EXPECT_EQ(test::threadsNow(), before);
}

TEST(IgtlFaults, ANameOrAnAddressThatLeadsNowhereIsToldAndStopsAtOnce) {
  for (const char* host : {"no-such-computer.invalid", "192.0.2.1"}) {
    IgtlSettings settings;
    settings.host = host;
    Watched client(makeIgtlClient(settings));
    const auto told_s = eventually([&] { return client.sentence().find("tried again") != std::string::npos; }, 20.0);
    std::cout << host << ": " << (told_s ? client.sentence() : "no answer yet, which is no fault of the client") << "\n";
    EXPECT_EQ(client.link(), LinkState::connecting);
    const double begin_s = steadyNow_s();
    client.device->stop();
    std::cout << "stopped after " << steadyNow_s() - begin_s << " s\n";
    EXPECT_EQ(client.link(), LinkState::off);
  }
}

TEST(IgtlFaults, EveryFaultInTurnLeavesNoThreadAndNoDescriptor) {
  const auto descriptors = [] {
    std::size_t count = 0;
    for ([[maybe_unused]] const auto& one : std::filesystem::directory_iterator("/proc/self/fd")) ++count;
    return count;
  };
  const std::size_t threads = test::threadsNow(), files = descriptors();
  {
    Connected it;
    ASSERT_TRUE(it.works);
    for (int n = 0; n < 12; ++n) {
      switch (n % 4) {
        case 0:
          it.server.hangUp();
          break;
        case 1:
          it.server.crash();
          break;
        case 2:
          it.server.send(Bytes(100, 0xff));
          break;
        default:
          it.server.send(Bytes(30, 0));
          it.server.hangUp();
      }
      ASSERT_TRUE(it.recovers(30 + n)) << n;
    }
  }
  EXPECT_EQ(test::threadsNow(), threads);
  EXPECT_EQ(descriptors(), files);
}

}  // namespace
}  // namespace ew
