#pragma once

#include <archive.h>
#include <archive_entry.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "ew/io/volume_file.h"
#include "ew/library/bundle.h"
#include "library/temporary_folder.h"

namespace ew::test {

/// Everything below a folder: what is a file with its content, what is a link with its target. Two libraries with the same tree are the
/// same.
inline std::map<std::string, std::string> treeOf(const std::filesystem::path& folder) {
  namespace fs = std::filesystem;
  std::map<std::string, std::string> tree;
  if (!fs::exists(folder)) return tree;
  tree["."] = "a folder";
  for (const auto& each : fs::recursive_directory_iterator(folder)) {
    const std::string path = each.path().lexically_relative(folder).string();
    if (each.is_symlink())
      tree[path] = "-> " + fs::read_symlink(each.path()).string();
    else
      tree[path] = each.is_directory() ? "a folder" : "file " + textOf(each.path());
  }
  return tree;
}

inline Volume noisyVolume(const glm::ivec3& dims, unsigned seed) {
  Volume volume;
  volume.grid.dims = dims;
  volume.echo.resize(volume.grid.voxelCount());
  for (auto& value : volume.echo) {
    seed = seed * 1664525u + 1013904223u;
    value = static_cast<std::uint8_t>(seed >> 24);
  }
  return volume;
}

inline nlohmann::json manifestOfVolumeCase(const std::string& id, const std::string& title = "A knee") {
  return {{"format", 1},
          {"id", id},
          {"title", title},
          {"title_for_trainees", "A joint"},
          {"region", "knee"},
          {"indication", "Pain after a fall. Fluid?"},
          {"findings", {"No fluid."}},
          {"diagnosis", "A sound knee."},
          {"start_pose", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}},
          {"volume",
           {{"file", "volumes/v.mha"},
            {"attribution", "made for a test"},
            {"licence", "CC0"},
            {"file_to_world", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}}}};
}

/// A case folder with a volume and some files besides.
inline void makeVolumeCase(const std::filesystem::path& folder, const std::string& id, const glm::ivec3& dims = {20, 20, 20},
                           unsigned seed = 1) {
  std::filesystem::create_directories(folder / "volumes");
  ASSERT_TRUE(writeVolume(noisyVolume(dims, seed), folder / "volumes/v.mha"));
  writeText(folder / "media/übersicht.txt", "An image of sorts.");
  writeText(folder / "scans/expert.txt", std::string(3000, 'p'));
  writeText(folder / "case.json", manifestOfVolumeCase(id).dump(2));
}

/// An entry of a tar as somebody may have made it.
struct RawEntry {
  std::string path;
  std::string content = {};
  unsigned type = AE_IFREG;
  std::string hardLink = {};
  std::string symbolicLink = {};
};

inline std::string sumOf(const std::string& content) {
  Sha256 sum;
  sum.add(std::as_bytes(std::span(content)));
  return sum.hex();
}

inline nlohmann::json listed(const std::string& path, const std::string& content) {
  return {{"path", path}, {"size", content.size()}, {"sha256", sumOf(content)}};
}

/// A bundle.json around a list.
inline nlohmann::json headerAround(const nlohmann::json& files, const std::string& id = "knee") {
  return {{"format", 1}, {"kind", "case"}, {"id", id}, {"title", "A knee"}, {"revision", 1}, {"program", "0.1.0"}, {"files", files}};
}

/// A tar in zstd of any entries.
inline void writeRawBundle(const std::filesystem::path& file, const std::vector<RawEntry>& entries, bool pax = true) {
  archive* out = archive_write_new();
  if (pax)
    archive_write_set_format_pax_restricted(out);
  else
    archive_write_set_format_gnutar(out);
  archive_write_add_filter_zstd(out);
  ASSERT_EQ(archive_write_open_filename(out, file.c_str()), ARCHIVE_OK);
  for (const RawEntry& each : entries) {
    archive_entry* entry = archive_entry_new();
    archive_entry_set_pathname(entry, each.path.c_str());
    archive_entry_set_filetype(entry, each.type);
    archive_entry_set_perm(entry, 0644);
    archive_entry_set_size(entry, each.type == AE_IFREG ? static_cast<la_int64_t>(each.content.size()) : 0);
    if (!each.hardLink.empty()) archive_entry_set_hardlink(entry, each.hardLink.c_str());
    if (!each.symbolicLink.empty()) archive_entry_set_symlink(entry, each.symbolicLink.c_str());
    ASSERT_EQ(archive_write_header(out, entry), ARCHIVE_OK) << archive_error_string(out);
    if (!each.content.empty()) archive_write_data(out, each.content.data(), each.content.size());
    archive_entry_free(entry);
  }
  archive_write_close(out);
  archive_write_free(out);
}

/// A virtual patient as the smallest case that opens from case.json and one more file.
struct TinyCase {
  std::string manifest;
  std::string volume;  ///< what volumes/v.mha holds

  explicit TinyCase(const std::string& id = "knee") : manifest(manifestOfVolumeCase(id).dump()) {
    const TemporaryFolder folder;
    EXPECT_TRUE(writeVolume(noisyVolume({6, 5, 4}, 3), folder / "v.mha"));
    volume = textOf(folder / "v.mha");
  }
  [[nodiscard]] nlohmann::json list() const { return {listed("case.json", manifest), listed("volumes/v.mha", volume)}; }
  [[nodiscard]] std::vector<RawEntry> entries() const { return {{"case.json", manifest}, {"volumes/v.mha", volume}}; }
  [[nodiscard]] std::vector<RawEntry> bundle(const nlohmann::json& header) const {
    auto all = entries();
    all.insert(all.begin(), {"bundle.json", header.dump()});
    return all;
  }
};

}  // namespace ew::test
