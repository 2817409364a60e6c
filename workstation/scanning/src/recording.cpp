#include "ew/scanning/recording.h"

#include <algorithm>
#include <utility>

#include "event_json.h"
#include "ew/core/json_fields.h"
#include "ew/core/numbers.h"
#include "ew/core/version.h"
#include "ew/io/sequence.h"

namespace ew {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;
using Fields = std::vector<std::pair<std::string, std::string>>;

constexpr const char* kFormatField = "EchoWeaveRecording";
constexpr const char* kProgramField = "EchoWeaveVersion";
constexpr const char* kSubjectField = "EchoWeaveSubject";
constexpr const char* kSizeField = "EchoWeaveImageSize";
constexpr const char* kNumberField = "ImageNumber";
constexpr const char* kGapsField = "SkinGaps";
constexpr const char* kBodyField = "BodyState";
constexpr const char* kEventsField = "Events";
constexpr std::size_t kLongestValue = 900;  // with its key a line that readers with buffers of 1000 characters take whole
constexpr std::size_t kMostGaps = 4096;
constexpr std::size_t kLongestEvents = 16u << 20;

std::string numbered(const char* key, std::size_t n) {
  std::string number = std::to_string(n);
  number.insert(0, 3 - std::min<std::size_t>(3, number.size()), '0');
  return key + number;
}

/// A long value goes into several fields, cut where no blank would stand at the end of one: readers trim them.
void addText(Fields& fields, const char* key, const std::string& text) {
  if (text.size() <= kLongestValue) {
    fields.emplace_back(key, text);
    return;
  }
  std::size_t n = 0;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t length = std::min(kLongestValue, text.size() - at);
    while (length > 1 && at + length < text.size() && (text[at + length - 1] == ' ' || text[at + length] == ' ')) --length;
    fields.emplace_back(numbered(key, n++), text.substr(at, length));
    at += length;
  }
}

std::string valueOf(const Fields& fields, const std::string& key) {
  const auto found = std::find_if(fields.begin(), fields.end(), [&](const auto& field) { return field.first == key; });
  return found == fields.end() ? std::string() : found->second;
}

std::string joinedText(const Fields& fields, const char* key) {
  std::string text = valueOf(fields, key);
  for (std::size_t n = 0; text.size() < kLongestEvents; ++n) {
    const std::string piece = valueOf(fields, numbered(key, n));
    if (piece.empty()) break;
    text += piece;
  }
  return text;
}

tl::unexpected<Error> badEvent(const fs::path& file, const Message& where, const Message& expected) {
  return failure(ErrorCode::badField, say<"The recording '%1' has something else in %2 than %3.">(file.string(), where, expected),
                 {{"file", file.string()}, {"field", where.english()}, {"expected", expected.english()}});
}

Result<void> takeEvents(const SequenceFrame& frame, std::size_t n, const fs::path& file, ScanLog& log) {
  const std::string text = joinedText(frame.otherFields, kEventsField);
  if (text.empty()) return {};
  const Message where = say<"frame %1 of %2">(n, file.string());
  const auto events = parseJson(text, where);
  if (!events) return passOn(events.error());
  if (!events->is_array()) return badEvent(file, say<"frame %1">(n), say<"a list of events">());
  for (const json& object : *events) {
    auto event = eventOf(object, where);
    if (!event) return passOn(event.error());
    log.add(std::move(*event));
  }
  return {};
}

Result<void> takeFrame(const SequenceFrame& frame, std::size_t n, const fs::path& file, ScanLog& log) {
  if (auto taken = takeEvents(frame, n, file, log); !taken) return taken;
  const auto bad = [&](const char* field, const Message& expected) {
    return badEvent(file, joined({say<"frame %1">(n), verbatim(field)}, ", "), expected);
  };
  const std::string number = valueOf(frame.otherFields, kNumberField);
  if (number.empty()) return {};  // holds the last events alone
  FrameMade made;
  const auto parsed = parseIntegers(number);
  if (!parsed || parsed->size() != 1 || parsed->front() < 0) return bad(kNumberField, say<"a whole number">());
  made.number = static_cast<std::uint64_t>(parsed->front());
  const auto pose = std::find_if(frame.transforms.begin(), frame.transforms.end(),
                                 [](const FrameTransform& t) { return t.from == "Probe" && t.to == "World"; });
  if (pose == frame.transforms.end() || !frame.time_s)
    return badEvent(file, say<"frame %1">(n), say<"a ProbeToWorldTransform and a Timestamp">());
  made.pose.probeToWorld.matrix = pose->matrix;
  made.pose.status = pose->status;
  if (const std::string gaps = joinedText(frame.otherFields, kGapsField); !gaps.empty()) {
    const auto numbers = parseNumbers(gaps);
    if (!numbers || numbers->size() > kMostGaps) return bad(kGapsField, say<"distances in mm">());
    for (const double gap_mm : *numbers) made.gaps_mm.push_back(static_cast<float>(gap_mm));
  }
  if (const std::string body = valueOf(frame.otherFields, kBodyField); !body.empty()) {
    const auto numbers = parseNumbers(body);
    const auto isShare = [](double value) { return value >= 0.0 && value <= 1.0; };
    if (!numbers || numbers->size() != 3 || !std::all_of(numbers->begin(), numbers->end(), isShare))
      return bad(kBodyField, say<"breath, pulse and bowel, three numbers from 0 to 1">());
    made.body = {(*numbers)[0], (*numbers)[1], (*numbers)[2]};
  }
  log.add({*frame.time_s, std::move(made)});
  return {};
}

