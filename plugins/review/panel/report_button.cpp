#include "panel/report_button.h"

#include <QFileDialog>
#include <QVariant>

namespace ew::review {

ReportButton::ReportButton(ReviewSession& session, bool isOfClass, QWidget* parent)
    : QPushButton(isOfClass ? tr("Report on the class …") : tr("Report …"), parent), session_(session), isOfClass_(isOfClass) {
  setObjectName(isOfClass ? QStringLiteral("classReport") : QStringLiteral("attemptReport"));
  setToolTip(isOfClass ? tr("Writes a page or a PDF about all attempts at this lesson; names are in it only while they are shown")
                       : tr("Writes a page or a PDF about this attempt; the name is in it only while names are shown"));
  setProperty("session", QVariant::fromValue<QObject*>(&session_));
  connect(this, &QPushButton::clicked, this, &ReportButton::ask);
}

void ReportButton::ask() {
  const QString pdf = tr("PDF (*.pdf)"), page = tr("Page for browsers (*.html)");
  QString kind = pdf;
  QString file = QFileDialog::getSaveFileName(this, tr("Save the report"), isOfClass_ ? tr("class.pdf") : tr("attempt.pdf"),
                                              pdf + QStringLiteral(";;") + page, &kind);
  if (file.isEmpty()) return;
  const QString ending = kind == page ? QStringLiteral(".html") : QStringLiteral(".pdf");
  if (!file.endsWith(QStringLiteral(".pdf"), Qt::CaseInsensitive) && !file.endsWith(QStringLiteral(".html"), Qt::CaseInsensitive))
    file += ending;
  session_.writeReport(file.toStdString(), isOfClass_);
}

}  // namespace ew::review
