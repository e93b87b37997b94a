// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/contact/contact.h>
#include <hybrid/dda/contact/stillness_cache.h>

#include <gtest/gtest.h>

#include <limits>

#include "contact_scenes.h"

using namespace hybrid::dda;
using namespace hybrid::dda::contact_scenes;

namespace
{
  constexpr double tolerance = 1e-6; // [m]

  constexpr ContactCandidate upper_on_lower{1, 4, 0, -1},
    lower_on_foundation{0, 0, foundation_body, 0}, end_on_foundation{0, 0, foundation_body, 1};



  Geometry two_blocks()
  {
    Geometry g         = blocks({square(0., 0.), square(0., 1.)});
    g.foundation_nodes = {{-1., 0.}, {2., 0.}, {5., 0.}};
    return g;
  }
} // namespace


TEST(StillnessCache, a_body_rests_until_it_is_a_tolerance_away_from_where_it_last_moved)
{
  Geometry       g = two_blocks();
  StillnessCache watch;
  RestState      rest;
  watch.look(g, rest, tolerance);
  EXPECT_TRUE(watch.rests(upper_on_lower));
  for (int step = 0; step < 10; ++step) // a fifth of the tolerance each
    {
      move_block(g, 1, {0.2 * tolerance, 0.});
      watch.look(g, rest, tolerance);
      EXPECT_EQ(watch.rests(upper_on_lower), step != 5) << step;
      EXPECT_TRUE(watch.rests(lower_on_foundation));
    }
}



TEST(StillnessCache, segments_of_the_base_rest_one_by_one)
{
  Geometry       g = two_blocks();
  StillnessCache watch;
  RestState      rest;
  watch.look(g, rest, tolerance);
  g.foundation_nodes[2].y() += 2. * tolerance;
  watch.look(g, rest, tolerance);
  EXPECT_TRUE(watch.rests(lower_on_foundation));
  EXPECT_FALSE(watch.rests(end_on_foundation));
}



TEST(StillnessCache, not_a_number_never_rests)
{
  Geometry       g = two_blocks();
  StillnessCache watch;
  RestState      rest;
  g.vertices[4].x() = std::numeric_limits<double>::quiet_NaN();
  watch.look(g, rest, tolerance);
  EXPECT_FALSE(watch.rests(upper_on_lower));
}
