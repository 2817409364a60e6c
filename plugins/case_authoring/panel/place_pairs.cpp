// The pairs of places of the panel by which a volume is placed, and who is asked to point at them.
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

#include "ew/widgets/labels.h"
#include "ew/widgets/look.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"
#include "panel/place_panel.h"

namespace ew::case_authoring {
namespace {

QString millimetres(double value) { return QLocale().toString(value, 'f', 1); }

}  // namespace

QWidget* PlacePanel::makePairs() {
  auto* box = new QWidget;
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kGrid_px);
  column->addWidget(
      quietLabel(tr("Point at the same places in the image and on the body: three at least, not on one line. A fourth shows "
                    "which one is wrong.")));
  pairs_ = new PairList;
  pairs_->setObjectName(QStringLiteral("pairList"));
  pairs_->onNamed = [this](std::size_t pair, const QString& name) {
    auto all = pairsIn(host_.caseParts().read(kPlacingPart));
    if (pair >= all.size()) return;
    all[pair].name = name.toStdString();
    editPairs(std::move(all), tr("Name a place"), "placing.name" + std::to_string(pair));
  };
  pairs_->onRemoved = [this](std::size_t pair) {
    stopAsking();
    auto all = pairsIn(host_.caseParts().read(kPlacingPart));
    if (pair >= all.size()) return;
    all.erase(all.begin() + static_cast<std::ptrdiff_t>(pair));
    editPairs(std::move(all), tr("Remove a place"));
  };
  pairs_->onInImage = [this](std::size_t pair, bool asks) { pointInImage(pair, asks); };
  pairs_->onOnBody = [this](std::size_t pair) { pointOnBody(pair); };
  pairs_->onLandmark = [this](std::size_t pair, const BodyLandmark& at) {
    stopAsking();
    auto all = pairsIn(host_.caseParts().read(kPlacingPart));
    if (pair >= all.size()) return;
    all[pair].world_mm = at.at_mm;
    all[pair].landmark = at.id;
    editPairs(std::move(all), tr("Choose a place on the body"));
  };
  column->addWidget(pairs_);
  fitWords_ = new QLabel;
  fitWords_->setObjectName(QStringLiteral("pairsFit"));
  fitWords_->setWordWrap(true);
  column->addWidget(fitWords_);
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(kGrid_px);
  auto* add = new QPushButton(tr("Add a place"));
  add->setObjectName(QStringLiteral("addPair"));
  connect(add, &QPushButton::clicked, this, [this] {
    auto all = pairsIn(host_.caseParts().read(kPlacingPart));
    all.emplace_back();
    editPairs(std::move(all), tr("Add a place"));
  });
  buttons->addWidget(add);
  buttons->addStretch(1);
  fit_ = new QPushButton(tr("Place by these"));
  fit_->setObjectName(QStringLiteral("placeByPairs"));
  setLook(fit_, Look::primary);
  connect(fit_, &QPushButton::clicked, this, [this] {
    if (const auto found = fitOf(pairsIn(host_.caseParts().read(kPlacingPart))); found.fit)
      place(found.fit->fileToWorld, tr("Place the volume by places"), {});
  });
  buttons->addWidget(fit_);
  column->addLayout(buttons);
  return box;
}

void PlacePanel::stopAsking() {
  const auto ends = std::exchange(asking_, nullptr);
  onSkin_->setChecked(false);
  if (!std::exchange(asked_, std::nullopt)) return;
  if (host_.cases().current()) showPairs();
}

