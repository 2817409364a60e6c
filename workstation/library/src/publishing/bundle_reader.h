#pragma once

#include <filesystem>
#include <memory>
#include <span>

#include "ew/library/bundle.h"
#include "files/file_pieces.h"
#include "publishing/bundle_header.h"

namespace ew {

/// Where the files of a bundle go.
class BundleSink {
 public:
  virtual ~BundleSink() = default;
  [[nodiscard]] virtual Result<void> begin(const FileSum& file) = 0;
  [[nodiscard]] virtual Result<void> data(std::span<const std::byte> piece) = 0;
  [[nodiscard]] virtual Result<void> end() = 0;  ///< the file is complete and holds what the list says
};

/// A bundle that is read from its beginning to its end, once.
class BundleReader {
 public:
  /// Reads bundle.json. @param progress outlives the reader: it is asked whether to go on, also between files
  /// @error as readBundleHeader, cancelled
  [[nodiscard]] static Result<BundleReader> open(const std::filesystem::path& file, const BundleLimits& limits, Progress& progress);
  ~BundleReader();
  BundleReader(BundleReader&&) noexcept;
  BundleReader& operator=(BundleReader&&) = delete;

  [[nodiscard]] const BundleHeader& header() const;
  /// Every file that is listed, in the order they come, each checked; and that there is nothing else up to the end of the bundle.
  /// @error as importBundle, of the sink
  [[nodiscard]] Result<void> readFiles(BundleSink& sink, ByteCount& count);

 private:
  struct Parts;
  explicit BundleReader(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

}  // namespace ew
