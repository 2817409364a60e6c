#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

#include "cli/cli_world.h"
#include "ew/cli/run_command.h"
#include "ew/sdk/plugin.h"

namespace ew::test::plugins_test {
namespace {

void writeManifest(const TemporaryFolder& folder, const std::string& name, const nlohmann::json& changes) {
  std::filesystem::create_directories(folder.path() / name);
  nlohmann::json manifest = {
      {"name", name}, {"version", "1.2.3"}, {"abi", sdk::kAbi}, {"capabilities", {"command:" + name}}, {"description", "A test."}};
  manifest["library"] = name + ".so";
  manifest.update(changes);
  writeText(folder / (name + "/plugin.json"), manifest.dump());
  writeText(folder / (name + "/" + name + ".so"), "no library at all");
}

TEST(PluginsCommand, ABrokenAForeignAndAnOlderPluginAreMessagesAndTheStatusIsZero) {
  const TemporaryFolder folder;
  const EnvironmentValue searched("ECHOWEAVE_PLUGINS", folder.path().string());
  writeManifest(folder, "foreign", nlohmann::json::object());
  writeManifest(folder, "older", {{"abi", sdk::kAbi - 0x10000}});
  std::filesystem::create_directory(folder / "broken");
  writeText(folder / "broken/plugin.json", "{ \"name\": ");
  const auto listed = run({"plugins", "list", "--json", "--report", folder / "r.json"});
  ASSERT_EQ(listed.status, 0) << listed.err;
  const auto json = nlohmann::json::parse(listed.out, nullptr, false);
  ASSERT_TRUE(json.is_object()) << listed.out;
  std::size_t ours = 0;
  for (const auto& plugin : json["plugins"]) {
    if (plugin["folder"].get<std::string>().rfind(folder.path().string(), 0) != 0) continue;
    ++ours;
    EXPECT_NE(plugin["state"], "loaded");
    EXPECT_FALSE(plugin["message"].get<std::string>().empty()) << plugin;
  }
  EXPECT_EQ(ours, 3u);
  EXPECT_EQ(readJson(folder / "r.json")["quality"]["not_loaded"], 3);
  const auto words = run({"plugins", "list"});
  EXPECT_EQ(words.status, 0);
  EXPECT_NE(words.out.find("older"), std::string::npos);
  EXPECT_NE(words.out.find("1.2.3"), std::string::npos);
  EXPECT_NE(words.out.find(folder.path().string()), std::string::npos) << "the folders searched";
}

TEST(PluginsCommand, ACommandOfAPluginThatCannotBeLoadedSaysWhy) {
  const TemporaryFolder folder;
  const EnvironmentValue searched("ECHOWEAVE_PLUGINS", folder.path().string());
  writeManifest(folder, "gauge", {{"abi", sdk::kAbi - 0x10000}});
  const auto outcome = run({"gauge", "a.mha", "--report", folder / "r.json"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("gauge"), std::string::npos) << outcome.err;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  EXPECT_FALSE(std::filesystem::exists(folder / "r.json"));
}

TEST(PluginsCommand, ACommandThatThrowsIsOneSentenceThatNamesThePlugin) {
  for (const auto& [kind, command, why] :
       {std::tuple{"callbacks", "throw-number", "stopped unexpectedly"},
        std::tuple{"callbacks", "throw-at-the-end", "stopped unexpectedly"}, std::tuple{"callbacks", "throw-memory", "not enough memory"},
        std::tuple{"late", "throw-number", "changed its mind"}, std::tuple{"late_number", "throw-number", "could not start"}}) {
    const TemporaryFolder folder;
    const EnvironmentValue searched("ECHOWEAVE_PLUGINS", folder.path().string());
    writeManifest(folder, "odd", {{"capabilities", {"command:throw-number", "command:throw-memory", "command:throw-at-the-end"}}});
    std::filesystem::copy_file(std::string(EW_ODD_PLUGIN_DIR "/odd_") + kind + ".so", folder.path() / "odd/odd.so",
                               std::filesystem::copy_options::overwrite_existing);
    const auto outcome = run({command, "--report", folder / "r.json"});
    EXPECT_EQ(outcome.status, 1) << kind;
    EXPECT_NE(outcome.err.find(why), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("'odd'"), std::string::npos) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "r.json"));
    EXPECT_EQ(run({"plugins", "list"}).status, 0);
  }
}

TEST(PluginsCommand, TheHelpNamesTheCommandsOfPluginsWithoutLoadingThem) {
  const TemporaryFolder folder;
  const EnvironmentValue searched("ECHOWEAVE_PLUGINS", folder.path().string());
  writeManifest(folder, "gauge", nlohmann::json::object());
  const auto help = run({"--help"});
  EXPECT_EQ(help.status, 0);
  EXPECT_NE(help.out.find("gauge"), std::string::npos) << help.out;
}

TEST(PluginsCommand, StitchJoinsTwoVolumesAndReportsLikeACommandOfOurOwn) {
  const std::vector<std::string> stitch{"stitch"};
#ifdef EW_WITH_STITCHING
  ASSERT_TRUE(cli::isHeadless(stitch)) << "the stitching plugin is part of this build and brought no command";
#else
  if (!cli::isHeadless(stitch)) GTEST_SKIP() << "the stitching plugin is not part of this build";
#endif
  const TemporaryFolder folder;
  Volume constant;
  constant.grid.dims = {8, 6, 4};
  constant.echo.assign(constant.grid.voxelCount(), 90);
  ASSERT_TRUE(writeVolume(constant, folder / "a.mha"));
  const nlohmann::json atRest{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, moved{1, 0, 0, 4, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  const nlohmann::json project{{"volumes", {{{"file", "a.mha"}, {"to_world", atRest}}, {{"file", "a.mha"}, {"to_world", moved}}}}};
  writeText(folder / "project.json", project.dump());
  const auto outcome = run({"stitch", folder / "project.json", "-o", folder / "out", "--report", folder / "r.json", "--quiet"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out + outcome.err, "");
  const auto joined = readVolume(folder / "out/volume.mha");
  ASSERT_TRUE(joined) << joined.error();
  EXPECT_EQ(joined->volume.grid.dims, glm::ivec3(12, 6, 4));
  EXPECT_EQ(joined->volume.echo, std::vector<std::uint8_t>(joined->volume.grid.voxelCount(), 90));
  const auto report = readJson(folder / "r.json");
  EXPECT_EQ(report["command"], "stitch");
  EXPECT_EQ(report["inputs"], nlohmann::json({folder / "project.json"}));
  EXPECT_FALSE(report["outputs"].empty());

  const auto missing = run({"stitch", folder / "none.json", "-o", folder / "out2"});
  EXPECT_EQ(missing.status, 1);
  EXPECT_FALSE(std::filesystem::exists(folder / "out2"));
  EXPECT_EQ(run({"stitch"}).status, 2);
  EXPECT_EQ(run({"stitch", "--help"}).status, 0);
}

}  // namespace
}  // namespace ew::test::plugins_test
