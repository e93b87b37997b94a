// SPDX-License-Identifier: GPL-3.0-or-later
#include "random_block_matrix.h"
#include "thread_group.h"

#include <hybrid/dda/linear/frontal_lu.h>
#include <hybrid/restart/archive.h>

#include <gtest/gtest.h>

#include <cmath>
#include <omp.h>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;
  using hybrid::test::dense;
  using hybrid::test::random_block_matrix;
  using hybrid::test::unsymmetric_block_matrix;

  const std::vector<int> distances{1, 2, 7, 11};

  /// Relative residual of a solution.
  double error(FrontalLu &factor, const BlockMatrix &m)
  {
    const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(m.size(), -1., 2.);
    Eigen::VectorXd       x(m.size()), product(m.size());
    factor.solve(b, x);
    m.multiply(x, product);
    return (product - b).norm() / b.norm();
  }

  void part(BlockMatrix &m, const std::size_t pair)
  {
    m.off_diagonal[pair].setZero();
    m.lower[pair].setZero();
  }
} // namespace



TEST(FrontalLu, solves_symmetric_and_unsymmetric_systems)
{
  for (const int n : {1, 7, 40, 1500}) // the last with nested dissection
    for (const double size : {0., 0.1})
      {
        const BlockMatrix m = size == 0. ? random_block_matrix(n, 0, distances)
                                         : unsymmetric_block_matrix(n, 0, size, distances);
        FrontalLu         factor;
        ASSERT_TRUE(factor.factorize(m));
        EXPECT_LT(error(factor, m), 1e-12);
      }
}



TEST(FrontalLu, a_symmetric_factor_takes_the_place_of_an_unsymmetric_one)
{
  const BlockMatrix symmetric   = random_block_matrix(40, 0, distances);
  const BlockMatrix unsymmetric = unsymmetric_block_matrix(40, 0, 0.1, distances);
  FrontalLu         factor;
  for (const BlockMatrix *m : {&unsymmetric, &symmetric, &unsymmetric})
    {
      ASSERT_TRUE(factor.factorize(*m));
      EXPECT_LT(error(factor, *m), 1e-12);
    }
  EXPECT_EQ(factor.n_analyses(), 1);
}



TEST(FrontalLu, the_order_is_kept_while_no_other_pairs_touch)
{
  BlockMatrix m     = unsymmetric_block_matrix(40, 0, 0.1, distances);
  const Mat6  right = m.off_diagonal[5], below = m.lower[5];
  part(m, 5);
  FrontalLu factor;
  ASSERT_TRUE(factor.factorize(m));
  part(m, 8);
  ASSERT_TRUE(factor.factorize(m));
  EXPECT_EQ(factor.n_analyses(), 1);
  EXPECT_LT(error(factor, m), 1e-12);
  m.off_diagonal[5] = right;
  m.lower[5]        = below;
  ASSERT_TRUE(factor.factorize(m));
  EXPECT_EQ(factor.n_analyses(), 2);
  EXPECT_LT(error(factor, m), 1e-12);
}



TEST(FrontalLu, the_order_is_forgotten_when_most_pairs_have_parted)
{
  BlockMatrix m = unsymmetric_block_matrix(40, 0, 0.1, distances);
  FrontalLu   factor;
  ASSERT_TRUE(factor.factorize(m));
  const double all = factor.fronts().products;
  for (std::size_t s = 0; s < m.pairs.size(); ++s)
    if (m.pairs[s][1] != m.pairs[s][0] + 1)
      part(m, s);
  ASSERT_TRUE(factor.factorize(m));
  EXPECT_EQ(factor.n_analyses(), 2);
  EXPECT_LT(3. * factor.fronts().products, all);
  EXPECT_LT(error(factor, m), 1e-12);
}



