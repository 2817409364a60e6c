#include <array>
#include <nlohmann/json.hpp>
#include <set>

#include "ew/annotation/body_mark.h"
#include "ew/core/json_fields.h"
#include "ew/io/json_files.h"
#include "kept_limits.h"

namespace ew::annotation {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::size_t kMostVariants = 20;
constexpr double kFarthestCentre_mm = 3000.0;

constexpr std::array<std::pair<std::string_view, MarkView>, 4> kViews{
    {{"front", MarkView::front}, {"back", MarkView::back}, {"right", MarkView::right}, {"left", MarkView::left}}};

std::string idIn(const JsonFields& fields, std::string_view key) {
  std::string id = fields.text(key, {}, 1, 40);
  const bool isPlain = id.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") == std::string::npos;
  if (fields.good() && !isPlain) fields.refuse(key, say<"small letters, digits and -">());
  return id;
}

fs::path drawingIn(const JsonFields& fields, const fs::path& folder) {
  const Message expected = say<"the name of an SVG file in the folder of the mark">();
  const std::string name = fields.text("drawing", {}, 1, 100, expected);
  if (!fields.good()) return {};
  fs::path file = folder / name;
  std::error_code ignored;
  if (fs::path(name).filename() != name || file.extension() != ".svg" || !fs::is_regular_file(file, ignored))
    fields.refuse("drawing", expected);
  return file;
}

}  // namespace

Result<BodyMark> bodyMarkFromJson(const json& document, const std::string& id, const fs::path& folder, const Message& where) {
  JsonReading reading(where, {"note"});
  const JsonFields fields(document, reading);
  requireFormat(fields, kBodyMarkFormat);
  fields.only({"format", "title", "view", "centre_mm", "side_mm", "drawing", "variants", "regions", "mannequins"});
  BodyMark mark;
  mark.id = id;
  mark.title = wordsIn(fields, "title", kLongestTitle);
  mark.view = fields.word("view", kViews);
  mark.centre_mm = fields.point("centre_mm", kFarthestCentre_mm);
  mark.side_mm = fields.number("side_mm", 20.0, kFarthestCentre_mm);
  mark.drawing = drawingIn(fields, folder);
  std::set<std::string> ids;
  for (const JsonFields& each : fields.objects("variants", 0, kMostVariants)) {
    each.only({"id", "title", "drawing"});
    MarkVariant variant{idIn(each, "id"), wordsIn(each, "title", kLongestTitle), drawingIn(each, folder)};
    if (each.good() && !ids.insert(variant.id).second) each.refuse("id", say<"an id that no other variant has">());
    mark.variants.push_back(std::move(variant));
  }
  mark.regions = fields.texts("regions", 0, kMostRegions);
  mark.mannequins = fields.texts("mannequins", 0, kMostRegions);
  if (reading.problem()) return passOn(*reading.problem());
  return mark;
}

Result<BodyMark> readBodyMark(const fs::path& file) {
  const Message where = say<"the body mark %1">(file.string());
  const auto document = readJsonFile(file, where);
  if (!document) return passOn(document.error());
  return bodyMarkFromJson(*document, file.stem().string(), file.parent_path(), where);
}

Result<std::vector<BodyMark>> readBodyMarks(const fs::path& folder) {
  return readEvery<BodyMark>(folder, say<"body marks">(), readBodyMark);
}

}  // namespace ew::annotation
