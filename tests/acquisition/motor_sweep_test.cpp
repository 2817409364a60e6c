#include "ew/acquisition/motor_sweep.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "acquisition/sweeps.h"
#include "ew/core/numbers.h"
#include "ew/io/gating_fields.h"
#include "places.h"

namespace ew::motor_sweep_test {
namespace {

using nlohmann::json;
using sweeps::imageOf;
using sweeps::Sweep;

constexpr double kDegree_rad = std::numbers::pi / 180.0;

glm::dvec3 reached(const MotorSweep& motor, double value, const glm::dvec3& p_probe) {
  return (probeToWorldAt(motor, value) * Point<frame::Probe>{p_probe}).at;
}

TEST(MotorSweep, AFanTurnsAboutTheAxisBehindItsFace) {
  MotorSweep fan{.kind = MotorKind::fan, .axisBehindFace_mm = 12.0};
  for (const double angle_deg : {-35.0, 0.0, 20.0}) {
    const double angle_rad = angle_deg * kDegree_rad;
    const glm::dvec3 at = reached(fan, angle_deg, {7.0, 50.0, 0.0});
    EXPECT_NEAR(at.x, 7.0, 1e-12);
    EXPECT_NEAR(at.y, 62.0 * std::cos(angle_rad) - 12.0, 1e-12);
    EXPECT_NEAR(at.z, 62.0 * std::sin(angle_rad), 1e-12);
    EXPECT_LT(glm::distance(reached(fan, angle_deg, {3.0, -12.0, 0.0}), glm::dvec3(3.0, -12.0, 0.0)), 1e-12) << "the axis stays";
  }
}

TEST(MotorSweep, ARotationalSweepKeepsItsAxisOnAndOffTheBeam) {
  MotorSweep turning{.kind = MotorKind::rotational};
  EXPECT_LT(glm::distance(reached(turning, 90.0, {5.0, 30.0, 0.0}), glm::dvec3(0.0, 30.0, -5.0)), 1e-12);
  turning.axisOffset_mm = {4.0, 2.0};
  EXPECT_LT(glm::distance(reached(turning, 77.0, {4.0, 30.0, 2.0}), glm::dvec3(4.0, 30.0, 2.0)), 1e-12);
  EXPECT_LT(glm::distance(reached(turning, 180.0, {0.0, 30.0, 0.0}), glm::dvec3(8.0, 30.0, 4.0)), 1e-12);
}

/// A soft ball of 6 mm in a ramp: the world that all three motors look at.
double levelAt(const glm::dvec3& p_mm) {
  const glm::dvec3 centre_mm(1.5, 21.0, -0.7);
  return 40.0 + p_mm.y + 120.0 * std::exp(-glm::dot(p_mm - centre_mm, p_mm - centre_mm) / 18.0);
}

Sweep imaged(const MotorSweep& motor, int frames) {
  constexpr int kWidth = 81, kHeight = 101;
  constexpr double kPixel_mm = 0.4;
  Sweep sweep;
  for (int n = 0; n < frames; ++n) {
    const glm::dmat4 probeToWorld = probeToWorldAt(motor, motor.first + n * motor.step).matrix;
    const glm::dmat4 imageToProbe = sweeps::matrixOf({kPixel_mm, 0, 0}, {0, kPixel_mm, 0}, {0, 0, kPixel_mm}, {-16.0, 0.0, 0.0});
    sweep.add(imageOf(kWidth, kHeight,
                      [&](int x, int y) {
                        // Where the pixel lies, by hand rather than by the matrices under test.
                        const double lateral_mm = kPixel_mm * x - 16.0, depth_mm = kPixel_mm * y;
                        const double value = motor.first + n * motor.step, angle_rad = value * kDegree_rad;
                        glm::dvec3 at_mm(lateral_mm, depth_mm, value);
                        if (motor.kind == MotorKind::fan) {
                          const double radius_mm = depth_mm + motor.axisBehindFace_mm;
                          at_mm = {lateral_mm, radius_mm * std::cos(angle_rad) - motor.axisBehindFace_mm, radius_mm * std::sin(angle_rad)};
                        } else if (motor.kind == MotorKind::rotational) {
                          at_mm = {lateral_mm * std::cos(angle_rad), depth_mm, -lateral_mm * std::sin(angle_rad)};
                        }
                        return static_cast<int>(std::lround(levelAt(at_mm)));
                      }),
              probeToWorld * imageToProbe);
  }
  return sweep;
}

/// Centroid of what the ball adds to the ramp, over measured voxels within 7 mm of where it should be.
double centroidError_mm(const Volume& volume) {
  const glm::dvec3 centre_mm(1.5, 21.0, -0.7);
  glm::dvec3 sum(0.0);
  double weight = 0.0;
  const auto voxelToWorld = volume.grid.voxelToWorld();
  for (int k = 0; k < volume.grid.dims.z; ++k)
    for (int j = 0; j < volume.grid.dims.y; ++j)
      for (int i = 0; i < volume.grid.dims.x; ++i) {
        const std::size_t index = volume.grid.indexOf(i, j, k);
        const glm::dvec3 p_mm = (voxelToWorld * Point<frame::Voxel>{{i, j, k}}).at;
        if (volume.coverageAt(index) == Coverage::absent || glm::distance(p_mm, centre_mm) > 7.0) continue;
        const double adds = std::max(0.0, volume.echo[index] - 40.0 - p_mm.y);
        sum += adds * p_mm;
        weight += adds;
      }
  return glm::distance(sum / weight, centre_mm);
}

TEST(MotorSweep, ParallelFanAndRotationalSweepsOfOneWorldAgreeWithIt) {
  const MotorSweep motors[] = {{.kind = MotorKind::parallel, .first = -9.0, .step = 0.45},
                               {.kind = MotorKind::fan, .first = -25.0, .step = 1.0, .axisBehindFace_mm = 8.0},
                               {.kind = MotorKind::rotational, .first = 0.0, .step = 3.0}};
  for (const MotorSweep& motor : motors) {
    const Sweep sweep = imaged(motor, motor.kind == MotorKind::rotational ? 60 : motor.kind == MotorKind::fan ? 51 : 41);
    const auto made = reconstruct(sweep.frames, {.spacing_mm = 0.5, .fillReach_mm = 3.0}, noProgress());
    ASSERT_TRUE(made.has_value()) << made.error();
    EXPECT_LT(centroidError_mm(made->volume), 0.1) << "kind " << static_cast<int>(motor.kind) << ", voxels of 0.5 mm";
    double worst = 0.0, sum = 0.0;
    std::size_t count = 0;
    const Grid& grid = made->volume.grid;
    for (int k = 0; k < grid.dims.z; ++k)
      for (int j = 0; j < grid.dims.y; ++j)
        for (int i = 0; i < grid.dims.x; ++i) {
          const std::size_t index = grid.indexOf(i, j, k);
          if (made->volume.coverageAt(index) != Coverage::measured) continue;
          const double error = std::abs(made->volume.echo[index] - levelAt((grid.voxelToWorld() * Point<frame::Voxel>{{i, j, k}}).at));
          worst = std::max(worst, error);
          sum += error;
          ++count;
        }
    EXPECT_LT(sum / static_cast<double>(count), 1.2) << "of a world whose steepest slope is 12 levels a voxel";
    EXPECT_LT(worst, 12.0) << "no voxel is a whole voxel off";
  }
}

class MotorFile : public testing::Test {
 protected:
  MotorFile() {
    const json document = json::parse(std::ifstream(std::string(EW_SOURCE_DIR) + "/resources/schemas/motor-sweep.schema.json"));
    valijson::SchemaParser(valijson::SchemaParser::kDraft7).populateSchema(valijson::adapters::NlohmannJsonAdapter(document), schema_);
  }
  ~MotorFile() override { std::filesystem::remove(file_); }
  Result<MotorSweep> read(const json& motor) {
    std::ofstream(file_) << motor;
    return readMotorSweep(file_);
  }
  bool schemaTakes(const json& motor) {
    valijson::Validator validator;
    return validator.validate(schema_, valijson::adapters::NlohmannJsonAdapter(motor), nullptr);
  }

