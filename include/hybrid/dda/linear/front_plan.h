// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/linear/front_owners.h>

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
   * Of several processes each eliminates its own fronts, and then all of them those above
   * (FrontOwners); what the topmost of its own fronts leave goes to the others.
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

    /// Of some fronts, for the work space of a thread that eliminates them.
    struct Largest
    {
      int         own   = 0; ///< blocks
      std::size_t panel = 0; ///< own times later blocks

      void take(const FrontTree &tree, int f);
    };

    FrontPlan() = default;

    /// @param is_shared several threads eliminate @param of_processes which process eliminates
    /// what; this one is number @p rank
    FrontPlan(const FrontTree   &tree,
              bool               is_shared,
              const FrontOwners &of_processes = {},
              int                rank         = 0);

    /// Several processes eliminate fronts.
    bool is_of_processes() const
    {
      return !owners.of.empty();
    }

    /// Which process eliminates a front, of several.
    int owner(const int f) const
    {
      return owners.of[f];
    }

    /// This process eliminates the front.
    bool is_mine(const int f) const
    {
      return !is_of_processes() || owners.of[f] == me || owners.of[f] == FrontOwners::all;
    }

    /// Give what each front leaves a place of its own.
    void keep_all(const FrontTree &tree);

    /// Entries that all fronts leave.
    static std::size_t left_by_all(const FrontTree &tree);

    std::vector<Subtrees>    shared;         ///< of this process, independent of each other
    std::vector<int>         above;          ///< its other fronts, ascending
    std::vector<int>         of_all;         ///< fronts that all processes eliminate, ascending
    std::vector<int>         handed_over;    ///< topmost fronts of each process, by process
    std::vector<std::size_t> handed_by;      ///< CSR over processes of handed_over
    std::vector<int>         child_begin{0}; ///< CSR over fronts
    std::vector<int>         child;
    std::vector<std::size_t> place; ///< of what each front leaves, among all that waits [entries]
    std::size_t              size = 0;       ///< of all that waits [entries]
    Largest                  largest;        ///< of this process' fronts and those of all
    Largest                  largest_shared; ///< of those that threads share

  private:
    FrontOwners owners;
    int         me = 0; ///< number of this process

    bool is_of_all(const int f) const
    {
      return is_of_processes() && owners.of[f] == FrontOwners::all;
    }

    void list_handed_over(const FrontTree &tree);

    void list_children(const FrontTree &tree);

    void find_subtrees(const FrontTree &tree);

    void find_places(const FrontTree &tree);
  };
} // namespace hybrid::dda
