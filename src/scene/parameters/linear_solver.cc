// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/parameters/linear_solver.h>
#include <hybrid/scene/parameters/time_integrator.h>

namespace hybrid::scene
{
  namespace
  {
    /// Time of a step by conjugate gradients over that of one with a factor, on one process: 5 to
    /// 14 measured (doc/performance.md).
    constexpr int cost_of_iterations = 14;
  } // namespace



  std::string why_not_iterated(const SceneParameters &scene)
  {
    if (!scene.has_continuum())
      return "the bedrock is not of finite elements (Model/Bedrock)";
    if (!scene.bedding.names.empty() && scene.bedding.slips)
      return "bedding planes may slip (Bedding planes/Strength)";
    return "";
  }



  void check_linear_solver(const SceneParameters &scene, const ParameterTable &table)
  {
    if (scene.continuum.linear_solver != LinearSolver::conjugate_gradients)
      return;
    const std::string reason = why_not_iterated(scene);
    if (!reason.empty())
      throw table.error("Continuum/Linear solver",
                        "conjugate gradients is not allowed, as " + reason +
                          "; allowed here: automatic | factor");
    if (scene.has_blocks() && scene.continuum.surface_form == SurfaceForm::dense)
      throw table.error("Continuum/Surface stiffness",
                        "dense is for a factor; allowed with Continuum/Linear solver = conjugate "
                        "gradients: automatic | banded");
  }



  SceneParameters with_linear_solver(SceneParameters scene, const int processes)
  {
    if (scene.continuum.linear_solver == LinearSolver::automatic &&
        processes > cost_of_iterations && why_not_waves_alone(scene).empty())
      scene.continuum.linear_solver = LinearSolver::conjugate_gradients;
    return scene;
  }
} // namespace hybrid::scene
