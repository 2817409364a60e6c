#include <gtest/gtest.h>

#include <set>

#include "bench/volumes/bench_register.h"
#include "bench/volumes/bench_register_peers.h"
#include "cli/bench_run.h"

namespace ew::test::bench_register_test {
namespace {

class BenchRegister : public BenchRun<BenchRegister> {
 public:
  static std::vector<std::string> command() { return {"bench", "register", "--side", "48", "--no-peers"}; }

 protected:
  static double error_mm(const std::string& method, const std::string& setting) {
    return row({{"method", method}, {"setting", setting}})["error_mm"].get<double>();
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
  EXPECT_LT(error_mm("elastic2d", "chosen by size"), 0.5 * error_mm("elastic2d", "one level"));
}

TEST_F(BenchRegister, RobustLandmarksBeatTheClosedFormWhenOneInFiveIsWrong) {
  for (const char* count : {"7", "10", "25"})
    EXPECT_LT(error_mm("landmarks", std::string(count) + " pairs, robust"),
              0.6 * error_mm("landmarks", std::string(count) + " pairs, closed form alone"));
  EXPECT_LT(error_mm("landmarks", "25 pairs, robust"), error_mm("landmarks", "5 pairs, robust"));
}

TEST_F(BenchRegister, ThePageStandsOnItsOwn) {
  expectOnItsOwn(page());
  EXPECT_NE(page().find("error removed"), std::string::npos);
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
  EXPECT_EQ(runBench({"bench", "register", "--side", "20"}).status, 2);
  EXPECT_EQ(runBench({"bench", "register", "--repetitions", "0"}).status, 2);
}

}  // namespace
}  // namespace ew::test::bench_register_test
