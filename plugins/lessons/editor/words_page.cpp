#include "editor/words_page.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

#include "editor/order_list.h"
#include "ew/widgets/labels.h"
#include "ew/widgets/look.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"

namespace ew::lessons {

std::vector<std::string> textsWithout(const std::vector<std::string>& texts, const CaseWords& words) {
  std::vector<std::string> missing;
  std::copy_if(texts.begin(), texts.end(), std::back_inserter(missing), [&](const std::string& text) { return !words.has(text); });
  return missing;
}

WordsPage::WordsPage(LessonDocument& document, QWidget* parent) : QWidget(parent), document_(document) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(2 * kGrid_px, kGrid_px, 2 * kGrid_px, 2 * kGrid_px);
  column->setSpacing(kGrid_px);
  auto* top = new QHBoxLayout;
  auto* back = smallButton(tr("Lessons"), "backFromWords", tr("Back to the lessons of the case"));
  connect(back, &QPushButton::clicked, this, &WordsPage::backAsked);
  language_ = new QComboBox;
  language_->setObjectName(QStringLiteral("wordsLanguage"));
  language_->setAccessibleName(tr("Language of the translation"));
  for (const auto& [id, name] :
       {std::pair<const char*, QString>{"de", tr("German")}, {"en", tr("English")}, {"fr", tr("French")}, {"es", tr("Spanish")}})
    language_->addItem(name, QString::fromLatin1(id));
  top->addWidget(back);
  top->addStretch(1);
  top->addWidget(language_);
  column->addLayout(top);
  column->addWidget(headingLabel(tr("Translations")));
  count_ = quietLabel({});
  count_->setObjectName(QStringLiteral("wordsCount"));
  column->addWidget(count_);
  onlyMissing_ = new QCheckBox(tr("Only texts that have none yet"));
  onlyMissing_->setObjectName(QStringLiteral("onlyMissingWords"));
  onlyMissing_->setChecked(true);
  column->addWidget(onlyMissing_);
  list_ = new QListWidget;
  list_->setObjectName(QStringLiteral("wordsTexts"));
  list_->setAccessibleName(tr("Texts"));
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setUniformItemSizes(true);
  column->addWidget(list_, 2);
  original_ = new QLabel;
  original_->setObjectName(QStringLiteral("wordsOriginal"));
  original_->setWordWrap(true);
  original_->setTextFormat(Qt::PlainText);
  original_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  original_->setFocusPolicy(Qt::NoFocus);
  column->addWidget(original_);
  translation_ = new QPlainTextEdit;
  translation_->setObjectName(QStringLiteral("wordsTranslation"));
  translation_->setTabChangesFocus(true);
  translation_->setPlaceholderText(tr("what is shown in its place"));
  translation_->setAccessibleName(tr("Translation"));
  column->addWidget(translation_, 1);
  keep_ = smallButton(tr("Keep and go to the next"), "keepWords", tr("Written into the case folder at once"));
  setLook(keep_, Look::primary);
  column->addWidget(keep_, 0, Qt::AlignLeft);
  connect(language_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &WordsPage::showTexts);
  connect(onlyMissing_, &QCheckBox::toggled, this, &WordsPage::showTexts);
  connect(list_, &QListWidget::currentRowChanged, this, &WordsPage::showChosen);
  connect(keep_, &QPushButton::clicked, this, &WordsPage::keep);
}

std::string WordsPage::language() const { return language_->currentData().toString().toStdString(); }

void WordsPage::showTexts() {
  const auto& home = document_.home();
  if (!home) return;
  const std::string chosen = list_->currentRow() >= 0 ? texts_[static_cast<std::size_t>(list_->currentRow())] : std::string();
  const std::string typed = translation_->toPlainText().toStdString();
  words_ = wordsOf(home->folder, language());
  const std::vector<std::string> all = textsOf(*home, document_.lessons());
  const std::vector<std::string> missing = textsWithout(all, words_);
  texts_ = onlyMissing_->isChecked() ? missing : all;
  count_->setText(missing.empty() ? tr("Every text has a translation.")
                                  : tr("%1 of %2 texts have none yet.").arg(missing.size()).arg(all.size()));
  const QSignalBlocker quiet(list_);
  list_->clear();
  for (const std::string& text : texts_) {
    auto* item = new QListWidgetItem(words(text).simplified(), list_);
    item->setToolTip(words(text));
    QFont font = item->font();
    font.setBold(!words_.has(text));  // what is still to do stands out, also in the list of all
    item->setFont(onlyMissing_->isChecked() ? list_->font() : font);
  }
  const auto kept = std::find(texts_.begin(), texts_.end(), chosen);
  const bool isSame = kept != texts_.end();
  list_->setCurrentRow(isSame ? static_cast<int>(kept - texts_.begin()) : texts_.empty() ? -1 : 0);
  showChosen();
  if (isSame && !typed.empty() && !words_.has(chosen)) translation_->setPlainText(words(typed));
}

void WordsPage::showChosen() {
  const int row = list_->currentRow();
  const bool isOne = row >= 0 && row < static_cast<int>(texts_.size());
  const std::string text = isOne ? texts_[static_cast<std::size_t>(row)] : std::string();
  original_->setText(words(text));
  translation_->setPlainText(isOne && words_.has(text) ? words(words_.of(text)) : QString());
  original_->setVisible(isOne);
  translation_->setVisible(isOne);
  keep_->setVisible(isOne);
}

void WordsPage::keep() {
  const int row = list_->currentRow();
  if (row < 0 || !document_.home()) return;
  if (auto own = document_.makeOwn(); !own) {
    Q_EMIT failed(words(own.error()));
    return;
  }
  const std::string text = texts_[static_cast<std::size_t>(row)];
  const auto kept = setCaseWord(document_.home()->folder, language(), text, translation_->toPlainText().trimmed().toStdString());
  Q_EMIT failed(kept ? QString() : words(kept.error()));
  if (!kept) return;
  translation_->clear();
  const std::string next = static_cast<std::size_t>(row) + 1 < texts_.size() ? texts_[static_cast<std::size_t>(row) + 1] : std::string();
  showTexts();
  const auto at = std::find(texts_.begin(), texts_.end(), next);
  if (at != texts_.end()) list_->setCurrentRow(static_cast<int>(at - texts_.begin()));
  translation_->setFocus();
}

}  // namespace ew::lessons
