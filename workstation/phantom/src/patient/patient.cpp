#include "ew/phantom/patient.h"

#include <array>
#include <set>

#include "ew/core/numbers.h"
#include "ew/phantom/flow.h"
#include "ew/phantom/motion.h"
#include "patient/anatomy.h"
#include "patient/distance_cache.h"
#include "patient/recipe.h"
#include "patient/whole_recipe.h"

namespace ew {
namespace {

constexpr double kSkinSpacing_mm = 4.0;
constexpr double kLargestBox_mm3 = 1e9;          // a cubic metre holds a person lying down; the skin is sampled all over the box
constexpr double kMostSolidsOfOrgans = 50000.0;  // asked for one point inside all organs
constexpr std::uint64_t kVoxelVersion = 3;       // raise when the same recipe starts to give other voxels

std::uint64_t fnv1a(const std::string& text, std::uint64_t hash) {
  for (const char letter : text) hash = (hash ^ static_cast<unsigned char>(letter)) * 1099511628211ull;
  return hash;
}

Result<std::filesystem::path> findMannequin(const JsonFields& recipe, const std::filesystem::path& file,
                                            const std::filesystem::path& mannequins) {
  const std::string name = recipe.text("mannequin");
  if (recipe.good() && std::filesystem::path(name).has_parent_path())
    recipe.refuse("mannequin", say<"the name of a file in resources/mannequin, without a folder">());
  if (!recipe.good()) return passOn(*recipe.reading().problem());
  const auto found = phantom::findNamed(name, "mannequin", file, mannequins);
  if (!found.empty()) return found;
  return failure(
      ErrorCode::notFound,
      say<"%1 needs the mannequin %2, which is neither beside it nor in resources/mannequin; put it there.">(file.string(), name),
      {{"file", file.string()}, {"mannequin", name}});
}

Bounds readBox(const JsonFields& recipe) {
  Bounds read;
  if (!recipe.has("box")) recipe.refuse("box", say<"an object with lowest_mm and highest_mm">());
  const JsonFields box = recipe.object("box");
  box.only({"lowest_mm", "highest_mm"});
  read = {box.point("lowest_mm", phantom::kFarthest_mm), box.point("highest_mm", phantom::kFarthest_mm)};
  const glm::dvec3 size = read.highest_mm - read.lowest_mm;
  for (int axis = 0; axis < 3; ++axis) {
    if (!(size[axis] >= 1.0 && size[axis] <= 3000.0))
      box.refuse("highest_mm", say<"not 1 to 3000 mm above lowest_mm">(), say<"the upper corner of the box">());
  }
  if (!(size.x * size.y * size.z <= kLargestBox_mm3))
    recipe.refuse("box", say<"larger than a cubic metre">(), say<"the part of the body that is drawn">());
  return read;
}

Tissue readTissue(const JsonFields& object) {
  Tissue tissue;
  object.only({"echo_level", "speckle", "attenuation_db_per_cm_mhz", "reflection_db", "texture", "impedance_mrayl", "speed_m_per_s",
               "scatterers_per_mm3"});
  if (!object.good()) return tissue;
  tissue.name = object.text("name");
  tissue.echoLevel = object.number("echo_level", 0.0, 255.0);
  tissue.speckle = object.number("speckle", 0.0, 1.0);
  tissue.attenuation_dbPerCmMhz = object.number("attenuation_db_per_cm_mhz", 0.0, 100.0, 0.5);
  tissue.reflection_db = object.number("reflection_db", 0.0, 60.0, 0.0);
  tissue.impedance_mrayl = object.number("impedance_mrayl", 1e-4, 20.0, tissue.impedance_mrayl);
  tissue.speed_mPerS = object.number("speed_m_per_s", 200.0, 6000.0, tissue.speed_mPerS);
  if (object.has("scatterers_per_mm3")) tissue.scatterers_perMm3 = object.number("scatterers_per_mm3", 0.0, 1000.0);
  if (object.has("texture")) {
    const JsonFields texture = object.object("texture");
    texture.only({"level", "scale_mm", "follows_the_skin"});
    tissue.texture.level = texture.number("level", 0.0, 255.0);
    tissue.texture.scale_mm = texture.point("scale_mm", phantom::kFarthest_mm);
    for (int axis = 0; axis < 3; ++axis) {
      if (!(tissue.texture.scale_mm[axis] >= 0.1)) texture.refuse("scale_mm", say<"three sizes of at least 0.1 mm">());
    }
    tissue.texture.followsTheSkin = texture.flag("follows_the_skin", false);
  }
  return tissue;
}

std::vector<Tissue> readTissues(const JsonFields& recipe) {
  std::vector<Tissue> read;
  std::set<std::string> names;
  for (const JsonFields& each : recipe.objects("tissues", 1, 254)) {
    read.push_back(readTissue(each));
    if (each.good() && !names.insert(read.back().name).second) each.refuse("name", say<"a name that is not taken yet">());
  }
  return read;
}

std::size_t tissueNamed(const JsonFields& object, const std::string& field, const std::vector<Tissue>& tissues) {
  const std::string name = object.text(field);
  for (std::size_t n = 0; n < tissues.size(); ++n) {
    if (tissues[n].name == name) return n;
  }
  object.refuse(field, say<"one of the tissues (%1)">(phantom::listed(tissues, [](const Tissue& tissue) { return tissue.name; })));
  return 0;
}

constexpr std::array<std::pair<std::string_view, phantom::Shine>, 3> kShines{
    {{"glint", phantom::Shine::glint}, {"front", phantom::Shine::front}, {"all round", phantom::Shine::allRound}}};

std::optional<phantom::Border> readBorder(const JsonFields& object) {
  if (!object.has("border")) return std::nullopt;
  const JsonFields border = object.object("border");
  border.only({"echo_level", "width_mm", "shine", "sheets", "sheet_gap_mm", "fall_deg", "rough_db"});
  phantom::Border read;
  read.echoLevel = border.number("echo_level", 0.0, 255.0);
  read.width_mm = border.number("width_mm", 0.05, 50.0);
  read.shine = border.word("shine", kShines, std::optional(phantom::Shine::glint));
  read.sheets = static_cast<int>(border.number("sheets", 1.0, 4.0, 1.0));
  read.sheetGap_mm = border.number("sheet_gap_mm", 0.3, 10.0, read.sheetGap_mm);
  if (border.has("fall_deg")) read.fall_deg = border.number("fall_deg", 2.0, 60.0);
  if (border.has("rough_db")) read.rough_db = border.number("rough_db", -60.0, 0.0);
  return read;
}

void readOrgans(const JsonFields& recipe, phantom::ShapesByName known, Patient& patient) {
  const phantom::FramesByName frames = phantom::readFrames(recipe);
  const auto newName = [&known](const JsonFields& entry) {
    std::string name = entry.text("name");
    if (known.count(name) > 0) entry.refuse("name", say<"a name that is not taken yet">());
    return name;
  };
  for (const JsonFields& entry : recipe.objects("shapes", 0, 200)) {
    const std::string name = newName(entry);
    phantom::ShapePtr shape = phantom::readShape(entry.called(entry.place() + " (" + name + ")"), known, frames);
    if (!recipe.good()) return;
    known.emplace(name, std::move(shape));
  }
  double solids = 0.0;
  for (const JsonFields& entry : recipe.objects("organs", 1, 254)) {
    entry.only({"tissue", "shape", "border"});
    phantom::Organ organ;
    organ.name = entry.text("name");
    const JsonFields each = entry.called(entry.place() + " (" + organ.name + ")");
    newName(each);
    organ.tissue = tissueNamed(each, "tissue", patient.tissues);
    if (!each.has("shape")) each.refuse("shape", say<"a shape">());
    if (!recipe.good()) return;
    organ.shape = phantom::readShape(each.object("shape"), known, frames);
    organ.border = readBorder(each);
    if (!recipe.good()) return;
    solids += organ.shape->solids();
    if (solids > kMostSolidsOfOrgans)
      return each.refuse("shape", say<"one solid too many with those of the organs before it">(),
                         say<"at most %1 in all organs, a shared one counted at every use">(textOf(kMostSolidsOfOrgans)));
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
  JsonReading reading = phantom::readingOf(file);
  const JsonFields recipe(whole->json, reading);
  const auto stopped = [] { return failure(ErrorCode::cancelled, say<"Reading the patient was stopped.">()); };
  auto patient = std::make_shared<Patient>();
  patient->parameters = whole->parameters;
  recipe.only({"format", "mannequin", "box", "beam_axis_mm", "scatterers", "tissues", "background", "frames", "shapes", "organs", "motion",
               "flow", "measurements", "planes"});
  patient->name = recipe.text("name");
  patient->box = readBox(recipe);
  if (const auto axis = recipe.numbers("beam_axis_mm", 2, 2, -1e4, 1e4, false); !axis.empty()) patient->beamAxis_mm = {axis[0], axis[1]};
  const JsonFields scatterers = recipe.object("scatterers");
  scatterers.only({"pitch_mm"});
  if (recipe.has("scatterers")) patient->scattererPitch_mm = scatterers.number("pitch_mm", 0.05, 5.0);
  patient->tissues = readTissues(recipe);
  patient->backgroundTissue = tissueNamed(recipe, "background", patient->tissues);
  const auto bodyFile = findMannequin(recipe, file, mannequins);
  if (!bodyFile) return passOn(bodyFile.error());
  auto body = readBodyShape(*bodyFile);
  if (!body) return passOn(body.error());
  if (reading.problem()) return passOn(*reading.problem());
  PartOfProgress skin(progress, 0.0, 0.6), moving(progress, 0.6, 1.0);
  patient->skin = phantom::keepDistance(std::move(*body), patient->box, kSkinSpacing_mm, skin);
  if (!patient->skin) return stopped();
  readOrgans(recipe, {{"skin surface", patient->skin}}, *patient);
  if (recipe.has("motion") && reading.good())
    patient->motion = phantom::readMotion(recipe.object("motion"), patient->box, patient->skin, patient->shapes, moving);
  if (progress.cancelRequested()) return stopped();
  if (recipe.has("flow") && reading.good()) patient->flow = phantom::readFlow(recipe.object("flow"), patient->shapes, rhythmsOf(*patient));
  patient->planes = phantom::readPlanes(recipe, patient->skin, patient->shapes, progress);
  if (progress.cancelRequested()) return stopped();
  patient->measurements = phantom::readMeasurements(recipe, patient->shapes, patient->planes);
  if (reading.problem()) return passOn(*reading.problem());
  return patient;
}

Result<Bounds> readPatientBox(const std::filesystem::path& file, const std::filesystem::path& mannequins,
                              const ParameterValues& parameters) {
  const auto whole = phantom::readWholeRecipe(file, mannequins, parameters);
  if (!whole) return passOn(whole.error());
  JsonReading reading = phantom::readingOf(file);
  const Bounds box = readBox(JsonFields(whole->json, reading));
  if (reading.problem()) return passOn(*reading.problem());
  return box;
}

Result<FlowField> readPatientFlow(const std::filesystem::path& file, const std::filesystem::path& mannequins,
                                  const ParameterValues& parameters, Progress& progress) {
  const auto whole = phantom::readWholeRecipe(file, mannequins, parameters);
  if (!whole) return passOn(whole.error());
  if (!whole->json.contains("flow")) return FlowField{};
  const auto patient = readPatient(file, mannequins, parameters, progress);
  if (!patient) return passOn(patient.error());
  return flowOf(**patient);
}

Result<std::uint64_t> fingerprintOfPatient(const std::filesystem::path& file, const std::filesystem::path& mannequins,
                                           const ParameterValues& parameters) {
  const auto whole = phantom::readWholeRecipe(file, mannequins, parameters);
  if (!whole) return passOn(whole.error());
  JsonReading reading = phantom::readingOf(file);
  const auto bodyFile = findMannequin(JsonFields(whole->json, reading), file, mannequins);
  if (!bodyFile) return passOn(bodyFile.error());
  const auto body = phantom::readWholeMannequin(*bodyFile);
  if (!body) return passOn(body.error());
  nlohmann::json drawn = whole->json;
  drawn.erase("flow");  // no voxel depends on it
  return fnv1a(body->dump(), fnv1a(drawn.dump(), 14695981039346656037ull ^ kVoxelVersion));
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
  JsonReading reading = phantom::readingOf(file);
  const JsonFields recipe(whole->json, reading);
  const std::vector<Tissue> tissues = readTissues(recipe);
  const std::size_t background = tissueNamed(recipe, "background", tissues);
  if (reading.problem()) return passOn(*reading.problem());
  std::vector<LabelTissue> labels{{0, "", tissues[background]}};
  for (const JsonFields& each : recipe.objects("organs", 1, 254)) {
    const std::string name = each.text("name");
    const std::size_t tissue = tissueNamed(each, "tissue", tissues);
    if (reading.good()) labels.push_back({static_cast<int>(labels.size()), name, tissues[tissue]});
  }
  if (reading.problem()) return passOn(*reading.problem());
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
  return failure(ErrorCode::badField, say<"The patient has no organ %1; its organs are %2.">(organ, names), {{"organ", organ}});
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
