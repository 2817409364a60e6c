#include "panel/rating_page.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "ew/sdk/window.h"
#include "ew/widgets/fields.h"
#include "ew/widgets/labels.h"
#include "ew/widgets/look.h"
#include "ew/widgets/scroll_rows.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"
#include "panel/session/review_session.h"

namespace ew::review {

namespace {

constexpr int kNotApplicable = -1001, kOpen = -1002;  // beyond every scale
constexpr int kPause_ms = 1500;                       // in typing

QString in(const Words& text) { return words(text.in(QLocale().name().toStdString())); }

QComboBox* combo(const char* name, const QString& spoken) {
  auto* made = new QComboBox;
  made->setObjectName(QLatin1String(name));
  made->setAccessibleName(spoken);
  made->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  made->setMinimumContentsLength(8);
  return made;
}

}  // namespace

RatingPage::RatingPage(ReviewSession& session, QWidget* parent)
    : QWidget(parent),
      host_(session.host()),
      selection_(session.selection()),
      reviewer_(session.reviewer()),
      lessonScores_(session.scores()) {
  setObjectName(QStringLiteral("reviewRating"));
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(0, 0, 0, 0);
  auto* scroll = new ScrollRows(2 * kGrid_px);
  auto* rows = scroll->rows();
  form_ = combo("ratingForm", tr("Rating form"));
  if (const auto resources = resourceFolder()) forms_ = listRatingForms(*resources, libraryFolder());
  for (const RatingForm& each : forms_.forms)
    if (forms_.find(each.id) == &each) form_->addItem(in(each.title), words(each.id));
  connect(form_, qOverload<int>(&QComboBox::activated), this, [this] {
    if (!keepDraft()) form_->setCurrentIndex(form_->findData(words(madeFor_)));  // what could not be kept stays in sight
    refresh();
  });
  rows->addWidget(form_);
  blind_ = quietLabel({});
  blind_->setObjectName(QStringLiteral("ratingBlind"));
  rows->addWidget(blind_);
  problem_ = problemLabel();
  problem_->setObjectName(QStringLiteral("ratingProblem"));
  rows->addWidget(problem_);
  makeBody();
  rows->addWidget(body_);
  rows->addStretch(1);
  outer->addWidget(scroll);
  idle_.setSingleShot(true);
  idle_.setInterval(kPause_ms);
  connect(&idle_, &QTimer::timeout, this, &RatingPage::keepDraft);
  held_ = session.document().holdWork(
      {[this] { return keepDraft(); }, [this] { return keepDraft() ? std::string() : tr("A rating could not be kept.").toStdString(); }});
  connect(&selection_, &ReviewSelection::changed, this, &RatingPage::refresh);
  connect(&reviewer_, &Reviewer::changed, this, [this] {
    attempt_.clear();
    read_.reset();  // it was kept before the name changed
    refresh();
  });
  refresh();
}

/// All that is filled in, and what becomes of it.
void RatingPage::makeBody() {
  body_ = new QWidget;
  auto* inner = new QVBoxLayout(body_);
  inner->setContentsMargins(0, 0, 0, 0);
  inner->setSpacing(kGrid_px);
  auto* holder = new QWidget;
  items_ = new QVBoxLayout(holder);
  items_->setContentsMargins(0, 0, 0, 0);
  items_->setSpacing(kGrid_px / 2);
  inner->addWidget(holder);
  remark_ = new QPlainTextEdit;
  remark_->setObjectName(QStringLiteral("ratingRemark"));
  remark_->setPlaceholderText(tr("On the whole"));
  remark_->setAccessibleName(tr("Remark on the whole"));
  remark_->setTabChangesFocus(true);
  holdFixedHeight(*remark_, 64);
  connect(remark_, &QPlainTextEdit::textChanged, this, [this] { showTotal(); });
  inner->addWidget(remark_);
  level_ = combo("ratingLevel", tr("Kind of examination"));
  connect(level_, qOverload<int>(&QComboBox::activated), this, [this] { showTotal(); });
  inner->addWidget(level_);
  total_ = headingLabel({});
  total_->setObjectName(QStringLiteral("ratingTotal"));
  inner->addWidget(total_);
  kept_ = quietLabel({});
  kept_->setObjectName(QStringLiteral("ratingKept"));
  inner->addWidget(kept_);
  auto* buttons = new QHBoxLayout;
  draft_ = new QPushButton(tr("Keep as a draft"));
  draft_->setObjectName(QStringLiteral("ratingDraft"));
  draft_->setToolTip(tr("Happens by itself as well: after a pause, and before another attempt is chosen"));
  connect(draft_, &QPushButton::clicked, this, [this] { keep(false); });
  finish_ = new QPushButton(tr("Finish"));
  finish_->setObjectName(QStringLiteral("ratingFinish"));
  setLook(finish_, Look::primary);
  finish_->setToolTip(tr("Counts from now on; another one by you would be the next revision, and this one is kept"));
  connect(finish_, &QPushButton::clicked, this, [this] { keep(true); });
  buttons->addWidget(draft_, 1);
  buttons->addWidget(finish_, 1);
  inner->addLayout(buttons);
  others_ = quietLabel({});
  others_->setObjectName(QStringLiteral("ratingOthers"));
  inner->addWidget(others_);
}

const RatingForm* RatingPage::shownForm() const { return forms_.find(madeFor_); }

const RatingForm* RatingPage::form() const { return forms_.find(form_->currentData().toString().toStdString()); }

void RatingPage::refresh() {
  const bool hasAttempt = selection_.attempt() != nullptr, hasName = !reviewer_.name().isEmpty();
  setProblem(problem_, {});
  body_->setVisible(hasAttempt && hasName && form() != nullptr);
  blind_->setText(form() == nullptr        ? tr("No rating form was found.")
                  : !hasAttempt            ? tr("Choose an attempt to rate it.")
                  : !hasName               ? tr("Say who you are, above; a rating is kept under the name of its rater.")
                  : reviewer_.showsNames() ? tr("Names are shown: this rating does not count as blinded.")
                                           : tr("Blinded: names are not shown, and others' ratings only when yours is finished."));
  if (body_->isHidden()) {
    attempt_.clear();
    read_.reset();
    return;
  }
  const std::filesystem::path folder = selection_.attempt()->first;
  if (madeFor_ != form()->id) {
    makeItems();
    attempt_.clear();
  }
  if (attempt_ == folder) return;  // what was typed stays
  attempt_ = folder;
  readRating();
}

void RatingPage::makeItems() {
  showing_ = true;
  while (QLayoutItem* item = items_->takeAt(0)) {
    if (item->widget() != nullptr) item->widget()->deleteLater();
    delete item;
  }
  scores_.clear();
  remarks_.clear();
  madeFor_ = form()->id;
  for (const RatingItem& item : form()->items) {
    auto* title = new QLabel(in(item.title));
    title->setWordWrap(true);
    title->setToolTip(in(item.description));
    items_->addWidget(title);
    auto* score = new WheelWithFocus<QComboBox>;
    score->setObjectName(QStringLiteral("rating_") + words(item.id));
    score->setAccessibleName(in(item.title));
    score->setAccessibleDescription(in(item.description));
    score->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    score->setMinimumContentsLength(8);
    score->setFocusPolicy(Qt::StrongFocus);
    score->addItem(QStringLiteral("–"), kOpen);
    for (int n = form()->lowest; n <= form()->highest; ++n) {
      QString text = QString::number(n);
      for (const RatingAnchor& anchor : item.anchors)
        if (anchor.score == n) text += QStringLiteral("  ") + in(anchor.text);
      score->addItem(text, n);
      score->setItemData(score->count() - 1, text, Qt::ToolTipRole);
    }
    if (item.mayBeNotApplicable) score->addItem(tr("not applicable"), kNotApplicable);
    connect(score, qOverload<int>(&QComboBox::currentIndexChanged), this, [this, score] {
      score->setToolTip(score->currentText());
      showTotal();
    });
    items_->addWidget(score);
    auto* remark = new QLineEdit;
    remark->setObjectName(QStringLiteral("remark_") + words(item.id));
    remark->setMaxLength(2000);
    remark->setPlaceholderText(tr("Remark"));
    remark->setAccessibleName(tr("Remark on %1").arg(in(item.title)));
    connect(remark, &QLineEdit::textChanged, this, [this] { showTotal(); });
    items_->addWidget(remark);
    items_->addSpacing(kGrid_px / 2);
    scores_[item.id] = score;
    remarks_[item.id] = remark;
  }
  level_->clear();
  for (const RatingPassLevel& each : form()->passLevels) {
    level_->addItem(in(each.title), words(each.id));
    level_->setItemData(level_->count() - 1, words(each.source), Qt::ToolTipRole);
  }
  level_->setVisible(level_->count() > 1);
  showing_ = false;
}

/// The reviewer's own draft, else what they finished last, else an empty form.
void RatingPage::readRating() {
  showing_ = true;
  for (auto& [id, score] : scores_) score->setCurrentIndex(0);
  for (auto& [id, remark] : remarks_) remark->clear();
  remark_->clear();
  kept_->clear();
  const RatingRecords seen = ratingsVisibleTo(reviewer_.name().toStdString(), attempt_);
  for (const RatingRecord& each : seen.ratings) {
    if (each.rating.rater != reviewer_.name().toStdString() || each.rating.formId != madeFor_) continue;
    for (auto& [id, score] : scores_) {
      const ItemRating* item = each.rating.itemOf(id);
      score->setCurrentIndex(item == nullptr || item->isOpen ? 0 : std::max(0, score->findData(item->score.value_or(kNotApplicable))));
      remarks_.at(id)->setText(item == nullptr ? QString() : words(item->remark));
    }
    remark_->setPlainText(words(each.rating.remark));
    if (!each.rating.passLevel.empty()) level_->setCurrentIndex(std::max(0, level_->findData(words(each.rating.passLevel))));
    kept_->setText(each.rating.finished ? tr("Finished, revision %1").arg(each.rating.revision) : tr("A draft, which does not count yet"));
  }
  if (!seen.problems.empty()) setProblem(problem_, words(seen.problems.front()));
  read_ = rating(false);
  showing_ = false;
  showTotal();
  showOthers();
}

void RatingPage::showOthers() {
  const RatingRecords seen = ratingsVisibleTo(reviewer_.name().toStdString(), attempt_);
  QStringList lines;
  for (const RatingRecord& each : seen.ratings) {
    if (each.rating.rater == reviewer_.name().toStdString() || !each.rating.finished) continue;
    const auto total = totalOf(*each.form, each.rating);
    lines << tr("%1, %2: %3", "rater, form: total")
                 .arg(reviewer_.called(each.rating.rater), in(each.form->title),
                      total ? QLocale().toString(*total, 'f', 2) : QStringLiteral("–"));
  }
  if (seen.hiddenRaters > 0)
    lines << (seen.hiddenRaters == 1 ? tr("Another rater has finished; you see it when you have.")
                                     : tr("%1 other raters have finished; you see it when you have.").arg(seen.hiddenRaters));
  others_->setText(lines.join(QLatin1Char('\n')));
  others_->setVisible(!lines.isEmpty());
}

Rating RatingPage::rating(bool finished) const {
  Rating made;
  made.rater = reviewer_.name().toStdString();
  if (shownForm()->passLevels.size() > 1) made.passLevel = level_->currentData().toString().toStdString();
  for (const RatingItem& item : shownForm()->items) {
    const int score = scores_.at(item.id)->currentData().toInt();
    const std::string remark = remarks_.at(item.id)->text().toStdString();
    if (score == kOpen && (finished || remark.empty())) continue;
    made.items.push_back(
        {item.id, score == kOpen || score == kNotApplicable ? std::nullopt : std::optional(score), remark, score == kOpen});
  }
  made.remark = remark_->toPlainText().left(5000).toStdString();
  made.sawName = reviewer_.showsNames();
  made.at = std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
  made.finished = finished;
  return made;
}

void RatingPage::showTotal() {
  const RatingForm* of = shownForm();
  if (showing_ || of == nullptr) return;
  if (isChanged()) idle_.start();
  const Rating now = rating(true);
  const auto total = totalOf(*of, now);
  const auto passed = checkRating(*of, now) ? passedBy(*of, now) : std::nullopt;
  QString text = total ? tr("Total %1 of %2").arg(QLocale().toString(*total, 'f', 2)).arg(of->highest) : tr("No item is rated yet");
  if (passed) text += QStringLiteral(": ") + (*passed ? tr("passed") : tr("not passed"));
  total_->setText(text);
}

bool RatingPage::isChanged() const {
  if (!read_ || attempt_.empty() || shownForm() == nullptr) return false;
  const Rating now = rating(false);
  return now.items != read_->items || now.remark != read_->remark || now.passLevel != read_->passLevel;
}

/// @return false: something was typed and could not be kept
bool RatingPage::keepDraft() {
  idle_.stop();
  if (!isChanged() || keep(false)) return true;
  host_.window().error(problem_->text().toStdString(), "review rating");
  return false;
}

bool RatingPage::keep(bool finished) {
  const auto kept = keepRating(attempt_, *shownForm(), rating(finished));
  setProblem(problem_, kept ? QString() : words(kept.error()));
  if (!kept) return false;
  read_ = rating(false);
  idle_.stop();
  kept_->setText(kept->finished ? tr("Finished, revision %1").arg(kept->revision) : tr("A draft, which does not count yet"));
  showOthers();
  if (kept->finished) lessonScores_.takeRating(attempt_);
  return true;
}

}  // namespace ew::review
