#include <algorithm>
#include <array>
#include <cmath>

#include "ew/core/figures.h"
#include "ew/core/numbers.h"
#include "files/header_fields.h"
#include "files/image_header.h"
#include "files/line_reader.h"
#include "volumes/nrrd_time_axis.h"

namespace ew::detail {
namespace {
namespace fs = std::filesystem;

struct NrrdType {
  const char* name;
  SampleType type;
};
constexpr std::array<NrrdType, 36> kNrrdTypes{{
    {"signed char", SampleType::i8},
    {"int8", SampleType::i8},
    {"int8_t", SampleType::i8},
    {"uchar", SampleType::u8},
    {"unsigned char", SampleType::u8},
    {"uint8", SampleType::u8},
    {"uint8_t", SampleType::u8},
    {"short", SampleType::i16},
    {"short int", SampleType::i16},
    {"signed short", SampleType::i16},
    {"int16", SampleType::i16},
    {"int16_t", SampleType::i16},
    {"ushort", SampleType::u16},
    {"unsigned short", SampleType::u16},
    {"unsigned short int", SampleType::u16},
    {"uint16", SampleType::u16},
    {"uint16_t", SampleType::u16},
    {"int", SampleType::i32},
    {"signed int", SampleType::i32},
    {"int32", SampleType::i32},
    {"int32_t", SampleType::i32},
    {"uint", SampleType::u32},
    {"unsigned int", SampleType::u32},
    {"uint32", SampleType::u32},
    {"uint32_t", SampleType::u32},
    {"longlong", SampleType::i64},
    {"long long", SampleType::i64},
    {"long long int", SampleType::i64},
    {"int64", SampleType::i64},
    {"int64_t", SampleType::i64},
    {"ulonglong", SampleType::u64},
    {"unsigned long long", SampleType::u64},
    {"uint64", SampleType::u64},
    {"uint64_t", SampleType::u64},
    {"float", SampleType::f32},
    {"double", SampleType::f64},
}};

using Axis = NrrdDirection;

/// Vectors as `space directions` and `space origin` write them; empty when the text is anything else.
std::optional<std::vector<Axis>> parseVectors(std::string_view text) {
  std::vector<Axis> axes;
  for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
    if (lowerCase(text.substr(0, 4)) == "none") {
      axes.emplace_back(std::nullopt);
      text.remove_prefix(4);
      continue;
    }
    const auto close = text.find(')');
    if (text.front() != '(' || close == std::string_view::npos) return std::nullopt;
    std::string inside(text.substr(1, close - 1));
    std::replace(inside.begin(), inside.end(), ',', ' ');
    auto numbers = parseNumbers(inside);
    if (!numbers) return std::nullopt;
    axes.emplace_back(*std::move(numbers));
    text.remove_prefix(close + 1);
  }
  return axes;
}

/// `\n` and `\\` in values of key/value pairs stand for a line break and a backslash. A break would not survive in a line of ours.
std::string unescaped(std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\\' && i + 1 < text.size() && (text[i + 1] == 'n' || text[i + 1] == '\\')) {
      plain.push_back(text[++i] == 'n' ? ' ' : '\\');
    } else {
      plain.push_back(text[i]);
    }
  }
  return plain;
}

/// What a NRRD header can say beside what is read of it.
constexpr std::array kNrrdFields{
    FieldTableRow{"space units", FieldTouches::geometry}, FieldTableRow{"units", FieldTouches::geometry},
    FieldTableRow{"axis mins", FieldTouches::geometry},   FieldTableRow{"axis maxs", FieldTouches::geometry},
    FieldTableRow{"thicknesses", FieldTouches::geometry}, FieldTableRow{"old min", FieldTouches::levels},
    FieldTableRow{"old max", FieldTouches::levels},       FieldTableRow{"min", FieldTouches::levels},
    FieldTableRow{"max", FieldTouches::levels},
};

