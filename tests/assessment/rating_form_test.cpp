#include "ew/assessment/rating_form.h"

#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "assessment/made_ratings.h"
#include "library/temporary_folder.h"
#include "places.h"

namespace ew::rating_form_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::smallForm;
using test::TemporaryFolder;
using test::writeText;

const fs::path kResources = fs::path(EW_SOURCE_DIR) / "resources";

Result<RatingForm> read(const json& document) { return ratingFormFromJson(document, verbatim("form.json")); }

TEST(RatingForm, IsReadAsItWasWritten) {
  const RatingForm form = smallForm();
  const auto again = read(json::parse(jsonOf(form).dump()));
  ASSERT_TRUE(again) << again.error();
  EXPECT_EQ(*again, form);
}

TEST(RatingForm, HasAUsualWeightAndNoPassLevelWhereAFileSaysNothing) {
  json document = jsonOf(smallForm());
  document.erase("pass_levels");
  document["items"][1].erase("weight");
  document["items"][2].erase("not_applicable");
  const auto form = read(document);
  ASSERT_TRUE(form) << form.error();
  EXPECT_EQ(form->items[1].weight, 1.0);
  EXPECT_FALSE(form->items[2].mayBeNotApplicable);
  EXPECT_TRUE(form->passLevels.empty());
  EXPECT_EQ(form->passLevelOf(""), nullptr);
}

/// A place in the form, what is put there, and the field that the sentence has to name.
struct Wrong {
  const char* at;
  json value;  ///< discarded: the field is taken away
  const char* field;
};

TEST(RatingForm, RefusesEveryWrongFieldByItsName) {
  const json none(json::value_t::discarded);
  const json words = {{"en", "x"}, {"de", "y"}};
  const std::vector<Wrong> wrongs = {
      {"/format", none, "format"},
      {"/format", 0, "format"},
      {"/id", none, "id"},
      {"/id", "Capital", "id"},
      {"/id", "../up", "id"},
      {"/id", "-first", "id"},
      {"/id", std::string(61, 'a'), "id"},
      {"/version", 0, "version"},
      {"/version", 1.5, "version"},
      {"/title", "text", "title"},
      {"/title/de", none, "title.de"},
      {"/title/fr", "titre", "title.fr"},
      {"/source", "", "source"},
      {"/validity", none, "validity.en"},
      {"/scale", none, "scale"},
      {"/scale/lowest", "1", "scale.lowest"},
      {"/scale/highest", 1, "scale.highest"},
      {"/scale/steps", 5, "scale.steps"},
      {"/items", none, "items"},
      {"/items", json::array(), "items"},
      {"/items/1/id", "image", "items[1].id"},
      {"/items/1/title/en", "", "items[1].title.en"},
      {"/items/0/description", none, "items[0].description.en"},
      {"/items/0/anchors", none, "items[0].anchors"},
      {"/items/0/anchors/0/score", 2, "items[0].anchors"},
      {"/items/0/anchors/2/score", 4, "items[0].anchors"},
      {"/items/0/anchors/2/score", 6, "items[0].anchors[2].score"},
      {"/items/0/anchors/1/score", 1, "items[0].anchors[1].score"},
      {"/items/0/anchors/1/text/en", none, "items[0].anchors[1].text.en"},
      {"/items/0/weight", 0, "items[0].weight"},
      {"/items/0/weight", -1, "items[0].weight"},
      {"/items/0/not_applicable", "yes", "items[0].not_applicable"},
      {"/items/0/wieght", 2, "items[0].wieght"},
      {"/pass_levels/0/id", none, "pass_levels[0].id"},
      {"/pass_levels/0/title", none, "pass_levels[0].title.en"},
      {"/pass_levels/0/total", 5.5, "pass_levels[0].total"},
      {"/pass_levels/0/source", none, "pass_levels[0].source"},
      {"/pass_levels/1", {{"id", "usual"}, {"title", words}, {"total", 2}, {"source", "x"}}, "pass_levels[1].id"},
      {"/passlevels", json::array(), "passlevels"},
  };
  for (const Wrong& wrong : wrongs) {
    json document = jsonOf(smallForm());
    const json::json_pointer at(wrong.at);
    if (wrong.value.is_discarded())
      document[at.parent_pointer()].erase(at.back());
    else
      document[at] = wrong.value;
    const auto form = read(document);
    ASSERT_FALSE(form) << wrong.at;
    EXPECT_EQ(form.error().code, ErrorCode::badField) << wrong.at;
    EXPECT_TRUE(form.error().sentence().starts_with("'" + std::string(wrong.field) + "' in form.json is ")) << form.error();
  }
}

