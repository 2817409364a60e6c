#include <gtest/gtest.h>

#include "ew/io/sequence.h"
#include "ew/trackers/igtl_client.h"
#include "igtl_partners.h"
#include "recordings.h"

namespace ew {
namespace {

using test::eventually;
using test::Partner;
using test::Watched;

constexpr const char* kWires = "wire-phantom-pair/fCal_Test_Calibration_3NWires_fCal2.0.igs.mha";
constexpr const char* kLiver = "liver-sweep/liver_sweep.igs.mha";

/// Sends a recording as the server of PLUS does: a TRANSFORM for each transform of a frame, stamped with the frame's time.
bool play(Partner& server, const Sequence& recording, int version) {
  for (const SequenceFrame& frame : recording.frames)
    for (const FrameTransform& transform : frame.transforms) {
      IgtlMessage message =
          test::transformMessage(transform.matrix, transform.from + "To" + transform.to, frame.time_s.value_or(0.0), version);
      if (version == 2) message.words = {{"TransformValid", "true"}, {"TransformStatus", "OK"}};
      if (!server.send(message)) return false;
    }
  return true;
}

TEST(IgtlRecordings, ARecordingOfPlusPlaysBackToItsOwnPoses) {
  EW_NEEDS_RECORDING(kWires);
  const auto recording = readSequence(test::recording(kWires));
  ASSERT_TRUE(recording) << recording.error();
  for (int version : {1, 2}) {
    Partner server;
    IgtlSettings settings;
    settings.port = server.port();
    Watched client(makeIgtlClient(settings));
    ASSERT_TRUE(server.accept());
    ASSERT_TRUE(play(server, *recording, version));
    const std::size_t count = recording->frames.size() * 3;
    ASSERT_TRUE(eventually([&] { return client.all().size() >= count; }));
    ASSERT_EQ(client.readings.size(), count);
    EXPECT_EQ(client.device->status().tools, (std::vector<std::string>{"ProbeToTracker", "ReferenceToTracker", "StylusToTracker"}));
    std::size_t at = 0;
    for (const SequenceFrame& frame : recording->frames)
      for (const FrameTransform& transform : frame.transforms) {
        const ToolReading& reading = client.readings[at++];
        EXPECT_EQ(reading.tool, transform.from + "To" + transform.to);
        EXPECT_NEAR(reading.device_s, *frame.time_s, 1e-6);
        ASSERT_EQ(reading.state, TrackingState::live);
        EXPECT_LT(test::difference(reading.toolToTracker.matrix, transform.matrix), 5e-5) << "single precision, and six digits in the file";
      }
  }
}

TEST(IgtlRecordings, ARecordingWhoseTransformsScaleIsRefusedInWords) {
  EW_NEEDS_RECORDING(kLiver);
  const auto recording = readSequence(test::recording(kLiver));
  ASSERT_TRUE(recording) << recording.error();
  Partner server;
  IgtlSettings settings;
  settings.port = server.port();
  Watched client(makeIgtlClient(settings));
  ASSERT_TRUE(server.accept());
  ASSERT_TRUE(play(server, *recording, 1));
  ASSERT_TRUE(eventually([&] { return client.all().size() >= recording->frames.size(); }));
  for (const ToolReading& reading : client.readings)
    EXPECT_EQ(reading.state, TrackingState::invalid) << "image to reference: pixels, no tool";
  EXPECT_NE(client.device->status().lastRefusal.english().find("ImageToReference that is not a rotation and a translation"),
            std::string::npos)
      << client.device->status().lastRefusal;
}

}  // namespace
}  // namespace ew
