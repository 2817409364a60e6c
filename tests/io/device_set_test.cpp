#include <gtest/gtest.h>

#include "ew/io/sequence.h"
#include "files.h"

namespace ew::device_set_test {
namespace {
using namespace test;

std::string deviceSet(const std::string& inside) {
  return "<PlusConfiguration version=\"2.1\">\n<!-- a comment -->\n" + inside + "</PlusConfiguration>\n";
}

TEST(DeviceSetFile, ReadsCalibrationAndReconstructionWithAnyWhiteSpaceBetweenNumbers) {
  const TempFolder folder;
  const auto set = readDeviceSet(folder.put(
      "d.xml",
      deviceSet(
          "<CoordinateDefinitions><Transform From=\"Image\" To=\"Probe\"\n Matrix=\"0.1 2\t3 4\n  5 6 7 8\r\n 9 10 11 12   0 0 0 1 \"\n"
          " Error=\"1.7\"/></CoordinateDefinitions>"
          "<VolumeReconstruction OutputSpacing=\"0.5 0.25 1\" ClipRectangleOrigin=\"192 16\" ClipRectangleSize=\"420 580\" "
          "FanAnglesDeg=\"-45 45\""
          " FanOriginPixel=\"380 20\" FanRadiusStartPixel=\"120\" FanRadiusStopPixel=\"360.5\" Interpolation=\"LINEAR\" "
          "CompoundingMode=\"MEAN\"/>")));
  ASSERT_TRUE(succeeded(set));
  ASSERT_EQ(set->transforms.size(), 1u);
  EXPECT_EQ(set->transforms[0].from, "Image");
  EXPECT_EQ(set->transforms[0].to, "Probe");
  EXPECT_EQ(rowsOf(set->transforms[0].matrix), (std::array<double, 16>{0.1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 0, 0, 0, 1}));
  EXPECT_EQ(set->outputSpacing_mm, glm::dvec3(0.5, 0.25, 1));
  EXPECT_EQ(set->clipOrigin_px, glm::dvec2(192, 16));
  EXPECT_EQ(set->clipSize_px, glm::dvec2(420, 580));
  EXPECT_EQ(set->fanAngles_deg, glm::dvec2(-45, 45));
  EXPECT_EQ(set->fanOrigin_px, glm::dvec2(380, 20));
  EXPECT_EQ(set->fanRadiusStart_px, 120.0);
  EXPECT_EQ(set->fanRadiusStop_px, 360.5);
  EXPECT_EQ(set->interpolation, "LINEAR");
  EXPECT_EQ(set->compounding, "MEAN");
}

TEST(DeviceSetFile, OfSeveralFilesTheEarlierCountsAndTheLaterFillsGaps) {
  const TempFolder folder;
  const auto transform = [](const std::string& from, const std::string& to, int x) {
    return "<Transform From=\"" + from + "\" To=\"" + to + "\" Matrix=\"1 0 0 " + std::to_string(x) + " 0 1 0 0 0 0 1 0 0 0 0 1\"/>";
  };
  const std::vector<std::filesystem::path> files = {
      folder.put("a.xml", deviceSet("<CoordinateDefinitions>" + transform("Image", "Probe", 1) + "</CoordinateDefinitions>")),
      folder.put("b.xml", deviceSet("<CoordinateDefinitions>" + transform("Probe", "Image", 2) + transform("Phantom", "Reference", 3) +
                                    "</CoordinateDefinitions><VolumeReconstruction OutputSpacing=\"1 1 1\"/>"))};
  const auto joined = readDeviceSets(files);
  ASSERT_TRUE(succeeded(joined));
  ASSERT_EQ(joined->transforms.size(), 2u);
  EXPECT_EQ(joined->transforms[0].matrix[3].x, 1.0);
  EXPECT_EQ(joined->transforms[1].from, "Phantom");
  EXPECT_EQ(joined->outputSpacing_mm, glm::dvec3(1.0));
  EXPECT_TRUE(failedWith(readDeviceSets(std::vector<std::filesystem::path>{files[0], folder.path() / "none.xml"}), ErrorCode::notFound));
}

TEST(DeviceSetFile, TheCalibrationProgramsResultIsACalibrationToo) {
  const TempFolder folder;
  const auto set =
      readDeviceSet(folder.put("r.xml",
                               "<ProbeCalibrationResult version=\"2.0\"><CalibrationResults><Transform From=\"Image\" To=\"Probe\"\n"
                               "Matrix=\"1 0 0 5\t0 -6.68987e-005 0 6 0 0 1 7 0 0 0 1\"/></CalibrationResults></ProbeCalibrationResult>"));
  ASSERT_TRUE(succeeded(set));
  ASSERT_EQ(set->transforms.size(), 1u);
  EXPECT_EQ(set->transforms[0].matrix[1][1], -6.68987e-5);
}

TEST(DeviceSetFile, WhatIsNotSaidIsNotMadeUp) {
  const TempFolder folder;
  const auto set = readDeviceSet(folder.put("d.xml", deviceSet("<VolumeReconstruction Compounding=\"ON\"/>")));
  ASSERT_TRUE(succeeded(set));
  EXPECT_TRUE(set->transforms.empty());
  EXPECT_FALSE(set->outputSpacing_mm || set->clipOrigin_px || set->fanAngles_deg || set->interpolation);
  EXPECT_EQ(set->compounding, "ON") << "as written, also from the older `Compounding`";
}

TEST(DeviceSetFile, WhatIsExpectedOfAMatrixReadsAsASentence) {
  const TempFolder folder;
  const auto few = readDeviceSet(folder.put(
      "d.xml", deviceSet("<CoordinateDefinitions><Transform From=\"Image\" To=\"Probe\" Matrix=\"1 2 3\"/></CoordinateDefinitions>")));
  ASSERT_FALSE(few.has_value());
  EXPECT_EQ(
      few.error().sentence(),
      "In \"d.xml\", the Matrix of Image to Probe is \"1 2 3\" (expected: 16 finite numbers (4 x 4, row by row)); correct the header or "
      "export the file again.");
  const auto unnamed = readDeviceSet(folder.put(
      "d.xml",
      deviceSet("<CoordinateDefinitions><Transform From=\"Image\" Matrix=\"1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1\"/></CoordinateDefinitions>")));
  ASSERT_FALSE(unnamed.has_value());
  EXPECT_NE(unnamed.error().sentence().find("two frame names (From and To) are needed"), std::string::npos) << unnamed.error();
}

TEST(DeviceSetFile, WrongFilesAreRefusedInOneSentence) {
  const TempFolder folder;
  EXPECT_TRUE(failedWith(readDeviceSet(folder / "no.xml"), ErrorCode::notFound));
  EXPECT_TRUE(failedWith(readDeviceSet(folder.put("a.xml", "no xml")), ErrorCode::badHeader));
  EXPECT_TRUE(failedWith(readDeviceSet(folder.put("b.xml", "<Other/>")), ErrorCode::badHeader));
  EXPECT_TRUE(failedWith(readDeviceSet(folder.put("c.xml", "<PlusConfiguration><Coord")), ErrorCode::badHeader));
  for (const char* wrong :
       {"<CoordinateDefinitions><Transform From=\"Image\" To=\"Probe\" Matrix=\"1 2 3\"/></CoordinateDefinitions>",
        "<CoordinateDefinitions><Transform From=\"Image\" To=\"Probe\"/></CoordinateDefinitions>",
        "<CoordinateDefinitions><Transform From=\"Image\" Matrix=\"1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1\"/></CoordinateDefinitions>",
        "<CoordinateDefinitions><Transform From=\"Image\" To=\"Probe\" Matrix=\"nan 0 0 0 0 1 0 0 0 0 1 0 0 0 0 "
        "1\"/></CoordinateDefinitions>",
        "<VolumeReconstruction OutputSpacing=\"0.5 0.5\"/>", "<VolumeReconstruction OutputSpacing=\"0.5 0.5 0\"/>",
        "<VolumeReconstruction FanAnglesDeg=\"-45\"/>", "<VolumeReconstruction FanRadiusStartPixel=\"12 13\"/>"})
    EXPECT_TRUE(failedWith(readDeviceSet(folder.put("d.xml", deviceSet(wrong))), ErrorCode::badField)) << wrong;
}

}  // namespace
}  // namespace ew::device_set_test
