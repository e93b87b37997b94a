// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/continuum/continuum.h>
#include <hybrid/coupling/coupled_state.h>
#include <hybrid/coupling/foundation.h>
#include <hybrid/dda/model/model.h>
#include <hybrid/scene/parameters/scene_parameters.h>

#include <string>
#include <utility>
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
   * A point belongs to what it lies in: a block (on the outlines of several,
   * the one whose centroid is nearest), the bedrock, or all that is below the
   * surface of a base that moves as prescribed. What lies in nothing, by no
   * more than a thousandth of the section, belongs to what is nearest.
   */
  class Probes
  {
  public:
    /// What the scene does not have is nullptr. All must outlive the probes.
    Probes(const dda::Model           *blocks,
           const continuum::Continuum *bedrock,
           const coupling::Foundation *foundation = nullptr);

    /// Follow the point at the initial position @p x. @return its number. @throws InputError if
    /// it is farther than a thousandth of the section from everything.
    int add(const Vec2 &x, const std::string &name);

    /**
     * Follow the point at @p x in the block or the cell that has an edge through it and lies to the
     * left of @p direction: one side of a plane that runs along this unit vector. Without any,
     * what is to the right of a direction to +x may be a base that moves as prescribed.
     * @return its number; -1 if nothing is there.
     */
    int add_beside(const Vec2 &x, const Vec2 &direction);

    /// Displacements count from the positions in @p state.
    void set_reference(const coupling::CoupledState &state);

    PointMotion sample(const coupling::CoupledState &state, int probe) const;

    /// The block that a probe belongs to; -1: none.
    int block(const int probe) const
    {
      return probes[probe].block;
    }

    /// Where the bedrock is looked at.
    std::vector<continuum::Continuum::Point> points_of_bedrock() const;

    /// Reference positions, for the checkpoint.
    void serialize(restart::Archive &archive);

  private:
    struct Probe
    {
      int    block       = -1;           ///< or -1
      int    vertices[3] = {0, 0, 0};    ///< of the block, spanning it
      double weights[3]  = {0., 0., 0.}; ///< the point is their weighted sum
      Vec2   reference   = Vec2::Zero(); ///< [m]

      continuum::Continuum::Point point; ///< without a block; no cell: on the prescribed base
    };

    const dda::Model           *model;
    const continuum::Continuum *continuum;
    const coupling::Foundation *foundation;
    double                      section = 0.; ///< larger side of all there is [m]
    std::vector<Probe>          probes;

    /// The block that a point lies in or on; -1: none.
    int block_at(const Vec2 &x) const;

    /// Block with an edge through @p x along @p direction, to its left, and the cosine between the
    /// two; -1 if all edges are 25 degrees off or more.
    std::pair<int, double> block_beside(const Vec2 &x, const Vec2 &direction) const;

    /// A block and how far a point is from its outline [m]; infinite without blocks.
    std::pair<int, double> nearest_block(const Vec2 &x) const;

    /// How far a point is above the surface of a prescribed base [m]; infinite without one.
    double height_above_base(const Vec2 &x) const;

    /// For a point that lies in nothing. @throws InputError if it is too far from everything.
    void attach_to_nearest(Probe &probe, const Vec2 &x, const std::string &name) const;

    /// @throws InputError if a point of the rigid base is a thousand sections from its surface: a
    /// slip of the pen.
    void check_distance_from_base(const Vec2 &x, const std::string &name) const;

    void attach(Probe &probe, int block, const Vec2 &x) const;

    Vec2 position(const dda::DdaState &state, const Probe &probe) const;
  };
} // namespace hybrid::output
