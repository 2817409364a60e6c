#include "ew/assessment/rating_form.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>

#include "ew/core/find_entry.h"
#include "ew/core/json_fields.h"
#include "ew/io/content_key.h"
#include "ew/io/json_files.h"
#include "rating/rating_ids.h"

namespace ew {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr int kLowestScore = -100, kHighestScore = 100;
constexpr std::size_t kMostItems = 100, kMostPassLevels = 50, kMostAnchors = kHighestScore - kLowestScore + 1;
constexpr std::size_t kLongestFormTitle = 200, kLongestFormText = 2000;  // bytes
constexpr double kLeastWeight = 0.001, kLargestWeight = 1000.0;

/// An id that no earlier entry of its list has.
std::string newId(const JsonFields& fields, std::set<std::string>& ids) {
  std::string id = assessment::idIn(fields, "id");
  if (fields.good() && !ids.insert(id).second) fields.refuse("id", say<"an id that no entry before it has">());
  return id;
}

std::vector<RatingAnchor> anchorsIn(const JsonFields& item, const RatingForm& form) {
  std::vector<RatingAnchor> anchors;
  for (const JsonFields& each : item.objects("anchors", 2, kMostAnchors)) {
    each.only({"score", "text"});
    const int least = anchors.empty() ? form.lowest : anchors.back().score + 1;
    const Message expected = say<"a whole number of the scale, %1 to %2, above that of the anchor before it">(form.lowest, form.highest);
    anchors.push_back({static_cast<int>(each.whole("score", least, form.highest, {}, expected)), wordsIn(each, "text", kLongestFormText)});
  }
  if (item.good() && (anchors.front().score != form.lowest || anchors.back().score != form.highest))
    item.refuse("anchors", say<"without one for an end of the scale">(),
                say<"a list that says what the scores %1 and %2 look like">(form.lowest, form.highest));
  return anchors;
}

RatingItem itemIn(const JsonFields& fields, const RatingForm& form, std::set<std::string>& ids) {
  fields.only({"id", "title", "description", "anchors", "weight", "not_applicable"});
  RatingItem item;
  item.id = newId(fields, ids);
  item.title = wordsIn(fields, "title", kLongestFormTitle);
  item.description = wordsIn(fields, "description", kLongestFormText);
  item.anchors = anchorsIn(fields, form);
  item.weight = fields.number("weight", kLeastWeight, kLargestWeight, 1.0);
  item.mayBeNotApplicable = fields.flag("not_applicable", false);
  return item;
}

RatingPassLevel passLevelIn(const JsonFields& fields, const RatingForm& form, std::set<std::string>& ids) {
  fields.only({"id", "title", "total", "source"});
  RatingPassLevel level;
  level.id = newId(fields, ids);
  level.title = wordsIn(fields, "title", kLongestFormTitle);
  level.total = fields.number("total", form.lowest, form.highest);
  level.source = fields.text("source", {}, 1, kLongestFormText);
  return level;
}

void readScale(const JsonFields& scale, RatingForm& form) {
  scale.only({"lowest", "highest"});
  form.lowest = static_cast<int>(scale.whole("lowest", kLowestScore, kHighestScore - 1));
  form.highest = static_cast<int>(scale.whole("highest", form.lowest + 1, kHighestScore));
}

json jsonOf(const Words& words) { return {{"en", words.english}, {"de", words.german}}; }

Error leftOut(const fs::path& file, const Message& why, ErrorCode code) {
  return {code, say<"The rating form '%1' is left out: %2">(file.filename(), why), {{"file", file.string()}}};
}

/// Adds the forms of a folder that no form of the list is like already.
void addFrom(const fs::path& folder, RatingFormList& list) {
  const auto files = jsonFilesIn(folder, say<"rating forms">());
  if (!files) return list.problems.push_back(files.error());
  for (const fs::path& file : *files) {
    auto form = readRatingForm(file);
    if (!form) {
      list.problems.push_back(leftOut(file, form.error().message, form.error().code));
    } else if (list.find(form->id, form->version) != nullptr) {
      list.problems.push_back(
          leftOut(file,
                  say<"there is a form '%1' of version %2 already; give yours another id, or a higher version if it is yours.">(
                      form->id, form->version),
                  ErrorCode::badField));
    } else {
      list.forms.push_back(std::move(*form));
    }
  }
}

}  // namespace

