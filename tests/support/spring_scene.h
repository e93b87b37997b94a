// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "block_scenes.h"

#include <hybrid/dda/springs/springs.h>

#include <algorithm>

namespace hybrid::test
{
  using namespace dda;

  /// Two squares side by side on a foundation of three segments, bonded to each other or not.
  struct SpringScene
  {
    Model    model;
    DdaState state;
    Springs  springs;
    Trial    trial;

    explicit SpringScene(const bool bonded, const double damping_ratio = 0.)
    {
      scene::SceneParameters p             = block_parameters(85.); // nothing slides
      p.materials["rock"].cohesion         = 1e9;
      p.materials["rock"].tensile_strength = 1e9;
      p.blocks.bonded                      = bonded;
      p.blocks.damping_ratio               = damping_ratio;
      model = build_model(square_blocks(2, 1), p, straight_foundation(0., 0.3, 2.3, 3));
      state = initial_state(model);
      for (int v = 0; v < 8; ++v) // corners 0, 1 of both blocks stand on the foundation
        if (v % 4 < 2)
          {
            const double x = state.geometry.vertices[v].x(), s = (x + 0.3) / 2.6 * 3.;
            const int    segment = std::min(2, static_cast<int>(s));
            state.contacts.push_back(
              {state.geometry.block_of[v], v, foundation_body, segment, s - segment});
          }
      if (!bonded) // a corner of the second block in the side of the first
        {
          state.geometry.vertices[7].y() -= 0.25;
          state.contacts.push_back({1, 7, 0, 1, 0.75});
        }
      springs.collect(model, state);
      trial.dt = 1e-3;
      trial.increment.assign(2, Vec6::Zero());
      trial.rate.assign(2, Vec6::Zero());
      trial.foundation = Eigen::VectorXd::Zero(8);
    }

    void move(const Eigen::VectorXd &d)
    {
      trial.motion.clear();
      trial.displacement.resize(8);
      for (int b = 0; b < 2; ++b)
        {
          trial.increment[b] = d.segment<6>(6 * b);
          trial.motion.emplace_back(state.blocks[b].centroid, trial.increment[b]);
          for (int v = 4 * b; v < 4 * b + 4; ++v)
            trial.displacement[v] = trial.motion[b].displacement(state.geometry.vertices[v]);
        }
      trial.foundation = d.tail(8);
      springs.evaluate(model, state, trial);
    }

    Eigen::VectorXd forces(const Eigen::VectorXd &d)
    {
      move(d);
      Eigen::VectorXd f = Eigen::VectorXd::Zero(20), absolute = Eigen::VectorXd::Zero(2);
      springs.add_forces(f, f, absolute);
      return f;
    }

    double energy(const Eigen::VectorXd &d)
    {
      move(d);
      double sum = 0.;
      for (std::size_t s = 0; s < springs.springs.size(); ++s)
        {
          const SpringState &now = springs.responses[s].now;
          sum += springs.springs[s].length *
                 springs.springs[s].law->stored_energy({now.gap, now.slip}, now.history);
        }
      return sum;
    }
  };



  /// A small displacement that presses the blocks onto the foundation and onto one another.
  inline Eigen::VectorXd pressing(const double size)
  {
    Eigen::VectorXd d(20);
    d << 0.6, -1., 0.2, 0.1, -0.1, 0.2, -0.5, -1.2, -0.1, 0.1, 0.2, -0.1, 0.02, 0.05, -0.03, 0.02,
      0.04, 0.03, 0.01, -0.05;
    return size * d;
  }
} // namespace hybrid::test
