// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/substitution.h>

#include <algorithm>
#include <array>
#include <utility>

namespace hybrid::continuum
{
  namespace
  {
    /// Numbers of a factor from which threads share a substitution: they take some 300 us, waking a
    /// thread 50.
    constexpr std::size_t worth_sharing = 400000;

    constexpr int four = SubstitutionPlan::rows_at_once, widest = SubstitutionPlan::widest;

    using Two  = Eigen::Array2d;
    using Fill = Eigen::Map<const Two>;

    /// A panel's numbers and the places of its rows.
    struct PanelData
    {
      const double *triangle, *below;
      const int    *row;
      int           n_fours;
    };

    /// y of the panel's own unknowns, and what that takes from the rows below.
    template <int columns>
    void forward_panel(const PanelData &panel, double *own, double *all)
    {
      double        x[columns];
      const double *l = panel.triangle;
      for (int i = 0; i < columns; ++i)
        {
          double sum = own[i];
          for (int j = 0; j < i; ++j)
            sum -= *l++ * x[j];
          own[i] = x[i] = sum * *l++;
        }
      const double *below = panel.below;
      const int    *row   = panel.row;
      for (int k = 0; k < panel.n_fours; ++k, below += four * columns, row += four)
        {
          Two a(all[row[0]], all[row[1]]), b(all[row[2]], all[row[3]]);
          for (int j = 0; j < columns; ++j)
            {
              a -= Fill(below + four * j) * x[j];
              b -= Fill(below + four * j + 2) * x[j];
            }
          all[row[0]] = a[0];
          all[row[1]] = a[1];
          all[row[2]] = b[0];
          all[row[3]] = b[1];
        }
    }



    /// x of the panel's own unknowns from y and from x of the rows below. These are read from the
    /// last to the first, as panels are.
    template <int columns>
    void backward_panel(const PanelData &panel, const double *y, double *own, const double *all)
    {
      std::array<Two, columns> sum;
      sum.fill(Two::Zero());
      const double *below =
        panel.below + static_cast<std::ptrdiff_t>(four) * columns * panel.n_fours;
      const int *row = panel.row + static_cast<std::ptrdiff_t>(four) * panel.n_fours;
      for (int k = 0; k < panel.n_fours; ++k)
        {
          below -= four * columns;
          row -= four;
          const Two a(all[row[0]], all[row[1]]), b(all[row[2]], all[row[3]]);
          for (int j = 0; j < columns; ++j)
            sum[j] += Fill(below + four * j) * a + Fill(below + four * j + 2) * b;
        }
      double x[columns];
      for (int j = 0; j < columns; ++j)
        x[j] = y[j] - (sum[j][0] + sum[j][1]);
      const double *l = panel.below;
      for (int i = columns - 1; i >= 0; --i)
        {
          l -= i + 1;
          own[i] = x[i] *= l[i];
          for (int j = 0; j < i; ++j)
            x[j] -= l[j] * x[i];
        }
    }



    using Forward  = void (*)(const PanelData &, double *, double *);
    using Backward = void (*)(const PanelData &, const double *, double *, const double *);

    template <int... n>
    constexpr std::array<Forward, widest> forward_kernels(std::integer_sequence<int, n...>)
    {
      return {forward_panel<n + 1>...};
    }

    template <int... n>
    constexpr std::array<Backward, widest> backward_kernels(std::integer_sequence<int, n...>)
    {
      return {backward_panel<n + 1>...};
    }

    /// By the number of columns less one.
    constexpr auto forward_of  = forward_kernels(std::make_integer_sequence<int, widest>());
    constexpr auto backward_of = backward_kernels(std::make_integer_sequence<int, widest>());



    PanelData data_of(const SubstitutionPlan        &plan,
                      const SubstitutionPlan::Panel &panel,
                      const double                  *factor)
    {
      const double *triangle = factor + panel.begin;
      return {triangle,
              triangle + panel.columns * (panel.columns + 1) / 2,
              plan.row.data() + panel.row_begin,
              panel.n_fours};
    }
  } // namespace



