// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/step/bond_memory.h>

#include <cmath>

namespace hybrid::dda
{
  namespace
  {
    /// Cosine and sine of an angle.
    struct Turn
    {
      double cosine, sine;

      Turn(const double c, const double s)
        : cosine(c)
        , sine(s)
      {}

      explicit Turn(const BlockMotion &motion)
        : Turn(motion.cosine, motion.sine)
      {}

      Vec2 operator*(const Vec2 &v) const
      {
        return {cosine * v.x() - sine * v.y(), sine * v.x() + cosine * v.y()};
      }

      /// This turn after the opposite of another one.
      Turn beyond(const Turn &other) const
      {
        return {cosine * other.cosine + sine * other.sine,
                sine * other.cosine - cosine * other.sine};
      }
    };



    /// By the mean of both angles.
    Turn mean_turn(const BlockMotion &a, const BlockMotion &b)
    {
      const double c = a.cosine + b.cosine, s = a.sine + b.sine, size = std::sqrt(c * c + s * s);
      return {c / size, s / size};
    }



    /// Force on the joint's block of what its two ends bear as bonds, over directions [N/m].
    Vec2 bond_force(const Springs &springs,
                    const int      first,
                    const Vec2    &normal,
                    const Vec2    &tangent,
                    const bool     at_start)
    {
      Vec2 sum = Vec2::Zero();
      for (int s = first; s < first + 2; ++s)
        {
          const Springs::Spring  &spring  = springs.springs[s];
          const SpringState      &state   = at_start ? spring.old : springs.responses[s].now;
          const Springs::Traction contact = spring.contact_traction(state);
          sum -= spring.length * ((state.normal - contact.normal) * normal +
                                  (state.shear - contact.shear) * tangent);
        }
      return sum;
    }



    /// Unit vector along a joint.
    Vec2 tangent_of(const Joint &joint, const Geometry &geometry)
    {
      const std::vector<Vec2> &others =
        joint.other == foundation_body ? geometry.foundation_nodes : geometry.vertices;
      const Vec2 &pa = geometry.vertices[joint.edge];
      const Vec2 &pb = geometry.vertices[geometry.next(joint.edge)];
      const Vec2 &q0 = others[joint.points[0].other_vertex];
      const Vec2 &q1 = others[joint.points[1].other_vertex];
      return ((joint.points[1].position - joint.points[0].position) * (pb - pa) + (q1 - q0))
        .normalized();
    }
  } // namespace



  void remember_bond_force(const Model   &model,
                           const Springs &springs,
                           const Trial   &trial,
                           const double   kept,
                           const int      number,
                           DdaState      &state)
  {
    const int              first   = 2 * number;
    const Springs::Spring &spring  = springs.springs[first];
    const Vec2             tangent = tangent_of(model.joints[spring.joint], state.geometry);
    const Vec2 before = bond_force(springs, first, {tangent.y(), -tangent.x()}, tangent, true);
    const Springs::Response &end    = springs.responses[first];
    const Vec2               now    = bond_force(springs, first, end.normal, end.tangent, false);
    Vec2                    &change = state.joints[spring.joint].force_change;
    const Turn               turn   = spring.other == foundation_body
                                        ? Turn(trial.motion[spring.block])
                                        : mean_turn(trial.motion[spring.block], trial.motion[spring.other]);
    change                          = turn * (kept * change + Newmark::memory * (now - before));
  }



  double remembered_base_work(const Model    &model,
                              const Springs  &springs,
                              const Trial    &trial,
                              const DdaState &state)
  {
    double work = 0.;
    for (std::size_t s = 0; s < springs.first_contact(); s += 2)
      {
        const Springs::Spring &spring = springs.springs[s];
        if (spring.other != foundation_body)
          continue;
        Vec2 moved = Vec2::Zero();
        for (const Joint::Point &end : model.joints[spring.joint].points)
          moved +=
            0.5 *
            (trial.foundation - state.foundation_displacement).segment<2>(2 * end.other_vertex);
        work += state.joints[spring.joint].force_change.dot(moved);
      }
    return work;
  }



  Vec2 turned_beyond_bonds(const Springs  &springs,
                           const Trial    &trial,
                           const DdaState &state,
                           const int       block)
  {
    const int  n_joint_springs = static_cast<int>(springs.first_contact());
    const Turn turn(trial.motion[block]);
    Vec2       sum = Vec2::Zero();
    for (const int entry : springs.of_block(block))
      {
        const int s = entry / 2;
        if (s >= n_joint_springs || s % 2 == 1)
          continue;
        const Springs::Spring &spring = springs.springs[s];
        if (spring.other == foundation_body)
          continue;
        const Vec2 &change = state.joints[spring.joint].force_change;
        const Turn  beyond =
          turn.beyond(mean_turn(trial.motion[spring.block], trial.motion[spring.other]));
        const Vec2 added = beyond * change - change;
        sum += block == spring.block ? added : Vec2(-added);
      }
    return sum;
  }
} // namespace hybrid::dda
