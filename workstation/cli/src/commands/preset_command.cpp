#include <algorithm>
#include <ostream>

#include "ew/library/case.h"
#include "ew/scanning/preset.h"
#include "run/arguments.h"
#include "run/command.h"

namespace ew::cli {
namespace {

using nlohmann::json;

struct PresetArguments {
  std::string probe;
  std::string language = "en";
  std::vector<std::string> files;
  bool asJson = false;
};

json rowOf(const Preset& preset, bool isOwn) {
  return {{"id", preset.id},
          {"title", {{"en", preset.title.english}, {"de", preset.title.german}}},
          {"probe", preset.probe},
          {"own", isOwn},
          {"knobs", toJson(preset)["knobs"]}};
}

Result<int> listAll(const PresetArguments& arguments, Run& run) {
  const auto resources = resourceFolder();
  if (!resources) return passOn(resources.error());
  const auto shipped = readPresets(*resources / "presets");
  if (!shipped) return passOn(shipped.error());
  const OwnPresets own = readOwnPresets(ownPresetsFolder());
  for (const Error& problem : own.problems) run.remark(problem.message);
  std::vector<std::pair<const Preset*, bool>> shown;  // and whether it is the user's
  for (const Preset& preset : *shipped) shown.emplace_back(&preset, false);
  for (const Preset& preset : own.presets) shown.emplace_back(&preset, true);
  std::erase_if(shown, [&](const auto& each) { return !arguments.probe.empty() && each.first->probe != arguments.probe; });
  json rows = json::array();
  for (const auto& [preset, isOwn] : shown) rows.push_back(rowOf(*preset, isOwn));
  run.report.quality = {{"presets", shown.size()}, {"own", own.presets.size()}, {"problems", own.problems.size()}};
  run.report.details["presets"] = rows;
  if (arguments.asJson) {
    run.out() << json{{"folder", ownPresetsFolder().string()}, {"presets", rows}}.dump(2, ' ', false, json::error_handler_t::replace)
              << "\n";
    return kDone;
  }
  std::size_t idWidth = 2, probeWidth = 5;
  for (const auto& [preset, isOwn] : shown) {
    idWidth = std::max(idWidth, preset->id.size());
    probeWidth = std::max(probeWidth, preset->probe.size());
  }
  for (const auto& [preset, isOwn] : shown) {
    std::string id = preset->id, probe = preset->probe;
    id.resize(idWidth + 2, ' ');
    probe.resize(probeWidth + 2, ' ');
    run.out() << id << probe << preset->title.in(arguments.language) << (isOwn ? " (your own)" : "") << "\n";
  }
  if (shown.empty()) run.out() << "No presets.\n";
  return kDone;
}

/// Every file is looked at, so that one run says all that is wrong.
Result<int> check(const PresetArguments& arguments, Run& run) {
  const auto probes = shippedProbes();
  if (!probes) return passOn(probes.error());
  std::size_t wrong = 0;
  for (const std::string& file : arguments.files) {
    if (auto kept = run.input(file); !kept) return passOn(kept.error());
    auto preset = readPreset(file);
    Result<void> fits;
    if (!preset)
      fits = passOn(preset.error());
    else
      fits = checkPreset(*preset, *probes);
    run.out() << file << ": "
              << (fits ? std::string("a preset of ") + preset->probe + ", " + preset->title.in(arguments.language) + "."
                       : fits.error().sentence())
              << "\n";
    if (!fits) run.report.details["problems"].push_back({{"file", file}, {"sentence", fits.error().sentence()}});
    wrong += fits ? 0 : 1;
  }
  run.report.quality = {{"presets", arguments.files.size()}, {"problems", wrong}};
  if (wrong == 0) return kDone;
  run.out() << std::flush;
  return run.answer(
      {ErrorCode::badField, say<"Of %1 presets %2 cannot be used; correct what is listed.">(arguments.files.size(), wrong), {}});
}

}  // namespace

void addPreset(CLI::App& root, Selection& selection) {
  auto& group = *root.add_subcommand("preset", "List and check presets: how the console is set for an examination");
  group.require_subcommand(1);
  auto arguments = std::make_shared<PresetArguments>();
  auto& list = addCommand(group, selection, "list", "The presets of the program and your own, with their probes",
                          {"preset list", "preset list --probe linear-12", "preset list --json"},
                          [arguments](Run& run) { return listAll(*arguments, run); });
  list.add_option("--probe", arguments->probe, "Only those of this probe")->type_name("NAME");
  list.add_option("--language", arguments->language, "Of titles: en or de (en)")->check(CLI::IsMember({"en", "de"}))->type_name("LANGUAGE");
  list.add_flag("--json", arguments->asJson, "As JSON");
  auto& checked = addCommand(group, selection, "check", "Whether files are presets that fit their probes; exit status 1 when one is not",
                             {"preset check mine.json"}, [arguments](Run& run) { return check(*arguments, run); });
  checked.add_option("FILES", arguments->files, "Preset files")->required()->type_name("");
  checked.add_option("--language", arguments->language, "Of titles: en or de (en)")
      ->check(CLI::IsMember({"en", "de"}))
      ->type_name("LANGUAGE");
}

}  // namespace ew::cli
