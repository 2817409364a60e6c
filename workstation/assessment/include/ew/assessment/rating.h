#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ew/assessment/rating_form.h"
#include "ew/core/result.h"

namespace ew {

inline constexpr int kRatingFormat = 1;  ///< `format` of a rating; a file with a larger one is refused with newerFormat

/// What a rater says to one item of the form.
struct ItemRating {
  std::string item;          ///< id in the form
  std::optional<int> score;  ///< within the form's scale; nothing: not applicable, or not answered yet
  std::string remark;        ///< at most 20,000 bytes
  bool isOpen = false;       ///< of a draft: not answered yet, and something was remarked already
  bool operator==(const ItemRating&) const = default;
};

/// One rater's rating of one attempt.
struct Rating {
  std::string rater;              ///< as they call themselves, 1 to 200 bytes on one line
  std::string passLevel;          ///< id in the form; empty: its only one, else no verdict
  std::vector<ItemRating> items;  ///< each item at most once; one that is not there, or open, was not answered
  std::string remark;             ///< on the whole, at most 20,000 bytes
  bool sawName = false;           ///< the rater knew whose attempt it is
  bool sawOthers = false;         ///< the rater could have seen others' ratings of this attempt; kept true by keepRating
  std::chrono::sys_seconds at{};  ///< when it was given
  bool finished = false;          ///< false: a draft, which counts for nothing
  // What keepRating fills in.
  std::string attemptId;
  std::string formId;
  int formVersion = 1;
  std::string formContent;  ///< contentOf(form)
  int revision = 1;         ///< from 1, of this rater with this form; a draft has the one that it will be
  bool operator==(const Rating&) const = default;

  /// Whether neither name nor others' ratings were seen.
  [[nodiscard]] bool isBlinded() const { return !sawName && !sawOthers; }
  [[nodiscard]] const ItemRating* itemOf(std::string_view itemId) const;  ///< null when nothing was said to it
};

/// Weighted mean of the items that have a score; nothing when none has.
[[nodiscard]] std::optional<double> totalOf(const RatingForm& form, const Rating& rating);
/// Whether a finished rating reaches its pass level (to 1e-9, since a mean is rounded). Nothing for a draft, without a total, and where the
/// form has no level for it.
[[nodiscard]] std::optional<bool> passedBy(const RatingForm& form, const Rating& rating);

/// Whether a rating answers this form: its items and pass level are there, scores lie within the scale, "not applicable" only where it may
/// be; finished, every item is answered, and one at least has a score. @error badField
[[nodiscard]] Result<void> checkRating(const RatingForm& form, const Rating& rating);

/// @param where how sentences name the document @error badField, newerFormat
[[nodiscard]] Result<Rating> ratingFromJson(const nlohmann::json& document, const Message& where);
/// ratingFromJson(jsonOf(r)) == r.
[[nodiscard]] nlohmann::json jsonOf(const Rating& rating);

// Ratings lie in the attempt's folder (attempt.h):
//   ratings/RATER/FORM-0001.json, -0002 …  what this rater finished, each written whole or not at all and never changed again
//   ratings/RATER/FORM-draft.json          what they are at
//   ratings/forms/CONTENT.json             the forms as they were used: a total can be worked out though the school's form has changed
// RATER has letters that every file system takes and is another one for every rater.

[[nodiscard]] std::filesystem::path ratingFolder(const std::filesystem::path& attemptFolder, const std::string& rater);

/// Keeps a rating of the attempt in a folder. A finished one becomes the next revision and leaves the earlier ones as they are; a draft
/// takes the place of the draft. sawOthers is set when this rater could have seen another's rating before (ratingsVisibleTo).
/// @return the rating as it was kept
/// @error as checkRating and AttemptFolder::open; badField (texts that are not UTF-8, too long, or a name with blanks at its ends),
///        notWritable. Then everything is as it was, but for a folder
[[nodiscard]] Result<Rating> keepRating(const std::filesystem::path& attemptFolder, const RatingForm& form, Rating rating);

struct RatingRecord {
  Rating rating;
  std::shared_ptr<const RatingForm> form;  ///< as it was when the rating was given; never null
};

struct RatingRecords {
  std::string attemptId;              ///< empty when the attempt cannot be read
  std::vector<RatingRecord> ratings;  ///< by rater, form and revision, a draft last
  std::vector<Error> problems;        ///< of files that are left out: each names its file
  std::size_t hiddenRaters = 0;       ///< of ratingsVisibleTo: others who have finished a rating that is not shown
};
/// All ratings of an attempt with all revisions, drafts of everybody among them: for statistics and reports, never for somebody who rates.
/// Left out are files that are damaged, belong to another attempt or do not answer their form, and drafts that were finished since.
[[nodiscard]] RatingRecords everyRating(const std::filesystem::path& attemptFolder);

/// What a rater may see: everything of their own; others' finished ratings with a form once they have finished theirs with this form (of
/// whatever version); others' drafts never.
[[nodiscard]] RatingRecords ratingsVisibleTo(const std::string& rater, const std::filesystem::path& attemptFolder);

}  // namespace ew
