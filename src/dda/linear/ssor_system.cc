// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/linear/block_inverse.h>
#include <hybrid/dda/linear/shared_loop.h>
#include <hybrid/dda/linear/ssor_system.h>

#include <algorithm>
#include <array>
#include <numeric>

namespace hybrid::dda
{
  void SsorSystem::set_slices(const std::vector<int> &slice_of_block)
  {
    if (slice_of_block == slice)
      return;
    slice   = slice_of_block;
    version = -1;
  }



  void SsorSystem::set(const BlockMatrix        &block_matrix,
                       const InterfaceStiffness &foundation_band,
                       const std::vector<int>   &blocks)
  {
    const bool same = matrix == &block_matrix && version == block_matrix.pattern_version();
    matrix          = &block_matrix;
    foundation      = &foundation_band;
    if (!same)
      order_rows();
    const int n = same ? static_cast<int>(blocks.size()) : matrix->n_blocks();
#pragma omp parallel for schedule(static) if (is_worth_sharing(n))
    for (int k = 0; k < n; ++k)
      set_row(same ? blocks[k] : order.block[k]);
    foundation->diagonal(weight.tail(2 * matrix->n_nodes()));
  }



  void SsorSystem::release()
  {
    SsorSystem none;
    std::swap(none.slice, slice);
    *this = std::move(none);
  }



  void SsorSystem::set_row(const int block)
  {
    const int p                  = order.place[block];
    inverse_diagonal[p]          = block_inverse(matrix->diagonal[block]);
    weight.segment<6>(6 * block) = matrix->diagonal[block].diagonal();
    const auto copy              = [&](const int first, const int last) {
      int end = first;
      for (int k = first; k < last; ++k)
        {
          const Mat6 &from = slot[k] >= 0 ? matrix->off_diagonal[slot[k]] : matrix->lower[~slot[k]];
          if (from.isZero(0.))
            continue;
          column[end]  = neighbour[k];
          entry[end++] = from;
        }
      return end;
    };
    below_end[p] = copy(row_begin[p], row_middle[p]);
    above_end[p] = copy(row_middle[p], row_begin[p + 1]);
  }



  void SsorSystem::order_rows()
  {
    const int  n     = matrix->n_blocks();
    const bool known = static_cast<int>(slice.size()) == n;
    order            = SweepOrder(n, known ? slice : std::vector<int>(), matrix->pairs);

    row_begin.assign(n + 1, 0);
    for (const auto &pair : matrix->pairs)
      for (const int block : pair)
        ++row_begin[order.place[block] + 1];
    std::partial_sum(row_begin.begin(), row_begin.end(), row_begin.begin());
    std::vector<int>                next(row_begin.begin(), row_begin.end() - 1);
    std::vector<std::array<int, 2>> entries(2 * matrix->pairs.size()); // place of the column, slot
    for (std::size_t s = 0; s < matrix->pairs.size(); ++s)
      {
        const int i = order.place[matrix->pairs[s][0]], j = order.place[matrix->pairs[s][1]];
        entries[next[i]++] = {j, static_cast<int>(s)};
        entries[next[j]++] = {i, ~static_cast<int>(s)};
      }
    row_middle.assign(row_begin.begin(), row_begin.end() - 1);
    neighbour.resize(entries.size());
    slot.resize(entries.size());
    for (int p = 0; p < n; ++p)
      {
        std::sort(entries.begin() + row_begin[p], entries.begin() + row_begin[p + 1]);
        for (int k = row_begin[p]; k < row_begin[p + 1]; ++k)
          {
            row_middle[p] += entries[k][0] < p ? 1 : 0;
            neighbour[k] = order.block[entries[k][0]];
            slot[k]      = entries[k][1];
          }
      }
    below_end.resize(n);
    above_end.resize(n);
    column.resize(entries.size());
    entry.resize(entries.size());
    inverse_diagonal.resize(n);
    above.resize(6 * n);
    place.resize(matrix->size());
    weight.resize(matrix->size());
    version = matrix->pattern_version();
  }



  double SsorSystem::n_entries() const
  {
    double sum = 0.;
    for (std::size_t p = 0; p < below_end.size(); ++p)
      sum += 1. + (below_end[p] - row_begin[p]) + (above_end[p] - row_middle[p]);
    return sum;
  }



