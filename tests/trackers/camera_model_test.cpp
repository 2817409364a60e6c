#include "ew/trackers/camera_model.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "trackers/camera_frames.h"

namespace ew {
namespace {

CameraModel aModel() {
  CameraModel model = test::smallCamera();
  model.camera = "HD Webcam";
  model.rms_px = 0.21;
  model.views = 18;
  model.made = "2026-11-27T08:00:00Z";
  return model;
}

TEST(CameraModel, TheRayThroughAPixelLeadsBackToIt) {
  ASSERT_TRUE(rc::check([] {
    CameraModel model = assumedCamera(1280, 720, *rc::gen::inRange(60, 160) * 0.01);
    model.distortion = {*rc::gen::inRange(-20, 20) * 0.01, *rc::gen::inRange(-5, 5) * 0.01, *rc::gen::inRange(-10, 10) * 1e-4,
                        *rc::gen::inRange(-10, 10) * 1e-4, 0.0};
    // As far out as the lens still maps one to one.
    const glm::dvec2 ray(*rc::gen::inRange(-60, 60) * 0.01, *rc::gen::inRange(-40, 40) * 0.01);
    const glm::dvec2 again = rayThrough(model, pixelOf(model, glm::dvec3(ray, 1.0)));
    RC_ASSERT(glm::distance(ray, again) < 1e-9);
  }));
}

TEST(CameraModel, APointOnTheAxisAppearsAtThePrincipalPoint) {
  const CameraModel model = aModel();
  EXPECT_EQ(pixelOf(model, {0.0, 0.0, 500.0}), glm::dvec2(model.cx, model.cy));
}

TEST(CameraModel, SurvivesItsText) {
  const auto read = parseCameraModel(cameraModelText(aModel()), verbatim("camera.json"));
  ASSERT_TRUE(read) << read.error();
  EXPECT_EQ(*read, aModel());
}

TEST(CameraModel, IsRefusedWithTheFieldThatIsWrong) {
  const auto refusal = [](const std::string& from, const std::string& to) {
    std::string text = cameraModelText(aModel());
    text.replace(text.find(from), from.size(), to);
    const auto read = parseCameraModel(text, verbatim("camera.json"));
    return read ? std::string("read") : read.error().sentence();
  };
  EXPECT_NE(refusal("\"width\": 640", "\"width\": -3").find("'width' in camera.json is -3"), std::string::npos);
  EXPECT_NE(refusal("\"fx\"", "\"gx\"").find("fx"), std::string::npos);
  EXPECT_NE(refusal("\"format\": 1", "\"format\": 2").find("format 2"), std::string::npos);
  EXPECT_EQ(parseCameraModel("{", verbatim("camera.json")).error().code, ErrorCode::badHeader);
}

TEST(CameraModel, SeesTheSameInAnImageOfHalfTheSize) {
  const CameraModel model = aModel();
  const auto half = scaledTo(model, 320, 240);
  ASSERT_TRUE(half);
  const glm::dvec3 p(40.0, -30.0, 400.0);
  const glm::dvec2 whole_px = pixelOf(model, p), half_px = pixelOf(*half, p);
  EXPECT_NEAR((whole_px.x + 0.5) / 2.0 - 0.5, half_px.x, 1e-9);
  EXPECT_NEAR((whole_px.y + 0.5) / 2.0 - 0.5, half_px.y, 1e-9);
}

TEST(CameraModel, IsNotStretchedToAnotherShapeOfImage) {
  const auto wide = scaledTo(aModel(), 1280, 720);
  ASSERT_FALSE(wide);
  EXPECT_NE(wide.error().sentence().find("640 x 480"), std::string::npos);
}

}  // namespace
}  // namespace ew
