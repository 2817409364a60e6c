#pragma once

#include <QDateTime>
#include <QImage>
#include <QObject>
#include <QString>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ew/export/examination_files.h"
#include "images/image_store.h"
#include "images/saved_picture.h"

namespace ew::ui {

class Session;
class Worksheets;

/// The pictures that were stored of the patient who is scanned, as a console's key for it keeps them, and the worksheets beside them: what
/// becomes a report with pictures and goes to an archive. Another patient begins with none; pictures are there again with their patient,
/// for they are kept in the library (ImageStore).
class StoredExamination final : public QObject {
  Q_OBJECT

 public:
  struct Item {
    QImage picture;   ///< as savedPicture
    QString caption;  ///< probe, depth and when
    ExaminationFiles::StoredStill still;
    std::uint64_t revision = 0;  ///< never the same for two pictures of a session
    bool hasLeft = false;        ///< it was saved or sent
    bool isKept = true;          ///< in the library, or on its way there
  };

  StoredExamination(Session& session, Worksheets& worksheets, QObject* parent = nullptr);

  /// Keeps what the scan shows now. @param parts, columns as of savedPictures @param study of the patient, taken with the first picture
  /// @return false: there is no picture
  bool store(const std::vector<SavedPart>& parts, int columns, const DicomStudy& study, const QDateTime& at);
  [[nodiscard]] const std::vector<Item>& items() const { return items_; }
  void remove(std::size_t item);
  /// Neither pictures nor filled worksheets.
  [[nodiscard]] bool isEmpty() const;
  /// Pictures and worksheets for files and archives; one that was not changed keeps its identifier. @param study where none was taken yet
  [[nodiscard]] ExaminationFiles files(const DicomStudy& study, const QDateTime& at);

  /// Grows with every picture that is stored. Whoever begins to save takes it along.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }
  /// Stored pictures that were neither saved nor sent.
  [[nodiscard]] std::size_t unsavedCount() const;
  [[nodiscard]] bool isUnsaved() const { return unsavedCount() > 0; }
  /// Of these, the ones that are not in the library: they are lost when another patient is scanned.
  [[nodiscard]] std::size_t atRiskCount() const;
  /// What was there at a revision was saved or sent; what was stored since was not.
  void setSaved(std::uint64_t revision);
  /// Where the pictures of this patient are kept from now on (ImageStore::folderOf): those that are here are kept there as well, and those
  /// that lie there come back. Another patient, or somebody else who stores, begins with clear().
  void keepIn(const std::filesystem::path& folder);
  [[nodiscard]] const std::filesystem::path& folder() const { return store_.folder(); }  ///< empty: they are kept nowhere yet
  /// Waits until every picture is written.
  void flush() { store_.flush(); }
  /// Every picture goes.
  void clear();

 Q_SIGNALS:
  void changed();
  void notKept(const ew::Error& problem);

 private:
  struct KnownReport {
    std::string contents;
    ExaminationFiles::Report report;
  };
  void keep(const Item& item);
  void takeBack(const std::vector<ImageStore::Kept>& images);

  Session& session_;
  Worksheets& worksheets_;
  std::vector<Item> items_;
  std::optional<DicomStudy> study_;
  std::map<std::string, KnownReport> reports_;  ///< by package, as last asked for
  int number_ = 0;                              ///< of pictures of this examination so far
  std::uint64_t revision_ = 0;
  ImageStore store_;
};

/// What is shown, ready to be written as DICOM: each picture and strip with its scale; probe and settings are those of the picture in hand.
/// Expects a picture in hand.
[[nodiscard]] ExaminationFiles::StoredStill storedStill(const std::vector<SavedPart>& parts, const SavedTogether& saved, int number,
                                                        const QDateTime& at);

/// A picture as it may leave the program: with the words it must carry.
[[nodiscard]] QImage withWarning(const QImage& saved);

}  // namespace ew::ui
