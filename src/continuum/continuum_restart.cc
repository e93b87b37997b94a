// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/continuum_implementation.h>
#include <hybrid/restart/archive.h>

#include <cstring>

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
           base_force_change,
           force,
           contact,
           slip,
           column_slip,
           maxwell,
           energy] = state;
    archive(time, last_step, displacement, velocity, acceleration, of_contacts, change, force);
    archive(base_force_change, contact, slip, column_slip, maxwell, energy);
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



  namespace
  {
    /// Of a vector of the state: unknowns of the rock, which ranks share, and of the columns behind
    /// them; so many times. Each rank has and reads those of the nodes that it holds.
    restart::SharedVector
    shared_vector(std::vector<double> &vector, const std::size_t blocks, const Ownership &ownership)
    {
      const std::size_t n = 2 * ownership.n_nodes(), held = 2 * ownership.held().size(),
                        size = vector.size() / blocks, columns = size - held;
      restart::SharedVector result{&vector, blocks, n, columns, {}, {}, {}};
      result.portion = [&vector, &ownership, size](const std::size_t block) {
        std::vector<double> portion;
        ownership.to_portion(vector.data() + block * size, 2, portion); // its own stand first
        return portion;
      };
      result.rest = [&vector, held, size](const std::size_t block) {
        return vector.data() + block * size + held;
      };
      result.take = [&vector, &ownership, n, held, size, columns](const std::size_t block,
                                                                  const char       *numbers) {
        double *const here = vector.data() + block * size;
        ownership.read_held(numbers, here);
        std::memcpy(here + held, numbers + n * sizeof(double), columns * sizeof(double));
      };
      return result;
    }



    /// Of the rock's nodes alone, where contacts act; else there is none, now or in the checkpoint.
    restart::SharedVector contacts_of(std::vector<double> &vector, const Ownership &ownership)
    {
      restart::SharedVector result{&vector, 1, 2 * ownership.n_nodes(), 0, {}, {}, {}};
      result.is_empty = vector.empty();
      result.portion  = [&vector, &ownership](std::size_t) {
        std::vector<double> portion;
        ownership.to_portion(vector.data(), 2, portion); // its own stand first
        return portion;
      };
      result.take = [&vector, &ownership](std::size_t, const char *numbers) {
        vector.resize(2 * ownership.held().size());
        ownership.read_held(numbers, vector.data());
      };
      return result;
    }
  } // namespace



  std::vector<restart::SharedVector> Continuum::shared_vectors(ContinuumState &state) const
  {
    const Ownership                   &ownership = *impl->ownership();
    std::vector<restart::SharedVector> result;
    for (std::vector<double> *vector :
         {&state.displacement, &state.velocity, &state.acceleration, &state.acceleration_change})
      if (!vector->empty())
        result.push_back(shared_vector(*vector, 1, ownership));
    result.push_back(contacts_of(state.contact_acceleration, ownership));
    if (!state.maxwell.strain.empty())
      result.push_back(shared_vector(state.maxwell.strain,
                                     state.maxwell.strain.size() / state.displacement.size(),
                                     ownership));
    return result;
  }



  restart::SharedVector Continuum::shared_rest() const
  {
    const Ownership      &ownership = *impl->ownership();
    std::vector<double>  &own       = impl->static_displacement;
    restart::SharedVector result{&own, 1, 2 * ownership.n_nodes(), 0, {}, {}, {}};
    result.is_empty = !impl->knows_rest();
    result.portion  = [&](std::size_t) {
      std::vector<double> portion;
      ownership.to_portion(own.data(), 2, portion);
      return portion;
    };
    result.take = [&](std::size_t, const char *numbers) { own = ownership.read(numbers); };
    return result;
  }
} // namespace hybrid::continuum
