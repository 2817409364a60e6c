#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "cli/cli_world.h"
#include "ew/cli/run_command.h"
#include "ew/core/simd.h"
#include "ew/core/version.h"

namespace ew::test::usage_test {
namespace {

std::size_t lines(const std::string& text) { return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')); }

TEST(Usage, VersionAndHelpGoToTheOutputAndSucceed) {
  const auto version = run({"--version"});
  EXPECT_EQ(version.status, 0);
  EXPECT_EQ(version.out, std::string("echoweave ") + kVersion + "\n");
  const auto help = run({"--help"});
  EXPECT_EQ(help.status, 0);
  for (const char* command : {"import", "screen", "reconstruct", "register", "slice", "level", "surfaces", "scan", "phantom", "case",
                              "measure", "criteria", "preset", "send", "records", "tracker", "plugins", "bench"})
    EXPECT_NE(help.out.find(command), std::string::npos) << command;
  EXPECT_EQ(help.err, "");
}

TEST(Usage, EveryCommandExplainsItselfWithAnExampleAndTheSharedOptions) {
  const std::vector<std::vector<std::string>> commands{{"import"},
                                                       {"reconstruct"},
                                                       {"register"},
                                                       {"slice"},
                                                       {"surfaces"},
                                                       {"scan"},
                                                       {"phantom"},
                                                       {"case", "list"},
                                                       {"case", "show"},
                                                       {"case", "validate"},
                                                       {"case", "prepare"},
                                                       {"case", "export"},
                                                       {"case", "import"},
                                                       {"case", "publish"},
                                                       {"case", "verify"},
                                                       {"preset", "list"},
                                                       {"records", "add"},
                                                       {"records", "send"},
                                                       {"records", "list"},
                                                       {"records", "launch"},
                                                       {"records", "settings"},
                                                       {"preset", "check"},
                                                       {"measure"},
                                                       {"criteria"},
                                                       {"send"},
                                                       {"plugins", "list"},
                                                       {"lesson", "list"},
                                                       {"lesson", "show"},
                                                       {"lesson", "check"},
                                                       {"lesson", "record"},
                                                       {"lesson", "course"},
                                                       {"tracker", "print"},
                                                       {"tracker", "list"},
                                                       {"tracker", "check"},
                                                       {"assess"}};
  for (auto words : commands) {
    words.push_back("--help");
    const auto help = run(words);
    EXPECT_EQ(help.status, 0) << words.front();
    for (const char* part : {"--report", "--quiet", "Examples:", "echoweave "})
      EXPECT_NE(help.out.find(part), std::string::npos) << words.front() << part;
  }
}

TEST(Usage, WrongWordsAreOneSentenceAndStatusTwo) {
  const TemporaryFolder folder;
  const std::vector<std::vector<std::string>> wrong{{"slice"},
                                                    {"slice", "v.mha", "--pose", "x", "-o", "o.png", "--nonsense"},
                                                    {"slice", "v.mha", "--pose", "x", "-o", "o.png", "--size", "400"},
                                                    {"slice", "v.mha", "--pose", "x", "-o", "o.png", "--size", "0x4"},
                                                    {"slice", "v.mha", "--pose", "x", "-o", "o.png", "--size", "99999x4"},
                                                    {"slice", "v.mha", "--pose", "x", "-o", "o.png", "--pixel", "wide"},
                                                    {"slice", "v.mha", "--pose", "x", "-o", "o.png", "--pixel", "-1"},
                                                    {"slice", "v.mha", "--pose", "x", "-o", "o.png", "--pixel", "nan"},
                                                    {"slice", "v.mha", "--pose", "x", "-o", "o.png", "--quality", "best"},
                                                    {"slice", "v.mha", "--pose", "x", "-o", "o.png", "--repeat", "0"},
                                                    {"slice", "v.mha", "--pose", "x"},
                                                    {"slice", "v.mha", "--pose", "1 2 3", "-o", "o.png"},
                                                    {"phantom", "p.json"},
                                                    {"phantom", "p.json", "--volume", folder / "v.mha", "--seed", "-1"},
                                                    {"case"},
                                                    {"case", "shove"},
                                                    {"case", "prepare"},
                                                    {"no-such-command"},
                                                    {"reconstruct", "s.igs.mha"},
                                                    {"reconstruct", "s.igs.mha", "-o", folder / "v.png"},
                                                    {"reconstruct", "s.igs.mha", "-o", folder / "v.mha", "--interpolation", "cubic"},
                                                    {"reconstruct", "s.igs.mha", "-o", folder / "v.mha", "--clip", "1", "2", "3"},
                                                    {"tracker"},
                                                    {"tracker", "print"},
                                                    {"tracker", "print", "no-such-body", "-o", folder / "v.pdf"},
                                                    {"tracker", "print", "-o", folder / "v.pdf", "--paper", "a3"},
                                                    {"tracker", "print", "--measured-scale", "80"},
                                                    {"plugins", "list", "--simd", "mmx"}};
  for (const auto& words : wrong) {
    const auto outcome = run(words);
    std::string line;
    for (const auto& word : words) line += word + " ";
    EXPECT_EQ(outcome.status, cli::kWrongUsage) << line << outcome.err;
    EXPECT_EQ(outcome.out, "") << line;
    EXPECT_EQ(outcome.err.rfind("echoweave: ", 0), 0u) << line << outcome.err;
    EXPECT_EQ(lines(outcome.err), 1u) << line << outcome.err;
    EXPECT_EQ(outcome.err.substr(outcome.err.size() - 2), ".\n") << outcome.err;
  }
  EXPECT_TRUE(folder.names().empty());
}

TEST(Usage, TheBenchesAreAProgramOfTheirOwnWhoseWordsAreKnown) {
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"bench"}, {"bench", "slicing"}, {"help", "bench"}, {"-h", "bench", "all"}})
    EXPECT_TRUE(cli::isBench(words)) << words.front();
  for (const std::vector<std::string>& words : {std::vector<std::string>{}, {"--help"}, {"case", "bench"}, {"--version", "bench"}})
    EXPECT_FALSE(cli::isBench(words)) << (words.empty() ? "" : words.front());
  const auto alone = run({"bench", "slicing", "--side", "256"});
  EXPECT_EQ(alone.status, cli::kFailed) << "without its program";
  EXPECT_NE(alone.err.find("echoweave-bench"), std::string::npos) << alone.err;
}

