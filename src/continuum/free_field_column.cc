// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/free_field_column.h>
#include <hybrid/continuum/inertia_correction.h>
#include <hybrid/scene/lapack_band.h>

#include <algorithm>
#include <stdexcept>

extern "C"
{
  // BLAS on a symmetric band matrix: y = alpha A x + beta y.
  void dsbmv_(const char   *uplo,
              const int    *n,
              const int    *k,
              const double *alpha,
              const double *a,
              const int    *lda,
              const double *x,
              const int    *incx,
              const double *beta,
              double       *y,
              const int    *incy);
}

namespace hybrid::continuum
{
  namespace
  {
    /// y += factor A x
    void add_product(const double           factor,
                     const Eigen::MatrixXd &a,
                     const Eigen::VectorXd &x,
                     Eigen::VectorXd       &y)
    {
      const int    n = static_cast<int>(a.cols()), leading = static_cast<int>(a.rows());
      const int    width = leading - 1, one = 1;
      const double kept = 1.;
      dsbmv_("L", &n, &width, &factor, a.data(), &leading, x.data(), &one, &kept, y.data(), &one);
    }



    void factorize(Eigen::MatrixXd &a)
    {
      const int n = static_cast<int>(a.cols()), leading = static_cast<int>(a.rows());
      const int width = leading - 1;
      int       info  = 0;
      dpbtrf_("L", &n, &width, a.data(), &leading, &info);
      if (info != 0)
        throw std::runtime_error("FreeFieldColumn: the matrix is not positive definite");
    }



    /// x := A^-1 x
    void solve(const Eigen::MatrixXd &factor, Eigen::VectorXd &x)
    {
      const int n = static_cast<int>(factor.cols()), leading = static_cast<int>(factor.rows());
      const int width = leading - 1, one = 1;
      int       info = 0;
      dpbtrs_("L", &n, &width, &one, factor.data(), &leading, x.data(), &n, &info);
    }
  } // namespace



  FreeFieldColumn::FreeFieldColumn(const LagrangeLine &line, Model m)
    : model(std::move(m))
    , joints(model.joints, line.degree())
    , width(line.degree())
    , n(static_cast<int>(model.elements.size()) * width + 1 + joints.count())
    , mass(Eigen::MatrixXd::Zero(width + 1, n))
    , stiffness{mass, mass}
    , inertia_correction{mass, mass}
  {
    for (ColumnJoints::Nodal *of_nodes : {&predicted, &rate, &u, &past})
      for (Eigen::VectorXd &x : *of_nodes)
        x = Eigen::VectorXd::Zero(n);
    for (std::size_t e = 0; e < model.elements.size(); ++e)
      {
        const Element        &element   = model.elements[e];
        const int             first     = first_node(static_cast<int>(e));
        const double          h         = element.top - element.bottom;
        const Eigen::MatrixXd inertia   = element.density * h * line.mass();
        const double          moduli[2] = {element.shear, element.lambda + 2. * element.shear};
        const auto            add = [&](Eigen::MatrixXd &band, const Eigen::MatrixXd &of_element) {
          for (int j = 0; j <= width; ++j)
            band.col(first + j).head(width + 1 - j) += of_element.col(j).tail(width + 1 - j);
        };
        add(mass, inertia);
        for (const int c : {0, 1})
          {
            const Eigen::MatrixXd elastic = moduli[c] / h * line.stiffness();
            add(stiffness[c], elastic);
            if (model.newmark.corrected_step != 0.)
              add(inertia_correction[c],
                  continuum::inertia_correction(inertia, elastic, model.newmark.corrected_step));
          }
      }
  }


