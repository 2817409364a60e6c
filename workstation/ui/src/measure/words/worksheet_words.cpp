#include "measure/words/worksheet_words.h"

#include <QLocale>
#include <QStringList>
#include <vector>

#include "ew/measurement/worksheet_line.h"
#include "ew/widgets/words.h"

namespace ew::ui {
namespace {

QString oneUnderAnother(const std::vector<Message>& lines) {
  QStringList all;
  for (const Message& line : lines) all << words(line).toHtmlEscaped();
  return all.join(QStringLiteral("<br>"));
}

}  // namespace

QString WorksheetWords::sideOf(const std::string& side) { return side == "right" ? tr("right") : side == "left" ? tr("left") : QString(); }

QString WorksheetWords::htmlOf(const measurement::Worksheet& sheet, const QString& quiet) {
  const std::string language = QLocale().name().toStdString();
  QString html;
  const auto quietly = [&](const QString& text) {
    return text.isEmpty() ? QString() : QStringLiteral("<span style='color:%1'>%2</span>").arg(quiet, text);
  };
  for (const auto& section : sheet.sections) {
    html += QStringLiteral("<h3>%1</h3><table width='100%' cellspacing='0' cellpadding='3'>").arg(words(section.title).toHtmlEscaped());
    for (const measurement::WorksheetRow& row : section.rows) {
      const measurement::WorksheetLine line = lineOf(row, language);
      const QString below = oneUnderAnother(line.origin);
      html += QStringLiteral(
                  "<tr><td width='46%'>%1%2</td><td width='28%' align='right'><b><nobr>%3</nobr></b></td><td width='26%'>%4</td></tr>")
                  .arg(words(line.title).toHtmlEscaped(), below.isEmpty() ? QString() : QStringLiteral("<br>") + quietly(below),
                       words(line.value).toHtmlEscaped(), quietly(oneUnderAnother(line.against)));
    }
    html += QStringLiteral("</table>");
  }
  if (sheet.redating) html += QStringLiteral("<p>%1</p>").arg(words(sentenceOf(*sheet.redating)).toHtmlEscaped());
  for (const auto& summary : sheet.summaries)
    html += QStringLiteral("<p><b>%1:</b> %2</p>").arg(words(summary.title).toHtmlEscaped(), words(summary.says).toHtmlEscaped());
  return html;
}

}  // namespace ew::ui