TEST(Usage, WhatWasNotExpectedIsNamedInTheOrderItWasGiven) {
  const auto outcome = run({"plugins", "list", "first", "--second", "third"});
  EXPECT_EQ(outcome.status, cli::kWrongUsage);
  EXPECT_EQ(outcome.err, "echoweave: Not expected: 'first', '--second', 'third'; 'echoweave plugins list --help' shows how.\n");
}

TEST(Usage, TheInstructionSetHoldsForOneCommandAndStandsInItsReport) {
  const TemporaryFolder folder;
  const auto simdOf = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {"plugins", "list", "--report", folder / "r.json"});
    EXPECT_EQ(run(words).status, 0);
    return nlohmann::json::parse(std::ifstream(folder / "r.json"))["simd"].get<std::string>();
  };
  const std::string best = bestSimd();
  EXPECT_EQ(simdOf({"--simd", "scalar"}), "scalar");
  EXPECT_EQ(simdOf({}), best);
  const EnvironmentValue asked("ECHOWEAVE_SIMD", "scalar");
  EXPECT_EQ(simdOf({}), "scalar");
  EXPECT_EQ(simdOf({"--simd", "best"}), best);
  const EnvironmentValue wrong("ECHOWEAVE_SIMD", "mmx");
  const auto refused = run({"plugins", "list"});
  EXPECT_EQ(refused.status, cli::kWrongUsage);
  EXPECT_NE(refused.err.find("ECHOWEAVE_SIMD"), std::string::npos) << refused.err;
}

TEST(Usage, VerboseAddsTheParticularsOfAnErrorOnASecondLine) {
  const std::vector<std::string> words{"slice", "no-such.mha", "--pose", kIdentityPose, "--repeat", "1"};
  auto more = words;
  more.push_back("--verbose");
  const auto brief = run(words), verbose = run(more);
  EXPECT_EQ(brief.status, 1);
  EXPECT_EQ(lines(brief.err), 1u) << brief.err;
  EXPECT_EQ(lines(verbose.err), 2u) << verbose.err;
  EXPECT_NE(verbose.err.find("no-such.mha", verbose.err.find('\n')), std::string::npos) << verbose.err;
}

TEST(Usage, OnlyCommandsAndQuestionsAreHeadless) {
  using Words = std::vector<std::string>;
  for (const Words& words : {Words{"slice"}, Words{"case", "list"}, Words{"--help"}, Words{"--version"}})
    EXPECT_TRUE(cli::isHeadless(words)) << words.front();
  for (const Words& words : {Words{}, Words{"case.json"}, Words{"--screenshot", "a.png"}, Words{"sweep.igs.mha"}, Words{"./slice"}})
    EXPECT_FALSE(cli::isHeadless(words));
}

}  // namespace
}  // namespace ew::test::usage_test
