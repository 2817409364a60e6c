#include "measure/worksheets/worksheet_file.h"

#include <QBuffer>
#include <QLocale>
#include <QPageLayout>
#include <QPdfWriter>
#include <QTextDocument>
#include <QUrl>
#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "ew/core/ending.h"
#include "ew/io/safe_file.h"
#include "ew/widgets/words.h"
#include "measure/words/worksheet_words.h"

namespace ew::ui {
namespace {

constexpr int kResolution_dpi = 300;
constexpr double kText_pt = 10.0;

/// Two in a row, each with its caption.
QString picturesOf(const std::vector<ReportPicture>& pictures, QTextDocument& document) {
  if (pictures.empty()) return {};
  constexpr int kWidth_px = 310;  // of a page of 96 dpi, half of what its margins leave
  QString html = QStringLiteral("<h3>%1</h3><table cellspacing='8'>").arg(WorksheetWords::tr("Images"));
  for (std::size_t n = 0; n < pictures.size(); ++n) {
    const QString name = QStringLiteral("picture%1").arg(n);
    document.addResource(QTextDocument::ImageResource, QUrl(name), pictures[n].picture);
    if (n % 2 == 0) html += QStringLiteral("<tr>");
    html += QStringLiteral("<td><img src='%1' width='%2'><br><small>%3. %4</small></td>")
                .arg(name)
                .arg(kWidth_px)
                .arg(n + 1)
                .arg(pictures[n].caption.toHtmlEscaped());
    if (n % 2 == 1 || n + 1 == pictures.size()) html += QStringLiteral("</tr>");
  }
  return html + QStringLiteral("</table>");
}

QByteArray pdfOf(const measurement::Worksheet& sheet, const QString& title, const QDateTime& at, const std::vector<ReportPicture>& pictures,
                 const QString& person) {
  QBuffer pdf;
  pdf.open(QIODevice::WriteOnly);
  QPdfWriter writer(&pdf);
  writer.setPageSize(QPageSize(QPageSize::A4));
  writer.setPageMargins(QMarginsF(18.0, 18.0, 18.0, 18.0), QPageLayout::Millimeter);
  writer.setResolution(kResolution_dpi);
  writer.setTitle(words(sheet.title));
  writer.setCreator(QStringLiteral("EchoWeave"));
  QTextDocument document;
  QFont font(QStringLiteral("DejaVu Sans"));
  font.setPointSizeF(kText_pt);
  document.setDefaultFont(font);
  QString html = QStringLiteral("<h2>%1</h2><p>%2<br>%3</p><p><b>%4</b></p>")
                     .arg(words(sheet.title).toHtmlEscaped(), title.toHtmlEscaped(), QLocale().toString(at, QLocale::ShortFormat),
                          WorksheetWords::tr("Simulation, training only: not for diagnosis.").toHtmlEscaped());
  if (!person.isEmpty()) html += QStringLiteral("<p>%1</p>").arg(WorksheetWords::tr("Examined by: %1").arg(person).toHtmlEscaped());
  if (sheet.gestation_weeks)
    html += QStringLiteral("<p>%1</p>")
                .arg(WorksheetWords::tr("Gestational age by dates: %1")
                         .arg(WorksheetWords::textOf({*sheet.gestation_weeks, 0.0, measurement::Unit::weeks})));
  html += WorksheetWords::htmlOf(sheet, QStringLiteral("#505050"));
  html += QStringLiteral("<p style='color:#505050'>%1</p>").arg(words(sheet.source).toHtmlEscaped());
  html += picturesOf(pictures, document);
  document.setHtml(html);
  document.print(&writer);
  return pdf.data();
}

nlohmann::ordered_json withWhose(nlohmann::ordered_json sheet, const QString& title, const QString& person) {
  sheet["patient"] = title.toStdString();
  if (!person.isEmpty()) sheet["examined_by"] = person.toStdString();
  return sheet;
}

/// A line for each at the end, in the columns of the others: the value stands in the fifth, what it is in the second.
std::string withWhose(std::string csv, const QString& title, const QString& person) {
  const std::string titles = csv.substr(0, csv.find('\n'));
  const auto columns = static_cast<std::size_t>(std::count(titles.begin(), titles.end(), ',')) + 1;
  const auto add = [&](const char* label, QString value) {
    std::vector<std::string> cells(columns);
    cells[1] = label;
    cells[4] = "\"" + value.replace(QLatin1Char('"'), QStringLiteral("\"\"")).toStdString() + "\"";
    for (std::size_t n = 0; n < columns; ++n) csv += (n > 0 ? "," : "") + cells[n];
    csv += "\n";
  };
  add("patient", title);
  if (!person.isEmpty()) add("examined_by", person);
  return csv;
}

}  // namespace

Result<void> writeWorksheet(const measurement::Worksheet& sheet, const QString& title, const QDateTime& at,
                            const std::filesystem::path& file, const std::vector<ReportPicture>& pictures, const QString& person) {
  const std::string language = QLocale().name().toStdString();
  if (hasEnding(file, ".csv")) return writeFileSafely(file, withWhose(toCsv(sheet, language), title, person));
  if (hasEnding(file, ".json")) return writeFileSafely(file, withWhose(toJson(sheet, language), title, person).dump(2) + "\n");
  const QByteArray pdf = pdfOf(sheet, title, at, pictures, person);
  return writeFileSafely(file, std::string_view(pdf.constData(), static_cast<std::size_t>(pdf.size())));
}

Result<void> writeMeasurements(const measurement::Findings& findings, const QString& title, const std::filesystem::path& file) {
  const std::string scanned = title.toStdString();
  if (hasEnding(file, ".csv")) return writeFileSafely(file, toCsv(findings, scanned));
  return writeFileSafely(file, toJson(findings, scanned).dump(2) + "\n");
}

}  // namespace ew::ui
