#include "logic/project.h"

#include <algorithm>
#include <array>
#include <initializer_list>

#include "ew/core/nesting.h"
#include "ew/core/numbers.h"
#include "ew/core/version.h"

namespace ew::stitching {
namespace {

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

Result<void> onlyKnown(const json& object, const std::string& prefix, std::initializer_list<const char*> known) {
  for (const auto& [name, value] : object.items())
    if (std::find(known.begin(), known.end(), name) == known.end())
      return failure(ErrorCode::badField,
                     "'" + prefix + name + "' in the stitch project is not a field of it; correct the name or remove the field.",
                     {{"field", prefix + name}, {"found", shown(value)}});
  return {};
}

Result<void> readNumber(const json& object, const char* name, double& into) {
  if (!object.contains(name)) return {};
  if (!object[name].is_number()) return badField(name, shown(object[name]), "a number");
  into = object[name].get<double>();
  return {};
}

Result<std::string> text(const json& object, const char* name, const std::string& field) {
  if (!object.contains(name)) return std::string();
  if (!object[name].is_string() || object[name].get_ref<const std::string&>().empty())
    return badField(field, shown(object[name]), "a file name");
  return object[name].get<std::string>();
}

Result<glm::dmat4> placeOf(const json& value, const std::string& field, const fs::path& folder, sdk::Files& files) {
  if (value.is_string()) {
    const fs::path file = folder / value.get<std::string>();
    auto read = files.readText(file);
    if (!read) return passOn(read.error());
    return parseTransform(*read, file.filename().string());
  }
  const bool sixteen =
      value.is_array() && value.size() == 16 && std::all_of(value.begin(), value.end(), [](const json& n) { return n.is_number(); });
  if (!sixteen) return badField(field, shown(value), "16 numbers, row by row, or the name of a file that holds them");
  std::array<double, 16> rows{};
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = value[i].get<double>();
  const glm::dmat4 matrix = matrixFromRows(rows);
  if (auto rigid = checkRigid(matrix); !rigid) {
    Error problem = rigid.error();
    problem.sentence = "'" + field + "' in the stitch project cannot be used. " + problem.sentence;
    problem.context.emplace_back("field", field);
    return passOn(std::move(problem));
  }
  return matrix;
}

Result<ProjectVolume> volumeOf(const json& entry, const std::string& prefix, const fs::path& folder, sdk::Files& files) {
  if (!entry.is_object()) return badField(prefix, shown(entry), "an object with file and to_world");
  if (auto known = onlyKnown(entry, prefix + ".", {"file", "coverage", "name", "to_world"}); !known) return passOn(known.error());
  if (!entry.contains("file")) return badField(prefix + ".file", "missing", "the name of a volume file");
  ProjectVolume volume;
  auto file = text(entry, "file", prefix + ".file");
  if (!file) return passOn(file.error());
  volume.file = folder / *file;
  auto coverage = text(entry, "coverage", prefix + ".coverage");
  if (!coverage) return passOn(coverage.error());
  if (!coverage->empty()) volume.coverage = folder / *coverage;
  auto name = text(entry, "name", prefix + ".name");
  if (!name) return passOn(name.error());
  volume.name = name->empty() ? volume.file.filename().string() : *name;
  if (entry.contains("to_world")) {
    auto place = placeOf(entry["to_world"], prefix + ".to_world", folder, files);
    if (!place) return passOn(place.error());
    volume.toWorld = *place;
  }
  return volume;
}

std::string relativeText(const fs::path& file, const fs::path& folder) {
  const fs::path relative = file.lexically_relative(folder);
  const bool below = !relative.empty() && *relative.begin() != "..";
  return (below && !folder.empty() ? relative : file).generic_string();
}

}  // namespace

Result<glm::dmat4> parseTransform(const std::string& text, const std::string& name) {
  const auto numbers = parseNumbers(text);
  if (!numbers || numbers->size() != 16)
    return failure(ErrorCode::badField,
                   "'" + name + "' holds " + (numbers ? std::to_string(numbers->size()) + " numbers" : "something that is not a number") +
                       "; a transform is 16 numbers, row by row.",
                   {{"file", name}});
  std::array<double, 16> rows{};
  std::copy(numbers->begin(), numbers->end(), rows.begin());
  const glm::dmat4 matrix = matrixFromRows(rows);
  if (auto rigid = checkRigid(matrix); !rigid) {
    Error problem = rigid.error();
    problem.sentence = "The transform in '" + name + "' cannot be used. " + problem.sentence;
    problem.context.emplace_back("file", name);
    return passOn(std::move(problem));
  }
  return matrix;
}

Result<StitchProject> parseProject(const std::string& textOfProject, const fs::path& folder, sdk::Files& files) {
  if (nestsDeeperThan(textOfProject))
    return failure(ErrorCode::badHeader, "The stitch project nests too deeply to be one; check that it is the right file.");
  json document;
  try {
    document = json::parse(textOfProject);
  } catch (const json::exception& problem) {
    return failure(ErrorCode::badHeader,
                   "The stitch project is not valid JSON; correct the place named at the end of this message or choose "
                   "another file (" +
                       std::string(problem.what()) + ").");
  }
  if (!document.is_object()) return badField("the whole file", shown(document), "an object with the field volumes");
  if (document.contains("format")) {
    const json& format = document["format"];
    if (!format.is_number_integer() || format.get<double>() < 1) return badField("format", shown(format), "a whole number from 1");
    if (format.get<double>() > kProjectFormat)
      return failure(ErrorCode::newerFormat,
                     "The stitch project has format " + format.dump() + ", and this program reads formats up to " +
                         std::to_string(kProjectFormat) + "; open it with a newer EchoWeave.",
                     {{"found", format.dump()}, {"expected", "at most " + std::to_string(kProjectFormat)}});
  }
  if (auto known = onlyKnown(document, "", {"format", "volumes", "spacing_mm", "feather_mm", "interpolated_weight", "axes"}); !known)
    return passOn(known.error());
  if (!document.contains("volumes") || !document["volumes"].is_array() || document["volumes"].empty())
    return badField("volumes", document.contains("volumes") ? shown(document["volumes"]) : "missing", "a list of at least one volume");

  StitchProject project;
  for (std::size_t n = 0; n < document["volumes"].size(); ++n) {
    auto volume = volumeOf(document["volumes"][n], "volumes[" + std::to_string(n) + "]", folder, files);
    if (!volume) return passOn(volume.error());
    project.volumes.push_back(std::move(*volume));
  }
  for (const auto& [name, into] :
       {std::pair{"spacing_mm", &project.options.spacing_mm}, std::pair{"feather_mm", &project.options.featherWidth_mm},
        std::pair{"interpolated_weight", &project.options.interpolatedWeight}})
    if (auto read = readNumber(document, name, *into); !read) return passOn(read.error());
  if (!(project.options.spacing_mm >= 0.0))
    return badField("spacing_mm", shown(document["spacing_mm"]), "a positive number, or 0 for the finest");
  if (!(project.options.featherWidth_mm >= 0.0)) return badField("feather_mm", shown(document["feather_mm"]), "0 or a positive number");
  if (!(project.options.interpolatedWeight > 0.0 && project.options.interpolatedWeight <= 1.0))
    return badField("interpolated_weight", shown(document["interpolated_weight"]), "above 0 and at most 1");
  if (document.contains("axes")) {
    const json& axes = document["axes"];
    if (axes != "first" && axes != "world") return badField("axes", shown(axes), "\"first\" or \"world\"");
    project.options.axes = axes == "world" ? GridAxes::world : GridAxes::first;
  }
  return project;
}

std::string projectText(const StitchProject& project, const fs::path& folder) {
  nlohmann::ordered_json document;
  document["format"] = kProjectFormat;
  document["volumes"] = nlohmann::ordered_json::array();
  for (const auto& volume : project.volumes) {
    nlohmann::ordered_json entry;
    entry["file"] = relativeText(volume.file, folder);
    if (!volume.coverage.empty()) entry["coverage"] = relativeText(volume.coverage, folder);
    entry["name"] = volume.name;
    entry["to_world"] = rowsOf(volume.toWorld);
    document["volumes"].push_back(entry);
  }
  document["spacing_mm"] = project.options.spacing_mm;
  document["feather_mm"] = project.options.featherWidth_mm;
  document["interpolated_weight"] = project.options.interpolatedWeight;
  document["axes"] = project.options.axes == GridAxes::world ? "world" : "first";
  return document.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

Result<std::vector<PlacedVolume>> readVolumes(const StitchProject& project, sdk::Volumes& volumes, Progress& progress) {
  std::vector<PlacedVolume> read;
  const double share = project.volumes.empty() ? 1.0 : 1.0 / static_cast<double>(project.volumes.size());
  for (const auto& each : project.volumes) {
    if (progress.cancelRequested()) return failure(ErrorCode::cancelled, "The stitching was cancelled.");
    PartOfProgress part(progress, share * static_cast<double>(read.size()), share * static_cast<double>(read.size() + 1));
    part.report("Reading " + each.name, 0.0);
    auto volume = volumes.read(each.file, part);
    if (!volume) return passOn(volume.error());
    if (!each.coverage.empty())
      if (auto coverage = volumes.readCoverageInto(*volume, each.coverage, part); !coverage) return passOn(coverage.error());
    read.push_back({std::move(*volume), each.toWorld, each.name});
  }
  return read;
}

}  // namespace ew::stitching
