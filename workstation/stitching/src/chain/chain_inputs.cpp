#include "chain/chain_inputs.h"

#include <algorithm>
#include <array>

#include "ew/core/message_json.h"
#include "ew/core/quiet_progress.h"
#include "ew/io/safe_file.h"

#include "chain/chain_json.h"
#include "chain/chain_keys.h"
#include "chain/chain_run.h"

namespace ew::stitching {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using nlohmann::ordered_json;

/// Of a sweep's volume, in the store.
constexpr std::array<const char*, 3> kSweepFiles = {"volume.mha", "coverage.mha", "confidence.mha"};

/// As checkMeant, with what a person can do about it here. The message's first argument is the question: a window answers it otherwise.
Result<void> checkMeantOf(const SweepInput& opened, const std::string& name) {
  auto meant = checkMeant(opened);
  if (meant) return {};
  Error question = meant.error();
  question.message =
      say<"%1 A stitch project says so with \"accept_small\": true in the entry of '%2'; or reconstruct the sweep by itself and take its "
          "volume instead.">(question.message, name);
  return passOn(std::move(question));
}

}  // namespace

ChainInputs::ChainInputs(const StitchProject& project, const ChainOptions& options, const StepStore& store)
    : project_(project), options_(options), store_(store), contents_(store.folder()) {
  inputs_.resize(project.volumes.size());
}

/// The content of one file, by its bytes; of what is no file, by its voxels.
Result<std::string> ChainInputs::contentOf(const fs::path& file, Progress& progress) {
  auto content = contents_.keyOf(file, progress);
  if (!content) return passOn(content.error());
  if (*content) return **content;
  auto read = readVolume(file, progress);
  if (!read) return passOn(read.error());
  return ContentKey().add(jsonOf(read->volume.grid).dump()).add(std::span<const std::uint8_t>(read->volume.echo)).text();
}

/// Of the files of an input and of how they are read.
Result<std::string> ChainInputs::keyOf(std::size_t v, Progress& progress) {
  const ProjectVolume& asked = project_.volumes[v];
  const VolumeHeader& header = inputs_[v].header;
  ContentKey key = newKey("input", kInputFormat);
  key.add(header.sequence).add(asked.spacing_mm);
  if (header.sequence && asked.acceptsSmall) key.add("accept_small");  // taken back it is asked about again
  std::vector<fs::path> files = header.files;
  for (const fs::path& beside : {asked.coverage, asked.confidence, asked.calibration}) {
    key.add(!beside.empty());
    if (!beside.empty()) files.push_back(beside);
  }
  for (const fs::path& file : files) {
    if (file == asked.calibration) {
      auto text = readTextFile(file);
      if (!text) return passOn(text.error());
      key.add(*text);
      continue;
    }
    auto content = contentOf(file, progress);
    if (!content) return passOn(content.error());
    key.add(*content);
  }
  return key.text();
}

Result<void> ChainInputs::identify(Progress& progress, bool planSweeps) {
  for (std::size_t v = 0; v < inputs_.size(); ++v) {
    const ProjectVolume& asked = project_.volumes[v];
    ChainInput& input = inputs_[v];
    if (progress.cancelRequested()) return cancelledChain();
    progress.report(say<"Inspecting %1">(asked.name), 0.0);
    auto header = readVolumeHeader(asked.file);
    if (!header) return passOn(header.error());
    input.header = std::move(*header);
    input.grid = input.header.grid;
    auto key = keyOf(v, progress);
    if (!key) return passOn(key.error());
    input.key = std::move(*key);
    if (!input.header.sequence) continue;
    if (auto grid = readBack<Grid>(store_.find(kStep, input.key), [](const json& data) { return gridFrom(data.at("grid")); })) {
      input.grid = *grid;
    } else if (planSweeps) {
      if (auto planned = plan(v, progress); !planned) return planned;
    }
  }
  return {};
}

bool ChainInputs::isToBeMade(std::size_t v) const { return inputs_[v].header.sequence && !store_.find(kStep, inputs_[v].key); }

SweepVolumeOptions ChainInputs::sweepOptions(std::size_t v) const {
  const ProjectVolume& asked = project_.volumes[v];
  return {.spacing_mm = asked.spacing_mm,
          .calibration = asked.calibration,
          .threads = options_.threads,
          .maxBytes = options_.maxBytes,
          .acceptsSmall = asked.acceptsSmall};
}

Result<void> ChainInputs::plan(std::size_t v, Progress& progress) {
  QuietProgress silent(progress);
  const auto opened = openSweepVolume(project_.volumes[v].file, sweepOptions(v), silent);
  if (!opened) return passOn(opened.error());
  inputs_[v].grid = opened->plan.grid;
  inputs_[v].sweepBytes = sweepVolumeBytes(opened->plan);
  return {};
}

