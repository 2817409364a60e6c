#include "case/case_info.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QMouseEvent>
#include <QPushButton>
#include <QScrollArea>
#include <QSettings>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>
#include <vector>

#include "case/case_images.h"
#include "ew/library/case.h"
#include "ew/widgets/icons.h"
#include "ew/widgets/look.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"

namespace ew::ui {
namespace {

constexpr int kHead_px = 36;
const auto kOpenSetting = QStringLiteral("caseInfoOpen");

QString patientOf(const CasePatient& patient) {
  QStringList parts;
  if (!patient.name.empty()) parts << words(patient.name);
  if (patient.sex == "female") parts << CaseInfo::tr("female");
  if (patient.sex == "male") parts << CaseInfo::tr("male");
  if (patient.age_years) parts << CaseInfo::tr("%1 years").arg(*patient.age_years);
  return parts.join(QStringLiteral(", "));
}

QString examinationOf(const CaseExamination& examination) {
  QStringList head;
  for (const std::string& part : {examination.when, examination.kind})
    if (!part.empty()) head << words(part);
  const QString when = head.join(QStringLiteral(", "));
  return when.isEmpty() ? words(examination.findings) : CaseInfo::tr("%1: %2").arg(when, words(examination.findings));
}

/// An entry of the list: its name, and whether the name waits for the findings.
struct Entry {
  std::string name;
  bool revealsFinding = false;
};

std::vector<Entry> targetsOf(const Case& shown, CaseTarget::Kind kind) {
  std::vector<Entry> entries;
  for (const CaseTarget& target : shown.targets)
    if (target.kind == kind) entries.push_back({target.name, target.revealsFinding});
  return entries;
}

std::vector<Entry> measurementsOf(const Case& shown) {
  std::vector<Entry> entries;
  for (const CaseMeasurement& measurement : shown.measurements) entries.push_back({measurement.name, measurement.revealsFinding});
  return entries;
}

/// The words of an entry, which wrap where a check box would be cut off; a click on them ticks it.
class ItemLabel final : public QLabel {
 public:
  ItemLabel(const QString& text, QCheckBox& box) : QLabel(text), box_(box) {
    setTextFormat(Qt::PlainText);
    setWordWrap(true);
  }

 protected:
  void mousePressEvent(QMouseEvent* event) override { event->accept(); }
  void mouseReleaseEvent(QMouseEvent* event) override {
    if (event->button() == Qt::LeftButton && rect().contains(event->pos())) box_.toggle();
  }

 private:
  QCheckBox& box_;
};

}  // namespace

CaseInfo::CaseInfo(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("caseInfo"));
  setAttribute(Qt::WA_StyledBackground);
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(0, 1, 0, 0);  // the line above it
  rows->setSpacing(0);
  head_ = new QPushButton(tr("Case"));
  head_->setObjectName(QStringLiteral("caseInfoHead"));
  setLook(head_, Look::fold);
  holdFixedHeight(*head_, kHead_px);
  head_->setFocusPolicy(Qt::TabFocus);
  head_->setToolTip(tr("Patient, history, indication, and what is to be shown"));
  rows->addWidget(head_);
  scroll_ = new QScrollArea;
  scroll_->setWidgetResizable(true);
  scroll_->setFrameShape(QFrame::NoFrame);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll_->setFocusPolicy(Qt::NoFocus);
  rows->addWidget(scroll_, 1);
  connect(head_, &QPushButton::clicked, this, [this] {
    setOpen(!isOpen_);
    QSettings().setValue(kOpenSetting, isOpen_);
  });
  setOpen(QSettings().value(kOpenSetting, true).toBool());
  hide();
}

void CaseInfo::setOpen(bool open) {
  isOpen_ = open;
  scroll_->setVisible(open);
  refreshIcons();
  Q_EMIT opened(open);
}

void CaseInfo::refreshIcons() { head_->setIcon(icon(isOpen_ ? QStringLiteral("unfolded") : QStringLiteral("folded"))); }

int CaseInfo::headHeight_px() const { return scaled(kHead_px) + 1; }

int CaseInfo::wantedHeight_px() const {
  if (!isOpen_ || body_ == nullptr) return headHeight_px();
  const int inside_px = body_->layout()->hasHeightForWidth() ? body_->layout()->heightForWidth(width()) : body_->sizeHint().height();
  return headHeight_px() + inside_px;
}

void CaseInfo::showCase(const Case* shown) {
  if (shown == nullptr) {
    case_.clear();
    contents_.reset();
    hide();
    return;
  }
  const std::string place = shown->folder.string();  // copies of a case have the same id
  const bool isAnother = place != case_ || isHidden();
  if (!isAnother && contents_ == *shown) return;
  if (place != case_) showsFindings_ = false;
  case_ = place;
  contents_ = *shown;
  words_ = ew::wordsOf(shown->folder, QLocale().name().toStdString());
  fill(translated(*shown, words_));
  show();
  Q_EMIT contentsChanged();
}

