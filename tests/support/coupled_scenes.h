// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupled_section.h"

#include <hybrid/coupling/condensed_foundation.h>
#include <hybrid/coupling/coupled_step.h>
#include <hybrid/dda/model/model_builder.h>
#include <hybrid/dda/step/initial_state.h>
#include <hybrid/output/energy_ledger.h>

#include <cmath>
#include <map>
#include <memory>
#include <vector>

/// Small scenes of blocks on bedrock that several tests share.
namespace hybrid::test
{
  /// Direction of the particle motion of a vertically travelling wave.
  enum class Wave
  {
    shear,
    pressure
  };



  /**
   * The condensed base between walls that make a column a part of an infinite layer: they hold the
   * displacement that a plane wave does not have (vertical for S, horizontal for P) and leave the
   * other free. The rock's sides are held by stiff springs on its surface unknowns; the blocks'
   * sides by joints (add_wall_joints()) to nodes that do not move.
   */
  class WalledFoundation final : public coupling::Foundation
  {
  public:
    WalledFoundation(continuum::Continuum &rock, const Section &layout, const Wave kind)
      : condensed(rock)
      , wave(kind)
      , n_wall(layout.mass_rows + 1)
    {
      const double width = layout.size * layout.columns;
      for (int j = layout.mass_rows; j >= 0; --j)
        nodes.push_back(layout.size * Vec2(-10., j));
      for (const Vec2 &x : rock.surface_nodes())
        {
          if (std::abs(x.x()) < 1e-9 || std::abs(x.x() - width) < 1e-9)
            held.push_back(2 * static_cast<int>(nodes.size()) + (wave == Wave::shear ? 1 : 0));
          nodes.push_back(x);
        }
      for (int j = 0; j <= layout.mass_rows; ++j)
        nodes.push_back(Vec2(width + 10. * layout.size, layout.size * j));
      size = 2 * static_cast<Eigen::Index>(nodes.size());
    }

    const std::vector<Vec2> &surface_nodes() const override
    {
      return nodes;
    }

    const dda::FoundationResponse &predict(const coupling::CoupledState &state,
                                           const double                  dt) override
    {
      const dda::FoundationResponse &inner = condensed.predict(state, dt);
      const Eigen::Index             n = inner.load.size(), o = 2 * n_wall;
      Eigen::MatrixXd               &s = stiffness[dt];
      if (s.size() == 0)
        {
          const double rigid  = 1e6 * inner.stiffness.dense().diagonal().maxCoeff();
          s                   = rigid * Eigen::MatrixXd::Identity(size, size);
          s.block(o, o, n, n) = inner.stiffness.dense();
          for (const int i : held)
            s(i, i) += rigid;
        }
      response.prescribed   = false;
      response.stiffness    = &s;
      response.load         = Eigen::VectorXd::Zero(size);
      response.displacement = Eigen::VectorXd::Zero(size);

      response.load.segment(o, n)         = inner.load;
      response.displacement.segment(o, n) = inner.displacement;
      return response;
    }

    void correct(coupling::CoupledState        &state,
                 const double                   dt,
                 const Eigen::VectorXd         &displacement,
                 const continuum::SurfaceForce &force) override
    {
      const Eigen::Index o = 2 * n_wall, n = size - 2 * o;
      condensed.correct(state,
                        dt,
                        displacement.segment(o, n),
                        {force.all.segment(o, n),
                         force.contacts.segment(o, n),
                         force.ended.segment(o, n)});
    }

