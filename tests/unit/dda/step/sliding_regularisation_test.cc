// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/step/sliding_regularisation.h>

#include <gtest/gtest.h>

using hybrid::dda::SlidingRegularisation;



TEST(SlidingRegularisation, grows_while_updates_are_cut_short_and_fades_while_they_are_whole)
{
  SlidingRegularisation share;
  EXPECT_EQ(share.value(), 0.);
  share.adapt(1.);
  EXPECT_EQ(share.value(), 0.);
  double before = share.value();
  for (int k = 0; k < 10; ++k)
    {
      share.adapt(0.01);
      EXPECT_GE(share.value(), before);
      before = share.value();
    }
  EXPECT_EQ(share.value(), 1.); // the whole shear stiffness, not more
  share.adapt(0.5);
  EXPECT_EQ(share.value(), 1.);
  for (int k = 0; k < 10; ++k)
    share.adapt(0.9);
  EXPECT_EQ(share.value(), 0.);
}
