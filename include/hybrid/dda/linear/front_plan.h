// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/linear/front_tree.h>

#include <cstddef>
#include <vector>

namespace hybrid::dda
{
  /**
   * Which fronts a thread eliminates in a row, and where what they leave waits for their parents.
   *
   * Subtrees of at most a sixteenth of all products are eliminated at once, then the fronts above
   * them in turn. A single thread takes all fronts in turn, each as soon as its children are
   * there: then the least waits, a third of it. The bits depend on the fronts alone.
   *
   * What waits is stacked, that of fronts of even and of odd depth apart: so a front finds what its
   * children left at the end of one stack and leaves its own at the end of the other, and nothing
   * is copied. Or all of it is kept, for fronts above that are eliminated again.
   */
  struct FrontPlan
  {
    /// Fronts first to last - 1, and all below them.
    struct Subtrees
    {
      int first, last;
    };

    FrontPlan() = default;

    /// @param is_shared several threads eliminate
    FrontPlan(const FrontTree &tree, bool is_shared);

    /// Give what each front leaves a place of its own.
    void keep_all(const FrontTree &tree);

    /// Entries that all fronts leave.
    static std::size_t left_by_all(const FrontTree &tree);

    std::vector<Subtrees>    shared;         ///< independent of each other
    std::vector<int>         above;          ///< the other fronts, ascending
    std::vector<int>         child_begin{0}; ///< CSR over fronts
    std::vector<int>         child;
    std::vector<std::size_t> place; ///< of what each front leaves, among all that waits [entries]
    std::size_t              size          = 0; ///< of all that waits [entries]
    int                      largest_own   = 0; ///< own blocks of a front
    std::size_t              largest_panel = 0; ///< own times later blocks of a front

  private:
    void list_children(const FrontTree &tree);

    void find_subtrees(const FrontTree &tree);

    void find_places(const FrontTree &tree);
  };
} // namespace hybrid::dda