struct NrrdDraft {
  ImageHeader header;
  HeaderFields fields{kNrrdFields};
  std::optional<std::uint64_t> dimension;
  std::string space;
  std::optional<long long> spaceDimension;
  std::string directions;
  std::string origin;
  std::string dataFile;
  std::string encoding;
  std::string endian;
  std::optional<std::size_t> timeAxis;  ///< of the file, one with a unit of time
  long long byteSkip = 0;
  long long lineSkip = 0;
  bool hasType = false;
};

Result<void> take(NrrdDraft& draft, std::string field, const std::string& value) {
  ImageHeader& header = draft.header;
  const auto bad = [&](const Message& expected) { return badField(header.file, verbatim(field), verbatim(value), expected); };
  const auto whole = [&](long long& target, long long smallest) -> Result<void> {
    const auto number = parseIntegers(value);
    if (!number || number->size() != 1 || number->front() < smallest) return bad(say<"a whole number from %1">(smallest));
    target = number->front();
    return {};
  };
  field = lowerCase(field);
  // Each of these has a second spelling.
  for (const auto& [joined, apart] : {std::pair("axismins", "axis mins"), std::pair("axismaxs", "axis maxs"),
                                      std::pair("oldmin", "old min"), std::pair("oldmax", "old max"), std::pair("centerings", "centers")})
    if (field == joined) field = apart;
  draft.fields.meet(field, value);
  if (field == "type") {
    const std::string name = lowerCase(value);
    const auto* const found = std::find_if(kNrrdTypes.begin(), kNrrdTypes.end(), [&](const NrrdType& type) { return name == type.name; });
    if (found == kNrrdTypes.end()) return bad(say<"a type from uchar to double">());
    header.type = found->type;
    draft.hasType = true;
  } else if (field == "dimension") {
    long long number = 0;
    if (auto read = whole(number, 1); !read) return read;
    if (number > 16) return bad(say<"a number from 1 to 16">());
    draft.dimension = static_cast<std::uint64_t>(number);
  } else if (field == "sizes") {
    const auto numbers = parseIntegers(value);
    if (!numbers || std::any_of(numbers->begin(), numbers->end(), [](long long size) { return size < 0; }))
      return bad(say<"one whole number per axis, none negative,">());
    header.sizes.assign(numbers->begin(), numbers->end());
  } else if (field == "kinds") {
    header.kinds = wordsOf(value);
  } else if (field == "endian") {
    draft.endian = lowerCase(value);
  } else if (field == "encoding") {
    draft.encoding = lowerCase(value);
  } else if (field == "space") {
    draft.space = lowerCase(value);
  } else if (field == "space dimension") {
    long long number = 0;
    if (auto read = whole(number, 1); !read) return read;
    draft.spaceDimension = number;
  } else if (field == "space directions") {
    draft.directions = value;
  } else if (field == "space origin") {
    draft.origin = value;
  } else if (field == "data file" || field == "datafile") {
    draft.dataFile = value;
  } else if (field == "byte skip" || field == "byteskip") {
    return whole(draft.byteSkip, -1);
  } else if (field == "line skip" || field == "lineskip") {
    return whole(draft.lineSkip, 0);
  } else if (field == "content") {
    header.fields.emplace_back("content", value);
  }  // all others are asked for by name, or told as not used
  return {};
}

