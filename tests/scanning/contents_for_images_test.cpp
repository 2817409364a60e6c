// Images of what was made for them alone are those of the whole case.
#include "ew/scanning/contents_for_images.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <vector>

#include "ew/imaging/display.h"
#include "ew/library/case_start.h"
#include "ew/library/preparation.h"
#include "ew/scanning/first_image.h"
#include "ew/scanning/scanner.h"
#include "library/coarse_case.h"

namespace ew::contents_for_images_test {
namespace {

using test::EnvironmentValue;
using test::TemporaryFolder;

constexpr int kWidth_px = 200, kHeight_px = 160;

std::vector<std::uint8_t> imageOf(ScanSubject subject, const ScanState& state) {
  Scanner scanner(1);
  scanner.show(std::move(subject));
  const DisplayImage image = scanner.make(state, kWidth_px, kHeight_px);
  std::vector<std::uint8_t> pixels;
  for (int y = 0; y < image.grey.height; ++y) pixels.insert(pixels.end(), image.grey.row(y), image.grey.row(y) + image.grey.width);
  return pixels;
}

/// The probe moved and turned in its own frame.
Pose movedBy(const Pose& pose, const glm::dvec3& by_mm, double turned_rad) {
  glm::dmat4 move(1.0);
  move[0] = {std::cos(turned_rad), 0.0, std::sin(turned_rad), 0.0};
  move[2] = {-std::sin(turned_rad), 0.0, std::cos(turned_rad), 0.0};
  move[3] = glm::dvec4(by_mm, 1.0);
  Pose moved = pose;
  moved.probeToWorld = Transform<frame::World, frame::Probe>{pose.probeToWorld.matrix * move};
  return moved;
}

class ContentsOfCase : public ::testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    const auto shipped = loadCase(*shippedCasesFolder() / GetParam());
    ASSERT_TRUE(shipped) << shipped.error();
    test::copyCoarse(shipped->folder, folder_ / "case", 2.0 * shipped->volume.recipeSpacing_mm);
    const auto found = loadCase(folder_ / "case");
    ASSERT_TRUE(found) << found.error();
    opened_ = *found;
    const auto there = beginningsThere();
    ASSERT_TRUE(there) << there.error();
    probes_ = there->probes;
  }
  [[nodiscard]] std::vector<StillImages> asked() const {
    std::vector<StillImages> all;
    for (const Probe& probe : probes_) {
      if (std::find(opened_.probes.begin(), opened_.probes.end(), probe.id) == opened_.probes.end()) continue;
      StillImages images{probe, {}, {*opened_.startPose, movedBy(*opened_.startPose, {8.0, 3.0, -6.0}, 0.7)}};
      images.knobs.depth_mm = 0.6 * resolvedDepth_mm(probe, {});
      all.push_back(images);
      images.knobs.compoundAngles = 3;
      images.knobs.harmonic = true;
      images.knobs.steering_rad = probe.kind == ProbeKind::linear ? 0.2 : 0.0;
      images.poses.resize(1);
      all.push_back(images);
      // A piece of the slab that is nearly twice as thick as the others, the finer slice, and lines that lean.
      images.knobs.depth_mm = 79.0;
      images.knobs.quality = Quality::cubic;
      images.knobs.compoundAngles = 1;
      images.knobs.harmonic = false;
      images.knobs.trapezoid = probe.kind == ProbeKind::linear;
      all.push_back(images);
      images.knobs.quality = Quality::weave;
      images.knobs.trapezoid = false;
      all.push_back(images);
    }
    return all;
  }

  TemporaryFolder folder_;
  EnvironmentValue cache_{"ECHOWEAVE_CACHE", folder_ / "cache"};
  Case opened_;
  std::vector<Probe> probes_;
};
INSTANTIATE_TEST_SUITE_P(Shipped, ContentsOfCase,
                         ::testing::Values("upper-abdomen-gall-stone", "neck-carotid-thyroid", "fetal-biometry", "focused-trauma"),
                         test::nameOfCase);

TEST_P(ContentsOfCase, GiveThePixelsOfTheWhole) {
  test::writeText(folder_ / "cache/speed.json", R"({"voxels": 50.0})");  // a machine so slow that even this is worth a part
  std::vector<std::pair<StillImages, ContentsForImages>> parts;
  for (const StillImages& images : asked()) {
    auto part = readContentsFor(opened_, images, noProgress());
    ASSERT_TRUE(part) << part.error();
    ASSERT_TRUE(*part) << images.probe.id << " sees too much to be worth a part";
    parts.emplace_back(images, std::move(**part));
  }
  EXPECT_TRUE(caseNeedsPreparation(opened_)) << "nothing is kept";
  const auto whole = readContents(opened_, noProgress());
  ASSERT_TRUE(whole) << whole.error();
  for (const auto& [images, part] : parts) {
    ASSERT_EQ(part.contents.flow == nullptr, whole->flow == nullptr);
    EXPECT_EQ(whole->flow == nullptr, GetParam() != "neck-carotid-thyroid");
    if (whole->flow) {
      EXPECT_EQ(part.contents.flow->bytes(), whole->flow->bytes());
      EXPECT_EQ(part.contents.flow->bounds().lowest_mm, whole->flow->bounds().lowest_mm);
    }
    for (const Pose& pose : images.poses) {
      const ScanState state{.probe = images.probe, .knobs = images.knobs, .pan = {}, .scene = opened_.scene, .pose = pose, .gaps_mm = {}};
      const auto expected = imageOf(subjectOf(opened_, *whole), state);
      EXPECT_EQ(imageOf(subjectOf(opened_, part.contents), state), expected) << images.probe.id << ", " << part.share;
      // Lifted off at one end.
      ScanState other = state;
      other.gaps_mm = {0.0, 3.0};
      EXPECT_EQ(imageOf(subjectOf(opened_, part.contents), other), imageOf(subjectOf(opened_, *whole), other)) << images.probe.id;
      EXPECT_GT(std::count_if(expected.begin(), expected.end(), [](int grey) { return grey > 20; }), 1000) << images.probe.id;
    }
  }
  const auto there = readContentsFor(opened_, asked().front(), noProgress());
  ASSERT_TRUE(there) << there.error();
  EXPECT_FALSE(*there) << "the whole is there";
}

TEST_P(ContentsOfCase, AreNotMadeWhereEchoesAreSliced) {
  test::writeText(folder_ / "cache/speed.json", R"({"voxels": 50.0})");
  opened_.scene.liveEchoes.reset();
  const auto part = readContentsFor(opened_, asked().front(), noProgress());
  ASSERT_TRUE(part) << part.error();
  EXPECT_FALSE(*part);
}

}  // namespace
}  // namespace ew::contents_for_images_test
