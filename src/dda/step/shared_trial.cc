// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/step/shared_trial.h>

#include <algorithm>

namespace hybrid::dda
{
  void SharedTrial::begin(const Model &model, const DdaState &state, const Springs &step_springs)
  {
    group  = model.processes.get();
    shares = group != nullptr && group->count() > 1;
    if (!shares || cut_of == step_springs.list_version())
      return;
    cut_of = step_springs.list_version();
    centres.clear();
    for (const BlockState &block : state.blocks)
      centres.push_back(block.centroid);
    owners.cut(centres, group->count());
    list_blocks(model.n_blocks());
    list_springs(step_springs);
  }



  void SharedTrial::list_blocks(const int n_blocks)
  {
    const int n_processes = group->count();
    first_of.assign(n_processes + 1, 0);
    for (int b = 0; b < n_blocks; ++b)
      ++first_of[owners.of(b) + 1];
    for (int p = 0; p < n_processes; ++p)
      first_of[p + 1] += first_of[p];
    parts = first_of;
    by_owner.resize(n_blocks);
    for (int b = 0; b < n_blocks; ++b)
      by_owner[parts[owners.of(b)]++] = b;
    own_blocks.assign(by_owner.begin() + first_of[group->rank()],
                      by_owner.begin() + first_of[group->rank() + 1]);
  }



  void SharedTrial::list_springs(const Springs &step_springs)
  {
    own_springs.clear();
    others.clear();
    for (std::size_t s = 0; s < step_springs.bodies.size(); ++s)
      {
        const Springs::Bodies &bodies = step_springs.bodies[s];
        const bool             is_own =
          bodies.other == foundation_body || owns(bodies.block) || owns(bodies.other);
        (is_own ? own_springs : others).push_back(static_cast<int>(s));
      }
  }



  void SharedTrial::exchange(Eigen::VectorXd &rows, Eigen::VectorXd *values)
  {
    const std::size_t size = values != nullptr ? 7 : 6, mine = first_of[group->rank()];
    message.resize(size * by_owner.size());
    parts.resize(first_of.size());
    for (std::size_t p = 0; p < parts.size(); ++p)
      parts[p] = size * first_of[p];
    for (std::size_t k = 0; k < own_blocks.size(); ++k)
      {
        double    *place = message.data() + size * (mine + k);
        const Vec6 row   = rows.segment<6>(6 * own_blocks[k]);
        std::copy(row.begin(), row.end(), place);
        if (values != nullptr)
          place[6] = (*values)[own_blocks[k]];
      }
    group->gather(message, parts);
    for (std::size_t k = 0; k < by_owner.size(); ++k)
      {
        if (k >= mine && k < mine + own_blocks.size())
          continue;
        const double *place              = message.data() + size * k;
        rows.segment<6>(6 * by_owner[k]) = Eigen::Map<const Vec6>(place);
        if (values != nullptr)
          (*values)[by_owner[k]] = place[6];
      }
  }
} // namespace hybrid::dda
