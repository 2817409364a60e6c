#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <nlohmann/json.hpp>
#include <random>

#include "assessment/made_ratings.h"
#include "ew/assessment/rating.h"
#include "ew/library/attempt.h"
#include "library/temporary_folder.h"

namespace ew::rating_record_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::kRatedAt;
using test::ratingOf;
using test::smallForm;
using test::TemporaryFolder;
using test::textOf;
using test::writeText;

/// An attempt in a library of its own.
class RatingRecord : public ::testing::Test {
 protected:
  void SetUp() override { attempt_ = makeAttempt("20261126-093000-4f2a91c7"); }

  fs::path makeAttempt(const std::string& id) {
    Attempt attempt;
    attempt.id = id;
    attempt.caseId = "case";
    attempt.lessonId = "lesson";
    attempt.person = "Trainee";
    attempt.startedAt = kRatedAt;
    return AttemptFolder::begin(library_.path(), attempt)->folder();
  }
  Rating keep(const std::string& rater, const std::vector<int>& scores, bool finished = true) {
    const auto kept = keepRating(attempt_, form_, ratingOf(form_, rater, scores, finished));
    EXPECT_TRUE(kept) << kept.error();
    return kept.value_or(Rating());
  }
  /// "Ada 1, Ada draft 2": whose ratings there are.
  static std::string namesOf(const RatingRecords& kept) {
    std::string names;
    for (const auto& each : kept.ratings)
      names +=
          (names.empty() ? "" : ", ") + each.rating.rater + (each.rating.finished ? " " : " draft ") + std::to_string(each.rating.revision);
    return names;
  }
  std::string everyName() const {
    const RatingRecords kept = everyRating(attempt_);
    EXPECT_TRUE(kept.problems.empty()) << kept.problems.front();
    return namesOf(kept);
  }
  std::string visibleTo(const std::string& rater) const { return namesOf(ratingsVisibleTo(rater, attempt_)); }
  fs::path fileOf(const std::string& rater, const std::string& name) const { return ratingFolder(attempt_, rater) / name; }

  const TemporaryFolder library_;
  fs::path attempt_;
  RatingForm form_ = smallForm();
};

