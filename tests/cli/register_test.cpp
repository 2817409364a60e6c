#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "cli/cli_world.h"
#include "commands/registration_files.h"
#include "ew/core/frames.h"
#include "ew/io/vector_file.h"
#include "ew/io/volume_file.h"
#include "ew/phantom/speckle_tissue.h"

namespace ew::test::register_test {
namespace {

class RegisterCommand : public testing::Test {
 protected:
  void SetUp() override {
    Volume fixed = rampVolume({12, 10, 8});
    fixed.grid.origin_mm = {5.0, -3.0, 2.0};
    ASSERT_TRUE(writeVolume(fixed, folder / "f.mha"));
    ASSERT_TRUE(writeVolume(rampVolume({14, 12, 9}), folder / "m.mha"));
  }
  /// Four places, of which the named one may be wrong by so much along x.
  void writePairs(const std::string& file, const std::string& wrong = {}, double by_mm = 0.0) const {
    nlohmann::json list = nlohmann::json::array();
    const std::vector<std::pair<std::string, glm::dvec3>> places{
        {"gall bladder", {5, -3, 2}}, {"vein", {15, -3, 3}}, {"rib", {6, 6, 4}}, {"cyst", {9, 2, 9}}, {"node", {12, 5, 6}}};
    for (const auto& [name, p] : places) {
      glm::dvec3 q = carried(truth, p);
      if (name == wrong) q.x += by_mm;
      list.push_back({{"name", name}, {"fixed_mm", {p.x, p.y, p.z}}, {"moving_mm", {q.x, q.y, q.z}}});
    }
    writeText(file, nlohmann::json{{"landmarks", list}, {"pick_error_mm", 0.5}}.dump());
  }
  Outcome registered(std::vector<std::string> more) const {
    std::vector<std::string> words{"register", folder / "f.mha", folder / "m.mha"};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  }
  const Transform<frame::Moving, frame::Fixed> truth{
      glm::rotate(glm::translate(glm::dmat4(1.0), {-4.0, 2.5, 1.0}), 0.3, glm::dvec3(0.0, 0.6, 0.8))};
  TemporaryFolder folder;
};

TEST_F(RegisterCommand, BringsVolumesTogetherByLandmarksAndWritesWhatTheContractSays) {
  writePairs(folder / "pairs.json");
  const auto outcome = registered({"--method", "landmarks", "--landmarks", folder / "pairs.json", "-o", folder / "t.txt", "--field",
                                   folder / "field.mha", "--moved", folder / "moved.mha", "--report", folder / "r.json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("Aligned: 5 pairs agree"), std::string::npos) << outcome.out;
  const auto transform = cli::readTransform(folder / "t.txt");
  ASSERT_TRUE(transform) << transform.error();
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r) EXPECT_NEAR(transform->matrix[c][r], truth.matrix[c][r], 1e-9);

  const auto field = readVectorField(folder / "field.mha");
  ASSERT_TRUE(field) << field.error();
  EXPECT_EQ(field->components, 3);
  const auto& grid = field->grid;
  ASSERT_EQ(grid.dims, glm::ivec3(12, 10, 8));
  for (int k = 0; k < 8; ++k)
    for (int j = 0; j < 10; ++j)
      for (int i = 0; i < 12; ++i) {
        const glm::dvec3 p(5.0 + i, -3.0 + j, 2.0 + k);
        const glm::dvec3 u = carried(truth, p) - p;
        for (int axis = 0; axis < 3; ++axis)
          ASSERT_NEAR(field->values[3 * grid.indexOf(i, j, k) + static_cast<std::size_t>(axis)], u[axis], 1e-5);
      }

  // The moving volume is a ramp: seen on the fixed grid it is the ramp at the moved places, wherever they lie inside.
  const auto moved = readVolume(folder / "moved.mha");
  ASSERT_TRUE(moved);
  ASSERT_EQ(moved->volume.grid.dims, glm::ivec3(12, 10, 8));
  int compared = 0;
  for (int k = 0; k < 8; ++k)
    for (int j = 0; j < 10; ++j)
      for (int i = 0; i < 12; ++i) {
        const glm::dvec3 q = carried(truth, {5.0 + i, -3.0 + j, 2.0 + k});
        if (glm::any(glm::lessThan(q, glm::dvec3(0.0))) || glm::any(glm::greaterThan(q, glm::dvec3(13.0, 11.0, 8.0)))) continue;
        ++compared;
        EXPECT_NEAR(moved->volume.echo[moved->volume.grid.indexOf(i, j, k)], 20.0 + 3.0 * q.x + 5.0 * q.y + 7.0 * q.z, 0.51);
      }
  EXPECT_GT(compared, 100);

  const auto report = readJson(folder / "r.json");
  EXPECT_EQ(report["command"], "register");
  EXPECT_EQ(report["verdict"], "aligned");
  EXPECT_EQ(report["inputs"], nlohmann::json({folder / "f.mha", folder / "m.mha", folder / "pairs.json"}));
  EXPECT_EQ(report["outputs"], nlohmann::json({folder / "t.txt", folder / "field.mha", folder / "moved.mha"}));
  EXPECT_EQ(report["options"]["method"], "landmarks");
  EXPECT_EQ(report["options"]["pick_error_mm"], 0.5);
  EXPECT_LT(report["quality"]["rms_mm"], 1e-6);
  EXPECT_GT(report["quality"]["expected_error_mm"], 0.1);
  EXPECT_NEAR(report["quality"]["turn_deg"].get<double>(), glm::degrees(0.3), 1e-6);
  EXPECT_EQ(report["landmarks"].size(), 5u);
  EXPECT_EQ(report["steps"].size(), 3u);
}

TEST_F(RegisterCommand, NamesAWrongLandmarkAndGoesOnWithoutIt) {
  writePairs(folder / "pairs.json", "rib", 20.0);
  const auto outcome = registered({"--method", "landmarks", "--landmarks", folder / "pairs.json", "-o", folder / "t.txt"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("'rib' does not fit"), std::string::npos) << outcome.out;
}

TEST_F(RegisterCommand, AnHonestVerdictIsStatusThreeAndTheOutputsAreThereForALook) {
  writeText(folder / "two.json", R"([{"fixed_mm": [1, 2, 3], "moving_mm": [4, 5, 6]}, {"fixed_mm": [9, 2, 3], "moving_mm": [12, 5, 6]}])");
  const auto outcome = registered({"--method", "landmarks", "--landmarks", folder / "two.json", "-o", folder / "t.txt", "--field",
                                   folder / "field.mha", "--report", folder / "r.json"});
  EXPECT_EQ(outcome.status, 3) << outcome.err;
  EXPECT_NE(outcome.out.find("Cannot tell: Two places are too few"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("do not build on it"), std::string::npos);
  EXPECT_TRUE(readVectorField(folder / "field.mha"));
  const auto report = readJson(folder / "r.json");
  EXPECT_EQ(report["verdict"], "cannot tell");
  EXPECT_TRUE(report["quality"]["expected_error_mm"].is_null());
}

TEST_F(RegisterCommand, WrongUsageIsToldBeforeAnythingIsRead) {
  writePairs(folder / "pairs.json");
  writeText(folder / "start.txt", "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1");
  const std::vector<std::pair<std::vector<std::string>, std::string>> wrong{
      {{"--method", "landmarks"}, "--landmarks"},
      {{"--method", "guess"}, "method"},
      {{"--method", "rigid", "--landmarks", folder / "pairs.json"}, "--landmarks goes with --method landmarks"},
      {{"--method", "landmarks", "--landmarks", folder / "pairs.json", "--start", folder / "start.txt"}, "--start goes with"},
      {{"--method", "partial", "--effort", "fast"}, "--effort goes with"},
      {{"--method", "elastic2d", "--node", "5"}, "--node goes with"},
      {{"--method", "rigid", "--threads", "-1"}, "threads"}};
  for (auto [words, expected] : wrong) {
    words.insert(words.end(), {"-o", folder / "t.txt"});
    const auto outcome = registered(words);
    EXPECT_EQ(outcome.status, 2) << outcome.err;
    EXPECT_NE(outcome.err.find(expected), std::string::npos) << outcome.err;
  }
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"f.mha", "m.mha", "pairs.json", "start.txt"}));
}

TEST_F(RegisterCommand, TheDirectionOfTheBeamsIsThreeNumbersNegativeOnesToo) {
  const auto taken =
      registered({"--method", "rigid", "-o", folder / "t.txt", "--beam-fixed", "0.1", "-0.9", "0", "--beam-moving", "-1", "0", "0"});
  EXPECT_NE(taken.status, 1) << taken.err;
  EXPECT_NE(taken.status, 2) << taken.err;
  const auto refused = registered({"--method", "rigid", "-o", folder / "u.txt", "--beam-moving", "0", "0", "0"});
  EXPECT_EQ(refused.status, 1);
  EXPECT_NE(refused.err.find("moving volume is no direction"), std::string::npos) << refused.err;
}

TEST_F(RegisterCommand, AFailureSaysWhyAndLeavesNothing) {
  writePairs(folder / "pairs.json");
  writeText(folder / "broken.json", "{\"landmarks\": [{\"name\": \"x\", \"fixed_mm\": [1, 2], \"moving_mm\": [1, 2, 3]}]}");
  const auto before = folder.names();
  const std::vector<std::pair<std::vector<std::string>, std::string>> failing{
      {{"--landmarks", folder / "none.json"}, "none.json"},
      {{"--landmarks", folder / "broken.json"}, "'landmarks[0].fixed_mm' in "},
      {{"--landmarks", folder / "pairs.json", "--coverage-fixed", folder / "m.mha"}, "lies on another grid"},
      {{"--landmarks", folder / "pairs.json", "--confidence-moving", folder / "f.mha"}, "lies on another grid"},
      {{"--landmarks", folder / "pairs.json", "--field", folder / "none/field.mha"}, "does not exist"}};
  for (auto [words, expected] : failing) {
    words.insert(words.end(), {"--method", "landmarks", "-o", folder / "t.txt"});
    const auto outcome = registered(words);
    EXPECT_EQ(outcome.status, 1) << outcome.err;
    EXPECT_NE(outcome.err.find(expected), std::string::npos) << outcome.err;
    EXPECT_EQ(folder.names(), before);
  }
}

/// Two views of speckled tissue: 40 voxels of 1.5 mm, the moving one turned by 8 degrees and shifted by 12 mm.
class RegisterImages : public testing::Test {
 protected:
  static TissueView viewOfSide(int side, double voxel_mm) {
    TissueView view;
    view.grid.dims = glm::ivec3(side);
    view.grid.spacing_mm = glm::dvec3(voxel_mm);
    view.shared = 0.8;
    return view;
  }
  void write(const SpeckleTissue& tissue, const TissueView& view, const std::string& name) const {
    const auto image = imageOf(tissue, view, 0, noProgress());
    ASSERT_TRUE(image);
    ASSERT_TRUE(writeVolume(*image, folder / name));
  }
  void SetUp() override {
    const SpeckleTissue tissue(4), other(40);
    TissueView view = viewOfSide(48, 1.25);
    write(tissue, view, "f.mha");
    view.view = 2;
    view.toTissue = [this](const glm::dvec3& q) { return carried(inverse(truth), q); };
    write(tissue, view, "m.mha");
    write(other, view, "o.mha");
  }
  /// Worst error of a written transform at the corners of the fixed volume.
  double errorOf(const std::string& file) const {
    const auto found = cli::readTransform(folder / file);
    if (!found) return 1e9;
    double worst = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
      const glm::dvec3 p(corner & 1 ? 59.0 : 0.0, corner & 2 ? 59.0 : 0.0, corner & 4 ? 59.0 : 0.0);
      worst = std::max(worst, glm::length(carried(*found, p) - carried(truth, p)));
    }
    return worst;
  }
  const Transform<frame::Moving, frame::Fixed> truth{
      glm::rotate(glm::translate(glm::dmat4(1.0), {12.0, -3.0, 2.0}), 0.14, glm::normalize(glm::dvec3(0.2, 1.0, 0.4)))};
  TemporaryFolder folder;
};

TEST_F(RegisterImages, WithoutAnyStartTheVolumesAreMatchedAndThenRefinedFromThere) {
  const auto matched = run({"register", folder / "f.mha", folder / "m.mha", "--method", "partial", "--max-turn", "15", "-o",
                            folder / "t.txt", "--report", folder / "r.json"});
  ASSERT_EQ(matched.status, 0) << matched.out << matched.err;
  EXPECT_LT(errorOf("t.txt"), 1.0);
  auto report = readJson(folder / "r.json");
  EXPECT_EQ(report["verdict"], "aligned");
  EXPECT_GT(report["quality"]["margin"].get<double>(), 1.0);
  EXPECT_NEAR(report["quality"]["turn_deg"].get<double>(), glm::degrees(0.14), 1.0);
  EXPECT_FALSE(report["hypotheses"].empty());
  EXPECT_FALSE(report["levels"].empty());

  const auto refined = run({"register", folder / "f.mha", folder / "m.mha", "--method", "rigid", "--start", folder / "t.txt", "-o",
                            folder / "u.txt", "--assess", "--report", folder / "r.json"});
  ASSERT_EQ(refined.status, 0) << refined.out << refined.err;
  EXPECT_LT(errorOf("u.txt"), 0.6);
  auto figures = readJson(folder / "r.json");
  EXPECT_GT(figures["quality"]["local_correlation_after"].get<double>(), 0.3);
  EXPECT_FALSE(figures["regions"].empty());
  EXPECT_GT(figures["quality"]["conditioning"].get<double>(), 0.0);
}

TEST_F(RegisterImages, StrangersAreRefusedWithStatusThree) {
  const auto outcome =
      run({"register", folder / "f.mha", folder / "o.mha", "--method", "partial", "--max-turn", "15", "-o", folder / "t.txt"});
  EXPECT_EQ(outcome.status, 3) << outcome.out << outcome.err;
  EXPECT_TRUE(outcome.out.starts_with("Not aligned: ") || outcome.out.starts_with("Cannot tell: ")) << outcome.out;
}

TEST_F(RegisterImages, ABendIsWrittenAsAFieldThatIsBetterThanNoneAndWithoutFolds) {
  const SpeckleTissue tissue(9);
  TissueView view = viewOfSide(48, 0.8);
  write(tissue, view, "a.mha");
  const auto warp = [](const glm::dvec3& p) { return 2.5 * glm::dvec3(std::sin(p.y / 12.0), std::sin(p.z / 14.0), std::sin(p.x / 13.0)); };
  view.view = 2;
  view.toTissue = [&](const glm::dvec3& q) {
    glm::dvec3 p = q;
    for (int step = 0; step < 30; ++step) p = q - warp(p);
    return p;
  };
  write(tissue, view, "b.mha");
  const auto outcome = run({"register", folder / "a.mha", folder / "b.mha", "--method", "elastic3d", "--threads", "1", "-o",
                            folder / "t.txt", "--field", folder / "field.mha", "--report", folder / "r.json"});
  ASSERT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  const auto field = readVectorField(folder / "field.mha");
  ASSERT_TRUE(field);
  double before = 0.0;
  double after = 0.0;
  for (int k = 4; k < 44; k += 4)
    for (int j = 4; j < 44; j += 4)
      for (int i = 4; i < 44; i += 4) {
        const glm::dvec3 u = warp(0.8 * glm::dvec3(i, j, k));
        const float* found = field->values.data() + 3 * field->grid.indexOf(i, j, k);
        before += glm::length(u) / 1000.0;
        after += glm::length(glm::dvec3(found[0], found[1], found[2]) - u) / 1000.0;
      }
  EXPECT_LT(after, 0.35 * before) << before << " mm undone";
  auto report = readJson(folder / "r.json");
  EXPECT_GT(report["quality"]["jacobian_min"].get<double>(), 0.0);
  EXPECT_EQ(report["quality"]["folded_cells"], 0);
  EXPECT_GT(report["levels"].size(), 1u);
}

TEST_F(RegisterImages, ImagesGiveATwoDimensionalFieldInTheCoordinatesOfBothHeaders) {
  const SpeckleTissue tissue(12);
  TissueView view = viewOfSide(128, 0.4);
  view.grid.dims.z = 1;
  view.grid.origin_mm = {3.0, 4.0, 0.0};
  write(tissue, view, "a.mha");
  view.view = 2;
  view.toTissue = [](const glm::dvec3& q) { return q - glm::dvec3(1.2, -0.8, 0.0); };
  write(tissue, view, "b.mha");
  const auto outcome = run({"register", folder / "a.mha", folder / "b.mha", "--method", "elastic2d", "-o", folder / "t.txt", "--field",
                            folder / "field.mha", "--moved", folder / "moved.mha"});
  ASSERT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  const auto field = readVectorField(folder / "field.mha");
  ASSERT_TRUE(field) << field.error();
  EXPECT_EQ(field->components, 2);
  EXPECT_NE(readText(folder / "field.mha").find("NDims = 2"), std::string::npos);
  double worst = 0.0;
  for (int j = 20; j < 108; j += 8)
    for (int i = 20; i < 108; i += 8) {
      const float* found = field->values.data() + 2 * field->grid.indexOf(i, j, 0);
      worst = std::max(worst, std::hypot(static_cast<double>(found[0]) - 1.2, static_cast<double>(found[1]) + 0.8));
    }
  EXPECT_LT(worst, 0.5);
  const auto refused = run({"register", folder / "f.mha", folder / "m.mha", "--method", "elastic2d", "-o", folder / "t.txt"});
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("takes two images"), std::string::npos) << refused.err;
}