void CaseInfo::fill(const Case& shown) {
  body_ = new QWidget;
  body_->setObjectName(QStringLiteral("caseInfoBody"));
  rows_ = new QVBoxLayout(body_);
  rows_->setContentsMargins(16, 0, 16, 16);
  rows_->setSpacing(4);
  const QString patient = patientOf(shown.patient);
  if (!patient.isEmpty()) addText(patient)->setObjectName(QStringLiteral("caseInfoPatient"));
  if (!shown.complaint.empty()) {
    addHeading(tr("Complaint"));
    addText(words(shown.complaint));
  }
  if (!shown.indication.empty()) {
    addHeading(tr("Indication"));
    addText(words(shown.indication));
  }
  if (!shown.history.empty()) {
    addHeading(tr("History"));
    addText(words(shown.history));
  }
  if (!shown.previousExaminations.empty()) {
    addHeading(tr("Previous examinations"));
    for (const CaseExamination& examination : shown.previousExaminations) {
      addText(examinationOf(examination));
      if (!examination.images.empty()) rows_->addWidget(caseImages(shown.folder, examination.images, examinationOf(examination)));
    }
  }
  if (!shown.laboratory.empty()) {
    addHeading(tr("Laboratory"));
    for (const CaseLaboratory& values : shown.laboratory)
      addText(values.when.empty() ? words(values.findings) : tr("%1: %2").arg(words(values.when), words(values.findings)));
  }
  addList(shown);
  if (!shown.findings.empty() || !shown.diagnosis.empty()) {
    rows_->addSpacing(12);
    findingsButton_ = new QPushButton;
    findingsButton_->setObjectName(QStringLiteral("showFindings"));
    findingsButton_->setFocusPolicy(Qt::TabFocus);
    findingsButton_->setText(showsFindings_ ? tr("Hide findings") : tr("Show findings"));
    findingsButton_->setToolTip(tr("What a good report says: look after your own examination"));
    rows_->addWidget(findingsButton_, 0, Qt::AlignLeft);
    connect(findingsButton_, &QPushButton::clicked, this, [this, shown] {
      showsFindings_ = !showsFindings_;
      // The button is part of what is made anew.
      QMetaObject::invokeMethod(
          this,
          [this, shown] {
            if (shown.folder.string() != case_) return;
            fill(shown);
            Q_EMIT contentsChanged();
          },
          Qt::QueuedConnection);
    });
    if (showsFindings_) {
      for (const std::string& finding : shown.findings) addText(words(finding))->setObjectName(QStringLiteral("caseInfoFinding"));
      if (!shown.diagnosis.empty()) {
        addHeading(tr("Diagnosis"));
        addText(words(shown.diagnosis))->setObjectName(QStringLiteral("caseInfoDiagnosis"));
      }
      if (!shown.differential.empty()) {
        addHeading(tr("Differential diagnosis"));
        for (const std::string& other : shown.differential) addText(words(other));
      }
    }
  }
  rows_->addStretch(1);
  scroll_->setWidget(body_);  // deletes the one before
}

void CaseInfo::addHeading(const QString& text) {
  rows_->addSpacing(8);
  auto* label = new QLabel(text);
  setLook(label, Look::quiet);
  setLook(label, Look::small);
  rows_->addWidget(label);
}

QLabel* CaseInfo::addText(const QString& text, bool quiet) {
  auto* label = new QLabel(text);
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  setLook(label, Look::quiet, quiet);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  label->setFocusPolicy(Qt::NoFocus);
  rows_->addWidget(label);
  return label;
}

void CaseInfo::addList(const Case& shown) {
  int waiting = 0;
  const auto add = [&](const QString& title, const std::vector<Entry>& entries) {
    const auto isShown = [this](const Entry& entry) { return showsFindings_ || !entry.revealsFinding; };
    waiting += static_cast<int>(std::count_if(entries.begin(), entries.end(), [&](const Entry& entry) { return !isShown(entry); }));
    if (std::none_of(entries.begin(), entries.end(), isShown)) return;
    addHeading(title);
    for (const Entry& entry : entries) {
      if (!isShown(entry)) continue;
      auto* box = new QCheckBox;
      box->setObjectName(QStringLiteral("caseInfoItem"));
      box->setFocusPolicy(Qt::TabFocus);
      box->setAccessibleName(words(words_.of(entry.name)));
      box->setChecked(ticked_[case_].count(entry.name) > 0);
      auto* line = new QHBoxLayout;
      line->setSpacing(8);
      line->addWidget(box, 0, Qt::AlignTop);
      line->addWidget(new ItemLabel(words(words_.of(entry.name)), *box), 1);
      rows_->addLayout(line);
      connect(box, &QCheckBox::toggled, this, [this, id = case_, name = entry.name](bool on) {
        if (on) {
          ticked_[id].insert(name);
        } else {
          ticked_[id].erase(name);
        }
      });
    }
  };
  add(tr("Planes to show"), targetsOf(shown, CaseTarget::Kind::plane));
  add(tr("Structures to show"), targetsOf(shown, CaseTarget::Kind::structure));
  add(tr("Points to find"), targetsOf(shown, CaseTarget::Kind::point));
  add(tr("To measure"), measurementsOf(shown));
  if (waiting > 0) {
    setLook(addText(tr("%n more with the findings", nullptr, waiting), true), Look::small);
  }
}

}  // namespace ew::ui
