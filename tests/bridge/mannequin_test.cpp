#include "ew/bridge/mannequin.h"

#include <gtest/gtest.h>
#include <vtkFeatureEdges.h>
#include <vtkOBJWriter.h>
#include <vtkPLYWriter.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSTLWriter.h>

#include <fstream>
#include <sstream>

#include "bridge/meshes.h"
#include "ew/phantom/patient.h"
#include "places.h"

namespace ew::bridge::mannequin_test {
namespace {

using test::Folder;
using test::sphereMesh;

template <class Writer>
void write(vtkPolyData* mesh, const std::filesystem::path& file, bool binary) {
  vtkNew<Writer> writer;
  writer->SetInputData(mesh);
  writer->SetFileName(file.c_str());
  if constexpr (requires { writer->SetFileTypeToBinary(); }) binary ? writer->SetFileTypeToBinary() : writer->SetFileTypeToASCII();
  writer->Write();
}

std::string contentOf(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

void expectSphere(const Result<Mannequin>& loaded, double radius_mm) {
  ASSERT_TRUE(loaded) << loaded.error();
  EXPECT_NEAR(loaded->bounds.highest_mm.z, radius_mm, 1e-3 * radius_mm);
  const auto hit = loaded->skin->hit({0.0, -9000.0, 0.0}, {0.0, 1.0, 0.0});
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->point_mm.y, -radius_mm, 2e-3 * radius_mm);
  EXPECT_LT(hit->outward.y, -0.99);
  ASSERT_NE(loaded->surface->GetPointData()->GetNormals(), nullptr);
}

class EveryMeshFormat : public testing::TestWithParam<const char*> {
 protected:
  std::filesystem::path written(vtkPolyData* mesh) {
    const std::string kind = GetParam();
    if (kind == "stl binary") write<vtkSTLWriter>(mesh, folder_ / "body.stl", true);
    if (kind == "stl ascii") write<vtkSTLWriter>(mesh, folder_ / "body.stl", false);
    if (kind == "ply binary") write<vtkPLYWriter>(mesh, folder_ / "body.ply", true);
    if (kind == "ply ascii") write<vtkPLYWriter>(mesh, folder_ / "body.ply", false);
    if (kind == "obj") write<vtkOBJWriter>(mesh, folder_ / "body.obj", false);
    return folder_ / ("body." + kind.substr(0, 3));
  }
  Folder folder_{"mannequin"};
};

TEST_P(EveryMeshFormat, IsReadWithItsSizeAndOutwardNormals) { expectSphere(loadMannequin(written(sphereMesh(800.0, 32))), 800.0); }

TEST_P(EveryMeshFormat, InMetresIsScaledAndANoteSaysSo) {
  const auto loaded = loadMannequin(written(sphereMesh(0.875, 32)));
  expectSphere(loaded, 875.0);
  ASSERT_EQ(loaded->notes.size(), 1U);
  EXPECT_NE(loaded->notes[0].english().find("metres"), std::string::npos) << loaded->notes[0];
}

TEST_P(EveryMeshFormat, CutShortAnywhereIsAnErrorOrASmallerMeshButNeverACrash) {
  const auto file = written(sphereMesh(800.0, 10));
  const std::string whole = contentOf(file);
  for (int part = 0; part <= 40; ++part) {
    const auto cut = folder_.write("cut" + file.extension().string(), whole.substr(0, whole.size() * static_cast<std::size_t>(part) / 41));
    const auto loaded = loadMannequin(cut);
    if (!loaded) {
      EXPECT_NE(loaded.error().sentence().find("cut."), std::string::npos) << loaded.error();
      EXPECT_EQ(loaded.error().sentence().back(), '.');
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Mannequin, EveryMeshFormat, testing::Values("stl binary", "stl ascii", "ply binary", "ply ascii", "obj"));

TEST(Mannequin, TrianglesThatFaceInwardsAreTurned) {
  const Folder folder("inward");
  std::string text = "v 0 0 0\nv 900 0 0\nv 0 900 0\nv 0 0 900\n";
  text += "f 1 2 3\nf 1 4 2\nf 2 4 3\nf 1 3 4\n";  // counter-clockwise seen from inside
  const auto loaded = loadMannequin(folder.write("inward.obj", text));
  ASSERT_TRUE(loaded) << loaded.error();
  const auto below = loaded->skin->nearest({200.0, 200.0, -50.0});
  EXPECT_LT(below.outward.z, -0.9);
  ASSERT_EQ(loaded->notes.size(), 1U);
  EXPECT_NE(loaded->notes[0].english().find("inwards"), std::string::npos);
}

TEST(Mannequin, EachKindOfBadFileIsNamed) {
  const Folder folder("bad");
  const auto codeOf = [](const std::filesystem::path& file) {
    const auto loaded = loadMannequin(file);
    return loaded ? std::string("loaded") : std::string(nameOf(loaded.error().code));
  };
  EXPECT_EQ(codeOf(folder / "nothing.stl"), nameOf(ErrorCode::notFound));
  EXPECT_EQ(codeOf(folder.write("a.doc", "x")), nameOf(ErrorCode::unsupported));
  EXPECT_EQ(codeOf(folder.write("empty.ply", "")), nameOf(ErrorCode::emptyVolume));
  EXPECT_EQ(codeOf(folder.write("points.obj", "v 0 0 0\nv 1 0 0\n")), nameOf(ErrorCode::emptyVolume));
  EXPECT_EQ(codeOf(folder.write("corner.obj", "v 0 0 0\nv 900 0 0\nv 0 900 0\nf 1 2 999\n")), nameOf(ErrorCode::badField));
  EXPECT_EQ(codeOf(folder.write("least.obj", "v 0 0 0\nv 900 0 0\nv 0 900 0\nf 1 2 -9223372036854775808\n")), nameOf(ErrorCode::badField));
  EXPECT_EQ(codeOf(folder.write("zero.obj", "v 0 0 0\nv 900 0 0\nv 0 900 0\nf 1 2 0\n")), nameOf(ErrorCode::badField));
  EXPECT_EQ(codeOf(folder.write("nan.obj", "v 0 0 nan\nv 900 0 0\nv 0 900 0\nf 1 2 3\n")), nameOf(ErrorCode::badField));
  EXPECT_EQ(codeOf(folder.write("small.obj", "v 0 0 0\nv 9 0 0\nv 0 9 0\nf 1 2 3\n")), nameOf(ErrorCode::badField));
  EXPECT_EQ(codeOf(folder.write("notply.ply", "solid x\n")), nameOf(ErrorCode::badHeader));
}

TEST(Mannequin, AHeaderThatPromisesMoreThanTheFileHoldsTakesNoMemory) {
  const Folder folder("promise");
  std::string stl(84, '\0');
  stl[80] = stl[81] = stl[82] = stl[83] = '\xff';
  EXPECT_EQ(loadMannequin(folder.write("huge.stl", stl)).error().code, ErrorCode::truncated);
  const std::string ply =
      "ply\nformat binary_little_endian 1.0\nelement vertex 15000000\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 15000000\nproperty list uchar int vertex_indices\nend_header\n";
  EXPECT_EQ(loadMannequin(folder.write("huge.ply", ply)).error().code, ErrorCode::truncated);
}

TEST(Mannequin, FacesMayComeBeforeTheirPoints) {
  const Folder folder("order");
  const auto loaded = loadMannequin(folder.write("order.obj", "f 1 2 3\nv 0 0 0\nv 900 0 0\nv 0 900 0\n"));
  EXPECT_TRUE(loaded) << loaded.error();
}

/// A ball of 300 mm beside the origin.
class Ball final : public BodyShape {
 public:
  [[nodiscard]] double signedDistance_mm(const glm::dvec3& p) const override { return glm::distance(p, centre_mm) - 300.0; }
  [[nodiscard]] Bounds bounds() const override { return {centre_mm - 300.0, centre_mm + 300.0}; }
  glm::dvec3 centre_mm{100.0, -50.0, 20.0};
};

TEST(Polygonise, ABallIsClosedRoundAndFacesOutwards) {
  const Ball ball;
  const auto made = polygonise(ball, {.cell_mm = 8.0});
  ASSERT_TRUE(made) << made.error();
  vtkNew<vtkFeatureEdges> open;
  open->SetInputData(made->surface);
  open->BoundaryEdgesOn();
  open->NonManifoldEdgesOn();
  open->FeatureEdgesOff();
  open->ManifoldEdgesOff();
  open->Update();
  EXPECT_EQ(open->GetOutput()->GetNumberOfCells(), 0);
  for (vtkIdType id = 0; id < made->surface->GetNumberOfPoints(); id += 7) {
    glm::dvec3 p;
    glm::dvec3 n;
    made->surface->GetPoint(id, &p.x);
    made->surface->GetPointData()->GetNormals()->GetTuple(id, &n.x);
    EXPECT_LT(std::abs(ball.signedDistance_mm(p)), 0.1);
    EXPECT_GT(glm::dot(n, glm::normalize(p - ball.centre_mm)), 0.9999);
  }
  // The winding agrees with the normals: a black body otherwise.
  vtkIdType count = 0;
  const vtkIdType* ids = nullptr;
  made->surface->GetPolys()->GetCellAtId(0, count, ids);
  glm::dvec3 a;
  glm::dvec3 b;
  glm::dvec3 c;
  made->surface->GetPoint(ids[0], &a.x);
  made->surface->GetPoint(ids[1], &b.x);
  made->surface->GetPoint(ids[2], &c.x);
  EXPECT_GT(glm::dot(glm::cross(b - a, c - a), a - ball.centre_mm), 0.0);
}

TEST(Polygonise, CanBeCancelled) {
  class Cancelled final : public Progress {
   public:
    void report(const Message&, double) override {}
    [[nodiscard]] bool cancelRequested() const override { return true; }
  } progress;
  EXPECT_EQ(polygonise(Ball(), {}, progress).error().code, ErrorCode::cancelled);
}

TEST(Mannequin, TheShippedBodyIsAnAdultOfOnePieceFacingMinusY) {
  const auto loaded = loadMannequin(std::filesystem::path(EW_SOURCE_DIR) / "resources/mannequin/adult.json");
  ASSERT_TRUE(loaded) << loaded.error();
  EXPECT_NEAR(loaded->bounds.highest_mm.z, 470.0, 20.0);
  EXPECT_NEAR(loaded->bounds.lowest_mm.z, -1280.0, 30.0);
  const auto front = loaded->skin->hit({0.0, -2000.0, 0.0}, {0.0, 1.0, 0.0});
  ASSERT_TRUE(front);
  EXPECT_NEAR(front->point_mm.y, -105.0, 20.0);
  EXPECT_LT(front->outward.y, -0.8);
}

TEST(Polygonise, IsFinerWhereTheBodyIsMoreCurvedAndStaysClosed) {
  /// A ball with a finger.
  class Finger final : public BodyShape {
   public:
    [[nodiscard]] double signedDistance_mm(const glm::dvec3& p) const override {
      const double along = std::clamp(p.x, 0.0, 380.0);
      return std::min(glm::length(p) - 300.0, glm::distance(p, glm::dvec3(along, 0.0, 0.0)) - 9.0);
    }
    [[nodiscard]] Bounds bounds() const override { return {glm::dvec3(-300.0), {390.0, 300.0, 300.0}}; }
  } const body;
  const auto made = polygonise(body, {.cell_mm = 8.0});
  ASSERT_TRUE(made) << made.error();
  vtkNew<vtkFeatureEdges> open;
  open->SetInputData(made->surface);
  open->BoundaryEdgesOn();
  open->NonManifoldEdgesOn();
  open->FeatureEdgesOff();
  open->ManifoldEdgesOff();
  open->Update();
  EXPECT_EQ(open->GetOutput()->GetNumberOfCells(), 0);
  const SkinVertices vertices = skinVerticesOf(*made);
  ASSERT_EQ(vertices.points_mm.size(), static_cast<std::size_t>(made->surface->GetNumberOfPoints()));
  int onFinger = 0;
  for (std::size_t n = 0; n < vertices.points_mm.size(); ++n) {
    EXPECT_LT(std::abs(body.signedDistance_mm(vertices.points_mm[n])), 0.9);
    EXPECT_NEAR(glm::length(vertices.outward[n]), 1.0, 1e-3);
    onFinger += vertices.points_mm[n].x > 310.0F ? 1 : 0;
  }
  const double area_mm2 = 2.0 * 3.1416 * 9.0 * 75.0;
  EXPECT_GT(onFinger, 3.0 * area_mm2 / (8.0 * 8.0)) << "several times as many as cells of the grid";
}

}  // namespace
}  // namespace ew::bridge::mannequin_test
