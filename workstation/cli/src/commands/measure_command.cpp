#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <numbers>
#include <ostream>

#include "ew/core/ending.h"
#include "ew/core/numbers.h"
#include "ew/export/measurement_report.h"
#include "ew/io/safe_file.h"
#include "ew/library/case.h"
#include "ew/measurement/package.h"
#include "ew/measurement/worksheet.h"
#include "ew/reports/message_catalogue.h"
#include "ew/reports/report_pdf.h"
#include "ew/reports/worksheet_report.h"
#include "run/arguments.h"
#include "run/command.h"
#include "run/volume_input.h"

namespace ew::cli {
namespace {

namespace fs = std::filesystem;
using namespace ew::measurement;

struct MeasureArguments {
  bool wantsPackages = false;
  std::string package;
  std::vector<std::string> values;
  std::string gestation;
  std::string several = "mean";
  std::string language = "en";
  std::string json;
  std::string csv;
  std::string pdf;
  std::string dicom;
  std::string patientOf;
};

Result<fs::path> packagesFolder() {
  const auto resources = resourceFolder();
  if (!resources) return passOn(resources.error());
  return *resources / "measurements";
}

Result<int> listPackages(const MeasureArguments& arguments, Run& run) {
  const auto folder = packagesFolder();
  if (!folder) return passOn(folder.error());
  const auto packages = readPackages(*folder);
  if (!packages) return passOn(packages.error());
  for (const Package& package : *packages) {
    run.out() << package.id << " (version " << package.version << "): " << package.title.in(arguments.language) << "\n";
    for (const PackageItem& item : package.items) {
      run.out() << "  " << item.label << (item.isSided ? "/right|left" : "");
      if (item.measure == ItemMeasure::choice) {
        std::string words;
        for (const auto& [word, title] : item.choices) words += (words.empty() ? "" : "|") + word;
        run.out() << " = " << words;
      } else {
        run.out() << ", " << symbolOf(item.unit);
      }
      run.out() << ": " << item.title.in(arguments.language) << "\n";
    }
    run.report.details["packages"].push_back({{"id", package.id},
                                              {"version", package.version},
                                              {"title", package.title.english},
                                              {"items", package.items.size()},
                                              {"formulas", package.formulas.size()},
                                              {"charts", package.charts.size()}});
  }
  return kDone;
}

/// A shipped package by its id, or the file of one.
Result<Package> packageNamed(const std::string& name, Run& run) {
  if (hasEnding(name, ".json")) {
    if (auto kept = run.input(name); !kept) return passOn(kept.error());
    return readPackage(name);
  }
  const auto folder = packagesFolder();
  if (!folder) return passOn(folder.error());
  const fs::path file = *folder / (name + ".json");
  std::error_code ignored;
  if (name.find('/') != std::string::npos || !fs::exists(file, ignored))
    return failure(ErrorCode::badUsage,
                   say<"There is no measurement package '%1'; 'echoweave measure --packages' lists those there are.">(name));
  if (auto kept = run.input(file); !kept) return passOn(kept.error());
  return readPackage(file);
}

/// "BPD=82mm", "KIDNEY_L/right=10.4 cm", "ICA_PSV/left=200cm/s@60deg", "RUQ=seen", "*BPD=82mm".
Result<WorksheetEntry> entryIn(const std::string& text, const Package& package) {
  const auto equals = text.find('=');
  if (equals == std::string::npos || equals == 0)
    return failure(ErrorCode::badUsage, say<"--value %1 has no label; write it as in BPD=82mm.">(text));
  WorksheetEntry entry;
  entry.label = text.substr(0, equals);
  if (entry.label.starts_with('*')) {
    entry.isSelected = true;
    entry.label.erase(0, 1);
  }
  if (const auto slash = entry.label.find('/'); slash != std::string::npos) {
    entry.side = entry.label.substr(slash + 1);
    entry.label.erase(slash);
  }
  std::string value = text.substr(equals + 1);
  const PackageItem* item = package.item(entry.label);
  if (item != nullptr && item->measure == ItemMeasure::choice) {
    entry.choice = value;
    return entry;
  }
  if (const auto at = value.find('@'); at != std::string::npos) {
    const auto angle = quantityOf(std::string_view(value).substr(at + 1));
    if (!angle || angle->unit != Unit::degree)
      return failure(ErrorCode::badUsage, say<"--value %1 has no angle behind its @; write it as in ICA_PSV/left=200cm/s@60deg.">(text));
    entry.angle_rad = angle->value * std::numbers::pi / 180.0;
    value.erase(at);
  }
  const auto quantity = quantityOf(value);
  if (!quantity)
    return failure(ErrorCode::badUsage, say<"--value %1 is not a number with its unit; write it as in BPD=82mm or BPD=82+-0.8mm.">(text));
  if (item != nullptr && quantity->unit == Unit::one && item->unit != Unit::one)
    return failure(ErrorCode::badUsage, say<"--value %1 has no unit; write it as in %2=82mm.">(text, entry.label));
  entry.quantity = *quantity;
  return entry;
}

std::string padded(std::string text, std::size_t width) {
  std::size_t letters = 0;  // of UTF-8: all but continuing bytes
  for (const char c : text) letters += (static_cast<unsigned char>(c) & 0xC0U) != 0x80U ? 1 : 0;
  if (letters < width) text.append(width - letters, ' ');
  return text;
}

void print(const Worksheet& sheet, const MeasureArguments& arguments, std::ostream& out) {
  constexpr std::size_t kLabelWidth = 26, kValueWidth = 22;
  out << sheet.title.in(arguments.language) << " (package " << sheet.package << ", version " << sheet.packageVersion << ")";
  if (sheet.gestation_weeks) out << ", " << gestationText(*sheet.gestation_weeks) << " by dates";
  out << "\n" << kTrainingOnly << "\n";
  for (const SectionValues& section : sheet.sections) {
    out << "\n" << section.title.in(arguments.language) << "\n";
    for (const WorksheetRow& row : section.rows) {
      std::string line = padded(row.label + (row.side.empty() ? "" : "/" + row.side), kLabelWidth);
      std::string value = row.value ? shown(*row.value) : row.choiceTitle.in(arguments.language);
      if (row.value && areComparable(row.value->unit, Unit::weeks) && row.isFormula)
        value += " (" + gestationText(converted(row.value->value, row.value->unit, Unit::weeks)) + ")";
      line += padded(value.empty() ? "-" : value, kValueWidth) + " " + howItCameAbout(row);
      if (row.predictionError > 0.0 && row.value)
        line += "; predicts within " + rounded(row.predictionError, 0) + " " + std::string(symbolOf(row.value->unit)) + " (1 SD)";
      for (const RangeReading& reading : row.ranges) {
        const std::string& whom = reading.range.applies.in(arguments.language);
        line += "; " + std::string(wordOf(reading.verdict)) + " the usual range, " + rangeText(reading.range).english() +
                (whom.empty() ? "" : " (" + whom + ")");
      }
      for (const ChartReading& chart : row.charts) line += "; percentile " + rounded(chart.percentile, 1) + " by " + chart.label;
      out << "  " << line << "\n";
      for (const Message& remark : row.remarks) out << "    " << remark << "\n";
    }
  }
  if (sheet.redating) out << "\n" << sentenceOf(*sheet.redating) << "\n";
  for (const SummaryReading& summary : sheet.summaries)
    out << "\n" << summary.title.in(arguments.language) << ": " << summary.says.in(arguments.language) << "\n";
}

Result<void> writeOutput(const std::string& file, const std::string& text, Run& run) {
  if (file.empty()) return {};
  if (auto written = writeFileSafely(run.outputs.staged(file), text); !written) return passOn(written.error());
  run.say("Wrote " + file + ".");
  return {};
}

/// As a page to print.
Result<void> writePage(const MeasureArguments& arguments, const Worksheet& sheet, Run& run) {
  if (arguments.pdf.empty()) return {};
  const auto catalogue = MessageCatalogue::ofLanguage(arguments.language);
  if (!catalogue) return passOn(catalogue.error());
  const auto pdf = pdfOf(worksheetReport(sheet, {}, arguments.language),
                         {.language = arguments.language, .words = [&](const Message& message) { return catalogue->words(message); }});
  return pdf ? writeOutput(arguments.pdf, *pdf, run) : passOn(pdf.error());
}

/// As a DICOM structured report, of a case's patient or of nobody.
Result<void> writeReport(const MeasureArguments& arguments, const Worksheet& sheet, Run& run) {
  if (arguments.dicom.empty()) {
    if (arguments.patientOf.empty()) return {};
    return failure(ErrorCode::badUsage, say<"--patient names the patient of a DICOM report; give --dicom OUT.dcm, too.">());
  }
  const auto now = std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
  DicomStudy study = beginStudy(sheet.title.english, now);
  if (!arguments.patientOf.empty()) {
    const auto examined = findCase(arguments.patientOf);
    if (!examined) return passOn(examined.error());
    study = beginStudy(*examined, now);
  }
  const auto written =
      writeMeasurementReport(sheet, {.instanceUid = newDicomUid(), .made = now}, study, run.outputs.staged(arguments.dicom));
  if (!written) return passOn(written.error());
  run.say("Wrote " + arguments.dicom + ".");
  return {};
}

Result<int> fillSheet(const MeasureArguments& arguments, Run& run) {
  if (arguments.package.empty())
    return failure(ErrorCode::badUsage, say<"Name a package with --package; 'echoweave measure --packages' lists those there are.">());
  if (arguments.values.empty()) return failure(ErrorCode::badUsage, say<"Give at least one measurement, as in --value BPD=82mm.">());
  const auto package = packageNamed(arguments.package, run);
  if (!package) return passOn(package.error());
  for (const auto& [file, ending] : {std::pair{arguments.json, ".json"}, std::pair{arguments.csv, ".csv"}, std::pair{arguments.pdf, ".pdf"},
                                     std::pair{arguments.dicom, ".dcm"}})
    if (!file.empty())
      if (auto announced = run.output(file, ending); !announced) return passOn(announced.error());

  WorksheetInput input;
  for (const std::string& value : arguments.values) {
    auto entry = entryIn(value, *package);
    if (!entry) return passOn(entry.error());
    input.entries.push_back(std::move(*entry));
  }
  input.several = arguments.several == "mean" ? Several::mean : arguments.several == "last" ? Several::last : Several::selected;
  if (!arguments.gestation.empty()) {
    input.gestation_weeks = gestationOf(arguments.gestation);
    if (!input.gestation_weeks)
      return failure(ErrorCode::badUsage,
                     say<"--gestation '%1' is no gestational age; write it as in 32w1d or 32+1, up to 45 weeks.">(arguments.gestation));
  }
  Worksheet sheet;
  {
    const StepClock clock(run.report, "worksheet");
    auto filled = fillWorksheet(*package, input);
    if (!filled) return passOn(filled.error());
    sheet = std::move(*filled);
  }
  const auto document = toJson(sheet, arguments.language);
  if (auto written = writeOutput(arguments.json, document.dump(2) + "\n", run); !written) return passOn(written.error());
  if (auto written = writeOutput(arguments.csv, toCsv(sheet, arguments.language), run); !written) return passOn(written.error());
  if (auto written = writePage(arguments, sheet, run); !written) return passOn(written.error());
  if (auto written = writeReport(arguments, sheet, run); !written) return passOn(written.error());
  if (arguments.json.empty() && arguments.csv.empty() && arguments.pdf.empty() && arguments.dicom.empty())
    print(sheet, arguments, run.out());
  std::size_t results = 0, without = 0;
  for (const SectionValues& section : sheet.sections)
    for (const WorksheetRow& row : section.rows) {
      results += row.isFormula && row.value ? 1 : 0;
      without += row.isFormula && !row.value ? 1 : 0;
    }
  run.report.options = {
      {"package", package->id}, {"package_version", package->version}, {"values", arguments.values}, {"several", arguments.several}};
  if (input.gestation_weeks) run.report.options["gestation_weeks"] = *input.gestation_weeks;
  run.report.quality = {{"measurements", input.entries.size()}, {"results", results}, {"results_out_of_range", without}};
  run.report.details["worksheet"] = document;
  return kDone;
}

}  // namespace

void addMeasure(CLI::App& root, Selection& selection) {
  auto arguments = std::make_shared<MeasureArguments>();
  auto& app =
      addCommand(root, selection, "measure", "Fill the worksheet of a measurement package: results, usual ranges, percentiles",
                 {"measure --packages",
                  "measure --package obstetric --value BPD=82mm --value HC=300mm --value AC=280mm --value FL=62mm --gestation 32w1d",
                  "measure --package vessel --value D_MIN/left=1.5+-0.2mm --value D_DISTAL/left=5mm --json left.json",
                  "measure --package vascular --value ICA_PSV/left=200cm/s@60deg --value CCA_PSV/left=80cm/s@60deg",
                  "measure --package trauma --value RUQ=seen --value LUQ=not_seen --csv fast.csv",
                  "measure --package obstetric --value BPD=82mm --value HC=300mm --dicom report.dcm --patient fetal-biometry"},
                 [arguments](Run& run) { return arguments->wantsPackages ? listPackages(*arguments, run) : fillSheet(*arguments, run); });
  auto* packages = app.add_flag("--packages", arguments->wantsPackages, "List the packages that there are, with the labels of their items");
  app.add_option("--package", arguments->package, "A shipped package by its name, or the .json file of one")
      ->type_name("NAME|FILE.json")
      ->excludes(packages);
  app.add_option(
         "--value", arguments->values,
         "A measurement or an answer, as often as there are: BPD=82mm, BPD=82+-0.8mm with its standard uncertainty, KIDNEY_L/right=10.4cm "
         "of a side, ICA_PSV/left=200cm/s@60deg with the angle a velocity was corrected by (3 degrees uncertain), RUQ=seen; *BPD=82mm is "
         "the one "
         "that counts with --several selected")
      ->type_name("LABEL[/SIDE]=VALUE")
      ->allow_extra_args(false);
  app.add_option("--gestation", arguments->gestation, "Gestational age by dates, for charts and redating: 32w1d or 32+1")
      ->type_name("WEEKS");
  app.add_option("--several", arguments->several, "What counts of several measurements of an item: mean, last or selected (mean)")
      ->check(CLI::IsMember({"mean", "last", "selected"}))
      ->type_name("HOW");
  app.add_option("--language", arguments->language, "Of titles, and of the pages to print: en or de (en)")
      ->check(CLI::IsMember({"en", "de"}))
      ->type_name("LANGUAGE");
  app.add_option("--json", arguments->json, "Write the worksheet as JSON")->type_name("OUT.json");
  app.add_option("--csv", arguments->csv, "Write the worksheet as a table for a spreadsheet")->type_name("OUT.csv");
  app.add_option("--pdf", arguments->pdf, "Write the worksheet as pages to print (A4)")->type_name("OUT.pdf");
  app.add_option("--dicom", arguments->dicom, "Write the worksheet as a DICOM structured report (obstetrics by TID 5000, others TID 1500)")
      ->type_name("OUT.dcm");
  app.add_option("--patient", arguments->patientOf, "The case whose invented patient the DICOM report names (nobody)")->type_name("CASE");
}

}  // namespace ew::cli
