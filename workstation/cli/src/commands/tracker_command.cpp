#include <algorithm>
#include <chrono>
#include <ostream>
#include <thread>

#include "ew/library/case.h"
#include "ew/trackers/camera_device.h"
#include "ew/trackers/hand_controller.h"
#include "ew/trackers/marker_sheet.h"
#include "ew/tracking/calibration_file.h"
#include "run/arguments.h"
#include "run/command.h"

namespace ew::cli {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

struct TrackerArguments {
  std::vector<std::string> bodies;
  std::string output;
  std::string paper = "a4";
  std::string language = "en";
  std::optional<double> measuredScale_mm;
  std::string calibration;
  bool asJson = false;
};

fs::path trackersFolder() { return libraryFolder() / "trackers"; }

/// The program's and the user's own.
Result<std::vector<PaperBody>> allBodies() {
  const auto resources = resourceFolder();
  if (!resources) return passOn(resources.error());
  return readPaperBodies({*resources / "marker_bodies", trackersFolder() / "bodies"});
}

Message namesOf(const std::vector<PaperBody>& bodies) {
  std::vector<Message> names;
  for (const PaperBody& body : bodies) names.push_back(verbatim(body.id));
  return joined(names, ", ");
}

/// Those that are asked for, each once, in that order; without a wish what a camera needs: a probe, the board and the chess board.
Result<std::vector<PaperBody>> chosenBodies(const std::vector<std::string>& ids) {
  const auto all = allBodies();
  if (!all) return passOn(all.error());
  std::vector<PaperBody> chosen;
  for (const std::string& id : ids.empty() ? std::vector<std::string>{"box-60", "mannequin-board", "calibration-board"} : ids) {
    const auto found = std::find_if(all->begin(), all->end(), [&](const PaperBody& body) { return body.id == id; });
    if (found == all->end())
      return failure(ErrorCode::badUsage, say<"There is no marker body '%1'; there are: %2.">(id, namesOf(*all)), {{"body", id}});
    if (std::none_of(chosen.begin(), chosen.end(), [&](const PaperBody& body) { return body.id == id; })) chosen.push_back(*found);
  }
  return chosen;
}

Result<int> print(const TrackerArguments& arguments, Run& run) {
  if (arguments.output.empty() && !arguments.measuredScale_mm)
    return failure(ErrorCode::badUsage,
                   say<"Say where the sheets go with -o marker.pdf, or what the printed scale measures with --measured-scale MM.">());
  if (arguments.measuredScale_mm)
    if (auto factor = printedFactor(*arguments.measuredScale_mm); !factor) return failure(ErrorCode::badUsage, factor.error().message);
  run.report.options = {{"paper", arguments.paper}, {"language", arguments.language}};
  if (!arguments.output.empty()) {
    const auto chosen = chosenBodies(arguments.bodies);
    if (!chosen) return passOn(chosen.error());
    if (auto announced = run.output(arguments.output, ".pdf"); !announced) return passOn(announced.error());
    const PaperSize paper = arguments.paper == "letter" ? PaperSize::letter : PaperSize::a4;
    if (auto written = writeMarkerSheet(*chosen, paper, run.outputs.staged(arguments.output), {}, arguments.language); !written)
      return passOn(written.error());
    json names = json::array();
    for (const PaperBody& body : *chosen) names.push_back({{"id", body.id}, {"version", body.version}});
    run.report.details["bodies"] = names;
    run.report.quality["pages"] = chosen->size();
    run.say(counted(chosen->size(), "sheet") + " in " + arguments.output +
            ". Print at 100 % (actual size); both scales must measure 100 mm.");
  }
  if (arguments.measuredScale_mm) {
    if (auto kept = keepPrintedScale(trackersFolder(), *arguments.measuredScale_mm); !kept) return passOn(kept.error());
    run.report.options["measured_scale_mm"] = *arguments.measuredScale_mm;
    run.say("Cameras take 100 mm of a sheet for " + rounded(*arguments.measuredScale_mm, 4) + " mm from now on.");
  }
  return kDone;
}

const char* kindOf(const PaperBody& body) {
  switch (body.kind) {
    case PaperKind::held:
      return "held";
    case PaperKind::board:
      return "board";
    case PaperKind::calibration:
      return "calibration";
  }
  return "";
}

/// What a controller says of itself within a second.
json controllerHere(HandControllerKind kind, const char* name) {
  const auto device = makeHandController(kind);
  device->start();
  using namespace std::chrono_literals;
  for (int n = 0; n < 20 && device->status().link != LinkState::connected; ++n) std::this_thread::sleep_for(50ms);
  const AxisStatus status = device->status();
  device->stop();
  return {
      {"kind", name}, {"connected", status.link == LinkState::connected}, {"name", status.name}, {"sentence", status.sentence.english()}};
}

Result<int> list(const TrackerArguments& arguments, Run& run) {
  const auto bodies = allBodies();
  if (!bodies) return passOn(bodies.error());
  const auto scale = readPrintedScale(trackersFolder());
  if (!scale) return passOn(scale.error());
  json rows = json::array();
  for (const PaperBody& body : *bodies) {
    std::size_t markers = 0;
    for (const PaperPanel& panel : body.panels) markers += panel.markers.size();
    rows.push_back({{"id", body.id},
                    {"name", body.name.in(arguments.language)},
                    {"kind", kindOf(body)},
                    {"version", body.version},
                    {"dictionary", body.dictionary},
                    {"markers", markers}});
  }
  const json controllers = {controllerHere(HandControllerKind::spaceMouse, "SpaceMouse"),
                            controllerHere(HandControllerKind::gameController, "game controller")};
  json cameras = json::array();
  for (const CameraHere& camera : camerasHere()) cameras.push_back({{"device", camera.device}, {"name", camera.name}});
  const json all = {{"bodies", rows},
                    {"cameras", cameras},
                    {"controllers", controllers},
                    {"measured_scale_mm", *scale},
                    {"own_bodies", (trackersFolder() / "bodies").string()}};
  run.report.details["trackers"] = all;
  run.report.quality = {{"bodies", bodies->size()}};
  if (arguments.asJson) {
    run.out() << all.dump(2, ' ', false, json::error_handler_t::replace) << "\n";
    return kDone;
  }
  run.out() << "Marker bodies (your own go to " << (trackersFolder() / "bodies").string() << "):\n";
  for (const json& row : rows) {
    std::string id = row["id"].get<std::string>();
    id.resize(std::max<std::size_t>(id.size() + 2, 20), ' ');
    run.out() << "  " << id << row["name"].get<std::string>() << "\n";
  }
  run.out() << "Cameras:\n";
  for (const json& row : cameras) run.out() << "  " << row["device"].get<std::string>() << "  " << row["name"].get<std::string>() << "\n";
  if (cameras.empty()) run.out() << "  none is connected\n";
  run.out() << "Hand controllers:\n";
  for (const json& row : controllers)
    run.out() << "  " << row["kind"].get<std::string>() << ": "
              << (row["connected"].get<bool>() ? row["name"].get<std::string>() : row["sentence"].get<std::string>()) << "\n";
  if (*scale != 100.0) run.out() << "Printed scale: 100 mm measure " << rounded(*scale, 4) << " mm.\n";
  return kDone;
}

std::string partOf(const char* what, const CalibrationQuality& quality) {
  if (quality.method == "none" || quality.method.empty()) return std::string(what) + ": not calibrated\n";
  std::string line =
      std::string(what) + ": " + quality.method + ", " + quality.made + ", residual " + rounded(quality.residual_mm, 3) + " mm";
  if (quality.expected_mm > 0.0) line += ", expected within " + rounded(quality.expected_mm, 3) + " mm";
  return line + " (" + counted(static_cast<std::size_t>(std::max(0, quality.samples)), "sample") + ")\n";
}

/// An honest no is a calibration of which a part was never made, or that is expected to be worse than a standard plane allows.
Result<int> check(const TrackerArguments& arguments, Run& run) {
  constexpr double kWorst_mm = 8.0;
  if (auto kept = run.input(arguments.calibration); !kept) return passOn(kept.error());
  const auto read = readCalibration(arguments.calibration);
  if (!read) return passOn(read.error());
  run.out() << arguments.calibration << ": revision " << read->revision << " of '" << read->tool << "' on '" << read->source << "'\n"
            << partOf("  face", read->face) << partOf("  alignment", read->alignment);
  const auto isMade = [](const CalibrationQuality& quality) { return !quality.method.empty() && quality.method != "none"; };
  const bool complete = isMade(read->face) && isMade(read->alignment);
  const bool good = complete && read->face.expected_mm <= kWorst_mm && read->alignment.expected_mm <= kWorst_mm;
  run.report.quality = {{"revision", read->revision},
                        {"face_residual_mm", read->face.residual_mm},
                        {"alignment_residual_mm", read->alignment.residual_mm},
                        {"alignment_expected_mm", read->alignment.expected_mm}};
  run.report.verdict = good ? "usable" : "not usable";
  if (!complete)
    run.out() << "  Not usable: a part was not calibrated; open the Tracker page and finish the wizard.\n";
  else if (!good)
    run.out() << "  Not usable: it is expected to be off by more than " << rounded(kWorst_mm, 2)
              << " mm; align again with more landmarks, farther apart.\n";
  else
    run.out() << "  Usable.\n";
  return good ? kDone : kVerdict;
}

}  // namespace