TEST_F(RegisterImages, ImagesOfWhichOneHeaderIsLeftHandedAreBroughtTogetherByARotation) {
  const SpeckleTissue tissue(12);
  TissueView view = viewOfSide(128, 0.4);
  view.grid.dims.z = 1;
  write(tissue, view, "a.mha");
  view.grid.directions[2] = -view.grid.directions[2];  // of an image nothing lies along it
  view.view = 2;
  view.toTissue = [](const glm::dvec3& q) { return glm::dvec3(q.x - 1.2, q.y + 0.8, q.z); };
  write(tissue, view, "b.mha");
  const auto outcome = run({"register", folder / "a.mha", folder / "b.mha", "--method", "elastic2d", "-o", folder / "t.txt"});
  ASSERT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  const auto rigid = cli::readTransform(folder / "t.txt");
  ASSERT_TRUE(rigid) << rigid.error();
  EXPECT_GT(glm::determinant(rigid->matrix), 0.0);
  for (const glm::dvec3& corner : {glm::dvec3(0, 0, 0), glm::dvec3(50, 0, 0), glm::dvec3(0, 50, 0)})
    EXPECT_LT(glm::distance(carried(*rigid, corner), corner), 1e-9) << "the pixels stay where they are";
}

TEST(RegistrationFiles, ATransformComesBackTheSameToTheLastBit) {
  const TemporaryFolder folder;
  const Transform<frame::Moving, frame::Fixed> fixedToMoving{
      glm::rotate(glm::translate(glm::dmat4(1.0), {1.0 / 3.0, -1e6, 2e-9}), 0.7, glm::dvec3(1.0, 0.0, 0.0))};
  writeText(folder / "t.txt", "# made by hand\n" + cli::transformText(fixedToMoving));
  const auto read = cli::readTransform(folder / "t.txt");
  ASSERT_TRUE(read) << read.error();
  EXPECT_EQ(*read, fixedToMoving);
  for (const auto& [text, code] : {std::pair{std::string("1 2 3"), ErrorCode::badField},
                                   {std::string("1 0 0 0 0 1 0 0 0 0 -1 0 0 0 0 1"), ErrorCode::notRigid},
                                   {std::string("1 0 0 0 0 1 0 0 0 0 x 0 0 0 0 1"), ErrorCode::badField}}) {
    writeText(folder / "bad.txt", text);
    const auto bad = cli::readTransform(folder / "bad.txt");
    ASSERT_FALSE(bad) << text;
    EXPECT_EQ(bad.error().code, code) << bad.error();
  }
}

}  // namespace
}  // namespace ew::test::register_test
