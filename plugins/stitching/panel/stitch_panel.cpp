#include "panel/stitch_panel.h"

#include <QApplication>
#include <QComboBox>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFormLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QLocale>
#include <QMimeData>
#include <QPainter>
#include <QStackedWidget>
#include <QStyledItemDelegate>
#include <QUrl>
#include <algorithm>

#include "panel/look.h"

namespace ew::stitching {
namespace {

namespace fs = std::filesystem;
using sdk::kGap_px;
using sdk::words;

constexpr int kRow_px = 44;
constexpr int kJobRoom_px = 104;  // a card of the window's jobs fits in

QString mebibytes(double bytes) {
  const double mib = bytes / (1024.0 * 1024.0);
  return mib < 1024.0 ? QStringLiteral("%1 MiB").arg(QLocale().toString(mib, 'f', mib < 10.0 ? 1 : 0))
                      : QStringLiteral("%1 GiB").arg(QLocale().toString(mib / 1024.0, 'f', 1));
}

QString sizeOf(const Grid& grid) { return QStringLiteral("%1 × %2 × %3").arg(grid.dims.x).arg(grid.dims.y).arg(grid.dims.z); }

enum Role { kLine = Qt::UserRole, kMark, kBroken };

/// Letter, name, size and where it lies; at the right what holds it.
class VolumeDelegate final : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override { return {200, kRow_px}; }
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    const QRect box = option.rect;
    const QPalette& colours = option.palette;
    if (option.state.testFlag(QStyle::State_Selected)) {
      painter->setPen(Qt::NoPen);
      painter->setBrush(colours.color(QPalette::Button));
      painter->drawRoundedRect(box.adjusted(2, 1, -2, -1), 4, 4);
    }
    if (option.state.testFlag(QStyle::State_HasFocus)) {
      painter->setPen(QPen(colours.color(QPalette::Highlight), 1.0));
      painter->setBrush(Qt::NoBrush);
      painter->drawRoundedRect(QRectF(box).adjusted(2.5, 1.5, -2.5, -1.5), 4, 4);
    }
    const QRectF badge(box.left() + 10, box.top() + 11, 22, 22);
    painter->setPen(QPen(colourOf(colourOfView(static_cast<std::size_t>(index.row()))), 2.0));
    painter->setBrush(Qt::NoBrush);
    painter->drawEllipse(badge.adjusted(1, 1, -1, -1));
    QFont font = option.font;
    font.setPixelSize(12);
    painter->setFont(font);
    painter->setPen(colours.color(QPalette::WindowText));
    painter->drawText(badge, Qt::AlignCenter, words(letterOf(static_cast<std::size_t>(index.row()))));
    const int left = box.left() + 42;
    const int wide = box.right() - 32 - left;
    font.setPixelSize(13);
    painter->setFont(font);
    painter->drawText(QRect(left, box.top() + 4, wide, 18), Qt::AlignLeft | Qt::AlignVCenter,
                      QFontMetrics(font).elidedText(index.data(Qt::EditRole).toString(), Qt::ElideMiddle, wide));
    font.setPixelSize(12);
    painter->setFont(font);
    painter->setPen(colours.color(index.data(kBroken).toBool() ? QPalette::BrightText : QPalette::PlaceholderText));
    painter->drawText(QRect(left, box.top() + 22, wide, 18), Qt::AlignLeft | Qt::AlignVCenter,
                      QFontMetrics(font).elidedText(index.data(kLine).toString(), Qt::ElideRight, wide));
    drawMark(*painter, QRectF(box.right() - 27, box.top() + 15, 14, 14), static_cast<StitchSession::Mark>(index.data(kMark).toInt()),
             colours);
    painter->restore();
  }
  void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option, const QModelIndex&) const override {
    editor->setGeometry(option.rect.adjusted(38, 6, -8, -6));
  }
};

