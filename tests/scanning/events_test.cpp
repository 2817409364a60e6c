#include "ew/scanning/events.h"

#include <gtest/gtest.h>

#include "scanning/small_scan.h"

namespace ew::events_test {

TEST(ScanLog, GivesBackEveryStateThatWasAdded) {
  ScanLog log;
  std::vector<ScanState> states;
  for (int n = 0; n < 400; ++n) {
    states.push_back(test::movingState(n));
    log.addFrame(states.back());
  }
  ASSERT_EQ(log.frameCount(), states.size());
  for (std::size_t n = 0; n < states.size(); ++n) ASSERT_EQ(log.frame(n), states[n]) << n;
}

TEST(ScanLog, GivesAStateIntoOneThatWasAnothers) {
  ScanLog log;
  ScanState bare = test::movingState(0);
  log.add({0.0, ProbeChosen{bare.probe}});
  log.add({0.0, FrameMade{bare.pose, {}, 1, {}}});  // before any settings and scene
  for (int n = 1; n < 40; ++n) log.addFrame(test::movingState(n));
  ScanState state;
  for (std::size_t step = 1; step <= log.frameCount(); ++step) {
    const std::size_t n = 7 * step % log.frameCount();
    log.frame(n, state);
    ASSERT_EQ(state, log.frame(n)) << n;
    ASSERT_EQ(state.gaps_mm, log.made(n).gaps_mm) << n;
    ASSERT_EQ(state.pose, log.made(n).pose) << n;
  }
}

TEST(ScanLog, KeepsOnlyWhatChanged) {
  ScanLog log;
  ScanState state = test::movingState(0);
  log.addFrame(state);
  EXPECT_EQ(log.events().size(), 4U) << "probe, settings, scene, frame";
  state.pose.probeToWorld.matrix[3].x += 1.0;
  log.addFrame(state);
  EXPECT_EQ(log.events().size(), 5U);
  state.knobs.gain = 1.7;
  log.addFrame(state);
  EXPECT_EQ(log.events().size(), 7U);
  state.probe.id = "other";
  log.addFrame(state);
  EXPECT_EQ(log.events().size(), 9U);
  state.scene.focus.emplace();
  log.addFrame(state);
  EXPECT_EQ(log.events().size(), 11U);
}

TEST(ScanLog, FindsTheFrameThatIsSeenAtAMoment) {
  ScanLog log;
  for (const double time_s : {2.0, 2.5, 2.5, 4.0}) {
    ScanState state = test::movingState(0);
    state.time_s = time_s;
    log.addFrame(state);
  }
  EXPECT_EQ(log.frameAt(-1.0), 0U);
  EXPECT_EQ(log.frameAt(2.0), 0U);
  EXPECT_EQ(log.frameAt(2.49), 0U);
  EXPECT_EQ(log.frameAt(2.5), 2U) << "the later of two at one time";
  EXPECT_EQ(log.frameAt(3.99), 2U);
  EXPECT_EQ(log.frameAt(100.0), 3U);
  EXPECT_EQ(log.begin_s(), 2.0);
  EXPECT_EQ(log.end_s(), 4.0);
}

TEST(ScanLog, KnowsWhenItWasFrozenAndKeepsNotesAsTheyAre) {
  ScanLog log;
  ScanState state = test::movingState(0);
  state.time_s = 1.0;
  log.addFrame(state);
  log.setFrozen(2.0, true);
  log.setFrozen(2.5, true);
  log.addNote(3.0, "measurement", {{"mm", 12.5}, {"of", "aorta"}});
  log.setFrozen(4.0, false);
  EXPECT_EQ(log.events().size(), 7U) << "freezing what is frozen is no event";
  EXPECT_FALSE(log.isFrozenAt(1.9));
  EXPECT_TRUE(log.isFrozenAt(2.0));
  EXPECT_TRUE(log.isFrozenAt(3.9));
  EXPECT_FALSE(log.isFrozenAt(4.0));
  EXPECT_EQ(std::get<Note>(log.events()[5].what).what["of"], "aorta");
}

TEST(ScanLog, TimesNeverFallAndAFrameWithoutAProbeIsNotKept) {
  ScanLog log;
  log.add({3.0, FrameMade{}});
  EXPECT_TRUE(log.empty());
  ScanState state = test::movingState(0);
  state.time_s = 5.0;
  log.addFrame(state);
  state.time_s = 4.0;
  log.addFrame(state);
  EXPECT_EQ(log.frameTime_s(1), 5.0);
}

}  // namespace ew::events_test
