#include "panel/report_button.h"

#include "panel/session/review_reports.h"

namespace ew::review {

ReportButton::ReportButton(ReviewReports& reports, bool isOfClass, QWidget* parent)
    : QPushButton(isOfClass ? tr("Report on the class …") : tr("Report …"), parent), reports_(reports), isOfClass_(isOfClass) {
  setObjectName(isOfClass ? QStringLiteral("classReport") : QStringLiteral("attemptReport"));
  setToolTip(isOfClass ? tr("Writes a page or a PDF about all attempts at this lesson; names are in it only while they are shown")
                       : tr("Writes a page or a PDF about this attempt; the name is in it only while names are shown"));
  connect(this, &QPushButton::clicked, this, &ReportButton::ask);
}

void ReportButton::ask() {
  const QString kinds = tr("PDF (*.pdf)") + QStringLiteral(";;") + tr("Page for browsers (*.html)");
  reports_.ask({.title = tr("Save the report").toStdString(),
                .proposal = (isOfClass_ ? tr("class.pdf") : tr("attempt.pdf")).toStdString(),
                .filter = kinds.toStdString(),
                .endings = {".pdf", ".html"},
                .isDated = true},
               isOfClass_);
}

}  // namespace ew::review
