#include "volumes/nrrd_time_axis.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace ew::detail {
namespace {

constexpr std::size_t kSpaceAndTime = 4;  // axes of a file in which one without spacing or direction must be that of time

bool isTimeUnit(std::string_view unit) {
  constexpr std::array<std::string_view, 23> names{"s",         "sec",     "second",      "seconds",      "secs",         "ms",
                                                   "msec",      "msecs",   "millisecond", "milliseconds", "us",           "\xC2\xB5s",
                                                   "\xCE\xBCs", "\xB5s",   "usec",        "microsecond",  "microseconds", "min",
                                                   "minute",    "minutes", "h",           "hour",         "hours"};
  return std::find(names.begin(), names.end(), lowerCase(trimmed(unit))) != names.end();
}

bool isLengthUnit(std::string_view unit) { return !trimmed(unit).empty() && lengthUnit_mm(unit).has_value(); }

/// What speaks for an axis being of time or not, as part of a sentence.
struct Hint {
  std::size_t axis = 0;
  Message says;
};

std::string kindOf(const ImageHeader& header, std::size_t axis) {
  return header.kinds.empty() ? std::string() : lowerCase(header.kinds[axis]);
}

/// Whether a kind leaves open what stands along its axis: a domain may be one of space or of time.
bool leavesOpen(std::string_view kind) { return kind.empty() || kind == "domain" || kind == "none" || kind == "???"; }

Hint byKind(const ImageHeader& header, std::size_t axis) {
  return {axis, say<"axis %1 has the kind \"%2\"">(axis + 1, shortened(header.kinds[axis]))};
}

Hint byUnit(const NrrdAxes& axes, std::size_t axis) {
  return {axis, say<"axis %1 has the unit \"%2\"">(axis + 1, shortened(axes.units[axis]))};
}

/// Whether a direction has no part in space: none, or one along time alone, the fourth number.
bool isOutsideSpace(const NrrdDirection& direction) {
  return !direction || (direction->size() == kSpaceAndTime &&
                        std::all_of(direction->begin(), direction->begin() + 3, [](double part) { return part == 0.0; }));
}

bool isFinite(const NrrdDirection& direction) {
  return !isOutsideSpace(direction) && std::all_of(direction->begin(), direction->end(), [](double part) { return std::isfinite(part); });
}

/// The one axis of four that has no spacing or no direction while all others have.
std::optional<Hint> byGap(const NrrdAxes& axes, std::size_t count) {
  if (count != kSpaceAndTime) return std::nullopt;
  std::vector<std::size_t> gaps;
  if (axes.directions) {
    for (std::size_t axis = 0; axis < count; ++axis)
      if (!isFinite((*axes.directions)[axis])) gaps.push_back(axis);
    if (gaps.size() != 1 || !isOutsideSpace((*axes.directions)[gaps.front()])) return std::nullopt;
    return Hint{gaps.front(), say<"axis %1 alone has no direction in space">(gaps.front() + 1)};
  }
  if (axes.spacings.size() != count) return std::nullopt;
  for (std::size_t axis = 0; axis < count; ++axis)
    if (!std::isfinite(axes.spacings[axis])) gaps.push_back(axis);
  if (gaps.size() != 1) return std::nullopt;
  return Hint{gaps.front(), say<"axis %1 alone has no spacing">(gaps.front() + 1)};
}

tl::unexpected<Error> contradiction(const ImageHeader& header, const Hint& time, const Hint& other) {
  return failure(ErrorCode::badField,
                 say<"Two hints of %1 at its axis of time contradict each other: %2, but %3; correct the header or export the file again.">(
                     quoted(header.file), time.says, other.says),
                 {{"file", header.file.string()}, {"hint", time.says.english()}, {"other", other.says.english()}});
}

/// What says that the axis of `time` is none of time; empty: nothing.
std::optional<Hint> objectionTo(const ImageHeader& header, const NrrdAxes& axes, const Hint& time) {
  const std::string kind = kindOf(header, time.axis);
  if (kind != "time" && kind != "list" && !leavesOpen(kind)) return byKind(header, time.axis);
  // Along a list may stand whatever was recorded one after the other, also at places.
  if (kind != "list" && !axes.units.empty() && isLengthUnit(axes.units[time.axis])) return byUnit(axes, time.axis);
  return std::nullopt;
}

}  // namespace

Result<std::optional<std::size_t>> settleTimeAxis(ImageHeader& header, const NrrdAxes& axes) {
  const std::size_t count = header.sizes.size();
  std::vector<Hint> hints;
  std::optional<std::size_t> inTime;
  for (std::size_t axis = 0; axis < count && !axes.units.empty(); ++axis)
    if (isTimeUnit(axes.units[axis])) {
      hints.push_back(byUnit(axes, axis));
      if (!inTime) inTime = axis;
    }
  // An axis of colours or components has neither spacing nor direction, and its kind says why.
  if (const auto gap = byGap(axes, count)) {
    const std::string kind = kindOf(header, gap->axis);
    if (leavesOpen(kind) || kind == "space" || kind == "time" || kind == "list") hints.push_back(*gap);
  }
  const bool byKindAlone = hints.empty();
  for (std::size_t axis = 0; axis < header.kinds.size(); ++axis) {
    const std::string kind = kindOf(header, axis);
    if (kind == "time" || (kind == "list" && !byKindAlone)) hints.push_back(byKind(header, axis));
  }
  for (const Hint& hint : hints)
    if (const auto objection = objectionTo(header, axes, hint)) return contradiction(header, hint, *objection);
  if (byKindAlone) return inTime;
  for (const Hint& hint : hints)
    if (hint.axis != hints.front().axis) return contradiction(header, hints.front(), hint);
  if (header.kinds.empty()) header.kinds.assign(count, "domain");
  for (std::size_t axis = 0; axis < count; ++axis) {
    const std::string kind = kindOf(header, axis);
    if (axis == hints.front().axis)
      header.kinds[axis] = kind == "list" ? "list" : "time";
    else if (count == kSpaceAndTime && leavesOpen(kind))
      header.kinds[axis] = "domain";  // with time found, the other three are those of space
  }
  return inTime;
}

}  // namespace ew::detail