void PlacePanel::showPairs() {
  const auto opened = host_.cases().current();
  if (!opened) return;
  const std::string& mannequin = opened->mannequin;
  if (!hasLandmarks_ || mannequin != landmarksOf_) {
    landmarksOf_ = mannequin;
    hasLandmarks_ = true;
    auto known = landmarksOf(mannequin);
    sites_ = known ? known->sites : std::vector<PlacingSite>();
    pairs_->setLandmarks(known ? std::move(known->landmarks) : std::vector<BodyLandmark>());
  }
  const auto pairs = pairsIn(host_.caseParts().read(kPlacingPart));
  const PairsFit found = fitOf(pairs);
  pairs_->show(pairs, found, asked_);
  const auto nameOfPair = [&](std::size_t n) { return pairs[n].name.empty() ? tr("Place %1").arg(n + 1) : words(pairs[n].name); };
  QString sentence;
  if (pairs.empty()) {
    sentence.clear();
  } else if (!found.fit) {
    sentence = words(found.fit.error());
  } else if (found.wrong) {
    sentence = tr("'%1' does not fit with the others: it lies %2 mm off and is left out. Point at it again. The others lie %3 mm apart on "
                  "average.")
                   .arg(nameOfPair(*found.wrong), millimetres(*found.residuals_mm[*found.wrong]), millimetres(found.fit->rms_mm));
  } else {
    sentence = tr("The places lie %1 mm apart on average; the worst is '%2' with %3 mm.")
                   .arg(millimetres(found.fit->rms_mm), nameOfPair(*found.worst), millimetres(*found.residuals_mm[*found.worst]));
  }
  fitWords_->setText(sentence);
  fitWords_->setForegroundRole(found.wrong ? QPalette::BrightText : QPalette::WindowText);
  fitWords_->setVisible(!sentence.isEmpty());
  fit_->setEnabled(found.fit.has_value());
  fit_->setToolTip(found.fit ? tr("Move the volume so that the places lie on each other as well as may be")
                             : tr("Three complete pairs are needed, not on one line"));
}

void PlacePanel::editPairs(std::vector<DraftPair> pairs, const QString& what, const std::string& mergeKey) {
  auto section = host_.caseParts().read(kPlacingPart);
  const auto next = withPairs(section, pairs);
  if (next == section) return showPairs();
  if (const auto done = host_.caseParts().edit(kPlacingPart, next, what.toStdString(), mergeKey); !done) say(done.error());
}

void PlacePanel::pointInImage(std::size_t pair, bool asks) {
  stopAsking();
  if (!asks) return;
  if (!placed()) {
    showPairs();
    setProblem(problem_, tr("The volume of this case is not what is scanned at the moment; choose View, Scan the case's volume."));
    return;
  }
  asked_ = PairList::Asked{pair, true};
  asking_ = host_.scan().askForPoint(
      tr("Click the place in the image; move the probe before, if it is not to be seen. Escape ends.").toStdString(),
      [this, pair](const Point<frame::Probe>& at) { takeImagePoint(pair, at); }, [this] { stopAsking(); });
  showPairs();
}

void PlacePanel::takeImagePoint(std::size_t pair, const Point<frame::Probe>& at) {
  const auto now = placed();
  const auto image = host_.scan().state();
  stopAsking();
  auto all = pairsIn(host_.caseParts().read(kPlacingPart));
  if (!now || !image || pair >= all.size()) return;
  all[pair].file_mm = carried(rigidInverse(now->fileToWorld), (image->pose.probeToWorld * at).at);
  editPairs(std::move(all), tr("Point at a place in the volume"));
}

void PlacePanel::pointOnBody(std::size_t pair) {
  stopAsking();
  asked_ = PairList::Asked{pair, false};
  asking_ = host_.overlays().askForBodyPoint(
      tr("Click the place on the body. Escape ends.").toStdString(),
      [this, pair](const Point<frame::World>& at) {
        stopAsking();
        auto all = pairsIn(host_.caseParts().read(kPlacingPart));
        if (pair >= all.size()) return;
        all[pair].world_mm = at.at;
        all[pair].landmark.clear();
        editPairs(std::move(all), tr("Point at a place on the body"));
      },
      [this] { stopAsking(); });
  showPairs();
}

}  // namespace ew::case_authoring