TEST(RatingForm, OfANewerProgramIsRefusedAsThat) {
  json document = jsonOf(smallForm());
  document["format"] = kRatingFormFormat + 1;
  document["something"] = "else";
  EXPECT_EQ(read(document).error().code, ErrorCode::newerFormat);
}

TEST(RatingForm, HasTheSameContentHoweverItsFileIsLaidOutAndAnotherWhenAWordChanges) {
  const RatingForm form = smallForm();
  json document = jsonOf(form);
  document["note"] = "for whoever edits it";
  EXPECT_EQ(contentOf(*read(json::parse(document.dump(8)))), contentOf(form));
  RatingForm other = form;
  other.items[2].anchors[1].text.german += "!";
  EXPECT_NE(contentOf(other), contentOf(form));
  other = form;
  other.items[0].weight = 1.0000001;
  EXPECT_NE(contentOf(other), contentOf(form));
}

TEST(RatingForm, HasAPassLevelByItsIdOrTheOnlyOne) {
  RatingForm form = smallForm();
  EXPECT_EQ(form.passLevelOf(""), &form.passLevels[0]);
  EXPECT_EQ(form.passLevelOf("usual"), &form.passLevels[0]);
  EXPECT_EQ(form.passLevelOf("other"), nullptr);
  form.passLevels.push_back({"other", {"x", "y"}, 2.0, "x"});
  EXPECT_EQ(form.passLevelOf(""), nullptr) << "which of both nobody has said";
  EXPECT_EQ(form.passLevelOf("other"), &form.passLevels[1]);
}

TEST(ShippedRatingForms, AreTheSevenElementsAndAGlobalRating) {
  const TemporaryFolder library;
  const RatingFormList list = listRatingForms(kResources, library.path());
  EXPECT_TRUE(list.problems.empty()) << list.problems.front();
  ASSERT_EQ(list.forms.size(), 2u);
  const RatingForm* osaus = list.find("osaus-like");
  ASSERT_NE(osaus, nullptr);
  std::vector<std::string> ids;
  for (const RatingItem& item : osaus->items) ids.push_back(item.id);
  EXPECT_EQ(ids, (std::vector<std::string>{"indication", "equipment", "optimisation", "systematic", "interpretation", "documentation",
                                           "decision"}));
  EXPECT_EQ(osaus->passLevelOf("transabdominal-biometry")->total, 3.0);
  EXPECT_EQ(osaus->passLevelOf("systematic-transvaginal")->total, 2.5);
  EXPECT_EQ(osaus->passLevelOf(""), nullptr) << "no level is known of other examinations";
  ASSERT_NE(list.find("global-rating"), nullptr);
  for (const RatingForm& form : list.forms) {
    EXPECT_EQ(form.lowest, 1);
    EXPECT_EQ(form.highest, 5);
  }
}

TEST(RatingForm, IsWhatTheManualShowsAsOne) {
  const std::string manual = test::textOf(kResources / "docs" / "developer" / "formats.md");
  const std::string fence = "```json\n";
  const auto begin = manual.find(fence, manual.find("## Rating forms")) + fence.size();
  const auto form = read(json::parse(manual.substr(begin, manual.find("```", begin) - begin)));
  ASSERT_TRUE(form) << form.error();
  EXPECT_EQ(form->id, "our-first-form");
}

