#include "scan/source/source_dialog.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QPointer>
#include <QPushButton>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>

#include "ew/widgets/figures.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"

namespace ew::ui {

/// A frame as it was recorded, its pixels as wide and high as they are in the body, and a cross.
class SourceImage final : public QWidget {
 public:
  SourceImage() {
    setObjectName(QStringLiteral("sourceImage"));
    setMinimumSize(320, 240);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  }

  void show(const QImage& image, const QSizeF& pixel_mm, const std::optional<QPointF>& cross_px, bool isSource, const QString& instead) {
    image_ = image;
    pixel_mm_ = pixel_mm;
    cross_px_ = cross_px;
    isSource_ = isSource;
    instead_ = instead;
    update();
  }
  [[nodiscard]] const QImage& image() const { return image_; }
  [[nodiscard]] const std::optional<QPointF>& cross() const { return cross_px_; }

 protected:
  void paintEvent(QPaintEvent*) override {
    const Theme theme = scanTheme();
    QPainter painter(this);
    painter.fillRect(rect(), Qt::black);
    if (image_.isNull()) {
      painter.setFont(textFont());
      painter.setPen(theme.quiet);
      painter.drawText(rect().adjusted(24, 24, -24, -24), Qt::AlignCenter | Qt::TextWordWrap, instead_);
      return;
    }
    const QSizeF size_mm(image_.width() * pixel_mm_.width(), image_.height() * pixel_mm_.height());
    const double scale = std::min(width() / size_mm.width(), height() / size_mm.height());
    const QSizeF shown = size_mm * scale;
    const QRectF box(QPointF((width() - shown.width()) / 2.0, (height() - shown.height()) / 2.0), shown);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(box, image_);
    if (!cross_px_) return;
    const QPointF at(box.left() + (cross_px_->x() + 0.5) * pixel_mm_.width() * scale,
                     box.top() + (cross_px_->y() + 0.5) * pixel_mm_.height() * scale);
    if (!box.contains(at)) return;
    painter.setRenderHint(QPainter::Antialiasing);
    // Beside the source the cross says where the same point would be; it is dashed, so not told by its colour alone.
    for (const auto& [colour, width] : {std::pair{QColor(Qt::black), 3.0}, std::pair{isSource_ ? theme.accent : theme.text, 1.5}}) {
      painter.setPen(QPen(colour, width, isSource_ ? Qt::SolidLine : Qt::DotLine));
      for (const QPointF& way : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)}) {
        painter.drawLine(at + 4.0 * way, at + 16.0 * way);
      }
    }
  }

 private:
  QImage image_;
  QSizeF pixel_mm_{1.0, 1.0};
  std::optional<QPointF> cross_px_;
  bool isSource_ = true;
  QString instead_;
};