class LegendMark final : public QWidget {
 public:
  explicit LegendMark(StitchSession::Mark mark) : mark_(mark) { setFixedSize(40, 14); }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QPen pen(colourOfMark(mark_, palette()), 2.0);
    if (mark_ == StitchSession::Mark::cannotTell) pen.setDashPattern({4.0, 3.0});
    if (mark_ == StitchSession::Mark::notAligned) pen.setDashPattern({1.5, 2.0});
    painter.setPen(pen);
    painter.drawLine(QPointF(0, 7.5), QPointF(20, 7.5));
    drawMark(painter, QRectF(25, 1, 13, 13), mark_, palette());
  }

 private:
  StitchSession::Mark mark_;
};

}  // namespace

StitchPanel::StitchPanel(StitchSession& session, QWidget* parent) : QWidget(parent), session_(session) {
  setObjectName(QStringLiteral("stitchPanel"));
  setAcceptDrops(true);
  setMinimumWidth(280);
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(0, 0, 0, 0);
  auto* room = new PlainHeight;
  outer->addWidget(room);
  auto* column = new QVBoxLayout(room);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  offer_ = makeOffer();
  column->addWidget(offer_);
  pages_ = new QStackedWidget(this);
  auto* add = new QPushButton(tr("Add volumes…"));
  add->setObjectName(QStringLiteral("addFirst"));
  connect(add, &QPushButton::clicked, this, &StitchPanel::askForFiles);
  pages_->addWidget(sdk::emptyState(
      tr("Weave volumes into one"),
      tr("Add two or more volumes or sweeps that overlap, or drop their files or a stitch project here. No tracker is needed."), add));
  pages_->addWidget(makeWorkPage());
  column->addWidget(pages_, 1);
  problem_ = sdk::problemLabel(this);
  problem_->setObjectName(QStringLiteral("problem"));
  problem_->setContentsMargins(2 * kGap_px, kGap_px, 2 * kGap_px, kGap_px);
  column->addWidget(problem_);
  jobRoom_ = new QWidget;
  jobRoom_->setFixedHeight(kJobRoom_px);
  jobRoom_->hide();
  column->addWidget(jobRoom_);
  connect(&session_, &StitchSession::changed, this, &StitchPanel::refresh);
  connect(&session_, &StitchSession::problem, this, [this](const QString& sentence) { sdk::setProblem(problem_, sentence); });
  connect(&session_, &StitchSession::said, this, [this](const QString& sentence) {
    outcome_->say(sentence);
    outcome_->setVisible(!sentence.isEmpty());
  });
  connect(&session_, &StitchSession::nextPairAsked, graph_, &PairGraph::chooseNext);
  refresh();
}

QWidget* StitchPanel::makeOffer() {
  auto* box = new QWidget;
  box->setObjectName(QStringLiteral("recoveryOffer"));
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(2 * kGap_px, 2 * kGap_px, 2 * kGap_px, kGap_px);
  offerWord_ = new QLabel;
  offerWord_->setWordWrap(true);
  column->addWidget(offerWord_);
  auto* row = new QHBoxLayout;
  auto* reopen = new QPushButton(tr("Reopen"));
  reopen->setObjectName(QStringLiteral("reopenLeft"));
  reopen->setProperty("primary", true);
  connect(reopen, &QPushButton::clicked, &session_, &StitchSession::reopenLeft);
  auto* discard = new QPushButton(tr("Discard"));
  discard->setObjectName(QStringLiteral("discardLeft"));
  connect(discard, &QPushButton::clicked, &session_, &StitchSession::discardLeft);
  row->addWidget(reopen);
  row->addWidget(discard);
  row->addStretch(1);
  column->addLayout(row);
  return box;
}

