// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace hybrid::continuum
{
  /// Where the numbers of a supernodal Cholesky factor are, as CHOLMOD has it.
  struct SupernodalPattern
  {
    int        n_interior   = 0;       ///< the first unknowns, in order of L
    int        n_surface    = 0;       ///< the others
    int        n_supernodes = 0;       ///< that have a column of the interior
    const int *first_column = nullptr; ///< of each, and the end
    const int *row_begin    = nullptr; ///< of each in row, and the end
    const int *row          = nullptr; ///< ascending, its own columns first
    const int *value_begin  = nullptr; ///< of each, a dense matrix by columns
    const int *permutation  = nullptr; ///< number of each unknown before they were ordered
  };


  /**
   * The order in which substitutions with [L_II; L_GI], a Cholesky factor without its columns of
   * the surface, read its numbers.
   *
   * Columns of a supernode are cut into panels of at most eight. The numbers of a panel stand one
   * after the other as they are read: its triangle by rows with the inverse diagonal, then the
   * rows below by fours. Panels stand in the order of the forward substitution, so both
   * substitutions read the memory from one end to the other.
   *
   * Parts are subtrees of the elimination tree with at most a sixteenth of all numbers; the last
   * one is what is above them. The subtrees are independent of each other, so that threads share
   * them; what they add to the unknowns above is summed in their order. The parts depend on the
   * pattern alone.
   */
  class SubstitutionPlan
  {
  public:
    static constexpr int widest       = 8; ///< columns of a panel
    static constexpr int rows_at_once = 4;

    /// Some columns of a supernode. Places are those in the numbers of its part.
    struct Panel
    {
      int         place;             ///< of the first column
      int         columns;           ///< 1 to widest
      int         n_fours;           ///< rows below, rows_at_once each
      int         row_begin;         ///< of the rows' places in row
      std::size_t begin;             ///< of its numbers
      int         supernode, column; ///< of the factor; column counted from the supernode's first
    };

    /// A list of subtrees, or what is above all of them. Its numbers are those of its own unknowns,
    /// then those outside that it adds to, then one that no one reads.
    struct Part
    {
      int first_panel = 0, last_panel = 0;
      int first_own = 0, last_own = 0;         ///< in own
      int first_outside = 0, last_outside = 0; ///< in outside
      int begin = 0;                           ///< of its numbers among those of all parts

      int n_own() const
      {
        return last_own - first_own;
      }

      int n_outside() const
      {
        return last_outside - first_outside;
      }
    };

    explicit SubstitutionPlan(const SupernodalPattern &pattern);

    /// Part that is above all others, whose unknowns outside are those of the surface.
    const Part &above() const
    {
      return parts.back();
    }

    /// Numbers of a factor in this order. @param values as CHOLMOD has them.
    std::vector<double> pack(const SupernodalPattern &pattern, const double *values) const;

    std::vector<Part>  parts;
    std::vector<Panel> panels;
    std::vector<int>   own;     ///< unknowns of the parts, as numbered before they were ordered
    std::vector<int>   outside; ///< places in the part above; in its own list: of the surface
    std::vector<int>   row;     ///< places of rows
    std::size_t        n_values  = 0; ///< of a factor
    int                n_numbers = 0; ///< of all parts

  private:
    /// Unknowns above, in order of L, that a list of subtrees adds to.
    std::vector<int> beyond(const SupernodalPattern &pattern,
                            const std::vector<int>  &supernodes) const;

    void add_part(const SupernodalPattern &pattern,
                  const std::vector<int>  &supernodes,
                  const std::vector<int>  &unknowns_outside);

    /// @param no_one place of the number that no one reads
    void add_panels(const SupernodalPattern &pattern, int supernode, int no_one);

    std::vector<int> place_above;   ///< of each unknown in order of L, in the part above, or -1
    std::vector<int> place_in_part; ///< likewise, in the part that is added
  };
} // namespace hybrid::continuum
