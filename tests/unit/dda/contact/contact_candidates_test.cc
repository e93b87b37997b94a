// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_scenes.h"

#include <random>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;
  using namespace hybrid::dda::contact_scenes;

  /// Ground of sharp valleys and ridges, and polygons of many corners just above it.
  Geometry polygons_on_rough_ground(const unsigned seed)
  {
    std::mt19937                           random(seed);
    std::uniform_real_distribution<double> height(-0.4, 0.4), turn(0., 60. * degree);
    Geometry                               g;
    g.offset.push_back(0);
    constexpr int n = 40;
    for (int i = 0; i < n; ++i)
      {
        Outline      nonagon;
        const double a = turn(random);
        for (int k = 0; k < 9; ++k)
          nonagon.push_back(Vec2(1.2 * i, 0.5 + height(random) * 0.3) +
                            0.5 *
                              Vec2(std::cos(a + 40. * k * degree), std::sin(a + 40. * k * degree)));
        add_block(g, nonagon);
      }
    for (double x = -1.; x < 1.2 * n + 1.; x += 0.5)
      g.foundation_nodes.emplace_back(x, height(random));
    return g;
  }

  /// The blocks creep over the ground; every step builds its list anew, or only the first.
  TEST(ContactCandidates, AnOldListGivesTheContactsOfANewOneInValleys)
  {
    std::size_t most = 0;
    for (unsigned seed = 1; seed <= 10; ++seed)
      {
        Geometry         g = polygons_on_rough_ground(seed);
        ContactDetection old_list({parameters.reach, 10., parameters.smooth_angle});
        Contacts         with_old, with_new;
        for (int step = 0; step < 40; ++step)
          {
            ContactDetection new_list(
              {parameters.reach, parameters.reach, parameters.smooth_angle});
            old_list.update(g, with_old);
            new_list.update(g, with_new);
            expect_equal(with_old, with_new);
            most = std::max(most, with_old.size());
            for (int b = 0; b < g.n_blocks(); ++b)
              move_block(g, b, 0.02 * Vec2(1., std::sin(0.3 * step + b)));
          }
        EXPECT_EQ(old_list.report().builds, 1);
      }
    EXPECT_GT(most, 30u);
  }
} // namespace