QWidget* StitchPanel::makeWorkPage() {
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(2 * kGap_px, kGap_px, 2 * kGap_px, kGap_px);
  column->setSpacing(kGap_px);

  const auto flat = [this](const QString& text, const QString& hint, const char* name) {
    auto* button = new QPushButton(text);
    button->setProperty("flat", true);
    button->setToolTip(hint);
    button->setObjectName(QLatin1String(name));
    return button;
  };
  auto* top = new QHBoxLayout;
  top->setSpacing(0);
  top->addWidget(sdk::headingLabel(tr("Subvolumes")), 1);
  saveProject_ = flat(tr("save"), tr("Save the stitch project; the command line runs it identically (Ctrl+S)"), "saveProject");
  connect(saveProject_, &QPushButton::clicked, this, [this] { session_.save(false); });
  top->addWidget(saveProject_);
  auto* open = flat(tr("open"), tr("Open a stitch project in place of this one"), "openProject");
  connect(open, &QPushButton::clicked, this, &StitchPanel::askForProject);
  top->addWidget(open);
  auto* add = flat(tr("+ add"), tr("Add volumes or sweeps"), "addMore");
  connect(add, &QPushButton::clicked, this, &StitchPanel::askForFiles);
  top->addWidget(add);
  column->addLayout(top);

  list_ = new QListWidget;
  list_->setObjectName(QStringLiteral("volumes"));
  list_->setItemDelegate(new VolumeDelegate(list_));
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  list_->setDragDropMode(QAbstractItemView::InternalMove);
  list_->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
  list_->setMinimumHeight(2 * kRow_px + 4);
  list_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  list_->installEventFilter(this);
  connect(list_, &QListWidget::currentRowChanged, this, [this](int row) {
    if (!showing_ && row >= 0) session_.chooseVolume(static_cast<std::size_t>(row));
  });
  connect(list_, &QListWidget::itemChanged, this, [this](QListWidgetItem* item) {
    if (showing_) return;
    const auto at = static_cast<std::size_t>(list_->row(item));
    const std::string name = item->text().trimmed().toStdString();
    if (auto problem = problemOfName(session_.project(), at, name)) {
      sdk::setProblem(problem_, words(problem->sentence));
    } else {
      StitchProject next = session_.project();
      next.volumes[at].name = name;
      sdk::setProblem(problem_, {});
      session_.edit(std::move(next), tr("call %1 '%2'").arg(words(letterOf(at)), words(name)));
    }
    QMetaObject::invokeMethod(this, &StitchPanel::refresh, Qt::QueuedConnection);
  });
  connect(list_->model(), &QAbstractItemModel::rowsMoved, this, [this](const QModelIndex&, int from, int, const QModelIndex&, int to) {
    if (showing_) return;
    const auto at = static_cast<std::size_t>(from);
    const auto there = static_cast<std::size_t>(to > from ? to - 1 : to);
    // After the view is done with its own move.
    QMetaObject::invokeMethod(
        this,
        [this, at, there] {
          session_.edit(withVolumeMoved(session_.project(), at, there), tr("move %1 in the list").arg(words(letterOf(at))));
          session_.chooseVolume(there);
        },
        Qt::QueuedConnection);
  });
  column->addWidget(list_, 3);
  column->addWidget(makeVolumeBox());

  pairsBox_ = new QWidget;
  auto* pairs = new QVBoxLayout(pairsBox_);
  pairs->setContentsMargins(0, 0, 0, 0);
  pairs->setSpacing(kGap_px / 2);
  auto* pairsTop = new QHBoxLayout;
  pairsTop->addWidget(sdk::headingLabel(tr("Pairs")));
  pairWord_ = sdk::quietLabel({});
  pairWord_->setObjectName(QStringLiteral("pairWord"));
  pairWord_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  pairsTop->addWidget(pairWord_, 1);
  pairs->addLayout(pairsTop);
  graph_ = new PairGraph(session_);
  graph_->setMaximumHeight(280);
  pairs->addWidget(graph_, 1);
  pairs->addWidget(makeLegend());
  pairsBox_->setMaximumHeight(360);  // on a tall screen the room is left below, not between
  column->addWidget(pairsBox_, 4);
  column->addWidget(makeSteps());
  column->addWidget(makeResultBox());
  column->addStretch(1);
  return page;
}

