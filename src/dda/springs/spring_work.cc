// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/contact/contact_frame.h>
#include <hybrid/dda/springs/spring_work.h>

#include <algorithm>

namespace hybrid::dda
{
  namespace
  {
    Vec2 foundation_moved(const SpringStep &step, const int node)
    {
      return (step.trial.foundation - step.before.foundation_displacement).segment<2>(2 * node);
    }



    /// Where a spring was when the step began: the forces then differ in their tractions alone.
    struct Start
    {
      Vec2   normal, tangent;      ///< unit vectors
      Vec2   place;                ///< where it acts [m]
      double weight[2] = {1., 0.}; ///< Q's share on the foundation nodes
    };



    Start joint_at_start(const SpringStep &step, const Springs::Spring &spring)
    {
      const Joint    &joint    = step.model.joints[spring.joint];
      const Geometry &geometry = step.before.geometry;
      const auto      place    = [&](const int v) {
        return joint.other == foundation_body ? geometry.foundation_nodes[v] : geometry.vertices[v];
      };
      const Vec2 &a         = geometry.vertices[joint.edge],
                 &b         = geometry.vertices[geometry.next(joint.edge)];
      const double fraction = joint.points[1].position - joint.points[0].position;
      const double at       = joint.points[spring.end].position;
      Start        start;
      start.tangent = (fraction * (b - a) +
                       (place(joint.points[1].other_vertex) - place(joint.points[0].other_vertex)))
                        .normalized();
      start.normal = Vec2(start.tangent.y(), -start.tangent.x());
      start.place  = (1. - at) * a + at * b + 0.5 * spring.old.jump;
      return start;
    }



    Start contact_at_start(const SpringStep &step, const Springs::Spring &spring)
    {
      const Contact      &contact     = step.before.contacts[spring.contact];
      const ContactPlaces places_then = places(contact, step.before.geometry);
      const ContactFrame  frame(contact, places_then);
      const double        sign = contact.vertex_body == foundation_body ? 1. : -1.;
      Start               start;
      start.normal  = sign * frame.outward;
      start.tangent = sign * frame.along;
      start.place   = places_then.vertex;
      if (contact.edge_body == foundation_body)
        {
          start.weight[1] = std::min(1., std::max(0., frame.edge_position));
          start.weight[0] = 1. - start.weight[1];
        }
      return start;
    }



    /// Force on Q.
    Vec2 force_of(const Springs::Spring &spring, const Start &start, const Springs::Traction &t)
    {
      return spring.length * (t.normal * start.normal + t.shear * start.tangent);
    }



    bool is_none(const Springs::Traction &traction)
    {
      return traction.normal == 0. && traction.shear == 0.;
    }



    /// Of a place at the start of the step, by the derivative of the motion there: what forces at
    /// the start do their work on [m].
    Vec2 moved_at_start(const SpringStep &step, const int body, const Vec2 &place)
    {
      const Vec6 &d = step.trial.increment[body];
      const Vec2  r = place - step.before.blocks[body].centroid;
      return {d[0] - d[2] * r.y() + d[3] * r.x() + 0.5 * d[5] * r.y(),
              d[1] + d[2] * r.x() + d[4] * r.y() + 0.5 * d[5] * r.x()};
    }



    double work_at_start(const SpringStep      &step,
                         const Springs::Spring &spring,
                         const Start           &start,
                         const Vec2            &force)
    {
      double work = -force.dot(moved_at_start(step, spring.block, start.place));
      if (spring.other != foundation_body)
        return work + force.dot(moved_at_start(step, spring.other, start.place));
      for (int k = 0; k < 2; ++k)
        work += start.weight[k] * force.dot(foundation_moved(step, spring.node[k]));
      return work;
    }



    double
    work_at_end(const SpringStep &step, const std::size_t number, const Springs::Traction &traction)
    {
      if (is_none(traction))
        return 0.;
      const Springs::Spring   &spring   = step.springs.springs[number];
      const Springs::Response &response = step.springs.responses[number];
      const Springs::Forces    force    = step.springs.forces_of(step.trial, number, traction);
      double                   work     = force.on_block.dot(step.trial.increment[spring.block]);
      if (spring.other != foundation_body)
        return work + force.on_other.dot(step.trial.increment[spring.other]);
      for (int k = 0; k < 2; ++k)
        work -=
          response.weight[k] * force.on_block.head<2>().dot(foundation_moved(step, spring.node[k]));
      return work;
    }



    /// Of the forces at the start.
    double
    arc_work_at_start(const SpringStep &step, const Springs::Spring &spring, const Start &start)
    {
      const Vec2 force  = force_of(spring, start, {spring.old.normal, spring.old.shear});
      const auto on_arc = [&](const int b) -> Vec2 {
        return moved_at_start(step, b, start.place) -
               step.trial.motion[b].displacement(start.place);
      };
      Vec2 arc = -on_arc(spring.block);
      if (spring.other != foundation_body)
        arc += on_arc(spring.other);
      return force.dot(arc);
    }



    /// Of the forces at the end.
    double arc_work_at_end(const SpringStep &step, const std::size_t number)
    {
      const Springs::Spring   &spring   = step.springs.springs[number];
      const Springs::Response &response = step.springs.responses[number];
      const auto               on_arc   = [&](const int b, const Vec6 &force) {
        return force.dot(step.trial.increment[b]) -
               force.head<2>().dot(step.trial.motion[b].displacement_to(response.place));
      };
      const Springs::Forces &force = step.springs.forces[number];
      double                 work  = on_arc(spring.block, force.on_block);
      if (spring.other != foundation_body)
        work += on_arc(spring.other, force.on_other);
      return work;
    }
  } // namespace



  TurningWork turning_work(const SpringStep        &step,
                           const std::size_t        number,
                           const Springs::Traction &start,
                           const Springs::Traction &end)
  {
    const Springs::Spring  &spring = step.springs.springs[number];
    const SpringState      &old = spring.old, &now = step.springs.responses[number].now;
    const Springs::Traction then{old.normal, old.shear};
    TurningWork             work;
    work.rotation = work_at_end(step, number, end) -
                    spring.length * ((end.normal - start.normal) * (now.gap - old.gap) +
                                     (end.shear - start.shear) * (now.slip - old.slip));
    if (!is_none(start) || !is_none(then))
      {
        const Start place =
          spring.joint >= 0 ? joint_at_start(step, spring) : contact_at_start(step, spring);
        if (!is_none(start))
          work.rotation -= work_at_start(step, spring, place, force_of(spring, place, start));
        if (!is_none(then))
          work.arc += arc_work_at_start(step, spring, place);
      }
    if (!is_none(step.springs.responses[number].acting()))
      work.arc += arc_work_at_end(step, number);
    work.arc *= 0.5;
    return work;
  }
} // namespace hybrid::dda