 private:
  std::filesystem::path file_ = std::filesystem::path(testing::TempDir()) / "ew_motor_sweep_test.json";
  valijson::Schema schema_;
};

TEST_F(MotorFile, SaysEverythingAboutAFan) {
  const json file = {{"format", 1},
                     {"kind", "fan"},
                     {"step_deg", 0.5},
                     {"first_deg", -20},
                     {"axis_behind_face_mm", 11},
                     {"image", {{"pixel_mm", {0.2, 0.3}}, {"face_px", {100, 10}}}},
                     {"probe_to_world", {0, -1, 0, 5, 1, 0, 0, 6, 0, 0, 1, 7, 0, 0, 0, 1}}};
  EXPECT_TRUE(schemaTakes(file));
  const auto motor = read(file);
  ASSERT_TRUE(motor.has_value()) << motor.error();
  EXPECT_EQ(motor->kind, MotorKind::fan);
  EXPECT_EQ(motor->step, 0.5);
  EXPECT_EQ(motor->first, -20.0);
  EXPECT_EQ(motor->axisBehindFace_mm, 11.0);
  EXPECT_EQ(motor->startProbeToWorld.matrix[3], glm::dvec4(5, 6, 7, 1));
  const glm::dvec3 face_mm = (*motor->imageToProbe * Point<frame::Image>{{100.0, 10.0, 0.0}}).at;
  const glm::dvec3 beyond_mm = (*motor->imageToProbe * Point<frame::Image>{{110.0, 30.0, 0.0}}).at;
  EXPECT_LT(glm::length(face_mm), 1e-12);
  EXPECT_LT(glm::distance(beyond_mm, glm::dvec3(2.0, 6.0, 0.0)), 1e-12);
}

TEST_F(MotorFile, ReaderAndSchemaRefuseTheSameFilesByField) {
  const json good = {{"format", 1}, {"kind", "parallel"}, {"step_mm", 0.4}};
  ASSERT_TRUE(schemaTakes(good) && read(good));
  const std::vector<std::pair<std::string, json>> bad = {{"kind", {{"kind", "spiral"}}},
                                                         {"step_mm", {{"step_mm", 0}}},
                                                         {"step_mm", {{"step_mm", "wide"}}},
                                                         {"step_mm", {{"positions_mm", {0, 1, 2}}}},
                                                         {"axis_behind_face_mm", {{"axis_behind_face_mm", 3}}},
                                                         {"angles_deg", {{"angles_deg", {0, 1}}}},
                                                         {"probe_to_world", {{"probe_to_world", {1, 2, 3}}}},
                                                         {"colour", {{"colour", "red"}}},
                                                         {"pixel_mm", {{"image", {{"face_px", {1, 2}}}}}},
                                                         {"face_px", {{"image", {{"pixel_mm", {1, 2}}}}}}};
  for (const auto& [field, change] : bad) {
    json file = good;
    file.update(change);
    EXPECT_FALSE(schemaTakes(file)) << file;
    const auto motor = read(file);
    ASSERT_FALSE(motor.has_value()) << file;
    EXPECT_EQ(motor.error().code, ErrorCode::badField);
    EXPECT_NE(motor.error().sentence().find(field + "' in the motor file "), std::string::npos) << motor.error();
  }
  json none = good;
  none.erase("step_mm");
  EXPECT_FALSE(schemaTakes(none) || read(none));
  EXPECT_EQ(read({{"format", 2}, {"kind", "fan"}}).error().code, ErrorCode::newerFormat);
}

Sequence recordedFan(int frames) {
  Sequence sequence;
  sequence.width = 4;
  sequence.height = 3;
  sequence.otherFields = {{std::string(fields::kMotorKind), "FAN"},
                          {std::string(fields::kMotorAxisBehindFace), "9.5"},
                          {std::string(fields::kMotorStart), "1 0 0 3 0 1 0 0 0 0 1 0 0 0 0 1"}};
  for (int n = 0; n < frames; ++n) {
    SequenceFrame frame;
    frame.otherFields = {{std::string(fields::kMotorAngle), textOf(-4.0 + 2.0 * n)}};
    frame.transforms = {{"Image", "Probe", glm::dmat4(1.0), PoseStatus::ok}};
    sequence.frames.push_back(frame);
  }
  return sequence;
}

TEST(RecordedMotor, GivesThePosesThatItsFieldsSay) {
  Sequence sequence = recordedFan(5);
  sequence.frames[1].imageStatus = PoseStatus::invalid;
  sequence.frames[3].otherFields.clear();
  const auto motor = recordedMotor(sequence);
  ASSERT_TRUE(motor.has_value()) << motor.error();
  const auto poses = motorPoses(sequence, *motor);
  ASSERT_TRUE(poses.has_value()) << poses.error();
  EXPECT_EQ(poses->usable, 3u);
  EXPECT_EQ(poses->invalid, 1u);
  EXPECT_EQ(poses->missing, 1u);
  EXPECT_FALSE(poses->imageToWorld[1] || poses->imageToWorld[3]);
  const double angle_rad = 4.0 * kDegree_rad;
  const glm::dvec3 at = (*poses->imageToWorld[4] * Point<frame::Image>{{0.0, 2.0, 0.0}}).at;
  EXPECT_LT(glm::distance(at, glm::dvec3(3.0, 11.5 * std::cos(angle_rad) - 9.5, 11.5 * std::sin(angle_rad))), 1e-12);
}

TEST(RecordedMotor, SaysWhatIsMissing) {
  Sequence sequence = recordedFan(3);
  EXPECT_FALSE(recordedMotor({}).has_value());
  MotorSweep still{.kind = MotorKind::fan};
  EXPECT_NE(motorPoses(sequence, still).error().sentence().find("does not move"), std::string::npos);
  still.values = {1.0, 2.0};
  EXPECT_NE(motorPoses(sequence, still).error().sentence().find("2 values"), std::string::npos);
  still.values = {1.0, 2.0, 3.0};
  for (auto& frame : sequence.frames) frame.transforms.clear();
  EXPECT_EQ(motorPoses(sequence, still).error().code, ErrorCode::missingCalibration);
  sequence.frames[0].otherFields[0].second = "askew";
  EXPECT_EQ(recordedMotor(sequence).error().code, ErrorCode::badField);
}

}  // namespace
}  // namespace ew::motor_sweep_test
