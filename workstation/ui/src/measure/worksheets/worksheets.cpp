#include "measure/worksheets/worksheets.h"

#include <algorithm>

#include "ew/widgets/words.h"
#include "measure/calipers/calipers.h"
#include "scan/session.h"

namespace ew::ui {

using measurement::Examination;
using measurement::Package;

Worksheets::Worksheets(Session& session, Calipers& calipers, QObject* parent) : QObject(parent), calipers_(calipers) {
  connect(&calipers_, &Calipers::linesChanged, this, &Worksheets::take);
  connect(&calipers_, &Calipers::changed, this, &Worksheets::sayRefused);
  connect(&session, &Session::patientReplaced, this, &Worksheets::clear);
}

void Worksheets::setPackages(std::vector<Package> packages) {
  packages_.clear();
  for (Package& package : packages) packages_.push_back(std::make_shared<const Package>(std::move(package)));
  Q_EMIT packagesChanged();
}

void Worksheets::choose(const std::string& id) {
  const auto found = std::find_if(packages_.begin(), packages_.end(), [&](const auto& package) { return package->id == id; });
  Examination* chosen = found != packages_.end() ? &examinations_.try_emplace(id, *found).first->second : nullptr;
  if (chosen == current_) return;
  current_ = chosen;
  take();
  Q_EMIT changed();
}

void Worksheets::change(const std::function<void(Examination&)>& edit) {
  EW_EXPECTS(current_ != nullptr);
  edit(*current_);
  Q_EMIT changed();
}

void Worksheets::measure(const std::string& item, const std::string& side) {
  if (current_ == nullptr) return;
  if (const measurement::PackageItem* asked = current_->package().item(item)) calipers_.takeFor(*asked, side);
  Q_EMIT changed();  // an item checks itself, whatever came of it
  if (const QString remark = whyNotSide ? whyNotSide(side) : QString(); !remark.isEmpty() && calipers_.drawing().tool())
    Q_EMIT said(remark);
}

void Worksheets::take() {
  if (current_ == nullptr) return;
  std::vector<Message> remarks;
  const auto enter = [&](std::uint64_t image, Where where) {
    auto said = current_->measuredIn(image, calipers_.drawingIn(where).shown(), calipers_.uncertainty(where));
    remarks.insert(remarks.end(), said.begin(), said.end());
  };
  const auto image = calipers_.image();
  if (image) enter(*image, Where::image);
  enter(calipers_.strip(), Where::strip);
  if (image || !remarks.empty()) refused_ = remarks.empty() ? QString() : words(remarks.back());
  Q_EMIT changed();
}

void Worksheets::sayRefused() {
  if (calipers_.drawing().isDragging() || refused_ == said_) return;
  said_ = refused_;
  if (!said_.isEmpty()) Q_EMIT said(said_);
}

const Examination* Worksheets::unsaved() const {
  for (const auto& [id, examination] : examinations_) {
    const auto saved = saved_.find(id);
    if (!examination.isEmpty() && (saved == saved_.end() || !(saved->second == examination))) return &examination;
  }
  return nullptr;
}

std::vector<const Examination*> Worksheets::filled() const {
  std::vector<const Examination*> all;
  for (const auto& [id, examination] : examinations_)
    if (!examination.isEmpty()) all.push_back(&examination);
  return all;
}

void Worksheets::setSaved(const std::vector<const Examination*>& written) {
  for (const Examination* each : written) saved_.insert_or_assign(each->package().id, *each);
}

void Worksheets::keepIn(MeasurementWork& work) const {
  for (const Examination* each : filled()) {
    MeasurementWork::Sheet sheet{each->package().id, each->gestation_weeks(), each->answers(), {}};
    for (const Examination::Found& found : each->found()) sheet.found.emplace_back(found.image, found.number);
    work.sheets.push_back(std::move(sheet));
  }
  work.current = current_ != nullptr ? current_->package().id : std::string();
}

void Worksheets::restore(const MeasurementWork& work) {
  current_ = nullptr;
  examinations_.clear();
  saved_.clear();
  for (const MeasurementWork::Sheet& sheet : work.sheets) {
    const auto package = std::find_if(packages_.begin(), packages_.end(), [&](const auto& each) { return each->id == sheet.package; });
    if (package == packages_.end()) continue;
    Examination& filled = examinations_.try_emplace(sheet.package, *package).first->second;
    for (const ImageMeasurements& image : work.images) {
      measurement::Measurements inSheet = image.measurements;
      std::erase_if(inSheet.all, [&](const measurement::Measurement& each) {
        return std::find(sheet.found.begin(), sheet.found.end(), std::pair(image.image, each.number)) == sheet.found.end();
      });
      static_cast<void>(filled.measuredIn(image.image, inSheet, Calipers::uncertaintyIn(image)));
    }
    for (const Examination::Answer& answer : sheet.answers) filled.answer(answer.label, answer.side, answer.choice);
    filled.setGestation(sheet.gestation_weeks);
  }
  choose(work.current);
  Q_EMIT changed();
}

void Worksheets::clear() {
  const std::string id = current_ != nullptr ? current_->package().id : std::string();
  current_ = nullptr;
  examinations_.clear();
  saved_.clear();
  choose(id);  // the same kind of examination, of another patient
  Q_EMIT changed();
}

}  // namespace ew::ui
