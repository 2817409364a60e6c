#include "ew/trackers/igtl_wire.h"

#include <gtest/gtest.h>
#include <igtlPositionMessage.h>
#include <igtlStatusMessage.h>
#include <igtlTrackingDataMessage.h>
#include <igtlTransformMessage.h>
#include <rapidcheck/gtest.h>

#include <random>

#include "igtl_messages.h"

namespace ew {
namespace {

using test::append;
using test::Bytes;

struct Heard {
  std::vector<IgtlMessage> messages;
  std::vector<Message> refusals;
  std::size_t mostHeld_bytes = 0;
  bool isBroken = false;
};

/// @param cuts where the bytes are cut into portions, rising
Heard heardFrom(const Bytes& bytes, const std::vector<std::size_t>& cuts = {}, bool checksSums = true) {
  IgtlReader reader(checksSums);
  Heard heard;
  std::size_t begin = 0;
  for (std::size_t n = 0; n <= cuts.size() && !heard.isBroken; ++n) {
    const std::size_t end = n < cuts.size() ? cuts[n] : bytes.size();
    const auto read = reader.read(
        std::span(bytes).subspan(begin, end - begin), [&](const IgtlMessage& message) { heard.messages.push_back(message); },
        [&](Message why) { heard.refusals.push_back(std::move(why)); });
    heard.isBroken = !read;
    heard.mostHeld_bytes = std::max(heard.mostHeld_bytes, reader.held_bytes());
    begin = end;
  }
  return heard;
}

Bytes packed(igtl::MessageBase& message) {
  message.Pack();
  const auto* begin = static_cast<const std::uint8_t*>(message.GetPackPointer());
  return {begin, begin + message.GetPackSize()};
}

Bytes someStream() {
  Bytes bytes;
  append(bytes, igtlBytes(test::transformMessage(test::igtlPoseNumber(1))));
  append(bytes, igtlBytes(test::statusMessage(1)));
  IgtlMessage image;
  image.type = "IMAGE";
  image.device = "Image";
  image.content.assign(5000, 17);
  append(bytes, igtlBytes(image));
  IgtlMessage third = test::transformMessage(test::igtlPoseNumber(2), "StylusToTracker", 7.25, 2);
  third.id = 99;
  third.words = {{"TransformStatus", "OK"}, {"Empty", ""}};
  append(bytes, igtlBytes(third));
  append(bytes, igtlBytes(test::trackingMessage({"Probe", "Reference"})));
  return bytes;
}

TEST(IgtlWire, ReadsWhatTheLibraryOfTheSystemWrites) {
  auto transform = igtl::TransformMessage::New();
  igtl::Matrix4x4 matrix;
  const glm::dmat4 pose = test::igtlPoseNumber(3);
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) matrix[row][column] = static_cast<float>(pose[column][row]);
  transform->SetMatrix(matrix);
  transform->SetDeviceName("ProbeToTracker");
  transform->SetTimeStamp(1700000000u, 1u << 31u);
  const Heard heard = heardFrom(packed(*transform));
  ASSERT_EQ(heard.messages.size(), 1u);
  EXPECT_EQ(heard.messages[0].type, "TRANSFORM");
  EXPECT_EQ(heard.messages[0].device, "ProbeToTracker");
  EXPECT_EQ(heard.messages[0].time_s, 1700000000.5);
  EXPECT_EQ(heard.messages[0].content, igtlTransformContent(pose));
  EXPECT_TRUE(heard.refusals.empty());
}

TEST(IgtlWire, WritesWhatTheLibraryOfTheSystemReads) {
  const glm::dmat4 pose = test::igtlPoseNumber(4);
  Bytes bytes = igtlBytes(test::transformMessage(pose, "ProbeToWorld", 1234.5));
  auto header = igtl::MessageHeader::New();
  header->InitPack();
  std::copy_n(bytes.begin(), kIgtlHeader_bytes, static_cast<std::uint8_t*>(header->GetPackPointer()));
  header->Unpack();
  EXPECT_STREQ(header->GetDeviceType(), "TRANSFORM");
  auto transform = igtl::TransformMessage::New();
  transform->SetMessageHeader(header);
  transform->AllocatePack();
  std::copy(bytes.begin() + kIgtlHeader_bytes, bytes.end(), static_cast<std::uint8_t*>(transform->GetPackBodyPointer()));
  ASSERT_TRUE(transform->Unpack(1) & igtl::MessageHeader::UNPACK_BODY) << "the sum is checked too";
  igtl::Matrix4x4 matrix;
  transform->GetMatrix(matrix);
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column) EXPECT_EQ(matrix[row][column], static_cast<float>(pose[column][row]));
}

