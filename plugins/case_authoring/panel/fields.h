#pragma once

#include <QComboBox>
#include <QString>
#include <QStringList>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "ew/library/case_values.h"
#include "ew/widgets/words.h"

class QVBoxLayout;

namespace ew::case_authoring {

/// The name of the widget that edits a dotted field of case.json: "patient_name".
inline QString nameOf(const std::string& path) { return words(path).replace(QLatin1Char('.'), QLatin1Char('_')); }

/// A size that people read has no hundredths: "42 MiB", "4.2 MiB".
[[nodiscard]] QString sizeWords(std::uint64_t bytes);

/// Earlier examinations, one below the other: when, what kind, what it said, and its images. Fields of an examination that it does not
/// show stay as they are.
class ExaminationsField final : public QWidget {
  Q_OBJECT

 public:
  /// What was examined before, or values from the laboratory: those have no kind.
  enum class Of { examinations, laboratory };
  explicit ExaminationsField(Of what = Of::examinations, QWidget* parent = nullptr);

  void setValue(const std::vector<CaseExamination>& list);
  std::function<void(const std::vector<CaseExamination>& list)> onChanged;  ///< called when the user edits
  void setFolder(const std::filesystem::path& folder);                      ///< of the case, where its images lie
  /// The user wants images in an examination; answered by addPictures.
  std::function<void(std::size_t number)> onImagesAsked;
  /// @param files in the case folder, as it names them ("media/….png"); those that are there already stay once
  void addImages(std::size_t number, const std::vector<std::string>& files);

 private:
  void remake();
  void addOne(std::size_t number);
  void addImagesOf(std::size_t number, QVBoxLayout& rows);
  void tell();
  [[nodiscard]] QString namePrefix(std::size_t number) const;
  void edit(std::size_t number, std::string CaseExamination::*text, const QString& typed);

  Of what_;
  std::filesystem::path folder_;
  std::vector<CaseExamination> list_;
  QVBoxLayout* column_ = nullptr;
  QWidget* entries_ = nullptr;
};

}  // namespace ew::case_authoring
