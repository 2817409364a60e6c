#include "panel/volume_list.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QItemSelectionModel>
#include <QKeyEvent>
#include <QListWidget>
#include <QLocale>
#include <QPainter>
#include <QPushButton>
#include <QStyle>
#include <QStyledItemDelegate>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "ew/widgets/fields.h"
#include "ew/widgets/labels.h"
#include "ew/widgets/look.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"
#include "panel/folders.h"
#include "panel/marks.h"
#include "panel/stitch_session.h"

namespace ew::stitching {
namespace {

namespace fs = std::filesystem;

constexpr int kRow_px = 44;

enum Role { kLine = Qt::UserRole, kMark, kBroken };

QString placementWords(Placement placement) {
  switch (placement) {
    case Placement::unknown:
      return VolumeList::tr("pose unknown");
    case Placement::tracker:
      return VolumeList::tr("recorded");
    case Placement::hand:
      return VolumeList::tr("manual");
  }
  return {};
}

/// Letter, name, size and where it lies; at the right what holds it.
class VolumeDelegate final : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override { return {200, scaled(kRow_px)}; }
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    const QRect box = option.rect;
    const QPalette& colours = option.palette;
    const QColor accent = QApplication::palette().color(QPalette::Highlight);  // the style of lists has a quiet one in its place
    if (option.state.testFlag(QStyle::State_Selected)) {
      painter->setPen(Qt::NoPen);
      painter->setBrush(colours.color(QPalette::Button));
      painter->drawRoundedRect(box.adjusted(2, 1, -2, -1), 4, 4);
      // The ground alone is a shade that nobody sees: what the buttons below are about has a bar as well.
      painter->setBrush(accent);
      painter->drawRoundedRect(QStyle::visualRect(option.direction, box, QRect(box.left() + 2, box.top() + 4, 3, box.height() - 8)), 1.5,
                               1.5);
    }
    if (option.state.testFlag(QStyle::State_HasFocus)) {
      painter->setPen(QPen(accent, 1.0));
      painter->setBrush(Qt::NoBrush);
      painter->drawRoundedRect(QRectF(box).adjusted(2.5, 1.5, -2.5, -1.5), 4, 4);
    }
    const auto px = [](int size) { return scaled(size); };
    const auto placed = [&](const QRect& rect) { return QStyle::visualRect(option.direction, box, rect); };
    const QRectF badge(placed(QRect(box.left() + 10, box.top() + px(11), px(22), px(22))));
    painter->setPen(QPen(colourOf(colourOfView(static_cast<std::size_t>(index.row()))), 2.0));
    painter->setBrush(Qt::NoBrush);
    painter->drawEllipse(badge.adjusted(1, 1, -1, -1));
    QFont font = option.font;
    font.setPixelSize(px(12));
    painter->setFont(font);
    painter->setPen(colours.color(QPalette::WindowText));
    painter->drawText(badge, Qt::AlignCenter, words(letterOf(static_cast<std::size_t>(index.row()))));
    const int left = box.left() + 20 + px(22);
    const int wide = box.right() - 18 - px(14) - left;
    font.setPixelSize(px(13));
    painter->setFont(font);
    painter->drawText(placed(QRect(left, box.top() + 4, wide, px(18))), Qt::AlignLeft | Qt::AlignVCenter,
                      QFontMetrics(font).elidedText(index.data(Qt::EditRole).toString(), Qt::ElideMiddle, wide));
    font.setPixelSize(px(12));
    painter->setFont(font);
    painter->setPen(colours.color(index.data(kBroken).toBool() ? QPalette::BrightText : QPalette::PlaceholderText));
    painter->drawText(placed(QRect(left, box.top() + 4 + px(18), wide, px(18))), Qt::AlignLeft | Qt::AlignVCenter,
                      QFontMetrics(font).elidedText(index.data(kLine).toString(), Qt::ElideRight, wide));
    drawMark(*painter, QRectF(placed(QRect(box.right() - 13 - px(14), box.top() + px(15), px(14), px(14)))),
             static_cast<StitchResults::Mark>(index.data(kMark).toInt()), colours);
    painter->restore();
  }
  void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option, const QModelIndex&) const override {
    editor->setGeometry(option.rect.adjusted(38, 6, -8, -6));
  }
};

}  // namespace

