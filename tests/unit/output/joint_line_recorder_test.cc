// SPDX-License-Identifier: GPL-3.0-or-later
#include "block_scenes.h"

#include <hybrid/output/joint_line_recorder.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

using namespace hybrid;



namespace
{
  /// Two squares of 1 m beside each other, or one upon the other, that share the line joint_a.
  dda::Model pair_of_squares(const bool upright_line)
  {
    scene::SectionMesh mesh =
      upright_line ? hybrid::test::square_blocks(2, 1, 1.) : hybrid::test::square_blocks(1, 2, 1.);
    std::vector<int> shared;
    for (const int node : mesh.blocks[0])
      if (std::count(mesh.blocks[1].begin(), mesh.blocks[1].end(), node) > 0)
        shared.push_back(node);
    mesh.lines["joint_a"] = {{shared.at(0), shared.at(1)}};
    return dda::build_model(mesh,
                            hybrid::test::block_parameters(30.),
                            hybrid::test::straight_foundation(0., -1., 6., 7));
  }

  /// Moves a block by @p way after it has been turned by @p angle about the origin.
  void move(const dda::Model &model,
            dda::DdaState    &state,
            const int         block,
            const Vec2       &way,
            const double      angle)
  {
    const Eigen::Rotation2Dd turn(angle);
    for (int v = model.initial.offset[block]; v < model.initial.offset[block + 1]; ++v)
      state.geometry.vertices[v] = turn * state.geometry.vertices[v] + way;
  }

  /// Moves both by a rotation and the second block, as it lies then, by @p way.
  output::Summary::PlaneSlip
  left_after(const bool upright_line, const Vec2 &way, const double angle)
  {
    const dda::Model          model = pair_of_squares(upright_line);
    output::JointLineRecorder recorder(&model, 1e-3);
    dda::DdaState             state = dda::initial_state(model);
    move(model, state, 1, {0.01, 0.02}, 0.); // at rest
    recorder.set_reference(state);
    move(model, state, 0, Vec2::Zero(), angle);
    move(model, state, 1, Eigen::Rotation2Dd(angle) * way, angle);
    output::Summary summary;
    recorder.summarize(state, summary);
    return summary.joint_lines.at("joint_a");
  }
} // namespace



TEST(JointLineRecorder, upper_side_slips_along_x_and_parts_upwards)
{
  for (const double angle : {0., 0.3})
    {
      const output::Summary::PlaneSlip left = left_after(false, {0.3, 0.1}, angle);
      EXPECT_NEAR(left.largest_left, 0.3, 1e-14);
      EXPECT_NEAR(left.opening_left, 0.1, 1e-14);
      EXPECT_EQ(left.where[1], 1.);
    }
}



TEST(JointLineRecorder, left_side_of_an_upright_line_slips_upwards)
{
  const output::Summary::PlaneSlip left = left_after(true, {0.1, -0.3}, 0.);
  EXPECT_NEAR(left.largest_left, 0.3, 1e-14);
  EXPECT_NEAR(left.opening_left, 0.1, 1e-14);
}



TEST(JointLineRecorder, sides_that_are_pressed_are_not_open)
{
  EXPECT_EQ(left_after(false, {0., -0.01}, 0.).opening_left, 0.);
}



TEST(JointLineRecorder, a_mass_without_lines_has_none)
{
  const dda::Model model = dda::build_model(hybrid::test::square_blocks(2, 1, 1.),
                                            hybrid::test::block_parameters(30.),
                                            hybrid::test::straight_foundation(0., -1., 6., 7));
  output::Summary  summary;
  output::JointLineRecorder(&model, 1e-3).summarize(dda::initial_state(model), summary);
  output::JointLineRecorder(nullptr, 1e-3).summarize({}, summary);
  EXPECT_TRUE(summary.joint_lines.empty());
}
