#include "io/mesh/handedness.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "cone_scene.h"
#include "io/mesh/source_units.h"

namespace coapt {
namespace {

/// x, y and z of a valve in LPS: the atrium to the right, behind and above, the aortic root to the right and in front.
Eigen::Matrix3d as_in_a_chest() {
  const Vec3 z = Vec3(-0.6, 0.55, 0.5).normalized();
  const Vec3 x = Vec3(-0.6, -0.6, 0.1).cross(z).normalized();
  Eigen::Matrix3d axes;
  axes << x, z.cross(x), z;
  return axes;
}

ImportDecision judged(SourceAxes stated, const Eigen::Matrix3d& axes) {
  ImportSource source;
  source.axes = stated;
  const Expected<ImportDecision> decision = judged_handedness(source, {axes, Vec3::Zero()});
  return decision ? *decision : ImportDecision{};
}

TEST(Handedness, NamedSidesTellAndMirroredFilesAreRefused) {
  ImportSource source = cone_source_with_gaps();
  source.chordae.clear();
  source.tips.clear();
  for (const double y : {12.0, -12.0}) {
    source.sided.push_back({Side::Anterolateral, Vec3(-10, y, -5)});
    source.sided.push_back({Side::Posteromedial, Vec3(10, y, -5)});
  }
  ImportOptions options;
  options.chordae_seed = 0;
  const Expected<ImportedValve> right = import_with_decisions(source, options);
  ASSERT_TRUE(right) << right.errors()[0].message;
  for (const ImportDecision& decision : right->decisions)
    EXPECT_FALSE(decision.subject == "frame" && decision.look);
  unmirror(source);  // turns what is right, too
  const Expected<ImportedValve> mirrored = import_with_decisions(source, options);
  ASSERT_FALSE(mirrored);
  EXPECT_EQ(mirrored.errors()[0].path, "/mirrored");
  options.mirrored = true;
  const Expected<ImportedValve> again = import_with_decisions(source, options);
  ASSERT_TRUE(again) << again.errors()[0].message;
  EXPECT_TRUE(again->valve.rest_mm.isApprox(right->valve.rest_mm, 1e-9));
}

TEST(Handedness, OneSideAloneTellsNothing) {
  ImportSource source;
  source.sided = {{Side::Anterolateral, Vec3(10, 0, 0)}, {Side::Anterolateral, Vec3(12, 5, 0)}};
  const Expected<ImportDecision> decision =
      judged_handedness(source, {Eigen::Matrix3d::Identity(), Vec3::Zero()});
  ASSERT_TRUE(decision);
  EXPECT_FALSE(decision->look);
  EXPECT_EQ(decision->confidence, 0.5);
}

TEST(Handedness, AValveThatLiesAsHeartsDoIsSoundAndItsMirrorImagesAreNot) {
  const Eigen::Matrix3d axes = as_in_a_chest();
  for (const Vec3& about : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(1, -1, 1)})
    for (const double degrees : {-30.0, 0.0, 30.0}) {
      const Eigen::Matrix3d turn =
          Eigen::AngleAxisd(degrees * M_PI / 180.0, about.normalized()).toRotationMatrix();
      const ImportDecision sound = judged(SourceAxes::Stated, turn * axes);
      EXPECT_FALSE(sound.look) << degrees << ' ' << about.transpose() << sentence(sound);
      EXPECT_GT(sound.confidence, 0.9);
      const Eigen::Matrix3d less =
          Eigen::AngleAxisd(degrees * M_PI / 360.0, about.normalized()).toRotationMatrix();
      for (Index along = 0; along < 3; ++along) {
        // Of mirrored files an import finds front and atrium, which were mirrored, and makes x of them.
        Eigen::Matrix3d mirrored = less * axes;
        mirrored.row(along) *= -1.0;
        mirrored.col(0) = mirrored.col(1).cross(mirrored.col(2)).eval();
        const ImportDecision found = judged(SourceAxes::Stated, mirrored);
        EXPECT_TRUE(found.look) << along << ' ' << degrees << ' ' << about.transpose()
                                << sentence(found);
        EXPECT_FALSE(judged(SourceAxes::Assumed, mirrored).look) << "nobody said that it is LPS";
      }
    }
}

TEST(Handedness, AxesOfVoxelsAloneAndThoseOfAnEchoProbeAreLookedAt) {
  EXPECT_TRUE(judged(SourceAxes::Unknown, as_in_a_chest()).look);
  const Eigen::Matrix3d upright = Eigen::Matrix3d::Identity();  // the atrium is straight above
  const ImportDecision stated = judged(SourceAxes::Stated, upright);
  EXPECT_TRUE(stated.look);
  EXPECT_EQ(stated.confidence, 0.5);
  EXPECT_NE(stated.reason.find("it lies 146 degrees from how a heart usually lies"),
            std::string::npos)
      << stated.reason;
  EXPECT_FALSE(judged(SourceAxes::Assumed, upright).look) << "meshes whose axes nobody states";
}

}  // namespace
}  // namespace coapt
