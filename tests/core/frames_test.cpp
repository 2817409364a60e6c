#include "ew/core/frames.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <type_traits>

namespace ew::frames_test {
namespace {

using frame::Image;
using frame::Probe;
using frame::World;

// No symmetry at all, so a transposed or reversed product cannot pass.
const std::array<double, 16> kRows{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 0, 0, 0, 1};

TEST(Frames, RowsOfAMatrixSurviveTheRoundTrip) {
  EXPECT_EQ(rowsOf(matrixFromRows(kRows)), kRows);
  EXPECT_EQ(matrixFromRows(kRows)[3], glm::dvec4(4, 8, 12, 1)) << "the translation is the last column";
}

TEST(Frames, AProductAppliesTheRightFactorFirst) {
  const Transform<Probe, Image> imageToProbe{glm::scale(glm::dmat4(1.0), glm::dvec3(0.5))};
  const Transform<World, Probe> probeToWorld{glm::translate(glm::dmat4(1.0), glm::dvec3(10, 20, 30))};
  const Point<World> p_world = (probeToWorld * imageToProbe) * Point<Image>{{2, 4, 6}};
  EXPECT_EQ(p_world.at, glm::dvec3(11, 22, 33));
  EXPECT_EQ((probeToWorld * Direction<Probe>{{1, 2, 3}}).along, glm::dvec3(1, 2, 3)) << "a direction is not translated";
}

template <class Left, class Right>
constexpr bool canMultiply = requires(const Left& left, const Right& right) {
  left* right;
};

// Decision 0001: a product in the wrong order does not compile.
static_assert(canMultiply<Transform<World, Probe>, Transform<Probe, Image>>);
static_assert(!canMultiply<Transform<Probe, Image>, Transform<World, Probe>>);
static_assert(canMultiply<Transform<frame::Moving, World>, Transform<World, frame::Fixed>>);
static_assert(!canMultiply<Transform<World, frame::Fixed>, Transform<frame::Moving, World>>);
static_assert(canMultiply<Transform<frame::Moving, frame::Fixed>, Transform<frame::Fixed, frame::Voxel>>);
static_assert(!canMultiply<Transform<frame::Moving, frame::Fixed>, Transform<frame::Moving, frame::Voxel>>, "the grid of the other volume");
static_assert(!canMultiply<Transform<World, frame::View>, Transform<frame::Moving, frame::Fixed>>,
              "a view is no moving volume unless renamed");
static_assert(!canMultiply<Transform<World, frame::Placed>, Transform<World, frame::View>>, "a place found is not placed once more");
static_assert(!canMultiply<Transform<World, frame::File>, Point<frame::Voxel>>);
// One pose is no other, and a matrix has to be named before it is one.
static_assert(!std::is_convertible_v<Transform<frame::Moving, frame::Fixed>, Transform<frame::Fixed, frame::Moving>>);
static_assert(!std::is_assignable_v<Transform<World, frame::View>&, Transform<World, frame::File>>);
static_assert(!std::is_convertible_v<glm::dmat4, Transform<World, frame::View>>);

TEST(Frames, ATransformRenamedKeepsItsNumbers) {
  const Transform<World, frame::View> viewToWorld{matrixFromRows(kRows)};
  const Transform<World, frame::Fixed> fixedToWorld = renamed<World, frame::Fixed>(viewToWorld);
  EXPECT_EQ(fixedToWorld.matrix, viewToWorld.matrix);
}

RC_GTEST_PROP(Frames, InverseUndoesARigidTransform, ()) {
  const auto number = [] { return static_cast<double>(*rc::gen::inRange(-100000, 100000)) / 1000.0; };
  const glm::dvec3 axis = glm::dvec3(number(), number(), number() + 200.0);
  const Transform<World, Probe> t{
      glm::rotate(glm::translate(glm::dmat4(1.0), glm::dvec3(number(), number(), number())), number(), glm::normalize(axis))};
  const Point<Probe> p{{number(), number(), number()}};
  RC_ASSERT(glm::length((inverse(t) * (t * p)).at - p.at) < 1e-9);
  RC_ASSERT(glm::length((rigidInverse(t) * (t * p)).at - p.at) < 1e-9);
  RC_ASSERT(glm::length(carried(t, p.at) - (t * p).at) == 0.0);
  RC_ASSERT(checkRigid(t).has_value());
}

TEST(CheckRigid, NamesWhatIsWrong) {
  const auto sentence = [](const glm::dmat4& m) {
    const auto checked = checkRigid(m);
    return checked ? std::string("accepted") : checked.error().sentence();
  };
  glm::dmat4 m(1.0);
  EXPECT_EQ(sentence(m), "accepted");
  m[1][1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(sentence(m).find("not finite"), std::string::npos);
  EXPECT_NE(sentence(glm::scale(glm::dmat4(1.0), glm::dvec3(0.0))).find("length 0"), std::string::npos);
  EXPECT_NE(sentence(glm::scale(glm::dmat4(1.0), glm::dvec3(1, 1, -1))).find("mirrored"), std::string::npos);
  m = glm::dmat4(1.0);
  m[1] = glm::dvec4(glm::normalize(glm::dvec3(0.5, 1, 0)), 0.0);
  EXPECT_NE(sentence(m).find("not orthogonal"), std::string::npos);
  m = glm::dmat4(1.0);
  m[0][3] = 0.5;
  EXPECT_NE(sentence(m).find("last row"), std::string::npos);
}

}  // namespace
}  // namespace ew::frames_test