Result<void> takeStorage(NrrdDraft& draft, std::uint64_t headerBytes) {
  ImageHeader& header = draft.header;
  if (draft.encoding == "raw") {
    header.packing = Packing::raw;
  } else if (draft.encoding == "gzip" || draft.encoding == "gz") {
    header.packing = Packing::deflated;
  } else if (draft.encoding == "ascii" || draft.encoding == "text" || draft.encoding == "txt") {
    header.packing = Packing::text;
  } else {
    return failure(
        ErrorCode::unsupported,
        say<"%1 is packed as \"%2\", which is not read; save it as raw or gzip.">(quoted(header.file), draft.encoding.substr(0, 40)),
        {{"file", header.file.string()}, {"encoding", draft.encoding.substr(0, 40)}});
  }
  const bool orderMatters = header.packing != Packing::text && bytesOf(header.type) > 1;
  if (orderMatters && draft.endian != "little" && draft.endian != "big")
    return badField(header.file, verbatim("endian"), verbatim(draft.endian), say<"little or big">());
  header.bigEndian = draft.endian == "big";
  if (draft.lineSkip > 0)
    return failure(ErrorCode::unsupported,
                   say<"%1 asks to skip lines of its data file, which is not read; use byte skip.">(quoted(header.file)),
                   {{"file", header.file.string()}});
  const std::string lower = lowerCase(draft.dataFile);
  if (draft.dataFile.empty()) {
    header.dataFile = header.file;
    header.dataOffset = headerBytes;
  } else if (lower == "list" || lower.starts_with("list ") || draft.dataFile.find('%') != std::string::npos) {
    return failure(ErrorCode::unsupported,
                   say<"%1 keeps its samples in many files, which is not read; save it as one .nrrd.">(quoted(header.file)),
                   {{"file", header.file.string()}});
  } else {
    auto file = resolveDataFile(header.file, draft.dataFile);
    if (!file) return passOn(file.error());
    header.dataFile = *std::move(file);
  }
  // In packed samples the bytes to skip are counted after unpacking, in raw ones from where they begin.
  if (draft.byteSkip < 0)
    header.dataAtEnd = true;
  else
    (header.packing == Packing::deflated ? header.skipUnpacked : header.dataOffset) += static_cast<std::uint64_t>(draft.byteSkip);
  return {};
}

/// What the fastest axis of a NRRD holds.
enum class FirstAxis { space, colours, components, volumes };

FirstAxis firstAxisOf(const ImageHeader& header, const std::optional<std::vector<Axis>>& axes) {
  const std::string kind = header.kinds.empty() ? "" : lowerCase(header.kinds.front());
  if (kind.find("color") != std::string::npos) return FirstAxis::colours;
  for (const char* word : {"vector", "matrix", "normal", "gradient", "quaternion", "complex"})
    if (kind.find(word) != std::string::npos) return FirstAxis::components;
  if (kind.starts_with("2-") || kind.starts_with("3-") || kind.starts_with("4-")) return FirstAxis::components;
  // An axis of a list, of time or without direction and name: what stands along it are volumes or images of their own, whatever their
  // count.
  const bool undirected = axes && !axes->empty() && !axes->front();
  const bool unnamed = (kind == "none" || kind == "???") && header.sizes.size() > 3;  // one of four can be none of space
  return kind == "list" || kind == "time" || undirected || unnamed ? FirstAxis::volumes : FirstAxis::space;
}

/// Values of a kind that is neither an echo level nor a colour of red, green and blue have no luminance. `vector` says nothing more than
/// that there are several, and is what some write for a colour.
Result<void> checkKind(const ImageHeader& header) {
  const std::string kind = header.kinds.empty() ? "" : lowerCase(header.kinds.front());
  bool refused = kind.starts_with("hsv") || kind.starts_with("xyz");
  for (const char* word : {"-vector", "matrix", "normal", "gradient", "quaternion", "complex"})
    refused = refused || kind.find(word) != std::string::npos;
  if (!refused || header.channels == 1) return {};
  return failure(ErrorCode::unsupported,
                 say<"%1 holds %2 values of the kind \"%3\" per sample, which are neither an echo level nor red, green and blue; export "
                     "the echo levels alone.">(quoted(header.file), header.channels, shortened(header.kinds.front())),
                 {{"file", header.file.string()}, {"channels", std::to_string(header.channels)}});
}

/// Takes an axis of colours, components or volumes out of the sizes: it must be the fastest.
Result<std::size_t> takeChannels(NrrdDraft& draft, const std::optional<std::vector<Axis>>& axes) {
  ImageHeader& header = draft.header;
  if (header.sizes.size() < 3) return std::size_t{0};
  const FirstAxis first = firstAxisOf(header, axes);
  if (first == FirstAxis::space) return std::size_t{0};
  header.channels = header.sizes.front();
  if (header.channels == 0)
    return badField(header.file, verbatim("sizes"), verbatim(sizesText(header.sizes)), say<"at least one value per sample">());
  header.coloursNamed = first == FirstAxis::colours;
  if (auto usable = checkKind(header); !usable) return passOn(usable.error());
  if (first == FirstAxis::volumes && header.channels > 1) header.wantedChannel = 0;
  header.sizes.erase(header.sizes.begin());
  if (!header.kinds.empty()) header.kinds.erase(header.kinds.begin());
  return std::size_t{1};
}