SequenceFrame frameOf(const ScanEvent& event, const FrameMade& made, json& events) {
  SequenceFrame frame;
  frame.time_s = event.time_s;
  frame.imageStatus = PoseStatus::missing;
  frame.transforms.push_back({"Probe", "World", made.pose.probeToWorld.matrix, made.pose.status});
  frame.otherFields.emplace_back(kNumberField, std::to_string(made.number));
  if (!made.gaps_mm.empty()) {
    std::string gaps;
    for (const float gap_mm : made.gaps_mm) gaps += (gaps.empty() ? "" : " ") + textOf(static_cast<double>(gap_mm));
    addText(frame.otherFields, kGapsField, gaps);
  }
  if (!(made.body == BodyState{}))
    frame.otherFields.emplace_back(kBodyField, textOf(made.body.breath) + " " + textOf(made.body.pulse) + " " + textOf(made.body.bowel));
  if (!events.empty()) addText(frame.otherFields, kEventsField, events.dump(-1, ' ', true));
  events = json::array();
  return frame;
}

}  // namespace

Result<void> writeRecording(const ScanRecording& recording, const fs::path& file, Progress& progress) {
  if (recording.log.frameCount() == 0)
    return failure(ErrorCode::badField, say<"The recording holds no image, so '%1' was not written; scan while it runs.">(file.string()),
                   {{"file", file.string()}});
  Sequence sequence;
  sequence.otherFields = {{kFormatField, std::to_string(kRecordingFormat)}, {kProgramField, kVersion}};
  addText(sequence.otherFields, kSubjectField, json{{"case", recording.caseId}, {"title", recording.title}}.dump(-1, ' ', true));
  sequence.otherFields.emplace_back(kSizeField, std::to_string(recording.size_px.x) + " " + std::to_string(recording.size_px.y));
  json events = json::array();
  for (const ScanEvent& event : recording.log.events()) {
    if (const auto* made = std::get_if<FrameMade>(&event.what))
      sequence.frames.push_back(frameOf(event, *made, events));
    else
      events.push_back(jsonOf(event));
  }
  if (!events.empty()) {
    // What happened after the last image: a frame without one, whose pose nobody may use.
    SequenceFrame last;
    last.time_s = recording.log.end_s();
    last.imageStatus = PoseStatus::missing;
    last.transforms.push_back({"Probe", "World", sequence.frames.back().transforms.front().matrix, PoseStatus::invalid});
    addText(last.otherFields, kEventsField, events.dump(-1, ' ', true));
    sequence.frames.push_back(std::move(last));
  }
  return writeSequence(sequence, file, progress);
}

Result<ScanRecording> readRecording(const fs::path& file, Progress& progress) {
  auto sequence = readPoseSequence(file, progress);
  if (!sequence) return passOn(sequence.error());
  const auto format = parseIntegers(valueOf(sequence->otherFields, kFormatField));
  if (!format || format->size() != 1)
    return failure(ErrorCode::unsupported,
                   say<"'%1' holds poses, but is no recording of a scan made here; open it as a sweep's tracking instead.">(file.string()),
                   {{"file", file.string()}});
  if (format->front() > kRecordingFormat)
    return failure(ErrorCode::newerFormat,
                   say<"The recording '%1' has format %2, this program reads up to %3; update EchoWeave.">(file.string(), format->front(),
                                                                                                           kRecordingFormat),
                   {{"file", file.string()}, {"found", std::to_string(format->front())}, {"known", std::to_string(kRecordingFormat)}});
  ScanRecording recording;
  recording.notes = std::move(sequence->notes);
  std::erase_if(recording.notes, [](const Message& note) { return note == say<"The recording has poses but no images.">(); });
  if (const auto subject = parseJsonObject(joinedText(sequence->otherFields, kSubjectField), verbatim(file.string()))) {
    JsonReading reading(verbatim(file.string()));
    const JsonFields fields(*subject, reading);
    recording.caseId = fields.text("case", "", 0);
    recording.title = fields.text("title", "", 0);
  }
  const auto size = parseIntegers(valueOf(sequence->otherFields, kSizeField));
  if (!size || size->size() != 2 || std::any_of(size->begin(), size->end(), [](long long n) { return n < 1 || n > 8192; }))
    return badEvent(file, verbatim(kSizeField), say<"two sizes from %1 to %2">(1, 8192));
  recording.size_px = {static_cast<int>(size->front()), static_cast<int>(size->back())};
  for (std::size_t n = 0; n < sequence->frames.size(); ++n) {
    if (n % 256 == 0 && progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"Stopped as asked; nothing was changed.">());
    if (auto taken = takeFrame(sequence->frames[n], n, file, recording.log); !taken) return passOn(taken.error());
  }
  if (recording.log.frameCount() == 0)
    return failure(ErrorCode::badField, say<"The recording '%1' holds no image; record the scan again.">(file.string()),
                   {{"file", file.string()}});
  return recording;
}

Result<bool> isRecording(const fs::path& file) {
  const auto sequence = readPoseSequence(file);
  if (!sequence && sequence.error().code == ErrorCode::unsupported) return false;
  if (!sequence) return passOn(sequence.error());
  return !valueOf(sequence->otherFields, kFormatField).empty();
}

}  // namespace ew
