// SPDX-License-Identifier: GPL-3.0-or-later
// The wave that is in the rock at t = 0.
#include <gtest/gtest.h>

#include <hybrid/continuum/continuum.h>
#include <hybrid/scene/input_error.h>

#include "rectangle_mesh.h"

#include <cmath>

namespace
{
  using namespace hybrid;
  using namespace hybrid::continuum;

  /// Rock of 800 m x 800 m with a packet of 50 m wave length in its middle.
  struct Scene
  {
    scene::SectionMesh mesh =
      test::rectangle_mesh(test::equal_spacing(0., 800., 32), test::equal_spacing(0., 800., 32));
    scene::SceneParameters parameters = test::rock_scene();

    explicit Scene(const scene::WaveType type)
    {
      parameters.continuum.degree       = 4;
      parameters.time.newmark           = Newmark::preset("trapezoidal");
      parameters.initial_wave.type      = type;
      parameters.initial_wave.direction = -60.;
      parameters.initial_wave.centre    = Vec2(400., 400.);
      parameters.initial_wave.width     = 1.5;
      const Material &rock              = parameters.materials.begin()->second;
      parameters.initial_wave.frequency =
        (type == scene::WaveType::pressure ? rock.p_wave_speed() : rock.s_wave_speed()) / 50.;
    }

    Continuum rock() const
    {
      return {mesh, parameters, {}, MPI_COMM_WORLD};
    }
  };


  /// Middle of the energy of motion [m].
  Vec2 middle(const Continuum &rock, const ContinuumState &state)
  {
    const auto picture = rock.picture(state);
    Vec2       sum     = Vec2::Zero();
    double     all     = 0.;
    for (std::size_t c = 0; c < picture.cells.size(); ++c)
      for (const int n : picture.cells[c])
        {
          const auto  &cell     = picture.cells[c];
          const Vec2   diagonal = picture.points[cell[2]] - picture.points[cell[0]];
          const double part     = picture.velocity[n].squaredNorm() * diagonal.x() * diagonal.y();
          sum += part * picture.points[n];
          all += part;
        }
    return sum / all;
  }
} // namespace



TEST(ContinuumStart, nothing_without_a_wave)
{
  Scene     scene(scene::WaveType::none);
  Continuum rock  = scene.rock();
  auto      state = rock.initial_state();
  rock.start_wave(state);
  for (const auto *x : {&state.displacement, &state.velocity, &state.acceleration})
    for (const double value : *x)
      ASSERT_EQ(value, 0.);
  EXPECT_EQ(rock.wave_at_boundary().fraction, 0.);
}



TEST(ContinuumStart, packet_travels_at_its_speed_and_keeps_its_energy)
{
  for (const auto type : {scene::WaveType::pressure, scene::WaveType::shear})
    {
      Scene     scene(type);
      Continuum rock  = scene.rock();
      auto      state = rock.initial_state();
      rock.start_wave(state);
      const Material &material = scene.parameters.materials.begin()->second;
      const double    c =
        type == scene::WaveType::pressure ? material.p_wave_speed() : material.s_wave_speed();
      const double dt    = 1. / (40. * scene.parameters.initial_wave.frequency);
      state.energy       = rock.audit_energy(state);
      const double start = state.energy.kinetic + state.energy.strain;
      // The velocity counts the wave number along the way only, the strain all of it.
      const double across = 0.5 * std::pow(2. * M_PI * 1.5, -2);
      EXPECT_NEAR(state.energy.kinetic / state.energy.strain, 1. - across, 3e-4);
      const Vec2 from = middle(rock, state);
      EXPECT_LT((from - Vec2(400., 400.)).norm(), 0.1);
      while (c * state.time < 100. - 1e-6)
        ASSERT_TRUE(rock.step(state, dt));
      const Vec2 moved = middle(rock, state) - from;
      // A beam of width b spreads: its waves' mean speed along the way is c (1 - 1 / (2 k b)^2).
      const double expected = c * state.time * (1. - std::pow(4. * M_PI * 1.5, -2));
      EXPECT_NEAR(moved.norm(), expected, 0.01 * expected);
      EXPECT_NEAR(std::atan2(moved.y(), moved.x()), -M_PI / 3., 0.002);
      state.energy = rock.audit_energy(state);
      EXPECT_NEAR(state.energy.kinetic + state.energy.strain, start, 1e-8 * start);
    }
}



TEST(ContinuumStart, audit_closes_from_the_first_step)
{
  for (const char *scheme : {"trapezoidal", "filtered", "dissipative", "fourth order"})
    {
      Scene scene(scene::WaveType::shear);
      scene.parameters.time.newmark = Newmark::preset(scheme);
      if (std::string(scheme) == "fourth order")
        scene.parameters.time.newmark.corrected_step = 1e-3;
      scene.parameters.continuum.rayleigh_mass      = 0.2;
      scene.parameters.continuum.rayleigh_stiffness = 1e-4;
      Continuum rock                                = scene.rock();
      auto      state                               = rock.initial_state();
      rock.start_wave(state);
      const auto balance = [&]() {
        state.energy             = rock.audit_energy(state);
        const ContinuumEnergy &e = state.energy;
        return e.kinetic + e.strain + e.boundary_loss + e.damping_loss + e.integration_loss -
               e.input_work;
      };
      const double start = balance();
      ASSERT_TRUE(rock.step(state, 1e-3));
      EXPECT_NEAR(balance(), start, 1e-11 * start) << scheme;
    }
}



TEST(ContinuumStart, says_where_the_wave_is_cut_off)
{
  Scene scene(scene::WaveType::shear);
  EXPECT_LT(scene.rock().wave_at_boundary().fraction, 0.01);
  scene.parameters.initial_wave.centre = Vec2(400., 75.);
  const auto reach                     = scene.rock().wave_at_boundary();
  EXPECT_GT(reach.fraction, 0.3);
  EXPECT_LT(reach.fraction, 1.);
  EXPECT_EQ(reach.where.y(), 0.);

  // A plane front meets the sides, which is no mistake.
  scene.parameters.initial_wave.centre    = Vec2(400., 400.);
  scene.parameters.initial_wave.direction = -90.;
  scene.parameters.initial_wave.width     = 0.;
  EXPECT_LT(scene.rock().wave_at_boundary().fraction, 0.01);
}



TEST(ContinuumStart, wave_at_the_contact_surface_is_refused)
{
  Scene scene(scene::WaveType::shear);
  scene.parameters.blocks.enabled = true;
  test::add_block(scene.mesh);
  EXPECT_NO_THROW(scene.rock());
  scene.parameters.initial_wave.centre = Vec2(400., 700.);
  EXPECT_THROW(scene.rock(), InputError);
  scene.parameters.initial_wave.centre = Vec2(400., 900.); // outside
  EXPECT_THROW(scene.rock(), InputError);
}
