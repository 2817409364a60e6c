#include <array>
#include <nlohmann/json.hpp>
#include <set>

#include "ew/annotation/annotation.h"
#include "ew/core/data_file.h"
#include "ew/core/json_fields.h"
#include "utf8.h"

namespace ew::annotation {
namespace {

using nlohmann::json;

constexpr int kLargestNumber = 1000000;

constexpr std::array<std::pair<std::string_view, AnnotationKind>, 2> kKinds{
    {{"text", AnnotationKind::text}, {"arrow", AnnotationKind::arrow}}};

glm::dvec2 placeIn(const JsonFields& fields, std::string_view key) {
  const auto both = fields.numbers(key, 2, 2, -kFarthest_mm, kFarthest_mm, true, say<"two numbers, a place in mm">());
  return both.size() == 2 ? glm::dvec2(both[0], both[1]) : glm::dvec2(0.0);
}

void readText(const JsonFields& fields, Annotation& one) {
  const Message expected = say<"one line of text of 1 to %1 bytes">(kLongestText);
  if (fields.has("tail_mm")) fields.refuse("tail_mm", say<"left out of a text">());
  one.tail_mm = one.at_mm;
  one.text = fields.text("text", {}, 1, kLongestText, expected);
  if (fields.good() && oneLine(one.text, kLongestText) != one.text) fields.refuse("text", expected);
}

void readArrow(const JsonFields& fields, Annotation& one) {
  if (fields.has("text")) fields.refuse("text", say<"left out of an arrow">());
  one.tail_mm = placeIn(fields, "tail_mm");
  if (fields.good() && glm::length(one.at_mm - one.tail_mm) < kShortestArrow_mm)
    fields.refuse("tail_mm", say<"a place at least 0.5 mm from at_mm">());
}

}  // namespace

std::string_view wordOf(AnnotationKind kind) {
  switch (kind) {
    case AnnotationKind::text:
      return "text";
    case AnnotationKind::arrow:
      return "arrow";
  }
  return {};
}

json toJson(const Annotations& annotations) {
  json all = json::array();
  for (const Annotation& each : annotations.all) {
    json one = {{"number", each.number}, {"kind", wordOf(each.kind)}, {"at_mm", {each.at_mm.x, each.at_mm.y}}};
    if (each.kind == AnnotationKind::arrow)
      one["tail_mm"] = {each.tail_mm.x, each.tail_mm.y};
    else
      one["text"] = each.text;
    all.push_back(std::move(one));
  }
  return {{"format", kAnnotationsFormat}, {"next_number", annotations.nextNumber}, {"annotations", std::move(all)}};
}

Result<Annotations> annotationsFromJson(const json& document, const Message& where) {
  JsonReading reading(where);
  const JsonFields fields(document, reading);
  requireFormat(fields, kAnnotationsFormat);
  fields.only({"format", "next_number", "annotations"});
  Annotations made;
  made.nextNumber = static_cast<int>(fields.whole("next_number", 1, kLargestNumber));
  std::set<int> numbers;
  for (const JsonFields& each : fields.objects("annotations", 0, kMostAnnotations)) {
    each.only({"number", "kind", "at_mm", "tail_mm", "text"});
    Annotation one;
    one.number = static_cast<int>(each.whole("number", 1, made.nextNumber - 1, {}, say<"a whole number from 1 to below next_number">()));
    if (each.good() && !numbers.insert(one.number).second) each.refuse("number", say<"a number that no other annotation has">());
    one.kind = each.word("kind", kKinds);
    one.at_mm = placeIn(each, "at_mm");
    if (one.kind == AnnotationKind::text)
      readText(each, one);
    else
      readArrow(each, one);
    made.all.push_back(std::move(one));
  }
  if (reading.problem()) return passOn(*reading.problem());
  return made;
}

}  // namespace ew::annotation