namespace {

QLabel* sourceLabel(const char* name) {
  auto* label = new QLabel;
  label->setObjectName(QLatin1String(name));
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

}  // namespace

SourceDialog::SourceDialog(Jobs& jobs, QWidget* parent) : QDialog(parent), jobs_(jobs) {
  setObjectName(QStringLiteral("sourceDialog"));
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(tr("Where this comes from"));
  resize(520, 600);
  addRows();
}

SourceDialog::~SourceDialog() {
  if (job_ != 0) jobs_.cancel(job_);
}

void SourceDialog::addRows() {
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(16, 16, 16, 16);
  outer->setSpacing(8);
  sentence_ = new QLabel;
  sentence_->setObjectName(QStringLiteral("sourceSentence"));
  sentence_->setWordWrap(true);
  sentence_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  outer->addWidget(sentence_);
  image_ = new SourceImage;
  image_->setAccessibleName(tr("Source frame"));
  outer->addWidget(image_, 1);

  facts_ = new QWidget;
  auto* form = new QFormLayout(facts_);
  form->setContentsMargins(0, 0, 0, 0);
  form->setHorizontalSpacing(24);
  form->setVerticalSpacing(4);
  sweep_ = sourceLabel("sourceSweep");
  frame_ = sourceLabel("sourceFrame");
  time_ = sourceLabel("sourceTime");
  voxel_ = sourceLabel("sourceVoxel");
  distance_ = sourceLabel("sourceDistance");
  form->addRow(tr("Sweep"), sweep_);
  form->addRow(tr("Frame"), frame_);
  form->addRow(tr("Time"), time_);
  form->addRow(tr("Voxel"), voxel_);
  form->addRow(tr("Distance"), distance_);
  // Nothing below it moves when a sentence gets shorter.
  voxel_->setMinimumHeight(voxel_->fontMetrics().height() * 2);
  voxel_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  outer->addWidget(facts_);

  const auto button = [this](const QString& text, const char* name, const QString& tip) {
    auto* made = new QPushButton(text);
    made->setObjectName(QLatin1String(name));
    made->setToolTip(tip);
    made->setAccessibleName(tip);
    made->setAutoDefault(false);
    return made;
  };
  before_ = button(QStringLiteral("←"), "sourceBefore", tr("The frame before (Left)"));
  home_ = button(tr("Source frame"), "sourceHome", tr("Back to the frame the voxel came from (Home)"));
  after_ = button(QStringLiteral("→"), "sourceAfter", tr("The frame after (Right)"));
  auto* close = button(tr("Close"), "sourceClose", tr("Close (Escape)"));
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(8);
  buttons->addWidget(before_);
  buttons->addWidget(home_);
  buttons->addWidget(after_);
  buttons->addStretch(1);
  buttons->addWidget(close);
  outer->addLayout(buttons);

  connect(before_, &QPushButton::clicked, this, [this] { step(-1); });
  connect(after_, &QPushButton::clicked, this, [this] { step(1); });
  connect(home_, &QPushButton::clicked, this, &SourceDialog::goHome);
  connect(close, &QPushButton::clicked, this, &QDialog::close);
  // Buttons would take the arrows to walk among themselves.
  for (QPushButton* each : {before_, home_, after_, close}) each->installEventFilter(this);
}

bool SourceDialog::takesKey(int key) {
  switch (key) {
    case Qt::Key_Left:
      step(-1);
      return true;
    case Qt::Key_Right:
      step(1);
      return true;
    case Qt::Key_Home:
      goHome();
      return true;
    default:
      return false;
  }
}

void SourceDialog::keyPressEvent(QKeyEvent* event) {
  if (!takesKey(event->key())) QDialog::keyPressEvent(event);
}

bool SourceDialog::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::KeyPress && takesKey(static_cast<QKeyEvent*>(event)->key())) return true;
  return QDialog::eventFilter(watched, event);
}

void SourceDialog::goHome() {
  if (!shownFrame()) return;
  shown_ = source_.frame;
  showAll();
}

void SourceDialog::showSource(const std::shared_ptr<const Provenance>& provenance, const VoxelSource& source) {
  if (source.found == VoxelSource::Found::outside)
    return showNone(tr("This point lies outside the volume. Click a point inside it: the thin box in the 3D view shows where it ends."));
  if (source.found == VoxelSource::Found::absent)
    return showNone(
        tr("Nothing is known here: no frame of the sweep reached this voxel, and it lies too far from the others to be filled "
           "in."));
  if (provenance != provenance_) {
    if (job_ != 0) jobs_.cancel(job_);
    job_ = 0;
    images_.reset();
    problem_.clear();
  }
  provenance_ = provenance;
  source_ = source;
  shown_ = source.frame;
  none_.clear();
  read();
  showAll();
}

void SourceDialog::showNone(const QString& why) {
  none_ = why;
  showAll();
}

std::optional<std::size_t> SourceDialog::shownFrame() const {
  return provenance_ && none_.isEmpty() ? std::optional(shown_) : std::nullopt;
}

const QImage& SourceDialog::image() const { return image_->image(); }

std::optional<QPointF> SourceDialog::cross() const { return image_->cross(); }

void SourceDialog::step(int by) {
  if (!shownFrame()) return;
  const auto last = static_cast<std::ptrdiff_t>(provenance_->frames.size()) - 1;
  shown_ = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(shown_) + by, 0, last));
  showAll();
}