VolumeList::VolumeList(StitchSession& session, QWidget* parent)
    : QWidget(parent),
      files_(session.host().files()),
      document_(session.document()),
      inputs_(session.inputs()),
      results_(session.results()),
      look_(session.look()),
      edits_(session.edits()) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kGrid_px);
  list_ = new QListWidget;
  list_->setObjectName(QStringLiteral("volumes"));
  list_->setAccessibleName(tr("Volumes"));
  list_->setItemDelegate(new VolumeDelegate(list_));
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  list_->setDragDropMode(QAbstractItemView::InternalMove);
  list_->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
  list_->setMinimumHeight(2 * scaled(kRow_px) + 4);
  list_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  list_->installEventFilter(this);
  connect(list_, &QListWidget::currentRowChanged, this, [this](int row) {
    if (!showing_ && row >= 0) look_.chooseVolume(static_cast<std::size_t>(row));
  });
  connect(list_, &QListWidget::itemChanged, this, [this](QListWidgetItem* item) {
    if (showing_) return;
    const auto at = static_cast<std::size_t>(list_->row(item));
    const std::string name = item->text().trimmed().toStdString();
    if (auto wrong = problemOfName(document_.project(), at, name)) {
      Q_EMIT problem(words(wrong->message));
    } else {
      StitchProject next = document_.project();
      next.volumes[at].name = name;
      Q_EMIT problem({});
      document_.edit(std::move(next), tr("call %1 '%2'").arg(words(letterOf(at)), words(name)));
    }
    QMetaObject::invokeMethod(this, &VolumeList::refresh, Qt::QueuedConnection);
  });
  connect(list_->model(), &QAbstractItemModel::rowsMoved, this, [this](const QModelIndex&, int from, int, const QModelIndex&, int to) {
    if (showing_) return;
    const auto at = static_cast<std::size_t>(from);
    const auto there = static_cast<std::size_t>(to > from ? to - 1 : to);
    // After the view is done with its own move.
    QMetaObject::invokeMethod(
        this,
        [this, at, there] {
          document_.edit(withVolumeMoved(document_.project(), at, there), tr("move %1 in the list").arg(words(letterOf(at))));
          look_.chooseVolume(there);
        },
        Qt::QueuedConnection);
  });
  column->addWidget(list_, 1);
  column->addWidget(makeChosenBox());
}

QWidget* VolumeList::makeChosenBox() {
  chosenBox_ = new QWidget;
  auto* column = new QVBoxLayout(chosenBox_);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kGrid_px / 2);
  auto* row = new QHBoxLayout;
  row->setSpacing(kGrid_px / 2);
  column->addLayout(row);
  placement_ = new QComboBox;
  placement_->setObjectName(QStringLiteral("placement"));
  placement_->addItem(tr("unknown"), static_cast<int>(Placement::unknown));
  placement_->addItem(tr("recorded"), static_cast<int>(Placement::tracker));
  placement_->addItem(tr("manual"), static_cast<int>(Placement::hand));
  placement_->setToolTip(
      tr("Where the chosen volume's place comes from: found by matching, believed as the tracker's, or a start by hand"));
  placement_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  connect(placement_, qOverload<int>(&QComboBox::activated), this, [this] {
    if (const auto chosen = look_.chosenVolume()) edits_.setPlacement(*chosen, static_cast<Placement>(placement_->currentData().toInt()));
  });
  row->addWidget(placement_, 1);
  const auto small = [&](const QString& text, const QString& hint, const char* name) {
    auto* button = new QPushButton(text);
    setLook(button, Look::compact);
    button->setToolTip(hint);
    button->setObjectName(QLatin1String(name));
    row->addWidget(button);
    return button;
  };
  connect(small(tr("File…"), tr("Read the pose from a file with 16 numbers, row by row"), "placeFromFile"), &QPushButton::clicked, this,
          &VolumeList::chooseTransform);
  connect(small(tr("Remove"), tr("Take this volume off the list; its file stays (Delete)"), "remove"), &QPushButton::clicked, this,
          &VolumeList::removeChosen);
  column->addWidget(makeSweepRow());
  acceptsSmall_ = new QCheckBox(tr("Take it all the same"));
  acceptsSmall_->setObjectName(QStringLiteral("acceptsSmall"));
  acceptsSmall_->setToolTip(
      tr("Less than a tenth of this sweep's pixels or frames becomes part of the volume, or its size is unusual, and that is meant"));
  connect(acceptsSmall_, &QCheckBox::clicked, this, [this](bool on) {
    if (const auto chosen = look_.chosenVolume()) inputs_.setAcceptsSmall(*chosen, on);
  });
  column->addWidget(acceptsSmall_);
  return chosenBox_;
}

