// SPDX-License-Identifier: GPL-3.0-or-later
// What processes that share the fronts give each other.
#include <hybrid/dda/linear/frontal_lu.h>

#include <algorithm>

namespace hybrid::dda
{
  void FrontalLu::list_places()
  {
    of_processes.clear();
    solution_begin.assign(1, 0);
    forces_begin.assign(1, 0);
    for (int process = 0; process < group->count(); ++process)
      {
        for (int f = 0; f < tree.n_fronts(); ++f)
          if (plan.owner(f) == process)
            for (int p = tree.begin[f]; p < tree.begin[f + 1]; ++p)
              of_processes.push_back(p);
        solution_begin.push_back(6 * of_processes.size());
        forces_begin.push_back(forces_begin.back());
        for (std::size_t k = plan.handed_by[process]; k < plan.handed_by[process + 1]; ++k)
          forces_begin.back() += 6 * static_cast<std::size_t>(tree.later(plan.handed_over[k]));
      }
    parcel.reserve(std::max(solution_begin.back(), forces_begin.back()));
  }



  bool FrontalLu::hand_over_fronts(const bool served)
  {
    if (!group->all(served))
      return false;
    for (const int f : plan.handed_over)
      if (is_due[f] != 0)
        {
          const std::size_t u = 6 * static_cast<std::size_t>(tree.later(f));
          group->spread(plan.owner(f), waiting.data() + plan.place[f], u * u);
        }
    return true;
  }



  void FrontalLu::hand_over_forces()
  {
    parcel.resize(forces_begin.back());
    const auto for_each = [this](const int process, const auto &act) {
      std::size_t at = forces_begin[process];
      for (std::size_t k = plan.handed_by[process]; k < plan.handed_by[process + 1]; ++k)
        {
          const int                   f = plan.handed_over[k], u = 6 * tree.later(f);
          Eigen::Map<Eigen::VectorXd> part(parcel.data() + at, u);
          act(part, handed.segment(6 * static_cast<Eigen::Index>(tree.later_begin[f]), u));
          at += u;
        }
    };
    for_each(group->rank(), [](auto &part, const auto &of_front) { part = of_front; });
    group->gather(parcel, forces_begin);
    for (int process = 0; process < group->count(); ++process)
      if (process != group->rank())
        for_each(process, [](const auto &part, auto of_front) { of_front = part; });
  }



  void FrontalLu::gather_solution()
  {
    parcel.resize(solution_begin.back());
    const auto for_each = [this](const int process, const auto &act) {
      for (std::size_t k = solution_begin[process]; k < solution_begin[process + 1]; k += 6)
        {
          Eigen::Map<Vec6> part(parcel.data() + k);
          act(part, ordered.segment<6>(6 * of_processes[k / 6]));
        }
    };
    for_each(group->rank(), [](auto &part, const auto &of_place) { part = of_place; });
    group->gather(parcel, solution_begin);
    for (int process = 0; process < group->count(); ++process)
      if (process != group->rank())
        for_each(process, [](const auto &part, auto of_place) { of_place = part; });
  }
} // namespace hybrid::dda
