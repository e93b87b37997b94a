// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/parameters/linear_solver.h>
#include <hybrid/scene/parameters/time_integrator.h>

namespace hybrid::scene
{
  void take_explicit(SceneParameters &scene)
  {
    scene.continuum.is_explicit = true;
    scene.time.newmark          = Newmark();
    scene.time.newmark.beta     = 0.;
    scene.time.newmark.gamma    = 0.5;
  }



  std::string why_not_waves_alone(const SceneParameters &scene)
  {
    const bool blocks = scene.has_continuum() && scene.has_blocks();
    return blocks ? "blocks stand on the bedrock (Model/Blocks)" : why_not_iterated(scene);
  }



  std::string why_not_explicit(const SceneParameters &scene)
  {
    const std::string reason = why_not_waves_alone(scene);
    if (reason.empty() && scene.time.scheme != "automatic")
      return "Time/Scheme names an implicit one";
    if (reason.empty() && scene.continuum.linear_solver != LinearSolver::automatic)
      return "Continuum/Linear solver names one of implicit steps";
    return reason;
  }



  void resolve_time_integrator(SceneParameters &scene, const ParameterTable &table)
  {
    if (scene.continuum.integrator != TimeIntegrator::explicit_steps)
      return;
    const std::string reason = why_not_explicit(scene);
    if (!reason.empty())
      throw table.error("Continuum/Time integrator",
                        "explicit is for waves alone, and " + reason +
                          "; allowed here: implicit | automatic");
    take_explicit(scene);
  }
} // namespace hybrid::scene
