#include "ew/assessment/rating.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "ew/core/find_entry.h"
#include "ew/core/json_fields.h"
#include "ew/io/content_key.h"
#include "rating/rating_ids.h"

namespace ew {
namespace {

using nlohmann::json;
using std::chrono::sys_seconds;

constexpr std::size_t kLongestRater = 200, kLongestRatingRemark = 20'000, kLongestAttemptId = 100;  // bytes
constexpr std::size_t kMostRatedItems = 100;
constexpr long long kLatestMoment_s = 253'402'300'799;  // the end of the year 9999
constexpr long long kMostRevisions = 9999;
constexpr double kRounding = 1e-9;

bool isBlank(char letter) { return letter == ' ' || (letter >= '\t' && letter <= '\r'); }

bool isRaterName(const std::string& name) {
  return !name.empty() && name.size() <= kLongestRater && !isBlank(name.front()) && !isBlank(name.back()) &&
         std::none_of(name.begin(), name.end(), [](char letter) { return static_cast<unsigned char>(letter) < 0x20 || letter == 0x7f; });
}

std::string raterIn(const JsonFields& fields) {
  const Message expected = say<"a name of 1 to %1 bytes on one line, without blanks at its ends">(kLongestRater);
  std::string name = fields.text("rater", {}, 1, kLongestRater, expected);
  if (fields.good() && !isRaterName(name)) fields.refuse("rater", expected);
  return name;
}

ItemRating ratedItemIn(const JsonFields& fields, std::set<std::string>& ids) {
  fields.only({"item", "score", "not_applicable", "open", "remark"});
  ItemRating rated;
  rated.item = assessment::idIn(fields, "item");
  if (fields.good() && !ids.insert(rated.item).second) fields.refuse("item", say<"an item that was not answered before">());
  const bool notApplicable = fields.flag("not_applicable", false);
  if (notApplicable && fields.has("score")) fields.refuse("score", say<"missing, since the item is not applicable">());
  rated.isOpen = fields.flag("open", false);
  if (rated.isOpen && (notApplicable || fields.has("score"))) fields.refuse("open", say<"false or missing, since the item is answered">());
  if (!notApplicable && !rated.isOpen) rated.score = static_cast<int>(fields.whole("score", -100, 100));
  rated.remark = fields.text("remark", std::string(), 0, kLongestRatingRemark);
  return rated;
}

void formIn(const JsonFields& fields, Rating& rating) {
  fields.only({"id", "version", "content"});
  rating.formId = assessment::idIn(fields, "id");
  rating.formVersion = static_cast<int>(fields.whole("version", 1, assessment::kHighestFormVersion));
  rating.formContent = fields.text("content");
  if (fields.good() && !isContentKey(rating.formContent)) fields.refuse("content", say<"32 hexadecimal digits">());
}

tl::unexpected<Error> refused(const std::string& field, const Message& found, const Message& expected) {
  return passOn(fieldError(say<"the rating">(), field, found, expected));
}

Result<void> checkItem(const RatingForm& form, const ItemRating& rated) {
  const RatingItem* item = form.itemOf(rated.item);
  if (item == nullptr) return refused("items", verbatim('"' + rated.item + '"'), say<"an item of the form '%1'">(form.id));
  if (rated.isOpen) return {};
  if (!rated.score && !item->mayBeNotApplicable)
    return refused(rated.item, say<"not applicable">(),
                   say<"a score from %1 to %2: the form asks for it always">(form.lowest, form.highest));
  if (rated.score && (*rated.score < form.lowest || *rated.score > form.highest))
    return refused(rated.item, verbatim(std::to_string(*rated.score)), say<"a score from %1 to %2">(form.lowest, form.highest));
  return {};
}

}  // namespace

const ItemRating* Rating::itemOf(std::string_view itemId) const { return entryWith(items, &ItemRating::item, itemId); }

std::optional<double> totalOf(const RatingForm& form, const Rating& rating) {
  double sum = 0.0, weights = 0.0;
  for (const ItemRating& rated : rating.items) {
    const RatingItem* item = form.itemOf(rated.item);
    if (item == nullptr || !rated.score) continue;
    sum += item->weight * *rated.score;
    weights += item->weight;
  }
  if (!(weights > 0.0)) return std::nullopt;
  return sum / weights;
}

std::optional<bool> passedBy(const RatingForm& form, const Rating& rating) {
  const auto total = totalOf(form, rating);
  const RatingPassLevel* level = form.passLevelOf(rating.passLevel);
  if (!rating.finished || !total || level == nullptr) return std::nullopt;
  return *total >= level->total - kRounding;
}

Result<void> checkRating(const RatingForm& form, const Rating& rating) {
  for (const ItemRating& rated : rating.items) {
    if (auto good = checkItem(form, rated); !good) return good;
    if (rating.itemOf(rated.item) != &rated) return refused(rated.item, say<"answered twice">(), say<"answered once">());
  }
  if (!rating.passLevel.empty() && form.passLevelOf(rating.passLevel) == nullptr)
    return refused("pass_level", verbatim('"' + rating.passLevel + '"'), say<"a pass level of the form '%1'">(form.id));
  if (!rating.finished) return {};
  for (const RatingItem& item : form.items)
    if (const ItemRating* rated = rating.itemOf(item.id); rated == nullptr || rated->isOpen)
      return refused(item.id, say<"not answered">(), say<"answered before the rating is finished">());
  if (!totalOf(form, rating)) return refused("items", say<"without a score">(), say<"a list with a score for one item at least">());
  return {};
}

Result<Rating> ratingFromJson(const json& document, const Message& where) {
  JsonReading reading(where);
  const JsonFields fields(document, reading);
  requireFormat(fields, kRatingFormat);
  fields.only(
      {"format", "attempt", "rater", "form", "pass_level", "items", "remark", "saw_name", "saw_others", "at_s", "finished", "revision"});
  Rating rating;
  rating.attemptId = fields.text("attempt", {}, 1, kLongestAttemptId);
  rating.rater = raterIn(fields);
  if (!fields.has("form")) fields.refuse("form", say<"an object with the fields id, version and content">());
  formIn(fields.object("form"), rating);
  rating.passLevel = assessment::idIn(fields, "pass_level", false);
  std::set<std::string> ids;
  for (const JsonFields& each : fields.objects("items", 0, kMostRatedItems)) rating.items.push_back(ratedItemIn(each, ids));
  rating.remark = fields.text("remark", std::string(), 0, kLongestRatingRemark);
  rating.sawName = fields.flag("saw_name");
  rating.sawOthers = fields.flag("saw_others");
  rating.at = sys_seconds(std::chrono::seconds(fields.whole("at_s", 0, kLatestMoment_s)));
  rating.finished = fields.flag("finished");
  rating.revision = static_cast<int>(fields.whole("revision", 1, kMostRevisions));
  if (reading.problem()) return passOn(*reading.problem());
  return rating;
}

json jsonOf(const Rating& rating) {
  json items = json::array();
  for (const ItemRating& rated : rating.items) {
    json each = {{"item", rated.item}};
    if (rated.score)
      each["score"] = *rated.score;
    else
      each[rated.isOpen ? "open" : "not_applicable"] = true;
    if (!rated.remark.empty()) each["remark"] = rated.remark;
    items.push_back(std::move(each));
  }
  json made = {
      {"format", kRatingFormat},        {"attempt", rating.attemptId},
      {"rater", rating.rater},          {"form", {{"id", rating.formId}, {"version", rating.formVersion}, {"content", rating.formContent}}},
      {"items", std::move(items)},      {"saw_name", rating.sawName},
      {"saw_others", rating.sawOthers}, {"at_s", rating.at.time_since_epoch().count()},
      {"finished", rating.finished},    {"revision", rating.revision}};
  if (!rating.passLevel.empty()) made["pass_level"] = rating.passLevel;
  if (!rating.remark.empty()) made["remark"] = rating.remark;
  return made;
}

}  // namespace ew