QWidget* StitchPanel::makeVolumeBox() {
  volumeBox_ = new QWidget;
  auto* row = new QHBoxLayout(volumeBox_);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(kGap_px / 2);
  placement_ = new QComboBox;
  placement_->setObjectName(QStringLiteral("placement"));
  placement_->addItem(tr("unknown"), static_cast<int>(Placement::unknown));
  placement_->addItem(tr("recorded"), static_cast<int>(Placement::tracker));
  placement_->addItem(tr("by hand"), static_cast<int>(Placement::hand));
  placement_->setToolTip(
      tr("Where the chosen volume's place comes from: found by matching, believed as the tracker's, or a start by hand"));
  placement_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  connect(placement_, qOverload<int>(&QComboBox::activated), this, [this] {
    if (const auto chosen = session_.chosenVolume())
      session_.setPlacement(*chosen, static_cast<Placement>(placement_->currentData().toInt()));
  });
  row->addWidget(placement_, 1);
  const auto small = [&](const QString& text, const QString& hint, const char* name) {
    auto* button = new QPushButton(text);
    button->setProperty("compact", true);
    button->setToolTip(hint);
    button->setObjectName(QLatin1String(name));
    row->addWidget(button);
    return button;
  };
  connect(small(tr("File…"), tr("Take the place from a file with 16 numbers, row by row"), "placeFromFile"), &QPushButton::clicked, this,
          &StitchPanel::chooseTransform);
  connect(small(tr("Remove"), tr("Take this volume off the list; its file stays (Delete)"), "remove"), &QPushButton::clicked, this,
          &StitchPanel::removeChosen);
  return volumeBox_;
}

QWidget* StitchPanel::makeLegend() {
  auto* box = new QWidget;
  auto* grid = new QGridLayout(box);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(kGap_px);
  grid->setVerticalSpacing(2);
  int n = 0;
  for (const auto mark :
       {StitchSession::Mark::aligned, StitchSession::Mark::cannotTell, StitchSession::Mark::notAligned, StitchSession::Mark::rejected}) {
    auto* word = sdk::quietLabel(wordsOfMark(mark));
    word->setProperty("small", true);
    word->setWordWrap(false);
    grid->addWidget(new LegendMark(mark), n / 2, 2 * (n % 2));
    grid->addWidget(word, n / 2, 2 * (n % 2) + 1);
    ++n;
  }
  grid->setColumnStretch(1, 1);
  grid->setColumnStretch(3, 1);
  return box;
}

QWidget* StitchPanel::makeSteps() {
  auto* box = new QWidget;
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kGap_px);
  const auto step = [&](const QString& text, const QString& hint, const char* name) {
    auto* button = new QPushButton(text);
    button->setToolTip(hint);
    button->setObjectName(QLatin1String(name));
    return button;
  };
  match_ = step(tr("Match all without tracker"), tr("Find how all subvolumes lie to each other, whatever is recorded about their places"),
                "matchAll");
  match_->setProperty("primary", true);
  connect(match_, &QPushButton::clicked, this, [this] { session_.matchAll(true); });
  column->addWidget(match_);
  refine_ = step(tr("Refine the places"), tr("Start from the places as they are recorded or put by hand, and let the images refine them"),
                 "refine");
  connect(refine_, &QPushButton::clicked, this, [this] { session_.matchAll(false); });
  column->addWidget(refine_);
  auto* row = new QHBoxLayout;
  row->setSpacing(kGap_px);
  elastic_ = step(tr("Elastic"), tr("Bend the subvolumes so that they fit where they overlap"), "elastic");
  connect(elastic_, &QPushButton::clicked, this, [this] {
    if (!session_.project().settings.elastic) {
      StitchProject next = session_.project();
      next.settings.elastic = true;
      session_.edit(std::move(next), tr("elastic step on"));
    }
    session_.run(Step::elastic, tr("Elastic"));
  });
  seams_ = step(tr("Seams and blend"), tr("Choose for every place the view that saw it best, and make one volume"), "seams");
  connect(seams_, &QPushButton::clicked, this, [this] { session_.run(Step::volume, tr("Seams and blend")); });
  row->addWidget(elastic_, 2);
  row->addWidget(seams_, 3);
  column->addLayout(row);
  return box;
}

