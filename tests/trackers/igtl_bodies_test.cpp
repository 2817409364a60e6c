#include "ew/trackers/igtl_bodies.h"

#include <gtest/gtest.h>
#include <igtlImageMessage.h>
#include <igtlPositionMessage.h>
#include <igtlQuaternionTrackingDataMessage.h>
#include <igtlStatusMessage.h>
#include <igtlTrackingDataMessage.h>
#include <rapidcheck/gtest.h>

#include <glm/gtc/quaternion.hpp>

#include "igtl_messages.h"

namespace ew {
namespace {

using test::Bytes;
using test::difference;
using test::igtlPoseNumber;

/// What the library of the system packs, read by our reader.
IgtlMessage sentByLibrary(igtl::MessageBase& message) {
  message.SetDeviceName("Device");
  message.Pack();
  const auto* begin = static_cast<const std::uint8_t*>(message.GetPackPointer());
  IgtlMessage read;
  IgtlReader reader;
  EXPECT_TRUE(reader.read(
      std::span(begin, static_cast<std::size_t>(message.GetPackSize())), [&](const IgtlMessage& one) { read = one; },
      [](const Message& why) { ADD_FAILURE() << why; }));
  return read;
}

IgtlPose onlyPose(const IgtlMessage& message) {
  const auto poses = igtlPoses(message);
  if (!poses || poses->size() != 1) {
    ADD_FAILURE() << "one pose was expected";
    return {};
  }
  return poses->front();
}

void setMatrix(igtl::Matrix4x4& to, const glm::dmat4& from) {
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) to[row][column] = static_cast<float>(from[column][row]);
}

glm::dquat rotationOf(const glm::dmat4& pose) { return glm::quat_cast(glm::dmat3(pose)); }

constexpr double kFloat = 2e-5;  // single precision at 350 mm

TEST(IgtlBodies, ATransformIsAPoseInTheTrackersOwnCoordinates) {
  const IgtlPose pose = onlyPose(test::transformMessage(igtlPoseNumber(5)));
  EXPECT_EQ(pose.tool, "ProbeToTracker");
  EXPECT_EQ(pose.state, TrackingState::live);
  EXPECT_LT(difference(pose.toolToTracker.matrix, igtlPoseNumber(5)), kFloat);
}

TEST(IgtlBodies, APositionOfTheLibraryIsAPoseAndSoIsItsShortForm) {
  const glm::dmat4 place = igtlPoseNumber(6);
  const glm::dquat rotation = rotationOf(place);
  auto position = igtl::PositionMessage::New();
  position->SetPosition(static_cast<float>(place[3].x), static_cast<float>(place[3].y), static_cast<float>(place[3].z));
  position->SetQuaternion(static_cast<float>(rotation.x), static_cast<float>(rotation.y), static_cast<float>(rotation.z),
                          static_cast<float>(rotation.w));
  IgtlMessage message = sentByLibrary(*position);
  // The library's own short forms write behind their memory, so they are cut here. Where w is left out, it is not negative.
  ASSERT_GT(rotation.w, 0.0);
  for (const std::size_t length : {28u, 24u}) {
    message.content.resize(length);
    const IgtlPose pose = onlyPose(message);
    EXPECT_EQ(pose.state, TrackingState::live) << length;
    EXPECT_LT(difference(pose.toolToTracker.matrix, place), kFloat) << length;
  }
  message.content.resize(12);
  const IgtlPose pose = onlyPose(message);
  EXPECT_EQ(pose.state, TrackingState::invalid) << "a place alone does not hold a probe";
  EXPECT_FALSE(pose.refusal.empty());
}

TEST(IgtlBodies, ListsOfTheLibraryAreReadToolByTool) {
  auto list = igtl::TrackingDataMessage::New();
  auto quaternions = igtl::QuaternionTrackingDataMessage::New();
  const std::string names[] = {"Probe", "Reference", "AToolWhoseNameIs20By"};
  for (int n = 0; n < 3; ++n) {
    const glm::dmat4 place = igtlPoseNumber(n);
    auto element = igtl::TrackingDataElement::New();
    element->SetName(names[n].c_str());
    element->SetType(n == 1 ? igtl::TrackingDataElement::TYPE_5D : igtl::TrackingDataElement::TYPE_6D);
    igtl::Matrix4x4 matrix;
    setMatrix(matrix, place);
    element->SetMatrix(matrix);
    list->AddTrackingDataElement(element);
    auto other = igtl::QuaternionTrackingDataElement::New();
    const glm::dquat rotation = rotationOf(place);
    other->SetName(names[n].c_str());
    other->SetType(n == 1 ? igtl::QuaternionTrackingDataElement::TYPE_5D : igtl::QuaternionTrackingDataElement::TYPE_6D);
    other->SetPosition(static_cast<float>(place[3].x), static_cast<float>(place[3].y), static_cast<float>(place[3].z));
    other->SetQuaternion(static_cast<float>(rotation.x), static_cast<float>(rotation.y), static_cast<float>(rotation.z),
                         static_cast<float>(rotation.w));
    quaternions->AddQuaternionTrackingDataElement(other);
  }
  for (const IgtlMessage& message : {sentByLibrary(*list), sentByLibrary(*quaternions)}) {
    const auto poses = igtlPoses(message);
    ASSERT_TRUE(poses);
    ASSERT_EQ(poses->size(), 3u) << message.type;
    for (int n = 0; n < 3; ++n) {
      const IgtlPose& pose = (*poses)[static_cast<std::size_t>(n)];
      EXPECT_EQ(pose.tool, names[n]);
      EXPECT_EQ(pose.state, n == 1 ? TrackingState::invalid : TrackingState::live) << "five degrees of freedom do not hold a probe";
      if (n == 1) continue;
      EXPECT_LT(difference(pose.toolToTracker.matrix, igtlPoseNumber(n)), kFloat) << message.type;
    }
  }
}

TEST(IgtlBodies, WhatIsNoPoseIsInvalidWithItsReason) {
  const double none = std::numeric_limits<double>::quiet_NaN(), endless = std::numeric_limits<double>::infinity();
  glm::dmat4 notANumber = igtlPoseNumber(1), infinite = igtlPoseNumber(1), lost = igtlPoseNumber(1), scaled = igtlPoseNumber(1);
  glm::dmat4 mirrored = igtlPoseNumber(1), zero(0.0);
  notANumber[1][2] = none;
  infinite[3][0] = endless;
  lost[3][1] = -3.697314e28;  // what one maker's trackers write for a tool that is not seen
  scaled[0] *= 1.02;
  mirrored[2] *= -1.0;
  for (const glm::dmat4& bad : {notANumber, infinite, lost, scaled, mirrored, zero, glm::dmat4(1.0)}) {
    const IgtlPose pose = onlyPose(test::transformMessage(bad));
    EXPECT_EQ(pose.state, TrackingState::invalid);
    EXPECT_FALSE(pose.refusal.empty());
  }
  IgtlMessage quaternion = test::transformMessage(glm::dmat4(1.0));
  quaternion.type = "POSITION";
  quaternion.content.assign(28, 0);
  EXPECT_EQ(onlyPose(quaternion).state, TrackingState::invalid) << "a quaternion of zeros turns nothing";
}

TEST(IgtlBodies, RoundingIsTakenOutOfARotation) {
  glm::dmat4 almost = igtlPoseNumber(8);
  almost[0] *= 1.0 + 4e-4;
  almost[1] += 3e-4 * almost[2];
  const IgtlPose pose = onlyPose(test::transformMessage(almost));
  ASSERT_EQ(pose.state, TrackingState::live);
  EXPECT_TRUE(checkRigid(pose.toolToTracker, 1e-12)) << pose.toolToTracker;
  EXPECT_LT(difference(pose.toolToTracker.matrix, igtlPoseNumber(8)), 5e-4);
}

RC_GTEST_PROP(IgtlBodies, WhateverStandsInATransformALivePoseIsRigid, ()) {
  IgtlMessage message = test::transformMessage(igtlPoseNumber(1));
  const int changes = *rc::gen::inRange(0, 5);
  for (int n = 0; n < changes; ++n)
    message.content[*rc::gen::inRange<std::size_t>(0, message.content.size())] = static_cast<std::uint8_t>(*rc::gen::inRange(0, 256));
  const auto poses = igtlPoses(message);
  RC_ASSERT(poses.has_value());
  const IgtlPose& pose = poses->front();
  RC_ASSERT(pose.state == TrackingState::invalid || checkRigid(pose.toolToTracker, 1e-9).has_value());
  RC_ASSERT((pose.state == TrackingState::invalid) == !pose.refusal.empty());
}

TEST(IgtlBodies, TheWordsOfPlusDecideOverTheNumbers) {
  const auto stateFor = [](const std::string& key, const std::string& value, const glm::dmat4& matrix) {
    IgtlMessage message = test::transformMessage(matrix, "Probe", 1.0, 2);
    message.words = {{key, value}};
    return onlyPose(message).state;
  };
  const glm::dmat4 good = igtlPoseNumber(1);
  EXPECT_EQ(stateFor("TransformStatus", "OK", good), TrackingState::live);
  EXPECT_EQ(stateFor("TransformStatus", "INVALID", good), TrackingState::invalid);
  EXPECT_EQ(stateFor("TransformStatus", "OUT_OF_VIEW", glm::dmat4(1.0)), TrackingState::outOfView);
  EXPECT_EQ(stateFor("TransformStatus", "TOOL_OUT_OF_VIEW", glm::dmat4(1.0)), TrackingState::outOfView);
  EXPECT_EQ(stateFor("TransformStatus", "MISSING", glm::dmat4(1.0)), TrackingState::outOfView);
  EXPECT_EQ(stateFor("TransformStatus", "OUT_OF_VOLUME", good), TrackingState::outOfRange);
  EXPECT_EQ(stateFor("TransformStatus", "OUT_OF_VOLUME", glm::dmat4(0.0)), TrackingState::invalid) << "words make no pose of what is none";
  EXPECT_EQ(stateFor("TransformStatus", "REQ_TIMEOUT", good), TrackingState::invalid);
  EXPECT_EQ(stateFor("TransformValid", "false", good), TrackingState::invalid);
  EXPECT_EQ(stateFor("TransformValid", "true", good), TrackingState::live);
}

TEST(IgtlBodies, ABodyOfAnotherLengthIsAnErrorAndAnotherTypeHasNoPoses) {
  IgtlMessage message = test::transformMessage(igtlPoseNumber(1));
  message.content.pop_back();
  EXPECT_FALSE(igtlPoses(message));
  message = test::trackingMessage({"A", "B"});
  message.content.pop_back();
  EXPECT_FALSE(igtlPoses(message));
  message.type = "STRING";
  ASSERT_TRUE(igtlPoses(message));
  EXPECT_TRUE(igtlPoses(message)->empty());
}

TEST(IgtlBodies, AStatusOfTheLibraryIsReadAndEveryCodeHasASentence) {
  auto sent = igtl::StatusMessage::New();
  sent->SetCode(igtl::StatusMessage::STATUS_HARDWARE_FAILURE);
  sent->SetSubCode(-5);
  sent->SetErrorName("LASER");
  sent->SetStatusString("The laser is off.");
  const auto status = igtlStatus(sentByLibrary(*sent));
  ASSERT_TRUE(status);
  EXPECT_EQ(*status, (IgtlStatus{18, -5, "LASER", "The laser is off."}));
  EXPECT_EQ(igtlStatusSentence(*status).english(),
            "The tracker's server reports: the device is broken. In its own words: The laser is off.");
  for (int code = 0; code < 25; ++code) EXPECT_FALSE(igtlStatusSentence({code, 0, "", ""}).empty());
  EXPECT_EQ(igtlStatus(test::statusMessage(7, "late"))->text, "late");
}

TEST(IgtlBodies, AnImageStandsWhereTheLibraryAndSlicerLookForIt) {
  GreyImage grey(31, 18);
  for (std::size_t n = 0; n < grey.pixels.size(); ++n) grey.pixels[n] = static_cast<std::uint8_t>(n % 251);
  glm::dmat4 imageToRas = igtlPoseNumber(9);
  imageToRas[0] *= 0.3;
  imageToRas[1] *= 0.2;
  imageToRas[2] = glm::dvec4(0.0);
  const Bytes content = igtlImageContent(viewOf(grey), imageToRas);

  IgtlMessage message;
  message.type = "IMAGE";
  message.device = "Image_World";
  message.content = content;
  const Bytes bytes = igtlBytes(message);
  auto header = igtl::MessageHeader::New();
  header->InitPack();
  std::copy_n(bytes.begin(), kIgtlHeader_bytes, static_cast<std::uint8_t*>(header->GetPackPointer()));
  header->Unpack();
  auto image = igtl::ImageMessage::New();
  image->SetMessageHeader(header);
  image->AllocatePack();
  std::copy(bytes.begin() + kIgtlHeader_bytes, bytes.end(), static_cast<std::uint8_t*>(image->GetPackBodyPointer()));
  ASSERT_TRUE(image->Unpack(1) & igtl::MessageHeader::UNPACK_BODY);

  int size[3];
  image->GetDimensions(size);
  EXPECT_EQ(size[0], 31);
  EXPECT_EQ(size[1], 18);
  EXPECT_EQ(size[2], 1);
  EXPECT_EQ(image->GetScalarType(), igtl::ImageMessage::TYPE_UINT8);
  EXPECT_EQ(image->GetCoordinateSystem(), igtl::ImageMessage::COORDINATE_RAS);
  EXPECT_TRUE(std::equal(grey.pixels.begin(), grey.pixels.end(), static_cast<const std::uint8_t*>(image->GetScalarPointer())));
  float spacing[3];
  image->GetSpacing(spacing);
  EXPECT_NEAR(spacing[0], 0.3F, 1e-6F);
  EXPECT_NEAR(spacing[1], 0.2F, 1e-6F);
  EXPECT_NEAR(spacing[2], 1.0F, 1e-6F);
  // The place of the image is its centre: back to the first pixel as a receiver goes back.
  igtl::Matrix4x4 matrix;
  image->GetMatrix(matrix);
  for (int row = 0; row < 3; ++row) {
    const double corner = static_cast<double>(matrix[row][3]) - static_cast<double>(imageToRas[0][row]) * 15.0 - imageToRas[1][row] * 8.5;
    EXPECT_NEAR(corner, imageToRas[3][row], 1e-4);
  }
}

}  // namespace
}  // namespace ew
