#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <functional>
#include <thread>

#include "ew/io/sequence.h"
#include "ew/trackers/sequence_device.h"
#include "ew/tracking/tracked_probe.h"
#include "recordings.h"

namespace ew::sequence_test {
namespace {

namespace fs = std::filesystem;

/// Waits generously for what comes soon.
bool waitUntil(const std::function<bool()>& isSo, double most_s = 20.0) {
  const double until_s = steadyNow_s() + most_s;
  while (!isSo()) {
    if (steadyNow_s() > until_s) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return true;
}

FrameTransform at(const std::string& from, double x_mm, PoseStatus status = PoseStatus::ok) {
  FrameTransform transform{.from = from, .to = "Tracker", .matrix = glm::dmat4(1.0), .status = status};
  transform.matrix[3].x = x_mm;
  return transform;
}

/// Twenty frames, a fiftieth of a second each; the probe is missing in the tenth, bad in the twelfth.
fs::path written(const std::string& name) {
  Sequence sequence;
  sequence.width = sequence.height = 2;
  for (int n = 0; n < 20; ++n) {
    SequenceFrame frame;
    frame.time_s = 77.0 + 0.02 * n;
    const PoseStatus status = n == 10 || n == 12 ? PoseStatus::invalid : PoseStatus::ok;
    frame.transforms = {at("Probe", n == 10 ? 0.0 : 1.0 + n, status), at("Reference", -5.0)};
    sequence.frames.push_back(frame);
  }
  sequence.pixels.assign(20 * 4, 0);
  const fs::path file = fs::path(::testing::TempDir()) / name;
  EXPECT_TRUE(writeSequence(sequence, file));
  return file;
}

}  // namespace

TEST(SequenceDevice, GivesEveryToolOfEveryFrameUnderTheRecordingsNamesAndStates) {
  const fs::path file = written("ew_tracker_all.igs.mha");
  const auto device = makeSequenceDevice({.file = file, .speed = 10.0, .loops = false});
  device->start();
  ASSERT_TRUE(waitUntil([&] { return device->status().link == LinkState::ended; })) << device->status().sentence;
  const auto readings = device->take();
  ASSERT_EQ(readings.size(), 40u);
  int probe = 0;
  for (const ToolReading& reading : readings) {
    if (reading.tool != "ProbeToTracker") continue;
    const TrackingState expected = probe == 10 ? TrackingState::outOfView : probe == 12 ? TrackingState::invalid : TrackingState::live;
    EXPECT_EQ(reading.state, expected) << probe;
    EXPECT_TRUE(expected != TrackingState::live || reading.toolToTracker.matrix[3].x == 1.0 + probe) << probe;
    EXPECT_NEAR(reading.device_s, 0.002 * probe, 1e-6) << "as a tracker would stamp it at that speed";
    ++probe;
  }
  EXPECT_EQ(probe, 20);
  EXPECT_EQ(device->status().tools, (std::vector<std::string>{"ProbeToTracker", "ReferenceToTracker"}));
  EXPECT_NEAR(device->length_s(), 0.38, 1e-9);
  fs::remove(file);
}

TEST(SequenceDevice, NeverPlaysAFrameBeforeItsTime) {
  const fs::path file = written("ew_tracker_pace.igs.mha");
  const auto device = makeSequenceDevice({.file = file, .speed = 1.0, .loops = false});
  device->start();
  ASSERT_TRUE(waitUntil([&] { return device->status().link == LinkState::ended; }));
  const auto readings = device->take();
  ASSERT_FALSE(readings.empty());
  for (const ToolReading& reading : readings)
    EXPECT_GE(reading.arrival_s - readings.front().arrival_s, reading.device_s - readings.front().device_s - 0.005);
  fs::remove(file);
}

TEST(SequenceDevice, BeginsAgainAtItsEndWithAClockThatGoesOn) {
  const fs::path file = written("ew_tracker_loop.igs.mha");
  const auto device = makeSequenceDevice({.file = file, .speed = 10.0, .loops = true});
  device->start();
  ASSERT_TRUE(waitUntil([&] { return device->status().readings > 130; }));
  device->stop();
  EXPECT_EQ(device->status().link, LinkState::off);
  double before_s = -1.0;
  for (const ToolReading& reading : device->take()) {
    EXPECT_GE(reading.device_s, before_s);
    before_s = reading.device_s;
  }
  EXPECT_GT(before_s, 3 * 0.038);
  fs::remove(file);
}

TEST(SequenceDevice, ASingleFrameComesAtTheUsualPaceAndNotAThousandTimesASecond) {
  Sequence sequence;
  sequence.width = sequence.height = 2;
  SequenceFrame frame;
  frame.time_s = 5.0;
  frame.transforms = {at("Probe", 1.0)};
  sequence.frames.push_back(frame);
  sequence.pixels.assign(4, 0);
  const fs::path file = fs::path(::testing::TempDir()) / "ew_tracker_one.igs.mha";
  ASSERT_TRUE(writeSequence(sequence, file));
  const auto device = makeSequenceDevice({.file = file, .speed = 10.0, .loops = true});
  device->start();
  ASSERT_TRUE(waitUntil([&] { return device->status().readings > 5; }));
  device->stop();
  const auto readings = device->take();
  for (std::size_t n = 1; n < readings.size(); ++n)
    EXPECT_NEAR(readings[n].device_s - readings[n - 1].device_s, 1.0 / 300, 1e-6) << "thirty a second, at ten times the speed";
  fs::remove(file);
}

TEST(SequenceDevice, StandsStillWhilePausedAndGoesOnWhereItWas) {
  const fs::path file = written("ew_tracker_pause.igs.mha");
  const auto device = makeSequenceDevice({.file = file, .speed = 0.5, .loops = false});
  device->start();
  ASSERT_TRUE(waitUntil([&] { return device->at_s() > 0.05; }));
  device->pause(true);
  EXPECT_TRUE(device->isPaused());
  const double at_s = device->at_s();
  std::this_thread::sleep_for(std::chrono::milliseconds(1000));  // longer than the whole recording
  EXPECT_LE(device->at_s(), at_s + 0.0201) << "what had begun may still come";
  EXPECT_EQ(device->status().link, LinkState::silent);
  device->pause(false);
  ASSERT_TRUE(waitUntil([&] { return device->status().link == LinkState::ended; }));
  EXPECT_EQ(device->status().readings, 40u) << "nothing is left out";
  fs::remove(file);
}

TEST(SequenceDevice, SaysWhatIsWrongWithAFileAndPlaysItOnceItIsThere) {
  const fs::path later = fs::path(::testing::TempDir()) / "ew_tracker_later.igs.mha";
  fs::remove(later);
  const auto device = makeSequenceDevice({.file = later, .speed = 10.0});
  device->start();
  ASSERT_TRUE(waitUntil([&] { return device->status().sentence.english().find("ew_tracker_later") != std::string::npos; }));
  EXPECT_EQ(device->status().link, LinkState::connecting);
  const fs::path file = written("ew_tracker_source.igs.mha");
  fs::rename(file, later);
  ASSERT_TRUE(waitUntil([&] { return device->status().link == LinkState::connected; })) << device->status().sentence;
  ASSERT_TRUE(waitUntil([&] { return device->status().readings > 0; }));
  device->stop();
  fs::remove(later);
}

TEST(SequenceDevice, StartsAgainFromItsBeginning) {
  const fs::path file = written("ew_tracker_again.igs.mha");
  const auto device = makeSequenceDevice({.file = file, .speed = 10.0, .loops = false});
  for (int run = 0; run < 3; ++run) {
    device->start();
    ASSERT_TRUE(waitUntil([&] { return device->status().link == LinkState::ended; }));
    const auto readings = device->take();
    ASSERT_EQ(readings.size(), 40u);
    EXPECT_EQ(readings.front().device_s, 0.0);
    device->stop();
  }
  fs::remove(file);
}

TEST(SequenceDevice, DrivesATrackedProbeFromARecordingOfPlus) {
  EW_NEEDS_RECORDING("spine-phantom-sweep");
  fs::path file;
  for (const auto& entry : fs::recursive_directory_iterator(test::recording("spine-phantom-sweep")))
    if (entry.path().string().ends_with(".mha") && isSequence(entry.path()).value_or(false)) file = entry.path();
  if (file.empty()) GTEST_SKIP() << "for want of recordings: spine-phantom-sweep holds no sequence";
  const std::shared_ptr<SequenceDevice> device = makeSequenceDevice({.file = file});
  TrackedProbe probe(device, {}, {}, 0.0);
  device->start();
  ASSERT_TRUE(waitUntil([&] { return probe.report(steadyNow_s()).state == TrackingState::live; }, 60.0)) << device->status().sentence;
  ASSERT_TRUE(waitUntil([&] { return probe.report(steadyNow_s()).rate_hz > 5.0; }));
  const TrackingReport report = probe.report(steadyNow_s());
  EXPECT_FALSE(report.tool.empty());
  EXPECT_TRUE(checkRigid(probe.poseAt(steadyNow_s()).probeToWorld));
  device->stop();
  EXPECT_EQ(probe.poseAt(steadyNow_s()).status, PoseStatus::missing);
}

}  // namespace ew::sequence_test
