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
    /// 2, of length 1; wave speed 1.
    double frequency_of_wave(const int degree, const double k, const ElementMass of_elements)
    {
      const bool is_diagonal = of_elements == ElementMass::diagonal;
      if (degree == 1 && is_diagonal)
        return 2. * std::sin(0.5 * k);
      if (degree == 1)
        return std::sqrt(6. * (1. - std::cos(k)) / (2. + std::cos(k)));
      // nodes 0, 1/2, 1: the last is the first one's neighbour in the next element
      const Complex    turn = std::exp(Complex(0., k));
      const double     next = 2. * std::cos(k);
      Eigen::Matrix2cd stiffness, mass;
      stiffness << 14. + next, -8. * (1. + std::conj(turn)), -8. * (1. + turn), 16.;
      if (is_diagonal)
        mass << 10., 0., 0., 20.;
      else
        mass << 8. - next, 2. * (1. + std::conj(turn)), 2. * (1. + turn), 16.;
      const Eigen::Matrix2cd k3 = stiffness / 3., m30 = mass / 30.;
      const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix2cd> eigen(k3, m30);
      return std::sqrt(eigen.eigenvalues()[0]);
    }



    TEST(MeshDispersion, IsTheLeadOfAWaveInARowOfElements)
    {
      for (const ElementMass mass : {ElementMass::consistent, ElementMass::diagonal})
        for (const int degree : {1, 2})
          {
            const double  k = 0.4, w = frequency_of_wave(degree, k, mass);
            const Complex error = mesh_frequency_error(degree, 1., Complex(0., w), mass);
            EXPECT_EQ(w > k, mass == ElementMass::consistent) << degree; // then the wave is fast
            EXPECT_NEAR(error.imag(), k - w, 0.05 * std::abs(w - k)) << degree;
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