class FormSchema : public ::testing::Test {
 protected:
  void SetUp() override {
    const json text = json::parse(std::ifstream(kResources / "schemas" / "rating-form.schema.json"));
    valijson::SchemaParser(valijson::SchemaParser::kDraft7).populateSchema(valijson::adapters::NlohmannJsonAdapter(text), schema_);
  }
  bool accepts(const json& document) {
    valijson::Validator validator;
    return validator.validate(schema_, valijson::adapters::NlohmannJsonAdapter(document), nullptr);
  }
  valijson::Schema schema_;
};

TEST_F(FormSchema, AgreesWithTheReader) {
  for (const char* name : {"osaus-like.json", "global-rating.json"}) {
    const json whole = json::parse(std::ifstream(kResources / "rating_forms" / name));
    EXPECT_TRUE(accepts(whole)) << name;
    EXPECT_TRUE(read(whole)) << name;
    const std::function<void(const json&, const json::json_pointer&)> visit = [&](const json& part, const json::json_pointer& at) {
      if (part.is_object()) {
        for (const auto& field : part.items()) {
          json less = whole;
          less[at].erase(field.key());
          EXPECT_EQ(accepts(less), read(less).has_value()) << name << ": " << at / field.key();
        }
        json more = whole;
        more[at]["surprise"] = 1;
        EXPECT_FALSE(accepts(more)) << name << ": " << at;
        EXPECT_FALSE(read(more)) << name << ": " << at;
      }
      // Of each list the first entry says it.
      if (part.is_object())
        for (const auto& inner : part.items()) visit(inner.value(), at / inner.key());
      else if (part.is_array() && !part.empty())
        visit(part.front(), at / 0);
    };
    visit(whole, json::json_pointer());
  }
}

TEST(RatingFormList, HasASchoolsOwnFormsBesideTheShippedOnes) {
  const TemporaryFolder library;
  RatingForm own = smallForm();
  writeText(ratingFormFolder(library.path()) / "own-1.json", jsonOf(own).dump());
  own.version = 10;
  own.title.english = "Small form, revised";
  writeText(ratingFormFolder(library.path()) / "own-2.json", jsonOf(own).dump());
  const RatingFormList list = listRatingForms(kResources, library.path());
  EXPECT_TRUE(list.problems.empty());
  ASSERT_EQ(list.forms.size(), 4u);
  EXPECT_EQ(list.find("small")->version, 10);
  ASSERT_NE(list.find("small", 2), nullptr);
  EXPECT_EQ(*list.find("small", 2), smallForm());
  EXPECT_EQ(list.find("small", 3), nullptr);
  EXPECT_EQ(list.forms[2].version, 10) << "of each form the highest version first";
}

TEST(RatingFormList, SaysWhichFileIsLeftOutAndWhyAndKeepsTheRest) {
  const TemporaryFolder library;
  const fs::path folder = ratingFormFolder(library.path());
  RatingForm taken = smallForm();
  taken.id = "global-rating";
  taken.version = 1;
  writeText(folder / "a-taken.json", jsonOf(taken).dump());
  writeText(folder / "b-broken.json", "{");
  json wrong = jsonOf(smallForm());
  wrong["items"][0]["weight"] = "heavy";
  writeText(folder / "c-wrong.json", wrong.dump());
  writeText(folder / "d-good.json", jsonOf(smallForm()).dump());
  writeText(folder / "notes.txt", "no form");
  const RatingFormList list = listRatingForms(kResources, library.path());
  EXPECT_EQ(list.forms.size(), 3u);
  EXPECT_EQ(list.find("global-rating")->items.size(), 5u) << "the shipped one stays";
  ASSERT_EQ(list.problems.size(), 3u);
  EXPECT_NE(list.problems[0].sentence().find("'a-taken.json' is left out: there is a form 'global-rating' of version 1"), std::string::npos)
      << list.problems[0];
  EXPECT_NE(list.problems[1].sentence().find("b-broken.json"), std::string::npos);
  EXPECT_EQ(list.problems[1].code, ErrorCode::badHeader);
  EXPECT_NE(list.problems[2].sentence().find("'items[0].weight'"), std::string::npos) << list.problems[2];
}

}  // namespace
}  // namespace ew::rating_form_test
