#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "ew/door/door.h"
#include "ew/door/headless_host.h"
#include "ew/io/volume_file.h"
#include "library/temporary_folder.h"

namespace ew::door::out_of_tree_test {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;
using test::textOf;
using test::writeText;

constexpr std::uint32_t kOlderAbi = sdk::kAbi ^ 0x10000u;

/// Runs a command; its output is the failure's message.
void runOrFail(const std::string& command, const fs::path& log) {
  const int status = std::system((command + " > '" + log.string() + "' 2>&1").c_str());
  ASSERT_EQ(status, 0) << command << "\n" << textOf(log);
}

/// The installed SDK and the example plugin built against it, made once for all tests of this program.
class OutOfTree : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<TemporaryFolder>();
    const auto& f = *folder_;
    runOrFail(std::string(CMAKE_PROGRAM) + " --install '" EW_BINARY_DIR "' --component sdk --prefix '" + (f / "sdk").string() + "'",
              f / "log");
    build(f / "sdk", f / "build");
    // The same SDK with another interface: what an author who has not updated would build against.
    fs::copy(f / "sdk", f / "older-sdk", fs::copy_options::recursive);
    const fs::path header = f / "older-sdk/include/ew/sdk/abi_number.h";
    std::string text = textOf(header);
    const std::string now = "kAbi = " + std::to_string(sdk::kAbi);
    ASSERT_NE(text.find(now), std::string::npos);
    text.replace(text.find(now), now.size(), "kAbi = " + std::to_string(kOlderAbi));
    writeText(header, text);
    build(f / "older-sdk", f / "older-build");
  }
  static void TearDownTestSuite() { folder_.reset(); }

  static void build(const fs::path& prefix, const fs::path& into) {
    const std::string configure = std::string(CMAKE_PROGRAM) + " -S '" EW_SOURCE_DIR "/tests/example_plugin' -B '" + into.string() +
                                  "' -G '" CMAKE_GENERATOR "' -DCMAKE_CXX_COMPILER='" CMAKE_CXX "' -DCMAKE_PREFIX_PATH='" +
                                  prefix.string() + "' -DEW_SANITIZE='" EW_SANITIZE_FLAGS "'";
    runOrFail(configure, *folder_ / "log");
    runOrFail(std::string(CMAKE_PROGRAM) + " --build '" + into.string() + "'", *folder_ / "log");
  }
  static std::unique_ptr<TemporaryFolder> folder_;
};
std::unique_ptr<TemporaryFolder> OutOfTree::folder_;

TEST_F(OutOfTree, APluginBuiltAgainstTheInstalledSdkIsLoadedAndRuns) {
  const fs::path built = *folder_ / "build/lib/plugins";
  ASSERT_TRUE(fs::exists(built / "mean_echo/mean_echo.so")) << "named without a lib prefix, in a folder of its own";
  HeadlessHost host;
  PluginList plugins({built});
  ASSERT_EQ(plugins.states().size(), 1u);
  ASSERT_EQ(plugins.states()[0].state, PluginState::found) << plugins.states()[0].sentence();
  EXPECT_EQ(plugins.states()[0].manifest->version, "1.4.2");
  EXPECT_EQ(plugins.states()[0].manifest->abi, sdk::kAbi);
  EXPECT_EQ(plugins.states()[0].manifest->capabilities, std::vector<std::string>{"command:mean-echo"});
  EXPECT_TRUE(host.registered().empty()) << "listing loads no code";
  plugins.openAll(host);
  ASSERT_EQ(plugins.states()[0].state, PluginState::loaded) << plugins.states()[0].sentence();

  Volume volume;
  volume.grid.dims = {2, 2, 2};
  volume.echo = {0, 10, 20, 30, 40, 50, 60, 70};
  ASSERT_TRUE(writeVolume(volume, *folder_ / "v.mha"));
  const Command* command = host.find("mean-echo");
  ASSERT_NE(command, nullptr);
  const auto outcome = command->run({(*folder_ / "v.mha").string()}, noProgress());
  ASSERT_TRUE(outcome) << outcome.error();
  EXPECT_EQ(outcome->quality.front().second, 35.0);
  EXPECT_EQ(command->run({}, noProgress()).error().code, ErrorCode::badUsage);
}

TEST(GuidedSweep, WithoutAWindowItOpensAndItsSectionOfACaseIsChecked) {
  const fs::path built = EW_BINARY_DIR "/tests/guided_sweep/build/lib/plugins";
  ASSERT_TRUE(fs::exists(built / "guided_sweep/guided_sweep.so")) << "ctest builds it first, as the test GuidedSweepBuild";
  EXPECT_TRUE(fs::exists(built / "guided_sweep/guided_sweep_de.qm"));
  HeadlessHost host;
  PluginList plugins({built});
  plugins.openAll(host);
  ASSERT_EQ(plugins.states()[0].state, PluginState::loaded) << plugins.states()[0].sentence();
  EXPECT_NE(host.find("guided-sweep"), nullptr);
  const nlohmann::json wrong = {{"parts", {{"guided_sweep", {{"duration_s", 600}}}}}};
  const auto problems = host.partProblems(wrong);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_NE(problems[0].sentence().find("'parts.guided_sweep.duration_s' in case.json is 600; it must be a number from 1 to 60"),
            std::string::npos)
      << problems[0];

#ifdef EW_PROGRAM
  const TemporaryFolder folder;
  writeText(folder / "case/case.json",
            R"({"format": 1, "id": "a", "title": "A", "volume": {"recipe": "patient.json"}, "parts": )" + wrong["parts"].dump() + "}");
  const auto validate = [&](const std::string& searched) {
    static_cast<void>(std::system(("ECHOWEAVE_PLUGINS='" + searched + "' '" EW_PROGRAM "' case validate '" + (folder / "case").string() +
                                   "' > '" + (folder / "said").string() + "' 2>&1")
                                      .c_str()));
    return textOf(folder / "said");
  };
  EXPECT_NE(validate(built.string()).find("parts.guided_sweep.duration_s"), std::string::npos) << textOf(folder / "said");
  EXPECT_EQ(validate("").find("parts.guided_sweep"), std::string::npos) << "without the plugin nobody knows the section";
#endif
}

