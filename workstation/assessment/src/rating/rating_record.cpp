#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>

#include "attempts/folder_lock.h"
#include "ew/assessment/rating.h"
#include "ew/core/output_set.h"
#include "ew/io/content_key.h"
#include "ew/io/json_files.h"
#include "ew/io/safe_file.h"
#include "ew/library/attempt.h"
#include "ew/library/lesson.h"
#include "rating/rating_ids.h"

namespace ew {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using Form = std::shared_ptr<const RatingForm>;

constexpr const char* kFormsFolder = "forms";
constexpr std::string_view kJsonEnding = ".json", kDraftEnding = "-draft.json";
constexpr std::size_t kRevisionDigits = 4;
constexpr int kHighestRevision = 9999;

fs::path ratingsFolder(const fs::path& attemptFolder) { return attemptFolder / "ratings"; }

std::string nameOfRevision(const std::string& formId, int revision) {
  std::array<char, 16> number{};
  std::snprintf(number.data(), number.size(), "-%04d", revision);
  return formId + number.data() + std::string(kJsonEnding);
}

/// Of "osaus-like-0002.json" with this form: 2. Nothing of other names.
std::optional<int> revisionOf(const std::string& name, const std::string& formId) {
  if (name.size() != formId.size() + 1 + kRevisionDigits + kJsonEnding.size() || !name.starts_with(formId + "-") ||
      !name.ends_with(kJsonEnding))
    return std::nullopt;
  const std::string digits = name.substr(formId.size() + 1, kRevisionDigits);
  if (digits.find_first_not_of("0123456789") != std::string::npos) return std::nullopt;
  return std::stoi(digits);
}

/// The entries of a folder, sorted; none when it is not there.
std::vector<fs::path> entriesOf(const fs::path& folder, std::vector<Error>& problems) {
  std::vector<fs::path> entries;
  std::error_code error;
  if (!fs::exists(folder, error)) return entries;
  fs::directory_iterator each(folder, error);
  for (; !error && each != fs::directory_iterator(); each.increment(error))
    if (!each->path().filename().string().starts_with('.')) entries.push_back(each->path());
  if (error)
    problems.push_back(
        {ErrorCode::notReadable,
         say<"The ratings in '%1' cannot be read (%2); check that you may read the folder.">(folder, verbatim(error.message())),
         {{"file", folder.string()}}});
  std::sort(entries.begin(), entries.end());
  return entries;
}

/// Reads the ratings of one attempt, each form once.
class RatingReader {
 public:
  RatingReader(const fs::path& attemptFolder, std::string attemptId) : ratings_(ratingsFolder(attemptFolder)) {
    found_.attemptId = std::move(attemptId);
  }

  RatingRecords all() {
    for (const fs::path& raterFolder : entriesOf(ratings_, found_.problems)) {
      std::error_code ignored;
      if (raterFolder.filename() == kFormsFolder || !fs::is_directory(raterFolder, ignored)) continue;
      for (const fs::path& file : entriesOf(raterFolder, found_.problems)) {
        if (file.extension() != kJsonEnding) continue;
        auto kept = read(file);
        if (kept)
          found_.ratings.push_back(std::move(*kept));
        else
          found_.problems.push_back({kept.error().code,
                                     say<"The rating '%1' is left out: %2">(file.filename(), kept.error().message),
                                     {{"file", file.string()}}});
      }
    }
    dropFinishedDrafts();
    std::sort(found_.ratings.begin(), found_.ratings.end(), [](const RatingRecord& a, const RatingRecord& b) {
      const bool draftA = !a.rating.finished, draftB = !b.rating.finished;
      return std::tie(a.rating.rater, a.rating.formId, draftA, a.rating.revision) <
             std::tie(b.rating.rater, b.rating.formId, draftB, b.rating.revision);
    });
    return std::move(found_);
  }

