#include "dicom/dicom_fields.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>

#include "ew/core/figures.h"
#include "ew/core/numbers.h"
#include "files/header_fields.h"
#include "files/image_header.h"

namespace ew {

namespace {

Message kindOf(const UltrasoundRegion& region) {
  if (region.dataType == 13) return say<"grey bar">();
  if (region.dataType == 14) return say<"colour bar">();
  switch (region.spatialFormat) {
    case 1:
      if (region.dataType == 1) return say<"tissue">();
      return region.dataType == 2 ? say<"colour flow">() : say<"two-dimensional, neither tissue nor flow">();
    case 2:
      return say<"M-mode">();
    case 3:
      return say<"spectrum">();
    case 4:
      return say<"curve">();
    default:
      return say<"another kind of image">();
  }
}

}  // namespace

Message UltrasoundRegion::describe(std::size_t number) const {
  const Message kind = kindOf(*this);
  const Message told = unitsX == 3 && unitsY == 3
                           ? say<"%1: %2, %3 x %4 pixels at (%5, %6), %7 x %8 mm a pixel">(
                                 number, kind, rect.width, rect.height, rect.x, rect.y, figureText(pixel_mm().x), figureText(pixel_mm().y))
                           : say<"%1: %2, %3 x %4 pixels at (%5, %6)">(number, kind, rect.width, rect.height, rect.x, rect.y);
  return problem.empty() ? told : say<"%1 (%2)">(told, problem);
}

namespace detail {
namespace {

struct Name {
  DicomTag tag;
  const char* name;
};
/// What names or dates a patient, a person, a place, a device or a study (after PS3.15, table E.1-1).
constexpr std::array kIdentifying{
    Name{0x00080014u, "Instance Creator UID"},
    Name{0x00080018u, "SOP Instance UID"},
    Name{0x00080012u, "Instance Creation Date"},
    Name{0x00080013u, "Instance Creation Time"},
    Name{0x00080020u, "Study Date"},
    Name{0x00080021u, "Series Date"},
    Name{0x00080022u, "Acquisition Date"},
    Name{0x00080023u, "Content Date"},
    Name{0x0008002Au, "Acquisition DateTime"},
    Name{0x00080030u, "Study Time"},
    Name{0x00080031u, "Series Time"},
    Name{0x00080032u, "Acquisition Time"},
    Name{0x00080033u, "Content Time"},
    Name{0x00080050u, "Accession Number"},
    Name{0x00080080u, "Institution Name"},
    Name{0x00080081u, "Institution Address"},
    Name{0x00080090u, "Referring Physician's Name"},
    Name{0x00080092u, "Referring Physician's Address"},
    Name{0x00080094u, "Referring Physician's Telephone Numbers"},
    Name{0x00081010u, "Station Name"},
    Name{0x00081030u, "Study Description"},
    Name{0x0008103Eu, "Series Description"},
    Name{0x00081040u, "Institutional Department Name"},
    Name{0x00081048u, "Physician(s) of Record"},
    Name{0x00081050u, "Performing Physician's Name"},
    Name{0x00081060u, "Name of Physician(s) Reading Study"},
    Name{0x00081070u, "Operators' Name"},
    Name{0x00081080u, "Admitting Diagnoses Description"},
    Name{0x00082111u, "Derivation Description"},
    Name{0x00084000u, "Identifying Comments"},
    Name{0x00100010u, "Patient's Name"},
    Name{0x00100020u, "Patient ID"},
    Name{0x00100021u, "Issuer of Patient ID"},
    Name{0x00100030u, "Patient's Birth Date"},
    Name{0x00100032u, "Patient's Birth Time"},
    Name{0x00100040u, "Patient's Sex"},
    Name{0x00101000u, "Other Patient IDs"},
    Name{0x00101001u, "Other Patient Names"},
    Name{0x00101010u, "Patient's Age"},
    Name{0x00101020u, "Patient's Size"},
    Name{0x00101030u, "Patient's Weight"},
    Name{0x00101040u, "Patient's Address"},
    Name{0x00102154u, "Patient's Telephone Numbers"},
    Name{0x00102160u, "Ethnic Group"},
    Name{0x00102180u, "Occupation"},
    Name{0x001021B0u, "Additional Patient History"},
    Name{0x001021C0u, "Pregnancy Status"},
    Name{0x001021D0u, "Last Menstrual Date"},
    Name{0x00104000u, "Patient Comments"},
    Name{0x00181000u, "Device Serial Number"},
    Name{0x00181030u, "Protocol Name"},
    Name{0x00184000u, "Acquisition Comments"},
    Name{0x0020000Du, "Study Instance UID"},
    Name{0x0020000Eu, "Series Instance UID"},
    Name{0x00200010u, "Study ID"},
    Name{0x00200052u, "Frame of Reference UID"},
    Name{0x00209312u, "Volume Frame of Reference UID"},
    Name{0x00204000u, "Image Comments"},
    Name{0x00321032u, "Requesting Physician"},
    Name{0x00321060u, "Requested Procedure Description"},
    Name{0x00380010u, "Admission ID"},
    Name{0x00400244u, "Performed Procedure Step Start Date"},
    Name{0x00400245u, "Performed Procedure Step Start Time"},
    Name{0x00400253u, "Performed Procedure Step ID"},
    Name{0x00400254u, "Performed Procedure Step Description"},
};

void collect(const DicomItem& item, Removed& removed) {
  for (const DicomElement& element : item.elements) {
    const std::uint32_t group = element.tag >> 16;
    if (group % 2 == 1) {
      ++removed.privateFields;
      continue;
    }
    const bool empty = element.value.empty() && element.items.empty();
    const auto* const known =
        std::find_if(kIdentifying.begin(), kIdentifying.end(), [&](const Name& name) { return name.tag == element.tag; });
    if (!empty && (known != kIdentifying.end() || group == 0x0010u)) {
      std::array<char, 16> tag{};
      std::snprintf(tag.data(), tag.size(), "(%04X,%04X)", group, element.tag & 0xFFFFu);
      Message name = joined({verbatim(tag.data()), known != kIdentifying.end() ? verbatim(known->name) : say<"patient field">()});
      if (std::find(removed.fields.begin(), removed.fields.end(), name) == removed.fields.end()) removed.fields.push_back(std::move(name));
    }
    for (const DicomItem& inside : element.items) collect(inside, removed);
  }
}

bool reachesBeyond(const PixelRect& rect, std::uint64_t columns, std::uint64_t rows) {
  return static_cast<std::uint64_t>(rect.x) + static_cast<std::uint64_t>(rect.width) > columns ||
         static_cast<std::uint64_t>(rect.y) + static_cast<std::uint64_t>(rect.height) > rows;
}

Message problemOf(const UltrasoundRegion& region, bool placed, std::uint64_t columns, std::uint64_t rows) {
  if (!placed) return say<"its corners are missing or crossed">();
  if (region.stale) return say<"it reaches beyond the image of %1 x %2 pixels, so that it was made for another size">(columns, rows);
  if (region.spatialFormat != 1) return say<"it is no two-dimensional image">();
  if (region.unitsX != 3 || region.unitsY != 3) return say<"its units are not cm">();
  const auto usable = [](double delta) { return std::isfinite(delta) && delta > 1e-6 && delta < 10.0; };
  if (!usable(region.deltaX) || !usable(region.deltaY)) return say<"it gives no size of a pixel">();
  return {};
}

}  // namespace

Removed identifyingFields(const DicomItem& data) {
  Removed removed;
  collect(data, removed);
  return removed;
}

std::vector<UltrasoundRegion> regionsOf(const DicomItem& data, std::uint64_t columns, std::uint64_t rows) {
  std::vector<UltrasoundRegion> regions;
  for (const DicomItem& item : data.items(0x00186011u)) {
    UltrasoundRegion region;
    const auto whole = [&](DicomTag tag) { return item.count(tag).value_or(0); };
    region.spatialFormat = static_cast<int>(std::min<std::uint64_t>(whole(0x00186012u), 999));
    region.dataType = static_cast<int>(std::min<std::uint64_t>(whole(0x00186014u), 999));
    region.flags = static_cast<std::uint32_t>(whole(0x00186016u));
    region.unitsX = static_cast<int>(std::min<std::uint64_t>(whole(0x00186024u), 999));
    region.unitsY = static_cast<int>(std::min<std::uint64_t>(whole(0x00186026u), 999));
    // A minus says which way the region counts its own mm, not that a pixel is smaller than nothing.
    region.deltaX = std::abs(item.number(0x0018602Cu).value_or(0.0));
    region.deltaY = std::abs(item.number(0x0018602Eu).value_or(0.0));
    const auto x0 = item.count(0x00186018u), y0 = item.count(0x0018601Au), x1 = item.count(0x0018601Cu), y1 = item.count(0x0018601Eu);
    constexpr std::uint64_t largest = 1u << 20;
    const bool placed = x0 && y0 && x1 && y1 && *x1 > *x0 && *y1 > *y0 && *x1 < largest && *y1 < largest;
    if (placed) {
      region.rect = {static_cast<int>(*x0), static_cast<int>(*y0), static_cast<int>(*x1 - *x0 + 1), static_cast<int>(*y1 - *y0 + 1)};
      // The lower right corner is inside the region; writers that count it outside end one pixel beyond the image.
      if (*x1 == columns) --region.rect.width;
      if (*y1 == rows) --region.rect.height;
    }
    const auto referenceX = item.number(0x00186020u), referenceY = item.number(0x00186022u);
    if (referenceX && referenceY) {
      region.referencePixel = glm::dvec2(*referenceX, *referenceY);
      region.referenceValue = {item.number(0x00186028u).value_or(0.0), item.number(0x0018602Au).value_or(0.0)};
    }
    region.stale = placed && reachesBeyond(region.rect, columns, rows);
    region.problem = problemOf(region, placed, columns, rows);
    const auto same = [&](const UltrasoundRegion& other) {
      return other.rect == region.rect && other.spatialFormat == region.spatialFormat && other.dataType == region.dataType &&
             other.unitsX == region.unitsX && other.unitsY == region.unitsY && other.deltaX == region.deltaX &&
             other.deltaY == region.deltaY;
    };
    if (std::none_of(regions.begin(), regions.end(), same)) regions.push_back(std::move(region));
  }
  return regions;
}

namespace {

/// A field of numbers, for notes and sentences; a text of them may be written with commas.
struct NumberField {
  DicomTag tag;
  const char* name;
  bool isBinary = false;
};
constexpr NumberField kFrameTime{0x00181063u, "Frame Time"};
constexpr NumberField kFrameTimeVector{0x00181065u, "Frame Time Vector"};
constexpr NumberField kActualFrameDuration{0x00181242u, "Actual Frame Duration"};
constexpr NumberField kCineRate{0x00180040u, "Cine Rate"};
constexpr NumberField kDisplayRate{0x00082144u, "Recommended Display Frame Rate"};
constexpr NumberField kEffectiveDuration{0x00180072u, "Effective Duration"};
constexpr NumberField kAcquisitionDuration{0x00189073u, "Acquisition Duration", true};  // in s (PS3.3)
constexpr NumberField kPixelSpacing{0x00280030u, "Pixel Spacing"};
constexpr NumberField kAspectRatio{0x00280034u, "Pixel Aspect Ratio"};
constexpr NumberField kImagerSpacing{0x00181164u, "Imager Pixel Spacing"};
constexpr NumberField kNominalSpacing{0x00182010u, "Nominal Scanned Pixel Spacing"};

/// What a file has there, as a person can read it.
Message statedBy(const DicomItem& data, const NumberField& field) {
  const auto value = field.isBinary ? data.number(field.tag) : std::nullopt;
  return say<"%1 \"%2\"">(verbatim(field.name),
                          field.isBinary ? (value ? textOf(*value) : std::string()) : shortened(data.text(field.tag)));
}

void noteCommas(const DicomItem& data, const NumberField& field, std::vector<Message>& notes) {
  if (!field.isBinary && data.hasDecimalCommas(field.tag))
    notes.push_back(say<"%1 is written with commas (\"%2\"); they were read as decimal points.">(verbatim(field.name),
                                                                                                 shortened(data.text(field.tag))));
}

bool isStep(double step) { return std::isfinite(step) && step >= 0.0 && step < 1e7; }

/// Milliseconds from frame to frame where a field gives them, or a rate, for all frames alike.
std::optional<double> period_msBy(const DicomItem& data, const NumberField& field, std::uint64_t frames) {
  const auto value = data.number(field.tag);
  if (!value || !isStep(*value) || !(*value > 0.0)) return std::nullopt;
  if (field.tag == kCineRate.tag || field.tag == kDisplayRate.tag) return 1000.0 / *value;
  if (field.tag == kEffectiveDuration.tag || field.tag == kAcquisitionDuration.tag) return 1000.0 * *value / static_cast<double>(frames);
  return *value;
}

/// Times by Frame Time Vector, in ms; empty where it cannot be used.
std::vector<double> times_msBySteps(const DicomItem& data, std::uint64_t frames, std::vector<Message>& notes) {
  const auto values = data.numbers(kFrameTimeVector.tag);
  // The first entry is the time before the first frame, 0 by the standard; some writers leave it out.
  const bool oneShort = frames > 1 && values.size() + 1 == frames && !values.empty() && values.front() > 0.0;
  if ((values.size() != frames && !oneShort) || !std::all_of(values.begin(), values.end(), isStep)) return {};
  if (oneShort)
    notes.push_back(say<"Frame Time Vector has one entry less than there are frames; it was read as the steps between them.">());
  std::vector<double> times_ms;
  double time_ms = 0.0;
  for (std::uint64_t n = 0; n < frames; ++n) {
    if (n > 0) time_ms += values[oneShort ? n - 1 : n];
    times_ms.push_back(time_ms);
  }
  return times_ms;
}

/// Times that no images of ultrasound have come of a unit that was not meant: seconds for milliseconds, a rate in thousandths.
void noteUnlikely(const std::vector<double>& times_s, const Message& stated, std::vector<Message>& notes) {
  constexpr double kShortest_ms = 0.5, kLongest_ms = 10'000.0;
  if (times_s.size() < 2) return;
  const double step_ms = 1000.0 * times_s.back() / static_cast<double>(times_s.size() - 1);
  if (!(step_ms > 0.0) || (step_ms >= kShortest_ms && step_ms <= kLongest_ms)) return;
  notes.push_back(say<"By %1 the frames are %2 ms apart, which is hardly meant; is it given in the unit that DICOM has for it?">(
      stated, numeral(figureText(step_ms))));
}

/// Fields that give a frame time or rate other than that of the times which were taken from `used`. Rates are whole numbers.
std::vector<Message> otherTimes(const DicomItem& data, const NumberField& used, const std::vector<double>& times_s) {
  std::vector<Message> others;
  const std::uint64_t frames = times_s.size();
  const double period_ms = 1000.0 * times_s.back() / static_cast<double>(frames - 1);
  if (!(period_ms > 0.0)) return others;
  for (const NumberField& field : {kFrameTime, kFrameTimeVector, kCineRate, kDisplayRate}) {
    if (field.tag == used.tag) continue;
    std::optional<double> other_ms = field.tag == kFrameTimeVector.tag ? std::nullopt : period_msBy(data, field, frames);
    std::vector<Message> ignored;
    if (field.tag == kFrameTimeVector.tag)
      if (const auto times_ms = times_msBySteps(data, frames, ignored); !times_ms.empty() && times_ms.back() > 0.0)
        other_ms = times_ms.back() / static_cast<double>(frames - 1);
    if (!other_ms) continue;
    const auto isRate = [](const NumberField& each) { return each.tag == kCineRate.tag || each.tag == kDisplayRate.tag; };
    const double rate_hz = 1000.0 / period_ms, other_hz = 1000.0 / *other_ms;
    const bool rounded = (isRate(field) || isRate(used)) && (std::abs(rate_hz - other_hz) <= 0.5 || std::max(rate_hz, other_hz) <= 1.0);
    if (!rounded && std::abs(*other_ms - period_ms) > 0.01 * period_ms) others.push_back(statedBy(data, field));
  }
  // From the first frame to the last, or to the end of the last one; what a machine does before and behind counts as well.
  if (const auto other_ms = period_msBy(data, kAcquisitionDuration, frames); other_ms && used.tag != kAcquisitionDuration.tag) {
    const double toLast_ms = *other_ms * static_cast<double>(frames) / static_cast<double>(frames - 1);
    if (std::abs(*other_ms - period_ms) > 0.1 * period_ms && std::abs(toLast_ms - period_ms) > 0.1 * period_ms)
      others.push_back(statedBy(data, kAcquisitionDuration));
  }
  return others;
}

/// Of a rectangle's two numbers the file gives rows first: x and y of a pixel.
std::optional<glm::dvec2> pairOf(const DicomItem& data, const NumberField& field) {
  const auto values = data.numbers(field.tag);
  const auto usable = [](double mm) { return std::isfinite(mm) && mm > 1e-6 && mm < 1e6; };
  if (values.size() < 2 || !usable(values[0]) || !usable(values[1])) return std::nullopt;
  return glm::dvec2(values[1], values[0]);
}

}  // namespace

DicomScale scaleOf(const DicomItem& data, std::uint64_t columns, std::uint64_t rows) {
  DicomScale scale;
  scale.regions = regionsOf(data, columns, rows);
  bool stale = false;
  for (std::size_t n = 0; n < scale.regions.size(); ++n) {
    if (scale.regions[n].usable() && scale.regions[n].isBMode()) scale.bModes.push_back(n);
    stale = stale || scale.regions[n].stale;
  }
  if (scale.bModes.size() == 1 && !stale) scale.onlyRegion = scale.bModes.front();
  if (const auto spacing = pairOf(data, kPixelSpacing)) {
    if (scale.regions.empty())
      scale.spacing_mm = *spacing;
    else
      scale.hints.push_back(joined({verbatim(kPixelSpacing.name), verbatim(shortened(data.text(kPixelSpacing.tag)))}));
    noteCommas(data, kPixelSpacing, scale.notes);
  } else if (data.find(kPixelSpacing.tag) != nullptr && !data.text(kPixelSpacing.tag).empty()) {
    scale.hints.push_back(joined({verbatim(kPixelSpacing.name), verbatim(shortened(data.text(kPixelSpacing.tag)))}));
  }
  for (const NumberField& field : {kImagerSpacing, kNominalSpacing})
    if (data.find(field.tag) != nullptr && !data.text(field.tag).empty())
      scale.hints.push_back(joined({verbatim(field.name), verbatim(shortened(data.text(field.tag)))}));
  if (const auto ratio = pairOf(data, kAspectRatio)) scale.heightByWidth = ratio->y / ratio->x;
  return scale;
}

namespace {

struct DicomField {
  DicomTag tag;
  const char* name;
  FieldTouches touches;
};
constexpr std::array kTouchingFields{
    DicomField{0x00200032u, "Image Position (Patient)", FieldTouches::geometry},
    DicomField{0x00200037u, "Image Orientation (Patient)", FieldTouches::geometry},
    DicomField{0x00280030u, "Pixel Spacing", FieldTouches::geometry},
    DicomField{0x00280034u, "Pixel Aspect Ratio", FieldTouches::geometry},
    DicomField{0x00281050u, "Window Center", FieldTouches::levels},
    DicomField{0x00281051u, "Window Width", FieldTouches::levels},
    DicomField{0x00281052u, "Rescale Intercept", FieldTouches::levels},
    DicomField{0x00281053u, "Rescale Slope", FieldTouches::levels},
    DicomField{0x20500020u, "Presentation LUT Shape", FieldTouches::levels},
    DicomField{0x00181066u, "Frame Delay", FieldTouches::time},
    DicomField{0x00082142u, "Start Trim", FieldTouches::count},
    DicomField{0x00082143u, "Stop Trim", FieldTouches::count},
};
constexpr auto kTouchingNames = [] {
  std::array<FieldTableRow, kTouchingFields.size()> names;
  for (std::size_t n = 0; n < names.size(); ++n) names[n] = {kTouchingFields[n].name, kTouchingFields[n].touches};
  return names;
}();

/// Whether a field's value changes nothing.
bool isNeutral(const DicomItem& data, const DicomField& field, const std::optional<glm::dvec2>& pixel_mm) {
  const double first = data.number(field.tag).value_or(0.0);
  switch (field.tag) {
    case 0x00280030u:
    case 0x00280034u: {
      const auto stated = pairOf(data, {field.tag, field.name});
      if (!stated || !pixel_mm) return !stated;
      const bool isRatio = field.tag == 0x00280034u;
      const glm::dvec2 scale = isRatio ? *stated * (pixel_mm->x / stated->x) : *stated;
      return glm::length(scale - *pixel_mm) <= 0.01 * glm::length(*pixel_mm);
    }
    case 0x00281050u:
      return first >= 127.0 && first <= 128.0;
    case 0x00281051u:
      return first == 255.0 || first == 256.0;
    case 0x00281053u:
      return first == 1.0;
    case 0x20500020u:
      return data.text(field.tag) == "IDENTITY";
    case 0x00082142u:
      return first <= 1.0;
    case 0x00082143u:
      return first >= data.number(0x00280008u).value_or(1.0);
    case 0x00281052u:
    case 0x00181066u:
      return first == 0.0;
    default:
      return false;
  }
}

}  // namespace

std::vector<Message> unusedFields(const DicomItem& data, const std::optional<glm::dvec2>& pixel_mm, bool placed) {
  HeaderFields fields(kTouchingNames);
  for (const DicomField& field : kTouchingFields) {
    if (data.find(field.tag) == nullptr || isNeutral(data, field, pixel_mm)) continue;
    fields.meet(field.name, data.text(field.tag));
    if (placed && (field.tag == 0x00200032u || field.tag == 0x00200037u)) fields.use(field.name);
  }
  return fields.unused();
}

std::vector<double> frameTimes(const DicomItem& data, std::uint64_t frames, std::vector<Message>& notes) {
  if (frames < 2) return {};
  DicomTag named = 0;
  if (const DicomElement* const pointer = data.find(0x00280009u); pointer != nullptr && pointer->value.size() >= 4) {
    const auto word = [&](std::size_t at) -> std::uint32_t {
      const std::uint32_t first = pointer->value[at], second = pointer->value[at + 1];
      return data.bigEndian ? first << 8 | second : second << 8 | first;
    };
    named = word(0) << 16 | word(2);
  }
  std::vector<NumberField> order{kFrameTime,   kFrameTimeVector,   kActualFrameDuration, kCineRate,
                                 kDisplayRate, kEffectiveDuration, kAcquisitionDuration};
  std::stable_partition(order.begin(), order.end(), [&](const NumberField& field) { return field.tag == named; });
  std::vector<Message> found;
  for (const NumberField& field : order) {
    if (data.find(field.tag) == nullptr) continue;
    found.push_back(statedBy(data, field));
    std::vector<double> times_s;
    if (field.tag == kFrameTimeVector.tag) {
      for (const double time_ms : times_msBySteps(data, frames, notes)) times_s.push_back(0.001 * time_ms);
    } else if (const auto period_ms = period_msBy(data, field, frames)) {
      for (std::uint64_t n = 0; n < frames; ++n) times_s.push_back(*period_ms * 0.001 * static_cast<double>(n));
    }
    if (times_s.empty()) continue;
    noteCommas(data, field, notes);
    noteUnlikely(times_s, found.back(), notes);
    if (auto others = otherTimes(data, field, times_s); !others.empty())
      notes.push_back(say<"The times of the frames are those of %1; another rate is that of %2, which was not used.">(
          found.back(), joined(std::move(others), ", ")));
    else if (field.tag != kFrameTime.tag && field.tag != kFrameTimeVector.tag)
      notes.push_back(say<"The times of the frames are those of %1.">(found.back()));
    return times_s;
  }
  if (found.empty())
    notes.push_back(say<"The file says nothing about the times of its frames, so they have none; a rate can be given.">());
  else
    notes.push_back(say<"The file gives no usable times of its %1 frames: it has %2, so they have none; a rate can be given.">(
        frames, joined(std::move(found), ", ")));
  return {};
}

Bytes kretzInside(const DicomItem& data) {
  for (const DicomElement& element : data.elements) {
    if ((element.tag >> 16) % 2 == 1 && element.value.size() > 24 && std::memcmp(element.value.data(), "KRETZFILE 1.0", 13) == 0)
      return element.value;
    for (const DicomItem& item : element.items)
      if (const Bytes inside = kretzInside(item); !inside.empty()) return inside;
  }
  return {};
}

}  // namespace detail
}  // namespace ew
