#include "ew/acquisition/joined_sweep.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>
#include <utility>

#include "ew/acquisition/import.h"
#include "ew/io/image_file.h"
#include "ew/io/volume_file.h"
#include "io/made_films.h"

namespace ew::joined_sweep_test {
namespace {

namespace fs = std::filesystem;

/// A folder of its own for each test, gone when the test ends.
class JoinedSweep : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) /
              ("ew-joined-" + std::to_string(getpid()) + "-" + testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  [[nodiscard]] fs::path put(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return folder_ / name;
  }

  /// Image to Probe with pixels of 0.5 mm.
  [[nodiscard]] fs::path deviceSet() const {
    return put("device.xml",
               "<PlusConfiguration><CoordinateDefinitions><Transform From=\"Image\" To=\"Probe\" "
               "Matrix=\"0.5 0 0 0 0 0.5 0 0 0 0 0.5 0 0 0 0 1\"/></CoordinateDefinitions></PlusConfiguration>");
  }

  [[nodiscard]] SweepImportOptions optionsWith(const fs::path& poses) const {
    SweepImportOptions options;
    options.calibrations = {deviceSet()};
    options.poses = poses;
    options.reconstruct.spacing_mm = 0.5;
    options.reconstruct.interpolation = Interpolation::nearest;
    return options;
  }

  fs::path folder_;
};

/// Images without poses, so many, 0.1 s apart from `from_s` on.
Sequence images(int count, double from_s = 0.0) {
  Sequence sequence;
  sequence.width = 20;
  sequence.height = 10;
  sequence.orientation = "MF";
  for (int n = 0; n < count; ++n) {
    SequenceFrame frame;
    frame.time_s = from_s + 0.1 * n;
    frame.imageStatus = PoseStatus::ok;
    sequence.frames.push_back(frame);
    for (int p = 0; p < 200; ++p) sequence.pixels.push_back(static_cast<std::uint8_t>(10 * n + p % 20));
  }
  return sequence;
}

FrameTransform probeAt(const glm::dvec3& place_mm, double turned_deg) {
  FrameTransform pose{"Probe", "Tracker", glm::rotate(glm::dmat4(1.0), turned_deg * std::numbers::pi / 180.0, glm::dvec3(0, 0, 1)),
                      PoseStatus::ok};
  pose.matrix[3] = glm::dvec4(place_mm, 1.0);
  return pose;
}

Sequence posesAt(const std::vector<std::pair<double, FrameTransform>>& given) {
  Sequence poses;
  for (const auto& [time_s, pose] : given) {
    SequenceFrame frame;
    frame.time_s = time_s;
    frame.transforms = {pose};
    poses.frames.push_back(frame);
  }
  return poses;
}

void expectNear(const glm::dmat4& found, const glm::dmat4& expected) {
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row) EXPECT_NEAR(found[column][row], expected[column][row], 1e-9) << column << ", " << row;
}

bool says(const std::vector<Message>& notes, const std::string& words) {
  return std::any_of(notes.begin(), notes.end(), [&](const Message& note) { return note.english().find(words) != std::string::npos; });
}

TEST_F(JoinedSweep, BetweenTwoPosesPlacesGoAlongALineAndAttitudesByTheShortestWay) {
  Sequence joined = images(3);  // at 0, 0.1 and 0.2 s
  const Sequence poses = posesAt({{0.0, probeAt({0, 0, 0}, 0.0)}, {0.15, probeAt({3, 6, 9}, 30.0)}, {0.3, probeAt({6, 12, 18}, 90.0)}});
  const auto notes = joinPoses(joined, poses, 0.0, "p.csv");
  ASSERT_TRUE(notes.has_value()) << notes.error();
  ASSERT_EQ(joined.frames[0].transforms.size(), 1u);
  EXPECT_EQ(joined.frames[0].transforms[0], poses.frames[0].transforms[0]) << "unchanged at the moment of a pose";
  expectNear(joined.frames[1].transforms[0].matrix, probeAt({2, 4, 6}, 20.0).matrix);
  expectNear(joined.frames[2].transforms[0].matrix, probeAt({4, 8, 12}, 50.0).matrix);
  EXPECT_TRUE(says(*notes, "an image of time t has the pose of t + 0 s"));
  EXPECT_FALSE(says(*notes, "count as invalid"));
}