TEST(FrontalLu, few_changes_take_few_fronts_and_leave_the_bits_of_new_factors)
{
  for (const bool symmetric : {true, false})
    {
      BlockMatrix m = symmetric ? random_block_matrix(1500, 0, {1, 38})
                                : unsymmetric_block_matrix(1500, 0, 0.1, {1, 38});
      FrontalLu   factor;
      ASSERT_TRUE(factor.factorize(m));
      const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(m.size(), -1., 2.);
      for (int change = 0; change < 4; ++change)
        {
          for (const int block : {700 + change, 720 - change})
            m.diagonal[block] *= 1.1 + 0.1 * change;
          ASSERT_TRUE(factor.factorize(m));
          // The first one finds that it pays to keep what fronts hand on.
          if (change > 0)
            {
              EXPECT_LT(factor.last_cost().products, 0.7 * factor.fronts().products);
              EXPECT_LT(factor.last_cost().fronts, 0.1 * factor.fronts().n_fronts());
            }
          FrontalLu all;
          ASSERT_TRUE(all.factorize(m));
          EXPECT_EQ(all.last_cost().products, all.fronts().products);
          Eigen::VectorXd x(m.size()), expected(m.size());
          factor.solve(b, x);
          all.solve(b, expected);
          EXPECT_EQ((x - expected).cwiseAbs().maxCoeff(), 0.);
        }
    }
}



TEST(FrontalLu, processes_share_fronts_and_have_the_bits_of_one)
{
  for (const bool symmetric : {true, false})
    for (const int n : {2, 3, 4})
      {
        BlockMatrix              m = symmetric ? random_block_matrix(2500, 0, {1, 50})
                                               : unsymmetric_block_matrix(2500, 0, 0.1, {1, 50});
        std::vector<BlockMatrix> matrices{m}; // then with few changes, so that fronts are kept
        for (const int change : {0, 1, 2})
          {
            m.diagonal[1200 + change] *= 1.1;
            matrices.push_back(m);
          }
        m.diagonal[77].setConstant(std::nan("")); // no factors
        matrices.push_back(m);
        m.diagonal[77] = matrices[0].diagonal[77];
        matrices.push_back(m);
        const Eigen::VectorXd        b = Eigen::VectorXd::LinSpaced(m.size(), -1., 2.);
        std::vector<Eigen::VectorXd> expected;
        FrontalLu                    alone;
        for (const BlockMatrix &matrix : matrices)
          {
            expected.emplace_back(m.size());
            if (alone.factorize(matrix))
              alone.solve(b, expected.back());
            else
              expected.back().setZero();
          }
        test::ThreadGroup   group(n);
        std::vector<int>    equal(n, 0);
        std::vector<double> products(n, 0.);
        group.run([&](const ProcessGroup &processes) {
          omp_set_num_threads(1);
          FrontalLu factor;
          factor.set_processes(&processes);
          Eigen::VectorXd x(m.size());
          for (std::size_t k = 0; k < matrices.size(); ++k)
            {
              if (factor.factorize(matrices[k]))
                factor.solve(b, x);
              else
                x.setZero();
              equal[processes.rank()] += x == expected[k] ? 1 : 0;
            }
          products[processes.rank()] = factor.last_cost().products;
        });
        EXPECT_EQ(equal, std::vector<int>(n, static_cast<int>(matrices.size())));
        EXPECT_EQ(products, std::vector<double>(n, alone.last_cost().products));
        EXPECT_GT(group.received(), 0U);
      }
}



TEST(FrontalLu, factors_that_failed_are_made_of_all_fronts_again)
{
  BlockMatrix m = unsymmetric_block_matrix(1500, 0, 0.1, {1, 38});
  FrontalLu   factor;
  ASSERT_TRUE(factor.factorize(m));
  const Mat6 before = m.diagonal[700];
  for (int change = 0; change < 2; ++change)
    {
      m.diagonal[700] *= 1.1;
      ASSERT_TRUE(factor.factorize(m));
    }
  EXPECT_LT(factor.last_cost().products, factor.fronts().products);
  m.diagonal[700].setConstant(std::nan(""));
  EXPECT_FALSE(factor.factorize(m));
  m.diagonal[700] = before;
  ASSERT_TRUE(factor.factorize(m));
  EXPECT_EQ(factor.last_cost().products, factor.fronts().products);
  EXPECT_LT(error(factor, m), 1e-12);
}



TEST(FrontalLu, an_indefinite_matrix_is_solved_too)
{
  BlockMatrix m = random_block_matrix(40, 0, distances);
  for (int b = 0; b < 40; b += 3)
    m.diagonal[b] -= 4. * Mat6::Identity();
  FrontalLu factor;
  ASSERT_TRUE(factor.factorize(m));
  EXPECT_LT(error(factor, m), 1e-10);
}



