// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/linear/local_system.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hybrid::dda
{
  namespace
  {
    constexpr double left_to_others = 0.2;  ///< of the norm of the residual
    constexpr double part_at_most   = 0.15; ///< of all bodies
    constexpr double most_bodies    = 4000;
    constexpr int    least_mass     = 500; ///< bodies in all, from which it pays
    constexpr int    most_sweeps    = 100;
  } // namespace



  bool LocalSystem::take_largest(const BlockMatrix &matrix,
                                 const Residual    &residual,
                                 const std::size_t  most)
  {
    const int n = matrix.n_blocks(), m = matrix.n_nodes();
    left.resize(n + m);
    double total = 0.;
    for (int b = 0; b < n; ++b)
      total += left[b] = residual.of_unknowns.segment<6>(6 * b)
                           .cwiseQuotient(residual.scale.segment<6>(6 * b))
                           .squaredNorm();
    for (int k = 0; k < m; ++k)
      total += left[n + k] = residual.of_unknowns.segment<2>(6 * n + 2 * k).squaredNorm();
    const double bound = left_to_others * left_to_others * total;
    // All that are not listed together have less than the bound.
    bodies.clear();
    for (int i = 0; i < n + m; ++i)
      if (left[i] > 0.1 * bound / (n + m))
        bodies.push_back(i);
    const auto larger = [this](const int i, const int j) {
      return left[i] != left[j] ? left[i] > left[j] : i < j;
    };
    const std::size_t ranked = std::min(bodies.size(), most);
    std::partial_sort(bodies.begin(), bodies.begin() + ranked, bodies.end(), larger);
    std::size_t taken = 0;
    for (; taken < ranked && total > bound; ++taken)
      total -= left[bodies[taken]];
    bodies.resize(taken);
    chosen.assign(n + m, 0);
    for (const int body : bodies)
      chosen[body] = 1;
    return total <= bound;
  }



  void LocalSystem::grow(const BlockMatrix &matrix, const bool with_nodes)
  {
    const int  n = matrix.n_blocks(), m = matrix.n_nodes();
    const auto take = [&](const int body) {
      if (chosen[body] == 0)
        bodies.push_back(body);
      chosen[body] = 1;
    };
    const std::size_t n_taken = bodies.size();
    for (std::size_t i = 0; i < n_taken; ++i)
      {
        const int body = bodies[i];
        if (body < n)
          {
            for (const int other : matrix.blocks_at_block(body))
              take(other);
            const auto [first, last] = matrix.couplings_of_block(body);
            for (int s = first; s < last && with_nodes; ++s)
              take(n + matrix.couplings[s][1]);
            continue;
          }
        for (const int s : matrix.couplings_of_node(body - n))
          take(matrix.couplings[s][0]);
        if (with_nodes && body > n)
          take(body - 1);
        if (with_nodes && body + 1 < n + m)
          take(body + 1);
      }
  }



  bool LocalSystem::choose(const BlockMatrix &matrix, const Residual &residual)
  {
    n_all_blocks    = matrix.n_blocks();
    const auto most = static_cast<std::size_t>(
      std::min(most_bodies, part_at_most * (n_all_blocks + matrix.n_nodes())));
    if (n_all_blocks + matrix.n_nodes() < least_mass || !take_largest(matrix, residual, most))
      return false;
    grow(matrix, true);
    if (bodies.size() > most)
      return false;
    const std::size_t n_moving = bodies.size();
    grow(matrix, false);
    list_bodies(n_moving);
    return true;
  }



  void LocalSystem::choose(const BlockMatrix &matrix, const std::vector<int> &blocks)
  {
    n_all_blocks = matrix.n_blocks();
    bodies.assign(blocks.begin(), blocks.end());
    chosen.assign(n_all_blocks + matrix.n_nodes(), 0);
    for (const int body : bodies)
      chosen[body] = 1;
    grow(matrix, false);
    list_bodies(blocks.size());
  }



  void LocalSystem::list_bodies(const std::size_t n_moving)
  {
    moving_blocks.clear();
    moving_nodes.clear();
    changing.clear();
    for (std::size_t i = 0; i < bodies.size(); ++i)
      {
        const int body = bodies[i];
        if (body < n_all_blocks)
          changing.push_back(body);
        if (i < n_moving && body < n_all_blocks)
          moving_blocks.push_back(body);
        else if (i < n_moving)
          moving_nodes.push_back(body - n_all_blocks);
      }
    for (std::vector<int> *list : {&moving_blocks, &moving_nodes, &changing})
      std::sort(list->begin(), list->end());
  }



  double LocalSystem::norm(const Residual &residual) const
  {
    double sum = 0.;
    for (const int b : moving_blocks)
      sum += residual.of_unknowns.segment<6>(6 * b)
               .cwiseQuotient(residual.scale.segment<6>(6 * b))
               .squaredNorm();
    for (const int k : moving_nodes)
      sum += residual.of_unknowns.segment<2>(6 * n_all_blocks + 2 * k).squaredNorm();
    return std::sqrt(sum);
  }



  void LocalSystem::set_part(const BlockMatrix         &matrix,
                             const FoundationStiffness &foundation,
                             const Residual            &residual)
  {
    const int n = static_cast<int>(moving_blocks.size()), m = static_cast<int>(moving_nodes.size());
    part.set_part(matrix, moving_blocks, moving_nodes);
    solver.set_foundation_stiffness({});
    if (foundation.exists() && m > 0)
      {
        part_foundation.resize(2 * m, 2 * m);
        for (int j = 0; j < 2 * m; ++j)
          for (int i = 0; i < 2 * m; ++i)
            part_foundation(i, j) =
              foundation(2 * moving_nodes[i / 2] + i % 2, 2 * moving_nodes[j / 2] + j % 2);
        solver.set_foundation_stiffness(&part_foundation);
      }
    part_residual.resize(6 * n + 2 * m);
    part_scale.setOnes(6 * n + 2 * m);
    for (int k = 0; k < n; ++k)
      {
        part_residual.segment<6>(6 * k) = residual.of_unknowns.segment<6>(6 * moving_blocks[k]);
        part_scale.segment<6>(6 * k)    = residual.scale.segment<6>(6 * moving_blocks[k]);
      }
    for (int k = 0; k < m; ++k)
      part_residual.segment<2>(6 * n + 2 * k) =
        residual.of_unknowns.segment<2>(6 * n_all_blocks + 2 * moving_nodes[k]);
    part_blocks.resize(n);
    std::iota(part_blocks.begin(), part_blocks.end(), 0);
    solver.matrix_changed(part, part_blocks);
  }



  void LocalSystem::solve(const BlockMatrix         &matrix,
                          const FoundationStiffness &foundation,
                          const Residual            &residual,
                          const double               tolerance,
                          Eigen::VectorXd           &x)
  {
    set_part(matrix, foundation, residual);
    solver.solve_by_sweeps(part, part_residual, part_scale, tolerance, most_sweeps, part_update);
    const int n = static_cast<int>(moving_blocks.size()), m = static_cast<int>(moving_nodes.size());
    x.setZero(residual.of_unknowns.size());
    for (int k = 0; k < n; ++k)
      x.segment<6>(6 * moving_blocks[k]) = part_update.segment<6>(6 * k);
    for (int k = 0; k < m; ++k)
      x.segment<2>(6 * n_all_blocks + 2 * moving_nodes[k]) = part_update.segment<2>(6 * n + 2 * k);
  }
} // namespace hybrid::dda
