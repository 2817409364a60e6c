#include "ew/trackers/igtl_session.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "igtl_messages.h"

namespace ew {
namespace {

using test::append;
using test::Bytes;

/// A session on a clock that the test moves.
struct Simulated {
  explicit Simulated(IgtlSettings settings = {}, IgtlTiming timing = {}) : session(std::move(settings), timing, queue) {
    queue.onNews([this] { ++news; });
  }
  /// Lets time pass as the client does: tick by tick.
  bool until(double time_s) {
    while (session.tick_s() < time_s) {
      now_s = std::max(now_s, session.tick_s());
      if (!session.tick(now_s)) return false;
    }
    now_s = time_s;
    return true;
  }
  bool hear(const Bytes& bytes) { return session.received(bytes, now_s); }
  bool hear(const IgtlMessage& message) { return hear(igtlBytes(message)); }
  LinkState link() const { return queue.status(now_s).link; }
  std::string sentence() const { return queue.status(now_s).sentence.english(); }
  std::vector<TrackingState> statesOf(const std::string& tool) {
    std::vector<TrackingState> states;
    for (const ToolReading& reading : queue.take())
      if (reading.tool == tool) states.push_back(reading.state);
    return states;
  }

  ReadingQueue queue;
  int news = 0;
  IgtlSession session;
  // The queue notes by steadyNow_s() when it was connected.
  double now_s = steadyNow_s();
};

TEST(IgtlSession, PosesBecomeReadingsWithBothTimes) {
  Simulated it;
  it.session.opened(it.now_s);
  it.now_s += 0.01;
  ASSERT_TRUE(it.hear(test::transformMessage(test::igtlPoseNumber(3), "ProbeToTracker", 1234.5)));
  const auto readings = it.queue.take();
  ASSERT_EQ(readings.size(), 1u);
  EXPECT_EQ(readings[0].tool, "ProbeToTracker");
  EXPECT_EQ(readings[0].device_s, 1234.5);
  EXPECT_EQ(readings[0].arrival_s, it.now_s);
  EXPECT_EQ(readings[0].state, TrackingState::live);
  EXPECT_EQ(it.link(), LinkState::connected);
}

TEST(IgtlSession, SilenceIsToldWithinSixTenthsOfASecondAndSoIsItsEnd) {
  Simulated it;
  it.session.opened(it.now_s);
  ASSERT_TRUE(it.hear(test::transformMessage(test::igtlPoseNumber(1))));
  const double begun_s = it.now_s;
  ASSERT_TRUE(it.until(begun_s + 0.49));
  const int before = it.news;
  EXPECT_EQ(it.link(), LinkState::connected);
  ASSERT_TRUE(it.until(begun_s + 0.6));
  EXPECT_GT(it.news, before) << "who waits for news is woken";
  EXPECT_EQ(it.link(), LinkState::silent);
  EXPECT_EQ(it.sentence(), "Nothing comes from localhost:18944 any more; check that the tracker and its server still run.");
  ASSERT_TRUE(it.hear(test::transformMessage(test::igtlPoseNumber(2))));
  EXPECT_EQ(it.link(), LinkState::connected);
  EXPECT_EQ(it.sentence(), "Connected with localhost:18944.");
}

TEST(IgtlSession, AToolThatPlusLeavesOutIsOutOfViewWhileTheServerTalks) {
  Simulated it;
  it.session.opened(it.now_s);
  ASSERT_TRUE(it.hear(test::transformMessage(test::igtlPoseNumber(1))));
  EXPECT_EQ(it.statesOf("ProbeToTracker"), std::vector{TrackingState::live});
  for (int n = 0; n < 8; ++n) {  // PLUS: STATUS each quarter of a second when nothing else is sent
    ASSERT_TRUE(it.until(it.now_s + 0.25));
    ASSERT_TRUE(it.hear(test::statusMessage(1)));
  }
  const auto states = it.statesOf("ProbeToTracker");
  EXPECT_GE(states.size(), 6u);
  EXPECT_EQ(std::set(states.begin(), states.end()), std::set{TrackingState::outOfView});
  EXPECT_EQ(it.link(), LinkState::connected) << "the server is there: this is no silence";
  EXPECT_NE(it.sentence().find("bring the tools back into the tracker's view"), std::string::npos) << it.sentence();
}

TEST(IgtlSession, OneToolOfSeveralThatIsLeftOutIsOutOfView) {
  Simulated it;
  it.session.opened(it.now_s);
  ASSERT_TRUE(it.hear(test::transformMessage(test::igtlPoseNumber(1), "Probe")));
  for (int n = 0; n < 40; ++n) {
    ASSERT_TRUE(it.until(it.now_s + 0.05));
    ASSERT_TRUE(it.hear(test::transformMessage(test::igtlPoseNumber(n), "Reference")));
  }
  const auto readings = it.queue.take();
  EXPECT_EQ(std::count_if(readings.begin(), readings.end(), [](const ToolReading& one) { return one.tool == "Reference"; }), 40);
  const auto missing = std::count_if(readings.begin(), readings.end(),
                                     [](const ToolReading& one) { return one.tool == "Probe" && one.state == TrackingState::outOfView; });
  EXPECT_GE(missing, 5);
  EXPECT_LE(missing, 8);
}

TEST(IgtlSession, AToolThatIsMissingFromAListIsOutOfViewAtOnce) {
  Simulated it;
  it.session.opened(it.now_s);
  ASSERT_TRUE(it.hear(test::trackingMessage({"Probe", "Reference"})));
  ASSERT_TRUE(it.hear(test::trackingMessage({"Reference"}, 1)));
  ASSERT_TRUE(it.hear(test::trackingMessage({}, 2)));
  ASSERT_TRUE(it.hear(test::trackingMessage({"Probe"}, 3)));
  EXPECT_EQ(it.statesOf("Probe"),
            (std::vector{TrackingState::live, TrackingState::outOfView, TrackingState::outOfView, TrackingState::live}));
}

TEST(IgtlSession, AServerThatSaysWhatIsWrongIsQuotedUntilItIsWellAgain) {
  Simulated it;
  it.session.opened(it.now_s);
  ASSERT_TRUE(it.hear(test::statusMessage(7, "no answer on port 3")));
  EXPECT_NE(it.sentence().find("no answer on port 3"), std::string::npos) << it.sentence();
  ASSERT_TRUE(it.until(it.now_s + 0.25));
  ASSERT_TRUE(it.hear(test::statusMessage(18, "laser")));
  EXPECT_NE(it.sentence().find("broken"), std::string::npos) << it.sentence();
  ASSERT_TRUE(it.hear(test::statusMessage(1)));
  EXPECT_EQ(it.sentence().find("broken"), std::string::npos) << it.sentence();
  ASSERT_TRUE(it.hear(test::transformMessage(test::igtlPoseNumber(1))));
  EXPECT_EQ(it.sentence(), "Connected with localhost:18944.");
}

TEST(IgtlSession, ASingleComplaintIsOverWhenPosesKeepComing) {
  Simulated it;
  it.session.opened(it.now_s);
  ASSERT_TRUE(it.hear(test::statusMessage(12, "STT_TDATA?")));
  for (int n = 0; n < 30; ++n) {
    ASSERT_TRUE(it.until(it.now_s + 0.1));
    ASSERT_TRUE(it.hear(test::transformMessage(test::igtlPoseNumber(n))));
  }
  EXPECT_EQ(it.sentence(), "Connected with localhost:18944.");
}

TEST(IgtlSession, AServerThatWaitsToBeAskedIsAskedForItsTools) {
  Simulated it;
  it.session.opened(it.now_s);
  EXPECT_TRUE(it.session.takeToSend().empty());
  ASSERT_TRUE(it.until(it.now_s + 1.1));
  const Bytes asked = it.session.takeToSend();
  ASSERT_EQ(asked.size(), kIgtlHeader_bytes + 36);
  EXPECT_EQ(std::string(reinterpret_cast<const char*>(asked.data()) + 2), "STT_TDATA");
  ASSERT_TRUE(it.hear(test::trackingMessage({"Probe"})));
  ASSERT_TRUE(it.until(it.now_s + 10.0));
  EXPECT_TRUE(it.session.takeToSend().empty()) << "and not again once poses came";
}

TEST(IgtlSession, Version3IsSpokenFirstOnlyWhereItIsWished) {
  Simulated it({.speaksVersion3 = true});
  it.session.opened(it.now_s);
  const Bytes asked = it.session.takeToSend();
  ASSERT_GE(asked.size(), kIgtlHeader_bytes);
  EXPECT_EQ(asked[1], 2);
}

TEST(IgtlSession, WhatIsNoPoseIsAReadingAndARefusalInWords) {
  Simulated it;
  it.session.opened(it.now_s);
  glm::dmat4 none = test::igtlPoseNumber(1);
  none[0][0] = std::numeric_limits<double>::quiet_NaN();
  ASSERT_TRUE(it.hear(test::transformMessage(none)));
  ASSERT_TRUE(it.hear(test::transformMessage(glm::dmat4(1.0))));
  EXPECT_EQ(it.statesOf("ProbeToTracker"), (std::vector{TrackingState::invalid, TrackingState::invalid}));
  EXPECT_EQ(it.queue.status().refused, 2u);
  EXPECT_NE(it.queue.status().lastRefusal.english().find("identity"), std::string::npos);
}

TEST(IgtlSession, PausesBetweenAttemptsGrowAndShrinkOnlyWhenAMessageCame) {
  Simulated it;
  const auto pauseAfterFailure = [&it] {
    it.session.closed(it.now_s, verbatim("no"));
    return it.session.attempt_s() - it.now_s;
  };
  for (double expected : {0.5, 1.0, 2.0, 4.0, 5.0, 5.0}) EXPECT_NEAR(pauseAfterFailure(), expected, 1e-6);
  it.session.opened(it.now_s);
  EXPECT_NEAR(pauseAfterFailure(), 5.0, 1e-6) << "a server that hangs up at once is not hammered";
  it.session.opened(it.now_s);
  ASSERT_TRUE(it.hear(test::statusMessage(1)));
  EXPECT_NEAR(pauseAfterFailure(), 0.5, 1e-6);
  EXPECT_EQ(it.link(), LinkState::connecting);
}

TEST(IgtlSession, AConnectionThatIsSilentForLongOrLostItsStepIsOpenedAnew) {
  Simulated it;
  it.session.opened(it.now_s);
  ASSERT_TRUE(it.hear(test::statusMessage(1)));
  EXPECT_FALSE(it.until(it.now_s + 15.1));
  EXPECT_EQ(it.link(), LinkState::connecting);

  it.session.opened(it.now_s);
  IgtlMessage video;
  video.type = "VIDEO";
  Bytes endless = igtlBytes(video);
  endless[46] = 0x7f;  // two gigabytes that never end
  ASSERT_TRUE(it.hear(endless));
  bool isOpen = true;
  for (int n = 0; n < 200 && isOpen; ++n) isOpen = it.until(it.now_s + 0.1) && it.hear(Bytes(100, 1));
  EXPECT_FALSE(isOpen);
  EXPECT_EQ(it.link(), LinkState::connecting);

  it.session.opened(it.now_s);
  EXPECT_FALSE(it.hear(Bytes(100, 0xff)));
  EXPECT_EQ(it.link(), LinkState::connecting);
  EXPECT_EQ(it.queue.status().refused, 1u);
}

TEST(IgtlSession, ATickAtItsTimeDoesWhatIsDueAtEveryHourOfAComputersClock) {
  std::mt19937 random(38);
  for (int n = 0; n < 4000; ++n) {
    Simulated it;
    it.now_s = std::exp(std::uniform_real_distribution<double>(0.0, std::log(4e7))(random));  // a second to a year since it started
    it.session.opened(it.now_s);
    it.now_s += 0.01;
    Bytes heard;
    if (n % 4 != 0) heard = igtlBytes(test::statusMessage(n % 4 == 1 ? 12 : 1));
    if (n % 4 == 3) append(heard, igtlBytes(test::transformMessage(test::igtlPoseNumber(n))));
    if (n % 8 >= 4) heard.insert(heard.end(), 20, 1);  // a message that never ends
    ASSERT_TRUE(it.hear(heard));
    for (bool isOpen = true; isOpen;) {
      const double due_s = it.session.tick_s();
      ASSERT_GT(due_s, it.now_s) << "due for ever at " << std::hexfloat << due_s;
      it.now_s = due_s;
      isOpen = it.session.tick(due_s);
    }
  }
}

TEST(IgtlSession, AStreamOfMadeUpNamesDoesNotFillTheMemory) {
  Simulated it;
  it.session.opened(it.now_s);
  for (int n = 0; n < 20000; ++n) ASSERT_TRUE(it.hear(test::transformMessage(test::igtlPoseNumber(n), "Tool" + std::to_string(n))));
  EXPECT_LT(it.session.held_bytes(), 20000u);
  EXPECT_LE(it.queue.take().size(), 4096u);
}

/// Eight hours of a working day at 60 poses a second, with everything that goes wrong in one: the real reader, session and queue on a clock
/// that runs as fast as the machine does.
TEST(IgtlSession, EightHoursWithEveryFaultLeaveMemoryFlatAndEndLive) {
  Simulated it;
  std::mt19937 random(19);
  std::set<LinkState> links;
  std::set<TrackingState> states;
  std::uint64_t poses = 0, taken = 0, connections = 0;
  std::size_t mostHeld_bytes = 0, mostWaiting = 0;
  const auto look = [&] {
    links.insert(it.link());
    mostHeld_bytes = std::max(mostHeld_bytes, it.session.held_bytes());
  };
  const auto takeAll = [&] {
    const auto readings = it.queue.take();
    taken += readings.size();
    mostWaiting = std::max(mostWaiting, readings.size());
    for (const ToolReading& reading : readings) states.insert(reading.state);
  };
  const auto open = [&] {
    it.session.opened(it.now_s);
    ++connections;
    look();
  };
  const auto close = [&](const char* why) {
    it.session.closed(it.now_s, verbatim(why));
    look();
    it.now_s = std::max(it.now_s, it.session.attempt_s());
    open();
  };
  const double begin_s = it.now_s, end_s = begin_s + 8.0 * 3600.0;
  open();
  int frame = 0;
  while (it.now_s < end_s) {
    // Ten seconds of poses, then one fault.
    for (int n = 0; n < 600; ++n, ++frame) {
      if (!it.until(it.now_s + 1.0 / 60.0)) open();
      IgtlMessage message = test::transformMessage(test::igtlPoseNumber(frame), "ProbeToTracker", 1e6 + it.now_s - begin_s, 1 + frame % 2);
      ASSERT_TRUE(it.hear(message));
      ++poses;
      if (n % 6 == 0) takeAll();
    }
    look();
    switch (random() % 8) {
      case 0:
        close("restarted");
        break;
      case 1:  // silence, from a moment up to half a minute
        if (!it.until(it.now_s + std::uniform_real_distribution<double>(0.1, 30.0)(random))) {
          look();
          open();
        }
        look();
        break;
      case 2:  // the tool is not seen
        for (int n = 0; n < 12; ++n) {
          ASSERT_TRUE(it.until(it.now_s + 0.25));
          ASSERT_TRUE(it.hear(test::statusMessage(1)));
        }
        break;
      case 3:
        ASSERT_TRUE(it.hear(test::transformMessage(glm::dmat4(1.0))));
        break;
      case 4: {  // damaged on the way
        Bytes bytes = igtlBytes(test::transformMessage(test::igtlPoseNumber(frame)));
        bytes[80] ^= 1u;
        ASSERT_TRUE(it.hear(bytes));
        break;
      }
      case 5:  // not OpenIGTLink any more
        ASSERT_FALSE(it.hear(Bytes(64, static_cast<std::uint8_t>(0x80u + random() % 64))));
        look();
        open();
        break;
      case 6: {  // cut in the middle
        const Bytes bytes = igtlBytes(test::transformMessage(test::igtlPoseNumber(frame)));
        ASSERT_TRUE(it.hear(Bytes(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(random() % bytes.size()))));
        close("cut");
        break;
      }
      default:  // nobody takes the readings for two minutes: a person is at lunch
        for (int n = 0; n < 7200; ++n, ++frame, ++poses) {
          if (!it.until(it.now_s + 1.0 / 60.0)) open();
          ASSERT_TRUE(it.hear(test::transformMessage(test::igtlPoseNumber(frame))));
        }
        takeAll();
    }
    takeAll();
  }
  ASSERT_TRUE(it.hear(test::transformMessage(test::igtlPoseNumber(1))));
  EXPECT_EQ(it.link(), LinkState::connected);
  EXPECT_EQ(it.queue.take().back().state, TrackingState::live);
  EXPECT_EQ(links, (std::set{LinkState::connecting, LinkState::connected, LinkState::silent}));
  EXPECT_EQ(states, (std::set{TrackingState::live, TrackingState::outOfView, TrackingState::invalid}));
  EXPECT_LT(mostHeld_bytes, 2000u) << "what the session holds on to";
  EXPECT_LE(mostWaiting, 4096u) << "what waits in the queue";
  EXPECT_GT(poses, 1000000u);
  EXPECT_EQ(taken + it.queue.status().dropped, it.queue.status().readings - 1);
  std::cout << poses << " poses, " << connections << " connections, at most " << mostHeld_bytes << " bytes held and " << mostWaiting
            << " readings waiting\n";
}

}  // namespace
}  // namespace ew
