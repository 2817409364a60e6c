#include <gtest/gtest.h>

#include <algorithm>

#include "cli/cli_world.h"
#include "ew/sdk/plugin.h"

namespace ew::test {
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
  writeManifest(folder, "measure", {{"abi", sdk::kAbi - 0x10000}});
  const auto outcome = run({"measure", "a.mha", "--report", folder / "r.json"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("measure"), std::string::npos) << outcome.err;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  EXPECT_FALSE(std::filesystem::exists(folder / "r.json"));
}

TEST(PluginsCommand, TheHelpNamesTheCommandsOfPluginsWithoutLoadingThem) {
  const TemporaryFolder folder;
  const EnvironmentValue searched("ECHOWEAVE_PLUGINS", folder.path().string());
  writeManifest(folder, "measure", nlohmann::json::object());
  const auto help = run({"--help"});
  EXPECT_EQ(help.status, 0);
  EXPECT_NE(help.out.find("measure"), std::string::npos) << help.out;
}

}  // namespace
}  // namespace ew::test
