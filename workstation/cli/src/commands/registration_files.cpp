#include "commands/registration_files.h"

#include <nlohmann/json.hpp>

#include "ew/core/frames.h"
#include "ew/core/json_fields.h"
#include "ew/core/numbers.h"
#include "ew/io/safe_file.h"
#include "ew/io/vector_file.h"

namespace ew::cli {
namespace {
namespace fs = std::filesystem;
using nlohmann::json;

constexpr double kFarthestLandmark_mm = 1e6;
constexpr std::size_t kMostLandmarks = 100000, kLongestLandmarkName = 1000;
constexpr double kSmallestPickError_mm = 1e-9, kLargestPickError_mm = 1e6;

}  // namespace

Result<Transform<frame::Moving, frame::Fixed>> readTransform(const fs::path& file) {
  constexpr std::size_t kMaxBytes = 1u << 20;
  const auto text = readTextFile(file, kMaxBytes);
  if (!text) return passOn(text.error());
  std::string plain;
  bool comment = false;
  for (const char c : *text) {
    comment = c == '#' || (comment && c != '\n');
    plain += comment || c == '\n' || c == '\r' || c == '\t' || c == ',' ? ' ' : c;
  }
  const auto numbers = parseNumbers(plain);
  if (!numbers || numbers->size() != 16)
    return failure(ErrorCode::badField,
                   numbers ? say<"'%1' does not hold a transform: sixteen numbers are expected, the rows of a 4 x 4 matrix in mm, not %2.">(
                                 file, numbers->size())
                           : say<"'%1' does not hold a transform: sixteen numbers are expected, the rows of a 4 x 4 matrix in mm.">(file),
                   {{"file", file.string()}});
  std::array<double, 16> rows{};
  std::copy(numbers->begin(), numbers->end(), rows.begin());
  const Transform<frame::Moving, frame::Fixed> fixedToMoving{matrixFromRows(rows)};
  if (const auto rigid = checkRigid(fixedToMoving); !rigid)
    return failure(ErrorCode::notRigid, say<"The transform in '%1' cannot be used: %2">(file.string(), rigid.error().message),
                   {{"file", file.string()}});
  return fixedToMoving;
}

std::string transformText(const Transform<frame::Moving, frame::Fixed>& fixedToMoving) {
  const auto rows = rowsOf(fixedToMoving);
  std::string text;
  for (std::size_t i = 0; i < 16; ++i) text += textOf(rows[i]) + (i % 4 == 3 ? "\n" : " ");
  return text;
}

Result<LandmarkFile> readLandmarks(const fs::path& file) {
  constexpr std::size_t kMaxBytes = 16u << 20;
  const auto text = readTextFile(file, kMaxBytes);
  if (!text) return passOn(text.error());
  const auto document = parseJson(*text, verbatim(file.filename().string()));
  if (!document) return passOn(document.error());
  LandmarkFile found;
  JsonReading reading(verbatim("'" + file.string() + "'"));
  const json whole = document->is_array() ? json{{"landmarks", *document}} : *document;
  const JsonFields fields(whole, reading);
  fields.only({"landmarks", "pick_error_mm"});
  if (fields.has("pick_error_mm"))
    found.pickError_mm = fields.number("pick_error_mm", kSmallestPickError_mm, kLargestPickError_mm, {}, say<"a length above 0 mm">());
  const Message pairs = say<"a list of objects with fixed_mm and moving_mm">(), three = say<"a list of three numbers, in mm">();
  if (!fields.has("landmarks")) fields.refuse("landmarks", pairs);
  for (const JsonFields& entry : fields.objects("landmarks", 0, kMostLandmarks, pairs)) {
    registration::LandmarkPair pair;
    pair.name = entry.text("name", "", 0, kLongestLandmarkName);
    if (pair.name.empty()) pair.name = std::to_string(found.pairs.size() + 1);
    pair.fixed_mm = entry.point("fixed_mm", kFarthestLandmark_mm, {}, three);
    pair.moving_mm = entry.point("moving_mm", kFarthestLandmark_mm, {}, three);
    found.pairs.push_back(std::move(pair));
  }
  if (reading.problem()) return passOn(*reading.problem());
  return found;
}

Result<void> writeField(const registration::Deformation& fixedToMoving, const Grid& fixed, bool flat, const fs::path& file, int threads,
                        Progress& progress) {
  const std::size_t components = flat ? 2 : 3;
  const auto slices = [&](int first, int count, std::span<float> out) -> Result<void> {
    Grid part = fixed;
    part.dims.z = count;
    part.origin_mm += fixed.directions[2] * (fixed.spacing_mm.z * first);
    PartOfProgress silent(noProgress(), 0.0, 1.0);
    if (progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"Stopped as asked; nothing was written.">());
    const auto field = registration::fieldOf(fixedToMoving, part, threads, silent);
    if (!field) return passOn(field.error());
    std::size_t at = 0;
    for (const glm::vec3& displacement : field->displacement_mm)
      for (std::size_t c = 0; c < components; ++c) out[at++] = displacement[static_cast<int>(c)];
    return {};
  };
  return writeVectorField(fixed, static_cast<int>(components), file, slices, progress);
}

}  // namespace ew::cli
