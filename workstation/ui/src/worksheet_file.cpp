#include "worksheet_file.h"

#include <QBuffer>
#include <QLocale>
#include <QPageLayout>
#include <QPdfWriter>
#include <QTextDocument>
#include <nlohmann/json.hpp>
#include <string_view>

#include "ew/io/safe_file.h"
#include "words.h"
#include "worksheet_words.h"

namespace ew::ui {
namespace {

constexpr int kResolution_dpi = 300;
constexpr double kText_pt = 10.0;

QByteArray pdfOf(const measurement::Worksheet& sheet, const QString& title, const QDateTime& at) {
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
  if (sheet.gestation_weeks)
    html += QStringLiteral("<p>%1</p>")
                .arg(WorksheetWords::tr("Gestational age by dates: %1")
                         .arg(WorksheetWords::textOf({*sheet.gestation_weeks, 0.0, measurement::Unit::weeks})));
  html += WorksheetWords::htmlOf(sheet, QStringLiteral("#505050"));
  html += QStringLiteral("<p style='color:#505050'>%1</p>").arg(words(sheet.source).toHtmlEscaped());
  document.setHtml(html);
  document.print(&writer);
  return pdf.data();
}

}  // namespace

Result<void> writeWorksheet(const measurement::Worksheet& sheet, const QString& title, const QDateTime& at,
                            const std::filesystem::path& file) {
  const std::string language = QLocale().name().toStdString();
  if (file.extension() == ".csv") return writeFileSafely(file, toCsv(sheet, language));
  if (file.extension() == ".json") return writeFileSafely(file, toJson(sheet, language).dump(2) + "\n");
  const QByteArray pdf = pdfOf(sheet, title, at);
  return writeFileSafely(file, std::string_view(pdf.constData(), static_cast<std::size_t>(pdf.size())));
}

}  // namespace ew::ui
