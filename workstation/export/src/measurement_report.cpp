#include "ew/export/measurement_report.h"

#include <algorithm>
#include <set>

#include "dicom_elements.h"
// after DCMTK's configuration
#include <dcmtk/dcmsr/dsrdoc.h>

#include "ew/core/version.h"
#include "ew/io/safe_file.h"
#include "report_codes.h"

namespace ew {
namespace {
using namespace exporting;
using namespace measurement;

constexpr auto kContains = DSRTypes::RT_contains;
constexpr auto kModifies = DSRTypes::RT_hasConceptMod;
constexpr auto kContext = DSRTypes::RT_hasObsContext;
constexpr auto kProperty = DSRTypes::RT_hasProperties;
constexpr auto kInferredFrom = DSRTypes::RT_inferredFrom;

/// The simulator as the observer of what it measured: one for all of them.
constexpr const char* kObserverUid = "2.25.203617914683541218537441229043173820";

Code dcm(const char* value, const char* meaning) { return {value, "DCM", meaning}; }

Code selectionOf(Several several) {
  switch (several) {
    case Several::mean:
      return dcm("121412", "Mean value chosen");
    case Several::last:
      return dcm("121411", "Most recent value chosen");
    case Several::selected:
      return dcm("121410", "User chosen value");
  }
  return {};
}
Code loinc(const char* value, const char* meaning) { return {value, "LN", meaning}; }
Code snomed(const char* value, const char* meaning) { return {value, "SCT", meaning}; }

/// Builds a document tree from above to below. Whatever DCMTK refuses is remembered.
class ReportTree {
 public:
  explicit ReportTree(DSRDocumentTree& tree) : tree_(tree) {}

  void root(const Code& title, const char* templateId) {
    if (tree_.addContentItem(DSRTypes::RT_isRoot, DSRTypes::VT_Container) == 0) refuse(title, "root");
    DSRContentItem& item = tree_.getCurrentContentItem();
    keep(item.setConceptName(coded(title)), title);
    keep(item.setTemplateIdentification(templateId, "DCMR"), title);
  }
  /// What `fill` adds stands below the container.
  template <class Fill>
  void container(const Code& name, Fill fill, const char* templateId = nullptr) {
    add(kContains, DSRTypes::VT_Container, name);
    if (templateId != nullptr) keep(tree_.getCurrentContentItem().setTemplateIdentification(templateId, "DCMR"), name);
    fill();
    tree_.goUp();
  }
  void code(DSRTypes::E_RelationshipType how, const Code& name, const Code& value) {
    add(how, DSRTypes::VT_Code, name);
    keep(tree_.getCurrentContentItem().setCodeValue(coded(value)), name);
    tree_.goUp();
  }
  void text(DSRTypes::E_RelationshipType how, const Code& name, const std::string& value) {
    add(how, DSRTypes::VT_Text, name);
    keep(tree_.getCurrentContentItem().setStringValue(value.c_str()), name);
    tree_.goUp();
  }
  void uid(DSRTypes::E_RelationshipType how, const Code& name, const std::string& value) {
    add(how, DSRTypes::VT_UIDRef, name);
    keep(tree_.getCurrentContentItem().setStringValue(value.c_str()), name);
    tree_.goUp();
  }
  void image(const DicomReference& reference) {
    if (tree_.addContentItem(kContains, DSRTypes::VT_Image, DSRTypes::AM_belowCurrent) == 0) refuse(dcm("", "Image"), "IMAGE");
    keep(tree_.getCurrentContentItem().setImageReference(DSRImageReferenceValue(reference.classUid.c_str(), reference.instanceUid.c_str())),
         dcm("", "Image"));
    tree_.goUp();
  }
  template <class Fill>
  void number(DSRTypes::E_RelationshipType how, const Code& name, double value, const Code& unit, Fill fill) {
    add(how, DSRTypes::VT_Num, name);
    keep(tree_.getCurrentContentItem().setNumericValue(DSRNumericMeasurementValue(decimalString(value).c_str(), coded(unit))), name);
    fill();
    tree_.goUp();
  }
  void number(DSRTypes::E_RelationshipType how, const Code& name, double value, const Code& unit) {
    number(how, name, value, unit, [] {});
  }
  [[nodiscard]] const std::string& refused() const { return refused_; }

