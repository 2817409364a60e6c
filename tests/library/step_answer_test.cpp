#include "ew/library/step_answer.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "ew/core/foreign_json.h"
#include "ew/library/attempt.h"

namespace ew::step_answer_test {
namespace {

using nlohmann::json;

/// One of each kind, with the JSON that attempts have always had for it.
std::vector<std::pair<StepAnswer, std::string>> everyKind() {
  const CaliperReading distance{"distance", {{"length", 40.5, "mm"}}, {{-20.0, 0.25, 1.0}, {20.5, 0.0, -0.125}}};
  const CaliperReading ellipse{"ellipse", {{"circumference", 62.5, "mm"}, {"area", 3.0, "cm2"}}, {}};
  return {
      {StepAnswer(), "null"},
      {OptionsAnswer{{0, 2}}, R"({"chosen":[0,2]})"},
      {OptionsAnswer{}, R"({"chosen":[]})"},
      {NumberAnswer{12.5}, R"({"number":12.5})"},
      {WatchAnswer{true}, R"({"watched":true})"},
      {WatchAnswer{false}, R"({"watched":false})"},
      {PointAnswer{{1.0, -2.5, 300.0}}, R"({"at_mm":[1.0,-2.5,300.0]})"},
      {MeasurementAnswer{40.5, "mm", "distance", distance.points_mm},
       R"({"caliper":"distance","points_mm":[[-20.0,0.25,1.0],[20.5,0.0,-0.125]],"unit":"mm","value":40.5})"},
      {MeasurementAnswer{3.0, "cm2", "ellipse", {}}, R"({"caliper":"ellipse","unit":"cm2","value":3.0})"},
      {MeasurementAnswer{7.0, "ml", {}, {}}, R"({"unit":"ml","value":7.0})"},
      {CalipersAnswer{{distance, ellipse}},
       R"({"measurements":[{"caliper":"distance","figures":[{"name":"length","unit":"mm","value":40.5}],)"
       R"("points_mm":[[-20.0,0.25,1.0],[20.5,0.0,-0.125]]},{"caliper":"ellipse","figures":[{"name":"circumference","unit":"mm",)"
       R"("value":62.5},{"name":"area","unit":"cm2","value":3.0}],"points_mm":[]}]})"},
  };
}

TEST(StepAnswers, OfEveryKindGoThroughJsonAndBackUnchanged) {
  for (const auto& [answer, text] : everyKind()) {
    EXPECT_EQ(jsonOf(answer).dump(), text);
    EXPECT_TRUE(stepAnswerFromJson(jsonOf(answer)) == answer) << text;
    EXPECT_TRUE(stepAnswerFromJson(jsonOrNull(text)) == answer) << text;
  }
}

TEST(StepAnswers, TakeWhatTheyKnowOfWhatAnybodyWrote) {
  const std::pair<const char*, StepAnswer> written[] = {
      {R"({"chosen":[1,"x",-1,2.5,3],"by":"me"})", OptionsAnswer{{1, 3}}},
      {R"({"number":12})", NumberAnswer{12.0}},
      {R"({"value":40,"unit":"mm","caliper":7,"points_mm":[[1,2,3],[1,2],"x",[1,2,null]]})",
       MeasurementAnswer{40.0, "mm", {}, {{1, 2, 3}}}},
      {R"({"measurements":[3,{"caliper":1,"figures":[{"name":"length","value":4.0,"unit":"mm"},{"name":"area","value":"4"}]}]})",
       CalipersAnswer{{{}, {"", {{"length", 4.0, "mm"}}, {}}}}}};
  for (const auto& [text, answer] : written) EXPECT_TRUE(stepAnswerFromJson(jsonOrNull(text)) == answer) << text;
  for (const char* text : {"null", "[1,2]", "\"yes\"", "12", "{}", R"({"value":"40","unit":"mm"})", R"({"value":40.0})", R"({"chosen":1})",
                           R"({"number":"12"})", R"({"watched":1})", R"({"at_mm":[1,2]})", R"({"at_mm":[1,2,null]})"})
    EXPECT_TRUE(stepAnswerFromJson(jsonOrNull(text)) == StepAnswer()) << text;
}

/// attempt.json as it was written when an answer was JSON all the way.
constexpr const char* kAttemptOfBefore = R"({
 "case": "liver-sweep-recorded",
 "finished_at": "2026-11-26T09:40:00Z",
 "format": 1,
 "id": "20261126-093000-1f4a91c7",
 "lesson": "first-movements",
 "outcomes": [
  {
   "answer": {
    "watched": true
   },
   "at": "2026-11-26T09:31:00Z",
   "score": 1.0,
   "seconds": 41.5,
   "step": "watch",
   "verdict": "passed"
  },
  {
   "answer": {
    "caliper": "distance",
    "points_mm": [
     [
      -20.0,
      0.0,
      0.0
     ],
     [
      20.5,
      0.1,
      0.0
     ]
    ],
    "unit": "mm",
    "value": 40.5
   },
   "at": "2026-11-26T09:32:00Z",
   "figures": [
    {
     "name": "value",
     "unit": "mm",
     "value": 40.5
    },
    {
     "name": "share",
     "value": 0.25
    }
   ],
   "hints": 1,
   "recording": "step-02-measure.seq.mha",
   "remarks": [
    {
     "good": true,
     "text": "Well done."
    }
   ],
   "score": 0.85,
   "seconds": 60.0,
   "step": "measure",
   "verdict": "passed"
  },
  {
   "answer": {
    "chosen": [
     1
    ]
   },
   "at": "2026-11-26T09:33:00Z",
   "score": 0.0,
   "seconds": 8.0,
   "step": "question",
   "verdict": "failed"
  },
  {
   "answer": {
    "chosen": [
     0,
     "two"
    ],
    "how": "by voice"
   },
   "at": "2026-11-26T09:34:00Z",
   "score": 0.0,
   "seconds": 8.0,
   "step": "question",
   "verdict": "failed"
  },
  {
   "answer": [
    1,
    2
   ],
   "at": "2026-11-26T09:35:00Z",
   "score": 0.0,
   "seconds": 8.0,
   "step": "question",
   "verdict": "handed_in"
  },
  {
   "at": "2026-11-26T09:36:00Z",
   "score": 0.0,
   "seconds": 1.0,
   "step": "free",
   "verdict": "skipped"
  }
 ],
 "person": "Ada",
 "program": "0.1.0",
 "started_at": "2026-11-26T09:30:00Z"
})";