/// An axis of time, or without direction, between those of space would be taken for one of them.
Result<void> checkAxes(const ImageHeader& header, const std::optional<std::vector<Axis>>& axes, std::size_t channelAxes) {
  for (std::size_t axis = 0; axis + 1 < header.sizes.size() && axis < 3; ++axis) {
    const std::string kind = header.kinds.empty() ? "" : lowerCase(header.kinds[axis]);
    const bool undirected = axes && !(*axes)[axis + channelAxes];
    if ((kind == "list" || kind == "time" || undirected) && header.sizes[axis] > 1)
      return failure(ErrorCode::unsupported,
                     say<"Axis %1 of %2 is none of space (%3), but stands between such; save it with that axis as the first or the last.">(
                         axis + channelAxes + 1, quoted(header.file), kind.empty() ? say<"it has no direction">() : verbatim(kind)),
                     {{"file", header.file.string()}});
  }
  return {};
}

/// "\"mm\" \"mm\" \"\"": one text an axis.
std::vector<std::string> quotedWords(std::string_view text) {
  std::vector<std::string> words;
  for (auto open = text.find('"'); open != std::string_view::npos; open = text.find('"', open)) {
    const auto close = text.find('"', open + 1);
    if (close == std::string_view::npos) break;
    words.emplace_back(text.substr(open + 1, close - open - 1));
    open = close + 1;
  }
  return words;
}

/// The words of a field of units.
std::vector<std::string> unitWords(const std::string& stated) {
  return stated.find('"') == std::string::npos ? wordsOf(stated) : quotedWords(stated);
}

/// Enters an axis that is one of time by its unit, its spacing or its direction as such.
Result<void> settleTime(NrrdDraft& draft, const std::optional<std::vector<Axis>>& directions) {
  const std::size_t count = draft.header.sizes.size();
  NrrdAxes axes{.units = {}, .spacings = {}, .directions = directions};
  axes.units = unitWords(draft.fields.stated("units").value_or(""));
  if (axes.units.size() < 2)
    axes.units.clear();  // one word for all of them
  else
    axes.units.resize(count);
  if (auto spacings = parseNumbers(draft.fields.stated("spacings").value_or("")); spacings && spacings->size() == count)
    axes.spacings = *std::move(spacings);
  const auto found = settleTimeAxis(draft.header, axes);
  if (!found) return passOn(found.error());
  draft.timeAxis = *found;
  const auto stated = std::count_if(axes.units.begin(), axes.units.end(), [](const std::string& unit) { return !trimmed(unit).empty(); });
  if (draft.timeAxis && stated == 1) draft.fields.use("units");
  return {};
}

/// Millimetres per unit along `count` axes, as a field of units from its entry `from` on says; 1 where it says nothing. A unit that is none
/// of length leaves the spacing unknown, and so does one that is missing where others are given: of which axes they are, nobody knows.
std::array<double, 3> unitsOf(NrrdDraft& draft, const char* field, std::size_t from, std::size_t count) {
  std::array<double, 3> mm{1.0, 1.0, 1.0};
  const auto stated = draft.fields.take(field);
  if (!stated) return mm;
  const auto words = unitWords(*stated);
  const bool isOfAll = words.size() == 1 && from == 0;  // one word for several axes is meant for each of them
  if (!isOfAll && words.size() < from + count)
    draft.header.spacingProblem = say<"%1 gives %2 units (%3) for %4 axes, so that the sizes are not known; give the spacing in mm.">(
        quoted(draft.header.file), words.size(), shortened(*stated), from + count);
  for (std::size_t axis = 0; axis < std::min<std::size_t>(count, 3) && (isOfAll || from + axis < words.size()); ++axis) {
    const std::string& word = isOfAll ? words.front() : words[from + axis];
    if (!isOfAll && std::string_view(field) == "units" && draft.timeAxis == from + axis) continue;
    const auto unit_mm = lengthUnit_mm(word);
    if (unit_mm)
      mm[axis] = *unit_mm;
    else
      draft.header.spacingProblem = unknownUnit(draft.header.file, word);
  }
  return mm;
}

