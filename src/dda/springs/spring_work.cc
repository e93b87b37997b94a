// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/contact/contact_frame.h>
#include <hybrid/dda/springs/spring_work.h>

#include <algorithm>

namespace hybrid::dda
{
  namespace
  {
    /// A spring's force on Q and where it acts, Q's share on the foundation nodes.
    struct Force
    {
      Vec2   force, place;
      double weight[2] = {1., 0.};
    };



    Vec2 foundation_moved(const SpringStep &step, const int node)
    {
      return (step.trial.foundation - step.before.foundation_displacement).segment<2>(2 * node);
    }



    Force joint_force_at_start(const SpringStep        &step,
                               const Springs::Spring   &spring,
                               const Springs::Traction &traction)
    {
      const Joint    &joint    = step.model.joints[spring.joint];
      const Geometry &geometry = step.before.geometry;
      const auto      place    = [&](const int v) {
        return joint.other == foundation_body ? geometry.foundation_nodes[v] : geometry.vertices[v];
      };
      const Vec2 &a         = geometry.vertices[joint.edge],
                 &b         = geometry.vertices[geometry.next(joint.edge)];
      const double fraction = joint.points[1].position - joint.points[0].position;
      const Vec2   tangent  = (fraction * (b - a) + (place(joint.points[1].other_vertex) -
                                                  place(joint.points[0].other_vertex)))
                             .normalized();
      const Vec2   normal(tangent.y(), -tangent.x());
      const double at = joint.points[spring.end].position;
      return {spring.length * (traction.normal * normal + traction.shear * tangent),
              (1. - at) * a + at * b + 0.5 * spring.old.jump};
    }



    Force contact_force_at_start(const SpringStep        &step,
                                 const Springs::Spring   &spring,
                                 const Springs::Traction &traction)
    {
      const Contact      &contact = step.before.contacts[spring.contact];
      const ContactPlaces start   = places(contact, step.before.geometry);
      const ContactFrame  frame(contact, start);
      const double        sign = contact.vertex_body == foundation_body ? 1. : -1.;
      Force               force{sign * spring.length *
                    (traction.normal * frame.outward + traction.shear * frame.along),
                  start.vertex};
      if (contact.edge_body == foundation_body)
        {
          force.weight[1] = std::min(1., std::max(0., frame.edge_position));
          force.weight[0] = 1. - force.weight[1];
        }
      return force;
    }



    Force force_at_start(const SpringStep        &step,
                         const Springs::Spring   &spring,
                         const Springs::Traction &traction)
    {
      return spring.joint >= 0 ? joint_force_at_start(step, spring, traction)
                               : contact_force_at_start(step, spring, traction);
    }



    /// Of the force, as on the other body.
    double work_on_body_at_start(const SpringStep &step, const int body, const Force &force)
    {
      return BlockMotion(step.before.blocks[body].centroid, Vec6::Zero())
        .gradient(force.place, force.force)
        .dot(step.trial.increment[body]);
    }



    double work_at_start(const SpringStep        &step,
                         const Springs::Spring   &spring,
                         const Springs::Traction &traction)
    {
      if (traction.normal == 0. && traction.shear == 0.)
        return 0.;
      const Force force = force_at_start(step, spring, traction);
      double      work  = -work_on_body_at_start(step, spring.block, force);
      if (spring.other != foundation_body)
        return work + work_on_body_at_start(step, spring.other, force);
      for (int k = 0; k < 2; ++k)
        work += force.weight[k] * force.force.dot(foundation_moved(step, spring.node[k]));
      return work;
    }



    double
    work_at_end(const SpringStep &step, const std::size_t number, const Springs::Traction &traction)
    {
      if (traction.normal == 0. && traction.shear == 0.)
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
  } // namespace



  double rotation_work(const SpringStep        &step,
                       const std::size_t        number,
                       const Springs::Traction &start,
                       const Springs::Traction &end)
  {
    const Springs::Spring &spring = step.springs.springs[number];
    const SpringState     &old = spring.old, &now = step.springs.responses[number].now;
    const double local = spring.length * ((end.normal - start.normal) * (now.gap - old.gap) +
                                          (end.shear - start.shear) * (now.slip - old.slip));
    return work_at_end(step, number, end) - work_at_start(step, spring, start) - local;
  }



  double arc_work(const SpringStep &step, const std::size_t number)
  {
    const Springs::Spring   &spring   = step.springs.springs[number];
    const Springs::Response &response = step.springs.responses[number];
    double                   work     = 0.;
    if (spring.old.normal != 0. || spring.old.shear != 0.)
      {
        const Force force  = force_at_start(step, spring, {spring.old.normal, spring.old.shear});
        const auto  on_arc = [&](const int b) {
          return work_on_body_at_start(step, b, force) -
                 force.force.dot(step.trial.motion[b].displacement(force.place));
        };
        work -= on_arc(spring.block);
        if (spring.other != foundation_body)
          work += on_arc(spring.other);
      }
    if (response.now.normal != 0. || response.now.shear != 0.)
      {
        const auto on_arc = [&](const int b, const Vec6 &force) {
          return force.dot(step.trial.increment[b]) -
                 force.head<2>().dot(step.trial.motion[b].displacement_to(response.place));
        };
        work += on_arc(spring.block, response.force.on_block);
        if (spring.other != foundation_body)
          work += on_arc(spring.other, response.force.on_other);
      }
    return 0.5 * work;
  }
} // namespace hybrid::dda
