// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/block/block.h>
#include <hybrid/dda/block/boundary_edge.h>
#include <hybrid/dda/block/edge_loads.h>
#include <hybrid/dda/block/maxwell_blocks.h>
#include <hybrid/dda/block/moving_blocks.h>
#include <hybrid/dda/block/water.h>
#include <hybrid/dda/contact/contact.h>
#include <hybrid/dda/geometry/geometry.h>
#include <hybrid/dda/joint/joint_law.h>
#include <hybrid/dda/linear/process_group.h>
#include <hybrid/dda/model/downhill.h>
#include <hybrid/dda/model/joint_line.h>
#include <hybrid/dda/model/soles.h>
#include <hybrid/scene/newmark.h>

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace hybrid::dda
{
  /// What a joint bonds.
  enum class JointKind
  {
    body,   ///< blocks of the sliding mass
    belt,   ///< sliding mass and what it stands on
    weld,   ///< blocks of the bedrock, or one and the foundation: never fails
    bedding ///< likewise, along a bedding plane
  };


  /**
   * An artificial joint: bonds an edge of a block to an edge of another block
   * or to a segment of the foundation, with springs at both ends.
   *
   * The outward normal of @p block at the joint is positive; gap and slip are
   * those of the other side relative to @p block.
   */
  struct Joint
  {
    /// One end: a material point on each side.
    struct Point
    {
      double position;     ///< on the block's edge, 0..1 from @p edge to the next vertex [-]
      int    other_vertex; ///< vertex of the other block, or foundation node
    };

    int      block;                ///< block whose outward normal counts
    int      edge;                 ///< first vertex of its edge (Geometry::vertices)
    int      other;                ///< other block, or foundation_body
    double   length;               ///< of the bonded edge or segment [m]
    Point    points[2];            ///< along the block's edge
    JointLaw law;                  ///< per area
    double   strength_factor = 1.; ///< on the material's cohesion and tensile strength [-]

    JointKind kind = JointKind::body;

    int plane = -1; ///< bedding plane: number among the scene's names

    /// Sine of the angle by which another edge rises where the joint slides to, with positive and
    /// with negative slip [-]: see joint_valleys.h
    std::array<double, 2> valley{{0., 0.}};

    /// Both sides are bedrock: the joint carries the load however far they slide.
    bool within_bedrock() const
    {
      return kind == JointKind::weld || kind == JointKind::bedding;
    }

    /// The other body's edge (of a belt: the ground's): its first end, seen from that body.
    int other_edge() const
    {
      return points[other == foundation_body ? 0 : 1].other_vertex;
    }

    /// A belt that keeps cohesion when it has slid.
    bool bears_residual_cohesion() const
    {
      return kind == JointKind::belt && law.has_residual_cohesion();
    }
  };


  /// Law and size of an unbonded vertex contact.
  struct ContactLaw
  {
    JointLaw law;    ///< per area
    double   length; ///< that a vertex stands for [m]
  };


  /**
   * Laws of contacts. What a block touches is a surface with a number: the mass's own materials,
   * those of its joints, the bedrock's, the belts. See set_contact_laws().
   */
  struct ContactLaws
  {
    std::vector<std::vector<ContactLaw>> of;      ///< [surface][block]
    std::vector<int>                     segment; ///< of each segment of the foundation
    std::vector<int> edge; ///< per vertex: of the block's edge that begins there

    std::vector<std::pair<int, int>>
      bonded; ///< blocks of the mass that a joint bonded, the lower first; sorted

    /// Law of a contact; its vertex is @p vertex_body's, its edge @p edge_body's.
    const ContactLaw &law(const Geometry &initial, const Contact &contact, int n_mass) const;

    /// True if a joint bonded the two blocks of the mass.
    bool were_bonded(int block, int other) const;
  };


  /// How the open-close iteration works.
  struct IterationParameters
  {
    int    maximum_iterations         = 80;
    double tolerance                  = 1e-8; ///< residual over the sum of absolute forces [-]
    double maximum_displacement_ratio = 0.05; ///< displacement per step over block size [-]
    bool   regularises_sliding =
      false; ///< sliding contacts keep a share of stiffness, see SlidingRegularisation
    bool changes_together = true; ///< contacts, before the line search, see OpenCloseIteration
    bool few_settle_alone = true; ///< bodies that hold most of the residual, see OpenCloseIteration
    bool stops_at_rest    = true; ///< blocks stop where they are in balance, see OpenCloseIteration
    bool sleeps           = true; ///< steps that change nothing are not computed, see Sleep
    bool is_patient       = false; ///< full steps go on while the residual does not fall, see there
  };


  /// Everything about the blocks that does not change: the problem.
  struct Model
  {
    std::vector<BlockProperties>  blocks;
    Geometry                      initial; ///< outlines and foundation before the first step
    std::vector<Joint>            joints;
    std::vector<JointLine>        joint_lines; ///< of the mass, by name
    ContactLaws                   contacts;
    std::vector<std::vector<int>> neighbours; ///< per block of the mass, see held_neighbours()
    std::vector<bool>             bonded;     ///< per block: has at least one joint
    std::vector<Sole>             soles;      ///< of the mass, on what it lies on
    Downhill                      downhill;   ///< of the blocks of the mass
    std::vector<int>              slice;      ///< per block: for sweeps by several threads
    Newmark                       newmark;
    double                        gravity    = 9.81; ///< [m/s2]
    double                        horizontal = 0.;   ///< pseudo-static acceleration along +x [m/s2]
    double                        dynamic_coefficient = 1.; ///< k01 [-]
    double                        coefficient_step    = 1.; ///< that it is for [s]
    double                        joint_damping_time  = 0.; ///< beta_K of the joints' springs [s]
    bool                          damps_loose         = false; ///< blocks have a loose_damping_time
    bool                          blocks_yield        = false; ///< blocks have a limited strength
    MaxwellBlocks                 maxwell;
    Water                         water;
    std::vector<Vec6>             dead_loads; ///< per block of the mass [N/m, N]; or empty
    EdgeLoads                     edge_loads;
    std::vector<MovingBlocks>     moving_blocks; ///< at t = 0; the others are at rest
    IterationParameters           iteration;
    /// What a step of this size leaves of velocities, as the given steps do in the same time [-].
    double velocity_kept_in(const double dt) const
    {
      return dynamic_coefficient == 1. ? 1. : std::pow(dynamic_coefficient, dt / coefficient_step);
    }

    std::shared_ptr<const ProcessGroup> processes; ///< that compute the scene; null: this one alone

    int    n_bedrock            = 0;     ///< the last blocks are the bedrock
    bool   hold_bedrock         = false; ///< the bedrock does not move (static stage)
    double bedrock_damping_time = 0.;    ///< beta_K of the springs within the bedrock [s]
    std::vector<BoundaryEdge> boundary;  ///< artificial boundaries of the bedrock

    int n_blocks() const
    {
      return static_cast<int>(blocks.size());
    }

    /// Blocks of the sliding mass: the first ones.
    int n_mass() const
    {
      return n_blocks() - n_bedrock;
    }

    bool is_bedrock(const int block) const
    {
      return block >= n_mass();
    }

    /// Number of a block within the bedrock.
    int bedrock_number(const int block) const
    {
      return block - n_mass();
    }

    int n_foundation_nodes() const
    {
      return static_cast<int>(initial.foundation_nodes.size());
    }
  };
} // namespace hybrid::dda