QWidget* StitchPanel::makeResultBox() {
  auto* box = new QWidget;
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kGap_px / 2);
  resultBox_ = new QWidget;
  auto* row = new QHBoxLayout(resultBox_);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(kGap_px / 2);
  const auto button = [&](const QString& text, const QString& hint, const char* name) {
    auto* made = new QPushButton(text);
    made->setProperty("compact", true);
    made->setToolTip(hint);
    made->setObjectName(QLatin1String(name));
    row->addWidget(made, 1);
    return made;
  };
  connect(button(tr("Into the case"), tr("The open case takes over the stitched volume"), "handToCase"), &QPushButton::clicked, &session_,
          &StitchSession::handToCase);
  connect(button(tr("Save volume…"), tr("Save volume, coverage, source and provenance in a folder"), "saveResult"), &QPushButton::clicked,
          this, [this] {
            const QString folder = QFileDialog::getExistingDirectory(this, tr("Folder for the stitched volume"));
            if (!folder.isEmpty()) session_.saveResult(folder.toStdString());
          });
  column->addWidget(resultBox_);
  old_ = new Paragraph(tr("Older than the last edit."));
  old_->setToolTip(tr("'Seams and blend' renews the stitched volume"));
  old_->setObjectName(QStringLiteral("resultIsOld"));
  old_->setProperty("small", true);
  column->addWidget(old_);
  outcome_ = new Paragraph;
  outcome_->setObjectName(QStringLiteral("outcome"));
  outcome_->hide();
  column->addWidget(outcome_);
  auto* more = new QPushButton(tr("Options"));
  more->setObjectName(QStringLiteral("moreOptions"));
  more->setProperty("flat", true);
  more->setCheckable(false);
  forecast_ = new Paragraph;
  forecast_->setObjectName(QStringLiteral("forecast"));
  forecast_->setProperty("small", true);
  moreRow_ = new QWidget;
  auto* moreRow = new QHBoxLayout(moreRow_);
  moreRow->setContentsMargins(0, 0, 0, 0);
  moreRow->addWidget(forecast_, 1);
  moreRow->addWidget(more);
  column->addWidget(moreRow_);
  options_ = makeOptions();
  options_->hide();
  column->addWidget(options_);
  connect(more, &QPushButton::clicked, this, [this, more] {
    options_->setVisible(!options_->isVisible());
    more->setText(options_->isVisible() ? tr("Fewer") : tr("Options"));
  });
  return box;
}