/// Numbers of a field with one for each axis, NaN for axes that have none; empty where it is not there or all are NaN.
Result<std::vector<double>> numbersPerAxis(NrrdDraft& draft, const char* field, std::size_t axes) {
  const auto stated = draft.fields.take(field);
  if (!stated) return std::vector<double>();
  auto numbers = parseNumbers(*stated);
  if (!numbers || numbers->size() != axes || std::any_of(numbers->begin(), numbers->end(), [](double value) { return std::isinf(value); }))
    return badField(draft.header.file, verbatim(field), verbatim(*stated), say<"one number per axis">());
  if (std::all_of(numbers->begin(), numbers->end(), [](double value) { return std::isnan(value); })) return std::vector<double>();
  return *std::move(numbers);
}

/// Spacing and place of axes that have lengths and no directions: `spacings`, and `axis mins` (and `axis maxs` where there are no
/// spacings), which are edges of the first (and last) cell where samples stand in cells, as they do unless the file says `node`.
/// @param stated which axes have a spacing
Result<void> takeExtents(NrrdDraft& draft, std::size_t spatial, std::size_t channelAxes, std::array<bool, 3>& stated) {
  ImageHeader& header = draft.header;
  const std::size_t all = header.sizes.size() + channelAxes;
  const auto spacings = numbersPerAxis(draft, "spacings", all);
  if (!spacings) return passOn(spacings.error());
  const auto mins = numbersPerAxis(draft, "axis mins", all);
  if (!mins) return passOn(mins.error());
  const auto maxs = numbersPerAxis(draft, "axis maxs", all);
  if (!maxs) return passOn(maxs.error());
  const auto units_mm =
      unitsOf(draft, draft.fields.stated("units") ? "units" : "space units", draft.fields.stated("units") ? channelAxes : 0, spatial);
  const auto centres = wordsOf(draft.fields.take("centers").value_or(""));
  const auto at = [](const std::vector<double>& values, std::size_t axis) {
    return axis < values.size() && !std::isnan(values[axis]) ? std::optional<double>(values[axis]) : std::nullopt;
  };
  for (std::size_t axis = 0; axis < spatial; ++axis) {
    const std::size_t here = axis + channelAxes;
    if (draft.timeAxis == here) continue;  // seconds are no millimetres
    const int i = static_cast<int>(axis);
    const bool onNodes = here < centres.size() && lowerCase(centres[here]) == "node";
    const auto samples = static_cast<double>(header.sizes[axis]);
    const auto lowest = at(*mins, here), highest = at(*maxs, here);
    std::optional<double> spacing = at(*spacings, here);
    if (!spacing && lowest && highest && *highest > *lowest && samples > 1.0)
      spacing = (*highest - *lowest) / (onNodes ? samples - 1.0 : samples);
    if (spacing) header.geometry.spacing_mm[i] = *spacing * units_mm[axis];
    stated[axis] = spacing.has_value();
    if (lowest && draft.origin.empty())
      header.geometry.origin_mm[i] = (*lowest + (onNodes ? 0.0 : 0.5 * spacing.value_or(0.0))) * units_mm[axis];
  }
  return {};
}

/// +1 or -1 for x, y, z: what takes the file's world to left-posterior-superior. Empty when the space is no patient's.
std::optional<glm::dvec3> signsOf(std::string space) {
  if (space.ends_with("-time")) space.resize(space.size() - 5);
  if (space == "left-posterior-superior" || space == "lps") return glm::dvec3(1, 1, 1);
  if (space == "right-anterior-superior" || space == "ras") return glm::dvec3(-1, -1, 1);
  if (space == "left-anterior-superior" || space == "las") return glm::dvec3(1, -1, 1);
  return std::nullopt;
}

/// Of the vectors of a space, 3 where there are none.
std::size_t componentsOf(const std::optional<std::vector<Axis>>& axes) {
  if (axes)
    for (const Axis& each : *axes)
      if (each) return std::min<std::size_t>(each->size(), 3);
  return 3;
}