 private:
  static DSRCodedEntryValue coded(const Code& code) {
    return DSRCodedEntryValue(fitting(code.value, 16).c_str(), code.scheme.c_str(), fitting(code.meaning, 64).c_str());
  }
  void add(DSRTypes::E_RelationshipType how, DSRTypes::E_ValueType kind, const Code& name) {
    if (tree_.addContentItem(how, kind, DSRTypes::AM_belowCurrent) == 0) refuse(name, DSRTypes::valueTypeToDefinedTerm(kind));
    keep(tree_.getCurrentContentItem().setConceptName(coded(name)), name);
  }
  void keep(const OFCondition& condition, const Code& name) {
    if (condition.bad()) refuse(name, condition.text());
  }
  void refuse(const Code& name, const std::string& why) {
    if (refused_.empty()) refused_ = name.meaning + ": " + why;
  }

  DSRDocumentTree& tree_;
  std::string refused_;
};

/// Writes rows of a worksheet into a tree: what both kinds of reports have in common.
class RowWriter {
 public:
  RowWriter(ReportTree& tree, const Worksheet& sheet) : tree_(tree), sheet_(sheet) {}

  void head() {
    tree_.code(kModifies, dcm("121049", "Language of Content Item and Descendants"), {"en", "RFC5646", "English"});
    tree_.code(kContext, dcm("121005", "Observer Type"), dcm("121007", "Device"));
    tree_.uid(kContext, dcm("121012", "Device Observer UID"), kObserverUid);
    tree_.text(kContext, dcm("121013", "Device Observer Name"), "EchoWeave training simulator");
    tree_.text(kContext, dcm("121014", "Device Observer Manufacturer"), "EchoWeave");
    tree_.text(kContext, dcm("121015", "Device Observer Model Name"), std::string("EchoWeave ") + kVersion);
  }
  void library(const std::vector<DicomReference>& images) {
    if (images.empty()) return;
    tree_.container(
        dcm("111028", "Image Library"),
        [&] {
          tree_.container(dcm("126200", "Image Library Group"), [&] {
            for (const DicomReference& image : images) tree_.image(image);
          });
        },
        "1600");
  }
  void comment(const std::string& text) { tree_.text(kContains, dcm("121106", "Comment"), text); }

  /// A row, under its own name or as what it is here (a gestational age, a weight).
  void row(const WorksheetRow& row, const Code& name) {
    if (!row.choice.empty()) {
      tree_.code(kContains, name, answerOf(sheet_.package, row));
      return;
    }
    if (row.measured.size() > 1)
      for (const Quantity& one : row.measured)
        tree_.number(kContains, name, one.value, ucumOf(one.unit), [&] {
          laterality(row);
          uncertainty(one);
        });
    if (row.value) {
      tree_.number(kContains, name, row.value->value, ucumOf(row.value->unit), [&] { about(row); });
    }
    for (const Message& remark : row.remarks) comment(row.title.english + ": " + remark.english());
  }
  void row(const WorksheetRow& each) { row(each, nameOf(sheet_.package, each)); }

 private:
  void laterality(const WorksheetRow& row) {
    if (const auto side = lateralityOf(row.side)) tree_.code(kModifies, snomed("272741003", "Laterality"), *side);
  }
  void uncertainty(const Quantity& value) {
    if (value.uncertainty > 0.0) tree_.number(kProperty, snomed("386136009", "Standard Deviation"), value.uncertainty, ucumOf(value.unit));
  }
  /// In the order of TID 300: what modifies the name, properties, what it was inferred from.
  void about(const WorksheetRow& row) {
    const bool isChosen = row.measured.size() > 1;
    laterality(row);
    if (isChosen && sheet_.several == Several::mean)
      tree_.code(kModifies, dcm("121401", "Derivation"), snomed("373098007", "Mean"));
    else if (row.isFormula || !row.from.empty())
      tree_.code(kModifies, dcm("121401", "Derivation"),
                 row.predictionError > 0.0 ? dcm("121427", "Estimated") : dcm("121428", "Calculated"));
    uncertainty(*row.value);
    if (isChosen) tree_.code(kProperty, dcm("121404", "Selection Status"), selectionOf(sheet_.several));
    for (const RangeReading& reading : row.ranges) {
      const std::string& whom = reading.range.applies.english;
      tree_.text(
          kProperty, dcm("121407", "Normal Range description"),
          rangeText(reading.range).english() + (whom.empty() ? "" : " (" + whom + ")") + "; " + std::string(wordOf(reading.verdict)));
      if (!reading.range.source.empty()) tree_.text(kProperty, dcm("121408", "Normal Range Authority"), reading.range.source);
    }
    for (const ChartReading& chart : row.charts) {
      const auto authority = [&] { tree_.text(kProperty, dcm("121406", "Reference Authority"), chart.title.english); };
      tree_.number(kProperty, dcm("121415", "Percentile Ranking of measurement"), chart.percentile, ucumOf(Unit::percent), authority);
      tree_.number(kProperty, dcm("121416", "Z-Score of measurement"), chart.z, ucumOf(Unit::one), authority);
    }
    if (const std::string convention = row.convention.english; !convention.empty())
      tree_.text(kProperty, dcm("121106", "Comment"), convention);
    if (row.isFormula) {
      if (const auto equation = equationOf(sheet_.package, row.label)) tree_.code(kInferredFrom, dcm("121420", "Equation"), *equation);
      if (!row.source.empty()) tree_.text(kInferredFrom, dcm("121421", "Equation Citation"), row.source);
      for (const FormulaValue& used : row.inputs) {
        WorksheetRow input;
        input.label = used.of;
        if (const WorksheetRow* known = sheet_.row(used.of, used.side)) input.title = known->title;
        if (input.title.english.empty()) input.title.english = used.of;
        tree_.number(kInferredFrom, nameOf(sheet_.package, input), used.value.value, ucumOf(used.value.unit), [&] {
          input.side = used.side;
          laterality(input);
        });
      }
    } else if (!row.from.empty()) {
      tree_.text(kInferredFrom, dcm("121421", "Equation Citation"), howItCameAbout(row));
    }
  }