QWidget* VolumeList::makeSweepRow() {
  sweepRow_ = new QWidget;
  auto* row = new QHBoxLayout(sweepRow_);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(kGrid_px / 2);
  calibration_ = new QPushButton;
  calibration_->setObjectName(QStringLiteral("calibration"));
  setLook(calibration_, Look::compact);
  calibration_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  connect(calibration_, &QPushButton::clicked, this, &VolumeList::chooseCalibration);
  row->addWidget(calibration_, 1);
  auto* name = quietLabel(tr("Voxels"));
  name->setWordWrap(false);
  row->addWidget(name);
  sweepSpacing_ = new NumberField(0.0, 20.0, 2, tr("mm"));
  sweepSpacing_->setObjectName(QStringLiteral("sweepSpacing"));
  sweepSpacing_->setSpecialValueText(tr("own"));
  sweepSpacing_->setSingleStep(0.1);
  sweepSpacing_->setKeyboardTracking(false);
  sweepSpacing_->setToolTip(
      tr("Spacing of the volume that is made of this sweep; at the least value as fine as its pixels and frames are"));
  name->setBuddy(sweepSpacing_);
  // Not while it is stepped: every value reads the sweep again.
  connect(sweepSpacing_, &QDoubleSpinBox::editingFinished, this, [this] {
    if (const auto chosen = look_.chosenVolume(); chosen && !showing_) inputs_.setSweepSpacing(*chosen, sweepSpacing_->value());
  });
  row->addWidget(sweepSpacing_);
  return sweepRow_;
}

void VolumeList::showSweepRow() {
  const auto chosen = look_.chosenVolume();
  const bool isSweep = chosen && inputs_.isSweep(*chosen);
  sweepRow_->setVisible(isSweep);
  acceptsSmall_->setVisible(isSweep && inputs_.asksAboutLittle(*chosen));
  if (!isSweep) return;
  const ProjectVolume& line = document_.project().volumes[*chosen];
  const QString file = words(line.calibration.filename().string());
  calibration_->setText(line.calibration.empty() ? tr("Calibration of %1…").arg(words(letterOf(*chosen)))
                                                 : calibration_->fontMetrics().elidedText(file, Qt::ElideMiddle, 110));
  calibration_->setToolTip(
      line.calibration.empty()
          ? tr("A device set (.xml) that says where the pixels lie on the probe; needed by a sweep that does not say it itself")
          : tr("Calibration from %1; click to choose another file").arg(words(line.calibration.string())));
  sweepSpacing_->setValue(line.spacing_mm);
  acceptsSmall_->setChecked(line.acceptsSmall);
}

void VolumeList::chooseCalibration() {
  const auto chosen = look_.chosenVolume();
  if (!chosen) return;
  const QString file = QFileDialog::getOpenFileName(this, tr("Calibration of %1").arg(words(document_.project().volumes[*chosen].name)),
                                                    lastFolder(), tr("Device sets (*.xml);;All files (*)"));
  if (file.isEmpty()) return;
  keepFolderOf(file);
  inputs_.setCalibration(*chosen, file.toStdString());
}

