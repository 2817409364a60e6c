#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include "ew/phantom/patient.h"
#include "places.h"

namespace ew::testing {

inline std::filesystem::path shippedMannequin() { return std::string(EW_SOURCE_DIR) + "/resources/mannequin/adult.json"; }
inline std::filesystem::path shippedPatient(const std::string& id = "upper-abdomen-gall-stone") {
  return std::filesystem::path(EW_SOURCE_DIR) / "cases" / id / "patient.json";
}

/// A folder of its own for one test, gone afterwards.
class Folder {
 public:
  Folder() {
    static std::atomic<int> next{0};
    path_ = std::filesystem::temp_directory_path() / ("ew_phantom_" + std::to_string(::getpid()) + "_" + std::to_string(next++));
    std::filesystem::create_directories(path_);
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
    return path_ / name;
  }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

inline std::string bodyRecipe(const std::string& shape) { return R"({"format": 1, "name": "test body", "body": )" + shape + "}"; }

inline std::unique_ptr<BodyShape> bodyOf(const std::string& shape) {
  const Folder folder;
  auto body = readBodyShape(folder.write("body.json", bodyRecipe(shape)));
  if (!body) {
    ADD_FAILURE() << body.error();
    return nullptr;
  }
  return std::move(*body);
}

/// A patient in a ball of skin (radius 60 mm) in a box of +-40 mm, with one even tissue around the given organs.
inline std::string patientRecipe(const std::string& organs, const std::string& extra = "") {
  return R"({"format": 1, "name": "test", "mannequin": "ball.json", "box": {"lowest_mm": [-40, -40, -40], "highest_mm": [40, 40, 40]},
    "tissues": [{"name": "even", "echo_level": 100, "speckle": 1}, {"name": "smooth", "echo_level": 180, "speckle": 0},
                {"name": "dark", "echo_level": 0, "speckle": 0}],
    "background": "even", )" +
         extra + R"( "organs": [)" + organs + "]}";
}

inline Result<std::shared_ptr<const Patient>> patientOf(const std::string& recipe) {
  const Folder folder;
  folder.write("ball.json", bodyRecipe(R"({"ellipsoid": {"centre_mm": [0, 0, 0], "radii_mm": [60, 60, 60]}})"));
  return readPatient(folder.write("patient.json", recipe));
}

inline const Patient& shipped() {
  static const auto patient = readPatient(shippedPatient());
  if (!patient) {
    ADD_FAILURE() << patient.error();
    std::abort();
  }
  return **patient;
}

}  // namespace ew::testing
