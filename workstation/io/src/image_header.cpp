#include "image_header.h"

#include <algorithm>
#include <charconv>
#include <limits>

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

const char* nameOf(SampleType type) {
  switch (type) {
    case SampleType::u8:
      return "8 bit unsigned";
    case SampleType::i8:
      return "8 bit signed";
    case SampleType::u16:
      return "16 bit unsigned";
    case SampleType::i16:
      return "16 bit signed";
    case SampleType::u32:
      return "32 bit unsigned";
    case SampleType::i32:
      return "32 bit signed";
    case SampleType::u64:
      return "64 bit unsigned";
    case SampleType::i64:
      return "64 bit signed";
    case SampleType::f32:
      return "32 bit floating point";
    case SampleType::f64:
      return "64 bit floating point";
    case SampleType::none:
      return "no";
  }
  return "unknown";
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
    if (last == "list" || last == "time") return hasFrames || !header.hasGeometry;
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

std::string countText(std::optional<std::uint64_t> count) { return count ? std::to_string(*count) : "more than 10^19"; }

std::string counted(std::uint64_t count, std::string_view one, std::string_view many) {
  return std::to_string(count) + " " + std::string(count == 1 ? one : many);
}

std::string sizesText(std::span<const std::uint64_t> sizes) {
  std::string text;
  for (const std::uint64_t size : sizes) text += (text.empty() ? "" : " x ") + std::to_string(size);
  return text;
}

std::string quoted(const fs::path& file) { return "\"" + file.filename().string() + "\""; }

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

Result<void> checkIsFile(const fs::path& file) {
  std::error_code problem;
  const auto status = fs::status(file, problem);
  if (status.type() == fs::file_type::not_found)
    return failure(ErrorCode::notFound, "There is no file " + quoted(file) + "; check its name and folder.", {{"file", file.string()}});
  if (problem)
    return failure(ErrorCode::notReadable, quoted(file) + " cannot be read (" + problem.message() + "); check its permissions.",
                   {{"file", file.string()}});
  if (status.type() != fs::file_type::regular)
    return failure(ErrorCode::notReadable, quoted(file) + " is not a regular file; choose a file.", {{"file", file.string()}});
  return {};
}

Result<fs::path> resolveDataFile(const fs::path& header, std::string_view name) {
  const fs::path file = header.parent_path() / fs::path(std::string(name));
  const auto status = checkIsFile(file);
  if (!status && status.error().code == ErrorCode::notFound)
    return failure(ErrorCode::notFound,
                   quoted(header) + " keeps its samples in \"" + std::string(name.substr(0, 200)) +
                       "\", which is not there; put both files into one folder.",
                   {{"file", header.string()}, {"missing", file.string()}});
  if (!status) return passOn(status.error());
  return file;
}

tl::unexpected<Error> badField(const fs::path& file, std::string_view field, std::string_view found, std::string_view expected) {
  constexpr std::size_t longest = 80;
  std::string shown(found.substr(0, longest));
  if (found.size() > longest) shown += "...";
  for (char& letter : shown)
    if (static_cast<unsigned char>(letter) < 0x20 || static_cast<unsigned char>(letter) > 0x7e) letter = '?';
  return failure(ErrorCode::badField,
                 "In " + quoted(file) + ", " + std::string(field) + " is \"" + shown + "\", but " + std::string(expected) +
                     " is needed; correct the header or export the file again.",
                 {{"file", file.string()}, {"field", std::string(field)}, {"found", shown}, {"expected", std::string(expected)}});
}

void completeGeometry(ImageHeader& header) {
  const Grid neutral;
  header.hasGeometry = header.geometry.spacing_mm != neutral.spacing_mm || header.geometry.origin_mm != neutral.origin_mm ||
                       header.geometry.directions != neutral.directions;
}

Result<ImageHeader> readImageHeader(const fs::path& file) {
  if (const auto status = checkIsFile(file); !status) return passOn(status.error());
  const std::string name = lowerCase(file.filename().string());
  if (name.ends_with(".mha") || name.ends_with(".mhd")) return readMetaHeader(file);
  if (name.ends_with(".nrrd") || name.ends_with(".nhdr")) return readNrrdHeader(file);
  if (name.ends_with(".nii") || name.ends_with(".nii.gz")) return readNiftiHeader(file);
  return failure(ErrorCode::unsupported,
                 quoted(file) + " has an ending that is not read; give a .mha, .mhd, .nrrd, .nhdr, .nii or .nii.gz file.",
                 {{"file", file.string()}});
}

}  // namespace ew::detail
