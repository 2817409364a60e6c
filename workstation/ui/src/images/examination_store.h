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
#include "images/saved_image.h"

namespace ew::ui {

class Session;
class Worksheets;

/// The images that were stored of the patient who is scanned, as a console's key for it keeps them, and the worksheets beside them: what
/// becomes a report with images and goes to an archive. Another patient begins with none; images are there again with their patient,
/// for they are kept in the library (ImageStore).
class ExaminationStore final : public QObject {
  Q_OBJECT

 public:
  struct Item {
    QImage image;     ///< as savedImage
    QString caption;  ///< probe, depth and when
    ExaminationFiles::StillRecord still;
    std::uint64_t revision = 0;  ///< never the same for two images of a session
    bool hasLeft = false;        ///< it was saved or sent
    bool isKept = true;          ///< in the library, or on its way there
  };

  ExaminationStore(Session& session, Worksheets& worksheets, QObject* parent = nullptr);

  /// Keeps what the scan shows now. @param parts, columns as of savedImages @param study of the patient, taken with the first image
  /// @return false: there is no image
  bool store(const std::vector<SnapshotPart>& parts, int columns, const DicomStudy& study, const QDateTime& at);
  [[nodiscard]] const std::vector<Item>& items() const { return items_; }
  void remove(std::size_t item);
  /// Neither images nor filled worksheets.
  [[nodiscard]] bool isEmpty() const;
  /// Images and worksheets for files and archives; one that was not changed keeps its identifier. @param study where none was taken yet
  [[nodiscard]] ExaminationFiles files(const DicomStudy& study, const QDateTime& at);

  /// Grows with every image that is stored. Whoever begins to save takes it along.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }
  /// Stored images that were neither saved nor sent.
  [[nodiscard]] std::size_t unsavedCount() const;
  [[nodiscard]] bool isUnsaved() const { return unsavedCount() > 0; }
  /// Of these, the ones that are not in the library: they are lost when another patient is scanned.
  [[nodiscard]] std::size_t atRiskCount() const;
  /// What was there at a revision was saved or sent; what was stored since was not.
  void setSaved(std::uint64_t revision);
  /// Where the images of this patient are kept from now on (ImageStore::folderOf): those that are here are kept there as well, and those
  /// that lie there come back. Another patient, or somebody else who stores, begins with clear().
  void keepIn(const std::filesystem::path& folder);
  [[nodiscard]] const std::filesystem::path& folder() const { return store_.folder(); }  ///< empty: they are kept nowhere yet
  /// Waits until every image is written.
  void flush() { store_.flush(); }
  /// Every image goes.
  void clear();

 Q_SIGNALS:
  void changed();
  void notKept(const ew::Error& problem);

 private:
  struct ReportEntry {
    std::string contents;
    ExaminationFiles::Report report;
  };
  void keep(const Item& item);
  void takeBack(const std::vector<ImageStore::Kept>& images);

  Session& session_;
  Worksheets& worksheets_;
  std::vector<Item> items_;
  std::optional<DicomStudy> study_;
  std::map<std::string, ReportEntry> reports_;  ///< by package, as last asked for
  int number_ = 0;                              ///< of images of this examination so far
  std::uint64_t revision_ = 0;
  ImageStore store_;
};

/// What is shown, ready to be written as DICOM: each image and strip with its scale; probe and settings are those of the image in hand.
/// Expects an image in hand.
[[nodiscard]] ExaminationFiles::StillRecord storedStill(const std::vector<SnapshotPart>& parts, const Snapshot& saved, int number,
                                                        const QDateTime& at);

/// An image as it may leave the program: with the words it must carry.
[[nodiscard]] QImage withWarning(const QImage& saved);

}  // namespace ew::ui
