#include <gtest/gtest.h>

#include "ew/library/case.h"
#include "ew/library/new_case.h"
#include "least_case.h"
#include "library/temporary_folder.h"

namespace ew::case_places_test {
namespace {

using nlohmann::json;
using test::context;
using test::EnvironmentValue;
using test::makeCase;
using test::smallest;
using test::TemporaryFolder;
using test::writeText;

TEST(ListCases, SortsByTitleAndReportsTheOnesItCannotRead) {
  const TemporaryFolder folder;
  for (const auto& [name, title] : {std::pair{"x", "Beta"}, std::pair{"y", "Alpha"}}) {
    json manifest = smallest();
    manifest["title"] = title;
    makeCase(folder / name, manifest);
  }
  writeText(folder / "broken/case.json", "{");
  writeText(folder / "notes/readme.txt", "not a case");
  makeCase(folder / ".half-made", smallest());
  const CaseList list = listCases(folder.path());
  ASSERT_EQ(list.cases.size(), 2u);
  EXPECT_EQ(list.cases[0].title, "Alpha");
  ASSERT_EQ(list.problems.size(), 1u);
  EXPECT_NE(context(list.problems[0], "case").find("broken"), std::string::npos);
  EXPECT_NE(list.problems[0].sentence().find("'broken'"), std::string::npos) << "which one is left out";
  EXPECT_EQ(list.noCases, (std::vector<std::filesystem::path>{folder / "notes"}));
  EXPECT_EQ(listCases(folder / "nowhere").problems.size(), 1u);
}

TEST(IdForFolder, IsMadeOfTheNameAndOfNoCaseBesideIt) {
  const TemporaryFolder folder;
  EXPECT_EQ(idForFolder(folder / "Upper Abdomen, my copy"), "upper-abdomen-my-copy");
  EXPECT_EQ(idForFolder(folder / "Leber – Übung"), "leber-bung");
  EXPECT_EQ(idForFolder(folder / "7"), "7");
  EXPECT_EQ(idForFolder(folder / "…"), "case");
  EXPECT_EQ(idForFolder(folder / "knee/"), "knee");
  EXPECT_LE(idForFolder(folder / std::string(240, 'x')).size(), 100u);
  json other = smallest();
  other["id"] = "knee";
  makeCase(folder / "another", other);
  EXPECT_EQ(idForFolder(folder / "knee"), "knee-2");
  makeCase(folder / "knee", other);
  EXPECT_EQ(idForFolder(folder / "another"), "another");
  for (const char* name : {"Upper Abdomen, my copy", "Leber – Übung", "…"}) {
    json manifest = smallest();
    manifest["id"] = idForFolder(folder / name);
    EXPECT_TRUE(caseFromManifest(manifest, {})) << name;
  }
}

TEST(ShippedCases, AreKnownByTheirPlaceAlsoThroughALink) {
  const auto shipped = shippedCasesFolder();
  ASSERT_TRUE(shipped);
  const TemporaryFolder folder;
  EXPECT_TRUE(isShipped(*shipped / "any case"));
  EXPECT_TRUE(isShipped(*shipped));
  EXPECT_FALSE(isShipped(*shipped / ".." / "elsewhere"));
  EXPECT_FALSE(isShipped(folder.path()));
  std::filesystem::create_directory_symlink(*shipped, folder / "link");
  EXPECT_TRUE(isShipped(folder / "link/any case"));
}

TEST(OwnCases, LieWhereTheEnvironmentOrTheHomeSays) {
  {
    const EnvironmentValue chosen("ECHOWEAVE_CASES", "/somewhere/mine");
    EXPECT_EQ(ownCasesFolder(), "/somewhere/mine");
  }
  const EnvironmentValue none("ECHOWEAVE_CASES", ""), home("HOME", "/home/somebody");
  EXPECT_EQ(ownCasesFolder(), "/home/somebody/EchoWeave/cases");
}

TEST(Folders, FollowTheEnvironmentAndSayWhenItIsWrong) {
  const TemporaryFolder folder;
  {
    const EnvironmentValue chosen("ECHOWEAVE_RESOURCES", folder.path().string());
    EXPECT_EQ(resourceFolder().value(), folder.path());
  }
  {
    const EnvironmentValue wrong("ECHOWEAVE_RESOURCES", folder / "nowhere");
    const auto refused = resourceFolder();
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().sentence().find("ECHOWEAVE_RESOURCES"), std::string::npos);
  }
  EXPECT_TRUE(resourceFolder()) << "the source tree's own";
  const EnvironmentValue cache("ECHOWEAVE_CACHE", "");
  const EnvironmentValue xdg("XDG_CACHE_HOME", "/some/where");
  EXPECT_EQ(cacheFolder(), "/some/where/echoweave");
}

TEST(ShippedCases, AreValid) {
  const auto folder = shippedCasesFolder();
  ASSERT_TRUE(folder);
  const CaseList list = listCases(*folder);
  for (const auto& problem : list.problems) ADD_FAILURE() << problem;
  EXPECT_FALSE(list.cases.empty());
}

}  // namespace
}  // namespace ew::case_places_test
