#include "ew/phantom/patient.h"

#include <set>

#include "anatomy.h"
#include "ew/core/numbers.h"
#include "kept_distance.h"
#include "recipe.h"
#include "whole_recipe.h"

namespace ew {
namespace {

using nlohmann::json;
using phantom::FieldReader;

constexpr double kSkinSpacing_mm = 4.0;
constexpr double kLargestBox_mm3 = 1e9;          // a cubic metre holds a person lying down; the skin is sampled all over the box
constexpr double kMostSolidsOfOrgans = 50000.0;  // asked for one point inside all organs
constexpr std::uint64_t kVoxelVersion = 1;       // raise when the same recipe starts to give other voxels

std::uint64_t fnv1a(const std::string& text, std::uint64_t hash) {
  for (const char letter : text) hash = (hash ^ static_cast<unsigned char>(letter)) * 1099511628211ull;
  return hash;
}

Result<std::filesystem::path> findMannequin(FieldReader& reader, const json& recipe, const std::filesystem::path& file,
                                            const std::filesystem::path& mannequins) {
  const std::string name = reader.text(recipe, "patient", "mannequin");
  if (!reader.problem() && std::filesystem::path(name).has_parent_path())
    reader.refuse("mannequin", '"' + name + '"', "the name of a file in resources/mannequin, without a folder");
  if (reader.problem()) return passOn(*reader.problem());
  const auto found = phantom::findNamed(name, "mannequin", file, mannequins);
  if (!found.empty()) return found;
  return failure(ErrorCode::notFound,
                 file.string() + " needs the mannequin " + name + ", which is neither beside it nor in resources/mannequin; put it there.",
                 {{"file", file.string()}, {"mannequin", name}});
}

Bounds readBox(FieldReader& reader, const json& recipe) {
  Bounds read;
  const auto box = recipe.find("box");
  if (box == recipe.end()) reader.refuse("box", "missing", "an object with lowest_mm and highest_mm");
  if (!reader.problem()) reader.allow(*box, "box", {"lowest_mm", "highest_mm"});
  if (reader.problem()) return read;
  read = {reader.vector(*box, "box", "lowest_mm"), reader.vector(*box, "box", "highest_mm")};
  const glm::dvec3 size = read.highest_mm - read.lowest_mm;
  for (int axis = 0; axis < 3; ++axis) {
    if (!(size[axis] >= 1.0 && size[axis] <= 3000.0))
      reader.refuse("box.highest_mm", "not 1 to 3000 mm above lowest_mm", "the upper corner of the box");
  }
  if (!(size.x * size.y * size.z <= kLargestBox_mm3))
    reader.refuse("box", "larger than a cubic metre", "the part of the body that is drawn");
  return read;
}

Tissue readTissue(FieldReader& reader, const json& object, const std::string& place) {
  Tissue tissue;
  reader.allow(object, place,
               {"echo_level", "speckle", "attenuation_db_per_cm_mhz", "reflection_db", "texture", "impedance_mrayl", "speed_m_per_s",
                "scatterers_per_mm3"});
  if (reader.problem()) return tissue;
  tissue.name = reader.text(object, place, "name");
  tissue.echoLevel = reader.number(object, place, "echo_level", 0.0, 255.0);
  tissue.speckle = reader.number(object, place, "speckle", 0.0, 1.0);
  tissue.attenuation_dbPerCmMhz = reader.number(object, place, "attenuation_db_per_cm_mhz", 0.0, 100.0, 0.5);
  tissue.reflection_db = reader.number(object, place, "reflection_db", 0.0, 60.0, 0.0);
  tissue.impedance_mrayl = reader.number(object, place, "impedance_mrayl", 1e-4, 20.0, tissue.impedance_mrayl);
  tissue.speed_mPerS = reader.number(object, place, "speed_m_per_s", 200.0, 6000.0, tissue.speed_mPerS);
  if (object.contains("scatterers_per_mm3")) tissue.scatterers_perMm3 = reader.number(object, place, "scatterers_per_mm3", 0.0, 1000.0);
  if (const auto texture = object.find("texture"); texture != object.end()) {
    const std::string at = place + ".texture";
    reader.allow(*texture, at, {"level", "scale_mm", "follows_the_skin"});
    if (reader.problem()) return tissue;
    tissue.texture.level = reader.number(*texture, at, "level", 0.0, 255.0);
    tissue.texture.scale_mm = reader.vector(*texture, at, "scale_mm");
    for (int axis = 0; axis < 3; ++axis) {
      if (!(tissue.texture.scale_mm[axis] >= 0.1)) reader.refuse(at + ".scale_mm", "not positive", "three sizes of at least 0.1 mm");
    }
    tissue.texture.followsTheSkin = reader.flag(*texture, at, "follows_the_skin", false);
  }
  return tissue;
}

std::vector<Tissue> readTissues(FieldReader& reader, const json& recipe) {
  std::vector<Tissue> read;
  std::set<std::string> names;
  const json& tissues = reader.list(recipe, "patient", "tissues", 1, 254);
  for (std::size_t n = 0; n < tissues.size() && !reader.problem(); ++n) {
    const std::string at = "tissues[" + std::to_string(n) + "]";
    read.push_back(readTissue(reader, tissues[n], at));
    if (!reader.problem() && !names.insert(read.back().name).second)
      reader.refuse(at + ".name", '"' + read.back().name + '"', "a name that is not taken yet");
  }
  return read;
}

std::size_t tissueNamed(FieldReader& reader, const json& object, const std::string& place, const std::string& field,
                        const std::vector<Tissue>& tissues) {
  const std::string name = reader.text(object, place, field);
  if (reader.problem()) return 0;
  for (std::size_t n = 0; n < tissues.size(); ++n) {
    if (tissues[n].name == name) return n;
  }
  const std::string names = phantom::listed(tissues, [](const Tissue& tissue) { return tissue.name; });
  reader.refuse(place + "." + field, '"' + name + '"', "one of the tissues (" + names + ")");
  return 0;
}

std::optional<phantom::Border> readBorder(FieldReader& reader, const json& object, const std::string& place) {
  const auto border = object.find("border");
  if (border == object.end()) return std::nullopt;
  const std::string at = place + ".border";
  reader.allow(*border, at, {"echo_level", "width_mm", "shine"});
  if (reader.problem()) return std::nullopt;
  phantom::Border read;
  read.echoLevel = reader.number(*border, at, "echo_level", 0.0, 255.0);
  read.width_mm = reader.number(*border, at, "width_mm", 0.05, 50.0);
  const std::string shine = reader.text(*border, at, "shine", "glint");
  if (shine == "front") read.shine = phantom::Shine::front;
  if (shine == "all round") read.shine = phantom::Shine::allRound;
  if (shine != "glint" && shine != "front" && shine != "all round")
    reader.refuse(at + ".shine", '"' + shine + '"', "\"glint\", \"front\" or \"all round\"");
  return read;
}

void readOrgans(FieldReader& reader, const json& recipe, phantom::NamedShapes known, Patient& patient) {
  const phantom::NamedFrames frames = phantom::readFrames(reader, recipe);
  if (recipe.contains("shapes")) {
    const json& shapes = reader.list(recipe, "patient", "shapes", 0, 200);
    for (std::size_t n = 0; n < shapes.size() && !reader.problem(); ++n) {
      const std::string at = "shapes[" + std::to_string(n) + "]";
      if (!shapes[n].is_object()) return reader.refuse(at, "not an object", "a named shape");
      const std::string name = reader.text(shapes[n], at, "name");
      if (known.count(name) > 0) reader.refuse(at + ".name", '"' + name + '"', "a name that is not taken yet");
      phantom::ShapePtr shape = phantom::readShape(reader, shapes[n], at + " (" + name + ")", known, frames);
      if (!reader.problem()) known.emplace(name, std::move(shape));
    }
  }
  double solids = 0.0;
  const json& organs = reader.list(recipe, "patient", "organs", 1, 254);
  for (std::size_t n = 0; n < organs.size() && !reader.problem(); ++n) {
    std::string at = "organs[" + std::to_string(n) + "]";
    reader.allow(organs[n], at, {"tissue", "shape", "border"});
    if (reader.problem()) return;
    phantom::Organ organ;
    organ.name = reader.text(organs[n], at, "name");
    at += " (" + organ.name + ")";
    if (known.count(organ.name) > 0) reader.refuse(at + ".name", '"' + organ.name + '"', "a name that is not taken yet");
    organ.tissue = tissueNamed(reader, organs[n], at, "tissue", patient.tissues);
    if (!organs[n].contains("shape")) reader.refuse(at + ".shape", "missing", "a shape");
    if (reader.problem()) return;
    organ.shape = phantom::readShape(reader, organs[n]["shape"], at + ".shape", known, frames);
    organ.border = readBorder(reader, organs[n], at);
    if (reader.problem()) return;
    solids += organ.shape->solids();
    if (solids > kMostSolidsOfOrgans)
      return reader.refuse(at + ".shape", "one solid too many with those of the organs before it",
                           "at most " + textOf(kMostSolidsOfOrgans) + " in all organs, a shared one counted at every use");
    known.emplace(organ.name, organ.shape);
    patient.organs.push_back(std::move(organ));
  }
  patient.shapes = std::move(known);
}

}  // namespace

Result<std::shared_ptr<const Patient>> readPatient(const std::filesystem::path& file, const std::filesystem::path& mannequins,
                                                   const ParameterValues& parameters, Progress& progress) {
  const auto whole = phantom::readWholeRecipe(file, mannequins, parameters);
  if (!whole) return passOn(whole.error());
  const json* recipe = &whole->json;
  FieldReader reader(file.string());
  const auto stopped = [] { return failure(ErrorCode::cancelled, "Reading the patient was stopped."); };
  auto patient = std::make_shared<Patient>();
  patient->parameters = whole->parameters;
  reader.allow(*recipe, "patient",
               {"format", "mannequin", "box", "beam_axis_mm", "scatterers", "tissues", "background", "frames", "shapes", "organs", "motion",
                "measurements", "planes"});
  patient->name = reader.text(*recipe, "patient", "name");

  patient->box = readBox(reader, *recipe);

  if (recipe->contains("beam_axis_mm")) {
    const json& axis = reader.list(*recipe, "patient", "beam_axis_mm", 2, 2);
    for (std::size_t n = 0; n < axis.size(); ++n) {
      const char* name = n == 0 ? "x" : "y";
      patient->beamAxis_mm[static_cast<int>(n)] = reader.number(json{{name, axis[n]}}, "beam_axis_mm", name, -1e4, 1e4);
    }
  }

  if (const auto scatterers = recipe->find("scatterers"); scatterers != recipe->end()) {
    reader.allow(*scatterers, "scatterers", {"pitch_mm"});
    if (!reader.problem()) patient->scattererPitch_mm = reader.number(*scatterers, "scatterers", "pitch_mm", 0.05, 5.0);
  }
  patient->tissues = readTissues(reader, *recipe);
  patient->backgroundTissue = tissueNamed(reader, *recipe, "patient", "background", patient->tissues);
  const auto bodyFile = findMannequin(reader, *recipe, file, mannequins);
  if (!bodyFile) return passOn(bodyFile.error());
  auto body = readBodyShape(*bodyFile);
  if (!body) return passOn(body.error());
  if (reader.problem()) return passOn(*reader.problem());
  PartOfProgress skin(progress, 0.0, 0.6), moving(progress, 0.6, 1.0);
  patient->skin = phantom::keepDistance(std::move(*body), patient->box, kSkinSpacing_mm, skin);
  if (!patient->skin) return stopped();
  readOrgans(reader, *recipe, {{"skin surface", patient->skin}}, *patient);
  if (const auto motion = recipe->find("motion"); motion != recipe->end() && !reader.problem())
    patient->motion = phantom::readMotion(reader, *motion, patient->box, patient->skin, patient->shapes, moving);
  if (progress.cancelRequested()) return stopped();
  patient->planes = phantom::readPlanes(reader, *recipe, patient->skin, patient->shapes, progress);
  if (progress.cancelRequested()) return stopped();
  patient->measurements = phantom::readMeasurements(reader, *recipe, patient->shapes, patient->planes);
  if (reader.problem()) return passOn(*reader.problem());
  return patient;
}

Result<Bounds> readPatientBox(const std::filesystem::path& file, const std::filesystem::path& mannequins,
                              const ParameterValues& parameters) {
  const auto whole = phantom::readWholeRecipe(file, mannequins, parameters);
  if (!whole) return passOn(whole.error());
  FieldReader reader(file.string());
  const Bounds box = readBox(reader, whole->json);
  if (reader.problem()) return passOn(*reader.problem());
  return box;
}

Result<std::uint64_t> fingerprintOfPatient(const std::filesystem::path& file, const std::filesystem::path& mannequins,
                                           const ParameterValues& parameters) {
  const auto whole = phantom::readWholeRecipe(file, mannequins, parameters);
  if (!whole) return passOn(whole.error());
  FieldReader reader(file.string());
  const auto bodyFile = findMannequin(reader, whole->json, file, mannequins);
  if (!bodyFile) return passOn(bodyFile.error());
  const auto body = phantom::readRecipe(*bodyFile, "mannequin recipe");
  if (!body) return passOn(body.error());
  return fnv1a(body->dump(), fnv1a(whole->json.dump(), 14695981039346656037ull ^ kVoxelVersion));
}

std::vector<OrganName> organsOf(const Patient& patient) {
  std::vector<OrganName> names;
  for (std::size_t n = 0; n < patient.organs.size(); ++n) names.push_back({static_cast<int>(n) + 1, patient.organs[n].name});
  return names;
}

Result<std::vector<LabelTissue>> readLabelTissues(const std::filesystem::path& file, const std::filesystem::path& mannequins,
                                                  const ParameterValues& parameters) {
  const auto whole = phantom::readWholeRecipe(file, mannequins, parameters);
  if (!whole) return passOn(whole.error());
  const json* recipe = &whole->json;
  FieldReader reader(file.string());
  const std::vector<Tissue> tissues = readTissues(reader, *recipe);
  const std::size_t background = tissueNamed(reader, *recipe, "patient", "background", tissues);
  if (reader.problem()) return passOn(*reader.problem());
  std::vector<LabelTissue> labels{{0, "", tissues[background]}};
  const json& organs = reader.list(*recipe, "patient", "organs", 1, 254);
  for (std::size_t n = 0; n < organs.size() && !reader.problem(); ++n) {
    const std::string at = "organs[" + std::to_string(n) + "]";
    if (!organs[n].is_object()) reader.refuse(at, "not an object", "an organ");
    const std::string name = reader.text(organs[n], at, "name");
    const std::size_t tissue = tissueNamed(reader, organs[n], at, "tissue", tissues);
    if (!reader.problem()) labels.push_back({static_cast<int>(n) + 1, name, tissues[tissue]});
  }
  if (reader.problem()) return passOn(*reader.problem());
  return labels;
}

const std::vector<PatientParameter>& parametersOf(const Patient& patient) { return patient.parameters; }

Bounds boxOf(const Patient& patient) { return patient.box; }

Result<double> signedDistance_mm(const Patient& patient, const std::string& organ, const glm::dvec3& p_world_mm) {
  for (const phantom::Organ& each : patient.organs) {
    if (each.name == organ) return each.shape->distance_mm(p_world_mm);
  }
  if (organ == "skin surface") return patient.skin->distance_mm(p_world_mm);
  const std::string names = phantom::listed(patient.organs, [](const phantom::Organ& each) { return each.name; });
  return failure(ErrorCode::badField, "The patient has no organ " + organ + "; its organs are " + names + ".", {{"organ", organ}});
}

int labelAt(const Patient& patient, const glm::dvec3& p_world_mm) {
  if (patient.skin->distance_mm(p_world_mm) >= 0.0) return 0;
  for (std::size_t n = 0; n < patient.organs.size(); ++n) {
    const phantom::Shape& shape = *patient.organs[n].shape;
    if (shape.atLeast_mm(p_world_mm) <= 0.0 && shape.distance_mm(p_world_mm) < 0.0) return static_cast<int>(n) + 1;
  }
  return 0;
}

}  // namespace ew
