#include <algorithm>
#include <array>
#include <filesystem>

#include "arguments.h"
#include "command.h"
#include "ew/core/numbers.h"
#include "ew/io/volume_file.h"
#include "ew/library/case.h"
#include "ew/phantom/patient.h"

namespace ew::cli {
namespace {

struct PhantomArguments {
  std::string patient;
  std::string volume;
  std::string labels;
  double spacing_mm = 1.0;
  std::uint64_t seed = 1;
  int threads = 0;
  std::vector<std::string> set;
};

/// The words of --set: NAME=VALUE.
Result<ParameterValues> parameterValues(const std::vector<std::string>& words) {
  ParameterValues values;
  for (const std::string& word : words) {
    const auto sign = word.find('=');
    const auto value = sign == std::string::npos ? std::nullopt : parseNumber(std::string_view(word).substr(sign + 1));
    if (!value || sign == 0)
      return failure(ErrorCode::badUsage, "--set takes NAME=VALUE with a number, as in --set stone_diameter_mm=9; found \"" + word + "\".");
    values[word.substr(0, sign)] = *value;
  }
  return values;
}

Result<int> makePhantom(const PhantomArguments& arguments, Run& run) {
  if (arguments.volume.empty() && arguments.labels.empty())
    return failure(ErrorCode::badUsage, "Say what to write: --volume TRUTH.mha, --labels LABELS.mha, or both.");
  run.input(arguments.patient);
  for (const auto& file : {arguments.volume, arguments.labels})
    if (!file.empty())
      if (auto announced = run.output(file, ".mha .mhd"); !announced) return passOn(announced.error());
  run.report.options = {{"spacing_mm", arguments.spacing_mm}, {"threads", arguments.threads}};
  run.report.seed = arguments.seed;

  const auto resources = resourceFolder();
  const auto values = parameterValues(arguments.set);
  if (!values) return passOn(values.error());
  const auto patient = readPatient(arguments.patient, resources ? *resources / "mannequin" : std::filesystem::path(), *values);
  if (!patient) return passOn(patient.error());
  for (const PatientParameter& each : parametersOf(**patient))
    run.report.details["parameters"][each.name] = {{"value", each.value}, {"unit", each.unit}};
  VoxeliseOptions options;
  options.spacing_mm = arguments.spacing_mm;
  options.seed = arguments.seed;
  options.threads = arguments.threads;
  PartOfProgress voxelising(run.progress, 0.0, 0.9);
  auto made = [&] {
    const StepClock clock(run.report, "voxelise");
    return voxelise(**patient, options, voxelising);
  }();
  if (!made) return passOn(made.error());

  std::array<std::size_t, 256> voxelsOf{};
  for (const auto label : made->labels) ++voxelsOf[label];
  const auto& grid = made->volume.grid;
  const double voxel_ml = grid.spacing_mm.x * grid.spacing_mm.y * grid.spacing_mm.z / 1000.0;
  run.report.quality["voxels"] = grid.voxelCount();
  run.report.details["grid"] = {{"dims", {grid.dims.x, grid.dims.y, grid.dims.z}},
                                {"origin_mm", {grid.origin_mm.x, grid.origin_mm.y, grid.origin_mm.z}},
                                {"spacing_mm", {grid.spacing_mm.x, grid.spacing_mm.y, grid.spacing_mm.z}}};
  run.report.details["organs"] = nlohmann::json::array();
  for (const auto& organ : organsOf(**patient)) {
    const auto voxels = voxelsOf[static_cast<std::size_t>(organ.label) & 255u];
    const double volume_ml = static_cast<double>(voxels) * voxel_ml;
    run.report.details["organs"].push_back({{"label", organ.label}, {"name", organ.name}, {"voxels", voxels}, {"volume_ml", volume_ml}});
    run.say(std::to_string(organ.label) + "  " + organ.name + "  " + rounded(volume_ml, 1) + " ml");
  }

  const StepClock clock(run.report, "write");
  if (!arguments.volume.empty()) {
    PartOfProgress writing(run.progress, 0.9, 0.97);
    if (auto written = writeVolume(made->volume, run.outputs.staged(arguments.volume), writing); !written) return passOn(written.error());
    run.say("Wrote " + arguments.volume + ".");
  }
  if (!arguments.labels.empty()) {
    PartOfProgress writing(run.progress, 0.97, 1.0);
    made->volume.echo = std::move(made->labels);
    if (auto written = writeVolume(made->volume, run.outputs.staged(arguments.labels), writing); !written) return passOn(written.error());
    run.say("Wrote " + arguments.labels + ".");
  }
  return kDone;
}

}  // namespace

void addPhantom(CLI::App& root, Selection& selection) {
  auto arguments = std::make_shared<PhantomArguments>();
  auto& app = addCommand(
      root, selection, "phantom", "Turn a virtual patient into a volume whose truth is known",
      {"phantom patient.json --volume truth.mha --labels labels.mha", "phantom patient.json --volume fine.mha --spacing 0.5 --seed 7"},
      [arguments](Run& run) { return makePhantom(*arguments, run); });
  app.add_option("PATIENT", arguments->patient, "The virtual patient: patient.json")->required()->type_name("");
  app.add_option("--volume", arguments->volume, "Echo levels with speckle: .mha or .mhd")->type_name("TRUTH.mha");
  app.add_option("--labels", arguments->labels, "Which organ owns a voxel (0: none); the numbers are listed when done")
      ->type_name("LABELS.mha");
  app.add_option("--set", arguments->set, "A parameter of the recipe, such as the size of a finding; may be given several times")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
  addNumber(app, "--spacing", arguments->spacing_mm, {0.01, 100.0}, "Size of a voxel in mm (1)");
  addSeed(app, "--seed", arguments->seed, "Of the speckle; the same seed gives the same voxels everywhere (1)");
  addCount(app, "--threads", arguments->threads, 0, 1024, "Threads; 0: all cores; the voxels do not depend on it (0)");
}

}  // namespace ew::cli
