#include "ew/scanning/recording_journal.h"

#include "event_json.h"
#include "ew/core/json_fields.h"
#include "ew/io/safe_file.h"

namespace ew {
namespace {

using nlohmann::json;

constexpr int kJournalFormat = 1;
constexpr std::size_t kLongestJournal_bytes = std::size_t{1} << 30;
constexpr std::size_t kLongestTitle_bytes = 10000;

std::string lineOf(const json& object) { return object.dump(-1, ' ', true, json::error_handler_t::replace) + "\n"; }

/// The text up to the next end of a line, which is taken from `rest`; empty and nothing taken: no whole line is left.
std::string_view nextLine(std::string_view& rest) {
  const std::size_t end = rest.find('\n');
  if (end == std::string_view::npos) return {};
  const std::string_view line = rest.substr(0, end);
  rest.remove_prefix(end + 1);
  return line;
}

Result<ScanRecording> readHead(std::string_view line, const Message& where) {
  const auto head = parseJsonObject(line, where);
  if (!head) return passOn(head.error());
  JsonReading reading(where);
  const JsonFields fields(*head, reading);
  const auto format = fields.whole("recording", 1, 1000000);
  if (reading.good() && format > kJournalFormat)
    return failure(ErrorCode::newerFormat,
                   say<"%1 has format %2, this program reads up to %3; update EchoWeave.">(where, format, kJournalFormat));
  ScanRecording recording;
  recording.caseId = fields.text("case", "", 0);
  recording.title = fields.text("title", "", 0, kLongestTitle_bytes);
  const auto size = fields.numbers("size_px", 2, 2, 1, 8192);
  if (reading.problem()) return passOn(*reading.problem());
  recording.size_px = {static_cast<int>(size[0]), static_cast<int>(size[1])};
  return recording;
}

}  // namespace

std::string journalHead(const ScanRecording& recording) {
  return lineOf({{"recording", kJournalFormat},
                 {"case", recording.caseId},
                 {"title", recording.title},
                 {"size_px", {recording.size_px.x, recording.size_px.y}}});
}

std::string journalLines(const ScanLog& log, std::size_t from) {
  std::string lines;
  for (std::size_t n = from; n < log.events().size(); ++n) lines += lineOf(jsonOf(log.events()[n]));
  return lines;
}

Result<ScanRecording> recordingFromJournal(std::string_view text, const Message& where) {
  const auto withoutImage = [&] {
    return failure(ErrorCode::truncated, say<"The recording '%1' holds no image; record the scan again.">(where));
  };
  if (text.find('\n') == std::string_view::npos) return withoutImage();  // the crash fell into the head
  std::string_view rest = text;
  auto recording = readHead(nextLine(rest), where);
  if (!recording) return recording;
  for (std::size_t n = 1; !rest.empty(); ++n) {
    const std::string_view line = nextLine(rest);
    if (line.empty()) break;  // the crash fell into it
    const Message at = say<"line %1 of %2">(n + 1, where);
    const auto object = parseJson(line, at);
    auto event = object ? eventOf(*object, at) : Result<ScanEvent>(passOn(object.error()));
    if (!event) {
      recording->notes.push_back(event.error().message);
      break;
    }
    recording->log.add(std::move(*event));
  }
  if (recording->log.frameCount() == 0 && recording->notes.empty()) return withoutImage();
  if (recording->log.frameCount() == 0) return failure(ErrorCode::badField, recording->notes.front());
  return recording;
}

Result<ScanRecording> readJournal(const std::filesystem::path& file) {
  const auto text = readTextFile(file, kLongestJournal_bytes);
  if (!text) return passOn(text.error());
  return recordingFromJournal(*text, verbatim(file.string()));
}

}  // namespace ew
