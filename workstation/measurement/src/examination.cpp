#include "ew/measurement/examination.h"

#include <algorithm>
#include <utility>

#include "ew/core/contract.h"
#include "ew/measurement/list_entries.h"

namespace ew::measurement {

Examination::Examination(std::shared_ptr<const Package> package) : package_(std::move(package)) { EW_EXPECTS(package_ != nullptr); }

std::vector<Message> Examination::measuredIn(std::uint64_t image, const Measurements& measurements, const UncertaintyAt& at) {
  std::vector<Message> remarks;
  std::vector<Found> now;
  for (const Measurement& each : measurements.all) {
    auto entry = entryOf(each, *package_, at);
    if (!entry) {
      remarks.push_back(entry.error().message);
      continue;
    }
    if (!*entry) continue;
    // What a worksheet would refuse must not keep the others from being shown.
    if (const auto alone = fillWorksheet(*package_, {{**entry}, Several::mean, {}}); !alone)
      remarks.push_back(alone.error().message);
    else
      now.push_back({image, each.number, std::move(**entry)});
  }
  std::erase_if(found_, [&](const Found& before) {
    return before.image == image && std::none_of(now.begin(), now.end(), [&](const Found& each) { return each.number == before.number; });
  });
  for (Found& each : now) {
    const auto known =
        std::find_if(found_.begin(), found_.end(), [&](const Found& f) { return f.image == image && f.number == each.number; });
    if (known != found_.end())
      *known = std::move(each);
    else
      found_.push_back(std::move(each));
  }
  return remarks;
}

std::vector<Quantity> Examination::of(std::string_view label, std::string_view side) const {
  std::vector<Quantity> values;
  for (const Found& each : found_)
    if (each.entry.label == label && each.entry.side == side) values.push_back(each.entry.quantity);
  return values;
}

bool Examination::remove(std::uint64_t image, int number) {
  return std::erase_if(found_, [&](const Found& each) { return each.image == image && each.number == number; }) > 0;
}

bool Examination::answer(const std::string& label, const std::string& side, const std::string& choice) {
  const PackageItem* item = package_->item(label);
  if (item == nullptr || item->measure != ItemMeasure::choice) return false;
  if (item->isSided ? side != "right" && side != "left" : !side.empty()) return false;
  const bool isWord = std::any_of(item->choices.begin(), item->choices.end(), [&](const auto& each) { return each.first == choice; });
  if (!isWord && !choice.empty()) return false;
  std::erase_if(answers_, [&](const Answer& each) { return each.label == label && each.side == side; });
  if (isWord) answers_.push_back({label, side, choice});
  return true;
}

bool Examination::setGestation(std::optional<double> weeks) {
  constexpr double kLongest_weeks = 45.0;
  if (weeks && !(*weeks >= 0.0 && *weeks <= kLongest_weeks)) return false;
  gestation_weeks_ = weeks;
  return true;
}

Worksheet Examination::worksheet() const {
  WorksheetInput input;
  input.gestation_weeks = gestation_weeks_;
  for (const Found& each : found_) input.entries.push_back(each.entry);
  for (const Answer& each : answers_) input.entries.push_back({each.label, each.side, {}, each.choice, false});
  auto filled = fillWorksheet(*package_, input);
  EW_EXPECTS(filled.has_value());  // each entry was taken alone already
  return filled ? std::move(*filled) : Worksheet{};
}

bool Examination::operator==(const Examination& other) const {
  return *package_ == *other.package_ && found_ == other.found_ && answers_ == other.answers_ && gestation_weeks_ == other.gestation_weeks_;
}

}  // namespace ew::measurement