Result<void> ChainInputs::make(std::size_t v, Progress& progress) {
  PartOfProgress reading(progress, 0.0, 0.25), making(progress, 0.25, 0.8), writing(progress, 0.8, 1.0);
  const auto opened = openSweepVolume(project_.volumes[v].file, sweepOptions(v), reading);
  if (!opened) return passOn(opened.error());
  if (auto meant = checkMeantOf(*opened, project_.volumes[v].name); !meant) return meant;
  auto made = makeSweepVolume(*opened, making);
  if (!made) return passOn(made.error());
  const std::string& key = inputs_[v].key;
  if (auto room = store_.prepare(kStep); !room) return room;
  if (auto w = writeVolume(made->volume, store_.fileOf(kStep, key, "volume.mha"), writing); !w) return w;
  if (auto w = writeCoverage(made->volume, store_.fileOf(kStep, key, "coverage.mha"), writing); !w) return w;
  if (auto w = writeConfidence(made->volume.grid, made->confidence, store_.fileOf(kStep, key, "confidence.mha"), writing); !w) return w;
  ordered_json data = {{"grid", jsonOf(made->volume.grid)}, {"beams", jsonOf(made->beams)}, {"notes", made->notes}};
  if (auto kept = store_.keep(kStep, key, std::move(data), {kSweepFiles.begin(), kSweepFiles.end()}); !kept) return kept;
  inputs_[v].grid = made->volume.grid;
  return {};
}

Result<std::shared_ptr<ViewData>> ChainInputs::readSweep(std::size_t v, Progress& progress) {
  const std::string& key = inputs_[v].key;
  const auto about = readBack<std::pair<Grid, std::optional<Beams>>>(
      store_.find(kStep, key), [](const json& data) { return std::pair(gridFrom(data.at("grid")), beamsFrom(data.at("beams"))); });
  if (!about) return failure(ErrorCode::notFound, say<"The reconstruction of '%1' is not there.">(project_.volumes[v].name));
  for (const char* name : kSweepFiles)
    if (!store_.isSound(kStep, key, name))
      return failure(ErrorCode::badHeader, say<"The reconstruction of '%1' was damaged.">(project_.volumes[v].name));
  auto loaded = readVolume(store_.fileOf(kStep, key, "volume.mha"), progress);
  if (!loaded) return passOn(loaded.error());
  Volume& volume = loaded->volume;
  if (auto r = readCoverageInto(volume, store_.fileOf(kStep, key, "coverage.mha"), progress); !r) return passOn(r.error());
  auto confidence = readConfidence(volume.grid, store_.fileOf(kStep, key, "confidence.mha"), progress);
  if (!confidence) return passOn(confidence.error());
  volume.grid = about->first;  // to the last bit, whatever the file's text of it says
  auto view = std::make_shared<ViewData>();
  view->volume = std::make_shared<const Volume>(std::move(volume));
  view->confidence = std::move(*confidence);
  view->beams = about->second;
  return view;
}

Result<std::shared_ptr<ViewData>> ChainInputs::readView(std::size_t v, Progress& progress) {
  const ProjectVolume& asked = project_.volumes[v];
  auto loaded = readVolume(asked.file, progress);
  if (!loaded) return passOn(loaded.error());
  Volume& volume = loaded->volume;
  if (!asked.coverage.empty())
    if (auto r = readCoverageInto(volume, asked.coverage, progress); !r) return passOn(r.error());
  auto view = std::make_shared<ViewData>();
  if (!asked.confidence.empty()) {
    auto confidence = readConfidence(volume.grid, asked.confidence, progress);
    if (!confidence) return passOn(confidence.error());
    view->confidence = std::move(*confidence);
  }
  view->volume = std::make_shared<const Volume>(std::move(volume));
  for (const Message& note : loaded->notes) notes_.push_back(joined({verbatim(asked.name), note}, ": "));
  return view;
}

Result<std::shared_ptr<const ViewData>> ChainInputs::load(std::size_t v, Progress& progress) {
  ChainInput& input = inputs_[v];
  if (input.view) return input.view;
  if (progress.cancelRequested()) return cancelledChain();
  progress.report(say<"Reading %1">(project_.volumes[v].name), 0.0);
  QuietProgress silent(progress);
  auto view = input.header.sequence ? readSweep(v, silent) : readView(v, silent);
  if (!view && input.header.sequence && view.error().code != ErrorCode::cancelled) {
    store_.remove(kStep, input.key);  // damaged: made again, once
    if (auto made = make(v, silent); !made) return passOn(made.error());
    view = readSweep(v, silent);
  }
  if (!view) return passOn(view.error());
  (*view)->name = project_.volumes[v].name;
  input.view = std::move(*view);
  input.grid = input.view->volume->grid;
  return input.view;
}

std::uint64_t ChainInputs::heldBytes() const {
  std::uint64_t bytes = 0;
  std::uint64_t largest = 0;
  for (const ChainInput& input : inputs_) {
    bytes += 3 * input.grid.voxelCount();
    largest = std::max<std::uint64_t>(largest, input.grid.voxelCount());
  }
  return bytes + 4 * largest;
}

}  // namespace ew::stitching
