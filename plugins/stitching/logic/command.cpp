#include "logic/command.h"

#include <algorithm>

#include "ew/io/safe_file.h"
#include "ew/stitching/chain.h"

namespace ew::stitching {
namespace {

namespace fs = std::filesystem;

Message namesOfSteps() {
  std::vector<Message> names;
  for (std::size_t n = 0; n + 1 < kSteps.size(); ++n) names.push_back(verbatim(nameOf(kSteps[n])));
  return say<"%1 and %2">(joined(std::move(names), ", "), verbatim(nameOf(kSteps.back())));
}

Message messageOf(registration::Verdict verdict) {
  switch (verdict) {
    case registration::Verdict::aligned:
      return say<"aligned">();
    case registration::Verdict::notAligned:
      return say<"not aligned">();
    case registration::Verdict::cannotTell:
      break;
  }
  return say<"cannot tell">();
}

void tellQuality(const ChainState& state, sdk::Commands::Outcome& outcome) {
  auto& quality = outcome.quality;
  std::uint64_t peak = 0;
  std::size_t reused = 0;
  for (const auto& step : state.steps) {
    if (!step.done) continue;
    outcome.steps.emplace_back(nameOf(step.step), step.seconds);
    reused += step.reused ? 1u : 0u;
    peak = std::max(peak, step.forecast_bytes);
  }
  quality.emplace_back("steps_reused", static_cast<double>(reused));
  if (state.pruned_bytes > 0) quality.emplace_back("pruned_mib", static_cast<double>(state.pruned_bytes) / (1024.0 * 1024.0));
  quality.emplace_back("forecast_mib", static_cast<double>(peak) / (1024.0 * 1024.0));
  if (!state.pairs.empty()) {
    const auto aligned = std::count_if(state.pairs.begin(), state.pairs.end(),
                                       [](const PairOutcome& pair) { return pair.rigid.verdict == registration::Verdict::aligned; });
    const auto wrong = std::count_if(state.pairs.begin(), state.pairs.end(), [](const PairOutcome& pair) { return pair.wrong; });
    quality.emplace_back("pairs", static_cast<double>(state.pairs.size()));
    quality.emplace_back("pairs_aligned", static_cast<double>(aligned));
    quality.emplace_back("pairs_wrong", static_cast<double>(wrong));
  }
  if (state.graph) quality.emplace_back("closure_mm", state.graph->closure_mm);
  if (state.warpSummary.pairs > 0) {
    quality.emplace_back("largest_bend_mm", state.warpSummary.largest_mm);
    quality.emplace_back("smallest_jacobian", state.warpSummary.smallestJacobian);
    quality.emplace_back("bends_disagree_95_mm", state.warpSummary.disagreement95_mm);
  }
  if (!state.report) return;
  quality.emplace_back("overlap_share", state.report->overlapShare);
  quality.emplace_back("disagreement_rms_grey", state.report->disagreementRms);
  if (state.report->seam.voxels > 0) {
    quality.emplace_back("seam_derivative_ratio", state.report->seam.derivativeRatio);
    quality.emplace_back("seam_speckle_ratio", state.report->seam.speckleRatio);
    quality.emplace_back("seam_mean_step_db", state.report->seam.meanStep_db);
  }
  std::size_t joined = 0;
  for (std::size_t v = 0; v < state.report->contributions.size() + state.leftOut.size(); ++v) {
    if (std::find(state.leftOut.begin(), state.leftOut.end(), v) != state.leftOut.end()) continue;
    quality.emplace_back("contributed_voxels_" + std::to_string(v + 1), static_cast<double>(state.report->contributions[joined++].voxels));
  }
}

Message verdictOf(const PairOutcome& pair) {
  switch (pair.used) {
    case PairMethod::byHand:
      return say<"by hand, not checked">();
    case PairMethod::landmarks:
      return say<"by landmarks, %1">(messageOf(pair.rigid.verdict));
    case PairMethod::automatic:
    case PairMethod::search:
    case PairMethod::refine:
      break;
  }
  return messageOf(pair.rigid.verdict);
}

/// What a person should know of a run, a sentence each: how each pair ended, what holds the whole, what joining had to decide.
std::vector<Message> notesOf(const StitchProject& project, const ChainState& state) {
  std::vector<Message> notes;
  for (const PairOutcome& pair : state.pairs) {
    const Message verdict = verdictOf(pair);
    const std::string &fixed = project.volumes[pair.fixed].name, &moving = project.volumes[pair.moving].name;
    notes.push_back(pair.wrong ? say<"'%1' with '%2': %3, and the other pairs contradict it. %4">(fixed, moving, verdict, pair.rigid.reason)
                               : say<"'%1' with '%2': %3. %4">(fixed, moving, verdict, pair.rigid.reason));
  }
  // Another verdict is told with its reason by whoever ends the program.
  if (state.graph && !state.pairs.empty() && state.verdict == registration::Verdict::aligned && !state.reason.empty())
    notes.push_back(state.reason);
  if (state.report) notes.insert(notes.end(), state.report->notes.begin(), state.report->notes.end());
  notes.insert(notes.end(), state.notes.begin(), state.notes.end());
  return notes;
}

}  // namespace

const char* const kStitchHelp =
    "  -o, --output DIR  Folder for volume.mha, coverage.mha, source.mha, level.mha (for live echoes) and provenance.json; made when it "
    "is\n"
    "                    not there.\n"
    "                    DIR/steps keeps what each step found, so that a second run only does what changed\n"
    "  --until STEP      Stop after reconstruct, rigid, graph, equalise, elastic, seam or volume (volume)\n"
    "  --threads N       Threads; 0: all cores; the voxels do not depend on it (0)\n"
    "  --prune           Afterwards, keep of DIR/steps only what this project uses. Without it, what earlier projects and edits left\n"
    "                    may take 2 GiB, the last used the longest\n"
    "\n"
    "PROJECT.json; only the volumes and their files are required, files are relative to it:\n"
    "  { \"format\": 2,\n"
    "    \"volumes\": [\n"
    "      { \"name\": \"right\", \"file\": \"right.mha\", \"coverage\": \"right-coverage.mha\", \"placement\": \"tracker\",\n"
    "        \"to_world\": \"right-to-world.txt\" },\n"
    "      { \"name\": \"left\", \"file\": \"left.igs.mha\", \"spacing_mm\": 0.8, \"placement\": \"unknown\" } ],\n"
    "    \"pairs\": [ { \"fixed\": \"right\", \"moving\": \"left\", \"method\": \"search\", \"max_turn_deg\": 45 } ],\n"
    "    \"settings\": { \"tracker_error_mm\": 3, \"tracker_error_deg\": 2, \"elastic\": true, \"effort\": \"balanced\" },\n"
    "    \"result\": { \"spacing_mm\": 0, \"axes\": \"first\" },\n"
    "    \"seam\": { \"method\": \"graph cut\", \"blend_mm\": 3 } }\n"
    "A file is a volume or a sweep, which is reconstructed. to_world is a list of 16 numbers, row by row, or a text file that holds\n"
    "them; placement is \"tracker\" (recorded), \"hand\" (a start) or \"unknown\" (found without one). Of pairs only those need an entry\n"
    "about which there is something to say. Every field: resources/docs/author/stitching.md.";

Result<sdk::Commands::Outcome> runStitchCommand(const std::vector<std::string>& args, Progress& progress) {
  const auto usage = [](const Message& what) {
    return failure(ErrorCode::badUsage, say<"%1 Usage: echoweave %2.">(what, verbatim(kStitchUsage)));
  };
  std::string projectFile;
  std::string folder;
  ChainOptions options;
  for (std::size_t i = 0; i < args.size(); ++i) {
    const bool takesValue = args[i] == "-o" || args[i] == "--output" || args[i] == "--threads" || args[i] == "--until";
    if (takesValue && i + 1 == args.size()) return usage(say<"A value is missing after %1.">(args[i]));
    if (args[i] == "-o" || args[i] == "--output") {
      folder = args[++i];
    } else if (args[i] == "--threads") {
      const auto& word = args[++i];
      if (word.empty() || word.size() > 4 || word.find_first_not_of("0123456789") != std::string::npos)
        return usage(say<"--threads is '%1' and must be a whole number from 0 to 9999.">(word));
      options.threads = std::stoi(word);
    } else if (args[i] == "--until") {
      const auto& word = args[++i];
      const auto step = std::find_if(kSteps.begin(), kSteps.end(), [&](Step each) { return word == nameOf(each); });
      if (step == kSteps.end()) return usage(say<"'%1' is not a step; the steps are %2.">(word, namesOfSteps()));
      options.until = *step;
    } else if (args[i] == "--prune") {
      options.keepBytes = 0;
    } else if (args[i].size() > 1 && args[i].front() == '-') {
      return usage(say<"'%1' is not an option of stitch.">(args[i]));
    } else if (projectFile.empty()) {
      projectFile = args[i];
    } else {
      return usage(say<"There are two projects, '%1' and '%2', and only one can be stitched.">(projectFile, args[i]));
    }
  }
  if (options.keepBytes == 0 && options.until != Step::volume)
    return usage(say<"--prune keeps what a finished volume was made of and does not go with --until.">());
  if (projectFile.empty()) return usage(say<"The project file is missing.">());
  if (folder.empty()) return usage(say<"The output folder is missing.">());

  auto text = readTextFile(projectFile);
  if (!text) return passOn(text.error());
  auto project = parseProject(*text, fs::path(projectFile).parent_path());
  if (!project) return passOn(project.error());
  options.keepVolumes = false;
  options.putInPlaceLater = true;
  auto state = runChain(*project, folder, options, progress);
  if (!state) return passOn(state.error());
  sdk::Commands::Outcome outcome;
  outcome.putInPlace = std::move(state->putInPlace);
  for (const auto& file : {state->volume, state->coverage, state->source, state->level, state->provenance})
    if (!file.empty()) outcome.outputs.push_back(file.string());
  tellQuality(*state, outcome);
  outcome.notes = notesOf(*project, *state);
  // Recorded places that are taken as they are were judged by nobody.
  if (state->graph && !state->pairs.empty()) {
    outcome.verdict = registration::nameOf(state->verdict);
    outcome.reason = state->reason.english();
  }
  return outcome;
}

}  // namespace ew::stitching
