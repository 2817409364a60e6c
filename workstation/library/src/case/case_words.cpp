#include "ew/library/case_words.h"

#include <set>

#include "ew/core/json_fields.h"
#include "ew/core/message.h"
#include "ew/io/json_files.h"
#include "ew/io/safe_file.h"

namespace ew {
namespace {

namespace fs = std::filesystem;

constexpr int kWordsFormat = 1;
constexpr std::size_t kLargestWords_bytes = 8u << 20;

/// Visits every text of a case, as something that may be changed.
template <class Visit>
void visitTexts(Case& shown, Visit visit) {
  for (std::string* text :
       {&shown.title, &shown.titleForTrainees, &shown.region, &shown.complaint, &shown.history, &shown.indication, &shown.diagnosis})
    visit(*text);
  for (CaseExamination& each : shown.previousExaminations)
    for (std::string* text : {&each.when, &each.kind, &each.findings}) visit(*text);
  for (CaseLaboratory& each : shown.laboratory)
    for (std::string* text : {&each.when, &each.findings}) visit(*text);
  for (auto* list : {&shown.findings, &shown.differential, &shown.tags})
    for (std::string& text : *list) visit(text);
}

template <class Visit>
void visitTexts(LessonStep& step, Visit visit) {
  for (std::string* text : {&step.title, &step.text, &step.lookFor, &step.after}) visit(*text);
  for (std::string& hint : step.hints) visit(hint);
  if (auto* watch = std::get_if<WatchTask>(&step.task))
    for (ExpertMark& mark : watch->marks) visit(mark.text);
  if (auto* answer = std::get_if<AnswerTask>(&step.task))
    for (AnswerOption& option : answer->options) {
      visit(option.text);
      visit(option.why);
    }
}

template <class Visit>
void visitTexts(Lesson& shown, Visit visit) {
  for (std::string* text : {&shown.title, &shown.aim}) visit(*text);
  for (std::string& tag : shown.tags) visit(tag);
  for (LessonStep& step : shown.steps) visitTexts(step, visit);
}

}  // namespace

const std::string& CaseWords::of(const std::string& text) const {
  const auto found = words_.find(text);
  return found == words_.end() ? text : found->second;
}

Result<CaseWords> readCaseWords(const fs::path& file) {
  const Message where = verbatim(file.filename().string());
  auto document = readJsonFile(file, where, kLargestWords_bytes);
  if (!document) return passOn(document.error());
  JsonReading reading(where);
  const JsonFields fields(*document, reading);
  const auto format = fields.whole("format", 1, 1'000'000);
  if (reading.good() && format > kWordsFormat)
    return failure(ErrorCode::newerFormat,
                   say<"%1 has format %2, and this program reads formats up to %3; open it with a newer EchoWeave.">(
                       where, std::to_string(format), kWordsFormat),
                   {{"field", "format"}});
  std::unordered_map<std::string, std::string> words;
  const JsonFields entries = fields.object("words");
  for (const auto& [from, to] : entries.value().items()) {
    if (!to.is_string())
      entries.refuse(from, say<"text">());
    else if (!to.get_ref<const std::string&>().empty())
      words[from] = to.get<std::string>();
  }
  if (reading.problem()) return passOn(*reading.problem());
  return CaseWords(std::move(words));
}

Result<void> setCaseWord(const fs::path& caseFolder, const std::string& language, const std::string& text, const std::string& translation) {
  constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_-";
  if (language.empty() || language.find_first_not_of(kLetters) != std::string::npos)
    return failure(ErrorCode::badUsage, say<"'%1' is not a language such as \"de\".">(language));
  const fs::path file = caseFolder / "words" / (language + ".json");
  nlohmann::json document = {{"format", kWordsFormat}, {"words", nlohmann::json::object()}};
  std::error_code problem;
  if (fs::exists(file, problem)) {
    if (auto known = readCaseWords(file); !known) return passOn(known.error());  // what cannot be read is not written over
    auto there = readTextFile(file, kLargestWords_bytes);
    if (!there) return passOn(there.error());
    auto parsed = parseJsonObject(*there, verbatim(file.filename().string()));
    if (!parsed) return passOn(parsed.error());
    document = std::move(*parsed);
  }
  if (translation.empty())
    document["words"].erase(text);
  else
    document["words"][text] = translation;
  fs::create_directories(file.parent_path(), problem);  // writing says what is wrong when this did not help
  return writeFileSafely(file, document.dump(2) + "\n");
}

CaseWords wordsOf(const fs::path& caseFolder, const std::string& language) {
  const std::string alone = language.substr(0, language.find_first_of("_-"));
  for (const std::string& name : {language, alone}) {
    if (name.empty() || name.find('/') != std::string::npos) continue;
    if (auto words = readCaseWords(caseFolder / "words" / (name + ".json"))) return std::move(*words);
  }
  return {};
}

Case translated(Case shown, const CaseWords& words) {
  if (!words.empty()) visitTexts(shown, [&](std::string& text) { text = words.of(text); });
  return shown;
}

Lesson translated(Lesson shown, const CaseWords& words) {
  if (!words.empty()) visitTexts(shown, [&](std::string& text) { text = words.of(text); });
  return shown;
}

std::vector<std::string> textsOf(const Case& shown, const std::vector<Lesson>& lessons) {
  std::vector<std::string> texts;
  std::set<std::string> seen;
  const auto keep = [&](const std::string& text) {
    if (!text.empty() && seen.insert(text).second) texts.push_back(text);
  };
  Case of = shown;
  visitTexts(of, keep);
  for (const CaseTarget& target : shown.targets) keep(target.name);
  for (const CaseMeasurement& measurement : shown.measurements) keep(measurement.name);
  for (Lesson lesson : lessons) visitTexts(lesson, keep);
  return texts;
}

}  // namespace ew
