#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "cli/cli_world.h"
#include "ew/cli/run_bench.h"

namespace ew::test {

/// Runs a bench in this process, as its program does.
inline Outcome runBench(const std::vector<std::string>& args) {
  std::ostringstream out, err;
  Outcome outcome;
  outcome.status = cli::runBench(args, {out, err});
  outcome.out = out.str();
  outcome.err = err.str();
  return outcome;
}

/// Tests that look at one run of `echoweave bench`, with a page and a report. `Suite` has `static std::vector<std::string> command()`.
template <class Suite>
class BenchRun : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    auto args = Suite::command();
    args.insert(args.end(), {"--html", folder() / "page", "--report", folder() / "r.json"});
    const auto outcome = runBench(args);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    quality() = readJson(folder() / "r.json")["quality"];
    said() = outcome.out;
  }
  static nlohmann::json& quality() {
    static nlohmann::json kept;
    return kept;
  }
  static std::string& said() {
    static std::string kept;
    return kept;
  }
  static std::string page() { return readText(folder() / "page/accuracy-and-time.html"); }
  /// The result in which every one of these fields has this value.
  static nlohmann::json row(const std::vector<std::pair<std::string, std::string>>& fields) {
    for (const auto& each : quality()["results"])
      if (std::all_of(fields.begin(), fields.end(), [&](const auto& field) { return each[field.first] == field.second; })) return each;
    ADD_FAILURE() << "no row with " << fields.back().first << " " << fields.back().second;
    return {};
  }
  /// A page needs nothing from elsewhere.
  static void expectOnItsOwn(const std::string& page) {
    EXPECT_NE(page.find("<svg"), std::string::npos);
    for (const char* outside : {"http:", "https:", "<script", "src=", "@import"})
      EXPECT_EQ(page.find(outside), std::string::npos) << outside;
  }

 private:
  static TemporaryFolder& folder() {
    static TemporaryFolder made;
    return made;
  }
};

}  // namespace ew::test
