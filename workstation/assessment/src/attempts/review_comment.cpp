#include "ew/assessment/review_comment.h"

#include <algorithm>
#include <array>

#include "ew/core/json_fields.h"
#include "ew/core/word_table.h"
#include "ew/io/content_key.h"
#include "ew/io/json_files.h"
#include "ew/io/safe_file.h"
#include "ew/library/lesson.h"

namespace ew {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using std::chrono::sys_seconds;
using Stroke = CommentStroke::Kind;

constexpr std::size_t kMostComments = 10'000, kMostStrokes = 200, kMostPoints = 5000, kLongestText = 20'000;
constexpr double kFarthest_mm = 1e4;
constexpr WordTable<Stroke, 3> kStrokes = {{{"line", Stroke::line}, {"arrow", Stroke::arrow}, {"circle", Stroke::circle}}};
constexpr std::array<std::string_view, 8> kCommentFields = {"id",   "step",    "recording",      "time_s",
                                                            "text", "strokes", "probe_to_world", "at_unix_s"};
constexpr std::array<std::string_view, 3> kFileFields = {"format", "author", "comments"};

template <std::size_t N>
json otherThan(const json& object, const std::array<std::string_view, N>& known) {
  json rest = object.is_object() ? object : json::object();
  for (const std::string_view key : known) rest.erase(std::string(key));
  return rest;
}

json numbersOf(const Transform<frame::World, frame::Probe>& t) {
  json numbers = json::array();
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) numbers.push_back(t.matrix[column][row]);
  return numbers;
}

CommentStroke strokeOf(const JsonFields& fields) {
  CommentStroke stroke;
  stroke.kind = fields.word("kind", kStrokes);
  const std::vector<double> numbers = fields.numbers("points_mm", 4, 2 * kMostPoints, -kFarthest_mm, kFarthest_mm);
  const bool isPair = stroke.kind != Stroke::line;
  if (numbers.size() % 2 != 0 || (isPair && numbers.size() > 4))
    fields.refuse("points_mm", isPair ? say<"two points, each lateral and axial">() : say<"points, each lateral and axial">());
  for (std::size_t n = 0; n + 1 < numbers.size(); n += 2) stroke.points_mm.emplace_back(numbers[n], numbers[n + 1]);
  return stroke;
}