TEST(FrontalLu, pieces_that_only_their_inertia_holds_are_solved_to_round_off)
{
  // A grid of blocks with one stiff spring between neighbours, and nothing else to hold them but a
  // tiny mass, as bonded pieces between open contacts in a static step.
  const int   side = 12, n = side * side;
  BlockMatrix m = random_block_matrix(n, 0, {1, side});
  for (Mat6 &d : m.diagonal)
    d = 1e-11 * Mat6::Identity();
  int        k    = 0;
  const auto join = [&](const int a, const int b) {
    Vec6 here, there; // the spring's gap by the motion of each block
    for (int c = 0; c < 6; ++c)
      {
        here[c]  = std::sin(1. + k + 2.3 * c * c);
        there[c] = std::cos(2. + 1.7 * k + 3.1 * c);
      }
    ++k;
    const std::size_t slot = m.block_slot(a, b);
    m.diagonal[a] += here * here.transpose();
    m.diagonal[b] += there * there.transpose();
    m.off_diagonal[slot] = -here * there.transpose();
    m.lower[slot]        = -there * here.transpose();
  };
  for (std::size_t s = 0; s < m.pairs.size(); ++s)
    part(m, s);
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j)
      {
        if (j + 1 < side)
          join(side * i + j, side * i + j + 1);
        if (i + 1 < side)
          join(side * i + j, side * (i + 1) + j);
      }
  for (const bool symmetric : {true, false})
    {
      m.symmetric = symmetric;
      FrontalLu factor;
      ASSERT_TRUE(factor.factorize(m));
      // Loads in balance on each piece: what moves it as a whole must not come from round-off.
      Eigen::VectorXd shape(m.size()), b(m.size()), x(m.size()), product(m.size());
      for (int e = 0; e < m.size(); ++e)
        shape[e] = std::sin(0.1 * e * e);
      m.multiply(shape, b);
      factor.solve(b, x);
      m.multiply(x, product);
      EXPECT_LT((product - b).norm(), 1e-5 * b.norm());
    }
}



TEST(FrontalLu, a_singular_block_and_growing_entries_are_noticed)
{
  BlockMatrix m = unsymmetric_block_matrix(10, 0, 0.1, {1});
  for (std::size_t s = 0; s < m.pairs.size(); ++s)
    part(m, s);
  m.diagonal[4].setZero();
  EXPECT_FALSE(FrontalLu().factorize(m));

  // Regular, but only if rows of different blocks are exchanged.
  BlockMatrix tiny = unsymmetric_block_matrix(3, 0, 0.1, {1});
  for (Mat6 &block : tiny.diagonal)
    block = 1e-8 * Mat6::Identity();
  EXPECT_FALSE(FrontalLu().factorize(tiny));
}



TEST(FrontalLu, a_restored_factor_and_later_ones_give_the_same_bits)
{
  using hybrid::restart::Archive;
  for (BlockMatrix m :
       {random_block_matrix(40, 0, distances), unsymmetric_block_matrix(40, 0, 0.1, distances)})
    {
      FrontalLu factor, copy;
      ASSERT_TRUE(factor.factorize(m));
      Archive writer = Archive::writer();
      factor.serialize(writer, true);
      Archive reader = Archive::reader(writer.content());
      copy.serialize(reader, true);
      EXPECT_TRUE(reader.at_end());
      const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(240, -1., 2.);
      Eigen::VectorXd       x(240), y(240);
      for (int round = 0; round < 2; ++round)
        {
          factor.solve(b, x);
          copy.solve(b, y);
          EXPECT_EQ(x, y);
          part(m, 3);
          ASSERT_TRUE(factor.factorize(m) && copy.factorize(m));
        }
    }
}



// Enough blocks to be shared out: subtrees, and products of the large fronts above them.
TEST(FrontalLu, the_same_bits_with_any_number_of_threads)
{
  const int side = 60, n = side * side, before = omp_get_max_threads();
  for (const BlockMatrix &m :
       {random_block_matrix(n, 0, {1, side}), unsymmetric_block_matrix(n, 0, 0.1, {1, side})})
    {
      const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(6 * n, -1., 2.);
      Eigen::VectorXd       one(6 * n), x(6 * n);
      for (const int threads : {1, 2, 3})
        {
          omp_set_num_threads(threads);
          FrontalLu factor;
          ASSERT_TRUE(factor.factorize(m));
          factor.solve(b, threads == 1 ? one : x);
          if (threads > 1)
            {
              EXPECT_EQ(one, x) << threads << " threads";
            }
        }
    }
  omp_set_num_threads(before);
}
