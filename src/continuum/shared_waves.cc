// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/shared_waves.h>

namespace hybrid::continuum
{
  SharedWaves::SharedWaves(ElementSpace &space, const MPI_Comm communicator)
    : shared(space, communicator)
    , owned(shared.unknowns(), space.nodes.size(), communicator)
  {}



  const dealii::AffineConstraints<double> &SharedWaves::nothing_supported()
  {
    static const dealii::AffineConstraints<double> none = [] {
      dealii::AffineConstraints<double> constraints;
      constraints.close();
      return constraints;
    }();
    return none;
  }



  double SharedWaves::static_memory() const
  {
    constexpr double of_products = 8., of_solver = 8., of_coarse = 4.; // numbers per unknown
    return sizeof(double) * (of_products + of_solver + of_coarse) *
           static_cast<double>(unknowns().size());
  }



  void SharedWaves::add_up(double *values, const int count) const
  {
    MPI_Allreduce(MPI_IN_PLACE, values, count, MPI_DOUBLE, MPI_SUM, shared.communicator());
  }



  std::vector<int> SharedWaves::hold(const std::vector<int> &nodes)
  {
    owned.hold(nodes);
    return owned.held().slots(nodes);
  }



  void SharedWaves::watch(const std::vector<int> &nodes)
  {
    watched          = SharedNodes(nodes, unknowns(), shared.communicator());
    slots_of_watched = hold(nodes);
  }



  void SharedWaves::collect_watched(ContinuumState &state)
  {
    if (is_alone())
      return;
    const auto bring = [&](const double *mine, std::vector<double> &held) {
      watched.gather(mine, collected);
      for (std::size_t k = 0; k < collected.size(); ++k)
        held[2 * slots_of_watched[k / 2] + k % 2] = collected[k];
    };
    const auto [u, v, a] = motion();
    bring(u, state.displacement);
    bring(v, state.velocity);
    bring(a, state.acceleration);
  }
} // namespace hybrid::continuum