TEST_F(JoinedSweep, APositiveOffsetTakesALaterPose) {
  Sequence joined = images(3);
  const Sequence poses = posesAt({{1000.0, probeAt({0, 0, 0}, 0.0)},
                                  {1000.1, probeAt({1, 0, 0}, 0.0)},
                                  {1000.2, probeAt({2, 0, 0}, 0.0)},
                                  {1000.3, probeAt({3, 0, 0}, 0.0)}});
  ASSERT_TRUE(joinPoses(joined, poses, 1000.1, "p.csv").has_value());
  for (int n = 0; n < 3; ++n) EXPECT_NEAR(joined.frames[static_cast<std::size_t>(n)].transforms[0].matrix[3].x, 1.0 + n, 1e-9);
}

TEST_F(JoinedSweep, ImagesOutsideAndBesideGapsAreInvalidAndCounted) {
  Sequence joined = images(10);  // 0 to 0.9 s
  std::vector<std::pair<double, FrameTransform>> given;
  for (const double time_s : {0.1, 0.2, 0.3, 0.7, 0.8}) given.emplace_back(time_s, probeAt({time_s, 0, 0}, 0.0));
  given[4].second.status = PoseStatus::invalid;
  const auto notes = joinPoses(joined, posesAt(given), 0.0, "p.csv");
  ASSERT_TRUE(notes.has_value()) << notes.error();
  std::vector<int> valid;
  for (int n = 0; n < 10; ++n)
    if (joined.frames[static_cast<std::size_t>(n)].transforms[0].status == PoseStatus::ok) valid.push_back(n);
  EXPECT_EQ(valid, (std::vector<int>{1, 2, 3, 7}));
  EXPECT_TRUE(says(*notes, "Images outside the times of the poses, which count as invalid: 2 of 10."));
  EXPECT_TRUE(says(*notes, "more than 0.3 s apart, which count as invalid: 4 of 10."));
}

TEST_F(JoinedSweep, WithoutACommonMomentBothRangesAreSaid) {
  Sequence joined = images(3);
  const auto refused = joinPoses(joined, posesAt({{100.0, probeAt({0, 0, 0}, 0.0)}, {100.5, probeAt({1, 0, 0}, 0.0)}}), 2.0, "p.csv");
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ErrorCode::noValidPose);
  EXPECT_NE(refused.error().sentence().find("images from 2 to 2.2 s (with an offset of 2 s), poses from 100 to 100.5 s"), std::string::npos)
      << refused.error();
}

TEST_F(JoinedSweep, PosesMuchCoarserThanTheImagesAreRefusedByBothSteps) {
  std::vector<std::pair<double, FrameTransform>> given;
  for (int n = 0; n < 5; ++n) given.emplace_back(50.0 * n, probeAt({0.0, 0.0, n}, 0.0));  // milliseconds taken for seconds
  Sequence some = images(5, 100.05);
  const auto refused = joinPoses(some, posesAt(given), 0.0, "p.csv");
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ErrorCode::badField);
  EXPECT_EQ(refused.error().sentence(),
            "Images lie between poses of \"p.csv\" that are 50 s apart, while the images are 0.1 s apart: do the poses count milliseconds? "
            "Correct their times (in a table a column time_ms counts milliseconds), or export the tracking with more poses.");
  Sequence slow = images(3, 100.0);  // images that are slow themselves
  for (std::size_t n = 0; n < 3; ++n) slow.frames[n].time_s = 40.0 * static_cast<double>(n);
  EXPECT_TRUE(joinPoses(slow, posesAt(given), 0.0, "p.csv").has_value());
}