TEST(StepAnswers, OfAttemptsThatWereWrittenBeforeAreReadAndKeptAsTheyAre) {
  const auto attempt = attemptFromJson(jsonOrNull(kAttemptOfBefore));
  ASSERT_TRUE(attempt) << attempt.error();
  ASSERT_EQ(attempt->outcomes.size(), 6u);
  const StepAnswer expected[] = {WatchAnswer{true},  MeasurementAnswer{40.5, "mm", "distance", {{-20.0, 0.0, 0.0}, {20.5, 0.1, 0.0}}},
                                 OptionsAnswer{{1}}, OptionsAnswer{{0}},
                                 StepAnswer(),       StepAnswer()};
  for (std::size_t n = 0; n < attempt->outcomes.size(); ++n) EXPECT_TRUE(attempt->outcomes[n].answer == expected[n]) << n;
  EXPECT_TRUE(attempt->outcomes[1].otherAnswer.is_null()) << "it is known in full";
  EXPECT_EQ(attempt->outcomes[3].answerJson()["how"], "by voice") << "what it does not know is kept";
  EXPECT_EQ(attempt->outcomes[4].answerJson(), json::array({1, 2}));
  EXPECT_TRUE(attempt->outcomes[5].answerJson().is_null());
  EXPECT_EQ(jsonOf(*attempt).dump(1), kAttemptOfBefore);
  EXPECT_EQ(*attemptFromJson(jsonOf(*attempt)), *attempt);
}

}  // namespace
}  // namespace ew::step_answer_test
