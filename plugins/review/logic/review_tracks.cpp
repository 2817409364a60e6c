#include "logic/review_tracks.h"

#include <algorithm>
#include <cmath>

#include "ew/core/figures.h"
#include "ew/imaging/display.h"
#include "ew/imaging/resolved.h"
#include "ew/library/step_answer.h"
#include "ew/scanning/contact.h"

namespace ew::review {
namespace {

Message inUnit(double value, int decimals, const char* unit) { return joined({fixedNumeral(value, decimals), verbatim(unit)}, " "); }

Message gainOf(const ScanState& state) {
  if (resolvedGainLaw(state.knobs, state.scene) == GainLaw::decibel) return inUnit(state.knobs.gain_db, 0, "dB");
  return joined({verbatim("×"), fixedNumeral(state.knobs.gain, 2)}, " ");
}

/// Eight sliders in one word: whether they stand where they rest, else how far they reach.
Message tgcOf(const ScanState& state) {
  const bool inDecibels = resolvedGainLaw(state.knobs, state.scene) == GainLaw::decibel;
  const auto& sliders = inDecibels ? state.knobs.tgc_db : state.knobs.dgc;
  const auto [low, high] = std::minmax_element(sliders.begin(), sliders.end());
  if (*low == (inDecibels ? 0.0 : 1.0) && *high == *low) return say<"neutral">();
  const int decimals = inDecibels ? 0 : 2;
  return say<"%1 to %2">(fixedNumeral(*low, decimals), inDecibels ? inUnit(*high, decimals, "dB") : fixedNumeral(*high, decimals));
}

Message focusOf(const ScanState& state) {
  const double depth_mm = resolvedDepth_mm(state.probe, state.knobs);
  std::vector<Message> foci{fixedNumeral((state.knobs.focus_mm > 0.0 ? state.knobs.focus_mm : 0.5 * depth_mm) / 10.0, 1)};
  for (const double more_mm : state.knobs.moreFoci_mm)
    if (more_mm > 0.0) foci.push_back(fixedNumeral(more_mm / 10.0, 1));
  return joined({joined(std::move(foci), ", "), verbatim("cm")}, " ");
}

Message modeOf(DisplayMode mode) {
  switch (mode) {
    case DisplayMode::mMode:
      return say<"M-mode">();
    case DisplayMode::both:
      return say<"B and M-mode">();
    case DisplayMode::spectrum:
      return say<"B-mode and spectrum">();
    case DisplayMode::bMode:
      break;
  }
  return say<"B-mode">();
}

/// "depth 12 cm, was 15 cm", for each setting that differs.
std::optional<Message> changeBetween(const ScanState& before, const ScanState& now) {
  const std::vector<Setting> were = settingsOf(before), are = settingsOf(now);
  std::vector<Message> parts;
  for (std::size_t n = 0; n < are.size(); ++n)
    if (!(are[n] == were[n])) parts.push_back(say<"%1 %2, was %3">(are[n].name, are[n].value, were[n].value));
  if (parts.empty()) return std::nullopt;
  return joined(std::move(parts), "; ");
}

void extend(std::vector<TrackSpan>& spans, double begin_s, double end_s, double level) {
  if (end_s <= begin_s) return;
  if (!spans.empty() && spans.back().end_s == begin_s && spans.back().level == level)
    spans.back().end_s = end_s;
  else
    spans.push_back({begin_s, end_s, level});
}

void followFrames(const ScanLog& log, const Part& part, std::vector<Track>& tracks) {
  std::optional<ScanState> before;
  for (std::size_t n = 0; n < log.frameCount(); ++n) {
    const ScanState state = log.frame(n);
    const double begin_s = std::max(part.begin_s, log.frameTime_s(n));
    const double end_s = std::min(part.end_s, n + 1 < log.frameCount() ? log.frameTime_s(n + 1) : log.end_s());
    if (log.frameTime_s(n) > part.end_s) break;
    if (state.pose.status == PoseStatus::ok) {
      extend(tracks[static_cast<std::size_t>(TrackKind::pose)].spans, begin_s, end_s, 1.0);
      const double touching = state.gaps_mm.empty() ? 1.0 : contactShare(state.gaps_mm);
      if (touching > 0.0) extend(tracks[static_cast<std::size_t>(TrackKind::contact)].spans, begin_s, end_s, touching);
    }
    const bool isSame = before && before->knobs == state.knobs && before->probe == state.probe && before->scene == state.scene;
    if (before && !isSame && log.frameTime_s(n) >= part.begin_s)
      if (auto change = changeBetween(*before, state))
        tracks[static_cast<std::size_t>(TrackKind::settings)].marks.push_back({begin_s, std::move(*change)});
    if (!isSame) before = state;
  }
}

std::string wordsIn(const nlohmann::json& what) {
  for (const char* key : {"text", "name", "title"})
    if (what.is_object() && what.contains(key) && what[key].is_string()) return what[key].get<std::string>();
  return what.is_string() ? what.get<std::string>() : std::string();
}

TrackKind kindOfNote(const std::string& kind) {
  if (kind == "measurement") return TrackKind::measurement;
  return kind == "answer" ? TrackKind::answer : TrackKind::mark;
}

void followNotes(const ScanLog& log, const Part& part, std::vector<Track>& tracks) {
  for (const ScanEvent& event : log.events()) {
    const auto* note = std::get_if<Note>(&event.what);
    if (note == nullptr || note->kind == "tracking" || event.time_s < part.begin_s || event.time_s > part.end_s) continue;
    const std::string words = wordsIn(note->what);
    tracks[static_cast<std::size_t>(kindOfNote(note->kind))].marks.push_back({event.time_s, verbatim(words.empty() ? note->kind : words)});
  }
}

void addOutcome(const StepOutcome& outcome, double end_s, std::vector<Track>& tracks) {
  if (outcome.answerJson().is_null()) return;
  const auto* measured = std::get_if<MeasurementAnswer>(&outcome.answer);
  const bool isMeasured = measured != nullptr && measured->caliper;
  auto& marks = tracks[static_cast<std::size_t>(isMeasured ? TrackKind::measurement : TrackKind::answer)].marks;
  marks.push_back({end_s, isMeasured ? say<"Handed in a measurement">() : say<"Handed in an answer">()});
}

}  // namespace

std::vector<Setting> settingsOf(const ScanState& state) {
  const Knobs& knobs = state.knobs;
  const double carrier_hz = knobs.carrier_hz > 0.0 ? knobs.carrier_hz : state.probe.carrier_hz;
  return {{say<"probe">(), verbatim(state.probe.name)},
          {say<"depth">(), inUnit(resolvedDepth_mm(state.probe, knobs) / 10.0, 1, "cm")},
          {say<"gain">(), gainOf(state)},
          {say<"TGC">(), tgcOf(state)},
          {say<"focus">(), focusOf(state)},
          {say<"frequency">(), inUnit(carrier_hz / 1e6, 1, "MHz")},
          {say<"dynamic range">(), knobs.dynamicRange_db > 0.0 ? inUnit(knobs.dynamicRange_db, 0, "dB") : say<"as recorded">()},
          {say<"zoom">(), joined({verbatim("×"), fixedNumeral(knobs.zoom, 1)}, " ")},
          {say<"mode">(), modeOf(knobs.mode)}};
}

std::vector<Track> tracksOf(const ScanLog& log, const Part& part, const TrackNotes& notes) {
  std::vector<Track> tracks(kTrackKinds);
  for (int n = 0; n < kTrackKinds; ++n) tracks[static_cast<std::size_t>(n)].kind = static_cast<TrackKind>(n);
  followFrames(log, part, tracks);
  tracks[static_cast<std::size_t>(TrackKind::freeze)].spans = freezesOf(log, part);
  followNotes(log, part, tracks);
  if (notes.outcome != nullptr) addOutcome(*notes.outcome, part.end_s, tracks);
  const auto isWithin = [&](double time_s) { return time_s >= part.begin_s && time_s <= part.end_s; };
  for (const ExpertMark& mark : notes.marks)
    if (isWithin(mark.time_s)) tracks[static_cast<std::size_t>(TrackKind::mark)].marks.push_back({mark.time_s, verbatim(mark.text)});
  for (const ReviewComment& comment : notes.comments)
    if (isWithin(comment.time_s))
      tracks[static_cast<std::size_t>(TrackKind::comment)].marks.push_back(
          {comment.time_s, comment.text.empty() ? say<"A drawing">() : verbatim(comment.text)});
  for (Track& track : tracks)
    std::stable_sort(track.marks.begin(), track.marks.end(), [](const TrackMark& a, const TrackMark& b) { return a.time_s < b.time_s; });
  return tracks;
}

std::vector<TrackSpan> freezesOf(const ScanLog& log, const Part& part) {
  std::vector<TrackSpan> spans;
  std::optional<double> since_s;
  const auto add = [&](double end_s) {
    const TrackSpan span{std::max(part.begin_s, *since_s), std::min(part.end_s, end_s), 1.0};
    if (span.begin_s < span.end_s) spans.push_back(span);
    since_s.reset();
  };
  for (const ScanEvent& event : log.events()) {
    const auto* freeze = std::get_if<FreezeChanged>(&event.what);
    if (freeze == nullptr) continue;
    if (freeze->isFrozen && !since_s) since_s = event.time_s;
    if (!freeze->isFrozen && since_s) add(event.time_s);
  }
  if (since_s) add(part.end_s);
  return spans;
}

std::vector<double> eventsOf(const std::vector<Track>& tracks) {
  std::vector<double> events_s;
  for (const Track& track : tracks) {
    for (const TrackMark& mark : track.marks) events_s.push_back(mark.time_s);
    if (track.kind != TrackKind::freeze) continue;
    for (const TrackSpan& span : track.spans) {
      events_s.push_back(span.begin_s);
      events_s.push_back(span.end_s);
    }
  }
  std::sort(events_s.begin(), events_s.end());
  events_s.erase(std::unique(events_s.begin(), events_s.end()), events_s.end());
  return events_s;
}

}  // namespace ew::review