TEST_F(JoinedSweep, ANoteSaysTheOffsetWithItsSignAndOnePoseAsOne) {
  const auto noteOf = [](const std::vector<std::pair<double, FrameTransform>>& given, double offset_s) {
    Sequence joined = images(3);
    const auto notes = joinPoses(joined, posesAt(given), offset_s, "p.csv");
    if (!notes) ADD_FAILURE() << notes.error();
    return notes && !notes->empty() ? notes->front().english() : std::string();
  };
  EXPECT_EQ(noteOf({{0.0, probeAt({0, 0, 0}, 0.0)}, {0.2, probeAt({1, 0, 0}, 0.0)}}, -0.1),
            "The poses come from \"p.csv\", where there are 2 from 0 to 0.2 s; an image of time t has the pose of t - 0.1 s.");
  EXPECT_EQ(noteOf({{0.1, probeAt({0, 0, 0}, 0.0)}}, 0.0),
            "The poses come from \"p.csv\", where there is one alone, at 0.1 s; an image of time t has the pose of t + 0 s.");
}

TEST_F(JoinedSweep, TimesThatAreMissingOrRunBackwardsAreRefused) {
  const Sequence poses = posesAt({{0.0, probeAt({0, 0, 0}, 0.0)}, {0.5, probeAt({1, 0, 0}, 0.0)}});
  Sequence untimed = images(3);
  untimed.frames[1].time_s.reset();
  const auto image = joinPoses(untimed, poses, 0.0, "p.csv");
  ASSERT_FALSE(image.has_value());
  EXPECT_NE(image.error().sentence().find("Image 1 of the recording has no time"), std::string::npos) << image.error();
  Sequence some = images(3), backwards = poses, lost = poses;
  backwards.frames[1].time_s = -1.0;
  EXPECT_NE(joinPoses(some, backwards, 0.0, "p.csv").error().sentence().find("time runs backwards at pose 1 (-1 s after 0 s)"),
            std::string::npos);
  lost.frames[1].time_s.reset();
  EXPECT_NE(joinPoses(some, lost, 0.0, "p.csv").error().sentence().find("Pose 1 of \"p.csv\" has no time"), std::string::npos);
}

/// Poses 0.1 s apart that go 1 mm along z each, as a table.
std::string evenTable(int count) {
  std::string text = "time_s,x_mm,y_mm,z_mm,qw,qx,qy,qz\n";
  for (int n = 0; n < count; ++n) text += std::to_string(0.1 * n) + ",0,0," + std::to_string(n) + ",1,0,0,0\n";
  return text;
}

TEST_F(JoinedSweep, ASequenceWithoutPosesAndATableBecomeTheSameVolumeAsATrackedOne) {
  Sequence tracked = images(5);
  for (std::size_t n = 0; n < 5; ++n) tracked.frames[n].transforms = {probeAt({0, 0, static_cast<double>(n)}, 0.0)};
  ASSERT_TRUE(writeSequence(tracked, folder_ / "tracked.igs.mha"));
  ASSERT_TRUE(writeSequence(images(5), folder_ / "images.igs.mha"));
  const auto whole = openSweep(folder_ / "tracked.igs.mha", optionsWith({}), noProgress());
  const auto joined = openSweep(folder_ / "images.igs.mha", optionsWith(put("p.csv", evenTable(5))), noProgress());
  ASSERT_TRUE(whole.has_value()) << whole.error();
  ASSERT_TRUE(joined.has_value()) << joined.error();
  EXPECT_EQ(joined->plan.toFrame, "Tracker");
  EXPECT_EQ(joined->plan.grid, whole->plan.grid);
  EXPECT_EQ(joined->plan.frames.used, 5u);
  const auto a = importSweep(*whole, noProgress()), b = importSweep(*joined, noProgress());
  ASSERT_TRUE(a.has_value() && b.has_value());
  EXPECT_EQ(a->reconstruction.volume.echo, b->reconstruction.volume.echo);
}

