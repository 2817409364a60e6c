#include "ew/assessment/rating.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "assessment/made_ratings.h"

namespace ew::rating_test {
namespace {

using nlohmann::json;
using test::kRatedAt;
using test::ratingOf;
using test::smallForm;

Rating wholeRating() {
  Rating rating = ratingOf(smallForm(), "Dr. Ö. Müller", {4, 2, 0});
  rating.passLevel = "usual";
  rating.items[1].remark = "Found the kidney \"twice\"\nand lost it";
  rating.remark = "Good hands.";
  rating.sawName = true;
  rating.attemptId = "20261126-093000-4f2a91c7";
  rating.formId = "small";
  rating.formVersion = 2;
  rating.formContent = contentOf(smallForm());
  rating.revision = 3;
  return rating;
}

Result<Rating> read(const json& document) { return ratingFromJson(document, verbatim("rating.json")); }

TEST(Rating, IsReadAsItWasWritten) {
  const Rating rating = wholeRating();
  const auto again = read(json::parse(jsonOf(rating).dump()));
  ASSERT_TRUE(again) << again.error();
  EXPECT_EQ(*again, rating);
}

TEST(Rating, TotalIsTheWeightedMeanOfWhatHasAScore) {
  const RatingForm form = smallForm();  // weights 1, 2, 1
  EXPECT_DOUBLE_EQ(*totalOf(form, ratingOf(form, "A", {4, 2, 5})), (4.0 + 2.0 * 2.0 + 5.0) / 4.0);
  EXPECT_DOUBLE_EQ(*totalOf(form, ratingOf(form, "A", {4, 2, 0})), (4.0 + 2.0 * 2.0) / 3.0);
  EXPECT_DOUBLE_EQ(*totalOf(form, ratingOf(form, "A", {5})), 5.0);
  EXPECT_FALSE(totalOf(form, ratingOf(form, "A", {})));
}

TEST(Rating, PassesFromItsLevelOnThoughTheMeanIsRounded) {
  RatingForm form = smallForm();
  EXPECT_EQ(passedBy(form, ratingOf(form, "A", {4, 3, 2})), true);
  EXPECT_EQ(passedBy(form, ratingOf(form, "A", {3, 3, 2})), false);
  // 0.1 * 3 + 0.7 * 3 + 0.2 * 3 over 0.1 + 0.7 + 0.2 is not 3 to the last bit for every order; it passes all the same.
  for (const auto& weights : {std::array{0.1, 0.7, 0.2}, std::array{0.3, 0.6, 0.1}, std::array{0.7, 0.1, 0.3}}) {
    for (std::size_t n = 0; n < 3; ++n) form.items[n].weight = weights[n];
    EXPECT_EQ(passedBy(form, ratingOf(form, "A", {3, 3, 3})), true);
  }
}

TEST(Rating, HasNoVerdictAsADraftNorWithoutALevel) {
  RatingForm form = smallForm();
  EXPECT_FALSE(passedBy(form, ratingOf(form, "A", {5, 5, 5}, false)));
  Rating rating = ratingOf(form, "A", {5, 5, 5});
  form.passLevels.push_back({"strict", {"x", "y"}, 4.5, "x"});
  EXPECT_FALSE(passedBy(form, rating)) << "of two levels nobody chose one";
  rating.passLevel = "strict";
  EXPECT_EQ(passedBy(form, rating), true);
  form.passLevels.clear();
  rating.passLevel.clear();
  EXPECT_FALSE(passedBy(form, rating));
}

TEST(Rating, AnswersItsForm) {
  const RatingForm form = smallForm();
  const auto sentence = [&](const Rating& rating) {
    const auto checked = checkRating(form, rating);
    EXPECT_TRUE(checked || checked.error().code == ErrorCode::badField);
    return checked ? std::string() : checked.error().sentence();
  };
  EXPECT_EQ(sentence(ratingOf(form, "A", {1, 5, 3})), "");
  EXPECT_EQ(sentence(ratingOf(form, "A", {1, 5, 0})), "");
  EXPECT_EQ(sentence(ratingOf(form, "A", {1}, false)), "") << "a draft may be in the middle";
  EXPECT_EQ(sentence(ratingOf(form, "A", {}, false)), "");
  EXPECT_EQ(sentence(ratingOf(form, "A", {1, 5})),
            "'report' in the rating is not answered; it must be answered before the rating is finished.");
  EXPECT_EQ(sentence(ratingOf(form, "A", {1, 6, 3})), "'order' in the rating is 6; it must be a score from 1 to 5.");
  EXPECT_EQ(sentence(ratingOf(form, "A", {-1, 5, 3}, false)), "'image' in the rating is -1; it must be a score from 1 to 5.");
  EXPECT_EQ(sentence(ratingOf(form, "A", {0, 5, 3})),
            "'image' in the rating is not applicable; it must be a score from 1 to 5: the form asks for it always.");
  Rating rating = ratingOf(form, "A", {1, 5, 3});
  rating.items.push_back({"image", 2, {}});
  EXPECT_NE(sentence(rating).find("'image' in the rating is answered twice"), std::string::npos);
  rating = ratingOf(form, "A", {1, 5, 3});
  rating.items[0].item = "courage";
  EXPECT_NE(sentence(rating).find("an item of the form 'small'"), std::string::npos);
  rating = ratingOf(form, "A", {1, 5, 3});
  rating.passLevel = "lenient";
  EXPECT_NE(sentence(rating).find("'pass_level' in the rating is \"lenient\""), std::string::npos);
  RatingForm allOptional = form;
  for (RatingItem& item : allOptional.items) item.mayBeNotApplicable = true;
  EXPECT_FALSE(checkRating(allOptional, ratingOf(form, "A", {0, 0, 0}))) << "a finished rating has a total";
}

TEST(Rating, RefusesEveryWrongFieldByItsName) {
  struct Wrong {
    const char* at;
    json value;  ///< discarded: the field is taken away
    const char* field;
  };
  const json none(json::value_t::discarded);
  const std::vector<Wrong> wrongs = {
      {"/format", none, "format"},
      {"/attempt", none, "attempt"},
      {"/rater", none, "rater"},
      {"/rater", "", "rater"},
      {"/rater", " Ada", "rater"},
      {"/rater", "Ada\t", "rater"},
      {"/rater", "A\nda", "rater"},
      {"/rater", std::string(201, 'x'), "rater"},
      {"/form", none, "form"},
      {"/form/id", "../x", "form.id"},
      {"/form/version", 0, "form.version"},
      {"/form/content", "abc", "form.content"},
      {"/form/content", "../../../../../../../../../../../", "form.content"},
      {"/pass_level", "", "pass_level"},
      {"/items", 3, "items"},
      {"/items/0/item", none, "items[0].item"},
      {"/items/1/item", "image", "items[1].item"},
      {"/items/0/score", none, "items[0].score"},
      {"/items/0/score", 3.5, "items[0].score"},
      {"/items/2/score", 3, "items[2].score"},
      {"/items/0/remark", 3, "items[0].remark"},
      {"/items/0/weight", 3, "items[0].weight"},
      {"/remark", std::string(20'001, 'x'), "remark"},
      {"/saw_name", none, "saw_name"},
      {"/saw_others", 1, "saw_others"},
      {"/at_s", -1, "at_s"},
      {"/finished", "yes", "finished"},
      {"/finished", none, "finished"},
      {"/revision", 0, "revision"},
      {"/total", 5, "total"},
  };
  for (const Wrong& wrong : wrongs) {
    json document = jsonOf(wholeRating());
    const json::json_pointer at(wrong.at);
    if (wrong.value.is_discarded())
      document[at.parent_pointer()].erase(at.back());
    else
      document[at] = wrong.value;
    const auto rating = read(document);
    ASSERT_FALSE(rating) << wrong.at << " " << wrong.value;
    EXPECT_EQ(rating.error().code, ErrorCode::badField) << wrong.at;
    EXPECT_TRUE(rating.error().sentence().starts_with("'" + std::string(wrong.field) + "' in rating.json is ")) << rating.error();
  }
  json newer = jsonOf(wholeRating());
  newer["format"] = kRatingFormat + 1;
  newer["something"] = "else";
  EXPECT_EQ(read(newer).error().code, ErrorCode::newerFormat);
}

}  // namespace
}  // namespace ew::rating_test
