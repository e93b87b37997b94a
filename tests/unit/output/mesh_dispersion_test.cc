// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/mesh_dispersion.h>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <cmath>

namespace hybrid::output
{
  namespace
  {
    using Complex = std::complex<double>;


    /// Lowest circular frequency of waves of the wave number k in a row of elements of degree 1 or
    /// 2, of length 1, with nodes and masses of Gauss and Lobatto; wave speed 1.
    double frequency_of_wave(const int degree, const double k)
    {
      if (degree == 1)
        return 2. * std::sin(0.5 * k);
      // nodes 0, 1/2, 1: the last is the first one's neighbour in the next element
      const double     third = 1. / 3.;
      const Complex    turn  = std::exp(Complex(0., k));
      Eigen::Matrix2cd stiffness;
      stiffness << 14. * third + third * (turn + std::conj(turn)),
        -8. * third * (1. + std::conj(turn)), -8. * third * (1. + turn), 16. * third;
      const Eigen::Vector2d  mass(1. / 3., 2. / 3.);
      const Eigen::Vector2d  root   = mass.cwiseSqrt().cwiseInverse();
      const Eigen::Matrix2cd scaled = root.asDiagonal() * stiffness * root.asDiagonal();
      return std::sqrt(Eigen::SelfAdjointEigenSolver<Eigen::Matrix2cd>(scaled).eigenvalues()[0]);
    }



    TEST(MeshDispersion, IsTheLagOfAWaveInARowOfElements)
    {
      for (const int degree : {1, 2})
        {
          const double  k = 0.4, w = frequency_of_wave(degree, k); // k > w: the wave is slow
          const Complex error = mesh_frequency_error(degree, 1., Complex(0., w));
          EXPECT_NEAR(error.imag(), k - w, 0.05 * (k - w)) << degree;
          EXPECT_EQ(error.real(), 0.);
        }
    }


    TEST(MeshDispersion, FallsWithTwiceTheDegree)
    {
      const Complex s(0., 3.);
      for (const int degree : {1, 2, 3, 4})
        EXPECT_NEAR(std::abs(mesh_frequency_error(degree, 0.2, s)) /
                      std::abs(mesh_frequency_error(degree, 0.1, s)),
                    std::pow(2., 2 * degree),
                    1e-9 * std::pow(2., 2 * degree));
    }
  } // namespace
} // namespace hybrid::output
