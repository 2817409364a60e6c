#include <gtest/gtest.h>

#include "ew/io/sequence.h"
#include "ew/io/sweep.h"
#include "ew/io/volume_file.h"
#include "files.h"

// Headers that other programs write: what only says "not set" is no value, units and axes are what they say, and what is not used is told.

namespace ew::foreign_headers_test {
namespace {
using namespace test;

DeviceSet setWith(const std::string& attributes) {
  const TempFolder folder;
  const auto set =
      readDeviceSet(folder.put("d.xml", "<PlusConfiguration version=\"2.1\"><VolumeReconstruction OutputSpacing=\"0.5 0.5 0.5\" " +
                                            attributes + "/></PlusConfiguration>"));
  EXPECT_TRUE(succeeded(set)) << attributes;
  return set.value_or(DeviceSet{});
}

TEST(ForeignDeviceSet, AClipThatOnlySaysNotSetIsNone) {
  for (const char* clip :
       {"ClipRectangleOrigin=\"0 0\" ClipRectangleSize=\"0 0\"", "ClipRectangleSize=\"0 0\"",
        "ClipRectangleOrigin=\"-1 -1\" ClipRectangleSize=\"-1 -1\"", "ClipRectangleOrigin=\"0 0\"",
        "ClipRectangleOrigin=\"\" ClipRectangleSize=\" \"", "ClipRectangleOrigin=\"nan nan\" ClipRectangleSize=\"NaN NaN\"",
        "ClipRectangleOrigin=\"3 4\" ClipRectangleSize=\"0 20\""}) {
    const DeviceSet set = setWith(clip);
    EXPECT_FALSE(set.clipSize_px.has_value()) << clip;
    EXPECT_FALSE(set.clipOrigin_px.has_value()) << clip;
  }
  EXPECT_TRUE(contains(setWith("ClipRectangleOrigin=\"3 4\" ClipRectangleSize=\"0 20\"").notes, "the size 0 20, which is none"));
  EXPECT_TRUE(contains(setWith("ClipRectangleOrigin=\"3 4\"").notes, "begins at (3 4) but has no size"));
}

TEST(ForeignDeviceSet, AFanThatOnlySaysNotSetIsNone) {
  EXPECT_FALSE(setWith("FanAnglesDeg=\"0 0\" FanOriginPixel=\"0 0\" FanRadiusStartPixel=\"5\" FanRadiusStopPixel=\"9\"").fanAngles_deg);
  EXPECT_FALSE(setWith("FanAnglesDeg=\"-30 30\" FanRadiusStopPixel=\"0\"").fanRadiusStop_px);
  EXPECT_FALSE(setWith("FanAnglesDeg=\"-30 30\" FanRadiusStartPixel=\"-1\" FanRadiusStopPixel=\"-1\"").fanRadiusStart_px);
  EXPECT_FALSE(setWith("FanAnglesDeg=\"\"").fanAngles_deg);
}

TEST(ForeignDeviceSet, WhateverSetsNothingIsNamedWithWhatHoldsInstead) {
  const TempFolder folder;
  const auto notesOf = [&](const std::string& attributes) {
    const auto set =
        readDeviceSet(folder.put("d.xml", "<PlusConfiguration><VolumeReconstruction " + attributes + "/></PlusConfiguration>"));
    EXPECT_TRUE(succeeded(set)) << attributes;
    return set ? set->notes : std::vector<Message>();
  };
  for (const char* spacing : {"", " ", "nan nan nan", "0 0 0", "-1 -1 -1", "0 -1 0"}) {
    const auto notes = notesOf("OutputSpacing=\"" + std::string(spacing) + "\"");
    ASSERT_EQ(notes.size(), 1u) << spacing;
    EXPECT_EQ(notes[0].english(), "The device set states OutputSpacing \"" + std::string(spacing) +
                                      "\", which sets nothing; unless it is given, the size of a voxel comes from the frames.");
  }
  for (const char* angles : {"FanAngles=\"30 30\"", "FanAnglesDeg=\"0 0\"", "FanAngles=\"\"", "FanAnglesDeg=\"NaN nan\""}) {
    const auto notes = notesOf(angles);
    ASSERT_EQ(notes.size(), 1u) << angles;
    EXPECT_TRUE(contains(notes, "which sets nothing; unless a fan is given, none is cut out")) << angles;
  }
  EXPECT_TRUE(contains(notesOf("FanAngles=\"30 30\""), "FanAngles \"30 30\""));
  EXPECT_TRUE(contains(notesOf("ClipRectangleOrigin=\"0 0\" ClipRectangleSize=\"0 0\""), "ClipRectangleSize \"0 0\", which sets nothing"));
  EXPECT_TRUE(contains(notesOf("FanRadiusStartPixel=\"-1\""), "a fan begins at its apex"));
  EXPECT_TRUE(contains(notesOf("FanDepth=\"0\""), "FanDepth \"0\", which sets nothing; a fan ends with the image"));
  EXPECT_TRUE(contains(notesOf("FanOrigin=\"\""), "FanOrigin \"\", which sets nothing; the apex"));
  for (const char* text : {"Interpolation", "CompoundingMode", "Compounding", "ReferenceCoordinateFrame"})
    EXPECT_TRUE(contains(notesOf(std::string(text) + "=\" \""), std::string(text) + " \" \", which sets nothing")) << text;
  EXPECT_TRUE(notesOf("OutputSpacing=\"0.5 0.5 0.5\" FanAngles=\"-30 30\" FanOrigin=\"20 -10\" FanDepth=\"25\"").empty());
}

TEST(ForeignDeviceSet, AnOlderNameSaysWhatTheNewerLeavesOpen) {
  const DeviceSet set = setWith("FanAnglesDeg=\"\" FanAngles=\"-30 30\" CompoundingMode=\"\" Compounding=\"ON\"");
  EXPECT_EQ(set.fanAngles_deg, glm::dvec2(-30, 30));
  EXPECT_EQ(set.compounding, "ON");
}

TEST(ForeignDeviceSet, AnOlderNameBesideTheNewerIsNamedAsOutranked) {
  const DeviceSet set = setWith(
      "FanAngles=\"-10 10\" FanAnglesDeg=\"-30 30\" FanDepth=\"9\" FanRadiusStopPixel=\"20\" CompoundingMode=\"MEAN\" Compounding=\"ON\"");
  EXPECT_EQ(set.fanAngles_deg, glm::dvec2(-30, 30));
  ASSERT_EQ(set.notes.size(), 2u);
  EXPECT_EQ(set.notes[0].english(), "FanAngles \"-10 10\" of the device set is not used, because its FanAnglesDeg says it.");
  EXPECT_EQ(set.notes[1].english(), "FanDepth \"9\" of the device set is not used, because its FanRadiusStopPixel says it.");
}

TEST(ForeignDeviceSet, WhatADeviceSetSaysIsNotCalledAHeader) {
  const auto notes = setWith("Wobble=\"4\" ClipRectangleOrigin=\"5 6\"").notes;
  ASSERT_EQ(notes.size(), 2u);
  EXPECT_EQ(notes[0].english(), "The clip rectangle begins at (5 6) but has no size; unless a clip is given, the whole images are taken.");
  EXPECT_EQ(notes[1].english(), "The device set also states Wobble \"4\", which is not known here and not used.");
}

TEST(ForeignDeviceSet, AValueWithQuotesOfItsOwnGetsNoOthers) {
  const auto notes = setWith("Wobble='\"mm\" \"mm\"' Other=\"4\"").notes;
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_EQ(notes[0].english(), "The device set also states Wobble \"mm\" \"mm\", Other \"4\", which is not known here and not used.");
}

TEST(ForeignDeviceSet, ANumberThatIsNoneAmongOthersIsRefused) {
  const TempFolder folder;
  for (const char* half : {"OutputSpacing=\"0.5 nan 0.5\"", "OutputSpacing=\"nan 0.5 0.5\"", "OutputSpacing=\"0.5 0.5 -1\"",
                           "OutputSpacing=\"inf inf inf\"", "FanAngles=\"-30 nan\"", "ClipRectangleSize=\"nan 4\""}) {
    const auto refused =
        readDeviceSet(folder.put("d.xml", "<PlusConfiguration><VolumeReconstruction " + std::string(half) + "/></PlusConfiguration>"));
    EXPECT_TRUE(failedWith(refused, ErrorCode::badField)) << half;
  }
}

TEST(ForeignDeviceSet, TheHeaderOfARecordingFollowsTheSameRule) {
  Sequence sequence;
  sequence.otherFields = {{"FanAnglesDeg", "30 30"}, {"ClipRectangleSize", " "}};
  const auto stated = clipStatedIn(sequence);
  ASSERT_TRUE(succeeded(stated));
  EXPECT_FALSE(stated->fanAngles_deg || stated->clipSize_px);
  EXPECT_TRUE(contains(stated->notes, "The recording states FanAnglesDeg \"30 30\", which sets nothing"));
  EXPECT_TRUE(contains(stated->notes, "The recording states ClipRectangleSize"));
}

TEST(ForeignDeviceSet, TheOlderDepthOfAFanEndsIt) {
  EXPECT_EQ(setWith("FanAngles=\"-30 30\" FanOrigin=\"20 -10\" FanDepth=\"25\"").fanRadiusStop_px, 25.0);
}

TEST(ForeignDeviceSet, WhatIsNotUsedIsToldAndWhatIsNeutralIsNot) {
  const DeviceSet named =
      setWith("OutputOrigin=\"1 2 3\" OutputExtent=\"0 9 0 9 0 9\" PixelRejectionThreshold=\"20\" SkipInterval=\"2\" Wobble=\"4\"");
  EXPECT_TRUE(
      contains(named.notes, "OutputOrigin \"1 2 3\", OutputExtent \"0 9 0 9 0 9\", which touches sizes and places and is not used"));
  EXPECT_TRUE(contains(named.notes, "PixelRejectionThreshold \"20\", which touches the grey levels"));
  EXPECT_TRUE(contains(named.notes, "SkipInterval \"2\", which touches how many images"));
  EXPECT_TRUE(contains(named.notes, "Wobble \"4\", which is not known here"));
  EXPECT_TRUE(setWith("OutputOrigin=\"0 0 0\" OutputExtent=\" \" NumberOfThreads=\"4\" Optimization=\"FULL\" FillHoles=\"ON\" "
                      "ImageCoordinateFrame=\"Image\" ReferenceCoordinateFrame=\"Tracker\"")
                  .notes.empty());
  EXPECT_EQ(setWith("ReferenceCoordinateFrame=\"Phantom\"").referenceFrame, "Phantom");
}

TEST(ForeignDeviceSet, AReconstructionInsideADeviceIsFound) {
  const TempFolder folder;
  const auto set = readDeviceSet(
      folder.put("d.xml",
                 "<PlusConfiguration><DataCollection><Device Type=\"VirtualVolumeReconstructor\"><VolumeReconstruction "
                 "OutputSpacing=\"0.5 0.5 0.5\" ClipRectangleOrigin=\"1 2\" ClipRectangleSize=\"3 4\"/></Device></DataCollection>"
                 "</PlusConfiguration>"));
  ASSERT_TRUE(succeeded(set));
  EXPECT_EQ(set->clipSize_px, glm::dvec2(3, 4));
}

TEST(ForeignDeviceSet, ASpacingOfNothingIsNotUsedAndAHalfOneIsRefused) {
  const TempFolder folder;
  const auto read = [&](const std::string& spacing) {
    return readDeviceSet(
        folder.put("d.xml", "<PlusConfiguration><VolumeReconstruction OutputSpacing=\"" + spacing + "\"/></PlusConfiguration>"));
  };
  const auto none = read("0 0 0");
  ASSERT_TRUE(succeeded(none));
  EXPECT_FALSE(none->outputSpacing_mm);
  EXPECT_TRUE(contains(none->notes, "OutputSpacing"));
  EXPECT_TRUE(failedWith(read("0.5 0 0.5"), ErrorCode::badField));
  EXPECT_TRUE(failedWith(read("0.5 0.5"), ErrorCode::badField));
}

Sequence trackedFrames() {
  Sequence sequence;
  for (int n = 0; n < 3; ++n) {
    SequenceFrame frame;
    frame.imageStatus = PoseStatus::ok;
    FrameTransform probe{"Probe", "Tracker", glm::dmat4(1.0), PoseStatus::ok};
    probe.matrix[3] = glm::dvec4(10.0, 20.0, 30.0 + n, 1.0);
    frame.transforms = {probe};
    sequence.frames.push_back(frame);
  }
  return sequence;
}

DeviceSet calibratedBy(const std::array<double, 16>& rows) {
  DeviceSet set;
  set.transforms = {{"Image", "Probe", matrixFromRows(rows), PoseStatus::ok}};
  return set;
}

TEST(ForeignCalibration, AMatrixThatCannotBeUsedIsNamedAndNotTheTracker) {
  const auto refusal = [&](const std::array<double, 16>& rows) {
    const DeviceSet set = calibratedBy(rows);
    const auto poses = sweepPoses(trackedFrames(), &set);
    EXPECT_TRUE(failedWith(poses, ErrorCode::badField));
    EXPECT_TRUE(says(poses, "The matrix of Image to Probe in the device set cannot be used"));
    EXPECT_FALSE(says(poses, "tracker"));
    return poses ? std::string() : poses.error().sentence();
  };
  const auto has = [](const std::string& sentence, const char* words) { return sentence.find(words) != std::string::npos; };
  EXPECT_TRUE(has(refusal({0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 0.5, 0, 1, 2, 3, 1}), "rows and columns are exchanged"));
  EXPECT_TRUE(has(refusal({0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 0}), "its last row is 0 0 0 0"));
  EXPECT_TRUE(has(refusal({0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}), "its last row is 0 0 0 0"));
  EXPECT_TRUE(has(refusal({0, 0, 0, 1, 0, 0.5, 0, 2, 0, 0, 0.5, 3, 0, 0, 0, 1}), "its column 1 holds nothing but 0"));
  EXPECT_TRUE(has(refusal({0.5, 0.5, 0, 0, 0.5, 0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 1}), "fall into one plane"));
}

TEST(ForeignCalibration, AFlatImageIsGivenItsThickness) {
  const DeviceSet set = calibratedBy({0.5, 0, 0, 7, 0, 0.5, 0, 8, 0, 0, 0, 9, 0, 0, 0, 1});
  const auto poses = sweepPoses(trackedFrames(), &set);
  ASSERT_TRUE(succeeded(poses));
  EXPECT_EQ(poses->usable, 3u);
  EXPECT_TRUE(contains(poses->notes, "0 in its third column"));
  const glm::dvec4 at = poses->imageToWorld[1]->matrix * glm::dvec4(2.0, 4.0, 0.0, 1.0);
  EXPECT_EQ(glm::dvec3(at), glm::dvec3(18.0, 30.0, 40.0));
}

TEST(ForeignCalibration, PosesThatAreMarkedValidAndAreNoneAreNamed) {
  Sequence sequence = trackedFrames();
  for (SequenceFrame& frame : sequence.frames) frame.transforms[0].matrix = glm::transpose(frame.transforms[0].matrix);
  const DeviceSet set = calibratedBy({0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 1});
  const auto poses = sweepPoses(sequence, &set);
  EXPECT_TRUE(failedWith(poses, ErrorCode::badField));
  EXPECT_TRUE(says(poses, "matrix of Probe to Tracker cannot be used in any frame"));
  EXPECT_TRUE(says(poses, "rows and columns are exchanged"));
}

Result<VolumeReadResult> nrrd(const std::string& header, const std::string& samples = ramp(12), const VolumeReadOptions& options = {}) {
  const TempFolder folder;
  return readVolume(folder.put("a.nrrd", "NRRD0005\ntype: uchar\nencoding: raw\n" + header + "\n" + samples), noProgress(), {}, options);
}

TEST(ForeignNrrd, UnitsOfASpaceAreUsed) {
  const std::string directions =
      "dimension: 3\nsizes: 2 3 2\nspace: LPS\nspace directions: (0.05,0,0) (0,0.05,0) (0,0,0.1)\nspace origin: (1,2,3)\n";
  const auto cm = nrrd(directions + "space units: \"cm\" \"cm\" \"cm\"\n");
  ASSERT_TRUE(succeeded(cm));
  EXPECT_LT(glm::length(cm->volume.grid.spacing_mm - glm::dvec3(0.5, 0.5, 1.0)), 1e-12);
  EXPECT_LT(glm::length(cm->volume.grid.origin_mm - glm::dvec3(10.0, 20.0, 30.0)), 1e-12);
  for (const char* unit : {"um", "microns", "micrometer", "Micrometres", "\xC2\xB5m"}) {
    const std::string q = "\"" + std::string(unit) + "\"";
    const auto um = nrrd(directions + "space units: " + q + " " + q + " " + q + "\n");
    ASSERT_TRUE(succeeded(um)) << unit;
    EXPECT_NEAR(um->volume.grid.spacing_mm.x, 5e-5, 1e-16) << unit;
  }
  const auto once = nrrd(directions + "space units: \"cm\"\n");
  ASSERT_TRUE(succeeded(once));
  EXPECT_EQ(once->volume.grid, cm->volume.grid) << "one word is meant for every axis";
  const auto same = nrrd(directions + "space units: \"mm\" \"mm\" \"mm\"\n");
  ASSERT_TRUE(succeeded(same));
  EXPECT_EQ(same->volume.grid.spacing_mm, glm::dvec3(0.05, 0.05, 0.1));
}

TEST(ForeignNrrd, AUnitOfNoLengthLeavesTheSpacingUnknown) {
  const auto odd =
      nrrd("dimension: 3\nsizes: 2 3 2\nspace: LPS\nspace directions: (2,0,0) (0,2,0) (0,0,2)\nspace units: \"furlong\" \"mm\" \"mm\"\n");
  ASSERT_TRUE(succeeded(odd));
  EXPECT_FALSE(odd->spacingKnown);
  EXPECT_NE(odd->spacingProblem.english().find("\"furlong\", which is no unit of length"), std::string::npos);
}

TEST(ForeignNrrd, FewerUnitsThanAxesLeaveTheSpacingUnknown) {
  const auto two = nrrd("dimension: 3\nsizes: 2 3 2\nspacings: 0.05 0.05 0.05\nunits: \"cm\" \"cm\"\n");
  ASSERT_TRUE(succeeded(two));
  EXPECT_FALSE(two->spacingKnown);
  EXPECT_EQ(two->spacingProblem.english(),
            "\"a.nrrd\" gives 2 units (\"cm\" \"cm\") for 3 axes, so that the sizes are not known; give the spacing in mm.");
  const auto flat = nrrd("dimension: 2\nsizes: 4 3\nspace dimension: 2\nspace directions: (0.05,0) (0,0.05)\nspace units: \"cm\" \"cm\"\n");
  ASSERT_TRUE(succeeded(flat));
  EXPECT_EQ(flat->spacingProblem.english().find("units"), std::string::npos) << flat->spacingProblem.english();
}

TEST(ForeignNrrd, SpacingsThatContradictTheDirectionsAreTold) {
  const std::string start = "dimension: 3\nsizes: 2 3 2\nspace: LPS\nspace directions: (2,0,0) (0,2,0) (0,0,3)\n";
  const auto differ = nrrd(start + "spacings: 0.5 2 3\n");
  ASSERT_TRUE(succeeded(differ));
  EXPECT_EQ(differ->volume.grid.spacing_mm, glm::dvec3(2, 2, 3));
  EXPECT_TRUE(contains(differ->notes,
                       "The file gives two voxel sizes: 2 x 2 x 3 mm by its space directions, which were used, and 0.5 x 2 x 3 by its "
                       "spacings."));
  for (const char* same : {"spacings: 2 2 3\n", "spacings: nan nan nan\n", ""}) {
    const auto one = nrrd(start + same);
    ASSERT_TRUE(succeeded(one)) << same;
    EXPECT_FALSE(contains(one->notes, "two voxel sizes")) << same;
  }
}

TEST(ForeignNrrd, SpacingsOfAxesHaveUnitsAndPlacesToo) {
  const auto cells = nrrd("dimension: 3\nsizes: 2 3 2\nspacings: 0.1 0.2 0.4\nunits: \"cm\" \"cm\" \"cm\"\naxis mins: 1 2 3\n");
  ASSERT_TRUE(succeeded(cells));
  EXPECT_LT(glm::length(cells->volume.grid.spacing_mm - glm::dvec3(1.0, 2.0, 4.0)), 1e-12);
  EXPECT_LT(glm::length(cells->volume.grid.origin_mm - glm::dvec3(10.5, 21.0, 32.0)), 1e-12) << "the edge of the first cell";
  const auto nodes = nrrd("dimension: 3\nsizes: 2 3 2\naxis mins: 1 2 3\naxis maxs: 2 6 5\ncenterings: node node node\n");
  ASSERT_TRUE(succeeded(nodes));
  EXPECT_EQ(nodes->volume.grid.spacing_mm, glm::dvec3(1.0, 2.0, 2.0));
  EXPECT_EQ(nodes->volume.grid.origin_mm, glm::dvec3(1.0, 2.0, 3.0));
  const auto unset = nrrd("dimension: 3\nsizes: 2 3 2\nspacings: 0.5 0.5 0.5\naxis mins: nan nan nan\n");
  ASSERT_TRUE(succeeded(unset));
  EXPECT_EQ(unset->volume.grid.origin_mm, glm::dvec3(0.0));
}

TEST(ForeignNrrd, WhatIsNotUsedIsTold) {
  const auto read = nrrd("dimension: 3\nsizes: 2 3 2\nspacings: 0.5 0.5 0.5\nthicknesses: 1 1 1\nold min: 0\nold max: 4095\n");
  ASSERT_TRUE(succeeded(read));
  EXPECT_TRUE(contains(read->notes, "thicknesses \"1 1 1\", which touches sizes"));
  EXPECT_TRUE(contains(read->notes, "old min \"0\", old max \"4095\", which touches the grey levels"));
}

TEST(ForeignNrrd, AFirstAxisOfTimeHoldsVolumesWhateverTheirCount) {
  const std::string space = "space: LPS\nspace directions: none (0.5,0,0) (0,0.5,0) (0,0,0.5)\n";
  for (const int steps : {2, 3, 4, 5}) {
    std::string samples;
    for (int voxel = 0; voxel < 4; ++voxel)
      for (int step = 0; step < steps; ++step) samples += static_cast<char>(10 * step + voxel);
    for (const char* kinds :
         {"kinds: list domain domain domain\n", "kinds: time domain domain domain\n", "kinds: none domain domain domain\n", ""}) {
      const std::string header = "dimension: 4\nsizes: " + std::to_string(steps) + " 2 2 1\n" + space + kinds;
      const auto first = nrrd(header, samples);
      ASSERT_TRUE(succeeded(first)) << header;
      EXPECT_EQ(first->timeSteps, static_cast<std::uint64_t>(steps)) << header;
      EXPECT_EQ(first->volume.echo, (std::vector<std::uint8_t>{0, 1, 2, 3}));
      const auto second = nrrd(header, samples, {.timeStep = 2});
      ASSERT_TRUE(succeeded(second));
      EXPECT_EQ(second->volume.echo, (std::vector<std::uint8_t>{10, 11, 12, 13}));
      EXPECT_FALSE(contains(second->notes, "colours"));
      EXPECT_TRUE(failedWith(nrrd(header, samples, {.timeStep = static_cast<std::uint64_t>(steps) + 1}), ErrorCode::badUsage));
    }
  }
}

TEST(ForeignNrrd, ALastAxisOfTimeHoldsVolumesWithAndWithoutAPlaceInSpace) {
  const TempFolder folder;
  const std::string placed = "space: LPS\nspace directions: (0.5,0,0) (0,0.5,0) (0,0,0.5) none\n";
  for (const std::string& geometry : {placed, std::string("spacings: 0.5 0.5 0.5 nan\n"), std::string()})
    for (const char* last : {"time", "list"}) {
      const std::string header = "dimension: 4\nsizes: 2 2 2 3\nkinds: space space space " + std::string(last) + "\n" + geometry;
      const auto file = folder.put("t.nrrd", "NRRD0005\ntype: uchar\nencoding: raw\n" + header + "\n" + ramp(24));
      EXPECT_EQ(isSequence(file), Result<bool>(false)) << header;
      const auto second = readVolume(file, noProgress(), {}, {.timeStep = 2});
      ASSERT_TRUE(succeeded(second)) << header;
      EXPECT_EQ(second->timeSteps, 3u) << header;
      EXPECT_EQ(second->volume.echo, (std::vector<std::uint8_t>{8, 9, 10, 11, 12, 13, 14, 15})) << header;
    }
}

/// 2 x 2 x 1 voxels at three moments: voxel v of moment m holds 10 m + v.
std::string threeMoments(bool timeFirst) {
  std::string samples;
  for (int outer = 0; outer < (timeFirst ? 4 : 3); ++outer)
    for (int inner = 0; inner < (timeFirst ? 3 : 4); ++inner)
      samples += static_cast<char>(timeFirst ? 10 * inner + outer : 10 * outer + inner);
  return samples;
}

TEST(ForeignNrrd, AnAxisOfTimeIsKnownByItsUnitItsSpacingOrItsDirectionWithoutAKind) {
  const std::string kindsOfNone = "kinds: none domain domain domain\n", kindsOfDomains = "kinds: domain domain domain domain\n";
  const std::string first = "dimension: 4\nsizes: 3 2 2 1\n", last = "dimension: 4\nsizes: 2 2 1 3\n";
  struct Case {
    std::string header;
    bool timeFirst;
  };
  std::vector<Case> cases;
  for (const std::string& kinds : {std::string(), kindsOfDomains}) {
    cases.push_back({first + kinds + "spacings: nan 0.5 0.5 2\n", true});
    cases.push_back({first + kinds + "spacings: 0.04 0.5 0.5 2\nunits: \"s\" \"mm\" \"mm\" \"mm\"\n", true});
    cases.push_back({first + kinds + "spacings: 40 0.5 0.5 2\nunits: \"ms\" \"\" \"\" \"\"\n", true});
    cases.push_back({first + kinds + "space: LPS\nspace directions: none (0.5,0,0) (0,0.5,0) (0,0,2)\n", true});
    cases.push_back(
        {first + kinds + "space: left-posterior-superior-time\nspace directions: (0,0,0,0.04) (0.5,0,0,0) (0,0.5,0,0) (0,0,2,0)\n", true});
    cases.push_back({last + kinds + "spacings: 0.5 0.5 2 nan\n", false});
    cases.push_back({last + kinds + "spacings: 0.5 0.5 2 0.04\nunits: \"mm\" \"mm\" \"mm\" \"seconds\"\n", false});
    cases.push_back({last + kinds + "space: LPS\nspace directions: (0.5,0,0) (0,0.5,0) (0,0,2) none\n", false});
  }
  cases.push_back({first + kindsOfNone + "spacings: nan 0.5 0.5 2\n", true});
  cases.push_back({last + "kinds: ??? ??? ??? ???\nspacings: 0.5 0.5 2 nan\n", false});
  for (const auto& [header, timeFirst] : cases) {
    const auto second = nrrd(header, threeMoments(timeFirst), {.timeStep = 2});
    ASSERT_TRUE(succeeded(second)) << header;
    EXPECT_EQ(second->timeSteps, 3u) << header;
    EXPECT_EQ(second->volume.echo, (std::vector<std::uint8_t>{10, 11, 12, 13})) << header;
    EXPECT_EQ(second->volume.grid.spacing_mm, glm::dvec3(0.5, 0.5, 2.0)) << header;
    EXPECT_TRUE(second->spacingKnown) << header;
    EXPECT_FALSE(contains(second->notes, "not used")) << header;
  }
}

TEST(ForeignNrrd, HintsOfTimeThatContradictEachOtherAreNamed) {
  const std::string first = "dimension: 4\nsizes: 3 2 2 1\n";
  struct Case {
    std::string header;
    const char* one;
    const char* other;
  };
  for (const auto& [header, one, other] :
       {Case{first + "kinds: domain domain domain time\nspacings: 1 0.5 0.5 2\nunits: \"s\" \"mm\" \"mm\" \"\"\n",
             "axis 1 has the unit \"s\"", "axis 4 has the kind \"time\""},
        Case{first + "kinds: space space space time\nspacings: nan 0.5 0.5 2\n", "axis 1 alone has no spacing",
             "axis 1 has the kind \"space\""},
        Case{first + "spacings: nan 0.5 0.5 2\nunits: \"mm\" \"mm\" \"mm\" \"\"\n", "axis 1 alone has no spacing",
             "axis 1 has the unit \"mm\""},
        Case{first + "spacings: nan 0.5 0.5 2\nunits: \"\" \"mm\" \"mm\" \"ms\"\n", "axis 4 has the unit \"ms\"",
             "axis 1 alone has no spacing"},
        Case{first + "kinds: RGB-color domain domain domain\nunits: \"s\" \"mm\" \"mm\" \"mm\"\n", "axis 1 has the unit \"s\"",
             "axis 1 has the kind \"RGB-color\""},
        Case{first + "kinds: time domain domain domain\nunits: \"mm\" \"mm\" \"mm\" \"mm\"\n", "axis 1 has the kind \"time\"",
             "axis 1 has the unit \"mm\""}}) {
    const auto read = nrrd(header, threeMoments(true));
    EXPECT_TRUE(failedWith(read, ErrorCode::badField)) << header;
    EXPECT_TRUE(says(read, one)) << header;
    EXPECT_TRUE(says(read, other)) << header;
    EXPECT_TRUE(says(read, "contradict each other")) << header;
  }
}

TEST(ForeignNrrd, SecondsBetweenImagesAreNoMillimetres) {
  const auto read = nrrd("dimension: 3\nsizes: 2 3 2\nspacings: 0.5 0.5 0.04\nunits: \"mm\" \"mm\" \"s\"\n");
  ASSERT_TRUE(succeeded(read));
  EXPECT_FALSE(read->spacingKnown);
  EXPECT_NE(read->spacingProblem.english().find("no spacing along its axis 3"), std::string::npos) << read->spacingProblem;
}

TEST(ForeignNrrd, FramesThatAreWovenIntoEachOtherAreNotDropped) {
  const TempFolder folder;
  const auto read = readSequence(folder.put("s.nrrd",
                                            "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 4 3 2\nkinds: list domain domain\nencoding: raw\n"
                                            "Seq_Frame0000_Timestamp:=1\nSeq_Frame0003_Timestamp:=2\n\n" +
                                                ramp(24)));
  EXPECT_TRUE(failedWith(read, ErrorCode::unsupported));
  EXPECT_TRUE(says(read, "runs over its 4 frames"));
}

TEST(ForeignNrrd, AnAxisOfTimeInTheMiddleIsNamed) {
  const auto read = nrrd("dimension: 4\nsizes: 2 3 2 1\nkinds: domain list domain domain\n");
  EXPECT_TRUE(failedWith(read, ErrorCode::unsupported));
  EXPECT_TRUE(says(read, "Axis 2"));
}

TEST(ForeignNrrd, ComponentsOfAVectorAreNoColours) {
  const TempFolder folder;
  const auto read = readVolume(folder.put("a.nrrd",
                                          "NRRD0005\ntype: float\nendian: little\nencoding: raw\ndimension: 4\nsizes: 3 1 1 1\n"
                                          "kinds: vector domain domain domain\n\n" +
                                              std::string(12, '\0')));
  EXPECT_TRUE(failedWith(read, ErrorCode::unsupported));
  EXPECT_TRUE(says(read, "3 components"));
}

TEST(ForeignNrrd, ValuesOfAKindThatIsNoColourHaveNoLuminance) {
  const auto ofKind = [](const std::string& kind, int count) {
    return nrrd("dimension: 4\nsizes: " + std::to_string(count) + " 1 2 2\nkinds: " + kind + " domain domain domain\n",
                ramp(static_cast<std::size_t>(4 * count)));
  };
  for (const auto& [kind, count] :
       {std::pair("3-gradient", 3), std::pair("3-normal", 3), std::pair("covariant-vector", 3), std::pair("4-vector", 4),
        std::pair("quaternion", 4), std::pair("HSV-color", 3), std::pair("XYZ-color", 3)}) {
    const auto read = ofKind(kind, count);
    EXPECT_TRUE(failedWith(read, ErrorCode::unsupported)) << kind;
    EXPECT_TRUE(says(read, std::string("of the kind \"") + kind + "\"")) << kind;
  }
  for (const auto& [kind, count] :
       {std::pair("vector", 3), std::pair("vector", 4), std::pair("RGB-color", 3), std::pair("RGBA-color", 4), std::pair("3-color", 3)})
    EXPECT_TRUE(succeeded(ofKind(kind, count))) << kind;
  EXPECT_TRUE(failedWith(ofKind("vector", 2), ErrorCode::unsupported));
}

TEST(ForeignSequence, ASweepRewrittenByItkKeepsItsPoses) {
  // ITK keeps the fields, drops Kinds and writes a geometry of its own.
  const TempFolder folder;
  const auto read = readSequence(folder.put(
      "s.mha",
      "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\nCompressedData = False\n"
      "TransformMatrix = 1 0 0 0 1 0 0 0 1\nOffset = 0 0 0\nCenterOfRotation = 0 0 0\nAnatomicalOrientation = RAI\nElementSpacing = 1 1 1\n"
      "Seq_Frame0000_ImageStatus = OK\nSeq_Frame0000_ProbeToTrackerTransform = 1 0 0 5 0 1 0 0 0 0 1 0 0 0 0 1\n"
      "Seq_Frame0000_ProbeToTrackerTransformStatus = OK\nSeq_Frame0000_Timestamp = 1.5\nSeq_Frame0001_Timestamp = 2\n"
      "UltrasoundImageOrientation = MF\nDimSize = 3 2 2\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n" +
          ramp(12)));
  ASSERT_TRUE(succeeded(read));
  EXPECT_EQ(read->frames.size(), 2u);
  EXPECT_EQ(read->frames[0].transforms.at(0).matrix[3].x, 5.0);
  EXPECT_EQ(read->frames[0].time_s, 1.5);
  EXPECT_EQ(read->orientation, "MF");
}

TEST(ForeignSequence, AScaleOfTheHeaderThatPosesReplaceIsTold) {
  const TempFolder folder;
  const auto read = readSequence(folder.put("s.mha",
                                            "ObjectType = Image\nNDims = 3\nKinds = domain domain list\nElementSpacing = 0.2 0.3 1\n"
                                            "Seq_Frame0000_Timestamp = 1\nDimSize = 3 2 2\nElementType = MET_UCHAR\n"
                                            "ElementDataFile = LOCAL\n" +
                                                ramp(12)));
  ASSERT_TRUE(succeeded(read));
  EXPECT_TRUE(contains(read->notes, "spacing \"0.2 x 0.3 mm a pixel\", which touches sizes"));
}

std::string metaHeader(const std::string& more, const std::string& file = "LOCAL") {
  return "ObjectType = Image\nNDims = 3\n" + more + "DimSize = 2 3 2\nElementType = MET_UCHAR\nElementDataFile = " + file + "\n";
}

TEST(ForeignMeta, UnitsOfDistanceAreUsed) {
  const TempFolder folder;
  const auto read =
      readVolume(folder.put("a.mha", metaHeader("DistanceUnits = um\nOffset = 1000 0 0\nElementSpacing = 500 500 1000\n") + ramp(12)));
  ASSERT_TRUE(succeeded(read));
  EXPECT_LT(glm::length(read->volume.grid.spacing_mm - glm::dvec3(0.5, 0.5, 1.0)), 1e-12);
  EXPECT_NEAR(read->volume.grid.origin_mm.x, 1.0, 1e-12);
}

TEST(ForeignMeta, TheLastPartOfAForeignPathIsTried) {
  const TempFolder folder;
  static_cast<void>(folder.put("v.raw", ramp(12)));
  for (const char* path : {"C:\\Users\\me\\data\\v.raw", "/home/somebody/v.raw", "..\\v.raw"}) {
    const auto read = readVolume(folder.put("a.mhd", metaHeader("ElementSpacing = 0.5 0.5 0.5\n", path)));
    ASSERT_TRUE(succeeded(read)) << path;
    EXPECT_EQ(read->volume.echo.size(), 12u);
  }
  EXPECT_TRUE(says(readVolume(folder.put("b.mhd", metaHeader("", "C:\\gone.raw"))), "which is not there"));
}

TEST(ForeignMeta, TheWordsForTheAxesAreTrueOrLeftOut) {
  const TempFolder folder;
  const auto wordsFor = [&](const glm::dmat3& directions) {
    Volume volume;
    volume.grid.dims = {2, 2, 2};
    volume.grid.directions = directions;
    volume.echo.resize(8);
    EXPECT_TRUE(succeeded(writeVolume(volume, folder / "w.mha", noProgress(), {.compress = false})));
    const std::string text = bytesOfFile(folder / "w.mha");
    const auto at = text.find("AnatomicalOrientation = ");
    return at == std::string::npos ? std::string() : text.substr(at + 24, 3);
  };
  EXPECT_EQ(wordsFor(glm::dmat3(1.0)), "RAI");
  EXPECT_EQ(wordsFor(glm::dmat3(glm::dvec3(-1, 0, 0), glm::dvec3(0, -1, 0), glm::dvec3(0, 0, 1))), "LPI");
  EXPECT_EQ(wordsFor(glm::dmat3(glm::dvec3(0, 0, 1), glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0))), "IRA");
  const double c = std::sqrt(0.5);
  EXPECT_EQ(wordsFor(glm::dmat3(glm::dvec3(c, c, 0), glm::dvec3(-c, c, 0), glm::dvec3(0, 0, 1))), "");
}

TEST(ForeignMeta, WordsThatContradictTheMatrixAreTold) {
  const TempFolder folder;
  const auto notes = [&](const std::string& words, const std::string& matrix) {
    const auto read = readVolume(folder.put(
        "a.mha",
        metaHeader("AnatomicalOrientation = " + words + "\nTransformMatrix = " + matrix + "\nElementSpacing = 0.5 0.5 0.5\n") + ramp(12)));
    EXPECT_TRUE(succeeded(read));
    return read ? read->notes : std::vector<Message>();
  };
  EXPECT_FALSE(contains(notes("RAI", "1 0 0 0 1 0 0 0 1"), "AnatomicalOrientation"));
  EXPECT_FALSE(contains(notes("LPS", "1 0 0 0 1 0 0 0 1"), "AnatomicalOrientation")) << "the same, meant as where the axes go";
  EXPECT_FALSE(contains(notes("???", "0 0 1 1 0 0 0 1 0"), "AnatomicalOrientation"));
  EXPECT_TRUE(contains(notes("RAI", "0 0 1 1 0 0 0 1 0"), "AnatomicalOrientation \"RAI\", which touches sizes and places"));
}

TEST(ForeignMeta, ASizeOfSamplesThatIsNotTheirSpacingIsTold) {
  const TempFolder folder;
  const auto notes = [&](const std::string& size) {
    const auto read = readVolume(folder.put("a.mha", metaHeader("ElementSpacing = 0.5 0.5 2\nElementSize = " + size + "\n") + ramp(12)));
    EXPECT_TRUE(succeeded(read));
    return read ? read->notes : std::vector<Message>();
  };
  EXPECT_FALSE(contains(notes("0.5 0.50 2"), "ElementSize"));
  EXPECT_TRUE(contains(notes("0.5 0.5 1"), "ElementSpacing \"0.5 0.5 2\" was used; ElementSize \"0.5 0.5 1\""));
}

TEST(ForeignMeta, NoZeroHasASign) {
  const TempFolder folder;
  Volume volume;
  volume.grid.dims = {1, 1, 1};
  volume.grid.origin_mm = {-0.0, 1.0, -0.0};
  volume.grid.directions[1] = {-0.0, 1.0, -0.0};
  volume.echo.resize(1);
  ASSERT_TRUE(succeeded(writeVolume(volume, folder / "z.mha", noProgress(), {.compress = false})));
  EXPECT_EQ(bytesOfFile(folder / "z.mha").find("-0"), std::string::npos);
}

}  // namespace
}  // namespace ew::foreign_headers_test