 private:
  Result<RatingRecord> read(const fs::path& file) {
    const Message where = verbatim(file.filename().string());
    const auto document = readJsonFile(file, where);
    if (!document) return passOn(document.error());
    auto rating = ratingFromJson(*document, where);
    if (!rating) return passOn(rating.error());
    const std::string name = file.filename().string();
    const bool named =
        rating->finished ? revisionOf(name, rating->formId) == rating->revision : name == rating->formId + std::string(kDraftEnding);
    if (!named || file.parent_path() != ratingFolder(ratings_.parent_path(), rating->rater))
      return failure(ErrorCode::badField, say<"its name is not that of what it holds; a copy of another rating counts for nothing.">());
    if (rating->attemptId != found_.attemptId)
      return failure(ErrorCode::badField, say<"it is of the attempt '%1'; move it to the folder of that attempt.">(rating->attemptId));
    const auto form = formOf(*rating);
    if (!form) return passOn(form.error());
    if (auto answers = checkRating(**form, *rating); !answers) return passOn(answers.error());
    return RatingRecord{std::move(*rating), *form};
  }

  Result<Form> formOf(const Rating& rating) {
    if (const auto known = forms_.find(rating.formContent); known != forms_.end()) return known->second;
    auto form = readRatingForm(ratings_ / kFormsFolder / (rating.formContent + std::string(kJsonEnding)));
    if (!form) return passOn(form.error());
    if (contentOf(*form) != rating.formContent || form->id != rating.formId || form->version != rating.formVersion)
      return failure(ErrorCode::badField,
                     say<"the form that was kept with it is not the one that was answered; restore the folder from a copy.">());
    return forms_[rating.formContent] = std::make_shared<const RatingForm>(std::move(*form));
  }

  /// A program that was killed between finishing and clearing up leaves a draft of what is a revision already.
  void dropFinishedDrafts() {
    const auto isFinished = [&](const RatingRecord& draft) {
      return !draft.rating.finished && std::any_of(found_.ratings.begin(), found_.ratings.end(), [&](const RatingRecord& each) {
        return each.rating.finished && each.rating.rater == draft.rating.rater && each.rating.formId == draft.rating.formId &&
               each.rating.revision >= draft.rating.revision;
      });
    };
    std::vector<RatingRecord> left;
    for (const RatingRecord& each : found_.ratings)
      if (!isFinished(each)) left.push_back(each);
    found_.ratings = std::move(left);
  }

  fs::path ratings_;
  std::map<std::string, Form> forms_;
  RatingRecords found_;
};

/// Above every file of this name, whatever it holds.
int nextRevision(const fs::path& folder, const std::string& formId) {
  int highest = 0;
  std::vector<Error> ignored;
  for (const fs::path& file : entriesOf(folder, ignored))
    highest = std::max(highest, revisionOf(file.filename().string(), formId).value_or(0));
  return highest + 1;
}

/// Whether anything of others was open to this rater.
bool couldSeeOthers(const std::string& rater, const fs::path& attemptFolder) {
  const auto visible = ratingsVisibleTo(rater, attemptFolder);
  return std::any_of(visible.ratings.begin(), visible.ratings.end(), [&](const RatingRecord& each) { return each.rating.rater != rater; });
}

Result<std::string> writtenOut(const json& document) {
  try {
    return document.dump(1) + "\n";
  } catch (const json::exception&) {
    return failure(ErrorCode::badField, say<"The rating has a text that is not UTF-8; write it again.">());
  }
}

/// The form as it is used, once for all ratings.
Result<void> keepForm(const fs::path& ratings, const RatingForm& form, const std::string& content) {
  const fs::path file = ratings / kFormsFolder / (content + std::string(kJsonEnding));
  const auto there = readRatingForm(file);
  if (there && contentOf(*there) == content) return {};
  std::error_code error;
  fs::create_directories(file.parent_path(), error);  // what is wrong the writing says
  const auto text = writtenOut(jsonOf(form));
  if (!text) return passOn(text.error());
  return writeFileSafely(file, *text);
}

}  // namespace

