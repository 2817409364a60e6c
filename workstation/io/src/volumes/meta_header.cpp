#include <algorithm>
#include <array>
#include <cmath>

#include "ew/core/numbers.h"
#include "files/header_fields.h"
#include "files/image_header.h"
#include "files/line_reader.h"

namespace ew::detail {
namespace {
namespace fs = std::filesystem;

struct MetaType {
  const char* name;
  SampleType type;
};
// MET_LONG is 4 bytes in this format whatever the machine's long is.
constexpr std::array<MetaType, 13> kMetaTypes{{{"MET_UCHAR", SampleType::u8},
                                               {"MET_CHAR", SampleType::i8},
                                               {"MET_USHORT", SampleType::u16},
                                               {"MET_SHORT", SampleType::i16},
                                               {"MET_UINT", SampleType::u32},
                                               {"MET_INT", SampleType::i32},
                                               {"MET_ULONG", SampleType::u32},
                                               {"MET_LONG", SampleType::i32},
                                               {"MET_ULONG_LONG", SampleType::u64},
                                               {"MET_LONG_LONG", SampleType::i64},
                                               {"MET_FLOAT", SampleType::f32},
                                               {"MET_DOUBLE", SampleType::f64},
                                               {"MET_OTHER", SampleType::none}}};

std::optional<bool> parseBool(std::string_view text) {
  const std::string lower = lowerCase(text);
  if (lower == "true" || lower == "1" || lower == "t" || lower == "yes") return true;
  if (lower == "false" || lower == "0" || lower == "f" || lower == "no") return false;
  return std::nullopt;
}

/// What a MetaImage header can say beside what is read of it. Lines of a recording and of other programs are kept and not judged here.
constexpr std::array kMetaFields{
    FieldTableRow{"DistanceUnits", FieldTouches::geometry},
    FieldTableRow{"AnatomicalOrientation", FieldTouches::geometry},
    FieldTableRow{"ElementToIntensityFunctionSlope", FieldTouches::levels},
    FieldTableRow{"ElementToIntensityFunctionOffset", FieldTouches::levels},
    FieldTableRow{"ElementMin", FieldTouches::nothing},
    FieldTableRow{"ElementMax", FieldTouches::nothing},
};

/// The header while its lines are read: what is known so far in raw form, because NDims may come after what needs it.
struct MetaDraft {
  ImageHeader header;
  HeaderFields fields{kMetaFields};
  std::optional<std::uint64_t> dimensions;
  std::string spacing;
  std::string size_mm;
  std::string offset;
  std::string matrix;
  bool binary = true;
  bool hasType = false;
  long long headerSize = 0;
};

Result<void> take(MetaDraft& draft, const std::string& key, const std::string& value) {
  ImageHeader& header = draft.header;
  const auto bad = [&](const Message& expected) { return badField(header.file, verbatim(key), verbatim(value), expected); };
  const auto boolean = [&](bool& target) -> Result<void> {
    const auto parsed = parseBool(value);
    if (!parsed) return bad(say<"True or False">());
    target = *parsed;
    return {};
  };
  if (key == "ObjectType") {
    if (lowerCase(value) != "image") return bad(verbatim("Image"));
  } else if (key == "NDims") {
    const auto number = parseIntegers(value);
    if (!number || number->size() != 1 || number->front() < 1 || number->front() > 10) return bad(say<"a number from 1 to 10">());
    draft.dimensions = static_cast<std::uint64_t>(number->front());
  } else if (key == "DimSize") {
    const auto numbers = parseIntegers(value);
    if (!numbers || std::any_of(numbers->begin(), numbers->end(), [](long long size) { return size < 0; }))
      return bad(say<"one whole number per dimension, none negative,">());
    header.sizes.assign(numbers->begin(), numbers->end());
  } else if (key == "ElementType") {
    std::string name = value;
    if (name.ends_with("_ARRAY")) name.resize(name.size() - 6);
    const auto* const found = std::find_if(kMetaTypes.begin(), kMetaTypes.end(), [&](const MetaType& type) { return name == type.name; });
    if (found == kMetaTypes.end()) return bad(say<"a type from MET_UCHAR to MET_DOUBLE">());
    header.type = found->type;
    draft.hasType = true;
  } else if (key == "ElementNumberOfChannels") {
    const auto number = parseIntegers(value);
    if (!number || number->size() != 1 || number->front() < 1) return bad(say<"a number above 0">());
    header.channels = static_cast<std::uint64_t>(number->front());
  } else if (key == "BinaryData") {
    return boolean(draft.binary);
  } else if (key == "BinaryDataByteOrderMSB" || key == "ElementByteOrderMSB") {
    return boolean(header.bigEndian);
  } else if (key == "CompressedData") {
    bool compressed = false;
    if (auto read = boolean(compressed); !read) return read;
    header.packing = compressed ? Packing::deflated : Packing::raw;
  } else if (key == "CompressedDataSize") {
    const auto number = parseIntegers(value);
    if (!number || number->size() != 1 || number->front() < 0) return bad(say<"a number of bytes">());
    if (number->front() > 0) header.packedBytes = static_cast<std::uint64_t>(number->front());
  } else if (key == "HeaderSize") {
    const auto number = parseIntegers(value);
    if (!number || number->size() != 1 || number->front() < -1) return bad(say<"a number of bytes or -1">());
    draft.headerSize = number->front();
  } else if (key == "ElementSpacing") {
    draft.spacing = value;
  } else if (key == "ElementSize") {
    draft.size_mm = value;
  } else if (key == "Offset" || key == "Position" || key == "Origin") {
    draft.offset = value;
  } else if (key == "TransformMatrix" || key == "Rotation" || key == "Orientation") {
    draft.matrix = value;
  } else if (std::any_of(kMetaFields.begin(), kMetaFields.end(), [&](const FieldTableRow& known) { return known.name == key; })) {
    draft.fields.meet(key, value);
  } else if (key == "Kinds") {
    header.kinds = wordsOf(value);
  } else if (key != "CenterOfRotation" && key != "CompressedDataSeekTable") {
    header.fields.emplace_back(key, value);
  }
  return {};
}

/// Exactly `count` finite numbers from `text`.
Result<std::vector<double>> numbersFor(const ImageHeader& header, std::string_view field, const std::string& text, std::size_t count) {
  auto numbers = parseNumbers(text);
  if (!numbers || numbers->size() != count ||
      std::any_of(numbers->begin(), numbers->end(), [](double value) { return !std::isfinite(value); }))
    return badField(header.file, verbatim(std::string(field)), verbatim(text), say<"%1 finite numbers">(count));
  return *std::move(numbers);
}

Result<void> takeGeometry(MetaDraft& draft) {
  ImageHeader& header = draft.header;
  const std::size_t n = header.sizes.size();
  const std::size_t spatial = std::min<std::size_t>(n, 3);
  // ElementSpacing is the distance between samples; ElementSize, their extent, only stands in for it.
  const bool spaced = !draft.spacing.empty();
  std::array<bool, 3> stated{};
  if (const std::string& text = spaced ? draft.spacing : draft.size_mm; !text.empty()) {
    const auto numbers = numbersFor(header, spaced ? "ElementSpacing" : "ElementSize", text, n);
    if (!numbers) return passOn(numbers.error());
    for (std::size_t axis = 0; axis < spatial; ++axis) {
      header.geometry.spacing_mm[static_cast<int>(axis)] = (*numbers)[axis];
      stated[axis] = true;
    }
  }
  if (!draft.offset.empty()) {
    const auto numbers = numbersFor(header, "Offset", draft.offset, n);
    if (!numbers) return passOn(numbers.error());
    for (std::size_t axis = 0; axis < spatial; ++axis) header.geometry.origin_mm[static_cast<int>(axis)] = (*numbers)[axis];
  }
  if (!draft.matrix.empty()) {
    const auto numbers = numbersFor(header, "TransformMatrix", draft.matrix, n * n);
    if (!numbers) return passOn(numbers.error());
    for (std::size_t axis = 0; axis < spatial; ++axis)
      for (std::size_t row = 0; row < spatial; ++row)
        header.geometry.directions[static_cast<int>(axis)][static_cast<int>(row)] = (*numbers)[axis * n + row];
    if (n == 2) header.geometry.directions[2] = glm::cross(header.geometry.directions[0], header.geometry.directions[1]);
  }
  if (const auto unit = draft.fields.take("DistanceUnits")) {
    const auto mm = *unit == "?" ? std::optional<double>(1.0) : lengthUnit_mm(*unit);
    if (mm) {
      header.geometry.spacing_mm *= *mm;
      header.geometry.origin_mm *= *mm;
    } else {
      header.spacingProblem = unknownUnit(header.file, *unit);
    }
  }
  completeGeometry(header);
  if (!header.spacingProblem.empty()) header.hasGeometry = false;
  noteUnstatedSpacing(header, stated);
  return {};
}

/// The extent of a sample may be stated as another than the distance from one to the next; whoever wrote it meant one of them.
void noteSizes(const MetaDraft& draft, std::vector<Message>& notes) {
  if (draft.spacing.empty() || draft.size_mm.empty()) return;
  const auto spacing = parseNumbers(draft.spacing), size = parseNumbers(draft.size_mm);
  const auto same = [](double one, double other) { return std::abs(one - other) <= 1e-3 * std::abs(one); };
  if (spacing && size && std::equal(spacing->begin(), spacing->end(), size->begin(), size->end(), same)) return;
  notes.push_back(say<"ElementSpacing \"%1\" was used; ElementSize \"%2\" says another size and was not.">(shortened(draft.spacing),
                                                                                                           shortened(draft.size_mm)));
}

/// Whether the words and the matrix say the same, in either of the two ways in which such words are meant (coming from, or going to).
bool agree(std::string words, const glm::dmat3& directions) {
  const std::string letters = anatomicalOrientation(directions);
  if (letters.empty() || words.find('?') != std::string::npos || words == letters) return true;
  for (char& letter : words) {
    constexpr std::string_view sides = "RLAPIS";
    const auto at = sides.find(letter);
    if (at == std::string_view::npos) return false;
    letter = sides[at ^ 1u];
  }
  return words == letters;
}

/// Fields that were met and not used, those left out that say nothing.
void noteUnused(MetaDraft& draft) {
  ImageHeader& header = draft.header;
  const auto words = draft.fields.stated("AnatomicalOrientation");
  if (words && (header.sizes.size() != 3 || describesSequence(header) || agree(*words, header.geometry.directions)))
    draft.fields.use("AnatomicalOrientation");
  if (draft.fields.stated("ElementToIntensityFunctionSlope") == std::optional<std::string>("1"))
    draft.fields.use("ElementToIntensityFunctionSlope");
  if (draft.fields.stated("ElementToIntensityFunctionOffset") == std::optional<std::string>("0"))
    draft.fields.use("ElementToIntensityFunctionOffset");
  noteSizes(draft, header.notes);
  for (Message& note : draft.fields.unused()) header.notes.push_back(std::move(note));
}

Result<void> takeDataFile(MetaDraft& draft, const std::string& name, std::uint64_t headerBytes) {
  ImageHeader& header = draft.header;
  const std::string lower = lowerCase(name);
  if (name.empty()) return badField(header.file, verbatim("ElementDataFile"), verbatim(name), say<"LOCAL or the name of a file">());
  if (lower.starts_with("list") && (lower.size() == 4 || lower[4] == ' '))
    return failure(ErrorCode::unsupported,
                   say<"%1 lists one file per slice, which is not read; convert it to a single .mha.">(quoted(header.file)),
                   {{"file", header.file.string()}});
  if (lower == "local") {
    header.dataFile = header.file;
    header.dataOffset = headerBytes;
  } else {
    if (name.find('%') != std::string::npos)
      return failure(ErrorCode::unsupported,
                     say<"%1 names one file per slice by a pattern, which is not read; convert it to a single .mha.">(quoted(header.file)),
                     {{"file", header.file.string()}});
    auto file = resolveDataFile(header.file, name);
    if (!file) return passOn(file.error());
    header.dataFile = *std::move(file);
  }
  if (draft.headerSize < 0)
    header.dataAtEnd = true;
  else
    header.dataOffset += static_cast<std::uint64_t>(draft.headerSize);
  return {};
}

}  // namespace

Result<ImageHeader> readMetaHeader(const fs::path& file, bool mayEndEarly) {
  LineReader lines(file);
  MetaDraft draft;
  draft.header.file = file;
  std::optional<std::string> dataFile;
  bool anyKnown = false;
  while (!dataFile) {
    auto line = lines.next();
    if (!line) return passOn(line.error());
    if (!*line) break;
    if (trimmed(**line).empty()) continue;
    const auto equals = (*line)->find('=');
    if (equals == std::string::npos && mayEndEarly && anyKnown) break;  // a line that was being written
    if (equals == std::string::npos)
      return failure(ErrorCode::badHeader,
                     say<"%1 is not a MetaImage: a header line has no \"=\"; check what kind of file it is.">(quoted(file)),
                     {{"file", file.string()}});
    const std::string key(trimmed(std::string_view(**line).substr(0, equals)));
    const std::string value(trimmed(std::string_view(**line).substr(equals + 1)));
    if (key == "ElementDataFile") {
      dataFile = value;
      break;
    }
    anyKnown = true;
    if (const auto taken = take(draft, key, value); !taken) return passOn(taken.error());
  }
  draft.header.endsEarly = !dataFile;
  if (!dataFile && !(mayEndEarly && productOf(draft.header.sizes) == std::optional<std::uint64_t>(0)))
    return failure(anyKnown ? ErrorCode::truncated : ErrorCode::badHeader,
                   say<"The header of %1 ends before it says where the samples are (ElementDataFile); get the file again.">(quoted(file)),
                   {{"file", file.string()}});
  ImageHeader& header = draft.header;
  if (header.sizes.empty()) return badField(file, verbatim("DimSize"), verbatim(""), say<"one whole number per dimension">());
  if (draft.dimensions && *draft.dimensions != header.sizes.size())
    return badField(file, verbatim("DimSize"), verbatim(sizesText(header.sizes)), say<"%1 numbers (NDims)">(*draft.dimensions));
  if (!draft.hasType) return badField(file, verbatim("ElementType"), verbatim(""), say<"a type from MET_UCHAR to MET_DOUBLE">());
  if (header.type == SampleType::none && productOf(header.sizes) != std::optional<std::uint64_t>(0))
    return badField(file, verbatim("ElementType"), verbatim("MET_OTHER"), say<"a type from MET_UCHAR to MET_DOUBLE">());
  if (!draft.binary) header.packing = Packing::text;
  if (header.packing != Packing::deflated) header.packedBytes.reset();
  if (const auto taken = takeGeometry(draft); !taken) return passOn(taken.error());
  noteUnused(draft);
  if (productOf(header.sizes) == std::optional<std::uint64_t>(0)) {
    header.dataFile = file;  // a recording of poses alone: whatever file is named has nothing in it
    return std::move(draft.header);
  }
  if (const auto taken = takeDataFile(draft, *dataFile, lines.consumed()); !taken) return passOn(taken.error());
  return std::move(draft.header);
}

}  // namespace ew::detail