QWidget* StitchPanel::makeOptions() {
  auto* box = new QWidget;
  auto* form = new QFormLayout(box);
  form->setContentsMargins(0, 0, 0, 0);
  form->setSpacing(kGap_px);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  spacing_ = new sdk::NumberField(0.0, 20.0, 2, tr("mm"));
  spacing_->setObjectName(QStringLiteral("spacing"));
  spacing_->setSpecialValueText(tr("finest"));
  spacing_->setSingleStep(0.1);
  fallOff_ = new sdk::NumberField(0.0, 200.0, 0, tr("mm"));
  fallOff_->setObjectName(QStringLiteral("fallOff"));
  fallOff_->setToolTip(tr("The bend is gone this far outside the overlap"));
  seamMethod_ = new QComboBox;
  seamMethod_->addItem(tr("cut"), static_cast<int>(SeamMethod::graphCut));
  seamMethod_->addItem(tr("deepest view"), static_cast<int>(SeamMethod::nearest));
  seamMethod_->addItem(tr("mean"), static_cast<int>(SeamMethod::feather));
  seamMethod_->setToolTip(
      tr("Cut along the surface where the views differ least; or each place from the view in whose inside it lies deepest; or "
         "a mean, which smooths speckle"));
  axes_ = new QComboBox;
  axes_->addItem(tr("first volume"), static_cast<int>(GridAxes::first));
  axes_->addItem(tr("body"), static_cast<int>(GridAxes::world));
  form->addRow(tr("Spacing"), spacing_);
  form->addRow(tr("Seam"), seamMethod_);
  form->addRow(tr("Fall-off"), fallOff_);
  form->addRow(tr("Axes"), axes_);
  for (QComboBox* each : {seamMethod_, axes_}) each->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  const auto change = [this](const QString& what, const std::string& key, auto&& set) {
    if (showing_) return;
    StitchProject next = session_.project();
    set(next.settings);
    session_.edit(std::move(next), what, key);
  };
  connect(spacing_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [change](double value) {
    change(tr("voxel spacing"), "spacing", [value](ProjectSettings& settings) { settings.join.grid.spacing_mm = value; });
  });
  connect(fallOff_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [change](double value) {
    change(tr("fall-off of the bend"), "falloff", [value](ProjectSettings& settings) { settings.fallOff_mm = value; });
  });
  connect(seamMethod_, qOverload<int>(&QComboBox::activated), this, [this, change] {
    change(tr("seam by %1").arg(seamMethod_->currentText()), {},
           [this](ProjectSettings& settings) { settings.join.seam.method = static_cast<SeamMethod>(seamMethod_->currentData().toInt()); });
  });
  connect(axes_, qOverload<int>(&QComboBox::activated), this, [this, change] {
    change(tr("axes of the %1").arg(axes_->currentText()), {},
           [this](ProjectSettings& settings) { settings.join.grid.axes = static_cast<GridAxes>(axes_->currentData().toInt()); });
  });
  return box;
}

void StitchPanel::showVolumes() {
  const auto& volumes = session_.project().volumes;
  const int rows = static_cast<int>(volumes.size());
  list_->setMinimumHeight(std::clamp(rows, 2, 4) * kRow_px + 4);
  list_->setMaximumHeight(std::max(2, rows) * kRow_px + 4);
  while (list_->count() > static_cast<int>(volumes.size())) delete list_->takeItem(list_->count() - 1);
  for (std::size_t n = 0; n < volumes.size(); ++n) {
    QListWidgetItem* item = list_->item(static_cast<int>(n));
    if (item == nullptr) {
      item = new QListWidgetItem(list_);
      item->setFlags((item->flags() | Qt::ItemIsEditable) & ~Qt::ItemIsDropEnabled);
    }
    const auto volume = session_.volume(n);
    const QString place = volumes[n].placement == Placement::unknown   ? tr("place unknown")
                          : volumes[n].placement == Placement::tracker ? tr("recorded")
                                                                       : tr("by hand");
    const auto mark = session_.markOf(n);
    item->setText(words(volumes[n].name));
    item->setData(kLine, volume                     ? sizeOf(volume->grid) + QStringLiteral(", ") + place
                         : session_.isUnreadable(n) ? tr("cannot be read")
                                                    : tr("reading…"));
    item->setData(kBroken, !volume && session_.isUnreadable(n));
    item->setData(kMark, static_cast<int>(mark));
    QString tip = words(volumes[n].name) + QLatin1Char('\n') + words(volumes[n].file.string());
    if (volume) {
      const Grid& grid = volume->grid;
      const QLocale locale;
      tip += QLatin1Char('\n') + tr("%1 voxels of %2 × %3 × %4 mm")
                                     .arg(sizeOf(grid), locale.toString(grid.spacing_mm.x, 'g', 4),
                                          locale.toString(grid.spacing_mm.y, 'g', 4), locale.toString(grid.spacing_mm.z, 'g', 4));
    }
    item->setToolTip(tip + QLatin1Char('\n') + wordsOfMark(mark) + QLatin1Char('\n') +
                     tr("F2 renames, Alt + up and down move it, Delete takes it off the list"));
  }
  const auto chosen = session_.chosenVolume();
  list_->setCurrentRow(chosen ? static_cast<int>(*chosen) : -1);
  volumeBox_->setVisible(chosen.has_value());
  if (chosen) placement_->setCurrentIndex(placement_->findData(static_cast<int>(volumes[*chosen].placement)));
}

