#include <algorithm>
#include <chrono>
#include <cmath>

#include "ew/core/ending.h"
#include "ew/core/numbers.h"
#include "ew/export/examination_files.h"
#include "ew/scanning/display_image_file.h"
#include "ew/scanning/replay.h"
#include "run/arguments.h"
#include "run/command.h"
#include "run/volume_input.h"

namespace ew::cli {
namespace {

struct ReplayArguments {
  std::string source;
  std::string recording;
  std::string output;
  glm::ivec2 size_px{0};
  double rate_hz = 30.0;
  int every = 1;
  int threads = 1;
};

constexpr std::size_t kMostImages = 100000;

/// What was scanned. The recording decides probe, settings and effects; of the case it takes voxels, labels and their place.
Result<ScanSubject> readSubject(const ReplayArguments& arguments, const std::optional<Case>& opened, Run& run) {
  if (opened) {
    auto contents = readCaseContents(run, *opened);
    if (!contents) return passOn(contents.error());
    return subjectOf(*opened, *contents);
  }
  auto voxels = openInputVoxels(run, arguments.source, false);
  if (voxels && voxels->volume()) voxels = ScanVoxels::of(voxels->volume(), run.progress);
  if (!voxels) return passOn(voxels.error());
  return subjectOf(std::move(*voxels), arguments.source);
}

/// The first scene of a recording that has live echoes, or one without them.
Scene liveSceneOf(const ScanLog& log) {
  for (const ScanEvent& event : log.events())
    if (const auto* changed = std::get_if<SceneChanged>(&event.what); changed && changed->scene.liveEchoes) return changed->scene;
  return {};
}

/// Which frame each image of the output shows: every n-th of the recording, or what is seen at even times.
std::vector<std::size_t> framesOf(const ReplayArguments& arguments, const ScanLog& log) {
  std::vector<std::size_t> frames;
  if (isClipFile(arguments.output)) {
    const double length_s = log.frameTime_s(log.frameCount() - 1) - log.frameTime_s(0);
    const auto count = static_cast<std::size_t>(std::min(length_s * arguments.rate_hz, 1e9)) + 1;
    for (std::size_t n = 0; n < std::min(count, kMostImages + 1); ++n)
      frames.push_back(log.frameAt(log.frameTime_s(0) + static_cast<double>(n) / arguments.rate_hz));
  } else {
    for (std::size_t n = 0; n < log.frameCount(); n += static_cast<std::size_t>(arguments.every)) frames.push_back(n);
  }
  return frames;
}

bool isDicomFile(const std::filesystem::path& file) { return hasEnding(file, ".dcm"); }

/// Where the images go when they are looked at one by one: numbered files, or one film.
class Images {
 public:
  Images(const ReplayArguments& arguments, std::size_t count, Run& run) : arguments_(arguments), count_(count), run_(run) {}

  Result<void> announce() {
    if (isOneFile()) return run_.output(arguments_.output);
    const std::filesystem::path folder = arguments_.output;
    if (auto made = run_.outputs.announceFolder(folder); !made) return made;
    for (std::size_t n = 0; n < count_; ++n)
      if (auto announced = run_.output(fileOf(n)); !announced) return announced;
    return {};
  }
  Result<void> begin(const glm::ivec2& size_px) {
    if (isDicomFile(arguments_.output)) return {};
    if (!isOneFile()) return checkRoomForWarning(size_px.x, size_px.y, fileOf(0));
    auto clip = ImageClip::open(run_.outputs.staged(arguments_.output), size_px.x, size_px.y, arguments_.rate_hz);
    if (!clip) return passOn(clip.error());
    clip_ = std::move(*clip);
    return {};
  }
  Result<void> add(std::size_t n, const DisplayImage& image, double pixel_mm) {
    const StepClock clock(run_.report, "write");
    return clip_ ? clip_->add(image) : writeDisplayImage(image, pixel_mm, run_.outputs.staged(fileOf(n)));
  }
  Result<void> finish() { return clip_ ? clip_->finish() : Result<void>(); }
  [[nodiscard]] bool isOneFile() const { return isClipFile(arguments_.output) || isDicomFile(arguments_.output); }

 private:
  [[nodiscard]] std::filesystem::path fileOf(std::size_t n) const {
    return numbered(std::filesystem::path(arguments_.output) / "image.png", n, std::max<std::size_t>(count_, 2));
  }

