#include "panel/comments_page.h"

#include <QLabel>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "ew/widgets/fields.h"
#include "ew/widgets/figures.h"
#include "ew/widgets/labels.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"
#include "panel/session/review_session.h"

namespace ew::review {

CommentsPage::CommentsPage(ReviewSession& session, QWidget* parent)
    : QWidget(parent),
      scans_(session.scans()),
      reviewer_(session.reviewer()),
      comments_(session.comments()),
      document_(session.document()) {
  setObjectName(QStringLiteral("reviewComments"));
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(2 * kGrid_px, 2 * kGrid_px, 2 * kGrid_px, 2 * kGrid_px);
  rows->setSpacing(kGrid_px);
  hint_ = quietLabel({});
  hint_->setObjectName(QStringLiteral("reviewCommentsHint"));
  rows->addWidget(hint_);
  list_ = new QListWidget;
  list_->setObjectName(QStringLiteral("reviewCommentList"));
  list_->setAccessibleName(tr("Comments"));
  list_->setWordWrap(true);
  connect(list_, &QListWidget::itemClicked, this, [this] { goTo(list_->currentRow()); });
  connect(list_, &QListWidget::itemActivated, this, [this] { goTo(list_->currentRow()); });
  rows->addWidget(list_, 2);
  text_ = new WithHostUndo<QPlainTextEdit>;
  text_->setObjectName(QStringLiteral("reviewCommentEdit"));
  text_->setAccessibleName(tr("Text of the comment"));
  text_->setTabChangesFocus(true);
  connect(text_, &QPlainTextEdit::textChanged, this, [this] {
    const ReviewComment* comment = chosen();
    if (showing_ || comment == nullptr) return;
    ReviewComment typed = *comment;
    typed.text = text_->toPlainText().left(5000).toStdString();
    comments_.edit(typed, tr("type a comment"), "text " + typed.id);
  });
  rows->addWidget(text_, 1);
  auto* buttons = new QHBoxLayout;
  remove_ = new QPushButton(tr("Remove"));
  remove_->setObjectName(QStringLiteral("reviewRemoveComment"));
  remove_->setToolTip(tr("Undo brings it back"));
  connect(remove_, &QPushButton::clicked, this, [this] { comments_.remove(comments_.chosen()); });
  save_ = new QPushButton(tr("Save"));
  save_->setObjectName(QStringLiteral("reviewSaveComments"));
  save_->setToolTip(tr("Keeps your comments beside the attempt (Ctrl+S); they are also kept when another scan is chosen"));
  connect(save_, &QPushButton::clicked, this, [this] { document_.save(false); });
  buttons->addWidget(remove_);
  buttons->addStretch(1);
  buttons->addWidget(save_);
  rows->addLayout(buttons);
  connect(&comments_, &AttemptComments::changed, this, &CommentsPage::refresh);
  // Saved or not is told to the window; the button follows.
  ticket_ = document_.onChanged([this] { showChosen(); });
  refresh();
}

void CommentsPage::refresh() {
  showing_ = true;
  rows_.clear();
  list_->clear();
  const ReviewScan* scan = scans_.opened(kReviewed);
  for (const ReviewComment& each : comments_.here()) rows_.push_back({each, {}});
  if (scan != nullptr && scan->scan->choice.outcome)
    for (const CommentFile& file : comments_.others())
      for (const ReviewComment& each : file.comments)
        if (each.stepId == scan->scan->choice.stepId && each.recording == scan->scan->choice.outcome->recording)
          rows_.push_back({each, reviewer_.called(file.author)});
  std::stable_sort(rows_.begin(), rows_.end(), [](const Row& a, const Row& b) { return a.comment.time_s < b.comment.time_s; });
  for (const Row& row : rows_) {
    QString text = row.comment.text.empty() ? tr("(drawing)") : words(row.comment.text);
    if (!row.comment.strokes.empty() && !row.comment.text.empty()) text += QStringLiteral("  ✎");
    if (!row.author.isEmpty()) text = tr("%1: %2", "author: comment").arg(row.author, text);
    const double begin_s = scan != nullptr ? scan->scan->part.begin_s : 0.0;
    auto* item = new QListWidgetItem(clockText(row.comment.time_s - begin_s) + QStringLiteral("   ") + text, list_);
    if (row.author.isEmpty() && row.comment.id == comments_.chosen()) list_->setCurrentItem(item);
  }
  const bool canWrite = comments_.history() != nullptr;
  hint_->setVisible(rows_.empty());
  hint_->setText(canWrite ? tr("No comments yet: write below the images what you see at a moment, and draw on the image.")
                          : tr("Comments are kept beside an attempt; choose a step that was recorded."));
  showing_ = false;
  showChosen();
}

const ReviewComment* CommentsPage::chosen() const {
  return comments_.history() != nullptr ? comments_.history()->find(comments_.chosen()) : nullptr;
}

void CommentsPage::showChosen() {
  showing_ = true;
  const ReviewComment* comment = chosen();
  const QString text = comment != nullptr ? words(comment->text) : QString();
  if (text_->toPlainText() != text) text_->setPlainText(text);
  text_->setVisible(comment != nullptr);
  remove_->setVisible(comment != nullptr);
  save_->setVisible(comments_.history() != nullptr);
  save_->setEnabled(comments_.history() != nullptr && !comments_.history()->isSaved());
  showing_ = false;
}

void CommentsPage::goTo(int row) {
  if (row < 0 || row >= static_cast<int>(rows_.size())) return;
  const Row went = rows_[static_cast<std::size_t>(row)];
  comments_.show(went.comment);
  if (!went.author.isEmpty()) comments_.choose({});
}

}  // namespace ew::review
