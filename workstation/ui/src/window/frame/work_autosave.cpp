#include "window/frame/work_autosave.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ew/core/json_fields.h"
#include "ew/io/json_files.h"
#include "ew/io/volume_file.h"
#include "ew/scanning/recording_journal.h"
#include "ew/widgets/words.h"
#include "measure/calipers/calipers.h"
#include "measure/worksheets/worksheets.h"
#include "scan/cine/recorder.h"
#include "scan/session.h"

namespace ew::ui {
namespace {

using nlohmann::json;

constexpr int kKeepMeasuredAfter_ms = 400;
constexpr std::size_t kLongestMeasured_bytes = 64u << 20;
constexpr const char* kRecordingItem = "recording.jsonl";
constexpr const char* kMeasuredItem = "measured.json";
constexpr const char* kVolumeBeginning = "volume-";
constexpr const char* kCoverageEnding = "-coverage.mha";

std::string journalOf(const ScanRecording& recording) { return journalHead(recording) + journalLines(recording.log, 0); }

/// "3:07"
QString minutesOf(const ScanRecording& recording) {
  const int seconds = static_cast<int>(std::lround(recording.log.end_s() - recording.log.begin_s()));
  return QStringLiteral("%1:%2").arg(seconds / 60).arg(seconds % 60, 2, 10, QLatin1Char('0'));
}

Result<MeasurementWork> readMeasured(const std::filesystem::path& file) {
  const Message where = verbatim(file.string());
  const auto document = readJsonFile(file, where, kLongestMeasured_bytes);
  if (!document) return passOn(document.error());
  JsonReading reading(where);
  const JsonFields fields(*document, reading);
  const auto states = recordingFromJournal(fields.text("states", "", 0, kLongestMeasured_bytes), where);
  const JsonFields work = fields.object("work");
  if (reading.problem()) return passOn(*reading.problem());
  if (const auto* images = work.find("images"); !states && images != nullptr && !images->empty()) return passOn(states.error());
  return measuredWorkFrom(work.value(), states ? *states : ScanRecording{}, where);
}

}  // namespace

WorkAutosave::WorkAutosave(const std::filesystem::path& root, Session& session, Recorder& recorder, Calipers& calipers,
                           Worksheets& worksheets, QObject* parent)
    : QObject(parent),
      session_(session),
      recorder_(recorder),
      calipers_(calipers),
      worksheets_(worksheets),
      kept_(root, [this](const Error& problem) {
        QMetaObject::invokeMethod(
            this, [this, problem] { Q_EMIT failed(problem); }, Qt::QueuedConnection);
      }) {
  keepSoon_.setSingleShot(true);
  keepSoon_.setInterval(kKeepMeasuredAfter_ms);
  connect(&keepSoon_, &QTimer::timeout, this, &WorkAutosave::keepMeasured);
  connect(&recorder_, &Recorder::changed, this, &WorkAutosave::grow);
  connect(&calipers_, &Calipers::linesChanged, this, &WorkAutosave::follow);
  connect(&calipers_, &Calipers::changed, this, [this] {
    if (!images_.empty() && !keepSoon_.isActive()) keepSoon_.start();  // a result over several may have changed
  });
  connect(&worksheets_, &Worksheets::changed, this, [this] {
    if (!keepSoon_.isActive()) keepSoon_.start();
  });
  connect(&session_, &Session::patientReplaced, this, [this] {
    images_.clear();
    path_.clear();
    isDescribed_ = false;
    keepMeasured();
  });
}

WorkAutosave::~WorkAutosave() = default;

void WorkAutosave::describe() {
  if (std::exchange(isDescribed_, true)) return;
  json about = {{"kind", kWindowWork}, {"path", path_.toStdString()}, {"volumes", json::array()}};
  if (const auto& subject = session_.subject()) about["title"] = words(subject->title).toStdString();
  for (const VolumeAutosave& each : volumes_)
    about["volumes"].push_back({{"path", each.made.path.toStdString()},
                                {"title", each.made.title.toStdString()},
                                {"item", each.item},
                                {"shown", each.made.isShown}});
  kept_.describe(std::move(about));
}

void WorkAutosave::setOpen(const QString& path) {
  path_ = path;
  isDescribed_ = false;
  if (isRecordingKept_ || isMeasuredKept_ || !volumes_.empty()) describe();
}

void WorkAutosave::grow() {
  if (const ScanRecording* now = recorder_.growing()) append(*now);
}

void WorkAutosave::append(const ScanRecording& recording) {
  if (recording.log.frameCount() == 0) return;  // its size is not known yet
  if (std::exchange(growing_, &recording) != &recording) {
    events_ = 0;
    kept_.remove(kRecordingItem);
  }
  if (events_ == recording.log.events().size()) return;
  describe();
  kept_.append(kRecordingItem, (events_ == 0 ? journalHead(recording) : std::string()) + journalLines(recording.log, events_));
  events_ = recording.log.events().size();
  isRecordingKept_ = true;
}

void WorkAutosave::takeRecording(const std::shared_ptr<const ScanRecording>& recording) {
  if (!recording) return dropRecording();
  if (growing_ == recording.get()) {
    append(*recording);
  } else {
    describe();
    kept_.replace(kRecordingItem, [recording]() -> Result<std::string> { return journalOf(*recording); });
    isRecordingKept_ = true;
  }
  growing_ = nullptr;
}

void WorkAutosave::dropRecording() {
  growing_ = nullptr;
  if (std::exchange(isRecordingKept_, false)) kept_.remove(kRecordingItem);
}

void WorkAutosave::setVolumes(const std::vector<SessionVolume>& volumes) {
  const auto isKnown = [](const SessionVolume& a, const SessionVolume& b) { return a.volume == b.volume && a.isShown == b.isShown; };
  if (std::equal(volumes.begin(), volumes.end(), volumes_.begin(), volumes_.end(),
                 [&](const SessionVolume& a, const VolumeAutosave& b) { return isKnown(a, b.made); }))
    return;
  std::vector<VolumeAutosave> now;
  for (const SessionVolume& each : volumes) {
    const auto known =
        std::find_if(volumes_.begin(), volumes_.end(), [&](const VolumeAutosave& one) { return one.made.volume == each.volume; });
    now.push_back({each, known != volumes_.end() ? known->item : kVolumeBeginning + std::to_string(nextVolume_++) + ".mha"});
  }
  const std::vector<VolumeAutosave> before = std::exchange(volumes_, std::move(now));
  isDescribed_ = false;
  describe();
  for (const VolumeAutosave& each : before)
    if (std::none_of(volumes_.begin(), volumes_.end(), [&](const VolumeAutosave& one) { return one.item == each.item; }))
      for (const std::string& item : {each.item, each.item + kCoverageEnding}) kept_.remove(item);
  for (const VolumeAutosave& each : volumes_) {
    if (std::any_of(before.begin(), before.end(), [&](const VolumeAutosave& one) { return one.item == each.item; })) continue;
    const auto volume = each.made.volume;
    kept_.replaceFile(each.item, volume->echo.size(), [volume](const std::filesystem::path& file) { return writeVolume(*volume, file); });
    if (!volume->coverage.empty())
      kept_.replaceFile(each.item + kCoverageEnding, volume->coverage.size(),
                        [volume](const std::filesystem::path& file) { return writeCoverage(*volume, file); });
  }
}

void WorkAutosave::follow() {
  if (const auto image = calipers_.image()) remember(*image, calipers_.drawingIn(Where::image).shown());
  remember(calipers_.strip(), calipers_.drawingIn(Where::strip).shown());
  if (!keepSoon_.isActive()) keepSoon_.start();
}

void WorkAutosave::remember(std::uint64_t image, const measurement::Measurements& shown) {
  const auto known = std::find_if(images_.begin(), images_.end(), [&](const ImageMeasurements& each) { return each.image == image; });
  if (shown.all.empty()) {
    if (known != images_.end()) images_.erase(known);
  } else if (known != images_.end()) {
    known->measurements = shown;
  } else {
    images_.push_back({image, session_.shownState(), session_.geometry(), shown});
  }
}

MeasurementWork WorkAutosave::measured() const {
  MeasurementWork work;
  work.images = images_;
  worksheets_.keepIn(work);
  work.combinations = calipers_.findings().combinations();
  return work;
}

void WorkAutosave::restore(const MeasurementWork& work) {
  images_ = work.images;
  keepMeasured();
}

void WorkAutosave::keepMeasured() {
  keepSoon_.stop();
  MeasurementWork work = measured();
  if (work.isEmpty()) {
    if (std::exchange(isMeasuredKept_, false)) kept_.remove(kMeasuredItem);
    return;
  }
  describe();
  isMeasuredKept_ = true;
  kept_.replace(kMeasuredItem, [work = std::move(work)]() -> Result<std::string> {
    const ScanRecording states = statesOf(work);
    return json{{"work", jsonOf(work)}, {"states", journalOf(states)}}.dump(-1, ' ', false, json::error_handler_t::replace);
  });
}

void WorkAutosave::forget() {
  keepSoon_.stop();
  isRecordingKept_ = isMeasuredKept_ = isDescribed_ = false;
  growing_ = nullptr;
  volumes_.clear();
  kept_.forget();
  kept_.flush();
}

RecoverableWork readLeftWork(Autosave::Left kept) {
  RecoverableWork work(std::move(kept));
  const Autosave::Left& left = *work.left;
  JsonReading reading(verbatim(left.folder().string()));
  const JsonFields about(left.about(), reading);
  work.kind = about.text("kind", "", 0);
  work.path = QString::fromStdString(about.text("path", "", 0, 10000));
  work.title = QString::fromStdString(about.text("title", "", 0, 10000));
  for (const JsonFields& each : about.objects("volumes", 0, 1000)) {
    const std::string item = each.text("item");
    const bool isThere = reading.good() && item.find('/') == std::string::npos && left.has(item);
    work.volumes.push_back({QString::fromStdString(each.text("path", "", 0, 10000)),
                            QString::fromStdString(each.text("title", "", 0, 10000)), isThere ? left.fileOf(item) : std::filesystem::path(),
                            each.flag("shown", false)});
  }
  if (about.has("step")) {
    const JsonFields step = about.object("step");
    work.step =
        RecoverableWork::Step{step.text("lesson"), QString::fromStdString(step.text("title", "", 0, 10000)),
                              static_cast<int>(step.whole("number", 1, 10000, 1)), static_cast<int>(step.whole("count", 1, 10000, 1))};
  }
  if (reading.problem()) {  // what was read before it counts
    if (!left.items().empty()) work.unread.push_back(reading.problem()->message);
    return work;
  }
  if (left.has(kRecordingItem)) {
    if (auto recording = readJournal(left.fileOf(kRecordingItem))) {
      work.unread = recording->notes;
      work.recording = std::make_shared<const ScanRecording>(std::move(*recording));
    } else if (recording.error().code != ErrorCode::truncated) {
      work.unread.push_back(recording.error().message);
    }
  }
  if (left.has(kMeasuredItem)) {
    if (auto measured = readMeasured(left.fileOf(kMeasuredItem)))
      work.measured = std::move(*measured);
    else
      work.unread.push_back(measured.error().message);
  }
  // Volumes that are not described were given up; anything else is what a newer program keeps.
  for (const std::string& item : left.items())
    if (work.kind == kWindowWork && item != kRecordingItem && item != kMeasuredItem && !item.starts_with(kVolumeBeginning))
      work.unread.push_back(verbatim(left.fileOf(item).string()));
  return work;
}

QStringList linesOf(const RecoverableWork& work) {
  QStringList lines;
  if (work.recording)
    lines << (work.kind == kExpertScanWork ? WorkAutosave::tr("An expert's scan that was being recorded for a lesson: %1 min")
                                           : WorkAutosave::tr("A recording of the scan: %1 min"))
                 .arg(minutesOf(*work.recording));
  if (!work.measured.images.empty()) lines << WorkAutosave::tr("What was measured, on images: %1").arg(work.measured.images.size());
  if (!work.measured.sheets.empty()) lines << WorkAutosave::tr("Worksheets with values: %1").arg(work.measured.sheets.size());
  for (const RecoverableWork::VolumeDraft& each : work.volumes)
    lines << (each.file.empty() ? WorkAutosave::tr("The volume made from '%1' was too large to be kept, and has to be made again.")
                                : WorkAutosave::tr("The volume made from '%1'"))
                 .arg(each.title);
  if (work.step)
    lines << WorkAutosave::tr("The lesson '%1', in step %2 of %3")
                 .arg(work.step->title, QString::number(work.step->number), QString::number(work.step->count));
  for (const Message& why : work.unread) lines << words(why);
  return lines;
}

}  // namespace ew::ui