  const FreeFieldColumn::Factor &FreeFieldColumn::factor_for(const double dt)
  {
    for (auto &factor : factors)
      if (factor.dt == dt)
        return factor;
    if (factors.size() >= 3)
      factors.erase(factors.begin());

    const double to_rate    = model.newmark.gamma / (model.newmark.beta * dt);
    const double to_inertia = 1. / (model.newmark.beta * dt * dt);
    Factor       factor;
    factor.dt = dt;
    for (int c = 0; c < 2; ++c)
      {
        Eigen::MatrixXd &a = factor.matrix[c];
        a = (1. + to_rate * model.rayleigh_stiffness + model.maxwell.step_modulus(dt)) *
              stiffness[c] +
            (to_inertia + to_rate * model.rayleigh_mass) * mass +
            to_inertia * inertia_correction[c];
        factor.foot[c] = a.col(0);
        if (model.foot == Foot::impedance)
          a(0, 0) += to_rate * model.foot_impedance[c];
        else
          a.col(0).tail(width).setZero();
        factorize(a);
        factor.response.motion[c] = Eigen::MatrixXd::Zero(n, joints.count());
        for (int j = 0; j < joints.count(); ++j)
          {
            u[c].setZero();
            joints.pull_apart(j, u[c]);
            solve(a, u[c]);
            factor.response.motion[c].col(j) = u[c];
          }
      }
    if (!joints.empty())
      joints.find_relaxation(joints.slips() ? 0. : excess(dt), factor.response);
    factors.push_back(std::move(factor));
    return factors.back();
  }



  double FreeFieldColumn::excess(const double dt) const
  {
    return model.newmark.gamma / (model.newmark.beta * dt) * model.rayleigh_stiffness +
           (model.joints_relax ? model.maxwell.step_modulus(dt) : 0.);
  }



  bool FreeFieldColumn::step(const ConstMotion &old,
                             const Motion      &next,
                             const double       dt,
                             const Input       &in,
                             const SlipState   *slip)
  {
    if (model.newmark.beta == 0.)
      {
        step_explicitly(old, next, dt, in);
        return true;
      }
    for (int c = 0; c < 2; ++c)
      step_alone(old, dt, in, c);
    if (!joints.empty())
      {
        const bool damped = !joints.slips() && excess(dt) != 0.;
        for (int c = 0; c < 2 && damped; ++c)
          {
            if (!model.joints_relax)
              past[c].setZero();
            past[c] = (past[c] + model.rayleigh_stiffness * rate[c]) / (1. + excess(dt));
          }
        if (!joints.join(factor_for(dt).response, damped ? &past : nullptr, slip, u))
          return false;
      }
    for (int c = 0; c < 2; ++c)
      finish(old, next, dt, c);
    return true;
  }



  void
  FreeFieldColumn::step_alone(const ConstMotion &old, const double dt, const Input &in, const int c)
  {
    const double  beta = model.newmark.beta, gamma = model.newmark.gamma;
    const double  to_rate = gamma / (beta * dt), to_acceleration = 1. / (beta * dt * dt);
    const double  filter = model.newmark.filter_in(dt, old.last_step);
    const Factor &factor = factor_for(dt);
    for (int i = 0; i < n; ++i)
      {
        const int k     = 2 * i + c;
        predicted[c][i] = old.u[k] + dt * old.v[k] + dt * dt * (0.5 - beta) * old.a[k];
        if (filter > 0.)
          predicted[c][i] -= 0.5 * dt * dt * filter * old.change[k];
        rate[c][i] = to_rate * predicted[c][i] - old.v[k] - (1. - gamma) * dt * old.a[k];
        if (filter > 0.)
          rate[c][i] += dt * filter * old.change[k];
      }
    Eigen::VectorXd &rhs = u[c];
    rhs.setZero();
    add_product(to_acceleration, mass, predicted[c], rhs);
    if (model.newmark.corrected_step != 0.)
      add_product(to_acceleration, inertia_correction[c], predicted[c], rhs);
    if (model.rayleigh_mass != 0.)
      add_product(model.rayleigh_mass, mass, rate[c], rhs);
    if (model.rayleigh_stiffness != 0.)
      add_product(model.rayleigh_stiffness, stiffness[c], rate[c], rhs);
    if (model.maxwell.n_branches() > 0)
      {
        find_past(old, dt, c);
        add_product(1., stiffness[c], past[c], rhs);
      }
    else
      past[c].setZero();
    const double foot = predicted[c][0] + beta * dt * dt * in.acceleration[c];
    if (model.foot == Foot::impedance)
      rhs[0] += model.foot_impedance[c] * (rate[c][0] + 2. * in.wave_velocity[c]);
    else
      {
        rhs.head(width + 1) -= foot * factor.foot[c];
        rhs[0] = 0.;
      }
    solve(factor.matrix[c], rhs);
    if (model.foot == Foot::prescribed)
      rhs[0] = foot;
  }



