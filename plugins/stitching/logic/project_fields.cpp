#include "logic/project_fields.h"

#include <algorithm>

namespace ew::stitching {

namespace fs = std::filesystem;
using nlohmann::json;

std::string shown(const json& value) {
  if (value.is_object()) return "an object";
  if (value.is_array()) return "a list of " + std::to_string(value.size());
  return value.dump(-1, ' ', false, json::error_handler_t::replace).substr(0, 80);
}

tl::unexpected<Error> badField(const std::string& field, const std::string& found, const std::string& expected) {
  return failure(ErrorCode::badField, "'" + field + "' in the stitch project is " + found + "; it must be " + expected + ".",
                 {{"field", field}, {"found", found}, {"expected", expected}});
}

const json* Fields::find(const char* field) const {
  const auto at = object_.find(field);
  return at == object_.end() ? nullptr : &*at;
}

Result<void> Fields::only(std::initializer_list<const char*> known) const {
  for (const auto& [name, value] : object_.items())
    if (std::find(known.begin(), known.end(), name) == known.end())
      return failure(ErrorCode::badField,
                     "'" + nameOf(name.c_str()) + "' in the stitch project is not a field of it; correct the name or remove the field.",
                     {{"field", nameOf(name.c_str())}, {"found", shown(value)}});
  return {};
}

Result<void> Fields::number(const char* field, double& into, double least, double most, const char* expected) const {
  const json* value = find(field);
  if (value == nullptr) return {};
  if (!value->is_number()) return badField(nameOf(field), shown(*value), expected);
  const double read = value->get<double>();
  if (!(read >= least && read <= most)) return badField(nameOf(field), shown(*value), expected);
  into = read;
  return {};
}

Result<void> Fields::yesOrNo(const char* field, bool& into) const {
  const json* value = find(field);
  if (value == nullptr) return {};
  if (!value->is_boolean()) return badField(nameOf(field), shown(*value), "true or false");
  into = value->get<bool>();
  return {};
}

Result<std::string> Fields::text(const char* field, const char* expected) const {
  const json* value = find(field);
  if (value == nullptr) return std::string();
  if (!value->is_string() || value->get_ref<const std::string&>().empty()) return badField(nameOf(field), shown(*value), expected);
  return value->get<std::string>();
}

Result<void> Fields::point(const char* field, glm::dvec3& into) const {
  const json* value = find(field);
  const bool three = value != nullptr && value->is_array() && value->size() == 3 &&
                     std::all_of(value->begin(), value->end(), [](const json& n) { return n.is_number(); });
  if (!three) return badField(nameOf(field), value == nullptr ? "missing" : shown(*value), "three numbers, in mm");
  for (int axis = 0; axis < 3; ++axis) into[axis] = (*value)[static_cast<std::size_t>(axis)].get<double>();
  return {};
}

Result<glm::dmat4> Fields::place(const char* field, const fs::path& folder, sdk::Files& files) const {
  const json& value = *find(field);
  if (value.is_string()) {
    const fs::path file = folder / value.get<std::string>();
    auto read = files.readText(file);
    if (!read) return passOn(read.error());
    return parseTransform(*read, file.filename().string());
  }
  const bool sixteen =
      value.is_array() && value.size() == 16 && std::all_of(value.begin(), value.end(), [](const json& n) { return n.is_number(); });
  if (!sixteen) return badField(nameOf(field), shown(value), "16 numbers, row by row, or the name of a file that holds them");
  std::array<double, 16> rows{};
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = value[i].get<double>();
  const glm::dmat4 matrix = matrixFromRows(rows);
  if (auto rigid = checkRigid(matrix); !rigid) {
    Error problem = rigid.error();
    problem.sentence = "'" + nameOf(field) + "' in the stitch project cannot be used. " + problem.sentence;
    problem.context.emplace_back("field", nameOf(field));
    return passOn(std::move(problem));
  }
  return matrix;
}

Result<std::vector<Fields>> Fields::objects(const char* field, const char* expected) const {
  std::vector<Fields> list;
  const json* value = find(field);
  if (value == nullptr) return list;
  if (!value->is_array()) return badField(nameOf(field), shown(*value), expected);
  for (std::size_t n = 0; n < value->size(); ++n) {
    const std::string name = nameOf(field) + "[" + std::to_string(n) + "]";
    if (!(*value)[n].is_object()) return badField(name, shown((*value)[n]), "an object");
    list.emplace_back((*value)[n], name);
  }
  return list;
}

Result<Fields> Fields::object(const char* field) const {
  static const json kNothing = json::object();
  const json* value = find(field);
  if (value == nullptr) return Fields(kNothing, nameOf(field));
  if (!value->is_object()) return badField(nameOf(field), shown(*value), "an object");
  return Fields(*value, nameOf(field));
}

}  // namespace ew::stitching