/// Directions have lengths, and a file that gives spacings besides says the same twice.
void noteSizes(NrrdDraft& draft, std::size_t spatial, std::size_t channelAxes, const std::array<bool, 3>& given) {
  const auto stated = draft.fields.take("spacings");
  const auto spacings = stated ? parseNumbers(*stated) : std::nullopt;
  if (!spacings || spacings->size() != draft.header.sizes.size() + channelAxes) return;
  std::array<std::string, 2> sizes;
  bool differ = false;
  for (std::size_t axis = 0; axis < spatial; ++axis) {
    const double used = draft.header.geometry.spacing_mm[static_cast<int>(axis)], other = (*spacings)[axis + channelAxes];
    if (!given[axis] || !std::isfinite(other)) continue;
    differ = differ || std::abs(other - used) > 0.01 * used;
    sizes[0] += (sizes[0].empty() ? "" : " x ") + figureText(used);
    sizes[1] += (sizes[1].empty() ? "" : " x ") + figureText(other);
  }
  if (differ)
    draft.header.notes.push_back(
        say<"The file gives two voxel sizes: %1 mm by its space directions, which were used, and %2 by its spacings.">(sizes[0], sizes[1]));
}

Result<void> takeGeometry(NrrdDraft& draft, const std::optional<std::vector<Axis>>& axes, std::size_t channelAxes) {
  ImageHeader& header = draft.header;
  const std::size_t spatial = std::min<std::size_t>(header.sizes.size(), 3);
  const auto signs = signsOf(draft.space);
  if (!signs && (!draft.space.empty() || axes) && header.sizes.size() > 2)
    header.notes.push_back(
        draft.space.empty()
            ? say<"The file's space is not named; its axes were taken for left, posterior and superior.">()
            : say<"The file's space is \"%1\"; its axes were taken for left, posterior and superior.">(draft.space.substr(0, 40)));
  const glm::dvec3 toLps = signs.value_or(glm::dvec3(1.0));
  const auto finite = [](const std::vector<double>& values) {
    return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
  };
  // Units of a space are those of the components of its vectors.
  const std::array<double, 3> space_mm =
      axes || !draft.origin.empty() ? unitsOf(draft, "space units", 0, componentsOf(axes)) : std::array<double, 3>{1.0, 1.0, 1.0};
  std::array<bool, 3> given{};  // along which axes the file states a spacing
  if (axes) {
    for (std::size_t axis = 0; axis < spatial; ++axis) {
      const Axis& step = (*axes)[axis + channelAxes];
      if (!step) continue;
      glm::dvec3 step_mm(0.0);
      if (step->size() > 4 || !finite(*step))
        return badField(header.file, verbatim("space directions"), verbatim(draft.directions), say<"finite vectors of 2 or 3 numbers">());
      for (std::size_t row = 0; row < std::min<std::size_t>(step->size(), 3); ++row)
        step_mm[static_cast<int>(row)] = (*step)[row] * space_mm[row];
      const double length = glm::length(step_mm);
      if (!(length > 0.0) || !std::isfinite(length))
        return badField(header.file, verbatim("space directions"), verbatim(draft.directions), say<"vectors longer than 0">());
      header.geometry.spacing_mm[static_cast<int>(axis)] = length;
      header.geometry.directions[static_cast<int>(axis)] = step_mm / length * toLps;
      given[axis] = true;
    }
    noteSizes(draft, spatial, channelAxes, given);
    // An axis without a direction (frames, or the missing third one of an image) stands upright on the other two.
    if (given[0] && given[1] && !given[2]) {
      const glm::dvec3 upright = glm::cross(header.geometry.directions[0], header.geometry.directions[1]);
      if (glm::length(upright) > 1e-6) header.geometry.directions[2] = glm::normalize(upright);
    }
  } else if (auto taken = takeExtents(draft, spatial, channelAxes, given); !taken) {
    return taken;
  }
  if (!draft.origin.empty()) {
    const auto origin = parseVectors(draft.origin);
    if (!origin || origin->size() != 1 || !origin->front() || origin->front()->size() > 4 || !finite(*origin->front()))
      return badField(header.file, verbatim("space origin"), verbatim(draft.origin), say<"one finite vector">());
    glm::dvec3 origin_mm(0.0);
    for (std::size_t row = 0; row < std::min<std::size_t>(origin->front()->size(), 3); ++row)
      origin_mm[static_cast<int>(row)] = (*origin->front())[row] * space_mm[row];
    header.geometry.origin_mm = origin_mm * toLps;
  }
  completeGeometry(header);
  if (!header.spacingProblem.empty()) header.hasGeometry = false;
  noteUnstatedSpacing(header, given);
  return {};
}

}  // namespace

