#include "ew/io/pose_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "files.h"

namespace ew::pose_table_test {
namespace {
using namespace test;

const std::string kHeader = "time_s, x_mm, y_mm, z_mm, qw, qx, qy, qz\n";

Result<Sequence> table(const std::string& text, const std::string& name = "poses.csv") {
  const TempFolder folder;
  return readPoseTable(folder.put(name, text));
}

/// A quarter turn about z.
glm::dmat4 turnedAt(double x, double y, double z) { return matrixFromRows({0, -1, 0, x, 1, 0, 0, y, 0, 0, 1, z, 0, 0, 0, 1}); }

void expectNear(const glm::dmat4& found, const glm::dmat4& expected) {
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row) EXPECT_NEAR(found[column][row], expected[column][row], 1e-12) << column << ", " << row;
}

const std::string kHalf = "0.7071067811865476";

TEST(PoseTable, ReadsPlacesAndQuaternions) {
  const auto read = table("\xEF\xBB\xBF# of a tracker\r\n" + kHeader + "\r\n0.5, 1, 2, 3, 1, 0, 0, 0\r\n0.75, 4, 5, 6, " + kHalf +
                          ", 0, 0, " + kHalf + "\r\n");
  ASSERT_TRUE(succeeded(read));
  EXPECT_EQ(read->width, 0);
  EXPECT_TRUE(read->pixels.empty());
  ASSERT_EQ(read->frames.size(), 2u);
  EXPECT_EQ(read->frames[0].time_s, 0.5);
  EXPECT_EQ(read->frames[1].time_s, 0.75);
  ASSERT_EQ(read->frames[1].transforms.size(), 1u);
  const FrameTransform& pose = read->frames[1].transforms[0];
  EXPECT_EQ(pose.from, "Probe");
  EXPECT_EQ(pose.to, "Tracker");
  EXPECT_EQ(pose.status, PoseStatus::ok);
  expectNear(pose.matrix, turnedAt(4, 5, 6));
  EXPECT_TRUE(read->notes.empty());
}

TEST(PoseTable, ReadsMatricesUnitsAndNamesFromTheHeader) {
  const auto read = table(
      "# transform: ProbeToReference\nTIME_MS;m00;m01;m02;m03_m;m10;m11;m12;m13_m;m20;m21;m22;m23_m;quality\n"
      "40;0;-1;0;0,004;1;0;0;0,005;0;0;1;0,006;0,9\n",
      "poses.txt");
  ASSERT_TRUE(succeeded(read));
  EXPECT_NEAR(*read->frames[0].time_s, 0.04, 1e-15);
  EXPECT_EQ(read->frames[0].transforms[0].to, "Reference");
  expectNear(read->frames[0].transforms[0].matrix, turnedAt(4, 5, 6));
  EXPECT_TRUE(contains(read->notes, "not known here and not used: quality"));
}

TEST(PoseTable, ColumnsMayStandInAnyOrderBetweenTabs) {
  const auto read = table("qz\tqy\tqx\tqw\tz_mm\ty_mm\tx_mm\ttime_us\n0\t0\t0\t1\t3\t2\t1\t250000\n", "poses.tsv");
  ASSERT_TRUE(succeeded(read));
  EXPECT_NEAR(*read->frames[0].time_s, 0.25, 1e-15);
  EXPECT_EQ(glm::dvec3(read->frames[0].transforms[0].matrix[3]), glm::dvec3(1, 2, 3));
}

TEST(PoseTable, PosesThatAreNotKnownAreMarked) {
  const auto read = table(
      "time_s,x_mm,y_mm,z_mm,qw,qx,qy,qz,status\n0,1,2,3,1,0,0,0,OK\n1,0,0,0,0,0,0,0,INVALID\n2,,,,,,,,ok\n"
      "3,nan,nan,nan,nan,nan,nan,nan,OK\n4,1,1,1,1,0,0,0,missing\n");
  ASSERT_TRUE(succeeded(read));
  const auto status = [&](std::size_t n) { return read->frames[n].transforms[0].status; };
  EXPECT_EQ(status(0), PoseStatus::ok);
  EXPECT_EQ(status(1), PoseStatus::invalid);
  EXPECT_EQ(status(2), PoseStatus::missing);
  EXPECT_EQ(status(3), PoseStatus::missing);
  EXPECT_EQ(status(4), PoseStatus::missing);
}

TEST(PoseTable, AWayFromTheImageMayScale) {
  const std::string rows = "time_s,m00,m01,m02,m03_mm,m10,m11,m12,m13_mm,m20,m21,m22,m23_mm\n0,0.1,0,0,1,0,0.2,0,2,0,0,0.1,3\n";
  const auto scaled = table("# transform: ImageToReference\n" + rows);
  ASSERT_TRUE(succeeded(scaled));
  EXPECT_EQ(scaled->frames[0].transforms[0].from, "Image");
  const auto refused = table(rows);
  EXPECT_TRUE(failedWith(refused, ErrorCode::badField));
  EXPECT_TRUE(says(refused, "In line 2 of \"poses.csv\", the matrix is no rotation"));
}

TEST(PoseTable, AStatusOfUnknownWordsIsRefusedByTheWord) {
  for (const char* word : {"1", "Valid", ""}) {
    const auto read = table("time_s,x_mm,y_mm,z_mm,qw,qx,qy,qz,status\n0,1,2,3,1,0,0,0," + std::string(word) + "\n");
    ASSERT_TRUE(failedWith(read, ErrorCode::badField)) << word;
    EXPECT_EQ(read.error().sentence(), "In line 2 of \"poses.csv\", the status is \"" + std::string(word) +
                                           "\", which is none of OK, INVALID and MISSING; correct the line, or export the tracking again.");
  }
}

TEST(PoseTable, LinesMayEndWithCarriageReturnsAlone) {
  std::string text = "# of an old program\n" + kHeader + "0,1,2,3,1,0,0,0\n0.5,4,5,6,1,0,0,0\n";
  std::replace(text.begin(), text.end(), '\n', '\r');
  const auto read = table(text);
  ASSERT_TRUE(succeeded(read));
  ASSERT_EQ(read->frames.size(), 2u);
  EXPECT_EQ(glm::dvec3(read->frames[1].transforms[0].matrix[3]), glm::dvec3(4, 5, 6));
}

TEST(PoseTable, BetweenTabsNumbersMayHaveDecimalCommas) {
  const auto read = table("time_s\tx_mm\ty_mm\tz_mm\tqw\tqx\tqy\tqz\n0,5\t1,5\t2\t3\t1,0\t0\t0\t0\n", "poses.tsv");
  ASSERT_TRUE(succeeded(read));
  EXPECT_EQ(read->frames[0].time_s, 0.5);
  EXPECT_EQ(glm::dvec3(read->frames[0].transforms[0].matrix[3]), glm::dvec3(1.5, 2, 3));
}

TEST(PoseTable, AColumnThatAnotherOutranksIsNamedAsSuch) {
  const auto read = table("time_s,time_ms,x_mm,x_m,y_mm,z_mm,qw,qx,qy,qz\n0.5,9,1,9,2,3,1,0,0,0\n");
  ASSERT_TRUE(succeeded(read));
  EXPECT_EQ(read->frames[0].time_s, 0.5);
  ASSERT_EQ(read->notes.size(), 2u);
  EXPECT_EQ(read->notes[0].english(), "The column time_ms of \"poses.csv\" is not used, because time_s says it.");
  EXPECT_EQ(read->notes[1].english(), "The column x_m of \"poses.csv\" is not used, because x_mm says it.");
}

TEST(PoseTable, QuaternionsOfImageSayNothingOfPixels) {
  const auto read = table("# transform: ImageToTracker\n" + kHeader + "0,1,2,3,1,0,0,0\n");
  ASSERT_TRUE(succeeded(read));
  ASSERT_EQ(read->notes.size(), 1u);
  EXPECT_EQ(read->notes[0].english(),
            "\"poses.csv\" gives poses of Image by quaternions, which do not say how large a pixel is; 1 x 1 mm was taken.");
}

TEST(PoseTable, ATableOfAnotherKindOfTextSaysWhatToDo) {
  const auto sentenceOf = [](const std::string& text) {
    const auto read = table(text);
    return read ? std::string("read") : read.error().sentence();
  };
  const std::string line = "0,1,2,3,1,0,0,0\n";
  const std::string needs =
      "a line of column names with time_s and either x_mm, y_mm, z_mm, qw, qx, qy, qz or the matrix m00 to m22 with m03_mm, m13_mm, "
      "m23_mm.";
  EXPECT_EQ(sentenceOf("# only a remark\n"), "\"poses.csv\" is empty but for remarks; it needs " + needs);
  EXPECT_EQ(sentenceOf(std::string("\xFF\xFEt\0i\0", 6)), "\"poses.csv\" is text in UTF-16, which is not read; save it as UTF-8.");
  EXPECT_EQ(sentenceOf(std::string("t\0i\0", 4)), "\"poses.csv\" is no text in UTF-8, it holds bytes of 0; save it as UTF-8.");
  EXPECT_EQ(sentenceOf("time_s x_mm y_mm z_mm qw qx qy qz\n0 1 2 3 1 0 0 0\n"),
            "In \"poses.csv\" blanks stand between the columns; put commas, semicolons or tabs there.");
  EXPECT_EQ(
      sentenceOf(kHeader + "0,5,1,0,2,3,1,0,0,0\n"),
      "In line 2 of \"poses.csv\", there are 10 values for 8 columns; where numbers have decimal commas, semicolons must stand between "
      "the columns; correct the line, or export the tracking again.");
  EXPECT_EQ(sentenceOf("# transform: ProbeToTracker\n# transform: StylusToWorld\n" + kHeader + line),
            "In line 2 of \"poses.csv\", the transform is StylusToWorld, but line 1 says ProbeToTracker; correct the line, or export the "
            "tracking again.");
  EXPECT_EQ(sentenceOf("# transform: ProbeToWorld\n# transform: ProbeToWorld\n" + kHeader + line), "read");
}

TEST(PoseTable, ATableThatIsWrongIsRefusedByWhatIsWrong) {
  const auto refusal = [](const std::string& text, ErrorCode code, const char* words) {
    const auto read = table(text);
    EXPECT_TRUE(failedWith(read, code)) << text;
    EXPECT_TRUE(says(read, words)) << (read ? std::string("read") : read.error().sentence());
  };
  const std::string line = "0,1,2,3,1,0,0,0\n";
  refusal("", ErrorCode::badHeader, "is empty");
  refusal("# only a remark\n", ErrorCode::badHeader, "is empty");
  refusal(line + line, ErrorCode::badHeader, "has no header line, its first line is \"0,1,2,3,1,0,0,0\"; it needs");
  refusal(kHeader, ErrorCode::badHeader, "holds no pose");
  refusal("time_s,x_mm,y_mm,z_mm,qw,qx,qy\n0,1,2,3,1,0,0\n", ErrorCode::badHeader, "lacks qz among its columns");
  refusal("t,x_mm,y_mm,z_mm,qw,qx,qy,qz\n" + line, ErrorCode::badHeader, "lacks time_s among its columns; it needs");
  refusal("time_s,x,y,z,qw,qx,qy,qz\n" + line, ErrorCode::badHeader, "lacks x_mm, y_mm, z_mm among its columns");
  refusal("time_s,x_mm,x_mm,z_mm,qw,qx,qy,qz\n" + line, ErrorCode::badHeader, "the column x_mm twice");
  refusal(kHeader + "0,1,2,3,1,0,0\n", ErrorCode::badField, "In line 2 of \"poses.csv\", there are 7 values for 8 columns");
  refusal(kHeader + line + "0.1,1,two,3,1,0,0,0\n", ErrorCode::badField, "In line 3 of \"poses.csv\", y_mm is \"two\" and no number");
  refusal(kHeader + "never,1,2,3,1,0,0,0\n", ErrorCode::badField, "time_s is \"never\" and no time");
  refusal(kHeader + "0,1,,3,1,0,0,0\n", ErrorCode::badField, "blank, NaN or infinite");
  refusal(kHeader + "0,1,2,3,0.5,0,0,0\n", ErrorCode::badField, "the quaternion has the length 0.5 instead of 1");
  refusal(kHeader + "1,1,2,3,1,0,0,0\n0.5,1,2,3,1,0,0,0\n", ErrorCode::badField,
          "In line 3 of \"poses.csv\", the time is 0.5 s and does not rise above the 1 s of the pose before");
  refusal(kHeader + line + line, ErrorCode::badField, "does not rise");
  refusal("# transform: Probe\n" + kHeader + line, ErrorCode::badField, "as in ProbeToTracker");
}

}  // namespace
}  // namespace ew::pose_table_test
