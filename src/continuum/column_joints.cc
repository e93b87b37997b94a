// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/column_joints.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace hybrid::continuum
{
  ColumnJoints::ColumnJoints(Model m, const int degree)
    : model(std::move(m))
    , rest(2 * model.joints.size(), 0.)
    , rest_failed(model.joints.size(), 0)
    , failed(rest_failed)
    , jump(static_cast<Eigen::Index>(rest.size()))
    , traction(jump.size())
  {
    for (std::size_t j = 0; j < model.joints.size(); ++j)
      above.push_back(model.joints[j].element * degree + static_cast<int>(j) + 1);
    if (slips())
      solver.emplace(model.joints.size(), *model.strength);
  }



  int ColumnJoints::below(const int e) const
  {
    return static_cast<int>(std::count_if(model.joints.begin(),
                                          model.joints.end(),
                                          [e](const ColumnJoint &j) { return j.element <= e; }));
  }



  void ColumnJoints::pull_apart(const int joint, Eigen::VectorXd &force) const
  {
    force[above[joint]] += 1.;
    force[above[joint] - 1] -= 1.;
  }



  void ColumnJoints::find_relaxation(const double excess, Response &response) const
  {
    const Eigen::Index n = jump.size();
    Eigen::MatrixXd    compliance(n, n);
    const auto         axis = [this](const Eigen::Index i) {
      return i % 2 == 0 ? normal(static_cast<int>(i / 2)) : model.joints[i / 2].tangent;
    };
    for (Eigen::Index i = 0; i < n; ++i)
      for (Eigen::Index k = 0; k < n; ++k)
        {
          const Vec2 of = axis(i), by = axis(k);
          double     sum = 0.;
          for (int c = 0; c < 2; ++c)
            sum += of[c] * by[c] *
                   (response.motion[c](above[i / 2], k / 2) -
                    response.motion[c](above[i / 2] - 1, k / 2));
          compliance(i, k) = sum / model.joints[k / 2].tangent.x();
        }
    for (Eigen::Index i = 0; i < n; ++i)
      compliance(i, i) +=
        1. / ((1. + excess) * (i % 2 == 0 ? model.stiffness.normal : model.stiffness.shear));
    response.relaxation = compliance.partialPivLu().inverse();
  }



  void ColumnJoints::set_rest(const std::vector<double> &tractions,
                              const std::vector<char>   &failures)
  {
    for (std::size_t j = 0; j < model.joints.size(); ++j)
      {
        const int point = model.joints[j].point;
        rest[2 * j]     = tractions[2 * point];
        rest[2 * j + 1] = tractions[2 * point + 1];
        rest_failed[j]  = failures[point];
      }
  }



  SlipState ColumnJoints::initial_state() const
  {
    const std::size_t n = slips() ? model.joints.size() : 0;
    return {std::vector<double>(2 * n, 0.),
            std::vector<double>(n, 0.),
            std::vector<char>(n, 0),
            std::vector<PlaneCondition>(n, PlaneCondition::elastic)};
  }



  void ColumnJoints::add_jumps(const Nodal &u, const double factor)
  {
    for (int j = 0; j < count(); ++j)
      {
        const Vec2 across(u[0][above[j]] - u[0][above[j] - 1], u[1][above[j]] - u[1][above[j] - 1]);
        jump[2 * j] += factor * across.dot(normal(j));
        jump[2 * j + 1] += factor * across.dot(model.joints[j].tangent);
      }
  }



  Vec2 ColumnJoints::force_of(const int joint, const Eigen::VectorXd &t) const
  {
    const Vec2 &tangent = model.joints[joint].tangent;
    return (t[2 * joint] * normal(joint) + t[2 * joint + 1] * tangent) / tangent.x();
  }



  bool
  ColumnJoints::join(const Response &response, const Nodal *slack, const SlipState *slip, Nodal &u)
  {
    jump.setZero();
    add_jumps(u, 1.);
    if (slack != nullptr)
      add_jumps(*slack, -1.);
    if (solver.has_value())
      {
        const Eigen::Map<const Eigen::VectorXd> old(slip->jump.data(), jump.size());
        const Eigen::Map<const Eigen::VectorXd> at_rest(rest.data(), jump.size());
        jump -= old;
        traction.noalias() = response.relaxation * jump;
        traction += at_rest;
        for (std::size_t j = 0; j < failed.size(); ++j)
          failed[j] = slip->failed[j] | rest_failed[j];
        if (!solver->solve({response.relaxation, traction, slip->jump}, failed))
          return false;
        const Eigen::Map<const Eigen::VectorXd> next(solver->jump().data(), jump.size());
        jump += old;
        jump -= next;
      }
    traction.noalias() = response.relaxation * jump;
    for (int j = 0; j < count(); ++j)
      for (int c = 0; c < 2; ++c)
        u[c].noalias() -= force_of(j, traction)[c] * response.motion[c].col(j);
    return true;
  }



  void ColumnJoints::keep(SlipState &state) const
  {
    const std::vector<double> &now = solver->jump();
    for (std::size_t j = 0; j < state.path.size(); ++j)
      state.path[j] += std::abs(now[2 * j + 1] - state.jump[2 * j + 1]);
    state.jump      = now;
    state.failed    = failed;
    state.condition = solver->conditions();
  }



  void ColumnJoints::add_forces(const Nodal &u, Nodal &force)
  {
    jump.setZero();
    add_jumps(u, 1.);
    for (Eigen::Index i = 0; i < jump.size(); ++i)
      traction[i] = (i % 2 == 0 ? model.stiffness.normal : model.stiffness.shear) * jump[i];
    for (int j = 0; j < count(); ++j)
      for (int c = 0; c < 2; ++c)
        {
          force[c][above[j]] -= force_of(j, traction)[c];
          force[c][above[j] - 1] += force_of(j, traction)[c];
        }
  }
} // namespace hybrid::continuum
