#include "annotate/image_annotations.h"

#include <QLocale>
#include <QPointF>
#include <QSettings>

namespace ew::ui {
namespace {

using annotation::AnnotationList;

const auto kHomeSetting = QStringLiteral("annotationHome");

annotation::HomePosition keptHome() {
  const annotation::HomePosition usual;
  const QPointF kept = QSettings().value(kHomeSetting, QPointF(usual.share.x, usual.share.y)).toPointF();
  return limited(annotation::HomePosition{{kept.x(), kept.y()}});
}

}  // namespace

ImageAnnotations::ImageAnnotations(Session& session, QObject* parent) : QObject(parent), session_(session), home_(keptHome()) {
  connect(&session_, &Session::imageChanged, this, &ImageAnnotations::look);
  connect(&session_, &Session::subjectReplaced, this, &ImageAnnotations::forget);
  connect(&session_, &Session::frozenChanged, this, [this](bool frozen) {
    if (!frozen && !session_.isPlaying()) forget();
  });
}

void ImageAnnotations::setWordLists(std::vector<annotation::WordList> lists) {
  wordLists_ = std::move(lists);
  showTerms();
}

void ImageAnnotations::setRegion(const std::string& region) {
  if (region == region_) return;
  region_ = region;
  chosen_.clear();  // another patient, another examination
  showTerms();
}

void ImageAnnotations::chooseList(const std::string& id) {
  if (id == chosen_) return;
  chosen_ = id;
  showTerms();
}

const annotation::WordList* ImageAnnotations::wordList() const { return wordListOf(wordLists_, chosen_.empty() ? region_ : chosen_); }

std::vector<const annotation::WordList*> ImageAnnotations::commonLists() const {
  std::vector<const annotation::WordList*> common;
  for (const annotation::WordList& list : wordLists_)
    if (list.regions.empty()) common.push_back(&list);
  return common;
}

void ImageAnnotations::showTerms() { terms_ = termsFor(wordLists_, chosen_.empty() ? region_ : chosen_, QLocale().name().toStdString()); }

bool ImageAnnotations::hold() {
  if (!session_.subject() || session_.image().isEmpty()) return false;
  if (session_.imageKnobs().mode == DisplayMode::mMode) {
    Q_EMIT said(tr("Words and arrows belong to the image, not to the strip of the M-mode. Switch to B or B + M."));
    return false;
  }
  Q_EMIT pauseAsked();
  if (!session_.isPlaying()) session_.setFrozen(true);
  lists_.turnTo(stillOf(session_));
  return true;
}

void ImageAnnotations::takeArrow() {
  if (isArrowAtHand_) return putDown();
  if (!hold()) return;
  isArrowAtHand_ = true;
  selected_ = 0;
  Q_EMIT changed();
}

void ImageAnnotations::putDown() {
  if (!isArrowAtHand_) return;
  isArrowAtHand_ = false;
  Q_EMIT changed();
}

void ImageAnnotations::exchange(ImageAnnotations& other) {
  std::swap(lists_, other.lists_);
  std::swap(wasWrittenLast_, other.wasWrittenLast_);
  for (ImageAnnotations* each : {this, &other}) {
    each->isArrowAtHand_ = false;
    each->selected_ = 0;
  }
}

void ImageAnnotations::change(const std::function<void(AnnotationList&)>& edit) {
  edit(lists_.now());
  if (list().now().find(selected_) == nullptr) selected_ = 0;
  wasWrittenLast_ = true;
  Q_EMIT changed();
}

void ImageAnnotations::select(int number) {
  if (number == selected_) return;
  selected_ = number;
  Q_EMIT changed();
}

void ImageAnnotations::setHome(const annotation::HomePosition& home) {
  home_ = limited(home);
  QSettings().setValue(kHomeSetting, QPointF(home_.share.x, home_.share.y));
}

void ImageAnnotations::look() {
  if (!lists_.image()) return;
  if (!session_.isFrozen() && !session_.isPlaying()) return forget();
  if (!lists_.turnTo(stillOf(session_))) return;
  selected_ = 0;
  Q_EMIT changed();
}

void ImageAnnotations::forget() {
  if (!lists_.forget()) return;
  isArrowAtHand_ = false;
  selected_ = 0;
  Q_EMIT changed();
}

}  // namespace ew::ui
