#pragma once

#include <string>
#include <utility>
#include <vector>

#include "ew/assessment/rating.h"

namespace ew::test {

inline constexpr std::chrono::sys_seconds kRatedAt{std::chrono::seconds(1'790'000'000)};

/// Three items, a scale from 1 to 5, weights 1, 2 and 1; the last item may be not applicable. Passed from 3.
inline RatingForm smallForm() {
  const auto item = [](std::string id, double weight, bool mayBeNotApplicable) {
    const std::vector<RatingAnchor> anchors = {{1, {"poor", "schlecht"}}, {3, {"fair", "mittel"}}, {5, {"good", "gut"}}};
    return RatingItem{id, {"Title of " + id, "Titel"}, {"What is looked at", "Was angesehen wird"}, anchors, weight, mayBeNotApplicable};
  };
  RatingForm form;
  form.id = "small";
  form.version = 2;
  form.title = {"Small form", "Kleiner Bogen"};
  form.source = "Made for tests";
  form.validity = {"None", "Keine"};
  form.items = {item("image", 1.0, false), item("order", 2.0, false), item("report", 1.0, true)};
  form.passLevels = {{"usual", {"Any examination", "Jede Untersuchung"}, 3.0, "Made for tests"}};
  return form;
}

/// @param scores in the order of the form's items; 0: not applicable. Items beyond them are not answered
inline Rating ratingOf(const RatingForm& form, const std::string& rater, const std::vector<int>& scores, bool finished = true) {
  Rating rating;
  rating.rater = rater;
  for (std::size_t n = 0; n < scores.size(); ++n)
    rating.items.push_back({form.items[n].id, scores[n] == 0 ? std::nullopt : std::optional(scores[n]), {}});
  rating.at = kRatedAt;
  rating.finished = finished;
  return rating;
}

}  // namespace ew::test