  ReportTree& tree_;
  const Worksheet& sheet_;
};

/// Where a row of the obstetric worksheet belongs in TID 5000.
enum class Place { summary, ratios, biometry, early };

bool isAge(const WorksheetRow& row) { return row.isFormula && row.label.starts_with("GA_"); }

/// The measurement that a gestational age was taken from alone; empty when there are several.
std::string onlyInputOf(const WorksheetRow& row) { return row.inputs.size() == 1 ? row.inputs.front().of : std::string(); }

class ObstetricReport {
 public:
  ObstetricReport(ReportTree& tree, const Worksheet& sheet) : tree_(tree), sheet_(sheet), writer_(tree, sheet) {}

  void write(const std::vector<DicomReference>& images) {
    tree_.root(dcm("125000", "OB-GYN Ultrasound Procedure Report"), "5000");
    writer_.head();
    writer_.library(images);
    summary();
    section(dcm("125001", "Fetal Biometry Ratios"), "5004", Place::ratios);
    section(dcm("125002", "Fetal Biometry"), "5005", Place::biometry);
    section(dcm("125009", "Early Gestation"), "5011", Place::early);
  }

 private:
  [[nodiscard]] static Place placeOf(const WorksheetRow& row) {
    if (row.label == "CRL" || (isAge(row) && onlyInputOf(row) == "CRL")) return Place::early;
    if (row.label == "CI") return Place::ratios;
    if (row.label.starts_with("EFW_") || (isAge(row) && onlyInputOf(row).empty())) return Place::summary;
    return Place::biometry;
  }
  [[nodiscard]] std::vector<const WorksheetRow*> rowsAt(Place place) const {
    std::vector<const WorksheetRow*> rows;
    for (const SectionValues& each : sheet_.sections)
      for (const WorksheetRow& row : each.rows)
        if (placeOf(row) == place) rows.push_back(&row);
    return rows;
  }
  void summary() {
    tree_.container(
        dcm("121111", "Summary"),
        [&] {
          writer_.comment(kTrainingOnly);
          if (sheet_.redating) writer_.comment(sentenceOf(*sheet_.redating).english());
          for (const SummaryReading& each : sheet_.summaries) writer_.comment(each.title.english + ": " + each.says.english);
          const auto rows = rowsAt(Place::summary);
          if (rows.empty() && !sheet_.gestation_weeks) return;
          tree_.container(
              dcm("125008", "Fetus Summary"),
              [&] {
                if (sheet_.gestation_weeks)
                  tree_.number(kContains, loinc("11885-1", "Gestational Age by LMP"), *sheet_.gestation_weeks, ucumOf(Unit::weeks));
                for (const WorksheetRow* row : rows)
                  writer_.row(*row, isAge(*row) ? loinc("11888-5", "Composite Ultrasound Age") : loinc("11727-5", "Estimated Weight"));
              },
              "5003");
        },
        "5002");
  }
  /// Each measurement in a group of its own, with the gestational ages that follow from it alone (TID 5008).
  void section(const Code& title, const char* templateId, Place place) {
    const auto rows = rowsAt(place);
    if (rows.empty()) return;
    tree_.container(
        title,
        [&] {
          if (place == Place::ratios) {
            for (const WorksheetRow* row : rows) writer_.row(*row);
            return;
          }
          std::set<const WorksheetRow*> written;
          for (const WorksheetRow* row : rows) {
            if (isAge(*row)) continue;
            tree_.container(
                dcm("125005", "Biometry Group"),
                [&] {
                  writer_.row(*row);
                  for (const WorksheetRow* age : rows)
                    if (isAge(*age) && onlyInputOf(*age) == row->label) {
                      writer_.row(*age, loinc("18185-9", "Gestational Age"));
                      written.insert(age);
                    }
                },
                "5008");
          }
          for (const WorksheetRow* age : rows)
            if (isAge(*age) && !written.contains(age))
              tree_.container(
                  dcm("125005", "Biometry Group"), [&] { writer_.row(*age, loinc("18185-9", "Gestational Age")); }, "5008");
        },
        templateId);
  }

