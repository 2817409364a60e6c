#include "ew/trackers/igtl_server.h"

#include <gtest/gtest.h>
#include <igtlClientSocket.h>
#include <igtlImageMessage.h>
#include <igtlTransformMessage.h>
#include <sys/resource.h>

#include <ctime>
#include <iostream>

#include "ew/trackers/igtl_client.h"
#include "igtl_partners.h"

namespace ew {
namespace {

using test::Bytes;
using test::eventually;
using test::igtlPoseNumber;
using test::Watched;

const glm::dmat4 kLpsToRas = glm::dmat4(-1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);

IgtlServerOptions anyPort() {
  IgtlServerOptions options;
  options.port = 0;
  return options;
}

/// A client of raw bytes, as slow as the test wants.
class Visitor {
 public:
  explicit Visitor(int port, int receiveBuffer_bytes = 0) : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    if (receiveBuffer_bytes > 0) ::setsockopt(socket_, SOL_SOCKET, SO_RCVBUF, &receiveBuffer_bytes, sizeof receiveBuffer_bytes);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    isConnected = ::connect(socket_, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0;
  }
  ~Visitor() { ::close(socket_); }
  Visitor(const Visitor&) = delete;
  Visitor& operator=(const Visitor&) = delete;
  void send(const IgtlMessage& message) {
    const Bytes bytes = igtlBytes(message);
    EXPECT_EQ(::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL), static_cast<ssize_t>(bytes.size()));
  }
  /// What came meanwhile. Nothing of a closed connection.
  void listen(double most_s = 0.02) {
    pollfd asked{socket_, POLLIN, 0};
    if (::poll(&asked, 1, static_cast<int>(most_s * 1e3)) <= 0) return;
    Bytes bytes(65536);
    const ssize_t count = ::recv(socket_, bytes.data(), bytes.size(), 0);
    isEnded = count <= 0;
    if (isEnded) return;
    bytes.resize(static_cast<std::size_t>(count));
    EXPECT_TRUE(reader_.read(
        bytes, [this](const IgtlMessage& one) { heard.push_back(one); }, [](const Message& why) { ADD_FAILURE() << why; }));
  }
  const IgtlMessage* first(const std::string& type, int version = 0) const {
    for (const IgtlMessage& one : heard)
      if (one.type == type && (version == 0 || one.version == version)) return &one;
    return nullptr;
  }
  bool hears(const std::string& type, int version = 0) {
    return eventually([&] {
             listen();
             return first(type, version) != nullptr;
           })
        .has_value();
  }

  bool isConnected = false, isEnded = false;
  std::vector<IgtlMessage> heard;

