// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/springs/springs.h>
#include <hybrid/restart/archive_forward.h>

#include <vector>

namespace hybrid::dda
{
  /**
   * Tangent stiffness of the springs, kept from one assembly to the next.
   *
   * While some joints of thousands change between sticking and sliding, the
   * others keep their stiffness and, but for the finite rotation of their
   * blocks, its direction: only rows of blocks with a spring that has changed
   * are rebuilt. That the kept directions are not quite those of the
   * trial makes the tangent less exact, not the solution.
   */
  class SpringStiffness
  {
  public:
    /// How update() works.
    struct Choice
    {
      /// Without, falling branches count as flat: less exact, but never indefinite.
      bool follow_softening = true;
      /// Weight of contacts [-].
      double contact_weight = 1.;
      /// Of the shear stiffness of contacts that slide, see SlidingRegularisation [-].
      double sliding_regularisation = 0.;
      /// Every spring is rebuilt, whether it has changed or not.
      bool all = true;
      /// Blocks whose rows are rebuilt with all springs, if not all blocks.
      const std::vector<int> *blocks = nullptr;
    };

    /// Bring the stiffness up to date with a trial that @p springs have evaluated; of springs at
    /// work.
    void update(const Springs &springs, const Trial &trial, const Choice &choice);

    /// Blocks with a spring that has changed in the last update, ascending; if all springs were
    /// rebuilt, Choice::blocks.
    const std::vector<int> &changed_blocks() const
    {
      return changed;
    }

    /// Add the rows of one block. @pre Springs::connect() has found the slots
    void add_rows(const Springs &springs, int block, BlockMatrix &matrix) const;

    /// Add rows and columns of the foundation nodes, and say if the matrix is symmetric.
    void add_foundation(const Springs &springs, BlockMatrix &matrix) const;

    /// What an update of the unknowns adds to gap and slip of one spring, as the stiffness was
    /// assembled [m].
    Vec2 displacement_jump(const Springs         &springs,
                           std::size_t            number,
                           const Eigen::VectorXd &update) const;

    static constexpr std::size_t bytes_per_spring()
    {
      return sizeof(Kept);
    }

    /// What is kept from one step to the next, for the checkpoint.
    void serialize(restart::Archive &archive);

  private:
    using Rows = Eigen::Matrix<double, 2, 6>; ///< along normal and tangent

    /// Stiffness of one spring, times the contact's weight.
    struct Coefficients
    {
      double nn = 0., tt = 0., tn = 0.; ///< normal, shear, shear by gap [N/m]

      bool none() const
      {
        return nn == 0. && tt == 0. && tn == 0.;
      }

      bool operator==(const Coefficients &o) const
      {
        return nn == o.nn && tt == o.tt && tn == o.tn;
      }
    };

    /// One spring as it was assembled.
    struct Kept
    {
      int          block = 0, other = foundation_body, joint = -1, end = 0;
      Coefficients stiffness;
      Rows         of_block = Rows::Zero(), of_other = Rows::Zero(); ///< gradients of displacements

      void serialize(restart::Archive &archive);
    };

    static Coefficients
    coefficients(const Springs::Spring &, const Springs::Response &, const Choice &);

    /// The kept spring is between the same bodies.
    static bool same_bodies(const Kept &, const Springs::Spring &);

    /// The kept spring would be assembled as it was.
    static bool same(const Kept &, const Springs::Spring &, const Springs::Response &);

    /// The kept spring may stay: nothing has changed, or the choice does not ask for it.
    static bool serves(const Kept &, const Springs &, int number, const Choice &);

    /// Rebuild the kept springs in the list renewed.
    void renew(const Springs &springs, const Trial &trial, const Choice &choice);

    /// K = K + sign G^T D H
    static void
    add_product(const Rows &g, const Coefficients &d, const Rows &h, double sign, Mat6 &k);

    void add_foundation_spring(const Springs &springs, int s, BlockMatrix &matrix) const;

    bool is_symmetric() const; ///< of all springs, at work or not

    std::vector<Kept> kept;      ///< of each spring
    std::vector<int>  renewed;   ///< springs, in the last update
    std::vector<int>  changed;   ///< blocks, in the last update
    std::vector<char> is_marked; ///< blocks, work
    std::vector<char> is_new;    ///< springs, work
  };
} // namespace hybrid::dda
