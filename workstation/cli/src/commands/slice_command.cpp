#include <cmath>

#include "ew/core/figures.h"
#include "ew/core/numbers.h"
#include "ew/imaging/slicing.h"
#include "ew/io/image_file.h"
#include "run/arguments.h"
#include "run/command.h"
#include "run/volume_input.h"

namespace ew::cli {
namespace {

struct SliceArguments {
  std::string volume;
  std::string pose;
  std::string output;
  glm::ivec2 size_px{400, 400};
  std::optional<double> pixel_mm;
  std::string quality = "linear";
  int repeat = 0;  // 0: once, with images
  bool map = false;
};

/// "x -10 to 50, y 0 to 40, z 5 to 90 mm": where a pose has to be to see something.
std::string extentOf(const Grid& grid) {
  const Bounds bounds = boundsOf(grid);
  std::string text;
  for (int axis = 0; axis < 3; ++axis)
    text += std::string(axis == 0 ? "" : ", ") + "xyz"[axis] + " " + std::to_string(std::lround(bounds.lowest_mm[axis])) + " to " +
            std::to_string(std::lround(bounds.highest_mm[axis]));
  return text + " mm";
}

/// Share of the pixels that lie on the volume: at most half a voxel outside the outermost voxel centres.
double shareInside(const Grid& grid, const Transform<frame::Voxel, frame::Image>& imageToVoxel, const glm::ivec2& size_px) {
  const glm::dvec3 start(imageToVoxel.matrix[3]), perX(imageToVoxel.matrix[0]), perY(imageToVoxel.matrix[1]);
  const glm::dvec3 highest = glm::dvec3(grid.dims) - 0.5;
  std::size_t inside = 0;
  for (int y = 0; y < size_px.y; ++y)
    for (int x = 0; x < size_px.x; ++x) {
      const glm::dvec3 at = start + perX * static_cast<double>(x) + perY * static_cast<double>(y);
      inside += glm::all(glm::greaterThanEqual(at, glm::dvec3(-0.5))) && glm::all(glm::lessThanEqual(at, highest)) ? 1 : 0;
    }
  return static_cast<double>(inside) / (static_cast<double>(size_px.x) * size_px.y);
}

Error stopped() { return {ErrorCode::cancelled, say<"Stopped as asked; nothing was written.">(), {}}; }

Result<int> sliceVolume(const SliceArguments& arguments, Run& run) {
  const bool writes = arguments.repeat == 0;
  if (writes && arguments.output.empty())
    return failure(ErrorCode::badUsage, say<"Say where the image goes with -o OUT.png, or measure with --repeat N.">());
  const auto poses = readPoses(run, arguments.pose);
  if (!poses) return passOn(poses.error());
  if (auto kept = run.protect(arguments.volume); !kept) return passOn(kept.error());
  if (writes)
    for (std::size_t n = 0; n < poses->size(); ++n)
      if (auto announced = run.output(numbered(arguments.output, n, poses->size()), ".png .mha"); !announced)
        return passOn(announced.error());

  const auto volume = openInputVoxels(run, arguments.volume, arguments.map);
  if (!volume) return passOn(volume.error());
  const auto& spacing_mm = volume->grid().spacing_mm;
  const double pixel_mm = arguments.pixel_mm.value_or(std::min({spacing_mm.x, spacing_mm.y, spacing_mm.z}));
  const Quality quality = arguments.quality == "weave" ? Quality::weave : arguments.quality == "cubic" ? Quality::cubic : Quality::linear;
  const auto worldToVoxel = volume->grid().worldToVoxel();
  const auto imageToProbe = sliceGeometry(arguments.size_px.x, pixel_mm);
  run.report.options = {{"pose", arguments.pose},
                        {"poses", poses->size()},
                        {"size", {arguments.size_px.x, arguments.size_px.y}},
                        {"pixel_mm", pixel_mm},
                        {"quality", arguments.quality},
                        {"repeat", arguments.repeat},
                        {"mapped", volume->volume() == nullptr}};

  GreyImage image(arguments.size_px.x, arguments.size_px.y);
  SliceScratch scratch;
  const int rounds = writes ? 1 : arguments.repeat;
  const double total = static_cast<double>(rounds) * static_cast<double>(poses->size());
  double done = 0.0, leastInside = 1.0, sumInside = 0.0;
  for (int round = 0; round < rounds; ++round)
    for (std::size_t n = 0; n < poses->size(); ++n) {
      if (run.progress.cancelRequested()) return passOn(stopped());
      if (auto whole = volume->unchanged(); !whole) return passOn(whole.error());
      const auto imageToVoxel = worldToVoxel * (*poses)[n].probeToWorld * imageToProbe;
      {
        const StepClock clock(run.report, "slice");
        slice(quality, volume->source(volume->grid(), 0.0), imageToVoxel, viewOf(image), scratch);
      }
      if (round == 0) {
        const double inside = shareInside(volume->grid(), imageToVoxel, arguments.size_px);
        leastInside = std::min(leastInside, inside);
        sumInside += inside;
        if (inside == 0.0)
          run.remark(
              say<"The plane of pose %1 does not meet the volume, which spans %2; its image is black.">(n + 1, extentOf(volume->grid())));
      }
      if (writes) {
        const StepClock clock(run.report, "write");
        const auto target = run.outputs.staged(numbered(arguments.output, n, poses->size()));
        if (auto written = writeImage(viewOf(std::as_const(image)), pixel_mm, target); !written) return passOn(written.error());
      }
      run.progress.report(say<"Slicing">(), kShareOfReading + (1.0 - kShareOfReading) * ++done / total);
    }
  run.report.quality = {{"inside_share_mean", sumInside / static_cast<double>(poses->size())}, {"inside_share_min", leastInside}};
  if (writes)
    run.say("Wrote " + counted(poses->size(), "slice") + " of " + std::to_string(arguments.size_px.x) + " x " +
            std::to_string(arguments.size_px.y) + " pixels of " + figureText(pixel_mm) + " mm.");
  else
    run.say("Sliced " + counted(poses->size(), "pose") + " " + counted(static_cast<std::size_t>(rounds), "time") + ", median " +
            rounded(run.report.median_us("slice"), 0) + " us a slice.");
  return kDone;
}

}  // namespace

void addSlice(CLI::App& root, Selection& selection) {
  auto arguments = std::make_shared<SliceArguments>();
  auto& app = addCommand(root, selection, "slice", "Cut a plane out of a volume",
                         {"slice liver.mha --pose \"1 0 0 0  0 1 0 0  0 0 1 0  0 0 0 1\" -o slice.png",
                          "slice liver.mha --pose poses.txt --size 512x512 --pixel 0.5 --quality weave -o out.png",
                          "slice liver.mha --pose poses.txt --repeat 100 --report times.json"},
                         [arguments](Run& run) { return sliceVolume(*arguments, run); });
  app.add_option("VOLUME", arguments->volume, "The volume: .mha, .mhd, .nrrd, .nii or .nii.gz")->required()->type_name("");
  app.add_option(
         "--pose", arguments->pose,
         "16 numbers, row by row, from probe to world in mm (LPS), or a file with one pose a line; the plane is z = 0 of the probe, "
         "pixel (i, j) lies at x = (i - (W-1)/2) pixel, y = j pixel. Several poses number their outputs: out_0000.png …")
      ->required()
      ->type_name("POSE");
  app.add_option("-o,--output", arguments->output, "The image: .png, or .mha as a two-dimensional image; 0 outside the volume")
      ->type_name("OUT");
  addSize(app, "--size", arguments->size_px, "Pixels of the image (400x400)");
  addNumber(app, "--pixel", arguments->pixel_mm, {1e-6, 1e6}, "Size of a pixel in mm (the volume's smallest spacing)");
  app.add_option("--quality", arguments->quality,
                 "weave: nearest voxel, fastest; linear: trilinear; cubic: cubic convolution, most exact (linear)")
      ->check(CLI::IsMember({"weave", "linear", "cubic"}))
      ->type_name("QUALITY");
  app.add_flag("--map", arguments->map,
               "Leave an uncompressed volume in its file and read it by the page, as files from 1 GiB on always are");
  addCount(app, "--repeat", arguments->repeat, 1, 1000000, "Run the whole list N times and write nothing but the report");
}

}  // namespace ew::cli
