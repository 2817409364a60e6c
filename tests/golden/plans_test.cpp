// What a frame of each shipped case runs with each of its probes, against kept lists; README.md beside this file says how to renew them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "ew/imaging/frame.h"
#include "ew/library/case.h"
#include "ew/phantom/patient.h"
#include "places.h"

namespace ew::plans_test {
namespace {

namespace fs = std::filesystem;

/// Console settings under which each plan is kept.
struct Setting {
  const char* name;
  Knobs knobs;
  bool isLifted = false;  ///< a part of the face is off the skin
};

std::vector<Setting> settings() {
  Knobs weave, turned, stretched, both;
  weave.quality = Quality::weave;
  turned.gain = 1.2;
  turned.edgeEnhancement = 0.5;
  turned.persistence = 0.5;
  turned.greyMap = GreyMap::soft;
  stretched.focusMethod = FocusMethod::rowStretch;
  both.mode = DisplayMode::both;
  return {{"neutral", {}},
          {"weave", weave},
          {"gain, grey map, edges, persistence", turned},
          {"focus by rows", stretched},
          {"B- and M-mode", both},
          {"partly off the skin", {}, true}};
}

std::string plansOf(const Case& opened, const std::vector<Probe>& probes) {
  const fs::path recipe = opened.folder / opened.volume.recipe;
  const auto tissues = readLabelTissues(recipe);
  EXPECT_TRUE(tissues) << tissues.error();
  std::vector<TissueAcoustics> acoustics;
  for (const LabelTissue& each : *tissues)
    acoustics.push_back({each.label, each.organ, each.tissue.attenuation_dbPerCmMhz, each.tissue.reflection_db});
  const Scene scene = sceneWithTissues(opened.scene, acoustics);
  const Grid grid{{400, 300, 400}, glm::dvec3(opened.volume.recipeSpacing_mm)};
  std::ostringstream text;
  for (const std::string& id : opened.probes) {
    const auto probe = std::find_if(probes.begin(), probes.end(), [&](const Probe& each) { return each.id == id; });
    EXPECT_NE(probe, probes.end()) << id;
    if (probe == probes.end()) continue;
    for (const Setting& setting : settings())
      text << id << ", " << setting.name << "\n  "
           << makePlan(*probe, setting.knobs, scene, fitDisplay(*probe, setting.knobs, 1024, 768), grid, {.labels = true}, setting.isLifted)
           << "\n";
  }
  return text.str();
}

class GoldenPlan : public ::testing::TestWithParam<const char*> {};

TEST_P(GoldenPlan, IsTheKeptList) {
  const fs::path golden = fs::path(EW_SOURCE_DIR) / "tests" / "golden" / "plans" / (std::string(GetParam()) + ".txt");
  const auto opened = loadCase(fs::path(EW_SOURCE_DIR) / "cases" / GetParam());
  ASSERT_TRUE(opened) << opened.error();
  const auto probes = readProbes(fs::path(EW_SOURCE_DIR) / "resources" / "probes");
  ASSERT_TRUE(probes) << probes.error();
  const std::string actual = plansOf(*opened, *probes);
  if (std::getenv("EW_RENEW_GOLDEN") != nullptr) {
    std::ofstream(golden) << actual;
    GTEST_SKIP() << "Renewed " << golden;
  }
  std::ifstream file(golden);
  std::ostringstream expected;
  expected << file.rdbuf();
  EXPECT_EQ(actual, expected.str());
}

INSTANTIATE_TEST_SUITE_P(Kept, GoldenPlan, ::testing::Values("upper-abdomen-gall-stone", "upper-abdomen-normal"), [](const auto& tested) {
  std::string name = tested.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

}  // namespace
}  // namespace ew::plans_test
