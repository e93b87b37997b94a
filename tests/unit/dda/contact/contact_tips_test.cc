// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_scenes.h"

#include <algorithm>
#include <cmath>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;
  using namespace hybrid::dda::contact_scenes;

  /// A wedge of an angle whose tip points right, and a square that slides to the left.
  struct Meeting
  {
    double angle; ///< [rad]
    double above; ///< the square's corner above the wedge's lower edge [m]

    Geometry at(const double passed) const
    {
      Geometry g = blocks({{{0., 0.}, {-1., std::tan(angle)}, {-1., 0.}}, square(-passed, above)});
      g.foundation_nodes = {{-5., 0.}, {5., 0.}};
      return g;
    }
  };

  /// A contact of blocks 0 and 1 holds what is in it.
  bool holds(const Geometry &g, const Contacts &contacts)
  {
    return std::any_of(contacts.begin(), contacts.end(), [&g](const Contact &c) {
      const Edge edge = edge_of(g, c.edge_body, c.edge);
      return std::min(c.vertex_body, c.edge_body) == 0 &&
             std::max(c.vertex_body, c.edge_body) == 1 &&
             edge.n.dot(g.vertices[c.vertex] - edge.a) < -1e-4 * parameters.reach;
    });
  }

  Geometry mirrored(Geometry g)
  {
    for (int b = 0; b < g.n_blocks(); ++b)
      std::reverse(g.vertices.begin() + g.offset[b], g.vertices.begin() + g.offset[b + 1]);
    for (Vec2 &p : g.vertices)
      p.x() *= -1.;
    return g;
  }

  /// The same blocks, on a slab in place of the foundation.
  Geometry on_slab(Geometry g)
  {
    add_block(g, {{-5., -1.}, {5., -1.}, {5., 0.}, {-5., 0.}});
    g.foundation_nodes.clear();
    return g;
  }

  TEST(ContactTips, ACornerBelowATipOnTheGroundDoesNotPassIt)
  {
    // Corner and tip are pressed into the ground, not by the same depth: a corner that lies lower
    // is never in the wedge, and at one height with it round-off decides.
    for (const double degrees : {1., 2., 5., 8., 9.9, 10.1, 12., 30., 60., 89.})
      for (const double above : {-2e-5, -1e-6, -1e-9, 0., 1e-9, 1e-6})
        for (const auto &scene : {+[](Geometry g) { return g; }, mirrored, on_slab})
          {
            const Meeting    meeting{degrees * degree, above};
            ContactDetection detection(parameters);
            Contacts         contacts;
            const double     most = 3e-3 * parameters.reach / std::sin(meeting.angle);
            for (const double part : {-2., -1., 0.3, 1., 2., 3.})
              {
                const Geometry g = scene(meeting.at(part * most));
                detection.update(g, contacts);
                // within the height of a seam the ground bears the corner alone
                EXPECT_TRUE(part < 1. || holds(g, contacts))
                  << degrees << " degrees, " << above << " m above, " << part;
              }
          }
  }

  TEST(ContactTips, TipsOnTheGroundDoNotPassEachOther)
  {
    for (const double mine : {1., 3., 8., 30.})
      for (const double theirs : {1., 3., 8., 60.})
        for (const double above : {-1e-6, 0., 1e-6})
          {
            const auto scene = [&](const double passed) {
              Geometry g         = blocks({{{0., 0.}, {-1., std::tan(mine * degree)}, {-1., 0.}},
                                           {{-passed, above},
                                            {1. - passed, above},
                                            {1. - passed, above + std::tan(theirs * degree)}}});
              g.foundation_nodes = {{-5., 0.}, {5., 0.}};
              return g;
            };
            const double most = 3e-3 * parameters.reach / std::sin(std::min(mine, theirs) * degree);
            ContactDetection detection(parameters);
            Contacts         contacts;
            for (const double part : {-2., -1., 0.3, 1., 2., 3.})
              {
                const Geometry g = scene(part * most);
                detection.update(g, contacts);
                EXPECT_TRUE(part < 1. || holds(g, contacts))
                  << mine << " and " << theirs << " degrees, " << above << " m above, " << part;
              }
          }
  }


  // A square slides on a triangle towards one that touches the row's line with its tip alone, and
  // presses its corner in by what the contact springs give way.
  TEST(ContactTips, ATipBelowARowStopsNothing)
  {
    for (const double height : {0., 0.01})
      {
        Geometry         g = blocks({{{1., 0.}, {0., 0.}, {0.5, -1.}},
                                     {{1., height}, {0.6, -1.}, {1.4, -1.}},
                                     {{2., 0.}, {1., 0.}, {1.5, -1.}},
                                     square(0., -1e-5, 0.9)});
        ContactDetection detection(parameters);
        Contacts         contacts;
        int              n_stops = 0, n_carried = 0;
        for (int k = 0; k < 60; ++k)
          {
            move_block(g, 3, Vec2(0.005, 0.));
            detection.update(g, contacts);
            for (const Contact &c : contacts)
              {
                const bool of_tip =
                  (c.vertex == 3 && c.edge_body == 3) || (c.vertex_body == 3 && c.edge_body == 1);
                n_stops += of_tip && c.edge != 9 ? 1 : 0; // edge 9 is the sole
                n_carried += c.vertex == 10 && (c.edge == 0 || c.edge == 6) ? 1 : 0;
              }
          }
        EXPECT_EQ(n_stops > 0, height > 0.) << height;
        EXPECT_GE(n_carried, height > 0. ? 1 : 58);
      }
  }
} // namespace
