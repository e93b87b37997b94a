// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_scenes.h"

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;
  using namespace hybrid::dda::contact_scenes;


  /// The contact of a place of the foundation with an edge, or nullptr.
  const Contact *find_place(const Contacts &contacts, const int node, const int edge)
  {
    for (const Contact &c : contacts)
      if (c.vertex_body == foundation_body && c.vertex == node && c.edge == edge)
        return &c;
    return nullptr;
  }

  TEST(BedrockSurface, EveryPlaceOfTheBaseBelowASoleTouchesIt)
  {
    Geometry g         = blocks({square(0.05, 0.)});
    g.foundation_nodes = {{-1., 0.}, {0., 0.}, {0.2, 0.}, {0.5, 0.}, {0.9, 0.}, {2., 0.}};
    ContactDetection detection(parameters);
    Contacts         contacts;
    detection.update(g, contacts);
    for (const int node : {2, 3, 4})
      EXPECT_NE(find_place(contacts, node, 0), nullptr) << node;
    EXPECT_EQ(contacts.size(), 5u) << "three places and two corners";
  }

  /// A square of the mass on bedrock of two triangles, whose upper sides make one straight surface
  /// from x = -1 to 3 with a place at x = 1.
  Geometry square_on_triangles(const double x, const double y)
  {
    Geometry g =
      blocks({square(x, y), {{-1., 0.}, {0., -1.}, {1., 0.}}, {{1., 0.}, {2., -1.}, {3., 0.}}});
    constexpr int   in = BedrockSurface::inside, none = BedrockSurface::none;
    BedrockSurface &rock = g.bedrock;
    rock.first_block     = 1;
    rock.next            = {1, 2, 3, 0, in, in, none, in, in, 6};
    rock.previous        = {3, 0, 1, 2, none, none, 9, none, none, none};
    return g;
  }

  TEST(BedrockSurface, TrianglesOfTheBedrockAreOneSurface)
  {
    ContactDetection detection(parameters);
    for (const double x : {0.5, 1., 0.999, 1.001, 0.})
      {
        const Geometry g = square_on_triangles(x, -0.001);
        Contacts       contacts;
        detection.update(g, contacts);
        EXPECT_GE(contacts.size(), 2u) << x;
        for (const Contact &c : contacts)
          {
            const bool on_rock = c.vertex_body == 0 && (c.edge == 6 || c.edge == 9);
            const bool on_sole = c.vertex == 6 && c.edge_body == 0 && c.edge == 0;
            EXPECT_TRUE(on_rock || on_sole)
              << "at " << x << " vertex " << c.vertex << " edge " << c.edge;
          }
      }
    const Geometry over_seam = square_on_triangles(0.5, -0.001);
    Contacts       contacts;
    detection.update(over_seam, contacts);
    EXPECT_EQ(contacts.size(), 3u);
    EXPECT_NE(find(contacts, 6, 0, 0), nullptr) << "the place between the triangles";
  }
} // namespace
