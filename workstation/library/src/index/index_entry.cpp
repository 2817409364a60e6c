#include "index/index_entry.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "case/manifest.h"
#include "ew/core/json_fields.h"
#include "ew/io/safe_file.h"
#include "ew/library/case.h"
#include "ew/library/case_words.h"

namespace ew {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

constexpr std::size_t kLargestIndexed_bytes = 4u << 20;
constexpr std::size_t kMostIndexedTags = 64;
constexpr std::size_t kMostIndexedLessons = 1000;
constexpr std::size_t kLongestIndexed_bytes = 64u << 10;

const json& indexedField(const json& object, const char* key) {
  static const json nothing;
  if (!object.is_object()) return nothing;
  const auto found = object.find(key);
  return found == object.end() ? nothing : *found;
}

/// Of the value as text; NUL would end a text in the data base.
std::string indexable(const json& value) {
  if (!value.is_string()) return {};
  std::string text = value.get_ref<const std::string&>().substr(0, kLongestIndexed_bytes);
  std::replace(text.begin(), text.end(), '\0', ' ');
  return text;
}

std::string indexedText(const json& object, const char* key) { return indexable(indexedField(object, key)); }

std::vector<std::string> indexedTexts(const json& object, const char* key, std::size_t atMost) {
  std::vector<std::string> texts;
  const json& list = indexedField(object, key);
  if (!list.is_array()) return texts;
  for (const json& each : list)
    if (std::string text = indexable(each); !text.empty() && texts.size() < atMost) texts.push_back(std::move(text));
  return texts;
}

std::optional<int> indexedWhole(const json& object, const char* key, double lowest, double highest) {
  const auto found = numberWithin(indexedField(object, key), lowest, highest);
  if (!found || *found != static_cast<double>(static_cast<int>(*found))) return {};
  return static_cast<int>(*found);
}

/// Collects texts as they are and as the language of the index has them.
class SearchTexts {
 public:
  explicit SearchTexts(const CaseWords& words) : words_(words) {}
  void add(const std::string& text) {
    if (text.empty()) return;
    all_ += text + '\n';
    if (words_.has(text)) all_ += words_.of(text) + '\n';
  }
  void add(const std::vector<std::string>& texts) {
    for (const std::string& text : texts) add(text);
  }
  [[nodiscard]] std::string take() { return searchable(std::move(all_)); }

 private:
  const CaseWords& words_;
  std::string all_;
};

std::vector<std::string> translatedTags(std::vector<std::string> tags, const CaseWords& words) {
  for (std::string& tag : tags) tag = words.of(tag);
  std::sort(tags.begin(), tags.end());
  tags.erase(std::unique(tags.begin(), tags.end()), tags.end());
  return tags;
}

void readLessonRows(const json& manifest, const CaseWords& words, CaseRow& row, SearchTexts& open) {
  const json& lessons = indexedField(indexedField(indexedField(manifest, "parts"), "lessons"), "lessons");
  if (!lessons.is_array()) return;
  for (const json& each : lessons) {
    if (!each.is_object() || row.lessons.size() >= kMostIndexedLessons) continue;
    LessonRow lesson;
    lesson.id = indexedText(each, "id");
    const std::string title = indexedText(each, "title"), aim = indexedText(each, "aim");
    lesson.title = words.of(title);
    lesson.aim = words.of(aim);
    lesson.level = indexedWhole(each, "level", 1, 5).value_or(1);
    lesson.minutes = indexedWhole(each, "minutes", 0, 100000).value_or(0);
    const json& steps = indexedField(each, "steps");
    lesson.steps = steps.is_array() ? static_cast<int>(steps.size()) : 0;
    open.add(title);
    open.add(aim);
    open.add(indexedTexts(each, "tags", kMostIndexedTags));
    row.lessons.push_back(std::move(lesson));
  }
}

std::optional<int> indexedLevel(const json& manifest, const std::vector<LessonRow>& lessons) {
  if (const auto difficulty = indexedWhole(manifest, "difficulty", 1, 5)) return difficulty;
  const auto easiest =
      std::min_element(lessons.begin(), lessons.end(), [](const LessonRow& a, const LessonRow& b) { return a.level < b.level; });
  return easiest == lessons.end() ? std::optional<int>() : std::optional<int>(easiest->level);
}

std::string joinedTexts(const std::vector<std::string>& texts, const CaseWords& words) {
  std::string all;
  for (const std::string& text : texts)
    if (!text.empty()) all += (all.empty() ? "" : "\n") + words.of(text);
  return all;
}

std::optional<Message> indexProblem(const json& manifest, const fs::path& folder) {
  if (const json& format = indexedField(manifest, "format"); format.is_number() && format.get<double>() > kCaseFormat)
    return say<"The case in '%1' has format %2, and this program reads formats up to %3; install a newer version of EchoWeave.">(
        folder, format.dump(), kCaseFormat);
  for (const char* needed : {"id", "title"})
    if (indexedText(manifest, needed).empty())
      return say<"The case.json in '%1' has no '%2'; open the folder to see what else is missing.">(folder, std::string(needed));
  return {};
}

}  // namespace