void SourceDialog::read() {
  if (images_ || job_ != 0) return;
  problem_.clear();
  auto found = std::make_shared<std::shared_ptr<const Sequence>>();
  auto id = std::make_shared<int>(0);
  *id = jobs_.start(
      tr("Reading the frames of %1").arg(wordsOf(provenance_->sweep.filename())),
      [found, provenance = provenance_](Progress& progress) -> Result<void> {
        auto images = readTracedImages(*provenance, progress);
        if (!images) return passOn(images.error());
        *found = std::make_shared<const Sequence>(std::move(*images));
        return {};
      },
      [here = QPointer<SourceDialog>(this), found, id](const Result<void>& outcome) {
        SourceDialog* dialog = here.data();
        if (dialog == nullptr || dialog->job_ != *id) return;
        dialog->job_ = 0;
        if (outcome) {
          dialog->images_ = *found;
        } else {
          dialog->problem_ = outcome.error().code == ErrorCode::cancelled ? tr("Reading was stopped. Ask again to go on.")
                                                                          : words(outcome.error().message);
        }
        dialog->showAll();
      });
  job_ = *id;
}

QString SourceDialog::wordsOfVoxel() const {
  switch (source_.coverage) {
    case Coverage::measured:
      return tr("measured: of all frames that reached it, a pixel of the source frame lies nearest");
    case Coverage::interpolated:
      return tr("invented: no pixel fell into it, it was filled from its neighbours, of which the source frame is the nearest");
    case Coverage::absent:
      return tr("absent");
  }
  return {};
}

void SourceDialog::showAll() {
  const bool hasFrame = shownFrame().has_value();
  sentence_->setText(none_);
  sentence_->setVisible(!hasFrame);
  image_->setVisible(hasFrame);
  facts_->setVisible(hasFrame);
  for (QPushButton* button : {before_, home_, after_}) button->setVisible(hasFrame);
  if (!hasFrame) {
    image_->show({}, {1.0, 1.0}, {}, true, {});
    return;
  }
  const FrameProvenance& frame = provenance_->frames[shown_];
  const bool isSource = shown_ == source_.frame;
  sweep_->setText(wordsOf(provenance_->sweep.filename()));
  sweep_->setToolTip(wordsOf(provenance_->sweep));
  const QString number = tr("%1 of %2").arg(frame.number + 1).arg(provenance_->recordedFrames);
  const int apart = static_cast<int>(shown_ > source_.frame ? shown_ - source_.frame : source_.frame - shown_);
  frame_->setText(isSource                 ? tr("%1, the source").arg(number)
                  : shown_ > source_.frame ? tr("%1, %n after the source", nullptr, apart).arg(number)
                                           : tr("%1, %n before the source", nullptr, apart).arg(number));
  time_->setText(frame.time_s ? tr("%1 s").arg(figure(*frame.time_s, 3)) : tr("not recorded"));
  voxel_->setText(wordsOfVoxel());
  const FrameProjection projection = projectionOnto(frame.imageToWorld, source_.at_recorded);
  distance_->setText(tr("%1 mm from the plane of this frame").arg(figure(projection.distance_mm, 2)));
  before_->setEnabled(shown_ > 0);
  after_->setEnabled(shown_ + 1 < provenance_->frames.size());
  home_->setEnabled(!isSource);

  QImage image;
  if (images_) {
    const std::span<const std::uint8_t> pixels = images_->framePixels(frame.number);
    image = QImage(pixels.data(), images_->width, images_->height, images_->width, QImage::Format_Grayscale8).copy();
  }
  const glm::dmat4& m = frame.imageToWorld.matrix;
  const QSizeF pixel_mm(glm::length(glm::dvec3(m[0])), glm::length(glm::dvec3(m[1])));
  image_->show(image, pixel_mm, QPointF(projection.at_px.x, projection.at_px.y), isSource,
               problem_.isEmpty() ? tr("Reading the recording…") : problem_);
  image_->setAccessibleDescription(frame_->text());
}

}  // namespace ew::ui
