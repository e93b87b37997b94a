// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/linear/front_kernels.h>
#include <hybrid/dda/linear/front_plan.h>
#include <hybrid/dda/linear/process_group.h>
#include <hybrid/restart/archive_forward.h>

#include <Eigen/Core>

#include <vector>

namespace hybrid::dda
{
  /**
   * LU factors of the blocks' part of a BlockMatrix by the multifrontal method (Duff and Reid
   * 1983), whether it is symmetric or not.
   *
   * The pattern is symmetric, so order and fronts (FrontTree) are found once for the pairs that are
   * not zero and kept while no other pair becomes so. Fronts are dense: their elimination is
   * products of dense matrices. With the own blocks D of a front, what it has on their right, B,
   * below, C, and among later blocks, E,
   *
   *     C D^-1,   E - (C D^-1) B
   *
   * are what is kept and what goes to the parent; of a symmetric matrix the half below the
   * diagonal. D is inverted, or where it is nearly singular factored: for what is free but for its
   * inertia (DenseDivisor). Rows are exchanged within D only: inertia and elasticity make it
   * regular. Where that does not suffice entries grow, and there are no factors.
   *
   * Where few entries have changed since the last factors, the fronts that hold them and those
   * above these are eliminated again, all others stay: the bits are those of new factors. That
   * takes the memory of what every front hands on, so it begins once it would have served.
   *
   * Threads share subtrees of fronts (FrontPlan), and so do processes, each of which keeps the
   * factors of its own fronts and of those above; the bits are the same for any number of both.
   */
  class FrontalLu
  {
  public:
    /// Share fronts out among @p processes, which all call whatever follows; nullptr: none.
    void set_processes(const ProcessGroup *processes)
    {
      group = processes;
    }

    /// @return false if a block of the diagonal becomes singular or large.
    bool factorize(const BlockMatrix &matrix);

    /// The same in two parts: copy the matrix, which may go then, and factor the copy.
    void load(const BlockMatrix &matrix);
    bool factorize_loaded();

    /// Memory that a factorisation takes for a while, but for what fronts keep.
    void give_back_work();

    /// What an elimination takes.
    struct Cost
    {
      double products = 0.; ///< of 6x6 blocks
      double fronts   = 0.;
    };

    /// Of the last call of factorize().
    const Cost &last_cost() const
    {
      return cost;
    }

    /// x = K^-1 b for the first 6 n_blocks entries.
    void solve(const Eigen::VectorXd &b, Eigen::VectorXd &x);

    /// Order and fronts that were used last.
    const FrontTree &fronts() const
    {
      return tree;
    }

    /// Entries that fronts hand on and that are kept where few change; 0: too many.
    static std::size_t kept_entries(const FrontTree &tree);

    /// The analysis as often as it was made.
    int n_analyses() const
    {
      return analyses;
    }

    /// The next factors are made of all fronts.
    void forget()
    {
      regular = false;
    }

    /// What was factored, and factored again when read, for the checkpoint. @param is_used false:
    /// the pairs alone, on which later orders depend, and the last cost.
    void serialize(restart::Archive &archive, bool is_used);

  private:
    /// Where a pair of blocks goes.
    struct Entry
    {
      int pair;   ///< in pairs
      int first;  ///< position of the one that is eliminated first
      int second; ///< of the other
    };

    /// Where the parts of a front are in memory.
    struct Front
    {
      DenseView own;   ///< D, then its inverse or factors
      DenseView right; ///< B; not of a symmetric matrix
      DenseView below; ///< C, in work space
      DenseView kept;  ///< C D^-1
      DenseView later; ///< E
    };

    /// Work space of a thread.
    struct Work
    {
      std::vector<double> below;
      std::vector<double> largest; ///< entry that each own block may have
      DenseInverse        inverse;
    };

    const ProcessGroup            *group     = nullptr;
    int                            size      = 0; ///< blocks that were analysed
    int                            analyses  = 0;
    bool                           symmetric = false; ///< what was factored last
    std::vector<BlockMatrix::Pair> pairs;             ///< analysed
    FrontTree                      tree;
    FrontPlan                      plan;
    std::vector<int>               entry_begin; ///< CSR over fronts
    std::vector<Entry>             entries;
    // What is factored: the diagonal, and of each pair the rows of the block that is eliminated
    // last; of an unsymmetric matrix those of the other, too.
    std::vector<Mat6>        diagonal, below_diagonal, right_of_diagonal;
    std::vector<char>        is_due;          ///< fronts to be eliminated: entries changed
    bool                     keeps   = false; ///< what all fronts hand on
    bool                     regular = false; ///< there are factors
    Cost                     cost;
    std::vector<std::size_t> factor_begin; ///< of each front in factors
    std::vector<double>      factors; ///< per front D^-1 or the factors of D, C D^-1 and, unless
                                      ///< symmetric, B; by columns
    std::vector<int>         pivots;  ///< of each front's DenseDivisor, at its first place
    std::vector<double>      waiting; ///< E of fronts, see FrontPlan
    std::vector<Work>        work;    ///< of each thread
    std::vector<int>         of_processes;   ///< places, by the process whose fronts they are in
    std::vector<std::size_t> solution_begin; ///< of each process in a parcel
    std::vector<std::size_t> forces_begin;   ///< likewise
    std::vector<double>      parcel;         ///< work: what processes give each other
    Eigen::VectorXd          rest;           ///< work: right-hand side in the order of places
    Eigen::VectorXd          ordered;        ///< work: solution in the order of places
    Eigen::VectorXd          handed;         ///< work: of each front's later blocks

    /// Make sure that the fronts serve: that they are those of all pairs that touch, and not of
    /// many others.
    void bring_order_up_to_date(const BlockMatrix &matrix);

    /// Mark the fronts above those that are due, or all where the others are not kept.
    void choose_fronts();

    Cost cost_of_due() const;

    void analyze(std::vector<BlockMatrix::Pair> pairs_now, int n_blocks);

    /// Lay out the factors.
    void place_factors();

    /// The fronts that are due.
    bool eliminate();

    /// Work space for each thread that there may be.
    void reserve_work();

    /// C D^-1 of a front among the factors; B, if it is there, follows.
    double *kept_of(int f);

    /// Of C D^-1, or of B.
    std::ptrdiff_t entries_of_panel(int f) const;

    Front front_of(int f, Work &of_thread);

    /// Division by the own blocks, from their first entry among the factors on.
    DenseDivisor divisor(int f, const DenseView &own);

    /// Eliminate one front.
    bool eliminate(int f, Work &of_thread);

    /// Entries of the matrix.
    void fill(int f, const Front &front) const;

    /// Add what a child front left.
    void add_child(int child, const Front &front) const;

    bool shares_fronts() const
    {
      return plan.is_of_processes();
    }

    /// List the places of the processes' own fronts.
    void list_places();

    /// What the topmost fronts of each process leave to those of all; @p served: on this process.
    /// @return whether all were served
    bool hand_over_fronts(bool served);

    /// The same of a right-hand side.
    void hand_over_forces();

    /// The solution at the places of each process, to all.
    void gather_solution();

    void solve_forward(int f);

    void solve_backward(int f);
  };
} // namespace hybrid::dda
