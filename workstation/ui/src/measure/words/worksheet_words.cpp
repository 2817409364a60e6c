#include "measure/words/worksheet_words.h"

#include <QLocale>
#include <QStringList>
#include <algorithm>
#include <cmath>

#include "ew/widgets/figures.h"
#include "ew/widgets/words.h"
#include "measure/words/caliper_words.h"

namespace ew::ui {

using measurement::Quantity;
using measurement::RangeVerdict;
using measurement::Unit;
using measurement::Worksheet;
using measurement::WorksheetRow;

namespace {

constexpr double kDaysOfAWeek = 7.0;

QString localised(QString number) { return number.replace(QLatin1Char('.'), QLocale().decimalPoint()); }

QString verdictWord(RangeVerdict verdict) {
  switch (verdict) {
    case RangeVerdict::below:
      return WorksheetWords::tr("low");
    case RangeVerdict::within:
      return WorksheetWords::tr("usual");
    case RangeVerdict::above:
      return WorksheetWords::tr("high");
  }
  return {};
}

QString rangesOf(const WorksheetRow& row) {
  QStringList all;
  for (const auto& reading : row.ranges) {
    const QString range = localised(QString::fromStdString(rangeText(reading.range)));
    const QString verdict = verdictWord(reading.verdict);
    const QString whom = words(reading.range.applies);
    all << (whom.isEmpty()
                ? WorksheetWords::tr("%1 (usual: %2)", "verdict and range").arg(verdict, range)
                : WorksheetWords::tr("%1 (usual: %2; %3)", "verdict, range, and what is to be known of it").arg(verdict, range, whom));
  }
  for (const auto& chart : row.charts)
    all << WorksheetWords::tr("percentile %1 (%2 to %3), %4", "percentile, its range, and the chart")
               .arg(figure(chart.percentile, 0), figure(chart.lowPercentile, 0), figure(chart.highPercentile, 0), words(chart.title));
  return all.join(QStringLiteral("<br>"));
}

/// Where it comes from: measured several times, from other rows, or why there is nothing.
QString originOf(const WorksheetRow& row) {
  QStringList all;
  if (row.measured.size() > 1) {
    QStringList each;
    for (const Quantity& quantity : row.measured) each << localised(QString::fromStdString(shownValue(quantity)));
    all << WorksheetWords::tr("mean of %1", "of several values").arg(each.join(QStringLiteral("; ")));
  }
  if (!row.from.empty()) all << WorksheetWords::tr("by %1", "a formula").arg(words(row.from));
  if (row.isFormula && row.value && !row.inputs.empty()) {
    QStringList from;
    for (const auto& used : row.inputs)
      from << words(used.of) + QLatin1Char(' ') + WorksheetWords::textOf({used.value.value, 0.0, used.value.unit});
    all << WorksheetWords::tr("from %1", "values").arg(from.join(QStringLiteral(", ")));
  }
  for (const Message& remark : row.remarks) all << words(remark);
  return all.join(QStringLiteral("<br>")).toHtmlEscaped().replace(QStringLiteral("&lt;br&gt;"), QStringLiteral("<br>"));
}

QString valueOf(const WorksheetRow& row) {
  if (!row.choice.empty()) return words(row.choiceTitle).toHtmlEscaped();
  if (!row.value) return QStringLiteral("–");
  Quantity value = *row.value;
  value.uncertainty = std::hypot(value.uncertainty, row.predictionError);
  return WorksheetWords::textOf(value).replace(QLatin1Char(' '), QChar(QChar::Nbsp)).toHtmlEscaped();  // in one line
}

}  // namespace

QString WorksheetWords::sideOf(const std::string& side) { return side == "right" ? tr("right") : side == "left" ? tr("left") : QString(); }

QString WorksheetWords::textOf(const Quantity& quantity) {
  if (quantity.unit != Unit::weeks) return CaliperWords::textOf(quantity);
  const QString age = QString::fromStdString(measurement::gestationText(quantity.value));
  if (!(quantity.uncertainty > 0.0)) return age;
  const double days = kDaysOfAWeek * quantity.uncertainty;
  // Nothing is known to 0 days.
  return tr("%1 ± %2 d", "gestational age and days").arg(age, days < 0.95 ? figure(std::max(days, 0.1), 1) : figure(days, 0));
}

QString WorksheetWords::htmlOf(const Worksheet& sheet, const QString& quiet) {
  QString html;
  const auto quietly = [&](const QString& text) {
    return text.isEmpty() ? QString() : QStringLiteral("<span style='color:%1'>%2</span>").arg(quiet, text);
  };
  for (const auto& section : sheet.sections) {
    html += QStringLiteral("<h3>%1</h3><table width='100%' cellspacing='0' cellpadding='3'>").arg(words(section.title).toHtmlEscaped());
    for (const WorksheetRow& row : section.rows) {
      QString title = words(row.title).toHtmlEscaped();
      if (!row.side.empty()) title = tr("%1, %2", "what was measured, and its side").arg(title, sideOf(row.side));
      const QString below = originOf(row);
      html += QStringLiteral(
                  "<tr><td width='46%'>%1%2</td><td width='28%' align='right'><b><nobr>%3</nobr></b></td><td width='26%'>%4</td></tr>")
                  .arg(title, below.isEmpty() ? QString() : QStringLiteral("<br>") + quietly(below), valueOf(row), quietly(rangesOf(row)));
    }
    html += QStringLiteral("</table>");
  }
  if (sheet.redating) html += QStringLiteral("<p>%1</p>").arg(words(sentenceOf(*sheet.redating)).toHtmlEscaped());
  for (const auto& summary : sheet.summaries)
    html += QStringLiteral("<p><b>%1:</b> %2</p>").arg(words(summary.title).toHtmlEscaped(), words(summary.says).toHtmlEscaped());
  return html;
}

}  // namespace ew::ui
