// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/step/secant_correction.h>
#include <hybrid/restart/archive.h>

#include <gtest/gtest.h>

#include <Eigen/LU>

namespace
{
  using hybrid::dda::SecantCorrection;

  constexpr int size = 12;

  /// A kept tangent, and what it has become since.
  struct Case
  {
    Eigen::MatrixXd kept, now;
    Eigen::VectorXd scale, load, other_load;

    Case()
    {
      std::srand(1);
      kept  = Eigen::MatrixXd::Identity(size, size) + 0.1 * Eigen::MatrixXd::Random(size, size);
      now   = kept + 1e-3 * Eigen::MatrixXd::Random(size, size);
      scale = Eigen::VectorXd::LinSpaced(size, 0.5, 2.);
      load  = Eigen::VectorXd::Random(size);
      other_load = 1.1 * load + 0.05 * Eigen::VectorXd::Random(size);
    }

    Eigen::VectorXd solve(const Eigen::VectorXd &b) const
    {
      return kept.lu().solve(b);
    }

    double left(const Eigen::VectorXd &b, const Eigen::VectorXd &update) const
    {
      return (b - now * update).norm() / b.norm();
    }

    /// One step of two updates.
    void teach(SecantCorrection &secant, const Eigen::VectorXd &b) const
    {
      Eigen::VectorXd first = solve(b);
      secant.correct(scale, first);
      secant.first(first);
      secant.second(solve(b - now * first));
    }
  };
} // namespace



TEST(SecantCorrection, solves_the_matrix_that_has_the_secant)
{
  const Case            c;
  SecantCorrection      secant;
  const Eigen::VectorXd s = c.solve(c.load), weighted = c.scale.cwiseAbs2().cwiseProduct(s);
  c.teach(secant, c.load);
  const Eigen::MatrixXd mended =
    c.kept - (c.load - c.now * s) * weighted.transpose() / weighted.dot(s);
  Eigen::VectorXd u = c.solve(c.other_load);
  secant.correct(c.scale, u);
  EXPECT_LT((mended * u - c.other_load).norm(), 1e-12 * c.other_load.norm());
}



TEST(SecantCorrection, a_similar_step_needs_no_second_update)
{
  const Case       c;
  SecantCorrection secant;
  c.teach(secant, c.load);
  const Eigen::VectorXd plain = c.solve(c.other_load);
  Eigen::VectorXd       u     = plain;
  secant.correct(c.scale, u);
  EXPECT_LT(c.left(c.other_load, u), 0.1 * c.left(c.other_load, plain));
}



// The remedy of a corrected update is that of both parts: the same step again is solved.
TEST(SecantCorrection, a_second_lesson_replaces_the_first)
{
  const Case       c;
  SecantCorrection secant;
  c.teach(secant, c.load);
  c.teach(secant, c.other_load);
  Eigen::VectorXd u = c.solve(c.other_load);
  secant.correct(c.scale, u);
  EXPECT_LT(c.left(c.other_load, u), 1e-5);
}



TEST(SecantCorrection, forgets_and_leaves_alone_what_it_cannot_mend)
{
  Case             c;
  SecantCorrection secant;
  c.teach(secant, c.load);
  secant.reset();
  const Eigen::VectorXd plain = c.solve(c.load);
  Eigen::VectorXd       u     = plain;
  secant.correct(c.scale, u);
  EXPECT_EQ(u, plain);

  c.now = 0.5 * c.kept; // half of the residual is left
  c.teach(secant, c.load);
  secant.correct(c.scale, u);
  EXPECT_EQ(u, plain);
}



TEST(SecantCorrection, is_stored)
{
  using hybrid::restart::Archive;
  const Case       c;
  SecantCorrection secant, copy;
  c.teach(secant, c.load);
  Archive writer = Archive::writer();
  secant.serialize(writer);
  Archive reader = Archive::reader(writer.content());
  copy.serialize(reader);
  Eigen::VectorXd u = c.solve(c.other_load), v = u;
  secant.correct(c.scale, u);
  copy.correct(c.scale, v);
  EXPECT_EQ(u, v);
}
