#pragma once

#include <optional>
#include <vector>

#include "ew/assessment/review_comment.h"
#include "ew/library/attempt.h"
#include "ew/library/lesson.h"
#include "ew/scanning/events.h"
#include "logic/review_clock.h"

namespace ew::review {

enum class TrackKind { pose, contact, settings, freeze, measurement, answer, mark, comment };
inline constexpr int kTrackKinds = 8;

/// A while on the recording's clock.
struct TrackSpan {
  double begin_s = 0.0;
  double end_s = 0.0;
  double level = 1.0;  ///< 0 to 1: of the contact, how much of the face touches
  bool operator==(const TrackSpan&) const = default;
};

/// A moment on the recording's clock, and what happened then.
struct TrackMark {
  double time_s = 0.0;
  Message what;
  bool operator==(const TrackMark&) const = default;
};

struct Track {
  TrackKind kind = TrackKind::pose;
  std::vector<TrackSpan> spans;  ///< of pose, contact and freeze; by rising time, without overlap
  std::vector<TrackMark> marks;  ///< of the others; by rising time
  bool operator==(const Track&) const = default;
};

/// What is told of a scan beside its recording.
struct TrackNotes {
  const StepOutcome* outcome = nullptr;  ///< of the step; null: none
  std::vector<ExpertMark> marks = {};    ///< of an expert's scan
  std::vector<ReviewComment> comments = {};
};

/// All tracks of a scan in the order of TrackKind, those without anything as well. A frame lasts until the next one is made, the last one
/// no time. A measurement or an answer that was noted in the scan stands where it was noted, those of the outcome at its end.
[[nodiscard]] std::vector<Track> tracksOf(const ScanLog& log, const Part& part, const TrackNotes& notes = {});

/// While the image was frozen, within the part.
[[nodiscard]] std::vector<TrackSpan> freezesOf(const ScanLog& log, const Part& part);

/// The moments of all marks and beginnings and ends of freezing, sorted: what a jump goes to. Poses and contact change too often.
[[nodiscard]] std::vector<double> eventsOf(const std::vector<Track>& tracks);

/// One setting as a console shows it, with its unit.
struct Setting {
  Message name;
  Message value;
  bool operator==(const Setting&) const = default;
};
/// What decides an image and a console shows: probe, depth, gain, dynamic range, focus, frequency, ... always the same ones in the same
/// order.
[[nodiscard]] std::vector<Setting> settingsOf(const ScanState& state);

}  // namespace ew::review
