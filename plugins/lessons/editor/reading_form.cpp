#include "editor/reading_form.h"

#include <QDragEnterEvent>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QMimeData>
#include <QPixmap>
#include <QPushButton>
#include <QUrl>
#include <QVBoxLayout>

#include "editor/order_list.h"
#include "editor/step_image.h"
#include "ew/widgets/labels.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"
#include "logic/expert_recorder.h"

namespace ew::lessons {

namespace {

constexpr int kHighestPreview_px = 160;

}  // namespace

ReadingForm::ReadingForm(const StepEdit& edited, QWidget* parent) : TaskForm(edited, parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kGrid_px);
  setAcceptDrops(true);
  image_ = new QLabel;
  image_->setObjectName(QStringLiteral("chosenPicture"));
  column->addWidget(image_);
  auto* row = new QHBoxLayout;
  row->setSpacing(kGrid_px);
  auto* choose = smallButton(tr("Choose an image…"), "choosePicture",
                             tr("PNG or JPEG; it is kept without what is written in the file about patient, place and time"));
  remove_ = smallButton(tr("Remove it"), "removePicture", tr("The step goes without an image; undo brings it back"));
  row->addWidget(choose);
  row->addWidget(remove_);
  row->addStretch(1);
  column->addLayout(row);
  problem_ = problemLabel();
  problem_->setObjectName(QStringLiteral("picture_problem"));
  column->addWidget(problem_);
  connect(choose, &QPushButton::clicked, this, [this] {
    const QString file = QFileDialog::getOpenFileName(this, tr("Choose an image"), {}, tr("Images (*.png *.jpg *.jpeg)"));
    if (!file.isEmpty()) takeImage(file);
  });
  connect(remove_, &QPushButton::clicked, this, [this] {
    say(this->edited().changeTask<ReadingTask>(tr("Remove an image"), {}, [](ReadingTask& task) { task.image.clear(); }));
    showTask(false);
  });
}

void ReadingForm::showTask(bool) {
  const std::string name = edited().task<ReadingTask>().image;
  remove_->setVisible(!name.empty());
  if (name.empty()) return image_->setText(tr("No image."));
  const QPixmap image(words((edited().document.folder() / name).string()));
  if (image.isNull()) return image_->setText(tr("The image '%1' cannot be shown.").arg(words(name)));
  const QSize room(std::max(200, width()), kHighestPreview_px);
  image_->setPixmap(image.width() > room.width() || image.height() > room.height()
                        ? image.scaled(room, Qt::KeepAspectRatio, Qt::SmoothTransformation)
                        : image);
}

void ReadingForm::takeImage(const QString& file) {
  const auto clean = cleanImage(file.toStdString());
  if (!clean) return say(tl::unexpected(clean.error()));
  if (auto own = edited().document.makeOwn(); !own) return say(own);
  const auto name = keepBytes({clean->bytes.constData(), static_cast<std::size_t>(clean->bytes.size())}, edited().document.folder(),
                              "media", clean->ending);
  if (!name) return say(tl::unexpected(name.error()));
  say(edited().changeTask<ReadingTask>(tr("Choose an image"), {}, [&](ReadingTask& task) { task.image = *name; }));
  showTask(false);
}

void ReadingForm::dragEnterEvent(QDragEnterEvent* event) {
  const QList<QUrl> files = event->mimeData()->urls();
  if (files.size() == 1 && files.front().isLocalFile()) event->acceptProposedAction();
}

void ReadingForm::dropEvent(QDropEvent* event) {
  event->acceptProposedAction();
  takeImage(event->mimeData()->urls().front().toLocalFile());
}

void ReadingForm::say(const Result<void>& done) { setProblem(problem_, done ? QString() : words(done.error())); }

TaskForm* makeReadForm(const StepEdit& edited, QWidget* parent) { return new ReadingForm(edited, parent); }

}  // namespace ew::lessons
