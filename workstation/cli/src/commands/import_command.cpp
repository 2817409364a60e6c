#include <algorithm>

#include "ew/core/ending.h"
#include "ew/core/figures.h"
#include "ew/core/numbers.h"
#include "ew/io/sequence.h"
#include "ew/library/file_import.h"
#include "run/arguments.h"
#include "run/asked_option.h"
#include "run/command.h"
#include "run/length_option.h"

namespace ew::cli {
namespace {

using nlohmann::json;

struct ImportArguments {
  std::string file;
  std::string output;
  std::string mask;
  std::string region;
  std::string pixel_mm;
  std::string spacing_mm;
  std::string colour;
  std::vector<std::string> blank;
  std::string raw;
  int timeStep = 0;
  bool keepText = false;
  bool mirrored = false;
  bool asSequence = false;
  bool acceptsSmall = false;
  std::optional<double> rate_hz;
};

Result<ImportAnswers> answersOf(const ImportArguments& arguments) {
  ImportAnswers answers;
  if (arguments.region == "all") {
    answers.region = 0;
  } else if (!arguments.region.empty()) {
    const auto number = parseIntegers(arguments.region);
    if (!number || number->size() != 1 || number->front() < 0 || number->front() > 1000)
      return failure(ErrorCode::badUsage, say<"--region takes the number of a region from 1, or all; not '%1'.">(arguments.region));
    answers.region = static_cast<int>(number->front());
  }
  if (!arguments.pixel_mm.empty()) {
    const auto values = lengthsGiven("--pixel-mm", arguments.pixel_mm, 2);
    if (!values) return passOn(values.error());
    answers.pixel_mm = glm::dvec2((*values)[0], (*values)[1]);
  }
  if (!arguments.spacing_mm.empty()) {
    const auto values = lengthsGiven("--spacing", arguments.spacing_mm, 3);
    if (!values) return passOn(values.error());
    answers.spacing_mm = glm::dvec3((*values)[0], (*values)[1], (*values)[2]);
  }
  if (arguments.colour == "keep-grey") answers.colour = ColourRule::keepGrey;
  if (arguments.colour == "drop-colour") answers.colour = ColourRule::dropColour;
  for (const std::string& text : arguments.blank) {
    const auto rect = parsePixelRect(text);
    if (!rect) return passOn(rect.error());
    answers.blank.push_back(*rect);
  }
  if (!arguments.raw.empty()) {
    const auto layout = parseRawLayout(arguments.raw);
    if (!layout) return passOn(layout.error());
    answers.raw = *layout;
  }
  if (arguments.timeStep > 0) answers.timeStep = arguments.timeStep;
  answers.keepText = arguments.keepText;
  answers.mirrored = arguments.mirrored;
  answers.asSequence = arguments.asSequence;
  answers.acceptsSmall = arguments.acceptsSmall;
  answers.rate_hz = arguments.rate_hz;
  return answers;
}

json toJson(const Removed& removed) {
  json blanked = json::array(), kept = json::array();
  for (const PixelRect& rect : removed.blanked) blanked.push_back({rect.x, rect.y, rect.width, rect.height});
  for (const PixelRect& rect : removed.blankedOutside) kept.push_back({rect.x, rect.y, rect.width, rect.height});
  return {{"fields", english(removed.fields)},
          {"private_fields", removed.privateFields},
          {"pixels_per_frame", removed.pixelsPerFrame},
          {"blanked", blanked},
          {"cut_to", kept}};
}

/// The error with everything else that this file asks for, found by answering what it asks: nobody wants to be asked one thing at a time.
tl::unexpected<Error> withAllQuestions(Error error, const std::string& file, ImportAnswers answers, Run& run) {
  const std::string first = askedFor(error);
  std::string further;
  for (std::string asked = first; !asked.empty();) {
    if (asked == "region") {
      answers.region = 1;
    } else if (asked == "pixel-mm") {
      answers.pixel_mm = glm::dvec2(1.0);
    } else if (asked == "colour") {
      answers.colour = ColourRule::keepGrey;
    } else if (asked == "blank") {
      answers.keepText = true;
    } else if (asked == "accept-small") {
      answers.acceptsSmall = true;
    } else {
      break;
    }
    const auto next = importFile(file, answers, run.progress);
    const std::string question = next ? std::string() : askedFor(next.error());
    if (question == asked) break;
    if (!question.empty()) further += (further.empty() ? " It also asks for " : "; ") + optionFor(question);
    asked = question;
  }
  auto told = withOption(std::move(error));
  if (!further.empty()) told.value().message = verbatim(told.value().sentence() + further + ".");
  return told;
}

Result<int> import(const ImportArguments& arguments, Run& run) {
  const auto answers = answersOf(arguments);
  if (!answers) return passOn(answers.error());
  if (auto kept = run.input(arguments.file); !kept) return passOn(kept.error());
  if (auto announced = run.output(arguments.output, ".mha .mhd"); !announced) return passOn(announced.error());
  if (!arguments.mask.empty())
    if (auto announced = run.output(arguments.mask, ".mha"); !announced) return passOn(announced.error());
  PartOfProgress reading(run.progress, 0.0, 0.8), writing(run.progress, 0.8, 1.0);
  Result<FileImportResult> read = [&] {
    const StepClock clock(run.report, "read");
    return importFile(arguments.file, *answers, reading);
  }();
  if (!read) return withAllQuestions(read.error(), arguments.file, *answers, run);
  for (const Message& warning : read->warnings) run.remark(warning);
  for (const Message& note : read->notes)
    if (std::find(read->warnings.begin(), read->warnings.end(), note) == read->warnings.end()) run.remark(note);
  for (const Message& sentence : sentencesOf(read->removed)) run.remark(sentence);
  run.report.details["kind"] = nameOf(read->kind);
  run.report.details["notes"] = english(read->notes);
  run.report.details["removed"] = toJson(read->removed);
  const StepClock clock(run.report, "write");
  const auto out = run.outputs.staged(arguments.output);
  if (read->volume) {
    if (!arguments.mask.empty())
      return failure(ErrorCode::badUsage, say<"--colour-mask is for images; %1 became a volume.">(arguments.file));
    const Grid& grid = read->volume->grid;
    if (auto written = writeVolume(*read->volume, out, writing); !written) return passOn(written.error());
    run.report.quality = {{"voxels", grid.voxelCount()}, {"spacing_mm", {grid.spacing_mm.x, grid.spacing_mm.y, grid.spacing_mm.z}}};
    run.say("Wrote " + arguments.output + ": " + std::to_string(grid.dims.x) + " x " + std::to_string(grid.dims.y) + " x " +
            std::to_string(grid.dims.z) + " voxels of " + figureText(grid.spacing_mm.x) + " x " + figureText(grid.spacing_mm.y) + " x " +
            figureText(grid.spacing_mm.z) + " mm.");
    return kDone;
  }
  if (hasEnding(arguments.output, ".mhd"))
    return failure(ErrorCode::badUsage, say<"%1 holds images without a volume; end the output's name in .igs.mha.">(arguments.file));
  Cine& cine = *read->images;
  if (auto written = writeSequence(cine.sequence, out, writing); !written) return passOn(written.error());
  if (!arguments.mask.empty()) {
    Sequence mask = cine.sequence;
    std::fill(mask.pixels.begin(), mask.pixels.end(), std::uint8_t{0});
    for (std::size_t n = 0; n < cine.coloured.size(); ++n) mask.pixels[n] = cine.coloured[n] != 0 ? 255 : 0;
    if (auto written = writeSequence(mask, run.outputs.staged(arguments.mask)); !written) return passOn(written.error());
  }
  run.report.quality = {{"frames", cine.sequence.frames.size()},
                        {"width_px", cine.sequence.width},
                        {"height_px", cine.sequence.height},
                        {"pixel_mm", {cine.pixel_mm.x, cine.pixel_mm.y}},
                        {"coloured_share", cine.colouredShare}};
  run.say("Wrote " + arguments.output + ": " + counted(cine.sequence.frames.size(), "frame") + " of " +
          std::to_string(cine.sequence.width) + " x " + std::to_string(cine.sequence.height) + " pixels of " + figureText(cine.pixel_mm.x) +
          " x " + figureText(cine.pixel_mm.y) + " mm.");
  return kDone;
}

}  // namespace

void addImport(CLI::App& root, Selection& selection) {
  auto arguments = std::make_shared<ImportArguments>();
  auto& app = addCommand(
      root, selection, "import", "Turn DICOM, Kretz, NIfTI, raw samples or images into a volume or a sequence without patient fields",
      {"import cine.dcm -o cine.igs.mha --region 1", "import volume.vol -o volume.mha --spacing 0.5",
       "import samples.raw -o volume.mha --raw 256x256x180:u8:0.5,0.5,1.2", "import slices/ -o volume.mha --spacing 0.3,0.3,0.5",
       "import still.dcm -o still.igs.mha --region all --pixel-mm 0.2 --colour keep-grey --report removed.json"},
      [arguments](Run& run) { return import(*arguments, run); });
  app.add_option("FILE", arguments->file, "DICOM, .vol, .nii, .mha, .nrrd, raw samples, or a folder of .png, .jpg, .pgm or DICOM stills")
      ->required()
      ->type_name("");
  app.add_option("-o,--output", arguments->output, "A volume .mha or .mhd; for cines and planes a sequence .igs.mha")
      ->required()
      ->type_name("OUT");
  app.add_option("--region", arguments->region, "Ultrasound region of a DICOM file, from 1; all: the whole image")->type_name("N");
  app.add_option("--pixel-mm", arguments->pixel_mm, "Size of a pixel of DICOM images in mm")->type_name("X,Y");
  addNumber(app, "--rate", arguments->rate_hz, {0.001, 100000.0},
            "Frames a second of a DICOM cine that does not say it, or says it wrongly");
  app.add_option("--spacing", arguments->spacing_mm,
                 "Spacing in mm of images and of volumes that do not say it; of what Kretz beams become")
      ->type_name("X,Y,Z");
  app.add_option("--colour", arguments->colour, "keep-grey: coloured pixels as their luminance; drop-colour: as black")
      ->check(CLI::IsMember({"keep-grey", "drop-colour"}))
      ->type_name("RULE");
  app.add_option("--colour-mask", arguments->mask, "Also write where the images were coloured (255)")->type_name("OUT.igs.mha");
  app.add_option("--blank", arguments->blank, "Make this rectangle of every image black; may be given several times")
      ->type_name("X,Y,W,H")
      ->allow_extra_args(false);
  app.add_flag("--keep-text", arguments->keepText, "Take the whole image although the file says that text is burned in");
  addCount(app, "--time-step", arguments->timeStep, 1, 1000000, "Which of several volumes in the file, from 1");
  app.add_option(
         "--raw", arguments->raw,
         "Read samples without a header, as in 256x256x180:u8:0.5,0.5,1.2:512; types u8 i8 u16 i16 u32 i32 f32 f64, with be for big endian")
      ->type_name("DIMS:TYPE:SPACING[:OFFSET]");
  app.add_flag("--mirrored", arguments->mirrored, "Turn the elevational axis of a Kretz volume over");
  app.add_flag("--accept-small", arguments->acceptsSmall,
               "Import also when less than a tenth of each image is kept, DICOM stills are missing between others, or the size of a "
               "voxel can hardly be meant");
  app.add_flag("--planes", arguments->asSequence, "Write the planes of an Enhanced US Volume as a sequence with their poses");
}

}  // namespace ew::cli
