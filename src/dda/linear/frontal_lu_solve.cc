// SPDX-License-Identifier: GPL-3.0-or-later
// Solution with the factors.
#include <hybrid/dda/linear/frontal_lu.h>
#include <hybrid/dda/linear/shared_loop.h>

#include <algorithm>

namespace hybrid::dda
{
  namespace
  {
    /// Bring numbers of the next front into the cache while this one is solved: processors do so by
    /// themselves within a front, but fronts are small.
    void fetch(const double *begin, const double *end)
    {
      constexpr std::ptrdiff_t line = 8, most = 1024;
      const double *const      last = std::min(end, begin + std::min(most, end - begin));
      for (const double *at = begin; at < last; at += line)
        __builtin_prefetch(at);
    }
  } // namespace



  void FrontalLu::solve(const Eigen::VectorXd &b, Eigen::VectorXd &x)
  {
    const int  n_shared = static_cast<int>(plan.shared.size());
    const bool is_large = is_worth_sharing(size);
    for (int p = 0; p < size; ++p)
      rest.segment<6>(6 * p) = b.segment<6>(6 * tree.block[p]);
#pragma omp parallel for schedule(dynamic) if (is_large)
    for (int s = 0; s < n_shared; ++s)
      for (int f = plan.shared[s].first; f < plan.shared[s].last; ++f)
        solve_forward(f);
    for (const int f : plan.above)
      solve_forward(f);
    if (shares_fronts())
      hand_over_forces();
    for (const int f : plan.of_all)
      solve_forward(f);
    for (auto f = plan.of_all.rbegin(); f != plan.of_all.rend(); ++f)
      solve_backward(*f);
    for (auto f = plan.above.rbegin(); f != plan.above.rend(); ++f)
      solve_backward(*f);
#pragma omp parallel for schedule(dynamic) if (is_large)
    for (int s = 0; s < n_shared; ++s)
      for (int f = plan.shared[s].last - 1; f >= plan.shared[s].first; --f)
        solve_backward(f);
    if (shares_fronts())
      gather_solution();
    for (int p = 0; p < size; ++p)
      x.segment<6>(6 * tree.block[p]) = ordered.segment<6>(6 * p);
  }



  void FrontalLu::solve_forward(const int f)
  {
    const int p = tree.own(f), u = tree.later(f);
    if (f + 1 < tree.n_fronts())
      fetch(kept_of(f + 1), kept_of(f + 1) + entries_of_panel(f + 1));
    double *own  = rest.data() + 6 * tree.begin[f];
    double *hand = handed.data() + 6 * static_cast<std::ptrdiff_t>(tree.later_begin[f]);
    std::fill_n(hand, 6 * u, 0.);
    for (int c = plan.child_begin[f]; c < plan.child_begin[f + 1]; ++c)
      {
        const int     begin = tree.later_begin[plan.child[c]];
        const double *left  = handed.data() + 6 * static_cast<std::ptrdiff_t>(begin);
        for (int k = 0; k < tree.later(plan.child[c]); ++k)
          {
            const int place = tree.in_parent[begin + k];
            Eigen::Map<Vec6>(place < p ? own + 6 * place : hand + 6 * (place - p)) +=
              Eigen::Map<const Vec6>(left + 6 * k);
          }
      }
    subtract_product({kept_of(f), 6 * u, 6 * p, 6 * u}, own, hand);
  }



  void FrontalLu::solve_backward(const int f)
  {
    const int p = 6 * tree.own(f), u = 6 * tree.later(f);
    if (f > 0)
      {
        const double *next = factors.data() + factor_begin[f - 1], *panel = kept_of(f - 1);
        fetch(next, panel);
        fetch(panel + (symmetric ? 0 : entries_of_panel(f - 1)), factors.data() + factor_begin[f]);
      }
    double    *own    = factors.data() + factor_begin[f];
    double    *kept   = kept_of(f);
    double    *right  = kept + entries_of_panel(f);
    double    *here   = rest.data() + 6 * tree.begin[f];
    double    *result = ordered.data() + 6 * tree.begin[f];
    double    *later  = handed.data() + 6 * static_cast<std::ptrdiff_t>(tree.later_begin[f]);
    const int *place  = tree.later_places.data() + tree.later_begin[f];
    for (int k = 0; k < u / 6; ++k)
      Eigen::Map<Vec6>(later + 6 * k) = ordered.segment<6>(6 * place[k]);
    if (!symmetric)
      subtract_product({right, p, u, p}, later, here);
    divide(here, divisor(f, {own, p, p, p}), result);
    if (symmetric) // D^-1 B is the transpose of C D^-1
      subtract_transposed_product({kept, u, p, u}, later, result);
  }
} // namespace hybrid::dda
