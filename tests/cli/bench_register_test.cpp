#include <gtest/gtest.h>

#include <set>

#include "bench_register.h"
#include "bench_register_peers.h"
#include "cli/cli_world.h"

namespace ew::test {
namespace {

class BenchRegister : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    const auto outcome =
        run({"bench", "register", "--side", "48", "--no-peers", "--html", folder() / "page", "--report", folder() / "r.json"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    quality() = readJson(folder() / "r.json")["quality"];
    said() = outcome.out;
  }
  static TemporaryFolder& folder() {
    static TemporaryFolder made;
    return made;
  }
  static nlohmann::json& quality() {
    static nlohmann::json kept;
    return kept;
  }
  static std::string& said() {
    static std::string kept;
    return kept;
  }
  static nlohmann::json row(const std::string& method, const std::string& setting) {
    for (const auto& each : quality()["results"])
      if (each["method"] == method && each["setting"] == setting) return each;
    ADD_FAILURE() << "no row " << method << ", " << setting;
    return {};
  }
};

TEST_F(BenchRegister, EveryRowHasATimeAnErrorBeforeAndAnErrorAfter) {
  std::set<std::string> methods;
  for (const auto& each : quality()["results"]) {
    methods.insert(each["method"].get<std::string>());
    EXPECT_GT(each["median_us"].get<double>(), 0.0) << each;
    EXPECT_GT(each["error_start_mm"].get<double>(), 0.5) << each;
    EXPECT_TRUE(each["error_mm"].is_number()) << each;
  }
  EXPECT_TRUE(methods.contains("elastic2d"));
  EXPECT_TRUE(methods.contains("landmarks"));
  EXPECT_NE(said().find("register_elastic2d/pictures/one level"), std::string::npos) << said();
}

TEST_F(BenchRegister, SeveralLevelsConvergeWhereOneDoesNot) {
  EXPECT_LT(row("elastic2d", "chosen by size")["error_mm"].get<double>(), 0.5 * row("elastic2d", "one level")["error_mm"].get<double>());
}

TEST_F(BenchRegister, RobustLandmarksBeatTheClosedFormWhenOneInFiveIsWrong) {
  for (const char* count : {"7", "10", "25"})
    EXPECT_LT(row("landmarks", std::string(count) + " pairs, robust")["error_mm"].get<double>(),
              0.6 * row("landmarks", std::string(count) + " pairs, closed form alone")["error_mm"].get<double>());
  EXPECT_LT(row("landmarks", "25 pairs, robust")["error_mm"].get<double>(), row("landmarks", "5 pairs, robust")["error_mm"].get<double>());
}

TEST_F(BenchRegister, ThePageStandsOnItsOwn) {
  const std::string page = readText(folder() / "page/accuracy-and-time.html");
  EXPECT_NE(page.find("<svg"), std::string::npos);
  EXPECT_NE(page.find("error removed"), std::string::npos);
  for (const char* outside : {"http:", "https:", "<script", "src=", "@import"}) EXPECT_EQ(page.find(outside), std::string::npos) << outside;
}

TEST(BenchRegisterPeers, AProgramThatIsNotThereIsKnownToBeMissing) {
  EXPECT_FALSE(isInstalled("no-such-program-anywhere"));
  EXPECT_TRUE(isInstalled("sh"));
  const TemporaryFolder folder;
  const EnvironmentValue nowhere("PATH", folder / "empty");
  for (const auto& peer : registerPeers()) {
    EXPECT_FALSE(isInstalled(peer.program));
    const auto run = runPeer(peer, folder / "f.mha", folder / "m.mha", folder.path(), noProgress());
    ASSERT_FALSE(run);
    EXPECT_EQ(run.error().code, ErrorCode::notFound) << run.error();
  }
}

TEST(BenchRegisterOptions, AreRefusedOutsideTheirRange) {
  EXPECT_EQ(run({"bench", "register", "--side", "20"}).status, 2);
  EXPECT_EQ(run({"bench", "register", "--repetitions", "0"}).status, 2);
}

}  // namespace
}  // namespace ew::test
