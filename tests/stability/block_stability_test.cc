// SPDX-License-Identifier: GPL-3.0-or-later
// Hard cases of blocks on a fixed base: no NaN, no energy created, no block through the base by
// more than 1 % of its size, no ejection.
#include <hybrid/dda/statics/static_stage.h>
#include <hybrid/dda/step/block_energy.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/block_scenes.h"

namespace hybrid::test
{
  namespace
  {
    constexpr double g = 9.81;



    /// Deepest vertex below y = 0 [m], positive.
    double deepest(const dda::DdaState &state)
    {
      double depth = 0.;
      for (const Vec2 &v : state.geometry.vertices)
        depth = std::max(depth, -v.y());
      return depth;
    }



    double fastest(const dda::DdaState &state)
    {
      double speed = 0.;
      for (const dda::BlockState &block : state.blocks)
        speed = std::max(speed, block.velocity.head<2>().norm());
      return speed;
    }



    /// Energy held now [J/m].
    double held(const dda::BlockEnergy &e)
    {
      return e.kinetic + e.strain + e.gravity + e.springs;
    }



    void start_energy(FixedBaseRun &run)
    {
      run.state.energy = dda::stored_energy(run.model, run.state);
    }



    /// Bonded triangles in a square of columns x rows cells, diagonals alternating.
    scene::SectionMesh triangle_blocks(const int columns, const int rows, const double size)
    {
      scene::SectionMesh mesh    = square_blocks(columns, rows, size);
      const auto         squares = mesh.blocks;
      mesh.blocks.clear();
      mesh.block_region.clear();
      for (std::size_t k = 0; k < squares.size(); ++k)
        {
          const auto &s    = squares[k];
          const bool  even = (k % columns + k / columns) % 2 == 0;
          mesh.blocks.push_back(even ? std::vector<int>{s[0], s[1], s[2]}
                                     : std::vector<int>{s[0], s[1], s[3]});
          mesh.blocks.push_back(even ? std::vector<int>{s[0], s[2], s[3]}
                                     : std::vector<int>{s[1], s[2], s[3]});
          mesh.block_region.insert(mesh.block_region.end(), {0, 0});
        }
      return mesh;
    }
  } // namespace



  TEST(BlockStability, block_hits_the_base_at_50_m_per_s)
  {
    for (const char *preset : {"dissipative", "filtered", "shi"})
      for (const double dt : {1e-4, 1e-3})
        {
          scene::SceneParameters scene          = block_parameters(30., 50e9);
          scene.time.newmark                    = Newmark::preset(preset);
          scene.time.maximum_displacement_ratio = 0.01;
          FixedBaseRun run(square_blocks(1, 1), scene, straight_foundation(0., 5., 6.));
          run.state.blocks[0].velocity[1] = -50.;
          start_energy(run);
          const double before = held(run.state.energy);
          ASSERT_TRUE(run.run(0.05, dt)) << preset << " dt " << dt;
          EXPECT_LT(held(run.state.energy), before * 1.01) << preset << " dt " << dt;
          EXPECT_LT(deepest(run.state), 0.01) << preset << " dt " << dt;
          EXPECT_LT(fastest(run.state), 50.5) << preset << " dt " << dt;
          std::printf("50 m/s, %s, dt %g: %d steps, %d cuts, rebound %.2f m/s\n",
                      preset,
                      dt,
                      run.steps,
                      run.cuts,
                      run.state.blocks[0].velocity[1]);
        }
  }



  TEST(BlockStability, column_of_50_blocks_stands)
  {
    FixedBaseRun run(square_blocks(1, 50), block_parameters(30.), straight_foundation(0., 5., 6.));
    const dda::StaticResult settled = dda::settle(run.model, run.state);
    ASSERT_TRUE(settled.equilibrium);
    const auto start = run.state.blocks;
    ASSERT_TRUE(run.run(2., 2e-3));
    for (std::size_t b = 0; b < start.size(); ++b)
      EXPECT_LT((run.state.blocks[b].centroid - start[b].centroid).norm(), 1e-6) << "block " << b;
  }



  TEST(BlockStability, penalty_a_thousand_times_softer_and_stiffer)
  {
    for (const double factor : {1e-3, 1., 1e3})
      {
        scene::SceneParameters scene = block_parameters(30.);
        scene.blocks.penalty_ratio *= factor;
        FixedBaseRun run(square_blocks(2, 2), scene, straight_foundation(0., 5., 7.));
        for (auto &block : run.state.blocks)
          block.velocity[1] = -1.;
        start_energy(run);
        const double before = held(run.state.energy);
        ASSERT_TRUE(run.run(0.3, 1e-3)) << "penalty x " << factor;
        EXPECT_LT(held(run.state.energy), before + 0.01 * std::abs(before))
          << "penalty x " << factor;
        EXPECT_LT(fastest(run.state), 1. + 0.3 * g) << "penalty x " << factor;
      }
  }



  TEST(BlockStability, every_joint_fails_at_once)
  {
    scene::SceneParameters scene = block_parameters(30.);
    scene.blocks.bonded          = true;
    Material &rock               = scene.materials["rock"];
    rock.cohesion                = 1.; // the mass cannot carry itself
    rock.tensile_strength        = 1.;
    scene.blocks.fracture_energy = 0.;
    scene.blocks.softening_slip  = 0.;
    FixedBaseRun run(triangle_blocks(4, 8, 1.), scene, straight_foundation(0., 40., 44.));
    start_energy(run);
    const double before = run.state.energy.balance();
    ASSERT_TRUE(run.run(1., 1e-3));
    int failed = 0;
    for (const dda::JointState &joint : run.state.joints)
      failed += joint.failure != dda::FailureKind::none;
    EXPECT_GT(failed, static_cast<int>(run.state.joints.size()) / 2);
    EXPECT_LT(deepest(run.state), 0.01);
    EXPECT_LT(fastest(run.state), std::sqrt(2. * g * 8.));
    // Nothing may be created; what vanishes when contacts take over from joints is in
    // spring_replacement_loss.
    EXPECT_LT(run.state.energy.balance() - before, 0.01 * 8. * 32. * 2220. * g);
    std::printf("collapse: %d of %zu joints failed, %d steps, %d cuts\n",
                failed,
                run.state.joints.size(),
                run.steps,
                run.cuts);
  }



  TEST(BlockStability, sliver_of_one_degree_lands)
  {
    scene::SectionMesh mesh;
    const double       high = std::tan(M_PI / 180.) * 2.;
    mesh.nodes              = {Vec2(0., 0.05), Vec2(2., 0.05), Vec2(2., 0.05 + high)};
    mesh.blocks             = {{0, 1, 2}};
    mesh.block_region       = {0};
    mesh.block_region_names = {"sliding_mass"};
    FixedBaseRun run(mesh, block_parameters(30.), straight_foundation(0., 5., 7.));
    ASSERT_TRUE(run.run(0.5, 1e-3));
    EXPECT_LT(deepest(run.state), 0.01 * 2.);
    EXPECT_LT(fastest(run.state), 1.1);
  }
} // namespace hybrid::test
