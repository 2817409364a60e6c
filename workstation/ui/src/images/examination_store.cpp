#include "images/examination_store.h"

#include <QLocale>
#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>
#include <variant>

#include "ew/core/contract.h"
#include "ew/imaging/caption.h"
#include "ew/widgets/figures.h"
#include "ew/widgets/qt_image.h"
#include "ew/widgets/words.h"
#include "measure/worksheets/worksheets.h"
#include "scan/session.h"
#include "window/layout/window_text.h"

namespace ew::ui {
namespace {

std::chrono::sys_seconds secondsOf(const QDateTime& at) { return std::chrono::sys_seconds(std::chrono::seconds(at.toSecsSinceEpoch())); }

std::variant<GreyImage, RgbImage> stillPixelsOf(const QImage& image) {
  if (image.format() != QImage::Format_Grayscale8) return coloursOf(image);
  GreyImage grey(image.width(), image.height());
  for (int y = 0; y < image.height(); ++y) std::copy_n(image.constScanLine(y), image.width(), viewOf(grey).row(y));
  return grey;
}

}  // namespace

ExaminationFiles::StillRecord storedStill(const std::vector<SnapshotPart>& parts, const Snapshot& saved, int number, const QDateTime& at) {
  Still still;
  still.pixels = stillPixelsOf(saved.image);
  for (const auto& [session, image, strip] : saved.places) {
    const glm::ivec2 image_px(image.x(), image.y()), strip_px(strip.x(), strip.y()), stripSize_px(strip.width(), strip.height());
    const Knobs& knobs = session->imageKnobs();
    if (!image.isEmpty()) {
      still.regions.push_back(regionOf(session->geometry(), image_px));
      if (session->image().hasColour())
        if (auto box = regionOfColour(session->imageProbe(), knobs, session->geometry(), image_px)) still.regions.push_back(*box);
    }
    if (strip.isEmpty()) continue;
    const double sweep_s = strip.width() * session->seen().mMode().columnTime_s();
    if (knobs.mode == DisplayMode::spectrum && knobs.spectral)
      still.regions.push_back(
          regionOfSpectrum(session->imageProbe(), knobs, session->geometry(), stripSize_px, sweep_s, strip_px, image_px));
    else
      still.regions.push_back(regionOfStrip(stripSize_px, sweep_s, session->geometry().depth_mm, strip_px));
  }
  const auto inHand = std::find_if(parts.begin(), parts.end(), [](const SnapshotPart& part) { return part.isInHand; });
  EW_EXPECTS(inHand != parts.end());
  const Session& session = *inHand->session;
  return {std::move(still), imageOptions(session.imageProbe(), session.imageKnobs(), session.geometry(), number, secondsOf(at))};
}

QImage withWarning(const QImage& saved) {
  QImage marked = saved;
  if (marked.format() == QImage::Format_Grayscale8) {
    burnCaption(ImageView<std::uint8_t>{marked.bits(), marked.width(), marked.height(), marked.bytesPerLine()}, kNotForDiagnosis);
  } else {
    RgbImage colours = coloursOf(saved);
    burnCaption(viewOf(colours), kNotForDiagnosis);
    for (int y = 0; y < marked.height(); ++y)
      std::copy_n(viewOf(colours).row(y), marked.width(), reinterpret_cast<Rgb*>(marked.scanLine(y)));
  }
  return marked;
}

ExaminationStore::ExaminationStore(Session& session, Worksheets& worksheets, QObject* parent)
    : QObject(parent), session_(session), worksheets_(worksheets) {
  connect(&session_, &Session::patientReplaced, this, &ExaminationStore::clear);
  connect(&worksheets_, &Worksheets::changed, this, &ExaminationStore::changed);
  connect(&store_, &ImageStore::read, this, [this](const std::filesystem::path& folder, const std::vector<ImageStore::Kept>& images) {
    if (folder == store_.folder()) takeBack(images);
  });
  connect(&store_, &ImageStore::failed, this, [this](const std::string& instanceUid, const Error& problem) {
    for (Item& item : items_)
      if (item.still.options.instanceUid == instanceUid) item.isKept = false;
    Q_EMIT notKept(problem);
  });
}

bool ExaminationStore::store(const std::vector<SnapshotPart>& parts, int columns, const DicomStudy& study, const QDateTime& at) {
  Snapshot saved = savedImages(parts, columns, at);
  if (saved.image.isNull()) return false;
  if (!study_) study_ = study;
  const QString caption = WindowText::tr("%1, %2 cm, %3", "probe, depth and time of a stored image")
                              .arg(words(session_.imageProbe().name), figure(session_.geometry().depth_mm / 10.0, 1),
                                   QLocale().toString(at.time(), QLocale::ShortFormat));
  auto still = storedStill(parts, saved, ++number_, at);
  items_.push_back({std::move(saved.image), caption, std::move(still), ++revision_, false, !store_.folder().empty()});
  keep(items_.back());
  Q_EMIT changed();
  return true;
}

void ExaminationStore::remove(std::size_t item) {
  if (item >= items_.size()) return;
  store_.remove(items_[item].still.options.instanceUid);
  items_.erase(items_.begin() + static_cast<std::ptrdiff_t>(item));
  Q_EMIT changed();
}

std::size_t ExaminationStore::unsavedCount() const {
  return static_cast<std::size_t>(std::count_if(items_.begin(), items_.end(), [](const Item& item) { return !item.hasLeft; }));
}

std::size_t ExaminationStore::atRiskCount() const {
  return static_cast<std::size_t>(
      std::count_if(items_.begin(), items_.end(), [](const Item& item) { return !item.hasLeft && !item.isKept; }));
}

void ExaminationStore::setSaved(std::uint64_t revision) {
  for (Item& item : items_)
    if (item.revision <= revision && !std::exchange(item.hasLeft, true)) keep(item);
}

void ExaminationStore::keep(const Item& item) {
  if (!study_) return;
  store_.keep(item.image, {item.still.options, item.still.still.regions, item.caption.toStdString(), item.hasLeft, *study_});
}

void ExaminationStore::keepIn(const std::filesystem::path& folder) {
  if (folder == store_.folder()) return;
  store_.turnTo(folder);
  for (Item& item : items_) {
    item.isKept = !folder.empty();
    keep(item);
  }
  if (!items_.empty()) Q_EMIT changed();
}

/// What was stored of this patient before stands before what was stored since it was asked for.
void ExaminationStore::takeBack(const std::vector<ImageStore::Kept>& images) {
  std::vector<Item> before;
  for (const ImageStore::Kept& each : images) {
    const std::string& uid = each.about.options.instanceUid;
    if (std::any_of(items_.begin(), items_.end(), [&](const Item& item) { return item.still.options.instanceUid == uid; })) continue;
    ExaminationFiles::StillRecord still{{stillPixelsOf(each.image), each.about.regions}, each.about.options};
    before.push_back({each.image, QString::fromStdString(each.about.caption), std::move(still), ++revision_, each.about.hasLeft, true});
    number_ = std::max(number_, each.about.options.number);
    if (items_.empty()) study_ = each.about.study;  // the examination goes on
  }
  items_.insert(items_.begin(), std::make_move_iterator(before.begin()), std::make_move_iterator(before.end()));
  Q_EMIT changed();
}

bool ExaminationStore::isEmpty() const { return items_.empty() && worksheets_.filled().empty(); }

ExaminationFiles ExaminationStore::files(const DicomStudy& study, const QDateTime& at) {
  if (!study_) study_ = study;
  ExaminationFiles files{*study_, {}, {}};
  for (const Item& item : items_) files.images.push_back(item.still);
  for (const measurement::Examination* each : worksheets_.filled()) {
    measurement::Worksheet sheet = each->worksheet();
    std::string contents = toJson(sheet, "en").dump();
    ReportEntry& known = reports_[sheet.package];
    if (known.contents != contents) known = {std::move(contents), {std::move(sheet), newDicomUid(), secondsOf(at)}};
    files.reports.push_back(known.report);
  }
  return files;
}

void ExaminationStore::clear() {
  items_.clear();
  reports_.clear();
  study_.reset();
  number_ = 0;
  store_.turnTo({});
  Q_EMIT changed();
}

}  // namespace ew::ui
