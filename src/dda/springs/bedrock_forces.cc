// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/block/viscous_boundary.h>
#include <hybrid/dda/springs/bedrock_forces.h>

#include <algorithm>

namespace hybrid::dda
{
  namespace
  {
    constexpr int forces_per_edge = 2 * BoundaryEdge::n_points;

    ViscousBoundary at_end(const BedrockStep &step, const BoundaryEdge &edge)
    {
      const Geometry &g = step.before.geometry;
      const int       a = edge.vertex, b = g.next(a);
      return {edge,
              g.vertices[a] + step.trial.displacement[a],
              g.vertices[b] + step.trial.displacement[b],
              step.trial.motion[edge.block]};
    }



    ViscousBoundary at_start(const BedrockStep &step, const BoundaryEdge &edge)
    {
      const Geometry &g = step.before.geometry;
      return {edge,
              g.vertices[edge.vertex],
              g.vertices[g.next(edge.vertex)],
              BlockMotion(step.before.blocks[edge.block].centroid, Vec6::Zero())};
    }



    bool is_among(const Model &model, const std::vector<int> &blocks, const int block)
    {
      return static_cast<int>(blocks.size()) == model.n_blocks() ||
             std::binary_search(blocks.begin(), blocks.end(), block);
    }
  } // namespace



  void add_bedrock_forces(const BedrockStep      &step,
                          const std::vector<int> &blocks,
                          Eigen::VectorXd        &residual,
                          Eigen::VectorXd        &absolute)
  {
    const Model &model = step.model;
    const int    first = model.n_mass();
    if (model.hold_bedrock)
      {
        residual.segment(6 * first, 6 * model.n_bedrock).setZero();
        return;
      }
    const Eigen::VectorXd &borne = step.before.bedrock_static_force;
    if (borne.size() > 0)
      for (auto b = std::lower_bound(blocks.begin(), blocks.end(), first); b != blocks.end(); ++b)
        {
          residual.segment<6>(6 * *b) -= borne.segment<6>(6 * (*b - first));
          absolute[*b] += borne.segment<2>(6 * (*b - first)).norm();
        }
    if (step.incoming.size() == 0)
      return;
    for (std::size_t e = 0; e < model.boundary.size(); ++e)
      {
        const BoundaryEdge &edge = model.boundary[e];
        if (!is_among(model, blocks, edge.block))
          continue;
        const ViscousBoundary boundary = at_end(step, edge);
        const Vec6            in       = boundary.incoming(&step.incoming[forces_per_edge * e]);
        const Vec6            out      = boundary.dashpots(step.trial.rate[edge.block]);
        residual.segment<6>(6 * edge.block) += in + out;
        absolute[edge.block] += in.head<2>().norm() + out.head<2>().norm();
      }
  }



  void add_bedrock_stiffness(const BedrockStep      &step,
                             const std::vector<int> &blocks,
                             BlockMatrix            &matrix)
  {
    const Model &model = step.model;
    if (model.hold_bedrock)
      {
        for (std::size_t s = 0; s < matrix.pairs.size(); ++s)
          if (model.is_bedrock(matrix.pairs[s][0]) || model.is_bedrock(matrix.pairs[s][1]))
            {
              matrix.off_diagonal[s].setZero();
              matrix.lower[s].setZero();
            }
        return;
      }
    if (step.incoming.size() == 0)
      return;
    const double rate_by_increment = model.newmark.gamma / (model.newmark.beta * step.trial.dt);
    for (const BoundaryEdge &edge : model.boundary)
      if (is_among(model, blocks, edge.block))
        matrix.diagonal[edge.block] += rate_by_increment * at_end(step, edge).damping();
  }



  void audit_bedrock(const BedrockStep &step, BlockEnergy &energy)
  {
    const Model &model = step.model;
    const int    first = model.n_mass();
    if (step.before.bedrock_static_force.size() > 0)
      for (int k = 0; k < model.n_bedrock; ++k)
        energy.static_work +=
          step.before.bedrock_static_force.segment<6>(6 * k).dot(step.trial.increment[first + k]);
    if (step.incoming.size() == 0)
      return;
    const double gamma = model.newmark.gamma;
    for (std::size_t e = 0; e < model.boundary.size(); ++e)
      {
        const BoundaryEdge   &edge   = model.boundary[e];
        const ViscousBoundary before = at_start(step, edge), after = at_end(step, edge);
        const Vec6           &d = step.trial.increment[edge.block];
        const Vec6 in0          = before.incoming(&step.before.boundary_force[forces_per_edge * e]);
        const Vec6 in1          = after.incoming(&step.incoming[forces_per_edge * e]);
        energy.input_work += d.dot((1. - gamma) * in0 + gamma * in1);
        const Vec6 out0 = before.dashpots(step.before.blocks[edge.block].velocity);
        const Vec6 out1 = after.dashpots(step.trial.rate[edge.block]);
        energy.boundary_loss -= d.dot((1. - gamma) * out0 + gamma * out1);
      }
  }
} // namespace hybrid::dda