 private:
  int socket_;
  IgtlReader reader_;
};

struct Serving {
  Serving() {
    if (const auto started = server.start()) port = *started;
  }
  bool hasClients(int count) {
    return eventually([&] { return server.status().clients == count; }).has_value();
  }
  void sendPose(int n, PoseStatus status = PoseStatus::ok) {
    IgtlFrame frame;
    frame.pose.probeToWorld.matrix = igtlPoseNumber(n);
    frame.pose.status = status;
    frame.time_s = 1e9 + n;
    server.send(frame);
  }
  void sendImage(int n, const GreyImage& image) {
    IgtlFrame frame;
    frame.pose.probeToWorld.matrix = igtlPoseNumber(n);
    frame.image = viewOf(image);
    frame.imageToWorld.matrix = igtlPoseNumber(n);
    frame.time_s = 1e9 + n;
    server.send(frame);
  }
  IgtlServer server{anyPort()};
  int port = 0;
};

TEST(IgtlServer, OurOwnClientGetsThePoseInRas) {
  Serving it;
  ASSERT_GT(it.port, 0);
  IgtlSettings settings;
  settings.port = it.port;
  Watched client(makeIgtlClient(settings));
  ASSERT_TRUE(it.hasClients(1));
  it.sendPose(5);
  ASSERT_TRUE(eventually([&] { return !client.all().empty(); }));
  const ToolReading& reading = client.readings.front();
  EXPECT_EQ(reading.tool, "ProbeToWorld");
  EXPECT_EQ(reading.state, TrackingState::live);
  EXPECT_EQ(reading.device_s, 1e9 + 5);
  EXPECT_LT(test::difference(reading.toolToTracker.matrix, kLpsToRas * igtlPoseNumber(5)), 1e-4);
}

TEST(IgtlServer, TheSystemsLibraryReadsPoseAndImage) {
  Serving it;
  GreyImage grey(64, 48);
  for (std::size_t n = 0; n < grey.pixels.size(); ++n) grey.pixels[n] = static_cast<std::uint8_t>(n % 255);
  auto socket = igtl::ClientSocket::New();
  ASSERT_EQ(socket->ConnectToServer("127.0.0.1", it.port), 0);
  ASSERT_TRUE(it.hasClients(1));
  it.sendImage(3, grey);
  bool hasPose = false, hasImage = false;
  while (!hasPose || !hasImage) {
    auto header = igtl::MessageHeader::New();
    header->InitPack();
    ASSERT_EQ(socket->Receive(header->GetPackPointer(), header->GetPackSize()), header->GetPackSize());
    header->Unpack();
    const std::string type = header->GetDeviceType();
    if (type == "TRANSFORM") {
      auto transform = igtl::TransformMessage::New();
      transform->SetMessageHeader(header);
      transform->AllocatePack();
      socket->Receive(transform->GetPackBodyPointer(), transform->GetPackBodySize());
      ASSERT_TRUE(transform->Unpack(1) & igtl::MessageHeader::UNPACK_BODY);
      hasPose = true;
    } else if (type == "IMAGE") {
      auto image = igtl::ImageMessage::New();
      image->SetMessageHeader(header);
      image->AllocatePack();
      socket->Receive(image->GetPackBodyPointer(), image->GetPackBodySize());
      ASSERT_TRUE(image->Unpack(1) & igtl::MessageHeader::UNPACK_BODY);
      EXPECT_TRUE(std::equal(grey.pixels.begin(), grey.pixels.end(), static_cast<const std::uint8_t*>(image->GetScalarPointer())));
      EXPECT_STREQ(image->GetDeviceName(), "Image_World");
      hasImage = true;
    } else {
      socket->Skip(header->GetBodySizeToRead(), 0);
    }
  }
  socket->CloseSocket();
}

TEST(IgtlServer, TwoClientsGetTheSameAndEachItsOwnVersion) {
  Serving it;
  Visitor old(it.port), modern(it.port);
  ASSERT_TRUE(it.hasClients(2));
  IgtlMessage question;
  question.version = 2;
  question.type = "GET_STATUS";
  modern.send(question);
  ASSERT_TRUE(modern.hears("STATUS", 2)) << "answered in the version it was asked in";
  it.sendPose(7);
  ASSERT_TRUE(old.hears("TRANSFORM", 1));
  ASSERT_TRUE(modern.hears("TRANSFORM", 2));
  EXPECT_EQ(old.first("TRANSFORM")->content, modern.first("TRANSFORM")->content);
  EXPECT_EQ(modern.first("TRANSFORM")->words.front(), (std::pair<std::string, std::string>("TransformStatus", "OK")));
  EXPECT_EQ(old.first("STATUS", 2), nullptr);
}

TEST(IgtlServer, StatusIsSaidWhileNothingElseIsSoThatSilenceMeansAFault) {
  Serving it;
  Visitor visitor(it.port);
  ASSERT_TRUE(eventually([&] {
    visitor.listen();
    return visitor.heard.size() >= 4;
  }));
  for (const IgtlMessage& one : visitor.heard) {
    const auto status = igtlStatus(one);
    ASSERT_TRUE(status);
    EXPECT_EQ(status->code, 1);
  }
}

TEST(IgtlServer, APoseThatIsNotOkIsLeftOutAndToldByStatus) {
  Serving it;
  IgtlSettings settings;
  settings.port = it.port;
  Watched client(makeIgtlClient(settings));
  ASSERT_TRUE(it.hasClients(1));
  it.sendPose(1);
  ASSERT_TRUE(eventually([&] { return !client.all().empty(); }));
  it.sendPose(2, PoseStatus::invalid);
  ASSERT_TRUE(eventually([&] { return client.sentence().find("The probe is not tracked at the moment") != std::string::npos; }));
  ASSERT_TRUE(eventually([&] {
    client.all();
    return client.readings.back().state == TrackingState::outOfView;
  })) << "a live server without the tool";
  it.sendPose(3);
  ASSERT_TRUE(eventually([&] {
    client.all();
    return client.readings.back().state == TrackingState::live;
  }));
  EXPECT_TRUE(eventually([&] { return client.sentence().find("Connected with") == 0; })) << client.sentence();
  for (const ToolReading& one : client.readings) EXPECT_NE(one.device_s, 1e9 + 2);
}

TEST(IgtlServer, ASlowClientLosesOldImagesAndHoldsUpNobody) {
  Serving it;
  const GreyImage grey(512, 384, 99);
  Visitor slow(it.port, 65536), quick(it.port);
  ASSERT_TRUE(it.hasClients(2));
  std::size_t most_bytes = 0;
  double memory_mb = 0.0;
  for (int n = 1; n <= 200; ++n) {
    it.sendImage(n, grey);
    ASSERT_TRUE(eventually([&] {
      quick.listen();
      const auto isLatest = [n](const IgtlMessage& one) { return one.type == "IMAGE" && one.time_s == 1e9 + n; };
      return std::any_of(quick.heard.begin(), quick.heard.end(), isLatest);
    })) << n;
    if (quick.heard.size() > 10) quick.heard.clear();
    if (n == 100) test::sleep_s(7.0);
    most_bytes = std::max(most_bytes, it.server.status().waiting_bytes);
    if (n == 50) memory_mb = test::resident_mb();
  }
  const IgtlServerStatus status = it.server.status();
  EXPECT_GT(status.droppedImages, 100u);
  EXPECT_LT(most_bytes, 4u * grey.pixels.size());
  EXPECT_LT(test::resident_mb() - memory_mb, test::kFlat_mb);
  std::cout << status.droppedImages << " images dropped, at most " << most_bytes << " bytes waiting\n";
  // TCP must not take a client that pauses for one that is gone, either. When it listens again, what it gets is whole and ends with the
  // newest.
  ASSERT_TRUE(eventually([&] {
    slow.listen();
    EXPECT_FALSE(slow.isEnded);
    return slow.isEnded || std::any_of(slow.heard.begin(), slow.heard.end(),
                                       [](const IgtlMessage& one) { return one.type == "IMAGE" && one.time_s == 1e9 + 200; });
  }));
}

TEST(IgtlServer, AClientThatTalksRubbishOrLeavesIsLetGo) {
  Serving it;
  {
    Visitor leaving(it.port);
    ASSERT_TRUE(it.hasClients(1));
  }
  ASSERT_TRUE(it.hasClients(0));
  Visitor rude(it.port);
  ASSERT_TRUE(it.hasClients(1));
  IgtlMessage nonsense;
  nonsense.type = "\x01\x02";
  rude.send(nonsense);
  ASSERT_TRUE(it.hasClients(0));
}

/// Seconds of the processor that this program has taken.
double worked_s() {
  timespec now{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

TEST(IgtlServer, WithoutAFreeDescriptorWaitsUntilThereIsOneAndDoesNotSpin) {
  Serving serving;
  ASSERT_GT(serving.port, 0);
  const int visitor = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  ASSERT_GE(visitor, 0);
  const int next = ::dup(visitor);  // the number that the next one would have
  ASSERT_EQ(::close(next), 0);
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_NOFILE, &before), 0);
  rlimit none = before;
  none.rlim_cur = static_cast<rlim_t>(next);
  ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &none), 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  address.sin_port = htons(static_cast<std::uint16_t>(serving.port));
  EXPECT_EQ(::connect(visitor, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
  const double began_s = worked_s();
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  const double spun_s = worked_s() - began_s;
  ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &before), 0);
  EXPECT_LT(spun_s, 0.25) << "poll() says at once that somebody waits, again and again";
  EXPECT_TRUE(serving.hasClients(1)) << "who waited is let in";
  ::close(visitor);
}

