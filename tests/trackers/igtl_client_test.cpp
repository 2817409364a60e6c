#include "ew/trackers/igtl_client.h"

#include <gtest/gtest.h>
#include <igtlPositionMessage.h>
#include <igtlServerSocket.h>
#include <igtlTrackingDataMessage.h>
#include <igtlTransformMessage.h>

#include "igtl_partners.h"

namespace ew {
namespace {

using test::eventually;
using test::igtlPoseNumber;
using test::Partner;
using test::Watched;

IgtlSettings at(int port, const std::string& host = "localhost") {
  IgtlSettings settings;
  settings.host = host;
  settings.port = port;
  return settings;
}

/// The library's own server, as a maker's program would use it: three kinds of messages at 100 Hz.
class LibraryServer {
 public:
  LibraryServer() {
    server_ = igtl::ServerSocket::New();
    isListening = server_->CreateServer(0) == 0;
    port = server_->GetServerPort();
    thread_ = std::thread([this] { run(); });
  }
  ~LibraryServer() {
    stopping_ = true;
    thread_.join();
    server_->CloseSocket();
  }
  bool isListening = false;
  int port = 0;

 private:
  static void setMatrix(igtl::Matrix4x4& to, const glm::dmat4& from) {
    for (int row = 0; row < 4; ++row)
      for (int column = 0; column < 4; ++column) to[row][column] = static_cast<float>(from[column][row]);
  }
  void run() {
    igtl::ClientSocket::Pointer client;
    auto stamp = igtl::TimeStamp::New();
    for (int n = 0; !stopping_; ++n) {
      if (client.IsNull()) {
        client = server_->WaitForConnection(50);
        continue;
      }
      stamp->GetTime();
      igtl::Matrix4x4 matrix;
      setMatrix(matrix, igtlPoseNumber(n));
      auto transform = igtl::TransformMessage::New();
      transform->SetDeviceName("ProbeToTracker");
      transform->SetMatrix(matrix);
      transform->SetTimeStamp(stamp);
      transform->Pack();
      auto list = igtl::TrackingDataMessage::New();
      list->SetDeviceName("Tracker");
      for (const char* name : {"Stylus", "Reference"}) {
        auto element = igtl::TrackingDataElement::New();
        element->SetName(name);
        element->SetType(igtl::TrackingDataElement::TYPE_6D);
        element->SetMatrix(matrix);
        list->AddTrackingDataElement(element);
      }
      list->SetTimeStamp(stamp);
      list->Pack();
      auto position = igtl::PositionMessage::New();
      position->SetDeviceName("Needle");
      position->SetPosition(1.0F, 2.0F, 3.0F);
      position->SetQuaternion(0.6F, 0.0F, 0.0F, 0.8F);
      position->SetTimeStamp(0u, 0u);
      position->Pack();
      if (client->Send(transform->GetPackPointer(), transform->GetPackSize()) == 0) return;
      client->Send(list->GetPackPointer(), list->GetPackSize());
      client->Send(position->GetPackPointer(), position->GetPackSize());
      test::sleep_s(0.01);
    }
    if (client.IsNotNull()) client->CloseSocket();
  }
  igtl::ServerSocket::Pointer server_;
  std::atomic<bool> stopping_ = false;
  std::thread thread_;
};

TEST(IgtlClient, FollowsTheSenderOfTheSystemsLibraryToolByTool) {
  LibraryServer server;
  ASSERT_TRUE(server.isListening);
  Watched client(makeIgtlClient(at(server.port)));
  ASSERT_TRUE(eventually([&] { return client.all().size() >= 400; }));
  const DeviceStatus status = client.device->status();
  EXPECT_EQ(status.link, LinkState::connected);
  EXPECT_EQ(status.tools, (std::vector<std::string>{"ProbeToTracker", "Stylus", "Reference", "Needle"}));
  EXPECT_EQ(status.refused, 0u) << status.lastRefusal;
  EXPECT_GT(client.news, 0);
  int poses = 0;
  double before_s = 0.0;
  for (const ToolReading& reading : client.readings) {
    EXPECT_EQ(reading.state, TrackingState::live);
    EXPECT_TRUE(checkRigid(reading.toolToTracker, 1e-9));
    EXPECT_GE(reading.arrival_s, before_s) << "in the order they came";
    before_s = reading.arrival_s;
    if (reading.tool == "Needle") {
      EXPECT_TRUE(std::isnan(reading.device_s)) << "it was sent without a stamp";
      continue;
    }
    EXPECT_GT(reading.device_s, 1.6e9) << "stamped by the sender";
    if (reading.tool == "ProbeToTracker") ++poses;
  }
  EXPECT_GT(poses, 50);
}

TEST(IgtlClient, ReadsEveryVersionOfTheProtocolInOneConnection) {
  Partner server;
  Watched client(makeIgtlClient(at(server.port())));
  ASSERT_TRUE(server.accept());
  for (int n = 0; n < 30; ++n) {
    IgtlMessage message = test::transformMessage(igtlPoseNumber(n), "ProbeToTracker", 10.0 + n, 1 + n % 2);
    if (message.version == 2) message.words = {{"TransformStatus", n % 4 == 1 ? "OK" : "OUT_OF_VIEW"}};
    ASSERT_TRUE(server.send(message));
  }
  ASSERT_TRUE(eventually([&] { return client.all().size() >= 30; }));
  ASSERT_EQ(client.readings.size(), 30u);
  for (int n = 0; n < 30; ++n) {
    const ToolReading& reading = client.readings[static_cast<std::size_t>(n)];
    EXPECT_EQ(reading.state, n % 4 == 3 ? TrackingState::outOfView : TrackingState::live) << n;
    EXPECT_EQ(reading.device_s, 10.0 + n);
  }
}

TEST(IgtlClient, ConnectsOverIpv6) {
  Partner server(0, true);
  if (!server.isListening()) GTEST_SKIP() << "this computer has no IPv6";
  for (const char* host : {"::1", "localhost"}) {
    Watched client(makeIgtlClient(at(server.port(), host)));
    ASSERT_TRUE(server.accept()) << host;
    ASSERT_TRUE(server.send(test::transformMessage(igtlPoseNumber(4))));
    EXPECT_TRUE(client.getsPose(4)) << host;
  }
}

TEST(IgtlClient, AsksAServerThatWaitsToBeAsked) {
  Partner server;
  Watched client(makeIgtlClient(at(server.port())));
  ASSERT_TRUE(server.accept());
  const auto questions = server.hear();
  ASSERT_FALSE(questions.empty());
  EXPECT_EQ(questions[0].type, "STT_TDATA");
  EXPECT_EQ(questions[0].version, 1);
  ASSERT_TRUE(server.send(test::trackingMessage({"Probe", "Reference"}, 9)));
  EXPECT_TRUE(client.getsPose(9, "Reference"));
}

TEST(IgtlClient, AToolMissingFromTheListIsOutOfView) {
  Partner server;
  Watched client(makeIgtlClient(at(server.port())));
  ASSERT_TRUE(server.accept());
  ASSERT_TRUE(server.send(test::trackingMessage({"Probe", "Reference"}, 1)));
  ASSERT_TRUE(server.send(test::trackingMessage({"Reference"}, 2)));
  ASSERT_TRUE(eventually([&] { return client.all().size() >= 4; }));
  ASSERT_EQ(client.readings.size(), 4u);
  EXPECT_EQ(client.readings[3].tool, "Probe");
  EXPECT_EQ(client.readings[3].state, TrackingState::outOfView);
}

TEST(IgtlClient, StartsAndStopsAsOftenAsOneLikesAndLeavesNoThread) {
  const std::size_t before = test::threadsNow();
  Partner server;
  const auto client = makeIgtlClient(at(server.port()));
  EXPECT_EQ(client->status().link, LinkState::off);
  for (int n = 0; n < 5; ++n) {
    client->start();
    client->start();
    ASSERT_TRUE(server.accept());
    ASSERT_TRUE(server.send(test::transformMessage(igtlPoseNumber(n))));
    ASSERT_TRUE(eventually([&] { return client->status().readings == 1; })) << "counted from the start";
    client->stop();
    client->stop();
    EXPECT_EQ(client->status().link, LinkState::off);
    EXPECT_EQ(client->take().size(), 1u) << "what was not taken stays";
    EXPECT_EQ(test::threadsNow(), before);
  }
}

}  // namespace
}  // namespace ew
