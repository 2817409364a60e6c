#include "start/case_details.h"

#include <QPointer>

#include "ew/core/progress.h"
#include "ew/core/quiet_work.h"
#include "ew/library/case_card.h"
#include "ew/scanning/subject.h"
#include "ew/widgets/words.h"
#include "start/thumbnails.h"

namespace ew::ui {
namespace {

const QSize kImage_px(kCardImageWidth_px, kCardImageHeight_px);
constexpr int kQuiet = 10;  // a card is no reason to make the scan wait

/// Goes on until the program ends.
class UntilTheEnd final : public Progress {
 public:
  explicit UntilTheEnd(const std::atomic<bool>& ends) : ends_(ends) {}
  void report(const Message&, double) override {}
  [[nodiscard]] bool cancelRequested() const override { return ends_; }

 private:
  const std::atomic<bool>& ends_;
};

}  // namespace

CaseDetails::CaseDetails(QObject* parent) : QObject(parent) {}

CaseDetails::~CaseDetails() { ends_ = true; }

void CaseDetails::want(const QStringList& folders) {
  const int round = ++round_;
  for (const QString& folder : folders) {
    if (known_.contains(folder)) continue;
    ++waiting_;
    worker_.add([this, folder, round, epoch = epoch_] { readOne(folder, round, epoch); });
  }
}

void CaseDetails::forget() {
  ++round_;
  ++epoch_;
  known_.clear();
}

const Case* CaseDetails::of(const QString& folder) const {
  const auto found = known_.constFind(folder);
  return found != known_.constEnd() && *found ? &**found : nullptr;
}

/// On the worker's thread.
void CaseDetails::readOne(const QString& folder, int round, int epoch) {
  auto read = std::make_shared<Read>();
  read->folder = folder;
  const bool isWanted = round == round_ && !ends_;
  if (isWanted) {
    if (auto opened = loadCase(pathOf(folder))) read->opened = std::move(*opened);
    if (read->opened) {
      read->image = keptThumbnail(*read->opened, kImage_px);
      // A start page is no reason to compute for minutes.
      if (read->image.isNull() && caseNeedsPreparation(*read->opened)) {
        read->image = broughtThumbnail(*read->opened);
      } else if (read->image.isNull()) {
        if (there_.probes.empty())
          if (auto there = beginningsThere()) there_ = std::move(*there);
        const QuietWork quietly(kQuiet);
        UntilTheEnd progress(ends_);
        if (auto contents = readContents(*read->opened, progress)) {
          read->image = thumbnailOf(subjectOf(*read->opened, *contents), there_, kImage_px);
          keepThumbnail(*read->opened, read->image);
        }
      }
    }
  }
  if (!ends_)
    QMetaObject::invokeMethod(
        this, [this, read, epoch = isWanted ? epoch : -1] { take(*read, epoch); }, Qt::QueuedConnection);
}

void CaseDetails::take(const Read& read, int epoch) {
  --waiting_;
  if (epoch == epoch_) {
    known_.insert(read.folder, read.opened);
    if (!read.image.isNull()) Q_EMIT imageRead(read.folder, read.image);
    Q_EMIT caseRead(read.folder);
  }
  if (waiting_ == 0) Q_EMIT rested();
}

}  // namespace ew::ui
