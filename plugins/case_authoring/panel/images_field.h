#pragma once

#include <QWidget>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "ew/core/result.h"

namespace ew::case_authoring {

/// An image of an earlier examination as it is kept in a case: pixels alone, without what a file may say of patient, place or device.
struct CleanImage {
  std::string bytes;   ///< PNG, or JPEG of what came as one
  std::string ending;  ///< ".png" or ".jpg"
};
inline constexpr int kMostImageBytes = 20 << 20;  ///< of a file that is taken
inline constexpr int kLongestSide_px = 1600;      ///< larger ones are made smaller

/// Reads an image, turns it as its file says, makes it small enough and encodes its pixels anew.
/// @error notFound, tooLarge, unsupported (no PNG or JPEG, or damaged)
[[nodiscard]] Result<CleanImage> cleanImage(const std::filesystem::path& file);
/// "media/" and the first 16 hexadecimal digits of the SHA-256 of the bytes: the same image is kept once.
[[nodiscard]] std::string imageName(const CleanImage& image);

/// The images of an earlier examination as thumbnails, each with a cross, and a button that adds more.
class ImagesField final : public QWidget {
  Q_OBJECT

 public:
  /// @param name of the widgets: NAME + "add", NAME + "picture_0", NAME + "removePicture_0"
  /// @param folder of the case
  ImagesField(const QString& name, const std::filesystem::path& folder, const std::vector<std::string>& images, QWidget* parent = nullptr);

  std::function<void()> onAdd;  ///< the user wants more
  std::function<void(std::size_t number)> onRemove;
};

}  // namespace ew::case_authoring