const RatingItem* RatingForm::itemOf(std::string_view itemId) const { return entryWith(items, &RatingItem::id, itemId); }

const RatingPassLevel* RatingForm::passLevelOf(std::string_view levelId) const {
  if (levelId.empty()) return passLevels.size() == 1 ? &passLevels.front() : nullptr;
  return entryWith(passLevels, &RatingPassLevel::id, levelId);
}

Result<RatingForm> ratingFormFromJson(const json& document, const Message& where) {
  JsonReading reading(where, {"note"});
  const JsonFields fields(document, reading);
  requireFormat(fields, kRatingFormFormat);
  fields.only({"format", "id", "version", "title", "source", "validity", "scale", "items", "pass_levels"});
  RatingForm form;
  form.id = assessment::idIn(fields, "id");
  form.version = static_cast<int>(fields.whole("version", 1, assessment::kHighestFormVersion));
  form.title = wordsIn(fields, "title", kLongestFormTitle);
  form.source = fields.text("source", {}, 1, kLongestFormText);
  form.validity = wordsIn(fields, "validity", kLongestFormText);
  if (!fields.has("scale")) fields.refuse("scale", say<"an object with the fields lowest and highest">());
  readScale(fields.object("scale"), form);
  std::set<std::string> itemIds, levelIds;
  for (const JsonFields& each : fields.objects("items", 1, kMostItems)) form.items.push_back(itemIn(each, form, itemIds));
  for (const JsonFields& each : fields.objects("pass_levels", 0, kMostPassLevels))
    form.passLevels.push_back(passLevelIn(each, form, levelIds));
  if (reading.problem()) return passOn(*reading.problem());
  return form;
}

json jsonOf(const RatingForm& form) {
  json items = json::array(), levels = json::array();
  for (const RatingItem& each : form.items) {
    json anchors = json::array();
    for (const RatingAnchor& anchor : each.anchors) anchors.push_back({{"score", anchor.score}, {"text", jsonOf(anchor.text)}});
    items.push_back({{"id", each.id},
                     {"title", jsonOf(each.title)},
                     {"description", jsonOf(each.description)},
                     {"anchors", std::move(anchors)},
                     {"weight", each.weight},
                     {"not_applicable", each.mayBeNotApplicable}});
  }
  for (const RatingPassLevel& each : form.passLevels)
    levels.push_back({{"id", each.id}, {"title", jsonOf(each.title)}, {"total", each.total}, {"source", each.source}});
  return {{"format", kRatingFormFormat},
          {"id", form.id},
          {"version", form.version},
          {"title", jsonOf(form.title)},
          {"source", form.source},
          {"validity", jsonOf(form.validity)},
          {"scale", {{"lowest", form.lowest}, {"highest", form.highest}}},
          {"items", std::move(items)},
          {"pass_levels", std::move(levels)}};
}

Result<RatingForm> readRatingForm(const fs::path& file) {
  const Message where = say<"the rating form %1">(file.filename());
  const auto document = readJsonFile(file, where);
  if (!document) return passOn(document.error());
  return ratingFormFromJson(*document, where);
}

std::string contentOf(const RatingForm& form) {
  return ContentKey().add(jsonOf(form).dump(-1, ' ', false, json::error_handler_t::replace)).text();
}

fs::path ratingFormFolder(const fs::path& library) { return library / "rating_forms"; }

const RatingForm* RatingFormList::find(std::string_view id, int version) const {
  const RatingForm* best = nullptr;
  for (const RatingForm& each : forms)
    if (each.id == id && (version == 0 || each.version == version) && (best == nullptr || each.version > best->version)) best = &each;
  return best;
}

RatingFormList listRatingForms(const fs::path& resources, const fs::path& library) {
  RatingFormList list;
  addFrom(resources / "rating_forms", list);
  std::error_code ignored;
  const fs::path own = ratingFormFolder(library);
  if (!library.empty() && fs::exists(own, ignored)) addFrom(own, list);
  std::sort(list.forms.begin(), list.forms.end(),
            [](const RatingForm& a, const RatingForm& b) { return std::tie(a.id, b.version) < std::tie(b.id, a.version); });
  return list;
}

}  // namespace ew
