#include "commands/case_new.h"

#include <algorithm>
#include <array>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include "ew/core/json_fields.h"
#include "ew/io/json_files.h"
#include "ew/library/new_case.h"
#include "ew/library/templates.h"
#include "run/arguments.h"
#include "run/asked_option.h"
#include "run/length_option.h"

namespace ew::cli {
namespace {

namespace fs = std::filesystem;

struct NewCaseArguments {
  std::string source;
  std::string output;
  std::string title;
  std::string traineeTitle;
  std::string region;
  std::string templateId;
  std::string mannequin;
  std::string landmarks;
  std::string calibration;
  std::string attribution;
  std::string licence;
  std::string spacing_mm;
  std::optional<int> timeStep;
  std::string probeSide;
  std::optional<std::vector<double>> fan;    // left right (degrees), apex x y, start stop radius (pixels)
  std::optional<std::vector<double>> place;  // x y z (mm), about x y z (degrees)
  bool isListing = false;
  bool withoutLevel = false;
  bool takesWholeFrames = false;
  bool acceptsSmall = false;
  int framesEvery = 0;
};

constexpr double kFinestOfSweep_mm = 0.1, kCoarsestOfSweep_mm = 10.0;

/// Rotations about x, then y, then z of the world, then the way.
Transform<frame::World, frame::File> placeOf(const std::vector<double>& six) {
  glm::dmat4 matrix = glm::translate(glm::dmat4(1.0), glm::dvec3(six[0], six[1], six[2]));
  matrix = glm::rotate(matrix, glm::radians(six[5]), glm::dvec3(0.0, 0.0, 1.0));
  matrix = glm::rotate(matrix, glm::radians(six[4]), glm::dvec3(0.0, 1.0, 0.0));
  return {glm::rotate(matrix, glm::radians(six[3]), glm::dvec3(1.0, 0.0, 0.0))};
}

/// {"format": 1, "pairs": [{"file_mm": [x, y, z], "landmark": "xiphoid"}, {"name": "…", "file_mm": …, "world_mm": …}]}
Result<std::vector<PlacingPair>> readPairs(const fs::path& file, const std::string& mannequin) {
  constexpr int kFormat = 1;
  constexpr double kFarthest_mm = 1e5;
  const Message where = verbatim(file.filename().string());
  const auto document = readJsonFile(file, where);
  if (!document) return passOn(document.error());
  const auto known = landmarksOf(mannequin);
  JsonReading reading(where, {"note"});
  const JsonFields fields(*document, reading);
  requireFormat(fields, kFormat);
  fields.only({"format", "pairs"});
  std::vector<PlacingPair> pairs;
  for (const JsonFields& each : fields.objects("pairs", 3, 100)) {
    each.only({"name", "landmark", "file_mm", "world_mm"});
    PlacingPair pair;
    const std::string id = each.text("landmark", "", 0);
    pair.name = each.text("name", id, 0);
    pair.file_mm = each.point("file_mm", kFarthest_mm);
    if (id.empty()) {
      pair.world_mm = each.point("world_mm", kFarthest_mm);
    } else {
      if (!known) return passOn(known.error());
      const auto named = std::find_if(known->landmarks.begin(), known->landmarks.end(), [&](const auto& one) { return one.id == id; });
      if (named == known->landmarks.end())
        each.refuse("landmark", say<"the id of a named place of the mannequin">());
      else
        pair.world_mm = named->at_mm;
    }
    pairs.push_back(std::move(pair));
  }
  if (reading.problem()) return passOn(*reading.problem());
  return pairs;
}

Clip clipOf(const std::vector<double>& six) {
  Clip clip;
  clip.fan = ClipFan{.origin_px = {six[2], six[3]},
                     .leftAngle_rad = glm::radians(six[0]),
                     .rightAngle_rad = glm::radians(six[1]),
                     .startRadius_px = six[4],
                     .stopRadius_px = six[5]};
  return clip;
}

Result<std::optional<glm::dvec3>> spacingGiven(const NewCaseArguments& arguments) {
  if (arguments.spacing_mm.empty()) return std::optional<glm::dvec3>();
  const auto given = lengthsGiven("--spacing", arguments.spacing_mm, 3);
  if (!given) return passOn(given.error());
  return std::optional(glm::dvec3((*given)[0], (*given)[1], (*given)[2]));
}

/// As withOption, of the options that this command has. What else is asked the command answers that makes a volume.
tl::unexpected<Error> withOwnOption(Error error) {
  constexpr std::array<std::string_view, 4> own{"time-step", "spacing", "calibration", "accept-small"};
  constexpr std::array<std::string_view, 5> ofSweep{"frame", "motor", "rate", "time-offset", "reconstruct"};
  const std::string asked = askedFor(error);
  if (asked.empty() || std::find(own.begin(), own.end(), asked) != own.end()) return withOption(std::move(error));
  const bool isOfSweep = std::find(ofSweep.begin(), ofSweep.end(), asked) != ofSweep.end();
  std::string sentence = error.sentence();
  if (sentence.ends_with('.')) sentence.pop_back();
  const std::string calibration = asked == "frame" ? optionFor("calibration") + ", or " : std::string();
  error.message = verbatim(sentence + ": " + calibration + "make its volume first (echoweave " + (isOfSweep ? "reconstruct" : "import") +
                           "), then the case of that.");
  return passOn(std::move(error));
}

Result<CaseSource> sourceOf(const NewCaseArguments& arguments) {
  if (arguments.source.empty()) return CaseSource{};
  auto source = ew::sourceOf(arguments.source);
  if (!source) return source;
  if (arguments.framesEvery > 0 && !std::holds_alternative<SweepFile>(*source))
    return failure(ErrorCode::badUsage,
                   say<"--keep-images keeps images of a tracked recording, and '%1' is none; leave it out.">(arguments.source));
  const auto given_mm = spacingGiven(arguments);
  if (!given_mm) return passOn(given_mm.error());
  const std::optional<glm::dvec3>& spacing_mm = *given_mm;
  if (auto* sweep = std::get_if<SweepFile>(&*source)) {
    if (spacing_mm &&
        !(spacing_mm->x >= kFinestOfSweep_mm && spacing_mm->x <= kCoarsestOfSweep_mm && *spacing_mm == glm::dvec3(spacing_mm->x)))
      return failure(ErrorCode::badUsage,
                     say<"The volume of a recording has one --spacing along all axes, from %1 to %2 mm; not '%3'.">(
                         numeral(rounded(kFinestOfSweep_mm, 1)), numeral(rounded(kCoarsestOfSweep_mm, 0)), arguments.spacing_mm));
    if (spacing_mm) sweep->spacing_mm = spacing_mm->x;
    sweep->calibration = arguments.calibration;
    if (arguments.fan) sweep->clip = clipOf(*arguments.fan);
    sweep->looksForFan = !arguments.takesWholeFrames;
    sweep->acceptsSmall = arguments.acceptsSmall;
    sweep->framesEvery = arguments.framesEvery;
  } else if (auto* volume = std::get_if<VolumeFile>(&*source)) {
    volume->answers.spacing_mm = spacing_mm;
    volume->answers.acceptsSmall = arguments.acceptsSmall;
    volume->answers.timeStep = arguments.timeStep;
    volume->probeSide = volumeSideOf(arguments.probeSide);
  } else if (auto* stitched = std::get_if<StitchingResult>(&*source)) {
    stitched->probeSide = volumeSideOf(arguments.probeSide);
  }
  return source;
}

Result<NewCase> wantedOf(const NewCaseArguments& arguments, Run& run) {
  if (arguments.place && !arguments.landmarks.empty())
    return failure(ErrorCode::badUsage, say<"--place and --landmarks both say where the volume lies; give one of them.">());
  NewCase wanted;
  wanted.title = arguments.title.empty() ? fs::path(arguments.output).lexically_normal().filename().string() : arguments.title;
  wanted.titleForTrainees = arguments.traineeTitle;
  wanted.region = arguments.region;
  wanted.templateId = arguments.templateId;
  wanted.mannequin = arguments.mannequin;
  wanted.attribution = arguments.attribution;
  wanted.licence = arguments.licence;
  wanted.makesLevel = !arguments.withoutLevel;
  auto source = sourceOf(arguments);
  if (!source) return withOwnOption(source.error());
  wanted.source = *std::move(source);
  if (arguments.place) wanted.fileToWorld = placeOf(*arguments.place);
  if (arguments.landmarks.empty()) return wanted;
  const auto pairs = readPairs(arguments.landmarks, arguments.mannequin);
  if (!pairs) return passOn(pairs.error());
  const auto fit = placeByLandmarks(*pairs);
  if (!fit) return passOn(fit.error());
  wanted.fileToWorld = fit->fileToWorld;
  run.report.quality["landmarks_rms_mm"] = fit->rms_mm;
  if (fit->wrong)
    run.remark(say<"The pair '%1' contradicts the others by %2 mm and was left out; check it.">(
        (*pairs)[*fit->wrong].name, numeral(rounded(fit->residuals_mm[*fit->wrong], 1))));
  return wanted;
}

void tellMade(const NewCaseArguments& arguments, const NewCasePlan& plan, const CaseCreation& made, Run& run) {
  auto& quality = run.report.quality;
  quality["forecast_mib"] = static_cast<double>(plan.bytes) / 1048576.0;
  quality["forecast_s"] = plan.seconds;
  run.report.outputs.push_back(arguments.output);
  run.report.details["case"] = {{"id", made.made.id}, {"file_to_world", rowsOf(made.made.volume.fileToWorld)}};
  run.say("Made the case " + made.made.id + " in " + arguments.output +
          (hasNoVolume(made.made) ? "; it has no volume yet." : ": " + made.made.volume.file + "."));
  if (made.frames) {
    quality["frames_total"] = made.frames->total;
    quality["frames_used"] = made.frames->used;
    run.say("Used " + std::to_string(made.frames->used) + " of " + counted(made.frames->total, "frame") + ".");
  }
  if (!made.contact) return;
  quality["contact_share"] = made.contact->faceShare;
  quality["deepest_gap_mm"] = made.contact->deepestGap_mm;
  quality["deepest_intrusion_mm"] = made.contact->deepestIntrusion_mm;
  quality["outside_share"] = made.contact->outsideShare;
  run.say("On the mannequin " + rounded(100.0 * made.contact->faceShare, 0) + " % of its near face touch the skin, gaps up to " +
          rounded(made.contact->deepestGap_mm, 1) + " mm; " + rounded(100.0 * made.contact->outsideShare, 1) +
          " % of it lie outside the body.");
}

Result<int> listAll(Run& run) {
  const TemplateList list = listTemplates();
  for (const CaseTemplate& each : list.templates) run.out() << each.id << "  " << each.title.english << ": " << each.text.english << "\n";
  for (const Error& problem : list.problems) run.remark(problem.message);
  return kDone;
}

constexpr std::uint64_t kMebibyte = 1ull << 20;
Message aboutMebibytes(std::uint64_t bytes) {
  return bytes < kMebibyte ? say<"less than 1 MiB">() : say<"about %1 MiB">(bytes / kMebibyte);
}
Message mostMebibytes(std::uint64_t bytes) {
  return bytes < kMebibyte ? say<"less than 1 MiB">() : say<"at most %1 MiB">((bytes + kMebibyte - 1) / kMebibyte);
}

Result<int> makeNew(const NewCaseArguments& arguments, Run& run) {
  if (arguments.isListing) return listAll(run);
  if (arguments.output.empty()) return failure(ErrorCode::badUsage, say<"Say where the case is to be made, with -o DIR.">());
  for (const std::string& file : {arguments.source, arguments.landmarks, arguments.calibration})
    if (!file.empty())
      if (auto kept = run.input(file); !kept) return passOn(kept.error());
  const auto wanted = wantedOf(arguments, run);
  if (!wanted) return passOn(wanted.error());
  PartOfProgress planning(run.progress, 0.0, 0.2), making(run.progress, 0.2, 1.0);
  const auto plan = [&] {
    const StepClock clock(run.report, "plan");
    return planCase(*wanted, planning);
  }();
  if (!plan) return withOwnOption(plan.error());
  run.remark(say<"Making the case needs %1 of memory and %2 on disk.">(aboutMebibytes(plan->bytes), mostMebibytes(plan->disk_bytes)));
  run.report.options = {{"template", arguments.templateId}, {"region", arguments.region}, {"mannequin", arguments.mannequin}};
  const auto spacing_mm = spacingGiven(arguments);
  if (!spacing_mm) return passOn(spacing_mm.error());
  run.report.options["spacing_mm"] = *spacing_mm ? nlohmann::json{(*spacing_mm)->x, (*spacing_mm)->y, (*spacing_mm)->z} : nlohmann::json();
  const auto made = [&] {
    const StepClock clock(run.report, "make");
    return makeCase(*wanted, arguments.output, making);
  }();
  if (!made) return withOwnOption(made.error());
  run.isPublished = true;
  for (const Message& each : made->notes) run.remark(each);
  tellMade(arguments, *plan, *made, run);
  return kDone;
}

}  // namespace

void addCaseNew(CLI::App& group, Selection& selection) {
  auto arguments = std::make_shared<NewCaseArguments>();
  auto& app = addCommand(group, selection, "new", "Make a case of a volume, a recording or a stitched result, placed on the mannequin",
                         {"case new liver.igs.mha -o my-cases/liver --region \"right upper quadrant\" --spacing 1",
                          "case new stitched/volume.mha -o my-cases/abdomen --template upper-abdomen --title \"Gall stone\"",
                          "case new -o my-cases/later --template thyroid-and-neck", "case new --list-templates"},
                         [arguments](Run& run) { return makeNew(*arguments, run); });
  app.add_option("SOURCE", arguments->source,
                 "A volume, a tracked recording, a stitch project, or the folder stitching wrote; without it the case waits for a volume")
      ->type_name("");
  app.add_option("-o,--output", arguments->output, "The case folder to make; it appears complete or not at all")->type_name("DIR");
  app.add_option("--title", arguments->title, "Title for authors and instructors (the folder's name)")->type_name("TEXT");
  app.add_option("--trainee-title", arguments->traineeTitle, "Title for trainees, which gives no finding away")->type_name("TEXT");
  app.add_option("--region", arguments->region, "Region of the body, which also says where the volume is put (the template's)")
      ->type_name("TEXT");
  app.add_option("--template", arguments->templateId, "What such cases have in common: probes, effects, an outline of lessons")
      ->type_name("ID");
  app.add_flag("--list-templates", arguments->isListing, "List the templates and end");
  app.add_option("--mannequin", arguments->mannequin, "A file of resources/mannequin (the template's, else adult.json)")->type_name("FILE");
  addNumberList(app, "--place", arguments->place, 6, "X Y Z RX RY RZ",
                "Where the volume lies: mm, then degrees about x, then y, then z (where the region's probe usually stands)");
  app.add_option("--landmarks", arguments->landmarks, "Pairs of places in the volume and on the body, by which it is placed")
      ->type_name("JSON");
  app.add_option("--spacing", arguments->spacing_mm,
                 "Size of a voxel in mm: of a recording one length (as fine as its frames carry); of a volume that does not know its own "
                 "one length or three")
      ->type_name("X[,Y,Z]");
  addNumberList(app, "--fan", arguments->fan, 6, "LEFT RIGHT X Y START STOP",
                "Which part of a recording's images is image: angles (degrees from down), apex and radii of its fan (pixels; as its "
                "device set says, else found in the images)");
  app.add_flag("--whole-frames", arguments->takesWholeFrames,
               "Look for no fan in a recording's images; what its device set says still holds");
  addCount(app, "--time-step", arguments->timeStep, 1, 1'000'000, "Which volume of a file that holds several, from 1");
  app.add_option("--probe-side", arguments->probeSide,
                 "From which side a volume was scanned: front, back, left, right, upper or lower, as its file has them; without it the "
                 "side is taken that its voxels suggest, and a remark says so")
      ->check(CLI::IsMember({"front", "back", "left", "right", "upper", "lower"}))
      ->type_name("SIDE");
  app.add_option("--calibration", arguments->calibration, "Device set of the recording")->type_name("XML");
  app.add_option("--keep-images", arguments->framesEvery,
                 "Keep every N-th image of a recording beside its volume: slices read them, and are as sharp as they")
      ->check(CLI::Range(1, 1000));
  app.add_flag(
      "--accept-small", arguments->acceptsSmall,
      "Make the case also when less than a tenth of the recording's pixels or frames is used, or when its size can hardly be meant");
  app.add_flag("--no-level", arguments->withoutLevel, "No level for live echoes: the image stays the recorded one");
  app.add_option("--attribution", arguments->attribution, "Whom to name for the recording")->type_name("TEXT");
  app.add_option("--licence", arguments->licence, "Under which licence the recording may be passed on")->type_name("TEXT");
}

}  // namespace ew::cli