TEST_F(RatingRecord, ComesBackAsItWasGivenWithItsForm) {
  Rating given = ratingOf(form_, "Ada", {4, 2, 0});
  given.items[0].remark = "Schön gesehen: Δ, \"x\"\n";
  given.remark = std::string(20'000, 'r');
  given.sawName = true;
  const auto kept = keepRating(attempt_, form_, given);
  ASSERT_TRUE(kept) << kept.error();
  EXPECT_EQ(kept->attemptId, "20261126-093000-4f2a91c7");
  EXPECT_EQ(kept->formId, "small");
  EXPECT_EQ(kept->formVersion, 2);
  EXPECT_EQ(kept->revision, 1);
  EXPECT_FALSE(kept->sawOthers);
  const RatingRecords all = everyRating(attempt_);
  EXPECT_TRUE(all.problems.empty());
  ASSERT_EQ(all.ratings.size(), 1u);
  EXPECT_EQ(all.ratings[0].rating, *kept);
  EXPECT_EQ(*all.ratings[0].form, form_);
  EXPECT_EQ(all.attemptId, kept->attemptId);
}

TEST_F(RatingRecord, LeavesEarlierRatingsAsTheyAreWhenARaterRatesAgain) {
  keep("Ada", {1, 1, 1});
  const fs::path first = fileOf("Ada", "small-0001.json");
  const std::string before = textOf(first);
  EXPECT_EQ(keep("Ada", {2, 2, 2}).revision, 2);
  EXPECT_EQ(keep("Ada", {3, 3, 3}).revision, 3);
  EXPECT_EQ(textOf(first), before);
  const RatingRecords all = everyRating(attempt_);
  ASSERT_EQ(namesOf(all), "Ada 1, Ada 2, Ada 3");
  for (std::size_t n = 0; n < 3; ++n) EXPECT_DOUBLE_EQ(*totalOf(form_, all.ratings[n].rating), static_cast<double>(n + 1));
}

TEST_F(RatingRecord, NeverTakesTheNameOfADamagedRevision) {
  keep("Ada", {1, 1, 1});
  const fs::path second = fileOf("Ada", "small-0002.json");
  writeText(second, "{ half");
  EXPECT_EQ(keep("Ada", {3, 3, 3}).revision, 3);
  EXPECT_EQ(textOf(second), "{ half");
}

TEST_F(RatingRecord, TakesTheDraftsPlaceWithTheNextDraftAndEndsItWhenFinished) {
  EXPECT_EQ(keep("Ada", {1}, false).revision, 1);
  keep("Ada", {1, 4}, false);
  EXPECT_EQ(everyName(), "Ada draft 1");
  EXPECT_EQ(everyRating(attempt_).ratings[0].rating.items.size(), 2u);
  keep("Ada", {1, 4, 5});
  EXPECT_EQ(everyName(), "Ada 1");
  EXPECT_FALSE(fs::exists(fileOf("Ada", "small-draft.json")));
  keep("Ada", {2}, false);
  EXPECT_EQ(everyName(), "Ada 1, Ada draft 2");
}

TEST_F(RatingRecord, KeepsInADraftWhatIsRemarkedOnAnItemThatHasNoScoreYet) {
  Rating given = ratingOf(form_, "Ada", {4}, false);
  given.items.push_back({form_.items[1].id, std::nullopt, "look again", true});
  ASSERT_TRUE(keepRating(attempt_, form_, given));
  const RatingRecords all = everyRating(attempt_);
  ASSERT_TRUE(all.problems.empty()) << all.problems.front();
  EXPECT_EQ(all.ratings.at(0).rating.items, given.items);
  EXPECT_DOUBLE_EQ(*totalOf(form_, all.ratings[0].rating), 4.0);
  given.items.push_back({form_.items[2].id, 3, {}});
  given.finished = true;
  EXPECT_FALSE(keepRating(attempt_, form_, given)) << "an open item is not answered";
}

TEST_F(RatingRecord, ForgetsADraftThatWasFinishedBeforeTheProgramWasKilled) {
  keep("Ada", {1, 4}, false);
  const fs::path draft = fileOf("Ada", "small-draft.json");
  const std::string left = textOf(draft);
  keep("Ada", {1, 4, 5});
  writeText(draft, left);
  EXPECT_EQ(everyName(), "Ada 1");
}

TEST_F(RatingRecord, KnowsTheFormAsItWasThoughTheSchoolHasChangedIt) {
  keep("Ada", {4, 4, 4});
  RatingForm changed = form_;
  changed.version = 3;
  changed.items[0].weight = 9.0;
  changed.passLevels[0].total = 5.0;
  ASSERT_TRUE(keepRating(attempt_, changed, ratingOf(changed, "Ada", {1, 4, 4})));
  const RatingRecords all = everyRating(attempt_);
  ASSERT_EQ(namesOf(all), "Ada 1, Ada 2");
  EXPECT_EQ(passedBy(*all.ratings[0].form, all.ratings[0].rating), true);
  EXPECT_DOUBLE_EQ(*totalOf(*all.ratings[1].form, all.ratings[1].rating), (9.0 + 2.0 * 4.0 + 4.0) / 12.0);
}

TEST_F(RatingRecord, ShowsARaterNothingOfOthersBeforeTheyHaveFinished) {
  keep("Ada", {4, 4, 4});
  keep("Ben", {2, 2, 2});
  keep("Cleo", {3}, false);
  EXPECT_EQ(visibleTo("Cleo"), "Cleo draft 1");
  EXPECT_EQ(ratingsVisibleTo("Cleo", attempt_).hiddenRaters, 2u);
  EXPECT_EQ(visibleTo("Dan"), "") << "who has not begun sees nothing";
  EXPECT_EQ(visibleTo(""), "");
  EXPECT_EQ(visibleTo("ada"), "") << "a name is itself alone";
  EXPECT_EQ(visibleTo("Ada"), "Ada 1, Ben 1") << "drafts of others never";
  EXPECT_EQ(ratingsVisibleTo("Ada", attempt_).hiddenRaters, 0u);
  keep("Cleo", {3, 3, 3});
  EXPECT_EQ(visibleTo("Cleo"), "Ada 1, Ben 1, Cleo 1");
}

TEST_F(RatingRecord, HidesOthersFormByForm) {
  RatingForm second = form_;
  second.id = "second";
  keep("Ada", {4, 4, 4});
  ASSERT_TRUE(keepRating(attempt_, second, ratingOf(second, "Ada", {1, 1, 1})));
  ASSERT_TRUE(keepRating(attempt_, second, ratingOf(second, "Ben", {2, 2, 2})));
  const RatingRecords visible = ratingsVisibleTo("Ben", attempt_);
  ASSERT_EQ(namesOf(visible), "Ada 1, Ben 1");
  EXPECT_EQ(visible.ratings[0].rating.formId, "second");
  EXPECT_EQ(visible.hiddenRaters, 1u);
}

TEST_F(RatingRecord, SaysOfALaterRevisionThatOthersCouldBeSeen) {
  keep("Ada", {4, 4, 4});
  EXPECT_FALSE(keep("Ada", {4, 4, 5}).sawOthers) << "nobody else has rated";
  EXPECT_FALSE(keep("Ben", {2, 2, 2}).sawOthers) << "Ada's are hidden until Ben has finished";
  EXPECT_TRUE(keep("Ben", {4, 4, 5}).sawOthers);
  EXPECT_TRUE(keep("Ada", {2, 2, 2}, false).sawOthers);
  RatingForm second = form_;
  second.id = "second";
  EXPECT_TRUE(keepRating(attempt_, second, ratingOf(second, "Ada", {1, 1, 1}))->sawOthers) << "also with another form";
  EXPECT_TRUE(everyRating(attempt_).ratings[1].rating.isBlinded()) << "what was given before stays so";
}

TEST_F(RatingRecord, LetsNoDamagedFileOfOthersThrough) {
  keep("Ada", {4, 4, 4});
  writeText(fileOf("Ada", "small-0002.json"), R"({"secret": 5})");
  writeText(fileOf("Ben", "small-0001.json"), "{");
  EXPECT_EQ(everyRating(attempt_).problems.size(), 2u);
  const RatingRecords visible = ratingsVisibleTo("Ben", attempt_);
  EXPECT_TRUE(visible.ratings.empty());
  ASSERT_EQ(visible.problems.size(), 1u) << "only of what is their own";
  EXPECT_EQ(visible.problems[0].context[0].second, fileOf("Ben", "small-0001.json").string());
}

TEST_F(RatingRecord, TakesNothingElseForARating) {
  keep("Ada", {4, 4, 4});
  const fs::path good = fileOf("Ada", "small-0001.json");
  const std::string text = textOf(good);
  const auto refused = [&](const fs::path& file, const std::string& content, const std::string& because) {
    writeText(file, content);
    const RatingRecords all = everyRating(attempt_);
    EXPECT_EQ(namesOf(all), "Ada 1") << because;
    EXPECT_EQ(all.problems.size(), 1u) << because;
    const std::string sentence = all.problems.empty() ? std::string() : all.problems[0].sentence();
    EXPECT_NE(sentence.find(because), std::string::npos) << sentence;
    fs::remove(file);
  };
  const fs::path next = fileOf("Ada", "small-0002.json");
  refused(next, text.substr(0, text.size() / 2), "is not valid JSON");
  refused(next, "", "is not valid JSON");
  refused(next, text, "a copy of another rating counts for nothing");
  refused(fileOf("Ben", "small-0001.json"), text, "a copy of another rating counts for nothing");
  refused(fileOf("Ada", "small-draft.json"), text, "a copy of another rating counts for nothing");
  json changed = json::parse(text);
  changed["revision"] = 2;
  changed["items"][0]["score"] = 17;
  refused(next, changed.dump(), "it must be a score from 1 to 5");
  changed["items"][0]["score"] = 5;
  changed["attempt"] = "another";
  refused(next, changed.dump(), "it is of the attempt 'another'");
  changed["attempt"] = "20261126-093000-4f2a91c7";
  changed["form"]["content"] = std::string(32, '0');
  refused(next, changed.dump(), std::string(32, '0') + ".json");
  // Left beside it by a program that was killed: no names of ratings, and no problem either.
  writeText(ratingFolder(attempt_, "Ada") / ".ew-1-2-machine" / "small-0002.json", text);
  writeText(fileOf("Ada", "small-0002.json.part"), text);
  EXPECT_EQ(everyName(), "Ada 1");
}

TEST_F(RatingRecord, IsNotBelievedWithAFormThatWasChangedAfterwards) {
  const Rating kept = keep("Ada", {4, 4, 4});
  const fs::path file = attempt_ / "ratings" / "forms" / (kept.formContent + ".json");
  json form = json::parse(textOf(file));
  form["pass_levels"][0]["total"] = 1.0;
  writeText(file, form.dump());
  const RatingRecords all = everyRating(attempt_);
  EXPECT_TRUE(all.ratings.empty());
  ASSERT_EQ(all.problems.size(), 1u);
  EXPECT_NE(all.problems[0].sentence().find("is not the one that was answered"), std::string::npos) << all.problems[0];
  keep("Ben", {3, 3, 3});
  EXPECT_EQ(everyName(), "Ada 1, Ben 1") << "the next rating with that form mends it";
}

TEST_F(RatingRecord, WritesNothingOfARatingThatItRefuses) {
  const auto refused = [&](Rating rating, const std::string& because) {
    const auto kept = keepRating(attempt_, form_, std::move(rating));
    ASSERT_FALSE(kept) << because;
    EXPECT_EQ(kept.error().code, ErrorCode::badField);
    EXPECT_NE(kept.error().sentence().find(because), std::string::npos) << kept.error();
    EXPECT_FALSE(fs::exists(attempt_ / "ratings"));
  };
  refused(ratingOf(form_, "", {3, 3, 3}), "'rater' in the rating");
  refused(ratingOf(form_, "Ada ", {3, 3, 3}), "'rater' in the rating");
  refused(ratingOf(form_, "Ada", {3, 3}), "'report' in the rating is not answered");
  refused(ratingOf(form_, "Ada", {3, 9, 3}), "'order' in the rating is 9");
  refused(ratingOf(form_,
                   "A\xff"
                   "da",
                   {3, 3, 3}),
          "not UTF-8");
  Rating rating = ratingOf(form_, "Ada", {3, 3, 3});
  rating.remark = std::string(20'001, 'x');
  refused(rating, "'remark' in the rating");
  rating = ratingOf(form_, "Ada", {3, 3, 3});
  rating.at = std::chrono::sys_seconds(std::chrono::seconds(-1));
  refused(rating, "'at_s' in the rating");
  EXPECT_EQ(keepRating(library_ / "nothing", form_, ratingOf(form_, "Ada", {3, 3, 3})).error().code, ErrorCode::notFound);
  EXPECT_FALSE(fs::exists(library_ / "nothing"));
}

TEST_F(RatingRecord, SaysThatItCannotBeWritten) {
  writeText(attempt_ / "ratings", "a file");
  const auto kept = keepRating(attempt_, form_, ratingOf(form_, "Ada", {3, 3, 3}));
  ASSERT_FALSE(kept);
  EXPECT_EQ(kept.error().code, ErrorCode::notWritable);
}

TEST_F(RatingRecord, OfAnAttemptThatCannotBeReadIsNone) {
  const RatingRecords none = everyRating(library_ / "nothing");
  EXPECT_TRUE(none.ratings.empty());
  EXPECT_EQ(none.problems.size(), 1u);
  EXPECT_EQ(ratingsVisibleTo("Ada", library_ / "nothing").problems.size(), 1u) << "a rater is told as well";
}

TEST_F(RatingRecord, HasAFolderForEachRater) {
  std::set<fs::path> folders;
  const std::vector<std::string> names = {"Ada", "ada", "A/da", "../Ada", "Ä", "Ö", "forms", std::string(200, 'x')};
  for (const std::string& name : names) {
    const fs::path folder = ratingFolder("/attempt", name);
    folders.insert(folder);
    EXPECT_EQ(folder.lexically_normal(), folder) << "no name leads out of the folder";
    EXPECT_EQ(folder.parent_path(), fs::path("/attempt/ratings"));
    EXPECT_NE(folder.filename(), "forms");
    EXPECT_LT(folder.filename().string().size(), 60u);
  }
  EXPECT_EQ(folders.size(), names.size());
}

TEST_F(RatingRecord, GetsANumberOfItsOwnFromWindowsThatWorkAtOnce) {
  constexpr int kWindows = 4, kTimes = 8;
  std::vector<pid_t> windows;
  for (int window = 0; window < kWindows; ++window) {
    const pid_t child = ::fork();
    if (child == 0) {
      for (int n = 0; n < kTimes; ++n)
        if (!keepRating(attempt_, form_, ratingOf(form_, "Ada", {1 + n % 5, 1 + window, 3}))) ::_exit(1);
      ::_exit(0);
    }
    windows.push_back(child);
  }
  for (const pid_t child : windows) {
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
  }
  const RatingRecords all = everyRating(attempt_);
  EXPECT_TRUE(all.problems.empty());
  ASSERT_EQ(all.ratings.size(), static_cast<std::size_t>(kWindows * kTimes));
  EXPECT_EQ(all.ratings.back().rating.revision, kWindows * kTimes);
}

TEST_F(RatingRecord, IsWholeOrNotThereWhenTheProgramIsKilled) {
  std::mt19937 random(31);
  std::uniform_int_distribution<int> wait_us(200, 20'000);
  for (int trial = 0; trial < 20; ++trial) {
    attempt_ = makeAttempt("attempt-" + std::to_string(trial));
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    const pid_t child = ::fork();
    if (child == 0) {
      Rating rating = ratingOf(form_, "Ada", {1, 2, 3});
      rating.remark = std::string(20'000, 'r');
      while (keepRating(attempt_, form_, rating) && ::write(ends[1], "r", 1) == 1) {
      }
      ::_exit(1);
    }
    ::close(ends[1]);
    char one = 0;
    ASSERT_EQ(::read(ends[0], &one, 1), 1);
    ::usleep(static_cast<useconds_t>(wait_us(random)));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    std::size_t told = 1;
    while (::read(ends[0], &one, 1) == 1) ++told;
    ::close(ends[0]);
    const RatingRecords all = everyRating(attempt_);
    EXPECT_TRUE(all.problems.empty()) << all.problems.front();
    EXPECT_GE(all.ratings.size(), told) << "what was said to be kept is kept";
    EXPECT_LE(all.ratings.size(), told + 1);
    EXPECT_EQ(keep("Ada", {3, 3, 3}).revision, static_cast<int>(all.ratings.size()) + 1) << "and it goes on";
    for (const auto& each : fs::directory_iterator(ratingFolder(attempt_, "Ada")))
      EXPECT_FALSE(each.path().filename().string().starts_with('.')) << "what it left beside them is gone: " << each.path();
  }
}

}  // namespace
}  // namespace ew::rating_record_test
