#include "registration_files.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "ew/core/frames.h"
#include "ew/core/numbers.h"
#include "ew/io/safe_file.h"
#include "ew/io/vector_file.h"
#include "ew/library/schema.h"

namespace ew::cli {
namespace {
namespace fs = std::filesystem;
using nlohmann::json;

tl::unexpected<Error> badLandmark(const fs::path& file, const std::string& field, const std::string& expected) {
  return failure(ErrorCode::badField, "'" + file.string() + "': " + field + " must be " + expected + ".",
                 {{"file", file.string()}, {"field", field}, {"expected", expected}});
}

Result<glm::dvec3> pointOf(const json& entry, const std::string& field, const fs::path& file, const std::string& where) {
  const auto found = entry.find(field);
  const auto bad = [&] { return badLandmark(file, where + "." + field, "a list of three numbers, in mm"); };
  if (found == entry.end() || !found->is_array() || found->size() != 3) return bad();
  glm::dvec3 point;
  for (int axis = 0; axis < 3; ++axis) {
    const json& number = (*found)[static_cast<std::size_t>(axis)];
    if (!number.is_number() || !std::isfinite(number.get<double>())) return bad();
    point[axis] = number.get<double>();
  }
  return point;
}

}  // namespace

Result<glm::dmat4> readTransform(const fs::path& file) {
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
                   "'" + file.string() + "' does not hold a transform: sixteen numbers are expected, the rows of a 4 x 4 matrix in mm" +
                       (numbers ? ", not " + std::to_string(numbers->size()) : std::string()) + ".",
                   {{"file", file.string()}});
  std::array<double, 16> rows{};
  std::copy(numbers->begin(), numbers->end(), rows.begin());
  const glm::dmat4 matrix = matrixFromRows(rows);
  if (const auto rigid = checkRigid(matrix); !rigid)
    return failure(ErrorCode::notRigid, "The transform in '" + file.string() + "' cannot be used: " + rigid.error().sentence,
                   {{"file", file.string()}});
  return matrix;
}

std::string transformText(const glm::dmat4& matrix) {
  const auto rows = rowsOf(matrix);
  std::string text;
  for (std::size_t i = 0; i < 16; ++i) text += textOf(rows[i]) + (i % 4 == 3 ? "\n" : " ");
  return text;
}

Result<LandmarkFile> readLandmarks(const fs::path& file) {
  constexpr std::size_t kMaxBytes = 16u << 20;
  const auto text = readTextFile(file, kMaxBytes);
  if (!text) return passOn(text.error());
  const auto document = parseJson(*text, file.filename().string());
  if (!document) return passOn(document.error());
  LandmarkFile found;
  const json* list = &*document;
  if (document->is_object()) {
    for (const auto& [key, value] : document->items())
      if (key != "landmarks" && key != "pick_error_mm")
        return badLandmark(file, key, "left out: only landmarks and pick_error_mm are known");
    const auto landmarks = document->find("landmarks");
    if (landmarks == document->end()) return badLandmark(file, "landmarks", "there: a list of objects with fixed_mm and moving_mm");
    list = &*landmarks;
    if (const auto pick = document->find("pick_error_mm"); pick != document->end()) {
      if (!pick->is_number() || !(pick->get<double>() > 0.0)) return badLandmark(file, "pick_error_mm", "a length above 0 mm");
      found.pickError_mm = pick->get<double>();
    }
  }
  if (!list->is_array()) return badLandmark(file, "landmarks", "a list of objects with fixed_mm and moving_mm");
  for (const json& entry : *list) {
    const std::string where = "landmarks[" + std::to_string(found.pairs.size()) + "]";
    if (!entry.is_object()) return badLandmark(file, where, "an object with fixed_mm and moving_mm");
    registration::LandmarkPair pair;
    pair.name = std::to_string(found.pairs.size() + 1);
    if (const auto name = entry.find("name"); name != entry.end()) {
      if (!name->is_string()) return badLandmark(file, where + ".name", "a text");
      if (!name->get_ref<const std::string&>().empty()) pair.name = name->get<std::string>();
    }
    const auto fixed = pointOf(entry, "fixed_mm", file, where);
    if (!fixed) return passOn(fixed.error());
    const auto moving = pointOf(entry, "moving_mm", file, where);
    if (!moving) return passOn(moving.error());
    pair.fixed_mm = *fixed;
    pair.moving_mm = *moving;
    found.pairs.push_back(std::move(pair));
  }
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
    if (progress.cancelRequested()) return failure(ErrorCode::cancelled, "Stopped as asked; nothing was written.");
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
