#include "images/image_store.h"

#include <QCryptographicHash>
#include <algorithm>
#include <future>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "ew/core/json_fields.h"
#include "ew/io/private_file.h"
#include "ew/io/safe_file.h"
#include "ew/scanning/display_image_file.h"
#include "ew/widgets/qt_image.h"
#include "ew/widgets/words.h"

namespace ew::ui {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostShown = 100;  ///< of one patient; older ones stay in the folder
constexpr std::size_t kLongestNote_bytes = 1u << 20;

/// Of a name that may hold anything.
std::string folderNameOf(const std::string& name) {
  return QCryptographicHash::hash(QByteArray::fromStdString(name), QCryptographicHash::Sha256).toHex().left(16).toStdString();
}

Result<void> writeKept(const fs::path& folder, const QImage& image, const ImageRecord& about) {
  std::error_code failed;
  fs::create_directories(folder.parent_path(), failed);  // the library's; others may have folders there
  if (auto made = makePrivateFolder(folder); !made) return made;
  const fs::path file = folder / (about.options.instanceUid + ".png");
  auto written = image.format() == QImage::Format_Grayscale8
                     ? writeDisplayImage(DisplayImage{{image.constBits(), image.width(), image.height(), image.bytesPerLine()}}, 1.0, file)
                     : writeDisplayImage(coloursOf(image), 1.0, file);
  if (!written) return written;
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write, failed);
  return writePrivateFile(folder / (about.options.instanceUid + ".json"),
                          toJson(about).dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

std::vector<ImageRecord> notesIn(const fs::path& folder) {
  std::vector<ImageRecord> all;
  std::error_code failed;
  for (fs::directory_iterator at(folder, failed); !failed && at != fs::directory_iterator(); at.increment(failed)) {
    if (at->path().extension() != ".json") continue;
    const Message where = verbatim(at->path().string());
    const auto text = readTextFile(at->path(), kLongestNote_bytes);
    const auto document = text ? parseJsonObject(*text, where) : Result<nlohmann::json>(passOn(text.error()));
    auto note = document ? storedImageFromJson(*document, where) : Result<ImageRecord>(passOn(document.error()));
    if (note && at->path().stem() == note->options.instanceUid) all.push_back(std::move(*note));
  }
  std::sort(all.begin(), all.end(), [](const ImageRecord& a, const ImageRecord& b) {
    return std::pair(a.options.taken, a.options.number) < std::pair(b.options.taken, b.options.number);
  });
  if (all.size() > kMostShown) all.erase(all.begin(), all.end() - kMostShown);
  return all;
}

std::vector<ImageStore::Kept> readKept(const fs::path& folder) {
  std::vector<ImageStore::Kept> all;
  for (ImageRecord& note : notesIn(folder)) {
    QImage image;
    if (!image.load(wordsOf(folder / (note.options.instanceUid + ".png")))) continue;
    image = image.convertToFormat(image.isGrayscale() ? QImage::Format_Grayscale8 : QImage::Format_RGB888);
    all.push_back({std::move(image), std::move(note)});
  }
  return all;
}

}  // namespace

ImageStore::ImageStore(QObject* parent) : QObject(parent) {}

ImageStore::~ImageStore() { flush(); }

fs::path ImageStore::folderOf(const fs::path& library, const std::string& patient, const std::string& person) {
  return library / "stored-images" / (folderNameOf(patient) + "-" + folderNameOf(person));
}

void ImageStore::turnTo(const fs::path& folder) {
  if (folder == folder_) return;
  folder_ = folder;
  if (folder.empty()) return;
  worker_.add([this, folder] {
    auto images = readKept(folder);
    QMetaObject::invokeMethod(
        this, [this, folder, images = std::move(images)] { Q_EMIT read(folder, images); }, Qt::QueuedConnection);
  });
}

void ImageStore::keep(const QImage& image, const ImageRecord& about) {
  if (folder_.empty()) return;
  worker_.add([this, folder = folder_, image, about] {
    const auto written = writeKept(folder, image, about);
    if (written) return;
    QMetaObject::invokeMethod(
        this, [this, problem = written.error(), uid = about.options.instanceUid] { Q_EMIT failed(uid, problem); }, Qt::QueuedConnection);
  });
}

void ImageStore::remove(const std::string& instanceUid) {
  if (folder_.empty()) return;
  worker_.add([folder = folder_, instanceUid] {
    std::error_code ignored;
    for (const char* ending : {".json", ".png"}) fs::remove(folder / (instanceUid + ending), ignored);
  });
}

void ImageStore::flush() {
  std::promise<void> done;
  worker_.add([&done] { done.set_value(); });
  done.get_future().wait();
}

}  // namespace ew::ui
