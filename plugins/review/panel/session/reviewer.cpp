#include "panel/session/reviewer.h"

#include <QSettings>

#include "ew/library/folders.h"
#include "ew/widgets/words.h"

namespace ew::review {

namespace {

const QString kReviewerSetting = QStringLiteral("review/reviewer");
const QString kNamesSetting = QStringLiteral("review/names");

}  // namespace

Reviewer::Reviewer() {
  name_ = QSettings().value(kReviewerSetting).toString();
  showsNames_ = QSettings().value(kNamesSetting, false).toBool();
}

void Reviewer::setName(const QString& name) {
  name_ = name;
  QSettings().setValue(kReviewerSetting, name);
}

void Reviewer::setShowsNames(bool names) {
  if (names == showsNames_) return;
  showsNames_ = names;
  QSettings().setValue(kNamesSetting, names);
  Q_EMIT namesChanged();
}

const Pseudonyms* Reviewer::codes() const {
  if (!codes_)
    if (auto read = Pseudonyms::ofLibrary(libraryFolder())) codes_ = *read;
  return codes_ ? &*codes_ : nullptr;
}

QString Reviewer::called(const std::string& reviewer) const {
  if (showsNames_) return reviewer.empty() ? tr("somebody") : words(reviewer);
  return codes() != nullptr ? words(codes()->ofReviewer(reviewer)) : tr("without a code");
}

QString Reviewer::personOf(const Attempt& tried) const {
  if (showsNames_) return tried.person.empty() ? tr("without a name") : words(tried.person);
  return codes() != nullptr ? words(codes_->ofPerson(tried.person)) : tr("without a code");
}

}  // namespace ew::review