TEST(IgtlServer, StopsAndStartsAgainAndLeavesNoThread) {
  const std::size_t before = test::threadsNow();
  IgtlServer server(anyPort());
  for (int n = 0; n < 3; ++n) {
    const auto port = server.start();
    ASSERT_TRUE(port);
    Visitor visitor(*port);
    ASSERT_TRUE(visitor.isConnected);
    ASSERT_TRUE(eventually([&] { return server.status().clients == 1; }));
    const double begin_s = steadyNow_s();
    server.stop();
    std::cout << "stopped after " << steadyNow_s() - begin_s << " s\n";
    EXPECT_EQ(test::threadsNow(), before);
    EXPECT_EQ(server.status().clients, 0);
    EXPECT_TRUE(eventually([&] {
      visitor.listen();
      return visitor.isEnded;
    }));
  }
}

TEST(IgtlServer, APortThatIsTakenIsToldInWords) {
  Serving it;
  IgtlServerOptions options;
  options.port = it.port;
  IgtlServer second(options);
  const auto started = second.start();
  ASSERT_FALSE(started);
  EXPECT_NE(started.error().sentence().find("choose another port"), std::string::npos) << started.error();
}

TEST(IgtlServer, OnlyThisComputerConnectsUnlessAsked) {
  Serving it;
  IgtlServerOptions options = anyPort();
  options.everyone = true;
  IgtlServer open(options);
  const auto port = open.start();
  ASSERT_TRUE(port);
  Visitor visitor(*port);
  EXPECT_TRUE(visitor.isConnected) << "IPv4 reaches a server for everyone too";
}

}  // namespace
}  // namespace ew