TEST(IgtlWire, TakesHeaderVersion2ApartAndStaysInStep) {
  const Heard heard = heardFrom(someStream());
  ASSERT_EQ(heard.messages.size(), 5u);
  EXPECT_TRUE(heard.messages[2].isSkipped);
  EXPECT_EQ(heard.messages[2].type, "IMAGE");
  const IgtlMessage& third = heard.messages[3];
  EXPECT_EQ(third.version, 2);
  EXPECT_EQ(third.id, 99u);
  EXPECT_EQ(third.device, "StylusToTracker");
  EXPECT_EQ(third.content, igtlTransformContent(test::igtlPoseNumber(2)));
  EXPECT_EQ(third.words, (std::vector<std::pair<std::string, std::string>>{{"TransformStatus", "OK"}, {"Empty", ""}}));
  EXPECT_EQ(heard.messages[4].type, "TDATA");
}

TEST(IgtlWire, ADeviceNameOf20LettersIsReadWhole) {
  const std::string name = "TwentyLettersInTotal";
  ASSERT_EQ(name.size(), 20u);
  const Heard heard = heardFrom(igtlBytes(test::transformMessage(test::igtlPoseNumber(1), name)));
  ASSERT_EQ(heard.messages.size(), 1u);
  EXPECT_EQ(heard.messages[0].device, name);
  EXPECT_EQ(heardFrom(igtlBytes(test::transformMessage(test::igtlPoseNumber(1), name + "AndMore"))).messages[0].device, name);
}

TEST(IgtlWire, AMessageWithoutAStampHasNoTime) {
  const Heard heard = heardFrom(igtlBytes(test::transformMessage(test::igtlPoseNumber(1), "Probe", 0.0)));
  ASSERT_EQ(heard.messages.size(), 1u);
  EXPECT_TRUE(std::isnan(heard.messages[0].time_s));
}

TEST(IgtlWire, AMessageWithAWrongSumIsRefusedAndTheNextOneRead) {
  Bytes bytes = igtlBytes(test::transformMessage(test::igtlPoseNumber(1), "Damaged"));
  bytes[kIgtlHeader_bytes + 7] ^= 0x10u;
  append(bytes, igtlBytes(test::transformMessage(test::igtlPoseNumber(2), "Whole")));
  const Heard heard = heardFrom(bytes);
  ASSERT_EQ(heard.messages.size(), 1u);
  EXPECT_EQ(heard.messages[0].device, "Whole");
  EXPECT_EQ(heard.refusals.size(), 1u);
  EXPECT_EQ(heardFrom(bytes, {}, false).messages.size(), 2u) << "unless sums are not checked";
}

TEST(IgtlWire, ABodyOf3GigabytesOfAnUnknownTypeIsPassedOverWithoutBeingHeld) {
  IgtlMessage video;
  video.type = "VIDEO";
  Bytes header = igtlBytes(video);
  const std::uint64_t size = std::uint64_t{3} << 30u;
  for (std::size_t n = 0; n < 8; ++n) header[42 + n] = static_cast<std::uint8_t>(size >> (8u * (7u - n)));
  IgtlReader reader;
  std::size_t count = 0, mostHeld_bytes = 0;
  const auto read = [&](const Bytes& bytes) {
    ASSERT_TRUE(reader.read(
        bytes, [&](const IgtlMessage&) { ++count; }, [](const Message&) {}));
    mostHeld_bytes = std::max(mostHeld_bytes, reader.held_bytes());
  };
  read(header);
  const Bytes portion(std::size_t{1} << 20u, 0x55);
  for (std::uint64_t at = 0; at < size; at += portion.size()) read(portion);
  EXPECT_EQ(count, 1u);
  read(igtlBytes(test::transformMessage(test::igtlPoseNumber(1))));
  EXPECT_EQ(count, 2u);
  EXPECT_LE(mostHeld_bytes, 2 * kIgtlHeader_bytes);
}

TEST(IgtlWire, AnImpossibleSizeOrATypeThatIsNoWordBreaksTheStreamWithASentence) {
  const Bytes good = igtlBytes(test::transformMessage(test::igtlPoseNumber(1)));
  Bytes large = good, foreign = good, version = good;
  large[45] = 1;
  foreign[4] = 0x07;
  version[1] = 77;
  for (const Bytes& bytes : {large, foreign, version}) {
    const Heard heard = heardFrom(bytes);
    EXPECT_TRUE(heard.isBroken);
    EXPECT_TRUE(heard.messages.empty());
  }
  const std::string web = "HTTP/1.1 400 Bad Request\r\nContent-Type: text/html; charset=utf-8\r\n\r\n";
  EXPECT_TRUE(heardFrom(Bytes(web.begin(), web.end())).isBroken);
}