  Substitution::Substitution(const SubstitutionPlan &substitution_plan)
    : plan(substitution_plan)
    , is_shared(plan.n_values >= worth_sharing)
    , left(plan.n_numbers, 0.)
    , none(plan.n_numbers, 0.)
    , solution(plan.n_numbers, 0.)
  {}



  void Substitution::forward_part(const SubstitutionPlan::Part &part, const double *factor)
  {
    double *y = left.data() + part.begin;
    for (int p = part.first_panel; p < part.last_panel; ++p)
      {
        const SubstitutionPlan::Panel &panel = plan.panels[p];
        forward_of[panel.columns - 1](data_of(plan, panel, factor), y + panel.place, y);
      }
  }



  void Substitution::forward(const double *factor, const double *b, Eigen::VectorXd &g)
  {
    const int   n_below = static_cast<int>(plan.parts.size()) - 1;
    const auto &above   = plan.above();
    const auto  take    = [&](const SubstitutionPlan::Part &part) {
      double *y = left.data() + part.begin;
      for (int i = part.first_own; i < part.last_own; ++i)
        *y++ = b[plan.own[i]];
      std::fill_n(y, part.n_outside() + 1, 0.);
    };
#pragma omp parallel for schedule(dynamic) if (is_shared)
    for (int k = 0; k < n_below; ++k)
      {
        take(plan.parts[k]);
        forward_part(plan.parts[k], factor);
      }
    take(above);
    double *y = left.data() + above.begin;
    std::copy_n(b + plan.own.size(), above.n_outside(), y + above.n_own());
    for (int k = 0; k < n_below; ++k)
      {
        const SubstitutionPlan::Part &part  = plan.parts[k];
        const double                 *added = left.data() + part.begin + part.n_own();
        for (int i = part.first_outside; i < part.last_outside; ++i)
          y[plan.outside[i]] += *added++;
      }
    forward_part(above, factor);
    g = surface_load();
  }



  Eigen::Map<const Eigen::VectorXd> Substitution::surface_load() const
  {
    const SubstitutionPlan::Part &above = plan.above();
    return {left.data() + above.begin + above.n_own(), above.n_outside()};
  }



  void Substitution::backward_part(const SubstitutionPlan::Part &part,
                                   const double                 *factor,
                                   const double                 *from,
                                   double                       *x)
  {
    const double *y = from + part.begin;
    double       *z = solution.data() + part.begin;
    for (int p = part.last_panel - 1; p >= part.first_panel; --p)
      {
        const SubstitutionPlan::Panel &panel = plan.panels[p];
        backward_of[panel.columns - 1](data_of(plan, panel, factor),
                                       y + panel.place,
                                       z + panel.place,
                                       z);
      }
    for (int i = part.first_own; i < part.last_own; ++i)
      x[plan.own[i]] = *z++;
  }



  void Substitution::backward_from(const double          *from,
                                   const double          *factor,
                                   const Eigen::VectorXd &surface,
                                   double                *x)
  {
    const SubstitutionPlan::Part &above   = plan.above();
    double                       *z_above = solution.data() + above.begin;
    std::copy_n(surface.data(), above.n_outside(), z_above + above.n_own());
    std::copy_n(surface.data(), above.n_outside(), x + plan.own.size());
    backward_part(above, factor, from, x);
#pragma omp parallel for schedule(dynamic) if (is_shared)
    for (int k = static_cast<int>(plan.parts.size()) - 2; k >= 0; --k)
      {
        const SubstitutionPlan::Part &part = plan.parts[k];
        double                       *z    = solution.data() + part.begin + part.n_own();
        for (int i = part.first_outside; i < part.last_outside; ++i)
          *z++ = z_above[plan.outside[i]];
        backward_part(part, factor, from, x);
      }
  }



  void Substitution::backward(const double *factor, const Eigen::VectorXd &surface, double *x)
  {
    backward_from(left.data(), factor, surface, x);
  }



  void Substitution::backward_from_surface(const double          *factor,
                                           const Eigen::VectorXd &surface,
                                           double                *x)
  {
    backward_from(none.data(), factor, surface, x);
  }
} // namespace hybrid::continuum
