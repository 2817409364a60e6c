#include "ew/annotation/word_list.h"
#include "places.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

namespace ew::annotation::word_list_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const fs::path kFolder = fs::path(EW_SOURCE_DIR) / "resources" / "annotations";

std::vector<WordList> shipped() {
  auto lists = readWordLists(kFolder);
  EXPECT_TRUE(lists) << lists.error();
  return lists ? std::move(*lists) : std::vector<WordList>{};
}

bool has(const std::vector<std::string>& terms, const std::string& term) {
  return std::find(terms.begin(), terms.end(), term) != terms.end();
}

TEST(WordLists, OfTheProgramAreAllReadAndServeEveryRegionOfTheCases) {
  const auto lists = shipped();
  std::vector<std::string> ids;
  for (const WordList& list : lists) ids.push_back(list.id);
  EXPECT_EQ(ids, (std::vector<std::string>{"abdomen", "common", "neck", "obstetrics", "trauma", "vessels"}));
  for (const auto& entry : fs::directory_iterator(fs::path(EW_SOURCE_DIR) / "cases")) {
    if (!entry.is_directory()) continue;  // the course over all of them
    std::ifstream file(entry.path() / "case.json");
    const std::string region = json::parse(file)["region"];
    EXPECT_NE(wordListOf(lists, region), nullptr) << region;
  }
}

TEST(WordLists, OfferTheTermsOfAConsoleInBothLanguages) {
  const auto lists = shipped();
  for (const char* region : {"abdomen", "upper abdomen", "pregnant womb", "neck", "vessels", "trauma"}) {
    const auto english = termsFor(lists, region, "en"), german = termsFor(lists, region, "de_DE");
    for (const char* term : {"RT", "LT", "TRANS", "SAG", "LONG", "MIDLINE"}) EXPECT_TRUE(has(english, term)) << region << ": " << term;
    for (const char* term : {"RE", "LI", "QUER", "SAGITTAL", "LÄNGS"}) EXPECT_TRUE(has(german, term)) << region << ": " << term;
    EXPECT_EQ(std::set<std::string>(english.begin(), english.end()).size(), english.size()) << region;
    EXPECT_GT(english.size(), 50u) << region;
  }
  EXPECT_TRUE(has(termsFor(lists, "upper abdomen", "en"), "PORTAL VEIN"));
  EXPECT_FALSE(has(termsFor(lists, "upper abdomen", "en"), "THALAMI"));
  EXPECT_TRUE(has(termsFor(lists, "pregnant womb", "de"), "KLEINHIRN"));
  EXPECT_TRUE(has(termsFor(lists, "neck", "en"), "ISTHMUS"));
  EXPECT_TRUE(has(termsFor(lists, "trauma", "de"), "MORISON"));
  EXPECT_EQ(termsFor(lists, "upper abdomen", "en").front(), "LIVER") << "the region's own words come first";
  // Of a region nobody has written words for: all there are.
  EXPECT_TRUE(has(termsFor(lists, "knee", "en"), "THALAMI"));
  EXPECT_TRUE(has(termsFor(lists, "knee", "en"), "LIVER"));
}

TEST(Completions, ContinueTheLastWordsThatBeginATerm) {
  const std::vector<std::string> terms{"LIVER", "RT LOBE", "RT KIDNEY", "KIDNEY", "RT", "ÖSOPHAGUS"};
  using Texts = std::vector<std::string>;
  EXPECT_EQ(completionsOf("KID", terms), (Texts{"KIDNEY"}));
  EXPECT_EQ(completionsOf("rt kid", terms), (Texts{"RT KIDNEY", "rt KIDNEY"}));
  EXPECT_EQ(completionsOf("LONG KID", terms), (Texts{"LONG KIDNEY"}));
  EXPECT_EQ(completionsOf("R", terms), (Texts{"RT LOBE", "RT KIDNEY", "RT"}));
  EXPECT_EQ(completionsOf("ös", terms), (Texts{"ÖSOPHAGUS"}));
  EXPECT_EQ(completionsOf("R", terms, 2), (Texts{"RT LOBE", "RT KIDNEY"}));
  EXPECT_EQ(completionsOf("KIDNEY", terms), Texts{}) << "it says the term already";
  EXPECT_EQ(completionsOf("RT ", terms), Texts{});
  EXPECT_EQ(completionsOf("", terms), Texts{});
  EXPECT_EQ(completionsOf("IDNEY", terms), Texts{}) << "from the beginning of a word on";
}

json small() {
  return json::parse(R"({"format": 1, "title": {"en": "Knee", "de": "Knie"}, "regions": ["knee"], "source": "made for this test",
    "groups": [{"title": {"en": "Joint", "de": "Gelenk"}, "terms": [{"en": "MENISCUS", "de": "MENISKUS"},
      {"en": "ACL", "de": "VKB", "means": {"en": "anterior cruciate ligament", "de": "vorderes Kreuzband"}}]}]})");
}

TEST(WordListReader, TakesWhatASmallListSays) {
  const auto list = wordListFromJson(small(), "knee", verbatim("knee.json"));
  ASSERT_TRUE(list) << list.error();
  EXPECT_EQ(list->id, "knee");
  EXPECT_EQ(list->title.in("de"), "Knie");
  ASSERT_EQ(list->groups.size(), 1u);
  EXPECT_EQ(list->groups[0].terms[1].text.english, "ACL");
  EXPECT_EQ(list->groups[0].terms[1].meaning.german, "vorderes Kreuzband");
  EXPECT_TRUE(list->groups[0].terms[0].meaning.english.empty());
}

TEST(WordListReader, SaysWhatIsWrong) {
  const auto sentence = [](const json::json_pointer& at, const json& value) {
    json changed = small();
    changed[at] = value;
    const auto read = wordListFromJson(changed, "knee", verbatim("knee.json"));
    return read ? std::string("taken") : read.error().sentence();
  };
  EXPECT_EQ(sentence("/format"_json_pointer, 3), "knee.json has format 3, this program reads up to 1; update EchoWeave.");
  EXPECT_EQ(
      sentence("/groups/0/terms/1/en"_json_pointer, "Meniscus"),
      "'groups[0].terms[1].en' in knee.json is \"Meniscus\"; it must be one line of 1 to 40 bytes that no other term of the list says.");
  EXPECT_EQ(
      sentence("/groups/0/terms/0/de"_json_pointer, " MENISKUS"),
      "'groups[0].terms[0].de' in knee.json is \" MENISKUS\"; it must be one line of 1 to 40 bytes that no other term of the list says.");
  EXPECT_NE(sentence("/groups/0/terms/0/fr"_json_pointer, "MÉNISQUE").find("fr"), std::string::npos);
  EXPECT_NE(sentence("/title/de"_json_pointer, 7).find("'title.de' in knee.json is 7"), std::string::npos);
  EXPECT_NE(sentence("/groups"_json_pointer, json::array()).find("'groups' in knee.json"), std::string::npos);
}

TEST(WordListReader, NamesTheFolderThatIsNotThere) {
  const auto lists = readWordLists(kFolder / "nowhere");
  ASSERT_FALSE(lists);
  EXPECT_EQ(lists.error().code, ErrorCode::notFound);
  EXPECT_NE(lists.error().sentence().find("with the word lists"), std::string::npos);
}

}  // namespace
}  // namespace ew::annotation::word_list_test
