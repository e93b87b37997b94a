// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/linear/shared_loop.h>
#include <hybrid/dda/springs/spring_stiffness.h>
#include <hybrid/restart/archive.h>

#include <algorithm>
#include <limits>

namespace hybrid::dda
{
  namespace
  {
    /// A joint that has turned by more is rebuilt [rad].
    constexpr double turned = 1e-4;
  } // namespace



  void SpringStiffness::add_product(const Rows         &g,
                                    const Coefficients &d,
                                    const Rows         &h,
                                    const double        sign,
                                    Mat6               &k)
  {
    const Vec6 normal = g.row(0).transpose(), tangent = g.row(1).transpose();
    for (int c = 0; c < 6; ++c)
      {
        const double n = sign * (d.nn * h(0, c)), t = sign * (d.tn * h(0, c) + d.tt * h(1, c));
        k.col(c) += n * normal + t * tangent;
      }
  }



  void SpringStiffness::Kept::serialize(restart::Archive &archive)
  {
    archive(block, other, joint, end, stiffness.nn, stiffness.tt, stiffness.tn);
    archive(of_block, of_other);
  }



  void SpringStiffness::serialize(restart::Archive &archive)
  {
    archive(kept);
  }



  SpringStiffness::Coefficients SpringStiffness::coefficients(const Springs::Spring   &spring,
                                                              const Springs::Response &response,
                                                              const Choice            &choice)
  {
    const double none     = -std::numeric_limits<double>::infinity();
    const double floor    = choice.follow_softening ? none : 0.;
    const double fraction = spring.contact_fraction;
    const double weight   = 1. + fraction * (choice.contact_weight - 1.);
    const double length   = weight * spring.length;
    const bool   coupled  = choice.follow_softening || response.k_nn >= 0.;
    const bool   slides   = fraction == 1. && response.now.state == ContactState::sliding;
    if (fraction == 1. && response.k_nn > 0.) // also between open and closed, see InteriorContacts
      {
        const double kept =
          slides ? choice.sliding_regularisation * spring.law->shear_stiffness() : 0.;
        return {choice.contact_weight * spring.length * response.k_nn,
                length * (std::max(floor, response.shear_by_slip) + kept),
                length * response.k_tn};
      }
    const double kept_shear =
      slides ? choice.sliding_regularisation * spring.law->shear_stiffness() : 0.;
    // Open, only the bond of a joint acts; closed, its contact has the part of k_n.
    const double pressing = response.now.gap > 0. ? 0. : fraction * spring.law->normal_stiffness();
    return {spring.length * std::max(floor, response.k_nn - pressing) +
              choice.contact_weight * spring.length * pressing,
            length * (std::max(floor, response.shear_by_slip) + kept_shear),
            coupled ? length * response.k_tn : 0.};
  }



  Vec2 SpringStiffness::displacement_jump(const Springs         &springs,
                                          const std::size_t      number,
                                          const Eigen::VectorXd &update) const
  {
    const Kept            &k      = kept[number];
    const Springs::Spring &spring = springs.springs[number];
    Vec2                   jump   = -k.of_block * update.segment<6>(6 * spring.block);
    if (spring.other != foundation_body)
      return jump + k.of_other * update.segment<6>(6 * spring.other);
    const Springs::Response &response = springs.responses[number];
    const double            *nodes    = update.data() + 6 * springs.n_blocks();
    for (int i = 0; i < 2; ++i)
      jump += response.weight[i] * k.of_block.leftCols<2>() *
              Eigen::Map<const Vec2>(nodes + 2 * spring.node[i]);
    return jump;
  }



  bool SpringStiffness::same_bodies(const Kept &old, const Springs::Spring &spring)
  {
    return old.block == spring.block && old.other == spring.other && old.joint == spring.joint &&
           old.end == spring.end;
  }



  bool SpringStiffness::same(const Kept              &old,
                             const Springs::Spring   &spring,
                             const Springs::Response &response)
  {
    if (!same_bodies(old, spring))
      return false;
    // The gradient's first entries are the normal. A contact's place moves along an edge as well.
    return old.stiffness.none() ||
           (spring.joint >= 0 &&
            (old.of_block.topLeftCorner<1, 2>().transpose() - response.normal).norm() < turned);
  }



  bool SpringStiffness::serves(const Kept    &old,
                               const Springs &springs,
                               const int      s,
                               const Choice  &choice)
  {
    const Springs::Spring   &spring   = springs.springs[s];
    const Springs::Response &response = springs.responses[s];
    return !choice.all && same(old, spring, response) &&
           old.stiffness == coefficients(spring, response, choice);
  }