  Vec6 SsorSystem::product(const int first, const int last, const Eigen::VectorXd &x) const
  {
    Vec6 sum = Vec6::Zero();
    for (int k = first; k < last; ++k)
      sum.noalias() += entry[k] * Eigen::Map<const Vec6>(x.data() + 6 * column[k]);
    return sum;
  }



  void SsorSystem::sweep_backward(const Eigen::VectorXd &hat, Eigen::VectorXd &x)
  {
    x.tail(2 * matrix->n_nodes()) = hat.tail(2 * matrix->n_nodes());
    const auto sweep              = [&](const int part) {
      for (int p = order.begin[part + 1] - 1; p >= order.begin[part]; --p)
        {
          const int  i   = order.block[p];
          const Vec6 sum = product(row_middle[p], above_end[p], x) + matrix->row_of_nodes(i, x);
          Eigen::Map<Vec6>(above.data() + 6 * i) = sum;
          Eigen::Map<Vec6>(x.data() + 6 * i) =
            Eigen::Map<const Vec6>(hat.data() + 6 * i) - inverse_diagonal[p] * sum;
        }
    };
    sweep(order.n_parts());
#pragma omp parallel for schedule(static) if (is_worth_sharing(matrix->n_blocks()))
    for (int part = 0; part < order.n_parts(); ++part)
      sweep(part);
  }



  void SsorSystem::sweep_forward(const Eigen::VectorXd &b, Eigen::VectorXd &result)
  {
    const auto sweep = [&](const int part) {
      for (int p = order.begin[part]; p < order.begin[part + 1]; ++p)
        {
          const int  i = order.block[p];
          const Vec6 rest =
            Eigen::Map<const Vec6>(b.data() + 6 * i) - product(row_begin[p], below_end[p], result);
          Eigen::Map<Vec6>(result.data() + 6 * i).noalias() = inverse_diagonal[p] * rest;
        }
    };
#pragma omp parallel for schedule(static) if (is_worth_sharing(matrix->n_blocks()))
    for (int part = 0; part < order.n_parts(); ++part)
      sweep(part);
    sweep(order.n_parts());
    result.tail(2 * matrix->n_nodes()) = b.tail(2 * matrix->n_nodes());
    matrix->add_blocks_to_nodes(result, result, -1.);
    foundation->solve(result.data() + 6 * matrix->n_blocks());
  }



  void SsorSystem::multiply(const Eigen::VectorXd &x, Eigen::VectorXd &y)
  {
    // A = (D + L) + (D + U) + (D_A - 2 D): with t = (D + U)^-1 D x the product is
    // t + (D + L)^-1 (U t + (D_A - D) t), and D_A differs from D at the nodes only.
    const int n = matrix->n_blocks(), m = 2 * matrix->n_nodes();
    sweep_backward(x, place);
    y.head(6 * n) = above;
    matrix->multiply_nodes(place, y);
    if (foundation->exists())
      foundation->add_nodes(place.data() + 6 * n, y.data() + 6 * n, -1.);
    else
      y.tail(m) -= place.tail(m);
    sweep_forward(y, y);
    y += place;
  }



  void SsorSystem::multiply_diagonal(const Eigen::VectorXd &x, Eigen::VectorXd &y) const
  {
    const int n = matrix->n_blocks(), m = 2 * matrix->n_nodes();
#pragma omp parallel for schedule(static) if (is_worth_sharing(n))
    for (int i = 0; i < n; ++i)
      Eigen::Map<Vec6>(y.data() + 6 * i).noalias() =
        matrix->diagonal[i] * Eigen::Map<const Vec6>(x.data() + 6 * i);
    if (!foundation->exists())
      {
        y.tail(m) = x.tail(m);
        return;
      }
    y.tail(m).setZero();
    foundation->add_product(x.data() + 6 * n, y.data() + 6 * n);
    foundation->add_nodes(x.data() + 6 * n, y.data() + 6 * n, 1.);
  }



  void SsorSystem::undo_forward(const Eigen::VectorXd &x, Eigen::VectorXd &y) const
  {
    const int n = matrix->n_blocks();
    multiply_diagonal(x, y);
#pragma omp parallel for schedule(static) if (is_worth_sharing(n))
    for (int p = 0; p < n; ++p)
      Eigen::Map<Vec6>(y.data() + 6 * order.block[p]) += product(row_begin[p], below_end[p], x);
    matrix->add_blocks_to_nodes(x, y);
  }
} // namespace hybrid::dda