TEST_F(JoinedSweep, APoseSequenceIsJoinedAndReplacesThePosesOfTheImages) {
  Sequence recorded = images(5);
  for (SequenceFrame& frame : recorded.frames) frame.transforms = {probeAt({0, 0, 50}, 0.0)};
  ASSERT_TRUE(writeSequence(recorded, folder_ / "images.igs.mha"));
  Sequence poses;
  for (int n = 0; n < 5; ++n) {
    SequenceFrame frame;
    frame.time_s = 0.1 * n;
    frame.transforms = {probeAt({0, 0, static_cast<double>(n)}, 0.0)};
    poses.frames.push_back(frame);
  }
  ASSERT_TRUE(writeSequence(poses, folder_ / "poses.seq.mha"));
  Sequence dummy = poses;
  dummy.width = dummy.height = 1;
  dummy.pixels.assign(5, 0);
  ASSERT_TRUE(writeSequence(dummy, folder_ / "dummy.igs.mha"));
  for (const char* file : {"poses.seq.mha", "dummy.igs.mha"}) {
    const auto joined = openSweep(folder_ / "images.igs.mha", optionsWith(folder_ / file), noProgress());
    ASSERT_TRUE(joined.has_value()) << file << joined.error();
    EXPECT_EQ(joined->plan.grid.origin_mm.z, 0.0) << file;
    EXPECT_EQ(joined->plan.frames.used, 5u) << file;
  }
}

TEST_F(JoinedSweep, IsPlannedAgainWithAnotherOffsetAndWithItsOwnPoses) {
  Sequence recorded = images(5);
  for (SequenceFrame& frame : recorded.frames) frame.transforms = {probeAt({0, 0, 50}, 0.0)};
  recorded.frames[4].transforms = {probeAt({0, 0, 51}, 0.0)};
  ASSERT_TRUE(writeSequence(recorded, folder_ / "images.igs.mha"));
  SweepImportOptions options = optionsWith(put("p.csv", evenTable(20)));
  auto opened = openSweep(folder_ / "images.igs.mha", options, noProgress());
  ASSERT_TRUE(opened.has_value()) << opened.error();
  EXPECT_NEAR(opened->plan.grid.origin_mm.z, 0.0, 1e-9);
  options.poseDelay_s = 1.0;
  ASSERT_TRUE(planAgain(*opened, options, noProgress()));
  EXPECT_NEAR(opened->plan.grid.origin_mm.z, 10.0, 1e-6);
  options = optionsWith({});
  ASSERT_TRUE(planAgain(*opened, options, noProgress()));
  EXPECT_NEAR(opened->plan.grid.origin_mm.z, 50.0, 1e-9) << "what the images' file says";
}

TEST_F(JoinedSweep, ImagesNeedARateAndTakeIt) {
  const fs::path images = folder_ / "pictures";
  fs::create_directories(images);
  for (int n = 0; n < 3; ++n) {
    GreyImage image(20, 10, static_cast<std::uint8_t>(50 * n));
    ASSERT_TRUE(writeImage(viewOf(std::as_const(image)), 1.0, images / ("image" + std::to_string(n) + ".png")));
  }
  SweepImportOptions options = optionsWith(put("p.csv", evenTable(5)));
  const auto asked = openSweep(images, options, noProgress());
  ASSERT_FALSE(asked.has_value());
  EXPECT_NE(asked.error().sentence().find("give the images' rate"), std::string::npos) << asked.error();
  options.imageRate_hz = 10.0;
  const auto timed = openSweep(images, options, noProgress());
  ASSERT_TRUE(timed.has_value()) << timed.error();
  EXPECT_EQ(timed->plan.frames.used, 3u);
  EXPECT_EQ(timed->sequence.frames[2].time_s, 0.2);
  EXPECT_EQ(timed->sequence.framePixels(1)[0], 50);
  EXPECT_NEAR(timed->poses.imageToWorld[2]->matrix[3].z, 2.0, 1e-6);
}

TEST_F(JoinedSweep, TheSlicesOfAVolumeAreImages) {
  Volume volume;
  volume.grid.dims = {20, 10, 3};
  volume.grid.spacing_mm = glm::dvec3(0.7);
  for (int n = 0; n < 3; ++n) volume.echo.insert(volume.echo.end(), 200, static_cast<std::uint8_t>(40 * n + 1));
  ASSERT_TRUE(writeVolume(volume, folder_ / "stack.mha"));
  SweepImportOptions options = optionsWith(put("p.csv", evenTable(5)));
  options.imageRate_hz = 10.0;
  const auto joined = openSweep(folder_ / "stack.mha", options, noProgress());
  ASSERT_TRUE(joined.has_value()) << joined.error();
  EXPECT_EQ(joined->plan.frames.used, 3u);
  EXPECT_EQ(joined->sequence.framePixels(2)[0], 81);
  EXPECT_TRUE(says(joined->plan.notes, "each of its 3 slices was taken for an image"));
}

