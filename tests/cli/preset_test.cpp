#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>

#include "cli/cli_world.h"
#include "places.h"

namespace ew::test::preset_command_test {
namespace {

using nlohmann::json;

class PresetCommand : public ::testing::Test {
 protected:
  const TemporaryFolder folder_;
  EnvironmentValue resources_{"ECHOWEAVE_RESOURCES", std::string(EW_SOURCE_DIR) + "/resources"};
  EnvironmentValue own_{"ECHOWEAVE_PRESETS", folder_ / "own"};
  const std::string shipped_ = std::string(EW_SOURCE_DIR) + "/resources/presets/";

  std::string changed(const std::string& name, const std::function<void(json&)>& change) const {
    json preset = readJson(shipped_ + "abdomen-convex-3.5.json");
    change(preset);
    writeText(folder_ / name, preset.dump());
    return folder_ / name;
  }
};

TEST_F(PresetCommand, ListsThoseOfTheProgramAndOnesOwn) {
  const auto outcome = run({"preset", "list"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("thyroid-linear-12 "), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("Obstetrics, second trimester\n"), std::string::npos);
  EXPECT_EQ(outcome.out.find("(your own)"), std::string::npos);
  std::filesystem::create_directory(folder_ / "own");
  changed("own/mine.json", [](json& preset) { preset["title"] = {{"en", "Mine"}, {"de", "Meine"}}; });
  writeText(folder_ / "own/broken.json", "{");
  const auto german = run({"preset", "list", "--language", "de", "--probe", "convex-3.5"});
  EXPECT_EQ(german.status, 0) << german.err;
  EXPECT_NE(german.out.find("Meine (your own)"), std::string::npos) << german.out;
  EXPECT_EQ(german.out.find("thyroid"), std::string::npos);
  EXPECT_NE(german.err.find("broken.json"), std::string::npos) << german.err;
  const json listed = json::parse(run({"preset", "list", "--json"}).out);
  EXPECT_EQ(listed["presets"].back()["id"], "mine");
  EXPECT_EQ(listed["presets"].back()["own"], true);
}

TEST_F(PresetCommand, ChecksEveryFileThatIsNamed) {
  const auto good = run({"preset", "check", shipped_ + "abdomen-convex-3.5.json"});
  EXPECT_EQ(good.status, 0) << good.err;
  EXPECT_NE(good.out.find("a preset of convex-3.5, Abdomen."), std::string::npos) << good.out;
  const std::string deep = changed("deep.json", [](json& preset) { preset["knobs"]["depth_mm"] = 900; });
  const std::string odd = changed("odd.json", [](json& preset) { preset["knobs"]["grey_map"] = "pink"; });
  const auto bad = run({"preset", "check", deep, shipped_ + "abdomen-convex-3.5.json", odd, "--report", folder_ / "r.json"});
  EXPECT_EQ(bad.status, 1);
  EXPECT_NE(bad.out.find("'knobs.depth_mm' in the preset deep is 900; it must be a number from 60 to 240."), std::string::npos) << bad.out;
  EXPECT_NE(bad.out.find("'grey_map' in the knobs of "), std::string::npos) << bad.out;
  EXPECT_NE(bad.err.find("Of 3 presets 2 cannot be used"), std::string::npos) << bad.err;
  EXPECT_EQ(readJson(folder_ / "r.json")["quality"]["problems"], 2);
}

}  // namespace
}  // namespace ew::test::preset_command_test
