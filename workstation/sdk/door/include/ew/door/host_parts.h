#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "ew/library/case_values.h"
#include "ew/library/schema.h"
#include "ew/sdk/case_parts.h"
#include "ew/sdk/host.h"

namespace ew::door {

/// Volumes of a host in files. What a reader had to decide goes to the log. There is nowhere to show one; a host with a window adds that.
class FileVolumes : public sdk::Volumes {
 public:
  Result<Volume> read(const std::filesystem::path& file, Progress& progress) override;
  Result<void> write(const Volume& volume, const std::filesystem::path& file, Progress& progress) override;
  Result<void> writeCoverage(const Volume& volume, const std::filesystem::path& file, Progress& progress) override;
  Result<void> readCoverageInto(Volume& volume, const std::filesystem::path& file, Progress& progress) override;
  Result<sdk::VolumeInfo> inspect(const std::filesystem::path& file) override;
  Result<std::vector<std::uint8_t>> readConfidence(const Grid& grid, const std::filesystem::path& file, Progress& progress) override;
  Result<void> writeConfidence(const Grid& grid, std::span<const std::uint8_t> confidence, const std::filesystem::path& file,
                               Progress& progress) override;
  Result<sdk::SweepPlan> planSweep(const std::filesystem::path& sweep, const sdk::SweepOptions& options, Progress& progress) override;
  Result<sdk::SweepVolume> reconstruct(const std::filesystem::path& sweep, const sdk::SweepOptions& options, Progress& progress) override;
  Result<std::unique_ptr<sdk::VolumeWriter>> writeInBlocks(const Grid& grid, const std::filesystem::path& file) override;
  void show(Volume volume, const std::string& title) override;
};

class TextFiles final : public sdk::Files {
 public:
  Result<std::string> readText(const std::filesystem::path& file) override;
  Result<void> writeText(const std::filesystem::path& file, const std::string& text) override;
};

/// The schemas of sections that plugins keep in a case. Shared, because tickets take them out again.
class PartSchemas : public std::enable_shared_from_this<PartSchemas> {
 public:
  /// As sdk::CaseParts::add.
  [[nodiscard]] Result<sdk::Ticket> add(const std::string& name, const std::string& schema);
  [[nodiscard]] bool knows(const std::string& name) const { return schemas_.contains(name); }
  /// What the known schemas say about the sections of a manifest, or of the fields of a case that are JSON (Case::otherFields).
  [[nodiscard]] std::vector<Error> problems(const nlohmann::json& manifest) const;
  /// Everything that is wrong with a case, its sections too. @param folder where its files are looked for; empty: they are not
  [[nodiscard]] std::vector<Error> problemsIn(Case edited, const std::filesystem::path& folder) const;
  /// Of one section.
  [[nodiscard]] std::vector<Error> problems(const std::string& name, const nlohmann::json& section) const;

 private:
  std::map<std::string, PartSchema> schemas_;
};

/// The section of a manifest or of Case::otherFields; empty: it has none.
[[nodiscard]] std::optional<nlohmann::json> partOf(const nlohmann::json& manifest, const std::string& name);
/// The case with the section in place of its own, or without it; the last one takes "parts" along.
[[nodiscard]] Case withPart(Case edited, const std::string& name, const std::optional<nlohmann::json>& section);

/// The log of the program, which is spdlog's default one.
class ProgramLog final : public sdk::Log {
 public:
  void info(const std::string& text) override;
  void warn(const std::string& text) override;
  void error(const std::string& text) override;
};

}  // namespace ew::door