  ReportTree& tree_;
  const Worksheet& sheet_;
  RowWriter writer_;
};

/// TID 1500: a measurement group (TID 1501) for each section of the worksheet and side.
void writeImagingReport(ReportTree& tree, const Worksheet& sheet, const std::vector<DicomReference>& images) {
  RowWriter writer(tree, sheet);
  tree.root(dcm("126000", "Imaging Measurement Report"), "1500");
  writer.head();
  tree.code(kModifies, dcm("121058", "Procedure reported"), snomed("16310003", "Ultrasonography"));
  writer.library(images);
  tree.container(dcm("126010", "Imaging Measurements"), [&] {
    for (const SectionValues& section : sheet.sections)
      for (const std::string side : {"", "right", "left"}) {
        const auto belongs = [&](const WorksheetRow& row) { return row.side == side; };
        if (std::none_of(section.rows.begin(), section.rows.end(), belongs)) continue;
        tree.container(
            dcm("125007", "Measurement Group"),
            [&] {
              const std::string name = sheet.title.english + ": " + section.title.english;
              tree.text(kContext, dcm("112039", "Tracking Identifier"), side.empty() ? name : name + ", " + side);
              tree.uid(kContext, dcm("112040", "Tracking Unique Identifier"), newDicomUid());
              for (const WorksheetRow& row : section.rows)
                if (belongs(row)) writer.row(row);
            },
            "1501");
      }
  });
  writer.comment(kTrainingOnly);
  for (const SummaryReading& each : sheet.summaries) writer.comment(each.title.english + ": " + each.says.english);
}

tl::unexpected<Error> notMade(const std::string& why) {
  return failure(ErrorCode::internal,
                 say<"The structured report could not be made (%1); save the worksheet as .json or .csv instead.">(verbatim(why)));
}

}  // namespace

Result<DicomReference> writeMeasurementReport(const Worksheet& worksheet, const MeasurementReportOptions& options, const DicomStudy& study,
                                              const std::filesystem::path& file) {
  if (auto named = checkIdentifiers(study, study.reportsUid, options.instanceUid); !named) return passOn(named.error());
  if (worksheet.sections.empty()) return failure(ErrorCode::badField, say<"The worksheet is empty; measure something first.">());
  quietDcmtk();
  DSRDocument document(DSRTypes::DT_ComprehensiveSR);
  document.setSpecificCharacterSetType(DSRTypes::CS_UTF8);
  ReportTree tree(document.getTree());
  if (worksheet.package == "obstetric")
    ObstetricReport(tree, worksheet).write(options.images);
  else
    writeImagingReport(tree, worksheet, options.images);
  if (!tree.refused().empty()) return notMade(tree.refused());
  for (const DicomReference& image : options.images) {
    const auto added = document.getCurrentRequestedProcedureEvidence().addItem(study.studyUid.c_str(), study.imagesUid.c_str(),
                                                                               image.classUid.c_str(), image.instanceUid.c_str());
    if (added.bad()) return notMade(added.text());
  }
  document.getCodingSchemeIdentification().addItem(kPrivateCodingScheme);
  document.getCodingSchemeIdentification().setCodingSchemeName("Measurement packages of EchoWeave, PACKAGE.LABEL");
  document.getCodingSchemeIdentification().setCodingSchemeResponsibleOrganization("EchoWeave");
  document.completeDocument(kSimulation);

  DcmFileFormat made;
  if (const auto written = document.write(*made.getDataset()); written.bad()) return notMade(written.text());
  Elements elements(*made.getDataset());
  putPatientAndStudy(elements, study);
  putSeriesAndEquipment(
      elements, study,
      {kComprehensiveSrClass, options.instanceUid, study.reportsUid, "SR", 2, options.number, "Simulated measurements", options.made});
  elements.text(DCM_ContentDate, dicomDate(options.made));
  elements.text(DCM_ContentTime, dicomTime(options.made));
  if (auto put = elements.check(); !put) return passOn(put.error());
  const auto bytes = bytesOf(made);
  if (!bytes) return passOn(bytes.error());
  auto saved = writeFileSafely(file, std::string_view(bytes->data(), bytes->size()));
  if (!saved) return passOn(saved.error());
  return DicomReference{kComprehensiveSrClass, options.instanceUid};
}

}  // namespace ew