Result<ImageHeader> readNrrdHeader(const fs::path& file) {
  LineReader lines(file);
  NrrdDraft draft;
  ImageHeader& header = draft.header;
  header.file = file;
  const auto notNrrd = [&] {
    return failure(ErrorCode::badHeader, say<"%1 is not a NRRD file; check what kind of file it is.">(quoted(file)),
                   {{"file", file.string()}});
  };
  const auto magic = lines.next();
  if (!magic) return magic.error().code == ErrorCode::badHeader ? notNrrd() : passOn(magic.error());
  if (!*magic || !(*magic)->starts_with("NRRD000")) return notNrrd();
  bool ended = false;
  while (!ended) {
    auto line = lines.next();
    if (!line) return passOn(line.error());
    if (!*line || trimmed(**line).empty()) {
      ended = line->has_value();
      break;
    }
    const std::string& text = **line;
    if (text.front() == '#') continue;
    const auto colon = text.find(':');
    if (colon == std::string::npos) return notNrrd();
    const std::string key(trimmed(std::string_view(text).substr(0, colon)));
    if (colon + 1 < text.size() && text[colon + 1] == '=') {
      header.fields.emplace_back(key, trimmed(unescaped(std::string_view(text).substr(colon + 2))));
    } else if (auto taken = take(draft, key, std::string(trimmed(std::string_view(text).substr(colon + 1)))); !taken) {
      return passOn(taken.error());
    }
  }
  // A detached header may end with the file; one with samples behind it needs its blank line.
  if (!ended && draft.dataFile.empty())
    return failure(ErrorCode::truncated, say<"The header of %1 breaks off before its samples; get the file again.">(quoted(file)),
                   {{"file", file.string()}});
  if (!draft.hasType) return badField(file, verbatim("type"), verbatim(""), say<"a type from uchar to double">());
  if (header.sizes.empty()) return badField(file, verbatim("sizes"), verbatim(""), say<"one whole number per axis">());
  if (draft.dimension && *draft.dimension != header.sizes.size())
    return badField(file, verbatim("sizes"), verbatim(sizesText(header.sizes)), say<"%1 numbers (dimension)">(*draft.dimension));
  if (!header.kinds.empty() && header.kinds.size() != header.sizes.size())
    return badField(file, verbatim("kinds"), say<"%1 words">(header.kinds.size()), say<"%1 words, one per axis,">(header.sizes.size()));
  std::optional<std::vector<Axis>> axes;
  if (!draft.directions.empty()) {
    axes = parseVectors(draft.directions);
    if (!axes || axes->size() != header.sizes.size())
      return badField(file, verbatim("space directions"), verbatim(draft.directions), say<"one vector or none per axis">());
  }
  if (auto settled = settleTime(draft, axes); !settled) return passOn(settled.error());
  const auto channelAxes = takeChannels(draft, axes);
  if (!channelAxes) return passOn(channelAxes.error());
  if (auto usable = checkAxes(header, axes, *channelAxes); !usable) return passOn(usable.error());
  if (auto taken = takeGeometry(draft, axes, *channelAxes); !taken) return passOn(taken.error());
  for (Message& note : draft.fields.unused()) header.notes.push_back(std::move(note));
  if (auto taken = takeStorage(draft, lines.consumed()); !taken) return passOn(taken.error());
  return std::move(draft.header);
}

}  // namespace ew::detail
