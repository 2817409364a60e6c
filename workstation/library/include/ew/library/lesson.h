#pragma once

#include <glm/glm.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "ew/core/result.h"

namespace ew {

inline constexpr int kLessonsFormat = 1;                     ///< `format` of the section; a larger one is refused with newerFormat
inline constexpr std::string_view kLessonsPart = "lessons";  ///< the section of a case ("parts.lessons"), and its folder ("parts/lessons")

/// What a trainee may have shown beside the scan while working on a step. All off: the scan alone, as at a machine.
struct LessonAids {
  bool translucentSkin = false;
  bool organs = false;       ///< in 3D, where the case knows them
  bool volumeBox = false;    ///< how far the recorded volume reaches
  bool ownPath = false;      ///< where the probe has been
  bool expertProbe = false;  ///< the expert's probe and image plane
  bool outline = false;      ///< of the target in the image
  bool compass = false;      ///< which movement comes next
  bool operator==(const LessonAids&) const = default;
};

/// Something to read, perhaps with an image.
struct ReadingTask {
  std::string image;  ///< relative to the section's folder ("media/liver.png"), or empty
  bool operator==(const ReadingTask&) const = default;
};

/// A moment of an expert's scan, with what is to be seen there.
struct ExpertMark {
  double time_s = 0.0;  ///< on the recording's own clock
  std::string text;
  bool operator==(const ExpertMark&) const = default;
};

/// The expert's scan is played, and stops at its marks.
struct WatchTask {
  std::string recording;          ///< relative to the section's folder ("scans/right-lobe.seq.mha"); empty: not recorded yet
  std::optional<double> begin_s;  ///< of the part that is shown; absent: from its first image
  std::optional<double> end_s;    ///< absent: to its last
  std::vector<ExpertMark> marks;  ///< by rising time
  bool operator==(const WatchTask&) const = default;
};

/// A target plane of the case is to be set and the image frozen there.
struct PlaneTask {
  std::string target;
  std::optional<double> positionTolerance_mm;  ///< absent: the target's own
  std::optional<double> angleTolerance_deg;
  bool operator==(const PlaneTask&) const = default;
};

/// A structure is to be swept from end to end.
struct SweepTask {
  std::string target;  ///< a structure of the case
  double share = 0.9;  ///< of its volume that images have to pass through, 0.05 to 1
  bool operator==(const SweepTask&) const = default;
};

/// A measurement that the case expects is to be taken with calipers.
struct MeasureTask {
  std::string measurement;
  std::optional<double> tolerance;  ///< in its unit; absent: the case's
  bool operator==(const MeasureTask&) const = default;
};

/// A point or a structure of the case is to be clicked in the image.
struct PointTask {
  std::string target;
  bool operator==(const PointTask&) const = default;
};

/// One setting of the machine and between which values it is right.
struct SettingBand {
  std::string setting;  ///< one of kLessonSettings
  double lowest = 0.0;
  double highest = 0.0;
  bool operator==(const SettingBand&) const = default;
};

/// The machine is to be set: the probe, and settings within their bands.
struct SettingsTask {
  std::vector<std::string> probes;  ///< any of these is right; empty: any at all
  std::vector<SettingBand> bands;
  bool operator==(const SettingsTask&) const = default;
};

struct AnswerOption {
  std::string text;
  bool right = false;
  std::string why;  ///< what to say to whoever chose it
  bool operator==(const AnswerOption&) const = default;
};

/// A question: options of which one or several are right, or a number.
struct AnswerTask {
  std::vector<AnswerOption> options;  ///< empty: a number is asked for
  std::optional<double> number;       ///< the right one, in `unit`
  double tolerance = 0.0;
  std::string unit;
  bool operator==(const AnswerTask&) const = default;
};

/// Scanning at one's own choice, for at least a while; what is to be shown is a list to tick.
struct FreeTask {
  double shortest_s = 0.0;
  std::vector<std::string> targets;  ///< planes and structures of the case that are looked for meanwhile
  bool operator==(const FreeTask&) const = default;
};

using LessonTask = std::variant<ReadingTask, WatchTask, PlaneTask, SweepTask, MeasureTask, PointTask, SettingsTask, AnswerTask, FreeTask>;

/// The words of files for the kinds of steps, in the order of LessonTask: "read", "watch", "plane", "sweep", "measure", "point",
/// "settings", "answer", "free".
[[nodiscard]] std::string_view taskWord(const LessonTask& task);
[[nodiscard]] std::optional<LessonTask> taskOfWord(std::string_view word);
/// Whether the step is worked on with probe and console alone: nothing else would tell that somebody did it.
[[nodiscard]] bool isScanned(const LessonTask& task);

/// Settings a step can ask for, each a knob with its unit.
inline constexpr std::string_view kLessonSettings[] = {"depth_mm", "gain_db", "dynamic_range_db", "focus_mm"};

struct LessonStep {
  std::string id;                  ///< unique in its lesson; attempts are kept by it
  std::string title;               ///< "Find the portal vein"
  std::string text;                ///< what to do; of an answer the question
  std::string lookFor;             ///< what to look for
  std::string after;               ///< said when the step is over, passed or not
  std::string caseId;              ///< what is scanned; empty: the case that holds the lesson
  std::vector<std::string> hints;  ///< one after another, on request
  LessonAids aids;                 ///< that may be switched on
  bool feedback = true;            ///< whether it is said while scanning how far off one is
  double passLevel = 0.7;          ///< the least score, 0 to 1
  std::optional<double> time_s;    ///< that the step may take, from 5 to 7200; absent: as long as one likes
  LessonTask task;
  nlohmann::json otherFields = nlohmann::json::object();  ///< kept as they are
  bool operator==(const LessonStep&) const = default;
};

struct Lesson {
  std::string id;     ///< unique in its case
  std::string title;  ///< gives no finding away
  std::string aim;    ///< what one can do afterwards
  int level = 1;      ///< 1 (first steps) to 5 (examination)
  int minutes = 10;   ///< about how long it takes
  std::vector<std::string> tags;
  std::vector<std::string> sources;  ///< what it teaches after
  std::string language = "en";       ///< its texts are written in
  std::vector<LessonStep> steps;
  nlohmann::json otherFields = nlohmann::json::object();
  bool operator==(const Lesson&) const = default;
};

/// The section of a case that holds its lessons.
/// @param section "parts.lessons" as it stands in case.json
/// @error badField (field name, value found, value expected), newerFormat (with both format numbers)
[[nodiscard]] Result<std::vector<Lesson>> lessonsFromJson(const nlohmann::json& section);
/// lessonsFromJson(jsonOf(lessons)) == lessons.
[[nodiscard]] nlohmann::json jsonOf(const std::vector<Lesson>& lessons);

/// A name of a lesson's content (ContentKey of its JSON): attempts keep it, to tell whether the lesson has changed since.
[[nodiscard]] std::string contentOf(const Lesson& lesson);

/// JSON Schema, draft 7, of the section: what CaseParts and editors of other programs check it with. lessonsFromJson refuses what it
/// refuses.
[[nodiscard]] const std::string& lessonsSchema();

/// An id for something new: its name in small letters with '-' for what an id may not hold, at most 90 characters, `otherwise` when nothing
/// is left; with a number behind it when it is taken.
[[nodiscard]] std::string idFor(std::string_view name, const std::vector<std::string>& taken, std::string_view otherwise = "step");

}  // namespace ew
