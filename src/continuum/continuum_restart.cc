// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/continuum_implementation.h>
#include <hybrid/restart/archive.h>

namespace hybrid::continuum
{
  using restart::Archive;

  void serialize(Archive &archive, SlipState &state)
  {
    auto &[jump, path, failed, condition] = state;
    archive(jump, path, failed, condition);
  }



  void serialize(Archive &archive, ContinuumEnergy &energy)
  {
    auto &[kinetic,
           strain,
           boundary_springs,
           input_work,
           surface_work,
           boundary_loss,
           damping_loss,
           bedding_loss,
           bedding_static_stress,
           integration_loss,
           rock_work] = energy;
    archive(kinetic, strain, boundary_springs, input_work, surface_work, boundary_loss);
    archive(damping_loss, bedding_loss, bedding_static_stress, integration_loss, rock_work);
  }



  void serialize(Archive &archive, ContinuumState &state)
  {
    auto &[time,
           last_step,
           displacement,
           velocity,
           acceleration,
           of_contacts,
           change,
           force,
           contact,
           slip,
           column_slip,
           maxwell,
           energy] = state;
    archive(time, last_step, displacement, velocity, acceleration, of_contacts, change, force);
    archive(contact, slip, column_slip, maxwell, energy);
  }



  void BeddingSlip::serialize_rest(Archive &archive)
  {
    archive(rest, rest_failed);
  }



  void Continuum::serialize_rest(Archive &archive)
  {
    archive(impl->static_displacement, impl->factor_time);
    if (impl->slip != nullptr)
      impl->slip->serialize_rest(archive);
  }
} // namespace hybrid::continuum