TEST_F(OutOfTree, TheStitchingPluginConfiguresAgainstTheInstalledSdkAlone) {
  const auto& f = *folder_;
  const std::string into = (f / "stitching-build").string();
  runOrFail(std::string(CMAKE_PROGRAM) + " -S '" EW_SOURCE_DIR "/plugins/stitching' -B '" + into +
                "' -G '" CMAKE_GENERATOR "' -DCMAKE_CXX_COMPILER='" CMAKE_CXX "' -DCMAKE_PREFIX_PATH='" + (f / "sdk").string() +
                "' -DEW_SANITIZE='" EW_SANITIZE_FLAGS "'",
            f / "log");
  EXPECT_TRUE(fs::exists(f / "sdk/include/ew/stitching/common_grid.h"));
}

TEST_F(OutOfTree, AWordThatIsNotKnownOrSaysNothingStopsTheConfigurationInsteadOfAPluginWithoutItsPanel) {
  const auto& f = *folder_;
  const std::string wholeText = textOf(EW_SOURCE_DIR "/tests/example_plugin/CMakeLists.txt");
  const std::string entry = "ENTRY mean_echo.cpp";
  ASSERT_NE(wholeText.find(entry), std::string::npos);
  for (const auto& [name, instead, said] : {std::tuple{"slip", "ENTRY mean_echo.cpp\n  PANELS panel.cpp", "PANELS"},
                                            std::tuple{"nothing", "PANEL\n  ENTRY mean_echo.cpp", "PANEL"}}) {
    std::string text = wholeText;
    text.replace(text.find(entry), entry.size(), instead);
    writeText(f / name / "CMakeLists.txt", text);
    fs::copy_file(EW_SOURCE_DIR "/tests/example_plugin/mean_echo.cpp", f / name / "mean_echo.cpp");
    const std::string configure = std::string(CMAKE_PROGRAM) + " -S '" + (f / name).string() + "' -B '" + (f / name).string() +
                                  "-build' -G '" CMAKE_GENERATOR "' -DCMAKE_CXX_COMPILER='" CMAKE_CXX "' -DCMAKE_PREFIX_PATH='" +
                                  (f / "sdk").string() + "' > '" + (f / "log").string() + "' 2>&1";
    EXPECT_NE(std::system(configure.c_str()), 0) << name;
    EXPECT_NE(textOf(f / "log").find(said), std::string::npos) << textOf(f / "log");
  }
}

TEST_F(OutOfTree, APluginBuiltAgainstAnOlderSdkIsRefusedByItsManifest) {
  HeadlessHost host;
  PluginList plugins({*folder_ / "older-build/lib/plugins"});
  plugins.openAll(host);
  ASSERT_EQ(plugins.states().size(), 1u);
  EXPECT_EQ(plugins.states()[0].state, PluginState::otherAbi);
  EXPECT_NE(plugins.states()[0].sentence().find(std::to_string(sdk::kAbi)), std::string::npos);
  EXPECT_NE(plugins.states()[0].sentence().find(std::to_string(kOlderAbi)), std::string::npos);
  EXPECT_EQ(host.find("mean-echo"), nullptr);
  RecordProperty("message", plugins.states()[0].sentence());
}

TEST_F(OutOfTree, AManifestThatLiesAboutItsAbiIsFoundOutBeforeAnythingElseIsCalled) {
  const fs::path liar = *folder_ / "liar";
  fs::create_directories(liar);
  fs::copy(*folder_ / "older-build/lib/plugins/mean_echo", liar / "mean_echo", fs::copy_options::recursive);
  std::string manifest = textOf(liar / "mean_echo/plugin.json");
  const std::string older = std::to_string(kOlderAbi);
  ASSERT_NE(manifest.find(older), std::string::npos);
  manifest.replace(manifest.find(older), older.size(), std::to_string(sdk::kAbi));
  writeText(liar / "mean_echo/plugin.json", manifest);
  HeadlessHost host;
  PluginList plugins({liar});
  EXPECT_EQ(plugins.states()[0].state, PluginState::found);
  plugins.openAll(host);
  EXPECT_EQ(plugins.states()[0].state, PluginState::otherAbi);
  EXPECT_EQ(host.find("mean-echo"), nullptr);
}

}  // namespace
}  // namespace ew::door::out_of_tree_test
