#include "ew/scanning/recording.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>

#include "ew/core/numbers.h"
#include "ew/io/safe_file.h"
#include "ew/io/sequence.h"
#include "io/files.h"
#include "scanning/small_scan.h"

namespace ew::recording_test {
namespace {

ScanRecording recordingOf(int frames) {
  ScanRecording recording;
  recording.caseId = "a-case";
  recording.title = "Pain \"after\" meals \xC3\xBC\nand more";
  recording.size_px = {320, 240};
  for (int n = 0; n < frames; ++n) {
    recording.log.addFrame(test::movingState(n));
    if (n == 20) recording.log.setFrozen(100.0 + (n + 0.5) / 30.0, true);
    if (n == 21) recording.log.setFrozen(100.0 + (n + 0.2) / 30.0, false);
  }
  recording.log.addNote(recording.log.end_s() + 0.5, "mark", "here it is");
  return recording;
}

/// As the readers of PLUS and 3D Slicer take a sequence metafile: lines of at most 1000 characters of "key = value" up to ElementDataFile,
/// and of each Seq_Frame0000_NAME those that they know by their ending.
struct OtherProgram {
  std::map<int, std::map<std::string, std::string>> frames;
  std::map<std::string, std::string> header;
  std::size_t longestLine = 0;

  explicit OtherProgram(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    for (std::string line; std::getline(in, line);) {
      longestLine = std::max(longestLine, line.size());
      const auto equals = line.find(" = ");
      if (equals == std::string::npos) continue;
      const std::string key = line.substr(0, equals), value = line.substr(equals + 3);
      if (key.starts_with("Seq_Frame")) {
        const auto underscore = key.find('_', 9);
        frames[std::stoi(key.substr(9, underscore - 9))][key.substr(underscore + 1)] = value;
      } else {
        header[key] = value;
      }
      if (key == "ElementDataFile") break;
    }
  }
};

class Recording : public ::testing::Test {
 protected:
  test::TempFolder folder;
};

}  // namespace

TEST_F(Recording, IsReadBackAsItWasWritten) {
  const ScanRecording written = recordingOf(700);
  ASSERT_TRUE(writeRecording(written, folder / "r.seq.mha"));
  const auto read = readRecording(folder / "r.seq.mha");
  ASSERT_TRUE(read) << read.error();
  EXPECT_EQ(read->caseId, written.caseId);
  EXPECT_EQ(read->title, written.title);
  EXPECT_EQ(read->size_px, written.size_px);
  EXPECT_TRUE(read->notes.empty());
  ASSERT_EQ(read->log.events().size(), written.log.events().size());
  for (std::size_t n = 0; n < written.log.events().size(); ++n) ASSERT_EQ(read->log.events()[n], written.log.events()[n]) << n;
  EXPECT_TRUE(isRecording(folder / "r.seq.mha").value());
}

TEST_F(Recording, OfABodyAtRestHasNoWordOfItAndOneWithoutThatWordIsAtRest) {
  ScanRecording written = recordingOf(1);
  ASSERT_TRUE(writeRecording(written, folder / "r.seq.mha"));
  EXPECT_EQ(readTextFile(folder / "r.seq.mha")->find("BodyState"), std::string::npos);
  EXPECT_EQ(readRecording(folder / "r.seq.mha")->log.frame(0).body, BodyState{});
  written = recordingOf(2);
  ASSERT_TRUE(writeRecording(written, folder / "r.seq.mha"));
  EXPECT_NE(readTextFile(folder / "r.seq.mha")->find("BodyState"), std::string::npos);
  const BodyState body = readRecording(folder / "r.seq.mha")->log.frame(1).body;
  EXPECT_EQ(body, written.log.frame(1).body);
  EXPECT_NE(body, BodyState{});
}

TEST_F(Recording, GapsOfMorePlacesThanALineHoldsAreReadBackWhole) {
  ScanRecording written;
  written.size_px = {320, 240};
  ScanState state = test::movingState(0);
  state.gaps_mm.clear();
  for (int n = 0; n < 300; ++n) state.gaps_mm.push_back(0.125F * static_cast<float>(n));
  written.log.addFrame(state);
  ASSERT_TRUE(writeRecording(written, folder / "r.seq.mha"));
  EXPECT_LT(OtherProgram(folder / "r.seq.mha").longestLine, 1000U);
  const auto read = readRecording(folder / "r.seq.mha");
  ASSERT_TRUE(read) << read.error();
  EXPECT_EQ(read->log.frame(0).gaps_mm, state.gaps_mm);
}

TEST_F(Recording, OtherProgramsReadItAsASequenceOfTransforms) {
  const ScanRecording written = recordingOf(120);
  ASSERT_TRUE(writeRecording(written, folder / "r.seq.mha"));
  const OtherProgram other(folder / "r.seq.mha");
  EXPECT_LT(other.longestLine, 1000U);
  EXPECT_EQ(other.header.at("Kinds"), "domain domain list");
  std::istringstream sizes(other.header.at("DimSize"));
  int width = -1, height = -1, frames = -1;
  sizes >> width >> height >> frames;
  EXPECT_EQ(frames, static_cast<int>(other.frames.size()));
  ASSERT_EQ(other.frames.size(), 121U) << "120 images, and one frame of what came after them";
  double last_s = 0.0;
  for (int n = 0; n < 120; ++n) {
    const auto& fields = other.frames.at(n);
    const auto rows = parseNumbers(fields.at("ProbeToWorldTransform"));
    ASSERT_TRUE(rows && rows->size() == 16);
    const glm::dmat4& expected = test::movingState(n).pose.probeToWorld.matrix;
    for (int row = 0; row < 4; ++row)
      for (int column = 0; column < 4; ++column) ASSERT_EQ((*rows)[static_cast<std::size_t>(4 * row + column)], expected[column][row]) << n;
    EXPECT_EQ(fields.at("ProbeToWorldTransformStatus"), "OK");
    const double time_s = std::stod(fields.at("Timestamp"));
    EXPECT_GT(time_s, last_s);
    last_s = time_s;
  }
  EXPECT_EQ(other.frames.at(120).at("ProbeToWorldTransformStatus"), "INVALID") << "nobody takes it for a pose";
}

TEST_F(Recording, FieldsOfOtherProgramsDoNotHarmIt) {
  ASSERT_TRUE(writeRecording(recordingOf(50), folder / "r.seq.mha"));
  auto sequence = readPoseSequence(folder / "r.seq.mha");
  ASSERT_TRUE(sequence);
  // As a program would that adds a tracker of its own and keeps what it does not know.
  for (SequenceFrame& frame : sequence->frames) {
    frame.transforms.insert(frame.transforms.begin(), {"Stylus", "Tracker", glm::dmat4(1.0), PoseStatus::ok});
    frame.otherFields.emplace_back("Comment", "kept");
  }
  ASSERT_TRUE(writeSequence(*sequence, folder / "s.seq.mha"));
  const auto read = readRecording(folder / "s.seq.mha");
  ASSERT_TRUE(read) << read.error();
  EXPECT_EQ(read->log.events(), recordingOf(50).log.events());
}

TEST_F(Recording, CutAnywhereGivesTheFramesBeforeTheCutOrASentence) {
  const ScanRecording written = recordingOf(60);
  ASSERT_TRUE(writeRecording(written, folder / "r.seq.mha"));
  const std::string whole = *readTextFile(folder / "r.seq.mha");
  const auto firstFrame = whole.find("Seq_Frame0002_"), end = whole.find("ElementDataFile");
  ASSERT_NE(firstFrame, std::string::npos);
  std::size_t most = 0;
  for (std::size_t cut = 0; cut < end; cut += 97) {
    std::ofstream(folder / "c.seq.mha", std::ios::binary) << whole.substr(0, cut);
    const auto read = readRecording(folder / "c.seq.mha");
    if (!read) {
      ASSERT_LT(cut, firstFrame) << cut << ": " << read.error();
      ASSERT_FALSE(read.error().sentence().empty());
      continue;
    }
    ASSERT_FALSE(read->notes.empty()) << cut;
    ASSERT_GE(read->log.frameCount(), most) << "more of the file, more frames";
    most = read->log.frameCount();
    for (std::size_t n = 0; n < read->log.frameCount(); ++n) ASSERT_EQ(read->log.frame(n), written.log.frame(n)) << cut << ' ' << n;
  }
  EXPECT_GE(most, 58U);
}

TEST_F(Recording, WhatCannotBeUsedIsRefusedInASentence) {
  ASSERT_TRUE(writeRecording(recordingOf(10), folder / "r.seq.mha"));
  const std::string whole = *readTextFile(folder / "r.seq.mha");
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string text = whole;
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
    std::ofstream(folder / "x.seq.mha", std::ios::binary) << text;
    return readRecording(folder / "x.seq.mha");
  };
  const std::tuple<const char*, const char*, ErrorCode> cases[] = {
      {"EchoWeaveRecording = 1", "EchoWeaveRecording = 2", ErrorCode::newerFormat},
      {"EchoWeaveRecording = 1", "SomethingElse = 1", ErrorCode::unsupported},
      {"ImageNumber = 8", "ImageNumber = -8", ErrorCode::badField},
      {"ImageNumber = 8", "ImageNumber = eight", ErrorCode::badField},
      {"EchoWeaveImageSize = 320 240", "EchoWeaveImageSize = 0 240", ErrorCode::badField},
      {"BodyState = ", "BodyState = 0 ", ErrorCode::badField},
      {"BodyState = ", "BodyState = 1.", ErrorCode::badField},
      {"\"gain\":", "\"gian\":", ErrorCode::badField},
      {"\"settings\":", "\"settings\":3,\"x\":", ErrorCode::badHeader},
      {"\"time_s\":", "\"time\":", ErrorCode::badField}};
  for (const auto& [from, to, code] : cases) {
    const auto read = changed(from, to);
    ASSERT_FALSE(read) << to;
    EXPECT_EQ(read.error().code, code) << to << ": " << read.error();
  }
}

TEST_F(Recording, WithoutAnImageIsNotWritten) {
  const auto written = writeRecording(ScanRecording(), folder / "r.seq.mha");
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, ErrorCode::badField);
  EXPECT_FALSE(std::filesystem::exists(folder / "r.seq.mha"));
}

}  // namespace ew::recording_test
