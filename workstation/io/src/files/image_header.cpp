#include "files/image_header.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "files/content_kind.h"

namespace ew::detail {
namespace fs = std::filesystem;

std::uint64_t bytesOf(SampleType type) {
  switch (type) {
    case SampleType::u8:
    case SampleType::i8:
      return 1;
    case SampleType::u16:
    case SampleType::i16:
      return 2;
    case SampleType::u32:
    case SampleType::i32:
    case SampleType::f32:
      return 4;
    case SampleType::u64:
    case SampleType::i64:
    case SampleType::f64:
      return 8;
    case SampleType::none:
      return 0;
  }
  return 0;
}

Message nameOf(SampleType type) {
  switch (type) {
    case SampleType::u8:
      return say<"8 bit unsigned">();
    case SampleType::i8:
      return say<"8 bit signed">();
    case SampleType::u16:
      return say<"16 bit unsigned">();
    case SampleType::i16:
      return say<"16 bit signed">();
    case SampleType::u32:
      return say<"32 bit unsigned">();
    case SampleType::i32:
      return say<"32 bit signed">();
    case SampleType::u64:
      return say<"64 bit unsigned">();
    case SampleType::i64:
      return say<"64 bit signed">();
    case SampleType::f32:
      return say<"32 bit floating point">();
    case SampleType::f64:
      return say<"64 bit floating point">();
    case SampleType::none:
      return say<"no">();
  }
  return say<"unknown">();
}

std::optional<FrameKey> frameKey(std::string_view key) {
  constexpr std::string_view prefix = "Seq_Frame";
  if (!key.starts_with(prefix)) return std::nullopt;
  key.remove_prefix(prefix.size());
  FrameKey found;
  const auto [end, error] = std::from_chars(key.data(), key.data() + key.size(), found.frame);
  if (error != std::errc{} || end == key.data() + key.size() || *end != '_') return std::nullopt;
  found.name = key.substr(static_cast<std::size_t>(end - key.data()) + 1);
  if (found.name.empty()) return std::nullopt;
  return found;
}

bool describesSequence(const ImageHeader& header) {
  const bool hasFrames =
      std::any_of(header.fields.begin(), header.fields.end(), [](const auto& field) { return frameKey(field.first).has_value(); });
  if (!header.kinds.empty()) {
    const std::string last = lowerCase(header.kinds.back());
    const bool ofVolumes = header.sizes.size() == 4 && header.sizes[2] > 1;
    if (last == "list" || last == "time") return hasFrames || (!header.hasGeometry && !ofVolumes);
    const bool allInSpace = std::all_of(header.kinds.begin(), header.kinds.end(), [](const std::string& kind) {
      const std::string lower = lowerCase(kind);
      return lower == "domain" || lower == "space";
    });
    if (allInSpace && header.sizes.size() > 2) return false;
  }
  return hasFrames;
}

std::optional<std::uint64_t> productOf(std::span<const std::uint64_t> factors) {
  if (std::find(factors.begin(), factors.end(), 0u) != factors.end()) return 0;
  std::uint64_t product = 1;
  for (const std::uint64_t factor : factors) {
    if (product > std::numeric_limits<std::uint64_t>::max() / factor) return std::nullopt;
    product *= factor;
  }
  return product;
}

Message countText(std::optional<std::uint64_t> count) { return count ? verbatim(std::to_string(*count)) : say<"more than 10^19">(); }

std::string sizesText(std::span<const std::uint64_t> sizes) {
  std::string text;
  for (const std::uint64_t size : sizes) text += (text.empty() ? "" : " x ") + std::to_string(size);
  return text;
}

Message quoted(const fs::path& file) { return say<"\"%1\"">(file.filename()); }

std::string shortened(const std::string& found) {
  constexpr std::size_t longest = 80;
  std::string shown = found.substr(0, longest);
  if (found.size() > longest) shown += "...";
  for (char& letter : shown)
    if (static_cast<unsigned char>(letter) < 0x20 || static_cast<unsigned char>(letter) > 0x7e) letter = '?';
  return shown;
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n\v\f";
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string lowerCase(std::string_view text) {
  std::string lower(text);
  for (char& letter : lower)
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
  return lower;
}

std::vector<std::string> wordsOf(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n\v\f";
  std::vector<std::string> words;
  for (auto start = text.find_first_not_of(blanks); start != std::string_view::npos; start = text.find_first_not_of(blanks, start)) {
    const auto end = std::min(text.find_first_of(blanks, start), text.size());
    words.emplace_back(text.substr(start, end - start));
    start = end;
  }
  return words;
}

std::string anatomicalOrientation(const glm::dmat3& directions) {
  constexpr std::array<std::array<char, 2>, 3> sides{
      {{'R', 'L'}, {'A', 'P'}, {'I', 'S'}}};  // of x, y, z: coming from, when it grows or falls
  std::string letters;
  std::array<bool, 3> seen{};
  for (int axis = 0; axis < 3; ++axis)
    for (int row = 0; row < 3; ++row) {
      const double along = directions[axis][row];
      if (std::abs(std::abs(along) - 1.0) > 1e-6) continue;
      const auto body = static_cast<std::size_t>(row);
      letters += sides[body][along > 0.0 ? 0 : 1];
      seen[body] = true;
    }
  return letters.size() == 3 && seen[0] && seen[1] && seen[2] ? letters : std::string();
}

std::optional<double> lengthUnit_mm(std::string_view unit) {
  struct Unit {
    std::string_view name;
    double mm;
  };
  constexpr std::array units{Unit{"", 1.0},
                             Unit{"mm", 1.0},
                             Unit{"millimeter", 1.0},
                             Unit{"millimetre", 1.0},
                             Unit{"cm", 10.0},
                             Unit{"centimeter", 10.0},
                             Unit{"centimetre", 10.0},
                             Unit{"dm", 100.0},
                             Unit{"m", 1000.0},
                             Unit{"meter", 1000.0},
                             Unit{"metre", 1000.0},
                             Unit{"um", 1e-3},
                             Unit{"\xC2\xB5m", 1e-3},
                             Unit{"\xCE\xBCm", 1e-3},
                             Unit{"\xB5m", 1e-3},
                             Unit{"micron", 1e-3},
                             Unit{"micrometer", 1e-3},
                             Unit{"micrometre", 1e-3},
                             Unit{"nm", 1e-6},
                             Unit{"nanometer", 1e-6},
                             Unit{"nanometre", 1e-6},
                             Unit{"in", 25.4},
                             Unit{"inch", 25.4},
                             Unit{"inche", 25.4},
                             Unit{"km", 1e6}};
  std::string name = lowerCase(trimmed(unit));
  if (name.size() > 3 && name.ends_with('s')) name.pop_back();
  const auto* const found = std::find_if(units.begin(), units.end(), [&](const Unit& each) { return each.name == name; });
  if (found == units.end()) return std::nullopt;
  return found->mm;
}

Message unknownUnit(const fs::path& file, std::string_view unit) {
  return say<"%1 gives its sizes in \"%2\", which is no unit of length that is known; give the spacing in mm.">(
      quoted(file), shortened(std::string(unit)));
}

Result<void> checkIsFile(const fs::path& file) {
  std::error_code problem;
  const auto status = fs::status(file, problem);
  if (status.type() == fs::file_type::not_found)
    return failure(ErrorCode::notFound, say<"There is no file %1; check its name and folder.">(quoted(file)), {{"file", file.string()}});
  if (problem)
    return failure(ErrorCode::notReadable, say<"%1 cannot be read (%2); check its permissions.">(quoted(file), verbatim(problem.message())),
                   {{"file", file.string()}});
  if (status.type() != fs::file_type::regular)
    return failure(ErrorCode::notReadable, say<"%1 is not a regular file; choose a file.">(quoted(file)), {{"file", file.string()}});
  return {};
}

Result<fs::path> resolveDataFile(const fs::path& header, std::string_view name) {
  fs::path file = header.parent_path() / fs::path(std::string(name));
  auto status = checkIsFile(file);
  // The way to it is that of another computer, maybe with its backslashes: beside the header lies what was copied together.
  if (const auto last = name.find_last_of("/\\"); !status && last != std::string_view::npos && last + 1 < name.size()) {
    const fs::path beside = header.parent_path() / fs::path(std::string(name.substr(last + 1)));
    if (checkIsFile(beside)) {
      file = beside;
      status = {};
    }
  }
  if (!status && status.error().code == ErrorCode::notFound)
    return failure(ErrorCode::notFound,
                   say<"%1 keeps its samples in \"%2\", which is not there; put both files into one folder.">(
                       quoted(header), std::string(name.substr(0, 200))),
                   {{"file", header.string()}, {"missing", file.string()}});
  if (!status) return passOn(status.error());
  return file;
}

tl::unexpected<Error> badField(const fs::path& file, const Message& field, const Message& found, const Message& expected) {
  const Message seen = found.text() == nullptr ? verbatim(shortened(found.verbatim())) : found;
  return failure(
      ErrorCode::badField,
      say<"In %1, %2 is \"%3\" (expected: %4); correct the header or export the file again.">(quoted(file), field, seen, expected),
      {{"file", file.string()}, {"field", field.english()}, {"found", seen.english()}, {"expected", expected.english()}});
}

void completeGeometry(ImageHeader& header) {
  const Grid neutral;
  header.hasGeometry = header.geometry.spacing_mm != neutral.spacing_mm || header.geometry.origin_mm != neutral.origin_mm ||
                       header.geometry.directions != neutral.directions;
}

void noteUnstatedSpacing(ImageHeader& header, const std::array<bool, 3>& stated) {
  const auto known = std::count(stated.begin(), stated.end(), true);
  if (known == 3 || !header.spacingProblem.empty() || (known == 0 && !header.hasGeometry)) return;
  if (known == 0) {
    header.spacingProblem = say<"%1 gives a place but no spacing along any of its axes; give the spacing in mm.">(quoted(header.file));
    return;
  }
  const auto missing = static_cast<int>(std::find(stated.begin(), stated.end(), false) - stated.begin());
  if (known == 2) {
    header.spacingProblem = say<"%1 gives no spacing along its axis %2; give the spacing in mm.">(quoted(header.file), missing + 1);
    return;
  }
  const int other = stated[2] ? 2 : 3;
  header.spacingProblem =
      say<"%1 gives no spacing along its axes %2 and %3; give the spacing in mm.">(quoted(header.file), missing + 1, other);
}

Result<ImageHeader> readImageHeader(const fs::path& file) {
  if (const auto status = checkIsFile(file); !status) return passOn(status.error());
  if (const auto fits = checkContent(file); !fits) return passOn(fits.error());
  const std::string name = lowerCase(file.filename().string());
  if (name.ends_with(".mha") || name.ends_with(".mhd")) return readMetaHeader(file);
  if (name.ends_with(".nrrd") || name.ends_with(".nhdr")) return readNrrdHeader(file);
  if (name.ends_with(".nii") || name.ends_with(".nii.gz")) return readNiftiHeader(file);
  return failure(ErrorCode::unsupported,
                 say<"%1 has an ending that is not read; give a .mha, .mhd, .nrrd, .nhdr, .nii or .nii.gz file.">(quoted(file)),
                 {{"file", file.string()}});
}

}  // namespace ew::detail