void StitchPanel::refresh() {
  const bool was = std::exchange(showing_, true);
  const auto& left = session_.left();
  offer_->setVisible(left.has_value());
  if (left)
    offerWord_->setText(
        left->file.empty()
            ? tr("A project of %n volumes was not saved when the program ended.", nullptr, static_cast<int>(left->project.volumes.size()))
            : tr("Changes to '%1' were not saved when the program ended.").arg(words(left->file.stem().string())));
  const auto& project = session_.project();
  pages_->setCurrentIndex(project.volumes.empty() ? 0 : 1);
  showVolumes();
  const auto all = session_.pairs();
  const int look = session_.pairsToLookAt();
  const bool seen = std::any_of(all.begin(), all.end(), [](const auto& line) { return line.outcome != nullptr; });
  pairWord_->setText(!seen ? QString() : look == 0 ? tr("all looked at") : tr("%1 of %2 need a look").arg(look).arg(all.size()));
  pairsBox_->setVisible(project.volumes.size() >= 2);
  const bool running = session_.isRunning();
  jobRoom_->setVisible(running);
  moreRow_->setVisible(!running);  // its room is the card's on a small screen
  for (QPushButton* button : {match_, refine_, elastic_, seams_}) button->setEnabled(!running);
  // Once each: what is shown and hidden again in one go leaves its room behind.
  for (QPushButton* button : {match_, elastic_, seams_}) button->setVisible(project.volumes.size() >= 2);
  refine_->setVisible(project.volumes.size() >= 2 && std::any_of(project.volumes.begin(), project.volumes.end(), [](const auto& volume) {
                        return volume.placement != Placement::unknown;
                      }));
  saveProject_->setVisible(session_.document().hasUnsavedChanges());
  resultBox_->setVisible(session_.result() != nullptr);
  old_->setVisible(session_.result() != nullptr && !session_.isResultFresh());
  spacing_->setValue(project.settings.join.grid.spacing_mm);
  fallOff_->setValue(project.settings.fallOff_mm);
  seamMethod_->setCurrentIndex(std::max(0, seamMethod_->findData(static_cast<int>(project.settings.join.seam.method))));
  axes_->setCurrentIndex(std::max(0, axes_->findData(static_cast<int>(project.settings.join.grid.axes))));
  showForecast();
  showing_ = was;
}

void StitchPanel::showForecast() {
  std::vector<PlacedGrid> grids;
  for (std::size_t n = 0; n < session_.project().volumes.size(); ++n)
    if (const auto volume = session_.volume(n)) grids.push_back({volume->grid, session_.toWorld(n), session_.project().volumes[n].name});
  if (grids.empty()) return forecast_->say({});
  const auto forecast = forecastJoin(grids, session_.project().settings.join);
  if (!forecast) return forecast_->say(words(forecast.error().sentence));
  const QString needs = mebibytes(static_cast<double>(forecast->bytes));
  QString tip = tr("What the stitched volume will be, and the memory that making it takes at its peak");
  if (const auto free = availableMemory_bytes()) tip += QLatin1Char('\n') + tr("%1 are free").arg(mebibytes(static_cast<double>(*free)));
  forecast_->setToolTip(tip);
  forecast_->say(tr("Whole: %1, %2").arg(sizeOf(forecast->grid), needs));
}

