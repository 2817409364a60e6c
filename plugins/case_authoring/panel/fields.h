#pragma once

#include <QString>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "ew/library/case_values.h"
#include "ew/widgets/words.h"
#include "panel/list_field.h"

namespace ew::case_authoring {

/// The name of the widget that edits a dotted field of case.json: "patient_name".
inline QString nameOf(const std::string& path) { return words(path).replace(QLatin1Char('.'), QLatin1Char('_')); }

/// A size that people read has no hundredths: "42 MiB", "4.2 MiB".
[[nodiscard]] QString sizeWords(std::uint64_t bytes);

/// Earlier examinations, one below the other: when, what kind, what it said, and its images.
class ExaminationsField final : public ListField<CaseExamination> {
  Q_OBJECT

 public:
  /// What was examined before, or values from the laboratory: those have no kind.
  enum class Of { examinations, laboratory };
  explicit ExaminationsField(Of what = Of::examinations, QWidget* parent = nullptr);

  void setFolder(const std::filesystem::path& folder);  ///< of the case, where its images lie
  /// The user wants images in an examination; answered by addImages.
  std::function<void(std::size_t number)> onImagesAsked;
  /// @param files in the case folder, as it names them ("media/….png"); those that are there already stay once
  void addImages(std::size_t number, const std::vector<std::string>& files);

 private:
  void addRows(std::size_t number, QVBoxLayout& rows) override;
  void addImagesOf(std::size_t number, QVBoxLayout& rows);
  [[nodiscard]] QString namePrefix(std::size_t number) const;
  void editText(std::size_t number, std::string CaseExamination::*text, const QString& typed);

  Of what_;
  std::filesystem::path folder_;
};

}  // namespace ew::case_authoring