  void FreeFieldColumn::finish(const ConstMotion &old,
                               const Motion      &next,
                               const double       dt,
                               const int          c) const
  {
    const double gamma = model.newmark.gamma, to_acceleration = 1. / (model.newmark.beta * dt * dt);
    const double filter = model.newmark.filter_in(dt, old.last_step);
    const double kept   = (1. - Newmark::memory) * Newmark::remembered_in(dt, old.last_step);
    for (int i = 0; i < n; ++i)
      {
        const int k = 2 * i + c;
        next.u[k]   = u[c][i];
        next.a[k]   = to_acceleration * (u[c][i] - predicted[c][i]);
        next.v[k]   = old.v[k] + dt * ((1. - gamma) * old.a[k] + gamma * next.a[k]);
        if (filter > 0.)
          next.v[k] -= dt * filter * old.change[k];
        if (next.change != nullptr)
          next.change[k] = kept * old.change[k] + Newmark::memory * (next.a[k] - old.a[k]);
      }
    if (next.branch != nullptr)
      advance(old, next, dt, c);
  }



  void FreeFieldColumn::step_explicitly(const ConstMotion &old,
                                        const Motion      &next,
                                        const double       dt,
                                        const Input       &in)
  {
    const double half = 0.5 * dt;
    for (int c = 0; c < 2; ++c)
      {
        strain_explicitly(old, next, dt, c);
        u[c].setZero();
        add_product(-1., stiffness[c], past[c], u[c]);
      }
    if (!joints.empty())
      joints.add_forces(past, u);
    for (int c = 0; c < 2; ++c)
      for (int i = 0; i < n; ++i)
        {
          const int    k       = 2 * i + c;
          const double inertia = mass(0, i), drag = model.rayleigh_mass * inertia;
          double       force = u[c][i] - drag * rate[c][i], resisting = inertia + half * drag;
          if (i == 0 && model.foot == Foot::impedance)
            {
              force += model.foot_impedance[c] * (2. * in.wave_velocity[c] - rate[c][0]);
              resisting += half * model.foot_impedance[c];
            }
          next.u[k] = predicted[c][i];
          next.a[k] =
            i == 0 && model.foot == Foot::prescribed ? in.acceleration[c] : force / resisting;
          next.v[k] = rate[c][i] + half * next.a[k];
        }
  }



  void FreeFieldColumn::strain_explicitly(const ConstMotion &old,
                                          const Motion      &next,
                                          const double       dt,
                                          const int          c)
  {
    for (int i = 0; i < n; ++i)
      {
        const int k     = 2 * i + c;
        rate[c][i]      = old.v[k] + 0.5 * dt * old.a[k];
        predicted[c][i] = old.u[k] + dt * rate[c][i];
      }
    past[c] = model.maxwell.relaxed * predicted[c] + model.rayleigh_stiffness * rate[c];
    for (std::size_t l = 0; l < model.maxwell.n_branches(); ++l)
      for (int i = 0; i < n; ++i)
        {
          double &strain = next.branch[l * old.stride + 2 * i + c];
          strain         = model.maxwell.kept(dt, l) * old.branch[l * old.stride + 2 * i + c] +
                   model.maxwell.gained(dt, l) * dt * rate[c][i];
          past[c][i] += model.maxwell.weight[l] * strain;
        }
  }



  void FreeFieldColumn::find_past(const ConstMotion &old, const double dt, const int c)
  {
    const MaxwellBody &body = model.maxwell;
    past[c].setZero();
    for (std::size_t l = 0; l < body.n_branches(); ++l)
      {
        const double kept = body.weight[l] * body.kept(dt, l);
        const double gain = body.weight[l] * body.gained(dt, l);
        for (int i = 0; i < n; ++i)
          past[c][i] += gain * old.u[2 * i + c] - kept * old.branch[l * old.stride + 2 * i + c];
      }
  }



  void FreeFieldColumn::advance(const ConstMotion &old,
                                const Motion      &next,
                                const double       dt,
                                const int          c) const
  {
    const MaxwellBody &body = model.maxwell;
    for (std::size_t l = 0; l < body.n_branches(); ++l)
      for (int i = 0; i < n; ++i)
        {
          const std::size_t k = 2 * i + c, b = l * old.stride + k;
          next.branch[b] =
            body.kept(dt, l) * old.branch[b] + body.gained(dt, l) * (next.u[k] - old.u[k]);
        }
  }
} // namespace hybrid::continuum