TEST(IgtlWire, MetadataWhoseLengthsLieIsRefused) {
  IgtlMessage message = test::transformMessage(test::igtlPoseNumber(1), "Probe", 1.0, 2);
  message.words = {{"TransformStatus", "OK"}};
  const Bytes good = igtlBytes(message);
  for (std::size_t at : {58u, 60u, 62u, 63u, 64u, 118u, 120u, 124u}) {
    Bytes bytes = good;
    bytes[at] ^= 0x40u;
    const Heard heard = heardFrom(bytes, {}, false);
    EXPECT_FALSE(heard.isBroken);
    EXPECT_EQ(heard.messages.size() + heard.refusals.size(), 1u) << at;
  }
}

RC_GTEST_PROP(IgtlWire, AnySplitOfTheBytesGivesTheSameMessages, ()) {
  const Bytes bytes = someStream();
  static const Heard whole = heardFrom(someStream());
  auto cuts = *rc::gen::container<std::vector<std::size_t>>(rc::gen::inRange<std::size_t>(0, bytes.size() + 1));
  std::sort(cuts.begin(), cuts.end());
  const Heard heard = heardFrom(bytes, cuts);
  RC_ASSERT(!heard.isBroken);
  RC_ASSERT(heard.refusals.empty());
  RC_ASSERT(heard.messages.size() == whole.messages.size());
  for (std::size_t n = 0; n < whole.messages.size(); ++n) RC_ASSERT(heard.messages[n].content == whole.messages[n].content);
}

TEST(IgtlWire, OneByteAtATimeGivesTheSameMessages) {
  const Bytes bytes = someStream();
  std::vector<std::size_t> cuts;
  for (std::size_t n = 1; n < bytes.size(); ++n) cuts.push_back(n);
  EXPECT_EQ(heardFrom(bytes, cuts).messages.size(), 5u);
}

TEST(IgtlWire, NoFlippedBitOfABodyOrItsSumGivesAPose) {
  for (int version : {1, 2}) {
    const Bytes good = igtlBytes(test::transformMessage(test::igtlPoseNumber(1), "Probe", 1.0, version));
    for (std::size_t at = 50; at < good.size(); ++at)
      for (unsigned bit = 0; bit < 8; ++bit) {
        Bytes bytes = good;
        bytes[at] ^= static_cast<std::uint8_t>(1u << bit);
        const Heard heard = heardFrom(bytes);
        ASSERT_TRUE(heard.messages.empty()) << "byte " << at << " bit " << bit;
      }
  }
}

RC_GTEST_PROP(IgtlWire, NoFlippedBytesAnywhereInAStreamDoHarm, ()) {
  Bytes bytes = someStream();
  const int flips = *rc::gen::inRange(1, 6);
  for (int n = 0; n < flips; ++n)
    bytes[*rc::gen::inRange<std::size_t>(0, bytes.size())] ^= static_cast<std::uint8_t>(*rc::gen::inRange(1, 256));
  const Heard heard = heardFrom(bytes);
  RC_ASSERT(heard.mostHeld_bytes <= kIgtlHeader_bytes + kIgtlLargestBody_bytes);
  // Whatever is still read as a pose has the very numbers of one that was sent: the sum covers them.
  for (const IgtlMessage& message : heard.messages)
    if (message.type == "TRANSFORM")
      RC_ASSERT(message.content == igtlTransformContent(test::igtlPoseNumber(1)) ||
                message.content == igtlTransformContent(test::igtlPoseNumber(2)));
}

TEST(IgtlWire, NoiseIsNoMessageAndNoCrash) {
  std::mt19937 random(7);
  std::uniform_int_distribution<int> byte(0, 255);
  for (int run = 0; run < 20000; ++run) {
    Bytes bytes(200);
    for (std::uint8_t& one : bytes) one = static_cast<std::uint8_t>(byte(random));
    if (run % 2 == 0) {  // half of them begin as a header does
      const Bytes header = igtlBytes(test::transformMessage(test::igtlPoseNumber(1), "Probe", 1.0, 2));
      std::copy_n(header.begin(), 42, bytes.begin());
    }
    EXPECT_TRUE(heardFrom(bytes).messages.empty());
  }
}

}  // namespace
}  // namespace ew