  const ReplayArguments& arguments_;
  std::size_t count_;
  Run& run_;
  std::optional<ImageClip> clip_;
};

DicomStudy studyOf(const std::optional<Case>& opened, const std::string& source) {
  const auto now = std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
  return opened ? beginStudy(*opened, now) : beginStudy(std::filesystem::path(source).stem().string(), now);
}

Result<int> replay(const ReplayArguments& arguments, Run& run) {
  std::optional<Case> opened;
  if (meansCase(arguments.source)) {
    auto found = findCase(arguments.source);
    if (!found) return passOn(found.error());
    opened = std::move(*found);
    if (auto kept = run.protect(opened->folder / "case.json"); !kept) return passOn(kept.error());
  } else if (auto kept = run.protect(arguments.source); !kept) {
    return passOn(kept.error());
  }
  if (auto kept = run.input(arguments.recording); !kept) return passOn(kept.error());
  const auto recording = readRecording(arguments.recording, run.progress);
  if (!recording) return passOn(recording.error());
  for (const Message& note : recording->notes) run.remark(note);
  if (opened && !recording->caseId.empty() && recording->caseId != opened->id)
    run.remark(say<"The recording is of the case '%1', not of '%2'; what it shows is not what was seen.">(recording->caseId, opened->id));

  const ScanLog& log = recording->log;
  const std::vector<std::size_t> frames = framesOf(arguments, log);
  if (frames.size() > kMostImages)
    return failure(ErrorCode::badUsage,
                   say<"The recording would give more than %1 images; give a smaller --rate, or a larger --every.">(kMostImages));
  Images images(arguments, frames.size(), run);
  if (auto announced = images.announce(); !announced) return passOn(announced.error());
  const glm::ivec2 size_px = arguments.size_px.x > 0 ? arguments.size_px : recording->size_px;
  if (auto begun = images.begin(size_px); !begun) return passOn(begun.error());
  auto subject = readSubject(arguments, opened, run);
  if (!subject) return passOn(subject.error());
  if (const Scene live = liveSceneOf(log); live.liveEchoes)
    if (auto formed = formEchoes(run, *subject, live); !formed) return passOn(formed.error());

  Replay scan(log, std::move(*subject), arguments.threads);
  const auto make = [&](std::size_t n) -> Result<DisplayImage> {
    // What is not shown is made all the same: it shows in what follows.
    for (std::size_t frame = n == 0 ? 0 : frames[n - 1] + 1; frame < frames[n]; ++frame) {
      if (run.progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"Stopped as asked; nothing was written.">());
      scan.make(frame, size_px.x, size_px.y);
    }
    if (run.progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"Stopped as asked; nothing was written.">());
    const StepClock clock(run.report, "frame");
    return scan.make(frames[n], size_px.x, size_px.y);
  };
  if (isDicomFile(arguments.output)) {
    const auto makeWithPlace = [&](std::size_t n) -> Result<std::pair<DisplayImage, DisplayGeometry>> {
      auto image = make(n);
      if (!image) return passOn(image.error());
      return std::pair(*image, scan.scanner().geometry());
    };
    if (auto written = writeDicomScan(log, frames, makeWithPlace, studyOf(opened, arguments.source), run.outputs.staged(arguments.output),
                                      run.progress);
        !written)
      return passOn(written.error());
  } else {
    for (std::size_t n = 0; n < frames.size(); ++n) {
      auto image = make(n);
      if (!image) return passOn(image.error());
      if (auto added = images.add(n, *image, scan.scanner().geometry().pixel_mm); !added) return passOn(added.error());
      run.progress.report(say<"Making images">(),
                          kShareOfReading + (1.0 - kShareOfReading) * static_cast<double>(n + 1) / static_cast<double>(frames.size()));
    }
    if (auto finished = images.finish(); !finished) return passOn(finished.error());
  }
  run.report.options = {
      {"size", {size_px.x, size_px.y}}, {"rate_hz", arguments.rate_hz}, {"every", arguments.every}, {"threads", arguments.threads}};
  run.report.quality = {{"images", frames.size()}, {"recorded_images", log.frameCount()}, {"length_s", log.end_s() - log.begin_s()}};
  run.progress.clear();
  run.say(images.isOneFile() ? "Wrote a film of " + counted(frames.size(), "image") + "."
                             : "Wrote " + counted(frames.size(), "image") + ".");
  return kDone;
}

}  // namespace

void addReplay(CLI::App& root, Selection& selection) {
  auto arguments = std::make_shared<ReplayArguments>();
  auto& app = addCommand(root, selection, "replay", "Make the images of a recorded scan again",
                         {"replay upper-abdomen-gall-stone --scan mine.seq.mha -o mine.avi",
                          "replay upper-abdomen-gall-stone --scan mine.seq.mha -o images --every 30",
                          "replay liver.mha --scan mine.seq.mha -o mine.mp4 --rate 25 --size 800x600",
                          "replay upper-abdomen-gall-stone --scan mine.seq.mha -o mine.dcm --every 2"},
                         [arguments](Run& run) { return replay(*arguments, run); });
  app.add_option("SOURCE", arguments->source, "What was scanned: a case folder, a case.json, a shipped case's id, or a volume")
      ->required()
      ->type_name("");
  app.add_option("--scan", arguments->recording, "The recording (.seq.mha), as the window saves it")->required()->type_name("RECORDING");
  app.add_option(
         "-o,--output", arguments->output,
         "A folder for image_0000.png …, a film (.avi, .mp4), or a DICOM clip with scale (.dcm); every image carries 'simulation, not "
         "for diagnosis'")
      ->required()
      ->type_name("DIR|CLIP|OUT.dcm");
  addSize(app, "--size", arguments->size_px, "Pixels of the images (as recorded)");
  addCount(app, "--every", arguments->every, 1, 1000000, "Of the recorded images every N-th, into a folder or a DICOM clip (1)");
  addNumber(app, "--rate", arguments->rate_hz, {0.1, 240.0}, "Images a second of a film (30)");
  addCount(app, "--threads", arguments->threads, 0, 256, "Threads of one image; 0: all cores; images do not depend on it (1)");
}

}  // namespace ew::cli
