// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/linear/block_owners.h>
#include <hybrid/dda/linear/process_group.h>
#include <hybrid/dda/model/model.h>
#include <hybrid/dda/model/state.h>
#include <hybrid/dda/springs/springs.h>

#include <vector>

namespace hybrid::dda
{
  /**
   * What this process does in trials that several share: it evaluates the springs of its own blocks
   * (those between two owners both evaluate, those on the foundation all) and sums the forces on
   * its blocks; then all exchange the sums. A sum has the terms and the order that it has in one
   * process, so the bits are the same. Without processes nothing is shared.
   */
  class SharedTrial
  {
  public:
    /// A step begins: share its trials out. The mass is cut anew where the springs connect others
    /// than before; so a block that moves gets another owner.
    void begin(const Model &model, const DdaState &state, const Springs &step_springs);

    /// Let every process do all until the next step.
    void stop()
    {
      shares = false;
    }

    bool is_on() const
    {
      return shares;
    }

    bool owns(const int block) const
    {
      return owners.of(block) == group->rank();
    }

    /// Own blocks, ascending.
    const std::vector<int> &blocks() const
    {
      return own_blocks;
    }

    /// Springs of own blocks, and those on the foundation, ascending.
    const std::vector<int> &springs() const
    {
      return own_springs;
    }

    /// All others.
    const std::vector<int> &other_springs() const
    {
      return others;
    }

    /// Whether it is true in all processes.
    bool all(const bool mine) const
    {
      return group->all(mine);
    }

    /// Get the entries of others' blocks: six per block of @p rows and, if there are, one of
    /// @p values.
    void exchange(Eigen::VectorXd &rows, Eigen::VectorXd *values);

  private:
    const ProcessGroup      *group  = nullptr;
    bool                     shares = false;
    int                      cut_of = -1; ///< Springs::list_version() when the mass was cut
    BlockOwners              owners;
    std::vector<int>         own_blocks, own_springs, others;
    std::vector<int>         by_owner; ///< all blocks: those of the first process, of the second...
    std::vector<std::size_t> first_of; ///< place there where those of each process begin
    std::vector<Vec2>        centres;  ///< work
    std::vector<double>      message;  ///< work
    std::vector<std::size_t> parts;    ///< work: of the message

    void list_blocks(int n_blocks);
    void list_springs(const Springs &step_springs);
  };
} // namespace hybrid::dda