  void SpringStiffness::update(const Springs &springs, const Trial &trial, const Choice &choice)
  {
    const int n       = static_cast<int>(springs.springs.size());
    const int n_old   = static_cast<int>(kept.size());
    const int n_block = springs.n_blocks();
    is_marked.assign(n_block, choice.all && choice.blocks == nullptr ? 1 : 0);
    if (choice.all && choice.blocks != nullptr)
      for (const int b : *choice.blocks)
        is_marked[b] = 1;
    const auto mark = [&](const int block, const int other) {
      for (const int body : {block, other})
        if (body != foundation_body && body < n_block)
          is_marked[body] = 1;
    };
    for (int s = n; s < n_old; ++s)
      mark(kept[s].block, kept[s].other);
    kept.resize(n);
    is_new.resize(n);
    const int n_at_work = static_cast<int>(springs.n_at_work());
#pragma omp parallel for schedule(static) if (is_worth_sharing(n_at_work))
    for (int k = 0; k < n_at_work; ++k)
      {
        const int s = static_cast<int>(springs.at_work(k));
        is_new[s]   = s >= n_old || !serves(kept[s], springs, s, choice) ? 1 : 0;
      }
    renewed.clear();
    for (int k = 0; k < n_at_work; ++k)
      {
        const int s = static_cast<int>(springs.at_work(k));
        if (is_new[s] == 0)
          continue;
        if (s < n_old)
          mark(kept[s].block, kept[s].other);
        mark(springs.bodies[s].block, springs.bodies[s].other);
        renewed.push_back(s);
      }
    renew(springs, trial, choice);
    changed.clear();
    for (int b = 0; b < n_block; ++b)
      if (is_marked[b])
        changed.push_back(b);
  }



  void SpringStiffness::renew(const Springs &springs, const Trial &trial, const Choice &choice)
  {
#pragma omp parallel for schedule(static) if (is_worth_sharing(renewed.size()))
    for (std::size_t k = 0; k < renewed.size(); ++k)
      {
        const Springs::Spring   &spring   = springs.springs[renewed[k]];
        const Springs::Response &response = springs.responses[renewed[k]];
        Kept                    &now      = kept[renewed[k]];
        now.block                         = spring.block;
        now.other                         = spring.other;
        now.joint                         = spring.joint;
        now.end                           = spring.end;
        now.stiffness                     = coefficients(spring, response, choice);
        now.of_block.setZero();
        now.of_other.setZero();
        if (now.stiffness.none())
          continue;
        const auto gradients = [&](const int block, Rows &rows) {
          rows.row(0) = trial.motion[block].gradient(response.place, response.normal);
          rows.row(1) = trial.motion[block].gradient(response.place, response.tangent);
        };
        gradients(spring.block, now.of_block);
        if (spring.other != foundation_body)
          gradients(spring.other, now.of_other);
      }
  }



  void SpringStiffness::add_rows(const Springs &springs, const int block, BlockMatrix &matrix) const
  {
    // K = G^T D G with rows of G along normal and tangent; the force has the rows D G.
    for (const int entry : springs.of_block(block))
      {
        const int   s = entry / 2;
        const Kept &k = kept[s];
        if (k.stiffness.none())
          continue;
        const bool  is_first = entry % 2 == 0;
        const Rows &g        = is_first ? k.of_block : k.of_other;
        const int   there    = is_first ? k.other : k.block;
        add_product(g, k.stiffness, g, 1., matrix.diagonal[block]);
        if (there == foundation_body)
          continue;
        add_product(g,
                    k.stiffness,
                    is_first ? k.of_other : k.of_block,
                    -1.,
                    (block < there ? matrix.off_diagonal : matrix.lower)[springs.slot(s)[0]]);
      }
  }



  void SpringStiffness::add_foundation(const Springs &springs, BlockMatrix &matrix) const
  {
    for (const int s : springs.on_foundation())
      if (!kept[s].stiffness.none())
        add_foundation_spring(springs, s, matrix);
    matrix.symmetric = matrix.symmetric && is_symmetric();
  }



  bool SpringStiffness::is_symmetric() const
  {
    bool symmetric = true;
#pragma omp parallel for schedule(static) reduction(&& : symmetric) \
  if (is_worth_sharing(kept.size()))
    for (std::size_t s = 0; s < kept.size(); ++s)
      symmetric = symmetric && kept[s].stiffness.tn == 0. && kept[s].stiffness.nn >= 0. &&
                  kept[s].stiffness.tt >= 0.;
    return symmetric;
  }



  void SpringStiffness::add_foundation_spring(const Springs &springs,
                                              const int      s,
                                              BlockMatrix   &matrix) const
  {
    const Springs::Spring   &spring   = springs.springs[s];
    const Springs::Response &response = springs.responses[s];
    const Kept              &k        = kept[s];
    Eigen::Matrix2d          d;
    d << k.stiffness.nn, 0., k.stiffness.tn, k.stiffness.tt;
    const Eigen::Matrix2d             axes  = k.of_block.leftCols<2>(); // rows: normal, tangent
    const Eigen::Matrix2d             nodal = axes.transpose() * d * axes;
    const Eigen::Matrix<double, 6, 2> right = k.of_block.transpose() * d * axes;
    const Rows                        left  = axes.transpose() * d * k.of_block;
    for (int i = 0; i < 2; ++i)
      {
        const double w = response.weight[i];
        if (w == 0.)
          continue;
        matrix.block_node[springs.slot(s)[i]] -= w * right;
        matrix.node_block[springs.slot(s)[i]] -= w * left;
        matrix.node_diagonal[spring.node[i]] += w * w * nodal;
      }
    if (spring.node[1] == spring.node[0] + 1)
      {
        const double w = response.weight[0] * response.weight[1];
        matrix.node_next[spring.node[0]] += w * nodal;
        matrix.node_previous[spring.node[0]] += w * nodal;
      }
  }
} // namespace hybrid::dda
