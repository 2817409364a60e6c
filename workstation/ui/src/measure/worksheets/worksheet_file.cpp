#include "measure/worksheets/worksheet_file.h"

#include <QBuffer>
#include <QLocale>
#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <string>

#include "ew/core/ending.h"
#include "ew/io/safe_file.h"
#include "ew/reports/report_pdf.h"
#include "ew/reports/worksheet_report.h"
#include "ew/widgets/words.h"

namespace ew::ui {
namespace {

std::string pngOf(const QImage& image) {
  QBuffer png;
  png.open(QIODevice::WriteOnly);
  image.save(&png, "PNG");
  return png.data().toStdString();
}

Result<std::string> paperOf(const measurement::Worksheet& sheet, const QString& title, const QDateTime& at,
                            const std::vector<WorksheetImage>& images, const QString& person) {
  const std::string language = QLocale().name().toStdString();
  WorksheetAbout about{.patient = title.toStdString(),
                       .moment = verbatim(QLocale().toString(at, QLocale::ShortFormat).toStdString()),
                       .at = std::chrono::sys_seconds(std::chrono::seconds(at.toSecsSinceEpoch())),
                       .examiner = person.toStdString()};
  for (const WorksheetImage& image : images)
    about.images.push_back({.caption = verbatim(image.caption.toStdString()), .bytes = pngOf(image.image), .isSmall = true});
  return pdfOf(worksheetReport(sheet, std::move(about), language),
               {.language = language, .words = [](const Message& message) { return words(message).toStdString(); }});
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
                            const std::filesystem::path& file, const std::vector<WorksheetImage>& images, const QString& person) {
  const std::string language = QLocale().name().toStdString();
  if (hasEnding(file, ".csv")) return writeFileSafely(file, withWhose(toCsv(sheet, language), title, person));
  if (hasEnding(file, ".json")) return writeFileSafely(file, withWhose(toJson(sheet, language), title, person).dump(2) + "\n");
  const auto pdf = paperOf(sheet, title, at, images, person);
  return pdf ? writeFileSafely(file, *pdf) : passOn(pdf.error());
}

Result<void> writeMeasurements(const measurement::Findings& findings, const QString& title, const std::filesystem::path& file) {
  const std::string scanned = title.toStdString();
  if (hasEnding(file, ".csv")) return writeFileSafely(file, toCsv(findings, scanned));
  return writeFileSafely(file, toJson(findings, scanned).dump(2) + "\n");
}

}  // namespace ew::ui
