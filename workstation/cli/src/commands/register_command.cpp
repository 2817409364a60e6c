#include <cmath>

#include "commands/registration_files.h"
#include "ew/core/numbers.h"
#include "ew/io/safe_file.h"
#include "ew/io/volume_file.h"
#include "ew/registration/deformation.h"
#include "ew/registration/elastic.h"
#include "ew/registration/landmarks.h"
#include "ew/registration/quality.h"
#include "ew/registration/rigid.h"
#include "run/arguments.h"
#include "run/command.h"

namespace ew::cli {
namespace {

using namespace registration;

struct RegisterArguments {
  std::string fixed;
  std::string moving;
  std::string method;
  std::string start;
  std::string landmarks;
  std::string output;
  std::string field;
  std::string moved;
  std::string coverageFixed;
  std::string coverageMoving;
  std::string confidenceFixed;
  std::string confidenceMoving;
  std::optional<std::vector<double>> beamFixed;
  std::optional<std::vector<double>> beamMoving;
  int threads = 0;
  std::optional<double> pickError_mm;
  std::string effort = "balanced";
  std::optional<double> maxRotation_deg;
  std::optional<double> stepRotation_deg;
  std::optional<double> leastOverlap;
  std::optional<double> finest_mm;
  std::optional<double> node_mm;
  std::optional<double> stiffness;
  std::optional<double> maxMotion_mm;
  std::optional<double> maxTime_s;
  bool singleResolution = false;
  bool assess = false;
};

/// A side as read: the volume and what goes with it.
struct Side {
  Volume volume;
  std::vector<float> confidence;
  std::optional<Beams> beams;
  [[nodiscard]] Input input() const { return {&volume, confidence, beams}; }
};

/// What any method found, in one form.
struct Found {
  Verdict verdict = Verdict::cannotTell;
  Message reason;
  Deformation fixedToMoving;
  bool flat = false;  ///< two-dimensional images: so is their field
  StopReason stop = StopReason::notRun;
  nlohmann::json quality = nlohmann::json::object();
  nlohmann::json details = nlohmann::json::object();
  std::vector<Level> levels;
};

Result<Side> readSide(Run& run, const std::string& file, const std::string& coverage, const std::string& confidence, Progress& progress) {
  Side side;
  auto loaded = readVolume(file, progress);
  if (!loaded) return passOn(loaded.error());
  for (const auto& note : loaded->notes) run.remark(note);
  side.volume = std::move(loaded->volume);
  if (!coverage.empty())
    if (auto read = readCoverageInto(side.volume, coverage, progress); !read) return passOn(read.error());
  if (!confidence.empty()) {
    const auto map = readVolume(confidence, progress);
    if (!map) return passOn(map.error());
    if (map->volume.grid.dims != side.volume.grid.dims)
      return failure(ErrorCode::badField,
                     say<"The confidence in '%1' lies on another grid than '%2'; give the map made with this volume.">(confidence, file),
                     {{"file", confidence}});
    side.confidence.resize(map->volume.echo.size());
    for (std::size_t i = 0; i < side.confidence.size(); ++i) side.confidence[i] = static_cast<float>(map->volume.echo[i]) / 255.0F;
  }
  return side;
}

void agreementInto(nlohmann::json& quality, const Agreement& before, const Agreement& after) {
  quality["correlation_before"] = before.correlation;
  quality["correlation_after"] = after.correlation;
  quality["overlap_share"] = after.overlapShare;
  quality["chance_correlation"] = after.chance;
}

bool contains(const Grid& grid, const glm::dvec3& p_mm) {
  const glm::dvec3 at = (grid.worldToVoxel() * Point<frame::World>{p_mm}).at;
  return glm::all(glm::greaterThanEqual(at, glm::dvec3(-0.5))) && glm::all(glm::lessThanEqual(at, glm::dvec3(grid.dims) - 0.5));
}

Result<Found> byLandmarks(const RegisterArguments& arguments, const Side& fixed, const Side& moving, Run& run) {
  const auto file = readLandmarks(arguments.landmarks);
  if (!file) return passOn(file.error());
  for (const auto& pair : file->pairs) {
    if (!contains(fixed.volume.grid, pair.fixed_mm)) run.remark(say<"The landmark '%1' lies outside the fixed volume.">(pair.name));
    if (!contains(moving.volume.grid, pair.moving_mm)) run.remark(say<"The landmark '%1' lies outside the moving volume.">(pair.name));
  }
  LandmarkOptions options;
  options.pickError_mm = arguments.pickError_mm.value_or(file->pickError_mm.value_or(options.pickError_mm));
  run.report.options["pick_error_mm"] = options.pickError_mm;
  const auto result = registerLandmarks(file->pairs, options);
  if (!result) return passOn(result.error());
  Found found;
  found.verdict = result->verdict;
  found.reason = result->reason;
  found.fixedToMoving.rigid = result->fixedToMoving;
  found.stop = result->stop;
  const auto orNull = [](double value) { return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json(); };
  found.quality = {{"landmarks", file->pairs.size()},
                   {"rms_mm", result->rms_mm},
                   {"expected_error_mm", orNull(result->expectedError_mm)},
                   {"conditioning", result->conditioning}};
  auto& rows = found.details["landmarks"] = nlohmann::json::array();
  for (std::size_t i = 0; i < file->pairs.size(); ++i)
    rows.push_back({{"name", file->pairs[i].name}, {"residual_mm", result->residual_mm[i]}, {"weight", result->weight[i]}});
  return found;
}

/// Images: a displacement per pixel, brought into the coordinates of both headers.
Result<Found> byElastic2d(const RegisterArguments& arguments, const Side& fixed, const Side& moving, Run& run, Progress& progress,
                          const OnLevel& onLevel) {
  const Grid& f = fixed.volume.grid;
  const Grid& m = moving.volume.grid;
  if (f.dims.z != 1 || m.dims.z != 1)
    return failure(ErrorCode::badUsage,
                   say<"--method elastic2d takes two images, but '%1' is a volume; cut a slice out of it, or use --method elastic3d.">(
                       f.dims.z != 1 ? arguments.fixed : arguments.moving));
  const glm::dvec2 pixel_mm(f.spacing_mm.x, f.spacing_mm.y);
  if (std::abs(m.spacing_mm.x / pixel_mm.x - 1.0) > 1e-3 || std::abs(m.spacing_mm.y / pixel_mm.y - 1.0) > 1e-3)
    return failure(ErrorCode::badField, say<"The pixels of the two images are not of one size; resample one of them.">(),
                   {{"field", "spacing"}});
  Elastic2dOptions options;
  options.singleResolution = arguments.singleResolution;
  options.stiffness = arguments.stiffness.value_or(options.stiffness);
  options.threads = arguments.threads;
  run.report.options["single_resolution"] = options.singleResolution;
  const auto view = [](const Volume& volume) {
    return ImageView<const std::uint8_t>{volume.echo.data(), volume.grid.dims.x, volume.grid.dims.y, volume.grid.dims.x};
  };
  auto result = registerElastic2d(view(fixed.volume), view(moving.volume), pixel_mm, options, progress, onLevel);
  if (!result) return passOn(result.error());
  Found found;
  found.verdict = result->verdict;
  found.reason = result->reason;
  found.stop = result->stop;
  found.flat = true;
  // Pixel (0, 0) lay on pixel (0, 0): the rigid part takes one header's place to the other's, the warp happens before it.
  // Across a flat image nothing is seen, so where one header is left-handed and the other is not, that direction is turned over: the same
  // pixels on the same places, by a rotation and never by a mirror.
  glm::dmat3 across(1.0);
  across[2][2] = glm::determinant(m.directions) * glm::determinant(f.directions) < 0.0 ? -1.0 : 1.0;
  const glm::dmat3 turn = m.directions * across * glm::transpose(f.directions);
  found.fixedToMoving.rigid.matrix = glm::dmat4(turn);
  found.fixedToMoving.rigid.matrix[3] = glm::dvec4(m.origin_mm - turn * f.origin_mm, 1.0);
  found.fixedToMoving.control.nodes = f;
  found.fixedToMoving.control.displacement_mm.reserve(result->displacement_mm.size());
  double largest_mm = 0.0;
  for (const glm::vec2& d : result->displacement_mm) {
    found.fixedToMoving.control.displacement_mm.emplace_back(f.directions * glm::dvec3(d.x, d.y, 0.0));
    largest_mm = std::max(largest_mm, static_cast<double>(glm::length(d)));
  }
  found.quality = {{"correlation_before", result->correlationBefore},
                   {"correlation_after", result->correlationAfter},
                   {"jacobian_min", result->smallestJacobian},
                   {"largest_motion_mm", largest_mm}};
  return found;
}

Result<Found> byElastic3d(const RegisterArguments& arguments, const Side& fixed, const Side& moving,
                          const Transform<frame::Moving, frame::Fixed>& start, Run& run, Progress& progress, const OnLevel& onLevel) {
  ElasticOptions options;
  options.effort = arguments.effort == "fast"       ? ElasticEffort::fast
                   : arguments.effort == "accurate" ? ElasticEffort::accurate
                                                    : ElasticEffort::balanced;
  options.finestNode_mm = arguments.node_mm.value_or(options.finestNode_mm);
  options.finestVoxel_mm = arguments.finest_mm.value_or(options.finestVoxel_mm);
  options.stiffness = arguments.stiffness.value_or(options.stiffness);
  options.largestMotion_mm = arguments.maxMotion_mm.value_or(options.largestMotion_mm);
  options.maxTime_s = arguments.maxTime_s.value_or(options.maxTime_s);
  options.threads = arguments.threads;
  run.report.options["effort"] = arguments.effort;
  const auto forecast = forecastElastic_bytes(fixed.volume.grid, moving.volume.grid, options);
  auto result = registerElastic(fixed.input(), moving.input(), start, options, progress, onLevel);
  if (!result) return passOn(result.error());
  Found found;
  found.verdict = result->verdict;
  found.reason = result->reason;
  found.stop = result->stop;
  agreementInto(found.quality, result->before, result->after);
  std::size_t unsure = 0;
  for (const float share : result->uncertainty) unsure += share > 0.5F ? 1 : 0;
  found.quality["jacobian_min"] = result->jacobian.smallest;
  found.quality["jacobian_max"] = result->jacobian.largest;
  found.quality["folded_cells"] = result->jacobian.folded;
  found.quality["residual_rms"] = result->residualRms;
  found.quality["stiffness"] = result->stiffness;
  found.quality["largest_motion_mm"] = result->largestMotion_mm;
  found.quality["left_motion_share"] = result->residualShare;
  found.quality["unsure_node_share"] =
      result->uncertainty.empty() ? 0.0 : static_cast<double>(unsure) / static_cast<double>(result->uncertainty.size());
  found.quality["forecast_mib"] = static_cast<double>(forecast) / 1048576.0;
  found.fixedToMoving = std::move(result->fixedToMoving);
  return found;
}

void rigidInto(Found& found, const RigidResult& result) {
  found.verdict = result.verdict;
  found.reason = result.reason;
  found.stop = result.stop;
  found.fixedToMoving.rigid = result.fixedToMoving;
  agreementInto(found.quality, result.before, result.after);
  found.quality["conditioning"] = result.conditioning;
  found.quality["halves_disagree_mm"] = result.halvesDisagree_mm;
  found.quality["residual_rms"] = result.residualRms;
  if (result.covariance) {
    found.details["covariance"] = *result.covariance;
    found.details["covariance_centre_mm"] = {result.centre_mm.x, result.centre_mm.y, result.centre_mm.z};
  }
}

Result<Found> byRigid(const RegisterArguments& arguments, const Side& fixed, const Side& moving,
                      const Transform<frame::Moving, frame::Fixed>& start, Progress& progress, const OnLevel& onLevel) {
  constexpr double kSearchRotation_deg = 20.0;
  RefineOptions options;
  options.searchRotation_deg = kSearchRotation_deg;
  options.finest_mm = arguments.finest_mm.value_or(options.finest_mm);
  options.coarsest_mm = std::max(options.coarsest_mm, options.finest_mm);
  options.threads = arguments.threads;
  const auto result = refineRigid(fixed.input(), moving.input(), start, options, progress, onLevel);
  if (!result) return passOn(result.error());
  Found found;
  rigidInto(found, *result);
  return found;
}

Result<Found> byPartial(const RegisterArguments& arguments, const Side& fixed, const Side& moving, Run& run, Progress& progress,
                        const OnLevel& onLevel) {
  PartialOptions options;
  options.maxRotation_deg = arguments.maxRotation_deg.value_or(options.maxRotation_deg);
  options.stepRotation_deg = arguments.stepRotation_deg.value_or(options.stepRotation_deg);
  options.leastOverlap = arguments.leastOverlap.value_or(options.leastOverlap);
  options.refine.finest_mm = arguments.finest_mm.value_or(options.refine.finest_mm);
  options.refine.coarsest_mm = std::max(options.refine.coarsest_mm, options.refine.finest_mm);
  options.threads = options.refine.threads = arguments.threads;
  run.report.options["max_turn_deg"] = options.maxRotation_deg;
  run.report.options["step_turn_deg"] = options.stepRotation_deg;
  const auto forecast = forecastPartial_bytes(fixed.volume.grid, moving.volume.grid, options);
  const auto result = matchPartial(fixed.input(), moving.input(), options, progress, onLevel);
  if (!result) return passOn(result.error());
  Found found;
  rigidInto(found, result->best);
  found.quality["margin"] = result->margin;
  found.quality["poses_searched"] = result->poses;
  found.quality["forecast_mib"] = static_cast<double>(forecast) / 1048576.0;
  auto& rows = found.details["hypotheses"] = nlohmann::json::array();
  for (const auto& hypothesis : result->hypotheses)
    rows.push_back({{"fixed_to_moving", rowsOf(hypothesis.fixedToMoving)},
                    {"significance", hypothesis.significance},
                    {"correlation", hypothesis.correlation},
                    {"overlap_share", hypothesis.overlapShare}});
  return found;
}

bool isOneOf(const std::string& method, std::initializer_list<const char*> names) {
  return std::any_of(names.begin(), names.end(), [&](const char* name) { return method == name; });
}

/// Options that the method would not look at: a word to the user now is better than a wrong belief.
Result<void> checkUsage(const RegisterArguments& arguments) {
  const std::string& method = arguments.method;
  const auto only = [&](bool given, const char* option, std::initializer_list<const char*> methods) -> Result<void> {
    if (!given || isOneOf(method, methods)) return {};
    std::string names;
    for (const char* name : methods) names += (names.empty() ? "" : " or ") + std::string(name);
    return failure(ErrorCode::badUsage, say<"%1 goes with --method %2, not with %3; leave it out or choose another method.">(
                                            std::string(option), names, method));
  };
  for (const auto& fits :
       {only(!arguments.start.empty(), "--start", {"rigid", "elastic3d"}), only(!arguments.landmarks.empty(), "--landmarks", {"landmarks"}),
        only(arguments.pickError_mm.has_value(), "--pick-error", {"landmarks"}),
        only(arguments.maxRotation_deg.has_value(), "--max-turn", {"partial"}),
        only(arguments.stepRotation_deg.has_value(), "--step-turn", {"partial"}),
        only(arguments.leastOverlap.has_value(), "--least-overlap", {"partial"}),
        only(arguments.effort != "balanced", "--effort", {"elastic3d"}),
        only(arguments.beamFixed.has_value(), "--beam-fixed", {"rigid", "partial", "elastic3d"}),
        only(arguments.beamMoving.has_value(), "--beam-moving", {"rigid", "partial", "elastic3d"}),
        only(arguments.finest_mm.has_value(), "--finest", {"rigid", "partial", "elastic3d"}),
        only(arguments.node_mm.has_value(), "--node", {"elastic3d"}),
        only(arguments.stiffness.has_value(), "--stiffness", {"elastic2d", "elastic3d"}),
        only(arguments.maxMotion_mm.has_value(), "--max-motion", {"elastic3d"}),
        only(arguments.maxTime_s.has_value(), "--max-time", {"elastic3d"}),
        only(arguments.singleResolution, "--single-resolution", {"elastic2d"})})
    if (!fits) return fits;
  if (method == "landmarks" && arguments.landmarks.empty())
    return failure(ErrorCode::badUsage, say<"--method landmarks needs the pairs: give --landmarks L.json.">());
  return {};
}

Result<Found> findTransform(const RegisterArguments& arguments, const Side& fixed, const Side& moving, Run& run, Progress& progress) {
  const std::string& method = arguments.method;
  Transform<frame::Moving, frame::Fixed> start;
  if (!arguments.start.empty()) {
    const auto read = readTransform(arguments.start);
    if (!read) return passOn(read.error());
    start = *read;
  }
  std::vector<Level> levels;
  const OnLevel onLevel = [&](const Level& level) { levels.push_back(level); };
  auto found = [&]() -> Result<Found> {
    if (method == "landmarks") return byLandmarks(arguments, fixed, moving, run);
    if (method == "elastic2d") return byElastic2d(arguments, fixed, moving, run, progress, onLevel);
    if (method == "elastic3d") return byElastic3d(arguments, fixed, moving, start, run, progress, onLevel);
    if (method == "rigid") return byRigid(arguments, fixed, moving, start, progress, onLevel);
    return byPartial(arguments, fixed, moving, run, progress, onLevel);
  }();
  if (found) found->levels = std::move(levels);
  return found;
}

/// `--assess`: the figures of ew/registration/quality.h, against where it started.
Result<void> assess(const RegisterArguments& arguments, const Side& fixed, const Side& moving, Found& found, Progress& progress) {
  Transform<frame::Moving, frame::Fixed> before;
  if (!arguments.start.empty()) {
    const auto start = readTransform(arguments.start);
    if (!start) return passOn(start.error());
    before = *start;
  }
  QualityOptions options;
  options.threads = arguments.threads;
  const auto quality = assessQuality(fixed.input(), moving.input(), before, found.fixedToMoving, nullptr, options, progress);
  if (!quality) return passOn(quality.error());
  found.quality["grey_correlation_before"] = quality->greyCorrelationBefore;
  found.quality["grey_correlation_after"] = quality->greyCorrelationAfter;
  found.quality["local_correlation_before"] = quality->localCorrelationBefore;
  found.quality["local_correlation_after"] = quality->localCorrelationAfter;
  found.quality["residual_rms_grey"] = quality->residualRms_grey;
  found.details["residual_histogram"] = quality->residualHistogram;
  auto& rows = found.details["regions"] = nlohmann::json::array();
  for (const RegionQuality& region : quality->regions)
    rows.push_back({{"centre_mm", {region.centre_mm.x, region.centre_mm.y, region.centre_mm.z}},
                    {"voxels", region.voxels},
                    {"correlation", region.correlation},
                    {"uncertainty_mm", std::isfinite(region.uncertainty_mm) ? nlohmann::json(region.uncertainty_mm) : nlohmann::json()}});
  return {};
}

/// The turn and the shift of the fixed volume's middle: what a person compares with what they expect.
void transformInto(nlohmann::json& quality, const Transform<frame::Moving, frame::Fixed>& rigid, const Grid& fixed) {
  const glm::dmat4& turn = rigid.matrix;
  const double cosine = 0.5 * (turn[0][0] + turn[1][1] + turn[2][2] - 1.0);
  const glm::dvec3 middle = middleOf(fixed);
  quality["turn_deg"] = glm::degrees(std::acos(std::clamp(cosine, -1.0, 1.0)));
  quality["shift_of_middle_mm"] = glm::length(carried(rigid, middle) - middle);
}

Result<void> announceRegistration(const RegisterArguments& arguments, Run& run) {
  for (const std::string* file : {&arguments.fixed, &arguments.moving, &arguments.start, &arguments.landmarks, &arguments.coverageFixed,
                                  &arguments.coverageMoving, &arguments.confidenceFixed, &arguments.confidenceMoving})
    if (auto kept = run.input(*file); !kept) return kept;
  if (auto announced = run.output(arguments.output); !announced) return announced;
  if (!arguments.field.empty())
    if (auto announced = run.output(arguments.field, ".mha"); !announced) return announced;
  if (!arguments.moved.empty())
    if (auto announced = run.output(arguments.moved, ".mha .mhd"); !announced) return announced;
  return {};
}

nlohmann::json registrationOptions(const RegisterArguments& arguments) {
  nlohmann::json options = {{"method", arguments.method}, {"threads", arguments.threads}};
  if (arguments.beamFixed) options["beam_fixed"] = *arguments.beamFixed;
  if (arguments.beamMoving) options["beam_moving"] = *arguments.beamMoving;
  options["start"] = arguments.start.empty() ? nlohmann::json() : nlohmann::json(arguments.start);
  return options;
}

Result<std::pair<Side, Side>> readSides(const RegisterArguments& arguments, Run& run) {
  const StepClock clock(run.report, "read");
  PartOfProgress first(run.progress, 0.0, 0.03);
  auto fixed = readSide(run, arguments.fixed, arguments.coverageFixed, arguments.confidenceFixed, first);
  if (!fixed) return passOn(fixed.error());
  PartOfProgress second(run.progress, 0.03, 0.06);
  auto moving = readSide(run, arguments.moving, arguments.coverageMoving, arguments.confidenceMoving, second);
  if (!moving) return passOn(moving.error());
  if (const auto& beam = arguments.beamFixed) fixed->beams = Beams{{(*beam)[0], (*beam)[1], (*beam)[2]}};
  if (const auto& beam = arguments.beamMoving) moving->beams = Beams{{(*beam)[0], (*beam)[1], (*beam)[2]}};
  return std::pair(*std::move(fixed), *std::move(moving));
}

/// @param moving may be empty unless the moved volume is asked for
Result<void> writeFound(const RegisterArguments& arguments, const Grid& fixed, const Volume& moving, const Found& found, Run& run) {
  const StepClock clock(run.report, "write");
  if (auto written = writeFileSafely(run.outputs.staged(arguments.output), transformText(found.fixedToMoving.rigid)); !written)
    return written;
  if (!arguments.field.empty()) {
    PartOfProgress writing(run.progress, 0.9, arguments.moved.empty() ? 1.0 : 0.95);
    if (auto written = writeField(found.fixedToMoving, fixed, found.flat, run.outputs.staged(arguments.field), arguments.threads, writing);
        !written)
      return written;
  }
  if (arguments.moved.empty()) return {};
  PartOfProgress warping(run.progress, 0.95, 1.0);
  auto seen = warped(moving, found.fixedToMoving, fixed, arguments.threads, warping);
  if (!seen) return passOn(seen.error());
  return writeVolume(*seen, run.outputs.staged(arguments.moved), warping);
}

void reportFound(const Found& found, const Grid& fixed, Report& report) {
  for (const Level& level : found.levels) report.addStep("level " + textOf(level.voxel_mm) + " mm", level.seconds * 1e6);
  auto& levels = report.details["levels"] = nlohmann::json::array();
  for (const Level& level : found.levels)
    levels.push_back({{"voxel_mm", level.voxel_mm},
                      {"node_mm", level.node_mm},
                      {"iterations", level.iterations},
                      {"correlation_before", level.correlationBefore},
                      {"correlation_after", level.correlationAfter},
                      {"seconds", level.seconds}});
  report.quality = found.quality;
  transformInto(report.quality, found.fixedToMoving.rigid, fixed);
  report.verdict = nameOf(found.verdict);
  report.details["reason"] = found.reason.english();
  report.details["stop"] = nameOf(found.stop);
  for (const auto& [key, value] : found.details.items()) report.details[key] = value;
}

Result<int> registerVolumes(const RegisterArguments& arguments, Run& run) {
  if (auto fits = checkUsage(arguments); !fits) return passOn(fits.error());
  if (auto announced = announceRegistration(arguments, run); !announced) return passOn(announced.error());
  run.report.options = registrationOptions(arguments);
  auto sides = readSides(arguments, run);
  if (!sides) return passOn(sides.error());
  auto& [fixed, moving] = *sides;
  auto found = [&, &fixed = fixed, &moving = moving] {
    const StepClock clock(run.report, "register");
    PartOfProgress registering(run.progress, 0.06, arguments.assess ? 0.85 : 0.9);
    return findTransform(arguments, fixed, moving, run, registering);
  }();
  if (!found) return passOn(found.error());
  if (arguments.assess) {
    const StepClock clock(run.report, "assess");
    PartOfProgress assessing(run.progress, 0.85, 0.9);
    if (auto assessed = assess(arguments, fixed, moving, *found, assessing); !assessed) return passOn(assessed.error());
  }
  if (arguments.moved.empty()) moving = {};  // the field needs the memory more
  if (auto written = writeFound(arguments, fixed.volume.grid, moving.volume, *found, run); !written) return passOn(written.error());
  reportFound(*found, fixed.volume.grid, run.report);

  std::string verdict = nameOf(found->verdict);
  verdict.front() = static_cast<char>(verdict.front() - 'a' + 'A');
  run.say(verdict + ": " + found->reason.english());
  if (found->verdict != Verdict::aligned)
    run.say("What was found is in " + arguments.output + " all the same, for a look; do not build on it.");
  return found->verdict == Verdict::aligned ? kDone : kVerdict;
}

}  // namespace

void addRegister(CLI::App& root, Selection& selection) {
  auto arguments = std::make_shared<RegisterArguments>();
  auto& app =
      addCommand(root, selection, "register", "Find how one volume lies to another, with a verdict",
                 {"register a.mha b.mha --method partial -o a_to_b.txt --report r.json",
                  "register a.mha b.mha --method elastic3d --start a_to_b.txt -o rigid.txt --field displacement.mha --moved b_on_a.mha",
                  "register a.mha b.mha --method landmarks --landmarks pairs.json -o a_to_b.txt"},
                 [arguments](Run& run) { return registerVolumes(*arguments, run); });
  app.add_option("FIXED", arguments->fixed, "The volume that stays")->required()->type_name("");
  app.add_option("MOVING", arguments->moving, "The volume that is brought to it")->required()->type_name("");
  app.add_option("--method", arguments->method,
                 "landmarks: from pairs of places; rigid: refined from a start by the images; partial: without any start, however the two "
                 "overlap; elastic2d: two images, deformed; elastic3d: two volumes, deformed, from a rigid start")
      ->required()
      ->check(CLI::IsMember({"landmarks", "rigid", "partial", "elastic2d", "elastic3d"}))
      ->type_name("METHOD");
  app.add_option("-o,--output", arguments->output,
                 "The rigid transform: 4 x 4, a point of FIXED to the same place in MOVING, mm (elastic: its rigid part)")
      ->required()
      ->type_name("TRANSFORM.txt");
  app.add_option("--field", arguments->field,
                 "Also write the displacement of every voxel of FIXED: point + displacement = place in MOVING, three floats, mm")
      ->type_name("FIELD.mha");
  app.add_option("--moved", arguments->moved, "Also write MOVING as seen on the grid of FIXED")->type_name("MOVED.mha");
  app.add_option("--start", arguments->start, "Where to start: 4 x 4 as in -o; without it the files' own coordinates (rigid, elastic3d)")
      ->type_name("T.txt");
  app.add_option("--landmarks", arguments->landmarks,
                 "The pairs: {\"landmarks\": [{\"name\": \"…\", \"fixed_mm\": [x, y, z], \"moving_mm\": [x, y, z]}, …]}")
      ->type_name("L.json");
  addNumber(app, "--pick-error", arguments->pickError_mm, {1e-6, 1e3}, "How well the landmarks' places were hit, mm (the file's, else 1)");
  app.add_option(
         "--coverage-fixed", arguments->coverageFixed,
         "What is known of each voxel of FIXED, as reconstruct --coverage writes it (without it, black that reaches the border is outside)")
      ->type_name("C.mha");
  app.add_option("--coverage-moving", arguments->coverageMoving, "The same of MOVING")->type_name("C.mha");
  app.add_option("--confidence-fixed", arguments->confidenceFixed, "How far each voxel of FIXED is believed, 0..255 on the same grid")
      ->type_name("C.mha");
  app.add_option("--confidence-moving", arguments->confidenceMoving, "The same of MOVING")->type_name("C.mha");
  addNumberList(
      app, "--beam-fixed", arguments->beamFixed, 3, "X Y Z",
      "rigid, partial, elastic3d: the direction of FIXED's beams, in its coordinates; shadows along it do not count (looked for)");
  addNumberList(app, "--beam-moving", arguments->beamMoving, 3, "X Y Z", "The same of MOVING");
  app.add_option("--effort", arguments->effort, "elastic3d: fast, balanced or accurate (balanced)")
      ->check(CLI::IsMember({"fast", "balanced", "accurate"}))
      ->type_name("EFFORT");
  addNumber(app, "--max-turn", arguments->maxRotation_deg, {0.0, 180.0}, "partial: turns searched, in every direction, degrees (30)");
  addNumber(app, "--step-turn", arguments->stepRotation_deg, {2.0, 90.0}, "partial: between turns of the first search, degrees (10)");
  addNumber(app, "--least-overlap", arguments->leastOverlap, {0.001, 0.999}, "partial: smallest share of the smaller volume (0.08)");
  addNumber(app, "--finest", arguments->finest_mm, {0.01, 100.0},
            "Voxels of the last level, mm (rigid and partial 0.75, elastic3d by effort)");
  addNumber(app, "--node", arguments->node_mm, {1.0, 1000.0}, "elastic3d: distance of control nodes at the last level, mm (by effort)");
  addNumber(app, "--stiffness", arguments->stiffness, {1e-6, 1e6}, "Weight of the regulariser (follows the measured speckle)");
  addNumber(app, "--max-motion", arguments->maxMotion_mm, {0.0, 50.0}, "elastic3d: how far the first search looks, mm; 0: none (12)");
  addNumber(app, "--max-time", arguments->maxTime_s, {0.01, 1e6}, "elastic3d: stop with the best so far after so many seconds (no limit)");
  app.add_flag("--single-resolution", arguments->singleResolution, "elastic2d: the finest level alone, which fails where several converge");
  app.add_flag("--assess", arguments->assess,
               "Also report local correlation, residuals and what is known of each region (not of images); a second or more");
  addCount(app, "--threads", arguments->threads, 0, 1024, "Threads; 0: all cores; the result does not depend on it (0)");
}

}  // namespace ew::cli
