#include <algorithm>
#include <map>

#include "ew/core/ending.h"
#include "ew/core/label_colour.h"
#include "ew/core/numbers.h"
#include "ew/io/surface_file.h"
#include "ew/io/volume_file.h"
#include "ew/labelling/label_surfaces.h"
#include "run/arguments.h"
#include "run/command.h"

namespace ew::cli {
namespace {

struct SurfacesArguments {
  std::string labels;
  std::string output;
  std::vector<std::string> only;
  std::vector<std::string> names;
  double smoothing_voxel = labelling::LabelSurfaceOptions{}.shortestWave_voxel;
  int threads = 0;
};

Result<std::uint8_t> labelFrom(const std::string& word) {
  const auto number = parseIntegers(word);
  if (!number || number->size() != 1 || number->front() < 1 || number->front() > 255)
    return failure(ErrorCode::badUsage, say<"'%1' is no label; give a whole number from 1 to 255.">(word));
  return static_cast<std::uint8_t>(number->front());
}

Result<std::vector<std::uint8_t>> wantedLabels(const std::vector<std::string>& words) {
  std::vector<std::uint8_t> labels;
  for (const std::string& word : words) {
    const auto label = labelFrom(word);
    if (!label) return passOn(label.error());
    labels.push_back(*label);
  }
  return labels;
}

Result<std::map<std::uint8_t, std::string>> namesOfLabels(const std::vector<std::string>& words) {
  std::map<std::uint8_t, std::string> names;
  for (const std::string& word : words) {
    const std::size_t equals = word.find('=');
    if (equals == std::string::npos || equals + 1 == word.size())
      return failure(ErrorCode::badUsage, say<"--name takes NUMBER=NAME, as in --name 3=liver; found \"%1\".">(word));
    const auto label = labelFrom(word.substr(0, equals));
    if (!label) return passOn(label.error());
    names[*label] = word.substr(equals + 1);
  }
  return names;
}

/// The smoothing that is asked for makes sense, and an STL file gets one label.
Result<void> checkSurfaces(const SurfacesArguments& arguments, std::size_t labels) {
  if (arguments.smoothing_voxel > 0.0 && arguments.smoothing_voxel < 4.0)
    return failure(ErrorCode::badUsage,
                   say<"--smoothing %1 cannot be used; give 0 or a number from 4 to 32.">(textOf(arguments.smoothing_voxel)));
  if (!hasEnding(arguments.output, ".glb") && labels != 1)
    return failure(ErrorCode::badUsage, say<"%1 holds one surface; say which with --label NUMBER, or write .glb.">(arguments.output));
  return {};
}

/// What every label has become, for the report and the screen; those that are wanted.
Result<std::vector<SurfacePart>> partsOf(const labelling::LabelSurfaces& surfaces, const std::vector<std::uint8_t>& only,
                                         const std::map<std::uint8_t, std::string>& names, Run& run) {
  std::vector<SurfacePart> named;
  run.report.details["surfaces"] = nlohmann::json::array();
  for (const std::uint8_t label : surfaces.labels) {
    if (!only.empty() && std::find(only.begin(), only.end(), label) == only.end()) continue;
    if (run.progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"Making surfaces was stopped.">());
    const auto name = names.find(label);
    named.push_back({.name = name == names.end() ? "label " + std::to_string(label) : name->second,
                     .colour = colourOfLabel(label),
                     .mesh = labelling::meshOf(surfaces, label)});
    const SurfaceMesh& mesh = named.back().mesh;
    run.report.details["surfaces"].push_back(
        {{"label", label}, {"name", named.back().name}, {"points", mesh.points_mm.size()}, {"triangles", mesh.triangles.size()}});
    run.say(std::to_string(label) + "  " + named.back().name + "  " + counted(mesh.triangles.size(), "triangle"));
  }
  for (const std::uint8_t label : only)
    if (std::find(surfaces.labels.begin(), surfaces.labels.end(), label) == surfaces.labels.end())
      return failure(ErrorCode::notFound, say<"No voxel has the label %1; leave --label out to see which there are.">(int{label}));
  return named;
}

Result<int> makeSurfaces(const SurfacesArguments& arguments, Run& run) {
  const auto only = wantedLabels(arguments.only);
  if (!only) return passOn(only.error());
  const auto names = namesOfLabels(arguments.names);
  if (!names) return passOn(names.error());
  if (auto kept = run.input(arguments.labels); !kept) return passOn(kept.error());
  if (auto announced = run.output(arguments.output, ".glb .stl .ply"); !announced) return passOn(announced.error());
  if (auto usable = checkSurfaces(arguments, only->size()); !usable) return passOn(usable.error());
  PartOfProgress reading(run.progress, 0.0, 0.4), making(run.progress, 0.4, 0.8);
  const auto read = [&] {
    const StepClock clock(run.report, "read");
    return readLabelVolume(arguments.labels, reading);
  }();
  if (!read) return passOn(read.error());
  const labelling::LabelSurfaceOptions options{.shortestWave_voxel = arguments.smoothing_voxel, .threads = arguments.threads};
  const auto surfaces = [&] {
    const StepClock clock(run.report, "surfaces");
    return labelling::labelSurfaces(read->volume.view(), options, making);
  }();
  if (!surfaces) return passOn(surfaces.error());
  const auto named = partsOf(*surfaces, *only, *names, run);
  if (!named) return passOn(named.error());
  const StepClock clock(run.report, "write");
  const auto file = run.outputs.staged(arguments.output);
  if (auto written = hasEnding(arguments.output, ".glb") ? writeGltf(*named, file) : writeSurface(named->front().mesh, file); !written)
    return passOn(written.error());
  run.report.options = {{"smoothing_voxel", arguments.smoothing_voxel}, {"threads", arguments.threads}};
  run.report.quality = {{"points", surfaces->points_mm.size()}, {"triangles", surfaces->triangles.size()}};
  run.say("Wrote " + arguments.output + " with " + counted(named->size(), "surface") + ".");
  return kDone;
}

}  // namespace

void addSurfaces(CLI::App& root, Selection& selection) {
  auto arguments = std::make_shared<SurfacesArguments>();
  auto& app =
      addCommand(root, selection, "surfaces", "Make smooth, closed surfaces of the labels of a volume, for 3D programs and printers",
                 {"surfaces labels.mha -o organs.glb --name 1=liver --name 2=aorta", "surfaces labels.mha -o liver.stl --label 1"},
                 [arguments](Run& run) { return makeSurfaces(*arguments, run); });
  app.add_option("LABELS", arguments->labels, "A number per voxel, 0 for none: .mha, .mhd, .nrrd, .nii or .nii.gz, 8 bits, unsigned")
      ->required()
      ->type_name("");
  app.add_option("-o,--output", arguments->output,
                 "All surfaces with names and colours: .glb (glTF 2.0, metres); the surface of one label: .stl or .ply (mm, LPS)")
      ->required()
      ->type_name("SURFACES.glb");
  app.add_option("--label", arguments->only, "Only this label; may be given several times (all)")
      ->type_name("NUMBER")
      ->allow_extra_args(false);
  app.add_option("--name", arguments->names, "The name of a label; may be given several times (label NUMBER)")
      ->type_name("NUMBER=NAME")
      ->allow_extra_args(false);
  addNumber(app, "--smoothing", arguments->smoothing_voxel, {0.0, 32.0},
            "Waves of so many voxels are halved and shorter ones, the stairs of the voxels, taken away: 4 to 32; 0: not smoothed (8)");
  addCount(app, "--threads", arguments->threads, 0, 1000, "Threads; 0: all cores; the surfaces do not depend on it (0)");
}

}  // namespace ew::cli