TEST_F(JoinedSweep, AFilmOfKnownFramesLiesWhereTheTableSays) {
  if (!test::canWrite(AV_CODEC_ID_FFV1)) GTEST_SKIP() << "this FFmpeg writes no FFV1";
  test::FilmOf film;
  film.times_s = {0.0, 0.1, 0.2};
  film.level = [](int n, int, int) { return static_cast<std::uint8_t>(60 + 50 * n); };
  test::writeFilm(folder_ / "film.mkv", film);
  SweepImportOptions options = optionsWith(put("p.csv", evenTable(10)));
  options.poseDelay_s = 0.25;
  const auto joined = openSweep(folder_ / "film.mkv", options, noProgress());
  ASSERT_TRUE(joined.has_value()) << joined.error();
  ASSERT_EQ(joined->sequence.frames.size(), 3u);
  EXPECT_EQ(joined->plan.frames.used, 3u);
  for (std::size_t n = 0; n < 3; ++n) {
    EXPECT_NEAR(joined->poses.imageToWorld[n]->matrix[3].z, 2.5 + static_cast<double>(n), 1e-6);
    if (n > 0) {
      EXPECT_GT(joined->sequence.framePixels(n)[0], joined->sequence.framePixels(n - 1)[0] + 30);
    }
  }
}

TEST_F(JoinedSweep, PosesOfImageThatDoNotScaleAreRefusedBesideACalibration) {
  ASSERT_TRUE(writeSequence(images(5), folder_ / "images.igs.mha"));
  const auto refused =
      openSweep(folder_ / "images.igs.mha", optionsWith(put("p.csv", "# transform: ImageToTracker\n" + evenTable(5))), noProgress());
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ErrorCode::badField);
  EXPECT_EQ(refused.error().sentence(),
            "The poses of \"p.csv\" lead from Image to Tracker and make a pixel 1 x 1 mm, as quaternions do, but the device set says 0.5 x "
            "0.5 mm. If they are those of the probe, name them so (transform: ProbeToTracker); else give matrices that scale, or leave the "
            "device set away.");
  SweepImportOptions alone = optionsWith(put("p.csv", "# transform: ImageToTracker\n" + evenTable(5)));
  alone.calibrations.clear();
  EXPECT_TRUE(openSweep(folder_ / "images.igs.mha", alone, noProgress()).has_value());
}

TEST_F(JoinedSweep, PosesOfAFileOfAnotherEndingAreRefusedByWhatIsRead) {
  const auto refused = readPoses(put("p.dat", evenTable(5)), noProgress());
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(
      refused.error().sentence(),
      "\"p.dat\" has an ending of which no poses are read; give a table of text (.csv, .tsv, .txt) or a tracked sequence (.mha, .mhd, "
      ".nrrd, .nhdr).");
}

TEST_F(JoinedSweep, AFileWithoutPosesAndAMotorBesideThemAreRefused) {
  ASSERT_TRUE(writeSequence(images(5), folder_ / "images.igs.mha"));
  const auto none = openSweep(folder_ / "images.igs.mha", optionsWith(folder_ / "images.igs.mha"), noProgress());
  ASSERT_FALSE(none.has_value());
  EXPECT_NE(none.error().sentence().find("\"images.igs.mha\" holds no poses"), std::string::npos) << none.error();
  SweepImportOptions both = optionsWith(put("p.csv", evenTable(5)));
  both.motor = kRecordedMotor;
  const auto twice = openSweep(folder_ / "images.igs.mha", both, noProgress());
  ASSERT_FALSE(twice.has_value());
  EXPECT_EQ(twice.error().code, ErrorCode::badUsage);
}

}  // namespace
}  // namespace ew::joined_sweep_test
