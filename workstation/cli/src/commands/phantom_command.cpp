#include <algorithm>
#include <array>
#include <filesystem>

#include "commands/phantom_flow.h"
#include "commands/phantom_sweep.h"
#include "ew/core/numbers.h"
#include "ew/core/quiet_progress.h"
#include "ew/io/safe_file.h"
#include "ew/io/surface_file.h"
#include "ew/io/volume_file.h"
#include "ew/library/case.h"
#include "ew/phantom/flow.h"
#include "ew/phantom/patient.h"
#include "ew/phantom/truth.h"
#include "run/arguments.h"
#include "run/command.h"

namespace ew::cli {
namespace {

struct PhantomArguments {
  std::string patient;
  std::string volume;
  std::string labels;
  std::string level;
  double spacing_mm = 1.0;
  std::uint64_t seed = 1;
  int threads = 0;
  std::vector<std::string> set;
  std::string truth;
  BodyState state;
  std::vector<std::string> surfaces;
  double edge_mm = 1.0;
  SweepArguments sweep;
  FlowArguments flow;
};

/// The words of --set: NAME=VALUE.
Result<ParameterValues> parameterValues(const std::vector<std::string>& words) {
  ParameterValues values;
  for (const std::string& word : words) {
    const auto sign = word.find('=');
    const auto value = sign == std::string::npos ? std::nullopt : parseNumber(std::string_view(word).substr(sign + 1));
    if (!value || sign == 0)
      return failure(ErrorCode::badUsage,
                     say<"--set takes NAME=VALUE with a number, as in --set stone_diameter_mm=9; found \"%1\".">(word));
    values[word.substr(0, sign)] = *value;
  }
  return values;
}

nlohmann::json jsonOf(const glm::dvec3& p) { return {p.x, p.y, p.z}; }

/// What the anatomy has exactly, for lessons and for the judging of algorithms.
Result<nlohmann::json> truthOf(const Patient& patient, const BodyState& state, Progress& progress) {
  const auto measurements = measurementsOf(patient, state, progress);
  if (!measurements) return passOn(measurements.error());
  nlohmann::json truth = {{"format", 1}, {"state", {{"breath", state.breath}, {"pulse", state.pulse}}}};
  truth["parameters"] = nlohmann::json::object();
  for (const PatientParameter& each : parametersOf(patient))
    truth["parameters"][each.name] = {{"value", each.value}, {"unit", each.unit}, {"lowest", each.lowest}, {"highest", each.highest}};
  truth["organs"] = nlohmann::json::array();
  for (const OrganName& each : organsOf(patient)) truth["organs"].push_back({{"label", each.label}, {"name", each.name}});
  truth["measurements"] = nlohmann::json::array();
  for (const TrueMeasurement& each : *measurements) {
    nlohmann::json entry = {{"name", each.name}, {"kind", each.kind}, {"value", each.value}, {"unit", each.unit}};
    if (!each.plane.empty()) entry["plane"] = each.plane;
    for (const glm::dvec3& point : each.points_mm) entry["points_mm"].push_back(jsonOf(point));
    truth["measurements"].push_back(std::move(entry));
  }
  truth["planes"] = nlohmann::json::array();
  for (const StandardPlane& each : planesOf(patient))
    truth["planes"].push_back({{"name", each.name},
                               {"probe_to_world", rowsOf(each.probeToWorld.matrix)},
                               {"position_tolerance_mm", each.positionTolerance_mm},
                               {"angle_tolerance_deg", each.angleTolerance_deg},
                               {"shows", each.shows}});
  if (!flowOf(patient).streams.empty()) truth["flow"] = flowTruthOf(patient);
  return truth;
}

Result<void> writeTruth(const PhantomArguments& arguments, const Patient& patient, Run& run) {
  const StepClock clock(run.report, "truth");
  auto truth = truthOf(patient, arguments.state, run.progress);
  if (!truth) return passOn(truth.error());
  for (const auto& each : (*truth)["measurements"])
    run.say(each["name"].get<std::string>() + ": " + rounded(each["value"].get<double>(), 2) + " " + each["unit"].get<std::string>());
  if (auto written = writeFileSafely(run.outputs.staged(arguments.truth), truth->dump(2) + "\n"); !written) return written;
  run.say("Wrote " + arguments.truth + ".");
  return {};
}

using Surfaces = std::vector<std::pair<std::string, std::string>>;  // organ, file

/// The words of --surface: ORGAN=FILE.
Result<Surfaces> wantedSurfaces(const std::vector<std::string>& words) {
  Surfaces wanted;
  for (const std::string& word : words) {
    const auto sign = word.find('=');
    if (sign == std::string::npos || sign == 0 || sign + 1 == word.size())
      return failure(ErrorCode::badUsage, say<"--surface takes ORGAN=FILE, as in --surface liver=liver.stl; found \"%1\".">(word));
    wanted.emplace_back(word.substr(0, sign), word.substr(sign + 1));
  }
  return wanted;
}

Result<void> announcePhantom(const PhantomArguments& arguments, const Surfaces& surfaces, Run& run) {
  if (auto kept = run.input(arguments.patient); !kept) return kept;
  for (const auto& file : {arguments.volume, arguments.labels, arguments.level})
    if (!file.empty())
      if (auto announced = run.output(file, ".mha .mhd"); !announced) return announced;
  if (!arguments.truth.empty())
    if (auto announced = run.output(arguments.truth, ".json"); !announced) return announced;
  for (const auto& [organ, file] : surfaces)
    if (auto announced = run.output(file, ".stl .ply"); !announced) return announced;
  return announceSweep(arguments.sweep, run);
}

Result<void> writeSurfaces(const PhantomArguments& arguments, const Patient& patient, const Surfaces& surfaces, Run& run) {
  for (const auto& [organ, file] : surfaces) {
    const StepClock clock(run.report, "surface");
    const auto mesh = surfaceOf(patient, organ, arguments.edge_mm, run.progress);
    if (!mesh) return passOn(mesh.error());
    if (auto written = writeSurface(*mesh, run.outputs.staged(file)); !written) return written;
    run.say("Wrote " + file + " with " + counted(mesh->triangles.size(), "triangle") + ".");
  }
  return {};
}

/// How many voxels each organ has.
void reportOrgans(const Patient& patient, const VoxelPatient& made, Run& run) {
  std::array<std::size_t, 256> voxelsOf{};
  for (const auto label : made.labels) ++voxelsOf[label];
  const auto& grid = made.volume.grid;
  const double voxel_ml = grid.spacing_mm.x * grid.spacing_mm.y * grid.spacing_mm.z / 1000.0;
  run.report.quality["voxels"] = grid.voxelCount();
  run.report.details["grid"] = {{"dims", {grid.dims.x, grid.dims.y, grid.dims.z}},
                                {"origin_mm", {grid.origin_mm.x, grid.origin_mm.y, grid.origin_mm.z}},
                                {"spacing_mm", {grid.spacing_mm.x, grid.spacing_mm.y, grid.spacing_mm.z}}};
  run.report.details["organs"] = nlohmann::json::array();
  for (const auto& organ : organsOf(patient)) {
    const auto voxels = voxelsOf[static_cast<std::size_t>(organ.label) & 255u];
    const double volume_ml = static_cast<double>(voxels) * voxel_ml;
    run.report.details["organs"].push_back({{"label", organ.label}, {"name", organ.name}, {"voxels", voxels}, {"volume_ml", volume_ml}});
    run.say(std::to_string(organ.label) + "  " + organ.name + "  " + rounded(volume_ml, 1) + " ml");
  }
}

/// @param from share of the whole work that is done before
Result<void> makeVoxels(const PhantomArguments& arguments, const Patient& patient, double from, Run& run) {
  VoxeliseOptions options;
  options.spacing_mm = arguments.spacing_mm;
  options.seed = arguments.seed;
  options.threads = arguments.threads;
  options.maps = !arguments.level.empty();
  PartOfProgress voxelising(run.progress, from, 0.9);
  auto made = [&] {
    const StepClock clock(run.report, "voxelise");
    return voxelise(patient, options, voxelising);
  }();
  if (!made) return passOn(made.error());
  reportOrgans(patient, *made, run);
  const StepClock clock(run.report, "write");
  if (!arguments.volume.empty()) {
    PartOfProgress writing(run.progress, 0.9, 0.97);
    if (auto written = writeVolume(made->volume, run.outputs.staged(arguments.volume), writing); !written) return written;
    run.say("Wrote " + arguments.volume + ".");
  }
  if (!arguments.labels.empty()) {
    PartOfProgress writing(run.progress, 0.97, 0.99);
    made->volume.echo = std::move(made->labels);
    if (auto written = writeVolume(made->volume, run.outputs.staged(arguments.labels), writing); !written) return written;
    run.say("Wrote " + arguments.labels + ".");
  }
  if (made->maps) {
    PartOfProgress writing(run.progress, 0.99, 1.0);
    made->volume.echo = std::move(made->maps->level);
    if (auto written = writeVolume(made->volume, run.outputs.staged(arguments.level), writing); !written) return written;
    run.say("Wrote " + arguments.level + " with " + counted(made->maps->surfaces.size(), "reflecting surface") + ".");
  }
  return {};
}

Result<int> makePhantom(const PhantomArguments& arguments, Run& run) {
  const bool voxelsWanted = !arguments.volume.empty() || !arguments.labels.empty() || !arguments.level.empty();
  const bool sweepWanted = !arguments.sweep.sweep.empty();
  const auto surfaces = wantedSurfaces(arguments.surfaces);
  if (!surfaces) return passOn(surfaces.error());
  if (auto announced = announcePhantom(arguments, *surfaces, run); !announced) return passOn(announced.error());
  if (!voxelsWanted && !sweepWanted && arguments.truth.empty() && arguments.surfaces.empty() && !arguments.flow.at_mm)
    return failure(ErrorCode::badUsage,
                   say<"Say what to write: --volume TRUTH.mha, --labels LABELS.mha, --level LEVEL.mha, --truth TRUTH.json, --surface "
                       "ORGAN=FILE, --sweep SWEEP.json -o SWEEP.igs.mha, or several; or ask with --blood X Y Z.">());
  run.report.options = {{"spacing_mm", arguments.spacing_mm}, {"threads", arguments.threads}};
  run.report.seed = arguments.seed;

  const auto resources = resourceFolder();
  const auto values = parameterValues(arguments.set);
  if (!values) return passOn(values.error());
  QuietProgress reading(run.progress);
  const auto patient = readPatient(arguments.patient, resources ? *resources / "mannequin" : std::filesystem::path(), *values, reading);
  if (!patient) return passOn(patient.error());
  for (const PatientParameter& each : parametersOf(**patient))
    run.report.details["parameters"][each.name] = {{"value", each.value}, {"unit", each.unit}};
  if (!arguments.truth.empty())
    if (auto written = writeTruth(arguments, **patient, run); !written) return passOn(written.error());
  if (arguments.flow.at_mm)
    if (auto told = tellBlood(arguments.flow, **patient, run); !told) return passOn(told.error());
  if (auto written = writeSurfaces(arguments, **patient, *surfaces, run); !written) return passOn(written.error());
  if (sweepWanted) {
    PartOfProgress sweeping(run.progress, 0.0, voxelsWanted ? 0.7 : 1.0);
    if (auto made = makeSweep(arguments.sweep, *patient, arguments.threads, run, sweeping); !made) return passOn(made.error());
  }
  if (!voxelsWanted) return kDone;
  if (auto made = makeVoxels(arguments, **patient, sweepWanted ? 0.7 : 0.0, run); !made) return passOn(made.error());
  return kDone;
}

}  // namespace

void addPhantom(CLI::App& root, Selection& selection) {
  auto arguments = std::make_shared<PhantomArguments>();
  auto& app = addCommand(
      root, selection, "phantom", "Turn a virtual patient into a volume or a sweep whose truth is known",
      {"phantom patient.json --volume truth.mha --labels labels.mha", "phantom patient.json --volume fine.mha --spacing 0.5 --seed 7",
       "phantom patient.json --sweep sweep.json -o sweep.igs.mha --truth-poses poses.txt --device-set sweep.xml"},
      [arguments](Run& run) { return makePhantom(*arguments, run); });
  app.add_option("PATIENT", arguments->patient, "The virtual patient: patient.json")->required()->type_name("");
  app.add_option("--volume", arguments->volume, "Echo levels with speckle: .mha or .mhd")->type_name("TRUTH.mha");
  app.add_option("--labels", arguments->labels, "Which organ owns a voxel (0: none); the numbers are listed when done")
      ->type_name("LABELS.mha");
  app.add_option("--level", arguments->level, "Echo levels without speckle, borders and shadows, as live echoes are formed from them")
      ->type_name("LEVEL.mha");
  app.add_option("--sweep", arguments->sweep.sweep, "Scan the patient as this file says: probe, path, machine, tracker")
      ->type_name("SWEEP.json");
  app.add_option("-o,--output", arguments->sweep.output, "The recording of the sweep: a tracked sequence")->type_name("SWEEP.igs.mha");
  app.add_option("--truth-poses", arguments->sweep.truePoses, "Where the probe truly was, a pose a line, whatever the tracker saw")
      ->type_name("POSES.txt");
  app.add_option("--device-set", arguments->sweep.deviceSet, "Calibration and sector of the sweep, for reconstruct --calibration")
      ->type_name("OUT.xml");
  app.add_option("--set", arguments->set, "A parameter of the recipe, such as the size of a finding; may be given several times")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
  app.add_option("--truth", arguments->truth, "The recipe's measurements, standard planes and flow, exactly: .json")
      ->type_name("TRUTH.json");
  addNumber(app, "--breath", arguments->state.breath, {0.0, 1.0}, "Of --truth: 0 breathed out, 1 breathed in (0)");
  addNumber(app, "--pulse", arguments->state.pulse, {0.0, 1.0}, "Of --truth: 0 vessels narrow, 1 wide (0)");
  addNumberList(app, "--blood", arguments->flow.at_mm, 3, "X Y Z", "Tell how blood flows at this place of the body at rest, in mm");
  addNumber(app, "--time", arguments->flow.time_s, {0.0, 1e6}, "Of --blood: the moment in s; beats are those of the patient's pulse (0)")
      .needs("--blood");
  app.add_option("--surface", arguments->surfaces, "An organ's surface as triangles: .stl or .ply; may be given several times")
      ->type_name("ORGAN=FILE")
      ->allow_extra_args(false);
  addNumber(app, "--edge", arguments->edge_mm, {0.01, 100.0}, "Of --surface: size of its cells in mm (1)");
  addNumber(app, "--spacing", arguments->spacing_mm, {0.01, 100.0}, "Size of a voxel in mm (1)");
  addSeed(app, "--seed", arguments->seed, "Of the speckle; the same seed gives the same voxels everywhere (1)");
  addCount(app, "--threads", arguments->threads, 0, 1024, "Threads; 0: all cores; the voxels do not depend on it (0)");
}

}  // namespace ew::cli
