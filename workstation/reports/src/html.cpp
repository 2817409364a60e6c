#include "ew/reports/html.h"

#include "ew/core/word_table.h"
#include "ew/io/safe_file.h"
#include "ew/reports/image_file.h"
#include "html_style.h"
#include "report_words.h"

namespace ew {
namespace {

constexpr WordTable<ReportTone, 5> kReportToneWords{{{"", ReportTone::plain},
                                                     {"soft", ReportTone::soft},
                                                     {"good", ReportTone::good},
                                                     {"bad", ReportTone::bad},
                                                     {"caution", ReportTone::caution}}};
std::string wordOf(ReportTone tone) { return wordIn(kReportToneWords, tone); }

std::string classOf(const std::string& words) { return words.empty() ? std::string() : " class='" + words + "'"; }

/// A name of a file of this folder, as it may stand in a link.
std::string linkTo(const std::string& file) {
  constexpr std::string_view kPlain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_.~";
  std::string made = "./";
  for (const char byte : file) {
    if (kPlain.find(byte) != std::string_view::npos) {
      made += byte;
      continue;
    }
    constexpr std::string_view kDigits = "0123456789ABCDEF";
    made += {'%', kDigits[static_cast<unsigned char>(byte) >> 4], kDigits[static_cast<unsigned char>(byte) & 15u]};
  }
  return made;
}

class PageWriter {
 public:
  explicit PageWriter(const ReportOptions& options) : options_(options) {}

  std::string page(const ReportDocument& document) {
    const std::string title = text(document.title);
    html_ = "<!doctype html>\n<html lang='" + htmlEscaped(options_.language.substr(0, options_.language.find('_'))) +
            "'><head><meta charset='utf-8'><meta name='viewport' content='width=device-width, initial-scale=1'>"
            "<meta http-equiv='Content-Security-Policy' content=\"default-src 'none'; img-src data:; style-src 'unsafe-inline'\"><title>" +
            title + "</title><style>" + reports::kPageStyle + "</style></head>\n<body><main>";
    navigation(document);
    html_ += "<h1>" + title + "</h1>";
    if (!document.subtitle.empty()) html_ += "<p class='subtitle'>" + text(document.subtitle) + "</p>";
    html_ += "<p class='simulation'>" + text(simulationSentence()) + "</p>\n";
    for (const ReportBlock& block : document.blocks) {
      std::visit([this](const auto& one) { write(one); }, block);
      html_ += "\n";
    }
    return std::move(html_) + "</main></body></html>\n";
  }

 private:
  [[nodiscard]] std::string text(const Message& message) const { return htmlEscaped(options_.say(message)); }

  void navigation(const ReportDocument& document) {
    if (document.links.empty()) return;
    html_ += "<nav>";
    for (const auto& [name, file] : document.links) html_ += "<a href='" + linkTo(file) + "'>" + text(name) + "</a> ";
    html_ += "</nav>";
  }

  void write(const ReportHeading& heading) {
    const std::string tag = "h" + std::to_string(heading.level);
    html_ += "<" + tag + ">" + text(heading.text) + "</" + tag + ">";
  }
  void write(const ReportParagraph& paragraph) { html_ += "<p" + classOf(wordOf(paragraph.tone)) + ">" + text(paragraph.text) + "</p>"; }
  void write(const ReportList& list) {
    if (list.items.empty()) return;
    html_ += "<ul>";
    for (const ReportItem& item : list.items)
      html_ +=
          "<li><span" + classOf(("sign " + wordOf(item.tone))) + ">" + reports::signOf(item.tone) + "</span>" + text(item.text) + "</li>";
    html_ += "</ul>";
  }
  void write(const ReportFacts& facts) {
    html_ += "<dl>";
    for (const ReportFact& fact : facts.rows)
      html_ += "<dt>" + text(fact.name) + "</dt><dd" + classOf(wordOf(fact.tone)) + ">" + text(fact.value) + "</dd>";
    html_ += "</dl>";
  }
  void write(const ReportTable& table) {
    const std::string caption = text(table.caption);
    html_ += "<div class='wide' tabindex='0' role='region' aria-label='" + caption + "'><table>";
    if (!caption.empty()) html_ += "<caption>" + caption + "</caption>";
    html_ += "<thead><tr>";
    for (const ReportColumn& column : table.columns)
      html_ += "<th scope='col'" + classOf(column.isNumber ? "number" : "") + ">" + text(column.name) + "</th>";
    html_ += "</tr></thead><tbody>";
    for (const auto& row : table.rows) {
      html_ += "<tr>";
      for (std::size_t n = 0; n < row.size(); ++n) cell(row[n], table.columns[n].isNumber, n == 0);
      html_ += "</tr>\n";
    }
    html_ += "</tbody></table></div>";
  }
  void cell(const ReportCell& cell, bool isNumber, bool namesRow) {
    std::string words = isNumber ? "number" : "";
    if (const std::string tone = wordOf(cell.tone); !tone.empty()) words += (words.empty() ? "" : " ") + tone;
    html_ += (namesRow ? "<th scope='row'" : "<td") + classOf(words) + ">";
    html_ += cell.link.empty() ? text(cell.text) : "<a href='" + linkTo(cell.link) + "'>" + text(cell.text) + "</a>";
    for (std::size_t n = 0; n < cell.below.size(); ++n)
      html_ += (n > 0 || !cell.text.empty() ? "<br>" : "") + ("<span class='soft'>" + text(cell.below[n])) + "</span>";
    html_ += namesRow ? "</th>" : "</td>";
  }
  void write(const ReportPlot& plot) {
    html_ += "<figure class='plot" + std::string(plot.isSmall ? " small" : "") + "'><figcaption>" + text(plot.title) +
             "</figcaption><div class='wide' tabindex='0' role='region' aria-label='" + text(plot.title) + "'>" +
             svgOf(plot, pageColours(), [this](const Message& message) { return options_.say(message); }) + "</div></figure>";
  }
  void write(const ReportImage& image) {
    const auto read = imageOf(image);
    if (!read) return write(ReportParagraph{read.error().message, ReportTone::caution});
    const std::string caption = text(image.caption);
    html_ += "<figure" + classOf(image.isSmall ? "small" : "") + "><img alt='" + caption + "' src='data:" + read->mediaType + ";base64," +
             base64Of(read->bytes) + "'><figcaption>" + caption + "</figcaption></figure>";
  }

  const ReportOptions& options_;
  std::string html_;
};

}  // namespace

std::string htmlEscaped(std::string_view text) {
  std::string made;
  made.reserve(text.size());
  for (const char letter : text) {
    switch (letter) {
      case '&':
        made += "&amp;";
        break;
      case '<':
        made += "&lt;";
        break;
      case '>':
        made += "&gt;";
        break;
      case '"':
        made += "&quot;";
        break;
      case '\'':
        made += "&#39;";
        break;
      default:
        if (static_cast<unsigned char>(letter) >= 0x20 && letter != 0x7f) made += letter;
        if (letter == '\n' || letter == '\t') made += letter;
    }
  }
  return made;
}

std::string htmlOf(const ReportDocument& document, const ReportOptions& options) { return PageWriter(options).page(document); }

}  // namespace ew
