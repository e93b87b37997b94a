// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/coupling/coupled_state.h>
#include <hybrid/restart/archive.h>

#include <gtest/gtest.h>

namespace hybrid::coupling
{
  namespace
  {
    using restart::Archive;

    TEST(CoupledState, IsStoredWhole)
    {
      CoupledState state;
      state.time    = 1.;
      state.columns = {{14.}, {15., 16.}, {17.}, {17.5}, 17.75, {17.8}, {{}}, {17.9}, {1}};
      state.columns.slip[0].jump   = {17.85};
      state.blocks.time            = 2.;
      auto &rock                   = state.continuum;
      rock.time                    = 3.;
      rock.displacement            = {4.};
      rock.velocity                = {5., 6.};
      rock.acceleration            = {7., 8., 9.};
      rock.surface_force           = {10.};
      rock.surface_contact         = {11.};
      rock.contact_acceleration    = {11.5};
      rock.acceleration_change     = {11.6};
      rock.last_step               = 11.7;
      rock.maxwell                 = {{11.8}, {11.81, 11.82}, {11.83}};
      rock.slip.jump               = {12.};
      rock.slip.path               = {13.};
      rock.slip.failed             = {1, 0};
      rock.slip.condition          = {continuum::PlaneCondition::open};
      constexpr std::size_t n      = sizeof(continuum::ContinuumEnergy) / sizeof(double);
      double *const         values = &rock.energy.kinetic;
      for (std::size_t k = 0; k < n; ++k)
        values[k] = 1. + k;

      Archive writer = Archive::writer();
      writer(state);
      Archive      reader = Archive::reader(writer.content());
      CoupledState copy;
      reader(copy);
      EXPECT_TRUE(reader.at_end());
      EXPECT_EQ(copy.time, 1.);
      EXPECT_EQ(copy.columns.displacement, state.columns.displacement);
      EXPECT_EQ(copy.columns.velocity, state.columns.velocity);
      EXPECT_EQ(copy.columns.acceleration, state.columns.acceleration);
      EXPECT_EQ(copy.columns.change, state.columns.change);
      EXPECT_EQ(copy.columns.last_step, state.columns.last_step);
      EXPECT_EQ(copy.columns.branches, state.columns.branches);
      ASSERT_EQ(copy.columns.slip.size(), 1u);
      EXPECT_EQ(copy.columns.slip[0].jump, state.columns.slip[0].jump);
      EXPECT_EQ(copy.columns.rest, state.columns.rest);
      EXPECT_EQ(copy.columns.rest_failed, state.columns.rest_failed);
      EXPECT_EQ(copy.continuum.maxwell.strain, rock.maxwell.strain);
      EXPECT_EQ(copy.continuum.maxwell.force, rock.maxwell.force);
      EXPECT_EQ(copy.continuum.maxwell.elastic, rock.maxwell.elastic);
      EXPECT_EQ(copy.blocks.time, 2.);
      EXPECT_EQ(copy.continuum.time, 3.);
      EXPECT_EQ(copy.continuum.displacement, rock.displacement);
      EXPECT_EQ(copy.continuum.velocity, rock.velocity);
      EXPECT_EQ(copy.continuum.acceleration, rock.acceleration);
      EXPECT_EQ(copy.continuum.surface_force, rock.surface_force);
      EXPECT_EQ(copy.continuum.surface_contact, rock.surface_contact);
      EXPECT_EQ(copy.continuum.contact_acceleration, rock.contact_acceleration);
      EXPECT_EQ(copy.continuum.acceleration_change, rock.acceleration_change);
      EXPECT_EQ(copy.continuum.last_step, rock.last_step);
      EXPECT_EQ(copy.continuum.slip.jump, rock.slip.jump);
      EXPECT_EQ(copy.continuum.slip.path, rock.slip.path);
      EXPECT_EQ(copy.continuum.slip.failed, rock.slip.failed);
      EXPECT_EQ(copy.continuum.slip.condition, rock.slip.condition);
      const double *const read = &copy.continuum.energy.kinetic;
      for (std::size_t k = 0; k < n; ++k)
        EXPECT_EQ(read[k], 1. + k);
    }


    TEST(CoupledState, HasOneTime)
    {
      CoupledState state;
      state.set_time(4.);
      EXPECT_EQ(state.time, 4.);
      EXPECT_EQ(state.blocks.time, 4.);
      EXPECT_EQ(state.continuum.time, 4.);
    }
  } // namespace
} // namespace hybrid::coupling
