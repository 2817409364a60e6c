#pragma once

#include <QTest>
#include <cmath>
#include <numbers>

#include "ew/library/learning_progress.h"
#include "ew/library/step_answer.h"
#include "ew/scanning/contact.h"
#include "ew/scanning/recording.h"
#include "gui/support/case_aside.h"
#include "gui/support/taught_case.h"

namespace ew::ui::testing {

/// A small case with a lesson that an expert has shown and that trainees have tried: what a review needs, made in seconds. A dark cyst with
/// a bright rim lies in speckled tissue below the skin of the front; the plane through its middle is to be found.
class ReviewedCase {
 public:
  /// How somebody scanned.
  struct Way {
    std::string person;
    double seconds = 12.0;
    double detour_mm = 0.0;   ///< to the side, half way
    double miss_mm = 0.0;     ///< how far from the plane it ends
    double depth_mm = 120.0;  ///< from 2 s on
    double gain = 1.0;
    double tremor_mm = 0.0;
    bool losesContact = false;  ///< for a while
    bool losesPose = false;     ///< for a while
    double score = 1.0;
  };
  static constexpr int kStructure = 3;
  static constexpr double kRate_hz = 10.0;

  ReviewedCase(const Files& files, const QString& name) : folder_(files.writeCase(QStringLiteral("own cases/") + name)) {}
  [[nodiscard]] const QString& folder() const { return folder_; }

  /// Fills the folder that the constructor made. @param skin of the mannequin, as a session has it
  bool make(const Skin& skin, const Probe& probe) {
    skin_ = &skin;
    probe_ = probe;
    const auto front = skin.hit({20.0, -2000.0, -20.0}, {0.0, 1.0, 0.0});
    if (!front) return false;
    start_.contact = *front;
    start_.press_mm = usualPress_mm(probe);
    target_ = slid(start_, skin, 0.0, 60.0);
    middle_mm_ = carried(poseOf(target_).probeToWorld, glm::dvec3(0.0, 55.0, 0.0));
    return writeTissue() && writeManifest();
  }

  [[nodiscard]] ScanRecording recordingOf(const Way& way) const {
    ScanRecording made;
    made.caseId = "reviewed-case";
    made.title = "An upper abdomen";
    made.size_px = {480, 400};
    const int frames = static_cast<int>(way.seconds * kRate_hz);
    for (int n = 0; n <= frames; ++n) {
      const double time_s = n / kRate_hz, share = n / static_cast<double>(frames);
      // Out in the first two thirds, gently; then the probe rests.
      const double gone = std::min(1.0, share / 0.66);
      const double eased = gone * gone * (3.0 - 2.0 * gone);
      const double tremor = way.tremor_mm * std::sin(2.0 * std::numbers::pi * 2.3 * time_s);
      Hold hold = slid(start_, *skin_, way.detour_mm * std::sin(std::numbers::pi * gone) + tremor, (60.0 + way.miss_mm) * eased);
      if (way.losesContact && share > 0.35 && share < 0.45) hold.tilt_rad = 1.0;
      ScanState state;
      state.probe = probe_;
      state.pose = poseOf(hold);
      if (way.losesContact && share > 0.35 && share < 0.45) state.pose.probeToWorld.matrix[3] += glm::dvec4(0.0, -25.0, 0.0, 0.0);
      state.pose.time_s = state.time_s = time_s;
      if (way.losesPose && share > 0.55 && share < 0.62) state.pose.status = PoseStatus::invalid;
      state.gaps_mm = gapsToSkin_mm(probe_, state.pose, *skin_);
      state.knobs.depth_mm = time_s < 2.0 ? 160.0 : way.depth_mm;
      state.knobs.gain = way.gain;
      state.scene.gainAndDgc = true;
      state.number = static_cast<std::uint64_t>(n);
      made.log.addFrame(state);
      if (n == frames / 2) made.log.addNote(time_s, "mark", {{"text", "Looks for the cyst"}});
    }
    made.log.setFrozen(way.seconds, true);
    return made;
  }

