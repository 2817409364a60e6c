
#include "ew/acquisition/screen_recording.h"
#include "ew/core/numbers.h"
#include "ew/io/sequence.h"
#include "run/arguments.h"
#include "run/asked_option.h"
#include "run/command.h"

namespace ew::cli {
namespace {

using nlohmann::json;

constexpr double kRadian_deg = 57.29577951308232;

struct ScreenArguments {
  std::string recording;
  std::string output;
  std::string correction;
  std::string deviceSet;
  std::optional<double> depth_mm;
  std::optional<double> tick_mm;
  std::optional<double> rate_hz;
  std::string fill = "neighbours";
  bool keepOutside = false;
  int turn_deg = 0;
  bool isMirrored = false;
  bool acceptsSmall = false;
};

json toJson(const PixelRect& rect) { return {rect.x, rect.y, rect.width, rect.height}; }

json toJson(const FanOutline& outline) {
  json fan{{"shape", outline.word()}};
  if (outline.shape == FanShape::linear) {
    for (const glm::dvec2 corner : outline.corners_px) fan["corners_px"].push_back({corner.x, corner.y});
    return fan;
  }
  fan["apex_px"] = {outline.apex_px.x, outline.apex_px.y};
  fan["angles_deg"] = {outline.left_rad * kRadian_deg, outline.right_rad * kRadian_deg};
  fan["radii_px"] = {outline.near_px, outline.far_px};
  return fan;
}

/// What the report says beside its common keys: everything found, in pixels of the recording.
void describe(const ScreenSurvey& opened, const ScreenGeometry& geometry, Report& report) {
  const ScreenAnalysis& found = opened.found;
  report.details["kind"] = nameOf(opened.reader.info().kind);
  report.details["outline"] = geometry.outline ? toJson(*geometry.outline) : json(nullptr);
  if (found.ticks)
    report.details["ticks"] = {{"x_px", found.ticks->x_px},
                               {"first_px", found.ticks->first_px},
                               {"spacing_px", found.ticks->spacing_px},
                               {"count", found.ticks->count},
                               {"every", found.ticks->every}};
  json parts = json::array();
  for (const ScreenPart& part : found.parts) parts.push_back({{"kind", nameOf(part.kind)}, {"box_px", toJson(part.rect)}});
  report.details["parts"] = std::move(parts);
  json blanked = json::array();
  for (const PixelRect& box : geometry.text) blanked.push_back(toJson(box));
  report.details["blanked"] = std::move(blanked);
  if (opened.brokenOff) report.details["broken_off"] = opened.brokenOff->sentence();
  report.quality["outline_quality"] = found.quality;
  report.quality["frames"] = opened.times_s.size();
  report.quality["frames_looked_at"] = found.frames;
  if (found.ticks) report.quality["tick_spacing_px"] = found.ticks->spacing_px;
  if (geometry.pixel_mm) report.quality["pixel_mm"] = *geometry.pixel_mm;
  if (geometry.pixel_mm && geometry.outline) report.quality["depth_mm"] = *geometry.pixel_mm * geometry.outline->depth_px();
}

Result<ScreenCorrection> correctionOf(const ScreenArguments& arguments) {
  ScreenCorrection correction;
  if (!arguments.correction.empty()) {
    auto read = readScreenCorrection(arguments.correction);
    if (!read) return passOn(read.error());
    correction = *std::move(read);
  }
  if (arguments.depth_mm) correction.depth_mm = arguments.depth_mm;
  if (arguments.tick_mm) correction.tick_mm = arguments.tick_mm;
  if (arguments.turn_deg != 0 || arguments.isMirrored) correction.turned = {arguments.turn_deg / 90, arguments.isMirrored};
  return correction;
}

std::string told(const FanOutline& outline, const std::optional<double>& pixel_mm) {
  std::string text = std::string(outline.word()) + ", ";
  if (outline.shape != FanShape::linear)
    text += rounded(outline.left_rad * kRadian_deg, 1) + " to " + rounded(outline.right_rad * kRadian_deg, 1) + " degrees, ";
  text += rounded(outline.depth_px(), 1) + " pixels deep";
  if (pixel_mm) text += " (" + rounded(*pixel_mm * outline.depth_px(), 1) + " mm)";
  return text;
}

Result<int> cleanScreen(const ScreenArguments& arguments, Run& run) {
  if (auto kept = run.input(arguments.recording); !kept) return passOn(kept.error());
  if (!arguments.correction.empty())
    if (auto kept = run.input(arguments.correction); !kept) return passOn(kept.error());
  const auto correction = correctionOf(arguments);
  if (!correction) return passOn(correction.error());
  if (auto announced = run.output(arguments.output, ".mha"); !announced) return passOn(announced.error());
  const std::string beside = screenFileBeside(arguments.output).string();
  // The correction that was given may be this very file: it stays as it is.
  const bool isCorrection =
      !arguments.correction.empty() && std::filesystem::weakly_canonical(arguments.correction) == std::filesystem::weakly_canonical(beside);
  if (!isCorrection)
    if (auto announced = run.output(beside); !announced) return passOn(announced.error());
  if (!arguments.deviceSet.empty())
    if (auto announced = run.output(arguments.deviceSet, ".xml"); !announced) return passOn(announced.error());
  const CleaningOptions cleaning{.fill = arguments.fill == "black" ? TextFill::black : TextFill::neighbours,
                                 .keepOutside = arguments.keepOutside,
                                 .acceptsSmall = arguments.acceptsSmall || correction->outline.has_value()};
  run.report.options = {{"fill", arguments.fill}, {"keep_outside", arguments.keepOutside}};
  if (correction->depth_mm) run.report.options["depth_mm"] = *correction->depth_mm;
  if (correction->tick_mm) run.report.options["tick_mm"] = *correction->tick_mm;
  if (arguments.rate_hz) run.report.options["rate_hz"] = *arguments.rate_hz;
  if (!correction->turned.isUpright()) {
    run.report.options["turn_deg"] = correction->turned.degrees();
    run.report.options["mirror"] = correction->turned.mirrored;
  }

  PartOfProgress looking(run.progress, 0.0, 0.6), writing(run.progress, 0.6, 1.0);
  auto opened = [&] {
    const StepClock clock(run.report, "find");
    return openScreen(arguments.recording, correction->outline, looking, {}, kScreenFrames, correction->turned, arguments.rate_hz);
  }();
  if (!opened) return passOn(opened.error());
  for (const Message& note : opened->reader.info().notes) run.remark(note);
  if (opened->reader.info().assumedRate_hz > 0.0) run.remark(ew::say<"If the images have another rate, state it with --rate.">());
  for (const Message& note : opened->found.notes) run.remark(note);
  if (opened->brokenOff) run.remark(opened->brokenOff->message);
  const auto geometry = corrected(opened->found, *correction);
  if (!geometry) return passOn(geometry.error());
  for (const Message& note : geometry->notes) run.remark(note);
  describe(*opened, *geometry, run.report);
  run.report.verdict = geometry->outline ? "found" : "not found";
  if (!geometry->outline && !arguments.keepOutside) {
    run.say(
        "The outline of the scan was not found, and nothing was written; give a correction with its outline (--correction), or "
        "--keep-outside.");
    return kVerdict;
  }

  const StepClock clock(run.report, "write");
  const auto cleaned = writeCleaned(*opened, *geometry, cleaning, run.outputs.staged(arguments.output), writing);
  if (!cleaned) return withOption(cleaned.error());
  if (!isCorrection)
    if (auto written = writeScreen(opened->found, *correction, run.outputs.staged(beside)); !written) return passOn(written.error());
  if (!arguments.deviceSet.empty())
    if (auto written = writeDeviceSet(deviceSetOf(*geometry, cleaned->kept), run.outputs.staged(arguments.deviceSet)); !written)
      return passOn(written.error());
  for (const Message& sentence : sentencesOf(cleaned->removed)) run.remark(sentence);
  if (arguments.keepOutside) run.remark(ew::say<"What lies outside the scan was kept; check that it names nobody.">());
  if (!geometry->pixel_mm)
    run.remark(ew::say<"The size of a pixel is not known, so the recording has none; state the depth or the distance of the ticks.">());
  run.report.details["cut_to"] = toJson(cleaned->kept);
  run.report.quality["width_px"] = cleaned->kept.width;
  run.report.quality["height_px"] = cleaned->kept.height;
  run.report.quality["fan_filled_share"] =
      static_cast<double>(cleaned->pixelsFilled) / static_cast<double>(std::max<std::size_t>(cleaned->pixelsInside, 1));
  run.say("Wrote " + arguments.output + ": " + counted(cleaned->frames, "frame") + " of " + std::to_string(cleaned->kept.width) + " x " +
          std::to_string(cleaned->kept.height) + " pixels" +
          (geometry->outline ? "; " + told(*geometry->outline, geometry->pixel_mm) : std::string()) + ", quality " +
          rounded(opened->found.quality, 2) + "; " + counted(geometry->text.size(), "place") + " with text filled.");
  return kDone;
}

}  // namespace

void addScreen(CLI::App& root, Selection& selection) {
  auto arguments = std::make_shared<ScreenArguments>();
  auto& app = addCommand(
      root, selection, "screen", "Find the scan in a recorded screen or film, and write it without text and without what stands around it",
      {"screen recording.mp4 -o liver.igs.mha --depth 160", "screen cine.dcm -o heart.igs.mha --tick 10 --report found.json",
       "screen stack.tif -o liver.igs.mha --correction liver.screen.json --device-set liver.xml"},
      [arguments](Run& run) { return cleanScreen(*arguments, run); });
  app.add_option("RECORDING", arguments->recording,
                 "A film (MP4, AVI, MPEG ...), a DICOM cine or film, a TIFF of several pages, a sequence, or a folder of images")
      ->required()
      ->type_name("");
  app.add_option("-o,--output", arguments->output, "The cleaned recording; its geometry goes beside it, into OUT.screen.json")
      ->required()
      ->type_name("OUT.igs.mha");
  addNumber(app, "--depth", arguments->depth_mm, {1.0, 1000.0},
            "Depth of the scan in mm, as the screen states it: from its near to its far edge");
  addNumber(app, "--tick", arguments->tick_mm, {0.05, 500.0}, "Distance of neighbouring marks of the depth scale in mm");
  addNumber(app, "--rate", arguments->rate_hz, {0.001, 100000.0},
            "Images a second of a recording that does not say it, or says it wrongly");
  app.add_option("--correction", arguments->correction,
                 "Outline, depth, boxes to add or to remove: a .screen.json as this command writes, edited")
      ->type_name("C.json");
  app.add_option("--turn", arguments->turn_deg, "Turn the images clockwise by so many degrees, on top of what the file says: 90, 180, 270")
      ->check(CLI::IsMember({90, 180, 270}))
      ->type_name("DEGREES");
  app.add_flag("--mirror", arguments->isMirrored, "Then mirror them, left to right");
  app.add_option("--fill", arguments->fill, "Under text: neighbours, smoothly from the scan around it; black")
      ->check(CLI::IsMember({"neighbours", "black"}))
      ->type_name("WAY");
  app.add_flag("--keep-outside", arguments->keepOutside, "Keep the whole image; only boxes of text over the scan are filled");
  app.add_flag("--accept-small", arguments->acceptsSmall, "Write also when less than a tenth of each image or of the frames is kept");
  app.add_option("--device-set", arguments->deviceSet,
                 "Also write what reconstruct --calibration takes: the fan, and where pixels lie before the probe")
      ->type_name("OUT.xml");
}

}  // namespace ew::cli
