#include "editor/read_form.h"

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
#include "editor/step_picture.h"
#include "ew/widgets/labels.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"
#include "logic/expert_recorder.h"

namespace ew::lessons {

namespace {

constexpr int kHighestPreview_px = 160;

}  // namespace

ReadForm::ReadForm(const EditedStep& edited, QWidget* parent) : TaskForm(edited, parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kGrid_px);
  setAcceptDrops(true);
  picture_ = new QLabel;
  picture_->setObjectName(QStringLiteral("chosenPicture"));
  column->addWidget(picture_);
  auto* row = new QHBoxLayout;
  row->setSpacing(kGrid_px);
  auto* choose = smallButton(tr("Choose a picture…"), "choosePicture",
                             tr("PNG or JPEG; it is kept without what is written in the file about patient, place and time"));
  remove_ = smallButton(tr("Remove it"), "removePicture", tr("The step goes without a picture; undo brings it back"));
  row->addWidget(choose);
  row->addWidget(remove_);
  row->addStretch(1);
  column->addLayout(row);
  problem_ = problemLabel();
  problem_->setObjectName(QStringLiteral("picture_problem"));
  column->addWidget(problem_);
  connect(choose, &QPushButton::clicked, this, [this] {
    const QString file = QFileDialog::getOpenFileName(this, tr("Choose a picture"), {}, tr("Pictures (*.png *.jpg *.jpeg)"));
    if (!file.isEmpty()) takePicture(file);
  });
  connect(remove_, &QPushButton::clicked, this, [this] {
    say(this->edited().changeTask<ReadTask>(tr("Remove a picture"), {}, [](ReadTask& task) { task.picture.clear(); }));
    showTask(false);
  });
}

void ReadForm::showTask(bool) {
  const std::string name = edited().task<ReadTask>().picture;
  remove_->setVisible(!name.empty());
  if (name.empty()) return picture_->setText(tr("No picture."));
  const QPixmap picture(words((edited().document.folder() / name).string()));
  if (picture.isNull()) return picture_->setText(tr("The picture '%1' cannot be shown.").arg(words(name)));
  const QSize room(std::max(200, width()), kHighestPreview_px);
  picture_->setPixmap(picture.width() > room.width() || picture.height() > room.height()
                          ? picture.scaled(room, Qt::KeepAspectRatio, Qt::SmoothTransformation)
                          : picture);
}

void ReadForm::takePicture(const QString& file) {
  const auto clean = cleanPicture(file.toStdString());
  if (!clean) return say(tl::unexpected(clean.error()));
  if (auto own = edited().document.makeOwn(); !own) return say(own);
  const auto name = keepBytes({clean->bytes.constData(), static_cast<std::size_t>(clean->bytes.size())}, edited().document.folder(),
                              "media", clean->ending);
  if (!name) return say(tl::unexpected(name.error()));
  say(edited().changeTask<ReadTask>(tr("Choose a picture"), {}, [&](ReadTask& task) { task.picture = *name; }));
  showTask(false);
}

void ReadForm::dragEnterEvent(QDragEnterEvent* event) {
  const QList<QUrl> files = event->mimeData()->urls();
  if (files.size() == 1 && files.front().isLocalFile()) event->acceptProposedAction();
}

void ReadForm::dropEvent(QDropEvent* event) {
  event->acceptProposedAction();
  takePicture(event->mimeData()->urls().front().toLocalFile());
}

void ReadForm::say(const Result<void>& done) { setProblem(problem_, done ? QString() : words(done.error())); }

TaskForm* makeReadForm(const EditedStep& edited, QWidget* parent) { return new ReadForm(edited, parent); }

}  // namespace ew::lessons