ReviewComment commentOf(const JsonFields& fields) {
  ReviewComment made;
  made.id = fields.text("id", {}, 1, 100);
  made.stepId = fields.text("step", {}, 1, 100);
  made.recording = fields.text("recording", std::string(), 0, 240);
  if (made.recording.find_first_of("/\\") != std::string::npos || made.recording == "..")
    fields.refuse("recording", say<"a file of the attempt's folder">());
  made.time_s = fields.number("time_s", 0.0, 1e9);
  made.text = fields.text("text", std::string(), 0, kLongestText);
  for (const JsonFields& each : fields.objects("strokes", 0, kMostStrokes)) made.strokes.push_back(strokeOf(each));
  if (const auto matrix = fields.rigid("probe_to_world")) made.probeToWorld = Transform<frame::World, frame::Probe>{*matrix};
  made.at = sys_seconds(std::chrono::seconds(fields.whole("at_unix_s", 0, 253'402'300'799)));
  made.otherFields = otherThan(fields.value(), kCommentFields);
  return made;
}

json jsonOf(const ReviewComment& comment) {
  json made = comment.otherFields.is_object() ? comment.otherFields : json::object();
  made["id"] = comment.id;
  made["step"] = comment.stepId;
  if (!comment.recording.empty()) made["recording"] = comment.recording;
  made["time_s"] = comment.time_s;
  if (!comment.text.empty()) made["text"] = comment.text;
  for (const CommentStroke& stroke : comment.strokes) {
    json each = {{"kind", wordIn(kStrokes, stroke.kind)}, {"points_mm", json::array()}};
    for (const glm::dvec2& p : stroke.points_mm) {
      each["points_mm"].push_back(p.x);
      each["points_mm"].push_back(p.y);
    }
    made["strokes"].push_back(std::move(each));
  }
  if (comment.probeToWorld) made["probe_to_world"] = numbersOf(*comment.probeToWorld);
  made["at_unix_s"] = comment.at.time_since_epoch().count();
  return made;
}

Result<CommentFile> readFile(const fs::path& file) {
  auto document = readJsonFile(file, verbatim(file.filename().string()), 64u << 20);
  if (!document) return passOn(document.error());
  return commentsFromJson(*document);
}

}  // namespace

Result<CommentFile> commentsFromJson(const json& document) {
  JsonReading reading(say<"the comments">());
  const JsonFields fields(document, reading);
  const auto format = fields.whole("format", 1, 1'000'000);
  if (reading.good() && format > kCommentsFormat)
    return failure(ErrorCode::newerFormat,
                   say<"The comments have format %1, and this program reads formats up to %2; open them with a newer EchoWeave.">(
                       std::to_string(format), kCommentsFormat),
                   {{"format", std::to_string(format)}, {"known", std::to_string(kCommentsFormat)}});
  CommentFile made;
  made.author = fields.text("author", std::string(), 0, 400);
  for (const JsonFields& each : fields.objects("comments", 0, kMostComments)) {
    made.comments.push_back(commentOf(each));
    const auto isSame = [&](const ReviewComment& other) { return other.id == made.comments.back().id; };
    if (std::count_if(made.comments.begin(), made.comments.end(), isSame) > 1) each.refuse("id", say<"an id that no other comment has">());
  }
  made.otherFields = otherThan(fields.value(), kFileFields);
  if (reading.problem()) return passOn(*reading.problem());
  return made;
}

json jsonOf(const CommentFile& file) {
  json made = file.otherFields.is_object() ? file.otherFields : json::object();
  made["format"] = kCommentsFormat;
  made["author"] = file.author;
  made["comments"] = json::array();
  for (const ReviewComment& comment : file.comments) made["comments"].push_back(jsonOf(comment));
  return made;
}

fs::path commentsFileOf(const fs::path& attempt, const std::string& author) {
  // A name in letters that any file system takes, and its key: "Ana" and "ANA" are two people.
  const std::string key = ContentKey().add(author).text();
  return attempt / "comments" / (idFor(author.substr(0, 40), {}, "reviewer") + "-" + key.substr(0, 8) + ".json");
}

Result<CommentFile> readComments(const fs::path& attempt, const std::string& author) {
  const fs::path file = commentsFileOf(attempt, author);
  std::error_code ignored;
  if (!fs::exists(file, ignored)) return CommentFile{author, {}, json::object()};
  return readFile(file);
}

Result<void> writeComments(const fs::path& attempt, const CommentFile& file) {
  if (auto there = readComments(attempt, file.author); !there) return passOn(there.error());
  const fs::path target = commentsFileOf(attempt, file.author);
  std::error_code why;
  fs::create_directories(target.parent_path(), why);
  if (why)
    return failure(ErrorCode::notWritable,
                   say<"%1 cannot be made (%2); check that you may write there.">(target.parent_path(), verbatim(why.message())),
                   {{"file", target.parent_path().string()}});
  return writeFileSafely(target, jsonOf(file).dump(1) + "\n");
}

CommentList listComments(const fs::path& attempt) {
  CommentList list;
  std::error_code why;
  std::vector<fs::path> files;
  for (fs::directory_iterator each(attempt / "comments", why), end; !why && each != end; each.increment(why))
    if (each->path().extension() == ".json") files.push_back(each->path());
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) {
    if (auto read = readFile(file))
      list.files.push_back(std::move(*read));
    else
      list.problems.push_back(std::move(read.error()));
  }
  std::stable_sort(list.files.begin(), list.files.end(), [](const CommentFile& a, const CommentFile& b) { return a.author < b.author; });
  return list;
}

}  // namespace ew
