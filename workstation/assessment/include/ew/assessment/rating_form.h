#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "ew/core/data_file.h"
#include "ew/core/result.h"

namespace ew {

inline constexpr int kRatingFormFormat = 1;  ///< `format` of a rating form; a file with a larger one is refused with newerFormat

/// What one score of an item looks like in a trainee.
struct RatingAnchor {
  int score = 0;
  Words text;
  bool operator==(const RatingAnchor&) const = default;
};

/// One question that a rater answers with a score.
struct RatingItem {
  std::string id;  ///< "image-optimisation", unique in its form
  Words title;
  Words description;                  ///< what is looked at
  std::vector<RatingAnchor> anchors;  ///< by rising score; the lowest and the highest score have one, those between may
  double weight = 1.0;                ///< in the total, against the other items, > 0
  bool mayBeNotApplicable = false;    ///< a rater may leave it out of the total: nothing was to be seen of it
  bool operator==(const RatingItem&) const = default;
};

/// The least total that passes one kind of examination.
struct RatingPassLevel {
  std::string id;  ///< "transabdominal-biometry", unique in its form
  Words title;     ///< the examination it is for
  double total = 0.0;
  std::string source;  ///< who set it, and how
  bool operator==(const RatingPassLevel&) const = default;
};

/// Questions for people who judge an attempt: resources/rating_forms/*.json and a school's own in LIBRARY/rating_forms,
/// resources/schemas/rating-form.schema.json.
struct RatingForm {
  std::string id;   ///< small letters, digits and '-'
  int version = 1;  ///< from 1; rises when a score means something else
  Words title;
  std::string source;  ///< where the items and the scale come from
  Words validity;      ///< what is known of its use, and what is not
  int lowest = 1;      ///< score
  int highest = 5;     ///< score, above `lowest`
  std::vector<RatingItem> items;
  std::vector<RatingPassLevel> passLevels;  ///< none: the form gives a total and no verdict
  bool operator==(const RatingForm&) const = default;

  /// Null when there is none of that id.
  [[nodiscard]] const RatingItem* itemOf(std::string_view itemId) const;
  /// Of an empty id: the only one, when there is one. Null: no verdict can be given.
  [[nodiscard]] const RatingPassLevel* passLevelOf(std::string_view levelId) const;
};

/// @param where how sentences name the document
/// @error badField (also ids that are twice, anchors beyond the scale, out of order or missing at its ends, a pass level beyond it),
///        newerFormat
[[nodiscard]] Result<RatingForm> ratingFormFromJson(const nlohmann::json& document, const Message& where);
/// Every field, also those with usual values. ratingFormFromJson(jsonOf(f)) == f.
[[nodiscard]] nlohmann::json jsonOf(const RatingForm& form);
/// @error notFound, notReadable, tooLarge (above 4 MiB), badHeader (not JSON), otherwise as ratingFormFromJson
[[nodiscard]] Result<RatingForm> readRatingForm(const std::filesystem::path& file);

/// The name of everything that a rater reads and that counts (content_key.h): the same for a file that is only laid out otherwise.
[[nodiscard]] std::string contentOf(const RatingForm& form);

/// LIBRARY/rating_forms: a school's own forms, a .json file each.
[[nodiscard]] std::filesystem::path ratingFormFolder(const std::filesystem::path& library);

struct RatingFormList {
  std::vector<RatingForm> forms;  ///< by id, of each the highest version first
  std::vector<Error> problems;    ///< of files that are left out, each with its name
  /// @param version 0: the highest. Null when there is none
  [[nodiscard]] const RatingForm* find(std::string_view id, int version = 0) const;
};
/// The shipped forms and the school's. A file whose form has the id and version of another one is left out, and `problems` says so; the
/// shipped one stays. A library without a folder for forms has none.
[[nodiscard]] RatingFormList listRatingForms(const std::filesystem::path& resources, const std::filesystem::path& library);

}  // namespace ew
