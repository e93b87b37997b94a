// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/model/model.h>
#include <hybrid/dda/model/state.h>

#include <vector>

namespace hybrid::dda
{
  /**
   * Bodies that lose their hold while the static stage looks for an equilibrium: blocks that
   * neither joints nor closed contacts connect with the ground, directly or through others. They
   * would fall until they lie somewhere else, or for ever.
   */
  class LostHold
  {
  public:
    /**
     * Look at the blocks after a static step. @return whether one that was held in a step before
     * has fallen by half its size since. What was drawn in the air was never held.
     */
    bool falls(const Model &model, const DdaState &state);

    /// Once one falls: the state in which the first of those in the air had just lost its hold.
    const DdaState &loss() const
    {
      return first_loss;
    }

  private:
    std::vector<Vec2> place; ///< of each block's centroid when it was last held [m]
    std::vector<char> was_held;
    bool              flew = false; ///< one that was held was in the air when last looked at
    DdaState          first_loss;
    std::vector<int>  leader; ///< towards the number of the body that a block belongs to, work

    /// Joins the blocks that hold each other; the ground comes last.
    void join_bodies(const Model &model, const DdaState &state);
    int  root(int block);
    void join(int a, int b);
  };
} // namespace hybrid::dda