    /// Joints of the edges at x = 0 and x = width: stiff where the wall holds, free along it.
    void add_wall_joints(dda::Model &model, const double spring) const
    {
      const dda::Geometry &g     = model.initial;
      const double         width = nodes.back().x() + nodes.front().x();
      const dda::JointLaw  law(dda::JointStrength::unlimited_bond(),
                              (wave == Wave::shear ? 1e-9 : 1.) * spring,
                              (wave == Wave::shear ? 1. : 1e-9) * spring);
      for (int v = 0; v < static_cast<int>(g.vertices.size()); ++v)
        {
          const Vec2 a = g.vertices[v], b = g.vertices[g.next(v)];
          const bool left = a.x() < 1e-9 && b.x() < 1e-9;
          if (!left && (a.x() < width - 1e-9 || b.x() < width - 1e-9))
            continue;
          const double h   = (b - a).norm();
          const int    row = static_cast<int>(std::round(a.y() / h));
          const int first = left ? n_wall - 1 - row : static_cast<int>(nodes.size()) - n_wall + row;
          model.joints.push_back(
            {g.block_of[v], v, dda::foundation_body, h, {{0., first}, {1., first + 1}}, law});
        }
    }

  private:
    coupling::CondensedFoundation     condensed;
    const Wave                        wave;
    const int                         n_wall;
    std::vector<Vec2>                 nodes; ///< left wall downwards, rock, right wall upwards
    std::vector<int>                  held;  ///< unknowns of the rock's sides
    Eigen::Index                      size;
    std::map<double, Eigen::MatrixXd> stiffness;
    dda::FoundationResponse           response;
  };



  /// Blocks on bedrock that step at constant dt; a failed step is taken in two halves.
  class CoupledRun
  {
  public:
    CoupledRun(const Section                &layout,
               const scene::SceneParameters &parameters,
               const scene::Motion          &motion = {})
      : scene(parameters)
      , rock(section_mesh(layout), scene, {motion, scene.motion}, MPI_COMM_WORLD)
      , base(std::make_unique<coupling::CondensedFoundation>(rock))
      , model(dda::build_model(section_mesh(layout), scene, base->surface_nodes()))
    {
      start();
    }

    /// A column between walls (layout.walled).
    CoupledRun(const Section                &layout,
               const scene::SceneParameters &parameters,
               const scene::Motion          &motion,
               const Wave                    wave)
      : scene(parameters)
      , rock(section_mesh(layout), scene, {motion, scene.motion}, MPI_COMM_WORLD)
    {
      auto walled = std::make_unique<WalledFoundation>(rock, layout, wave);
      model       = dda::build_model(section_mesh(layout), scene, walled->surface_nodes());
      walled->add_wall_joints(model,
                              scene.blocks.penalty_ratio *
                                scene.materials.at("mass").young_modulus / layout.size);
      base = std::move(walled);
      start();
    }

    /// One step. @return false if dt / 2^halvings did not converge.
    bool advance(const double dt, const int halvings = 0)
    {
      const dda::StepResult result = step->solve(state, dt);
      iterations += result.iterations;
      if (result.converged)
        {
          ++steps;
          return true;
        }
      ++cuts;
      return halvings > 0 && advance(0.5 * dt, halvings - 1) && advance(0.5 * dt, halvings - 1);
    }

    /// Largest relative energy residual so far, this state included [-].
    double audit()
    {
      state.continuum.energy = rock.audit_energy(state.continuum);
      ledger.update(state);
      return ledger.largest_residual();
    }

    /// Block whose centroid is nearest to a point.
    int block_at(const Vec2 &x) const
    {
      int best = 0;
      for (int b = 1; b < model.n_blocks(); ++b)
        if ((state.blocks.blocks[b].centroid - x).norm() <
            (state.blocks.blocks[best].centroid - x).norm())
          best = b;
      return best;
    }

    scene::SceneParameters                 scene;
    continuum::Continuum                   rock;
    std::unique_ptr<coupling::Foundation>  base;
    dda::Model                             model;
    coupling::CoupledState                 state;
    std::unique_ptr<dda::BlockSolver>      solver;
    std::unique_ptr<coupling::CoupledStep> step;
    output::EnergyLedger                   ledger{true, {false, false, true}};
    int                                    steps = 0, cuts = 0, iterations = 0;

  private:
    void start()
    {
      state.continuum = rock.initial_state();
      state.blocks    = dda::initial_state(model);
      solver          = std::make_unique<dda::BlockSolver>(model);
      step            = std::make_unique<coupling::CoupledStep>(solver.get(), base.get(), &rock);
    }
  };
} // namespace hybrid::test