void StitchPanel::askForFiles() {
  const QStringList chosen = QFileDialog::getOpenFileNames(
      this, tr("Add volumes"), {},
      tr("Volumes, sweeps and stitch projects (*.mha *.mhd *.nrrd *.nhdr *.nii *.nii.gz *.json);;All files (*)"));
  std::vector<fs::path> files;
  for (const auto& each : chosen) files.emplace_back(each.toStdString());
  if (!files.empty()) session_.addFiles(files);
}

void StitchPanel::askForProject() {
  const QString chosen = QFileDialog::getOpenFileName(this, tr("Open a stitch project"), {}, tr("Stitch projects (*.json);;All files (*)"));
  if (!chosen.isEmpty()) session_.openProject(chosen.toStdString());
}

void StitchPanel::chooseTransform() {
  const auto chosen = session_.chosenVolume();
  if (!chosen) return;
  const QString file = QFileDialog::getOpenFileName(this, tr("Place of %1").arg(words(session_.project().volumes[*chosen].name)), {},
                                                    tr("Transforms (*.txt *.tfm);;All files (*)"));
  if (file.isEmpty()) return;
  auto text = session_.host().files().readText(file.toStdString());
  if (!text) return sdk::setProblem(problem_, words(text.error().sentence));
  auto matrix = parseTransform(*text, fs::path(file.toStdString()).filename().string());
  if (!matrix) return sdk::setProblem(problem_, words(matrix.error().sentence));
  sdk::setProblem(problem_, {});
  session_.edit(withPlace(session_.project(), *chosen, *matrix, Placement::tracker),
                tr("place %1 from a file").arg(words(letterOf(*chosen))));
}

void StitchPanel::removeChosen() {
  const auto chosen = session_.chosenVolume();
  if (!chosen) return;
  session_.edit(withoutVolume(session_.project(), *chosen), tr("remove %1").arg(words(session_.project().volumes[*chosen].name)));
}

void StitchPanel::moveChosen(int step) {
  const auto chosen = session_.chosenVolume();
  if (!chosen) return;
  const int to = static_cast<int>(*chosen) + step;
  if (to < 0 || to >= list_->count()) return;
  session_.edit(withVolumeMoved(session_.project(), *chosen, static_cast<std::size_t>(to)),
                tr("move %1 in the list").arg(words(letterOf(*chosen))));
  session_.chooseVolume(static_cast<std::size_t>(to));
}

bool StitchPanel::eventFilter(QObject* watched, QEvent* event) {
  if (watched == list_ && (event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride)) {
    auto* key = static_cast<QKeyEvent*>(event);
    const bool act = event->type() == QEvent::KeyPress;
    const bool up = key->key() == Qt::Key_Up;
    if (key->key() == Qt::Key_Delete && key->modifiers() == Qt::NoModifier) {
      if (act)
        removeChosen();
      else
        event->accept();
      return true;
    }
    if ((up || key->key() == Qt::Key_Down) && key->modifiers().testFlag(Qt::AltModifier)) {
      if (act)
        moveChosen(up ? -1 : 1);
      else
        event->accept();
      return true;
    }
    if (!act && (up || key->key() == Qt::Key_Down || key->key() == Qt::Key_F2)) {
      event->accept();
      return true;
    }
  }
  return QWidget::eventFilter(watched, event);
}

void StitchPanel::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void StitchPanel::dropEvent(QDropEvent* event) {
  std::vector<fs::path> files;
  for (const auto& url : event->mimeData()->urls())
    if (url.isLocalFile()) files.emplace_back(url.toLocalFile().toStdString());
  if (files.empty()) return;
  event->acceptProposedAction();
  session_.addFiles(files);
}

}  // namespace ew::stitching
