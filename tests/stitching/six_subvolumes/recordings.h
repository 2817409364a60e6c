#pragma once

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "ew/imaging/probe.h"
#include "ew/io/safe_file.h"
#include "ew/io/sequence.h"
#include "ew/phantom/patient.h"
#include "ew/phantom/virtual_sweep.h"
#include "places.h"

namespace ew::test {

/// Six overlapping sweeps of one virtual patient, pressed in by different amounts, as a laboratory records them, and what is true about
/// them: where each probe was, and how its face pushed the tissue.
class SixRecordings {
 public:
  static constexpr std::size_t kViews = 6;

  /// Records into `folder` what is not there yet.
  /// @param outOfFrame every recording in a frame of its own, as without a common tracker; else all in the patient's world
  void make(const std::filesystem::path& folder, bool outOfFrame) {
    const std::filesystem::path source(EW_SOURCE_DIR);
    const auto patient = readPatient(source / "cases/upper-abdomen-gall-stone/patient.json", source / "resources/mannequin");
    ASSERT_TRUE(patient) << patient.error();
    for (std::size_t n = 0; n < kViews; ++n) {
      const std::string name = "view" + std::to_string(n);
      const auto recipe = readSweepRecipe(source / "tests/stitching/six_subvolumes" / (name + ".json"));
      ASSERT_TRUE(recipe) << recipe.error();
      const auto probe = readProbe(source / "resources/probes" / (recipe->probe + ".json"));
      ASSERT_TRUE(probe) << probe.error();
      View& view = views_[n];
      if (outOfFrame) view.fromWorld = ownFrame(n);
      std::vector<glm::dmat4> poses;
      if (!std::filesystem::exists(folder / (name + ".truth"))) {
        auto swept = recordSweep(*patient, *probe, *recipe, 0, noProgress());
        ASSERT_TRUE(swept) << swept.error();
        for (auto& frame : swept->sequence.frames)
          for (auto& each : frame.transforms)
            if (each.to == "Reference") each.matrix = view.fromWorld.matrix * each.matrix;
        ASSERT_TRUE(writeDeviceSet(swept->deviceSet, folder / (name + ".xml")));
        ASSERT_TRUE(writeSequence(swept->sequence, folder / (name + ".igs.mha")));
        std::ofstream out(folder / (name + ".truth"));
        out.precision(17);
        for (const auto& pose : swept->trueProbeToWorld)
          for (int n16 = 0; n16 < 16; ++n16) out << pose.matrix[n16 / 4][n16 % 4] << (n16 == 15 ? '\n' : ' ');
      }
      std::ifstream in(folder / (name + ".truth"));
      for (glm::dmat4 pose(1.0); in;) {
        for (int n16 = 0; n16 < 16; ++n16) in >> pose[n16 / 4][n16 % 4];
        if (in) poses.push_back(pose);
      }
      ASSERT_EQ(poses.size(), static_cast<std::size_t>(recipe->frames));
      for (const glm::dmat4& pose : poses) {
        view.toProbe.push_back(glm::inverse(pose));
        view.pressure.push_back(deformationOf(**patient, *probe, *recipe, {pose}, {}));
      }
    }
  }

  /// The world's mm to those of the recording; a view's true place is the inverse.
  [[nodiscard]] const Transform<frame::View, frame::World>& fromWorld(std::size_t view) const { return views_[view].fromWorld; }

  /// Where the tissue rests, in the patient's world, that a recording shows at a point of its own frame.
  [[nodiscard]] glm::dvec3 tissueAt(std::size_t view, const glm::dvec3& p_mm) const {
    const View& of = views_[view];
    const glm::dvec3 p_world = carried(inverse(of.fromWorld), p_mm);
    return of.pressure[frameAt(of, p_world)]->rest(p_world);
  }
  /// The way back: where a recording shows what rests at a point of the world.
  [[nodiscard]] glm::dvec3 shownAt(std::size_t view, const glm::dvec3& rest_mm) const {
    const View& of = views_[view];
    glm::dvec3 p_world = rest_mm;
    for (int round = 0; round < 3; ++round) p_world = of.pressure[frameAt(of, p_world)]->moved(rest_mm);
    return carried(of.fromWorld, p_world);
  }

 private:
  struct View {
    Transform<frame::View, frame::World> fromWorld;
    std::vector<glm::dmat4> toProbe;
    std::vector<std::unique_ptr<Deformation>> pressure;
  };

  /// The frame whose plane is nearest.
  static std::size_t frameAt(const View& view, const glm::dvec3& p_world) {
    std::size_t nearest = 0;
    double least = std::numeric_limits<double>::max();
    for (std::size_t f = 0; f < view.toProbe.size(); ++f) {
      const double beside = std::abs((view.toProbe[f] * glm::dvec4(p_world, 1.0)).z);
      if (beside < least) {
        least = beside;
        nearest = f;
      }
    }
    return nearest;
  }

  /// Turned by up to 21 degrees and shifted by up to 100 mm, for each view otherwise.
  static Transform<frame::View, frame::World> ownFrame(std::size_t view) {
    const auto n = static_cast<double>(view);
    const glm::dvec3 axis = glm::normalize(glm::dvec3(std::sin(1.0 + 2.1 * n), std::cos(0.3 + 1.3 * n), std::sin(2.0 + 0.7 * n)));
    const double turn = (view == 0 ? 0.0 : 6.0 + 3.0 * n) * 3.14159265358979 / 180.0;
    const double c = std::cos(turn), s = std::sin(turn);
    const glm::dmat3 cross(0.0, axis.z, -axis.y, -axis.z, 0.0, axis.x, axis.y, -axis.x, 0.0);
    glm::dmat4 frame(glm::dmat3(1.0) + s * cross + (1.0 - c) * cross * cross);
    frame[3] = glm::dvec4(60.0 * std::sin(3.0 * n), -50.0 * std::sin(2.0 * n), 80.0 * std::sin(5.0 * n), 1.0);
    return {frame};
  }

  std::array<View, kViews> views_;
};

}  // namespace ew::test
