#pragma once

#include <QImage>
#include <QObject>
#include <filesystem>
#include <string>
#include <vector>

#include "ew/export/image_record.h"
#include "ew/widgets/worker.h"

namespace ew::ui {

/// The images that one person has stored of one patient, in a folder of the library that is for that account alone: a .png with the words
/// it must carry, and what is known of it beside that. A thread writes and reads; an image is known by its DICOM identifier.
class ImageStore final : public QObject {
  Q_OBJECT

 public:
  struct Kept {
    QImage image;  ///< Format_Grayscale8 or Format_RGB888
    ImageRecord about;
  };

  explicit ImageStore(QObject* parent = nullptr);
  ~ImageStore() override;  ///< waits until all is written

  /// @param patient what tells the patient from others: a case's id, a file's path @param person as they call themselves; may be empty
  [[nodiscard]] static std::filesystem::path folderOf(const std::filesystem::path& library, const std::string& patient,
                                                      const std::string& person);
  /// From now on images are those of this folder; what lies there is read (see read()). Empty: nothing is kept.
  void turnTo(const std::filesystem::path& folder);
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

  void keep(const QImage& image, const ImageRecord& about);
  void remove(const std::string& instanceUid);
  /// Waits until all is written.
  void flush();

 Q_SIGNALS:
  void read(const std::filesystem::path& folder, const std::vector<ew::ui::ImageStore::Kept>& images);  ///< the oldest first
  void failed(const std::string& instanceUid, const ew::Error& problem);                                ///< it could not be written

 private:
  std::filesystem::path folder_;
  Worker worker_;
};

}  // namespace ew::ui
