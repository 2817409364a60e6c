#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ew/core/result.h"
#include "ew/measurement/caliper.h"
#include "ew/measurement/measurement_list.h"
#include "ew/measurement/package.h"
#include "ew/measurement/worksheet.h"

namespace ew::measurement {

/// What an examination has found so far for the items of one package: values from the calipers of its images, and answers. An image may
/// go; what was measured in it stays. Not for several threads at once.
class Examination {
 public:
  struct Found {
    std::uint64_t image = 0;
    int number = 0;  ///< of the measurement in its image
    WorksheetEntry entry;
    bool operator==(const Found&) const = default;
  };
  struct Answer {
    std::string label;
    std::string side;
    std::string choice;
    bool operator==(const Answer&) const = default;
  };

  /// @param package not null
  explicit Examination(std::shared_ptr<const Package> package);
  [[nodiscard]] const Package& package() const { return *package_; }

  /// What the calipers of an image give now takes the place of what they gave before; measurements of no item of this package are left
  /// out. @return one sentence for each measurement that gives nothing its item needs (a distance for a circumference), or a value that
  /// cannot be true; those are left out as well
  std::vector<Message> measuredIn(std::uint64_t image, const Measurements& measurements, const UncertaintyAt& at);
  /// In the order they were first measured.
  [[nodiscard]] const std::vector<Found>& found() const { return found_; }
  /// Of an item; of a sided one those of the side.
  [[nodiscard]] std::vector<Quantity> of(std::string_view label, std::string_view side) const;
  /// False when there is none such.
  bool remove(std::uint64_t image, int number);

  /// @param choice a word of the item; empty: the answer is taken back. False when the package has no such item, side or choice
  bool answer(const std::string& label, const std::string& side, const std::string& choice);
  [[nodiscard]] const std::vector<Answer>& answers() const { return answers_; }

  /// By dates, 0 to 45 weeks; anything else is not taken. False then.
  bool setGestation(std::optional<double> weeks);
  [[nodiscard]] std::optional<double> gestation_weeks() const { return gestation_weeks_; }

  [[nodiscard]] bool isEmpty() const { return found_.empty() && answers_.empty(); }
  [[nodiscard]] Worksheet worksheet() const;
  bool operator==(const Examination&) const;

 private:
  std::shared_ptr<const Package> package_;
  std::vector<Found> found_;
  std::vector<Answer> answers_;
  std::optional<double> gestation_weeks_;
};

}  // namespace ew::measurement
