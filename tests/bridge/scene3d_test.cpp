#include "ew/bridge/scene3d.h"

#include <gtest/gtest.h>
#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkAnnotatedCubeActor.h>
#include <vtkCamera.h>
#include <vtkDataArray.h>
#include <vtkMapper.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPropCollection.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>

#include <map>
#include <string>

#include "bridge/meshes.h"

namespace ew::bridge::scene3d_test {
namespace {

/// A scene in a window that is never drawn: nothing here needs a display.
class Scene : public ::testing::Test {
 protected:
  Scene() { window_->SetSize(800, 600); }

  [[nodiscard]] vtkRenderer* cornerWithCube(vtkAnnotatedCubeActor** cube) const {
    auto* renderers = window_->GetRenderers();
    renderers->InitTraversal();
    while (vtkRenderer* each = renderers->GetNextItem()) {
      auto* props = each->GetViewProps();
      props->InitTraversal();
      while (vtkProp* prop = props->GetNextProp())
        if ((*cube = vtkAnnotatedCubeActor::SafeDownCast(prop)) != nullptr) return each;
    }
    return nullptr;
  }
  /// What the cube's side that faces the viewer says.
  [[nodiscard]] std::string facing() {
    static_cast<void>(scene_.rayAt({1.0, 1.0}));  // brings the cameras up to date, as drawing does
    vtkAnnotatedCubeActor* cube = nullptr;
    vtkRenderer* corner = cornerWithCube(&cube);
    if (corner == nullptr) return "no cube";
    glm::dvec3 away;
    corner->GetActiveCamera()->GetDirectionOfProjection(&away.x);
    const std::map<std::string, glm::dvec3> sides{{cube->GetXPlusFaceText(), {1, 0, 0}}, {cube->GetXMinusFaceText(), {-1, 0, 0}},
                                                  {cube->GetYPlusFaceText(), {0, 1, 0}}, {cube->GetYMinusFaceText(), {0, -1, 0}},
                                                  {cube->GetZPlusFaceText(), {0, 0, 1}}, {cube->GetZMinusFaceText(), {0, 0, -1}}};
    std::string best = "none";
    double most = 0.0;
    for (const auto& [letter, outward] : sides) {
      if (-glm::dot(outward, away) <= most) continue;
      most = -glm::dot(outward, away);
      best = letter;
    }
    return best;
  }

  vtkNew<vtkRenderWindow> window_;
  Scene3D scene_{*window_};
};

TEST_F(Scene, NamesTheSideThatIsLookedAtFromEverywhere) {
  const std::map<CameraPreset, std::string> sides{{CameraPreset::front, "A"}, {CameraPreset::back, "P"}, {CameraPreset::right, "R"},
                                                  {CameraPreset::left, "L"},  {CameraPreset::top, "H"},  {CameraPreset::overview, "A"}};
  for (const auto& [preset, letter] : sides) {
    scene_.showFrom(preset);
    EXPECT_EQ(facing(), letter);
  }
  scene_.showFrom(CameraPreset::front);
  scene_.orbit(0.0, -1.4);
  EXPECT_EQ(facing(), "F") << "from below";
}

TEST_F(Scene, HasItsCubeInTheCornerWhateverTheWindowsSize) {
  for (const auto& [width, height] : {std::pair{800, 600}, {320, 240}, {2400, 300}, {40, 40}}) {
    window_->SetSize(width, height);
    static_cast<void>(scene_.rayAt({1.0, 1.0}));
    vtkAnnotatedCubeActor* cube = nullptr;
    double* place = cornerWithCube(&cube)->GetViewport();
    EXPECT_GE(place[0], 0.0);
    EXPECT_LT(place[0], place[2]);
    EXPECT_LE(place[2], 1.0);
    EXPECT_LT(place[1], place[3]);
    EXPECT_LE(place[3], 1.0);
    EXPECT_GE((place[2] - place[0]) * width, std::min(34, width - 8)) << "letters can be read";
  }
}

TEST_F(Scene, TintsTheSkinWhereThereAreDataAndLeavesTheMannequinAsItWas) {
  auto ball = std::make_shared<Mannequin>();
  ball->surface = test::sphereMesh(800.0, 16);
  ball->bounds = {glm::dvec3(-800.0), glm::dvec3(800.0)};
  const auto count = static_cast<std::size_t>(ball->surface->GetNumberOfPoints());
  const auto body = [&]() -> vtkActor* {
    auto* actors = window_->GetRenderers()->GetFirstRenderer()->GetActors();
    actors->InitTraversal();
    return actors->GetNextActor();
  };
  scene_.setMannequin(ball);
  EXPECT_FALSE(body()->GetMapper()->GetScalarVisibility());
  std::vector<float> shares(count, 0.0F);
  shares[5] = 1.0F;
  scene_.setCoverage(shares);
  ASSERT_TRUE(body()->GetMapper()->GetScalarVisibility());
  auto* tints = body()->GetMapper()->GetInputAsDataSet()->GetPointData()->GetScalars();
  ASSERT_EQ(tints->GetNumberOfTuples(), static_cast<vtkIdType>(count));
  const SceneColours colours;
  for (int channel = 0; channel < 3; ++channel) {
    EXPECT_NEAR(tints->GetComponent(5, channel), 255.0 * colours.covered[channel], 0.6);
    EXPECT_NEAR(tints->GetComponent(6, channel), 255.0 * colours.skin[channel], 0.6);
  }
  EXPECT_EQ(ball->surface->GetPointData()->GetScalars(), nullptr) << "it is shared with others";
  scene_.setColours(lightColours());
  tints = body()->GetMapper()->GetInputAsDataSet()->GetPointData()->GetScalars();
  EXPECT_NEAR(tints->GetComponent(5, 0), 255.0 * lightColours().covered.r, 0.6);
  scene_.setMannequin(ball);
  EXPECT_FALSE(body()->GetMapper()->GetScalarVisibility()) << "of another body nothing is known yet";
}

}  // namespace
}  // namespace ew::bridge::scene3d_test