  bool writeExpert(const Way& way) const {
    const std::filesystem::path file = folder_.toStdString() + "/parts/lessons/scans/expert.seq.mha";
    std::filesystem::create_directories(file.parent_path());
    return writeRecording(recordingOf(way), file).has_value();
  }
  /// An attempt that ended every step. @return its folder
  std::filesystem::path writeAttempt(const Way& way, int number) const {
    Attempt attempt;
    attempt.startedAt = std::chrono::sys_seconds(std::chrono::seconds(1'795'000'000 + 3600 * number));
    attempt.id = idOfAttempt(attempt.startedAt);
    attempt.caseId = "reviewed-case";
    attempt.lessonId = "cyst";
    attempt.lessonTitle = "Find the cyst";
    attempt.person = way.person;
    auto kept = AttemptFolder::begin(attemptsFolder(libraryFolder()), attempt);
    if (!kept) return {};
    for (const char* id : {"read", "watch", "find", "cover", "answer"}) {
      const std::string step = id;
      StepOutcome outcome;
      outcome.stepId = step;
      outcome.seconds = way.seconds;
      outcome.at = attempt.startedAt + std::chrono::seconds(60);
      outcome.score = step == "find" || step == "cover" ? way.score : 1.0;
      outcome.verdict = outcome.score >= 0.7 ? StepVerdict::passed : StepVerdict::failed;
      if (step == "answer") outcome.answer = OptionsAnswer{{way.score >= 0.5 ? 0U : 1U}};
      if (step == "watch") outcome.answer = WatchAnswer{true};
      if (!kept->beginStep(step)) return {};
      if (step == "find" || step == "cover") {
        outcome.recording = kept->nameForFile(step, ".seq.mha");
        if (!writeRecording(recordingOf(way), kept->folder() / outcome.recording)) return {};
        outcome.figures = {{"angle", 20.0 * (1.0 - way.score), "deg"}};
      }
      if (!kept->endStep(outcome)) return {};
    }
    if (!kept->finish(attempt.startedAt + std::chrono::minutes(5))) return {};
    return kept->folder();
  }

 private:
  [[nodiscard]] bool writeTissue() const {
    Volume volume, labels;
    volume.grid.dims = {104, 80, 104};
    volume.grid.spacing_mm = glm::dvec3(2.0);
    volume.grid.origin_mm = start_.contact.point_mm + glm::dvec3(-104.0, -8.0, -75.0);
    labels.grid = volume.grid;
    volume.echo.resize(volume.grid.voxelCount());
    labels.echo.assign(volume.grid.voxelCount(), 0);
    std::uint32_t random = 12345;
    for (int k = 0; k < volume.grid.dims.z; ++k)
      for (int j = 0; j < volume.grid.dims.y; ++j)
        for (int i = 0; i < volume.grid.dims.x; ++i) {
          random = random * 1664525U + 1013904223U;
          const double speckle = 0.55 + 0.9 * static_cast<double>(random >> 16U) / 65536.0;
          const glm::dvec3 at = volume.grid.origin_mm + 2.0 * glm::dvec3(i, j, k);
          const double off = glm::length((at - middle_mm_) * glm::dvec3(1.0, 1.2, 0.8));
          const double layer = 70.0 + 25.0 * std::sin(0.05 * at.x + 0.11 * at.y + 0.04 * at.z);
          const double mean = off < 22.0 ? 8.0 : off < 26.0 ? 170.0 : off > 60.0 && off < 63.0 ? 150.0 : layer;
          const std::size_t n = volume.grid.indexOf(i, j, k);
          volume.echo[n] = static_cast<std::uint8_t>(std::clamp(mean * speckle, 1.0, 250.0));
          if (off < 22.0) labels.echo[n] = kStructure;
        }
    return writeVolume(volume, folder_.toStdString() + "/volume.mha").has_value() &&
           writeVolume(labels, folder_.toStdString() + "/labels.mha").has_value();
  }

  [[nodiscard]] bool writeManifest() const {
    auto opened = loadCaseAside(folder_.toStdString());
    if (!opened) return false;
    opened->id = "reviewed-case";
    opened->title = "A cyst of the liver";
    opened->titleForTrainees = "An upper abdomen";
    opened->volume.labels = "labels.mha";
    opened->targets = {{.kind = CaseTarget::Kind::plane,
                        .name = "cyst across",
                        .probeToFile = renamed<frame::File, frame::Probe>(poseOf(target_).probeToWorld),
                        .positionTolerance_mm = 6.0,
                        .angleTolerance_deg = 12.0},
                       {.kind = CaseTarget::Kind::structure, .name = "cyst", .label = kStructure}};
    WatchTask watch;
    watch.recording = "scans/expert.seq.mha";
    watch.marks = {{4.0, "The cyst comes into the image."}};
    Lesson lesson =
        lessonOf("cyst", {stepOf("read", ReadingTask{}), stepOf("watch", watch), stepOf("find", PlaneTask{"cyst across", {}, {}}),
                          stepOf("cover", SweepTask{"cyst", 0.8}), questionOf("answer")});
    lesson.title = "Find the cyst";
    const std::pair<const char*, const char*> titles[] = {{"read", "What a cyst looks like"},
                                                          {"watch", "How an expert finds it"},
                                                          {"find", "Find the cyst"},
                                                          {"cover", "Sweep through all of it"},
                                                          {"answer", "What is it?"}};
    for (LessonStep& step : lesson.steps)
      for (const auto& [id, title] : titles)
        if (step.id == id) step.title = title;
    opened->otherFields["parts"]["lessons"] = jsonOf(std::vector<Lesson>{lesson});
    const auto saved = saveCase(*opened, folder_.toStdString());
    if (!saved) qWarning("%s", saved.error().sentence().c_str());
    return saved.has_value();
  }

  QString folder_;
  const Skin* skin_ = nullptr;
  Probe probe_;
  Hold start_, target_;
  glm::dvec3 middle_mm_{0.0};
};

}  // namespace ew::ui::testing
