#include "ew/export/image_record.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace ew::image_record_test {
namespace {

ImageRecord stored() {
  ImageRecord image;
  image.options.instanceUid = newDicomUid();
  image.options.number = 3;
  image.options.probe.id = "linear-7.5";
  image.options.probe.name = "Linear";
  image.options.carrier_hz = 7.5e6;
  image.options.depth_mm = 61.25;
  image.options.label = "kidney";
  image.options.taken = std::chrono::sys_seconds(std::chrono::seconds(1764312000));
  image.regions.push_back({RegionCalibration::Kind::image, {12, 48, 640, 480}, {0.0123, 0.0123}, {320, -14}, {0.0, 0.0}});
  image.regions.push_back({RegionCalibration::Kind::strip, {12, 540, 640, 200}, {0.00625, 0.03}, {0, 0}, {0.0, 0.0}});
  image.regions.push_back({RegionCalibration::Kind::spectrum,
                           {12, 760, 640, 200},
                           {0.00625, -0.5},
                           {0, 90},
                           {0.0, 0.1},
                           RegionCalibration::Doppler{4000.0, 5e6, -12.0, 60.0, glm::ivec2(300, 200)}});
  image.regions.push_back({RegionCalibration::Kind::colour,
                           {100, 100, 90, 80},
                           {0.0123, 0.0123},
                           {10, -14},
                           {0.0, 0.0},
                           RegionCalibration::Doppler{5000.0, 5e6}});
  image.caption = "Linear, 6.1 cm, 10:00";
  image.hasLeft = true;
  image.study.patient = {"Maren Achterberg", "EW-17", "female", 61};
  image.study.title = "Pain after meals";
  image.study.studyUid = newDicomUid();
  image.study.imagesUid = newDicomUid();
  image.study.reportsUid = newDicomUid();
  image.study.begun = std::chrono::sys_seconds(std::chrono::seconds(1764311000));
  return image;
}

TEST(ImageRecord, ComesBackAsTheSameObject) {
  const ImageRecord image = stored();
  const auto again = storedImageFromJson(toJson(image), verbatim("image.json"));
  ASSERT_TRUE(again) << again.error();
  EXPECT_EQ(again->options.instanceUid, image.options.instanceUid);
  EXPECT_EQ(again->options.number, 3);
  EXPECT_EQ(again->options.probe, image.options.probe);
  EXPECT_EQ(again->options.carrier_hz, 7.5e6);
  EXPECT_EQ(again->options.depth_mm, 61.25);
  EXPECT_EQ(again->options.taken, image.options.taken);
  EXPECT_EQ(again->regions, image.regions);
  EXPECT_EQ(again->caption, image.caption);
  EXPECT_TRUE(again->hasLeft);
  EXPECT_EQ(again->study, image.study);
}

TEST(ImageRecord, RefusesWhatCannotBeOne) {
  for (const auto& [key, value] : std::vector<std::pair<std::string, nlohmann::json>>{{"instance_uid", "no uid"},
                                                                                      {"format", 99},
                                                                                      {"regions", 5},
                                                                                      {"taken_s", "now"},
                                                                                      {"study", nlohmann::json::object()},
                                                                                      {"probe", "none"}}) {
    nlohmann::json document = toJson(stored());
    document[key] = value;
    EXPECT_FALSE(storedImageFromJson(document, verbatim("image.json"))) << key;
  }
  EXPECT_FALSE(storedImageFromJson(nlohmann::json::array(), verbatim("image.json")));
}

}  // namespace
}  // namespace ew::image_record_test
