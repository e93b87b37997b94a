// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <hybrid/scene/input_error.h>
#include <hybrid/scene/parameters/linear_solver.h>
#include <hybrid/scene/parameters/time_integrator.h>

#include "lamb_scene.h"

#include <string>
#include <vector>

namespace
{
  using namespace hybrid;
  using namespace hybrid::scene;

  LinearSolver decided(const std::string &given, const int processes, const bool slips = false)
  {
    SceneParameters scene = test::lamb_scene({"Continuum/Linear solver=" + given}, "implicit");
    if (slips)
      scene.bedding.names = {"bedding_1"};
    scene.bedding.slips = slips;
    return with_linear_solver(scene, processes).continuum.linear_solver;
  }


  TEST(LinearSolver, AutomaticIteratesOnManyProcessesOnly)
  {
    EXPECT_EQ(decided("automatic", 1), LinearSolver::automatic);
    EXPECT_EQ(decided("automatic", 14), LinearSolver::automatic);
    EXPECT_EQ(decided("automatic", 15), LinearSolver::conjugate_gradients);
    EXPECT_EQ(decided("factor", 15), LinearSolver::factor);
    EXPECT_EQ(decided("conjugate gradients", 1), LinearSolver::conjugate_gradients);
    EXPECT_EQ(decided("automatic", 15, true), LinearSolver::automatic);
  }


  TEST(LinearSolver, NamesImplicitSteps)
  {
    for (const char *solver : {"factor", "conjugate gradients"})
      {
        const std::vector<std::string> named = {std::string("Continuum/Linear solver=") + solver};
        EXPECT_THROW(test::lamb_scene(named, "explicit"), InputError);
        EXPECT_NE(why_not_explicit(test::lamb_scene(named, "automatic")), "");
      }
    EXPECT_EQ(why_not_explicit(test::lamb_scene({}, "automatic")), "");
    EXPECT_TRUE(
      test::lamb_scene({"Continuum/Linear solver=automatic"}, "explicit").continuum.is_explicit);
  }


  TEST(LinearSolver, ConjugateGradientsAreRefusedWithTheReason)
  {
    const std::pair<std::string, std::string> wrong[] = {
      {"Model/Bedrock=rigid", "not of finite elements"},
      {"Bedding planes/Names=bedding_1", "may slip"}};
    for (const auto &[override, reason] : wrong)
      try
        {
          test::lamb_scene({override,
                            "Bedding planes/Strength=Mohr-Coulomb",
                            "Continuum/Linear solver=conjugate gradients"},
                           "implicit");
          ADD_FAILURE() << override;
        }
      catch (const InputError &error)
        {
          EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
          EXPECT_NE(std::string(error.what()).find("Linear solver"), std::string::npos);
        }
  }


  SceneParameters scene_with_blocks(const std::vector<std::string> &overrides)
  {
    return read_scene(HYBRID_SOURCE_DIR "/parameters/verification/coupled_column.prm", overrides);
  }


  TEST(LinearSolver, ConjugateGradientsBelowBlocksAreTakenByName)
  {
    const SceneParameters named =
      scene_with_blocks({"Continuum/Linear solver=conjugate gradients"});
    EXPECT_EQ(named.continuum.linear_solver, LinearSolver::conjugate_gradients);
    EXPECT_EQ(why_not_iterated(named), "");
    EXPECT_NE(why_not_waves_alone(named), "");
    EXPECT_EQ(with_linear_solver(scene_with_blocks({}), 15).continuum.linear_solver,
              LinearSolver::automatic);
  }


  TEST(LinearSolver, AllEntriesOfTheSurfaceNeedAFactor)
  {
    for (const char *form : {"automatic", "banded"})
      EXPECT_NO_THROW(scene_with_blocks({"Continuum/Linear solver=conjugate gradients",
                                         std::string("Continuum/Surface stiffness=") + form}));
    try
      {
        scene_with_blocks(
          {"Continuum/Linear solver=conjugate gradients", "Continuum/Surface stiffness=dense"});
        ADD_FAILURE() << "dense";
      }
    catch (const InputError &error)
      {
        EXPECT_NE(std::string(error.what()).find("Surface stiffness"), std::string::npos);
        EXPECT_NE(std::string(error.what()).find("banded"), std::string::npos);
      }
  }
} // namespace
