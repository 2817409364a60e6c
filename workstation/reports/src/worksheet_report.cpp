#include "ew/reports/worksheet_report.h"

#include "ew/measurement/worksheet_line.h"

namespace ew {
namespace {

ReportTable tableOf(const measurement::SectionValues& section, std::string_view language) {
  ReportTable table{{}, {{say<"Measurement">()}, {say<"Value">(), true}, {say<"Usual values">()}}, {}};
  for (const measurement::WorksheetRow& row : section.rows) {
    measurement::WorksheetLine line = lineOf(row, language);
    table.rows.push_back({{.text = std::move(line.title), .below = std::move(line.origin)},
                          {.text = std::move(line.value)},
                          {.below = std::move(line.against)}});
  }
  return table;
}

}  // namespace

ReportDocument worksheetReport(const measurement::Worksheet& sheet, WorksheetAbout about, std::string_view language) {
  ReportDocument document{.title = verbatim(sheet.title.in(language)), .at = about.at};
  std::vector<Message> whose;
  if (!about.patient.empty()) whose.push_back(verbatim(std::move(about.patient)));
  if (!about.moment.empty()) whose.push_back(std::move(about.moment));
  if (!whose.empty()) document.subtitle = joined(std::move(whose), ", ");
  const auto add = [&document](Message text, ReportTone tone = ReportTone::plain) {
    document.blocks.emplace_back(ReportParagraph{std::move(text), tone});
  };
  if (!about.examiner.empty()) add(say<"Examined by: %1">(std::move(about.examiner)));
  if (sheet.gestation_weeks) add(say<"Gestational age by dates: %1">(measurement::gestationText(*sheet.gestation_weeks)));
  for (const measurement::SectionValues& section : sheet.sections) {
    document.blocks.emplace_back(ReportHeading{3, verbatim(section.title.in(language))});
    document.blocks.emplace_back(tableOf(section, language));
  }
  if (sheet.redating) add(sentenceOf(*sheet.redating));
  for (const measurement::SummaryReading& summary : sheet.summaries)
    add(joined({verbatim(summary.title.in(language)), verbatim(summary.says.in(language))}, ": "));
  if (!sheet.source.empty()) add(verbatim(sheet.source), ReportTone::soft);
  if (!about.images.empty()) document.blocks.emplace_back(ReportHeading{3, say<"Images">()});
  for (std::size_t n = 0; n < about.images.size(); ++n) {
    ReportImage& image = about.images[n];
    image.caption = joined({verbatim(std::to_string(n + 1) + "."), std::move(image.caption)});
    document.blocks.emplace_back(std::move(image));
  }
  return document;
}

}  // namespace ew