fs::path ratingFolder(const fs::path& attemptFolder, const std::string& rater) {
  constexpr std::size_t kLetters = 40, kDigits = 12;
  return ratingsFolder(attemptFolder) /
         (idFor(rater.substr(0, kLetters), {}, "rater") + "-" + ContentKey().add(rater).text().substr(0, kDigits));
}

Result<Rating> keepRating(const fs::path& attemptFolder, const RatingForm& form, Rating rating) {
  const auto attempt = AttemptFolder::open(attemptFolder);
  if (!attempt) return passOn(attempt.error());
  rating.attemptId = attempt->attempt().id;
  rating.formId = form.id;
  rating.formVersion = form.version;
  rating.formContent = contentOf(form);
  rating.revision = 1;
  if (auto answers = checkRating(form, rating); !answers) return passOn(answers.error());
  if (auto read = ratingFromJson(jsonOf(rating), say<"the rating">()); !read) return passOn(read.error());
  if (auto text = writtenOut(jsonOf(rating)); !text) return passOn(text.error());
  const auto lock = assessment::lockFolder(ratingsFolder(attemptFolder));
  if (!lock) return passOn(lock.error());
  const fs::path folder = ratingFolder(attemptFolder, rating.rater);
  rating.revision = nextRevision(folder, form.id);
  if (rating.revision > kHighestRevision)
    return failure(ErrorCode::tooLarge,
                   say<"There are %1 ratings of '%2' already; that is as many as are kept.">(kHighestRevision, rating.rater));
  rating.sawOthers = rating.sawOthers || couldSeeOthers(rating.rater, attemptFolder);
  if (auto kept = keepForm(ratingsFolder(attemptFolder), form, rating.formContent); !kept) return passOn(kept.error());
  std::error_code ignored;
  fs::create_directories(folder, ignored);  // what is wrong the writing says
  removeLeftovers(folder);
  const fs::path draft = folder / (form.id + std::string(kDraftEnding));
  const auto text = writtenOut(jsonOf(rating));
  if (!text) return passOn(text.error());
  const fs::path file = rating.finished ? folder / nameOfRevision(form.id, rating.revision) : draft;
  if (auto written = writeFileSafely(file, *text); !written) return passOn(written.error());
  if (rating.finished) fs::remove(draft, ignored);  // left behind it counts for nothing
  return rating;
}

RatingRecords everyRating(const fs::path& attemptFolder) {
  const auto attempt = AttemptFolder::open(attemptFolder);
  if (attempt) return RatingReader(attemptFolder, attempt->attempt().id).all();
  RatingRecords none;
  none.problems.push_back(attempt.error());
  return none;
}

RatingRecords ratingsVisibleTo(const std::string& rater, const fs::path& attemptFolder) {
  RatingRecords kept = everyRating(attemptFolder);
  std::set<std::string> finishedForms, hidden;
  for (const RatingRecord& each : kept.ratings)
    if (each.rating.finished && each.rating.rater == rater) finishedForms.insert(each.rating.formId);
  std::vector<RatingRecord> visible;
  for (RatingRecord& each : kept.ratings) {
    const bool own = each.rating.rater == rater;
    if (own || (each.rating.finished && finishedForms.contains(each.rating.formId)))
      visible.push_back(std::move(each));
    else if (each.rating.finished)
      hidden.insert(each.rating.rater);
  }
  kept.ratings = std::move(visible);
  kept.hiddenRaters = hidden.size();
  // A damaged file of another rater tells that they rated, and its sentence perhaps what.
  std::erase_if(kept.problems, [&](const Error& problem) {
    return std::any_of(problem.context.begin(), problem.context.end(), [&](const auto& each) {
      const fs::path folder = fs::path(each.second).parent_path();
      return each.first == "file" && folder.parent_path() == ratingsFolder(attemptFolder) && folder != ratingFolder(attemptFolder, rater);
    });
  });
  return kept;
}

}  // namespace ew
