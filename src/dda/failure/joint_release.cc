// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/contact/contact_frame.h>
#include <hybrid/dda/failure/joint_release.h>

#include <algorithm>
#include <vector>

namespace hybrid::dda
{
  namespace
  {
    using BodyPair = std::pair<int, int>; ///< the lower number first; foundation_body is the lowest

    /// @param a, b bodies; all blocks of the bedrock are one.
    BodyPair in_order(const Model &model, const int a, const int b)
    {
      const auto body = [&](const int c) { return std::min(c, model.n_mass()); };
      return std::minmax(body(a), body(b));
    }


    /// Bodies of a released joint, how far its springs overlapped, and by how much more than the
    /// bodies do [m], and with which force one of them pressed [N/m].
    struct Overlap
    {
      BodyPair bodies;
      double   depth, standoff, force;
    };

    bool operator<(const Overlap &a, const Overlap &b)
    {
      return a.bodies < b.bodies;
    }


    std::vector<Overlap> take_released(const Model &model, DdaState &state)
    {
      std::vector<Overlap> overlaps;
      for (std::size_t j = 0; j < model.joints.size(); ++j)
        {
          JointState &joint = state.joints[j];
          if (!joint.released || joint.handed_over)
            continue;
          joint.handed_over     = true;
          const auto  &points   = joint.points;
          const double closed   = -std::min(points[0].gap, points[1].gap);
          const double traction = std::max(points[0].normal, points[1].normal);
          overlaps.push_back({in_order(model, model.joints[j].block, model.joints[j].other),
                              std::max(closed, 0.),
                              std::max({0., -joint.drawn_gap[0], -joint.drawn_gap[1]}),
                              0.5 * model.joints[j].length * std::max(traction, 0.)});
        }
      std::sort(overlaps.begin(), overlaps.end());
      return overlaps;
    }


    double gap(const Contact &contact, const Geometry &geometry)
    {
      return ContactFrame(contact, places(contact, geometry)).gap;
    }
  } // namespace



  void hand_over_released_joints(const Model &model, DdaState &state)
  {
    const std::vector<Overlap> overlaps = take_released(model, state);
    if (overlaps.empty())
      return;
    for (Contact &contact : state.contacts)
      {
        const Overlap of_pair{in_order(model, contact.vertex_body, contact.edge_body), 0., 0., 0.};
        const auto    found = std::equal_range(overlaps.begin(), overlaps.end(), of_pair);
        for (auto joint = found.first; joint != found.second; ++joint)
          {
            const ContactLaw &law   = model.contacts.law(model.initial, contact, model.n_mass());
            const double      depth = joint->force / (law.length * law.law.normal_stiffness());
            contact.stress_free_gap =
              std::max(contact.stress_free_gap,
                       std::min(joint->standoff,
                                gap(contact, state.geometry) + std::min(joint->depth, depth)));
          }
      }
  }
} // namespace hybrid::dda
