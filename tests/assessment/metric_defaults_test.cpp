#include "ew/assessment/metric_defaults.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "ew/assessment/metric.h"
#include "ew/library/case.h"
#include "library/temporary_folder.h"

namespace ew {
namespace {

using nlohmann::json;
using test::TemporaryFolder;

json studied() {
  return {{"format", 1},
          {"study", {{"seed", 1}}},
          {"metrics",
           {{"path_length",
             {{"version", 1},
              {"on", true},
              {"auc", 0.8},
              {"low", 0.7},
              {"high", 0.9},
              {"kinds", {{"sweep", {{"on", false}, {"auc", 0.6}, {"low", 0.5}, {"high", 0.7}}}}}}},
            {"time", {{"version", 99}, {"on", true}, {"auc", 0.9}, {"low", 0.8}, {"high", 1.0}}}}}};
}

Result<MetricDefaults> readFrom(const json& document) {
  const TemporaryFolder folder;
  test::writeText(folder / "assessment" / "default-metrics.json", document.dump());
  return MetricDefaults::read(folder.path());
}

TEST(MetricDefaults, AreThoseThatToldLevelsApartInThatKindOfStep) {
  const auto defaults = readFrom(studied());
  ASSERT_TRUE(defaults) << defaults.error();
  EXPECT_TRUE(defaults->isOn("path_length"));
  EXPECT_FALSE(defaults->isOn("path_length", "sweep"));
  EXPECT_EQ(defaults->areaOf("path_length", "sweep"), (Estimate{0.6, 0.5, 0.7}));
  EXPECT_FALSE(defaults->isOn("time")) << "another version was studied";
  EXPECT_FALSE(defaults->isOn("pressure")) << "nobody studied it";
  EXPECT_FALSE(defaults->areaOf("pressure"));
}

TEST(MetricDefaults, RefuseWhatCannotBe) {
  for (const auto& [path, value] : std::vector<std::pair<std::string, json>>{
           {"/format", 2}, {"/metrics/path_length/auc", 1.4}, {"/metrics/path_length/on", "yes"}, {"/metrics", 3}}) {
    json bad = studied();
    bad[json::json_pointer(path)] = value;
    EXPECT_FALSE(readFrom(bad)) << path;
  }
}

TEST(MetricDefaults, ThatAreShippedKnowEveryMetric) {
  const auto resources = resourceFolder();
  ASSERT_TRUE(resources);
  const auto defaults = MetricDefaults::read(*resources);
  ASSERT_TRUE(defaults) << defaults.error();
  std::size_t on = 0;
  for (const Metric& each : metrics()) {
    on += defaults->isOn(each.id) ? 1 : 0;
    const auto area = defaults->areaOf(each.id);
    if (area) {
      EXPECT_EQ(defaults->isOn(each.id), area->value >= 0.7) << each.id;
    }
  }
  EXPECT_GT(on, 0u);
}

}  // namespace
}  // namespace ew
