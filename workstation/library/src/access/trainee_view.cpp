#include "access/trainee_view.h"

#include <algorithm>
#include <bitset>
#include <optional>
#include <tuple>
#include <variant>

#include "ew/library/case_start.h"

namespace ew {
namespace {

// Every assignment below is a field that goes to trainees. What is not assigned stays behind.

CaseExamination plain(const CaseExamination& original) {
  return {original.when, original.kind, original.findings, {}, nlohmann::json::object()};
}
CaseLaboratory plain(const CaseLaboratory& original) { return {original.when, original.findings, nlohmann::json::object()}; }

/// Whether a step asks for something; an expert's scan and a text do not.
bool asksFor(const LessonStep& step) {
  return !std::holds_alternative<ReadingTask>(step.task) && !std::holds_alternative<WatchTask>(step.task);
}

struct PlainTask {
  LessonTask operator()(const ReadingTask& task) const { return ReadingTask{task.image}; }
  LessonTask operator()(const WatchTask&) const { return WatchTask{}; }
  LessonTask operator()(const PlaneTask&) const { return PlaneTask{}; }
  LessonTask operator()(const SweepTask&) const { return SweepTask{}; }
  LessonTask operator()(const MeasureTask&) const { return MeasureTask{}; }
  LessonTask operator()(const PointTask&) const { return PointTask{}; }
  LessonTask operator()(const SettingsTask&) const { return SettingsTask{}; }
  LessonTask operator()(const AnswerTask& task) const {
    AnswerTask made;
    for (const AnswerOption& option : task.options) made.options.push_back({.text = option.text, .right = false, .why = {}});
    made.unit = task.unit;
    return made;
  }
  LessonTask operator()(const FreeTask& task) const { return FreeTask{.shortest_s = task.shortest_s, .targets = {}}; }
};

LessonStep plain(const LessonStep& original, std::string id) {
  LessonStep made;
  made.id = std::move(id);
  made.title = original.title;
  made.text = original.text;
  made.aids.translucentSkin = original.aids.translucentSkin;
  made.aids.volumeBox = original.aids.volumeBox;
  made.aids.ownPath = original.aids.ownPath;
  made.feedback = false;
  made.time_s = original.time_s;
  made.task = std::visit(PlainTask{}, original.task);
  return made;
}

Result<void> checkScansHome(const Lesson& lesson, const LessonStep& step) {
  if (step.caseId.empty()) return {};
  return failure(
      ErrorCode::badField,
      say<"The step '%1' of the lesson '%2' scans another case, '%3', and an examination carries one case; let it scan its own.">(
          step.id, lesson.id, step.caseId),
      {{"lesson", lesson.id}, {"step", step.id}});
}

}  // namespace

Result<Case> traineeView(const Case& original, const std::string& id) {
  if (original.titleForTrainees.empty())
    return failure(ErrorCode::badField,
                   say<"The case has no title for trainees, and its own may name the finding; give it one in the Author workspace.">(),
                   {{"field", "title_for_trainees"}});
  std::error_code ignored;
  if (!original.mannequin.empty() && std::filesystem::exists(original.folder / original.mannequin, ignored))
    return failure(ErrorCode::badField,
                   say<"The case has a mannequin of its own, '%1', whose file may say more than trainees should read; choose one of the "
                       "program's for an examination.">(original.mannequin),
                   {{"field", "mannequin"}});
  Case made;
  made.id = id;
  made.title = original.titleForTrainees;
  made.titleForTrainees = original.titleForTrainees;
  made.region = original.region;
  made.patient.name = original.patient.name;
  made.patient.sex = original.patient.sex;
  made.patient.age_years = original.patient.age_years;
  made.complaint = original.complaint;
  made.history = original.history;
  made.indication = original.indication;
  for (const CaseExamination& each : original.previousExaminations) made.previousExaminations.push_back(plain(each));
  for (const CaseLaboratory& each : original.laboratory) made.laboratory.push_back(plain(each));
  made.mannequin = original.mannequin;
  made.probes = original.probes;
  made.startPose = original.startPose;
  return withPresets(std::move(made), shippedPresetsOf(original));
}

Result<LessonsView> traineeView(const std::vector<Lesson>& lessons) {
  LessonsView view;
  bool asksAnything = false;
  for (const Lesson& lesson : lessons) {
    Lesson made;
    made.id = "lesson-" + std::to_string(&lesson - lessons.data() + 1);
    made.title = lesson.title;
    made.level = lesson.level;
    made.minutes = lesson.minutes;
    made.language = lesson.language;
    bool hasAsked = false;
    for (const LessonStep& step : lesson.steps) {
      if (auto good = checkScansHome(lesson, step); !good) return passOn(good.error());
      const bool asks = asksFor(step);
      // A text that comes after a question may be its answer.
      if (std::holds_alternative<WatchTask>(step.task) || (!asks && hasAsked)) {
        ++view.leftOut;
        continue;
      }
      hasAsked = hasAsked || asks;
      made.steps.push_back(plain(step, "step-" + std::to_string(&step - lesson.steps.data() + 1)));
      view.originalSteps[made.id][made.steps.back().id] = step.id;
      if (const auto* read = std::get_if<ReadingTask>(&step.task); read != nullptr && !read->image.empty()) view.images.insert(read->image);
    }
    if (!hasAsked) continue;
    asksAnything = true;
    view.originalLessons[made.id] = lesson.id;
    view.lessons.push_back(std::move(made));
  }
  if (!asksAnything)
    return failure(ErrorCode::badUsage,
                   say<"No lesson of the case asks for anything, so there is nothing to examine; give it a lesson with steps first.">());
  return view;
}

PlainTissues plainTissues(const Scene& whole) {
  using Acoustics = std::tuple<double, double, double>;
  PlainTissues made;
  made.scene.gainAndDgc = whole.gainAndDgc;
  made.scene.liveEchoes = whole.liveEchoes;
  made.scene.recordedDynamicRange_db = whole.recordedDynamicRange_db;
  made.scene.focus = whole.focus;
  made.scene.sliceThickness = whole.sliceThickness;
  made.scene.attenuation = whole.attenuation;
  made.scene.reverberation = whole.reverberation;
  made.scene.noise = whole.noise;
  made.scene.contact = whole.contact;
  made.scene.motion = whole.motion;
  std::map<Acoustics, int> labels;
  // 0 is where nothing is; 1 is for whatever no tissue is known of.
  for (std::size_t n = 1; n < made.newLabel.size(); ++n) made.newLabel[n] = 1;
  for (const TissueAcoustics& tissue : whole.tissues) {
    if (tissue.label < 0 || tissue.label > 255) continue;
    const Acoustics acoustics{tissue.attenuation_dbPerCmMhz, tissue.reflection_db, tissue.impedance_mrayl};
    int label = 0;
    if (tissue.label != 0) {
      label = labels.try_emplace(acoustics, static_cast<int>(labels.size()) + 2).first->second;
      made.newLabel[static_cast<std::size_t>(tissue.label)] = static_cast<std::uint8_t>(label);
    }
    const bool isKnown = std::any_of(made.scene.tissues.begin(), made.scene.tissues.end(), [&](const auto& t) { return t.label == label; });
    if (isKnown) continue;
    TissueAcoustics plain;
    plain.label = label;
    plain.attenuation_dbPerCmMhz = tissue.attenuation_dbPerCmMhz;
    plain.reflection_db = tissue.reflection_db;
    plain.impedance_mrayl = tissue.impedance_mrayl;
    made.scene.tissues.push_back(std::move(plain));
  }
  std::stable_sort(made.scene.tissues.begin(), made.scene.tissues.end(), [](const auto& a, const auto& b) { return a.label < b.label; });
  made.needsLabels = !made.scene.tissues.empty();
  return made;
}

namespace {

constexpr std::size_t kKinds = 256;  // of a map, 0 is none
using Kinds = std::bitset<kKinds>;

/// Everything that an image knows of a surface.
auto propertiesOf(const ReflectingSurface& surface) {
  return std::tuple(surface.echoLevel, surface.thickness_mm, surface.fall_deg, surface.rough_db, surface.roughFall_deg, surface.sheets,
                    surface.sheetGap_mm, surface.frontOnly);
}

/// By kind, which others there are among the eight voxels around a point: echoes ask for no more at once (echo_surfaces.cpp).
std::array<Kinds, kKinds> kindsBeside(const TissueMaps& maps) {
  std::array<Kinds, kKinds> beside;
  const glm::ivec3 dims = maps.grid.dims;
  const std::uint8_t* const voxels = maps.surfaceKind.data();
  const std::ptrdiff_t row = dims.x, plane = row * dims.y;
  for (int k = 0; k + 1 < dims.z; ++k)
    for (int j = 0; j + 1 < dims.y; ++j)
      for (int i = 0; i + 1 < dims.x; ++i) {
        const std::uint8_t* at = voxels + i + row * j + plane * k;
        const std::array<std::uint8_t, 8> around{at[0],     at[1],         at[row],         at[row + 1],
                                                 at[plane], at[plane + 1], at[plane + row], at[plane + row + 1]};
        for (const std::uint8_t a : around)
          if (a != around[0])
            for (const std::uint8_t b : around) beside[a].set(b), beside[b].set(a);
      }
  return beside;
}

/// Kinds that are met, in the order in which the voxels show them.
std::vector<std::size_t> kindsAsMet(const TissueMaps& maps) {
  std::vector<std::size_t> met;
  Kinds seen;
  for (const std::uint8_t kind : maps.surfaceKind)
    if (kind != 0 && kind <= maps.surfaces.size() && !seen[kind]) {
      seen.set(kind);
      met.push_back(kind);
    }
  return met;
}

}  // namespace

TissueMaps plainSurfaces(TissueMaps maps) {
  if (maps.surfaceKind.empty()) {
    maps.surfaces.clear();
    return maps;
  }
  const auto beside = kindsBeside(maps);
  using Numbered = std::pair<decltype(propertiesOf({})), std::size_t>;  // the first, second ... of those alike
  std::map<Numbered, Kinds> merged;
  for (const std::size_t kind : kindsAsMet(maps)) {
    Numbered as{propertiesOf(maps.surfaces[kind - 1]), 0};
    while ((merged[as] & beside[kind]).any()) ++as.second;
    merged[as].set(kind);
  }
  std::array<std::uint8_t, kKinds> newKind{};
  std::vector<ReflectingSurface> surfaces;
  for (const auto& [as, kinds] : merged) {
    std::optional<ReflectingSurface> one;
    for (std::size_t kind = 1; kind < kKinds; ++kind) {
      if (!kinds[kind]) continue;
      one = maps.surfaces[kind - 1];
      newKind[kind] = static_cast<std::uint8_t>(surfaces.size() + 1);
    }
    one->name.clear();
    surfaces.push_back(std::move(*one));
  }
  for (std::uint8_t& kind : maps.surfaceKind) kind = newKind[kind];
  maps.surfaces = std::move(surfaces);
  return maps;
}

}  // namespace ew
