#include "ew/library/attempt.h"
#include "ew/assessment/attempt_score.h"
#include "ew/assessment/rating.h"
#include "ew/assessment/rating_form.h"
#include "ew/assessment/repetition.h"
#include "ew/assessment/review_comment.h"
#include "ew/core/foreign_json.h"
#include "ew/records/xapi.h"
#include "folder.h"

namespace {

using nlohmann::json;

/// What was read is written, read again and is the same; a number that a list gives its members is not asked for.
template <class Value, class Read>
void comesBack(const json& document, const Read& read) {
  const auto first = read(document);
  if (!first) return ew::fuzz::checkSentence(first.error());
  const json written = jsonOf(*first);
  const auto again = read(written);
  ew::fuzz::mustHold(again.has_value() && jsonOf(*again) == written);
  static_cast<void>(written.dump(-1, ' ', false, json::error_handler_t::replace));
}

}  // namespace

/// What the folder of an attempt holds: the attempt with the statements made of it, scores, ratings with their forms, comments,
/// repetitions.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace ew;
  const json document = jsonOrNull({reinterpret_cast<const char*>(bytes), size});
  const Message where = verbatim("The file");
  comesBack<Attempt>(document, [](const json& one) { return attemptFromJson(one); });
  comesBack<AttemptScore>(document, [](const json& one) { return scoreFromJson(one); });
  comesBack<Rating>(document, [&](const json& one) { return ratingFromJson(one, where); });
  comesBack<RatingForm>(document, [&](const json& one) { return ratingFormFromJson(one, where); });
  comesBack<CommentFile>(document, [](const json& one) { return commentsFromJson(one); });
  comesBack<std::vector<RepetitionState>>(document, [](const json& one) { return repetitionFromJson(one); });
  if (const auto attempt = attemptFromJson(document)) {
    XapiOptions options;
    options.homePage = "https://school.example/";
    options.pseudonym = "a";
    const auto statements = statementsOf(*attempt, options);
    if (!statements) fuzz::checkSentence(statements.error());
  }
  return 0;
}
