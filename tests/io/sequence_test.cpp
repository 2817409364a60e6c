#include "ew/io/sequence.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "files.h"

namespace ew::sequence_test {
namespace {
using namespace test;

const std::string kRows = "1 2 3 4 5 6 7 8 9 10 11 12 0 0 0 1";

glm::dmat4 rowsMatrix() { return matrixFromRows({1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 0, 0, 0, 1}); }

std::string recording(const std::string& sizes, const std::string& fields, const std::string& pixels,
                      const std::string& type = "MET_UCHAR") {
  return "ObjectType = Image\nNDims = 3\nDimSize = " + sizes + "\nElementType = " + type +
         "\nElementSpacing = 1 1 1\nKinds = domain domain list\n" + fields + "ElementDataFile = LOCAL\n" + pixels;
}

/// A sequence of any shape: names, statuses, times and unknown fields in every combination a file can hold.
Sequence anySequence() {
  const auto word = [] { return *rc::gen::nonEmpty(rc::gen::container<std::string>(rc::gen::elementOf(std::string("abcXYZ0189.-")))); };
  const auto status = [] { return *rc::gen::element(PoseStatus::ok, PoseStatus::invalid, PoseStatus::missing); };
  const auto number = [] { return *rc::gen::inRange(-1000000, 1000000) / 7.0; };
  Sequence sequence;
  const bool images = *rc::gen::arbitrary<bool>();
  sequence.width = images ? *rc::gen::inRange(1, 9) : 0;
  sequence.height = images ? *rc::gen::inRange(1, 9) : 0;
  sequence.orientation = *rc::gen::element<std::string>("MF", "MFA", "XX", "");
  sequence.imageType = *rc::gen::element<std::string>("BRIGHTNESS", "RF_REAL", "");
  const int frames = *rc::gen::inRange(1, 6);
  for (int i = 0; i < frames; ++i) {
    SequenceFrame frame;
    if (*rc::gen::arbitrary<bool>()) frame.time_s = number();
    frame.imageStatus = status();
    for (const char* from : {"Probe", "StylusTip", "ToolTop", "Image2"}) {
      if (!*rc::gen::arbitrary<bool>()) continue;
      FrameTransform transform{from, *rc::gen::element<std::string>("Tracker", "Reference", "2ndTracker"), glm::dmat4(1.0), status()};
      for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 3; ++row) transform.matrix[column][row] = number();
      frame.transforms.push_back(transform);
    }
    const int others = *rc::gen::inRange(0, 3);
    for (int k = 0; k < others; ++k) frame.otherFields.emplace_back("Other" + std::to_string(k) + word(), word());
    sequence.frames.push_back(frame);
  }
  sequence.otherFields.emplace_back("Comment", "made by = a test " + word());
  const auto count = static_cast<std::size_t>(sequence.width) * static_cast<std::size_t>(sequence.height) * sequence.frames.size();
  sequence.pixels = *rc::gen::container<std::vector<std::uint8_t>>(count, rc::gen::arbitrary<std::uint8_t>());
  return sequence;
}

RC_GTEST_PROP(Sequence, ComesBackWithEveryFieldAndPixel, ()) {
  const TempFolder folder;
  const Sequence written = anySequence();
  // A frame that says nothing at all has no line to come back from when it is the last word of a recording without images.
  const auto file = folder / "s.igs.mha";
  const auto done = writeSequence(written, file);
  RC_ASSERT(done.has_value());
  const auto read = readSequence(file);
  RC_ASSERT(read.has_value());
  RC_ASSERT(read->width == written.width);
  RC_ASSERT(read->height == written.height);
  RC_ASSERT(read->frames == written.frames);
  RC_ASSERT(read->pixels == written.pixels);
  RC_ASSERT(read->orientation == written.orientation);
  RC_ASSERT(read->imageType == written.imageType);
  RC_ASSERT(read->otherFields == written.otherFields);
}

TEST(SequenceFile, PaddedNumbersAreReadWhateverTheBlanks) {
  const TempFolder folder;
  const auto read = readSequence(
      folder.put("s.mha", recording("2\t            3             2               ", "Seq_Frame0000_Timestamp = 1.5   \n", ramp(12))));
  ASSERT_TRUE(succeeded(read));
  EXPECT_EQ(read->width, 2);
  EXPECT_EQ(read->height, 3);
  ASSERT_EQ(read->frames.size(), 2u);
  EXPECT_EQ(read->frames[0].time_s, 1.5);
  EXPECT_EQ(read->framePixels(1)[5], 11);
}

TEST(SequenceFile, AGapInTheNumberingIsUnknownAndNotTheFrameBefore) {
  const TempFolder folder;
  std::string fields;
  for (const char* frame : {"0000", "0001", "0003"})
    fields += std::string("Seq_Frame") + frame + "_ProbeToTrackerTransform = " + kRows + "\nSeq_Frame" + frame +
              "_ProbeToTrackerTransformStatus = OK\nSeq_Frame" + frame + "_Timestamp = 2\nSeq_Frame" + frame + "_ImageStatus = OK\n";
  const auto read = readSequence(folder.put("s.mha", recording("1 1 4", fields, ramp(4))));
  ASSERT_TRUE(succeeded(read));
  EXPECT_TRUE(read->frames[2].transforms.empty());
  EXPECT_FALSE(read->frames[2].time_s.has_value());
  EXPECT_EQ(read->frames[2].imageStatus, PoseStatus::missing);
  ASSERT_EQ(read->frames[3].transforms.size(), 1u);
  EXPECT_EQ(read->frames[3].transforms[0], (FrameTransform{"Probe", "Tracker", rowsMatrix(), PoseStatus::ok}));
  EXPECT_TRUE(contains(read->notes, "1 of 4 frames"));
}

/// A recording of one pixel an image whose frames of these names carry their own time.
std::string numbered(const std::vector<std::string>& names, int images) {
  std::string fields;
  for (std::size_t n = 0; n < names.size(); ++n)
    fields += "Seq_Frame" + names[n] + "_Timestamp = " + std::to_string(n) + ".5\nSeq_Frame" + names[n] +
              "_ProbeToTrackerTransform = " + kRows + "\n";
  return recording("1 1 " + std::to_string(images), fields, ramp(static_cast<std::size_t>(images)));
}

TEST(SequenceFile, FramesNumberedFromElsewhereAreTakenInTheirOrder) {
  const TempFolder folder;
  for (const auto& names : {std::vector<std::string>{"0010", "0011", "0012"},
                            {"1", "2", "3"},
                            {"00001", "00002", "00003"},
                            {"0000", "0004", "0009"},
                            {"8", "9", "10"}}) {
    const auto read = readSequence(folder.put("s.mha", numbered(names, 3)));
    ASSERT_TRUE(succeeded(read)) << names[0];
    for (std::size_t n = 0; n < 3; ++n) {
      EXPECT_EQ(read->frames[n].time_s, static_cast<double>(n) + 0.5) << names[0];
      EXPECT_EQ(read->frames[n].transforms.size(), 1u) << names[0];
    }
    EXPECT_TRUE(contains(read->notes, "and not from 0 to 2; as they are as many as the images, they were taken in their order"))
        << names[0];
  }
  const auto read = readSequence(folder.put("s.mha", numbered({"0010", "0011"}, 2)));
  ASSERT_TRUE(succeeded(read));
  EXPECT_TRUE(contains(read->notes, "numbered from 10 to 11 and not from 0 to 1"));
}

TEST(SequenceFile, OtherCountsOfDigitsAreTheSameNumbers) {
  const TempFolder folder;
  for (const auto& names : {std::vector<std::string>{"0", "1", "2"}, {"00000", "00001", "00002"}}) {
    const auto read = readSequence(folder.put("s.mha", numbered(names, 3)));
    ASSERT_TRUE(succeeded(read)) << names[0];
    EXPECT_EQ(read->frames[2].time_s, 2.5);
    EXPECT_FALSE(contains(read->notes, "numbered")) << names[0];
  }
}

TEST(SequenceFile, NumbersThatFitNoImageAreRefusedByTheFirstOfThem) {
  const TempFolder folder;
  for (const int images : {2, 4, 11}) {
    const auto refused = readSequence(folder.put("s.mha", numbered({"0010", "0011", "0012"}, images)));
    ASSERT_TRUE(failedWith(refused, ErrorCode::badHeader)) << images;
    EXPECT_NE(refused.error().sentence().find("numbers its frames from 10 to 12 and says something about 3 of them"), std::string::npos)
        << refused.error();
    EXPECT_NE(refused.error().sentence().find("number them from 0 to " + std::to_string(images - 1)), std::string::npos) << refused.error();
  }
}

TEST(SequenceFile, ARecordingOfPosesThatBreaksOffKeepsItsWholeFrames) {
  const TempFolder folder;
  const auto broken = [&](const std::vector<std::string>& names) {
    std::string whole = numbered(names, 0);
    whole.replace(whole.find("1 1 0"), 5, "0 0 9");
    return readPoseSequence(folder.put("s.seq.mha", whole.substr(0, whole.find("ElementDataFile"))));
  };
  const auto one = broken({"0000", "0001"});
  ASSERT_TRUE(succeeded(one));
  EXPECT_EQ(one->frames.size(), 1u);
  EXPECT_TRUE(contains(one->notes, "the 1 frame before it was read."));
  const auto two = broken({"0010", "0011", "0012"});
  ASSERT_TRUE(succeeded(two));
  ASSERT_EQ(two->frames.size(), 2u);
  EXPECT_EQ(two->frames[1].time_s, 1.5);
  EXPECT_TRUE(contains(two->notes, "the 2 frames before it were read."));
}

TEST(SequenceFile, AStatusMayStandInSmallLetters) {
  const TempFolder folder;
  const std::string frame = "Seq_Frame0000_ProbeToTrackerTransform = " + kRows + "\nSeq_Frame0000_ProbeToTrackerTransformStatus = ";
  for (const auto& [word, status] : {std::pair("ok", PoseStatus::ok), std::pair("Missing", PoseStatus::missing)}) {
    const auto read = readSequence(folder.put("s.mha", recording("1 1 1", frame + word + "\n", ramp(1))));
    ASSERT_TRUE(succeeded(read));
    EXPECT_EQ(read->frames[0].transforms[0].status, status) << word;
  }
}

TEST(SequenceFile, InvalidTransformsKeepTheirNumbersAndTheirStatus) {
  const TempFolder folder;
  const auto read = readSequence(folder.put("s.mha", recording("1 1 1",
                                                               // the status may stand before its transform
                                                               "Seq_Frame0000_ProbeToTrackerTransformStatus = INVALID\n"
                                                               "Seq_Frame0000_ProbeToTrackerTransform = " +
                                                                   kRows +
                                                                   "\n"
                                                                   "Seq_Frame0000_AToBTransform = " +
                                                                   kRows +
                                                                   "\nSeq_Frame0000_AToBTransformStatus = OUT_OF_VIEW\n"
                                                                   "Seq_Frame0000_CToDTransform = " +
                                                                   kRows +
                                                                   "\n"
                                                                   "Seq_Frame0000_EToFTransformStatus = INVALID\n",
                                                               ramp(1))));
  ASSERT_TRUE(succeeded(read));
  const auto& frame = read->frames[0];
  ASSERT_EQ(frame.transforms.size(), 3u);
  EXPECT_EQ(frame.transforms[0].status, PoseStatus::invalid);
  EXPECT_EQ(frame.transforms[0].matrix, rowsMatrix());
  EXPECT_EQ(frame.transforms[1].status, PoseStatus::invalid);
  EXPECT_EQ(frame.transforms[2].status, PoseStatus::ok);
  EXPECT_TRUE(contains(read->notes, "1 transform comes without a status"));
  ASSERT_EQ(frame.otherFields.size(), 1u);
  EXPECT_EQ(frame.otherFields[0].first, "EToFTransformStatus");
}

TEST(SequenceFile, FrameNamesAreCutAtTheRightTo) {
  const TempFolder folder;
  const auto read = readSequence(folder.put(
      "s.mha", recording("1 1 1",
                         "Seq_Frame0000_ToolToTrackerTransform = " + kRows + "\nSeq_Frame0000_StylusTipToStylusTransform = " + kRows +
                             "\nSeq_Frame0000_StepperHomeToStepperEncoderTransform = " + kRows + "\nSeq_Frame0000_NothingTransform = x\n",
                         ramp(1))));
  ASSERT_TRUE(succeeded(read));
  const auto& transforms = read->frames[0].transforms;
  ASSERT_EQ(transforms.size(), 3u);
  EXPECT_EQ(transforms[0].from + "|" + transforms[0].to, "Tool|Tracker");
  EXPECT_EQ(transforms[1].from + "|" + transforms[1].to, "StylusTip|Stylus");
  EXPECT_EQ(transforms[2].from + "|" + transforms[2].to, "StepperHome|StepperEncoder");
  EXPECT_EQ(read->frames[0].otherFields[0].first, "NothingTransform");
}

TEST(SequenceFile, ANameThatCouldBeCutTwiceIsNotWritten) {
  const TempFolder folder;
  Sequence sequence;
  sequence.frames.resize(1);
  sequence.frames[0].transforms.push_back({"AToB", "C", glm::dmat4(1.0), PoseStatus::ok});
  EXPECT_TRUE(failedWith(writeSequence(sequence, folder / "s.igs.mha"), ErrorCode::badField));
  sequence.frames[0].transforms.clear();
  sequence.frames[0].otherFields.emplace_back("Broken", "two\nlines");
  EXPECT_TRUE(failedWith(writeSequence(sequence, folder / "s.igs.mha"), ErrorCode::badField));
  EXPECT_TRUE(folder.names().empty());
}

TEST(SequenceFile, ExponentsOfThreeDigitsAreNumbers) {
  const TempFolder folder;
  const auto read = readSequence(folder.put(
      "s.mha",
      recording("1 1 1",
                "Seq_Frame0000_AToBTransform = 8.4e-005 0 0 0 0 1 0 0 0 0 1 2.2e-016 0 0 0 1\nSeq_Frame0000_AToBTransformStatus = OK\n",
                ramp(1))));
  ASSERT_TRUE(succeeded(read));
  EXPECT_EQ(read->frames[0].transforms[0].matrix[0][0], 8.4e-5);
  EXPECT_EQ(read->frames[0].transforms[0].matrix[3][2], 2.2e-16);
}

TEST(SequenceFile, RecordingsOfPosesAloneHaveNoPixels) {
  const TempFolder folder;
  std::string fields;
  for (int i = 0; i < 100; ++i) {
    std::string number = std::to_string(i);
    number.insert(0, 4 - number.size(), '0');
    fields += "Seq_Frame" + number + "_Timestamp = " + number + "\n";
  }
  const auto read = readSequence(folder.put("s.mha", recording("0 0 100", fields, "", "MET_OTHER")));
  ASSERT_TRUE(succeeded(read));
  EXPECT_EQ(read->frames.size(), 100u);
  EXPECT_TRUE(read->pixels.empty());
  EXPECT_TRUE(read->framePixels(7).empty());
  EXPECT_EQ(read->frames[99].time_s, 99.0);
}

TEST(SequenceFile, FlatFilesAreOneFrameAndDummiesOnePixel) {
  const TempFolder folder;
  const auto flat = readSequence(folder.put(
      "flat.mha",
      "ObjectType = Image\nNDims = 2\nDimSize = 3                        2\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n" + ramp(6)));
  ASSERT_TRUE(succeeded(flat));
  EXPECT_EQ(flat->frames.size(), 1u);
  EXPECT_EQ(flat->pixels.size(), 6u);
  const auto dummy = readSequence(folder.put("dummy.mha", recording("1 1 5", "", ramp(5))));
  ASSERT_TRUE(succeeded(dummy));
  EXPECT_EQ(dummy->framePixels(4)[0], 4);
}

TEST(SequenceFile, AnExtraAxisOfOneSliceIsAccepted) {
  const TempFolder folder;
  const auto read =
      readSequence(folder.put("s.mha",
                              "ObjectType = Image\nNDims = 4\nDimSize = 2 2 1 3\nElementSpacing = 1 1 1 1\nElementType = MET_UCHAR\n"
                              "Kinds = domain domain domain list\nElementDataFile = LOCAL\n" +
                                  ramp(12)));
  ASSERT_TRUE(succeeded(read));
  EXPECT_EQ(read->frames.size(), 3u);
  const auto deep = readSequence(folder.put("d.mha",
                                            "ObjectType = Image\nNDims = 4\nDimSize = 2 2 2 3\nElementType = MET_UCHAR\n"
                                            "Kinds = domain domain domain list\nElementDataFile = LOCAL\n" +
                                                ramp(24)));
  EXPECT_TRUE(failedWith(deep, ErrorCode::unsupported));
}

TEST(SequenceFile, AHeaderMayEndWithoutALineBreak) {
  const TempFolder folder;
  ASSERT_FALSE(folder.put("s.raw", ramp(4)).empty());
  const auto read = readSequence(
      folder.put("s.igs.mhd",
                 "ObjectType = Image\r\nNDims = 3\r\nDimSize = 2 1 2\r\nElementType = MET_UCHAR\r\nKinds = domain domain list\r\n"
                 "UltrasoundImageOrientation = MN\r\nElementDataFile = s.raw"));
  ASSERT_TRUE(succeeded(read));
  EXPECT_EQ(read->orientation, "MN");
  EXPECT_EQ(read->pixels, (std::vector<std::uint8_t>{0, 1, 2, 3}));
}

TEST(SequenceFile, KindsDecideNotTheFrameFields) {
  const TempFolder folder;
  const auto withKinds = [&](const std::string& kinds, const std::string& fields) {
    return isSequence(folder.put("s.mha", "ObjectType = Image\nNDims = 3\nDimSize = 1 1 2\nElementType = MET_UCHAR\n" + kinds + fields +
                                              "ElementDataFile = LOCAL\n" + ramp(2)));
  };
  const std::string frameField = "Seq_Frame0000_ImageStatus = OK\n";
  EXPECT_EQ(withKinds("Kinds = domain domain list\n", ""), true);
  EXPECT_EQ(withKinds("Kinds = domain domain               list   \n", frameField), true);
  EXPECT_EQ(withKinds("Kinds = domain domain domain\n", frameField), false);
  EXPECT_EQ(withKinds("", frameField), true);
  EXPECT_EQ(withKinds("", ""), false);
  // Reconstructions with the sequence's Kinds left in them exist: they have a place in the world and no frame field.
  EXPECT_EQ(withKinds("Kinds = domain domain list\nElementSpacing = 0.5 0.5 0.5\n", ""), false);
  EXPECT_EQ(withKinds("Kinds = domain domain list\nElementSpacing = 0.3 0.3 1\n", frameField), true);
}

TEST(SequenceFile, AVolumeIsNotReadAsARecordingNorTheOtherWayRound) {
  const TempFolder folder;
  const auto sweep = folder.put("s.mha", recording("1 1 2", "Seq_Frame0000_ImageStatus = OK\n", ramp(2)));
  EXPECT_TRUE(failedWith(readVolume(sweep), ErrorCode::unsupported));
  const auto volume = folder.put(
      "v.mha",
      "ObjectType = Image\nNDims = 3\nDimSize = 1 1 2\nElementSpacing = 0.5 0.5 0.5\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n" +
          ramp(2));
  EXPECT_TRUE(failedWith(readSequence(volume), ErrorCode::unsupported));
}

TEST(SequenceFile, UnknownFieldsAndThoseBeyondTheLastImageAreKept) {
  const TempFolder folder;
  const auto first = readSequence(
      folder.put("s.mha", recording("1 1 2",
                                    "Comment = a = b\nSeq_Frame0000_ProbePosition = 12.5 mm\nSeq_Frame0001_ProbePosition = 13.5 mm\n"
                                    "Seq_Frame0007_Timestamp = 4\n",
                                    ramp(2))));
  ASSERT_TRUE(succeeded(first));
  EXPECT_EQ(first->frames[1].otherFields, (std::vector<std::pair<std::string, std::string>>{{"ProbePosition", "13.5 mm"}}));
  EXPECT_TRUE(contains(first->notes, "after the last image"));
  ASSERT_TRUE(succeeded(writeSequence(*first, folder / "t.igs.mha")));
  const auto second = readSequence(folder / "t.igs.mha");
  ASSERT_TRUE(succeeded(second));
  EXPECT_EQ(second->frames, first->frames);
  EXPECT_EQ(second->otherFields, first->otherFields);
  EXPECT_EQ(second->otherFields[0], (std::pair<std::string, std::string>("Comment", "a = b")));
}

TEST(SequenceFile, NrrdRecordingsSayStatusInsteadOfImageStatus) {
  const TempFolder folder;
  const std::string text =
      "NRRD0004\n# a comment\ntype: unsigned char\ndimension: 3\nspace dimension: 2\nsizes: 2 1 3\nspace directions: (1,0) (0,1) none\n"
      "kinds: domain domain list\nencoding: gzip\nspace origin: (0,0)\nUltrasoundImageOrientation:=MF\nUltrasoundImageType:=BRIGHTNESS\n"
      "Seq_Frame0000_ProbeToTrackerTransform:=" +
      kRows +
      "\nSeq_Frame0000_ProbeToTrackerTransformStatus:=OK\nSeq_Frame0000_Status:=OK\nSeq_Frame0000_Timestamp:=0.25\nSeq_Frame0001_Status:="
      "INVALID\n"
      "StudyId:=a\\\\b\n\n";
  const auto file = folder.put("s.igs.nrrd", text + deflated(ramp(6), true));
  EXPECT_EQ(isSequence(file), true);
  const auto read = readSequence(file);
  ASSERT_TRUE(succeeded(read));
  EXPECT_EQ(read->width, 2);
  EXPECT_EQ(read->height, 1);
  ASSERT_EQ(read->frames.size(), 3u);
  EXPECT_EQ(read->frames[0].imageStatus, PoseStatus::ok);
  EXPECT_EQ(read->frames[1].imageStatus, PoseStatus::invalid);
  EXPECT_EQ(read->frames[2].imageStatus, PoseStatus::missing);
  EXPECT_EQ(read->frames[0].time_s, 0.25);
  EXPECT_EQ(read->frames[0].transforms[0].matrix, rowsMatrix());
  EXPECT_EQ(read->orientation, "MF");
  EXPECT_EQ(read->otherFields, (std::vector<std::pair<std::string, std::string>>{{"StudyId", "a\\b"}}));
  EXPECT_EQ(read->pixels, (std::vector<std::uint8_t>{0, 1, 2, 3, 4, 5}));
}

TEST(SequenceFile, SixteenBitEchoesAreMappedTogetherSoThatFramesStayComparable) {
  const TempFolder folder;
  const std::vector<std::int16_t> samples{-100, 0, 100, 155};
  const auto read = readSequence(folder.put("s.mha", recording("2 1 2", "UltrasoundImageType = RF_REAL\n", bytesOf(samples), "MET_SHORT")));
  ASSERT_TRUE(succeeded(read));
  EXPECT_EQ(read->pixels, (std::vector<std::uint8_t>{0, 100, 200, 255}));
  EXPECT_TRUE(contains(read->notes, "from -100 to 155"));
}

TEST(SequenceFile, WrongFrameFieldsAreNamed) {
  const TempFolder folder;
  for (const char* field : {"Seq_Frame0000_AToBTransform = 1 2 3", "Seq_Frame0000_Timestamp = noon", "Seq_Frame0000_Timestamp = nan",
                            "Seq_Frame0000_AToBTransform = 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 one"}) {
    const auto read = readSequence(folder.put("s.mha", recording("1 1 1", std::string(field) + "\n", ramp(1))));
    EXPECT_TRUE(failedWith(read, ErrorCode::badField)) << field;
    EXPECT_TRUE(says(read, "Seq_Frame0000_")) << field;
  }
}

TEST(SequenceFile, ReadingStopsWhenAsked) {
  const TempFolder folder;
  Sequence sequence;
  sequence.width = 1024;
  sequence.height = 1024;
  sequence.frames.resize(8);
  sequence.pixels.assign(8u << 20, 3);
  StopAfter soon(3);
  EXPECT_TRUE(failedWith(writeSequence(sequence, folder / "s.igs.mha", soon), ErrorCode::cancelled));
  EXPECT_TRUE(folder.names().empty());
  StopAfter never(1 << 30);
  ASSERT_TRUE(succeeded(writeSequence(sequence, folder / "s.igs.mha", never)));
  StopAfter later(3);
  EXPECT_TRUE(failedWith(readSequence(folder / "s.igs.mha", later), ErrorCode::cancelled));
}

}  // namespace
}  // namespace ew::sequence_test