void VolumeList::refresh() {
  const bool was = std::exchange(showing_, true);
  const auto& volumes = document_.project().volumes;
  const int rows = static_cast<int>(volumes.size());
  list_->setMinimumHeight(std::clamp(rows, 2, 4) * scaled(kRow_px) + 4);
  list_->setMaximumHeight(std::max(2, rows) * scaled(kRow_px) + 4);
  while (list_->count() > static_cast<int>(volumes.size())) delete list_->takeItem(list_->count() - 1);
  for (std::size_t n = 0; n < volumes.size(); ++n) {
    QListWidgetItem* item = list_->item(static_cast<int>(n));
    if (item == nullptr) {
      item = new QListWidgetItem(list_);
      item->setFlags((item->flags() | Qt::ItemIsEditable) & ~Qt::ItemIsDropEnabled);
    }
    const auto volume = inputs_.volume(n);
    const QString place = placementWords(volumes[n].placement);
    const auto mark = results_.markOf(n);
    item->setText(words(volumes[n].name));
    item->setData(kLine, volume                    ? sizeOf(volume->grid) + QStringLiteral(", ") + place
                         : inputs_.isUnreadable(n) ? inputs_.isSweep(n) ? tr("sweep, not yet a volume") : tr("cannot be read")
                                                   : tr("reading…"));
    item->setData(kBroken, !volume && inputs_.isUnreadable(n));
    item->setData(kMark, static_cast<int>(mark));
    QString tip = words(volumes[n].name) + QLatin1Char('\n') + words(volumes[n].file.string());
    if (volume) {
      const Grid& grid = volume->grid;
      const QLocale locale;
      tip += QLatin1Char('\n') + tr("%1 voxels of %2 × %3 × %4 mm")
                                     .arg(sizeOf(grid), locale.toString(grid.spacing_mm.x, 'g', 4),
                                          locale.toString(grid.spacing_mm.y, 'g', 4), locale.toString(grid.spacing_mm.z, 'g', 4));
    }
    if (const QString why = inputs_.whyUnreadable(n); !volume && !why.isEmpty()) tip += QLatin1Char('\n') + why;
    item->setToolTip(tip + QLatin1Char('\n') + wordsOfMark(mark) + QLatin1Char('\n') +
                     tr("F2 renames, Alt + up and down move it, Delete takes it off the list"));
  }
  const auto chosen = look_.chosenVolume();
  // Selected as well: a row that became the current one because another was taken away is not.
  list_->setCurrentRow(chosen ? static_cast<int>(*chosen) : -1, QItemSelectionModel::ClearAndSelect);
  chosenBox_->setVisible(chosen.has_value());
  showSweepRow();
  if (chosen) placement_->setCurrentIndex(placement_->findData(static_cast<int>(volumes[*chosen].placement)));
  setMaximumHeight(list_->maximumHeight() + (chosen ? kGrid_px + chosenBox_->sizeHint().height() : 0));
  showing_ = was;
}

void VolumeList::chooseTransform() {
  const auto chosen = look_.chosenVolume();
  if (!chosen) return;
  const QString file = QFileDialog::getOpenFileName(this, tr("Pose of %1").arg(words(document_.project().volumes[*chosen].name)),
                                                    lastFolder(), tr("Transforms (*.txt *.tfm);;All files (*)"));
  if (file.isEmpty()) return;
  keepFolderOf(file);
  auto text = files_.readText(file.toStdString());
  if (!text) return Q_EMIT problem(words(text.error().message));
  auto toWorld = parseTransform<frame::World, frame::View>(*text, fs::path(file.toStdString()).filename().string());
  if (!toWorld) return Q_EMIT problem(words(toWorld.error().message));
  Q_EMIT problem({});
  document_.edit(withPlace(document_.project(), *chosen, *toWorld, Placement::tracker),
                 tr("pose of %1 from a file").arg(words(letterOf(*chosen))));
}

void VolumeList::removeChosen() {
  const auto chosen = look_.chosenVolume();
  if (!chosen) return;
  document_.edit(withoutVolume(document_.project(), *chosen), tr("remove %1").arg(words(document_.project().volumes[*chosen].name)));
}

void VolumeList::moveChosen(int step) {
  const auto chosen = look_.chosenVolume();
  if (!chosen) return;
  const int to = static_cast<int>(*chosen) + step;
  if (to < 0 || to >= list_->count()) return;
  document_.edit(withVolumeMoved(document_.project(), *chosen, static_cast<std::size_t>(to)),
                 tr("move %1 in the list").arg(words(letterOf(*chosen))));
  look_.chooseVolume(static_cast<std::size_t>(to));
}

bool VolumeList::eventFilter(QObject* watched, QEvent* event) {
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

}  // namespace ew::stitching