void addTracker(CLI::App& root, Selection& selection) {
  auto& group = *root.add_subcommand("tracker", "Print paper bodies for a camera, list trackers and check calibrations");
  group.require_subcommand(1);
  auto arguments = std::make_shared<TrackerArguments>();
  auto& printed = addCommand(
      group, selection, "print", "Sheets to print, cut and fold, as PDF: bodies with markers that a camera follows, and boards",
      {"tracker print -o marker.pdf", "tracker print box-40 sleeve -o small.pdf --paper letter", "tracker print --measured-scale 98.5"},
      [arguments](Run& run) { return print(*arguments, run); });
  printed.add_option("BODIES", arguments->bodies, "Which (box-60 mannequin-board calibration-board); 'tracker list' names all")
      ->type_name("");
  printed.add_option("-o,--output", arguments->output, "The sheets, one page for each body")->type_name("OUT.pdf");
  printed.add_option("--paper", arguments->paper, "a4 or letter (a4)")->check(CLI::IsMember({"a4", "letter"}))->type_name("SIZE");
  printed.add_option("--language", arguments->language, "Of names and notes: en or de (en)")
      ->check(CLI::IsMember({"en", "de"}))
      ->type_name("LANGUAGE");
  addNumber(printed, "--measured-scale", arguments->measuredScale_mm, {90.0, 110.0},
            "What the printed scale of 100 mm measures, in mm: kept for cameras");
  auto& listed = addCommand(group, selection, "list", "Marker bodies, and the cameras and hand controllers that are connected",
                            {"tracker list", "tracker list --json"}, [arguments](Run& run) { return list(*arguments, run); });
  listed.add_option("--language", arguments->language, "Of names: en or de (en)")
      ->check(CLI::IsMember({"en", "de"}))
      ->type_name("LANGUAGE");
  listed.add_flag("--json", arguments->asJson, "As JSON");
  auto& checked = addCommand(group, selection, "check", "What a calibration says of itself; exit status 3 when it is not usable",
                             {"tracker check r0003.json"}, [arguments](Run& run) { return check(*arguments, run); });
  checked.add_option("CALIBRATION", arguments->calibration, "A file of the folder trackers/calibrations in your library")
      ->required()
      ->type_name("");
}

}  // namespace ew::cli
