// SPDX-License-Identifier: GPL-3.0-or-later
#include "bedrock_section.h"

#include <hybrid/dda/springs/bedrock_forces.h>
#include <hybrid/dda/step/initial_state.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;
  using namespace hybrid::test;

  /// Squares on artificial boundaries that move, under a wave, with forces that they bore at rest.
  struct Rock
  {
    Model    model = build_model(layered_section(4, {2, 2}), bedrock_parameters("cells"), {});
    DdaState state = initial_state(model);
    Trial    trial;
    Eigen::VectorXd incoming;

    Rock()
    {
      const int n = model.n_blocks();
      trial.dt    = 2e-3;
      for (int b = 0; b < n; ++b)
        {
          trial.increment.emplace_back(Vec6::Constant(1e-5 * (b + 1)));
          trial.rate.emplace_back(Vec6::Constant(1e-2 * (b + 1)));
          trial.motion.emplace_back(state.blocks[b].centroid, trial.increment[b]);
        }
      for (int b = 0; b < n; ++b)
        for (int v = state.geometry.offset[b]; v < state.geometry.offset[b + 1]; ++v)
          trial.displacement.push_back(trial.motion[b].displacement(state.geometry.vertices[v]));
      incoming = Eigen::VectorXd::LinSpaced(
        2 * BoundaryEdge::n_points * static_cast<Eigen::Index>(model.boundary.size()), 1e3, 2e3);
      state.bedrock_static_force = Eigen::VectorXd::LinSpaced(6 * n, 5e3, 6e3);
    }

    BedrockStep step() const
    {
      return {model, state, trial, incoming};
    }

    std::vector<int> all() const
    {
      std::vector<int> blocks(model.n_blocks());
      std::iota(blocks.begin(), blocks.end(), 0);
      return blocks;
    }

    /// Forces on blocks and their sizes, one below the other.
    Eigen::VectorXd forces(const std::vector<int> &blocks) const
    {
      const int       n = model.n_blocks();
      Eigen::VectorXd residual(Eigen::VectorXd::Zero(6 * n)), absolute(Eigen::VectorXd::Zero(n));
      add_bedrock_forces(step(), blocks, residual, absolute);
      Eigen::VectorXd both(7 * n);
      both << residual, absolute;
      return both;
    }
  };
} // namespace



TEST(BedrockForces, blocks_that_are_asked_for_get_theirs_and_others_none)
{
  const Rock             rock;
  const int              n    = rock.model.n_blocks();
  const Eigen::VectorXd  all  = rock.forces(rock.all());
  const std::vector<int> part = {1, 4, 7, 8, 15};
  const Eigen::VectorXd  few  = rock.forces(part);
  EXPECT_GT(rock.model.boundary.size(), 8u);
  for (int b = 0; b < n; ++b)
    {
      const bool is_asked_for = std::find(part.begin(), part.end(), b) != part.end();
      EXPECT_NE(all.segment<6>(6 * b).norm(), 0.) << b;
      EXPECT_EQ(few.segment<6>(6 * b), is_asked_for ? Vec6(all.segment<6>(6 * b)) : Vec6::Zero());
      EXPECT_EQ(few[6 * n + b], is_asked_for ? all[6 * n + b] : 0.) << b;
    }
}



TEST(BedrockForces, dashpots_are_added_to_the_rows_that_are_asked_for)
{
  const Rock  rock;
  const int   n = rock.model.n_blocks();
  BlockMatrix all, few;
  for (BlockMatrix *matrix : {&all, &few})
    {
      matrix->set_pattern(n, 0, {}, {});
      matrix->set_zero();
    }
  add_bedrock_stiffness(rock.step(), rock.all(), all);
  add_bedrock_stiffness(rock.step(), {0, 3, 5}, few);
  EXPECT_GT(all.diagonal[0].norm(), 0.); // at a corner
  for (int b = 0; b < n; ++b)
    EXPECT_EQ(few.diagonal[b], b == 0 || b == 3 || b == 5 ? all.diagonal[b] : Mat6(Mat6::Zero()))
      << b;
}
