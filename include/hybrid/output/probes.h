// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/continuum/continuum.h>
#include <hybrid/coupling/coupled_state.h>
#include <hybrid/dda/model.h>
#include <hybrid/scene/scene_parameters.h>

#include <string>
#include <vector>

namespace hybrid::output
{
  /// What a material point does: displacement since the static state [m], velocity, acceleration.
  struct PointMotion
  {
    Vec2 displacement = Vec2::Zero();
    Vec2 velocity     = Vec2::Zero();
    Vec2 acceleration = Vec2::Zero();
  };


  /**
   * Material points of blocks, bedrock or rigid base that are followed through a run.
   *
   * A point belongs to the block that contains it, else to the bedrock, else
   * (on the outline, by rounding) to the nearest block; with a rigid base all
   * points outside the blocks move with it.
   */
  class Probes
  {
  public:
    /// Both may be nullptr (the scene has no such part). They must outlive the probes.
    Probes(const dda::Model *blocks, continuum::Continuum *bedrock);

    /// Follow the point at the initial position @p x. @return its number. @throws InputError if
    /// nothing is there.
    int add(const Vec2 &x, const std::string &name);

    /// Displacements count from the positions in @p state.
    void set_reference(const coupling::CoupledState &state);

    PointMotion sample(const coupling::CoupledState &state, int probe) const;

    /// Reference positions, for the checkpoint.
    void serialize(restart::Archive &archive);

  private:
    struct Probe
    {
      int    block       = -1;           ///< or -1
      int    point       = -1;           ///< of the continuum, or -1
      int    vertices[3] = {0, 0, 0};    ///< of the block, spanning it
      double weights[3]  = {0., 0., 0.}; ///< the point is their weighted sum
      Vec2   reference   = Vec2::Zero(); ///< [m]
    };

    const dda::Model     *model;
    continuum::Continuum *continuum;
    std::vector<Probe>    probes;

    int block_at(const Vec2 &x) const;

    int nearest_block(const Vec2 &x) const;

    /// How far a point is above the surface of the base [m]; infinite without one.
    double height_above_base(const Vec2 &x) const;

    void attach(Probe &probe, int block, const Vec2 &x) const;

    Vec2 position(const dda::DdaState &state, const Probe &probe) const;
  };
} // namespace hybrid::output