IndexEntry readIndexEntry(const fs::path& folder, LibraryKind kind, int revision, const std::string& language) {
  IndexEntry entry;
  CaseRow& row = entry.row;
  row.folder = folder;
  row.kind = kind;
  row.revision = revision;
  const auto refuse = [&](Message why) {
    entry.problem = std::move(why);
    return entry;
  };
  const auto text = readTextFile(folder / kManifestName, kLargestIndexed_bytes);
  if (!text) return refuse(text.error().message);
  const auto manifest = parseJsonObject(*text, verbatim((folder / kManifestName).string()));
  if (!manifest) return refuse(manifest.error().message);
  if (auto problem = indexProblem(*manifest, folder)) return refuse(std::move(*problem));

  const CaseWords words = wordsOf(folder, language);
  SearchTexts open(words), closed(words);
  const std::string title = indexedText(*manifest, "title"), forTrainees = indexedText(*manifest, "title_for_trainees");
  const std::string region = indexedText(*manifest, "region"), indication = indexedText(*manifest, "indication");
  const std::vector<std::string> tags = indexedTexts(*manifest, "tags", kMostIndexedTags);
  row.id = indexedText(*manifest, "id");
  row.title = words.of(title);
  row.titleForTrainees = words.of(forTrainees.empty() ? title : forTrainees);
  row.region = words.of(region);
  row.indication = words.of(indication);
  row.tags = translatedTags(tags, words);
  for (const std::string& each : {forTrainees.empty() ? title : forTrainees, region, indication, indexedText(*manifest, "complaint"),
                                  indexedText(*manifest, "history")})
    open.add(each);
  open.add(tags);
  readLessonRows(*manifest, words, row, open);
  row.level = indexedLevel(*manifest, row.lessons);
  std::vector<std::string> pathology = indexedTexts(*manifest, "findings", 1000);
  pathology.insert(pathology.begin(), indexedText(*manifest, "diagnosis"));
  row.pathology = joinedTexts(pathology, words);
  for (const std::string& each : {title, row.id}) closed.add(each);
  closed.add(pathology);
  closed.add(indexedTexts(*manifest, "differential", 1000));
  entry.openText = open.take();
  entry.closedText = closed.take();
  return entry;
}

std::string searchable(std::string text) {
  for (const std::string_view sharp : {std::string_view("\u00df"), std::string_view("\u1e9e")})
    for (auto at = text.find(sharp); at != std::string::npos; at = text.find(sharp, at + 2)) text.replace(at, sharp.size(), "ss");
  return text;
}

std::string sortKey(const std::string& title) {
  // U+00C0 to U+00FF without their accents; nothing where a sign is no letter.
  constexpr std::string_view kBase = "aaaaaaaceeeeiiiidnooooo ouuuuyts";
  std::string key;
  for (std::size_t n = 0; n < title.size(); ++n) {
    const auto byte = static_cast<unsigned char>(title[n]);
    if (byte == 0xC3 && n + 1 < title.size()) {
      const auto next = static_cast<unsigned char>(title[n + 1]);
      if (next >= 0x80 && next <= 0xBF) {
        key += next == 0x9F ? "ss" : std::string(1, kBase[next & 0x1F]);
        ++n;
        continue;
      }
    }
    key += byte >= 'A' && byte <= 'Z' ? static_cast<char>(byte - 'A' + 'a') : title[n];
  }
  return key;
}

}  // namespace ew
